"""PhyScene: the three files that it writes, in the frame of `sceneweaver.importers.box_sets`.

(a) Sampled rooms: lists ``[room][slot][..]`` of class_labels, translations, sizes (half), angles, objfeats_32 and
objectness, with scene_ids. (b) One room with the models that were chosen, ``{"ThreedFront" | "GPN": {jid: [...]}}``:
``position`` is the translation minus the model's ``centroid``, so the place of the model's ORIGIN, not of its box;
centre = position + centroid. Half extents are ``size`` for ThreedFront (its ``query_size`` is halved once more), and
``query_size`` for GPN, whose models are stretched to it. (c) ``*_bbox.json``: boxes with ``position`` (centre),
``scale`` (half) and ``theta``, ``floor_center`` [3] and ``door_box``: rows (x, z, y, and full lengths along them, 0),
where y is up and the lengths along x and z are those of the square that the leaf sweeps, so that the door's wall is the
one nearest. The floor's mesh, ``room_<k>.obj``, lies beside it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.geometry.walls import walls_of
from sceneweaver.io import InputError, read_mesh
from sceneweaver.io.messages import path_name

from ..box_files import is_archive, load_arrays, members
from ..box_sets import PADDING, rotation_of, size_of, thing
from ..frames import Y_UP
from ..model import ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..outlines import of_triangles
from ..sampled import read_sampled
from ..values import keys_seen, mapping, member, number, numbers, positive, sequence, word

SETS = ("ThreedFront", "GPN")


def matches(path: Path, head: bytes) -> bool:
    """Any of the three files."""
    if is_archive(path, head):
        names = members(path)
        return {"class_labels", "translations"} <= names and bool({"objectness", "scene_ids"} & names)
    if path.suffix.lower() != ".json" or head.lstrip()[:1] != b"{":
        return False
    names = keys_seen(head)
    sampled = bool({"class_labels", "translations"} & names) and bool(
        {"objectness", "scene_ids", "objfeats_32"} & names
    )
    return sampled or bool(set(SETS) & names) or ({"objects", "theta"} <= names and path.stem.endswith("_bbox"))


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its rooms: many of (a), one of (b) and (c)."""
    where = path_name(path)
    data = load_arrays(path)
    if "objects" in data:
        yield _boxes(path, data, where, options)
    elif any(name in data for name in SETS):
        yield _models(path, data, where)
    elif "translations" in data or "class_labels" in data:
        yield from read_sampled(path, options, data)
    else:
        raise InputError(f"{where}: neither class_labels, ThreedFront, GPN nor objects; is this a file of PhyScene?")


def _models(path: Path, data: Mapping[str, Any], where: str) -> SourceRoom:
    """(b): models that were chosen."""
    objects: list[SourceObject] = []
    without = 0
    for name in SETS:
        for jid, rows in mapping(data.get(name, {}), f"{where}: {name}").items():
            for k, row in enumerate(sequence(rows, f"{where}: {name}.{jid}")):
                place = f"{where}: {name}.{jid}[{k}]"
                found = _model(name, str(jid), row, place, f"{len(objects)}")
                without += found.anchor == "bottom"
                objects.append(found)
    notes = ["the file has no outline, doors or windows"]
    if without:
        notes.append(f"{without} models have no centroid: their origin is taken for the middle of their bottom")
    return SourceRoom(name=path.stem, type=_type_in(path.stem), objects=tuple(objects), notes=tuple(notes))


def _model(name: str, jid: str, row: Any, place: str, number_: str) -> SourceObject:
    origin = numbers(member(row, "position", place), (3,), f"{place}: position")
    angle = number(member(row, "theta", place), f"{place}: theta")
    label = word(row.get("query_label")) or word(member(row, "label", place), "object")
    key = "query_size" if name == "GPN" and "query_size" in row else "size"
    half = positive(row[key], f"{place}: {key}") if key in row else None
    keep = {key: row[key] for key in ("scale", "path") if key in row}
    if half is not None and "centroid" in row:
        centre = origin + numbers(row["centroid"], (3,), f"{place}: centroid")
        return thing(f"{label}_{number_}", label, centre, half, angle, asset=jid, keep=keep)
    x, y, z = (Y_UP @ origin).tolist()
    return SourceObject(
        name=f"{label}_{number_}",
        label=label,
        position=(x, y, z),
        anchor="bottom",
        rotation=rotation_of(angle),
        size=None if half is None else size_of(half),
        asset=jid,
        keep=keep,
    )


