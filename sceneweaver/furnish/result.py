"""What the design of a home led to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sceneweaver.home import Home
from sceneweaver.plans import PlanReport, Programme
from sceneweaver.verify.home import HomeReport

from .jobs import FurnishedRoom


@dataclass(frozen=True)
class HomeResult:
    """What the design of a home led to.

    Attributes:
        home: the home.
        report: the judge on it: its rooms, what joins them, and the ways of a round base.
        plan_report: the exact checker on its plan.
        programme: what the plan was solved for, with what furniture asked for.
        rooms: what became of each furnished room, by id.
        unmet: what was asked for and is not so.
        notes: what was assumed, and what the plan had to give way to.
        log: what was done, in order, a line each.
        style: of all rooms.
        seconds: wall time of all, and by part [s].
        undone: what there was no time for, and parts of the program that broke down.
        broken: those of them that broke down.
        files: what was written, in the order in which to look at it, by paths inside ``out``.
        out: the folder; None: none was written.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.plans import Programme, check_plan
        >>> from sceneweaver.verify.home import check_home
        >>> flat = sw.Home.example("flat")
        >>> plan, programme = check_plan(flat), Programme.example("flat-2-bedrooms")
        >>> sw.HomeResult(flat, check_home(flat), plan, programme, {}).unmet
        ()
    """

    home: Home
    report: HomeReport
    plan_report: PlanReport
    programme: Programme
    rooms: Mapping[str, FurnishedRoom]
    unmet: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    log: tuple[str, ...] = ()
    style: str = ""
    seconds: Mapping[str, float] = field(default_factory=dict)
    undone: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    out: Path | None = None

    @property
    def valid(self) -> bool:
        """Whether plan, rooms and ways are."""
        return self.report.valid and self.plan_report.valid

    @property
    def satisfied(self) -> bool:
        """Whether it is valid and all that was asked for is so, files included."""
        return self.valid and not self.unmet and not self.undone

    @property
    def grades(self) -> dict[str, float]:
        """The critic's grade of each furnished room, 0 to 10."""
        return {name: round(r.review.total, 2) for name, r in self.rooms.items() if r.review is not None}

    def to_dict(self) -> dict[str, Any]:
        """As JSON data: what ``metrics.json`` says beside the judge's report."""
        return {
            "satisfied": self.satisfied,
            "unmet": list(self.unmet),
            "undone": list(self.undone),
            "notes": list(self.notes),
            "log": list(self.log),
            "style": self.style,
            "grades": self.grades,
            "requests": {name: room.request for name, room in self.rooms.items()},
            "lacking": {name: list(room.lacking) for name, room in self.rooms.items() if room.lacking},
            "areas": dict(self.plan_report.areas),
            "seconds": dict(self.seconds),
        }
