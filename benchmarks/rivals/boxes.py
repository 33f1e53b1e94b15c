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


def placed(boxes: Boxes, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Middles [B, K, 2], axes [B, K, 2, 2] and arms from the owner [B, K, 2] at poses [B, n, 3] (x, y, yaw)."""
    mine = boxes.owner >= 0
    owner = np.maximum(boxes.owner, 0)
    yaw = np.where(mine, poses[:, owner, 2] if poses.shape[1] else 0.0, boxes.yaw)
    frame = axes(yaw)
    arm = np.einsum("ki,bkij->bkj", boxes.middle, np.where(mine[:, None, None], frame, np.eye(2)))
    base = poses[:, owner, :2] if poses.shape[1] else np.zeros_like(arm)
    return np.where(mine[:, None], base, 0.0) + arm, frame, np.where(mine[:, None], arm, 0.0)


def overlap_loss(boxes: Boxes, pairs: np.ndarray, poses: np.ndarray, margin: float, gradient: np.ndarray) -> np.ndarray:
    """Sum of squared depths (with a margin [m]) over box pairs [P, 2]: loss [B]; adds to gradient [B, n, 3]."""
    if not len(pairs):
        return np.zeros(len(poses))
    middle, frame, arm = placed(boxes, poses)
    a, b = pairs.T
    d = middle[:, b] - middle[:, a]
    axis = np.concatenate([frame[:, a], frame[:, b]], axis=2)  # [B, P, 4, 2]
    along = np.einsum("bpkj,bpj->bpk", axis, d)
    dot = [np.einsum("bpij,bpkj->bpki", frame[:, k], axis) for k in (a, b)]
    reach = sum(np.einsum("pi,bpki->bpk", boxes.half[k], np.abs(o)) for k, o in zip((a, b), dot, strict=True))
    depth = reach - np.abs(along) + margin
    best = depth.argmin(axis=-1)[..., None]
    depth = np.take_along_axis(depth, best, -1)[..., 0]
    hit = np.maximum(depth, 0.0)
    u = np.take_along_axis(axis, best[..., None], 2)[:, :, 0]
    sign = np.sign(np.take_along_axis(along, best, -1))
    pull = 2 * hit[..., None]
    push = pull * sign * u  # gradient by the first middle; the other way round by the second
    owns = best[..., 0] < 2  # whose axis it is, turns with it
    turn_axis = -sign[..., 0] * np.einsum("bpj,bpj->bp", _quarter(u), d)
    spin = []
    for k, other in ((a, b), (b, a)):
        mine = owns if k is a else ~owns
        e = frame[:, k]
        # an axis of the other one: our own extent changes as we turn; our own axis: the other's extent does
        own = np.einsum("pi,bpi->bp", boxes.half[k], np.sign(_dots(e, u)) * _dots(_quarter(e), u))
        f = frame[:, other]
        others = np.einsum("pi,bpi->bp", boxes.half[other], np.sign(_dots(f, u)) * _dots(f, _quarter(u)))
        spin.append(pull[..., 0] * np.where(mine, turn_axis + others, own))
    _add(gradient, boxes, a, push, spin[0], arm)
    _add(gradient, boxes, b, -push, spin[1], arm)
    return (hit * hit).sum(axis=1)


def _dots(frame: np.ndarray, u: np.ndarray) -> np.ndarray:
    return np.einsum("bpij,bpj->bpi", frame, u)


def _add(gradient: np.ndarray, boxes: Boxes, which: np.ndarray, push: np.ndarray, spin: np.ndarray, arm: np.ndarray):
    """Carry gradients by middle and turn of boxes over to the bodies that own them."""
    lever = np.einsum("bpj,bpj->bp", push, _quarter(arm[:, which]))
    full = np.concatenate([push, (spin + lever)[..., None]], axis=-1)
    owner = boxes.owner[which]
    for body in np.unique(owner[owner >= 0]):
        gradient[:, body] += full[:, owner == body].sum(axis=1)
