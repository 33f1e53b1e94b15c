"""A library of finished scenes: what there is at a glance, and each of them as a scene."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from functools import lru_cache
from importlib import resources
from pathlib import Path
from typing import Any

from pydantic import Field

from sceneweaver.io import parse_json, read_bytes
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.base import FrozenModel

INDEX = "index.json"


class SceneCard(FrozenModel):
    """What a choice among scenes needs to know of one; ``sides`` are those of the box around its floor [m]."""

    name: str
    room: str
    prompt: str = ""
    area: float = Field(description="Floor [m2]")
    sides: tuple[float, float]
    corners: int
    doors: int = 1
    windows: int = 0
    style: str | None = None
    people: int | None = None
    categories: dict[str, int] = Field(default={}, description="How many objects of each category")
    grade: float | None = Field(default=None, description="Mean grade 0 to 10 of the critic")
    source: str = Field(default="", description="Format of the file that it was read from; empty: one of ours")
    text: str = Field(default="", description="Other words that it came with: labels of another system")
    part: str = Field(default="", description="Name of its room in a file of several")
    nth: int = Field(default=0, description="Its place among the rooms of that name")


def own_folder() -> Path:
    """The folder of the scenes that come with the library."""
    return Path(str(resources.files(__package__ or "").joinpath("library")))


def library_scenes(folder: str | Path | None = None) -> tuple[SceneCard, ...]:
    """Cards of all scenes of a folder, of our own without one; files that are no scenes are skipped.

    Raises:
        InputError: when there is no such folder.
    """
    place = Path(folder) if folder is not None else own_folder()
    if not place.is_dir():
        if folder is None:
            return ()
        raise InputError(f"folder: '{place}' is no folder; give one that holds scene.json files")
    index = place / INDEX
    files = _files(place)
    stamp = max((f.stat().st_mtime_ns for f in (index, *files) if f.exists()), default=0)
    return _cards(place, len(files), stamp)


def load_scene(name: str, folder: str | Path | None = None) -> Scene:
    """The scene of a card's name; InputError when there is none, or its file is no scene."""
    place = Path(folder) if folder is not None else own_folder()
    for file in _files(place) if place.is_dir() else ():
        if _name(place, file) == name:
            return Scene.load(file)
    known = [card.name for card in library_scenes(folder)]
    raise InputError(f"library: there is no scene '{name}'{suggest(name, known)}")


def card_of(name: str, data: Mapping[str, Any], grade: float | None = None) -> SceneCard:
    """The card of a scene in plain JSON data."""
    room = data["room"]
    xs, ys = [float(p[0]) for p in room["outline"]], [float(p[1]) for p in room["outline"]]
    area = sum(x0 * y1 - x1 * y0 for x0, y0, x1, y1 in zip(xs, ys, [*xs[1:], xs[0]], [*ys[1:], ys[0]], strict=True))
    origin = data.get("provenance") or {}
    style, people = origin.get("style"), origin.get("people")
    return SceneCard(
        name=name,
        room=str(origin.get("room") or room.get("type", "room")),
        prompt=data.get("prompt", ""),
        area=round(abs(area) / 2, 3),
        sides=(round(max(xs) - min(xs), 3), round(max(ys) - min(ys), 3)),
        corners=len(xs),
        doors=len(room.get("doors", ())),
        windows=len(room.get("windows", ())),
        style=style if isinstance(style, str) else None,
        people=people if isinstance(people, int) else None,
        categories=dict(sorted(Counter(o["category"] for o in data.get("objects", ())).items())),
        grade=grade,
    )


def _files(place: Path) -> list[Path]:
    """Scene files of a folder: NAME.json, or NAME/scene.json."""
    flat = [f for f in sorted(place.glob("*.json")) if f.name not in (INDEX, "metrics.json")]
    return flat + sorted(place.glob("*/scene.json"))


def _name(place: Path, file: Path) -> str:
    return file.parent.name if file.name == "scene.json" and file.parent != place else file.stem


@lru_cache(maxsize=16)
def _cards(place: Path, count: int, stamp: int) -> tuple[SceneCard, ...]:
    """Cards from the index where it lists all files, else from the files; cached until one of them changes."""
    index = place / INDEX
    if index.is_file():
        try:
            rows = [SceneCard.model_validate(row) for row in parse_json(read_bytes(index))]
        except (ValueError, TypeError):
            rows = []
        if {row.name for row in rows} == {_name(place, f) for f in _files(place)}:
            return tuple(rows)
    found = []
    for file in _files(place):
        try:
            data = parse_json(read_bytes(file))
            found.append(card_of(_name(place, file), data))
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            continue  # some other JSON file
    return tuple(found)
