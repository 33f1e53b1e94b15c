"""The flood fill: exact cells, what hinders, which doors lead where, what can be reached."""

import numpy as np
import pytest
import shapely

from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import check, walkable
from sceneweaver.verify.grid import CELL, Grid
from sceneweaver.verify.solids import Placed
from tests.verify.agreement import disturb, zoo
from tests.verify.build import box, rectangle, relation, scene

DOOR = {"id": "door-0", "wall": 0, "offset": 1.55, "width": 0.9, "height": 2.0}
ZONE = {"name": "front", "polygon": rectangle(0.25, -0.5, 0.75, 0.5), "z": [0.0, 1.8]}


def measure(objects, relations=None, doors=(DOOR,), **room):
    found = walkable.measure(Placed.of(scene(objects, relations, size=4.0, doors=list(doors), **room)))
    assert found is not None
    return found


def wall_of_cabinets(gap, y=2.0):
    """Cabinets across the room of 4 m, but for a gap at the right."""
    return box("cabinets", (0.5, 4.0 - gap, 1.0), (4.0 - gap) / 2, y, 90.0)


@pytest.mark.parametrize("name", ["bedroom-small", "dining-round", "studio-U", "office-20"])
def test_free_cells_are_exact(name):
    """Against distances by shapely, in rooms as they are and disturbed; dining-round stands askew."""
    for data in (zoo(name), disturb(zoo(name), np.random.default_rng(1), 4)):
        placed = Placed.of(Scene.model_validate(data))
        grid = Grid(placed)
        rows, columns = np.indices(grid.shape)
        centres = shapely.points(grid._origin + np.stack([columns + 0.5, rows + 0.5], axis=-1) * CELL)
        room = shapely.polygons(grid.outline)
        parts = placed.parts
        solid = shapely.polygons(grid.to_grid(parts.xy[(parts.z[:, 0] < 1.8) & (parts.z[:, 1] > 0.02)]))
        away = np.minimum(
            shapely.distance(shapely.union_all(solid), centres), shapely.distance(shapely.boundary(room), centres)
        )
        shapely.prepare(room)
        free = shapely.contains(room, centres) & (away >= 0.2)
        sure = np.abs(away - 0.2) > 1e-7
        assert sure.mean() > 0.95
        np.testing.assert_array_equal(walkable.free_for(placed, grid, walkable.RADIUS)[sure], free[sure])


def test_the_grid_turns_with_the_room():
    counts = set()
    for angle in (0.0, 0.3, 1.2, 2.9):
        c, s = np.cos(angle), np.sin(angle)
        outline = np.array([[0, 0], [5, 0], [5, 3], [0, 3]]) @ [[c, s], [-s, c]] + (2.0, -7.0)
        made = Placed.of(scene([], outline=outline.tolist()))
        grid = Grid(made)
        counts.add((grid.shape, int(walkable.free_for(made, grid, walkable.RADIUS).sum()), int(grid.inside().sum())))
    assert counts == {((60, 100), 52 * 92, 60 * 100)}


def test_an_empty_room():
    assert measure([])[:2] == (1.0, 1.0)
    assert measure([], doors=())[:2] == (1.0, 1.0)


@pytest.mark.parametrize(("gap", "open_"), [(0.38, False), (0.46, True)])
def test_the_robot_is_as_wide_as_40_cm(gap, open_):
    found = measure([wall_of_cabinets(gap)])
    assert (found.walkable > 0.9) is open_
    if not open_:  # the doors' half: 1.75 m of depth less 0.2 at both ends, as behind the cabinets
        assert found.walkable == pytest.approx(0.5, abs=0.02)


@pytest.mark.parametrize(
    ("thing", "free"),
    [
        (box("rug", (3.9, 3.9, 0.02), 2.0, 2.0), True),
        (box("mat", (3.9, 3.9, 0.03), 2.0, 2.0), False),
        (box("shelf", (0.3, 4.0, 0.3), 2.0, 2.0, 90.0, 1.8, mount="wall"), True),
        (box("shelf", (0.3, 4.0, 0.3), 2.0, 2.0, 90.0, 1.7, mount="wall"), False),
        (box("lamp", (0.3, 4.0, 0.3), 2.0, 2.0, 90.0, 2.4, mount="ceiling"), True),
    ],
)
def test_what_hinders(thing, free):
    assert (measure([thing]).walkable == 1.0) is free


def test_doors():
    """Without doors the largest region counts; with several, the best one; a blocked one leads nowhere."""
    cabinets = wall_of_cabinets(0.0, 3.0)  # 2.75 m deep before, 0.75 m behind
    before, behind = (2.75 - 0.4) / (2.75 - 0.4 + 0.35), 0.35 / (2.75 - 0.4 + 0.35)
    back = {**DOOR, "id": "door-1", "wall": 2, "width": 0.6}
    assert measure([cabinets], doors=()).walkable == pytest.approx(before, abs=0.02)
    assert measure([cabinets]).walkable == pytest.approx(before, abs=0.02)
    assert measure([cabinets], doors=[back]).walkable == pytest.approx(behind, abs=0.02)
    assert measure([cabinets], doors=[back, DOOR]).walkable == pytest.approx(before, abs=0.02)
    assert measure([box("crate", (1.5, 1.5, 1.0), 2.0, 0.75)]).walkable == 0.0
    assert measure([box("block", (4.0, 4.0, 1.0), 2.0, 2.0)]) == (0.0, 0.0, ("block",))
    assert measure([box("block", (4.0, 4.0, 1.0), 2.0, 2.0)], doors=()).walkable == 0.0


