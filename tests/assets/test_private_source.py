"""A library of the caller's own is the one that is asked, wherever a scene with its assets is used."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import sceneweaver as sw
from sceneweaver.assets import Library
from sceneweaver.assets.sources import ParametricSource, StoreSource
from sceneweaver.envs import RoomEnv
from sceneweaver.export import export_scene
from sceneweaver.render import draw_room
from sceneweaver.report import ReportData, write_report
from tests.assets.private import Private

LIBRARY = Library([Private()])


@pytest.fixture(scope="module")
def scene() -> sw.Scene:
    room = sw.build(sw.Room.rectangle(4, 4), library=LIBRARY)
    room.add_door("south", at=0.5)
    room.add("side table", at=(1.0, 1.0))
    return room.scene()


@pytest.fixture(autouse=True)
def nothing_of_the_user(monkeypatch: pytest.MonkeyPatch, scene: sw.Scene) -> None:
    """Whatever asks the user's own sources fails."""
    for source in (StoreSource, ParametricSource):
        monkeypatch.setattr(source, "owns", _asked)
    monkeypatch.setattr(StoreSource, "find", _asked)


def _asked(*_: object) -> bool:
    raise AssertionError("the library of this user was asked")


def _edited(scene: sw.Scene, folder: Path) -> None:
    session = sw.EditSession(scene, device="cpu", library=LIBRARY)
    added = session.add("stool", at=(3.0, 3.0)).scene.objects[-1]
    assert str(added.asset).startswith("mine:")


def _judged(scene: sw.Scene, folder: Path) -> None:
    report = sw.check(scene, physics=True, openable=True, library=LIBRARY)
    assert report.stability is not None and not report.warnings


def _shown(scene: sw.Scene, folder: Path) -> None:
    assert scene.show(load=LIBRARY.load).html


def _drawn(scene: sw.Scene, folder: Path) -> None:
    draw_room(scene, LIBRARY.load, width=64, height=48)


def _exported(scene: sw.Scene, folder: Path) -> None:
    assert len(export_scene(scene, folder, ("glb", "mjcf", "urdf", "sdf", "scenestate"), LIBRARY.load)) == 5


def _reported(scene: sw.Scene, folder: Path) -> None:
    write_report(folder / "report.html", ReportData(scene, load=LIBRARY.load))


def _simulated(scene: sw.Scene, folder: Path) -> None:
    env = RoomEnv(scene, task="go to the side table", load=LIBRARY.load)
    env.reset(seed=0)
    env.close()


@pytest.mark.parametrize("used", [_edited, _judged, _shown, _drawn, _exported, _reported, _simulated])
def test_the_library_of_the_caller_is_asked(
    used: Callable[[sw.Scene, Path], None], scene: sw.Scene, tmp_path: Path
) -> None:
    assert all(str(o.asset).startswith("mine:") for o in scene.objects)
    used(scene, tmp_path)
