"""Designs that begin with a scene of somebody else: chosen, asked for, or given, and what is told of it."""

from __future__ import annotations

import json
from typing import Any

import pytest
from pydantic_ai.models.function import FunctionModel

import sceneweaver as sw
from sceneweaver.agent import design
from sceneweaver.agent.changed import start_of
from sceneweaver.agent.learned_starts import NONE
from sceneweaver.assets import make
from sceneweaver.scene import InputError, MissingDependencyError, Pose, Room, Scene
from tests.agent.by_model.scripted import Script
from tests.tools.programmes import PROGRAMME, item, place

QUICK = {"device": "cpu", "candidates": 8, "time_limit": None, "clutter": 0.0, "seed": 1}
SMALL = "a store room with one shelf"


def store(name: str = "store") -> Scene:
    """A store room with two shelves, one of them through a wall."""
    objects = (
        make("metal_shelf", seed=1).object("shelf-a", pose=Pose.from_yaw(0.4, 1.2, 0, 0)),
        make("metal_shelf", seed=1).object("shelf-b", pose=Pose.from_yaw(2.7, 2.3, 0, 3.1)),
    )
    room = Room.rectangle(3.0, 2.6, kind="store_room").with_door("south", at=0.3)
    return Scene(id=name, prompt=SMALL, room=room, objects=objects)


def store_programme() -> dict[str, Any]:
    """A store room as a language model may write it down."""
    items = [
        item("shelf", "metal_shelf", need="needed", count=[1, 1], place=[place("against_wall")], fill="boxes"),
        item("bin", "plastic_bin", place=[place("against_wall")]),
        item("box", "cardboard_box", place=[place("against_wall")]),
        item("light", "ceiling_light", need="needed", place=[place("on_grid")]),
    ]
    return {**PROGRAMME, "kind": "store room", "area": 8, "people": 1, "style": "", "items": items}


class Model:
    """Answers with a scene, or with what is no scene."""

    def __init__(self, answer):
        self.answer = answer

    def generate(self, request):
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer


def test_a_scene_is_gone_on_from(tmp_path):
    file = tmp_path / "theirs.json"
    before = store()
    before.save(file)
    result = design("", start=file, out=tmp_path / "out", steps=2, pictures="none", export="none", **QUICK)
    assert result.brief.text == SMALL  # that of the file
    assert result.report.valid and result.steps[0].call.tool == "init_model"
    assert not sw.check(before).valid
    start = result.start
    assert start is not None and start.name == str(file) and start.objects == 2
    assert "shelf-b" in {s.id for s in start.moved} and not {"shelf-a", "shelf-b"} & set(start.added)
    assert start == start_of(str(file), before, result.scene)
    data = json.loads((tmp_path / "out" / "metrics.json").read_text())["start"]
    assert data["name"] == str(file) and [row["id"] for row in data["moved"]] == [s.id for s in start.moved]
    assert Scene.load(tmp_path / "out" / "start.json") == before
    more = {"steps": 3, "pictures": "none", "export": "none", **QUICK}
    again = design("", start=file, out=tmp_path / "out", **more)
    assert again.start == start_of(str(file), before, again.scene) and len(again.steps) >= len(result.steps)
    with pytest.raises(InputError, match="holds a run with begin"):
        design(SMALL, out=tmp_path / "out", **more)


def test_a_valid_scene_with_all_that_is_asked_for_stays_as_it_is():
    scene = sw.design(SMALL, steps=2, **QUICK).scene
    result = design(SMALL, start=scene, steps=1, **QUICK)
    assert result.start.moved == () and result.start.removed == () and result.start.resized == ()
    assert "stand where they stood" in result.start.lines[0] and result.start.name == f"scene {scene.id}"


def test_a_model_is_asked_and_equal_seeds_give_equal_scenes():
    runs = [design(SMALL, scene_model=Model(store()), steps=2, **QUICK) for _ in range(2)]
    assert runs[0].scene == runs[1].scene and runs[0].steps[0].call.tool == "init_model"
    assert runs[0].start.name.endswith(":Model")


@pytest.mark.parametrize(
    ("answer", "line"),
    [
        (ValueError("no weights"), "it failed: ValueError: no weights"),
        ({"objects": [{"label": "shelf", "size": [1, 1, float("nan")], "position": [0, 0, 0]}]}, "finite number"),
        ({"objects": [{}] * 10_000}, "10000 objects"),
        (None, "has no scene"),
    ],
)
def test_after_a_bad_model_the_agent_goes_on_with_another_tool(answer, line):
    result = design(SMALL, scene_model=Model(answer), steps=1, **QUICK)
    (step,) = result.steps
    assert step.call.tool == "init_prior" and result.report.valid and result.start is None
    (failed,) = [row["failed"] for row in step.tried if "failed" in row]
    assert line in failed and "\n" not in failed
    assert any(line in note for note in result.notes)


def test_a_library_of_ones_own(tmp_path):
    store().save(tmp_path / "one.json")
    (tmp_path / "two.json").write_text("{")
    result = design(SMALL, scenes=tmp_path, steps=1, **QUICK)
    assert result.steps[0].call.tool == "init_library" and result.start.name == "one" and result.report.valid
    assert any("two.json" in note for note in result.notes)
    other = design("a bathroom with only a toilet", scenes=tmp_path, steps=1, **QUICK)
    assert other.steps[0].call.tool == "init_prior"
    assert any("holds no bathroom" in note for note in other.notes)