def _boxes(path: Path, data: Mapping[str, Any], where: str, options: ReadOptions) -> SourceRoom:
    """(c): boxes, with the floor's mesh where it lies beside them."""
    objects = []
    for k, row in enumerate(sequence(data["objects"], f"{where}: objects")):
        place = f"{where}: objects[{k}]"
        label = word(member(row, "label", place), "object")
        if label in PADDING:
            continue
        centre = numbers(member(row, "position", place), (3,), f"{place}: position")
        half = positive(member(row, "scale", place), f"{place}: scale")
        if "theta" in row:
            angle = number(row["theta"], f"{place}: theta")
        else:
            angle = float(np.radians(number(member(row, "rot_degree", place), f"{place}: rot_degree")))
        objects.append(thing(f"{label}_{k}", label, centre, half, angle))
    notes: list[str] = []
    outline = _floor(path, data, where, options, notes)
    doors: tuple[SourceOpening, ...] = ()
    if "door_box" in data:
        rows = numbers(data["door_box"], (None, 7), f"{where}: door_box")
        if outline is not None:
            doors = tuple(_door(row, k, outline) for k, row in enumerate(rows))
        elif len(rows):
            notes.append(f"{len(rows)} doors left out: they have no wall without the floor's mesh (room_<k>.obj)")
    return SourceRoom(
        name=path.stem, type=_type_in(path.stem), outline=outline, openings=doors, objects=tuple(objects),
        notes=tuple(notes),
    )  # fmt: skip


def _floor(
    path: Path, data: Mapping[str, Any], where: str, options: ReadOptions, notes: list[str]
) -> tuple[tuple[float, float], ...] | None:
    """The outline of ``room_<k>.obj`` about ``floor_center``, where such a file is there."""
    room = re.search(r"room_\d+", path.stem)
    folders = [path.parent, *([options.folder] if options.folder else [])]
    file = next((f / f"{room[0]}.obj" for f in folders if room and (f / f"{room[0]}.obj").is_file()), None)
    if file is None:
        notes.append("the floor's mesh (room_<k>.obj) is not beside the file, so there is no outline")
        return None
    mesh = read_mesh(file)
    vertices = np.asarray(mesh.vertices, dtype=float)
    centre = numbers(member(data, "floor_center", where), (3,), f"{where}: floor_center")
    corners, left = of_triangles(((vertices - centre) @ Y_UP.T)[:, :2], np.asarray(mesh.faces))
    notes += left
    return None if corners is None else tuple((float(x), float(y)) for x, y in corners)


def _door(row: np.ndarray, k: int, outline: tuple[tuple[float, float], ...]) -> SourceOpening:
    """The door of a row (x, z, y, lengths along them): on the nearest wall, as wide as its square."""
    at = np.array([row[0], -row[1]])
    width, height = float(max(row[3], row[4])), float(row[5])

    def away(wall: Any) -> float:
        along, across = wall.coordinates(at)
        return float(np.hypot(max(-along, along - wall.length, 0.0), across))

    wall = min(walls_of(outline), key=away)
    along, _ = wall.coordinates(at)
    a, b = wall.point(along - width / 2, 0.0), wall.point(along + width / 2, 0.0)
    return SourceOpening(
        name=f"door_{k}", kind="door", start=(float(a[0]), float(a[1])), end=(float(b[0]), float(b[1])),
        height=height if height > 0 else None,
    )  # fmt: skip


def _type_in(stem: str) -> str:
    """ "bedroom" of a name such as House_12_room_3_bedroom_bbox or <house>_LivingRoom-77."""
    found = re.search(r"(bed|living|dining)[ _]?room", stem, re.IGNORECASE)
    return found[0].lower().replace(" ", "").replace("_", "") if found else ""


FORMAT = SourceFormat(
    name="physcene",
    title="PhyScene",
    matches=matches,
    read=read,
    notes=(
        "Read: sampled rooms (.npz or .json; names of the classes from dataset_stats.txt), a room with its models "
        '("ThreedFront", "GPN"), and *_bbox.json with the floor\'s room_<k>.obj beside it.',
        "Meaning: y up, half extents, the front along +z; a model's position is that of its origin, and its centroid "
        "is added; coordinates are relative to the centre of the floor.",
        "Assumed: a door of *_bbox.json lies in the wall nearest to it; a model without centroid stands on its origin; "
        "of 3D-FUTURE models the size is 'size' (what was asked for, query_size, is halved twice in the file).",
        "Sampled rooms have an outline where --asset-folder is the folder of <room>/boxes.npz that scene_ids name.",
        "Lost: the outline where the floor's mesh is not there, windows, features, joints of GAPartNet models.",
    ),
    licence="3D-FRONT's terms of use",
    priority=2,
)
