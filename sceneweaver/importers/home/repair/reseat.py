"""Doors and windows put back into walls that have moved, or with another width."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from sceneweaver.geometry.walls import walls_of
from sceneweaver.home import Home, HomeDoor, HomeWindow
from sceneweaver.io import InputError

from ...model import SourceOpening
from ..openings import Opening, Walls, place


def reseated(
    home: Home, outlines: Sequence[tuple[tuple[float, float], ...]], widths: Mapping[str, float] | None = None
) -> Home | None:
    """The home with other outlines of its rooms and its openings where they were; None: one of them finds no place.

    Args:
        home: as it was.
        outlines: of its rooms, with as many corners as before.
        widths: other widths [m] of openings by id, about their middles.
    """
    old = {room.id: room for room in home.rooms}
    new = dict(zip(old, outlines, strict=True))
    doors: list[HomeDoor] = []
    windows: list[HomeWindow] = []
    for storey in home.storeys:
        here = [room for room in home.rooms if room.storey == storey.id]
        index = {room.id: k for k, room in enumerate(here)}
        walls = Walls.of([new[room.id] for room in here])
        for opening in (*home.doors, *home.windows):
            if opening.room not in index:
                continue
            source = opening_of(opening, old[opening.room].outline, new[opening.room], (widths or {}).get(opening.id))
            to = getattr(opening, "to", None)
            rooms = [index[opening.room]] + ([index[to]] if to is not None else [])
            placed = place(Opening(source, tuple(rooms)), walls, only=True)
            if isinstance(placed, str):
                return None
            names = here[placed.room].id, None if placed.to is None else here[placed.to].id
            shared = {"room": names[0], "wall": placed.wall, "offset": placed.offset, "width": placed.width}
            if isinstance(opening, HomeDoor):
                doors.append(opening.model_copy(update={**shared, "to": names[1]}))
            else:
                windows.append(opening.model_copy(update=shared))
    order = {o.id: k for k, o in enumerate((*home.doors, *home.windows))}
    rooms = tuple(room.model_copy(update={"outline": new[room.id], "scene": None}) for room in home.rooms)
    return changed(
        home,
        rooms=rooms,
        doors=tuple(sorted(doors, key=lambda d: order[d.id])),
        windows=tuple(sorted(windows, key=lambda w: order[w.id])),
    )


def changed(home: Home, **parts: Any) -> Home | None:
    """The home with some parts changed; None where they do not fit together."""
    try:
        return home.with_changes(**parts)
    except InputError:
        return None


def opening_of(
    opening: HomeDoor | HomeWindow,
    old: Sequence[Sequence[float]],
    new: Sequence[Sequence[float]],
    width: float | None = None,
) -> SourceOpening:
    """An opening by its two ends, its middle moved as its wall has moved there."""
    wall, moved = walls_of(old)[opening.wall], walls_of(new)[opening.wall]
    middle = opening.offset + opening.width / 2
    share = middle / wall.length
    at = [
        wall.point(middle)[k] + (1 - share) * (moved.start[k] - wall.start[k]) + share * (moved.end[k] - wall.end[k])
        for k in (0, 1)
    ]
    half = (opening.width if width is None else width) / 2
    ends = [(at[0] + t * moved.along[0], at[1] + t * moved.along[1]) for t in (-half, half)]
    kind = "window" if isinstance(opening, HomeWindow) else "passage" if opening.kind == "open" else "door"
    source = SourceOpening(opening.id, kind, ends[0], ends[1])
    outside = isinstance(opening, HomeWindow) or opening.to is None
    return replace(source, leads_to="outside") if outside else source
