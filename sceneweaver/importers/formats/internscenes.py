"""InternScenes: ``layout.json`` of a scene (Real2Sim, Gen), a list of ``id``, ``category``, ``model_uid`` and ``bbox``.

``bbox`` is EmbodiedScan's nine numbers: centre x, y, z, FULL extents along the box's own x, y, z, and three angles
[rad] about the moving axes z, then x, then y. Frame: metres, right-handed, z up. Models are turned before they are
stretched to the box so that they face +x, so the first extent is the depth. ``StructureMesh/floor.glb`` beside it is y
up.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import euler
from sceneweaver.io import InputError, read_mesh
from sceneweaver.io.messages import path_name, show

from ..frames import Y_UP
from ..model import ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..outlines import of_triangles
from ..values import keys_seen, loaded, member, numbers, sequence, word

OPENINGS = {"door": "door", "doorframe": "door", "window": "window"}
SHELL = frozenset({"wall", "floor", "ceiling"})
LEVEL = 0.5  # least upward part of the normal of a triangle of the floor


def matches(path: Path, head: bytes) -> bool:
    """A JSON list whose entries have a model_uid and a bbox."""
    return head.lstrip()[:1] == b"[" and {"model_uid", "bbox", "category"} <= keys_seen(head)


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its room."""
    where = path_name(path)
    notes: list[str] = []
    outline = _floor(path, notes)
    objects: list[SourceObject] = []
    openings: list[SourceOpening] = []
    shell = missing = 0
    for k, row in enumerate(sequence(loaded(path), where)):
        place = f"{where}: [{k}]"
        label = word(member(row, "category", place), "object")
        box = numbers(member(row, "bbox", place), (9,), f"{place}: bbox")
        if (box[3:6] <= 0).any():
            raise InputError(f"{place}: bbox: {show(float(box[3:6].min()))} is no extent; numbers 4 to 6 are lengths")
        if label.lower() in SHELL:
            shell += 1
        elif outline is not None and label.lower() in OPENINGS:
            openings.append(_opening(OPENINGS[label.lower()], len(openings), box))
        else:
            objects.append(_object(row, label, box, k))
            missing += not word(row.get("model_uid"))
    if shell:
        notes.append(f"{shell} walls, floors and ceilings among the objects are left out")
    if missing:
        notes.append(f"{missing} objects have no model_uid in the file: boxes only")
    yield SourceRoom(
        name="_".join(path.parent.parts[-2:]) if path.name == "layout.json" else path.stem,
        type=_type_of(path),
        outline=outline,
        openings=tuple(openings),
        objects=tuple(objects),
        notes=tuple(notes),
    )


def _turn(box: np.ndarray) -> np.ndarray:
    return euler(box[6:9], "ZXY")


def _object(row: Any, label: str, box: np.ndarray, k: int) -> SourceObject:
    return SourceObject(
        name=f"{label}_{word(row.get('id'), str(k))}",
        label=label,
        position=(float(box[0]), float(box[1]), float(box[2])),
        rotation=_turn(box),
        size=(float(box[3]), float(box[4]), float(box[5])),
        asset=word(row.get("model_uid")) or None,
    )


def _opening(kind: Any, k: int, box: np.ndarray) -> SourceOpening:
    """A door or window along the longer side of its box."""
    turn = _turn(box)
    axis = 0 if box[3] >= box[4] else 1
    half = turn[:, axis] * box[3 + axis] / 2
    a, b = box[:3] - half, box[:3] + half
    bottom = float(box[2] - box[5] / 2)
    return SourceOpening(
        name=f"{kind}_{k}",
        kind=kind,
        start=(float(a[0]), float(a[1])),
        end=(float(b[0]), float(b[1])),
        bottom=max(0.0, bottom),
        height=float(box[5]),
    )


def _floor(path: Path, notes: list[str]) -> tuple[tuple[float, float], ...] | None:
    """The outline of the floor's mesh, where it is there: its triangles that lie level."""
    file = path.parent / "StructureMesh" / "floor.glb"
    if not file.is_file():
        notes.append("StructureMesh/floor.glb is not beside the file, so there is no outline")
        return None
    mesh = read_mesh(file)
    vertices = np.asarray(mesh.vertices, dtype=float) @ Y_UP.T
    faces = np.asarray(mesh.faces)
    corners = vertices[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    level = faces[np.abs(normal[:, 2]) > LEVEL * np.maximum(length, 1e-12)]
    outline, left = of_triangles(vertices[:, :2], level)
    notes += left
    return None if outline is None else tuple((float(x), float(y)) for x, y in outline)


def _type_of(path: Path) -> str:
    """The kind of room of a path such as ``Layout_info/bathroom/0/layout.json``; scans have none."""
    parts = path.parent.parts
    return parts[-2].lower() if len(parts) > 1 and parts[-1].isdigit() else ""


FORMAT = SourceFormat(
    name="internscenes",
    title="InternScenes (layout.json)",
    matches=matches,
    read=read,
    notes=(
        "Read: layout.json with category, model_uid and bbox of each object; StructureMesh/floor.glb beside it gives "
        "the outline.",
        "Meaning: z up; bbox is centre, full extents and angles about the moving axes z, x, y; the front is the box's "
        "+x, as its models are turned.",
        "Assumed: the floor is at height 0; doors and windows among the objects lie in the wall next to them, where "
        "there is an outline (else they stay objects).",
        "Lost: walls, floors and ceilings among the objects; holes of the structure mesh; Infinigen models of "
        "InternScenes-Gen keep their box, though their mesh is already in place.",
    ),
    licence="as InternScenes and the sets that it draws on state",
)
