"""Which room of a home is the one that a request asks for: by its id, else by its type."""

from __future__ import annotations

from sceneweaver.home import HomeRoom
from sceneweaver.plans import room_types

from .measured import MeasuredHome
from .model import HomeRequest


def group_of(type_: str) -> str:
    """Kinds of rooms that are counted together: bedrooms whoever sleeps there, bathrooms with or without a tub."""
    roles = room_types()[type_].roles if type_ in room_types() else frozenset[str]()
    if "sleeping" in roles and "care" not in roles and type_ not in ("dormitory", "studio_apartment"):
        return "sleeping"
    if type_ in ("guest_toilet", "washroom", "accessible_toilet"):
        return "toilet"
    if "sanitary" in roles:
        return "bathing"
    return type_


def place(name: str, request: HomeRequest, measured: MeasuredHome) -> HomeRoom | None:
    """The room of an id, else the one of its type that has the same place among these."""
    there = room_of(measured, name)
    if there is not None:
        return there
    group = group_of(request.programme.room(name).type)
    own = [room.id for room in request.programme.rooms if group_of(room.type) == group]
    alike = [room for room in measured.home.rooms if group_of(room.type) == group]
    return alike[own.index(name)] if own.index(name) < len(alike) else None


def room_of(measured: MeasuredHome, name: str) -> HomeRoom | None:
    """The room of this id; None where the home has none."""
    return next((room for room in measured.home.rooms if room.id == name), None)
