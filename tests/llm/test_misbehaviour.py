"""A client and a server that misbehaves in every way we know: an answer or one clear line, and nothing else."""

from __future__ import annotations

import gc
import json
import ssl
from pathlib import Path

import pytest

from sceneweaver.llm import BudgetSpent, Limits, ModelError, ModelFailed, ModelUnreachable, attempts
from tests.llm.asking import (
    PLAN,
    RETRIES,
    TRIES,
    Plan,
    asked,
    assert_one_clear_line,
    assert_readable,
    client_of,
    in_time,
    peak_memory,
    strict_json,
)
from tests.llm.bad_statuses import redirect_to
from tests.llm.misbehaviour import Misbehaviour, always, catalogue, first, misbehaving
from tests.llm.model_server import ModelServer, answering
from tests.llm.planted_key import KEY, planted

GOOD = answering({Plan: PLAN})
CASES = [("chat", False), ("chat", True), ("messages", False), ("messages", True)]
IDS = ["chat", "chat streamed", "messages", "messages streamed"]
ALL = [
    pytest.param(one, *case, id=f"{name}-{one.name}", marks=[] if (k + i) % 4 == 0 else pytest.mark.slow)
    for k, one in enumerate(catalogue())
    for i, (case, name) in enumerate(zip(CASES, IDS, strict=True))
]
"""Every misbehaviour in every case; one of each is quick."""


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """No long waits, and no certificates, which take longer to read than the rest takes."""
    monkeypatch.setattr(attempts, "FIRST_WAIT", 0.01)
    monkeypatch.setattr(attempts, "LONGEST_WAIT", 0.1)
    monkeypatch.setattr(ssl.SSLContext, "load_verify_locations", lambda *_, **__: None)


@pytest.mark.parametrize(("misbehaviour", "api", "streamed"), ALL)
def test_an_answer_or_one_clear_line(
    misbehaviour: Misbehaviour, api: str, streamed: bool, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    with planted() as key, ModelServer(misbehaving(GOOD, always(misbehaviour.name))) as server:
        timeout = 0.3 if misbehaviour.family == "slow" else 60.0
        client = client_of(server, api, streamed, timeout, records=tmp_path / "llm")
        found = in_time(lambda: asked(client))
        if isinstance(found, ModelError):
            assert_one_clear_line(found)
            key.raised(found)
        else:
            assert isinstance(found, Plan) and strict_json(found.model_dump_json())
            assert KEY not in found.model_dump_json()
        slow = misbehaviour.family == "slow"  # then a request may end before the server has read it
        assert (not slow) <= len(server.requests) <= (RETRIES + 1) * TRIES
        assert misbehaviour.family not in ("statuses", "slow") or len(server.requests) <= TRIES
        assert server.keys_seen <= {KEY} and (slow or server.keys_seen) and not server.strays
        usage = strict_json(json.dumps(client.usage.to_dict()))
        assert usage["calls"] == len(server.requests) or (slow and usage["calls"] <= TRIES)
        assert usage["tokens_in"] >= 0 and usage["tokens_out"] >= 0
        assert_readable(tmp_path / "llm")
        key.said.append(repr(vars(client)) + json.dumps(usage))
        key.assert_nowhere(tmp_path, capfd.readouterr())


OUTCOMES: dict[type, str] = {
    Plan: "unknown_ids fenced_json huge_numbers hidden_instructions key_in_arguments",
    ModelFailed: "broken_json truncated_json wrong_types words_instead empty_reply refusal content_filter unknown_tool "
    "fields_not_asked_for nothing_but_null no_choices a_list html calls_without_function deep_arguments "
    "megabyte_of_words body_without_end gzip_bomb key_in_text",
    ModelUnreachable: "too_many too_many_wait_a_day server_error unavailable unauthorized not_found redirect silence "
    "dripped_headers dripped_body closed_before_headers reset_before_headers closed_in_headers not_http "
    "key_in_error key_in_redirect",
}


@pytest.mark.parametrize(("kind", "name"), [(kind, name) for kind, names in OUTCOMES.items() for name in names.split()])
def test_what_becomes_of_it(kind: type, name: str) -> None:
    with planted(), ModelServer(misbehaving(GOOD, always(name))) as server:
        found = in_time(
            lambda: asked(client_of(server, "chat", False, 0.3 if name == "silence" or "drip" in name else 60.0))
        )
    assert type(found) is kind, found


@pytest.mark.parametrize(("api", "streamed"), [("chat", False), ("messages", True)], ids=["chat", "messages streamed"])
@pytest.mark.parametrize(
    "name",
    ["broken_json", "empty_reply", "server_error", "too_many_wait_a_moment", "reset_in_body", "ended_in_the_middle"],
)
def test_it_recovers(name: str, api: str, streamed: bool) -> None:
    with ModelServer(misbehaving(GOOD, first(name, 1))) as server:
        assert in_time(lambda: asked(client_of(server, api, streamed))) == Plan.model_validate(PLAN)
    assert len(server.requests) == 2


@pytest.mark.parametrize(("api", "streamed"), CASES, ids=IDS)
def test_it_follows_nobody_elsewhere(api: str, streamed: bool) -> None:
    with planted(), ModelServer(GOOD) as other, ModelServer(lambda _: redirect_to(other.url)) as server:
        found = in_time(lambda: asked(client_of(server, api, streamed)))
    assert isinstance(found, ModelUnreachable)
    assert not other.requests and not other.strays and not other.keys_seen


@pytest.mark.parametrize(
    ("name", "streamed"),
    [
        pytest.param(name, streamed, marks=[] if streamed is (name == "stream_without_end") else [pytest.mark.slow])
        for name in ("gzip_bomb", "body_without_end", "stream_without_end", "headers_without_end")
        for streamed in (False, True)
    ],
)
def test_memory_is_bounded(name: str, streamed: bool) -> None:
    """These would be a quarter of a gigabyte, or would never end."""
    with ModelServer(misbehaving(GOOD, always(name))) as server:
        client = client_of(server, "chat", streamed)
        gc.collect()
        before = peak_memory(anew=True)
        in_time(lambda: asked(client))
    assert peak_memory() - before < 100 << 20


def test_tokens_that_were_never_used_spend_the_budget_and_none_come_back() -> None:
    limits = Limits(tokens=10_000)
    with ModelServer(misbehaving(GOOD, always("usage_without_end"))) as server:
        client = client_of(server, "chat", False, limits=limits)
        assert isinstance(asked(client), Plan) and isinstance(asked(client), BudgetSpent)
    with ModelServer(misbehaving(GOOD, always("usage_below_zero"))) as server:
        client = client_of(server, "chat", False, limits=Limits(tokens=1, calls=5))
        assert isinstance(asked(client), Plan) and client.usage.total.tokens_in >= 0
    assert len(server.requests) == 1


def test_the_time_of_the_run_ends_a_wait() -> None:
    with ModelServer(misbehaving(GOOD, always("silence"))) as server:
        left = iter([0.3] * 2 + [0.0] * 1000)
        found = in_time(lambda: asked(client_of(server, "chat", False, 50.0, left=lambda: next(left))))
    assert isinstance(found, BudgetSpent) and len(server.requests) <= 1
