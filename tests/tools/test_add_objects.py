"""Adding objects: bodies, ids, relations, places; the engine finds room for them."""

from __future__ import annotations

import pytest

import sceneweaver as sw
from sceneweaver.assets import make
from sceneweaver.language import Entity, SceneGraph, StatedRelation, Unread
from sceneweaver.scene import InputError, Pose, Room, Scene
from sceneweaver.scene.edits import Add, Relate, apply_all
from tests.sizes import sizes


def added(proposal):
    return [e.object for e in proposal.edits if isinstance(e, Add)]


def related(proposal, subject=None):
    rows = [e.relation for e in proposal.edits if isinstance(e, Relate)]
    return [r for r in rows if subject is None or r.subject == subject]


def after(scene, proposal):
    return apply_all(scene, proposal.edits)[0]


def test_a_room_is_furnished_and_valid(lounge, call):
    rows = [
        {"category": "tv stand"},
        {"category": "tv"},
        {"category": "floor lamp"},
        {"category": "rug"},
        {"category": "potted plant", "count": 2},
        {"category": "curtain"},
        {"category": "ceiling light"},
        {"category": "table lamp"},
    ]
    proposal = call("add_objects", lounge, {"objects": rows}, seed=3)
    assert not proposal.unmet
    scene = after(lounge, proposal)
    assert Scene.loads(scene.dumps()) == scene
    assert len(scene.objects) == len(lounge.objects) + 9
    best = sw.refine(scene, candidates=64, init="current", device="cpu").best
    report = sw.check(best)
    assert report.valid, report.violations


def test_poses_and_mounts(lounge, call):
    proposal = call(
        "add_objects", lounge, {"objects": [{"category": c} for c in ("picture", "pendant", "bench", "book")]}
    )
    picture, pendant, bench, book = added(proposal)
    assert (picture.mount, pendant.mount, bench.mount, book.mount) == ("wall", "ceiling", "floor", "surface")
    low, high = picture.intent.mounting_height
    assert 0 < low <= picture.pose.position[2] <= high < lounge.room.height - picture.size[2]
    assert pendant.pose.position[2] + pendant.size[2] == pytest.approx(lounge.room.height)
    assert bench.pose == Pose()
    carrier = lounge.object(book.support.object)
    surface = next(s for s in carrier.surfaces if s.name == book.support.surface)
    assert book.pose.position[2] == pytest.approx(carrier.pose.position[2] + surface.z)


def test_small_things_stand_free_on_what_is_named(lounge, call):
    rows = [{"category": "mug", "count": 3, "on": "coffee table"}, {"category": "table lamp", "on": ["sideboard-0"]}]
    scene = after(lounge, call("add_objects", lounge, {"objects": rows}))
    assert [o.support.object for o in scene.objects if o.category == "mug"] == ["coffee_table-0"] * 3
    assert scene.object("table_lamp-0").support.object == "sideboard-0"
    report = sw.check(scene)
    assert report.valid, report.violations


def test_what_fits_nowhere_is_unmet(lounge, call):
    proposal = call("add_objects", lounge, {"objects": [{"category": "mug", "count": 100, "on": "coffee table"}]})
    assert 0 < len(added(proposal)) < 100
    assert len(proposal.unmet) == 1 and "mug" in proposal.unmet[0]
    assert sw.check(after(lounge, proposal)).valid
    proposal = call("add_objects", lounge, {"objects": [{"category": "mug", "on": "piano"}]})
    assert not proposal.edits and "piano" in proposal.unmet[0]


