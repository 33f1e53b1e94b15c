"""Reading and writing files: every fault is one line that names the file."""

from __future__ import annotations

import json
import os
import stat
import threading
import time

import pytest

from sceneweaver.scene import EXAMPLES, InputError, Scene


def refused(call, *parts):
    with pytest.raises(InputError) as caught:
        call()
    text = str(caught.value)
    assert text.isprintable(), text
    for part in parts:
        assert part in text
    return text


def test_zoo_loads_and_keeps_what_the_file_says(zoo_file):
    scene, data = Scene.load(zoo_file), json.loads(zoo_file.read_text("utf-8"))
    assert list(scene.ids) == [o["id"] for o in data["objects"]]
    back = scene.to_json()
    for ours, theirs in zip(back["objects"], data["objects"], strict=True):
        assert ours.pop("pose")["quaternion"] == pytest.approx(theirs.pop("pose")["quaternion"], abs=1e-8)
        assert ours == {k: v for k, v in theirs.items() if v is not None or k in ("support", "asset")}
    assert back["relations"] == data["relations"] and back["room"] == data["room"]


def test_zoo_round_trips(zoo_file, tmp_path):
    scene = Scene.load(zoo_file)
    text = scene.dumps()
    again = Scene.loads(text)
    assert again == scene and again.dumps() == text and Scene.from_json(scene.to_json()) == scene
    scene.save(tmp_path / "scene.json")
    assert Scene.load(tmp_path / "scene.json") == scene
    assert (tmp_path / "scene.json").read_text("utf-8") == text


def test_one_of_everything_round_trips(small, as_text):
    scene = Scene.loads(as_text(small))
    assert Scene.loads(scene.dumps()) == scene == Scene.loads(scene.dumps().encode())
    assert scene.to_json()["relations"][3]["target"] == ["chair-0", "chair-1"]


def test_floats_keep_full_precision(small):
    small["objects"][3]["size"] = [0.1 + 0.2, 1 / 3, 5e-6]
    small["objects"][3]["pose"] = {"position": [1e-17, -0.0, 123456.789012345], "quaternion": [0, 0, 0, 1]}
    small["provenance"] = {"x": 2.0**-1074, "big": 2**90, "text": "[\n 1,\n 2\n]  [ 3 ] \u00e9 \u2028"}
    scene = Scene.from_json(small)
    again = Scene.loads(scene.dumps())
    assert again == scene and str(again.objects[3].pose.position[1]) == "-0.0"


def test_written_numbers_stand_on_one_line(small):
    text = Scene.from_json(small).dumps()
    assert '"outline": [[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [0.0, 4.0]]' in text
    assert '"size": [0.5, 0.5, 0.9]' in text and text.endswith("}\n")


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_load_and_are_named_like_their_files(name):
    scene = Scene.example(name)
    assert scene.id == name and Scene.loads(scene.dumps()) == scene


def test_examples_by_name():
    assert "bedroom" in EXAMPLES and Scene.example().id == "bedroom"
    refused(lambda: Scene.example("bedrom"), "no example 'bedrom'; did you mean 'bedroom'?")


def test_missing_file_and_folder(tmp_path):
    refused(lambda: Scene.load(tmp_path / "no.json"), "no.json: no such file; check the path")
    refused(lambda: Scene.load(tmp_path), "this is a folder; give the file in it, such as scene.json")
    refused(lambda: Scene.load("a\0b"), "cannot be read")
    refused(lambda: Scene.load("x" * 5000), "cannot be read (File name too long)")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read anything")
def test_unreadable_file(tmp_path):
    path = tmp_path / "scene.json"
    path.write_text("{}")
    path.chmod(0)
    refused(lambda: Scene.load(path), "cannot be read (Permission denied)")


def test_truncated_and_invalid_json(tmp_path, bedroom_text):
    path = tmp_path / "scene.json"
    path.write_text(bedroom_text[:5000])
    refused(lambda: Scene.load(path), "scene.json: invalid JSON: it ends too early, at line", "is the file cut off?")
    path.write_text('{"schema": "sceneweaver.scene/1",\n "id": nope}')
    refused(lambda: Scene.load(path), "scene.json: invalid JSON at line 2, column 8: Expecting value")
    path.write_text('{"id": "abc')
    refused(lambda: Scene.load(path), "it ends too early, at line 1, column 8")
    path.write_text("")
    refused(lambda: Scene.load(path), "the file is empty")
    path.write_text(bedroom_text + "}")
    refused(lambda: Scene.load(path), "invalid JSON at line", "Extra data")


def test_text_that_is_not_utf8(tmp_path, bedroom_text):
    path = tmp_path / "scene.json"
    path.write_bytes(bedroom_text.encode("utf-16"))
    refused(lambda: Scene.load(path), "scene.json: not UTF-8 text (byte 0); save the file as UTF-8")
    path.write_bytes(b"\xef\xbb\xbf" + bedroom_text.encode())  # a byte order mark does no harm
    assert Scene.load(path).id == "bedroom"


@pytest.mark.parametrize(("text", "what"), [("[]", "a list"), ("5", "5"), ('"x"', '"x"'), ("null", "null")])
def test_top_level_must_be_an_object(text, what):
    refused(lambda: Scene.loads(text), f"the top level is {what}; give an object")


