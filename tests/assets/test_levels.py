"""How high furniture is used, and what is clear below its top."""

from __future__ import annotations

import pytest

from sceneweaver.assets.levels import clear_below
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.scene import Part


def _box(depth: float, width: float, low: float, high: float) -> Part:
    return Part(polygon=rectangle(depth, width), z=(low, high))


def test_knees_have_what_is_clear_below_a_top() -> None:
    top, foot = _box(0.8, 1.6, 0.7, 0.74), _box(0.1, 0.1, 0.0, 0.7)
    assert clear_below([top, foot], (0.8, 1.6, 0.74)) == pytest.approx(0.7)
    assert clear_below([_box(0.8, 1.6, 0.0, 0.74)], (0.8, 1.6, 0.74)) == 0.0
    assert clear_below([foot], (0.8, 1.6, 0.7)) is None
