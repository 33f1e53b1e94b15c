"""Calls, tokens, cost and seconds end; prices are the user's."""

import asyncio
import time

import pytest
from pydantic_ai.messages import ModelResponse, ToolCallPart
from pydantic_ai.models.function import FunctionModel

from sceneweaver.llm import (
    BudgetSpent,
    Endpoint,
    Limits,
    ModelClient,
    ModelFailed,
    ModelUnreachable,
    Prices,
    Reply,
    open_client,
)
from sceneweaver.scene import InputError
from tests.llm.misbehaviour import always, first, misbehaving
from tests.llm.model_server import ModelServer, Said, answering

TABLE = """
currency: EUR
models:
  openai:small: {input: 2.0, cached_input: 0.5, output: 8}
  large: {input: 20, output: 80}
"""


class Plan(Reply):
    """What to do."""

    steps: int


def ask(client):
    return client.ask("plan", Plan, "Plan.", ["a room"])


def prices(tmp_path, text=TABLE):
    (tmp_path / "prices.yaml").write_text(text)
    return Prices.load(tmp_path / "prices.yaml")


def serving(tokens=(1000, 100)):
    return ModelServer(lambda asked: Said(calls=(("answer", {"steps": 1}),), tokens=tokens))


def test_prices(tmp_path):
    table = prices(tmp_path)
    assert table.of("openai:small").cost(1_000_000, 100_000, 400_000) == pytest.approx(1.2 + 0.2 + 0.8)
    assert table.of("anthropic:large").cost(1_000_000, 0, 500_000) == 20
    assert table.of("openai:other") is None


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[1]", "has no table 'models'"),
        ("models: {a: 1}", "models.a: needs input and output"),
        ("models: {a: {input: 1, output: -1}}", "models.a.output: -1 is no price"),
        ("models: {a: {input: .nan, output: 1}}", "models.a.input: nan is no price"),
        ("models: {a: {input: 1, output: 1, image: 2}}", "models.a.image: is unknown"),
        ("currencies: EUR\nmodels: {}", "'currencies' is unknown"),
        ("currency: [EUR]\nmodels: {}", "currency is no word"),
        ("models: {a: [", "cannot be read as YAML"),
    ],
)
def test_wrong_prices(tmp_path, text, says):
    with pytest.raises(InputError, match=says):
        prices(tmp_path, text)


def test_no_prices(tmp_path):
    with pytest.raises(InputError, match="no such file|cannot be read"):
        Prices.load(tmp_path / "none.yaml")


def test_cost(tmp_path):
    with serving() as server:
        client = open_client(Endpoint.of("small", server.url), prices=prices(tmp_path), limits=Limits(cost=0.005))
        ask(client), ask(client)
        with pytest.raises(BudgetSpent, match=r"plan: the limit of 0.005 EUR is reached"):
            ask(client)
    assert len(server.requests) == 2
    told = client.usage.to_dict()
    assert (told["cost"], told["currency"], told["calls"]) == (pytest.approx(0.0056), "EUR", 2)
    assert told["by_purpose"]["plan"]["tokens_in"] == 2000


def test_cost_without_a_price(tmp_path):
    with pytest.raises(InputError, match="limits.cost: no price of openai:other is known"):
        open_client(Endpoint.of("other", "http://127.0.0.1:9"), prices=prices(tmp_path), limits=Limits(cost=1))
    with serving() as server:
        client = open_client(Endpoint.of("other", server.url), prices=prices(tmp_path))
        ask(client)
    assert client.usage.to_dict()["cost"] is None


def test_tokens():
    with serving() as server:
        client = open_client(Endpoint.of("small", server.url), limits=Limits(tokens=2000))
        ask(client), ask(client)
        with pytest.raises(BudgetSpent, match="limit of 2000 tokens"):
            ask(client)


@pytest.mark.parametrize("tokens", [(-1_000_000, -1_000_000), (0, 0)])
def test_tokens_that_are_not_told_are_estimated(tokens):
    with serving(tokens) as server:
        client = open_client(Endpoint.of("small", server.url))
        ask(client)
    told = client.usage.total
    assert told.estimated == 1 and told.tokens_in > 0 and told.tokens_out > 0


