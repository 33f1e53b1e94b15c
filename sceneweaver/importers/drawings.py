"""Simple drawings, from SVG or DXF: closed shapes are rooms, lines are walls, doors, windows and dimensions.

What an element is, its own words say (id, class, label, title; in DXF its layer), else those of the groups it is in.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import shapely

from sceneweaver.io import InputError
from sceneweaver.io.messages import show

from .line_plans import MOST_LINES, Label, enclosed, labelled, numbered, rooms_of
from .model import SourceOpening, SourceRoom
from .outlines import middle_line
from .plan_types import known_type
from .values import LARGEST

Role = Literal["room", "wall", "door", "window", "entrance", "passage", "dimension"]

ROLES: dict[str, Role] = {
    "room": "room",
    "rooms": "room",
    "space": "room",
    "spaces": "room",
    "wall": "wall",
    "walls": "wall",
    "door": "door",
    "doors": "door",
    "window": "window",
    "windows": "window",
    "glaz": "window",
    "glazing": "window",
    "entrance": "entrance",
    "entrances": "entrance",
    "entry": "entrance",
    "passage": "passage",
    "passages": "passage",
    "opening": "passage",
    "openings": "passage",
    "dimension": "dimension",
    "dimensions": "dimension",
    "dim": "dimension",
    "dims": "dimension",
    "scale": "dimension",
}
"""Words of elements and layers by what they mean; "front door" and "main door" mean the entrance."""

REACH = 0.35
"""Farthest [m] of a door or window from the face of the wall that it lies in."""

MEET = 0.05
"""Ends of walls nearer than this [m] meet."""

WIDE = 0.4
"""What walls enclose and is nowhere so wide [m] is a wall between its two faces."""


@dataclass(frozen=True, eq=False)
class Drawn:
    """An element: what it is called in errors, its words from its own outwards, its points [n, 2], whether closed."""

    name: str
    words: tuple[str, ...]
    points: np.ndarray
    closed: bool


@dataclass
class Drawing:
    """The elements of a drawing with y up, the texts in it, and metres for a unit where the file says so."""

    where: str
    elements: list[Drawn] = field(default_factory=list)
    texts: list[Label] = field(default_factory=list)
    unit: float | None = None
    said: str = ""
    notes: list[str] = field(default_factory=list)


def role_of(words: Sequence[str], closed: bool) -> tuple[Role | None, str]:
    """What an element with these words is, and its type where it is a room: the first word that says something."""
    for k, word in enumerate(words):
        kind = known_type(word)
        parts = [p for p in re.split(r"[^a-z]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", word).lower()) if p]
        if {"front", "main", "entrance"} & {*parts} and {"door", "doors"} & {*parts}:
            return "entrance", ""  # "front door"
        if kind is not None and kind != "room" and closed:
            return "room", kind
        found: Role | None = next((ROLES[p] for p in parts if p in ROLES), None)
        if found == "room":
            own = [known_type(w) for w in words[:k]]
            return "room", next((t for t in own if t), "")
        if found is not None and not (closed and found == "entrance"):
            return found, ""
    return None, ""


def rooms_of_drawing(drawing: Drawing, scale: float | None) -> list[SourceRoom]:
    """The rooms of a drawing with the openings in their walls.

    Args:
        drawing: with y up.
        scale: metres for a unit, as the user says it; None: as the drawing does.

    Raises:
        InputError: nothing says how large a unit is; no room in it; an element that cannot be what it is called.
    """
    where = drawing.where
    if len(drawing.elements) + len(drawing.texts) > MOST_LINES:
        raise InputError(f"{where}: {len(drawing.elements)} elements; at most {MOST_LINES} are read")
    sorted_in: dict[Role, list[tuple[Drawn, str]]] = {}
    passed = 0
    for element in drawing.elements:
        if not np.isfinite(element.points).all() or np.abs(element.points).max() > LARGEST:
            raise InputError(f"{where}: {element.name}: a coordinate is not finite or too large; is the unit right?")
        role, kind = role_of(element.words, element.closed)
        passed += role is None
        if role is not None:
            sorted_in.setdefault(role, []).append((element, kind))
    unit, said = _unit(drawing, [e for e, _ in sorted_in.get("dimension", [])], scale)
    notes = [said, *drawing.notes]
    if passed:
        notes.append(f"{passed} elements passed over: no word of theirs is a room's, wall, door, window or dimension")
    rooms = _shapes(sorted_in.get("room", []), unit, where)
    rooms = rooms or _between(sorted_in.get("wall", []), unit, where)
    if not rooms:
        raise InputError(
            f"{where}: no room in it; draw closed shapes named by their rooms, such as id='bedroom', or lines in a "
            "layer 'walls' that meet at their ends"
        )
    rings = [ring for _, ring in rooms]
    texts = [Label(t.text, (t.point[0] * unit, t.point[1] * unit)) for t in drawing.texts]
    kinds = [
        kind or next((t for t in map(known_type, written) if t), written[0] if written else "room")
        for (kind, _), written in zip(rooms, labelled(rings, texts), strict=True)
    ]
    openings = [
        opening
        for role in ("entrance", "door", "passage", "window")
        for k, (element, _) in enumerate(sorted_in.get(role, []))
        for opening in [_opening(element, role, k, unit, where)]
    ]
    names = numbered([re.sub(r"\W+", "_", kind).strip("_").lower() for kind in kinds])
    listed = [(name, kind, ring) for name, kind, ring in zip(names, kinds, rings, strict=True)]
    made = rooms_of(listed, openings, REACH, notes)
    held = {o.name for room in made for o in room.openings}
    lost = next((o for o in openings if o.name not in held), None)
    if lost is not None:
        raise InputError(
            f"{where}: {lost.name}: lies in no wall of a room; move it to within {REACH:g} m of one, along it"
        )
    return made


def _shapes(found: Sequence[tuple[Drawn, str]], unit: float, where: str) -> list[tuple[str, np.ndarray]]:
    rooms = []
    for element, kind in found:
        if not element.closed:
            raise InputError(f"{where}: {element.name}: a room must be closed; end it where it begins")
        shape = shapely.Polygon(element.points * unit)
        if not shape.is_valid or shape.area <= 0:
            raise InputError(f"{where}: {element.name}: its outline crosses itself; give its corners in order")
        rooms.append((kind, element.points * unit))
    return rooms


def _between(found: Sequence[tuple[Drawn, str]], unit: float, where: str) -> list[tuple[str, np.ndarray]]:
    """What the lines of walls enclose."""
    lines = [
        (*a, *b)
        for element, _ in found
        for a, b in zip(
            element.points * unit,
            np.roll(element.points * unit, -1, axis=0)[: None if element.closed else -1],
            strict=False,
        )
    ]
    if not lines:
        return []
    if len(lines) > MOST_LINES:
        raise InputError(f"{where}: {len(lines)} lines of walls; at most {MOST_LINES} are read")
    rings = [ring for ring in enclosed(np.array(lines), MEET) if not shapely.Polygon(ring).buffer(-WIDE / 2).is_empty]
    if not rings:
        raise InputError(
            f"{where}: its {len(lines)} lines of walls enclose no room; let their ends meet within {MEET:g} m"
        )
    return [("", ring) for ring in rings]


def _opening(element: Drawn, role: Role, number: int, unit: float, where: str) -> SourceOpening:
    a, b, _ = middle_line(element.points * unit)
    if math.dist(a, b) < 1e-6:
        raise InputError(f"{where}: {element.name}: a {role} must have a length; draw it along its wall")
    kind = {"entrance": "door", "door": "door", "window": "window", "passage": "passage"}[role]
    return SourceOpening(
        name=element.name or f"{role}_{number}",
        kind=kind,  # type: ignore[arg-type]
        start=(float(a[0]), float(a[1])),
        end=(float(b[0]), float(b[1])),
        leads_to="outside" if role == "entrance" else None,
    )


def length_of(text: str) -> float | None:
    """The length [m] that a text states: "4.2 m", "420 cm", "4200"; plain numbers from 100 on are millimetres.

    Examples:
        >>> length_of("4,2 m"), length_of("4200"), length_of("3.5"), length_of("bedroom")
        (4.2, 4.2, 3.5, None)
    """
    found = re.search(r"(\d+(?:[.,]\d+)?)\s*(mm|cm|m|ft|in)?\b", text.strip().lower())
    if not found:
        return None
    value = float(found[1].replace(",", "."))
    of = {"mm": 0.001, "cm": 0.01, "m": 1.0, "ft": 0.3048, "in": 0.0254}
    return value * (of[found[2]] if found[2] else 0.001 if value >= 100 else 1.0) or None


def _unit(drawing: Drawing, dimensions: Sequence[Drawn], scale: float | None) -> tuple[float, str]:
    """Metres of a unit, and how that is known: as given, by a dimension, or as the file says."""
    if scale is not None:
        return scale, f"a unit is {scale:g} m, as given"
    for element in dimensions:
        if len(element.points) < 2:
            continue
        a, b, _ = middle_line(element.points)
        near = sorted(drawing.texts, key=lambda t: math.dist(t.point, (a + b) / 2))[:1]
        stated = next((n for w in (*element.words, *(t.text for t in near)) if (n := length_of(w))), None)
        if stated is None:
            raise InputError(
                f"{drawing.where}: {element.name}: a dimension must say its length; add a title or text such as '4.2 m'"
            )
        if math.dist(a, b) < 1e-9:
            raise InputError(f"{drawing.where}: {element.name}: a dimension must have a length")
        unit = stated / math.dist(a, b)
        return unit, f"a unit is {unit:.6g} m, by the dimension {show(f'{stated:g} m')} of {element.name}"
    if drawing.unit is not None:
        return drawing.unit, drawing.said
    raise InputError(
        f"{drawing.where}: nothing says how large a unit is; give --scale (metres for a unit), or draw a line in a "
        "layer 'dimension' with its length as its text, such as '4.2 m'"
    )
