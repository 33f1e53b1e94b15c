"""Tools that change what is there: they say what they did, and scenes stay sound."""

from __future__ import annotations

import math

import pytest

import sceneweaver as sw
from sceneweaver.assets import categories, make
from sceneweaver.generate.carry import carried, follow, local, move, world
from sceneweaver.scene import InputError, Pose, Relation, Scene, Support
from sceneweaver.scene.edits import SetPose, apply_all


def after(scene, proposal):
    made = apply_all(scene, proposal.edits)[0]
    assert Scene.loads(made.dumps()) == made
    return made


# ---- carrying -------------------------------------------------------------------------------------------------------


def test_carrying_is_rigid():
    old, new = Pose.from_yaw(1, 2, 0.5, 0.4), Pose.from_yaw(-3, 1, 0.1, 2.0)
    rider = Pose.from_yaw(1.3, 1.8, 1.2, -0.7)
    there = follow(old, new, rider)
    assert local(new, there) == pytest.approx(local(old, rider), abs=1e-9)
    assert follow(new, old, there).position == pytest.approx(rider.position, abs=1e-9)
    x, y, z, yaw = local(old, rider)
    assert world(old, x, y, z, yaw).position == pytest.approx(rider.position, abs=1e-9)


def test_a_tower_moves_as_one(lounge):
    tray = make("serving_tray", seed=0)
    top = lounge.object("coffee_table-0").surfaces[0]
    z = top.z
    base = Support(object="coffee_table-0", surface=top.name)
    first = tray.object("tray-0", pose=Pose.from_yaw(2.9, 3.0, z, 0.3), support=base)
    on = Support(object="tray-0", surface=tray.surfaces[0].name)
    cup = make("mug", seed=0).object("mug-0", pose=Pose.from_yaw(2.9, 3.0, z + tray.surfaces[0].z, 1.0), support=on)
    scene = lounge.model_copy(update={"objects": (*lounge.objects, first, cup)})
    objects = {o.id: o for o in scene.objects}
    assert set(carried(objects, "coffee_table-0")) == {"vase-0", "tray-0", "mug-0"}
    edits = move(scene, {"coffee_table-0": Pose.from_yaw(1, 1, 0, 0), "tray-0": Pose.from_yaw(1, 1.1, z, 0)})
    moved, _ = apply_all(scene, edits)
    assert {e.id for e in edits} == {"coffee_table-0", "vase-0", "tray-0", "mug-0"}
    assert moved.object("tray-0").pose.position == pytest.approx((1, 1.1, z))
    assert moved.object("mug-0").pose.position[:2] == pytest.approx((1, 1.1))


# ---- remove_objects -------------------------------------------------------------------------------------------------


def test_remove_takes_along_what_stands_there(lounge, call):
    proposal = call("remove_objects", lounge, {"ids": ["coffee_table-0", "vase-0"]})
    assert set(after(lounge, proposal).ids) == {"sofa-0", "armchair-0", "sideboard-0"}
    proposal = call("remove_objects", lounge, {"ids": ["coffee_table-0"]})
    assert proposal.notes == ("vase-0 went with coffee_table-0",)


def test_remove_by_category_keeps_some(lounge, call):
    chairs = tuple(make("chair", seed=1).object(f"chair-{k}", pose=Pose.from_yaw(1, 1 + k, 0, 0)) for k in range(3))
    scene = lounge.model_copy(update={"objects": (*lounge.objects, *chairs)})
    assert after(scene, call("remove_objects", scene, {"category": "chair", "keep": 2})).ids[-2:] == (
        "chair-0",
        "chair-1",
    )
    assert call("remove_objects", scene, {"category": "chair", "keep": 3}).edits == ()
    for inputs, line in (
        ({}, "name ids or a category"),
        ({"ids": ["sofa-1"]}, "did you mean 'sofa-0'"),
        ({"category": "piano"}, "there is none"),
    ):
        with pytest.raises(InputError, match=line):
            call("remove_objects", scene, inputs)