def test_seconds():
    async def said(messages, info):
        await asyncio.sleep(20)

    client = ModelClient(FunctionModel(said), limits=Limits(seconds=0.3))
    began = time.monotonic()
    with pytest.raises(BudgetSpent, match="the time for the model was over"):
        ask(client)
    assert time.monotonic() - began < 10


def test_samples_side_by_side_keep_the_limit_of_calls():
    calls = []

    def said(messages, info):
        calls.append(1)
        return ModelResponse(parts=[ToolCallPart("answer", {"steps": 1})])

    client = ModelClient(FunctionModel(said), limits=Limits(calls=2))
    found = client.ask_many("plan", Plan, "Plan.", ["a room"], samples=5)
    assert len(calls) == 2 and sum(isinstance(answer, BudgetSpent) for answer in found) == 3


def test_nothing_may_be_spent():
    with serving() as server, pytest.raises(BudgetSpent):
        ask(open_client(Endpoint.of("small", server.url), limits=Limits(calls=0)))
    assert server.requests == []


@pytest.mark.parametrize("fields", [{"calls": -1}, {"cost": float("nan")}, {"seconds": True}, {"tokens": "many"}])
def test_wrong_limits(fields):
    with pytest.raises(InputError, match=f"limits.{next(iter(fields))}"):
        Limits(**fields)


def test_rate():
    with serving() as server:
        client = open_client(Endpoint.of("small", server.url, per_minute=300))
        began = time.monotonic()
        client.ask_many("plan", Plan, "Plan.", ["a room"], samples=4)
    assert time.monotonic() - began >= 0.6  # three waits of a fifth of a second


def test_rate_does_not_outlive_the_run():
    with serving() as server:
        end = time.monotonic() + 5
        client = open_client(Endpoint.of("small", server.url, per_minute=1), left=lambda: end - time.monotonic())
        ask(client)
        with pytest.raises(BudgetSpent, match="would be over before the next request"):
            ask(client)
    assert time.monotonic() < end


@pytest.mark.parametrize("name", ["too_many_wait_a_moment", "server_error", "overloaded", "reset_in_body", "html"])
def test_errors_that_pass(name):
    with ModelServer(misbehaving(answering({Plan: {"steps": 1}}), first(name, 1))) as server:
        client = open_client(Endpoint.of("small", server.url))
        assert ask(client).steps == 1
    assert (client.usage.total.calls, client.usage.total.failed, client.lost) == (2, 1, "")


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("unauthorized", "set SCENEWEAVER_API_KEY"),
        ("not_found", "set SCENEWEAVER_MODEL"),
        ("redirect", "set SCENEWEAVER_BASE_URL"),
        ("too_many_wait_a_day", "asks to wait for 86400 s"),
    ],
)
def test_errors_that_stay_are_not_tried_again(name, says):
    with ModelServer(misbehaving(answering({Plan: {"steps": 1}}), first(name, 9))) as server:
        client = open_client(Endpoint.of("small", server.url))
        for words in (says, "not asked"):
            with pytest.raises(ModelUnreachable, match=words):
                ask(client)
    assert len(server.requests) == 1 and client.lost


def test_questions_in_a_row_without_a_reply_lose_the_model():
    with ModelServer(misbehaving(answering({Plan: {"steps": 1}}), always("html"))) as server:
        client = open_client(Endpoint.of("small", server.url, tries=1))
        for _ in range(3):
            with pytest.raises(ModelFailed):
                ask(client)
        with pytest.raises(ModelUnreachable, match="not asked"):
            ask(client)
    assert len(server.requests) == 3 and "in a row" in client.lost


def test_prompts_of_requests_that_were_cut_off_count(tmp_path):
    with ModelServer(misbehaving(answering({Plan: {"steps": 1}}), always("silence"))) as server:
        client = open_client(Endpoint.of("small", server.url, timeout=0.2, tries=1), prices=prices(tmp_path))
        with pytest.raises(ModelUnreachable, match="no whole reply in time"):
            ask(client)
    told = client.usage.total
    assert told.tokens_in > 0 and told.cost > 0 and told.failed == 1
