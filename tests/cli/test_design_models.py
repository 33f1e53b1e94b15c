"""``sceneweaver design`` with a model: its options, what it says, how it ends."""

from __future__ import annotations

import json

import pytest

from sceneweaver.llm import attempts
from tests.llm.misbehaviour import always, misbehaving
from tests.llm.model_server import ModelServer, answering

BEGIN = {"problem": "no room", "calls": [{"tool": "init_prior", "confidence": 0.9, "instruction": "Begin."}]}
STOP = {"stop": True, "stop_reason": "all is there"}
SHELF = "a store room with only one shelf"
KEY = "sk-planted-0123456789abcdef"
QUICK = ("--seed", 1, "--steps", 2, "--candidates", 8, "--device", "cpu", "--no-pictures", "--export", "none")
PLANS = ("--planner", "llm", "--reader", "rules", "--critic", "symbolic", "--model", "scripted-1")


def plans(*given):
    return answering({"You design a room step by step": [*given]})


@pytest.fixture(autouse=True)
def key(monkeypatch):
    for name in ("MODEL", "BASE_URL"):
        monkeypatch.delenv(f"SCENEWEAVER_{name}", raising=False)
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    monkeypatch.setattr(attempts, "FIRST_WAIT", 0.01)


@pytest.mark.parametrize("stream", ["--stream", pytest.param("--no-stream", marks=pytest.mark.slow)])
def test_a_model_on_a_server_plans_and_what_it_did_is_told(run, tmp_path, stream):
    prices = tmp_path / "prices.yaml"
    prices.write_text("currency: EUR\nmodels:\n  scripted-1: {input: 1.0, output: 2.0}\n")
    out = tmp_path / "out"
    with ModelServer(plans(BEGIN, STOP)) as server:
        done = run("design", SHELF, "--out", out, *QUICK, *PLANS, "--base-url", server.url, stream, "--prices", prices)
    assert done.code in (0, 3) and "planned 1 of 1 steps, 2 calls" in done.out and "EUR" in done.out
    assert f"model openai:scripted-1 at {server.url}: plans" in done.err and "planned by openai:scripted-1" in done.err
    assert server.keys_seen == {KEY} and all(asked.stream == (stream == "--stream") for asked in server.requests)
    models = json.loads((out / "metrics.json").read_text())["models"]
    assert models["planned"] == ["openai:scripted-1"] and models["usage"]["cost"] > 0
    transcript = (out / "llm/transcript.md").read_text()
    assert "no room" in transcript and "init_prior" in transcript
    again = tmp_path / "again"
    replayed = run("design", "--out", again, "--replay", out, "--no-pictures", "--export", "none", "--json")
    assert (again / "scene.json").read_bytes() == (out / "scene.json").read_bytes()
    assert replayed.json["models"]["usage"]["calls"] == 2 and replayed.json["models"]["name"] == "openai:scripted-1"
    assert KEY not in "".join(f.read_text() for f in tmp_path.rglob("*") if f.suffix in (".json", ".md", ".yaml"))


def test_a_model_that_is_not_there_costs_the_model_alone_unless_the_run_is_strict(run, tmp_path):
    with ModelServer(plans(BEGIN)) as server:
        gone = server.url
    options = (*QUICK, *PLANS, "--base-url", gone)
    done = run("design", SHELF, "--out", tmp_path / "a", *options, "--json")
    assert done.json["valid"] and done.json["models"]["planned"][0] == "rules" and done.json["models"]["lost"]
    assert any("planned by rules from step 1" in note for note in done.json["notes"])
    done = run("design", SHELF, "--out", tmp_path / "b", *options, "--strict")
    assert done.code == 4 and "strict" in done.err and KEY not in done.err


def test_budgets_end_the_model_and_not_the_run(run, tmp_path):
    with ModelServer(plans(BEGIN, {**BEGIN, "calls": []})) as server:
        options = (*QUICK, *PLANS, "--base-url", server.url, "--max-calls", 1)
        done = run("design", SHELF, "--out", tmp_path / "a", *options, "--json")
        assert done.json["valid"] and done.json["models"]["planned"] == ["openai:scripted-1", "rules"]
        assert len(server.requests) == 1


def test_broken_answers_end_in_a_valid_scene(run, tmp_path):
    with ModelServer(misbehaving(plans(BEGIN), always("broken_json"))) as server:
        options = (*QUICK, *PLANS, "--base-url", server.url, "--steps", 1)
        done = run("design", SHELF, "--out", tmp_path / "a", *options, "--json")
    assert done.json["valid"] and done.json["models"]["planned"] == ["rules"]


@pytest.mark.parametrize(
    ("options", "words", "code"),
    [
        (("--planner", "llm"), "no model is configured", 4),
        (("--planner", "llm", "--model", "some-name"), "does not say whose", 2),
        (("--planner", "llm", "--model", "openai:x", "--base-url", "http://me:secret@host/v1"), "password", 2),
        (("--reader", "oracle"), "--reader", 2),
        (("--critic", "oracle"), "--critic", 2),
        (("--samples", "0"), "--samples", 2),
        (("--prices", "nowhere.yaml"), "nowhere.yaml", 2),
        (("--replay", "nowhere"), "holds no run", 2),
    ],
)
def test_options_that_cannot_be(run, tmp_path, monkeypatch, options, words, code):
    monkeypatch.delenv("SCENEWEAVER_API_KEY")
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    done = run("design", SHELF, "--out", tmp_path / "out", *options)
    assert done.code == code and words in done.err and "secret" not in done.err
    assert not (tmp_path / "out").exists()


def test_a_request_is_needed_unless_a_run_is_made_again(run, tmp_path):
    done = run("design", "--out", tmp_path / "out")
    assert done.code == 2 and "prompt: is missing" in done.err
