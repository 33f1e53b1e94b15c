"""What the tests of ``sceneweaver.scene`` share: the zoo, and a small scene with one of everything."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

ZOO = sorted((Path(__file__).parents[1] / "zoo").glob("*.json"))


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "zoo_file" in metafunc.fixturenames:
        metafunc.parametrize("zoo_file", ZOO, ids=lambda path: path.stem)


@pytest.fixture(scope="session")
def bedroom_text() -> str:
    return (ZOO[0].parent / "bedroom.json").read_text("utf-8")


_SQUARE = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
_SMALL: dict[str, Any] = {
    "schema": "sceneweaver.scene/1",
    "id": "small",
    "room": {
        "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
        "height": 2.5,
        "doors": [{"id": "door-0", "wall": 0, "offset": 0.5, "width": 0.9, "height": 2.0}],
        "windows": [{"id": "window-0", "wall": 2, "offset": 1.0, "width": 1.5, "sill": 0.9, "height": 1.2}],
    },
    "objects": [
        {
            "id": "cup-0",
            "category": "cup",
            "size": [0.08, 0.08, 0.1],
            "pose": {"position": [2, 2, 0.77], "quaternion": [0, 0, 0, 1]},
            "mount": "surface",
            "support": {"object": "tray-0", "surface": "top"},
        },
        {
            "id": "desk-0",
            "category": "desk",
            "description": "an oak desk",
            "size": [1, 1, 0.75],
            "pose": {"position": [2, 2, 0], "quaternion": [0, 0, 0.6, 0.8]},
            "parts": [{"polygon": _SQUARE, "z": [0.7, 0.75]}, {"polygon": _SQUARE, "z": [0, 0.1]}],
            "zones": [{"name": "front", "polygon": [[0.5, -0.5], [1, -0.5], [1, 0.5], [0.5, 0.5]], "z": [0, 1.8]}],
            "surfaces": [{"name": "top", "polygon": _SQUARE, "z": 0.75, "headroom": 1.5}],
            "intent": {"priority": "asked", "request": "desk-1", "mounting_height": [0.5, 1]},
            "attributes": {"color": "brown", "style": {"era": [1950, 1960]}},
        },
        {
            "id": "tray-0",
            "category": "tray",
            "size": [0.3, 0.4, 0.02],
            "pose": {"position": [2, 2, 0.75], "quaternion": [0, 0, 0, 1]},
            "mount": "surface",
            "support": {"object": "desk-0", "surface": "top"},
            "surfaces": [{"name": "top", "polygon": [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]], "z": 0.02}],
        },
        {"id": "chair-0", "category": "chair", "size": [0.5, 0.5, 0.9]},
        {"id": "chair-1", "category": "chair", "size": [0.5, 0.5, 0.9]},
    ],
    "relations": [
        {"type": "against_wall", "subject": "desk-0", "target": "wall:1", "asked": True},
        {"type": "around", "subject": "chair-0", "target": "desk-0", "params": {"gap": [0, 0.2]}},
        {"type": "near", "subject": "chair-1", "target": "desk-0", "params": {"max": 2}, "hard": False, "weight": 0.5},
        {"type": "between", "subject": "desk-0", "target": ["chair-0", "chair-1"]},
        {"type": "near", "subject": "chair-1", "target": "desk-0"},
        {"type": "at_window", "subject": "desk-0", "target": "window-0"},
        {"type": "away_from_door", "subject": "chair-1", "target": "door-0"},
        {"type": "in_corner", "subject": "chair-1"},
        {"type": "on_top", "subject": "cup-0", "target": "tray-0"},
    ],
    "provenance": {"seed": 7},
    "dropped": [{"id": "lamp-0", "category": "lamp", "reason": "no room"}],
}


@pytest.fixture
def small() -> dict[str, Any]:
    """Data of a scene with one of everything: a stack of three, a pair target, duplicates of a relation."""
    return copy.deepcopy(_SMALL)


@pytest.fixture
def put() -> Any:
    """``put(data, path, value)`` sets a value deep in JSON data and gives the data."""

    def put(data: Any, path: tuple[str | int, ...], value: Any) -> Any:
        at = data
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = value
        return data

    return put


@pytest.fixture
def as_text() -> Any:
    return json.dumps
