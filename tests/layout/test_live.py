"""The kept problem of a live session: compiled anew only where it must be, and left as it was for others."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout import refine
from sceneweaver.layout.live import LiveLayout
from sceneweaver.scene import Scene
from sceneweaver.verify import check


@pytest.fixture
def live() -> LiveLayout:
    return LiveLayout("cpu")


def test_a_move_keeps_what_was_compiled(live):
    scene = Scene.example("bedroom")
    first = live.compiled(scene)
    moved = scene.move("chair", by=(0.1, 0.0))
    second = live.compiled(moved)
    assert second.room.solids is first.room.solids and second.room.packed is first.room.packed
    chair = scene.index("chair")
    assert np.allclose(second.room.home[chair] - first.room.home[chair], (0.1, 0, 0, 0))
    for changed in (
        moved.resize("chair", width=0.4),
        moved.remove("armchair"),
        moved.relate("chair", "near", "bed"),
        moved.model_copy(update={"room": moved.room.model_copy(update={"height": 3.0})}),
    ):
        kept = live.compiled(moved)
        assert live.compiled(changed).room.solids is not kept.room.solids


def test_only_what_is_free_moves(live):
    scene = Scene.example("bedroom").move("chair", to=(2.2, 1.8))
    assert not check(scene, walkable=False).valid
    poses = live.settle(scene, ["chair"])
    assert poses is not None
    home = live.compiled(scene).room.home
    moved = np.flatnonzero(np.abs(poses - home).max(axis=1) > 1e-5)
    assert moved.tolist() == [scene.index("chair")]


def test_nothing_feasible_is_none(live):
    scene = Scene.example("bedroom").resize("bed", width=6.0)
    assert live.settle(scene, ["bed"]) is None


def test_what_is_feasible_stays_to_the_bit(live):
    scene = Scene.example("study")
    poses = live.settle(scene, scene.ids)
    assert np.array_equal(poses.astype(np.float32), live.compiled(scene).room.home.astype(np.float32))


def test_others_may_use_the_compiled_scene(live):
    """Which objects were free is no part of it afterwards."""
    scene = Scene.example("bedroom").move("chair", to=(2.2, 1.8))
    live.settle(scene, ["plant"])
    options = {"candidates": 4, "init": "current", "device": "cpu", "walk": False}
    kept, fresh = refine(scene, compiled=live.compiled(scene), **options), refine(scene, **options)
    assert np.array_equal(kept.poses, fresh.poses) and np.array_equal(kept.status, fresh.status)
