"""SpatialLM: a layout as text, an entity a line, as its networks and data set write it.

``wall_0=Wall(ax,ay,az,bx,by,bz,height,thickness)``, ``door_0=Door(wall_0,x,y,z,width,height)`` and ``Window(...)``
alike (x, y, z is the CENTRE of the opening), ``bbox_0=Bbox(class,x,y,z,angle,sx,sy,sz)``: centre, angle [rad] about z
counter-clockwise, FULL extents along the box's own axes. Frame: metres, right-handed, z up. Nothing is evaluated.

SpatialLM says of no class which side of its box is the front. Manycore's scenes, which it is trained on, have models
that face -y of their own frame; so that is assumed, and boxes are symmetric in its own evaluation.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, read_text
from sceneweaver.io.messages import path_name, show

from ..frames import facing, yaw_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..outlines import holds, near_wall, of_walls
from ..values import LARGEST

_LINE = re.compile(
    r"\s*(wall|door|window|bbox)_(\d+)\s*=\s*(Wall|Door|Window|Bbox)\s*\(([^()]*)\)\s*,?\s*$", re.IGNORECASE
)
_SHAPE = {"wall": (0, 8), "door": (1, 5), "window": (1, 5), "bbox": (1, 7)}  # words, then numbers
_FIELDS = {
    "wall": "Wall(ax,ay,az,bx,by,bz,height,thickness)",
    "door": "Door(wall_0,x,y,z,width,height)",
    "window": "Window(wall_0,x,y,z,width,height)",
    "bbox": "Bbox(class,x,y,z,angle,sx,sy,sz)",
}
MEET = 0.1  # [m] ends of walls nearer than this meet
LEAST = 1.0  # [m2] least room
MOST = 1000  # walls
MAX_BYTES = 2**24


@dataclass
class _Layout:
    walls: dict[int, list[float]] = field(default_factory=dict)
    openings: list[tuple[str, int, int, list[float]]] = field(default_factory=list)
    boxes: list[tuple[int, str, list[float]]] = field(default_factory=list)


def matches(path: Path, head: bytes) -> bool:
    """Text with an entity on one of its first lines."""
    lines = head[:4096].decode("utf-8", "replace").splitlines()
    return any(_LINE.match(line) for line in lines[:20])


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms that its walls enclose, largest first; one without an outline where they enclose none."""
    where = path_name(path)
    layout = _parse(read_text(path, max_bytes=MAX_BYTES), where)
    if not layout.walls and not layout.boxes:
        raise InputError(f"{where}: no line is a wall or a box; give lines such as wall_0={_FIELDS['wall']}")
    if len(layout.walls) > MOST or len(layout.boxes) + len(layout.openings) > 10 * MOST:
        raise InputError(f"{where}: over {MOST} walls or {10 * MOST} boxes; split it into smaller files")
    floor = min((v for w in layout.walls.values() for v in (w[2], w[5])), default=0.0)
    objects = [_object(*entry, floor) for entry in layout.boxes]
    ends = np.array([[w[0], w[1], w[3], w[4]] for w in layout.walls.values()]).reshape(-1, 4)
    rooms = [ring for ring in of_walls(ends, MEET) if _area(ring) >= LEAST]
    notes = [f"the floor lies at {floor:g} m; it is moved to 0"] if abs(floor) > 1e-9 else []
    openings = [_opening(entry, layout.walls, floor) for entry in layout.openings if entry[2] in layout.walls]
    lost = len(layout.openings) - len(openings)
    if lost:
        notes.append(f"{lost} doors and windows left out: their wall is not in the file")
    if not rooms:
        if layout.walls:
            notes.append(f"{len(layout.walls)} walls enclose no room, so there is no outline")
        yield SourceRoom(name=path.stem, objects=tuple(objects), notes=tuple(notes))
        return
    homes = [next((k for k, ring in enumerate(rooms) if holds(ring, o.position)), None) for o in objects]
    outside = sum(home is None for home in homes)
    if outside:
        notes.append(f"{outside} objects stand in no room: each is given to the one whose middle is nearest")
        middles = [ring.mean(axis=0) for ring in rooms]
        near = [int(np.argmin([np.hypot(*(m - np.array(o.position[:2]))) for m in middles])) for o in objects]
        homes = [near[k] if home is None else home for k, home in enumerate(homes)]
    height = _height(layout.walls)
    for k, ring in enumerate(rooms):
        mine = [o for o in openings if near_wall(ring, o[1].start, o[1].end, max(0.3, o[0]))]
        yield SourceRoom(
            name=f"room_{k}" if len(rooms) > 1 else path.stem,
            outline=tuple((float(x), float(y)) for x, y in ring),
            height=height,
            openings=tuple(opening for _, opening in mine),
            objects=tuple(thing for thing, home in zip(objects, homes, strict=True) if home == k),
            notes=tuple(notes),
        )


