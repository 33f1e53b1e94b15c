"""Cameras that somebody else wrote down: what makes none is one short line."""

from __future__ import annotations

import json

import pytest

from sceneweaver.render.pass_files import read_shots
from sceneweaver.scene import InputError

SOUND = {"eye": [1, 1, 1.5], "target": [3, 2, 1]}


@pytest.mark.parametrize(
    "change",
    [
        {"width": 4294967296},
        {"width": float("inf")},
        {"height": -1},
        {"fov": "x" * 100_000},
        {"eye": [10**400, 0, 0]},
        {"eye": "\x1b[2J"},
    ],
)
def test_what_makes_no_camera_is_one_short_line(tmp_path, change):
    path = tmp_path / "cameras.json"
    path.write_text(json.dumps([SOUND]))
    assert len(read_shots(path, 64, 48)) == 1
    path.write_text(json.dumps([SOUND | change]))
    with pytest.raises(InputError, match="^camera-0: makes no camera") as caught:
        read_shots(path, 64, 48)
    assert len(str(caught.value)) < 300 and str(caught.value).isprintable()
