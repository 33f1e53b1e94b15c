"""ReSpace: a room in its structured scene representation (SSR), as JSON.

``bounds_bottom`` and ``bounds_top`` are the outline's corners [x, y, z] at floor and ceiling; ``objects`` have
``desc``, ``size`` [x, y, z] (FULL extents of the object's own axes), ``pos`` (the centre of the BOTTOM) and ``rot``
(quaternion x, y, z, w). Frame: metres, right-handed, y up, models of 3D-FUTURE facing +z. SSR-3DFRONT wraps it
as ``scene``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, parse_json
from sceneweaver.io.messages import path_name

from ..frames import Y_UP, facing, quaternion_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..values import loaded, mapping, member, numbers, positive, sequence, word

_REST = re.compile(r"\s*(?:[,.;]|\b(?:with|featuring|features?|that|has|having|in|made)\b).*", re.IGNORECASE)
"""What follows the thing itself in a description such as "Modern wooden bed with a low frame"."""


def matches(path: Path, head: bytes) -> bool:
    """JSON with the bounds of a room."""
    return head.lstrip()[:1] in (b"{", b"[") and b"bounds_bottom" in head and b"room_type" in head


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its room, or those of a list."""
    where = path_name(path)
    data = loaded(path)
    for k, entry in enumerate(data if isinstance(data, list) else [data]):
        place = f"{where}: [{k}]" if isinstance(data, list) else where
        entry = mapping(entry, place)
        scene = entry.get("scene", entry)
        if isinstance(scene, str):
            try:
                scene = parse_json(scene)
            except InputError as error:
                raise InputError(f"{place}: scene: {error}") from None
        name = word(entry.get("room_id")) or (f"{k:04d}" if isinstance(data, list) else "")
        yield _room(mapping(scene, f"{place}: scene"), name, word(entry.get("room_type")), place)


def _room(scene: Mapping[str, Any], name: str, kind: str, place: str) -> SourceRoom:
    bottom = numbers(member(scene, "bounds_bottom", place), (None, 3), f"{place}: bounds_bottom")
    if len(bottom) < 3:
        raise InputError(f"{place}: bounds_bottom: {len(bottom)} corners; a room needs three")
    floor, height = float(bottom[:, 1].min()), None
    if "bounds_top" in scene:
        top = numbers(scene["bounds_top"], (None, 3), f"{place}: bounds_top")
        height = float(top[:, 1].max()) - floor if len(top) else None
    if height is not None and height <= 0:
        raise InputError(f"{place}: bounds_top: the ceiling lies {-height:g} m below the floor")
    rows = sequence(member(scene, "objects", place), f"{place}: objects")
    return SourceRoom(
        name=name,
        type=word(scene.get("room_type"), kind),
        outline=tuple((float(x), float(y)) for x, y in (bottom @ Y_UP.T)[:, :2]),
        height=height,
        objects=tuple(_object(row, k, floor, f"{place}: objects[{k}]") for k, row in enumerate(rows)),
        notes=(f"the floor lies at {floor:g} m; it is moved to 0",) if abs(floor) > 1e-9 else (),
    )


def _object(row: Any, k: int, floor: float, place: str) -> SourceObject:
    size = positive(member(row, "size", place), f"{place}: size")
    position = numbers(member(row, "pos", place), (3,), f"{place}: pos") - np.array([0.0, floor, 0.0])
    try:
        turn = quaternion_matrix(numbers(row.get("rot", [0, 0, 0, 1]), (4,), f"{place}: rot").tolist())
    except ValueError as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{place}: rot: a quaternion of length 0; give x, y, z, w") from None
    text = word(row.get("desc"))
    label = word(row.get("category")) or word(row.get("class")) or _REST.sub("", text) or "object"
    x, y, z = (Y_UP @ position).tolist()
    return SourceObject(
        name=word(row.get("id")) or f"object_{k}",
        label=label,
        position=(x, y, z),
        anchor="bottom",
        rotation=Y_UP @ turn @ facing("z", "y").T,
        size=(float(size[2]), float(size[0]), float(size[1])),
        asset=word(row.get("sampled_asset_jid")) or word(row.get("jid")) or None,
        description=text,
        keep={key: row[key] for key in ("sampled_asset_size", "prompt", "uuid") if key in row},
    )


FORMAT = SourceFormat(
    name="respace",
    title="ReSpace (SSR)",
    matches=matches,
    read=read,
    notes=(
        "Read: JSON with room_type, bounds_bottom, bounds_top and objects (desc, size, pos, rot), alone, in a list, or "
        "under 'scene' as SSR-3DFRONT has it.",
        "Meaning: y up; size are full extents; pos is the middle of the bottom; rot is a quaternion x, y, z, w; the "
        "front is +z at no rotation. The room's height is that between the bounds.",
        "Assumed: the category is the first phrase of the description; the size is the one that was asked for, not "
        "that of the model that was found for it.",
        "Lost: doors and windows (the format has none).",
    ),
    licence="3D-FRONT's terms of use for scenes of SSR-3DFRONT",
)
