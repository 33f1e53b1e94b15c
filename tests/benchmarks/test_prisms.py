"""What the rivals take a scene to be made of."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from benchmarks.rivals.hinges import footprints, hinges
from benchmarks.rivals.prisms import openings, owners, pockets, rectangle, solids, zones
from benchmarks.rooms import load, witness
from benchmarks.starts import movable
from benchmarks.tenbox import ten_boxes
from sceneweaver.verify import check


def test_ten_boxes_is_valid_and_what_it_says():
    scene = ten_boxes()
    assert check(scene, walkable=False).valid
    assert len(scene.objects) == 10 and len(scene.relations) == 14
    assert not any(o.parts or o.zones for o in scene.objects)


def test_what_stands_on_objects_is_carried():
    scene = load("bedroom-small")
    slot = owners(scene)
    floor = movable(scene)
    assert list(slot[floor]) == list(range(len(floor)))
    for i, o in enumerate(scene.objects):
        if o.support is not None:
            assert slot[i] == slot[scene.index(o.support.object)]


def test_prisms_lie_where_the_witness_has_them():
    scene = load("bedroom-small")
    own, floor = witness(scene), movable(scene)
    for prism in (*solids(scene), *zones(scene)):
        x, y, _, yaw = own[floor[prism.owner]]
        turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
        middle = turn @ prism.corners.mean(axis=0) + (x, y)
        assert np.linalg.norm(middle - own[prism.item, :2]) < np.linalg.norm(scene.objects[prism.item].size[:2])
        assert shapely.LinearRing(prism.corners).is_ccw


@pytest.mark.parametrize("name", ["living-dining-L", "studio-U"])
def test_pockets_fill_the_hull_and_leave_the_room_free(name):
    outline = shapely.Polygon(load(name).room.outline)
    found = shapely.union_all([shapely.Polygon(p.corners) for p in pockets(load(name))])
    assert found.intersection(outline).area < 1e-9
    assert outline.convex_hull.difference(outline).difference(found).area < 1e-9


def test_openings_are_in_the_room_and_behind_its_wall():
    (door,) = openings(ten_boxes())
    low, high = door.corners.min(axis=0), door.corners.max(axis=0)
    assert (low[0], high[0]) == pytest.approx((1.3, 2.1))
    assert low[1] < 0 and high[1] == pytest.approx(0.8)
    assert door.z == (0.0, 2.05)


def test_rectangles_are_told_from_other_polygons():
    turn = np.array([[np.cos(0.3), -np.sin(0.3)], [np.sin(0.3), np.cos(0.3)]])
    corners = np.array([[-1, -2], [1, -2], [1, 2], [-1, 2]]) @ turn.T + (3, 4)
    middle, half, angle = rectangle(corners)
    assert middle == pytest.approx([3, 4]) and half == pytest.approx([1, 2]) and angle == pytest.approx(0.3)
    assert rectangle(corners + np.array([[0.1, 0], [0, 0], [0, 0], [0, 0]])) is None
    assert rectangle(corners[:3]) is None


def test_hinges_hold_at_the_witness():
    scene = ten_boxes()
    start = witness(scene)[None]
    middle = start[0, movable(scene), :2]
    found = hinges(scene, start)
    assert len(found) >= len(scene.relations) - 2  # facing and aligned say nothing about positions
    for hinge in found:
        d = middle[hinge.subject] - (middle[hinge.target] if hinge.target >= 0 else 0.0)
        value = np.linalg.norm(d) if hinge.direction is None else float(hinge.direction[0] @ d)
        slack = 0.35 if hinge.direction is None else 0.001  # near: taken from the circles inside of the boxes
        assert hinge.low[0] - slack <= value <= hinge.high[0] + slack
    assert footprints(scene, start)[0, 0] == pytest.approx([0.8, 1.0])  # the bed, turned by 90 degrees
