"""What the words about a state say of things of a category: for who draws them, and for who measures them."""

from __future__ import annotations

from sceneweaver.assets.states import State, state_of

from .model import Attribute

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


__all__ = ["posture_as_told", "state_as_told"]
