"""Swiss Dwellings and Modified Swiss Dwellings: a table (CSV) with a row an area or opening, its shape as WKT.

Columns: ``unit_id`` (or ``apartment_id``), ``entity_type`` (area, opening, separator, feature), ``entity_subtype``
(ROOM, KITCHEN, ..., DOOR, ENTRANCE_DOOR, WINDOW), ``geom`` or ``geometry`` (WKT, metres, y up), ``elevation``,
``height``, ``floor_id``; MSD adds ``roomtype``. Rows of one building follow one another. Pickles are never loaded.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, open_csv
from sceneweaver.io.messages import path_name, show

from ..line_plans import rooms_of
from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..outlines import middle_line, near_wall, of_shape
from ..values import LARGEST

ROOMS = {
    "room": "bedroom",
    "living_room": "living_room",
    "livingroom": "living_room",
    "living_dining": "living_dining",
    "kitchen_dining": "kitchen_diner",
    "corridor": "hallway",
    "corridors_and_halls": "hallway",
    "storeroom": "storage_room",
    "wash_and_dry_room": "laundry_room",
    "winter_garden": "sunroom",
    "patio": "terrace",
    "lobby": "entrance_hall",
    "garden": "terrace",
    "stairs": "stairs",
    "staircase": "stairs",
}
"""Words of the data set that mean another thing there than elsewhere; the others are plain."""

OPENINGS = {"DOOR": "door", "ENTRANCE_DOOR": "door", "WINDOW": "window"}
REACH = 0.45
TOILET = 2.2
"""A BATHROOM with less floor [m2] is a toilet: the data set has one word for both."""

MOST_ROWS = 200_000


@dataclass
class _Unit:
    """What the rows of one flat hold."""

    areas: list[tuple[str, Any, float, float | None]] = field(default_factory=list)


def matches(path: Path, head: bytes) -> bool:
    """A CSV with the columns of the data set."""
    first = head.split(b"\n", 1)[0]
    return b"entity_type" in first and b"entity_subtype" in first and (b"geom" in first)


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the table, flat after flat."""
    where = path_name(path)
    with open_csv(path) as rows:
        names = rows.fieldnames or []
        shape = next((n for n in ("geometry", "geom") if n in names), None)
        if shape is None or "entity_type" not in names or "entity_subtype" not in names:
            raise InputError(f"{where}: a column is missing; entity_type, entity_subtype and geom (WKT) are needed")
        unit = next((n for n in ("unit_id", "apartment_id") if n in names), None)
        if unit is None:
            raise InputError(f"{where}: neither unit_id nor apartment_id is a column; rows must say their flat")
        building = next((n for n in ("building_id", "site_id", "floor_id") if n in names), unit)
        some = False
        for _, group in groupby(enumerate(rows, 2), key=lambda r: r[1].get(building)):
            for room in _building(group, shape, unit, where):
                some = True
                if options.room in (None, room.name):
                    yield room
    if not some:
        raise InputError(f"{where}: no row is an area of a flat; entity_type 'area' with a {unit} is needed")


def _building(group: Any, shape: str, unit: str, where: str) -> Iterator[SourceRoom]:
    flats: dict[str, _Unit] = {}
    openings: list[tuple[float, SourceOpening]] = []
    for count, (number, row) in enumerate(group):
        if count > MOST_ROWS:
            raise InputError(f"{where}: row {number}: more than {MOST_ROWS} rows of one building")
        entity, kind = (row.get("entity_type") or "").lower(), (row.get("entity_subtype") or "").strip()
        if entity not in ("area", "opening"):
            continue
        elevation = _number(row, "elevation", number, where) or 0.0
        if entity == "opening":
            opening = _opening(row, kind, shape, number, where)
            if opening is not None:
                openings.append((elevation, opening))
            continue
        flat = (row.get(unit) or "").strip().removesuffix(".0")
        if not flat or flat.lower() in ("nan", "none"):
            continue
        found = _shape(row.get(shape) or "", number, where)
        word = (row.get("roomtype") or "") if kind.upper() in ("", "NOT_DEFINED") else kind
        height = _number(row, "height", number, where)
        flats.setdefault(flat, _Unit()).areas.append((word.lower(), found, elevation, height))
    for flat, held in flats.items():
        yield from _flat(flat, held, openings)


