"""What tests of readers share: rooms of a file, poses compared with numbers found another way, errors of one line."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.importers.formats import formats
from sceneweaver.importers.model import ReadOptions, SourceObject, SourceRoom
from sceneweaver.importers.read import format_of

NEAR = 1e-5


def written(folder: Path, name: str, data: Any) -> Path:
    """A file with data as JSON, or with text as it is."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(data if isinstance(data, str) else json.dumps(data))
    return path


def rooms_of(name: str, path: Path, folder: Path | None = None) -> dict[str, SourceRoom]:
    """The rooms of a file by name, read as a format; the file has to be recognised as one of it."""
    assert format_of(path).name == name
    return {room.name: room for room in formats()[name].read(path, ReadOptions(folder=folder))}


def things_of(room: SourceRoom) -> dict[str, SourceObject]:
    """The objects of a room by name."""
    return {thing.name: thing for thing in room.objects}


def centre_of(thing: SourceObject) -> np.ndarray:
    """The middle of an object's box [m]."""
    assert thing.anchor in ("centre", "bottom")
    up = 0.0
    if thing.anchor == "bottom":
        assert thing.size is not None
        up = thing.size[2] / 2
    return np.asarray(thing.position) + thing.rotation @ (0.0, 0.0, up)


def require_pose(thing: SourceObject, centre: Any, front: Any, up: Any = (0.0, 0.0, 1.0)) -> None:
    """An object is where it has to be: the middle of its box, where its front points, and its upper side."""
    np.testing.assert_allclose(centre_of(thing), centre, atol=NEAR, err_msg=thing.name)
    np.testing.assert_allclose(thing.rotation @ (1.0, 0.0, 0.0), front, atol=NEAR, err_msg=thing.name)
    np.testing.assert_allclose(thing.rotation @ (0.0, 0.0, 1.0), up, atol=NEAR, err_msg=thing.name)
    assert abs(np.linalg.det(thing.rotation) - 1.0) < 1e-9, thing.name


def compass(yaw: float) -> tuple[float, float, float]:
    """The direction of an angle [rad], counter-clockwise from +x."""
    return math.cos(yaw), math.sin(yaw), 0.0


def require_error(path: Path, name: str, *words: str, folder: Path | None = None) -> None:
    """Reading a broken file fails with one line that names the file and has some words."""
    with pytest.raises(sw.InputError) as caught:
        list(sw.read_scenes(path, name, assets="boxes", folder=folder))
    line = str(caught.value)
    assert "\n" not in line and path.name in line, line
    for word in words:
        assert word in line, line


def without(data: Any, *keys: Any) -> Any:
    """A copy of data in which what the keys lead to is missing."""
    copy = json.loads(json.dumps(data))
    at = copy
    for key in keys[:-1]:
        at = at[key]
    del at[keys[-1]]
    return copy


def changed(data: Any, value: Any, *keys: Any) -> Any:
    """A copy of data in which what the keys lead to has another value; NaN may be one."""
    copy = json.loads(json.dumps(data))
    at = copy
    for key in keys[:-1]:
        at = at[key]
    at[keys[-1]] = value
    return copy
