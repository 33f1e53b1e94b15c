"""Kinds of rooms as plans see them: roles, who walks through, usual areas. The data is ``room_types.yaml``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Literal

from sceneweaver.io import InputError, packaged
from sceneweaver.io.messages import show, suggest

Transit = Literal["all", "suite", "none"]


@dataclass(frozen=True)
class RoomType:
    """A type of room.

    Attributes:
        name: of the type, such as "bedroom".
        roles: what rules select by; ``room_types.yaml`` lists them.
        transit: who may walk through it: all, suite (only to its own annexes), none.
        area: (least, usual, most) floor between the walls [m2].
        side: usual least clear width [m].
        furnish: the kind of room by which it is furnished.
        storey: where it usually lies in a house of several storeys: "ground", "upper" or None.
    """

    name: str
    roles: frozenset[str]
    transit: Transit
    area: tuple[float, float, float]
    side: float
    furnish: str | None
    storey: Literal["ground", "upper"] | None = None


@cache
def room_types() -> Mapping[str, RoomType]:
    """All types by name."""
    rows = packaged.yaml_data("sceneweaver.plans", "room_types.yaml")
    return {
        name: RoomType(
            name=name,
            roles=frozenset(row["roles"]),
            transit=row["transit"],
            area=(float(row["area"][0]), float(row["area"][1]), float(row["area"][2])),
            side=float(row["side"]),
            furnish=row.get("furnish", name),
            storey=row.get("storey"),
        )
        for name, row in rows.items()
    }


def room_type(name: str) -> RoomType:
    """The type of this name.

    Raises:
        InputError: there is none.

    Examples:
        >>> from sceneweaver.plans import room_type
        >>> room_type("bedroom").transit, "daylight" in room_type("bedroom").roles
        ('suite', True)
    """
    known = room_types()
    if name not in known:
        raise InputError(f"room type {show(name)} is not known{suggest(name, known, what='the types are')}")
    return known[name]


@cache
def roles() -> frozenset[str]:
    """All roles that some type has."""
    return frozenset(role for kind in room_types().values() for role in kind.roles)


def selects(of: Iterable[str], kind: RoomType) -> bool:
    """Whether a selector means rooms of this type: roles and names of types, those with "-" in front are left out.

    A selector with nothing but exceptions means all other types.

    Examples:
        >>> from sceneweaver.plans import room_type
        >>> from sceneweaver.plans.room_types import selects
        >>> selects(("habitable", "-cooking"), room_type("kitchen")), selects(("-wet",), room_type("bedroom"))
        (False, True)
    """
    words = kind.roles | {kind.name}
    wanted = [word for word in of if not word.startswith("-")]
    left_out = any(word[1:] in words for word in of if word.startswith("-"))
    return not left_out and (not wanted or any(word in words for word in wanted))
