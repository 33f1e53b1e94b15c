"""From a request to a room with a model at work: ablations, fall-backs, what is kept, what the folder tells."""

from __future__ import annotations

import base64
import json
import time
from typing import Any

import pytest
from pydantic_ai.messages import ModelMessage, ModelResponse, ToolCallPart
from pydantic_ai.models.function import AgentInfo, FunctionModel
from pydantic_ai.models.test import TestModel

from sceneweaver.agent import Result, Settings, design
from sceneweaver.agent.by_model import critic, planner
from sceneweaver.agent.folder import State
from sceneweaver.agent.memory import Memory
from sceneweaver.agent.roles import Roles
from sceneweaver.llm import BudgetSpent, Limits, ModelClient, ModelUnreachable, Picture
from sceneweaver.runtime.deadline import Stop
from sceneweaver.scene import InputError, MissingDependencyError

PIXEL = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)
SHELF = "a store room with one shelf"
QUICK = {"candidates": 8, "finalists": 2, "generations": 0, "side_by_side": 1}
QUICK |= {"device": "cpu", "pictures": False, "export": "none"}
BEGIN = {"problem": "no room", "calls": [{"tool": "init_prior", "confidence": 0.9, "instruction": "Begin."}]}
STOP = {"stop": True, "stop_reason": "all is there"}
FILL = {
    "problem": "the shelf is bare",
    "calls": [{"tool": "add_crowd", "confidence": 0.8, "instruction": "Fill it.", "inputs": {"supports": []}}],
}


KINDS = {"calls": "plan", "inputs": "inputs", "realism": "look", "things": "read"}
"""What an answer is for, by a field of it that no other has."""


