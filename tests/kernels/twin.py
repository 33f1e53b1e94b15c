"""The energy as its definitions have it, in float64 NumPy: the reference that the kernels are tested against.

It reads a `layout.compile.LayoutProblem` (polygons, rows, relations), never the packed tables, so packing is tested
too. The energy is a list of terms. A term knows the objects that it depends on, how its value is shared among them, and
how to compute the value for K variants of their poses at once; its gradient is a central difference. Every object's
pose is independent of the others, also where a supporter would carry it along, and the options of relations are as
given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.kernels import tables as k
from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.layout.pack import MARGINS, WEIGHTS
from sceneweaver.layout.rows import Row
from sceneweaver.layout.shapes import Prism
from tests.kernels.features import FEATURES
from tests.kernels.polygons import placed, reach, separation, shared_height

FINE, COARSE = 1e-6, 3e-5  # steps of the central differences [m, rad]
NEARBY = 0.01  # [m] terms that are further than this from mattering are left out

Poses = np.ndarray  # [K, objects of the term, 4]: x, y, z, yaw


@dataclass(frozen=True)
class Term:
    """One term of the energy: ``value`` maps poses [K, len(objects), 4] to [K]; ``shares`` say whose it is.

    ``pulls`` is what the gradient has of it.
    """

    kind: str
    objects: tuple[int, ...]
    shares: tuple[float, ...]
    value: Callable[[Poses], np.ndarray]
    soft: bool = False
    pulls: float = 1.0


@dataclass
class Reference:
    """Energy of one layout: shares [N], soft parts of them [N], gradient [N, 4].

    ``rough`` [N] tells how much the gradient differs between the two step sizes: large where the energy has a kink.
    """

    share: np.ndarray
    soft: np.ndarray
    gradient: np.ndarray
    rough: np.ndarray

    @property
    def total(self) -> float:
        return float(self.share.sum())


# ---- terms


def huber(v: np.ndarray, knee: float) -> np.ndarray:
    """Penalty of a violation [m]: nothing below zero, quadratic up to the knee, then of slope 1."""
    v = np.maximum(v, 0.0)
    return np.where(v < knee, v * v / (2.0 * knee), v - knee / 2.0)


def too_close(first: Sequence[Prism], second: Sequence[Prism], aim: float, overlap_in_z: float, knee: float):
    """Penalty of two sets of prisms for every pair that meets in z and is closer than ``aim`` in the plane."""

    def value(poses: Poses) -> np.ndarray:
        one = poses[:, 0]
        two = poses[:, 1] if poses.shape[1] > 1 else np.zeros_like(one)
        e = np.zeros(len(poses))
        for p in first:
            for q in second:
                meets = shared_height(p, one[:, 2], q, two[:, 2]) > overlap_in_z
                if meets.any():
                    apart = separation(placed(p.polygon, one), placed(q.polygon, two), q.real)
                    e += np.where(meets, huber(aim - apart, knee), 0.0)
        return e

    return value


def _pair_terms(
    problem: LayoutProblem, poses: np.ndarray, m: Mapping[str, float], w: Mapping[str, float]
) -> Iterator[Term]:
    solids, zones = problem.solids, problem.zones
    radius = np.array([reach([*s, *z]) for s, z in zip(solids, zones, strict=True)])
    apart = np.hypot(*(poses[:, None, :2] - poses[None, :, :2]).transpose(2, 0, 1)) - radius[:, None] - radius[None, :]
    for i, j in zip(*np.nonzero(np.triu(apart < NEARBY, 1)), strict=True):
        flags = int(problem.flags[i, j])
        if flags & k.PAIR_RIGID:
            continue
        for bit, kind, a, b in (
            (k.PAIR_COLLIDE, "collision", solids[i], solids[j]),
            (k.PAIR_ZONE_OF_FIRST, "zone", zones[i], solids[j]),
            (k.PAIR_ZONE_OF_SECOND, "zone", solids[i], zones[j]),
        ):
            if flags & bit and a and b:
                term = too_close(a, b, m[f"{kind}_aim"], m["least_overlap_z"], w["knee"])
                yield Term(kind, (int(i), int(j)), (0.5, 0.5), _times(w[kind], term))


def _room_terms(
    problem: LayoutProblem, poses: np.ndarray, m: Mapping[str, float], w: Mapping[str, float]
) -> Iterator[Term]:
    region, aim, knee = problem.region, m["bounds_aim"], w["knee"]
    for i in range(problem.size):
        footprints, solids = problem.footprints[i], problem.solids[i]
        for plane in region.planes:

            def deepest(p: Poses, shapes=footprints, n=plane[:2], c=plane[2]) -> np.ndarray:
                depth = np.concatenate([placed(f, p[:, 0]) for f in shapes], axis=1) @ n - c
                return w["bounds"] * huber(aim - depth.min(axis=1), knee)

            if plane[:2] @ poses[i, :2] - plane[2] < reach(solids) + aim + NEARBY:
                yield Term("bounds", (i,), (1.0,), deepest)
        for prism in region.solids:
            yield Term(
                "bounds", (i,), (1.0,), _times(w["bounds"], too_close(solids, [prism], aim, m["least_overlap_z"], knee))
            )
        if problem.clear[i]:
            for prism in region.openings:
                term = too_close(solids, [prism], m["zone_aim"], m["least_overlap_z"], knee)
                yield Term("opening", (i,), (1.0,), _times(w["opening"], term))
        if problem.free[i] & k.FREE_Z:
            low, high = min(p.z[0] for p in solids), max(p.z[1] for p in solids)

            def height(p: Poses, low=low, high=high) -> np.ndarray:
                under, over = aim - low - p[:, 0, 2], p[:, 0, 2] + high + aim - region.height
                return w["bounds"] * huber(np.where(under > 0.0, under, over), knee)

            yield Term("height", (i,), (1.0,), height)


def beyond(value: np.ndarray, interval: tuple[float, float]) -> np.ndarray:
    """How far a value is from an interval."""
    return np.maximum(np.maximum(interval[0] - value, value - interval[1]), 0.0)


def row_value(
    problem: LayoutProblem, row: Row, ids: tuple[int, int, int], poses: Mapping[int, np.ndarray]
) -> np.ndarray:
    """The feature of a row for poses {object: [K, 4]}; object -1 is the room."""
    room = np.zeros_like(poses[ids[0]])
    return FEATURES[row.feature](problem, row, ids, *(poses.get(i, room) for i in ids))


def relation_term(problem: LayoutProblem, index: int, option: int, w: Mapping[str, float]) -> Term:
    """One relation under one of its options; the subject bears it."""
    rel = problem.relations[index]
    objects = tuple(dict.fromkeys(i for i in rel.objects if i >= 0))

    def value(poses: Poses) -> np.ndarray:
        at = {o: poses[:, n] for n, o in enumerate(objects)}
        off = (beyond(row_value(problem, r, rel.objects, at), r.aim) * r.scale for r in rel.options[option])
        return w["relation"] * rel.weight * sum((huber(v, w["knee"]) for v in off), np.zeros(len(poses)))

    shares = (1.0, *[0.0] * (len(objects) - 1))
    soft = rel.fault == 0
    return Term("relation", objects, shares, value, soft=soft, pulls=w["soft"] if soft else 1.0)


def _relation_terms(problem: LayoutProblem, options: Sequence[int], w: Mapping[str, float]) -> Iterator[Term]:
    for index, rel in enumerate(problem.relations):
        stacks = {int(problem.roots[i]) for i in rel.objects if i >= 0}
        if rel.objects[1] < 0 or len(stacks) > 1:  # what is carried along together keeps its relations
            yield relation_term(problem, index, int(options[index]), w)


def _pull_terms(problem: LayoutProblem, anchors: np.ndarray, w: Mapping[str, float]) -> Iterator[Term]:
    for i in range(problem.size):

        def value(poses: Poses, anchor=anchors[i]) -> np.ndarray:
            d = poses[:, 0] - anchor
            d = np.c_[d[:, :3], np.angle(np.exp(1j * d[:, 3]))]
            return 0.5 * w["pull"] * np.sum(d * d, axis=1)

        yield Term("pull", (i,), (1.0,), value, soft=True)


def _times(weight: float, value: Callable[[Poses], np.ndarray]) -> Callable[[Poses], np.ndarray]:
    return lambda poses: weight * value(poses)


def terms(
    problem: LayoutProblem,
    poses: np.ndarray,
    options: Sequence[int],
    anchors: np.ndarray | None = None,
    margins: Mapping[str, float] = MARGINS,
    weights: Mapping[str, float] = WEIGHTS,
) -> list[Term]:
    """Every term that may matter near a layout [N, 4]; ``options`` number each relation's options from 0."""
    found = [
        *_room_terms(problem, poses, margins, weights),
        *_relation_terms(problem, options, weights),
        *_pair_terms(problem, poses, margins, weights),
    ]
    if anchors is not None and weights["pull"] > 0.0:
        found += _pull_terms(problem, anchors, weights)
    return found


