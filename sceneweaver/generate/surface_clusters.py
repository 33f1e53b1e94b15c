"""Clusters of small things that a request relates to each other: where each stands about the first of them.

Everything is in the frame of what carries them, in which things look at its user: +x, with +y at the user's right hand.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.language import Grounded

from .surface_assets import Shelf
from .surface_geometry import Array, Shape

WAYS = {"left_of": (0.0, 1.0), "right_of": (0.0, -1.0), "in_front_of": (1.0, 0.0), "behind": (-1.0, 0.0)}
"""Direction of the sides of a thing in the support's frame."""

EXACT = (*WAYS, "near", "distance", "facing", "between", "over")
"""Types that `holds` measures as the judge does."""

GAPS = (0.03, 0.05, 0.08, 0.12, 0.18, 0.25, 0.35, 0.5, 0.7)
"""Gaps [m] between related things that are tried."""


@dataclass(frozen=True)
class Rider:
    """Something to stand on a support.

    ``inside`` asks for a board or a floor within it, not for its top; ``share`` is where on it, as depth (0 back to 1
    front) and side (-1 left to 1 right).
    """

    id: str
    asset: Asset
    inside: bool = False
    share: tuple[float, float] | None = None


@dataclass(frozen=True)
class Spot:
    """A member of a cluster, about the cluster's first: place [2] [m] and yaw [rad]."""

    rider: Rider
    shape: Shape
    at: Array
    yaw: float

    def box(self) -> tuple[Array, Array]:
        """Least and largest corner [m]."""
        low, high = self.shape.extent(self.yaw)
        return low + self.at, high + self.at


def connected(riders: Sequence[Rider], rows: Sequence[Grounded]) -> list[list[Rider]]:
    """Groups of things that relations tie together, each with what the others stand about in front."""
    root = {r.id: r.id for r in riders}

    def find(name: str) -> str:
        while root[name] != name:
            name = root[name]
        return name

    named = {r.id: 0 for r in riders}
    for row in rows:
        ids = [row.subject, *_targets(row)]
        if all(i in root for i in ids):
            for other in ids[1:]:
                named[other] += 1
                root[find(ids[0])] = find(other)
    groups: dict[str, list[Rider]] = {}
    for rider in riders:
        groups.setdefault(find(rider.id), []).append(rider)
    for group in groups.values():
        group.sort(key=lambda r: (-named[r.id], -r.asset.size[0] * r.asset.size[1]))
    return list(groups.values())


def arranged(group: Sequence[Rider], rows: Sequence[Grounded], shelf: Shelf, spread: float) -> list[Spot]:
    """The members of a cluster about its first, each where most of its relations to those before it hold."""
    known = {r.id: r for r in group}
    mine = [row for row in rows if row.subject in known and all(t in known for t in _targets(row))]
    first = group[0]
    spots = {first.id: Spot(first, shelf.shape(first.asset), np.zeros(2), 0.0)}
    while len(spots) < len(group):
        open_ = [r for r in group if r.id not in spots]
        ties = {r.id: [row for row in mine if _ties(row, r.id, spots)] for r in open_}
        rider = max(open_, key=lambda r: sum(1.0 if row.type in WAYS else 0.4 for row in ties[r.id]))
        best: tuple[tuple[float, float], Spot] | None = None
        for number, spot in enumerate(_candidates(rider, ties[rider.id], spots, shelf, spread)):
            if any(_overlap(spot, other) for other in spots.values()):
                continue
            wrong = sum(not holds(row, {**spots, rider.id: spot}) for row in ties[rider.id])
            key = (float(wrong), float(number))
            if best is None or key < best[0]:
                best = key, spot
            if not wrong:
                break
        if best is None:  # far off, and left to itself
            low, high = bounds(list(spots.values()))
            shape = shelf.shape(rider.asset)
            at = np.array([0.0, high[1] + 0.05 - shape.extent(0.0)[0][1]])
            best = (0.0, 0.0), Spot(rider, shape, at, 0.0)
        spots[rider.id] = best[1]
    return list(spots.values())


def _ties(row: Grounded, name: str, spots: Mapping[str, Spot]) -> bool:
    ids = {row.subject, *_targets(row)}
    return name in ids and all(i in spots for i in ids - {name})


def _candidates(
    rider: Rider, ties: Sequence[Grounded], spots: Mapping[str, Spot], shelf: Shelf, spread: float
) -> Iterator[Spot]:
    """Places for a thing by what it is related to, the best first."""
    shape = shelf.shape(rider.asset)
    for row in sorted(ties, key=lambda r: r.type not in WAYS):
        other = spots[next(i for i in (row.subject, *_targets(row)) if i != rider.id)]
        flipped = row.subject != rider.id
        if row.type == "between":
            a, b = (spots[t] for t in _targets(row))
            yield Spot(rider, shape, (a.at + b.at) / 2, 0.0)
            continue
        if row.type == "around":
            yield from _ring(rider, shape, other, int(row.params.get("n") or 6))
            continue
        if row.type in WAYS:
            x, y = WAYS[row.type]
            ways = [(-x, -y) if flipped else (x, y)]
        else:
            ways = [(0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0)]
        least = float(row.params.get("min") or 0.0) * spread if row.type == "distance" else 0.0
        for gap, way in itertools.product([max(g, least) for g in GAPS if g >= 0.6 * least or not least], ways):
            yield from _beside(rider, shape, other, np.array(way), gap, facing=row.type == "facing" and not flipped)


