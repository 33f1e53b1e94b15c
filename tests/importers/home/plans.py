"""One flat of two rooms as the files of every system: a bedroom, an L-shaped hall, two doors, a window.

Between the faces of walls, metres, y up:

    (0, 3) +--window--+ (4, 3)  (4.1, 3) +------+ (5.5, 3)
           | bedroom    |                |      |
           |          door               | hall +----+ (6.3, 2.2)
    (0, 0) +------------+       (4.1, 0) +--entrance-+ (6.3, 0)
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

BEDROOM = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
HALL = [(4.1, 0.0), (6.3, 0.0), (6.3, 2.2), (5.5, 2.2), (5.5, 3.0), (4.1, 3.0)]
BEDROOM_MIDDLE = [(-0.05, -0.05), (4.05, -0.05), (4.05, 3.05), (-0.05, 3.05)]
HALL_MIDDLE = [(4.05, -0.05), (6.35, -0.05), (6.35, 2.25), (5.55, 2.25), (5.55, 3.05), (4.05, 3.05)]
DOOR = [(4.05, 0.7), (4.05, 1.6)]
ENTRANCE = [(4.9, -0.05), (5.9, -0.05)]
WINDOW = [(1.0, 3.05), (2.5, 3.05)]

Points = list[tuple[float, float]]


def thick(ends: Points, across: float) -> Points:
    """The rectangle around a line, ``across`` wide."""
    (x0, y0), (x1, y1) = ends
    h = across / 2
    if x0 == x1:
        return [(x0 - h, y0), (x0 + h, y0), (x0 + h, y1), (x0 - h, y1)]
    return [(x0, y0 - h), (x1, y0 - h), (x1, y0 + h), (x0, y0 + h)]


def wkt(points: Points) -> str:
    return f"POLYGON (({', '.join(f'{x} {y}' for x, y in [*points, points[0]])}))"


def resplan() -> str:
    geometry: dict[str, Any] = {
        "bedroom": wkt(BEDROOM),
        "entrance": wkt(HALL),
        "door": wkt(thick(DOOR, 0.1)),
        "front_door": wkt(thick(ENTRANCE, 0.1)),
        "window": wkt(thick(WINDOW, 0.1)),
    }
    return json.dumps(geometry)


def msd(angle: float = math.radians(27.0)) -> str:
    """Turned, as flats lie on their site."""
    c, s = math.cos(angle), math.sin(angle)

    def turned(points: Points) -> str:
        return '"' + wkt([(c * x - s * y, s * x + c * y) for x, y in points]) + '"'

    rows = ["apartment_id,building_id,unit_id,area_id,entity_type,entity_subtype,geom,elevation,height,roomtype"]
    for number, (entity, kind, points) in enumerate(
        [
            ("area", "ROOM", BEDROOM),
            ("area", "LOBBY", HALL),
            ("opening", "DOOR", thick(DOOR, 0.1)),
            ("opening", "ENTRANCE_DOOR", thick(ENTRANCE, 0.1)),
            ("opening", "WINDOW", thick(WINDOW, 0.1)),
        ]
    ):
        unit = "77.0" if entity == "area" else ""
        rows.append(f"a1,9,{unit},{number}.0,{entity},{kind},{turned(points)},8.7,2.6,")
    return "\n".join(rows) + "\n"


def infinigen() -> str:
    def line(points: Points) -> dict[str, str]:
        return {"shape": f"shapely.LineString({points})"}

    return json.dumps(
        {
            "rooms": {
                "bedroom_0/0": {"shape": f"shapely.Polygon({BEDROOM_MIDDLE})"},
                "hallway_0/0": {"shape": f"shapely.Polygon({HALL_MIDDLE})"},
            },
            "doors": {"door": line(DOOR), "front": line(ENTRANCE)},
            "windows": {"window": line(WINDOW)},
        }
    )


def thor() -> str:
    def corner(x: float, z: float) -> dict[str, float]:
        return {"x": x, "y": 0.0, "z": z}

    def wall(name: str, room: str, a: tuple[float, float], b: tuple[float, float]) -> dict[str, Any]:
        (x0, z0), (x1, z1) = a, b
        polygon = [corner(x0, z0), corner(x1, z1), {"x": x1, "y": 2.6, "z": z1}, {"x": x0, "y": 2.6, "z": z0}]
        return {"id": name, "roomId": room, "polygon": polygon}

    def hole(low: float, high: float, bottom: float, top: float) -> list[dict[str, float]]:
        return [{"x": low, "y": bottom, "z": 0.0}, {"x": high, "y": top, "z": 0.0}]

    return json.dumps(
        {
            "rooms": [
                {"id": "room|1", "roomType": "Bedroom", "floorPolygon": [corner(*p) for p in BEDROOM_MIDDLE]},
                {"id": "room|2", "roomType": "Hallway", "floorPolygon": [corner(*p) for p in HALL_MIDDLE]},
            ],
            "walls": [
                wall("wall|1", "room|1", (4.05, -0.05), (4.05, 3.05)),
                wall("wall|2", "room|2", (4.05, -0.05), (6.35, -0.05)),
                wall("wall|3", "room|1", (-0.05, 3.05), (4.05, 3.05)),
            ],
            "doors": [
                {
                    "id": "door|1",
                    "room0": "room|1",
                    "room1": "room|2",
                    "wall0": "wall|1",
                    "assetId": "Doorway_1",
                    "holePolygon": hole(0.75, 1.65, 0.0, 2.1),
                },
                {
                    "id": "door|2",
                    "room0": "room|2",
                    "room1": "room|2",
                    "wall0": "wall|2",
                    "assetId": "Doorway_2",
                    "holePolygon": hole(0.85, 1.85, 0.0, 2.1),
                },
            ],
            "windows": [
                {"id": "window|1", "room0": "room|1", "wall0": "wall|3", "holePolygon": hole(1.05, 2.55, 0.9, 2.1)}
            ],
            "objects": [],
        }
    )


def _svg_points(points: Points, unit: float) -> str:
    return " ".join(f"{x / unit:.6f},{-y / unit:.6f}" for x, y in points)


def cubicasa() -> str:
    """Its scale comes from its doors: the middle one is taken for 0.8 m wide, so a unit is what makes it that."""
    unit = 0.01

    def group(kind: str, points: Points, inner: str = "") -> str:
        return f'<g class="{kind}"><polygon points="{_svg_points(points, unit)}"/>{inner}</g>'

    walls = group("Wall External", thick(ENTRANCE, 0.1), group("Door Swing Beside", thick(ENTRANCE, 0.1)))
    walls += group("Wall", thick(DOOR, 0.1), group("Door Swing Beside", thick(DOOR, 0.1)))
    walls += group("Wall External", thick(WINDOW, 0.1), group("Window Regular", thick(WINDOW, 0.1)))
    spaces = group("Space Bedroom", BEDROOM) + group("Space Entry", HALL)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="700" height="400"><g class="Model">'
        f'<g class="Floorplan Floor-1">{walls}{spaces}</g></g></svg>'
    )


def svg() -> str:
    unit = 0.01
    (x0, y0), (x1, y1) = [(x / unit, -y / unit) for x, y in DOOR]
    hall = "M " + " L ".join(_svg_points([p], unit) for p in HALL) + " Z"
    entrance = _svg_points(thick(ENTRANCE, 0.1), unit)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg">'
        f'<g id="rooms"><polygon id="bedroom" points="{_svg_points(BEDROOM, unit)}"/>'
        f'<path id="p7" d="{hall}"/></g><text x="{4.6 / unit}" y="{-1.0 / unit}">Hall</text>'
        f'<g id="doors"><line id="d1" x1="{x0}" y1="{y0}" x2="{x1}" y2="{y1}"/></g>'
        f'<polygon id="front-door" points="{entrance}"/>'
        f'<polyline class="window" points="{_svg_points(WINDOW, unit)}"/>'
        '<g id="dimension" transform="translate(0 50)"><line id="m" x1="0" y1="0" x2="400" y2="0"><title>4 m</title>'
        "</line></g></svg>"
    )


def r2v() -> str:
    """Pixels of 10 mm, y down."""
    rows = []

    def row(points: Points, kind: str) -> None:
        (x0, y0), (x1, y1) = points
        numbers = [round(v, 3) for v in (x0 * 100, -y0 * 100, x1 * 100, -y1 * 100)]
        rows.append("\t".join(str(v) for v in (*numbers, kind, 1, 1)))

    row(DOOR, "door")
    row(ENTRANCE, "door")
    row(WINDOW, "door")
    row([(1.0, 1.0), (1.4, 0.8)], "bedroom")
    row([(4.5, 0.5), (4.9, 0.3)], "corridor")
    row([(5.0, 0.3), (5.4, 0.1)], "entrance")
    for ring in (BEDROOM_MIDDLE, HALL_MIDDLE):
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            row([a, b], "wall")
    return "\n".join(rows) + "\n"


PIXEL = 18.0 / 256.0


def rplan() -> str:
    """In metres as if a pixel were 18 / 256 m: numbers that are no whole pixels, as the format allows them."""
    shapes = [(BEDROOM, 3), (HALL, 6), (thick(DOOR, 0.1), 17), (thick(ENTRANCE, 0.1), 15)]
    edges, owners = [], []
    for node, (points, kind) in enumerate(shapes):
        for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1], strict=True):
            edges.append([x0 / PIXEL, -y0 / PIXEL, x1 / PIXEL, -y1 / PIXEL, kind, 0])
            owners.append([node])
    owners[10].append(0)
    owners[12].append(1)
    owners[14].append(1)
    boxes = [[min(x for x, _ in p), 0, max(x for x, _ in p), 1] for p, _ in shapes]
    return json.dumps({"room_type": [k for _, k in shapes], "boxes": boxes, "edges": edges, "ed_rm": owners})


def dxf(folder: Path) -> Path:
    """In millimetres: rooms as closed polylines, doors as lines and a block, names as texts."""
    from ezdxf.filemanagement import new

    document = new("R2010")
    document.header["$INSUNITS"] = 4
    space = document.modelspace()

    def mm(points: Points) -> list[tuple[float, float]]:
        return [(1000 * x, 1000 * y) for x, y in points]

    for ring in (BEDROOM, HALL):
        space.add_lwpolyline(mm(ring), close=True, dxfattribs={"layer": "A-ROOM"})
    for text, at in (("Bedroom", (2.0, 1.5)), ("Entrance hall", (4.8, 1.0))):
        space.add_text(text, dxfattribs={"layer": "TEXT", "insert": mm([at])[0]})
    leaf = document.blocks.new("DOOR90")
    leaf.add_line((0, 0), (0, 900))
    leaf.add_arc((0, 0), 900, 0, 90)
    space.add_blockref("DOOR90", mm(DOOR)[0], dxfattribs={"layer": "A-DOOR", "rotation": 90})
    space.add_line(*mm(ENTRANCE), dxfattribs={"layer": "A-ENTRANCE"})
    space.add_line(*mm(WINDOW), dxfattribs={"layer": "A-GLAZ"})
    path = folder / "flat.dxf"
    document.saveas(path)
    return path


TEXTS: dict[str, tuple[str, Callable[[], str], float | None, bool]] = {
    "resplan": ("flat.json", resplan, None, True),
    "msd": ("flats.csv", msd, None, True),
    "infinigen-plan": ("predefined.json", infinigen, None, True),
    "ai2thor": ("house.json", thor, None, True),
    "cubicasa": ("model.svg", cubicasa, 0.01, True),
    "svg": ("flat.svg", svg, None, True),
    "r2v": ("flat.txt", r2v, 0.01, True),
    "rplan": ("7.json", rplan, None, False),
}
"""By format: name of the file, its text, metres of a unit where the file does not say, whether it has windows."""


def file_of(name: str, folder: Path) -> Path:
    """The flat as a file of a format."""
    if name == "dxf":
        return dxf(folder)
    file, text, *_ = TEXTS[name]
    path = folder / file
    path.write_text(text())
    return path
