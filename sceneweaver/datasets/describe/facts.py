"""The geometry of a scene that its descriptions speak of, measured once.

Directions in words are those of a visitor: in the doorway of the room's only door, looking straight in.
"""

from __future__ import annotations

import math
from collections import defaultdict
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Body, Opening, Placed

FLAT = 0.03
"""Height [m] up to which what lies on the floor is walked on, as a rug is."""

PLAIN = 0.7
"""Height [m] from which furniture has a front that is plain to see."""

CLOSE = 0.12
"""Distance [m] from a wall up to which something stands against it."""


def group_of(category: str) -> str:
    """The widest group of the taxonomy that a category belongs to."""
    return category_named(category).parent or "object"


def is_seat(body: Body) -> bool:
    """Whether it is a seat with a back, so that its front is plain to see."""
    category = body.item.category
    return group_of(category) in ("chair_group", "seating") and not has_role(category, "backless_seat")


def is_bed(body: Body) -> bool:
    """Whether it is a bed whose foot can be told from its head."""
    return group_of(body.item.category) == "bed_group" and body.item.category.endswith("bed")


def has_front(body: Body) -> bool:
    """Whether everyone sees where its front is."""
    category = body.item.category
    sides = category_named(category).sides
    if is_seat(body) or is_bed(body) or has_role(category, "display"):
        return True
    return "front" in sides and "back" not in sides and body.size[2] >= PLAIN


def is_watcher(body: Body) -> bool:
    """Whether people say of it that it faces something."""
    return is_seat(body) or has_role(body.item.category, "display")


class Facts:
    """A scene, placed, with what is often asked about it."""

    def __init__(self, scene: Scene):
        self.scene = scene
        self.placed = Placed.of(scene)
        self.bodies = self.placed.bodies
        self.by_id = self.placed.by_id
        self.names: Any = None

    @cached_property
    def by_category(self) -> dict[str, list[Body]]:
        """Bodies by category, in the order of the scene."""
        found = defaultdict(list)
        for body in self.bodies:
            found[body.item.category].append(body)
        return dict(found)

    @cached_property
    def furniture(self) -> list[Body]:
        """What stands on the floor and is no rug, the largest first."""
        standing = [b for b in self.bodies if b.item.mount == "floor" and b.z[1] > FLAT]
        return sorted(standing, key=lambda b: (-round(b.size[0] * b.size[1] * b.size[2], 6), b.id))

    @cached_property
    def carried(self) -> dict[tuple[str, str], list[Body]]:
        """What rests on a carrier, by its id and "on" or "in"."""
        found = defaultdict(list)
        for body in self.bodies:
            support = body.item.support
            if support is not None:
                surfaces = {s.name: s for s in self.by_id[support.object].item.surfaces}
                inner = surfaces[support.surface].headroom is not None
                found[support.object, "in" if inner else "on"].append(body)
        return dict(found)

    @cached_property
    def area(self) -> float:
        """Floor area [m2]."""
        return float(self.placed.floor.area)

    @cached_property
    def door(self) -> Opening | None:
        """The only door; None where there are several or none."""
        return self.placed.doors[0] if len(self.placed.doors) == 1 else None

    @cached_property
    def doorway(self) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
        """Of the only door: its middle on the wall [m], the unit vectors inward and to the left of who looks in."""
        if self.door is None:
            return None
        wall, item = self.door.wall, self.door.item
        middle = wall.point(item.offset + item.width / 2)
        (x, y) = wall.inward
        return np.array(middle, dtype=float), np.array((x, y)), np.array((-y, x))

    def from_door(self, body: Body) -> tuple[float, float] | None:
        """How far a body's centre is ahead and to the left [m] of who looks in from the doorway."""
        if self.doorway is None:
            return None
        start, inward, left = self.doorway
        away = np.array(body.centre) - start
        return float(away @ inward), float(away @ left)

    @cached_property
    def wall_names(self) -> dict[int, str]:
        """How walls are called that words can tell from all others, by number."""
        walls, names = self.placed.walls, {}
        windowed = {w.wall.index for w in self.placed.windows}
        doored = {d.wall.index for d in self.placed.doors}
        if len(windowed) == 1 and not windowed & doored:
            names[next(iter(windowed))] = "the wall with the window" + ("s" if len(self.placed.windows) > 1 else "")
        if self.doorway is not None and self.door is not None:
            _, inward, left = self.doorway
            sides = {"opposite the door": inward, "on the left": left, "on the right": -left}
            for words, direction in sides.items():
                facing = [w for w in walls if float(np.dot(w.outward, direction)) > 0.94]
                if len(facing) == 1:
                    names.setdefault(facing[0].index, f"the wall {words}")
        if len(doored) == 1:
            names[next(iter(doored))] = "the wall with the door" + ("s" if len(self.placed.doors) > 1 else "")
        return names

    def wall_at(self, body: Body, overlap: float = 0.6) -> int | None:
        """The wall that a body's back is against, or the only one that a side is; None where that is open."""
        if body.tilted:
            return None
        found = {}
        for side in ("back", "left", "right") if body.item.mount == "floor" else ("back",):
            face = body.face(side)
            for wall in self.placed.walls:
                if face.normal[0] * wall.outward[0] + face.normal[1] * wall.outward[1] < 0.99:
                    continue
                u, depth = wall.coordinates(face.centre)
                shared = min(u + face.half, wall.length) - max(u - face.half, 0.0)
                if -0.05 <= depth <= CLOSE and shared >= overlap * 2 * face.half:
                    found.setdefault(side, wall.index)
        if "back" in found:
            return found["back"]
        return next(iter(found.values())) if len(set(found.values())) == 1 else None

    def wall_gap(self, body: Body, index: int) -> float:
        """Distance [m] of a body's box from the line of a wall."""
        return min(float(self.placed.walls[index].coordinates(corner)[1]) for corner in body.corners)

    def holds(self, kind: str, subject: Body, target: Any, **params: Any) -> bool:
        """Whether a relation of the catalogue holds, by the judge."""
        relation = Relation(type=kind, subject=subject.id, target=target, params=params)
        return judge_relation(self.placed, relation).holds

    def beside_line(self, body: Body, a: Body, b: Body) -> tuple[float, float]:
        """Where a centre lies between two others: the share of the way along, and the distance aside [m]."""
        (x, y), (x0, y0), (x1, y1) = body.centre, a.centre, b.centre
        length = max(math.dist((x0, y0), (x1, y1)), 1e-9)
        u, v = (x1 - x0) / length, (y1 - y0) / length
        return ((x - x0) * u + (y - y0) * v) / length, abs((y - y0) * u - (x - x0) * v)

    def distance(self, a: Body, b: Body) -> float:
        """Distance between two footprints [m]."""
        return self.placed.distance(a, b)

    def boxes_apart(self, a: Body, b: Body) -> float:
        """A lower bound of `distance` that costs little: between the circles about the two boxes [m]."""
        away = math.dist(a.centre, b.centre)
        return max(0.0, away - (math.hypot(*a.size[:2]) + math.hypot(*b.size[:2])) / 2)
