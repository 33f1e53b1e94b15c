"""Measures of single bodies and of lists of them that only faults ask for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.knowledge.lived_in import left_about as is_left_about
from sceneweaver.verify.solids import Body

from .. import kinds
from ..design.query import kind_set
from ..design.registry import measure
from ..survey import Survey


@measure
def mount(_: Survey, o: Body) -> str:
    """Where a body is: "floor", "wall", "ceiling" or "surface"."""
    return o.item.mount


@measure
def known(_: Survey, o: Body) -> bool:
    """Whether the taxonomy has its category."""
    return o.item.category in categories()


@measure
def left_about(survey: Survey, o: Body) -> bool:
    """Whether people leave such a thing lying about in the room."""
    return is_left_about(o.item.category, survey.room_type.name)


@measure
def named_by_request(survey: Survey, o: Body) -> bool:
    """Whether it stands for something that the request names."""
    return o.id in survey.program.asked_of


@measure
def only(survey: Survey) -> bool:
    """Whether the request wants nothing but what it names."""
    return bool(survey.brief.only)


@measure
def ids(_: Survey, things: Sequence[Any], most: int | None = None, between: str = ", ") -> str:
    """The ids of the first of some things, in words."""
    return between.join(one if isinstance(one, str) else one.id for one in things[:most])


@measure
def whole(_: Survey, value: float) -> int:
    """A number without what is behind its point."""
    return int(value)


@measure
def in_set(_: Survey, category: str, kinds_: str) -> bool:
    """Whether a category is in a set."""
    return category in kind_set(kinds_)


@measure
def phrase(_: Survey, category: str) -> str:
    """A category in words."""
    return kinds.words(category)


@measure
def article(_: Survey, category: str) -> str:
    """A category in words, with its article."""
    return kinds.a(category)
