"""Bodies fitted to each other and to the room: units of a run, what hangs over them, what spans a thing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sceneweaver.assets import Library
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Relation, Room

from .galley import galley_runs
from .kitchen_runs import in_two_runs
from .program import Program, Wanted
from .run import (
    JOINT,
    SIDE_OF_WINDOW,
    TIGHT,
    CornerRun,
    Variant,
    corner_runs,
    drawn_widths,
    has_place,
    overlaps,
    run_of,
    windows_from,
)

WORSE = 0.3
"""How much worse than the best a way around a corner may be that is tried beside it."""

LACKING = 0.3
"""How much it counts that a unit has no place."""

POOR = 0.5
"""How badly a run may stand in a shell that another one would not take the place of."""


def fitted(
    program: Program, free: Sequence[Wanted], room: Room, library: Library, brief: SceneGraph
) -> tuple[list[Variant], float]:
    """Fit the bodies of a program: the units of a run to the room, what spans something to that.

    Of a run with a corner unit, what is no more than usual is left out until it goes around a corner; where it never
    does, the corner unit is. Nothing is hung over a unit that stands before a window.

    Args:
        program: changed in place.
        free: what may stand in a run, as the request gives it no other place.
        room: the empty room.
        library: draws bodies of other widths.
        brief: the request, which may set the units out in two runs.

    Returns:
        The relations of the ways around corners of the room, the best way first; empty where the run has no corner. And
        what speaks against the best [m off the middle of a window]: 0 without a corner unit, infinite without a place.
    """
    pieces = run_of(free)
    galley = len(pieces) > 1 and in_two_runs(brief, {one.category for one in pieces})
    corner = next((one for one in pieces if has_place(one, "in_corner")), None)
    runs = corner_runs(pieces, room)
    spare = [one for one in pieces if one.rank >= 2 and one is not corner and one.asked is None]
    spare.sort(key=lambda one: (one.rank, one.asset.size[1]))
    gone: list[Wanted] = []
    while corner is not None and not runs and spare:
        gone.append(spare.pop())
        runs = corner_runs([one for one in pieces if one not in gone], room)
    if corner is not None and not runs:
        gone = [corner]
    _without(program, gone)
    for one in program.wanted:
        if runs and one.id in runs[0].widths:
            _widen(one, runs[0].widths[one.id], library)
    for one in program.wanted:
        if one.item is not None and one.item.spans is not None and one.parent is not None and one.asked is None:
            _widen(one, one.item.spans * one.parent.asset.size[1], library)
    if galley:
        return galley_runs(brief, run_of([one for one in free if one in program.wanted]), room)
    if not runs:
        return [], 0.0 if corner is None else math.inf
    hung = CornerCabinets.of(program.wanted, runs[0])
    if hung is not None:
        turned = hung.turned
        hung.fit(runs[0], room, library)
        _without(program, [turned] if turned is not None and hung.turned is None else [])
    _without(program, _before_windows(program.wanted, runs[0], room, hung))
    ways = corner_runs([one for one in pieces if one not in gone], room, drawn_widths)
    if not any(one.asked for one in program.wanted):  # what a request names may stand in the way of the best
        ways = [way for way in ways if way.cost < ways[0].cost + WORSE]
    found = [(*way.relations, *(hung.relations(way, program.wanted) if hung is not None else ())) for way in ways]
    return found, runs[0].cost + LACKING * len(gone)


@dataclass
class CornerCabinets:
    """Cabinets that hang around the corner of a run: ``straight`` beside the corner in the wing of the stove,
    ``corner`` in it, and ``turned`` on the other wall over ``unit``, up to a window."""

    straight: Wanted
    corner: Wanted
    turned: Wanted | None
    unit: Wanted | None

    @classmethod
    def of(cls, wanted: Sequence[Wanted], run: CornerRun) -> CornerCabinets | None:
        """Those of a program; None where none hangs over the corner unit or beside it."""
        over = {one.parent.id: one for one in wanted if one.parent is not None and one.mount == "wall"}
        wings = sorted((run.ahead, run.turned), key=lambda wing: any(has_place(one, "at_window") for one in wing))
        straight, corner = (over.get(one.id) for one in (wings[0][0], run.corner)) if wings[0] else (None, None)
        if straight is None or corner is None:
            return None
        turned = next((one for one in wanted if one.parent is corner), None)
        return cls(straight, corner, turned, wings[1][0] if wings[1] else None)

    def fit(self, run: CornerRun, room: Room, library: Library) -> None:
        """Make the last one as long as there is room for it before a window; without room there is none."""
        if self.turned is None:
            return
        wall, _, end = run.spans()[self.unit.id] if self.unit is not None else (run.wall, 0.0, 0.0)
        start = self.corner.asset.size[0] + JOINT
        ends = [a - SIDE_OF_WINDOW for a, _ in windows_from(room, wall, wall == run.wall)]
        usual = category_named(self.turned.category).size
        assert usual is not None
        width = min(end, *ends, start + usual.width[1]) - start - JOINT
        if width < usual.width[0]:
            self.turned = None
        else:
            _widen(self.turned, width, library)

    def relations(self, way: CornerRun, wanted: Sequence[Wanted]) -> Variant:
        """Who hangs next to whom, as far as they are there."""
        side = "left" if self.straight.parent in way.ahead else "right"
        found = []
        if self.straight in wanted and self.corner in wanted:
            found.append(_next("next_to", self.corner, self.straight, side))
            if self.turned is not None and self.turned in wanted:
                found.append(_next("run_on", self.turned, self.corner, side))
        return tuple(found)


def _next(type: str, one: Wanted, other: Wanted, side: str) -> Relation:
    return Relation(type=type, subject=one.id, target=other.id, params={"side": side, **TIGHT})


def _without(program: Program, gone: Sequence[Wanted]) -> None:
    program.wanted = [one for one in program.wanted if one not in gone and one.parent not in gone]


def _widen(one: Wanted, width: float, library: Library) -> None:
    """Give a thing another body of that width [m]."""
    if one.wish is None or abs(width - one.asset.size[1]) < 1e-3:
        return
    one.wish = replace(one.wish, size=(one.wish.size[0], round(width, 3), one.wish.size[2]))
    one.asset = library.choose(one.category, 1, one.wish)[0]


def _before_windows(wanted: Sequence[Wanted], run: CornerRun, room: Room, hung: CornerCabinets | None) -> list[Wanted]:
    """What is hung over a unit that stands before a window, and over a corner without the one beside it."""
    spans = run.spans()
    found: list[Wanted] = []
    for one in wanted:
        if one.parent is None or one.parent.id not in spans or one.mount != "wall" or one.asked is not None:
            continue
        wall, start, end = spans[one.parent.id]
        if overlaps((start, end), windows_from(room, wall, wall == run.wall)):
            found.append(one)
    cut_off = hung is not None and hung.straight in found
    return [*found, *(one for one in wanted if one.parent is run.corner and (hung is None or cut_off))]
