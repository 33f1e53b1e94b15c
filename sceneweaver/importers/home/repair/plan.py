"""A plan repaired to a valid one with least movement, judged by `check_plan` at every step."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sceneweaver.home import Home
from sceneweaver.plans import PlanReport, Profile, check_plan

from .openings import freed_leaves, more_light, new_doors, new_entrances, wider_doors
from .walls import moved_walls

ROUNDS = 3
"""Times that walls, doors and windows are mended one after another."""

LIGHT = ("dark", "glazing", "escape")
WALLS = ("side", "passage", "aspect", "area", "largest_area", "wall_lack", "door_width")
"""Measures that windows, and that walls, can mend."""

ADDED = 12
"""Most doors that are added."""


@dataclass(frozen=True)
class PlanMove:
    """What a repair changed: a wall of a room or an opening, how, and by how much [m] (0: hung otherwise)."""

    what: str
    id: str
    how: str
    by: float


@dataclass(frozen=True)
class PlanRepair:
    """A repaired plan.

    ``before`` and ``after`` are the judge's reports, ``moved`` what was changed; what is left in ``after`` could not be
    mended by moving walls, doors and windows: it needs another plan.

    Examples:
        >>> import sceneweaver as sw
        >>> home = sw.Home.example("flat")
        >>> dark = home.with_changes(windows=tuple(w for w in home.windows if w.room != "bedroom"))
        >>> repair = sw.repair_plan(dark)
        >>> repair.before.valid, repair.after.valid, [(move.what, move.how) for move in repair.moved]
        (False, True, [('window', 'added to bedroom')])
    """

    home: Home
    before: PlanReport
    after: PlanReport
    moved: tuple[PlanMove, ...]

    @property
    def left(self) -> tuple[str, ...]:
        """What could not be mended, in one line each."""
        return tuple(f"{v.rule}: {v.detail}" for v in self.after.violations)


def repair_plan(home: Home, profile: Profile | str = "base") -> PlanRepair:
    """A plan that breaks as few hard rules of a profile as can be reached by small changes.

    Doors are hung otherwise, widened and moved along their walls; windows grow, and are added where a room has none;
    walls move as a whole by weighted least squares, in whole millimetres, their order kept; doors are added last, where
    no way leads to a room. Each change stays only where `check_plan` finds fewer faults after it. A plan that keeps all
    rules comes back as it is. Furniture of rooms is left out where anything changes.

    Args:
        home: the plan.
        profile: the rules, or the name of those that ship with the library.

    Raises:
        InputError: the profile is not known.

    Examples:
        >>> import sceneweaver as sw
        >>> home = sw.Home.example("flat")
        >>> repair = sw.repair_plan(home)
        >>> repair.home == home, repair.after.valid
        (True, True)
    """
    rules = Profile.of(profile)
    before = check_plan(home, profile=rules)
    best, report = home, before
    for _ in range(ROUNDS):
        if report.valid:
            break
        start = len(report.violations)
        for change in _changes(rules):
            for tried in change(best, report):
                judged = check_plan(tried, profile=rules)
                if _worse(judged, report):
                    continue
                best, report = tried, judged
                if report.valid:
                    break
        if len(report.violations) >= start:
            break
    return PlanRepair(best, before, report, tuple(_moves(home, best)) if best != home else ())


def _worse(a: PlanReport, b: PlanReport) -> bool:
    return len(a.violations) >= len(b.violations)


Change = Callable[[Home, PlanReport], Iterator[Home]]


def _changes(profile: Profile) -> tuple[Change, ...]:
    """What is tried, the smallest changes first; each gives homes of which those that are better are kept in turn."""
    hard = [row for row in profile.rows if row.hard]
    measure = {row.id: row.measure for row in hard}

    def broken(report: PlanReport, measures: tuple[str, ...]) -> list[str]:
        rooms = [r for v in report.violations if measure.get(v.rule) in measures for r in v.rooms[:1]]
        return list(dict.fromkeys(rooms))

    def leaves(home: Home, report: PlanReport) -> Iterator[Home]:
        if broken(report, ("leaf_fault",)):
            yield from _some(freed_leaves(home))

    def doors(home: Home, report: PlanReport) -> Iterator[Home]:
        lacking = [row for row in hard if row.measure == "door_width" and row.id in {v.rule for v in report.violations}]
        for _ in lacking:  # each round takes those that are left
            for wider in wider_doors(home, lacking):
                yield from _with_leaves(wider)

    def windows(home: Home, report: PlanReport) -> Iterator[Home]:
        least = max((row.least or 0.0 for row in hard if row.measure == "glazing"), default=0.05)
        rooms = broken(report, LIGHT)
        yield from _some(more_light(home, rooms, least) if rooms else None)
        for room in rooms:
            yield from _some(more_light(home, [room], least))

    def mended(home: Home | None) -> Iterator[Home]:
        """A home with other walls, and with its doors made to fit them."""
        if home is not None:
            yield from _with_leaves(home)
            for wider in wider_doors(home, hard):
                yield from _with_leaves(wider)

    def walls(home: Home, report: PlanReport) -> Iterator[Home]:
        names = {v.rule for v in report.violations if measure.get(v.rule) in WALLS}
        if not names:
            return
        wanted = [row for row in hard if row.measure in WALLS]
        yield from mended(moved_walls(home, wanted))
        for name in sorted(names):  # one rule after another, where they contradict each other
            kept = [row for row in wanted if row.id not in names or row.id == name]
            yield from mended(moved_walls(home, kept))

    def ways(home: Home, report: PlanReport) -> Iterator[Home]:
        if any(measure.get(v.rule) == "entrances" for v in report.violations):
            for tried in new_entrances(home):
                yield tried
                home, report = tried, check_plan(tried, profile=profile)
                break
        for _ in range(ADDED):
            lost = broken(report, ("unreached",))
            if not lost:
                return
            better = None
            reached = [r.id for r in home.rooms if r.id not in lost]
            for room in lost:
                for tried in new_doors(home, room, reached):
                    judged = check_plan(tried, profile=profile)
                    if len(judged.violations) < len(report.violations):
                        better = tried, judged
                        break
                if better:
                    break
            if better is None:
                return
            home, report = better
            yield home

    return leaves, doors, windows, walls, leaves, ways


def _some(home: Home | None) -> Iterator[Home]:
    if home is not None:
        yield home


def _with_leaves(home: Home | None) -> Iterator[Home]:
    if home is not None:
        yield home
        yield from _some(freed_leaves(home))


def _moves(old: Home, new: Home) -> Iterator[PlanMove]:
    """What differs between two homes of the same rooms."""
    for a, b in zip(old.rooms, new.rooms, strict=True):
        for before, after in zip(a.walls, b.walls, strict=True):
            by = before.coordinates(after.point(after.length / 2))[1]
            if abs(by) > 5e-4:
                yield PlanMove("wall", f"{a.id}:{before.index}", "moved into the room" if by > 0 else "moved out", by)
    known = {o.id: o for o in (*old.doors, *old.windows)}
    for now in (*new.doors, *new.windows):
        what = "door" if hasattr(now, "kind") else "window"
        was = known.get(now.id)
        if was is None:
            yield PlanMove(what, now.id, f"added to {now.room}", now.width)
            continue
        if abs(now.width - was.width) > 5e-4:
            yield PlanMove(
                what, now.id, "made wider" if now.width > was.width else "made narrower", now.width - was.width
            )
        by = math.dist(_middle(old, was), _middle(new, now))
        if by > 5e-4:
            yield PlanMove(what, now.id, "moved", by)
        for field, said in (("kind", "closes otherwise"), ("opens_into", "opens into"), ("hinge", "hung on the")):
            if getattr(was, field, None) != getattr(now, field, None):
                yield PlanMove(what, now.id, f"{said} {getattr(now, field)}".replace("closes otherwise", "is now"), 0.0)
        for field, said in (("sill", "sill"), ("height", "height")):
            change = getattr(now, field, 0.0) - getattr(was, field, 0.0)
            if abs(change) > 5e-4:
                yield PlanMove(what, now.id, f"{said} changed", change)


def _middle(home: Home, opening: object) -> tuple[float, float]:
    wall = home.room(opening.room).walls[opening.wall]  # type: ignore[attr-defined]
    return wall.point(opening.offset + opening.width / 2)  # type: ignore[attr-defined]
