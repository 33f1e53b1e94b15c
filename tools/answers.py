"""What a model of scenes answers, as a scene: checked before anything is made of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sceneweaver.importers.frames import yaw_matrix
from sceneweaver.importers.model import SourceObject, SourceRoom
from sceneweaver.importers.scene import ImportedScene, to_scene
from sceneweaver.io.messages import show
from sceneweaver.scene import InputError, Room, Scene

from .scene_files import GivenScene

MOST_OBJECTS = 500
"""Objects that a scene of a model may have."""

FARTHEST, LARGEST = 1000.0, 100.0
"""Metres from the origin, and of an extent, beyond which a number is nonsense."""

FORMAT = "model"
"""The format of plain data, in provenance."""

SHAPE = 'give a Scene, or {"room": {"outline": [[x, y], ...]}, "objects": [{"label", "size", "position", "yaw"}]}'


def scene_of(answer: Any, name: str, room: Room | None = None) -> GivenScene:
    """The scene that an answer is.

    Args:
        answer: a scene, what an importer reads or yields, or plain data as `SceneModel.generate` says.
        name: of the model.
        room: the shell that it was asked to furnish; plain data without a room means this one.

    Raises:
        InputError: it is none of these, or something in it is out of range; one line names the field.
    """
    if isinstance(answer, GivenScene):
        found = answer
    elif isinstance(answer, Scene):
        found = GivenScene(answer)
    elif isinstance(answer, ImportedScene):
        found = GivenScene(answer.scene, answer.room, answer.format, answer.notes)
    else:
        source = answer if isinstance(answer, SourceRoom) else _source_room(answer, name, room)
        _counted(source.objects)
        made = to_scene(source, FORMAT, name="room")
        found = GivenScene(made.scene, source.name, FORMAT, made.notes)
    _counted(found.scene.objects)
    return found


def _counted(objects: Sequence[Any]) -> None:
    if not objects:
        raise InputError("its scene holds no object")
    if len(objects) > MOST_OBJECTS:
        raise InputError(f"its scene has {len(objects)} objects; at most {MOST_OBJECTS} are taken")


def _source_room(data: Any, name: str, room: Room | None) -> SourceRoom:
    """Plain data as a reader would yield it."""
    if not isinstance(data, Mapping):
        raise InputError(f"its answer is {show(data)}; {SHAPE}")
    rows = data.get("objects")
    if not isinstance(rows, list | tuple):
        raise InputError(f"objects is {show(rows)}; {SHAPE}")
    _counted(rows)
    shell = data.get("room")
    if shell is None and room is not None:
        shell = {"outline": room.outline, "height": room.height, "type": room.type}
    if not isinstance(shell, Mapping | None):
        raise InputError(f"room is {show(shell)}; {SHAPE}")
    outline = height = None
    if shell is not None and shell.get("outline") is not None:
        corners = shell["outline"]
        if not isinstance(corners, list | tuple) or len(corners) < 3:
            raise InputError(f"room.outline is {show(corners)}; give at least three corners [x, y]")
        outline = tuple(_numbers(p, f"room.outline[{k}]", 2) for k, p in enumerate(corners))
    if shell is not None and shell.get("height") is not None:
        height = _number(shell["height"], "room.height", 0.5, LARGEST)
    kind = shell.get("type", "") if shell is not None else ""
    return SourceRoom(
        name=name,
        type=kind if isinstance(kind, str) else "",
        outline=outline,  # type: ignore[arg-type]
        height=height,
        objects=tuple(_source_object(row, f"objects[{k}]") for k, row in enumerate(rows)),
        text=str(data.get("text", "")),
    )


def _source_object(row: Any, where: str) -> SourceObject:
    if not isinstance(row, Mapping):
        raise InputError(f"{where} is {show(row)}; {SHAPE}")
    label = row.get("label")
    if not isinstance(label, str) or not label.strip():
        raise InputError(f"{where}.label is {show(label)}; give a text such as 'double bed'")
    size = row.get("size")
    extents = None if size is None else _numbers(size, f"{where}.size", 3, 1e-3, LARGEST)
    return SourceObject(
        name=str(row.get("id") or label),
        label=label,
        position=_numbers(row.get("position"), f"{where}.position", 3),  # type: ignore[arg-type]
        rotation=yaw_matrix(_number(row.get("yaw", 0.0), f"{where}.yaw", -FARTHEST, FARTHEST)),
        size=extents,  # type: ignore[arg-type]
    )


def _numbers(value: Any, where: str, many: int, low: float = -FARTHEST, high: float = FARTHEST) -> tuple[float, ...]:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, list | tuple) or len(value) != many:
        raise InputError(f"{where} is {show(value)}; give {many} numbers [m]")
    return tuple(_number(v, f"{where}[{k}]", low, high) for k, v in enumerate(value))


def _number(value: Any, where: str, low: float, high: float) -> float:
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise InputError(f"{where} is {show(value)}; give a finite number")
    if not low <= value <= high:
        raise InputError(f"{where} is {show(float(value))}; it has to be from {low:g} to {high:g}")
    return float(value)
