"""Which side of a desk a seat is at: that of who works there, or that of who comes to see them.

People say "behind the desk" of the side where its owner sits, which is the front of the piece of furniture: there are
its knee hole and its drawers. "In front of" it are those who visit, where the owner has a seat as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple, Protocol

from sceneweaver.assets.roles import has_role

OWNER, VISITOR = "owner_side", "visitor_side"
"""Words of ``rules/stated.yaml`` for the two sides."""

_BEFORE = ("in_front_of", "facing", "opposite", "at_foot", "near")
"""Relations of visitors to a desk that has its owner's seat, or to that seat."""


class Said(Protocol):
    """A stated relation, as far as it counts here."""

    @property
    def type(self) -> Any: ...
    @property
    def subject(self) -> str: ...
    @property
    def targets(self) -> tuple[str, ...]: ...


class Named(Protocol):
    """A thing."""

    @property
    def category(self) -> str: ...


class Brief(Protocol):
    """A request."""

    @property
    def relations(self) -> Sequence[Any]: ...
    def entity(self, name: str) -> Any: ...


class DeskSide(NamedTuple):
    """The side of a desk that a stated relation means: `OWNER` or `VISITOR`, and the desk by its id in the request."""

    side: Literal["owner_side", "visitor_side"]
    desk: str


def desk_side(said: Said, brief: Brief) -> DeskSide | None:
    """The side of a desk that a seat is told to be at; None for what says nothing of one.

    A single chair "in front of" a desk which has no other seat is its owner's.
    """
    if len(said.targets) != 1 or not _is_seat(brief.entity(said.subject)):
        return None
    target = said.targets[0]
    if is_desk(brief.entity(target)):
        owners = _owners(target, brief)
        if said.type == "behind":
            return DeskSide(OWNER, target)
        if owners and said.subject not in owners and said.type in _BEFORE[:3]:
            return DeskSide(VISITOR, target)
        if said.type == "in_front_of":
            return DeskSide(VISITOR if _several(said, target, brief) else OWNER, target)
        return None
    for other in brief.relations:  # before the chair of who sits at the desk
        if other.subject == target and said.type in _BEFORE[:3] and other.targets and said.subject != target:
            desk = other.targets[0]
            if is_desk(brief.entity(desk)) and target in _owners(desk, brief):
                return DeskSide(VISITOR, desk)
    return None


def is_desk(one: Named | None) -> bool:
    """Whether something is sat at from its front by who works there, and seen from its back by others."""
    return one is not None and has_role(one.category, "desk") and not has_role(one.category, "staffed")


def owner_of(desk: str, brief: Brief) -> str | None:
    """The seat of who works at a desk, by its id in the request; None where it names none."""
    return next(iter(_owners(desk, brief)), None)


def _owners(desk: str, brief: Brief) -> list[str]:
    """What is told to be behind a desk or at it."""
    at = [r for r in brief.relations if r.targets == (desk,) and _is_seat(brief.entity(r.subject))]
    behind = [r.subject for r in at if r.type == "behind"]
    return behind or [r.subject for r in at if r.type == "at"]


def _several(said: Said, desk: str, brief: Brief) -> bool:
    """Whether there are more seats before a desk than work at it."""
    seats, desks = brief.entity(said.subject), brief.entity(desk)
    return (seats.count or (1, 1))[0] > (desks.count or (1, 1))[0]


def _is_seat(one: Named | None) -> bool:
    return one is not None and has_role(one.category, "upright_seat", "armchair")


__all__ = ["OWNER", "VISITOR", "DeskSide", "desk_side", "is_desk", "owner_of"]