def _flat(flat: str, held: _Unit, openings: list[tuple[float, SourceOpening]]) -> Iterator[SourceRoom]:
    levels = sorted({elevation for _, _, elevation, _ in held.areas})
    counts: dict[str, int] = {}
    for word, found, elevation, height in held.areas:
        ring, notes = of_shape(found)
        kind = ROOMS.get(word, word or "room")
        if kind == "bathroom" and found.area < TOILET:
            kind = "guest_toilet"
        name = f"{kind}_{counts.setdefault(kind, 0)}"
        counts[kind] += 1
        if ring is None:
            continue
        near = [o for level, o in openings if level == elevation and near_wall(ring, o.start, o.end, REACH)]
        storey = "" if len(levels) == 1 else f"{levels.index(elevation)}"
        (room,) = rooms_of([(name, kind, ring)], near, REACH, notes, height=height, house=flat, storey=storey)
        yield room


def _opening(row: dict[str, str], kind: str, shape: str, number: int, where: str) -> SourceOpening | None:
    import shapely

    what = OPENINGS.get(kind.upper())
    if what is None:
        return None
    found = _shape(row.get(shape) or "", number, where)
    a, b, _ = middle_line(shapely.get_coordinates(found))
    height = _number(row, "height", number, where)
    return SourceOpening(
        name=f"{what}_{(row.get('area_id') or '').removesuffix('.0') or number}",
        kind=what,  # type: ignore[arg-type]
        start=(float(a[0]), float(a[1])),
        end=(float(b[0]), float(b[1])),
        height=height if height and height > 0.3 else None,
        bottom=0.9 if what == "window" else 0.0,
        leads_to="outside" if kind.upper() == "ENTRANCE_DOOR" else None,
    )


def _shape(text: str, number: int, where: str) -> Any:
    import numpy as np
    import shapely

    try:
        with np.errstate(invalid="ignore"):
            found = shapely.from_wkt(text)
    except (shapely.errors.ShapelyError, TypeError, ValueError):
        found = None
    if found is None or found.is_empty:
        raise InputError(f"{where}: row {number}: {show(text[:40])} is no WKT; give POLYGON ((x y, ...))")
    corners = shapely.get_coordinates(found)
    if not np.isfinite(corners).all() or np.abs(corners).max() > LARGEST:
        raise InputError(f"{where}: row {number}: a coordinate is not finite or too large; metres are needed")
    return found if found.is_valid else shapely.make_valid(found)


def _number(row: dict[str, str], key: str, number: int, where: str) -> float | None:
    text = (row.get(key) or "").strip()
    if not text or text.lower() == "nan":
        return None
    try:
        value = float(text)
    except ValueError:
        raise InputError(f"{where}: row {number}: {key} is {show(text)}; give metres") from None
    if not abs(value) <= LARGEST:
        raise InputError(f"{where}: row {number}: {key} is {text}; give metres")
    return value


FORMAT = SourceFormat(
    name="msd",
    title="Swiss Dwellings, MSD (CSV)",
    matches=matches,
    read=read,
    notes=(
        "Read: areas and openings of the table, shapes as WKT in metres; a flat is a unit_id, storeys by elevation; "
        "pickled graphs and pictures are not read.",
        "Meaning: areas are clear floors between walls; ROOM is taken for a bedroom; ENTRANCE_DOOR leads out of the "
        "flat. Flats that are turned from the axes are turned back where they become homes.",
        "Assumed: a BATHROOM of less than 2.2 m2 is a toilet; sills of windows (0.9 m) where the table has heights "
        "alone.",
        "Lost: separators (walls, railings), features (fixtures), areas that belong to no flat, such as stairwells.",
    ),
    licence="CC BY 4.0 (Swiss Dwellings)",
)
