"""How far convex parts move, about a hinge or along a slide, before they meet others.

Two parts meet where no plane parts them: of those along the faces of either and, unless both are upright prisms, of the
exact least translation as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.verify import convex
from sceneweaver.verify.solids import Array

STEPS = 20
"""Positions at which a moving part is looked at, evenly over its range."""

DEPTH = 0.002
"""Depth [m] by which a moving part may reach into another before that is in its way."""

UPRIGHT = 1e-6
"""Share of a unit normal by which the face of an upright prism may lean."""


@dataclass(frozen=True)
class Block:
    """A convex part in the world: ``points`` [V, 3] [m], and the number of the body that it belongs to."""

    points: Array
    body: int

    @cached_property
    def normals(self) -> Array:
        """Unit normals of its faces, each direction once [F, 3]."""
        faces = convex.normals(self.points)
        if not len(faces):
            return np.eye(3)
        sign = np.sign(faces @ np.array([1.0, 1e-3, 1e-6]))
        return np.unique(np.round(faces * np.where(sign == 0, 1.0, sign)[:, None], 6), axis=0)

    @cached_property
    def upright(self) -> bool:
        """Whether it is a prism that stands."""
        lean = np.abs(self.normals[:, 2])
        return bool(np.all((lean < UPRIGHT) | (lean > 1 - UPRIGHT)))


class Motion(NamedTuple):
    """A joint in the world: "hinge" or "slide", its unit ``axis`` [3], a point on it [3], and how far it goes [rad, m]
    with its sign."""

    joint: str
    axis: Array
    anchor: Array
    travel: float

    def steps(self) -> tuple[Array, Array]:
        """Rotations [K + 1, 3, 3] and shifts [K + 1, 3] from closed to open: a point p goes to R p + t."""
        from scipy.spatial.transform import Rotation

        at = np.linspace(0.0, self.travel, STEPS + 1)
        if self.joint == "slide":
            return np.broadcast_to(np.eye(3), (STEPS + 1, 3, 3)), at[:, None] * self.axis
        turns = Rotation.from_rotvec(at[:, None] * self.axis).as_matrix()
        return turns, self.anchor - turns @ self.anchor


class Scenery:
    """All parts that may be in the way, with their boxes."""

    def __init__(self, blocks: Sequence[Block]) -> None:
        """``blocks`` in any order."""
        self.blocks = blocks
        points = np.concatenate([b.points for b in blocks]) if blocks else np.empty((0, 3))
        starts = np.cumsum([0, *(len(b.points) for b in blocks)])[:-1]
        self._low, self._high = np.minimum.reduceat(points, starts), np.maximum.reduceat(points, starts)
        self._body = np.array([b.body for b in blocks], dtype=int)

    def first_met(self, moving: Sequence[Block], motion: Motion, skip: Any) -> tuple[int, int | None]:
        """The steps of `STEPS` that are free, and the number of the body that ends them (None: nothing does).

        ``skip`` [bodies] says which are never in the way. What a part is in already when it is closed is in its way
        when it goes deeper.
        """
        turns, shifts = motion.steps()
        free, met, skipped = STEPS, None, skip[self._body]
        for part in moving:
            path = part.points @ turns.transpose(0, 2, 1) + shifts[:, None]
            low, high = path.min(axis=1), path.max(axis=1)
            near = (self._low < high.max(axis=0) - DEPTH).all(axis=1) & (self._high > low.min(axis=0) + DEPTH).all(
                axis=1
            )
            for k in np.flatnonzero(near & ~skipped).tolist():
                other = self.blocks[k]
                steps = np.flatnonzero(((low < self._high[k] - DEPTH) & (high > self._low[k] + DEPTH)).all(axis=1))
                steps = steps[(steps > 0) & (steps <= free)]
                if not len(steps):
                    continue
                at = np.concatenate([[0], steps])
                deep = _face_depths(part, other, path[at], turns[at])
                slack = DEPTH + max(0.0, float(deep[0]))
                for step, depth in zip(steps, deep[1:], strict=True):
                    if depth > slack and (
                        _vertical(motion, part, other) or convex.depth(path[step], other.points) > slack
                    ):
                        free, met = int(step) - 1, other.body
                        break
        return free, met


def _vertical(motion: Motion, part: Block, other: Block) -> bool:
    """Whether the faces alone tell whether the two meet."""
    stands = motion.joint == "slide" or abs(motion.axis[2]) > 1 - UPRIGHT
    return stands and part.upright and other.upright


def _face_depths(part: Block, other: Block, path: Array, turns: Array) -> Array:
    """Depth [m] along the face normals of either, at each position of a part [K, V, 3]; below 0 they are apart."""
    mine = part.normals @ turns.transpose(0, 2, 1)
    axes = np.concatenate([mine, np.broadcast_to(other.normals, (len(path), *other.normals.shape))], axis=1)
    a, b = path @ axes.transpose(0, 2, 1), other.points @ axes.transpose(0, 2, 1)
    reach = np.minimum(a.max(axis=1) - b.min(axis=1), b.max(axis=1) - a.min(axis=1))
    return reach.min(axis=1)
