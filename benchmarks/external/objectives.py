"""What a problem asks to be minimised, as solvers outside of the engine see it: nets of pins, and flows.

Terms have a ``kind`` ("wire_length" or "flow"; rivals do not see others), ``objects``, ``weight`` and ``params``.
Values are computed here in float64, not by the engine.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

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


def nets_of(problem: Problem, terms: Sequence[Any]) -> list[Net]:
    """The nets and flows among terms, in the frame of `quarter_turns`."""
    view, found = quarter_turns(problem), []
    for term in terms:
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


class Lengths:
    """The weighted length [m] of nets and flows at quarter turns, for many calls."""

    def __init__(self, nets: list[Net], view: QuarterTurns) -> None:
        pins = [pin for net in nets for pin in net.pins]
        self.weight = np.array([net.weight for net in nets])
        self.crooked = np.array([net.boxed or net.power == 1 for net in nets], dtype=bool)
        self.start = np.cumsum([0, *(len(net.pins) for net in nets)])[:-1]
        self.body = np.array([body for body, _ in pins], dtype=int)
        self.offset = np.zeros((len(pins), 4, 2))  # from the body at each turn, or where a pin stands still
        for row, (body, (x, y)) in zip(self.offset, pins, strict=True):
            yaws = view.bodies[body].yaws if body >= 0 else np.zeros(1)
            c, s = np.cos(yaws), np.sin(yaws)
            row[: len(yaws)] = np.stack([c * x - s * y, s * x + c * y], axis=1)

    def __call__(self, xy: np.ndarray, turns: np.ndarray) -> float:
        """At positions [n, 2] and turns [n]."""
        if not len(self.body):
            return 0.0
        still = self.body < 0
        at = self.offset[np.arange(len(self.body)), np.where(still, 0, turns[self.body])]
        at += np.where(still[:, None], 0.0, xy[self.body])
        span = np.maximum.reduceat(at, self.start) - np.minimum.reduceat(at, self.start)
        return float(self.weight @ np.where(self.crooked, span.sum(axis=1), np.hypot(*span.T)))


def objective_of(problem: Problem, terms: Sequence[Any], poses: np.ndarray) -> np.ndarray:
    """The objective [B] of layouts [B, N, 4]."""
    nets, view = nets_of(problem, terms), quarter_turns(problem)
    return np.array([slope(nets, view, layout)[0] for layout in np.asarray(poses, dtype=np.float64)])


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
