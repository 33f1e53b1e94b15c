"""Rows of relations with their types: what is measured, the interval that it must lie in, at which sites.

Engine, judge and critic go through the same rows; what a row's numbers are for one relation, `Row.interval` says from
the names in its scope, such as its params, the sizes of the two things and the half width of the site.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Literal

from sceneweaver.io import packaged

from .expression import Expression
from .measures import MEASURES

Frame = Literal["own", "viewer", "frame"]
"""Whose left and right are meant: the thing's own, those of who looks at its front, as the param ``frame`` says."""

VIEWED = {"left": "right", "right": "left", "front": "front", "back": "back"}
"""The side of a thing, in its own frame, that a viewer of its front calls so; and the other way about."""

OPPOSITE = {"front": "back", "back": "front", "left": "right", "right": "left"}

Interval = tuple[float, float]
_KEYS = {"within", "at_most", "at_least", "about"}
_OPTIONS = ("by", "modulo", "swap", "side", "said")
_ROW = {"measure", "face", "of", "from", "if", "strict", "snap", "snap_if", "text", *_OPTIONS} | _KEYS
_WAY = {"sites", "rows", "every", "where", "when", "sides", "swap"}


@dataclass(frozen=True, slots=True)
class Row:
    """One measure and its interval; the keys of the data files are explained at the head of ``relations.yaml``.

    Attributes:
        measure: a name of `MEASURES`.
        kind: how the interval is given, or None: nothing is asked, the row is there for its exact value.
        ends: its one or two numbers.
        about: whether the interval is the same to both sides of zero.
        options: further arguments of the measure, as written.
    """

    measure: str
    kind: str | None
    ends: tuple[Expression, ...]
    face: str | None = None
    of: str | None = None
    start: Expression = field(default_factory=lambda: Expression(0.0))
    condition: Expression | None = None
    strict: bool = False
    snap: str | None = None
    snap_if: Expression | None = None
    text: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def about(self) -> bool:
        """Whether the interval is symmetric, so that its size alone counts."""
        return self.kind == "about"

    def counts(self, scope: Mapping[str, Any]) -> bool:
        """Whether its condition holds."""
        return self.condition is None or bool(self.condition.value(scope))

    def interval(self, scope: Mapping[str, Any]) -> Interval | None:
        """The interval in the unit of the measure; None where nothing is asked."""
        if self.kind is None:
            return None
        ends = [end.value(scope) for end in self.ends]
        if any(end is None for end in ends):
            return None
        if self.kind == "within":
            low, high = ends if len(ends) == 2 else ends[0]
            return float(low), float(high)
        value = float(ends[0])
        return {"at_most": (-math.inf, value), "at_least": (value, math.inf), "about": (-value, value)}[self.kind]


@dataclass(frozen=True, slots=True)
class Way:
    """Rows that together make a relation hold at a site: at one, or at ``every`` one.

    Of what requests state, ``sides`` are those of the target, each a site, and with ``swap`` the two change places.
    """

    rows: tuple[Row, ...]
    sites: str = "none"
    every: bool = False
    where: Expression | None = None
    when: Expression | None = None
    sides: str | tuple[str, ...] = ()
    swap: bool = False


def row_of(entry: Mapping[str, Any]) -> Row:
    """A row from data.

    Raises:
        ValueError: an unknown measure or key, or more than one interval.
    """
    unknown = set(entry) - _ROW
    kinds = _KEYS & set(entry)
    if unknown or len(kinds) > 1 or entry["measure"] not in MEASURES:
        raise ValueError(
            f"{dict(entry)}: no such row; measures are {', '.join(MEASURES)}, keys {', '.join(sorted(_ROW))}"
        )
    kind = next(iter(kinds), None)
    given = entry[kind] if kind else None
    ends = tuple(Expression(end) for end in (given if isinstance(given, list) else [given]))
    condition = {key: Expression(entry[key]) if key in entry else None for key in ("if", "snap_if")}
    return Row(
        measure=entry["measure"],
        kind=kind,
        ends=ends,
        face=entry.get("face"),
        of=entry.get("of"),
        start=Expression(entry.get("from", 0.0)),
        condition=condition["if"],
        strict=entry.get("strict", False),
        snap=entry.get("snap"),
        snap_if=condition["snap_if"],
        text=entry.get("text", entry["measure"]),
        options={key: entry[key] for key in _OPTIONS if key in entry},
    )


def ways_of(label: str, entries: Sequence[Mapping[str, Any]], frame: str | None) -> tuple[Way, ...]:
    """The ways of a rule from data; a rule with a measure that depends on sides has to name its frame.

    Raises:
        ValueError: an unknown key, a bad row, or no frame where one is needed.
    """
    made = []
    for entry in entries:
        if unknown := set(entry) - _WAY:
            raise ValueError(f"{label}: {', '.join(unknown)} says nothing of a way; keys are {', '.join(sorted(_WAY))}")
        rows = tuple(row_of(row) for row in entry["rows"])
        sided = [row.measure for row in rows if MEASURES[row.measure].sided]
        if sided and frame is None:
            raise ValueError(f"{label}: {sided[0]} depends on sides; say whose with frame: own, viewer or frame")
        conditions = {key: Expression(entry[key]) if key in entry else None for key in ("where", "when")}
        sides = entry.get("sides", ())
        sides = sides if isinstance(sides, str) else tuple(sides)
        every, swap = entry.get("every", False), entry.get("swap", False)
        made.append(Way(rows, entry.get("sites", "none"), every, **conditions, sides=sides, swap=swap))
    return tuple(made)


@cache
def load(name: str) -> Any:
    """A data file of this package, as plain values."""
    return packaged.yaml_data("sceneweaver.rules", name)


def own_side(side: str, frame: str) -> str:
    """A side in a thing's own frame, from whose frame it is named in."""
    return VIEWED[side] if frame == "viewer" else side


def opposed(a: str, b: str) -> bool:
    """Whether two faces are the left of one thing and the right of the other, so that both look the same way."""
    return {a, b} == {"left", "right"}
