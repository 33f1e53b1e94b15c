"""Stations: things each of which has something of its own, on the wall before it or on the floor at it.

A barber's chair with its mirror and shelf, a wheel with its stool, a treatment chair with its pump. In a row, what each
has keeps its place to it.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from sceneweaver.assets.roles import has_role
from sceneweaver.knowledge import Place
from sceneweaver.knowledge.stations import own_on_floor, own_on_wall
from sceneweaver.language import Grounded, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement

from .patterns import Spot, extent_of
from .program import Wanted

REACH = 0.75
"""Gap [m] between the front of a seat and what hangs on the wall before it: somebody stands or leans there."""

ROOM = 0.75
"""Gap [m] between neighbours that somebody works around."""

NARROW = 0.5
"""Width [m] of a seat up to which neighbours have a usual gap: stools at a counter."""

WITHIN = 0.1
"""Most distance [m] of what hangs from its place."""

AT_HAND = (0.1, 0.35)
"""Gap [m] between two things of which one is told to be at the other, where the rooms say none, and most of it."""

MIRROR, BELOW, LEDGE = 1.0, 0.04, 0.7
"""Height [m] of the bottom of what one looks at from a seat that has a shelf below it, the gap between both, and the
least height of that shelf."""

_SIDEWAYS = ("side_by_side", "leftright_to_leftright", "next_to", "beside", "near", "left_of", "right_of")
"""Relations of pairs of which one is beside the other."""


def rows_before_walls(brief: SceneGraph, wanted: Sequence[Wanted]) -> Iterator[Arrangement]:
    """Rows of seats that are told to have something of their own on a wall and have no arrangement yet."""
    set_out = {a.entity for a in brief.arrangements}
    for said, seats, _ in _on_walls(brief, wanted):
        name = seats[0].asked or ""
        if name not in set_out:
            set_out.add(name)
            width = _width(seats[0], brief, wanted)
            pitch = width + (ROOM if seats[0].asset.size[1] > NARROW else width)
            yield Arrangement(id=said.id, entity=name, pattern="row", rows=1, pitch=pitch, at_least=True)


def of_their_own(
    brief: SceneGraph, wanted: Sequence[Wanted], patterns: Sequence[tuple[str, Sequence[Wanted]]]
) -> Iterator[Grounded]:
    """The place of what each thing of a row has for its own: in the middle before it, or beside it.

    Args:
        brief: the request.
        wanted: the objects to be.
        patterns: the rows, each as the entity and its things.
    """
    rows: dict[str, list[Wanted]] = {}
    for name, things in patterns:
        rows.setdefault(name, []).extend(things)
    before = [(said, hung) for said, _, hung in _on_walls(brief, wanted)]
    for name, things in rows.items():
        own = [(said, hung) for said, hung in before if _seats_of(said, brief) == name]
        deep = max((one.asset.size[0] for _, hung in own for one in hung), default=0.0)
        for said, hung in own:
            for seat, one in zip(things, hung, strict=False):
                ahead = seat.asset.size[0] / 2 + REACH + deep - one.asset.size[0] / 2
                at = {"ahead": round(ahead, 4), "left": 0.0, "turn": 180.0, "offset": WITHIN, "degrees": 2.0}
                yield Grounded(said.id, "arranged", one.id, seat.id, at)
    for said, anchors, partners, places, turn in _on_floor(brief, wanted):
        things = rows.get(anchors[0].asked or "")
        for anchor, one in zip(things, partners, strict=False) if things else ():
            spot = beside(anchor, one, places, turn)
            at = {"ahead": round(spot.ahead, 4), "left": round(spot.left, 4), "turn": spot.turn}
            yield Grounded(said.id, "arranged", one.id, anchor.id, {**at, "offset": 0.1, "degrees": 10.0})


def as_they_belong(rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What a request states, with pairs of which one belongs to the other as the rooms have them."""
    kept, things = list(rows), {one.id: one for one in wanted}
    for said in brief.relations:
        pair = own_on_floor(said, brief)
        if pair is None:
            continue
        found = [row for row in kept if row.said == said.id and isinstance(row.target, str) and row.target in things]
        if not all(things[n].support is None for row in found for n in (row.subject, str(row.target)) if n in things):
            continue
        kept = [row for row in kept if row not in found]
        hosts: list[str] = []
        for one, other in dict.fromkeys((row.subject, str(row.target)) for row in found):
            one, other = (one, other) if said.subject == pair.one else (other, one)
            kept += [
                Grounded(said.id, place.type, one, other, dict(place.params), not place.soft) for place in pair.places
            ]
            hosts += [other] if other not in hosts else []
        # several alike that stand by themselves are not turned this way and that
        kept += [Grounded(said.id, "aligned", b, a, {}, hard=False) for a, b in itertools.pairwise(hosts)]
    return kept


