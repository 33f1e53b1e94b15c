"""Overlap of turned boxes in batches: penetration by separating axes, with its gradient."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Boxes:
    """Boxes that belong to bodies: owner (-1: the room), middle in the owner's frame, half size, heights.

    Shapes [K], [K, 2], [K, 2], [K, 2]; boxes of the room are in the world's frame, turned by ``yaw`` [K].
    """

    owner: np.ndarray
    middle: np.ndarray
    half: np.ndarray
    z: np.ndarray
    yaw: np.ndarray


def axes(yaw: np.ndarray) -> np.ndarray:
    """Front and left of bodies turned by ``yaw`` [...]: [..., 2 axes, 2]."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.stack([np.stack([c, s], -1), np.stack([-s, c], -1)], -2)


def _quarter(v: np.ndarray) -> np.ndarray:
    """Vectors [..., 2] turned by 90 degrees, their derivative by the angle."""
    return np.stack([-v[..., 1], v[..., 0]], -1)


def _dot(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Products of vectors [..., 2]; much quicker than einsum on an axis of two."""
    return u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]


def placed(boxes: Boxes, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Middles [B, K, 2], axes [B, K, 2, 2] and arms from the owner [B, K, 2] at poses [B, n, 3] (x, y, yaw)."""
    mine = boxes.owner >= 0
    owner = np.maximum(boxes.owner, 0)
    yaw = np.where(mine, poses[:, owner, 2] if poses.shape[1] else 0.0, boxes.yaw)
    frame = axes(yaw)
    arm = np.einsum("ki,bkij->bkj", boxes.middle, np.where(mine[:, None, None], frame, np.eye(2)))
    base = poses[:, owner, :2] if poses.shape[1] else np.zeros_like(arm)
    return np.where(mine[:, None], base, 0.0) + arm, frame, np.where(mine[:, None], arm, 0.0)


class Pairs:
    """Pairs of boxes [P, 2], in which order they add up to the bodies that own them."""

    def __init__(self, boxes: Boxes, pairs: np.ndarray) -> None:
        self.pairs = pairs
        self.sums = [_sums(boxes.owner[side]) for side in pairs.T]

    def near(self, boxes: Boxes, poses: np.ndarray, slack: float) -> Pairs:
        """Those that may touch in some candidate before a body has moved by half of ``slack`` [m]."""
        middle, _, _ = placed(boxes, poses)
        a, b = self.pairs.T
        radius = np.linalg.norm(boxes.half, axis=1)
        reach = radius[a] + radius[b] + slack
        d = middle[:, b] - middle[:, a]
        return Pairs(boxes, self.pairs[((d * d).sum(-1) < reach * reach).any(axis=0)])


def _sums(owner: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs ordered by owner (those of the room left out), where each owner's begin, and the owners."""
    order = np.argsort(owner, kind="stable")
    order = order[owner[order] >= 0]
    bodies, starts = np.unique(owner[order], return_index=True)
    return order, starts, bodies


def overlap_loss(boxes: Boxes, pairs: Pairs, poses: np.ndarray, margin: float, gradient: np.ndarray) -> np.ndarray:
    """Sum of squared depths (with a margin [m]) over box pairs: loss [B]; adds to gradient [B, n, 3]."""
    if not len(pairs.pairs):
        return np.zeros(len(poses))
    middle, frame, arm = placed(boxes, poses)
    a, b = pairs.pairs.T
    d = middle[:, b] - middle[:, a]
    axis = np.concatenate([frame[:, a], frame[:, b]], axis=2)  # [B, P, 4, 2]
    along = _dot(axis, d[:, :, None])
    reach = sum(boxes.half[k, i, None] * np.abs(_dot(frame[:, k, i, None], axis)) for k in (a, b) for i in (0, 1))
    depth = reach - np.abs(along) + margin
    best = depth.argmin(axis=-1)[..., None]
    depth = np.take_along_axis(depth, best, -1)[..., 0]
    hit = np.maximum(depth, 0.0)
    u = np.take_along_axis(axis, best[..., None], 2)[:, :, 0]
    sign = np.sign(np.take_along_axis(along, best, -1))
    pull = 2 * hit[..., None]
    push = pull * sign * u  # gradient by the first middle; the other way round by the second
    owns = best[..., 0] < 2  # whose axis it is, turns with it
    turn_axis = -sign[..., 0] * _dot(_quarter(u), d)
    spin = []
    for k, other in ((a, b), (b, a)):
        mine = owns if k is a else ~owns
        e = frame[:, k]
        # an axis of the other one: our own extent changes as we turn; our own axis: the other's extent does
        own = _widen(boxes.half[k], _dots(e, u), _dots(_quarter(e), u))
        f = frame[:, other]
        others = _widen(boxes.half[other], _dots(f, u), _dots(f, _quarter(u)))
        spin.append(pull[..., 0] * np.where(mine, turn_axis + others, own))
    _add(gradient, pairs.sums[0], push, spin[0], arm[:, a])
    _add(gradient, pairs.sums[1], -push, spin[1], arm[:, b])
    return (hit * hit).sum(axis=1)


def _dots(frame: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Products of both axes [B, P, 2, 2] with vectors [B, P, 2]."""
    return _dot(frame, u[:, :, None])


def _widen(half: np.ndarray, along: np.ndarray, change: np.ndarray) -> np.ndarray:
    """How the extent of boxes grows when their axes' products with a direction change."""
    grow = half * np.sign(along) * change
    return grow[..., 0] + grow[..., 1]


def _add(
    gradient: np.ndarray,
    sums: tuple[np.ndarray, np.ndarray, np.ndarray],
    push: np.ndarray,
    spin: np.ndarray,
    arm: np.ndarray,
) -> None:
    """Carry gradients by middle and turn of boxes over to the bodies that own them."""
    order, starts, bodies = sums
    if len(order):
        lever = _dot(push, _quarter(arm))
        full = np.concatenate([push, (spin + lever)[..., None]], axis=-1)
        gradient[:, bodies] += np.add.reduceat(full[:, order], starts, axis=1)
