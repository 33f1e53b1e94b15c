"""From measurements to what became of an item, and the fault that an unmet one is."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from sceneweaver.rules.faults import fault_kind, number
from sceneweaver.verify.measure import Measurement, Measurements

from .grade import Call, Finding, finding
from .model import ItemKind, ItemOutcome

ARM = 0.5
"""Length [m] that a radian, or a share of 1, weighs when measurements of different units are compared."""


class Verdict(NamedTuple):
    """Whether a condition holds, and the measurement that tells most: of what fails that which is farthest off."""

    holds: bool
    worst: Measurement | None = None


def decide(alternatives: Iterable[Measurements]) -> Verdict:
    """Whether all measurements of some alternative lie in their intervals; else how the nearest one misses."""
    best, least = Verdict(False), math.inf
    for measurements in alternatives:
        failing = [m for m in measurements if not m.ok()]
        if not failing:
            return Verdict(True, measurements[0] if measurements else None)
        total = sum(map(weight_of, failing))
        if total < least:
            best, least = Verdict(False, max(failing, key=weight_of)), total
    return best


def weight_of(m: Measurement) -> float:
    """How far a measurement is off, as a length [m]."""
    return m.excess if m.unit == "m" else ARM * (math.radians(m.excess) if m.unit == "deg" else m.excess)


def text_of(m: Measurement) -> str:
    """A measurement in words: what fails as the judge says it, the rest to the centimetre."""
    value = round(m.value, 2) if m.ok() else m.value
    return str(m._replace(value=value, low=round(m.low, 3), high=round(m.high, 3))).replace(" ,", ",").strip()


@dataclass(frozen=True)
class Asked:
    """An item of the request: what became of it, and the fault that it is where it is unmet."""

    outcome: ItemOutcome
    finding: Finding | None = None


def met(
    kind: ItemKind, item: str, objects: Iterable[str], reason: str, m: Measurement | None = None, assumed: bool = False
) -> Asked:
    """An item that is so; ``assumed`` when the request does not state it."""
    return Asked(_outcome(kind, item, "assumed" if assumed else "met", objects, reason, m))


def substituted(kind: ItemKind, item: str, objects: Iterable[str], reason: str, m: Measurement | None = None) -> Asked:
    """An item for which something else stands."""
    return Asked(_outcome(kind, item, "substituted", objects, reason, m))


def partly(kind: ItemKind, item: str, objects: Iterable[str], reason: str, m: Measurement | None = None) -> Asked:
    """An item of which a part is so."""
    return Asked(_outcome(kind, item, "partly", objects, reason, m))


def not_understood(kind: ItemKind, item: str, objects: Iterable[str], reason: str) -> Asked:
    """An item that cannot be measured."""
    return Asked(_outcome(kind, item, "not_understood", objects, reason, None))


def unmet(
    kind: ItemKind,
    item: str,
    objects: Sequence[str],
    reason: str,
    m: Measurement | None = None,
    *,
    fault: str,
    wrong: Iterable[str] | None = None,
    share: float = 1.0,
    points: float | None = None,
    suggestion: str = "",
    grave: bool = False,
    call: Call | None = None,
) -> Asked:
    """An item that is not so.

    Args:
        kind, item, objects, reason, m: see `ItemOutcome`.
        fault: its kind, a row of ``sceneweaver/rules/faults``.
        wrong: the objects that would have to change, where they are not all.
        share: how much of it is not so, over 0 and up to 1.
        points: where nothing of it is so; None: those of the kind of fault.
        suggestion, grave, call: see `finding`.
    """
    whole, least = fault_kind(fault).points if points is None else points, number("unmet")
    assert whole is not None
    found = finding(
        "alignment",
        fault,
        objects if wrong is None else wrong,
        reason,
        suggestion,
        points=whole * (least + (1.0 - least) * min(1.0, share)),
        grave=grave,
        call=call,
    )
    return Asked(_outcome(kind, item, "unmet", objects, reason, m), found)


def counted(quantity: str, value: float, low: float, high: float = math.inf, unit: str = "") -> Measurement:
    """A number of things, or another one without slack."""
    return Measurement(quantity, float(value), float(low), float(high), unit)


def _outcome(kind: ItemKind, item: str, status: Any, objects: Iterable[str], reason: str, m: Measurement | None):
    if m is None or not math.isfinite(m.value):
        return ItemOutcome(item=item, kind=kind, status=status, objects=tuple(objects), reason=reason)
    low, high = (round(end, 4) if math.isfinite(end) else None for end in (m.low, m.high))
    return ItemOutcome(
        item=item,
        kind=kind,
        status=status,
        objects=tuple(objects),
        quantity=m.quantity,
        measured=round(m.value, 4),
        allowed=(low, high),
        unit=m.unit,
        reason=reason,
        told=f"{m.quantity} " in reason or kind == "entity",
    )
