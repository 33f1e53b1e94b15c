"""The scripted server against the clients that talk to it: both protocols, streamed or not."""

from __future__ import annotations

import asyncio
import contextlib
import json
import socket
import time
from typing import Any

import pytest
from pydantic_ai import (
    Agent,
    BinaryContent,
    ModelRetry,
    NativeOutput,
    PromptedOutput,
    ToolOutput,
    UnexpectedModelBehavior,
)
from pydantic_ai.exceptions import ModelHTTPError
from pydantic_ai.models import Model
from pydantic_ai.models.anthropic import AnthropicModel
from pydantic_ai.models.openai import OpenAIChatModel
from pydantic_ai.providers.anthropic import AnthropicProvider
from pydantic_ai.providers.openai import OpenAIProvider

from sceneweaver.llm import Reply
from tests.llm.misbehaviour import Misbehaviour, always, catalogue, misbehaving
from tests.llm.model_server import MODEL, Asked, ModelServer, Said, answering

PNG = b"\x89PNG\r\n\x1a\n not much of a picture"


class Plan(Reply):
    """What to do next."""

    tool: str
    worth: float


class Grades(Reply):
    """How good it is."""

    grades: list[int]


PLAN = {"tool": "add_objects", "worth": 0.5}
BOTH = pytest.mark.parametrize("api", ["chat", "messages"])
STREAMED = pytest.mark.parametrize("streamed", [False, True], ids=["whole", "streamed"])


def model(server: ModelServer, api: str) -> Model:
    if api == "chat":
        return OpenAIChatModel(MODEL, provider=OpenAIProvider(base_url=server.url, api_key="key-of-chat"))
    return AnthropicModel(MODEL, provider=AnthropicProvider(base_url=server.root, api_key="key-of-messages"))


def ran(agent: Agent[None, Any], prompt: list[Any], streamed: bool) -> Any:
    async def one() -> Any:
        async with agent.run_stream(prompt) as result:
            return await result.get_output(), result.usage

    if streamed:
        return asyncio.run(one())
    result = agent.run_sync(prompt)
    return result.output, result.usage


@BOTH
@STREAMED
def test_a_structured_answer(api: str, streamed: bool) -> None:
    with ModelServer(answering({Grades: {"grades": [1]}, Plan: PLAN})) as server:
        agent = Agent(model(server, api), output_type=ToolOutput(Plan, name="answer"), instructions="Be brief.")
        output, usage = ran(agent, ["look", BinaryContent(PNG, media_type="image/png"), "and plan"], streamed)
    assert output == Plan(**PLAN)
    assert (usage.input_tokens, usage.output_tokens) == (100, 20)
    (asked,) = server.requests
    assert (asked.api, asked.stream, asked.instructions, asked.text) == (api, streamed, "Be brief.", "look\nand plan")
    assert asked.pictures == [PNG] and list(asked.tools) == ["answer"] and asked.model == MODEL
    assert server.keys_seen == {f"key-of-{api}"} and not server.strays


@pytest.mark.parametrize(
    ("api", "form"), [("chat", NativeOutput(Plan)), ("chat", PromptedOutput(Plan)), ("messages", PromptedOutput(Plan))]
)
def test_an_answer_as_text(api: str, form: Any) -> None:
    with ModelServer(answering({Grades: {"grades": [1]}, Plan: Plan(**PLAN)})) as server:
        output, _ = ran(Agent(model(server, api), output_type=form), ["plan"], streamed=False)
    assert output == Plan(**PLAN) and server.requests[0].as_text


@BOTH
@STREAMED
def test_words(api: str, streamed: bool) -> None:
    words = "a table, vier Stühle, 椅子 " * 40
    with ModelServer(answering({"furniture": words})) as server:
        output, _ = ran(Agent(model(server, api), instructions="You know furniture."), ["name some"], streamed)
    assert output == words


@BOTH
def test_what_it_is_told_about_a_refused_answer(api: str) -> None:
    with ModelServer(answering({Plan: [PLAN | {"worth": "much"}, PLAN | {"tool": "none"}, PLAN]})) as server:
        agent = Agent(model(server, api), output_type=ToolOutput(Plan, name="answer"), retries=2)

        @agent.output_validator
        def known(plan: Plan) -> Plan:
            if plan.tool == "none":
                raise ModelRetry("no tool none")
            return plan

        output, _ = ran(agent, ["plan"], streamed=False)
    assert output == Plan(**PLAN)
    told = [asked.told for asked in server.requests]
    assert told[0] == [] and "worth" in told[1][0] and "no tool none" in told[2][-1]
    assert {asked.text for asked in server.requests} == {"plan"}


@BOTH
@STREAMED
def test_a_refusal(api: str, streamed: bool) -> None:
    with ModelServer(answering(lambda asked: Said(refusal="I would rather not."))) as server:
        agent = Agent(model(server, api), output_type=ToolOutput(Plan, name="answer"), retries=0)
        with pytest.raises(UnexpectedModelBehavior):
            ran(agent, ["plan"], streamed)


def test_a_script_that_fails_is_raised_when_the_server_is_left() -> None:
    def script(asked: Asked) -> Said:
        raise AssertionError("not what was to be asked")

    with (
        pytest.raises(AssertionError, match="not what was to be asked"),
        ModelServer(script) as server,
        pytest.raises(ModelHTTPError, match="400"),
    ):
        ran(Agent(model(server, "chat")), ["anything"], streamed=False)


@pytest.mark.parametrize(
    ("misbehaviour", "path", "streamed"),
    [
        pytest.param(one, ["chat/completions", "messages"][k % 2], k % 4 > 1, id=one.name)
        for k, one in enumerate(catalogue())
    ],
)
def test_misbehaves_as_it_is_told(misbehaviour: Misbehaviour, path: str, streamed: bool) -> None:
    """Each writes something, or waits, for whoever asks; none fails on its own."""
    tool = {"name": "answer", "parameters": Grades.model_json_schema(), "input_schema": Grades.model_json_schema()}
    body = {"model": MODEL, "max_tokens": 9, "messages": [{"role": "user", "content": "hi"}], "stream": streamed}
    data = json.dumps(body | {"tools": [tool | {"function": tool}]}).encode()
    with ModelServer(misbehaving(answering({Grades: {"grades": [1, 2]}}), always(misbehaviour.name))) as server:
        with socket.create_connection(("127.0.0.1", int(server.root.rpartition(":")[2])), timeout=0.2) as connection:
            head = f"POST /v1/{path} HTTP/1.1\r\nHost: x\r\nx-api-key: k\r\nContent-Length: {len(data)}\r\n\r\n"
            connection.sendall(head.encode() + data)
            patience = time.monotonic() + 60
            while not server.requests and time.monotonic() < patience:
                time.sleep(0.005)
            with contextlib.suppress(OSError):
                connection.recv(1000)
        assert len(server.requests) == 1