def _beside(rider: Rider, shape: Shape, other: Spot, way: Array, gap: float, facing: bool) -> Iterator[Spot]:
    """A thing at one side of another, its middle in line with the other's or a little off."""
    yaw = math.atan2(-way[1], -way[0]) if facing else 0.0
    low, high = shape.extent(yaw)
    theirs = other.shape.extent(other.yaw)
    reach = float(theirs[1] @ np.maximum(way, 0) - theirs[0] @ np.maximum(-way, 0))
    own = float(high @ np.maximum(-way, 0) - low @ np.maximum(way, 0))
    aside = np.array([-way[1], way[0]])
    width = float(np.abs((theirs[1] - theirs[0]) @ np.abs(aside)))
    for share in (0.0, 0.25, -0.25):
        yield Spot(rider, shape, other.at + way * (reach + gap + own) + aside * share * width, yaw)


def _ring(rider: Rider, shape: Shape, other: Spot, n: int) -> Iterator[Spot]:
    """Places around a thing, at even angles."""
    radius = 0.5 * math.hypot(*other.rider.asset.size[:2]) + 0.5 * max(rider.asset.size[:2]) + 0.04
    for extra, k in itertools.product((0.0, 0.06, 0.15), range(n)):
        angle = 2 * math.pi * k / n
        yield Spot(rider, shape, other.at + (radius + extra) * np.array([math.cos(angle), math.sin(angle)]), 0.0)


def _overlap(a: Spot, b: Spot, gap: float = 0.01) -> bool:
    (a0, a1), (b0, b1) = a.box(), b.box()
    return bool((a0 < b1 + gap).all() and (b0 < a1 + gap).all())


def bounds(spots: Sequence[Spot]) -> tuple[Array, Array]:
    """Least and largest corner [m] of a cluster, about its first."""
    boxes = [s.box() for s in spots]
    return np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)


def _targets(row: Grounded) -> tuple[str, ...]:
    return () if row.target is None else (row.target,) if isinstance(row.target, str) else row.target


def holds(row: Grounded, spots: Mapping[str, Any]) -> bool:
    """Whether a relation between things on one surface holds, by their boxes: ``spots`` have place, yaw and rider.

    Types that this does not know hold.
    """
    a, others = spots[row.subject], [spots[t] for t in _targets(row)]
    if not others:
        return True
    b, p = others[0], row.params
    gap = _gap(a, b)
    if row.type in WAYS:
        way = np.array(WAYS[row.type])
        d, w, _ = b.rider.asset.size
        reach, half = (d / 2, w / 2) if way[0] else (w / 2, d / 2)
        off = a.at - b.at
        beyond, aside = float(off @ way) - reach, abs(float(off @ np.array([-way[1], way[0]])))
        band = float(p.get("band", 1.5)) * half
        return float(p.get("min", 0.0)) - 1e-4 <= beyond <= float(p.get("max", 1.5)) and aside <= band - 1e-4
    if row.type == "near":
        return gap <= float(p.get("max", 1.0)) - 1e-3
    if row.type == "distance":
        return float(p.get("min") or 0.0) + 1e-3 <= gap <= float(p.get("max") or 1e9) - 1e-3
    if row.type == "facing":
        way = b.at - a.at
        off = math.degrees(math.atan2(way[1], way[0]) - a.yaw)
        return abs((off + 180) % 360 - 180) <= float(p.get("degrees", 15.0)) - 0.1
    if row.type == "between" and len(others) == 2:
        c, way = others[1], others[1].at - b.at
        along = float((a.at - b.at) @ way) / max(float(way @ way), 1e-9)
        return c is not b and 0.21 <= along <= 0.79 and float(np.hypot(*(a.at - b.at - along * way))) <= 0.45
    return row.type not in ("around", "side_by_side", "next_to", "seated_at") or gap <= 0.3


def _gap(a: Any, b: Any) -> float:
    """Distance [m] of two boxes."""
    (a0, a1), (b0, b1) = (
        (s.rider.asset.size[0] / 2, s.rider.asset.size[1] / 2) if abs(math.sin(s.yaw)) < 0.7 else
        (s.rider.asset.size[1] / 2, s.rider.asset.size[0] / 2) for s in (a, b)
    )  # fmt: skip
    dx, dy = np.abs(a.at - b.at) - (a0 + b0, a1 + b1)
    return float(math.hypot(max(dx, 0.0), max(dy, 0.0)))
