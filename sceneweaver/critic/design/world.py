"""A scene whose poses are known, as queries of rows ask for it: objects, what is near them, and named selectors."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any

from sceneweaver.rules.expression import CALLED
from sceneweaver.verify.solids import Body

from ..groups import groups_of
from ..survey import Survey
from . import bodies, free, looks, plan, sets, walls
from .query import Case, kind_set
from .registry import MEASURES

MODULES = (bodies, free, looks, plan, sets, walls)
"""What has measures, by subject; they put them into `MEASURES` as they are read."""

OFF = 0.4
"""Distance [m] behind the back of a bed or sofa up to which something hangs over it."""


class Surveyed:
    """The objects of a survey by mount, kind and nearness."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.functions: Mapping[str, Callable[..., Any]] = {
            name + CALLED: partial(function, survey) for name, function in MEASURES.items()
        }
        self._members: dict[str, list[Body]] = {"": list(survey.bodies), "standing": list(survey.standing)}

    def members(self, mount: str) -> Iterable[Body]:
        """The objects of a mount; "standing": on the floor and higher than what is walked on; "": all."""
        if mount not in self._members:
            self._members[mount] = [b for b in self.survey.bodies if b.item.mount == mount]
        return self._members[mount]

    def near(self, o: Body, distance: float) -> Iterable[Body]:
        """What is within a gap [m] of an object, the nearest first."""
        return [b for b, _ in self.survey.near(o, distance)]

    def category(self, o: Body) -> str:
        """The category of an object."""
        return o.item.category

    def named(self, selector: str) -> Iterator[Case]:
        """The cases of a named selector."""
        return SELECTORS[selector](self.survey)


def _seating(survey: Survey) -> Iterator[Case]:
    """Groups of seats around a sofa or another seat."""
    for g in groups_of(survey).seatings:
        yield {"anchor": g.anchor, "seats": g.seats, "table": g.table, "rug": g.rug, "focus": g.focus}


def _sofa_with(name: str) -> Callable[[Survey], Iterator[Case]]:
    """Sofas with the table, rug or focus of their group; ``alone`` where the sofa is all of it."""

    def found(survey: Survey) -> Iterator[Case]:
        for g in groups_of(survey).seatings:
            other = getattr(g, name)
            if other is not None and g.anchor.item.category in kind_set("sofa"):
                yield {"sofa": g.anchor, name: other, "alone": len(g.seats) == 1 and g.table is None}

    return found


def _bed_rug(survey: Survey) -> Iterator[Case]:
    """Beds with the rug under them."""
    groups = groups_of(survey)
    for g in groups.sleepings:
        if g.rug is not None and g.bed.item.category in kind_set("bed") and groups.overlap(g.rug, g.bed) > 0.0:
            yield {"bed": g.bed, "rug": g.rug}


def _bed_lamp(survey: Survey) -> Iterator[Case]:
    """Beds with the lamps that hang over them."""
    for g in groups_of(survey).sleepings:
        for lamp in g.pendants:
            yield {"bed": g.bed, "lamp": lamp}


def _hung_over(survey: Survey) -> Iterator[Case]:
    """Beds and sofas with what hangs over them, all of it together."""
    over = {g.bed.id: g.over for g in groups_of(survey).sleepings}
    for base in survey.of_kind(kind_set("sofa bed")):
        half_d, half_w = base.size[0] / 2, base.size[1] / 2
        found = over.get(base.id) or [
            b
            for b in survey.of_kind(kind_set("hung_over"))
            if b.item.mount == "wall"
            and -half_d - OFF <= base.local(b.centre)[0] < -half_d + 0.3
            and abs(base.local(b.centre)[1]) < half_w
        ]
        if found:
            yield {"base": base, "over": tuple(found)}


def _flanking_pair(survey: Survey) -> Iterator[Case]:
    """Two of a kind beside a bed or a sofa."""
    for base in survey.of_kind(kind_set("bed sofa")):
        flanks: dict[str, list[Body]] = defaultdict(list)
        for body, _ in survey.near(base, 0.5):
            aside = abs(base.local(body.centre)[1])
            if body.item.category in kind_set("flanking") and aside > base.size[1] / 2:
                flanks[body.item.category].append(body)
        yield from ({"one": a[0], "other": a[1], "base": base} for a in flanks.values() if len(a) == 2)


def _seated(survey: Survey) -> Iterator[Case]:
    """Tables and desks with their upright seats."""
    for g in groups_of(survey).tables:
        yield {"table": g.table, "seats": g.seats}


SELECTORS: Mapping[str, Callable[[Survey], Iterator[Case]]] = {
    "seating": _seating,
    "sofa_table": _sofa_with("table"),
    "sofa_rug": _sofa_with("rug"),
    "sofa_focus": _sofa_with("focus"),
    "bed_rug": _bed_rug,
    "bed_lamp": _bed_lamp,
    "hung_over": _hung_over,
    "flanking_pair": _flanking_pair,
    "seated": _seated,
    "door": lambda survey: ({"door": door} for door in survey.placed.doors),
    "window": lambda survey: ({"window": window} for window in survey.placed.windows),
    "wall": lambda survey: ({"wall": wall} for wall in survey.placed.walls),
}
"""Named selectors over known poses; `sceneweaver.agent.choice` has those over relations."""
