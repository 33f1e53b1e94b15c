"""What the judge says of a home: a verdict with a report for each room, ways, and everything that is wrong."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal, Protocol

from sceneweaver.io import write_atomic
from sceneweaver.verify.report import Report

SCHEMA = "sceneweaver.home-metrics/1"

HomeKind = Literal[
    "plan",
    "room",
    "shell",
    "rooms_overlap",
    "opening",
    "through_wall",
    "blocked_leaf",
    "no_entrance",
    "blocked_door",
    "blocked_stair",
    "unreached_room",
    "unreached_object",
]
"""What can be wrong with a home beside what is wrong in a room."""


class PlanVerdict(Protocol):
    """What is used of the report about a plan, such as that of `sceneweaver.plans.check_plan`."""

    @property
    def valid(self) -> bool:
        """Whether the plan keeps all hard rules."""
        ...


@dataclass(frozen=True, slots=True)
class HomeViolation:
    """Something that makes a home invalid.

    Attributes:
        kind: what is wrong.
        rooms: ids of the rooms involved.
        parts: ids of the doors, windows or stairs involved, and "room/object" of objects.
        detail: one sentence with numbers and units.
        amount: how much, 0 when it has no size: an area [m2] of rooms that overlap and of what reaches through a
            wall, a depth [m] in the way of a leaf, a distance [m] to what is not reached, a number of faults of a room.

    Examples:
        >>> import sceneweaver as sw
        >>> home = sw.Home.example("flat")
        >>> [v.detail for v in sw.check_home(home).violations]
        []
    """

    kind: HomeKind
    rooms: tuple[str, ...]
    parts: tuple[str, ...]
    detail: str
    amount: float = 0.0

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data."""
        return {**asdict(self), "rooms": list(self.rooms), "parts": list(self.parts)}


@dataclass(frozen=True)
class HomeAccess:
    """How far a round base gets from the entrance.

    Attributes:
        robot_radius: of the base [m].
        entrance: id of the door that it comes in by; of several the one from which most is reached. None: there is
            none, or it is too narrow.
        walkable_share: of the area where the middle of the base may be, the share that is reached, 0 to 1.
        unreached_rooms: rooms in which the base cannot stand as a whole.
        needed: how many things are to be reached, by the role ``used`` of their category.
        unreached_objects: "room/object" of those with no functional side within reach, as in `walkable.Access`.
        blocked_doors: doors through which the base does not get from one side to the other.
        by_stairs: of the reached rooms those that need a stair, which people take and wheels do not.
    """

    robot_radius: float
    entrance: str | None
    walkable_share: float
    unreached_rooms: tuple[str, ...] = ()
    needed: int = 0
    unreached_objects: tuple[str, ...] = ()
    blocked_doors: tuple[str, ...] = ()
    by_stairs: tuple[str, ...] = ()

    @property
    def reachable_share(self) -> float:
        """Of the things that are to be reached, the share that is, 0 to 1; 1 when there are none."""
        return 1.0 - len(self.unreached_objects) / self.needed if self.needed else 1.0


@dataclass(frozen=True)
class HomeReport:
    """The verdict on a home.

    ``valid`` when the plan's report, where one is given, and every furnished room are, and nothing is in
    ``violations``. ``rooms`` has the report of each furnished room by its id. ``seconds`` is wall time, in all and by
    step.

    Examples:
        >>> import sceneweaver as sw
        >>> report = sw.check_home(sw.Home.example("flat"))
        >>> report.valid, report.access.walkable_share > 0.9, report.counts
        (True, True, {})
    """

    valid: bool
    rooms: Mapping[str, Report]
    access: HomeAccess
    violations: tuple[HomeViolation, ...] = ()
    plan: PlanVerdict | None = None
    seconds: Mapping[str, float] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()

    @property
    def counts(self) -> dict[str, int]:
        """How many violations there are of each kind that there is."""
        return dict(Counter(violation.kind for violation in self.violations))

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data, as ``metrics.json`` of a home has it.

        ``plan`` and ``warnings`` are there only where there is something to say; a plan's report says for itself what
        it is as JSON, or only whether it is valid.
        """
        access = {**asdict(self.access), "reachable_share": self.access.reachable_share}
        access = {name: list(value) if isinstance(value, tuple) else value for name, value in access.items()}
        data: dict[str, Any] = {
            "schema": SCHEMA,
            "valid": self.valid,
            "counts": self.counts,
            "access": access,
            "violations": [violation.to_dict() for violation in self.violations],
            "rooms": {name: report.to_dict() for name, report in self.rooms.items()},
        }
        if self.plan is not None:
            said = getattr(self.plan, "to_dict", None) or getattr(self.plan, "as_dict", None)
            data["plan"] = said() if said is not None else {"valid": self.plan.valid}
        data |= {"seconds": dict(self.seconds), "versions": dict(self.versions)}
        if self.warnings:
            data["warnings"] = list(self.warnings)
        return data

    def to_json(self, indent: int | None = 1) -> str:
        """The text of ``metrics.json``."""
        return json.dumps(self.to_dict(), indent=indent, allow_nan=False, ensure_ascii=False)

    def save(self, path: str | Path) -> None:
        """Write ``metrics.json`` under a temporary name beside it and rename it: it is never seen half written."""
        write_atomic(path, self.to_json() + "\n")
