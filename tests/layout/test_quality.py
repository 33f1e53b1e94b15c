"""Terms of design quality: what they take off, and what a refinement makes of them."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import shapely

import sceneweaver as sw
from sceneweaver.layout import QualityTerm, engine, rate
from sceneweaver.layout.solution import ALL_SOFT, AT_WALL, LARGE, missing_points, signatures
from sceneweaver.scene import InputError
from tests.layout.made import relation, room, scene, thing
from tests.test_repository import ROOT

ZOO = ROOT / "tests" / "zoo"

BED, BOX, OTHER = thing("bed", (2.0, 1.5, 0.5)), thing("box"), thing("other", (0.6, 1.0, 0.7))
ROOM = scene([BED, BOX, OTHER], [relation("against_wall", "bed"), relation("against_wall", "other")])
OFF_DOOR = QualityTerm("backing", ("bed", "door"), low=0.5, span=0.5, weight=3.0)
NO_TERM = {
    "kind": ("lateral?", ("bed", "box")),
    "members": ("gap", ("bed",)),
    "too many": ("mirrored", ("bed", "box", "other", "door")),
}


def at(*poses) -> np.ndarray:
    """One layout of the room."""
    return np.array([[(x, y, 0.0, yaw) for x, y, yaw in poses]])


@pytest.mark.parametrize("wrong", NO_TERM)
def test_a_term_has_a_kind_and_its_members(wrong):
    with pytest.raises(InputError, match="quality"):
        QualityTerm(*NO_TERM[wrong])


@pytest.mark.parametrize(
    "more",
    [{"span": 0.0}, {"weight": -1.0}, {"low": 1.0, "high": 0.0}, {"low": float("nan")}, {"params": {"eye": 1.0}}],
)
def test_numbers_of_a_term_are_checked(more):
    with pytest.raises(InputError, match="quality: gap of bed, box"):
        QualityTerm("gap", ("bed", "box"), **more)


def test_terms_name_what_the_scene_has():
    term = QualityTerm("gap", ("bed", "sofa"))
    for call in (lambda: sw.refine(ROOM, quality=[term]), lambda: rate(ROOM, np.zeros((1, 3, 4)), [term])):
        with pytest.raises(InputError, match='"sofa" is no object, door, window or wall'):
            call()
    with pytest.raises(InputError, match="terms of 1 scenes, but there are 2"):
        sw.refine_many([ROOM, ROOM], quality=[[term]])


def test_points_follow_the_miss_and_stop_at_the_weight():
    """The gap between two boxes of 0.5 m depth is their distance less 0.5 m."""
    poses = np.concatenate(
        [at((0.5, 3.0, 0.0), (1.0, 1.0, 0.0), (1.55 + gap, 1.0, 0.0)) for gap in (0.1, 0.3, 0.5, 3.0)]
    )
    term = QualityTerm("gap", ("box", "other"), low=0.2, high=0.4, span=0.2, weight=2.0)
    np.testing.assert_allclose(rate(ROOM, poses, [term]), [-1.0, 0.0, -1.0, -2.0], atol=1e-4)


def test_terms_of_one_rule_take_off_so_much_together():
    poses = at((1.0, 2.0, 0.0), (2.0, 2.0, 0.0), (2.0, 1.0, 0.0))
    far = [QualityTerm("gap", ("box", name), low=9.0, weight=1.0, rule="apart", most=1.5) for name in ("bed", "other")]
    alone = dataclasses.replace(far[0], rule="")
    assert rate(ROOM, poses, far) == pytest.approx(-1.5)
    assert rate(ROOM, poses, [far[0], alone, far[1]]) == pytest.approx(-2.5)


def test_the_floor_is_measured_for_the_best_only():
    """The others lose all points of such terms, so none of them comes before one that was measured."""
    free = at((1.0, 3.0, 0.0), (4.7, 3.7, 0.0), (4.6, 0.5, 0.0))
    worse = at((1.0, 3.0, 0.0), (4.7, 3.7, 0.0), (3.0, 2.0, 0.0))
    terms = [
        QualityTerm("gap", ("box", "other"), low=2.0, high=9.0, span=1.0, weight=1.0),
        QualityTerm("empty", high=9.0, weight=5.0),
    ]
    both = np.concatenate([worse, free])
    assert rate(ROOM, both, terms)[1] == pytest.approx(0.0)
    assert rate(ROOM, both, terms)[0] > -1.01
    np.testing.assert_allclose(rate(ROOM, both, terms, on_floor=1)[1], 0.0, atol=1e-6)
    assert rate(ROOM, both, terms, on_floor=1)[0] < -5.0


def test_a_refinement_prefers_what_the_terms_want():
    plain = sw.refine(ROOM, candidates=64, seed=3)
    found = sw.refine(ROOM, candidates=64, seed=3, quality=[OFF_DOOR])
    np.testing.assert_array_equal(found.poses, plain.poses)
    assert plain.quality is None
    valid = found.status == 0
    assert np.isnan(found.quality[~valid]).all() and np.isfinite(found.quality[valid]).all()
    assert found.quality[valid].min() < -2.9, "some bed has its head at the door"
    np.testing.assert_allclose(found.quality[valid], rate(ROOM, found.poses[valid], [OFF_DOOR]), atol=1e-6)
    first = found.ranked[0]
    assert found.order[0] == first and found.quality[first] == 0.0
    assert set(found.ranked) == set(np.flatnonzero(valid))


def test_soft_relations_weigh_more_than_taste():
    soft = ROOM.model_copy(update={"relations": (relation("facing", "box", "bed").model_copy(update={"hard": False}),)})
    holds = np.array([[True], [False]])
    np.testing.assert_allclose(missing_points(soft, holds), [0.0, ALL_SOFT])
    assert missing_points(ROOM, np.zeros((2, 2), dtype=bool)).max() == 0.0, "hard ones are no matter of points"


def test_many_scenes_are_rated_each_by_its_own_terms():
    other = ROOM.model_copy(update={"room": room(6.0, 4.0)})
    terms = [[OFF_DOOR], []]
    found = sw.refine_many([ROOM, other], candidates=16, seed=1, quality=terms)
    alone = engine.refine(ROOM, candidates=16, seed=1, quality=[OFF_DOOR])
    np.testing.assert_array_equal(found[0].quality, alone.quality)
    assert found[1].quality is None


def test_a_scene_is_rated_among_others_as_alone():
    """The terms look at all objects of a scene, whose tables are among those of the others."""
    other = ROOM.model_copy(update={"room": room(6.0, 4.0)})
    terms = [OFF_DOOR, QualityTerm("clear", ("bed",), low=2.0, span=2.0), QualityTerm("empty", high=0.5)]
    found = sw.refine_many([ROOM, other], candidates=16, seed=1, quality=[terms, terms])
    for one, solution in zip([ROOM, other], found, strict=True):
        valid = solution.status == 0
        assert valid.any()
        np.testing.assert_array_equal(solution.quality[valid], rate(one, solution.poses[valid], terms))


def test_the_best_that_differ_have_signatures_of_their_own():
    found = sw.refine(ROOM, candidates=64, seed=3, quality=[OFF_DOOR])
    layouts = found.distinct(6)
    poses = np.array([[(*o.pose.position, o.pose.yaw) for o in layout.objects] for layout in layouts])
    assert len(np.unique(signatures(ROOM, poses[:3]), axis=0)) == 3
    worth = rate(ROOM, poses, [OFF_DOOR])
    assert worth[0] == 0.0
    assert all((np.diff(part) <= 1e-6).all() for part in (worth[:3], worth[3:]))


def test_a_signature_ignores_small_things_and_small_moves():
    home = at((1.0, 0.75, 0.0), (2.0, 2.0, 0.0), (4.5, 2.0, 0.0))
    moved = home + np.array([[[0.02, 0.1, 0.0, 0.05], [1.0, 1.0, 0.0, 1.0], [0.0, 0.0, 0.0, 0.0]]])
    turned = home + np.array([[[0.0, 0.0, 0.0, np.pi], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]]])
    first, second, third = signatures(ROOM, np.concatenate([home, moved, turned]))
    assert (first == second).all() and (first != third).any()


@pytest.mark.parametrize("name", ["living-dining-L", "office-dense", "studio-U"])
def test_signatures_name_the_nearest_wall_and_the_eighth_of_a_turn(name):
    scene, rng = sw.Scene.load(ZOO / f"{name}.json"), np.random.default_rng(1)
    home = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])
    poses = home + rng.normal(0.0, (0.4, 0.4, 0.0, 0.8), (50, *home.shape))
    walls, eighths = np.split(signatures(scene, poses), 2, axis=1)
    large = [k for k, o in enumerate(scene.objects) if _is_large(o)]
    corners = scene.room.outline
    sides = [shapely.LineString([a, b]) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    depth = np.array([scene.objects[k].size[0] for k in large])
    turned = np.stack([np.cos(poses[:, large, 3]), np.sin(poses[:, large, 3])], axis=-1)
    backs = shapely.points(poses[:, large, :2] - depth[:, None] / 2 * turned)
    gaps = np.stack([shapely.distance(side, backs) for side in sides], axis=-1)
    np.testing.assert_array_equal(walls >= 0, gaps.min(axis=-1) <= AT_WALL)
    named = np.take_along_axis(gaps, np.maximum(walls, 0)[..., None], axis=-1)[..., 0]
    np.testing.assert_allclose(named[walls >= 0], gaps.min(axis=-1)[walls >= 0], atol=1e-9)  # near corners two are one
    np.testing.assert_array_equal(eighths, np.round(4 * poses[:, large, 3] / np.pi) % 8)
    assert (walls >= 0).any() and (walls < 0).any()
    assert signatures(scene, poses[:0]).shape == (0, 2 * len(large))


def _is_large(thing) -> bool:
    return (
        thing.mount == "floor" and not thing.fixed and thing.size[0] * thing.size[1] >= LARGE and thing.size[2] > 0.05
    )
