"""Beginning with a library scene: the best match, adapted to the request."""

from __future__ import annotations

import json

import pytest

import sceneweaver as sw
from benchmarks.library_scenes import collect
from sceneweaver.knowledge.library import library_scenes, load_scene, own_folder
from sceneweaver.language import Entity, Exclusion, SceneGraph, StatedRelation
from sceneweaver.scene import InputError, Intent, Relation, Scene


@pytest.fixture
def folder(lounge, tmp_path):
    """A library of a lounge and a bedroom."""
    lounge.save(tmp_path / "lounge.json")
    (tmp_path / "second").mkdir()
    Scene.example("bedroom").save(tmp_path / "second" / "scene.json")
    (tmp_path / "noise.json").write_text("{}")
    (tmp_path / "list.json").write_text("[1]")
    (tmp_path / "broken.json").write_text("{")
    return tmp_path


def begun(call, folder, brief, **more):
    proposal = call("init_library", Scene.example("bedroom"), {"folder": str(folder), **more}, brief=brief)
    scene = proposal.scene
    assert scene is not None and Scene.loads(scene.dumps()) == scene
    return scene, proposal


def test_cards(folder, lounge):
    cards = {card.name: card for card in library_scenes(folder)}
    assert set(cards) == {"lounge", "second"}
    assert cards["lounge"].categories["sofa"] == 1 and cards["lounge"].area == pytest.approx(30.0)
    assert load_scene("lounge", folder) == lounge
    with pytest.raises(InputError, match="there is no scene 'loung'"):
        load_scene("loung", folder)
    with pytest.raises(InputError, match="no folder"):
        library_scenes(folder / "nothing")


def test_as_it_is(call, folder, lounge):
    scene, proposal = begun(call, folder, SceneGraph(text="a living room"))
    assert scene.ids == lounge.ids and scene.prompt == "a living room" and "lounge" in proposal.notes[0]
    assert sw.check(scene).valid == sw.check(lounge).valid


def test_objects_are_swapped_added_and_removed(call, folder):
    brief = SceneGraph(
        text="x",
        entities=(
            Entity(id="sofa", noun="sofa", category="sectional_sofa"),
            Entity(id="armchair", noun="two armchairs", category="armchair", count=(2, 2)),
            Entity(id="lamp", noun="floor lamp", category="floor_lamp", count=(1, 1)),
            Entity(id="book", noun="book", category="book", count=(1, 1)),
            Entity(id="table", noun="coffee table", category="coffee_table"),
        ),
        relations=(
            StatedRelation(type="near", subject="lamp", targets=("sofa",), params={"max": 0.5}),
            StatedRelation(type="on", subject="book", targets=("table",)),
        ),
        exclusions=(Exclusion(words="sideboard", categories=("sideboard",)),),
    )
    # The lounge was made by hand; items tell what may be swapped for what.
    lounge = load_scene("lounge", folder)
    marked = tuple(
        o.model_copy(update={"intent": Intent(program_item=o.category)}) if o.category == "sofa" else o
        for o in lounge.objects
    )
    lounge.model_copy(update={"objects": marked}).save(folder / "lounge.json")
    scene, proposal = begun(call, folder, brief)
    kinds = sorted(o.category for o in scene.objects)
    assert kinds == ["armchair", "armchair", "book", "coffee_table", "floor_lamp", "sectional_sofa", "vase"]
    assert not proposal.unmet
    assert [o.support.object for o in scene.objects if o.category == "book"] == ["coffee_table-0"]
    near = [r for r in scene.relations if r.type == "near" and r.subject == "floor_lamp-0"]
    assert [r.target for r in near if r.asked] == ["sectional_sofa-0"] and sum(r.asked for r in scene.relations) == 1
    best = sw.refine(scene, candidates=64, init="current", device="cpu").best
    assert sw.check(best).valid


