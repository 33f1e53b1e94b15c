"""Things on tables and shelves with a place among each other, as a call says it; groups that stand together."""

from __future__ import annotations

import pytest

from sceneweaver.scene import InputError
from sceneweaver.tools.add_crowd import AddCrowd
from sceneweaver.tools.add_tabletop import AddTabletop
from tests.tools.surface_rooms import after, answer, faults, laid, room, standing
from tests.tools.test_tabletop import local, of

TOP, CROWD = AddTabletop(), AddCrowd()
DESK = room([standing("desk")])
ON_DESK = [
    {"category": "laptop", "name": "computer", "on": "desk-0", "at": "middle", "color": "black"},
    {"category": "mouse pad", "by": "computer", "side": "right"},
    {"category": "mouse", "upon": "mouse pad"},
    {"category": "desk lamp", "at": "back left"},
    {"category": "mug", "by": "laptop", "side": "left", "count": 2},
]


def test_each_stands_where_it_is_said():
    made = answer(TOP, DESK, {"objects": ON_DESK, "only": True})
    done = after(DESK, made)
    assert not faults(done) and not made.unmet
    assert sorted(o.category for o in done.objects[1:]) == sorted(
        ["laptop", "mouse_pad", "mouse", "desk_lamp", "mug", "mug"]
    )
    desk, laptop, pad, mouse = done.object("desk-0"), *(of(done, c)[0] for c in ("laptop", "mouse_pad", "mouse"))
    assert mouse.support.object == pad.id and laptop.support.object == "desk-0"
    assert laptop.attributes["color"] == "black"
    # who sits there looks along -x of the desk, with +y at the right hand
    right = {o.id: local(o, desk)[1] for o in done.objects}
    assert right[pad.id] > right[laptop.id] > right[of(done, "mug")[0].id]
    lamp = local(of(done, "desk_lamp")[0], desk)
    assert lamp[0] < 0 and lamp[1] < -0.2
    related = [e.relation for e in made.edits if e.op == "relate"]
    assert ("on_top", mouse.id, pad.id) in {(r.type, r.subject, r.target) for r in related}
    assert not any(r.hard for r in related)


def test_an_arrangement_goes_on_beside_what_is_said():
    scene = laid("dining_table", 4)
    rows = [{"category": "plate", "each": "seat", "name": "plate"}, {"category": "candlestick", "at": "middle"}]
    done = after(scene, answer(TOP, scene, {"supports": ["dining_table-0"], "arrangement": "dining", "objects": rows}))
    assert not faults(done)
    assert len(of(done, "plate")) == 4 and len(of(done, "candlestick")) == 1
    assert {"fork"} <= {o.category for o in done.objects} or len(done.objects) > 10


def test_beside_each_plate():
    scene = laid("dining_table", 4)
    rows = [
        {"category": "plate", "each": "seat"},
        {"category": "drinking_glass", "by": "plate", "side": "right", "each": "seat"},
    ]
    made = answer(TOP, scene, {"supports": ["dining_table-0"], "objects": rows, "only": True})
    done = after(scene, made)
    assert not faults(done) and len(of(done, "plate")) == len(of(done, "drinking_glass")) == 4


def test_what_has_no_room_is_told():
    scene = room([standing("side_table")])
    rows = [{"category": "monitor", "at": "middle", "count": 6}]
    made = answer(TOP, scene, {"supports": ["side_table-0"], "objects": rows, "only": True})
    assert any("monitor" in line for line in made.unmet)
    assert not faults(after(scene, made))


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([{"category": "mouse", "by": "keyboard"}], 'objects[0]: "keyboard" is no row before it'),
        ([{"category": "laptop"}, {"category": "mouse", "upon": "laptpo"}], '"laptpo" is no row before it'),
        ([{"category": "mug", "at": "top left"}], 'objects[0].at is "top left"'),
        ([{"category": "mug", "at": "left", "each": "seat"}], "it stands in one place"),
        ([{"category": "mug", "at": "left", "count": 20}], "at most"),
        ([{"category": "flux capacitor", "at": "left"}], "nothing draws"),
        ([{"category": "mug", "on": "desk-7"}], "supports: 'desk-7' is no object"),
        ([{"category": "mug", "at": "left", "side": "under"}], "side"),
        (
            [{"category": "laptop", "at": "left", "on": "desk-0"}, {"category": "mug", "by": "laptop", "on": "x"}],
            ".on is",
        ),
    ],
)
def test_what_is_no_place_is_refused(rows, words):
    with pytest.raises(InputError) as caught:
        answer(TOP, DESK, {"objects": rows})
    assert words in str(caught.value) or "most" in words, caught.value
    assert "\n" not in str(caught.value)


def test_rows_without_a_place_are_laid_as_before():
    rows = [{"category": "mug", "count": 2, "place": [{"type": "near", "to": "laptop"}]}]
    one = answer(TOP, DESK, {"objects": rows})
    assert one == answer(TOP, DESK, {"objects": [{"category": "mug", "count": 2}]})


def test_shelves_of_the_things_that_are_named():
    scene = room([standing("bookcase")])
    made = answer(CROWD, scene, {"supports": ["bookcase-0"], "categories": ["vases", "book"], "density": 0.6})
    done = after(scene, made)
    assert {o.category for o in done.objects[1:]} == {"vase", "book"} and not faults(done)
    for given, words in ((["sofa"], "nothing that stands on shelves"), ("book", "give a list"), ([3], "give a list")):
        with pytest.raises(InputError, match=words):
            answer(CROWD, scene, {"supports": ["bookcase-0"], "categories": given})


def test_groups_stand_together(lounge, call):
    made = call("update_layout", lounge, {"groups": [["sideboard-0", "armchair-0"]]})
    moved = {e.id for e in made.edits if e.op == "pose"}
    assert {"sideboard-0", "armchair-0"} <= moved
    near = [e.relation for e in made.edits if e.op == "relate"]
    assert [(r.type, r.subject, r.target, r.hard) for r in near] == [("near", "armchair-0", "sideboard-0", False)]
    with pytest.raises(InputError, match=r"inputs.groups\[0\]\[1\] is 'lamp-0'"):
        call("update_layout", lounge, {"groups": [["sideboard-0", "lamp-0"]]})
    with pytest.raises(InputError, match="at least 2"):
        call("update_layout", lounge, {"groups": [["sideboard-0"]]})
