"""What a request puts on one piece of furniture, laid out as it says: the mouse to the right of the keyboard.

Things that are related form a cluster, whose members stand about its first; each cluster then goes where it fits on a
surface. Everything is in the support's frame, in which things look at its user: +x, with +y at the user's right hand.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.knowledge.surfaces import Arrangement
from sceneweaver.language import Grounded
from sceneweaver.scene import Pose, SceneObject, Surface

from .surface_bodies import Shelf
from .surface_candidates import surfaces_of
from .surface_field import Array, Field, Piece, Shape, bounds
from .surface_scene import Frame, on_surface, solids_of
from .surface_setting import Setting, Standing

WAYS = {"left_of": (0.0, 1.0), "right_of": (0.0, -1.0), "in_front_of": (1.0, 0.0), "behind": (-1.0, 0.0)}
"""Direction of the sides of a thing in the support's frame."""

EXACT = (*WAYS, "near", "distance", "facing", "between", "over")
"""Types that `holds` measures as the judge does."""

GAPS = (0.03, 0.05, 0.08, 0.12, 0.18, 0.25, 0.35, 0.5, 0.7)
"""Gaps [m] between related things that are tried."""


SPREADS = (1.0, 0.5, 0.2)
"""Shares of a distance that is merely usual which are tried, for a surface that is too small for it."""

ENDS = (0.5, 0.0, 1.0)
"""Shares of the width to which things tend, tried in turn while something finds no room: the middle, either end."""

STEP = 0.025
"""Grid [m] of places that are tried on a surface."""

ALIKE = -5e-4
"""Free space [m] kept to the edge of a small thing: one of the same size may lie on it."""

MOST_ALIKE = 0.3
"""Distance [m] beyond which it does not matter how far apart things stand."""

MISSES = 6
"""Things of a category without room after which no more of it are tried on a support."""

BOARDS = 3
"""Boards from which on a piece of furniture is a shelf: what is on it may be on any."""

TALL = 0.22
"""Height [m] from which on things stand at the back."""


@dataclass(frozen=True)
class Rider:
    """Something to stand on a support.

    ``inside`` asks for a board or a floor within it, ``on_top`` for nothing above it; ``share`` is where on it, as
    depth (0 back to 1 front) and side (-1 left to 1 right).
    """

    id: str
    asset: Asset
    inside: bool = False
    share: tuple[float, float] | None = None
    on_top: bool = False


@dataclass(frozen=True)
class Spot(Piece):
    """A member of a cluster, about the cluster's first."""

    rider: Rider = field(kw_only=True)

    @property
    def asset(self) -> Asset:
        """Its body."""
        return self.rider.asset


