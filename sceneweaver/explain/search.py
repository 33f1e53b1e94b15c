"""Small refinements of parts of a scene, which tell what has a layout and what seems to have none, and a deletion
search for the smallest parts that have none."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import shapely

from sceneweaver.geometry.polygons import union
from sceneweaver.layout import refine_many
from sceneweaver.scene import Scene

from .space import wall_claims
from .study import OutOfTime, Study
from .words import FOUND, listed, plural, sized

CHUNK = 48  # parts that are tested at once

Effort = tuple[int, int]  # candidates, attempts
QUICK, FIRM, FEW_SURE, SURE = range(4)
# Of a test, by the kind of device: a GPU takes many candidates as fast as few.
EFFORTS: dict[str, tuple[Effort, ...]] = {
    "cpu": ((32, 1), (32, 3), (64, 3), (64, 5)),
    "cuda": ((256, 1), (1024, 1), (1024, 2), (2048, 2)),
}
FEW = 4  # objects up to which FEW_SURE is sure
CROWD = 40  # objects from which on a test stays quick


class Search:
    """Tests which parts of a studied scene have a layout, remembers the outcomes, and narrows parts that have none down
    to what it takes for that."""

    def __init__(self, study: Study, seed: int) -> None:
        self.study, self.seed = study, seed
        self.cut = False
        self.possible: list[frozenset[int]] = []
        self.impossible: list[frozenset[int]] = []
        self.narrowest: frozenset[int] | None = None

    def solvable(self, scenes: Sequence[Scene], effort: int) -> list[bool]:
        """Which scenes a small refinement finds a valid layout for; raises OutOfTime when the clock cuts it off."""
        left = self.study.until - time.monotonic()
        if left <= 0:
            raise OutOfTime
        candidates, steps = EFFORTS["cpu" if self.study.device == "cpu" else "cuda"][effort]
        solutions = refine_many(
            scenes,
            candidates=candidates,
            seed=(self.seed + 7919 * steps + candidates) % 2**32,
            device=self.study.device,
            steps=steps,
            time_limit=left,
        )
        found = [bool(np.any(s.status == 0)) for s in solutions]
        if not all(found) and any(s.timed_out for s in solutions):
            raise OutOfTime
        return found

    def known(self, part: frozenset[int]) -> bool | None:
        """What earlier tests and the solution's candidates say about a closed part."""
        if any(part <= other for other in self.possible) or self._witnessed(part):
            return True
        return False if any(other <= part for other in self.impossible) else None

    def _witnessed(self, part: frozenset[int]) -> bool:
        """Whether some candidate of the solution has a closed part in order."""
        units = [e for e in part if e < len(self.study.units)]
        bad = self.study.unmet[:, units].any(axis=1) | self.study.fault[:, sorted(self.study.objects_of(part))].any(
            axis=1
        )
        return not bad.all()

    def note(self, part: frozenset[int], can: bool) -> None:
        """Remember the outcome of a test."""
        if can:
            self.impossible = [p for p in self.impossible if not p <= part]
        (self.possible if can else self.impossible).append(part)

    def can(self, parts: Sequence[Iterable[int]]) -> list[bool]:
        """Whether each part has a layout, as far as a search tells: first a quick one, then a firmer one."""
        closed = [self.study.closed(p) for p in parts]
        for effort in (QUICK, FIRM):
            ask = [p for p in dict.fromkeys(closed) if self.known(p) is None]
            for some in (ask[i : i + CHUNK] for i in range(0, len(ask), CHUNK)):
                scenes = [self.study.scene_of(p, guides=effort == FIRM) for p in some]
                for part, can in zip(some, self.solvable(scenes, effort), strict=True):
                    if can or effort == FIRM or len(self.study.objects_of(part)) > CROWD:
                        self.note(part, can)
        return [bool(self.known(p)) for p in closed]

    def surely_not(self, part: Iterable[int]) -> bool:
        """Whether even a long search finds no layout for a part that a shorter one found none for."""
        closed = self.study.closed(part)
        few = len(self.study.objects_of(closed)) <= FEW
        try:
            found = self.solvable([self.study.scene_of(closed, guides=True)], FEW_SURE if few else SURE)[0]
        except OutOfTime:
            self.cut = True
            return True
        self.note(closed, found)
        return not found

    # what it takes for a part to have no layout

    def smallest(self, order: Sequence[int]) -> frozenset[int] | None:
        """A set of elements, none of them to spare, for which no layout was found; early ones preferred."""
        try:
            for _ in range(3):  # a search that misses a layout may lead to a set that has one
                n = 1
                while n < len(order) and self.can([order[:n]])[0]:
                    n *= 2
                self.narrowest = frozenset(order[:n])
                found = self._narrow(frozenset(), False, list(order[:n]))
                if self.surely_not(found):
                    return found
        except OutOfTime:
            raise OutOfTime(self._so_far()) from None
        return None

    def _narrow(self, background: frozenset[int], grew: bool, rest: list[int]) -> frozenset[int]:
        """QuickXplain (Junker 2004): what of ``rest`` it takes, with the background, to have no layout."""
        if grew and not self.can([background])[0]:
            self.narrowest = background
            return frozenset()
        if len(rest) == 1:
            return frozenset(rest)
        half = len(rest) // 2
        second = self._narrow(background | set(rest[:half]), True, rest[half:])
        first = self._narrow(background | second, bool(second), rest[:half])
        return first | second

    def _so_far(self) -> list[str]:
        if self.narrowest is None or len(self.study.objects_of(self.narrowest)) == len(self.study.free) > CROWD:
            return []
        units = [self.study.unit_words(u) for u in sorted(self.narrowest) if u < len(self.study.units)]
        objects = [self.study.scene.objects[i].id for i in sorted(self.study.objects_of(self.narrowest))]
        if not units:
            return [f"By then the cause was narrowed down to these {len(objects)} objects: {listed(objects, 8)}."]
        parts = f"{plural(len(units), 'hard relation')} and {plural(len(objects), 'object')}"
        return [f"By then the cause was narrowed down to {parts}: {listed(units, 8, '; ')}."]

    def outward(self, seed: int) -> list[int]:
        """All elements: units by how many steps they are from the seed, then objects."""
        keys = [self.study.keys(u) for u in range(len(self.study.units))]
        step, rank, reached = 0, {seed: 0}, set(keys[seed])
        while len(rank) < len(self.study.units):
            step += 1
            new = [u for u in range(len(self.study.units)) if u not in rank and keys[u] & reached]
            if not new:
                new = [u for u in range(len(self.study.units)) if u not in rank]
            for u in new:
                rank[u] = step
                reached |= keys[u]
        units = sorted(rank, key=lambda u: (rank[u], self.study.suspicion(u)))
        objects = sorted(self.study.free, key=lambda i: (-self.study.fault[:, i].mean(), i))
        return units + [len(self.study.units) + i for i in objects]

    def settled(self, found: frozenset[int]) -> str:
        """The words for a conflict; objects alone when they do not fit together without its relations."""
        objects = sorted(self.study.objects_of(found))
        try:
            if len(objects) > 1 and not self.can([self.study.presence(objects)])[0]:
                return next(self.crowding(objects), self._tell(found))
        except OutOfTime:
            self.cut = True
        return self._tell(found)

    def _tell(self, found: frozenset[int]) -> str:
        n = len(self.study.units)
        units = sorted(e for e in found if e < n)
        relations = [self.study.unit_words(u) for u in units]
        named = {i for u in units for i in self.study.named[u]}
        others = [self.study.scene.objects[e - n].id for e in sorted(found) if e >= n and e - n not in named]
        beside = self._beside_fixed(found)
        if others:
            beside += f" while {listed(others, 6)} {'is' if len(others) == 1 else 'are'} there"
        if len(units) == 1:
            sizes = listed([sized(self.study.scene.objects[i]) for i in sorted(named)], 4)
            return f"This hard relation holds nowhere{beside} {FOUND}: {relations[0]}; {sizes}."
        text = f"These {len(units)} hard relations cannot hold together{beside} {FOUND}: {listed(relations, 8, '; ')}."
        at_walls = {rel.subject for u in units for rel in self.study.relations(u) if rel.type.endswith("against_wall")}
        tight = self.study.walls.tightest([c for c in wall_claims(self.study.scene) if c.obj.id in at_walls])
        return f"{text} {tight}." if tight and len(at_walls) > 2 else text

    def crowding(self, objects: Sequence[int]) -> Iterator[str]:
        """A smallest set found of objects that do not fit together."""
        n = len(self.study.units)
        found = self.smallest([n + i for i in objects])
        if found is None:
            return
        ids = [self.study.scene.objects[i] for i in sorted(e - n for e in found)]
        everyone = " even without relations" if self.study.units else ""
        area = sum(self.study.area(self.study.index[o.id]) for o in ids if o.mount == "floor")
        floor = shapely.Polygon(self.study.scene.room.outline)
        doors = union(shapely.Polygon(d.polygon) for d in self.study.problem.region.doors.values())
        yield (
            f"These {len(ids)} objects do not fit together{self._beside_fixed(found)}{everyone} {FOUND}: "
            f"{listed([o.id for o in ids])}. Those on the floor cover {area:.1f} m2 of the "
            f"{floor.difference(doors).area:.1f} m2 that doors leave free."
        )

    def _beside_fixed(self, part: frozenset[int]) -> str:
        """Words for a conflict that is none without the fixed objects."""
        if not any(o.fixed for o in self.study.scene.objects):
            return ""
        try:
            alone = self.solvable([self.study.scene_of(part, fixed=False)], FIRM)[0]
            return " beside the fixed objects" if alone else ""
        except OutOfTime:
            self.cut = True
            return ""
