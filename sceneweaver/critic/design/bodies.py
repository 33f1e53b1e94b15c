"""Measures of single bodies: what they are, their sizes and heights; and lists as rows need them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sceneweaver.verify.solids import Body, Opening

from .. import kinds
from ..survey import Survey
from .measure import parts_of, top_of
from .query import kind_set
from .registry import measure


@measure
def kind(_: Survey, o: Body, kinds_: str) -> bool:
    """Whether a body is of a set of categories."""
    return o.item.category in kind_set(kinds_)


@measure
def category(_: Survey, o: Body) -> str:
    """The category of a body."""
    return o.item.category


@measure
def words(_: Survey, o: Body | str, article: bool = False) -> str:
    """The category of a body, or a kind of room, as a user would write it."""
    name = o if isinstance(o, str) else o.item.category
    return kinds.a(name) if article else kinds.words(name)


@measure
def attribute(_: Survey, o: Body, name: str) -> Any:
    """An attribute of a body, such as its material or color; None where it has none of the name."""
    return o.item.attributes.get(name)


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
def top(_: Survey, o: Body | Opening) -> float:
    """Height [m] of its upper end above the floor."""
    return o.z[1]


@measure
def worktop(_: Survey, o: Body) -> float:
    """Height [m] of the top of a table or unit over its lower end; a tap on it does not count."""
    return top_of(o)


@measure
def parts(_: Survey, o: Body) -> Sequence[tuple[float, float]]:
    """The solid parts of a body: the share of its box in plan, and the height [m] of the top, of each."""
    return parts_of(o)


@measure
def joined(_: Survey, words_: Sequence[str], between: str) -> str:
    """Some words in one text."""
    return between.join(words_)


@measure
def mode(_: Survey, values: Sequence[Any]) -> Any:
    """The most frequent of some values, of equally frequent ones the first; None of none."""
    return Counter(values).most_common(1)[0][0] if values else None


@measure
def groups(_: Survey, things: Sequence[Any], keys: Sequence[Any]) -> list[tuple[Any, ...]]:
    """The things with equal keys together, one key for each thing."""
    found: dict[Any, list[Any]] = {}
    for thing, key in zip(things, keys, strict=True):
        found.setdefault(key, []).append(thing)
    return [tuple(row) for row in found.values()]