def test_the_own_library_can_be_told():
    result = design("a bedroom with a bed", init="library", steps=1, **QUICK)
    assert result.steps[0].call.tool == "init_library"


def test_the_learned_prior_or_a_line(monkeypatch):
    monkeypatch.delattr(sw, "LayoutPrior", raising=False)
    monkeypatch.setattr(sw, "__getattr__", lambda name: (_ for _ in ()).throw(AttributeError(name)))
    result = design(SMALL, init="prior", steps=1, **QUICK)
    assert result.steps[0].call.tool == "init_prior" and NONE in result.notes


def test_poses_of_a_learned_prior_are_where_the_search_begins(monkeypatch):
    asked = []

    class Prior:
        @classmethod
        def load(cls):
            return cls()

        def sample(self, scene, *, candidates, seed):
            asked.append((len(scene.objects), candidates))
            return [[(*o.pose.position, o.pose.yaw) for o in scene.objects]] * candidates

    monkeypatch.setattr(sw, "LayoutPrior", Prior, raising=False)
    result = design(SMALL, init="prior", steps=1, **QUICK)
    assert asked and result.report.valid and NONE not in result.notes


def test_a_language_model_writes_the_room_down():
    script = Script(store_programme())
    result = design(SMALL, init="llm", model=script.client, steps=1, **QUICK)
    assert result.steps[0].call.tool == "init_llm" and script.calls == 1, result.steps[0].tried
    assert result.models is not None and result.models.planned == ("rules",)


@pytest.mark.parametrize(
    ("given", "line"),
    [
        ({"init": "libary"}, "init: 'libary' is unknown"),
        ({"init": "model"}, "init: model needs scene_model"),
        ({"init": "prior", "scenes": "."}, "init: prior does not go with scenes"),
        ({"init": "library", "scene_model": "a:b"}, "init: library does not go with scene_model"),
        ({"start": "nowhere.json"}, "start: 'nowhere.json' is not there"),
        ({"start": 3}, "start: int is no scene"),
        ({"start": "x", "init": "llm"}, "leave out init llm"),
        ({"start": "x", "scenes": "."}, "leave out scenes"),
        ({"scenes": "nowhere"}, "scenes: 'nowhere' is no folder"),
        ({"scene_model": "nowhere"}, 'scene_model: "nowhere" is no folder or file'),
        ({"init": "model", "scene_model": Model(None), "tools": ("init_prior",)}, "needs the tool init_model"),
        ({"source": 3}, "source: 3 is no name"),
    ],
)
def test_what_does_not_go_together_is_one_line(given, line):
    with pytest.raises(InputError) as caught:
        design(SMALL, steps=1, **QUICK, **given)
    assert line in str(caught.value) and "\n" not in str(caught.value)


def test_init_llm_without_a_model(monkeypatch):
    monkeypatch.delenv("SCENEWEAVER_MODEL", raising=False)
    with pytest.raises(MissingDependencyError):
        design(SMALL, init="llm", steps=1, **QUICK)


def test_damaged_scenes_to_go_on_from_are_one_line(tmp_path):
    whole = store().dumps()
    for k, text in enumerate(("", "{", whole[: len(whole) // 2], "[]", whole.replace("3.0", "NaN"))):
        file = tmp_path / f"{k}.json"
        file.write_text(text)
        with pytest.raises(InputError) as caught:
            design(SMALL, start=file, out=tmp_path / "out", steps=1, **QUICK)
        assert "\n" not in str(caught.value) and f"{k}.json" in str(caught.value)
    assert not (tmp_path / "out").exists()


def test_what_was_changed():
    before = store()
    after = (
        before.move("shelf-a", by=(0.3, 0.4), turn=90)
        .remove("shelf-b")
        .add(make("stool", seed=1).object("stool-0", pose=Pose.from_yaw(1.5, 1.5, 0, 0)))
    )
    after = after.model_copy(update={"room": after.room.with_window("north")})
    start = start_of("x", before, after)
    (shift,) = start.moved
    assert (shift.distance, shift.turn) == pytest.approx((0.5, 90.0))
    assert (start.added, start.removed) == (("stool-0",), ("shelf-b",)) and "windows from 0 to 1" in start.room
    assert start.lines[0] == "x: 0 of 2 objects stand where they stood"
    assert start_of("x", before, before).lines == ("x: 2 of 2 objects stand where they stood",)


def test_a_run_that_a_language_model_began_is_made_again_from_its_records(tmp_path):
    script = Script(store_programme())
    more = {"pictures": "none", "export": "none", "steps": 1, **QUICK}
    model = FunctionModel(script._answer)
    first = design(SMALL, init="llm", model=model, out=tmp_path / "first", **more)
    again = design(replay=tmp_path / "first", out=tmp_path / "again", **more)
    assert first.steps[0].call.tool == again.steps[0].call.tool == "init_llm" and again.scene == first.scene
    assert script.calls == 1
