"""Bare walls: what is hung over furniture and on free stretches, where, and what keeps it away."""

from __future__ import annotations

import math

import pytest

from sceneweaver.assets import Library, categories, make
from sceneweaver.generate.wall_objects import EACH, OVER
from sceneweaver.generate.wall_plan import AROUND, CORNER, FRAME, MARGIN, PASSED, UNDER, Outlines, extent, free_runs
from sceneweaver.geometry.angles import dot
from sceneweaver.knowledge import room_type, room_types
from sceneweaver.knowledge.small_things import most_on_walls, wall_things
from sceneweaver.language import read_request
from sceneweaver.scene import Door, InputError, Pose, Room, Scene, Window
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.add_wall_objects import AddWallObjects
from sceneweaver.tools.base import Context
from sceneweaver.verify import check
from tests.for_each import for_each

LIBRARY = Library()
DOOR = Door(id="door-0", wall=0, offset=0.2, width=0.9, height=2.0)
WINDOW = Window(id="window-0", wall=1, offset=1.2, width=1.4, sill=0.9, height=1.2)
SQUARE = ((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0))
L_SHAPE = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 5.5), (0.0, 5.5))


def scene(*objects, outline=SQUARE, kind="living_room") -> Scene:
    return Scene(id="s", room=Room(type=kind, outline=outline, doors=(DOOR,), windows=(WINDOW,)), objects=objects)


def sofa(x: float = 2.5):
    """A sofa with its back at the wall y = 4."""
    made = make("sofa", seed=1)
    return made.object("sofa-0", pose=Pose.from_yaw(x, 4.0 - made.size[0] / 2 - 0.01, 0.0, -math.pi / 2))


def hung(before: Scene, text: str = "a living room", seed: int = 3, **inputs):
    kind = room_type(before.room.type)
    proposal = AddWallObjects().propose(Context(read_request(text), kind, before, LIBRARY, seed, "", inputs))
    return apply_all(before, proposal.edits)[0], proposal


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("outline", [SQUARE, L_SHAPE])
def test_no_long_stretch_is_bare_and_all_is_valid(seed, outline):
    before = scene(outline=outline)
    after, _ = hung(before, seed=seed)
    assert check(after).valid
    new = [o for o in after.objects if o.category != "radiator"]
    for wall in after.room.walls:
        assert not free_runs(after.room, new, wall, EACH)
        for obj in new:
            along, deep = extent(obj, wall)
            if abs(deep[0]) < 0.01 and dot(obj.pose.frame.axis, wall.inward) > 0.9:
                assert along[0] > CORNER - 0.1 and along[1] < wall.length - CORNER + 0.1
                for opening in after.room.openings_of(wall.index):
                    apart = max(opening.offset - along[1], along[0] - opening.offset - opening.width)
                    assert apart > FRAME - 0.1
        assert all(o.mount == "wall" and o.intent.priority == "optional" for o in new)


def test_art_over_a_sofa_is_on_its_axis_and_two_thirds_as_wide():
    base = sofa()
    after, _ = hung(scene(base), walls=[2])
    over = [o for o in after.objects if o.id != "sofa-0"]
    assert len(over) == 1 and check(after).valid
    art = over[0]
    assert art.pose.position[0] == pytest.approx(base.pose.position[0], abs=0.01)
    assert 0.3 * base.size[1] < art.size[1] <= OVER * base.size[1] + 0.01
    assert art.pose.position[2] > base.size[2] + 0.1
    assert {r.type for r in after.relations if r.subject == art.id} == {"against_wall", "above"}


def test_the_middle_of_art_is_at_the_height_of_the_eyes():
    after, _ = hung(scene(), seed=5)
    art = [o for o in after.objects if o.category in ("picture", "poster", "photo_frames", "tapestry")]
    assert art
    for obj in art:
        assert 1.45 <= obj.pose.position[2] + obj.size[2] / 2 <= 1.75


def test_what_hangs_there_and_tall_furniture_are_left_alone():
    shelf = make("bookcase", seed=1)
    tall = shelf.object("bookcase-0", pose=Pose.from_yaw(1.0, 4.0 - shelf.size[0] / 2 - 0.01, 0.0, -math.pi / 2))
    once, _ = hung(scene(tall))
    again, proposal = hung(once, seed=9)
    assert again == once and proposal.unmet
    assert check(once).valid


def test_what_a_request_names_or_forbids_is_not_added():
    for seed in range(4):
        after, _ = hung(scene(), "a living room with a picture on the wall", seed=seed)
        assert "picture" not in {o.category for o in after.objects}
        after, _ = hung(scene(), "a living room without mirrors", seed=seed)
        assert not {"round_mirror", "wall_mirror"} & {o.category for o in after.objects}


def test_only_the_walls_that_are_named():
    after, _ = hung(scene(), walls=[3])
    assert after.objects and all(o.pose.position[0] < 0.3 for o in after.objects)
    with pytest.raises(InputError, match=r"inputs\.walls: there is no wall 7; use 0 to 3"):
        hung(scene(), walls=[7])


