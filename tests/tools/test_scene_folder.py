"""A folder of scenes as a library: its index, what is damaged, and which scene is chosen."""

from __future__ import annotations

import json
import os

import pytest

import sceneweaver as sw
from sceneweaver.importers import SourceFormat, SourceObject, SourceRoom, read
from sceneweaver.io import InputError, parse_json, read_bytes
from sceneweaver.knowledge.scene_words import text_likeness
from sceneweaver.language import Entity, Exclusion, SceneGraph
from sceneweaver.scene import Scene
from sceneweaver.tools import scene_files
from sceneweaver.tools.model_outputs import ModelOutputs
from sceneweaver.tools.scene_folder import INDEX, kind_named, scene_folder
from sceneweaver.tools.scene_model import SceneRequest

SIZES = {"bed": (2.0, 1.6, 0.5), "desk": (0.7, 1.4, 0.75), "wardrobe": (0.6, 1.2, 2.0), "plant": (0.5, 0.5, 1.0)}


def rooms_of(path, options):
    """Rooms as a made-up system writes them: {"them": [{"name", "type", "text", "things"}]}."""
    data = parse_json(read_bytes(path))
    for row in data["them"]:
        if row.get("broken"):
            raise InputError(f"{path.name}: room {row['name']} has no things; write some")
        things = [
            SourceObject(
                name=f"{label}-{k}", label=label, position=(0.8 + 1.1 * k, 1.3, SIZES[label][2] / 2), size=SIZES[label]
            )
            for k, label in enumerate(row["things"])
        ]
        outline = ((0, 0), (5, 0), (5, 3), (0, 3))
        yield SourceRoom(row.get("name", ""), row.get("type", ""), outline, 2.6, (), tuple(things), row.get("text", ""))


@pytest.fixture
def theirs(monkeypatch):
    """A format of another system, known to the importers."""
    entry = SourceFormat("them", "Them", lambda path, head: b'"them"' in head, rooms_of)
    for module in (read,):
        monkeypatch.setattr(module, "formats", lambda: {"them": entry})
    return entry


@pytest.fixture
def folder(tmp_path, lounge, theirs):
    """Scenes of ours, a file of another system with three rooms, damaged files, and others."""
    lounge.save(tmp_path / "lounge.json")
    run = tmp_path / "run"
    (run / "steps" / "01").mkdir(parents=True)
    for place in (run, run / "steps" / "01"):
        Scene.example("bedroom").save(place / "scene.json")
    (run / "metrics.json").write_text("{}")
    rooms = [
        {"name": "r1", "type": "Bedroom-12", "text": "a quiet bedroom to sleep in", "things": ["bed", "wardrobe"]},
        {"name": "r2", "type": "MasterBedroom", "text": "a bedroom to write in", "things": ["bed", "desk", "plant"]},
        {"name": "r3", "type": "Office", "things": ["desk", "plant"]},
    ]
    (tmp_path / "them.json").write_text(json.dumps({"them": rooms}))
    (tmp_path / "cut.json").write_text('{"them": [')
    (tmp_path / "half.json").write_text(json.dumps({"them": [{"name": "z", "broken": True}]}))
    (tmp_path / "noise.json").write_text("{}")
    (tmp_path / "notes.txt").write_text("no scene")
    return tmp_path


def test_what_a_folder_holds(folder):
    found = scene_folder(folder)
    cards = {card.name: card for card in found.cards}
    assert set(cards) == {"lounge", "run", "them#r1", "them#r2", "them#r3"}
    assert [cards[f"them#r{k}"].room for k in (1, 2, 3)] == ["bedroom", "master_bedroom", "office"]
    assert cards["them#r2"].source == "them" and cards["lounge"].source == ""
    assert cards["them#r2"].prompt == "a bedroom to write in" and cards["them#r2"].categories["desk"] == 1
    assert len(found.left_out) == 2 and all("\n" not in line for line in found.left_out)
    assert any("half.json: " in line and "no things" in line for line in found.left_out)
    assert any("cut.json: " in line for line in found.left_out)
    assert found.load("them#r2").scene.prompt == "a bedroom to write in"
    with pytest.raises(InputError, match="there is no scene 'them#r4'"):
        found.load("them#r4")


