"""Measures of single bodies: what they are, their sizes and heights; and lists of them as rows need them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sceneweaver.verify.solids import Body, Opening

from .. import kinds
from ..seats import seat_like as likely_seat
from ..survey import Survey
from .measure import movable as is_movable
from .query import kind_set
from .registry import measure


@measure
def kind(_: Survey, o: Body, kinds_: str) -> bool:
    """Whether a body is of a set of categories."""
    return o.item.category in kind_set(kinds_)


@measure
def all_kind(_: Survey, bodies: Sequence[Body], kinds_: str) -> bool:
    """Whether all of some bodies are of a set of categories."""
    return all(o.item.category in kind_set(kinds_) for o in bodies)


@measure
def category(_: Survey, o: Body) -> str:
    """The category of a body."""
    return o.item.category


@measure
def words(_: Survey, o: Body) -> str:
    """The category of a body as a user would write it."""
    return kinds.words(o.item.category)


@measure
def movable(_: Survey, o: Body) -> bool:
    """Whether it is a seat that is moved aside with one hand."""
    return is_movable(o)


@measure
def seat_like(_: Survey, o: Body) -> bool:
    """Whether people may sit on it at a table."""
    return likely_seat(o)


@measure
def named_round(_: Survey, o: Body) -> bool:
    """Whether its category says that it is round."""
    return "round" in o.item.category


@measure
def wanted(survey: Survey, o: Body) -> bool:
    """Whether somebody asked for it, or the room needs it."""
    return o.id in survey.program.asked_of or o.item.intent.priority in ("needed", "asked")


@measure
def asked(survey: Survey, o: Body) -> bool:
    """Whether the request names it."""
    return o.id in survey.program.asked_of or o.item.intent.priority == "asked"


@measure
def width(_: Survey, o: Body) -> float:
    """Width [m] of its box."""
    return o.size[1]


@measure
def depth(_: Survey, o: Body) -> float:
    """Depth [m] of its box, along its front."""
    return o.size[0]


@measure
def tall(_: Survey, o: Body) -> float:
    """Height [m] of its box."""
    return o.size[2]


@measure
def bottom(_: Survey, o: Body | Opening) -> float:
    """Height [m] of its lower end above the floor."""
    return o.z[0]


@measure
def top(_: Survey, o: Any) -> float:
    """Height [m] of its upper end, or of the highest of several, above the floor."""
    return max(one.z[1] for one in ((o,) if isinstance(o, (Body, Opening)) else o))


@measure
def number(_: Survey, o: Body) -> int:
    """Its place in the scene."""
    return o.index


@measure
def total_width(_: Survey, bodies: Sequence[Body]) -> float:
    """Width [m] of some bodies together."""
    return sum(b.size[1] for b in bodies)


@measure
def count(_: Survey, things: Sequence[Any]) -> int:
    """How many there are."""
    return len(things)


@measure
def rest(_: Survey, things: Sequence[Any], start: int, end: int | None = None) -> tuple[Any, ...]:
    """Those from a place on, up to another."""
    return tuple(things[start:end])


@measure
def largest(_: Survey, bodies: Sequence[Body]) -> Body | None:
    """The body with the largest box in plan."""
    return max(bodies, key=lambda b: (round(b.size[0] * b.size[1], 4), b.id), default=None)


@measure
def rank(_: Survey, value: float, o: Body) -> tuple[float, str]:
    """A key to order bodies by a number, and equal ones by id."""
    return round(value, 4), o.id


@measure
def by(_: Survey, value: Any) -> Any:
    """What ends a clear depth (None: a wall), or all objects that a reading is about."""
    found = getattr(value, "by", ())
    return found[0] if len(found) == 1 else found or None


@measure
def pairs_of(_: Survey, value: Any) -> int:
    """How many pairs a reading is about."""
    return getattr(value, "pairs", 0)


@measure
def more(_: Survey, number_: int, what: str) -> str:
    """The end of a sentence that names one of several."""
    return f", and {number_} more {what}" if number_ > 0 else ""


@measure
def joined(_: Survey, things: Sequence[Any], between: str) -> str:
    """Some words, or the first of each of some lists of words, in one."""
    return between.join(t if isinstance(t, str) else t[0] for t in things)


@measure
def all_of(_: Survey, *reasons: Any) -> str:
    """The reasons that hold, in one sentence."""
    return " and ".join(r for r in reasons if r and isinstance(r, str))
