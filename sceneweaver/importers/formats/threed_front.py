"""3D-FRONT: houses as published, one JSON each, with 3D-FUTURE's models in a folder where the user has them.

``furniture`` and ``mesh`` are tables by uid; ``scene.room[].children[]`` place them: ``pos``, ``rot`` (quaternion x, y,
z, w) and ``scale`` of the model's own origin. Frame: metres, right-handed, y up; models face +z and stand on their
origin. The floor's outline is the union of the room's meshes of type Floor; doors and windows are meshes as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, named_inside
from sceneweaver.io.messages import path_name

from ..frames import Y_UP, facing, quaternion_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..outlines import middle_line, near_wall, of_triangles
from ..values import keys_seen, loaded, mapping, member, numbers, sequence, word

MODELS = ("raw_model.obj", "normalized_model.obj")
REACH = 0.5  # [m] from the middle of a door's mesh to the face of its wall
_HANGING = re.compile(r"pendant|ceiling|chandelier")
OPENINGS = {"door": "door", "window": "window", "pocket": "passage"}


def matches(path: Path, head: bytes) -> bool:
    """JSON with furniture by jid and version or job of the design."""
    if head.lstrip()[:1] != b"{":
        return False
    names = keys_seen(head)
    return {"furniture", "jid"} <= names and bool({"design_version", "code_version", "jobid", "north_vector"} & names)


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the house, in its order."""
    where = path_name(path)
    data = loaded(path)
    furniture = _by_uid(data, "furniture", where)
    meshes = _by_uid(data, "mesh", where, needed=False)
    categories = _categories(options.folder)
    scene = member(data, "scene", where)
    for k, room in enumerate(sequence(member(scene, "room", f"{where}: scene"), f"{where}: scene.room")):
        place = f"{where}: scene.room[{k}]"
        name = word(member(room, "instanceid", place), f"room_{k}")
        if options.room is None or options.room == name:
            yield _room(room, name, furniture, meshes, categories, options.folder, place)


def _by_uid(data: Any, key: str, where: str, *, needed: bool = True) -> dict[str, Mapping[str, Any]]:
    rows = member(data, key, where) if needed else mapping(data, where).get(key, [])
    found = {}
    for k, row in enumerate(sequence(rows, f"{where}: {key}")):
        found[str(member(row, "uid", f"{where}: {key}[{k}]"))] = row
    return found


def _categories(folder: Path | None) -> dict[str, str]:
    """Category of each model by its id, from model_info.json of 3D-FUTURE where it is there."""
    file = folder / "model_info.json" if folder else None
    if file is None or not file.is_file():
        return {}
    found = {}
    for row in sequence(loaded(file), path_name(file)):
        row = mapping(row, path_name(file))
        label = word(row.get("category")) or word(row.get("super-category"))
        # "Lounge Chair / Cafe Chair / Office Chair": the first says it
        found[word(row.get("model_id"))] = label.split("/")[0].strip().lower()
    return found


def _room(
    room: Mapping[str, Any],
    name: str,
    furniture: Mapping[str, Mapping[str, Any]],
    meshes: Mapping[str, Mapping[str, Any]],
    categories: Mapping[str, str],
    folder: Path | None,
    place: str,
) -> SourceRoom:
    notes: list[str] = []
    objects: list[SourceObject] = []
    shell: list[tuple[str, np.ndarray, np.ndarray]] = []
    unknown = invalid = 0
    for k, child in enumerate(sequence(room.get("children", []), f"{place}: children")):
        at = f"{place}.children[{k}]"
        ref = str(member(child, "ref", at))
        if ref in furniture:
            if furniture[ref].get("valid", True) is False:
                invalid += 1
                continue
            objects.append(_object(child, furniture[ref], categories, folder, at, len(objects)))
        elif ref in meshes:
            shell.append(_mesh(child, meshes[ref], at))
        else:
            unknown += 1
    if invalid:
        notes.append(f"{invalid} pieces of furniture that the file marks as invalid are left out")
    if unknown:
        notes.append(f"{unknown} children left out: nothing in the house has their ref")
    outline, floor, height = _shell(shell, notes)
    openings = _openings(shell, outline, floor)
    if abs(floor) > 1e-9:
        notes.append(f"the floor lies at {floor:g} m in the house; it is moved to 0")
        objects = [_lowered(thing, floor) for thing in objects]
    return SourceRoom(
        name=name,
        type=word(room.get("type")).lower(),
        outline=outline,
        height=height,
        openings=openings,
        objects=tuple(objects),
        notes=tuple(notes),
    )


def _lowered(thing: SourceObject, floor: float) -> SourceObject:
    x, y, z = thing.position
    return replace(thing, position=(x, y, z - floor))


