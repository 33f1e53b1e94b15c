"""What a run that is broken off early, a client of one's own, and a run that was cut off come to."""

from __future__ import annotations

import json

import pytest
from pydantic_ai.messages import ModelResponse, ToolCallPart
from pydantic_ai.models.function import FunctionModel

from sceneweaver.agent import design
from sceneweaver.agent.by_model.asking import Asking
from sceneweaver.agent.by_model.session import Session
from sceneweaver.agent.deadline import NEVER
from sceneweaver.agent.folder import State
from sceneweaver.agent.memory import Memory
from sceneweaver.agent.roles import Roles
from sceneweaver.agent.settings import Settings
from sceneweaver.llm import Limits, ModelClient, Reply, open_client
from sceneweaver.scene import InputError


class Word(Reply):
    """An answer."""

    text: str


def saying(text: str) -> FunctionModel:
    return FunctionModel(lambda _, info: ModelResponse(parts=[ToolCallPart(info.output_tools[0].name, {"text": text})]))


def test_what_a_run_asked_that_was_killed_in_its_first_step_is_not_replayed(tmp_path):
    for text in ("killed", "killed as well", "whole"):
        session = Session.opened(Roles.of("llm"), Asking(saying(text)), NEVER, tmp_path)
        assert session.client is not None and session.client.ask("read", Word, "Say a word.", ["now"]).text == text
    session.client.keep()
    assert open_client(replay=tmp_path).ask("read", Word, "Say a word.", ["now"]).text == "whole"


def test_a_client_of_ones_own_has_limits_of_its_own():
    with pytest.raises(InputError, match="limits: a client has its own"):
        design("a store room", planner="llm", model=ModelClient(saying("")), limits=Limits(calls=1))


def test_a_limited_cost_needs_a_price_of_any_model():
    with pytest.raises(InputError, match="limits.cost: no price of"):
        design("a store room", planner="llm", model=saying(""), limits=Limits(cost=1.0))


def test_a_run_that_was_cut_off_is_not_replayed(tmp_path):
    state = State(
        schema="sceneweaver.run/1",
        prompt="a store room",
        settings=Settings(),
        scene="scene.json",
        memory=Memory(),
        roles=Roles.of("llm"),
    )
    (tmp_path / "state.json").write_text(json.dumps(state.model_dump(mode="json")))
    (tmp_path / "metrics.json").write_text(json.dumps({"cut_off": "600 seconds"}))
    with pytest.raises(InputError, match="was cut off .600 seconds.*go on there"):
        design(replay=tmp_path)
