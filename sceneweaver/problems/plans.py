"""Plans of blocks with an objective: chips, facilities, floor plans and warehouses, each with a layout that is valid.

Blocks fill cells of a rectangle that was cut up, as in the other families; warehouses stand in rows. The layout proves
that the problem can be solved and says nothing of its best objective: nets and flows know nothing of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import SCHEMA, Pose, Scene

from . import cells
from .cells import Box, NoFit
from .measures import footprint, tightness_of
from .nets import flow, flows, nets
from .units import rectangle

Json = dict[str, Any]

DOOR = {"id": "door", "wall": 0, "offset": cells.DOOR_OFFSET, "width": cells.DOOR_WIDTH, "height": 2.05}
SPREAD = {"gsrc": 0.55, "mcnc": 1.0, "equal": 0.0, "unequal": 0.7}
"""Standard deviation of the logarithm of blocks' areas."""
LARGEST = 6.0  # a block's area, in those of the average one
ALIKE = 6  # blocks that are put in order of size, so that no cut leaves a strip
PAD_SILL = 1.5  # [m] above all blocks: pads take no floor
LINKED = 0.3  # of the pairs of rooms beside each other, above those that tie all together
TOUCH = 0.8  # [m] of wall that rooms beside each other share
ROOMS = (24.0, 16.0, 14.0, 12.0, 12.0, 10.0, 6.0, 4.0)  # [m2]
RACK_DEPTH, AISLE, STRIP, DOCK = 1.1, 1.8, 3.0, (0.8, 1.6, 1.0)  # [m]


@dataclass
class Plan:
    """A scene while it is made, and its objective."""

    outline: list[list[float]]
    doors: list[Json] = field(default_factory=list)
    windows: list[Json] = field(default_factory=list)
    objects: list[Json] = field(default_factory=list)
    relations: list[Json] = field(default_factory=list)
    objective: list[Json] = field(default_factory=list)

    def add(self, name: str, at: tuple[float, float], size: Any, yaw: float = 0.0, **more: Any) -> str:
        """Put a block with its middle at (x, y) [m]; its id."""
        pose = Pose.from_yaw(round(at[0], 4), round(at[1], 4), 0.0, math.remainder(yaw, 2 * math.pi))
        where = {"position": list(pose.position), "quaternion": list(pose.quaternion)}
        size = [round(float(s), 3) for s in size]
        self.objects.append({"id": name, "category": name.rpartition("-")[0], "size": size, "pose": where, **more})
        return name

    def relate(self, kind: str, subject: str, target: str | None = None, **params: Any) -> None:
        """Add a hard relation."""
        row = {"type": kind, "subject": subject, "target": target, "params": params, "hard": True}
        self.relations.append(row)

    def scene(self) -> Scene:
        """The scene, as it was put together."""
        room = {"type": "room", "outline": self.outline, "height": 2.8, "doors": self.doors, "windows": self.windows}
        rows = {"objects": self.objects, "relations": self.relations}
        return Scene.from_json({"schema": SCHEMA, "id": "draft", "room": room, **rows})


def _areas(count: int, spread: float, rng: np.random.Generator) -> list[float]:
    """Areas of blocks [m2], the average 1, alike beside alike."""
    drawn = np.exp(rng.normal(0.0, spread, count))
    drawn = np.minimum(drawn / drawn.mean(), LARGEST)
    return [float(a) for k in range(0, count, ALIKE) for a in sorted(drawn[k : k + ALIKE])]


