"""What a stated relation between two things, or between a thing and a part of the room, means in the catalogue.

Distances are those at which people use the words: next to, within reach; near, a step away; opposite, across the room.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import category_named

from .model import StatedRelation

FLAT = 0.03
"""Height [m] up to which what lies on the floor, like a rug, has others stand on it."""

REACH, NEAR, ACROSS, FAR = 0.3, (0.3, 1.3), (1.5, 4.0), 2.5
"""Gaps [m]: most of what is next to another, of what is near it, of what is opposite; least of what is far away."""

TOUCHING = 0.02
"""Most gap [m], seen from above, of what is below or above a thing that leaves no room for its middle there."""

SOLID = ("sanitary", "storage", "appliance")
"""Groups of furniture that stands on the floor with all of its plan, or with its middle: a mat lies before it."""

SMALL = 0.2
"""Most gap [m] between small things that are next to each other on a table."""

BEYOND, AHEAD = 0.7, 1.1
"""Gap [m] in which something still is to the left or right of another, and in front of or behind it."""

BAND = 1.25
"""Width of what is beside a side, in widths of that side."""

PULLED = (-0.12, 0.12)
"""Gap [m] of a seat that is said to be in front of its table, before it or at its side: not pushed under it."""

HIGH = 0.6
"""Height [m] from which on a seat reaches under a table."""

EVENLY = 0.65
"""Share of the even angle by which neighbours around a thing may be nearer or further: chairs along two sides."""

TURNED = 10.0
"""Most angle [degrees] by which something that faces another is turned away from it."""

SEATED = ("at", "around", "next_to", "flanking")
"""Stated relations that pull a seat up to the side of a table that they name."""

THICKER = 0.15
"""How much further [m] the middle of a thing on a wall may be from the wall than that of one beside it."""

DIRECT = ("parallel", "aligned", "back_to_back")
"""Stated relations that are called so in the catalogue, too."""


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
        return "chair_group" in groups_of(self.category) or self.category in ("stool", "bar_stool", "bench")

    @property
    def is_table(self) -> bool:
        """Whether seats are pulled up to it."""
        return "table_group" in groups_of(self.category) or self.category in ("kitchen_island", "bar_counter")


class Row(NamedTuple):
    """A relation of the catalogue of a pair, or of the pair ``swapped``."""

    type: str
    params: dict[str, Any] = {}
    hard: bool = True
    swapped: bool = False


@cache
def groups_of(category: str) -> frozenset[str]:
    """The groups of the taxonomy that a category belongs to."""
    known, found = categories(), set[str]()
    parent = category_named(category).parent
    while parent is not None:
        found.add(parent)
        parent = known[parent].parent if parent in known else None
    return frozenset(found)


def kind_of(said: StatedRelation) -> str:
    """The type of a stated relation; "by the sofa" is nearer than "near the sofa"."""
    return "next_to" if said.type == "near" and said.words.lower().startswith(("by ", "at ")) else said.type


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
    if b.is_flat and not a.is_flat and kind in ("on", "at", "inside", "above"):
        yield Row("over", {"inset": round(min(0.1, 0.2 * min(b.size[:2])), 3)})
    elif a.is_flat and kind == "below" and _is_solid(b):
        yield Row("near", {"max": TOUCHING})
    elif a.is_flat and kind in ("below", "at"):
        yield Row("over")
    elif kind == "above":
        yield from _above(a, b)
    elif kind == "below":
        if b.mount in ("wall", "ceiling"):
            yield from (row._replace(swapped=True) for row in _above(b, a))
        else:
            yield Row("over")
    elif kind == "along" or (side is not None and a.is_seat and b.is_table and kind in SEATED):
        yield from _along(a, b, side or "front", k, n)
    elif kind == "flanking" or kind in ("left_of", "right_of", "in_front_of", "behind"):
        yield from _sided(kind, a, b, side or "left")
    elif kind in ("at_foot", "at_head"):
        yield from _at_end(kind, a, b, side, k, n)
    elif side is not None and kind in ("next_to", "near", "at", "around"):
        yield from _sided("flanking", a, b, side)
    else:
        yield from _loose(kind, a, b, n)


def _is_solid(thing: Thing) -> bool:
    return thing.mount == "floor" and not groups_of(thing.category).isdisjoint(SOLID)


def _loose(kind: str, a: Thing, b: Thing, n: int) -> Iterator[Row]:
    """Relations that name no side."""
    small = a.mount == b.mount == "surface"
    if kind == "next_to" and a.category == "nightstand" and "bed_group" in groups_of(b.category):
        yield Row("leftright_to_leftright")
    elif kind in ("next_to", "against", "leaning_on", "on", "inside", "hanging_from"):
        touching = kind in ("against", "leaning_on")
        yield Row("near", {"max": 0.05 if touching else SMALL if small else REACH})
    elif kind == "side_by_side" and small:
        yield Row("near", {"max": SMALL})
    elif kind == "side_by_side":
        yield Row("side_by_side", {"gap": [0.0, REACH]})
    elif kind == "near" and a.is_seat and b.is_table:
        yield Row("front_against", {"gap": [0.22, 0.6]})
    elif kind == "near":
        yield Row("distance", {"min": 0.2 if small else NEAR[0], "max": 0.5 if small else NEAR[1]})
    elif kind == "far_from":
        yield Row("distance", {"min": 0.4 if small else FAR, "max": 60.0})
    elif kind == "opposite":
        yield Row("distance", {"min": ACROSS[0], "max": ACROSS[1]})
        yield Row("facing", {"degrees": 30.0}, hard=False)
    elif kind == "facing":
        yield Row("facing", {"degrees": TURNED})
    elif kind == "around":
        gap = {} if a.is_seat and b.is_table and b.size[2] >= HIGH else {"gap": [0.1, 0.7]}
        if n < 2:
            yield Row("front_against", gap)
        else:
            yield Row("around", {"n": n, "spread": round(min(EVENLY * 360 / n, 58.0), 1), **gap})
    elif kind == "at" and a.is_seat:
        yield Row("front_against", {"gap": [-0.25, 0.1]} if b.is_table else {})
    elif kind == "at":
        yield Row("near", {"max": REACH})
    elif kind == "centered_on":
        yield Row("over", {"inset": round(0.4 * min(b.size[:2]), 3)} if b.is_flat else {})
    elif kind in DIRECT:
        yield Row(kind)


def _above(a: Thing, b: Thing) -> Iterator[Row]:
    """Over a thing: a lamp from the ceiling over its middle, a picture at the wall right behind it."""
    if a.mount == "ceiling" and b.mount == "wall":  # there is a wall where its middle would be
        yield Row("near", {"max": TOUCHING})
        return
    if a.mount == "ceiling":
        yield Row("over", {"inset": round(0.25 * min(b.size[:2]), 3)})
        return
    width = b.size[1]
    yield Row("above", {"lateral": round(max(0.03, (BAND * width - a.size[1]) / 2 / width), 3) if width else 0.1})
    if a.mount == "wall":
        yield Row("near", {"max": 0.03})


def _sided(kind: str, a: Thing, b: Thing, side: str) -> Iterator[Row]:
    """Beyond one side of a thing and within its width, all of it: the centre alone would let half of it stand before.

    A seat at the front of a desk is drawn up to it.
    """
    small = a.mount == b.mount == "surface"
    lateral = side in ("left", "right")
    if side == "front" and kind == "in_front_of" and a.is_seat and b.is_table:
        yield Row("front_to_front", {"gap": list(PULLED)})
        return
    if lateral and a.category == "nightstand" and "bed_group" in groups_of(b.category):
        yield Row("next_to", {"side": side, "gap": [0.0, 0.06]})
        return
    face = b.size[0] if lateral else b.size[1]
    room = BAND * face / 2 - a.half  # what is left beside it when all of it is within the band
    aside = max(room, 0.1 * face)
    if a.mount == b.mount == "wall":  # one may be thicker than the other
        aside = max(aside, THICKER)
    reach = SMALL if small else REACH if kind == "flanking" else BEYOND if lateral else AHEAD
    params: dict[str, Any] = {"max": round(a.half + reach, 3), "band": round(2 * aside / face, 3)}
    if a.is_flat or a.mount != b.mount:
        params["min"] = round(min(a.size[:2]) / 2, 3)
    yield Row({"left": "left_of", "right": "right_of", "front": "in_front_of", "back": "behind"}[side], params)
    if kind == "flanking":
        yield Row("near", {"max": SMALL if small else REACH})


def _along(a: Thing, b: Thing, side: str, k: int, n: int) -> Iterator[Row]:
    """At the ``k``-th of ``n`` places of a side."""
    if a.mount == "floor" and b.mount == "floor":
        yield from _at_place(side, k, n, list(PULLED) if a.is_seat else [0.0, 0.5])
    else:
        yield from _sided("in_front_of", a, b, side)


def _at_place(side: str, k: int, n: int, gap: list[float]) -> Iterator[Row]:
    """Before the middle of a part of a side; what is against a thing may stand in the space that this keeps free."""
    yield Row("seated_at", {"side": side, "k": k, "n": n, "gap": gap, "offset": 0.12})
    yield Row("front_against", {"gap": gap}, hard=False)


def _at_end(kind: str, a: Thing, b: Thing, side: str | None, k: int, n: int) -> Iterator[Row]:
    """At the foot of a bed, at the head of a table."""
    if a.is_seat and b.is_table and side is not None:
        yield from _at_place(side, k, n, list(PULLED))
        return
    yield from _sided("in_front_of" if kind == "at_foot" else "behind", a, b, "front" if kind == "at_foot" else "back")
    yield Row("near", {"max": REACH})
    yield Row("parallel", hard=False)


def of_place(said: StatedRelation, a: Thing, count: int) -> Iterator[tuple[str, str | None, dict[str, Any]]]:
    """Type, target and parameters of the relations to a part of the room; ``count`` things are said to be there."""
    place, kind = said.targets[0], kind_of(said)
    if place == "middle":
        offset = 0.2 if count == 1 else round(0.3 + count * a.half, 2)
        if a.mount in ("floor", "ceiling"):
            yield "in_middle", None, {"offset": offset}
    elif place == "corner":
        if a.mount == "floor":
            yield "in_corner", None, {}
    elif place == "window":
        yield from _at_window("at" if kind != said.type else kind, a)
    elif place == "door":
        yield from _at_door(kind)
    elif place.startswith("wall") and a.mount in ("floor", "wall") and kind not in ("far_from", "facing"):
        yield "against_wall", place if ":" in place else None, {}


def _at_window(kind: str, a: Thing) -> Iterator[tuple[str, str | None, dict[str, Any]]]:
    if kind == "far_from":
        yield "near_window", "window", {"min": FAR, "max": 60.0}
    elif kind == "opposite" or (kind == "facing" and a.is_seat):
        yield "near_window", "window", {"min": ACROSS[0], "max": ACROSS[1]}
    elif kind == "near":
        yield "near_window", "window", {"min": 0.3 if a.mount == "floor" else 0.0, "max": 0.9}
    elif kind in ("next_to", "left_of", "right_of", "flanking", "side_by_side"):
        yield "near_window", "window", {"min": 0.22 if a.mount == "floor" else 0.0, "max": REACH + 0.15}
    elif a.mount != "ceiling":
        yield "at_window", "window", {"max": 0.35} if a.mount == "floor" else {}


def _at_door(kind: str) -> Iterator[tuple[str, str | None, dict[str, Any]]]:
    if kind == "far_from":
        yield "away_from_door", None, {"min": 1.5}
    elif kind in ("opposite", "facing"):
        yield "near_door", "door", {"min": ACROSS[0], "max": ACROSS[1]}
    elif kind in ("next_to", "left_of", "right_of", "flanking", "at", "against", "side_by_side"):
        yield "near_door", "door", {"min": 0.0, "max": REACH + 0.1}
    else:
        yield "near_door", "door", {"min": 0.3 if kind == "near" else 0.0, "max": NEAR[1]}


__all__ = ["Row", "Thing", "groups_of", "of_pair", "of_place"]