class StatedLayer:
    """Lays out the things of one support; make one, then call ``run``."""

    def __init__(self, support: SceneObject, plan: Arrangement | None, shelf: Shelf):
        # In its own frame: its room is not laid out yet, so nothing is known to be above it.
        self._support = support.model_copy(update={"pose": Pose()})
        self._plan, self._shelf = plan, shelf
        self._setting = Setting(self._support, Frame(), shelf, self._ground)
        self._slots: set[str] = set()
        self._end = ENDS[0]

    def run(self, riders: Sequence[Rider], rows: Sequence[Grounded]) -> tuple[list[Standing], list[Rider]]:
        """Where the things stand, and those for which there is no room.

        Args:
            riders: the things, the more important first.
            rows: relations between them, as a request states them.
        """
        best: tuple[list[Standing], list[Rider]] | None = None
        for end in ENDS:
            self._slots, self._end = set(), end
            self._setting = Setting(self._support, Frame(), self._shelf, self._ground)
            found = self._once(riders, rows)
            if best is None or len(found[1]) < len(best[1]):
                best = found
            if not best[1]:
                break
        assert best is not None
        return best

    def _once(self, riders: Sequence[Rider], rows: Sequence[Grounded]) -> tuple[list[Standing], list[Rider]]:
        laid: list[Standing] = []
        lost: list[Rider] = []
        groups = connected(riders, rows)
        groups.sort(key=lambda g: (-len(g) if len(g) > 1 else 0, -max(r.asset.size[0] * r.asset.size[1] for r in g)))
        if self._end != 0.5:  # where room is short the largest comes first
            groups.sort(key=lambda g: -sum(r.asset.size[0] * r.asset.size[1] for r in g))
        misses: Counter[str] = Counter()
        for group in groups:
            full = len(group) == 1 and misses[group[0].asset.category] >= MISSES
            found = [] if full else self._cluster(group, rows)
            laid += found
            missing = [r for r in group if all(r.id != one.id for one in found)]
            for rider in missing:
                full = len(group) == 1 or misses[rider.asset.category] >= MISSES
                alone = [] if full else self._cluster([rider], ())
                laid += alone
                if not alone:
                    misses[rider.asset.category] += 1
                    lost.append(rider)
        return laid, lost

    def _cluster(self, group: Sequence[Rider], rows: Sequence[Grounded]) -> list[Standing]:
        """Set a cluster down on the first surface that has room for it, closer together where it is too small."""
        for surface in self._surfaces(group):
            for spread in SPREADS if len(group) > 1 else SPREADS[:1]:
                spots = arranged(group, rows, self._shelf, spread)
                at = self._setting.field(surface).place(spots, self._candidates(surface, spots))
                if at is not None:
                    return [self._setting.put(Standing(s.rider.id, s.asset, surface, s.at + at, s.yaw)) for s in spots]
        return []

    def _surfaces(self, group: Sequence[Rider]) -> list[Surface]:
        """Surfaces in the order in which they are tried: of boards the emptiest, else the one to work at."""
        inside = any(r.inside for r in group)
        tall = max(r.asset.size[2] for r in group)
        fits = [s for s in self._support.surfaces if s.headroom is None or s.headroom > tall + 0.002]
        if any(r.on_top for r in group):
            open_ = [s for s in fits if s.headroom is None]
            return sorted(open_ or fits, key=lambda s: -s.z)
        middle = 0.5 * self._support.size[2]
        if not inside and sum(s.headroom is not None for s in self._support.surfaces) < BOARDS:
            upper = [s for s in fits if s.z >= middle - 0.01]  # on a table is on its top, not on the shelf under it
            fits = upper or fits

        def order(s: Surface) -> tuple[Any, ...]:
            ground = self._setting.field(s)
            load = len(self._stands(s))
            if inside:
                return (s.headroom is None, load, -ground.area)
            low = s.z < middle - 0.01 and s.headroom is not None
            return (low, s.headroom is not None and s.headroom < 0.2, load > 0 and len(fits) > 2, -ground.area, load)

        if inside and any(s.headroom is not None for s in fits):
            fits = [s for s in fits if s.headroom is not None] + [s for s in fits if s.headroom is None]
        main = surfaces_of(self._support, False, bool(self._plan and self._plan.top))["main"] if fits else None
        found = sorted(fits, key=order)
        if not inside and main in found and main is not None and main.headroom is None:
            found = [main, *(s for s in found if s is not main)] if not self._full(main) else found
        return found

    def _full(self, surface: Surface) -> bool:
        """Whether a seat or the like carries something already, while others of its kind are bare."""
        level = [s for s in self._support.surfaces if abs(s.z - surface.z) < 0.02 and s is not surface]
        return bool(level) and bool(self._stands(surface))

    def _stands(self, surface: Surface) -> list[Array]:
        """Where [2] things stand on a surface."""
        return [one.at for one in self._setting.standing if one.surface is surface]

    def _ground(self, surface: Surface) -> Field:
        """The free space of a surface of the support by itself."""
        ring = counter_clockwise(surface.polygon)
        edge = 0.012 if min(np.ptp(ring, axis=0)) > 0.3 else 0.003
        edge = edge if self._support.mount != "surface" else ALIKE
        return on_surface(self._support, surface, solids_of(self._support, zones=False), edge=edge)

    def _candidates(self, surface: Surface, spots: Sequence[Spot]) -> Iterator[Array]:
        """Places of a cluster on a surface: by what is said of it, by custom, then a grid by cost."""
        ground = self._setting.field(surface)
        if ground.empty:
            return
        for goal in self._goals(ground, spots):
            yield goal[None]
        low, high = bounds(spots)
        first, last = ground.low - low + 1e-6, ground.high - high - 1e-6
        if (last < first).any():
            return
        step = STEP if self._end == ENDS[0] else STEP / 2
        if self._end == ENDS[2]:  # from the other end
            xs, ys = (np.arange(b, a - step, -step) for a, b in zip(first, last, strict=True))
        else:
            xs, ys = (np.arange(a, b + step, step) for a, b in zip(first, last, strict=True))
        grid = np.stack(np.meshgrid(xs, ys, indexing="ij"), axis=-1).reshape(-1, 2)
        grid = np.concatenate([grid, 0.5 * (first + last)[None]])  # where one fits that is as large as the surface
        yield grid[np.argsort(self._cost(surface, ground, grid, spots), kind="stable")]

    def _goals(self, ground: Field, spots: Sequence[Spot]) -> Iterator[Array]:
        """Places that a thing has by custom: its slot in what such furniture is laid with."""
        first = spots[0]
        for spot in spots:
            if spot.rider.share is not None:
                yield ground.inside(spot.shape, spot.yaw, spot.rider.share) - spot.at
        slot = next(
            (
                slot
                for slot in (self._plan.slots if self._plan else ())
                if slot.at is not None and slot.id not in self._slots and first.asset.category in slot.what
            ),
            None,
        )
        if slot is not None and slot.at is not None and self._end == ENDS[0]:
            self._slots.add(slot.id)
            yield ground.inside(first.shape, first.yaw, slot.at)

    def _cost(self, surface: Surface, ground: Field, grid: Array, spots: Sequence[Spot]) -> Array:
        """How unsuited each place [n, 2] of a cluster is: tall things at the back, apart from others, not at an end."""
        low, high = bounds(spots)
        span = np.maximum(ground.high - ground.low, 1e-6)
        middle = grid + 0.5 * (low + high)
        share = (middle - ground.low) / span
        if self._end != ENDS[0]:  # close together, from one end and the back
            return 2.0 * np.abs(share[:, 1] - self._end) + share[:, 0]
        tall = max(s.asset.size[2] for s in spots) > TALL
        cost = 0.5 * np.abs(share[:, 0] - (0.2 if tall and span[0] > 0.4 else 0.5)) + 0.25 * np.abs(
            share[:, 1] - self._end
        )
        wanted = [s for s in spots if s.rider.share is not None]
        for spot in wanted:
            goal = ground.inside(spot.shape, spot.yaw, spot.rider.share or (0.5, 0.0)) - spot.at
            cost = cost + 5.0 * np.hypot(*(grid - goal).T)
        stands = self._stands(surface)
        if stands and not wanted:
            away = np.min(np.hypot(*(middle[None] - np.array(stands)[:, None]).transpose(2, 0, 1)), axis=0)
            cost = cost - 2.0 * np.minimum(away, MOST_ALIKE)
        return cost


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
    spots = {first.id: Spot(shelf.shape(first.asset), rider=first)}
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
            best = (0.0, 0.0), Spot(shape, 0.0, at, rider=rider)
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
            yield Spot(shape, 0.0, (a.at + b.at) / 2, rider=rider)
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
        yield Spot(shape, yaw, other.at + way * (reach + gap + own) + aside * share * width, rider=rider)


