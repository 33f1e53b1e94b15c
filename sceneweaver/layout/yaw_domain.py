"""Domains of yaw: what the compiler and the engine's ends make of the angles that an object may take."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import SceneObject

SAME = 1.0e-6  # [rad] within which two angles are the same one


def yaws_of(obj: SceneObject) -> tuple[float, ...]:
    """The yaws [rad] from -pi to pi that an object may take, in the frame that it is solved in; none: any."""
    return tuple(math.radians(angle - 360.0 if angle > 180.0 else angle) for angle in obj.yaws)


def into_domain(yaws: tuple[float, ...], yaw: float) -> float:
    """The nearest yaw [rad] of a domain; the given one where that is in it, or where any is."""
    off = [abs(wrap_angle(own - yaw)) for own in yaws]
    if not off or min(off) <= SAME:
        return yaw
    return yaws[off.index(min(off))]


def into_domains(
    yaws: Sequence[tuple[float, ...]], movable: Sequence[bool] | np.ndarray, roots: np.ndarray, world: np.ndarray
) -> np.ndarray:
    """Layouts [B, N, 4] with the yaw of every root that may move in its domain; what it carries turns along."""
    bound = [i for i, own in enumerate(yaws) if own and movable[i] and roots[i] == i]
    if not bound:
        return world
    world = np.array(world, dtype=np.float64)
    for i in bound:
        own = np.array(yaws[i])
        off = np.abs(wrap_angle(own - world[:, i, 3, None]))
        nearest = own[np.argmin(off, axis=1)]
        spin = np.where(off.min(axis=1) <= SAME, 0.0, wrap_angle(nearest - world[:, i, 3]))
        cos, sin = np.cos(spin), np.sin(spin)
        for j in np.flatnonzero(roots == i):
            arm = world[:, j, :2] - world[:, i, :2]
            if j != i:
                world[:, j, 0] = world[:, i, 0] + cos * arm[:, 0] - sin * arm[:, 1]
                world[:, j, 1] = world[:, i, 1] + sin * arm[:, 0] + cos * arm[:, 1]
            world[:, j, 3] = world[:, j, 3] + spin
    return world


def turns_along(child: tuple[float, ...], parent: tuple[float, ...]) -> bool:
    """Whether every turn of a parent from one of its yaws to another leaves a child in its own domain.

    Only then the child may be moved with its parent as one rigid body.
    """
    if not child:
        return True
    if not parent:
        return False
    turned = [c + a - b for c in child for a in parent for b in parent]
    return all(any(abs(wrap_angle(t - c)) <= SAME for c in child) for t in turned)
