"""``sceneweaver knowledge``: learn from a server, keep, list, show, replay, forget."""

from __future__ import annotations

import logging
import os

import pytest

from sceneweaver.knowledge.room_files import read_room
from sceneweaver.language import read_request
from sceneweaver.llm import attempts
from sceneweaver.tools.room_reply import RoomReply
from tests.agent.by_model.test_rooms import SHED
from tests.llm.model_server import ModelServer, answering


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A user's folder of its own, and no model in the environment."""
    monkeypatch.setenv("SCENEWEAVER_ROOMS", str(tmp_path / "rooms"))
    monkeypatch.setattr(attempts, "FIRST_WAIT", 0.01)
    for name in ("MODEL", "BASE_URL", "API_KEY"):
        monkeypatch.delenv(f"SCENEWEAVER_{name}", raising=False)
    return tmp_path / "rooms"


def test_learn_list_show_replay_forget(run, tmp_path, folder):
    learn = ("knowledge", "learn", "Sky hut")
    with ModelServer(answering({RoomReply: SHED})) as server:
        endpoint = ("--model", "openai:scripted-1", "--base-url", server.url)
        done = run(*learn, *endpoint, "--record", tmp_path / "records", "--out", tmp_path / "hut.yaml")
        assert (done.code, done.err) == (0, "")
        assert "sky_hut: learned, 3 kinds of things (1 needed) on 6 to 16 m2" in done.out
        assert 'sceneweaver design "a sky hut"' in done.out
        assert len(server.requests) == 1 and "Sky hut" in server.requests[0].text
        again = run(*learn, *endpoint)
        assert again.code == 2 and "sky_hut is learned already; forget it first" in again.err
    text = (tmp_path / "hut.yaml").read_text()
    assert text == (folder / "sky_hut.yaml").read_text() and read_room(text).name == "sky_hut"
    listed = run("knowledge", "list", "--json").json["rooms"]
    assert [r["name"] for r in listed if r["learned"]] == ["sky_hut"] and len(listed) > 50
    assert run("knowledge", "list").out.startswith("sky_hut")
    assert run("knowledge", "show", "sky hut").out.strip() == text.strip()
    shown = run("knowledge", "show", "clipping shed", "--json").json
    assert shown["learned"] and [i["id"] for i in shown["items"]] == ["bench", "shelf", "light"]
    assert run("knowledge", "forget", "sky hut").out == "sky_hut: forgotten\n"
    replayed = run(*learn, "--replay", tmp_path / "records", "--json")
    assert replayed.code == 0 and replayed.json["learned"] == "sky_hut"
    assert (folder / "sky_hut.yaml").read_text() == text
    assert run("knowledge", "forget", "sky hut", "--json").json["forgotten"] == "sky_hut"
    assert list(folder.glob("*.yaml")) == []


def test_a_model_that_writes_nonsense(run, folder):
    with ModelServer(answering({RoomReply: {**SHED, "area": [2, 2, 2]}})) as server:
        args = ("knowledge", "learn", "sky hut", "--model", "openai:scripted-1", "--base-url", server.url)
        done = run(*args, "--json")
    assert done.code == 3 and "the model wrote no sky hut that can be drawn" in done.json["error"]
    assert not folder.exists()


@pytest.mark.parametrize(
    ("args", "code", "words"),
    [
        (("learn", "sky hut"), 4, "model"),
        (("learn", "sky hut", "--model", "openai:x", "--base-url", "http://127.0.0.1:9/v1"), 4, "room: "),
        (("learn", "bedroom", "--model", "x", "--base-url", "http://127.0.0.1:9/v1"), 2, "is known already"),
        (("learn", "../..", "--model", "x", "--base-url", "http://127.0.0.1:9/v1"), 2, "is no name"),
        (("learn", "sky hut", "--replay", "nowhere"), 2, "nowhere"),
        (("show", "sky hut"), 2, "'sky hut' is unknown"),
        (("forget", "sky hut"), 2, "was never learned"),
        (("forget", "bedroom"), 2, "cannot be forgotten"),
    ],
)
def test_what_can_go_wrong_is_one_line(args, code, words, run):
    done = run("knowledge", *args)
    assert done.code == code and words in done.err and done.err.count("\n") == 1, done.err


def test_known_rooms_are_shown(run):
    shown = run("knowledge", "show", "bed room")
    assert shown.code == 0 and "bedroom: A room to sleep" in shown.out and "nightstand" in shown.out


DAMAGED = {
    "cut off": "name: [",
    "50,000 levels": "[" * 50_000,
    "no date": "name: hut\nwords: [2001-99-99]\n",
    "200,000 digits": "name: hut\narea: " + "9" * 200_000,
    "code": '!!python/object/apply:os.system ["echo"]',
    "no text": "\0",
}
"""Text of a room's file, by what is wrong with it."""


def test_damaged_files_are_left_out_each_with_a_line(run, folder, caplog):
    """So one of them takes nothing from the other rooms, and no design from the user."""
    folder.mkdir()
    for k, text in enumerate(DAMAGED.values()):
        (folder / f"hut{k}.yaml").write_text(text)
    os.mkfifo(folder / "pipe.yaml")
    (folder / "folder.yaml").mkdir()
    (folder / "zero.yaml").symlink_to("/dev/zero")
    (folder / "gone.yaml").symlink_to(folder / "nowhere")
    with caplog.at_level(logging.WARNING):
        assert run("knowledge", "list").code == 0
    lines = [line.getMessage() for line in caplog.records if "is left out" in line.getMessage()]
    assert len(lines) == len(DAMAGED) + 4 and all("learned room" in line and "\n" not in line for line in lines)
    assert read_request("a bedroom with a bed").room_type == "bedroom"


@pytest.mark.parametrize("text", DAMAGED.values(), ids=DAMAGED)
def test_damaged_specifications_and_prices_are_one_line(run, tmp_path, text):
    file = tmp_path / "wrong.yaml"
    file.write_text(text)
    model = ("--planner", "llm", "--model", "openai:m", "--base-url", "http://127.0.0.1:9/v1")
    for command in (
        ("dataset", "make", file, "--out", tmp_path / "set"),
        ("design", "a bedroom", *model, "--prices", file, "--out", tmp_path / "run"),
    ):
        ended = run(*command)
        assert ended.code == 2 and ended.err.count("\n") == 1 and "wrong.yaml" in ended.err, ended.err
