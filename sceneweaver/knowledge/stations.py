"""What a request gives each of several things for its own: on the wall before it, or on the floor at it."""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from sceneweaver.assets.roles import groups_above, has_role
from sceneweaver.assets.taxonomy import category_named

from . import desk_sides
from .belongings import place_with
from .model import Place

AT_STATION, OVER_STATION, IN_REACH = "at_station", "over_station", "in_reach"
"""Words of ``rules/stated.yaml``: a seat at what hangs before it, what hangs before a seat, what is at hand."""

_BEFORE = ("in_front_of", "facing", "at", "opposite")
"""Relations of a seat to what hangs on the wall before it."""

_WITH = ("in_front_of", "facing", "at", "opposite", "near", "next_to")
"""Relations of what hangs before a seat to that seat; over it as well where that only follows from "with"."""

_FRONTAL = ("front_to_front", "front_against", "in_front_of")
"""Relations of pairs of which one is before the other."""


class Said(desk_sides.Said, Protocol):
    """A stated relation, as far as it counts here."""

    @property
    def each(self) -> bool: ...
    @property
    def implied(self) -> bool: ...
    @property
    def side(self) -> Any: ...


class Brief(Protocol):
    """A request."""

    def entity(self, name: str) -> Any: ...


class OnWall(NamedTuple):
    """The seats and what each of them has on the wall before it, by their ids in the request."""

    seats: str
    hung: str


class Pair(NamedTuple):
    """Two things of which one belongs to the other, by their ids in the request: how the ``one`` stands to the
    ``other``."""

    one: str
    other: str
    places: tuple[Place, ...]

    @property
    def frontal(self) -> bool:
        """Whether one is before the other, and not beside it."""
        return any(place.type in _FRONTAL for place in self.places)


def own_on_wall(said: Said, brief: Brief) -> OnWall | None:
    """The seats of which a statement gives each something of its own on a wall, such as a mirror; else None."""
    if not said.each or len(said.targets) != 1:
        return None
    subject, target = brief.entity(said.subject), brief.entity(said.targets[0])
    if subject is None or target is None:
        return None
    if said.type in _BEFORE and _is_seat(subject.category) and _hangs(target.category):
        return OnWall(said.subject, said.targets[0])
    used = has_role(subject.category, "wide_mirror", "shelves", "screen")
    told = said.type in _WITH or (said.type == "above" and said.implied)
    if told and used and _hangs(subject.category) and _is_seat(target.category):
        return OnWall(said.targets[0], said.subject)
    return None


def own_on_floor(said: Said, brief: Brief) -> Pair | None:
    """The pair of a statement that gives each of several things another for its own, which rooms know; else None.

    Seats at tables are no such pair: they have places there.
    """
    if not (said.each or said.implied) or len(said.targets) != 1 or said.side is not None or said.type not in _WITH:
        return None
    subject, target = brief.entity(said.subject), brief.entity(said.targets[0])
    if subject is None or target is None or {_mount(subject.category), _mount(target.category)} != {"floor"}:
        return None
    if _is_table(subject.category) or _is_table(target.category):
        return None
    for one, other in ((subject, target), (target, subject)):
        pair = Pair(one.id, other.id, place_with(one.category, other.category))
        if pair.places and _as_told(said.type, pair):
            return pair
    return None


def _as_told(word: str, pair: Pair) -> bool:
    """Whether a pair stands to each other as a word says."""
    if word in ("near", "at"):
        return True
    return pair.frontal if word != "next_to" else not pair.frontal


def _is_table(category: str) -> bool:
    return has_role(category, "seated_at") and has_role(category, "pulled_up_to")


def _mount(category: str) -> str:
    return category_named(category).mount[0]


def _hangs(category: str) -> bool:
    return _mount(category) == "wall"


def _is_seat(category: str) -> bool:
    return "seating" in groups_above(category)


__all__ = ["AT_STATION", "IN_REACH", "OVER_STATION", "OnWall", "Pair", "own_on_floor", "own_on_wall"]
