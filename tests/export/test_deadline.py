"""Every writer of a scene asks the deadline for each object."""

from __future__ import annotations

import threading

import pytest

from sceneweaver.export import FORMATS, export_scene
from sceneweaver.runtime import deadline
from sceneweaver.scene import Pose, Room, Scene, SceneObject

MANY = 12


def _scene(count: int) -> Scene:
    """Boxes without assets, no two alike."""
    boxes = [
        SceneObject(id=f"box-{k}", category="box", size=(0.3, 0.3, 0.3 + 0.01 * k), pose=Pose(position=(0.6 * k, 4, 0)))
        for k in range(1, count + 1)
    ]
    return Scene(id="boxes", room=Room.rectangle(9, 8), objects=tuple(boxes))


@pytest.mark.parametrize("name", FORMATS)
def test_each_object_is_a_checkpoint(name, tmp_path, monkeypatch):
    asked = []

    def counts(count: int) -> int:
        asked.clear()
        export_scene(_scene(count), tmp_path / str(count), [name])
        return len(asked)

    end, here = deadline.end_of_block, threading.get_ident()

    def noted():
        if threading.get_ident() == here:  # threads that other tests have left may ask as well
            asked.append(1)
        return end()

    monkeypatch.setattr(deadline, "end_of_block", noted)
    assert counts(MANY + 1) - counts(1) >= MANY


@pytest.mark.parametrize("name", FORMATS)
def test_time_that_is_up_ends_an_export_and_leaves_nothing(name, tmp_path):
    with pytest.raises(deadline.TimeUp), deadline.Deadline(end=0.0).enforced():
        export_scene(_scene(2), tmp_path / "out", [name])
    assert list(tmp_path.iterdir()) == []
