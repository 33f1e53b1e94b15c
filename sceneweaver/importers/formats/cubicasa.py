"""CubiCasa5K: floor plans as SVG, ``model.svg``: rooms with doors and windows; there is no loose furniture in it.

Groups by class: ``Space <Type>`` with a polygon is a room; ``Door ...`` and ``Window ...``, with the polygon of the
hole in the wall as their first, stand in a group of a ``Wall``. Units are pixels with y DOWN, and no file says how
large one is: doors are about 0.8 m wide, so the middle width of a plan's doors is taken for that; 0.01 m where there is
no door.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, load_xml
from sceneweaver.io.messages import path_name, show

from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..outlines import middle_line, near_wall
from ..svg_text import NUMBER, matrix_of, tag
from ..values import LARGEST

DOOR = 0.8
"""Width [m] of the middle door of a plan."""

UNIT = 0.01
"""Metres of a unit in a plan without doors."""

MOST = 2000
"""Rooms, doors and windows of a plan."""

REACH = 0.45  # [m] from the middle of an opening to the face of its wall
LEAST = 0.3  # [m2] least room
_CAPITAL = re.compile(r"(?<=[a-z])(?=[A-Z])")


def matches(path: Path, head: bytes) -> bool:
    """An SVG with rooms as CubiCasa names them."""
    return b"<svg" in head and (b'class="Space ' in head or (b'"Wall' in head and b"Floorplan" in head))


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the plan, in its order."""
    where = path_name(path)
    root = load_xml(path)
    if tag(root) != "svg":
        raise InputError(f"{where}: <{tag(root)}> is no <svg>; give CubiCasa's model.svg")
    spaces: list[tuple[str, np.ndarray, str]] = []
    holes: list[tuple[Any, np.ndarray]] = []
    fixtures = _walk(root, spaces, holes, where)
    if not spaces:
        raise InputError(f'{where}: no room in it; rooms are groups with class="Space ..." and a polygon')
    if len(spaces) + len(holes) > MOST:
        raise InputError(f"{where}: {len(spaces)} rooms and {len(holes)} openings; at most {MOST} are read")
    unit, said = _unit(holes, options.scale)
    rooms = [(kind, corners * np.array([unit, -unit]), storey) for kind, corners, storey in spaces]
    middles = [(kind, *middle_line(corners * np.array([unit, -unit]))) for kind, corners in holes]
    counts: dict[str, int] = {}
    for kind, ring, storey in rooms:
        area = abs(float(_area(ring)))
        words = _CAPITAL.sub("_", kind).lower()
        name = f"{words}_{counts.setdefault(words, 0)}"
        counts[words] += 1
        if area < LEAST or (options.room is not None and options.room != name):
            continue
        notes = [said]
        if fixtures:
            listed = ", ".join(f"{n} {name}" for name, n in sorted(fixtures.items()))
            notes.append(f"fixtures of the plan are left out: {listed}")
        yield SourceRoom(
            name=name,
            type=words,
            outline=tuple((float(x), float(y)) for x, y in ring),
            openings=tuple(
                SourceOpening(
                    name=f"{what}_{k}",
                    kind=what,
                    start=(float(a[0]), float(a[1])),
                    end=(float(b[0]), float(b[1])),
                )
                for k, (what, a, b, thick) in enumerate(middles)
                if near_wall(ring, a, b, max(REACH, thick))
            ),
            notes=tuple(notes),
            storey=storey,
        )


