"""Open-plan floors of any number of objects, at one density, with one mix of relations and a known valid layout.

Of a hundred objects, sixty are tables with four chairs each (front_against), twenty are desks with a chair
(front_to_front), ten are cabinets (against_wall) and ten plants without a relation. The floor's area grows with the
objects, its walls with the root of that: cabinets take 12 % of the walls at 50 objects and 37 % at 500.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from sceneweaver.scene import SCHEMA, Pose, Scene

FILL = 0.2
CELL = 1.92  # [m] a table with its chairs
RIM = 1.0  # [m] kept free of groups along the walls: cabinets with their zones, doors
CORNER = 1.3  # [m] kept free of cabinets
OBJECTS_A_DOOR = 120
LEAST = 50  # below, the grid of cells is too coarse

Json = dict[str, Any]


def _box(x: float, y: float, depth: float, width: float) -> list[list[float]]:
    return [[round(x + i * depth / 2, 4), round(y + j * width / 2, 4)] for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _part(x: float, y: float, depth: float, width: float, low: float, high: float) -> Json:
    return {"polygon": _box(x, y, depth, width), "z": [low, high]}


def _legs(depth: float, width: float, height: float) -> list[Json]:
    x, y = depth / 2 - 0.03, width / 2 - 0.03
    return [_part(i * x, j * y, 0.05, 0.05, 0, height) for i in (-1, 1) for j in (-1, 1)]


SHAPES: dict[str, Json] = {
    "table": {"size": [0.9, 1.5, 0.74], "parts": [_part(0, 0, 0.9, 1.5, 0.7, 0.74), *_legs(0.9, 1.5, 0.7)]},
    "desk": {
        "size": [0.64, 1.22, 0.75],
        "parts": [
            _part(0, 0, 0.64, 1.22, 0.71, 0.75),
            _part(0, -0.59, 0.64, 0.04, 0, 0.71),
            _part(0, 0.59, 0.64, 0.04, 0, 0.71),
        ],
    },
    "chair": {
        "size": [0.46, 0.45, 0.88],
        "parts": [_part(0, 0, 0.46, 0.45, 0, 0.46), _part(-0.205, 0, 0.05, 0.45, 0.46, 0.88)],
    },
    "cabinet": {
        "size": [0.45, 1.0, 0.84],
        "zones": [{"name": "front", "polygon": _box(0.475, 0, 0.5, 1.0), "z": [0, 1.8], "hard": True}],
    },
    "plant": {"size": [0.4, 0.4, 1.0]},
}


class _Plan:
    """A floor while it is made."""

    def __init__(self) -> None:
        self.objects: list[Json] = []
        self.relations: list[Json] = []

    def put(self, kind: str, x: float, y: float, yaw: float) -> str:
        pose = Pose.from_yaw(x, y, 0.0, yaw)
        object_id = f"{kind}-{len(self.objects)}"
        placed = {"position": list(pose.position), "quaternion": list(pose.quaternion)}
        self.objects.append({"id": object_id, "category": kind, "mount": "floor", "pose": placed, **SHAPES[kind]})
        return object_id

    def relate(self, kind: str, subject: str, target: str | None = None) -> None:
        self.relations.append({"type": kind, "subject": subject, "target": target, "hard": True})

    def table(self, x: float, y: float) -> None:
        table = self.put("table", x, y, 0.0)
        for side in (-1, 1):
            for along in (-1, 1):
                chair = self.put("chair", x + side * 0.71, y + along * 0.37, 0.0 if side < 0 else math.pi)
                self.relate("front_against", chair, table)

    def desk(self, x: float, y: float) -> None:
        desk = self.put("desk", x - 0.25, y, 0.0)
        self.relate("front_to_front", self.put("chair", x + 0.35, y, math.pi), desk)

    def cabinet(self, side: float, wall: int, along: float) -> None:
        d = SHAPES["cabinet"]["size"][0] / 2 + 0.02
        x, y, yaw = ((side - d, along, math.pi), (along, side - d, -math.pi / 2), (d, along, 0.0))[wall]
        self.relate("against_wall", self.put("cabinet", x, y, yaw))


def mix(objects: int) -> tuple[int, int, int, int]:
    """How many tables (with four chairs), desks (with one), cabinets and plants."""
    desks = cabinets = round(objects / 10)
    tables = (objects - 3 * desks - round(objects / 10)) // 5
    return tables, desks, cabinets, objects - 5 * tables - 2 * desks - cabinets


def _area(kind: str) -> float:
    depth, width, _ = SHAPES[kind]["size"]
    return depth * width


@cache
def floor(objects: int, seed: int = 0) -> Scene:
    """A square floor with so many objects (at least 50), in a valid layout."""
    if objects < LEAST:
        raise ValueError(f"objects: {objects} is less than {LEAST}")
    tables, desks, cabinets, plants = mix(objects)
    footprint = tables * (_area("table") + 4 * _area("chair")) + desks * (_area("desk") + _area("chair"))
    side = round(math.sqrt((footprint + cabinets * _area("cabinet") + plants * _area("plant")) / FILL), 2)
    plan = _Plan()
    cells = _cells(side, np.random.default_rng([seed, objects]))
    for _ in range(tables):
        plan.table(*next(cells))
    for _ in range(desks):
        plan.desk(*next(cells))
    _cabinets(plan, side, cabinets)
    for k in range(plants):  # four to a cell
        if k % 4 == 0:
            x, y = next(cells)
        plan.put("plant", x + (-0.5, 0.5)[k % 2], y + (-0.5, 0.5)[k // 2 % 2], 0.0)
    return Scene.from_json(
        {
            "schema": SCHEMA,
            "id": f"floor-{objects}",
            "room": {
                "type": "office",
                "outline": [[0, 0], [side, 0], [side, side], [0, side]],
                **_openings(side, objects),
            },
            "objects": plan.objects,
            "relations": plan.relations,
        }
    )


def _cells(side: float, rng: np.random.Generator):
    """Middles of a grid's cells in any order."""
    count = int((side - 2 * RIM) / CELL)
    step = (side - 2 * RIM) / count
    for k in rng.permutation(count * count):
        yield RIM + (k % count + 0.5) * step, RIM + (k // count + 0.5) * step


def _cabinets(plan: _Plan, side: float, count: int) -> None:
    """Evenly along three walls; the doors are in the fourth."""
    for wall in range(3):
        here = count // 3 + (wall < count % 3)
        for k in range(here):
            plan.cabinet(side, wall, CORNER + (k + 0.5) * (side - 2 * CORNER) / here)


def _openings(side: float, objects: int) -> Json:
    doors = max(1, round(objects / OBJECTS_A_DOOR))
    step = side / doors
    return {
        "doors": [
            {"id": f"door-{k}", "wall": 0, "offset": round((k + 0.5) * step - 0.45, 3), "width": 0.9, "height": 2.05}
            for k in range(doors)
        ],
        "windows": [{"id": "window-0", "wall": 2, "offset": 1.5, "width": 2.0, "sill": 0.95, "height": 1.2}],
    }
