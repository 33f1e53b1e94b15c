"""Free floor of a request in a first draft: free areas about the right things, more floor, relations that agree."""

from __future__ import annotations

from sceneweaver.assets import Library
from sceneweaver.generate.free_floor import agreeing, free_areas_of, kept_free
from sceneweaver.generate.room import first_draft
from sceneweaver.generate.setup import Setup
from sceneweaver.generate.shell import floor_area
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Door, FreeArea, Relation, Room, Scene

HALL = Room(
    outline=((0, 0), (4, 0), (4, 3), (0, 3)),
    doors=(
        Door(id="in", wall=0, offset=1.0, width=0.9, height=2.0),
        Door(id="out", wall=2, offset=1.0, width=0.9, height=2.0),
    ),
)


def draft(text: str, kind: str) -> Scene:
    empty = Scene(id="empty", room=HALL)
    setup = Setup(brief=read_request(text), room_type=room_type(kind), scene=empty, library=Library(), seed=3)
    scene = first_draft(setup).scene
    assert scene is not None
    return scene


def test_a_draft_keeps_the_floor_free_that_was_asked_for():
    scene = draft("a bedroom with a bed, 70 cm free on both sides of the bed and 2 x 1 m of free floor", "bedroom")
    beside, floor = scene.free_areas
    bed = next(o for o in scene.objects if o.intent.request == "bed")
    assert (beside.kind, beside.side, beside.targets) == ("clearance", "sides", (bed.id,))
    assert (floor.kind, floor.size, floor.request) == ("rectangle", (2.0, 1.0), "free_area-1")


def test_free_floor_makes_a_room_larger_unless_its_size_is_given():
    kind = room_type("bedroom")
    plain, free = (read_request(f"a bedroom with a bed{more}") for more in ("", " and 2 x 2 m of free floor"))
    assert floor_area(kind, free, 1)[0] > floor_area(kind, plain, 1)[0] + 0.5 * kept_free(free)
    given = read_request("a bedroom of 4 x 3 m with a bed and 2 x 2 m of free floor")
    assert floor_area(kind, given, 1)[0] == 12.0


def test_two_doors_are_told_apart():
    brief = read_request("a hall: keep a straight walkway of 1.1 m from door to door")
    (way,) = free_areas_of(brief, {}, HALL)
    assert (way.targets, way.others) == (("in",), ("out",))


def test_all_things_of_a_noun_are_meant():
    brief = read_request("an office with four desks, 1.2 m between the desks")
    (gap,) = free_areas_of(brief, {"desk": ["desk-0", "desk-1", "desk-2"]}, HALL)
    assert (gap.kind, gap.targets, gap.others) == ("gap", ("desk-0", "desk-1", "desk-2"), ())


def test_what_has_to_be_off_the_walls_stands_at_none():
    off = FreeArea(id="o", kind="gap", size=(0.5, 0.5), targets=("kiln",), others=("wall",))
    wall, corner = Relation(type="against_wall", subject="kiln"), Relation(type="in_corner", subject="kiln", asked=True)
    other = Relation(type="against_wall", subject="shelf")
    found = agreeing([wall, corner, other], [off])
    assert [r.type for r in found if r.subject == "kiln"] == ["in_corner"]
    assert found[0].params["to_wall"] > 0.5
    assert other in found


def test_what_is_to_be_apart_is_not_near():
    gap = FreeArea(id="g", kind="gap", size=(1.2, 1.2), targets=("counter",), others=("shelf",))
    near = Relation(type="near", subject="shelf", target="counter", params={"max": 0.3})
    behind = Relation(type="behind", subject="shelf", target="counter", asked=True)
    wall = Relation(type="against_wall", subject="counter")
    found = agreeing([near, behind, wall], [gap])
    assert [r.type for r in found] == ["behind"]
    assert found[0].params["max"] >= 2.2
    asked = agreeing([near.model_copy(update={"asked": True})], [gap])
    assert asked[0].params["max"] > 1.2