def _walk(
    root: Any, spaces: list[tuple[str, np.ndarray, str]], holes: list[tuple[Any, np.ndarray]], where: str
) -> dict[str, int]:
    """Fills rooms, and doors and windows, with their corners [n, 2] in the picture; returns fixtures by type."""
    fixtures: dict[str, int] = {}
    left = [(root, np.eye(3), "")]
    while left:
        element, above, storey = left.pop()
        turn = above @ matrix_of(element.get("transform", ""), where)
        if tag(element) in ("defs", "symbol"):
            continue
        inner = [child for child in element if isinstance(child.tag, str)]
        kinds = (element.get("class") or element.get("id") or "").split()
        kind = kinds[0] if kinds and tag(element) == "g" else ""
        if kind == "Floorplan" and len(kinds) > 1:
            storey = kinds[1]  # "Floorplan Floor-1"
        if kind == "Space":
            corners = _polygon(inner, turn, where)
            if corners is not None:
                spaces.append((kinds[1] if len(kinds) > 1 else "Room", corners, storey))
        elif kind in ("Door", "Window"):
            corners = _polygon(inner, turn, where)
            if corners is not None:
                holes.append((kind.lower(), corners))
            continue
        elif kind == "FixedFurniture":
            name = kinds[1] if len(kinds) > 1 else "other"
            fixtures[name] = fixtures.get(name, 0) + 1
            continue
        left.extend((child, turn, storey) for child in reversed(inner))
    return fixtures


def _polygon(children: list[Any], turn: np.ndarray, where: str) -> np.ndarray | None:
    """The corners of the first polygon among elements, moved by a matrix [3, 3]."""
    element = next((child for child in children if tag(child) == "polygon"), None)
    if element is None:
        return None
    text = element.get("points") or ""
    if re.search(r"nan|inf", text, re.IGNORECASE):
        raise InputError(f"{where}: points {show(text[:40])}: numbers must be finite")
    values = [float(v) for v in NUMBER.findall(text)]
    if re.sub(r"[\s,]", "", NUMBER.sub("", text)) or len(values) < 6 or len(values) % 2:
        raise InputError(f"{where}: points {show(text[:40])}: x,y pairs of three corners or more are needed")
    if max(map(abs, values)) > LARGEST:
        raise InputError(f"{where}: points {show(text[:40])}: too large for a plan")
    corners = np.array(values).reshape(-1, 2)
    moved = corners @ (turn @ matrix_of(element.get("transform", ""), where))[:2, :2].T
    moved = moved + (turn @ matrix_of(element.get("transform", ""), where))[:2, 2]
    return moved[:-1] if (np.abs(moved[0] - moved[-1]) < 1e-9).all() and len(moved) > 3 else moved


def _unit(holes: list[tuple[Any, np.ndarray]], scale: float | None) -> tuple[float, str]:
    """Metres of a unit, and how that was found."""
    if scale is not None:
        return scale, f"a unit is {scale:g} m, as given"
    widths = sorted(float(np.hypot(*(b - a))) for kind, c in holes if kind == "door" for a, b, _ in [middle_line(c)])
    widths = [width for width in widths if width > 0]
    if not widths:
        return UNIT, f"nothing says how large a unit is, and there is no door: {UNIT:g} m is assumed"
    middle = widths[len(widths) // 2] if len(widths) % 2 else sum(widths[len(widths) // 2 - 1 :][:2]) / 2
    unit = DOOR / middle
    return (
        unit,
        f"nothing says how large a unit is: the middle door is taken for {DOOR:g} m wide, a unit for {unit:.6g} m",
    )


def _area(ring: np.ndarray) -> float:
    from sceneweaver.geometry.polygons import signed_area

    return signed_area(ring)


FORMAT = SourceFormat(
    name="cubicasa",
    title="CubiCasa5K (SVG)",
    matches=matches,
    read=read,
    notes=(
        "Read: model.svg: a room a Space with its type and outline, doors and windows of the walls; entities and "
        "document types are refused.",
        "Meaning: y down; the hole's polygon is turned into a line along its longer side in the middle of the wall. "
        "Rooms keep their places in the plan.",
        "Assumed: the scale, which no file states: the middle width of the plan's doors is 0.8 m (a note has the "
        "figure); heights of doors and windows.",
        "Lost: fixed furniture (a note counts it), swings of doors, railings, stairs, texts.",
    ),
    licence="CC BY-NC 4.0 (CubiCasa5K)",
)