def test_the_index_is_made_once_and_renewed(folder, monkeypatch):
    read_files = []
    real = scene_files.read_scenes

    def counted(path, *args, **more):
        read_files.append(path.name)
        return real(path, *args, **more)

    monkeypatch.setattr(scene_files, "read_scenes", counted)
    first = scene_folder(folder)
    assert "them.json" in read_files and (folder / INDEX).is_file()
    read_files.clear()
    again = scene_folder(folder)
    assert again.cards == first.cards and again.left_out == first.left_out and read_files == []
    data = json.loads((folder / "them.json").read_text())
    data["them"].pop()
    (folder / "them.json").write_text(json.dumps(data))
    (folder / "cut.json").unlink()
    renewed = scene_folder(folder)
    assert "them#r3" not in {card.name for card in renewed.cards} and read_files == ["them.json"]
    assert len(renewed.left_out) == 1
    (folder / INDEX).write_text('{"schema": "other"')
    assert scene_folder(folder).cards == renewed.cards


@pytest.mark.skipif(os.geteuid() == 0, reason="root writes everywhere")
def test_a_folder_that_cannot_be_written_serves_as_well(folder):
    folder.chmod(0o500)
    try:
        assert scene_folder(folder).cards and not (folder / INDEX).exists()
    finally:
        folder.chmod(0o700)


def test_no_folder_and_an_empty_one(tmp_path):
    with pytest.raises(InputError, match="is no folder"):
        scene_folder(tmp_path / "nothing")
    assert scene_folder(tmp_path).cards == () and not (tmp_path / INDEX).exists()


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("LivingRoom-3421", "living_room"),
        ("MasterBedroom-7", "master_bedroom"),
        ("bedroom", "bedroom"),
        ("KITCHEN", "kitchen"),
        ("the living room", "living_room"),
    ],
)
def test_kinds_by_their_words(words, kind):
    assert kind_named(words, ()) == kind


def test_a_kind_by_its_things():
    assert kind_named("room", ("toilet", "shower")) == "bathroom"


def test_words_tell_scenes_apart():
    texts = ["a bedroom to write in, with a desk", "a bedroom to sleep in", "a desk", ""]
    found = text_likeness("a bedroom in which to write at a desk", texts)
    assert found[0] == max(found) and found[3] == 0.0 and all(0.0 <= v <= 1.0 + 1e-9 for v in found)
    assert text_likeness("", texts) == [0.0] * 4 and text_likeness("x", []) == []


def test_init_library_chooses_by_things_and_words_and_adapts(call, folder):
    def begun(text, **brief):
        start = Scene.example("bedroom")
        graph = SceneGraph(text=text, **brief)
        return call("init_library", start, {"folder": str(folder)}, brief=graph, room="bedroom")

    desk = Entity(id="desk", noun="desk", category="desk")
    assert begun("a bedroom to write in", entities=(desk,)).scene.provenance["library"] == "them#r2"
    quiet = begun(
        "a quiet bedroom with a wardrobe to sleep in", exclusions=(Exclusion(words="plant", categories=("plant",)),)
    )
    assert quiet.scene.provenance["library"] == "them#r1"
    proposal = begun(
        "a bedroom to write in",
        entities=(desk,),
        size=(6.0, 4.0),
        exclusions=(Exclusion(words="bed", categories=("bed",)),),
    )
    scene = proposal.scene
    assert "bed" not in {o.category for o in scene.objects} and scene.room.type == "bedroom"
    xs, ys = zip(*scene.room.outline, strict=True)
    assert (max(xs) - min(xs), max(ys) - min(ys)) == pytest.approx((6.0, 4.0))
    assert scene.room.doors and proposal.origin.room.doors == ()
    assert sum("left out" in note for note in proposal.notes) == 2


def test_a_folder_of_outputs_answers_with_the_one_for_the_request(folder):
    outputs = ModelOutputs(folder)
    assert outputs.generate(SceneRequest("A bedroom to write in.")).name == "them#r2"
    assert outputs.generate(SceneRequest("Lounge", kind="living_room")).name == "lounge"
    near = outputs.generate(SceneRequest("an office with a desk and a plant", kind="office"))
    assert near.name == "them#r3" and any("alike in words" in note for note in near.notes)
    file = ModelOutputs(folder / "them.json", "them", "r1")
    assert file.generate(SceneRequest("a bedroom to write in")).scene.prompt == "a quiet bedroom to sleep in"
    with pytest.raises(InputError, match="holds no scene 'r9'"):
        ModelOutputs(folder / "them.json", name="r9").generate(SceneRequest("x"))
    with pytest.raises(InputError, match="half.json"):
        ModelOutputs(folder / "half.json").generate(SceneRequest("x"))
    assert sw.check(near.scene) is not None
