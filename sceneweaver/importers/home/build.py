"""A home from the rooms that a reader gives of one house."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

import numpy as np

from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, WallThickness
from sceneweaver.io import InputError
from sceneweaver.io.messages import clean, quote

from ..model import SourceRoom
from ..plan_types import OUTDOOR, plan_type
from . import floors
from .doorways import open_up
from .floors import Drawn
from .leaves import faults_of, hang
from .model import ImportedHome
from .storeys import PlanRoom, levels_of, stacked, storeys_of


def home_of(rooms: Sequence[SourceRoom], format_name: str, *, name: str, drawn: Drawn = "auto") -> ImportedHome:
    """The home that the rooms of one house make.

    Args:
        rooms: of one house, as a reader gives them.
        format_name: of their format.
        name: id of the home.
        drawn: whether outlines are the "faces" of walls or their "middles"; "auto": as the gaps between rooms say.

    Raises:
        InputError: no room of it has an outline.
    """
    notes = list(dict.fromkeys(note for room in rooms for note in room.notes))
    named = _named(rooms, notes)
    if not named:
        raise InputError("no room has an outline; a home needs at least one")
    rings = {key: np.asarray(source.outline, dtype=float) for key, (source, _) in named.items()}
    angle = floors.turn_of(list(rings.values()))
    if angle:
        notes.append(f"the plan is turned by {math.degrees(-angle):.2f} degrees, its walls along the axes")
    levels = levels_of([source for source, _ in named.values()])
    thick = WallThickness()
    made: list[PlanRoom] = []
    inner: list[float] = []
    for level, storey in enumerate(levels):
        mine = {k: v for k, v in named.items() if v[0].storey == storey}
        outlines, walls = _outlines({k: floors.turned(rings[k], angle) for k in mine}, drawn, thick, notes)
        inner.append(walls)
        for key, outline in outlines.items():
            source, kind = mine[key]
            made.append(PlanRoom(key, kind, level, outline, source))
    if not made:
        raise InputError("nothing is left of its rooms; are the outlines closed and in metres?")
    made = stacked(made, levels, notes)
    storeys = storeys_of(made, levels, notes)
    doors: list[HomeDoor] = []
    windows: list[HomeWindow] = []
    used: set[str] = set()
    for level in range(len(levels)):
        here = [room for room in made if room.storey == level]
        open_up(here, storeys[level].height, angle, used, doors, windows, notes)
    said = {o.name for room in made for o in room.source.openings if o.swing is not None}
    home = Home(
        id=name,
        prompt=next((room.text for room in rooms if room.text), ""),
        storeys=tuple(storeys),
        walls=WallThickness(inner=round(min(inner), 3), outer=thick.outer),
        rooms=tuple(
            HomeRoom(
                id=room.name,
                type=room.type,
                storey=storeys[room.storey].id,
                outline=room.outline,
                outdoor=room.type in OUTDOOR,
            )
            for room in made
        ),
        doors=tuple(doors),
        windows=tuple(windows),
        provenance={"imported": {"format": format_name, "rooms": {r.name: r.source.name for r in made}}},
    )
    free = {door.id for door in home.doors if door.id not in said}
    if free and any(faults_of(home).values()):
        home = home.with_changes(doors=hang(home, free))
        stuck = {name for name, faults in faults_of(home).items() if faults and name in free}
        stuck = _sliding(home, stuck)
        if stuck:
            notes.append(f"doors that have no room to swing are taken to slide: {', '.join(sorted(stuck))}")
            slid = {"kind": "sliding", "opens_into": None}
            doors = [d.model_copy(update=slid) if d.id in stuck else d for d in home.doors]
            home = home.with_changes(doors=tuple(doors))
    return ImportedHome(home, format_name, tuple(dict.fromkeys(notes)), tuple(rooms))


def _sliding(home: Home, stuck: set[str]) -> set[str]:
    """Of doors whose leaves meet something those that are to slide: one after another, while some still meet."""
    found: set[str] = set()
    inner = [d.id for d in home.doors if d.id in stuck and d.to is not None]
    for name in inner:
        doors = [
            d.model_copy(update={"kind": "sliding", "opens_into": None}) if d.id in found else d for d in home.doors
        ]
        if faults_of(home.with_changes(doors=tuple(doors))).get(name):
            found.add(name)
    return found


def _named(rooms: Sequence[SourceRoom], notes: list[str]) -> dict[str, tuple[SourceRoom, str]]:
    """Rooms of a plan by an id of their own, with their types; shafts and rooms without an outline left out."""
    found: dict[str, tuple[SourceRoom, str]] = {}
    for room in rooms:
        kind = plan_type(room.type or re.sub(r"[\W_]*\d+$", "", room.name))
        if kind is None:
            notes.append(f"{room.name}: {quote(room.type)} is no room; it stays wall")
            continue
        if room.outline is None or len(room.outline) < 3:
            notes.append(f"{room.name}: the file has no outline of it; left out")
            continue
        if not np.isfinite(np.asarray(room.outline, dtype=float)).all():
            raise InputError(f"room {room.name}: outline: a corner is not finite; give metres")
        stem = clean(room.name).strip().removeprefix("wall:") or kind
        key, k = stem, 2
        while key in found:
            key, k = f"{stem}_{k}", k + 1
        found[key] = room, kind
    return found


def _outlines(
    rings: dict[str, np.ndarray], drawn: Drawn, thick: WallThickness, notes: list[str]
) -> tuple[dict[str, tuple[tuple[float, float], ...]], float]:
    """Clear floors of a storey by room, and the thickness [m] of the walls between them."""
    keys = list(rings)
    cleaned = dict(zip(keys, floors.clean([rings[k] for k in keys]), strict=True))
    notes += [f"{key}: {note}" for key, floor in cleaned.items() if floor is not None for note in floor.notes]
    kept = {key: floor.ring for key, floor in cleaned.items() if floor is not None}
    notes += [f"{key}: nothing is left of it" for key in keys if key not in kept]
    found = floors.gaps(list(kept.values()))
    middles = drawn == "middles" or (drawn == "auto" and floors.on_middles(found))
    if middles:
        notes.append(f"rooms share lines: each wall is moved inwards by {thick.inner / 2:g} m, half its thickness")
    outlines = {}
    for key, ring in kept.items():
        ring = floors.inset(ring, thick.inner / 2) if middles else ring
        outline = None if ring is None else floors.on_grid(ring)
        if outline is None:
            notes.append(f"{key}: nothing is left of it between its walls")
            continue
        outlines[key] = outline
    outlines = floors.apart(outlines)
    return outlines, floors.thickness(list(outlines.values()), thick.inner)
