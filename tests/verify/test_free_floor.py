"""Free floor as the judge measures it: twins that differ by what stands in it."""

from __future__ import annotations

import math

import pytest

from sceneweaver.scene import Door, FreeArea, Pose, Relation, Room, Scene, SceneObject
from sceneweaver.verify import check
from sceneweaver.verify.free_floor import find, measure
from sceneweaver.verify.solids import Placed

ROOM = Room(
    outline=((0, 0), (5, 0), (5, 4), (0, 4)),
    height=2.6,
    doors=(
        Door(id="door", wall=0, offset=0.2, width=0.9, height=2.05),
        Door(id="back-door", wall=2, offset=0.2, width=0.9, height=2.05),
    ),
)
MIDDLE = Pose.from_yaw(2.5, 2.0, 0.0, 0.0)


def box(name: str, size: tuple[float, float, float], x: float, y: float, z: float = 0.0, **more) -> SceneObject:
    yaw = more.pop("yaw", 0.0)
    return SceneObject(id=name, category=name, size=size, pose=Pose.from_yaw(x, y, z, yaw), **more)


def scene(area: FreeArea, *objects: SceneObject, relations: tuple[Relation, ...] = ()) -> Scene:
    return Scene(id="twin", room=ROOM, objects=objects, relations=relations, free_areas=(area,))


def width(made: Scene) -> float:
    found = measure(Placed.of(made), made.free_areas[0]).measurement
    assert found is not None
    return found.value


def verdict(made: Scene) -> tuple[bool, set[str]]:
    report = check(made, walkable=False)
    return report.valid, {v.kind for v in report.violations}


CIRCLE = FreeArea(id="turn", kind="circle", size=(1.5, 1.5), pose=MIDDLE)
SQUARE = FreeArea(id="play", kind="rectangle", size=(2.0, 1.0), pose=Pose.from_yaw(2.5, 2.0, 0.0, math.pi / 2))


@pytest.mark.parametrize(("x", "free"), [(3.51, True), (3.48, False)])
def test_a_circle_is_free_up_to_what_stands_beside_it(x, free):
    made = scene(CIRCLE, box("chair", (0.5, 0.5, 0.9), x, 2.0))
    assert width(made) == pytest.approx(2 * (x - 0.25 - 2.5))
    assert verdict(made) == ((True, set()) if free else (False, {"blocked_floor"}))


def test_a_rectangle_is_measured_along_its_own_sides():
    beside = scene(SQUARE, box("chest", (0.4, 0.4, 0.5), 3.3, 2.0))  # turned, it is 1 m wide along x
    assert width(beside) == pytest.approx(2.0 * 0.6 / 0.5)
    assert verdict(beside)[0]
    assert not verdict(scene(SQUARE, box("chest", (0.4, 0.4, 0.5), 2.5, 3.15)))[0]


def test_rugs_and_what_hangs_high_are_not_in_the_way():
    rug, lamp = box("rug", (2.0, 2.0, 0.02), 2.5, 2.0), box("lamp", (0.4, 0.4, 0.5), 2.5, 2.0, 2.1, mount="ceiling")
    assert verdict(scene(CIRCLE, rug, lamp)) == (True, set())


def test_free_floor_is_inside_the_room():
    at_wall = CIRCLE.model_copy(update={"pose": Pose.from_yaw(0.6, 2.0, 0.0, 0.0)})
    assert width(scene(at_wall)) == pytest.approx(1.2)
    assert not verdict(scene(at_wall))[0]


@pytest.mark.parametrize(
    ("side", "depth"), [("front", 1.0), ("back", 0.9), ("sides", 0.3), ("around", 0.3), ("left", 1.25), ("long", 0.3)]
)
def test_a_clearance_is_the_least_depth_beside_its_sides(side, depth):
    area = FreeArea(id="c", kind="clearance", size=(0.5, 0.5), targets=("table",), side=side)
    table = box("table", (1.8, 0.9, 0.75), 1.8, 2.3)
    right, ahead = box("chest", (0.6, 0.4, 0.8), 1.8, 1.35), box("desk", (0.4, 0.4, 0.8), 3.9, 2.3)
    assert width(scene(area, table, right, ahead)) == pytest.approx(depth)


def test_what_is_tied_to_a_thing_may_stand_in_its_clearance():
    area = FreeArea(id="c", kind="clearance", size=(0.8, 0.8), targets=("table",), side="around")
    table, chair = box("table", (1.8, 0.9, 0.75), 2.5, 2.0), box("chair", (0.5, 0.5, 0.9), 2.5, 1.25, yaw=math.pi / 2)
    tie = Relation(type="front_against", subject="chair", target="table")
    assert not verdict(scene(area, table, chair))[0]
    assert verdict(scene(area, table, chair, relations=(tie,)))[0]


@pytest.mark.parametrize(("x", "holds"), [(2.83, True), (2.79, False)])
def test_a_gap_is_the_least_distance_of_its_two_sides(x, holds):
    area = FreeArea(id="g", kind="gap", size=(1.2, 1.2), targets=("counter",), others=("shelf", "rack"))
    made = scene(
        area,
        box("counter", (0.6, 2.0, 0.9), 1.3, 2.0),
        box("shelf", (0.4, 1.0, 1.8), 3.5, 2.0),
        box("rack", (0.04, 1.0, 1.8), x, 3.0),
    )
    assert width(made) == pytest.approx(x - 0.02 - 1.6)
    assert verdict(made)[0] is holds


