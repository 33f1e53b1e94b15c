"""Tight bedrooms, one for every seed, each in a valid layout (its witness).

Sizes of furniture, door and window are drawn. Then pieces are put into corners and flush with what stands there, their
backs to walls, over and over, until all fit: first in a room of which furniture covers the share that was drawn, then
in ever larger ones of the same shape.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np

from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import SCHEMA, Pose, Scene

FILL = (0.47, 0.56)  # share of the floor that furniture covers
ASPECT = (0.85, 1.2)
GROWTH = 1.01  # of the room's sides
TRIES = 300  # layouts that are tried in a room of one size
GAP = 0.03  # [m] behind furniture
TUCKED = 0.2  # [m] that a chair stands under its desk
CLEAR = 1.8  # [m] height of zones in front of furniture
WINDOW_DEPTH = 0.3  # [m] kept free of what is taller than the sill

THINGS = {"desk": (0.2, 0.55, 0.44), "nightstand-0": (0.2, 0.2, 0.4), "dresser": (0.17, 0.17, 0.3)}
"""Sizes [m] of what stands on furniture."""

Json = dict[str, Any]
Box = tuple[float, float, float, float]  # x0, y0, x1, y1


@dataclass(frozen=True)
class Piece:
    """Something that stands with its back to a wall. ``zone`` is the depth [m] of the clear space before it."""

    id: str
    depth: float
    width: float
    height: float
    zone: float = 0.0


@dataclass
class Layout:
    """A rectangular room while it is filled: boxes of bodies and zones, and where pieces stand (x, y, yaw)."""

    walls: tuple[Wall, ...]
    door: Box
    window: Box
    sill: float
    air: float
    bodies: list[Box] = field(default_factory=list)
    zones: list[Box] = field(default_factory=list)
    poses: dict[str, tuple[float, float, float]] = field(default_factory=dict)

    def fits(self, body: Box, zone: Box | None, height: float) -> bool:
        """Whether there is room for a body with a zone."""
        x1, y1 = self.walls[1].end
        if min(body[:2]) < 0 or body[2] > x1 or body[3] > y1 or _meet(body, self.door):
            return False
        if height > self.sill and _meet(body, self.window):
            return False
        if any(_meet(body, other) for other in (*self.bodies, *self.zones)):
            return False
        return zone is None or not any(_meet(zone, other) for other in self.bodies)

    def put(self, piece: Piece, wall: Wall, offset: float) -> bool:
        """Put a piece against a wall from an offset on, if it fits there."""
        body = _box(wall, offset, piece.width, GAP, GAP + piece.depth)
        front = GAP + piece.depth
        zone = _box(wall, offset, piece.width, front, front + piece.zone) if piece.zone else None
        if not self.fits(body, zone, piece.height + THINGS.get(piece.id, (0.0, 0.0, 0.0))[2]):
            return False
        self.bodies.append(body)
        self.zones += [zone] if zone else []
        yaw = math.atan2(wall.inward[1], wall.inward[0])
        self.poses[piece.id] = (*wall.point(offset + piece.width / 2, GAP + piece.depth / 2), yaw)
        return True

    def offsets(self, wall: Wall, width: float) -> list[float]:
        """Offsets along a wall from which something so wide is flush with a corner, a body or a zone."""
        ends = [(-math.inf, 0.0), (wall.length, math.inf)]
        for x0, y0, x1, y1 in (*self.bodies, *self.zones, self.door, self.window):
            at = [wall.coordinates(p)[0] for p in ((x0, y0), (x1, y1))]
            ends.append((min(at), max(at)))
        found = [high + self.air for _, high in ends] + [low - self.air - width for low, _ in ends]
        return [s for s in found if 0 < s < wall.length - width]

    def copy(self) -> Layout:
        """A layout that may be filled further."""
        return replace(self, bodies=[*self.bodies], zones=[*self.zones], poses=dict(self.poses))


def _meet(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _box(wall: Wall, offset: float, width: float, near: float, far: float) -> Box:
    points = np.array(wall.strip(offset, width, near, far))
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return float(x0), float(y0), float(x1), float(y1)


def _rectangle(depth: float, width: float, x: float = 0.0, y: float = 0.0) -> list[list[float]]:
    return [[x + i * depth / 2, y + j * width / 2] for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _pieces(rng: np.random.Generator) -> dict[str, Piece]:
    """Furniture of any size: a bed between two nightstands, a desk with a chair, a wardrobe, a dresser, a bookcase."""

    def draw(object_id: str, depth: tuple, width: tuple, height: tuple, zone: float = 0.0) -> Piece:
        d, w, h = (round(float(rng.uniform(*span)), 2) for span in (depth, width, height))
        return Piece(object_id, d, w, h, zone)

    pieces = [
        draw("bed", (1.95, 2.15), (0.9, 1.8), (0.5, 0.6)),
        draw("nightstand-0", (0.34, 0.46), (0.4, 0.5), (0.5, 0.6)),
        draw("nightstand-1", (0.34, 0.46), (0.4, 0.5), (0.5, 0.6)),
        draw("wardrobe", (0.55, 0.62), (1.0, 1.7), (2.0, 2.2), 0.6),
        draw("desk", (0.6, 0.75), (1.1, 1.5), (0.73, 0.76)),
        draw("chair", (0.44, 0.52), (0.44, 0.5), (0.78, 0.9)),
        draw("dresser", (0.42, 0.5), (0.8, 1.15), (0.75, 0.85), 0.5),
        draw("bookcase", (0.28, 0.36), (0.75, 1.0), (1.7, 2.0), 0.5),
    ]
    if rng.random() < 0.4:
        pieces.append(draw("locker", (0.38, 0.5), (0.45, 0.8), (1.7, 2.0), 0.5))
    return {p.id: p for p in pieces}


def _empty(width: float, depth: float, shares: np.ndarray) -> tuple[Layout, Json]:
    """An empty room and its data. ``shares`` say where door and window are."""
    walls = walls_of([(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)])
    door_wall, other = walls[int(4 * shares[0])], int(3 * shares[1])
    window_wall = walls[(door_wall.index + 1 + other) % 4]
    door_at = 0.1 + (door_wall.length - 1.1) * float(np.round(shares[2], 0 if shares[3] < 0.7 else 2))
    span = 1.0 + 0.5 * float(shares[4])
    window_at = (window_wall.length - span) * (0.2 + 0.6 * float(shares[5]))
    door = {"id": "door", "wall": door_wall.index, "offset": round(door_at, 2), "width": 0.9, "height": 2.05}
    window = {"id": "window", "wall": window_wall.index, "offset": round(window_at, 2), "width": round(span, 2)}
    room = {
        "type": "bedroom",
        "outline": [list(w.start) for w in walls],
        "doors": [door],
        "windows": [{**window, "sill": 0.95, "height": 1.2}],
    }
    return Layout(
        walls,
        _box(door_wall, door["offset"], 0.9, 0.0, 0.9),
        _box(window_wall, window["offset"], window["width"], 0.0, WINDOW_DEPTH),
        0.95,
        0.02,
    ), room


def _bed(layout: Layout, pieces: dict[str, Piece], rng: np.random.Generator) -> bool:
    """Put the bed between its nightstands, somewhere along a wall."""
    row = [pieces[object_id] for object_id in ("nightstand-0", "bed", "nightstand-1")]
    width = sum(p.width for p in row) + 2 * layout.air
    wall = layout.walls[int(rng.integers(4))]
    if wall.length <= width + 2 * layout.air:
        return False
    offset = float(rng.choice(layout.offsets(wall, width)))
    for piece in row:
        if not layout.put(piece, wall, offset):
            return False
        offset += piece.width + layout.air
    return True


def _desk(layout: Layout, desk: Piece, chair: Piece, wall: Wall, offset: float) -> bool:
    """Put a desk with its chair."""
    if not layout.put(desk, wall, offset):
        return False
    at, front = offset + (desk.width - chair.width) / 2, GAP + desk.depth
    seat = _box(wall, at, chair.width, front + layout.air, front + chair.depth - TUCKED)
    if not layout.fits(seat, None, chair.height):
        return False
    layout.bodies.append(seat)
    x, y = wall.point(offset + desk.width / 2, front + chair.depth / 2 - TUCKED)
    layout.poses[chair.id] = (x, y, math.atan2(-wall.inward[1], -wall.inward[0]))
    return True


def _spots(layout: Layout, piece: Piece, pieces: dict[str, Piece], rng: np.random.Generator) -> Iterator[Layout]:
    """Layouts with a piece more, in any order."""
    spots = [(wall, s) for wall in layout.walls for s in layout.offsets(wall, piece.width)]
    for k in rng.permutation(len(spots)):
        wall, offset = spots[k]
        more = layout.copy()
        desk = piece.id == "desk"
        if _desk(more, piece, pieces["chair"], wall, offset) if desk else more.put(piece, wall, offset):
            yield more


def _fill(layout: Layout, pieces: dict[str, Piece], rng: np.random.Generator) -> Layout | None:
    """One try to put all pieces."""
    layout = layout.copy()
    if not _bed(layout, pieces, rng):
        return None
    rest = [p for p in pieces.values() if p.id not in layout.poses and p.id != "chair"]
    for k in rng.permutation(len(rest)):
        more = next(_spots(layout, rest[k], pieces, rng), None)
        if more is None:
            return None
        layout = more
    return layout


def _object(piece: Piece, pose: tuple[float, float, float]) -> Json:
    d, w, h = piece.depth, piece.width, piece.height
    kind = piece.id.split("-")[0]
    parts = [{"polygon": _rectangle(d, w), "z": [0, h]}]
    if kind == "desk":
        sides = [_rectangle(d, 0.04, 0.0, i * (w / 2 - 0.02)) for i in (-1, 1)]
        parts = [{"polygon": _rectangle(d, w), "z": [h - 0.04, h]}]
        parts += [{"polygon": side, "z": [0, h - 0.04]} for side in sides]
    if kind == "chair":
        back = _rectangle(0.05, w, 0.025 - d / 2)
        parts = [{"polygon": _rectangle(d, w), "z": [0, 0.46]}, {"polygon": back, "z": [0.46, h]}]
    placed = Pose.from_yaw(pose[0], pose[1], 0.0, pose[2])
    data: Json = {
        "id": piece.id,
        "category": kind,
        "size": [d, w, h],
        "pose": {"position": list(placed.position), "quaternion": list(placed.quaternion)},
        "parts": parts,
    }
    if piece.zone:
        front = _rectangle(piece.zone, w, (d + piece.zone) / 2)
        data["zones"] = [{"name": "front", "polygon": front, "z": [0, CLEAR], "hard": True}]
    if h < 1.0 and kind not in ("bed", "chair"):
        data["surfaces"] = [{"name": "top", "polygon": _rectangle(d - 0.04, w - 0.04), "z": h}]
    return data


def _thing(below: Json, size: tuple[float, float, float]) -> Json:
    """Something in the middle of a surface."""
    x, y, _ = below["pose"]["position"]
    return {
        "id": f"thing-{below['id']}",
        "category": "box",
        "size": list(size),
        "mount": "surface",
        "support": {"object": below["id"], "surface": "top"},
        "pose": {"position": [x, y, below["surfaces"][0]["z"]], "quaternion": below["pose"]["quaternion"]},
    }


@cache
def tight_room(seed: int) -> Scene:
    """The tight bedroom of a seed, in its witness."""
    rng = np.random.default_rng([seed, 0x716874])
    pieces = _pieces(rng)
    area = sum(p.depth * p.width for p in pieces.values()) / rng.uniform(*FILL)
    aspect, shares = rng.uniform(*ASPECT), rng.random(6)
    found, scale = None, 1.0
    while found is None:
        width, depth = (round(scale * math.sqrt(v), 2) for v in (area * aspect, area / aspect))
        empty, room = _empty(width, depth, shares)
        tries = (_fill(empty, pieces, rng) for _ in range(TRIES))
        found = next((layout for layout in tries if layout is not None), None)
        scale *= GROWTH
    objects = [_object(piece, found.poses[object_id]) for object_id, piece in pieces.items()]
    by_id = {o["id"]: o for o in objects}
    objects += [_thing(by_id[object_id], size) for object_id, size in THINGS.items()]
    backs = [{"type": "against_wall", "subject": object_id} for object_id in pieces if object_id != "chair"]
    sides = [{"type": "leftright_to_leftright", "subject": f"nightstand-{k}", "target": "bed"} for k in range(2)]
    seat = {"type": "front_to_front", "subject": "chair", "target": "desk"}
    middle = {"type": "centered_on", "subject": "chair", "target": "desk", "hard": False}
    relations = [{"hard": True, **relation} for relation in (*backs, *sides, seat, middle)]
    return Scene.from_json(
        {"schema": SCHEMA, "id": f"tight-{seed}", "room": room, "objects": objects, "relations": relations}
    )
