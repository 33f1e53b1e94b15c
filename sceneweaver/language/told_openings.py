"""What is told of doors and windows, as drafts and the critic take it alike."""

from __future__ import annotations

from .model import SceneGraph, StatedOpening
from .vocabulary import words

_UP_WITH = frozenset(("small", "little", "tiny", "slit", "slot", "horizontal", "narrow", "barred", "strip", "ribbon"))
"""Kinds of windows with which "high" says where they are, and not how tall."""


def doors_stated(brief: SceneGraph) -> list[StatedOpening]:
    """The doors that are described, one by one, that which one comes in by first."""
    doors = [one for one in brief.openings if one.part == "door" for _ in range(one.count)]
    return sorted(doors, key=leads_on)


def leads_on(one: StatedOpening) -> bool:
    """Whether a door leads from the room to another one, so that one does not come in by it."""
    targets = [feature.removeprefix("to the ") for feature in one.features if feature.startswith("to the ")]
    beyond = any(target not in words("openings")["outside"] for target in targets)
    return beyond or any(feature in words("openings")["another"] for feature in one.features)


def entry_stated(brief: SceneGraph) -> StatedOpening | None:
    """The door that one comes in by, where it is described."""
    return next((one for one in doors_stated(brief) if not leads_on(one)), None)


def is_high_up(one: StatedOpening) -> bool:
    """Whether a window is said to be above the eyes."""
    kinds = set(one.features)
    return bool(kinds & {"clerestory", "high up"}) or ("high" in kinds and bool(kinds & _UP_WITH))


def is_bay(one: StatedOpening) -> bool:
    """Whether a window is said to be in a bay."""
    return one.part == "window" and not {"bay", "bow"}.isdisjoint(one.features)


__all__ = ["doors_stated", "entry_stated", "is_bay", "is_high_up", "leads_on"]