def test_large_file_is_refused_before_it_is_read(tmp_path, monkeypatch):
    path = tmp_path / "scene.json"
    with open(path, "wb") as file:
        file.truncate(100 * 2**20)
    monkeypatch.setattr("builtins.open", lambda *a, **k: pytest.fail("the file was opened"))
    refused(lambda: Scene.load(path), "scene.json: the file has 100 MB; at most 64 MB are read")


def test_limit_can_be_set_and_pipes_and_devices_are_not_opened(tmp_path):
    path = tmp_path / "scene.json"
    path.write_bytes(b" " * 2000)
    refused(lambda: Scene.load(path, max_bytes=1000), "the file has 0.00190735 MB; at most")
    os.mkfifo(tmp_path / "pipe")
    for place in (tmp_path / "pipe", "/dev/zero"):
        refused(lambda place=place: Scene.load(place), "is a pipe or a device; give a regular file")


def test_nesting_is_limited(small):
    refused(lambda: Scene.loads('{"a":' * 100_000), "nested too deep")
    deep = 1
    for _ in range(200):
        deep = [deep]
    small["provenance"] = {"x": deep}
    refused(lambda: Scene.from_json(small), "is nested deeper than 32 levels; flatten it")
    small["provenance"] = {}
    small["objects"] = deep
    refused(lambda: Scene.from_json(small), "objects[0] is a list; give an object")


def test_numbers_of_thousands_of_digits(small, as_text):
    text = as_text(small).replace('"height": 2.5', f'"height": {"9" * 5000}')
    refused(lambda: Scene.loads(text), "a number has too many digits")
    text = as_text(small).replace('"height": 2.5', '"height": 1e999')
    refused(lambda: Scene.loads(text), "room.height is Infinity; numbers must be finite")


@pytest.mark.parametrize("word", ["NaN", "Infinity", "-Infinity"])
def test_words_for_numbers_are_refused_with_their_field(small, as_text, word):
    text = as_text(small).replace('"height": 2.5', f'"height": {word}')
    refused(lambda: Scene.loads(text), f"room.height is {word}; numbers must be finite")


def test_a_key_that_stands_twice(small, as_text):
    text = as_text(small).replace('"category": "cup"', '"category": "cup", "category": "mug"')
    refused(lambda: Scene.loads(text), "key \"category\" stands twice in one object of 'cup-0'; remove one")


def test_file_name_leads_the_line(tmp_path, small, as_text):
    path = tmp_path / "my\nscene.json"
    small["objects"][3]["size"][1] = -0.5
    path.write_text(as_text(small))
    text = refused(lambda: Scene.load(path), "objects[3] 'chair-0': size[1] is -0.5; sizes are positive metres")
    assert text.startswith(str(tmp_path)) and "my\\nscene.json: objects" in text


def test_save_replaces_the_whole_file_with_usual_permissions(tmp_path, small):
    scene, path = Scene.from_json(small), tmp_path / "scene.json"
    path.write_text("old")
    scene.save(str(path))
    assert Scene.load(path) == scene and os.listdir(tmp_path) == ["scene.json"]
    mask = os.umask(0)
    os.umask(mask)
    assert stat.S_IMODE(path.stat().st_mode) == 0o666 & ~mask


def test_save_through_a_link_keeps_the_link(tmp_path, small):
    (tmp_path / "real").mkdir()
    (tmp_path / "link.json").symlink_to(tmp_path / "real" / "scene.json")
    Scene.from_json(small).save(tmp_path / "link.json")
    assert (tmp_path / "link.json").is_symlink() and (tmp_path / "real" / "scene.json").exists()


@pytest.mark.parametrize("broken", ["open", "fsync", "replace"])
def test_failed_save_leaves_the_old_file_and_no_other(tmp_path, small, monkeypatch, broken):
    path = tmp_path / "scene.json"
    path.write_text("old")

    def fail(*args, **options):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, broken, fail)
    refused(lambda: Scene.from_json(small).save(path), "scene.json: cannot be written (No space left on device)")
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["scene.json"]


def test_save_to_bad_places(tmp_path, small):
    scene = Scene.from_json(small)
    refused(lambda: scene.save(tmp_path), "this is a folder; give a file name in it")
    refused(lambda: scene.save(tmp_path / "no" / "scene.json"), "its folder does not exist; make it first")
    (tmp_path / "file").write_text("")
    refused(lambda: scene.save(tmp_path / "file" / "scene.json"), "cannot be written (Not a directory)")
    refused(lambda: scene.save("/proc/scene.json"), "/proc/scene.json: ")
    refused(lambda: scene.save("a\0b"), "cannot be written")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_save_to_unwritable_folder(tmp_path, small):
    tmp_path.chmod(0o500)
    refused(lambda: Scene.from_json(small).save(tmp_path / "scene.json"), "cannot be written (Permission denied)")
    tmp_path.chmod(0o700)


def test_readers_never_see_half_a_file(tmp_path, small):
    scene, path = Scene.from_json(small), tmp_path / "scene.json"
    scene.save(path)
    stop = time.monotonic() + 0.3
    faults: list[Exception] = []

    def read():
        while time.monotonic() < stop:
            try:
                Scene.load(path)
            except InputError as error:
                faults.append(error)

    reader = threading.Thread(target=read)
    reader.start()
    while time.monotonic() < stop:
        scene.save(path)
    reader.join()
    assert not faults