def says(*plans: dict[str, Any], **others: list[dict[str, Any]]) -> tuple[FunctionModel, list[str]]:
    """A model that gives some plans in turn, the last for ever, and so the answers to what else it is asked; and the
    text that it was told each time."""
    left, told = {"plan": list(plans), **others}, list[str]()

    def say(messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        tool = info.output_tools[0]
        kind = next(kind for field, kind in KINDS.items() if field in tool.parameters_json_schema["properties"])
        told.append(f"{kind}: {[part.content for part in messages[-1].parts if hasattr(part, 'content')]}")
        rows = left[kind]
        return ModelResponse(parts=[ToolCallPart(tool.name, rows.pop(0) if len(rows) > 1 else rows[0])])

    return FunctionModel(say, model_name="scripted"), told


@pytest.fixture(autouse=True)
def undrawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures of one pixel: no test here draws."""
    picture = Picture(PIXEL, "top view")
    monkeypatch.setattr(planner, "top_picture", lambda *_, **__: picture)
    monkeypatch.setattr(critic, "room_pictures", lambda *_, **__: (picture, picture))


def run(model: Any, prompt: str = SHELF, **more: Any) -> Result:
    given = {"seed": 1, "steps": 4, "reader": "rules", "critic": "symbolic", **QUICK, **more}
    return design(prompt, planner="llm", model=model, **given)


def tools_of(result: Result) -> list[str]:
    return [step.call.tool for step in result.steps if step.call]


def test_the_model_plans_and_says_when_it_is_done(tmp_path):
    client, told = says(BEGIN, FILL, STOP)
    result = run(client, out=tmp_path)
    assert result.report.valid and tools_of(result) == ["init_prior", "add_crowd"]
    assert result.finished == "the planner stopped: all is there" and len(told) == 3
    plan = json.loads((tmp_path / "steps/02/plan.json").read_text())
    assert plan["problem"] == "the shelf is bare" and plan["ranked"][0]["tool"] == "add_crowd"
    assert "the shelf is bare" in told[2] and "plan" not in json.loads((tmp_path / "steps/02/step.json").read_text())


def test_any_answers_end_in_a_valid_scene_and_an_honest_report():
    result = run(TestModel(), steps=2)
    assert result.report.valid and len([n for n in result.notes if "the rules planned, not the model" in n]) == 2


@pytest.mark.parametrize(
    ("switches", "plans", "expected"),
    [
        ({"reflect": False}, [{"calls": [*BEGIN["calls"], *FILL["calls"]]}], ["init_prior", "add_crowd"]),
        ({"one_shot": True}, [BEGIN, FILL], ["init_prior", "add_crowd"]),
        ({"physics": False}, [BEGIN, FILL, STOP], ["init_prior", "add_crowd"]),
    ],
)
def test_ablations(switches, plans, expected):
    client, told = says(*plans)
    result = run(client, **switches)
    assert tools_of(result)[: len(expected)] == expected
    assert len(told) == len(plans) + (not result.report.valid)  # a stop is not heard while the scene is not valid


@pytest.mark.parametrize("switches", [{}, {"reflect": False}, {"one_shot": True}])
@pytest.mark.parametrize("steps", [1, 3])
def test_a_beginning_of_the_model_that_fails_is_not_the_end(switches, steps):
    nowhere = {"tool": "init_library", "confidence": 1, "instruction": "Begin.", "inputs": {"name": "nowhere"}}
    plan = {"problem": "no room", "calls": [nowhere, *([FILL["calls"][0]] if switches == {"reflect": False} else [])]}
    result = run(says(plan)[0], steps=steps, **switches)
    assert result.report.valid and result.scene.objects and "init_prior" in tools_of(result)
    assert any("the rules began the room" in note or "the rules planned" in note for note in result.notes)


def test_without_reflection_the_rules_have_their_fixed_plan():
    result = run(TestModel(), steps=2, reflect=False)
    assert tools_of(result) == ["init_prior", "add_tabletop"]


def test_only_the_tools_that_are_named():
    client, told = says(BEGIN, FILL, STOP)
    result = run(client, tools=("init_prior", "update_layout"), steps=2)
    assert set(tools_of(result)) <= {"init_prior", "update_layout"}
    assert "'add_crowd' is unknown" in told[2]


def test_a_step_in_vain_lowers_the_trust_is_told_and_counts():
    vain = [
        {"calls": [{**FILL["calls"][0], "tool": "remove_objects", "inputs": {"ids": [f"nothing-{k}"]}}]}
        for k in range(9)
    ]
    model, told = says(BEGIN, *vain, inputs=[{"inputs": {"ids": ["nothing"]}}])
    result = run(model, steps=10, replans=2)
    assert [s.accepted for s in result.steps] == [True, False, False, False]
    plans = [text for text in told if text.startswith("plan")]
    assert result.finished == "3 steps brought nothing" and len(plans) == 4
    assert "nothing-0" in plans[2] and "failed_calls" in plans[2] and '"kept":false' in plans[2]
    asked = next(text for text in told if text.startswith("inputs"))
    assert "these inputs were refused" in asked and "nothing-0" in asked


def test_a_strict_run_that_is_stopped_ends_as_any_other(tmp_path):
    stop = Stop()

    def say(messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        stop.request("SIGTERM")
        time.sleep(0.5)
        return ModelResponse(parts=[ToolCallPart(info.output_tools[0].name, BEGIN)])

    result = run(FunctionModel(say), strict=True, stop=stop, out=tmp_path)
    assert result.report.cut_off == "SIGTERM" and (tmp_path / "metrics.json").exists()


class Leaves(ModelClient):
    """Answers some times; then an error comes for ever."""

    def __init__(self, model: FunctionModel, times: int, error: Exception) -> None:
        super().__init__(model)
        self.times, self.error = times, error

    def ask_many(self, *given: Any, **more: Any) -> Any:
        self.times -= 1
        return [self.error] if self.times < 0 else super().ask_many(*given, **more)


@pytest.mark.parametrize("times", [0, 1])
def test_without_the_model_the_rules_go_on_or_a_strict_run_ends(tmp_path, times):
    def leaves(error: Exception) -> ModelClient:
        return Leaves(says(BEGIN, FILL)[0], times, error)

    result = run(leaves(ModelUnreachable("no connection")), steps=2)
    note = f"planned by rules from step {times + 1}, without the model (no connection)"
    assert result.report.valid and note in result.notes
    with pytest.raises(MissingDependencyError, match="spent"):
        run(leaves(BudgetSpent("10 calls are spent")), strict=True, out=tmp_path, steps=2)
    kept = json.loads((tmp_path / "state.json").read_text())["memory"]["steps"] if times else []
    assert len(kept) == times
    assert (tmp_path / "scene.json").exists()


def test_a_killed_run_goes_on_and_ends_with_the_same_scene(tmp_path):
    def stopping(step: Any) -> None:
        raise KeyboardInterrupt

    answers = (BEGIN, FILL, STOP)
    whole = run(says(*answers)[0], out=tmp_path / "whole")
    with pytest.raises(KeyboardInterrupt):
        run(says(*answers)[0], out=tmp_path / "cut", said=stopping)
    client, told = says(*answers[1:])
    again = run(client, out=tmp_path / "cut")
    assert len(told) == 2
    assert (tmp_path / "cut/scene.json").read_bytes() == (tmp_path / "whole/scene.json").read_bytes()
    assert tools_of(again) == tools_of(whole)


def looks(grade: float, comment: str = "fine") -> dict[str, Any]:
    graded = {"comment": comment, "grade": grade}
    return {name: graded for name in ("realism", "functionality", "layout", "completion")}


def test_what_looks_worse_is_taken_back_and_told(tmp_path):
    look = [looks(8), looks(4, "crammed"), looks(8), looks(8)]
    model, told = says(BEGIN, FILL, STOP, look=look)
    result = run(model, out=tmp_path, critic="vlm")
    assert [s.accepted for s in result.steps] == [True, False]
    assert result.steps[1].note == "the critic by vision gave 4.0 after 8.0"
    plans = [text for text in told if text.startswith("plan")]
    assert "Critic by vision" in plans[1] and "the critic by vision gave 4.0" in plans[2]
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["scores"]["critic"] == "symbolic" and metrics["scores"]["seen"]["mean"] == 8.0
    assert metrics["models"]["planned"] == ["scripted", "scripted"] and metrics["models"]["usage"]["calls"] == len(told)


def test_what_looks_a_little_worse_stays():
    look = [looks(8), looks(7.5), looks(7.5)]
    result = run(says(BEGIN, FILL, STOP, look=look)[0], critic="vlm")
    assert [s.accepted for s in result.steps] == [True, True] and result.review.seen.mean == 7.5


READ = {
    "room": {"kind": "storage room", "quote": "store room"},
    "things": [{"id": "shelf", "name": "shelf", "quote": "one shelf", "count": [1, 1]}],
}


def test_the_model_reads_the_request_and_a_reader_that_fails_is_replaced(tmp_path):
    model, told = says(BEGIN, STOP, read=[READ])
    result = run(model, reader="llm", out=tmp_path, steps=2)
    assert result.models.read == "scripted" and result.report.valid and told[0].startswith("read")
    again = run(says(STOP)[0], reader="llm", out=tmp_path, steps=3)  # the reading is that of the run
    assert again.models.read == "scripted" and again.brief == result.brief
    result = design(SHELF, reader="llm", model=TestModel(), seed=1, steps=1, **QUICK)
    assert result.report.valid and result.models.planned == ("rules",)


def test_inputs_that_are_left_out_are_asked_for(tmp_path):
    plan = {"problem": "bare", "calls": [{**FILL["calls"][0], "inputs": None}]}
    model, told = says(BEGIN, plan, STOP, inputs=[{"inputs": {"supports": ["nothing"]}}, {"inputs": {"supports": []}}])
    result = run(model)
    assert [text.partition(":")[0] for text in told] == ["plan", "plan", "inputs", "inputs", "plan"]
    assert result.steps[1].call.inputs == {"supports": []} and not result.steps[1].call.fill


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"planner": "oracle"}, "planner: 'oracle'"),
        ({"reader": "oracle"}, "reader: 'oracle'"),
        ({"critic": "oracle"}, "critic: 'oracle'"),
        ({"samples": 0}, "samples: 0"),
    ],
)
def test_words_that_are_no_roles(given, words):
    with pytest.raises(InputError, match=words):
        design(SHELF, **given)


def test_a_recorded_run_is_made_again_to_the_bit(tmp_path):
    record, again = tmp_path / "record", tmp_path / "again"
    wrong = {**FILL, "calls": [{**FILL["calls"][0], "tool": "teleport"}]}
    model, told = says(BEGIN, wrong, FILL, STOP, look=[looks(7)], read=[READ])
    first = run(model, out=record, reader="llm", critic="vlm", samples=2)
    result = design(out=again, replay=record, pictures=False, export="none")
    assert (again / "scene.json").read_bytes() == (record / "scene.json").read_bytes()
    assert tools_of(first) == tools_of(result) and result.notes == first.notes
    assert result.models.usage["calls"] == first.models.usage["calls"] == len(told)
    assert result.models.name == first.models.name and result.review.seen == first.review.seen


def test_a_run_that_fell_back_is_made_again_as_well(tmp_path):
    record, again = tmp_path / "record", tmp_path / "again"
    first = run(says(BEGIN, FILL, STOP)[0], out=record, limits=Limits(calls=1), steps=3)
    assert first.models.lost and first.models.planned[:2] == ("scripted", "rules")
    result = design(out=again, replay=record, pictures=False, export="none")
    assert (again / "scene.json").read_bytes() == (record / "scene.json").read_bytes()
    assert result.notes == first.notes and result.models.lost == first.models.lost


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"prompt": "a kitchen"}, "another request"),
        ({"seed": 9}, "seed 1, not 9"),
        ({"steps": 9}, "steps 4, not 9"),
        ({"reader": "llm"}, "reader rules, not llm"),
        ({"reflect": False}, "reflect True, not False"),
        ({"replay": "nowhere"}, "holds no run"),
    ],
)
def test_what_differs_from_a_recorded_run_is_said(tmp_path, given, words):
    record = tmp_path / "record"
    state = State(
        schema="sceneweaver.run/1",
        prompt=SHELF,
        settings=Settings(seed=1, steps=4),
        scene="scene.json",
        memory=Memory(),
        roles=Roles(planner="llm"),
    )
    record.mkdir()
    (record / "state.json").write_text(state.model_dump_json(by_alias=True))
    with pytest.raises(InputError, match=words):
        design(**{"replay": record, **given})


def test_a_planner_without_a_model_says_so(monkeypatch):
    monkeypatch.delenv("SCENEWEAVER_MODEL", raising=False)
    with pytest.raises(MissingDependencyError, match="model"):
        design(SHELF, planner="llm")
