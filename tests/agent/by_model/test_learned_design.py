"""A room of a kind that nobody knew, from the first question to its replay: learned, written down, dressed."""

from __future__ import annotations

import base64
from typing import Any

import pytest
from pydantic_ai.messages import ModelMessage, ModelResponse, ToolCallPart
from pydantic_ai.models.function import AgentInfo, FunctionModel

from sceneweaver.agent import design
from sceneweaver.agent.by_model import planner
from sceneweaver.knowledge.learned import forget_room, learned_rooms
from sceneweaver.llm import Picture
from tests.agent.by_model.test_rooms import SHED
from tests.tools.programmes import item

PIXEL = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)
REQUEST = "a clipping shed with a workbench"
ON_BENCH = [
    {"category": "potted plant", "on": "workbench-0", "at": "back left"},
    {"category": "mug", "by": "potted plant", "side": "right", "count": 2},
]


@pytest.mark.slow
def test_learned_written_down_dressed_and_replayed(tmp_path, monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_ROOMS", str(tmp_path / "rooms"))
    monkeypatch.setattr(planner, "top_picture", lambda *_, **__: Picture(PIXEL, "top view"))
    plans: list[dict[str, Any]] = [
        {"problem": "no room", "calls": [{"tool": "init_llm", "confidence": 0.9, "instruction": "Begin."}]},
        {"problem": "bare", "calls": [{"tool": "add_tabletop", "confidence": 0.8, "instruction": "Dress the bench."}]},
        {"stop": True, "stop_reason": "done"},
    ]
    by_field: dict[str, Any] = {
        "inputs": {"inputs": {"objects": ON_BENCH, "only": True}},
        "doors": SHED,
        "kind": {"kind": "clipping shed", "area": 10, "items": [*SHED["items"], item("stool", "stool")]},
        "language": {"room": "clipping shed", "things": []},
    }

    def say(messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        tool = info.output_tools[0]
        fields = tool.parameters_json_schema["properties"]
        answer = plans.pop(0) if "calls" in fields else next(by_field[name] for name in by_field if name in fields)
        return ModelResponse(parts=[ToolCallPart(tool.name, answer)])

    quick: dict[str, Any] = {"candidates": 8, "device": "cpu", "side_by_side": 1, "critic": "symbolic", "seed": 1}
    unseen: dict[str, Any] = {"pictures": False, "export": "none"}
    model = FunctionModel(say, model_name="scripted")
    result = design(REQUEST, planner="llm", model=model, out=tmp_path / "run", steps=3, **quick, **unseen)
    scene = result.scene
    assert result.report.valid and not result.unmet
    assert not any("no kind of room" in note for note in result.notes)
    assert scene.room.type == "clipping_shed" and set(learned_rooms()) == {"clipping_shed"}
    assert [step.call.tool for step in result.steps if step.call] == ["init_llm", "add_tabletop"]
    plant, mug = scene.object("potted_plant-0"), scene.object("mug-0")
    assert plant.support == mug.support and mug.support is not None and mug.support.object == "workbench-0"
    assert (tmp_path / "run/llm/room.yaml").is_file()
    forget_room("clipping shed")
    again = design(REQUEST, replay=tmp_path / "run", out=tmp_path / "again", **unseen)
    assert again.scene == scene and not learned_rooms()
