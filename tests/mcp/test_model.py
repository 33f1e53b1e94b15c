"""Designs with a language model through the server."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from sceneweaver.mcp import build_server
from tests.llm.bad_statuses import status
from tests.llm.model_server import ModelServer, answering
from tests.mcp.driving import ROOT, connected

KEY = "sk-planted-0123456789abcdef"
ROOM = {"prompt": "a store room with only one shelf", "steps": 1, "candidates": 8, "clutter": 0}
BEGIN = {"problem": "no room", "calls": [{"tool": "init_prior", "confidence": 0.9, "instruction": "Begin."}]}


@pytest.mark.slow
def test_a_model_plans_a_room_and_what_it_took_is_told(tmp_path, monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    with ModelServer(answering({"You design a room step by step": [BEGIN]})) as model:
        asked = {"model": "scripted-1", "base_url": model.url, "reader": "rules", "critic": "symbolic"}
        server = build_server(tmp_path, device="cpu", llm=asked)
        with connected(server) as driver:
            answer = driver.tell("design", planner="llm", folder="room", **ROOM)
        server.service.workers.close()
    assert not answer.is_error, answer.content[0].text
    room = answer.structured_content
    assert room["valid"] and room["model"]["planned"] == ["openai:scripted-1"] and not room["model"]["lost"]
    assert room["model"]["usage"]["calls"] == len(model.requests) == 1
    assert "openai:scripted-1: 1 call," in answer.content[0].text
    assert (tmp_path / "room" / "llm" / "transcript.md").is_file()
    for path in tmp_path.rglob("*"):
        assert not path.is_file() or KEY.encode() not in path.read_bytes(), path


@pytest.mark.slow
def test_a_model_that_refuses_leaves_a_valid_room_and_no_trace_of_the_key(tmp_path, monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    with ModelServer(lambda asked: status(401, f"no such key: {KEY}")) as model:
        server = build_server(tmp_path, device="cpu", llm={"model": "scripted-1", "base_url": model.url})
        with connected(server) as driver:
            answer = driver.tell("design", planner="llm", folder="room", **ROOM)
        server.service.workers.close()
    assert model.keys_seen == {KEY}
    assert not answer.is_error, answer.content[0].text
    room = answer.structured_content
    assert room["valid"] and room["model"]["lost"] and "not asked any more" in answer.content[0].text
    assert KEY not in answer.content[0].text and KEY not in json.dumps(room)
    for path in tmp_path.rglob("*"):
        assert not path.is_file() or KEY.encode() not in path.read_bytes(), path


def test_a_base_url_without_a_model_is_refused(tmp_path):
    arguments = ["-m", "sceneweaver", "mcp", "--folder", str(tmp_path), "--base-url", "http://127.0.0.1:9/v1"]
    done = subprocess.run([sys.executable, *arguments], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2 and done.stderr.startswith("sceneweaver: --model is missing"), done.stderr