# ---- add_relation ---------------------------------------------------------------------------------------------------


def test_relations_are_added_once_and_not_against_others(lounge, call):
    rows = [
        {"type": "against_wall", "subject": "sofa-0"},
        {"type": "facing", "subject": "armchair-0", "target": "coffee_table-0", "params": {"degrees": 40}},
        {"type": "back_to_back", "subject": "coffee_table-0", "target": "sofa-0"},
        {"type": "near", "subject": "armchair-0", "target": "sofa-0", "params": {"max": 1.0}},
        {"type": "distance", "subject": "sofa-0", "target": "armchair-0", "params": {"min": 2.0, "max": 3.0}},
        {"type": "near", "subject": "sofa-0", "target": "armchair-0", "params": {"max": 1.0}},
        {"type": "on_top", "subject": "armchair-0", "target": "coffee_table-0"},
        {"type": "against_wall", "subject": "vase-0"},
        {"type": "front_to_front", "subject": "coffee_table-0", "target": "sideboard-0"},
    ]
    proposal = call("add_relation", lounge, {"relations": rows})
    assert [e.relation.type for e in proposal.edits] == ["against_wall", "near"]
    assert len(proposal.notes) == 2 and all("already" in note for note in proposal.notes)
    assert len(proposal.unmet) == 5
    after(lounge, proposal)


def test_a_wish_can_be_made_a_must(lounge, call):
    soft = {"type": "against_wall", "subject": "sofa-0", "hard": False}
    scene = after(lounge, call("add_relation", lounge, {"relations": [soft]}))
    scene = after(scene, call("add_relation", scene, {"relations": [{**soft, "hard": True}]}))
    assert [r.hard for r in scene.relations if r.type == "against_wall"] == [True]


@pytest.mark.parametrize(
    ("row", "line"),
    [
        ({"type": "nere", "subject": "sofa-0"}, 'relations[0]: type "nere" is unknown'),
        ({"type": "near", "subject": "sofa-9", "target": "armchair-0"}, "did you mean 'sofa-0'"),
        ({"type": "near", "subject": "sofa-0", "target": "rug-0"}, "no object of this scene"),
        ({"type": "near", "subject": "sofa-0"}, "target is missing"),
        ({"type": "near", "subject": "sofa-0", "target": "armchair-0", "params": {"maks": 1}}, "maks"),
        ({"type": "against_wall", "subject": "sofa-0", "target": "wall:7"}, "wall:0 to wall:3"),
    ],
)
def test_wrong_relations(lounge, call, row, line):
    with pytest.raises(InputError) as caught:
        call("add_relation", lounge, {"relations": [row]})
    assert line in str(caught.value) and "inputs.relations[0]" in str(caught.value)


# ---- update_rotation ------------------------------------------------------------------------------------------------


def test_turned_toward_things(lounge, call):
    for toward, (x, y) in (
        ("sofa-0", (3.0, 4.5)),
        ("window", (6.0, 2.5)),
        ("door-0", (0.75, 0.0)),
        ("middle", (3.0, 2.5)),
        ("wall", (6.0, 2.6)),
        ("vase", (3.2, 3.2)),
    ):
        proposal = call("update_rotation", lounge, {"ids": ["armchair-0"], "toward": toward})
        made = after(lounge, proposal)
        pose = made.object("armchair-0").pose
        want = math.atan2(y - pose.position[1], x - pose.position[0])
        assert math.remainder(pose.yaw - want, 2 * math.pi) == pytest.approx(0.0, abs=1e-6), toward
        faces = [r for r in made.relations if r.type == "facing" and r.target == "sofa-0"]
        assert len(faces) == (toward == "sofa-0")
        old = [r for r in made.relations if r.type == "facing" and r.target == "coffee_table-0"]
        assert len(old) == 1