# ---- energy and gradient


def differences(term: Term, poses: np.ndarray) -> tuple[float, np.ndarray, np.ndarray]:
    """Value of a term and its gradients [objects, 4] by the fine and by the coarse step."""
    base = poses[list(term.objects)]
    n = base.size
    unit = np.eye(n).reshape(n, *base.shape)
    steps = [step * unit for step in (FINE, -FINE, COARSE, -COARSE)]
    values = term.value(np.concatenate([base[None], *(base + s for s in steps)]))
    up, down, far_up, far_down = values[1:].reshape(4, n)
    fine, coarse = (up - down) / (2 * FINE), (far_up - far_down) / (2 * COARSE)
    return float(values[0]), fine.reshape(base.shape), coarse.reshape(base.shape)


def energy(
    problem: LayoutProblem,
    poses: np.ndarray,
    options: Sequence[int],
    anchors: np.ndarray | None = None,
    margins: Mapping[str, float] = MARGINS,
    weights: Mapping[str, float] = WEIGHTS,
) -> Reference:
    """Shares, soft shares and gradient of one layout [N, 4]."""
    n = problem.size
    result = Reference(np.zeros(n), np.zeros(n), np.zeros((n, 4)), np.zeros(n))
    for term in terms(problem, poses, options, anchors, margins, weights):
        value, fine, coarse = differences(term, poses)
        for place, obj in enumerate(term.objects):
            part = term.shares[place] * value
            result.share[obj] += part
            result.soft[obj] += part if term.soft else 0.0
            result.gradient[obj] += term.pulls * fine[place]
            result.rough[obj] += term.pulls * np.linalg.norm(fine[place] - coarse[place])
    return result
