"""Measures of single bodies that only faults ask for."""

from __future__ import annotations

from sceneweaver.assets import categories
from sceneweaver.knowledge.small_things import left_about as is_left_about
from sceneweaver.verify.solids import Body

from .. import kinds
from ..design.query import kind_set
from ..design.registry import measure
from ..survey import Survey


@measure
def known(_: Survey, o: Body) -> bool:
    """Whether the taxonomy has its category."""
    return o.item.category in categories()


@measure
def left_about(survey: Survey, o: Body) -> bool:
    """Whether people leave such a thing lying about in the room."""
    return is_left_about(o.item.category, survey.room_type.name)


@measure
def carries(_: Survey, o: Body) -> bool:
    """Whether something should stand on or in it."""
    return kinds.carries(o.item.category)


@measure
def in_set(_: Survey, category: str, kinds_: str) -> bool:
    """Whether a category is in a set."""
    return category in kind_set(kinds_)


@measure
def whole(_: Survey, value: float) -> int:
    """A number without what is behind its point."""
    return int(value)
