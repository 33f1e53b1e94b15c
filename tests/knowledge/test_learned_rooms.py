"""Rooms that were learned: read by name and words, kept apart from all others, and harmless when they are damaged."""

from __future__ import annotations

import logging

import pytest

from sceneweaver.knowledge import match_room, room_type, room_types
from sceneweaver.knowledge.learned import (
    forget_room,
    keep_room,
    learned_rooms,
    learned_words,
    named_in,
    room_file,
    rooms_folder,
    rooms_of,
)
from sceneweaver.knowledge.likely import likeliest_room
from sceneweaver.knowledge.room_files import read_room, room_text, slug
from sceneweaver.language import read_request
from sceneweaver.scene import InputError
from sceneweaver.tools.room_reply import RoomReply, kind_data
from tests.tools.programmes import ROOM


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A user's folder of its own."""
    monkeypatch.setenv("SCENEWEAVER_ROOMS", str(tmp_path / "rooms"))
    return tmp_path / "rooms"


def hut(name: str = "mountain_hut", words: tuple[str, ...] = ("alpine hut",), **more: object) -> str:
    return room_text({**kind_data(RoomReply.model_validate(ROOM), name, words, "a test"), **more})


def test_what_is_kept_is_read_by_its_name_and_words(folder):
    assert keep_room(hut()) == folder / "mountain_hut.yaml"
    assert set(learned_rooms()) == {"mountain_hut"}
    assert learned_words() == {"mountain hut": "mountain_hut", "alpine hut": "mountain_hut"}
    for text in ("a mountain hut", "An alpine hut with two beds, rustic", "mountain-hut for six"):
        assert read_request(text).room_type == "mountain_hut", text
    assert match_room("Mountain Hut") == ("mountain_hut", 1.0) and match_room("alpine huts") == ("mountain_hut", 1.0)
    assert room_type("mountain_hut").item("stove").what == ("wood_stove",)
    assert read_request("an alpine hut with two beds").entity("bed") is not None
    assert [room.name for room in named_in("Build me a Mountain Hut!")] == ["mountain_hut"]


REQUESTS = (
    "a bedroom with a hut bed",
    "a living room with a painting of a mountain and a sofa",
    "a cosy room with a wood stove, two bunk beds and a dining table",
    "a moutain hutt",
    "hut",
    "a study",
)


def test_no_other_request_is_read_otherwise():
    before = [read_request(text) for text in REQUESTS]
    likely = [likeliest_room({"bunk_bed", "wood_stove", "dining_table"}, text) for text in REQUESTS]
    known = dict(room_types())
    keep_room(hut())
    assert [read_request(text) for text in REQUESTS] == before
    assert [likeliest_room({"bunk_bed", "wood_stove", "dining_table"}, text) for text in REQUESTS] == likely
    assert dict(room_types()) == known and match_room("mountain") is None


def test_it_is_forgotten(folder):
    keep_room(hut())
    assert forget_room("Mountain Hut") == folder / "mountain_hut.yaml"
    assert not learned_rooms() and read_request("a mountain hut").room_type is None
    with pytest.raises(InputError, match="'mountain_hut' was never learned"):
        forget_room("mountain hut")
    with pytest.raises(InputError, match="comes with sceneweaver and cannot be forgotten"):
        forget_room("bedroom")


@pytest.mark.parametrize(("name", "words"), [("bedroom", ()), ("sky_lab", ("living room",)), ("guest_room", ())])
def test_no_known_name_or_word_is_taken(name, words, folder):
    with pytest.raises(InputError, match="is known already, as"):
        keep_room(hut(name, words))
    folder.mkdir()
    (folder / f"{name}.yaml").write_text(hut(name, words))
    assert not learned_rooms() and room_type("bedroom").name == "bedroom"


BAD = {
    "empty": "",
    "list": "[1, 2]",
    "broken": "name: [",
    "no_schema": "name: no_schema",
    "bomb": "a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\nschema: sceneweaver.room/1",
    "code": "!!python/object/apply:os.system ['touch /tmp/owned']",
    "deep": "schema: " + "[" * 3000,
    "other_name": None,
    "unknown": None,
    "binary": b"\xff\xfe\x00\x01",
    "huge": "# " + "x" * 100_000,
    "numbers": "schema: sceneweaver.room/1\nname: numbers\nitems: 7",
    "dates": "schema: sceneweaver.room/1\nname: 2020-01-01\nitems: []",
}


def test_damaged_files_are_one_warning_each_and_never_a_crash(folder, caplog):
    folder.mkdir()
    for name, text in BAD.items():
        text = hut() if name == "other_name" else hut("unknown", (), extra=1) if text is None else text
        (folder / f"{name}.yaml").write_bytes(text if isinstance(text, bytes) else text.encode())
    (folder / "folder.yaml").mkdir()
    (folder / "good_hut.yaml").write_text(hut("good_hut", ()))
    with caplog.at_level(logging.WARNING):
        assert set(learned_rooms()) == {"good_hut"}
        assert read_request("a good hut").room_type == "good_hut"
    assert len(caplog.records) == len(BAD) + 1  # a folder is told as well
    assert all("is left out" in r.getMessage() and "\n" not in r.getMessage() for r in caplog.records)


@pytest.mark.parametrize("words", ["", "  ", "!!", "../../etc/passwd" * 9, "山小屋", "7 rooms", "a" * 41])
def test_what_is_no_name_is_refused(words):
    with pytest.raises(InputError, match="is no name"):
        slug(words)


def test_names_are_safe_for_files():
    assert slug("../Mountain  Hut\x00.yaml") == "mountain_hut_yaml"
    with pytest.raises(InputError, match="name"):
        read_room(hut("../evil", ()))


def test_a_file_says_the_same_after_it_was_read(folder):
    keep_room(hut())
    assert room_file("mountain_hut") == hut()
    assert read_room(hut()) == learned_rooms()["mountain_hut"]
    with pytest.raises(InputError, match="never learned"):
        room_file("nothing")


def test_a_run_may_know_other_rooms_than_the_user(tmp_path):
    keep_room(hut())
    with rooms_of(None):
        assert not learned_rooms() and read_request("a mountain hut").room_type is None
    keep_room(hut("sky_lab", ()), tmp_path / "others")
    with rooms_of(tmp_path / "others"):
        assert set(learned_rooms()) == {"sky_lab"}
    assert set(learned_rooms()) == {"mountain_hut"}


def test_folder_follows_the_environment(tmp_path, monkeypatch):
    assert rooms_folder() == tmp_path / "rooms"
    monkeypatch.delenv("SCENEWEAVER_ROOMS")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    assert rooms_folder() == tmp_path / "data" / "sceneweaver" / "rooms"
    assert not learned_rooms()
