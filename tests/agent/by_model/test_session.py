"""What a run that is broken off early, a client of one's own, and a run that was cut off come to."""

from __future__ import annotations

import asyncio
import json
import math
import time
from types import SimpleNamespace
from typing import Any

import pytest
from pydantic_ai.messages import ModelResponse, ToolCallPart
from pydantic_ai.models.function import FunctionModel

from sceneweaver.agent import design
from sceneweaver.agent.by_model.asking import Asking
from sceneweaver.agent.by_model.session import Session
from sceneweaver.agent.folder import State
from sceneweaver.agent.memory import Memory
from sceneweaver.agent.roles import Roles
from sceneweaver.agent.settings import Settings
from sceneweaver.llm import Limits, ModelClient, Reply, open_client
from sceneweaver.runtime.deadline import NEVER, Deadline
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


@pytest.mark.parametrize(
    ("seconds", "started", "reserve"),
    [(90.0, 3.5, 21.0), (90.0, 0.1, 10.0), (12.0, 0.1, 6.0), (90.0, 30.0, 45.0), (math.inf, 3.5, 0.0)],
)
def test_as_long_as_there_is_no_room_the_rules_keep_time_to_make_one(tmp_path, seconds, started, reserve):
    limit = Deadline(time.monotonic() + seconds)
    session = Session.opened(Roles.of("llm"), Asking(saying("")), limit, tmp_path, started)
    assert session.reserve == pytest.approx(reserve, rel=0.1) and session.left <= seconds - session.reserve
    session.run = SimpleNamespace(best=object(), deadline=limit)  # type: ignore[assignment]
    assert session.left > session.deadline.left - 1 or math.isinf(seconds)


@pytest.mark.slow
def test_a_model_that_never_answers_leaves_the_rules_time_for_a_room():
    async def never(_: Any, __: Any) -> ModelResponse:
        await asyncio.sleep(1000)
        raise AssertionError

    given = {"steps": 1, "candidates": 8, "device": "cpu", "critic": "symbolic"}
    result = design("a store room with one shelf", planner="llm", model=FunctionModel(never), time_limit=40, **given)
    assert result.report.valid and result.scene.objects and "the request was read by rules" in " ".join(result.notes)


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