def test_relations_name_what_is_meant(lounge, call):
    rows = [
        {"category": "floor lamp", "place": [{"type": "near", "to": "sofa", "max": 0.5, "soft": True}]},
        {"category": "bookcase", "place": [{"type": "against_wall", "to": "wall:left"}]},
        {"category": "palm", "place": [{"type": "at_window", "to": "window"}]},
        {"category": "pouf", "place": [{"type": "between", "to": ["sofa", "armchair-0"]}]},
        {"category": "trash can", "place": [{"type": "away_from_door", "params": {"min": 0.5}}]},
    ]
    proposal = call("add_objects", lounge, {"objects": rows})
    assert not proposal.unmet
    lamp, shelf, palm, pouf, waste_bin = (r for r in related(proposal))
    assert (lamp.type, lamp.target, lamp.hard, lamp.params) == ("near", "sofa-0", False, {"max": 0.5})
    assert (shelf.type, shelf.target) == ("against_wall", "wall:3")
    assert palm.target == "window-0" and pouf.target == ("sofa-0", "armchair-0") and waste_bin.params == {"min": 0.5}


def test_what_is_not_there_is_unmet_and_the_usual_place_serves(lounge, call):
    proposal = call(
        "add_objects", lounge, {"objects": [{"category": "bookcase", "place": [{"type": "near", "to": "piano"}]}]}
    )
    assert len(proposal.unmet) == 1 and "piano" in proposal.unmet[0]
    assert [r.type for r in related(proposal) if r.hard] == ["against_wall"]


def test_ids_are_fresh_and_bodies_match_their_set(call):
    room = Room(type="kitchen", outline=((0, 0), (5, 0), (5, 5), (0, 5)))
    table = make("dining_table", seed=2).object("dining_table-0", pose=Pose.from_yaw(2.5, 2.5, 0, 0))
    chair = make("dining_chair", seed=5).object("dining_chair-1", pose=Pose.from_yaw(4, 2.5, 0, 3.14))
    scene = Scene(id="k", room=room, objects=(table, chair))
    row = {"category": "dining chair", "count": 3, "place": [{"type": "front_against", "to": "dining table"}]}
    proposal = call("add_objects", scene, {"objects": [row]}, room="restaurant")
    new = added(proposal)
    assert len({o.id for o in new} | {"dining_chair-1"}) == 4
    assert {o.asset for o in new} == {chair.asset}, "chairs of a set are equal"
    assert all(r.target == "dining_table-0" for r in related(proposal))


def test_chairs_go_to_tables_that_have_room(call):
    room = Room(type="office", outline=((0, 0), (8, 0), (8, 6), (0, 6)))
    desks = tuple(make("desk", seed=k).object(f"desk-{k}", pose=Pose.from_yaw(1 + 2 * k, 3, 0, 0)) for k in range(3))
    scene = Scene(id="o", room=room, objects=desks)
    proposal = call("add_objects", scene, {"objects": [{"category": "stool", "count": 3}]}, room="gym")
    assert sorted(r.target for r in related(proposal) if r.type == "front_to_front") == ["desk-0", "desk-1", "desk-2"]


def test_seed_decides(lounge, call):
    inputs = {"objects": [{"category": "vase", "count": 2}, {"category": "bookcase"}]}
    first, again, other = (call("add_objects", lounge, inputs, seed=s) for s in (4, 4, 5))
    assert first == again and first != other


def test_the_request_and_the_room_leave_their_marks(lounge, call):
    brief = SceneGraph(text="x", entities=(Entity(id="plant", noun="plants", category="palm", count=(1, 1)),))
    new = added(
        call(
            "add_objects",
            lounge,
            {"objects": [{"category": "palm", "count": 2}, {"category": "tv stand"}]},
            brief=brief,
        )
    )
    assert [o.intent.request for o in new] == ["plant", None, None]
    assert new[0].intent.priority == "asked" and new[2].intent.program_item == "tv_stand"


def test_size_colour_and_unknown_words(lounge, call):
    rows = [{"category": "bookcase", "size": [None, 1.0, 1.8], "color": "white"}, {"category": "flux capacitor"}]
    proposal = call("add_objects", lounge, {"objects": rows})
    shelf, thing = added(proposal)
    assert shelf.size[1:] == pytest.approx((1.0, 1.8), abs=0.01)
    assert thing.category == "flux_capacitor" and any("flux capacitor" in note for note in proposal.notes)