def test_a_turn_holds_against_what_nobody_asked_for(lounge, call):
    made = after(lounge, call("update_rotation", lounge, {"ids": ["armchair-0"], "toward": "wall"}))
    assert [r.hard for r in made.relations if r.type == "facing"] == [False]
    said = tuple(r.model_copy(update={"asked": r.type == "facing"}) for r in lounge.relations)
    asked = lounge.model_copy(update={"relations": said})
    made = after(asked, call("update_rotation", asked, {"ids": ["armchair-0"], "toward": "wall"}))
    assert [r.hard for r in made.relations if r.type == "facing"] == [True]


def test_a_table_turns_with_its_vase(lounge, call):
    made = after(lounge, call("update_rotation", lounge, {"ids": ["coffee_table-0"], "degrees": 0}))
    table, vase = made.object("coffee_table-0"), made.object("vase-0")
    assert table.pose.yaw == pytest.approx(0)
    before = local(lounge.object("coffee_table-0").pose, lounge.object("vase-0").pose)
    assert local(table.pose, vase.pose) == pytest.approx(before, abs=1e-6)
    again = call("update_rotation", made, {"ids": ["coffee_table-0"], "yaw": 2 * math.pi})
    assert not again.edits and "already" in again.notes[0]


def test_square_to_the_walls_by_the_least_turn(lounge, call):
    for degrees, square in ((4.0, 0.0), (-93.0, -90.0), (47.0, 90.0)):
        made = after(lounge, call("update_rotation", lounge, {"ids": ["coffee_table-0"], "degrees": degrees}))
        made = after(made, call("update_rotation", made, {"ids": ["coffee_table-0"], "square": True}))
        turned = made.object("coffee_table-0").pose.yaw - math.radians(square)
        assert math.remainder(turned, 2 * math.pi) == pytest.approx(0.0, abs=1e-6)


def test_bad_turns(lounge, call):
    for inputs in (
        {"ids": ["sofa-0"]},
        {"ids": ["sofa-0"], "square": False},
        {"ids": ["sofa-0"], "yaw": 1, "degrees": 2},
        {"ids": []},
        {"ids": ["sofa-0"], "toward": "the moon"},
        {"ids": ["nothing"], "yaw": 1},
        {"ids": ["sofa-0"], "yaw": float("inf")},
    ):
        with pytest.raises(InputError, match="tool update_rotation: inputs"):
            call("update_rotation", lounge, inputs)


# ---- update_size ----------------------------------------------------------------------------------------------------


def test_a_table_is_made_longer_and_keeps_its_vase(lounge, call):
    d, w, h = lounge.object("coffee_table-0").size
    low, high = categories()["coffee_table"].size.width
    want = low + 0.9 * (high - low)
    made = after(lounge, call("update_size", lounge, {"sizes": {"coffee_table-0": [d, want, h]}}))
    table, vase = made.object("coffee_table-0"), made.object("vase-0")
    assert table.size == pytest.approx((d, want, h), abs=0.01)
    assert table.asset != lounge.object("coffee_table-0").asset
    surface = next(s for s in table.surfaces if s.name == vase.support.surface)
    assert vase.pose.position[2] == pytest.approx(surface.z, abs=1e-6)
    assert sw.check(sw.refine(made, candidates=64, init="current", device="cpu").best).valid


def test_sizes_stay_in_their_range(lounge, call):
    proposal = call("update_size", lounge, {"ids": ["sideboard-0"], "scale": 10})
    made = after(lounge, proposal)
    ranges = categories()["sideboard"].size.ranges
    for value, (_, high) in zip(made.object("sideboard-0").size, ranges, strict=True):
        assert value <= high + 0.01
    assert "was brought to" in proposal.notes[0]


