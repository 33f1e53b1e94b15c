"""What a request puts on one piece of furniture, laid out as it says: the mouse to the right of the keyboard.

Things that are related form a cluster, whose members stand about its first; each cluster then goes where it fits on a
surface. Everything is in the support's frame, in which things look at its user: +x, with +y at the user's right hand.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.knowledge.surfaces import Arrangement
from sceneweaver.language import Grounded
from sceneweaver.scene import SceneObject, Surface

from .surface_assets import Shelf
from .surface_clusters import Rider, Spot, arranged, bounds, connected
from .surface_geometry import Array, Field, Prism
from .surface_places import surfaces_of

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

BOARDS = 3
"""Boards from which on a piece of furniture is a shelf: what is on it may be on any."""

TALL = 0.22
"""Height [m] from which on things stand at the back."""


@dataclass(frozen=True)
class Laid:
    """Where something stands: its surface, place [2] [m] and yaw [rad] in the support's frame."""

    rider: Rider
    surface: Surface
    at: Array
    yaw: float


class StatedLayer:
    """Lays out the things of one support; make one, then call ``run``."""

    def __init__(self, support: SceneObject, plan: Arrangement | None, shelf: Shelf):
        self._support, self._plan, self._shelf = support, plan, shelf
        self._fields: dict[str, Field] = {}
        self._stands: dict[str, list[Array]] = {}
        self._slots: set[str] = set()
        self._end = ENDS[0]

    def run(self, riders: Sequence[Rider], rows: Sequence[Grounded]) -> tuple[list[Laid], list[Rider]]:
        """Where the things stand, and those for which there is no room.

        Args:
            riders: the things, the more important first.
            rows: relations between them, as a request states them.
        """
        best: tuple[list[Laid], list[Rider]] | None = None
        for end in ENDS:
            self._fields, self._stands, self._slots, self._end = {}, {}, set(), end
            found = self._once(riders, rows)
            if best is None or len(found[1]) < len(best[1]):
                best = found
            if not best[1]:
                break
        assert best is not None
        return best

    def _once(self, riders: Sequence[Rider], rows: Sequence[Grounded]) -> tuple[list[Laid], list[Rider]]:
        laid: list[Laid] = []
        lost: list[Rider] = []
        groups = connected(riders, rows)
        groups.sort(key=lambda g: (-len(g) if len(g) > 1 else 0, -max(r.asset.size[0] * r.asset.size[1] for r in g)))
        if self._end != 0.5:  # where room is short the largest comes first
            groups.sort(key=lambda g: -sum(r.asset.size[0] * r.asset.size[1] for r in g))
        for group in groups:
            found = self._cluster(group, rows)
            laid += found
            missing = [r for r in group if all(r is not one.rider for one in found)]
            for rider in missing:
                alone = self._cluster([rider], ())
                laid += alone
                lost += [] if alone else [rider]
        return laid, lost

    def _cluster(self, group: Sequence[Rider], rows: Sequence[Grounded]) -> list[Laid]:
        for surface in self._surfaces(group):
            for spread in SPREADS if len(group) > 1 else SPREADS[:1]:
                spots = arranged(group, rows, self._shelf, spread)
                at = self._place(surface, spots)
                if at is not None:
                    ground = self._field(surface)
                    for spot in spots:
                        ground.put(spot.shape, spot.yaw, spot.at + at)
                        self._stands[surface.name].append(spot.at + at)
                    return [Laid(s.rider, surface, s.at + at, s.yaw) for s in spots]
        return []

    def _surfaces(self, group: Sequence[Rider]) -> list[Surface]:
        """Surfaces in the order in which they are tried: of boards the emptiest, else the one to work at."""
        inside = any(r.inside for r in group)
        tall = max(r.asset.size[2] for r in group)
        fits = [s for s in self._support.surfaces if s.headroom is None or s.headroom > tall + 0.002]
        middle = 0.5 * self._support.size[2]
        if not inside and sum(s.headroom is not None for s in self._support.surfaces) < BOARDS:
            upper = [s for s in fits if s.z >= middle - 0.01]  # on a table is on its top, not on the shelf under it
            fits = upper or fits

        def order(s: Surface) -> tuple[Any, ...]:
            ground = self._field(s)
            load = len(self._stands[s.name])
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
        return bool(level) and len(self._stands.get(surface.name, ())) > 0

    def _field(self, surface: Surface) -> Field:
        if surface.name not in self._fields:
            ring = counter_clockwise(surface.polygon)
            edge = 0.012 if min(np.ptp(ring, axis=0)) > 0.3 else 0.003
            edge = edge if self._support.mount != "surface" else ALIKE
            ground = Field(ring, math.inf if surface.headroom is None else surface.headroom, edge=edge)
            for part in self._support.solids:
                if part.z[1] > surface.z + 1e-3:
                    prism = Prism(counter_clockwise(part.polygon), part.z[0] - surface.z, part.z[1] - surface.z)
                    ground.taken.append(prism)
            self._fields[surface.name], self._stands[surface.name] = ground, []
        return self._fields[surface.name]

    def _place(self, surface: Surface, spots: Sequence[Spot]) -> Array | None:
        """The best place [2] of a cluster on a surface; None when it fits nowhere."""
        ground = self._field(surface)
        if ground.empty:
            return None
        for goal in self._goals(ground, spots):
            if all(ground.free(s.shape, s.yaw, (s.at + goal)[None])[0] for s in spots):
                return goal
        low, high = bounds(spots)
        first, last = ground.low - low + 1e-6, ground.high - high - 1e-6
        if (last < first).any():
            return None
        step = STEP if self._end == ENDS[0] else STEP / 2
        if self._end == ENDS[2]:  # from the other end
            xs, ys = (np.arange(b, a - step, -step) for a, b in zip(first, last, strict=True))
        else:
            xs, ys = (np.arange(a, b + step, step) for a, b in zip(first, last, strict=True))
        grid = np.stack(np.meshgrid(xs, ys, indexing="ij"), axis=-1).reshape(-1, 2)
        grid = np.concatenate([grid, 0.5 * (first + last)[None]])  # where one fits that is as large as the surface
        for spot in spots:
            grid = grid[ground.free(spot.shape, spot.yaw, grid + spot.at)]
            if not len(grid):
                return None
        return grid[int(np.argmin(self._cost(surface, ground, grid, spots)))]

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
                if slot.at is not None and slot.id not in self._slots and first.rider.asset.category in slot.what
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
        tall = max(s.rider.asset.size[2] for s in spots) > TALL
        cost = 0.5 * np.abs(share[:, 0] - (0.2 if tall and span[0] > 0.4 else 0.5)) + 0.25 * np.abs(
            share[:, 1] - self._end
        )
        wanted = [s for s in spots if s.rider.share is not None]
        for spot in wanted:
            goal = ground.inside(spot.shape, spot.yaw, spot.rider.share or (0.5, 0.0)) - spot.at
            cost = cost + 5.0 * np.hypot(*(grid - goal).T)
        stands = self._stands[surface.name]
        if stands and not wanted:
            away = np.min(np.hypot(*(middle[None] - np.array(stands)[:, None]).transpose(2, 0, 1)), axis=0)
            cost = cost - 2.0 * np.minimum(away, MOST_ALIKE)
        return cost
