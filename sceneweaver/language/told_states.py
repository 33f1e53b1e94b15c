"""What words about states and looks of parts say of things: for who draws them, and for who measures them."""

from __future__ import annotations

import re

from sceneweaver.assets.looks import roles_of_detail
from sceneweaver.assets.states import State, state_of

from .model import Attribute

_DETAIL = re.compile(r"(?P<look>.+) (?P<part>[a-z]+)")

PARTS = ("drawer", "door", "lid")
"""Parts that words about a state may begin with: "drawer pulled out"."""


def state_as_told(category: str, told: Attribute) -> State | None:
    """What an attribute says of things of a category; the words may name the part: "drawer pulled out"."""
    part, _, rest = told.value.partition(" ")
    if part.rstrip("s") in PARTS:
        return state_of(category, rest, part.rstrip("s"))
    return state_of(category, told.value)


def posture_as_told(state: State, told: Attribute) -> str | None:
    """The posture of a state: of several parts where the words speak of them."""
    return state.several if state.several and told.value.partition(" ")[0].endswith("s") else state.posture


def detail_as_told(told: Attribute) -> tuple[str, str] | None:
    """The part, by the name that drawings know, and the look that an attribute says it has: ("top", "black marble")."""
    found = _DETAIL.fullmatch(told.value) if told.kind == "part" else None
    return (found["part"], found["look"]) if found is not None and roles_of_detail(found["part"]) else None


__all__ = ["detail_as_told", "posture_as_told", "state_as_told"]
