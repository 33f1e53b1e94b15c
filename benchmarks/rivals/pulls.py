"""Relations as pulls: each says, at the present poses, how far its subject is from where it holds.

A pull takes poses [B, n, 3] and gives residuals of subject and target: [B, 3] each (x, y [m], yaw [rad] times an arm of
half a metre). Losses are half their squares; the place to go to is held still while the gradient is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from benchmarks.rivals.boxes import axes
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import CATALOGUE, Relation, Scene

Pull = Callable[[np.ndarray], np.ndarray]
ARM = 0.5
SIDES = {"front": (0, 1.0), "left": (1, 1.0), "back": (0, -1.0), "right": (1, -1.0)}
ANGLES = {"front": 0.0, "left": math.pi / 2, "back": math.pi, "right": -math.pi / 2}
SLACK = 0.7  # share of an interval that is aimed at


def beyond(value: np.ndarray, low: float | np.ndarray, high: float | np.ndarray) -> np.ndarray:
    """How far values are outside of [low, high] with their sign: the hinge."""
    return np.maximum(value - high, 0.0) - np.maximum(low - value, 0.0)


def shrunk(low: float, high: float) -> tuple[float, float]:
    """The middle of an interval, so that what is nearly there is there."""
    middle, half = (low + high) / 2, SLACK * (high - low) / 2
    return middle - half, middle + half


def _least(options: list[np.ndarray]) -> np.ndarray:
    """Of several residuals [B, 3] the smallest, candidate by candidate."""
    stack = np.stack(options)
    best = (stack * stack).sum(-1).argmin(0)
    return stack[best, np.arange(stack.shape[1])]


def _turn(wanted: np.ndarray | float, yaw: np.ndarray, degrees: float) -> np.ndarray:
    limit = SLACK * math.radians(degrees)
    return ARM * beyond(wrap_angle(yaw - wanted), -limit, limit)


class Room:
    """Walls of a counter-clockwise outline: corners, directions, inward normals, lengths."""

    def __init__(self, scene: Scene) -> None:
        self.p = np.array(scene.room.outline, dtype=float)
        t = np.roll(self.p, -1, axis=0) - self.p
        self.length = np.linalg.norm(t, axis=1)
        self.t = t / self.length[:, None]
        self.n = np.stack([-self.t[:, 1], self.t[:, 0]], -1)
        before = np.roll(self.t, 1, axis=0)
        self.convex = np.flatnonzero(before[:, 0] * self.t[:, 1] - before[:, 1] * self.t[:, 0] > 1e-9)


def build(scene: Scene, floor: np.ndarray) -> list[tuple[int, int, Pull]]:
    """Pulls of all relations among floor objects: (subject, target or -1, residual of the subject)."""
    room = Room(scene)
    index = {scene.objects[i].id: k for k, i in enumerate(floor)}
    size = np.array([scene.objects[i].size for i in floor]).reshape(-1, 3)
    pulls = []
    for rel in scene.relations:
        if rel.subject not in index:
            continue
        a = index[rel.subject]
        b = index.get(rel.target, -1) if isinstance(rel.target, str) else -1
        pull = _pull(scene, room, rel, a, b, size)
        if pull is not None:
            pulls.append((a, b, pull))
    return pulls


def _pull(scene: Scene, room: Room, rel: Relation, a: int, b: int, size: np.ndarray) -> Pull | None:
    spec = CATALOGUE[rel.type]
    if rel.type in ("against_wall", "side_against_wall"):
        return _walls(room, rel, a, size)
    if rel.type == "in_corner":
        return _corner(room, a, size)
    if rel.type == "at_window":
        return _window(scene, room, rel, a, size)
    if b < 0:
        return None
    if spec.subject_sides and spec.target_sides:
        return _faces(rel, a, b, size)
    if rel.type == "centered_on":
        return lambda x: _centred(x, a, b)
    if rel.type == "near":
        return lambda x: _near(x, a, b, size, spec.value(rel, "max"))
    if rel.type == "facing":
        return lambda x: _facing(x, a, b, spec.value(rel, "degrees"))
    if rel.type in ("aligned", "parallel"):
        step = math.pi / 2 if rel.type == "aligned" else math.pi
        return lambda x: _aligned(x, a, b, step, spec.value(rel, "degrees") or 3.0)
    return None


def _pack(xy: np.ndarray, turn: np.ndarray) -> np.ndarray:
    return np.concatenate([xy, turn[:, None]], axis=1)


def _walls(room: Room, rel: Relation, a: int, size: np.ndarray) -> Pull:
    spec = CATALOGUE[rel.type]
    low, high = shrunk(*spec.gap_range(rel, size[a, 0]))
    degrees = spec.value(rel, "degrees")
    target = rel.target if isinstance(rel.target, str) else None
    walls = [int(target.partition(":")[2])] if target else range(len(room.p))

    def pull(x: np.ndarray) -> np.ndarray:
        options = []
        for w in walls:
            for side in spec.subject_sides:
                k, _ = SIDES[side]
                half, width = size[a, k] / 2, size[a, 1 - k] / 2
                d = x[:, a, :2] - room.p[w]
                off = beyond(d @ room.n[w] - half, low, high)
                inset = min(width, room.length[w] / 2)
                aside = beyond(d @ room.t[w], inset, room.length[w] - inset)
                wanted = math.atan2(-room.n[w, 1], -room.n[w, 0]) - ANGLES[side]
                xy = off[:, None] * room.n[w] + aside[:, None] * room.t[w]
                options.append(_pack(xy, _turn(wanted, x[:, a, 2], degrees)))
        return _least(options)

    return pull


def _extent(x: np.ndarray, a: int, size: np.ndarray, n: np.ndarray) -> np.ndarray:
    return np.abs(axes(x[:, a, 2]) @ n) @ (size[a, :2] / 2)


def _corner(room: Room, a: int, size: np.ndarray) -> Pull:
    def pull(x: np.ndarray) -> np.ndarray:
        options = []
        for c in room.convex:
            xy = np.zeros((len(x), 2))
            for w in (c, c - 1):
                off = (x[:, a, :2] - room.p[c]) @ room.n[w] - _extent(x, a, size, room.n[w])
                xy += beyond(off, 0.02, 0.1)[:, None] * room.n[w]
            options.append(_pack(xy, np.zeros(len(x))))
        return _least(options)

    return pull


def _window(scene: Scene, room: Room, rel: Relation, a: int, size: np.ndarray) -> Pull:
    windows = [w for w in scene.room.windows if rel.target in (None, w.id)]

    def pull(x: np.ndarray) -> np.ndarray:
        options = []
        for window in windows:
            n, t = room.n[window.wall], room.t[window.wall]
            d = x[:, a, :2] - room.p[window.wall]
            off = beyond(d @ n - _extent(x, a, size, n), 0.0, 0.9)
            aside = beyond(d @ t, window.offset, window.offset + window.width)
            options.append(_pack(off[:, None] * n + aside[:, None] * t, np.zeros(len(x))))
        return _least(options)

    return pull


def _faces(rel: Relation, a: int, b: int, size: np.ndarray) -> Pull:
    """Side to side. Boxes cannot be tucked under each other, so gaps begin at zero."""
    spec = CATALOGUE[rel.type]
    low, high = spec.gap_range(rel, size[a, 0])
    low, high = shrunk(max(low, 0.0), high)
    degrees, overlap = spec.value(rel, "degrees"), spec.value(rel, "overlap")

    def pull(x: np.ndarray) -> np.ndarray:
        frame = axes(x[:, b, 2])
        d = x[:, a, :2] - x[:, b, :2]
        options = []
        for theirs in spec.target_sides:
            kb, sign = SIDES[theirs]
            out, along = sign * frame[:, kb], frame[:, 1 - kb]
            for ours in spec.subject_sides:
                ka, _ = SIDES[ours]
                width_a, width_b = size[a, 1 - ka], size[b, 1 - kb]
                off = beyond((d * out).sum(-1) - size[a, ka] / 2 - size[b, kb] / 2, low, high)
                reach = (width_a + width_b) / 2 - min(1.0, overlap + 0.1) * min(width_a, width_b)
                aside = beyond((d * along).sum(-1), -reach, reach)
                wanted = x[:, b, 2] + ANGLES[theirs] + math.pi - ANGLES[ours]
                options.append(_pack(off[:, None] * out + aside[:, None] * along, _turn(wanted, x[:, a, 2], degrees)))
        return _least(options)

    return pull


def _centred(x: np.ndarray, a: int, b: int) -> np.ndarray:
    frame = axes(x[:, b, 2])
    local = np.einsum("bij,bj->bi", frame, x[:, a, :2] - x[:, b, :2])
    smaller = np.abs(local).argmin(-1)
    rows = np.arange(len(x))
    return _pack(beyond(local[rows, smaller], -0.07, 0.07)[:, None] * frame[rows, smaller], np.zeros(len(x)))


def _near(x: np.ndarray, a: int, b: int, size: np.ndarray, most: float) -> np.ndarray:
    d = x[:, a, :2] - x[:, b, :2]
    distance = np.linalg.norm(d, axis=-1) + 1e-9
    reach = size[a, :2].min() / 2 + size[b, :2].min() / 2 + SLACK * most
    return _pack((np.maximum(distance - reach, 0.0) / distance)[:, None] * d, np.zeros(len(x)))


def _facing(x: np.ndarray, a: int, b: int, degrees: float) -> np.ndarray:
    d = x[:, b, :2] - x[:, a, :2]
    return _pack(np.zeros((len(x), 2)), _turn(np.arctan2(d[:, 1], d[:, 0]), x[:, a, 2], degrees))


def _aligned(x: np.ndarray, a: int, b: int, step: float, degrees: float) -> np.ndarray:
    turn = x[:, a, 2] - x[:, b, 2]
    return _pack(np.zeros((len(x), 2)), _turn(np.round(turn / step) * step, turn, degrees))