def test_a_bed_of_another_kind_takes_the_place_of_the_bed(call, folder):
    brief = SceneGraph(text="x", entities=(Entity(id="bed", noun="single bed", category="single_bed", count=(2, 2)),))
    proposal = call(
        "init_library", Scene.example("bedroom"), {"folder": str(folder), "name": "second"}, brief=brief, room="bedroom"
    )
    beds = [o for o in proposal.scene.objects if "bed" in o.category.split("_")]
    assert [o.category for o in beds] == ["single_bed"] * 2 and all(o.intent.request == "bed" for o in beds)


def test_the_floor_is_made_as_asked(call, folder, lounge):
    scene, proposal = begun(call, folder, SceneGraph(text="x", size=(9.0, 6.0), height=3.2))
    assert scene.room.outline == ((0, 0), (9, 0), (9, 6), (0, 6)) and scene.room.height == 3.2
    assert scene.object("sofa-0").pose.position[0] == pytest.approx(4.5)
    vase, table = scene.object("vase-0").pose, scene.object("coffee_table-0").pose
    assert vase.position[0] - table.position[0] == pytest.approx(0.2, abs=1e-6)
    assert scene.room.doors[0].width == lounge.room.doors[0].width


def test_the_room_gets_the_shape_that_is_asked_for(call, folder, lounge):
    walled = Relation(type="against_wall", subject="sofa-0", target="wall:2")
    lounge.model_copy(update={"relations": (*lounge.relations, walled)}).save(folder / "lounge.json")
    scene, proposal = begun(call, folder, SceneGraph(text="x", shape="L"))
    assert len(scene.room.outline) == 6 and proposal.fresh and not proposal.unmet
    assert scene.ids == lounge.ids
    (wall,) = [r.target for r in scene.relations if r.type == "against_wall"]
    assert scene.room.walls[int(wall[5:])].inward == pytest.approx(lounge.room.walls[2].inward)
    area = sum(w.start[0] * w.end[1] - w.end[0] * w.start[1] for w in scene.room.walls) / 2
    assert area == pytest.approx(30.0, rel=0.05)


def test_only_what_is_named(call, folder):
    brief = SceneGraph(text="x", entities=(Entity(id="sofa", noun="sofa", category="sofa"),), only=True)
    scene, _ = begun(call, folder, brief)
    assert scene.ids == ("sofa-0",) and scene.object("sofa-0").intent.request == "sofa"


def test_the_best_match_is_taken(call, folder, lounge):
    small = lounge.model_copy(update={"objects": lounge.objects[:1], "relations": ()})
    small.save(folder / "bare.json")
    brief = SceneGraph(text="x", entities=(Entity(id="a", noun="armchair", category="armchair"),))
    assert begun(call, folder, brief)[0].provenance["library"] == "lounge"
    assert begun(call, folder, brief, name="bare")[0].provenance["library"] == "bare"
    with pytest.raises(InputError, match="holds no gym"):
        call("init_library", lounge, {"folder": str(folder)}, room="gym")


def test_collecting(lounge, tmp_path):
    runs, to = tmp_path / "runs", tmp_path / "to"
    for k, (valid, grade) in enumerate(((True, 6.0), (True, 9.0), (False, 10.0), (True, 8.0))):
        place = runs / f"run-{k}"
        (place / "steps" / "01").mkdir(parents=True)
        scene = lounge.model_copy(update={"prompt": f"number {k}"})
        scene.save(place / "scene.json")
        scene.save(place / "steps" / "01" / "scene.json")
        (place / "metrics.json").write_text(
            json.dumps({"valid": valid, "scores": {"critic": "symbolic", "layout": grade}})
        )
    assert collect(runs, to, least=7.0) == ["living_room-1", "living_room-2"]
    cards = library_scenes(to)
    assert [c.grade for c in cards] == [9.0, 8.0] and load_scene("living_room-1", to).prompt == "number 1"
    assert sw.check(load_scene("living_room-1", to)).valid == sw.check(lounge).valid


def test_our_own_scenes_load():
    for card in library_scenes() if own_folder().is_dir() else ():
        scene = load_scene(card.name)
        assert len(scene.objects) == sum(card.categories.values())