@pytest.mark.parametrize(
    ("inputs", "line"),
    [
        ({}, "inputs.objects is missing"),
        ({"objects": [{"category": "desk", "place": [{"type": "nere"}]}]}, 'did you mean "near"'),
        ({"objects": [{"category": "desk", "count": 0}]}, "inputs.objects[0].count is 0; at least 1"),
    ],
)
def test_bad_inputs(lounge, call, inputs, line):
    with pytest.raises(InputError) as caught:
        call("add_objects", lounge, inputs)
    assert line in str(caught.value)


def test_impossible_params_are_unmet(lounge, call):
    rows = [
        {"category": "bench", "place": [{"type": "near", "to": "sofa", "colour": 3}]},
        {"category": "bench", "place": [{"type": "against_wall", "to": "wall:9"}]},
    ]
    proposal = call("add_objects", lounge, {"objects": rows})
    assert len(proposal.unmet) == 2 and "colour" in proposal.unmet[0] and "wall 9" in proposal.unmet[1]


@sizes("count", 1, 8)
def test_an_empty_room_of_every_kind_takes_its_own_items(call, count):
    from sceneweaver.knowledge import room_types

    for name, room in room_types().items():
        scene = Scene(id="e", room=Room(type=name, outline=((0, 0), (8, 0), (8, 6), (0, 6))))
        rows = [{"category": item.what[0]} for item in room.items][:count]
        proposal = call("add_objects", scene, {"objects": rows}, room=name)
        assert Scene.loads(after(scene, proposal).dumps())


def test_a_sentence_is_read(lounge, call):
    reader = pytest.importorskip("sceneweaver.language")
    if not hasattr(reader, "read_request"):
        pytest.skip("the reader of requests is not there")
    proposal = call("add_objects", lounge, instruction="add two plants and a floor lamp next to the sofa")
    new = sorted(o.category for o in added(proposal))
    assert new.count("floor_lamp") == 1 and len(new) == 3 and "sofa" not in new
    assert any(r.target == "sofa-0" for r in related(proposal, "floor_lamp-0"))


def test_a_read_sentence_becomes_inputs(lounge, call, monkeypatch):
    brief = SceneGraph(
        text="x",
        entities=(
            Entity(id="book", noun="books", category="book", count=(2, 2), color="red"),
            Entity(id="shelf", noun="large bookcase", category="bookcase", words=("tall",)),
            Entity(id="sofa", noun="the sofa", category="sofa"),
        ),
        relations=(
            StatedRelation(type="on", subject="book", targets=("shelf",)),
            StatedRelation(type="near", subject="shelf", targets=("sofa",), params={"max": 0.8}),
            StatedRelation(type="at", subject="shelf", targets=("corner",)),
        ),
        unread=(Unread(words="flummox"),),
    )
    monkeypatch.setattr("sceneweaver.language.read_request", lambda text: brief, raising=False)
    proposal = call("add_objects", lounge, instruction="add ...")
    assert sorted(o.category for o in added(proposal)) == ["book", "book", "bookcase"]
    shelf = next(o for o in added(proposal) if o.category == "bookcase")
    assert {(r.type, r.target) for r in related(proposal, shelf.id)} == {("near", "sofa-0"), ("in_corner", None)}
    assert all(o.support.object == shelf.id for o in added(proposal) if o.category == "book")
    assert shelf.intent.priority == "asked" and any("flummox" in note for note in proposal.notes)
    monkeypatch.setattr("sceneweaver.language.read_request", lambda text: SceneGraph(text=text), raising=False)
    with pytest.raises(InputError, match="names nothing to add"):
        call("add_objects", lounge, instruction="hello")


def test_usual_places_name_what_exists():
    from sceneweaver.assets import categories
    from sceneweaver.knowledge.usual_places import usual_places

    known = categories()
    for what, rows in usual_places():
        assert what <= set(known)
        for row in rows:
            assert row.to in (None, "window", "wall") and set(row.instead) <= set(known)


def test_words_of_a_call_set_size_and_material(lounge, call):
    proposal = call("add_objects", lounge, {"objects": [{"category": "side table", "words": "narrow walnut"}]}, seed=3)
    (table,) = added(proposal)
    assert table.size[0] < 0.36 and table.attributes["material"] == "walnut"
