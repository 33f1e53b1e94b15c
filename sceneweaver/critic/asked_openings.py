"""What became of the doors and windows that a request describes: measured in the finished room's walls."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.geometry.seen import are_opposite, is_wall
from sceneweaver.geometry.walls import Wall
from sceneweaver.language.model import StatedOpening
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import Door, Window

from .survey import Survey
from .verdict import Asked, counted, met, unmet

UNDRAWN = ("coloured glass", "stained glass", "frosted", "leaded", "garage", "barred", "arched", "round", "pointed")
"""Kinds that are drawn like any other."""


def _limit(name: str) -> float:
    """A number of `wrong_doors`, which goes for all openings."""
    return fault_kind("wrong_doors").limits[name]


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each opening that the request describes."""
    walls = survey.placed.walls
    used: dict[str, list[Door | Window]] = {}
    taken: set[str] = set()
    room = survey.scene.room
    for one in survey.brief.openings:
        if one.part == "niche":
            yield _niche(one, walls)
            continue
        have: Sequence[Door | Window] = room.doors if one.part == "door" else room.windows
        free = [opening for opening in have if opening.id not in taken]
        entry = walls[room.doors[0].wall] if room.doors else None
        faults = {opening.id: _fault(one, opening, walls, entry, used) for opening in free}
        good = [opening for opening in free if not faults[opening.id]][: one.count]
        taken.update(opening.id for opening in good)
        used[one.id] = good or list(free[:1])
        number = counted(f"such {one.part}s", len(good), one.count)
        undrawn = [feature for feature in one.features if feature in UNDRAWN]
        if len(good) >= one.count and not undrawn:
            yield met("room", f"room.{one.id}", (), f"{one.words}: as asked", number)
            continue
        reason = next((fault for fault in faults.values() if fault), "") or f"there are {len(good)}"
        if len(good) >= one.count:
            reason = f"a {one.part} is not drawn as '{undrawn[0]}'"
        yield unmet(
            "room",
            f"room.{one.id}",
            (),
            f"'{one.words}': {reason}",
            number,
            fault=f"wrong_{one.part}s",
            suggestion="start again with a room as asked",
        )


def _fault(
    one: StatedOpening,
    opening: Door | Window,
    walls: Sequence[Wall],
    entry: Wall | None,
    used: dict[str, list[Door | Window]],
) -> str:
    """What is not as asked about an opening; empty where all is."""
    wall, part = walls[opening.wall], one.part
    own = entry is not None and entry.index == wall.index and part == "door"
    seen = "any" if own and one.wall in ("left", "right", "far", "near") else one.wall
    if not is_wall(seen, wall, walls, entry):
        return f"{opening.id} is not in the {one.wall} wall"
    if one.wall_length is not None and abs(wall.length - one.wall_length) > _limit("wall"):
        return f"{opening.id} is in a wall of {wall.length:.2f} m"
    across = [walls[o.wall] for o in used.get(one.opposite, [])]
    if one.opposite == "door" and entry is not None and not own:
        across = [entry]
    if across and not any(are_opposite(wall, other) for other in across):
        return f"{opening.id} is not in the opposite wall"
    if one.width is not None and abs(opening.width - one.width) > _limit("slack"):
        return f"{opening.id} is {opening.width:.2f} m wide"
    if one.height is not None and abs(opening.height - one.height) > _limit("slack"):
        return f"{opening.id} is {opening.height:.2f} m high"
    for feature in one.features:
        if opening.width < fault_kind("wrong_doors").limits.get(feature, 0):
            return f"{opening.id} is {opening.width:.2f} m wide, not {feature}"
    if isinstance(opening, Door) and "sliding" in one.features and opening.swing != "slide":
        return f"{opening.id} does not slide"
    if isinstance(opening, Window):
        if {"slot", "horizontal", "ribbon", "strip", "slit"} & set(one.features) and opening.width < _limit(
            "slot"
        ) * opening.height:
            return f"{opening.id} is {opening.width:.2f} x {opening.height:.2f} m"
        if "floor to ceiling" in one.features and opening.sill > _limit("floor"):
            return f"{opening.id} begins {opening.sill:.2f} m above the floor"
        if "tall" in one.features and opening.height < _limit("tall"):
            return f"{opening.id} is {opening.height:.2f} m high"
    return _place_fault(one, opening, wall)


def _place_fault(one: StatedOpening, opening: Door | Window, wall: Wall) -> str:
    before, after = opening.offset, wall.length - opening.offset - opening.width
    if one.at == "middle" and one.count == 1 and abs(before - after) / 2 > _limit("middle"):
        return f"{opening.id} is {abs(before - after) / 2:.2f} m off the middle of its wall"
    if one.at == "left" and after > _limit("corner"):
        return f"{opening.id} is {after:.2f} m from the left corner"
    if one.at == "right" and before > _limit("corner"):
        return f"{opening.id} is {before:.2f} m from the right corner"
    if one.at == "corner" and min(before, after) > _limit("corner"):
        return f"{opening.id} is {min(before, after):.2f} m from a corner"
    if one.at == "along" and one.count == 1 and opening.width < _limit("along") * wall.length:
        return f"{opening.id} takes {opening.width / wall.length:.0%} of its wall"
    return ""


def _niche(one: StatedOpening, walls: Sequence[Wall]) -> Asked:
    """A niche is a wall set back between two short ones that turn outward."""
    many = len(walls)
    found = 0
    for k in range(many):
        one_side, back, other = walls[k - 1], walls[k], walls[(k + 1) % many]
        sides = max(one_side.length, other.length) < _limit("deep") and are_opposite(one_side, other)
        found += bool(many > 4 and sides and back.length < _limit("long"))
    number = counted("niches", found, one.count)
    if found >= one.count:
        return met("room", f"room.{one.id}", (), f"{one.words}: as asked", number)
    return unmet(
        "room",
        f"room.{one.id}",
        (),
        f"'{one.words}': there is none",
        number,
        fault="wrong_shape",
        suggestion="start again with a room as asked",
    )


__all__ = ["outcomes"]
