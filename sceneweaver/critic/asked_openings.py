"""What became of the doors and windows that a request describes: measured in the finished room's walls."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.geometry.recesses import set_back, sides_of
from sceneweaver.geometry.seen import ahead_of, are_opposite, is_wall
from sceneweaver.geometry.walls import Point, Wall
from sceneweaver.language.model import StatedOpening
from sceneweaver.language.told_openings import entry_stated, is_bay, is_high_up, leads_on
from sceneweaver.language.vocabulary import words
from sceneweaver.language.wall_names import PARTS
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import Door, Window

from .survey import Survey
from .verdict import Asked, counted, met, partly, unmet

UNDRAWN = (
    *("coloured glass", "stained glass", "painted glass", "leaded glass", "frosted glass", "frosted", "leaded"),
    *("garage", "roller", "barred", "arched", "arch", "pointed arch", "round", "pointed", "lockable", "locking"),
    *("glass panel", "internal", "stable", "barn", "folding", "revolving", "sash", "casement", "dormer"),
    *("bifold", "bi fold", "concertina", "accordion", "saloon", "automatic", "hidden", "secret", "concealed", "pivot"),
    *("dutch", "louvred", "louvered", "soundproof", "airtight", "self closing", "trap"),
    *words("openings")["gates"],
)
"""Kinds that are drawn like any other: an opening that is right else is so in part."""


BEGIN = "start again with a room as asked"


def _limit(name: str) -> float:
    """A number of `wrong_doors`, which goes for all openings."""
    return fault_kind("wrong_doors").limits[name]


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each opening that the request describes."""
    walls = survey.placed.walls
    used: dict[str, list[Door | Window]] = {}
    taken: set[str] = set()
    room = survey.scene.room
    entry = walls[room.doors[0].wall] if room.doors else None
    first = entry_stated(survey.brief)
    ahead = ahead_of(entry, first.wall if first is not None else "any") if entry is not None else None
    for one in survey.brief.openings:
        if one.part not in ("door", "window"):
            yield _wall_part(one, survey, ahead) if one.part in ("niche", "breast") else _not_built(one)
            continue
        have: Sequence[Door | Window] = room.doors if one.part == "door" else room.windows
        beside = one.part == "door" and leads_on(one)  # not the door that one comes in by
        free = [opening for opening in have[beside:] if opening.id not in taken]
        faults = {opening.id: _fault(one, opening, walls, entry, ahead, used) for opening in free}
        good = [opening for opening in free if not faults[opening.id]][: one.count]
        taken.update(opening.id for opening in good)
        used[one.id] = good or list(free[:1])
        number = counted(f"such {one.part}s", len(good), one.count)
        undrawn = [feature for feature in one.features if feature in UNDRAWN or _leads_to_room(feature)]
        apart = "same wall" in one.features and len({opening.wall for opening in good}) > 1
        if len(good) >= one.count and not apart:
            if undrawn:
                reason = f"{one.words}: it is there, and not drawn as '{undrawn[0]}'"
                yield partly("room", f"room.{one.id}", (), reason, number)
            else:
                yield met("room", f"room.{one.id}", (), f"{one.words}: {_told(one, good, walls)}", number)
            continue
        reason = next((fault for fault in faults.values() if fault), "") or f"there are {len(good)}"
        reason = "they are in several walls" if apart else reason
        yield unmet(
            "room",
            f"room.{one.id}",
            (),
            f"'{one.words}': {reason}",
            number,
            fault=f"wrong_{one.part}s",
            suggestion=BEGIN,
        )


def _leads_to_room(feature: str) -> bool:
    """Whether a feature names a room behind a door, of which nothing is seen."""
    where = feature.removeprefix("to the ")
    return where != feature and where not in (*words("openings")["outside"], *words("openings")["in_the_open"])


def _fault(
    one: StatedOpening,
    opening: Door | Window,
    walls: Sequence[Wall],
    entry: Wall | None,
    ahead: Point | None,
    used: dict[str, list[Door | Window]],
) -> str:
    """What is not as asked about an opening; empty where all is."""
    wall, part = walls[opening.wall], one.part
    own = entry is not None and entry.index == wall.index and part == "door"
    seen = "any" if own and one.wall in ("left", "right", "side", "far", "near") else one.wall
    if not is_wall(seen, wall, walls, entry, ahead, one.run):
        name = one.wall if one.run == "any" else f"{one.wall} {one.run}"
        return f"{opening.id} is not in the {name} wall"
    if "apart" in one.features and any(
        opening.wall == other.wall and type(other) is type(opening) for others in used.values() for other in others
    ):
        return f"{opening.id} is in the wall of another one"
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
    if isinstance(opening, Window) and is_bay(one) and not _in_bay(wall, walls):
        return f"{opening.id} is in a straight wall"
    kind_fault = _window_fault(one, opening) if isinstance(opening, Window) else _door_fault(one, opening)
    return kind_fault or _place_fault(one, opening, wall)


def _in_bay(wall: Wall, walls: Sequence[Wall]) -> bool:
    """Whether a wall is the back of what stands out of the room."""
    return wall.index in set_back(walls)


def _door_fault(one: StatedOpening, door: Door) -> str:
    """What of the kind of a door is not as asked: how it opens, how low it is."""
    kinds = set(one.features)
    if kinds & {"sliding", "pocket"} and door.swing != "slide":
        return f"{door.id} does not slide"
    if kinds & {"outward", "outward opening"} and door.swing != "out":
        return f"{door.id} does not open outwards"
    if kinds & {"inward", "inward opening"} and not door.swing.startswith("in"):
        return f"{door.id} does not open inwards"
    if kinds & {"low", "crawl in", "crawl through", "tiny"} and door.height > _limit("low_door"):
        return f"{door.id} is {door.height:.2f} m high"
    return ""


