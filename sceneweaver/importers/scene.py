"""From a room as a reader gives it to a scene: categories, sizes, bodies, what holds what, relations."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.geometry.polygons import rectangle
from sceneweaver.io import InputError
from sceneweaver.scene import Pose, Scene, SceneObject

from .bodies import Assets, with_body
from .categories import Named, category_of
from .frames import matrix_quaternion
from .holding import hold
from .model import SourceObject, SourceRoom
from .outline import outline_of, room_of
from .relations import relations_of
from .sizes import Found, SizeTable, find_size

UNSURE = 0.5
"""Categories less sure than this are told one by one."""


@dataclass(frozen=True)
class ImportedScene:
    """A scene of another system, and what became of it.

    ``scene`` has the poses of the file to the last digit. ``boundary`` says whether the outline is the "file"'s or
    drawn around the "objects". ``confidence`` is that of the category (0 to 1) by object id, ``sizes_from`` where the
    size comes from ("file", "mesh", "table", "category"). ``notes`` say what was assumed or left out.

    Examples:
        >>> from sceneweaver.importers import SourceObject, SourceRoom, to_scene
        >>> bed = SourceObject("b1", "king-size bed", (2.0, 1.1, 0.3), size=(2.1, 1.8, 0.6))
        >>> room = SourceRoom("r", "Bedroom", ((0, 0), (4, 0), (4, 3), (0, 3)), height=2.6, objects=(bed,))
        >>> imported = to_scene(room, "mine", name="first")
        >>> imported.scene.objects[0].category, imported.boundary, imported.confidence
        ('king_bed', 'file', {'b1': 0.95})
    """

    scene: Scene
    format: str
    room: str
    boundary: str
    confidence: dict[str, float]
    sizes_from: dict[str, str]
    notes: tuple[str, ...]


def to_scene(
    room: SourceRoom,
    format_name: str,
    *,
    name: str,
    assets: Assets = "own",
    sizes: SizeTable | None = None,
    relations: bool = True,
) -> ImportedScene:
    """The scene of a room that a reader gives.

    Args:
        room: as the reader gives it.
        format_name: of its format.
        name: of the scene.
        assets: "own" furniture of the category and size, "theirs" from the asset folder, or "boxes".
        sizes: (depth, width, height) [m] by asset or label, for files without sizes.
        relations: whether to infer soft relations from the geometry.

    Raises:
        InputError: a number that is not finite, an outline that is none, nothing in the room.
    """
    notes = list(room.notes)
    found: list[tuple[SourceObject, Named, Found, SceneObject]] = []
    used: set[str] = set()
    for source in room.objects:
        named = _named(source)
        size = find_size(source, named.body, sizes or {})
        plain = _plain_object(source, named, size, _free_id(source.name or named.category, used))
        used.add(plain.id)
        found.append((source, named, size, plain))
    outline, given = outline_of(room, [_footprint(thing) for *_, thing in found], notes)
    top = max((thing.pose.position[2] + thing.size[2] for *_, thing in found), default=0.0)
    kind = re.sub(r"[\s_-]+", "_", re.sub(r"[0-9]+$", "", room.type).strip().lower()).strip("_") or "room"
    shell = room_of(room, outline, top, kind, notes)
    ids = {source.name: thing.id for source, *_, thing in reversed(found)}
    objects = hold(
        [(source, with_body(thing, source, named, assets, notes)) for source, named, _, thing in found], ids, shell
    )
    scene = Scene(
        id=name,
        prompt=room.text,
        room=shell,
        objects=tuple(objects),
        provenance=_provenance(room, format_name, given, found),
    )
    _tell(found, notes)
    if relations:
        scene = scene.model_copy(update={"relations": relations_of(scene)})
    return ImportedScene(
        scene=scene,
        format=format_name,
        room=room.name,
        boundary="file" if given else "objects",
        confidence={thing.id: named.confidence for _, named, _, thing in found},
        sizes_from={thing.id: size.origin for _, _, size, thing in found},
        notes=tuple(notes),
    )


def _named(source: SourceObject) -> Named:
    """The category of an object: of its label, or of its description where that says more."""
    named = category_of(source.label, source.mount)
    if named.confidence < UNSURE and source.description and len(source.description) < 60:
        other = category_of(source.description, source.mount)
        if other.confidence > named.confidence:
            return other
    return named


def _plain_object(source: SourceObject, named: Named, found: Found, name: str) -> SceneObject:
    """The object as a box where the file has it."""
    position = np.asarray(source.position, dtype=float)
    turn = np.asarray(source.rotation, dtype=float)
    if position.shape != (3,) or turn.shape != (3, 3) or not (np.isfinite(position).all() and np.isfinite(turn).all()):
        raise InputError(f"object {name}: its pose is not finite; give metres and radians")
    if not all(math.isfinite(v) for v in found.size):
        raise InputError(f"object {name}: its size is not finite; give metres")
    down = np.array((0.0, 0.0, found.size[2] / 2))
    if source.anchor == "centre":
        position = position - turn @ down
    elif source.anchor == "origin" and found.offset is not None:
        position = position + turn @ (np.asarray(found.offset) - down)
    x, y, z = (float(v) for v in position)
    return SceneObject(
        id=name,
        category=named.category,
        description=source.description or None,
        size=found.size,
        pose=Pose(position=(x, y, z), quaternion=matrix_quaternion(turn)),
        fixed=source.fixed,
    )


def _free_id(name: str, used: set[str]) -> str:
    """A name as an id that is not used yet."""
    clean = "".join(c if c.isprintable() else " " for c in str(name)).strip().removeprefix("wall:") or "object"
    if clean not in used:
        return clean
    k = 2
    while f"{clean}_{k}" in used:
        k += 1
    return f"{clean}_{k}"


def _footprint(thing: SceneObject) -> np.ndarray:
    """Corners [4, 2] of an object's box on the floor."""
    frame = thing.pose.frame
    return np.array([frame.world(x, y) for x, y in rectangle(*thing.size[:2])])


def _provenance(
    room: SourceRoom, format_name: str, given: bool, found: Sequence[tuple[SourceObject, Named, Found, SceneObject]]
) -> dict[str, Any]:
    return {
        "imported": {
            "format": format_name,
            "room": room.name,
            "boundary": "file" if given else "objects",
            "objects": {
                thing.id: {
                    "name": source.name,
                    "label": source.label,
                    "confidence": named.confidence,
                    "size_from": size.origin,
                    **({"asset": source.asset} if source.asset else {}),
                }
                for source, named, size, thing in found
            },
        }
    }


def _tell(found: Sequence[tuple[SourceObject, Named, Found, SceneObject]], notes: list[str]) -> None:
    """Notes on what was guessed."""
    for source, named, _, thing in found:
        if named.confidence < UNSURE:
            notes.append(f"{thing.id}: '{source.label}' is no known category; taken for {named.category}")
    guessed = [thing.id for *_, size, thing in found if size.origin == "category"]
    if guessed:
        notes.append(
            f"{len(guessed)} of {len(found)} objects have no size in the file, the asset folder or --sizes; "
            "the usual one of their category is assumed"
        )