def _ring(rider: Rider, shape: Shape, other: Spot, n: int) -> Iterator[Spot]:
    """Places around a thing, at even angles."""
    radius = 0.5 * math.hypot(*other.asset.size[:2]) + 0.5 * max(rider.asset.size[:2]) + 0.04
    for extra, k in itertools.product((0.0, 0.06, 0.15), range(n)):
        angle = 2 * math.pi * k / n
        yield Spot(shape, 0.0, other.at + (radius + extra) * np.array([math.cos(angle), math.sin(angle)]), rider=rider)


def _overlap(a: Spot, b: Spot, gap: float = 0.01) -> bool:
    (a0, a1), (b0, b1) = a.box, b.box
    return bool((a0 < b1 + gap).all() and (b0 < a1 + gap).all())


def _targets(row: Grounded) -> tuple[str, ...]:
    return () if row.target is None else (row.target,) if isinstance(row.target, str) else row.target


def holds(row: Grounded, spots: Mapping[str, Any]) -> bool:
    """Whether a relation between things on one surface holds, by their boxes: ``spots`` have place, yaw and asset.

    Types that this does not know hold.
    """
    a, others = spots[row.subject], [spots[t] for t in _targets(row)]
    if not others:
        return True
    b, p = others[0], row.params
    gap = _gap(a, b)
    if row.type in WAYS:
        way = np.array(WAYS[row.type])
        d, w, _ = b.asset.size
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
        (s.asset.size[0] / 2, s.asset.size[1] / 2) if abs(math.sin(s.yaw)) < 0.7 else
        (s.asset.size[1] / 2, s.asset.size[0] / 2) for s in (a, b)
    )  # fmt: skip
    dx, dy = np.abs(a.at - b.at) - (a0 + b0, a1 + b1)
    return float(math.hypot(max(dx, 0.0), max(dy, 0.0)))
