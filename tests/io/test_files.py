"""Files that users name: no waiting for pipes, no growing past a limit, nothing half written, one writer at a time."""

from __future__ import annotations

import gzip
import multiprocessing
import os
import signal
import subprocess
import sys
import time
import tracemalloc

import pytest

from sceneweaver.io import (
    lines_unpacked,
    locked,
    open_regular,
    read_bytes,
    read_unpacked,
    sweep,
    temporary_folder,
    whole,
    write_atomic,
)
from sceneweaver.scene import InputError, MissingDependencyError


@pytest.fixture
def pipe(tmp_path):
    """A pipe that nobody writes to: opening it the usual way waits for ever."""
    os.mkfifo(tmp_path / "pipe")
    return tmp_path / "pipe"


def test_a_pipe_is_refused_at_once(pipe):
    began = time.monotonic()
    with pytest.raises(InputError, match="pipe: this is a pipe or a device; give a regular file"):
        open_regular(pipe)
    link = pipe.with_name("link")
    link.symlink_to(pipe)
    with pytest.raises(InputError, match="link: this is a pipe or a device"):
        open_regular(link)
    assert time.monotonic() - began < 1.0


@pytest.mark.parametrize("read", [read_unpacked, lambda *a, **k: list(lines_unpacked(*a, **k))])
def test_no_more_is_unpacked_than_the_limit(tmp_path, read):
    path = tmp_path / "much.json.gz"
    path.write_bytes(gzip.compress(b" " * (64 << 20)))
    assert path.stat().st_size < 1 << 20
    tracemalloc.start()
    try:
        with pytest.raises(InputError, match="unpacks to more than 1 MB; split it"):
            read(path, max_bytes=1 << 20)
        assert tracemalloc.get_traced_memory()[1] < 8 << 20
    finally:
        tracemalloc.stop()


def test_unpacked_content_and_damage(tmp_path):
    path = tmp_path / "a.json.gz"
    path.write_bytes(gzip.compress(b"one\ntwo\n"))
    assert read_unpacked(path) == b"one\ntwo\n" and list(lines_unpacked(path)) == [b"one\n", b"two\n"]
    path.write_bytes(path.read_bytes()[:-6])
    with pytest.raises(InputError, match="a.json.gz: not readable as gzip"):
        read_unpacked(path)
    path.write_bytes(b"plain")
    with pytest.raises(InputError, match="not readable as gzip"):
        read_unpacked(path)


def test_a_file_is_whole_or_as_before(tmp_path):
    path = tmp_path / "a.txt"
    write_atomic(path, "old")
    with pytest.raises(KeyboardInterrupt), whole(path) as temporary:
        assert temporary.name == "a.txt"
        with open(temporary, "w") as file:
            file.write("half")
        raise KeyboardInterrupt
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["a.txt"]


WRITER = """
import sys, time
from sceneweaver.io import whole
with whole(sys.argv[1]) as temporary:
    open(temporary, "w").write("half")
    print("ready", flush=True)
    time.sleep(60)
"""


def test_what_a_killed_run_left_is_swept_and_what_a_live_one_writes_is_not(tmp_path):
    process = subprocess.Popen([sys.executable, "-c", WRITER, str(tmp_path / "a.txt")], stdout=subprocess.PIPE)
    assert process.stdout is not None and process.stdout.readline() == b"ready\n"
    sweep(tmp_path)
    assert len(os.listdir(tmp_path)) == 1  # it is still being written
    process.send_signal(signal.SIGKILL)
    process.wait(10)
    assert len(os.listdir(tmp_path)) == 1
    (tmp_path / "other.tmp").mkdir()
    sweep(tmp_path)
    assert os.listdir(tmp_path) == ["other.tmp"]
    with temporary_folder(tmp_path) as mine:
        sweep(tmp_path)
        assert mine.is_dir()


HOLDER = """
import sys, time
from sceneweaver.io import locked
with locked(sys.argv[1], "--out: x"):
    print("ready", flush=True)
    time.sleep(60)
"""


def test_one_writer_at_a_time_and_a_killed_one_does_not_count(tmp_path):
    path = tmp_path / "scene.json"
    process = subprocess.Popen([sys.executable, "-c", HOLDER, str(path)], stdout=subprocess.PIPE)
    assert process.stdout is not None and process.stdout.readline() == b"ready\n"
    with pytest.raises(InputError, match=f"--out: x is being written by process {process.pid}; wait for it, or choose"):
        locked(path, "--out: x").__enter__()
    process.send_signal(signal.SIGKILL)
    process.wait(10)
    assert os.listdir(tmp_path) == [".sceneweaver-scene.json.lock"]
    with locked(path, "--out: x"):
        assert len(os.listdir(tmp_path)) == 1
    assert not os.listdir(tmp_path)