def _window_fault(one: StatedOpening, window: Window) -> str:
    """What of the kind of a window is not as asked: how high it begins, how large it is, how its sides compare."""
    kinds, (low, tall, wide) = set(one.features), (window.sill, window.height, window.width)
    shape = f"{window.id} is {wide:.2f} x {tall:.2f} m"
    sides = f"{window.id} begins {low:.2f} m above the floor"
    if one.sill is not None and abs(low - one.sill) > _limit("sill"):
        return sides
    if kinds & {"horizontal", "ribbon", "strip"} and wide < _limit("slot") * tall:
        return shape
    if kinds & {"slot", "slit"} and max(wide, tall) < _limit("slot") * min(wide, tall):
        return shape
    if kinds & {"small", "little", "tiny", "narrow", "slim"} and min(wide, tall) > _limit("small_side"):
        return shape
    if kinds & {"floor to ceiling", "full height", "french", "patio"} and low > _limit("floor"):
        return sides
    up = is_high_up(one)
    if up and low < _limit("high_sill") or "low" in kinds and low > _limit("low_sill"):
        return sides
    long = kinds & {"tall", "vertical"} or ("high" in kinds and not up)
    if long and tall < _limit("tall") and low < _limit("high_sill"):
        return f"{window.id} is {tall:.2f} m high"
    return ""


def _told(one: StatedOpening, good: Sequence[Door | Window], walls: Sequence[Wall]) -> str:
    """Where openings are and how large, as measured."""
    return "; ".join(
        f"{o.id} is {o.width:.2f} x {o.height:.2f} m in a wall of {walls[o.wall].length:.2f} m"
        + (f", {o.sill:.2f} m above the floor" if isinstance(o, Window) else "")
        for o in good[: one.count]
    )


def _place_fault(one: StatedOpening, opening: Door | Window, wall: Wall) -> str:
    before, after = opening.offset, wall.length - opening.offset - opening.width
    if one.at == "middle" and one.count == 1 and abs(before - after) / 2 > _limit("middle"):
        return f"{opening.id} is {abs(before - after) / 2:.2f} m off the middle of its wall"
    if one.at == "left" and after > _limit("corner"):
        return f"{opening.id} is {after:.2f} m from the left corner"
    if one.at == "right" and before > _limit("corner"):
        return f"{opening.id} is {before:.2f} m from the right corner"
    if "corner" in one.features and isinstance(opening, Window) and min(before, after) > _limit("corner"):
        return f"{opening.id} is {min(before, after):.2f} m from a corner"
    if one.at == "corner" and min(before, after) > _limit("corner"):
        return f"{opening.id} is {min(before, after):.2f} m from a corner"
    if one.at == "along" and one.count == 1 and opening.width < _limit("along") * wall.length:
        return f"{opening.id} takes {opening.width / wall.length:.0%} of its wall"
    return ""


def _wall_part(one: StatedOpening, survey: Survey, ahead: Point | None) -> Asked:
    """A niche or a chimney breast, measured by the walls that stand back or forward."""
    room, walls, noun = survey.scene.room, survey.placed.walls, one.words or one.part
    entry = walls[room.doors[0].wall] if room.doors else None
    here = [walls[k] for k in PARTS["beside_breast" if "beside" in one.features else one.part](room)]
    faults = {wall.index: _part_fault(one, wall, walls, entry, ahead) for wall in here}
    good = [wall for wall in here if not faults[wall.index]]
    number = counted(f"such {one.part}s", len(good), one.count)
    if len(good) >= one.count:
        sizes = "; ".join(f"{w.length:.2f} m wide and {_depth(w, walls):.2f} m deep" for w in good[: one.count])
        return met("room", f"room.{one.id}", (), f"{noun}: {sizes}", number)
    reason = next((fault for fault in faults.values() if fault), f"there are {len(here)}")
    return unmet("room", f"room.{one.id}", (), f"'{noun}': {reason}", number, fault="wrong_shape", suggestion=BEGIN)


def _depth(wall: Wall, walls: Sequence[Wall]) -> float:
    """How far [m] a wall stands back or forward: the shorter of its sides."""
    return min(side.length for side in sides_of(wall.index, walls))


def _part_fault(one: StatedOpening, wall: Wall, walls: Sequence[Wall], entry: Wall | None, ahead: Point | None) -> str:
    """What is not as asked about a part of a wall."""
    name = f"the {one.part}"
    if not is_wall(one.wall, wall, walls, entry, ahead, one.run):
        return f"{name} is not in the {one.wall if one.run == 'any' else f'{one.wall} {one.run}'} wall"
    before, after = walls[wall.index - 2].length, walls[(wall.index + 2) % len(walls)].length
    if one.at == "middle" and one.count == 1 and abs(before - after) / 2 > _limit("middle"):
        return f"{name} is {abs(before - after) / 2:.2f} m off the middle of its wall"
    if one.opposite == "door" and entry is not None and not are_opposite(wall, entry):
        return f"{name} is not opposite the door"
    if one.width is not None and abs(wall.length - one.width) > _limit("slack"):
        return f"{name} is {wall.length:.2f} m wide"
    if one.depth is not None and abs(_depth(wall, walls) - one.depth) > _limit("slack"):
        return f"{name} is {_depth(wall, walls):.2f} m deep"
    return ""


def _not_built(one: StatedOpening) -> Asked:
    """What no room has here."""
    reason = f"'{one.words}' is not built: {next(iter(one.features), 'it cannot be')}"
    return unmet("room", f"room.{one.id}", (), reason, fault="wrong_shape", suggestion="do without it")


__all__ = ["outcomes"]