def test_a_row_of_one_kind_is_one_side_of_a_gap():
    area = FreeArea(id="g", kind="gap", size=(1.0, 1.0), targets=("a", "b", "c"))
    bodies = box("a", (0.6, 0.8, 2.0), 1.0, 1.5), box("b", (0.6, 0.8, 2.0), 1.0, 2.3), box("c", (0.6, 0.8, 2.0), 3.0, 2)
    row = Relation(type="next_to", subject="b", target="a", params={"side": "left", "gap": (0.0, 0.05)})
    assert width(scene(area, *bodies)) == pytest.approx(0.0)
    assert width(scene(area, *bodies, relations=(row,))) == pytest.approx(1.4)


def test_off_the_walls():
    area = FreeArea(id="g", kind="gap", size=(0.5, 0.5), targets=("kiln",), others=("wall",))
    assert width(scene(area, box("kiln", (0.8, 0.8, 1.0), 1.0, 2.0))) == pytest.approx(0.6)
    assert not verdict(scene(area, box("kiln", (0.8, 0.8, 1.0), 0.8, 2.0)))[0]


@pytest.mark.parametrize("opening", [0.6, 0.9, 1.3])
def test_a_path_is_as_wide_as_its_narrowest_place(opening):
    area = FreeArea(id="p", kind="path", size=(0.9, 0.9), targets=("door",), others=("back-door",))
    low, high = 1.0, 4.0 - 1.0 - opening
    made = scene(area, box("low", (0.4, low, 1.0), 2.5, low / 2), box("high", (0.4, high, 1.0), 2.5, 4.0 - high / 2))
    assert width(made) == pytest.approx(opening, abs=0.05)
    valid, kinds = verdict(made)
    assert valid  # a path that is too narrow is said, and leaves the scene valid
    assert kinds == ({"narrow_path"} if opening < 0.85 else set())


def test_no_path_leads_through_what_stands_from_wall_to_wall():
    area = FreeArea(id="p", kind="path", size=(0.6, 0.6), targets=("door",), others=("sofa",))
    sofa = box("sofa", (0.8, 1.6, 0.8), 4.2, 2.0)
    assert width(scene(area, sofa)) > 0.6
    assert width(scene(area, sofa, box("wall", (0.2, 4.0, 1.0), 2.5, 2.0))) == pytest.approx(0.0, abs=0.02)


def test_ways_of_a_scene_are_what_each_is_alone():
    """What they share is measured once, and let go of."""
    things = (box("desk", (0.8, 1.6, 0.75), 4.5, 1.0), box("shelf", (0.4, 1.2, 1.8), 0.3, 3.2))
    fence, wide = box("fence", (0.1, 3.4, 1.0), 0.75, 2.3), {"kind": "path", "size": (0.9, 0.9)}
    ends = [(("door",), ("shelf",)), (("door",), ("desk",)), (("desk", "door"), ("shelf", "back-door")), ((), ())]
    areas = [FreeArea(id=f"p{k}", targets=a, others=b, **wide) for k, (a, b) in enumerate(ends)]
    together = Placed.of(scene(areas[0], *things, fence).model_copy(update={"free_areas": tuple(areas)}))
    found = list(find(together))
    alone = [find(Placed.of(scene(area, *things, fence))) for area in areas]
    assert found == [violation for some in alone for violation in some] and len(found) == 3
    assert "_ground" not in together.__dict__


def test_without_ends_all_ways_are_meant():
    area = FreeArea(id="p", kind="path", size=(0.9, 0.9))
    desk, shelf = box("desk", (0.8, 1.6, 0.75), 4.5, 1.0), box("shelf", (0.4, 1.2, 1.8), 0.3, 3.2)
    assert width(scene(area, desk, shelf)) > 0.9
    fence = box("fence", (0.1, 3.4, 1.0), 0.75, 2.3)  # 0.7 m of way are left to the shelf
    found = measure(Placed.of(scene(area, desk, shelf, fence)), area)
    assert found.measurement is not None and found.measurement.value < 0.8
    assert "shelf" in found.objects


def test_anywhere_finds_the_largest():
    free = scene(CIRCLE.model_copy(update={"pose": Pose()}), box("bed", (3.0, 4.0, 0.5), 3.5, 2.0))
    found = measure(Placed.of(free), free.free_areas[0], anywhere=True).measurement
    assert found is not None and found.value == pytest.approx(2.0, abs=0.06)
    oblong = FreeArea(id="r", kind="rectangle", size=(3.6, 1.8))
    found = measure(Placed.of(free), oblong, anywhere=True).measurement
    assert found is not None and found.value == pytest.approx(4.0, abs=0.1)  # 4 x 2 m


def test_what_is_not_there_is_not_measured():
    for area in (
        FreeArea(id="c", kind="clearance", size=(1.0, 1.0), targets=("gone",)),
        FreeArea(id="g", kind="gap", size=(1.0, 1.0), targets=("gone", "lost")),
        FreeArea(id="p", kind="path", size=(1.0, 1.0), targets=("door",), others=("gone",)),
    ):
        made = scene(area, box("bed", (2.0, 1.6, 0.5), 3.5, 2.0))
        assert measure(Placed.of(made), area).measurement is None
        assert verdict(made)[0]


def test_who_gets_to_the_table_of_a_sofa_gets_to_the_sofa():
    area = FreeArea(id="p", kind="path", size=(0.8, 0.8), targets=("door",), others=("sofa",))
    sofa, low = box("sofa", (0.8, 1.6, 0.8), 4.6, 2.0, yaw=math.pi), box("table", (0.6, 3.8, 0.4), 3.5, 2.0)
    tie = Relation(type="front_to_front", subject="table", target="sofa")
    assert width(scene(area, sofa, low)) < 0.8
    assert width(scene(area, sofa, low, relations=(tie,))) > 0.8
