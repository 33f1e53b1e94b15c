"""What a stated relation between two things, or between a thing and a part of the room, means in the catalogue.

The distances at which people use the words, and what the engine is asked for, stand in ``rules/stated.yaml``; here is
what its expressions know of things.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.roles import groups_above as groups_of
from sceneweaver.assets.roles import has_role, roles_of
from sceneweaver.rules.stated import Meant as Row
from sceneweaver.rules.stated import number, word_of_place, word_of_things

from .model import StatedRelation

FLAT: float = number("flat")
"""Height [m] up to which what lies on the floor, like a rug, has others stand on it."""


_FRONTS = frozenset(("seating", "chair_group", "bed_group", "screen", "storage", "sanitary", "board", "wide_mirror"))
"""Roles and groups of what has a front that matters."""


@dataclass(frozen=True)
class Thing:
    """An object as far as its relations need to know it; ``carrier`` is the id of what it stands on, if anything."""

    id: str
    category: str
    size: tuple[float, float, float]
    mount: str = "floor"
    carrier: str | None = None

    @property
    def half(self) -> float:
        """Half of its longer side [m], seen from above."""
        return max(self.size[:2]) / 2

    @property
    def is_flat(self) -> bool:
        """Whether others stand on it as on the floor: a rug."""
        return self.mount == "floor" and self.size[2] <= FLAT

    @property
    def is_seat(self) -> bool:
        """Whether it is pulled up to tables."""
        return has_role(self.category, "pulled_up")

    @property
    def is_table(self) -> bool:
        """Whether seats are pulled up to it."""
        return has_role(self.category, "pulled_up_to")

    @cached_property
    def roles(self) -> frozenset[str]:
        """Its roles and the groups of the taxonomy that it belongs to."""
        return roles_of(self.category) | groups_of(self.category)

    @property
    def looks(self) -> bool:
        """Whether its front says where it looks, or from where it is used: a seat, a bed, a screen, a cupboard."""
        return not _FRONTS.isdisjoint(self.roles)

    @property
    def may_hang(self) -> bool:
        """Whether such a thing is hung on walls, as far as it is known."""
        row = categories().get(self.category)
        return self.mount == "wall" or row is None or "wall" in row.mount


def of_pair(kind: str, a: Thing, b: Thing, side: str | None, k: int, n: int) -> Iterator[Row]:
    """The relations that make a stated one hold between two things.

    Args:
        kind: the stated type.
        a: the subject.
        b: the target.
        side: the side of the target, in its own frame, where one is meant.
        k: the number of the subject among those on that side.
        n: how many there are.
    """
    word = word_of_things(kind)
    if word is None:
        return
    meant = side or word.side
    sideways = meant in ("left", "right")
    scope = {
        "a": a,
        "b": b,
        "k": k,
        "n": n,
        "given": side is not None,
        "side": meant,
        "sideways": sideways,
        "face": b.size[0] if sideways else b.size[1],
        "small": a.mount == b.mount == "surface",
    }
    yield from word.meant(scope)


def of_place(said: StatedRelation, a: Thing, count: int) -> Iterator[tuple[str, str | None, dict[str, Any]]]:
    """Type, target and parameters of the relations to a part of the room; ``count`` things are said to be there."""
    place = said.targets[0]
    names = [f"wall:{name}" for name in place.partition(":")[2].split("+") if name]
    for row in word_of_place(said.type, place).meant({"a": a, "count": count, "named": len(names)}):
        said_walls = {"said": names[0] if names else None, "second": names[-1] if names else None}
        yield row.type, said_walls.get(row.target, row.target) if row.target else None, row.params


__all__ = ["Row", "Thing", "groups_of", "of_pair", "of_place"]
