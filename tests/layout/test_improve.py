"""Good layouts recombined to better ones."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import QualityTerm, improve, rate
from sceneweaver.scene import InputError, Pose
from tests.layout.made import relation, scene, table, thing

BED, STAND = thing("bed", (2.0, 1.5, 0.5)), thing("stand", (0.4, 0.5, 0.6))
SHELF, DESK = thing("shelf", (0.4, 1.2, 1.8)), thing("desk", (0.6, 1.2, 0.75))
BOX = thing("box")
CUP = thing("cup", (0.1, 0.1, 0.1), mount="surface", support={"object": "table", "surface": "top"})
ROOM = scene(
    [BED, STAND, SHELF, DESK],
    [
        *(relation("against_wall", name) for name in ("bed", "shelf", "desk")),
        relation("leftright_to_leftright", "stand", "bed"),
    ],
)
TERMS = [
    QualityTerm("lateral", ("bed", "window"), high=0.02, span=2.0, weight=2.0),
    QualityTerm("bearing", ("desk", "window"), high=0.02, span=2.0, weight=2.0),
    QualityTerm("gap", ("shelf", "door"), low=4.5, span=4.0, weight=2.0),
]


@pytest.fixture(scope="module")
def first():
    return sw.refine(ROOM, candidates=16, seed=2, quality=TERMS)


def best(solution) -> float:
    return float(np.nanmax(solution.quality))


def test_children_are_added_and_better(first):
    found = improve(first, TERMS, candidates=16, generations=4)
    assert found.candidates == 16 + 4 * 16
    np.testing.assert_array_equal(found.poses[:16], first.poses)
    assert best(found) > best(first) + 0.02
    more = sw.refine(ROOM, candidates=80, seed=2, quality=TERMS)
    assert best(found) > best(more), "as many drawn anew are worse"
    valid = found.status == 0
    np.testing.assert_allclose(found.quality[valid], rate(ROOM, found.poses[valid], TERMS), atol=1e-5)
    assert all(sw.check(layout).valid for layout in found.distinct(5))
    assert np.isfinite(found.walkable[found.order[0]])


def test_the_same_seed_gives_the_same_children(first):
    a, b = (improve(first, TERMS, candidates=8, generations=2, snap=True) for _ in range(2))
    np.testing.assert_array_equal(a.poses, b.poses)
    np.testing.assert_array_equal(a.order, b.order)


def test_what_belongs_together_stays_together(first):
    """A nightstand comes along with its bed, so most children are valid."""
    found = improve(first, TERMS, candidates=32, generations=2)
    assert (found.status[16:] == 0).mean() > 0.5


def test_without_a_valid_layout_nothing_is_done(first):
    none = dataclasses.replace(first, status=np.ones_like(first.status))
    assert improve(none, TERMS, candidates=8, generations=2).candidates == first.candidates


def test_only_rated_solutions_are_improved(first):
    with pytest.raises(InputError, match="improve: takes a solution"):
        improve(sw.refine(ROOM, candidates=4), TERMS)
    with pytest.raises(InputError, match="improve: takes a solution"):
        improve(sw.refine(ROOM, candidates=4, init="current", quality=TERMS), TERMS)


def test_fixed_things_and_what_stands_on_others_stay_where_they_belong():
    fixed = thing("shelf", (0.4, 1.2, 1.8), fixed=True, pose=Pose.from_yaw(0.2, 3.2, 0.0, 0.0))
    room = scene([table(), CUP, fixed, BOX], [relation("against_wall", "box")])
    terms = [QualityTerm("gap", ("table", "box"), low=1.0), QualityTerm("bearing", ("box", "shelf"), high=0.3)]
    found = improve(sw.refine(room, candidates=8, quality=terms), terms, candidates=8, generations=2)
    assert np.ptp(found.poses[:, 2], axis=0).max() == 0.0
    for layout in found.distinct(4):
        assert sw.check(layout).valid
