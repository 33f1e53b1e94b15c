"""A plan as DXF, by layers: lines of walls, or closed polylines of rooms; doors and windows as lines; texts name rooms.

Read with ezdxf, which the extra ``dxf`` brings.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, reason
from sceneweaver.io.messages import path_name
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import MissingDependencyError

from ..drawings import Drawing, Drawn, role_of, rooms_of_drawing
from ..line_plans import MOST_LINES, Label
from ..model import ReadOptions, SourceFormat, SourceRoom

UNITS = {
    1: (0.0254, "inches"),
    2: (0.3048, "feet"),
    4: (0.001, "millimetres"),
    5: (0.01, "centimetres"),
    6: (1.0, "metres"),
}
"""Metres of a unit by $INSUNITS."""

MOST_BYTES = 2**27


def matches(path: Path, head: bytes) -> bool:
    """A DXF file by its name and the beginning of its text."""
    return path.suffix.lower() == ".dxf" and (b"SECTION" in head or head.startswith(b"AutoCAD Binary DXF"))


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the model space, in its order."""
    where = path_name(path)
    try:
        from ezdxf import recover
        from ezdxf.lldxf.const import DXFError
    except ImportError:
        raise MissingDependencyError(missing_extra("dxf", f"{where}: DXF needs ezdxf")) from None
    if path.stat().st_size > MOST_BYTES:
        raise InputError(f"{where}: larger than {MOST_BYTES >> 20} MB; export the plan's layers alone")
    try:
        document, _ = recover.readfile(str(path))
    except (OSError, DXFError, ValueError, KeyError, IndexError) as error:
        raise InputError(f"{where}: no DXF ({reason(error)}); save it anew, as ASCII DXF of 2000 or later") from None
    drawing = Drawing(where)
    unit = UNITS.get(int(document.header.get("$INSUNITS", 0)))
    if unit is not None:
        drawing.unit, drawing.said = unit[0], f"a unit is {unit[0]:g} m: the drawing is in {unit[1]}"
    for number, entity in enumerate(document.modelspace()):
        if number > 20 * MOST_LINES:
            raise InputError(f"{where}: more than {20 * MOST_LINES} entities; export the plan's layers alone")
        _take(entity, drawing)
    for room in rooms_of_drawing(drawing, options.scale):
        if options.room in (None, room.name):
            yield room


def _take(entity: Any, drawing: Drawing) -> None:
    """Adds an entity to a drawing: lines, polylines and texts; blocks of doors and windows by the line they lie on."""
    kind, layer = entity.dxftype(), str(entity.dxf.get("layer", "0"))
    called = f"{kind} {entity.dxf.get('handle', '')} on layer {layer}"
    if kind in ("TEXT", "MTEXT"):
        text = entity.plain_text() if kind == "MTEXT" else str(entity.dxf.text)
        at = entity.dxf.insert
        if text.strip():
            drawing.texts.append(Label(" ".join(text.split()), (float(at.x), float(at.y))))
        return
    if kind == "LINE":
        ends = np.array([(p.x, p.y) for p in (entity.dxf.start, entity.dxf.end)])
        drawing.elements.append(Drawn(called, (layer,), ends, False))
    elif kind in ("LWPOLYLINE", "POLYLINE"):
        if kind == "LWPOLYLINE":
            points = np.array([(x, y) for x, y in entity.get_points("xy")])
            curved, closed = entity.has_arc, bool(entity.closed)
        else:
            points = np.array([(p.x, p.y) for p in entity.points()])
            curved, closed = entity.has_arc, bool(entity.is_closed)
        if len(points) < 2:
            return
        same = len(points) > 3 and np.abs(points[0] - points[-1]).max() < 1e-9 * max(1.0, np.abs(points).max())
        points, closed = (points[:-1], True) if same else (points, closed and len(points) > 2)
        role, _ = role_of((layer,), closed)
        if curved and role in ("room", "wall"):
            raise InputError(f"{drawing.where}: {called}: it has arcs; rooms and walls are straight here, draw lines")
        drawing.elements.append(Drawn(called, (layer,), points, closed))
    elif kind == "DIMENSION":
        _measured(entity, called, drawing)
    elif kind == "INSERT" and role_of((layer, str(entity.dxf.get("name", ""))), False)[0] in ("door", "window"):
        _block(entity, called, layer, drawing)


def _measured(entity: Any, called: str, drawing: Drawing) -> None:
    """A dimension with the length that its text states; without a text it says nothing of the unit."""
    text = re.sub(r"\\[A-Za-z][^;]*;|[{}]", "", str(entity.dxf.get("text", "")))
    if not re.search(r"\d", text) or not entity.dxf.hasattr("defpoint2") or not entity.dxf.hasattr("defpoint3"):
        return
    ends = np.array([(p.x, p.y) for p in (entity.dxf.defpoint2, entity.dxf.defpoint3)])
    drawing.elements.append(Drawn(called, (text, "dimension"), ends, False))


def _block(entity: Any, called: str, layer: str, drawing: Drawing) -> None:
    """A door or window as a block: the longest of its straight lines that lies along the block's own x."""
    along = np.deg2rad(float(entity.dxf.get("rotation", 0.0)))
    way = np.array((np.cos(along), np.sin(along)))
    points = []
    for part in entity.virtual_entities():
        if part.dxftype() == "LINE":
            points += [(p.x, p.y) for p in (part.dxf.start, part.dxf.end)]
        elif part.dxftype() == "LWPOLYLINE":
            points += [(x, y) for x, y in part.get_points("xy")]
        elif part.dxftype() == "ARC":
            points += [(p.x, p.y) for p in (part.start_point, part.end_point)]
    if not points:
        drawing.notes.append(f"{called}: a block without lines; draw a line for it")
        return
    spread = np.array(points) @ way
    base = np.array((entity.dxf.insert.x, entity.dxf.insert.y))
    ends = np.stack([base + (t - base @ way) * way for t in (spread.min(), spread.max())])
    drawing.elements.append(Drawn(called, (layer, str(entity.dxf.get("name", ""))), ends, False))


FORMAT = SourceFormat(
    name="dxf",
    title="A drawing (DXF)",
    matches=matches,
    read=read,
    notes=(
        "Read: LINE, LWPOLYLINE, POLYLINE, TEXT, MTEXT, DIMENSION of the model space, with the extra dxf (ezdxf): "
        "closed polylines on a layer of rooms, else what the lines of the layers of walls enclose.",
        "Meaning: a layer by a word in its name: wall, room, door, window (glaz), entrance, passage, dimension, or "
        "that of a room. A text in a room names it. Doors and windows are lines or blocks along a wall.",
        "The scale is --scale, a dimension with a text, or the drawing's units ($INSUNITS); without one it is refused.",
        "Lost: arcs, hatches, other layers. Walls drawn as two lines are the gap between their faces. Heights are "
        "assumed.",
    ),
    licence="the user's own",
)