def test_what_fits_no_longer_is_said(call, lounge):
    table = lounge.object("coffee_table-0")
    small = [low for low, _ in categories()["coffee_table"].size.ranges]
    bowls = call("add_objects", lounge, {"objects": [{"category": "vase", "count": 12, "on": "coffee_table-0"}]})
    full = after(lounge, bowls)
    proposal = call("update_size", full, {"sizes": {"coffee_table-0": small}})
    made = after(full, proposal)
    gone = set(full.ids) - set(made.ids)
    assert gone and all(any(object_id in note for note in (*proposal.notes, *proposal.unmet)) for object_id in gone)
    assert made.object("coffee_table-0").size[1] < table.size[1]
    for o in made.objects:
        if o.support is not None:
            assert o.support.surface in {s.name for s in made.object(o.support.object).surfaces}


def test_box_objects_are_scaled_and_bad_sizes_refused(call, lounge):
    scene = Scene.example("bedroom")
    obj = next(o for o in scene.objects if o.asset is None and o.category not in categories())
    d, w, h = obj.size
    made = after(scene, call("update_size", scene, {"ids": [obj.id], "scale": 1.2}, room="bedroom"))
    assert made.object(obj.id).size == pytest.approx((1.2 * d, 1.2 * w, 1.2 * h), rel=1e-6)
    for inputs in (
        {},
        {"ids": ["sofa-0"]},
        {"scale": 2},
        {"sizes": {"sofa-7": [1, 1, 1]}},
        {"sizes": {"sofa-0": [1, 1]}},
    ):
        with pytest.raises(InputError, match="tool update_size: inputs"):
            call("update_size", lounge, inputs)


# ---- update_layout --------------------------------------------------------------------------------------------------


def test_all_is_laid_out_anew(lounge, call):
    proposal = call("update_layout", lounge, {})
    assert proposal.fresh and not proposal.edits


def test_some_are_set_back_with_what_belongs_to_them(lounge, call):
    proposal = call(
        "update_layout",
        lounge,
        {"ids": ["sofa-0"], "relations": [{"type": "against_wall", "subject": "sofa-0", "target": "wall:2"}]},
    )
    moved = {e.id for e in proposal.edits if isinstance(e, SetPose)}
    assert moved == {"sofa-0", "coffee_table-0", "vase-0"} and not proposal.fresh
    made = after(lounge, proposal)
    assert made.object("sofa-0").pose == Pose() and made.object("sideboard-0") == lounge.object("sideboard-0")
    best = sw.refine(made, candidates=64, init="current", device="cpu").best
    assert sw.check(best).valid


def test_what_stands_on_something_moves_with_it(lounge, call):
    proposal = call("update_layout", lounge, {"ids": ["vase-0"]})
    assert {e.id for e in proposal.edits} == {"coffee_table-0", "vase-0"} and "stands on" in proposal.notes[0]
    near = call("update_layout", lounge, {"ids": ["armchair-0"], "near": "sideboard"})
    assert near.edits[0].relation.target == "sideboard-0"
    for inputs in ({"ids": ["x"]}, {"near": "sofa-0"}, {"ids": ["sofa-0"], "near": "piano"}):
        with pytest.raises(InputError, match="tool update_layout: inputs"):
            call("update_layout", lounge, inputs)


def test_what_stands_in_a_row_stays_there(call, lounge):
    """A piece that is laid out by itself would leave its row; with a relation of its own it is asked to."""
    row = Relation(type="next_to", subject="armchair-0", target="sideboard-0", params={"gap": [0.0, 9.0]})
    scene = lounge.model_copy(update={"relations": (*lounge.relations, row)})
    proposal = call("update_layout", scene, {"ids": ["armchair-0"]})
    assert not proposal.edits and not proposal.fresh and "armchair-0 stands in a row" in proposal.notes[0]
    both = call("update_layout", scene, {"ids": ["armchair-0", "coffee_table-0"]})
    assert {e.id for e in both.edits} & {"armchair-0", "coffee_table-0"} == {"coffee_table-0"}
    assert call("update_layout", scene, {"ids": ["armchair-0"], "near": "sofa-0"}).edits