@for_each(sorted(room_types()))
def test_each_kind_of_room_has_things_for_its_walls(name):
    things = wall_things(name)
    assert things and all(share > 0 for share in things.values())
    assert all("wall" in categories()[category].mount for category in things)


def test_walls_for_use_and_worship_have_less_on_them_and_no_prints():
    room = ((0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0))
    counts = dict.fromkeys(("living_room", "warehouse", "church_nave"), 0)
    for kind in counts:
        for seed in range(3):
            after, _ = hung(scene(outline=room, kind=kind), f"a {kind.replace('_', ' ')}", seed=seed)
            if kind != "living_room":
                assert not {"picture", "poster", "photo_frames"} & {o.category for o in after.objects}
            counts[kind] += len(after.objects)
    assert 0 < counts["warehouse"] < 0.5 * counts["living_room"] and counts["church_nave"] < 0.5 * counts["living_room"]


def test_there_is_one_clock():
    room = ((0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0))
    for seed in range(3):
        after, _ = hung(scene(outline=room, kind="waiting_room"), "a waiting room", seed=seed)
        counts = [sum(o.category == name for o in after.objects) for name in ("wall_clock", "notice_board")]
        assert max(counts) <= 1 == most_on_walls("wall_clock")


def test_radiators_are_below_windows_and_clear_of_curtains():
    curtain = make("curtain", seed=2)
    drawn = curtain.object("curtain-0", pose=Pose.from_yaw(5.0 - curtain.size[0] / 2, 1.9, 0.05, math.pi), mount="wall")
    warm = 0
    for seed in range(8):
        for objects in ((), (drawn,)):
            after, _ = hung(scene(*objects), seed=seed)
            assert check(after).valid
            for obj in after.objects:
                if obj.category == "radiator":
                    warm += not objects
                    assert obj.pose.position[1] == pytest.approx(WINDOW.offset + WINDOW.width / 2, abs=0.01)
                    assert obj.size[1] < WINDOW.width and obj.pose.position[2] + obj.size[2] < WINDOW.sill
    assert 3 <= warm <= 8


def test_kinds_of_rooms_without_radiators_have_none():
    for seed in range(6):
        after, _ = hung(scene(kind="workshop"), "a workshop", seed=seed)
        assert "radiator" not in {o.category for o in after.objects}


@pytest.mark.parametrize(("gap", "bare"), ((0.45, True), (0.75, False)))
def test_a_narrow_way_along_a_wall_is_not_narrowed(gap, bare):
    stands = sofa()
    x, y, _ = stands.pose.position
    stands = stands.model_copy(update={"pose": Pose.from_yaw(x, y - gap, 0.0, -math.pi / 2)})
    after, _ = hung(scene(stands), walls=[2])
    (start, end), _ = extent(stands, after.room.walls[2])
    spans = [extent(o, after.room.walls[2])[0] for o in after.objects if o.mount == "wall" and o.pose.position[2] < 1.8]
    assert any(a < end and start < b for a, b in spans) is not bare


@pytest.mark.parametrize(("category", "hangs"), (("chair", True), ("low_bookcase", False)))
def test_boards_hang_where_people_can_stand_before_them(category, hangs):
    made = [make(category, seed=k) for k in range(6)]
    row = [
        asset.object(f"{category}-{k}", pose=Pose.from_yaw(0.5 + 0.8 * k, 3.5, 0.0, -math.pi / 2))
        for k, asset in enumerate(made)
    ]
    boards = []
    for seed in range(6):
        after, _ = hung(scene(*row, kind="classroom"), seed=seed, walls=[2])
        boards += [o for o in after.objects if o.category == "notice_board"]
    assert bool(boards) is hangs


def test_what_is_in_the_way_is_that_of_each_polygon_alone():
    room = Scene.example("bedroom")
    read = Outlines(room.objects[:2])
    for obj in room.objects[2:]:
        read.add(obj)
    for wall in room.room.walls:
        wanted = []
        for obj in room.objects:
            z, frame = obj.pose.position[2], obj.pose.frame
            rings = [(p.polygon, p.z, MARGIN / 2, obj.mount == "floor") for p in obj.solids]
            rings += [(zone.polygon, zone.z, 0.0, False) for zone in obj.zones if zone.hard]
            for ring, (low, high), margin, passed in rings:
                along, deep = zip(*(wall.coordinates(frame.world(*corner)) for corner in ring), strict=True)
                if max(deep) > 0.0 and min(deep) < 0.05 + margin:
                    wanted.append(((min(along), max(along)), (z + low, z + high)))
                if passed and PASSED[0] <= min(deep) < sum(PASSED) + 0.05:
                    wanted.append(((min(along) - AROUND, max(along) + AROUND), (0.0, UNDER)))
        assert sorted(map(tuple, read.before(wall, 0.05))) == sorted(wanted)
