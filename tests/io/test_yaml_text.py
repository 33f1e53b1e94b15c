"""YAML that others wrote: plain data, or one line that says what is wrong; never a crash, a wait or gigabytes."""

import os
import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sceneweaver.datasets.spec import load_spec
from sceneweaver.io import load_yaml, parse_yaml
from sceneweaver.knowledge.room_files import read_room
from sceneweaver.llm.prices import Prices
from sceneweaver.scene import InputError
from tests.sizes import examples

WRONG = {
    "brackets": ("[" * 50_000, "nested more than 40 deep"),
    "braces": ("{" * 50_000, "nested more than 40 deep"),
    "dashes": ("- " * 20_000, "nested more than 40 deep"),
    "no such day": ("a: 2001-99-99", "month must be in 1..12"),
    "digits": ("a: " + "9" * 200_000, "line 1: a value of 200000 characters; at most 300"),
    "hexadecimal digits": ("a: 0x" + "f" * 4000, "a value of 4002 characters; at most 300"),
    "a long value": ("a: " + "x" * 200_000, "at most 100000"),
    "an alias": ("a: &x 1\nb: *x", "anchors, aliases and tags are not read"),
    "a tag": ("a: !!python/object:x 1", "anchors, aliases and tags are not read"),
    "many values": ("a: [" + "1," * 300_000 + "]", "more than 200000 values"),
    "no end": ("a: [1", "line 2: did not find expected"),
    "no text": (b"\xff\xfe\x00", "cannot be read as YAML"),
}


@pytest.mark.parametrize(("text", "said"), WRONG.values(), ids=WRONG)
def test_what_is_refused(tmp_path, text, said):
    with pytest.raises(InputError) as error:
        parse_yaml(text, "hut.yaml")
    assert said in str(error.value) and str(error.value).startswith("hut.yaml: ") and "\n" not in str(error.value)
    path = tmp_path / "file.yaml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    for read in (Prices.load, load_spec, load_yaml, lambda path: read_room(path.read_text(errors="replace"))):
        with pytest.raises(InputError):
            read(path)


@pytest.mark.parametrize("read", [Prices.load, load_spec])
def test_only_regular_files_are_opened(tmp_path, read):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "endless").symlink_to("/dev/zero")
    for name in ("pipe", "endless"):
        with pytest.raises(InputError, match="pipe or a device"):
            read(tmp_path / name)


def test_a_broken_room_of_a_user_is_left_out(tmp_path):
    """50,000 brackets in one file ended the process with a segmentation fault."""
    (tmp_path / "hut.yaml").write_text("[" * 50_000)
    done = subprocess.run(
        [sys.executable, "-m", "sceneweaver.cli", "knowledge", "list"],
        env=os.environ | {"SCENEWEAVER_ROOMS": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0 and "bedroom" in done.stdout and "Traceback" not in done.stderr


@examples(70, 200)
@given(st.one_of(st.binary(max_size=200), st.text("[]{}-:,&*!?|>'\"#%@0x1e9.\n a", max_size=80)))
def test_any_text(text):
    try:
        parse_yaml(text, "f")
    except InputError as error:
        assert str(error).startswith("f: ") and "\n" not in str(error)


def test_plain_data():
    assert parse_yaml("a: [1, 2.5, text, true]\nb: {c: null}", "f") == {"a": [1, 2.5, "text", True], "b": {"c": None}}
