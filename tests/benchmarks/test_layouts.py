"""Starts, signatures, generated floors and edits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks import changes
from benchmarks.floors import FILL, LEAST, floor, mix
from benchmarks.rooms import LARGE, MIDDLE, ROOMS, SMALL, ZOO, candidates, load, witness
from benchmarks.settings import Settings
from benchmarks.signature import count_distinct, different, signatures
from benchmarks.starts import NOISE_M, blind, movable, noisy_poses, random_poses, start
from sceneweaver.verify import check

SCENE = load("bedroom-small")


def test_rooms_are_those_of_the_zoo():
    assert sorted(ROOMS) == sorted(p.stem for p in ZOO.glob("*.json"))
    full = Settings()
    assert [candidates(full, names[0]) for names in (SMALL, MIDDLE, LARGE)] == [1024, 256, 32]
    assert candidates(Settings(most=7), "bedroom") == 7


@pytest.mark.parametrize("make", [noisy_poses, random_poses])
def test_starts_carry_along_what_stands_on_objects(make):
    own, poses = witness(SCENE), make(SCENE, 3, 0)
    assert poses.shape == (3, len(SCENE.objects), 4)
    for i, o in enumerate(SCENE.objects):
        if o.support is not None:
            below = SCENE.index(o.support.object)
            for pose in poses:
                assert np.linalg.norm(pose[i, :3] - pose[below, :3]) == pytest.approx(
                    np.linalg.norm(own[i, :3] - own[below, :3])
                )
                turned = (pose[i, 3] - pose[below, 3]) - (own[i, 3] - own[below, 3])
                assert math.remainder(turned, 2 * math.pi) == pytest.approx(0.0, abs=1e-12)


def test_only_noisy_starts_know_the_witness():
    assert [start(SCENE, kind, 2, 0)[0] == SCENE for kind in ("random", "sample", "noisy")] == [False, False, True]
    bare = blind(SCENE)
    assert np.all(witness(bare)[:, (0, 1, 3)] == 0)
    assert np.all(witness(bare)[:, 2] == witness(SCENE)[:, 2])
    assert bare.relations == SCENE.relations and bare.room == SCENE.room


def test_noise_has_its_size():
    floor_objects = movable(SCENE)
    off = noisy_poses(SCENE, 500, 1)[:, floor_objects] - witness(SCENE)[floor_objects]
    assert off[..., :2].std() == pytest.approx(NOISE_M, rel=0.05)
    assert off[..., 3].std() == pytest.approx(math.radians(15), rel=0.05)
    assert np.all(off[..., 2] == 0)


def test_starts_depend_on_the_seed_only():
    assert np.array_equal(random_poses(SCENE, 2, 5), random_poses(SCENE, 2, 5))
    assert not np.array_equal(random_poses(SCENE, 2, 5), random_poses(SCENE, 2, 6))


def _layouts(*offsets: float) -> np.ndarray:
    poses = np.repeat(witness(SCENE)[None], len(offsets), axis=0)
    poses[:, movable(SCENE)[0], 0] += offsets
    return poses


def test_duplicates_are_counted_once():
    assert count_distinct(SCENE, _layouts(0.0, 0.0, 0.0)) == (1, 1)
    assert count_distinct(SCENE, _layouts(0.0, 0.005)) == (1, 1)
    assert count_distinct(SCENE, _layouts(0.0)[:0]) == (0, 0)


def test_small_moves_are_different_poses_but_not_distinct_layouts():
    x = witness(SCENE)[movable(SCENE)[0], 0]
    to_middle = (math.floor(x / 0.5) + 0.5) * 0.5 - x  # of a cell, so that 2 cm stay in it
    assert count_distinct(SCENE, _layouts(to_middle, to_middle + 0.02)) == (1, 2)
    assert count_distinct(SCENE, _layouts(to_middle, to_middle + 0.5)) == (2, 2)


def test_turned_objects_are_different():
    poses = _layouts(0.0, 0.0)
    poses[1, movable(SCENE)[0], 3] += math.pi
    assert count_distinct(SCENE, poses) == (2, 2)
    poses[1, movable(SCENE)[0], 3] += math.pi  # a whole turn
    assert count_distinct(SCENE, poses) == (1, 1)


def test_different_agrees_with_comparing_all_pairs():
    rng = np.random.default_rng(0)
    poses = rng.normal(0, 0.008, (60, 3, 4)) * (1, 1, 0, 0)
    kept = different(poses)
    apart = np.linalg.norm(poses[:, None, :, :3] - poses[None, :, :, :3], axis=-1).max(-1) > 0.01
    assert apart[np.ix_(kept, kept)].sum() == len(kept) * (len(kept) - 1)
    assert all(not apart[i, kept].all() for i in set(range(60)) - set(kept))


def test_signature_names_the_wall_behind():
    scene = load("lockers-wall-full")  # every locker is against a wall
    signature = signatures(scene, witness(scene)[None]).reshape(len(movable(scene)), 4)
    assert signature[:, 0].min() >= 0 and signature[:, 0].max() <= 3


@pytest.mark.parametrize("objects", [50, 83, 350])
def test_floors_are_valid_and_of_one_density(objects):
    scene = floor(objects)
    assert len(scene.objects) == objects
    side = scene.room.outline[2][0]
    assert sum(o.size[0] * o.size[1] for o in scene.objects) / side**2 == pytest.approx(FILL, rel=0.01)
    report = check(scene, walkable=False)
    assert report.valid, report.violations[:3]


def test_floors_keep_their_mix():
    for objects in (50, 100, 200, 500):
        assert [n / objects for n in mix(objects)] == pytest.approx([0.12, 0.1, 0.1, 0.1])
    with pytest.raises(ValueError, match="objects: 49 is less than 50"):
        floor(LEAST - 1)


@pytest.mark.parametrize("name", changes.CHANGES)
def test_edits_touch_one_object_and_what_it_carries(name):
    found = changes.CHANGES[name](SCENE, np.random.default_rng(3))
    if found is None:
        pytest.skip("no free spot in this room")
    after, edited = found
    touched = {o.id for o in after.objects if o.id not in SCENE.ids or o != SCENE.object(o.id)}
    assert edited in touched
    assert touched <= {o.id for o in changes._stack(after, edited)}
    assert touched <= changes.involved(after, edited)
    violations = check(after, walkable=False).violations
    assert not any(v.kind == "unsupported" for v in violations)
    if name == "add in a free spot":
        assert changes.involved(after, edited) == {edited}
