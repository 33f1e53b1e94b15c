"""Candidates of places on a support: the surface that is meant, how far things stray, where they lie before chairs."""

from __future__ import annotations

import math
import random

import numpy as np

from sceneweaver.geometry.angles import bearing, heading, wrap_angle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.knowledge.surfaces import Slot
from sceneweaver.scene import SceneObject, Surface

from .surface_field import Array, Field, Piece, Shape
from .surface_scene import Seat
from .surface_setting import Standing

SEAT_EDGE = 0.02
"""Distance [m] of a setting from the edge before its chair."""

STRAIGHT = math.radians(25)
"""Angle within which a setting is laid along the edge, although its chair stands askew."""


LATERAL = (0.0, 0.03, -0.03, 0.06, -0.06, 0.1, -0.1, 0.15, -0.15)
"""How far [m] aside of the middle of a chair a setting may lie."""

ROUND = 40.0
"""Yaw [degrees] from which on a thing that strays so far is a round one."""


def surfaces_of(obj: SceneObject, back: bool, top: bool = False) -> dict[str, Surface]:
    """The surfaces of a support by level, left and right as its user sees them; those that are not there are left out.

    The main one is the largest that is open and at a height to work at, or with ``top`` the highest.
    """

    def worth(s: Surface) -> float:
        ring = np.asarray(s.polygon)
        x, y = ring[:, 0], ring[:, 1]
        area = abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))) / 2
        tight = s.headroom is not None and s.headroom < 0.2
        high = s.z > 1.12 and s.z < obj.size[2] - 0.02
        return area * (0.3 if tight else 1.0) * (0.4 if high else 1.0) * (0.4 if s.z < 0.5 * obj.size[2] - 0.15 else 1)

    def side(s: Surface) -> float:
        y = float(np.mean([p[1] for p in s.polygon]))
        return -y if back else y

    main = max(obj.surfaces, key=(lambda s: s.z) if top else worth)
    level = [s for s in obj.surfaces if abs(s.z - main.z) < 0.1]
    found = {"main": main, "left": min(level, key=side), "right": max(level, key=side)}
    lower = [s for s in obj.surfaces if s.z < main.z - 0.1]
    upper = [s for s in obj.surfaces if s.z > main.z + 0.05]
    if lower:
        found["lower"] = max(lower, key=lambda s: s.z)
    if upper:
        found["upper"] = max(upper, key=lambda s: s.z)
    return found


class Spread:
    """What chance decides about one slot, drawn once: kind, yaw, and how far it strays."""

    def __init__(self, slot: Slot, dice: random.Random, mirror: bool, clutter: float = CLUTTER):
        """``clutter`` in 0..1 scales how far things stray, but for round ones, which have no side to align."""
        astray = min(2.0, clutter / CLUTTER)
        self._slot = slot
        sign = -1.0 if mirror else 1.0
        self._first = dice.random()
        self.stray = math.radians(slot.loose) * dice.uniform(-1, 1) * (astray if slot.loose < ROUND else 1.0)
        self.yaw = sign * math.radians(slot.turn) + self.stray
        self.drift = np.array([dice.uniform(-1, 1), dice.uniform(-1, 1)]) * slot.drift * astray
        at = slot.at or (0.5, 0.0)
        self.share = (at[0], sign * at[1])
        self._sign = sign
        self._some = dice.random() < 0.5

    def kinds(self) -> tuple[str, ...]:
        """The slot's categories, the one to try first in front: mostly the first of them."""
        what = self._slot.what
        k = 0 if self._slot.need == "needed" else min(int(self._first**1.6 * len(what)), len(what) - 1)
        return (what[k], *what[:k], *what[k + 1 :])

    def beside(self, piece: Piece, anchor: Standing, other: Piece) -> list[Array]:
        """Places [2] at the slot's side of what stands there, nearest to what is meant first."""
        side = self._slot.side
        ways = {"front": (1, 0), "back": (-1, 0), "right": (0, 1), "left": (0, -1)}
        if side == "beside":
            first, second = ("right", "left") if (self._sign > 0) == self._some else ("left", "right")
            order = [first, second, "back", "front"]
        else:
            order = [side]
        facing = anchor.yaw if anchor.seat is not None else 0.0  # a person sees it from the chair
        goals = []
        for name in order:
            way = np.array(SE2(yaw=facing).world(*ways[name]))
            goals.append(anchor.at + way * (_reach(other, way) + _reach(piece, -way) + self._slot.gap))
        return goals


def _reach(piece: Piece, way: Array) -> float:
    """How far a piece reaches along a unit vector [m]."""
    return max(float((p.polygon @ way).max()) for p in piece.shape.turned(piece.yaw).prisms)


def before_seat(shape: Shape, field: Field, seat: Seat, stray: float) -> tuple[Array, float] | None:
    """Where a thing lies before a chair, at the edge and facing it: place [2] and yaw; None when there is no room."""
    yaw = bearing(seat.look, (0.0, 0.0))
    edge = _edge_yaw(field, seat)
    if edge is not None and abs(wrap_angle(edge - yaw)) < STRAIGHT:
        yaw = edge
    look = -np.array(heading(yaw))
    aside = np.array([-look[1], look[0]])
    # Lines from the seat inward, the one straight ahead first; a place aside counts as one farther in.
    ahead, lateral = (a.ravel() for a in np.meshgrid(np.arange(0.0, 1.6, 0.01), LATERAL))
    line = seat.place + aside * lateral[:, None] + ahead[:, None] * look
    pieces = [Piece(shape, yaw + stray)]
    at = field.place(pieces, [line[np.argsort(ahead + 2.5 * np.abs(lateral), kind="stable")]])
    if at is None:
        return None
    inward = field.place(pieces, [np.stack([at + SEAT_EDGE * look, at + SEAT_EDGE / 2 * look, at])])
    return at if inward is None else inward, yaw + stray


def _edge_yaw(field: Field, seat: Seat) -> float | None:
    """Direction of the straight edge before a seat, outward; None at a round table."""
    ring = field.polygon
    step = np.roll(ring, -1, axis=0) - ring
    length = np.hypot(step[:, 0], step[:, 1])
    long = length > 0.35
    if not long.any():
        return None
    out = np.column_stack([step[:, 1], -step[:, 0]])[long] / length[long, None]
    k = int(np.argmax(out @ -seat.look))
    return math.atan2(out[k, 1], out[k, 0])