def _inside(box: Box, share: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Middle and sides of a block that takes a share of a cell, with air around it."""
    (x0, y0, x1, y1), side = box, math.sqrt(share)
    sides = tuple(round(side * s, 3) for s in (x1 - x0, y1 - y0))
    if min(sides) < 0.1 or any(s > whole - 0.008 for s, whole in zip(sides, (x1 - x0, y1 - y0), strict=True)):
        raise NoFit("no room for air around a block")
    return ((x0 + x1) / 2, (y0 + y1) / 2), (sides[0], sides[1])


def _cut(areas: list[float], scale: float, rng: np.random.Generator) -> tuple[float, float, list[Box]]:
    """A rectangle of the areas' sum and its cells."""
    whole, aspect = sum(areas) * scale, float(rng.uniform(1.0, 1.3))
    width, depth = round(math.sqrt(whole * aspect), 2), round(math.sqrt(whole / aspect), 2)
    return width, depth, cells.split((0.0, 0.0, width, depth), areas, rng)


def _blocks(plan: Plan, name: str, boxes: list[Box], share: float, rng: np.random.Generator) -> list[str]:
    ids = []
    for k, box in enumerate(boxes):
        (x, y), (dx, dy) = _inside(box, share)
        turned = bool(rng.random() < 0.5)
        size = (dy, dx) if turned else (dx, dy)
        ids.append(plan.add(f"{name}-{k}", (x, y), (*size, rng.uniform(0.4, 1.2)), turned * math.pi / 2))
    return ids


def chips(objects: int, tightness: float, kind: str, rng: np.random.Generator) -> Plan:
    """Blocks on a die with pads around it; the objective is the wire length of multi-pin nets."""
    areas = _areas(objects, SPREAD[kind], rng)
    width, depth, boxes = _cut(areas, 1.0 / tightness, rng)
    plan = Plan(rectangle(0.0, 0.0, width, depth))
    ids = _blocks(plan, "block", boxes, tightness, rng)
    pads = 4 * max(2, round(math.sqrt(objects) / 2))
    for k in range(pads):
        side, place = k % 4, k // 4
        length = width if side % 2 == 0 else depth
        offset = round(length * (place + 0.5) / (pads / 4) - 0.15, 3)
        row = {"id": f"pad-{k}", "wall": side, "offset": offset, "width": 0.3, "sill": PAD_SILL, "height": 0.3}
        plan.windows.append(row)
    plan.objective = nets(kind, ids, [o["size"] for o in plan.objects], [w["id"] for w in plan.windows], rng)
    return plan


def facilities(objects: int, tightness: float, kind: str, rng: np.random.Generator) -> Plan:
    """Departments of equal or unequal area with flows between them; the objective is flow times distance."""
    if kind == "equal":
        rows = max(k for k in range(1, math.isqrt(objects) + 1) if objects % k == 0 or k == math.isqrt(objects))
        columns, side = math.ceil(objects / rows), round(2.0 / math.sqrt(tightness), 3)
        width, depth = round(columns * side, 3), round(rows * side, 3)
        places = [divmod(k, columns) for k in range(objects)]
        boxes: list[Box] = [(c * side, r * side, (c + 1) * side, (r + 1) * side) for r, c in places]
    else:
        areas = [4 * a for a in _areas(objects, SPREAD[kind], rng)]
        width, depth, boxes = _cut(areas, 1.0 / tightness, rng)
    plan = Plan(rectangle(0.0, 0.0, width, depth))
    ids = _blocks(plan, "department", boxes, tightness, rng)
    plan.objective = flows(ids, 0.5 if objects <= 20 else 0.3, rng)
    return plan


def floor_plans(objects: int, tightness: float, kind: str, rng: np.random.Generator) -> Plan:
    """Rooms as blocks in the outline of a building, some beside others, some at the outer wall; flows between them."""
    areas = [float(a) * float(rng.uniform(0.85, 1.2)) for a in rng.choice(ROOMS, objects)]
    areas = [a for k in range(0, objects, ALIKE) for a in sorted(areas[k : k + ALIKE])]
    whole = sum(areas) / tightness + cells.PORCH**2
    shells = cells.rectangles(kind, whole, float(rng.uniform(1.0, 1.5)))
    boxes = cells.cut(shells, [a / tightness for a in areas], rng)
    plan = Plan(cells.outline_of(shells), doors=[DOOR])
    walls = walls_of(plan.outline)
    outside = []
    for k, box in enumerate(boxes):
        (x, y), (dx, dy) = _inside(box, tightness)
        cell = cells.with_walls(box, walls)
        facing = (int(rng.choice(cell.walls)) + 2) % 4 if cell.walls else int(rng.integers(4))
        size = (dx, dy) if facing % 2 == 0 else (dy, dx)
        if cell.walls:  # close to its wall
            slack = ((box[2] - box[0], box[3] - box[1])[facing % 2] - size[0]) / 2 - 0.02
            x, y = x - slack * (1, 0, -1, 0)[facing], y - slack * (0, 1, 0, -1)[facing]
            outside.append(f"room-{k}")
        plan.add(f"room-{k}", (x, y), (*size, 2.4), facing * math.pi / 2)
    for name in outside:
        if rng.random() < 0.6:
            plan.relate("against_wall", name)
    _beside(plan, rng)
    plan.objective = flows([o["id"] for o in plan.objects], 0.25, rng)
    return plan


def _beside(plan: Plan, rng: np.random.Generator) -> None:
    """Ties between rooms that are beside each other: what holds all together, and some more."""
    scene = plan.scene()
    feet = [footprint(item) for item in scene.objects]
    pairs = []
    for a in range(len(feet)):
        for b in range(a):
            gap = float(feet[a].distance(feet[b]))
            near = (
                feet[a]
                .buffer(gap / 2 + 0.01, join_style="mitre")
                .intersection(feet[b].buffer(gap / 2 + 0.01, join_style="mitre"))
            )
            if gap < 1.0 and near.length / 2 > TOUCH:
                pairs.append((a, b, gap))
    group = list(range(len(feet)))
    for k in rng.permutation(len(pairs)):
        a, b, gap = pairs[k]
        if group[a] != group[b] or rng.random() < LINKED:
            plan.relate("near", scene.ids[a], scene.ids[b], max=round(gap + 0.1, 2))
            group = [group[a] if g == group[b] else g for g in group]
    if len(set(group)) > 1:
        raise NoFit("some rooms are beside none of the others")


def warehouses(objects: int, tightness: float, kind: str, rng: np.random.Generator) -> Plan:
    """Racks in rows back to back, with aisles before them that two rows share, and docks; the objective is picking.

    ``kind`` "rows": racks of one width; "mixed": of several.
    """
    docks = 2
    racks = objects - docks
    each = next((k for k in (6, 5, 7, 4, 8, 3, 9, 10, 2) if racks % (2 * k) == 0), None)
    if each is None:
        raise NoFit("so many racks are in no even number of rows")
    widths = rng.choice((1.8, 2.2, 2.7) if kind == "mixed" else (2.7,), each)
    ids = rng.permutation(racks)
    low, high = 0.012, 1.2
    for _ in range(14):  # the more air the less of the floor is taken
        air = (low + high) / 2
        plan = _rows(racks // each, widths, air, ids)
        found = tightness_of(plan.scene())
        low, high = (air, high) if found > tightness else (low, air)
        if abs(found - tightness) < 0.005:
            break
    else:
        raise NoFit("the tightness was not reached")
    ranks = 1 + rng.permutation(racks)
    for k in range(racks):
        picks = math.ceil(40.0 / float(ranks[k]) ** 0.8)
        for dock, share in (("dock-0", 0.6), ("dock-1", 0.4)):
            plan.objective.append(flow(f"rack-{k}", dock, round(share * picks, 2)))
    return plan


def _rows(rows: int, widths: np.ndarray, air: float, ids: np.ndarray) -> Plan:
    """Pairs of rows that face each other over an aisle, beside a strip with the docks."""
    pitch = 2 * RACK_DEPTH + AISLE + 2 * air
    width = round(STRIP + float(widths.sum()) + air * (len(widths) + 1), 3)
    plan = Plan(rectangle(0.0, 0.0, width, round(rows / 2 * pitch, 3)), doors=[])
    depth = plan.outline[2][1]
    for k, y in enumerate((0.3 * depth, 0.7 * depth)):
        zone = {"name": "apron", "polygon": rectangle(DOCK[0] / 2, -DOCK[1] / 2, DOCK[0] / 2 + 1.2, DOCK[1] / 2)}
        zones = [{**zone, "z": [0, 1.8], "hard": True}]
        plan.add(f"dock-{k}", (DOCK[0] / 2 + 0.01, y), DOCK, 0.0, zones=zones, fixed=True)
    for row in range(rows):
        up = row % 2 == 0
        back = RACK_DEPTH / 2 + min(air, 0.04) / 2
        y = row // 2 * pitch + (back if up else pitch - back)
        x = STRIP + air
        for column, long in enumerate(widths):
            name = f"rack-{ids[row * len(widths) + column]}"
            front = rectangle(RACK_DEPTH / 2, -long / 2, RACK_DEPTH / 2 + AISLE, long / 2)
            zones = [{"name": "front", "polygon": front, "z": [0, 1.8], "hard": True}]
            at = (x + float(long) / 2, y)
            plan.add(name, at, (RACK_DEPTH, long, 2.4), (0.5 if up else -0.5) * math.pi, zones=zones)
            x += float(long) + air
            if row == 0 or row == rows - 1:
                plan.relate("against_wall", name)
            elif up:
                plan.relate("back_to_back", name, f"rack-{ids[(row - 1) * len(widths) + column]}")
    plan.objects.sort(key=lambda o: (o["category"], int(o["id"].rpartition("-")[2])))
    return plan


PLANS: dict[str, tuple[Callable[[int, float, str, np.random.Generator], Plan], tuple[str, ...]]] = {
    "chips": (chips, ("gsrc", "mcnc")),
    "facilities": (facilities, ("equal", "unequal")),
    "floor_plans": (floor_plans, ("rectangle", "L", "T", "U", "S")),
    "warehouses": (warehouses, ("rows", "mixed")),
}
"""What makes a plan of each family, and its kinds; the first one unless said."""
