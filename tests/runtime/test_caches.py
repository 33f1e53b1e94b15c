"""Where caches lie, and what stands in for them where that place cannot be written."""

import logging
import os
import stat
import tempfile
from pathlib import Path
from types import SimpleNamespace

import pytest

from sceneweaver.runtime import caches


@pytest.fixture(autouse=True)
def temporary(tmp_path, monkeypatch):
    """A temporary folder of this test's own, and nothing said yet."""
    place = tmp_path / "tmp"
    place.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(place))
    monkeypatch.setattr(caches, "_told", False)
    for name in ("XDG_CACHE_HOME", "XDG_DATA_HOME"):
        monkeypatch.delenv(name, raising=False)
    return place


def own(parent: Path) -> Path:
    return parent / f"sceneweaver-{os.getuid()}"


def full(*folders):
    """``os.statvfs`` where some folders are on a disk without room."""
    real = os.statvfs

    def statvfs(path):
        if any(Path(path).is_relative_to(folder) for folder in folders):
            return SimpleNamespace(f_bavail=1, f_frsize=4096)
        return real(path)

    return statvfs


def test_usual_places(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    assert caches.cache_place("sceneweaver/x") == tmp_path / ".cache/sceneweaver/x"
    assert caches.data_place("sceneweaver/x") == tmp_path / ".local/share/sceneweaver/x"
    assert caches.writable(caches.cache_place("x")) == tmp_path / ".cache/x"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "c"))
    monkeypatch.setenv("XDG_DATA_HOME", "relative")  # counts as not set
    assert caches.cache_place("x") == tmp_path / "c/x"
    assert caches.data_place("x") == tmp_path / ".local/share/x"


def test_home_that_is_not_there_is_not_made(tmp_path, temporary, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path / "nobody"))
    assert caches.writable(caches.cache_place("sceneweaver/x")) == own(temporary) / "sceneweaver/x"
    assert not (tmp_path / "nobody").exists()


@pytest.mark.parametrize("home", ["", "/", "relative"])
def test_home_that_is_none(home, temporary, monkeypatch):
    monkeypatch.setenv("HOME", home)
    assert caches.writable(caches.cache_place("sceneweaver/x")) == own(temporary) / "sceneweaver/x"


def test_user_without_home(temporary, monkeypatch):
    monkeypatch.delenv("HOME")
    monkeypatch.setattr(os.path, "expanduser", lambda path: path)  # as for a user whom the system does not know
    assert caches.writable(caches.cache_place("sceneweaver/x")) == own(temporary) / "sceneweaver/x"


@pytest.mark.parametrize("below", ["a", "a/b/c"])
def test_file_in_its_place(below, tmp_path, temporary, caplog):
    (tmp_path / "a").write_text("")
    usual = tmp_path / below
    with caplog.at_level(logging.INFO):
        found = [caches.writable(usual), caches.writable(usual), caches.writable(tmp_path / "a" / "other")]
    assert found[0] == found[1] == own(temporary) / Path(*usual.parts[-2:])
    assert len(set(found)) == 2 and all(place.is_dir() for place in found)
    assert stat.S_IMODE(own(temporary).stat().st_mode) == 0o700
    (record,) = caplog.records  # one line for all
    assert record.levelno == logging.WARNING and str(usual) in record.message and str(temporary) in record.message
    assert "\n" not in record.message


def test_read_only_and_full(tmp_path, temporary, monkeypatch):
    usual = tmp_path / "usual"
    usual.mkdir()
    with monkeypatch.context() as patch:
        patch.setattr(os, "access", lambda path, mode: Path(path) != usual)
        assert caches.writable(usual).is_relative_to(own(temporary))
    with monkeypatch.context() as patch:
        patch.setattr(os, "statvfs", full(usual))
        assert caches.writable(usual).is_relative_to(own(temporary))
    assert caches.writable(usual) == usual


def test_nothing_can_be_written(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "statvfs", full(tmp_path, Path(caches.SHARED_MEMORY)))
    with pytest.raises(OSError, match=r"usual cannot be written \(the disk is full\).*TMPDIR"):
        caches.writable(tmp_path / "usual")


@pytest.mark.parametrize("made", ["open to others", "a link", "a file", "of another user"])
def test_folder_of_somebody_else_is_not_used(made, tmp_path, temporary, monkeypatch):
    if made == "a link":
        (tmp_path / "elsewhere").mkdir(mode=0o700)
        own(temporary).symlink_to(tmp_path / "elsewhere")
    elif made == "a file":
        own(temporary).write_text("")
    else:
        own(temporary).mkdir(mode=0o700)
        if made == "open to others":
            own(temporary).chmod(0o777)
        else:
            monkeypatch.setattr(caches, "_user", lambda: os.getuid() + 1)
            own(temporary).rename(temporary / f"sceneweaver-{os.getuid() + 1}")
    found = caches.writable(Path("/dev/null/a/b"))
    if made == "of another user":
        monkeypatch.undo()
    root = found.parents[1]
    assert found.parts[-2:] == ("a", "b") and root.parent == temporary
    assert root.name.startswith("sceneweaver-") and root.name != f"sceneweaver-{os.getuid()}"
    assert not list((tmp_path / "elsewhere").glob("*"))


def test_what_stands_in_is_read_as_well(tmp_path, temporary):
    (tmp_path / "file").write_text("")
    usual = tmp_path / "file" / "x"
    assert caches.places(usual) == (usual,)
    kept = caches.writable(usual)
    assert caches.places(usual) == (usual, kept)


def test_what_is_mostly_read_stays_where_it_is(tmp_path, temporary, monkeypatch):
    usual = tmp_path / "usual"
    assert caches.kept_in(usual) == usual and not usual.exists()
    usual.mkdir()
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    assert caches.kept_in(usual) == usual  # to be read, though it is read-only
    monkeypatch.undo()
    assert caches.kept_in(Path("/dev/null/a/b")).parts[-2:] == ("a", "b")