def with_their_own(one: Wanted, brief: SceneGraph, wanted: Sequence[Wanted]) -> tuple[float, float]:
    """The sides [m] of the box about a thing and what it has for its own, along its front and across."""
    box = [(Spot(0.0, 0.0), one.asset.size[0], one.asset.size[1])]
    for _, anchors, partners, places, turn in _on_floor(brief, wanted):
        if anchors[0].asked == one.asked:
            d, w, _ = partners[0].asset.size
            box.append((beside(one, partners[0], places, turn), d, w))
    depth, width = extent_of(box)
    return depth, max(width, _width(one, brief, wanted))


def room_beside(one: Wanted, brief: SceneGraph, wanted: Sequence[Wanted]) -> float:
    """Least gap [m] between neighbours of a row: of seats at their mirrors somebody works around each."""
    stands = any(seats[0].asked == one.asked for _, seats, _ in _on_walls(brief, wanted))
    return ROOM if stands and one.asset.size[1] > NARROW else 0.0


def beside(anchor: Wanted, one: Wanted, places: Sequence[Place], turn: int = 0) -> Spot:
    """Where a thing is in the frame of what it belongs to, as the relations of such a pair have it; the first of those
    beside it is at its left, the second at its right."""
    (d, w, _), (e, v, _) = anchor.asset.size, one.asset.size
    place = next((p for p in places if not p.soft), places[0])
    gap = place.params.get("gap")
    low, high = gap if gap is not None else (0.0, min(float(place.params.get("max", 2 * AT_HAND[0])), 2 * AT_HAND[0]))
    mean = min((low + high) / 2, AT_HAND[1])
    if place.type in _SIDEWAYS:
        return Spot((e - d) / 2, ((w + v) / 2 + mean) * (-1) ** turn, 0.0)  # with the backs in line: by the pillow
    if place.type == "behind":
        return Spot(-(d + e) / 2 - mean, 0.0, 0.0)
    return Spot((d + e) / 2 + mean, 0.0, 180.0)


def hung_before(brief: SceneGraph, wanted: Sequence[Wanted]) -> None:
    """Gives what hangs before a seat its height where there are several: shelves below what one looks at."""
    by_seat: dict[str, list[list[Wanted]]] = {}
    for _, seats, hung in _on_walls(brief, wanted):
        by_seat.setdefault(seats[0].asked or "", []).append(hung)
    for several in by_seat.values():
        shelves = [one for hung in several if has_role(hung[0].category, "shelves") for one in hung]
        others = [one for hung in several if not has_role(hung[0].category, "shelves") for one in hung]
        if not shelves or not others:
            continue
        for one in others:
            one.held, one.hung = "wall", (MIRROR, MIRROR + 0.002)
        for one in shelves:
            at = max(LEDGE, round(MIRROR - BELOW - one.asset.size[2], 3))
            one.held, one.hung = "wall", (at, at + 0.002)


def _width(seat: Wanted, brief: SceneGraph, wanted: Sequence[Wanted]) -> float:
    """Width [m] of a seat or of the widest thing that hangs before it."""
    own = (
        one.asset.size[1] for _, seats, hung in _on_walls(brief, wanted) if seats[0].asked == seat.asked for one in hung
    )
    return max(seat.asset.size[1], *own, 0.0)


def _seats_of(said: StatedRelation, brief: SceneGraph) -> str:
    station = own_on_wall(said, brief)
    return station.seats if station is not None else ""


def _on_walls(
    brief: SceneGraph, wanted: Sequence[Wanted]
) -> Iterator[tuple[StatedRelation, list[Wanted], list[Wanted]]]:
    """The statements that give each seat something on a wall, with the seats and those things."""
    for said in brief.relations:
        station = own_on_wall(said, brief)
        if station is None:
            continue
        seats = [w for w in wanted if w.asked == station.seats and w.mount == "floor" and w.support is None]
        hung = [w for w in wanted if w.asked == station.hung and w.mount == "wall"]
        if len(seats) > 1 and len(seats) == len(hung):
            yield said, seats, hung


def _on_floor(
    brief: SceneGraph, wanted: Sequence[Wanted]
) -> Iterator[tuple[StatedRelation, list[Wanted], list[Wanted], tuple[Place, ...], int]]:
    """The statements that give each thing of an arrangement another on the floor, with both, how rooms have them, and
    the number of the statement among those of the same side."""
    set_out = {a.entity for a in brief.arrangements}
    taken: dict[tuple[str, bool], int] = {}
    for said in brief.relations:
        pair = own_on_floor(said, brief)
        if pair is None:
            continue
        names = (said.targets[0], said.subject)
        anchor = next((name for name in names if name in set_out), None)
        if anchor is None:
            continue
        anchors, partners = (
            [w for w in wanted if w.asked == name and w.mount == "floor" and w.support is None]
            for name in (anchor, names[1] if anchor == names[0] else names[0])
        )
        if not anchors or len(anchors) != len(partners):
            continue
        turn = taken[anchor, pair.frontal] = taken.get((anchor, pair.frontal), -1) + 1
        if turn < (1 if pair.frontal else 2):  # what has no side left is near
            yield said, anchors, partners, pair.places, turn


__all__ = [
    "as_they_belong",
    "beside",
    "hung_before",
    "of_their_own",
    "room_beside",
    "rows_before_walls",
    "with_their_own",
]