def _count(path, log):
    for _ in range(40):
        try:
            with locked(path, "x"):
                with open(log, "a") as file:
                    file.write("in\n")
                with open(log, "a") as file:
                    file.write("out\n")
        except InputError:
            continue


def test_the_lock_excludes_however_they_race(tmp_path):
    """Lock files are removed at the end: a holder that locked a removed one must not count."""
    log = tmp_path / "log"
    workers = [multiprocessing.get_context("fork").Process(target=_count, args=(tmp_path / "a", log)) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join(30)
    lines = log.read_text().split()
    assert lines == ["in", "out"] * (len(lines) // 2)


@pytest.fixture
def elsewhere(tmp_path):
    """A folder that nothing may be written to, with one file in it; a run's own folder lies beside it."""
    (tmp_path / "own").mkdir()
    place = tmp_path / "elsewhere"
    place.mkdir()
    (place / "keep.txt").write_text("keep")
    yield place
    assert [p.name for p in place.iterdir()] == ["keep.txt"] and (place / "keep.txt").read_text() == "keep"


def test_a_file_takes_the_place_of_a_link(elsewhere, tmp_path):
    for name, target in (("a", elsewhere / "keep.txt"), ("dangling", elsewhere / "new.txt"), ("folder", elsewhere)):
        link = tmp_path / "own" / name
        link.symlink_to(target)
        write_atomic(link, "new")
        assert not link.is_symlink() and link.read_text() == "new"


def test_no_folder_of_a_run_is_a_link(elsewhere, tmp_path):
    own = tmp_path / "own"
    (own / "views").symlink_to(elsewhere)
    (own / "steps").mkdir()
    (own / "steps" / "01").symlink_to(elsewhere)
    for name in ("views/top.png", "steps/01/scene.json"):
        with pytest.raises(InputError, match=f"{name.rpartition('/')[0]}: this is a link to another place; remove it"):
            write_atomic(own / name, "new", within=own)
    with pytest.raises(InputError, match="outside"):
        write_atomic(elsewhere / "new.txt", "new", within=own)
    (tmp_path / "linked").symlink_to(own)  # what a user names may be one
    write_atomic(tmp_path / "linked" / "a.txt", "new", within=tmp_path / "linked")
    assert (own / "a.txt").read_text() == "new"


def test_a_file_lands_in_the_folder_that_was_opened(elsewhere, tmp_path):
    """A link that takes the folder's name while the file is being written gets nothing."""
    own, views = tmp_path / "own", tmp_path / "own" / "views"
    views.mkdir()
    with whole(views / "top.png", within=own) as temporary:
        temporary.write_text("new")
        views.rename(own / "moved")
        views.symlink_to(elsewhere)
    assert (own / "moved" / "top.png").read_text() == "new"
    assert os.listdir(own / "moved") == ["top.png"]


def test_what_a_run_goes_on_from_is_no_link(elsewhere, tmp_path):
    own = tmp_path / "own"
    (own / "state.json").symlink_to(elsewhere / "keep.txt")
    with pytest.raises(InputError, match=r"state.json: this is a link to another place"):
        read_bytes(own / "state.json", within=own)
    (own / "steps").symlink_to(elsewhere)
    with pytest.raises(InputError, match=r"steps: this is a link to another place"):
        read_bytes(own / "steps" / "keep.txt", within=own)
    assert read_bytes(own / "steps" / "keep.txt") == b"keep"  # which a user may name


@pytest.mark.parametrize("kind", ["link", "hard link", "pipe"])
def test_a_lock_file_is_a_file_of_ours(elsewhere, tmp_path, kind):
    lock = tmp_path / "own" / ".sceneweaver-scene.json.lock"
    if kind == "pipe":
        os.mkfifo(lock)
    else:
        (os.link if kind == "hard link" else os.symlink)(elsewhere / "keep.txt", lock)
    with (
        pytest.raises(InputError, match="--out: own cannot be written"),
        locked(tmp_path / "own" / "scene.json", "--out: own"),
    ):
        pass


def test_an_error_is_one_line_whatever_it_quotes():
    for kind in (InputError, MissingDependencyError):
        line = str(kind("models.a\x00b: is \x1b[2J\r\nbad"))
        assert line.isprintable() and "models.a" in line and "bad" in line