def reachable(objects, relations=None, **room):
    return measure(objects, relations, **room).reachable


def row(depth, yaw, **more):
    """A dresser between two others along the right wall; those face the room."""
    sides = [box(f"n{y}", (depth, 1.5, 1.0), 4.0 - depth / 2, y, 180.0) for y in (0.75, 3.25)]
    return [*sides, box("d", (depth, 1.0, 1.0), 4.0 - depth / 2, 2.0, yaw, **more)]


def test_reach_is_to_the_front():
    """A dresser that faces the wall is not reached unless it is shallow, or a hard zone of it can be."""
    back = {**ZONE, "polygon": rectangle(-0.9, -0.5, -0.5, 0.5)}
    assert reachable(row(1.0, 180.0)) == 1.0
    assert reachable(row(1.0, 0.0)) == pytest.approx(2 / 3)
    assert reachable(row(0.3, 0.0)) == 1.0
    assert reachable(row(1.0, 0.0, zones=[back])) == 1.0
    assert reachable(row(1.0, 0.0, zones=[{**back, "hard": False}])) == pytest.approx(2 / 3)


@pytest.mark.parametrize(("away", "expected"), [(0.54, 1.0), (0.56, 0.0)])
def test_reach_is_55_cm(away, expected):
    """Cells end 0.2 m before the wall of cabinets: a front that is 0.35 m behind it or nearer can be reached."""
    fence = box("fence", (0.05, 4.0, 0.3), 2.0, 2.025, 90.0)
    last = 2.0 - 0.2 - 0.025  # centre of the last free cells before the fence
    thing = box("t", (0.3, 0.3, 0.3), 2.0, last + away + 0.15, -90.0)
    assert reachable([fence, thing]) == (1.0 + expected) / 2  # the fence itself is reached


def room_behind_a_gap_of_45_cm():
    cabinets = {**wall_of_cabinets(0.45), "pose": box("x", (1, 1, 1), 1.775, 2.0, -90.0)["pose"]}
    return scene([cabinets, box("desk", (0.6, 1.2, 0.75), 2.0, 3.7, -90.0)], size=4.0, doors=[DOOR])


@pytest.mark.parametrize(("radius", "share"), [(0.2, 1.0), (0.25, 0.5)])
def test_a_desk_is_out_of_reach_for_a_base_that_is_too_wide(radius, share):
    report = check(room_behind_a_gap_of_45_cm(), robot_radius=radius)
    assert report.reachable_share == share and (report.walkable_share == 1.0) == (share == 1.0)
    assert report.to_dict().get("robot_radius") == (None if radius == walkable.RADIUS else radius)


def test_what_was_measured_for_one_radius_is_not_that_of_another():
    placed = Placed.of(room_behind_a_gap_of_45_cm())
    assert [walkable.measure(placed, radius).unreached for radius in (0.2, 0.25, 0.2)] == [(), ("desk",), ()]


@pytest.mark.parametrize("radius", [0.0, -0.2, float("nan"), float("inf"), 5.1, True, "0.2", None])
def test_a_radius_that_is_none_is_refused(radius):
    with pytest.raises(InputError, match="robot_radius is .*; give metres, 0.01 to 5"):
        check(scene([]), robot_radius=radius)


def test_tied_objects_are_reached_anywhere():
    """A desk that faces the wall counts by its footprint once a chair is tied to it."""
    things = [*row(1.0, 0.0), box("chair", (0.4, 0.4, 0.9), 1.0, 3.0, 90.0)]
    assert reachable(things) == 0.75
    for kind in ("front_against", "front_to_front", "around"):
        assert reachable(things, [relation(kind, "chair", "d")]) == 1.0
        assert reachable(things, [relation(kind, "d", "chair", hard=False)]) == 1.0
    assert reachable(things, [relation("near", "chair", "d")]) == 0.75


def test_only_what_stands_on_the_floor_counts():
    high = box("tv", (0.1, 1.0, 0.6), 0.05, 2.0, z=1.2, mount="wall")
    assert reachable([high]) == 1.0
    behind = box("b", (0.3, 0.3, 0.3), 2.0, 3.7, 90.0)
    assert reachable([wall_of_cabinets(0.0), behind, high]) == 0.0
    turned = {**wall_of_cabinets(0.0), "pose": box("x", (1, 1, 1), 2.0, 2.0, -90.0)["pose"]}
    assert reachable([turned, behind, high]) == 0.5


def test_a_rug_is_reached_where_it_can_be_walked_on():
    assert reachable([box("rug", (1.0, 1.0, 0.01), 3.5, 3.5)]) == 1.0


def test_left_out_and_too_large():
    small = scene([])
    assert check(small, walkable=False).walkable_share is None
    report = check(scene([], size=1e6))
    assert (report.walkable_share, report.reachable_share) == (None, None)
    assert "too large" in report.warnings[0]
    assert report.valid