def _parse(text: str, where: str) -> _Layout:
    found = _Layout()
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = _LINE.match(line)
        place = f"{where}: line {number}"
        if match is None or match[1].lower() != match[3].lower():
            forms = ", ".join(_FIELDS.values())
            raise InputError(f"{place}: {show(line.strip())} is no entity; give one of {forms}")
        kind, index = match[1].lower(), int(match[2])
        parts = [part.strip() for part in match[4].split(",")]
        words, count = _SHAPE[kind]
        if len(parts) < words + count or (kind != "wall" and len(parts) != words + count):
            raise InputError(f"{place}: {len(parts)} values; {_FIELDS[kind]} has {words + count}")
        values = [_number(part, place) for part in parts[words : words + count]]
        if kind == "wall":
            if index in found.walls:
                raise InputError(f"{place}: wall_{index} stands twice; number walls one by one")
            found.walls[index] = values
        elif kind == "bbox":
            if min(map(abs, values[4:])) <= 0:
                raise InputError(f"{place}: an extent is 0; Bbox ends in three lengths")
            found.boxes.append((index, parts[0].strip("'\""), values))
        else:
            carrier = re.fullmatch(r"wall_(\d+)", parts[0])
            if carrier is None:
                raise InputError(f"{place}: {show(parts[0])} is no wall; give one such as wall_0")
            found.openings.append((kind, index, int(carrier[1]), values))
    return found


def _number(text: str, place: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise InputError(f"{place}: {show(text)} is no number") from None
    if not abs(value) <= LARGEST:
        raise InputError(f"{place}: {show(value)}; numbers must be finite, in metres and radians")
    return value


def _object(index: int, label: str, values: Sequence[float], floor: float) -> SourceObject:
    x, y, z, angle, along_x, along_y, tall = values
    return SourceObject(
        name=f"{label}_{index}",
        label=label,
        position=(x, y, z - floor),
        rotation=yaw_matrix(angle) @ facing("-y").T,
        size=(abs(along_y), abs(along_x), abs(tall)),
    )


def _opening(
    entry: tuple[str, int, int, list[float]], walls: dict[int, list[float]], floor: float
) -> tuple[float, SourceOpening]:
    """An opening, with the thickness of its wall."""
    kind, index, carrier, (x, y, z, width, height) = entry
    wall: Any = walls[carrier]
    way = np.array([wall[3] - wall[0], wall[4] - wall[1]])
    length = float(np.hypot(*way))
    way = way / length if length > 1e-9 else np.array([1.0, 0.0])
    a, b = np.array([x, y]) - way * width / 2, np.array([x, y]) + way * width / 2
    return float(wall[7]), SourceOpening(
        name=f"{kind}_{index}",
        kind="door" if kind == "door" else "window",
        start=(float(a[0]), float(a[1])),
        end=(float(b[0]), float(b[1])),
        bottom=max(0.0, z - height / 2 - floor),
        height=height if height > 0 else None,
    )


def _height(walls: dict[int, list[float]]) -> float | None:
    heights = sorted(w[6] for w in walls.values() if w[6] > 0.5)
    return heights[len(heights) // 2] if heights else None


def _area(ring: np.ndarray) -> float:
    from sceneweaver.geometry.polygons import signed_area

    return abs(signed_area(ring))


FORMAT = SourceFormat(
    name="spatiallm",
    title="SpatialLM (layout text)",
    matches=matches,
    read=read,
    notes=(
        "Read: lines of Wall, Door, Window and Bbox as SpatialLM writes them; text only, nothing is evaluated.",
        "Meaning: z up; doors, windows and boxes are given by their centre; extents are full; angles turn "
        "counter-clockwise about z. Each area of 1 m2 or more that the walls enclose is a room; ends of walls within "
        "0.1 m meet in their mean.",
        "Assumed: a box faces the -y of its own axes, since the format has no fronts; walls have no thickness; the "
        "room is as high as the middle of its walls; the floor is at the lowest wall.",
        "Lost: the thickness of walls, types of rooms (the format has none).",
    ),
    licence="as SpatialLM's data set states",
)
