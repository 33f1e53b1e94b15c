"""Smallest sets of relations and objects that have no layout together, by a deletion search, and their words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from sceneweaver.geometry.polygons import union

from .search import CROWD, FIRM, Search
from .study import OutOfTime
from .walls import wall_claims
from .words import FOUND, listed, plural, sized


class Conflicts:
    """Narrows parts that have no layout down to what it takes for that."""

    def __init__(self, search: Search) -> None:
        self.search, self.study = search, search.study
        self.narrowest: frozenset[int] | None = None

    def smallest(self, order: Sequence[int]) -> frozenset[int] | None:
        """A set of elements, none of them to spare, for which no layout was found; early ones preferred."""
        try:
            for _ in range(3):  # a search that misses a layout may lead to a set that has one
                n = 1
                while n < len(order) and self.search.can([order[:n]])[0]:
                    n *= 2
                self.narrowest = frozenset(order[:n])
                found = self._narrow(frozenset(), False, list(order[:n]))
                if self.search.surely_not(found):
                    return found
        except OutOfTime:
            raise OutOfTime(self._so_far()) from None
        return None

    def _narrow(self, background: frozenset[int], grew: bool, rest: list[int]) -> frozenset[int]:
        """QuickXplain (Junker 2004): what of ``rest`` it takes, with the background, to have no layout."""
        if grew and not self.search.can([background])[0]:
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
            if len(objects) > 1 and not self.search.can([self.study.presence(objects)])[0]:
                return next(self.crowding(objects), self._tell(found))
        except OutOfTime:
            self.search.cut = True
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
            alone = self.search.solvable([self.study.scene_of(part, fixed=False)], FIRM)[0]
            return " beside the fixed objects" if alone else ""
        except OutOfTime:
            self.search.cut = True
            return ""
