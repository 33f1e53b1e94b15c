"""What a problem asks to be minimised, as solvers outside of the engine see it: nets of pins, and flows.

Terms are those of ``problem.objective`` where a problem has any (kinds ``wire_length`` and ``flow``; others are not
seen by the rivals). Values are computed here in float64, not by the engine.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from sceneweaver.layout import Problem

from .quarter_turns import QuarterTurns, quarter_turns


class Net(NamedTuple):
    """Pins (body, or -1; offset in its frame, or the place in the view's frame), and the weight of a metre.

    ``boxed``: half the perimeter around the pins; else the distance of two, with the power of its metric (1 or 2).
    """

    weight: float
    pins: tuple[tuple[int, tuple[float, float]], ...]
    boxed: bool
    power: int


def nets_of(problem: Problem) -> list[Net]:
    """The nets and flows that a problem's objective asks for, in the frame of `quarter_turns`."""
    view, found = quarter_turns(problem), []
    for term in getattr(problem, "objective", None) or ():
        if term.kind not in ("wire_length", "flow"):
            continue
        params = term.params or {}
        offsets = params.get("pins") or [(0.0, 0.0)] * len(term.objects)
        pins = []
        for name, offset in zip(term.objects, offsets, strict=True):
            if name in view.names:
                pins.append((view.names[name], (float(offset[0]), float(offset[1]))))
            else:
                pins.append((-1, tuple(map(float, view.points[name]))))
        power = 1 if params.get("metric") == "manhattan" else 2
        found.append(Net(float(term.weight), tuple(pins), term.kind == "wire_length", power))
    return found


def length(nets: list[Net], yaws: list[np.ndarray], xy: np.ndarray, turns: np.ndarray) -> np.ndarray:
    """Weighted length [B] [m] at positions [B, n, 2] and turns [B, n]; ``yaws`` by body and turn."""
    total = np.zeros(len(xy))
    for net in nets:
        pins = []
        for body, (x, y) in net.pins:
            if body < 0:
                pins.append(np.broadcast_to((x, y), (len(xy), 2)))
                continue
            yaw = yaws[body][turns[:, body]]
            c, s = np.cos(yaw), np.sin(yaw)
            pins.append(xy[:, body] + np.stack([c * x - s * y, s * x + c * y], axis=-1))
        points = np.stack(pins, axis=1)
        span = points.max(axis=1) - points.min(axis=1)
        total += net.weight * (span.sum(axis=1) if net.boxed or net.power == 1 else np.hypot(*span.T))
    return total


def objective_of(problem: Problem) -> Callable[[np.ndarray], np.ndarray] | None:
    """The objective of layouts [B, N, 4], or None. Yaws are rounded to the view's: exact at quarter turns."""
    nets = nets_of(problem)
    if not nets:
        return None
    view = quarter_turns(problem)
    yaws = [body.yaws for body in view.bodies]
    return lambda poses: length(nets, yaws, *view.spot(np.asarray(poses, dtype=np.float64)))


def slope(nets: list[Net], view: QuarterTurns, poses: np.ndarray) -> tuple[float, np.ndarray]:
    """Value of nets and flows of a layout [N, 4] at any yaws, and its derivative [N, 4]."""
    total, by_pose = 0.0, np.zeros(poses.shape)
    c, s = np.cos(view.angle), np.sin(view.angle)
    back = np.array([[c, s], [-s, c]])
    for net in nets:
        points, arms = [], []
        for body, offset in net.pins:
            if body < 0:
                points.append(np.array(offset))
                arms.append(np.zeros(2))
                continue
            x, y, _, yaw = poses[view.bodies[body].index]
            arm = back @ np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]]) @ offset
            points.append(back @ (x, y) + arm)
            arms.append(arm)
        at = np.array(points)
        push = np.zeros_like(at)
        if net.boxed or net.power == 1:
            for d in (0, 1):
                push[at[:, d].argmax(), d] += 1.0
                push[at[:, d].argmin(), d] -= 1.0
            total += net.weight * float(np.ptp(at, axis=0).sum())
        else:
            d = at[0] - at[1]
            far = float(np.hypot(*d))
            push[0], push[1] = d / (far + 1e-9), -d / (far + 1e-9)
            total += net.weight * far
        for (body, _), pull, arm in zip(net.pins, net.weight * push, arms, strict=True):
            if body >= 0:
                index = view.bodies[body].index
                by_pose[index, :2] += back.T @ pull
                by_pose[index, 3] += arm[0] * pull[1] - arm[1] * pull[0]
    return total, by_pose
