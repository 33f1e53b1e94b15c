"""Runs, lines and grids as relations: who is next to whom, on which side and how far away. The search finds the place.

What does not always fit in one way is proposed in several *variants*: sets of relations of which one has to hold.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from sceneweaver.scene import Relation, Room

from .grid import grid_variants, in_grid
from .program import Wanted
from .run import TIGHT, Variant, run_of

LOOSE = (0.12, 0.6)
"""Least and largest gap [m] between the pieces of a line."""

IN_LINE = 0.02
"""Distance [m] by which the pieces of a line with given gaps may be out of line."""

PART = 0.7
"""Share of the longest wall from which on a line with given gaps may stand in two parts."""

PLAY = 0.05
"""Length [m] by which the gaps of a line may differ before they are made equal."""


def row_variants(
    program: Sequence[Wanted], room: Room, strip: float, corners: Sequence[Variant] = (), most: int = 6
) -> list[Variant]:
    """Up to ``most`` ways to set out what stands in grids, lines and runs; empty when nothing does, or nothing fits.

    ``strip`` [m] is the depth along the walls that a grid leaves to other things, ``corners`` are the ways that a run
    with a corner unit may go.
    """
    choices: list[list[Variant]] = []
    if in_grid(program):
        grids = grid_variants(program, room, strip)
        if not grids:
            return []
        choices.append(grids)
    run = run_of(program)
    if corners:
        choices.append(list(corners))
    elif len(run) > 1:
        choices.append(list(_run_variants(run, room)))
    choices += [list(_line_variants(line, room)) for line in lines_of(program)]
    if not choices:
        return []
    count = min(most, max(map(len, choices)))
    return [tuple(r for options in choices for r in options[k % len(options)]) for k in range(count)]


def in_rows(program: Sequence[Wanted]) -> bool:
    """Whether something of a program stands in grids, lines or runs."""
    return in_grid(program) or len(run_of(program)) > 1 or bool(lines_of(program))


def lines_of(program: Sequence[Wanted]) -> list[list[Wanted]]:
    """The pieces in order of each line of two or more: those of an item, or of all items that name it."""
    lines: dict[str, list[Wanted]] = {}
    for one in program:
        item = one.item
        if item and item.row == "line" and one.mount in ("floor", "wall") and (item.line or one.parent is None):
            name = item.line or item.id
            lines.setdefault(f"{name} {one.parent.id}" if one.parent else name, []).append(one)
    return [sorted(pieces, key=_order) for pieces in lines.values() if len(pieces) >= 2]


def _order(one: Wanted) -> tuple[float, int]:
    return (one.item.run if one.item and one.item.run is not None else 0.5), one.number


def _run_variants(pieces: Sequence[Wanted], room: Room) -> Iterator[Variant]:
    """A run that begins or ends in a corner of the room where a wall is long enough for it, and one in two parts.

    None goes around a corner: without a corner unit, what stands in the corner could not be opened.
    """
    count = len(pieces)
    long = sum(one.asset.size[1] for one in pieces) >= max(_walls(room))
    if not long:
        yield _run(pieces, count - 1, corner=True)
        yield _run(pieces, 0, corner=True)
    if count >= 4 or (long and count >= 2):
        yield _run(pieces[: count // 2], 0, corner=False) + _run(pieces[count // 2 :], 0, corner=False)


def _run(pieces: Sequence[Wanted], first: int, corner: bool) -> Variant:
    """The relations of a run that starts from one of its pieces, in a corner or anywhere at a wall."""
    leader = pieces[first].id
    found = [Relation(type="against_wall", subject=leader, params={"gap": TIGHT["gap"], "degrees": TIGHT["degrees"]})]
    if corner:
        found.append(Relation(type="in_corner", subject=leader))
    for a, b in itertools.pairwise(pieces[first:]):
        found.append(Relation(type="run_on", subject=b.id, target=a.id, params={"side": "right", **TIGHT}))
    for a, b in itertools.pairwise(reversed(pieces[: first + 1])):
        found.append(Relation(type="run_on", subject=b.id, target=a.id, params={"side": "left", **TIGHT}))
    return tuple(found)


def _line_variants(pieces: Sequence[Wanted], room: Room) -> Iterator[Variant]:
    """A line with as much space between its pieces as the longest wall has, with little, and in two parts; where its
    items say the gaps, with those, whole or in two parts."""
    if any(one.item and one.item.gap for one in pieces):
        yield _line(pieces, LOOSE[0])
        length = sum(one.asset.size[1] + (one.item.gap[0] if one.item and one.item.gap else 0.0) for one in pieces)
        if len(pieces) >= 4 and length > PART * max(_walls(room)):
            half = len(pieces) // 2
            yield _line(pieces[:half], LOOSE[0]) + _line(pieces[half:], LOOSE[0])
        return
    widths = [one.asset.size[1] for one in pieces]
    longest = max(_walls(room))
    spare = (longest - sum(widths)) / (len(pieces) + 1)
    roomy = min(LOOSE[1], max(LOOSE[0], spare))
    yield from (_line(pieces, gap) for gap in dict.fromkeys((roomy, 0.5 * (roomy + LOOSE[0]), LOOSE[0])))
    if len(pieces) >= 4:
        half = len(pieces) // 2
        yield _line(pieces[:half], LOOSE[0]) + _line(pieces[half:], LOOSE[0])


def _line(pieces: Sequence[Wanted], gap: float) -> Variant:
    usual = (round(max(0.02, gap - PLAY), 3), round(gap + PLAY, 3))
    found = []
    for a, b in itertools.pairwise(pieces):
        said = b.item.gap if b.item else None
        params = {"side": "right", "gap": said, "offset": IN_LINE} if said else {"side": "right", "gap": usual}
        found.append(Relation(type="next_to", subject=b.id, target=a.id, params=params))
    return tuple(found)


def _walls(room: Room) -> list[float]:
    """The length [m] of each wall less its doors."""
    return [wall.length - sum(d.width for d in room.doors if d.wall == wall.index) for wall in room.walls]
