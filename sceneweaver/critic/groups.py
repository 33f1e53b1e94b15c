"""The groups of a room, found from geometry and categories: seats around a sofa, a bed with its own, tables with seats.

No relation is read, so that scenes of other systems are grouped as well.
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property

from sceneweaver.rules.faults import number
from sceneweaver.verify.solids import Body

from . import kinds
from .seats import table_of
from .survey import Survey, turn_to

SEATS = kinds.LOUNGE | frozenset(("waiting_bench", "bench", "ottoman", "pouf"))
"""What makes up a seating group."""

ANCHORS = kinds.SOFAS | frozenset(("waiting_bench",))
"""Seats that others are set around."""

RUGS = frozenset(("rug", "round_rug", "runner_rug"))

FOCI = kinds.TVS | frozenset(("fireplace",))
"""What a seating group looks at."""

ALL_BEDS = kinds.BEDS | kinds.LONG_BEDS

BEDSIDE = frozenset(("nightstand", "side_table"))

HUNG = kinds.EYE_LEVEL - {"wall_clock"}
"""What is hung over a bed or a sofa to be looked at."""

COUNTERS = frozenset(("reception_desk", "bar_counter", "host_stand"))
"""What has staff on one side and visitors on the other."""


@dataclass(frozen=True, eq=False)
class Seating:
    """Seats that belong together: the sofa (or the seat) that the others are set around, and what goes with it."""

    anchor: Body
    seats: tuple[Body, ...]
    table: Body | None
    rug: Body | None
    focus: Body | None


@dataclass(frozen=True, eq=False)
class Sleeping:
    """A bed with what stands beside it, lies under it and hangs over it."""

    bed: Body
    stands: tuple[Body, ...]
    rug: Body | None
    over: tuple[Body, ...]
    pendants: tuple[Body, ...]


@dataclass(frozen=True, eq=False)
class Seated:
    """A table or desk with the seats at it."""

    table: Body
    seats: tuple[Body, ...]


@dataclass(frozen=True, eq=False)
class Groups:
    """All groups of a room."""

    survey: Survey

    @cached_property
    def rugs(self) -> list[Body]:
        """Rugs on the floor."""
        return [b for b in self.survey.of_kind(RUGS) if b.item.mount == "floor"]

    @cached_property
    def screens(self) -> list[Body]:
        """Televisions and screens, fireplaces."""
        return self.survey.of_kind(FOCI)

    @cached_property
    def seatings(self) -> list[Seating]:
        """The seating groups, that of the widest sofa first; a seat with nothing around it is no group."""
        seats = [b for b in self.survey.of_kind(SEATS) if b.item.mount == "floor"]
        anchors = sorted(seats, key=lambda b: (b.item.category not in ANCHORS, -round(b.size[1], 3), b.id))
        found: list[Seating] = []
        taken: set[str] = set()
        for anchor in anchors:
            if anchor.id in taken or anchor.item.category in ("ottoman", "pouf"):
                continue
            table = self._coffee_table(anchor)
            members, ids = [anchor], {anchor.id}
            if table is not None:
                members += [
                    b for b, _ in self.survey.near(table, number("seating")) if b in seats and b.id not in ids | taken
                ]
                ids.update(b.id for b in members)
            for member in members:  # grows: who is near a member is one as well
                for other, _ in self.survey.near(member, number("seating")):
                    if other in seats and other.id not in ids | taken:
                        members.append(other)
                        ids.add(other.id)
            if len(members) == 1 and table is None and anchor.item.category not in ANCHORS:
                continue
            taken.update(b.id for b in members)
            found.append(Seating(anchor, tuple(members), table, self._rug_of(table, anchor), self._focus(anchor)))
        return found

    def _coffee_table(self, anchor: Body) -> Body | None:
        """The nearest coffee table before a seat."""
        for other, _ in self.survey.near(anchor, number("seating")):
            if other.item.category in kinds.COFFEE and anchor.local(other.centre)[0] > 0.0:
                return other
        return None

    def _rug_of(self, *bodies: Body | None) -> Body | None:
        """The rug with the largest share under some bodies; None where there is none under any."""
        best: tuple[float, Body] | None = None
        for rug in self.rugs:
            area = sum(self.overlap(rug, b) for b in bodies if b is not None)
            if area > 1e-3 and (best is None or area > best[0]):
                best = area, rug
        return best[1] if best else None

    def overlap(self, one: Body, other: Body) -> float:
        """Area [m2] in plan that two boxes share."""
        boxes = self.survey.boxes
        return float(boxes[one.index].intersection(boxes[other.index]).area)

    def _focus(self, seat: Body) -> Body | None:
        """What a seat looks at: the screen or fireplace that is least off its front."""
        seen = [
            (turn_to(seat, b.centre), b.id, b)
            for b in self.screens
            if math.dist(b.centre, seat.centre) <= number("view")
            and math.degrees(turn_to(seat, b.centre)) <= number("lounge_off")
        ]
        return min(seen)[2] if seen else None

    @cached_property
    def sleepings(self) -> list[Sleeping]:
        """Every bed with its own."""
        return [self._sleeping(bed) for bed in self.survey.of_kind(ALL_BEDS) if bed.item.mount == "floor"]

    def _sleeping(self, bed: Body) -> Sleeping:
        half_d, half_w = bed.size[0] / 2, bed.size[1] / 2
        stands = [
            b
            for b, _ in self.survey.near(bed, number("bedside"))
            if b.item.category in BEDSIDE and bed.local(b.centre)[0] < 0.0 and abs(bed.local(b.centre)[1]) > half_w
        ]
        over, pendants = [], []
        for b in self.survey.bodies:
            ahead, aside = bed.local(b.centre)
            if b.item.mount == "wall" and b.item.category in HUNG:
                if abs(ahead + half_d) <= number("over_head") and abs(aside) < half_w + number("beside_head"):
                    over.append(b)
            elif b.item.category in ("pendant", "chandelier") and abs(ahead) < half_d and abs(aside) < half_w:
                pendants.append(b)
        return Sleeping(bed, tuple(stands), self._rug_of_bed(bed), tuple(over), tuple(pendants))

    def _rug_of_bed(self, bed: Body) -> Body | None:
        """The rug under a bed, or beside it; not one that lies under a table."""
        under = self._rug_of(bed)
        if under is not None:
            return under
        for rug, _ in self.survey.near(bed, number("rug_at_bed")):
            if rug in self.rugs and not any(self.overlap(rug, s.table) > 0.0 for s in self.tables):
                return rug
        return None

    @cached_property
    def tables(self) -> list[Seated]:
        """Every table or desk that has seats, with them."""
        at: dict[str, list[Body]] = defaultdict(list)
        for seat in self.survey.bodies:
            if seat.item.mount == "floor" and kinds.upright_seat(seat.item.category):
                table = table_of(self.survey, seat)
                if table is not None:
                    at[table.id].append(seat)
        by_id = self.survey.placed.by_id
        return [Seated(by_id[name], tuple(seats)) for name, seats in at.items()]


def groups_of(survey: Survey) -> Groups:
    """The groups of a room; found once for a survey."""
    kept = survey.__dict__.get("_groups")
    if kept is None:
        kept = survey.__dict__["_groups"] = Groups(survey)
    return kept
