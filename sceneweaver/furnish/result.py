"""What the design of a home led to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sceneweaver.home import Home
from sceneweaver.language.homes import HomeDemand
from sceneweaver.language.homes.model import Status
from sceneweaver.plans import PlanReport, Programme
from sceneweaver.rules.faults import number
from sceneweaver.verify.home import HomeReport

from .jobs import FurnishedRoom

STATUSES: tuple[Status, ...] = ("met", "partly", "not met", "not understood")
"""What becomes of demands."""


def unmet_of(demands: Iterable[HomeDemand]) -> list[str]:
    """The demands that are not met, a line each with what was found."""
    return [f"{one.words}: {one.status}, {one.detail}" for one in demands if one.status != "met"]


@dataclass(frozen=True)
class HomeResult:
    """What the design of a home led to.

    Attributes:
        home: the home.
        report: the judge on it: its rooms, what joins them, and the ways of a round base.
        plan_report: the exact checker on its plan.
        programme: what the plan was solved for, with what furniture asked for.
        rooms: what became of each furnished room, by id.
        demands: all that was asked for in words, each with what became of it; not understood is one of these.
        remarks: what the request says that is no demand.
        unmet: what was asked for and is not so, the demands that are not met or not understood among it.
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
    demands: tuple[HomeDemand, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether plan, rooms and ways are."""
        return self.report.valid and self.plan_report.valid

    @property
    def satisfied(self) -> bool:
        """Whether it is valid and all that was asked for is so, files included."""
        return self.valid and not self.unmet and not self.undone and not unmet_of(self.demands)

    @property
    def shares(self) -> dict[str, float]:
        """The share of the demands by what became of them; empty where the request has none."""
        many = len(self.demands)
        return {status: sum(d.status == status for d in self.demands) / many for status in STATUSES} if many else {}

    @property
    def alignment(self) -> float:
        """How much of the request is so, 0 to 10: what is so in part counts half; not above 8 where anything is unmet,
        in part, not understood, or something else in its stead, in a room as well."""
        shares = self.shares
        share = shares.get("met", 1.0 if not shares else 0.0) + 0.5 * shares.get("partly", 0.0)
        rooms = [room.review.alignment.share for room in self.rooms.values() if room.review is not None]
        faithful = not self.unmet and not unmet_of(self.demands) and min(rooms, default=1.0) >= 1.0
        return round(10.0 * share if faithful else min(number("faithful"), 10.0 * share), 2)

    @property
    def grades(self) -> dict[str, float]:
        """The critic's grade of each furnished room, 0 to 10."""
        return {name: round(r.review.total, 2) for name, r in self.rooms.items() if r.review is not None}

    def to_dict(self) -> dict[str, Any]:
        """As JSON data: what ``metrics.json`` says beside the judge's report."""
        return {
            "satisfied": self.satisfied,
            "alignment": self.alignment,
            "shares": {status: round(share, 4) for status, share in self.shares.items()},
            "demands": [demand.to_dict() for demand in self.demands],
            "remarks": list(self.remarks),
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