def _placed(child: Mapping[str, Any], at: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, rotation matrix and scale of a child, in its frame."""
    position = numbers(member(child, "pos", at), (3,), f"{at}: pos")
    four = numbers(member(child, "rot", at), (4,), f"{at}: rot")
    scale = numbers(child.get("scale", [1, 1, 1]), (3,), f"{at}: scale")
    try:
        turn = quaternion_matrix(four.tolist())
    except ValueError:
        raise InputError(f"{at}: rot: a quaternion of length 0; give x, y, z, w") from None
    if (np.abs(scale) < 1e-5).any():
        raise InputError(f"{at}: scale: {np.abs(scale).min():g} flattens the model")
    return position, turn, scale


def _object(
    child: Mapping[str, Any],
    row: Mapping[str, Any],
    categories: Mapping[str, str],
    folder: Path | None,
    at: str,
    k: int,
) -> SourceObject:
    position, turn, scale = _placed(child, at)
    jid = word(row.get("jid"))
    title = word(row.get("title")) or word(row.get("category"))
    label = categories.get(jid) or title.rpartition("/")[2].strip() or "object"
    mesh = _model(folder, jid)
    box = row.get("bbox") if isinstance(row.get("bbox"), list) else row.get("size")
    size = None
    if mesh is None and isinstance(box, list) and box:
        full = numbers(box, (3,), f"{at}: size of its furniture") * np.abs(scale)
        if (full > 0).all():
            size = (float(full[2]), float(full[0]), float(full[1]))
    x, y, z = (Y_UP @ position).tolist()
    return SourceObject(
        name=f"{label.replace(' ', '_')}_{k}",
        label=label,
        position=(x, y, z),
        anchor="bottom" if mesh is None else "origin",
        rotation=Y_UP @ turn @ facing("z", "y").T,
        size=size,
        asset=jid or None,
        mesh=mesh,
        mesh_axes=facing("z", "y"),
        scale=(float(abs(scale[0])), float(abs(scale[1])), float(abs(scale[2]))),
        mount="ceiling" if _HANGING.search(f"{title} {label}".lower()) else None,
        keep={"uid": str(row.get("uid"))},
    )


def _model(folder: Path | None, jid: str) -> Path | None:
    """The mesh of a model, in the user's folder only."""
    if folder is None or not jid:
        return None
    files = (named_inside(folder, folder / jid / name) for name in MODELS)
    return next((file for file in files if file is not None and file.is_file()), None)


def _mesh(child: Mapping[str, Any], row: Mapping[str, Any], at: str) -> tuple[str, np.ndarray, np.ndarray]:
    """Type, vertices [n, 3] in our frame and faces [m, 3] of a mesh of the shell."""
    position, turn, scale = _placed(child, at)
    flat = numbers(row.get("xyz", []), (None,), f"{at}: xyz of its mesh")
    faces = numbers(row.get("faces", []), (None,), f"{at}: faces of its mesh").astype(np.int64)
    if len(flat) % 3 or len(faces) % 3:
        raise InputError(f"{at}: xyz and faces of its mesh are threes of numbers")
    vertices, triangles = flat.reshape(-1, 3), faces.reshape(-1, 3)
    if len(triangles) and not 0 <= triangles.min() <= triangles.max() < len(vertices):
        raise InputError(f"{at}: faces of its mesh name {int(triangles.max())} of {len(vertices)} vertices")
    return str(row.get("type", "")), ((vertices * scale) @ turn.T + position) @ Y_UP.T, triangles


def _shell(
    shell: list[tuple[str, np.ndarray, np.ndarray]], notes: list[str]
) -> tuple[tuple[tuple[float, float], ...] | None, float, float | None]:
    """Outline, height of the floor [m] and height of the room [m]."""
    floors = [(v, f) for kind, v, f in shell if kind.lower() == "floor" and len(f)]
    if not floors:
        notes.append("the room has no mesh of type Floor, so there is no outline")
        return None, 0.0, None
    starts = np.cumsum([0, *(len(v) for v, _ in floors)])
    vertices = np.concatenate([v for v, _ in floors])
    faces = np.concatenate([f + start for (_, f), start in zip(floors, starts, strict=False)])
    corners, left = of_triangles(vertices[:, :2], faces)
    notes += left
    floor = float(vertices[:, 2].min())
    tops = [float(v[:, 2].max()) for kind, v, f in shell if kind.lower() in ("wallinner", "ceiling") and len(f)]
    height = max(tops) - floor if tops else None
    if corners is None:
        return None, floor, height
    return tuple((float(x), float(y)) for x, y in corners), floor, height if height and height > 0.5 else None


def _openings(
    shell: list[tuple[str, np.ndarray, np.ndarray]], outline: tuple[tuple[float, float], ...] | None, floor: float
) -> tuple[SourceOpening, ...]:
    found = []
    for kind, vertices, faces in shell:
        what: Any = OPENINGS.get(kind.lower())
        if what is None or outline is None or not len(faces):
            continue
        a, b, _ = middle_line(vertices[:, :2])
        low, high = float(vertices[:, 2].min()) - floor, float(vertices[:, 2].max()) - floor
        if not near_wall(outline, a, b, REACH):
            continue
        found.append(
            SourceOpening(
                name=f"{what}_{len(found)}",
                kind=what,
                start=(float(a[0]), float(a[1])),
                end=(float(b[0]), float(b[1])),
                bottom=max(0.0, low),
                height=high - max(0.0, low) if high > low else None,
            )
        )
    return tuple(found)


FORMAT = SourceFormat(
    name="3dfront",
    title="3D-FRONT",
    matches=matches,
    read=read,
    notes=(
        "Read: a house's JSON, every room of it; --asset-folder is the folder of 3D-FUTURE's models: categories from "
        "model_info.json, sizes and centres from <jid>/raw_model.obj.",
        "Meaning: y up, quaternions x, y, z, w of the model, which faces +z; positions are of the model's origin; "
        "scale multiplies the model. Rooms stay where they are in the house.",
        "Assumed: without the models, a model stands on its origin and has the size (full extents, before scale) that "
        "the house states; the outline is the union of the meshes of type Floor; a Door or Window mesh lies in the "
        "wall next to it; pendant and ceiling lamps hang from the ceiling.",
        "Lost: furniture marked invalid, materials, mirrored scales (their sign), extra meshes such as skirting.",
    ),
    licence="3D-FRONT's and 3D-FUTURE's terms of use",
    priority=1,
)
