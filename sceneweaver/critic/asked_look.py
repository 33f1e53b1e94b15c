"""What became of what a request says of the look of its whole room: style, time, theme, mood, light, finishes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sceneweaver.assets.materials import color_name, color_named, finishes, paint, reflectance
from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.room_looks import room_looks
from sceneweaver.assets.taxonomy import members
from sceneweaver.knowledge.looks import Look, joined, looks
from sceneweaver.knowledge.since import is_too_young, since
from sceneweaver.language import StatedFinish, StatedLook
from sceneweaver.language.wall_names import walls_meant
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import InputError, RoomLight
from sceneweaver.verify.solids import Body

from .survey import Survey
from .verdict import Asked, counted, met, partly, unmet

LIMITS = fault_kind("wrong_look").limits
"""Least shares of what is seen that are of a look, and how many things carry it."""

MIRED = 1_000_000
"""Over a colour temperature [K] the number by which eyes tell lamps apart."""

ELECTRIC = 1880
"""Year from which on there are electric lamps."""

LEVELS = ("dark", "dim", "normal", "bright")


class _Check(NamedTuple):
    """One thing that a look asks for: whether it is so, and what is there instead, in words."""

    holds: bool
    reason: str
    measured: tuple[str, float, float] | None = None
    objects: tuple[str, ...] = ()
    grave: bool = False
    """Whether nothing of the look is there without it."""


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each look, each time and each finish that the request states."""
    brief = survey.brief
    rows = {said.name: looks()[said.name] for said in brief.looks if said.name in looks()}
    whole = joined(rows.values()) if rows else None
    done = set[str]()
    for said in brief.looks:
        row = rows.get(said.name)
        if row is None or whole is None or said.name in done:
            continue
        done.add(said.name)
        yield _look(survey, said, row, whole)
    if brief.year is not None:
        yield _time(survey, brief.year)
    for said in brief.finishes:
        if said.part == "furniture" and any(one.part == "panels" and one.span == said.span for one in brief.finishes):
            continue
        yield _finish(survey, said)


def _look(survey: Survey, said: StatedLook, row: Look, whole: Look) -> Asked:
    """One look by all that its row asks for."""
    checks = list(_checks(survey, said, row, whole))
    wrong = [check for check in checks if not check.holds]
    item, ids = f"room.{said.id}", tuple(i for check in wrong for i in check.objects)[: int(LIMITS["shown"])]
    numbers = [check.measured for check in (wrong or checks) if check.measured is not None]
    m = counted(numbers[0][0], numbers[0][1], numbers[0][2]) if numbers else None
    told = "; ".join(check.reason for check in (wrong or checks)) or "nothing of it can be measured"
    reason = f"'{said.words}': {told}"
    if checks and not wrong:
        lacking = row.lacks or ("marks of use are not drawn" if row.worn else "")
        return partly("room", item, ids, f"{reason}; {lacking}", m) if lacking else met("room", item, ids, reason, m)
    if len(wrong) < len(checks) and not any(check.grave for check in wrong):
        return partly("room", item, ids, reason, m)
    return unmet(
        "room", item, ids, reason, m, fault="wrong_look", suggestion=f"start again with a room that is {row.name}"
    )


def _checks(survey: Survey, said: StatedLook, row: Look, whole: Look) -> Iterator[_Check]:
    if any((row.walls, row.floor, row.woods, row.textiles, row.metals)):
        yield _in_palette(survey, whole)
    if row.things:
        wanted, there = frozenset(row.things), [b for b in survey.bodies if b.item.category in row.things]
        kinds, least = {b.item.category for b in there}, min(int(LIMITS["things"]), len(wanted))
        reason = (
            f"{', '.join(sorted(kinds)).replace('_', ' ') or 'nothing'} {'carry' if len(kinds) > 1 else 'carries'} it"
        )
        yield _Check(len(kinds) >= least, reason, ("kinds of things that carry it", len(kinds), least))
    if row.never:
        banned = {name for word in row.never for name in (word, *members(word))} - set(whole.things)
        odd = [b for b in survey.bodies if b.item.category in banned and not _is_asked(survey, b)]
        yield _Check(not odd, f"{len(odd)} things are no part of it", None, tuple(b.id for b in odd))
    if row.floors:
        yield _stands_out(survey)
    yield from _light(survey, said, row)


def _light(survey: Survey, said: StatedLook, row: Look) -> Iterator[_Check]:
    """The light that the room is shown in beside the one that is asked for, and its lamps."""
    have, want = survey.scene.room.light or RoomLight(), row.light
    told = f"the light is {have.level}, {have.kelvin} K, {have.daylight}"
    if want.level is not None:
        right = have.level == want.level or _refined(survey, row, "level", have.level)
        yield _Check(right, told, grave=row.kind == "light")
    if want.daylight is not None:
        yield _Check(have.daylight == want.daylight or _refined(survey, row, "daylight", have.daylight), told)
    if want.kelvin is not None:
        near = abs(MIRED / have.kelvin - MIRED / want.kelvin) <= LIMITS["mired"]
        yield _Check(near or _refined(survey, row, "kelvin", have.kelvin), told)
    color = said.color or want.glow
    if color is not None:
        yield _Check(have.glow is not None, f"the room glows in {have.glow or 'no colour'}")
    if want.outside is not None:
        seen = bool(survey.scene.room.windows)
        yield _Check(
            seen and have.outside == want.outside, f"outside is {have.outside}" if seen else "there is no window"
        )
    if row.only == "named":
        lamps = [b for b in survey.bodies if _is_lamp(b.item.category) and not _is_asked(survey, b)]
        yield _Check(not lamps, f"{len(lamps)} lamps are there that nobody named", None, tuple(b.id for b in lamps))
    if row.only == "flame":
        lamps = [b for b in survey.bodies if _is_lamp(b.item.category)]
        electric = [b for b in lamps if since().get(b.item.category, 0) >= ELECTRIC]
        flames = [b for b in survey.bodies if b not in electric and (b in lamps or b.item.category in FLAMES)]
        yield _Check(not electric, f"{len(electric)} lamps are electric", None, tuple(b.id for b in electric))
        yield _Check(bool(flames), f"{len(flames)} things burn")


FLAMES = frozenset(
    ("fireplace", "wood_stove", "candle", "candlestick", "brazier", "firepit", "forge_hearth", "furnace")
)


def _refined(survey: Survey, row: Look, field: str, value: object) -> bool:
    """Whether another look that the request names asks for what is there."""
    others = (looks()[said.name] for said in survey.brief.looks if said.name in looks() and said.name != row.name)
    return any(getattr(other.light, field) == value for other in others)


def _is_lamp(category: str) -> bool:
    return "lighting" in groups_above(category)


def _is_asked(survey: Survey, body: Body) -> bool:
    return survey.program.asked_of.get(body.id) is not None


def _time(survey: Survey, year: int) -> Asked:
    """That nothing is younger than the time of the room."""
    young = [b for b in survey.bodies if is_too_young(b.item.category, year)]
    own = [b for b in young if not _is_asked(survey, b)]
    m = counted("things that came later", len(young), 0, 0)
    names = ", ".join(sorted({b.item.category.replace("_", " ") for b in young}))
    item, ids = "room.year", tuple(b.id for b in young)
    if not young:
        return met("room", item, (), f"nothing came into use after {year}", m)
    if not own:
        return partly("room", item, ids, f"after {year} came what is asked for: {names}", m)
    return unmet("room", item, ids, f"after {year} came: {names}", m, fault="anachronism", suggestion=f"remove {names}")


# ---- what is seen ----------------------------------------------------------------------------------------------------


def _stands_out(survey: Survey) -> _Check:
    """How far the floor is from the walls, in percent of the light that they reflect."""
    looks_ = room_looks(survey.scene.room)
    wall, floor = (100.0 * reflectance(material.color) for material in (looks_.wall, looks_.floor))
    told, least = f"walls reflect {wall:.0f} % of light, the floor {floor:.0f} %", LIMITS["contrast"]
    return _Check(abs(wall - floor) >= least, told, ("contrast of walls and floor", abs(wall - floor), least))


def _in_palette(survey: Survey, look: Look) -> _Check:
    """The share of what is seen, walls, floor and furniture, that has the finishes or colours of a look."""
    good, all_, odd = 0.0, 0.0, list[tuple[float, str]]()
    colors, materials = _colors(survey, look), frozenset((*look.woods, *look.metals, *look.paints))
    for area, color, material, name in seen(survey):
        all_ += area
        if material in materials or basic(color) in colors:
            good += area
        elif name:
            odd.append((area, name))
    share = good / all_ if all_ else 1.0
    reason = f"{share:.0%} of what is seen is in its colours and materials"
    worst = tuple(name for _, name in sorted(odd, reverse=True)[: int(LIMITS["shown"])])
    numbers = ("share in its colours", share, LIMITS["share"])
    return _Check(share >= LIMITS["share"], reason, numbers, worst, share < LIMITS["part"])


def seen(survey: Survey) -> Iterator[tuple[float, str, str, str]]:
    """Areas [m2] with their colour and material: walls, floor, and the sides and tops of things; "" for no object."""
    room, finish = survey.scene.room, survey.scene.room.finish
    if finish is not None:
        around = sum(wall.length for wall in room.walls)
        glass = sum(window.width * window.height for window in room.windows)
        high, accent = room.height, finish.accent
        banded = 0.0
        if accent is not None:
            length = sum(room.walls[k].length for k in accent.walls if k < len(room.walls))
            banded = length * min(accent.high or (LIMITS["panels"] if accent.kind == "panelling" else high), high)
            yield banded, accent.color, accent.color, ""
        yield max(around * high - glass - banded, 0.0), finish.walls, finish.walls, ""
        tone = finish.floor.tone or ""
        yield survey.area, tone, tone, ""
    for body in survey.bodies:
        d, w, h = body.size
        attributes = body.item.attributes
        area = 2.0 * (d + w) * h + d * w if body.item.mount != "wall" else w * h
        yield area, str(attributes.get("color", "")), str(attributes.get("material", "")), body.id


def _colors(survey: Survey, look: Look) -> frozenset[str]:
    """The basic colours that a look has, and those that the request names itself, which outrank it."""
    names = [*look.textiles, look.trim, look.walls and look.walls.color, look.accent and look.accent.color]
    names += [look.panels and look.panels.color, look.floor and look.floor.tone, look.ceiling and look.ceiling.color]
    names += [*look.woods, *look.metals, *look.paints, *survey.brief.colors]
    names += [said.color for said in survey.brief.finishes]
    names += [entity.color for entity in survey.brief.entities]
    return frozenset(found for name in names if name and (found := basic(name)))


def basic(name: str) -> str:
    """The basic colour of a colour or a finish; "" for what has none."""
    if name in finishes() or name.endswith(" paint"):
        try:
            return color_name(paint(name).material.color)
        except KeyError:
            return ""
    try:
        return color_named(name)
    except InputError:
        return ""


# ---- finishes --------------------------------------------------------------------------------------------------------


def _finish(survey: Survey, said: StatedFinish) -> Asked:
    """One part of the room beside what was said of it."""
    holds, is_ = _part(survey, said)
    item, what = f"room.{said.id}", said.part.replace("lower", "lower walls").replace("tiled", "tiled walls")
    if holds:
        return met("room", item, (), f"'{said.words}': {what} {is_}")
    return unmet("room", item, (), f"'{said.words}': {what} {is_}", fault="wrong_room_finish", suggestion="paint it so")


def _part(survey: Survey, said: StatedFinish) -> tuple[bool, str]:
    """Whether a part is as said, and what it is."""
    room, finish = survey.scene.room, survey.scene.room.finish
    if finish is None:
        return False, "as usual"
    accent, above = finish.accent, finish.ceiling
    every = len(room.walls)
    match said.part:
        case "walls":
            same = said.color is None or _alike(finish.walls, said.color)
            whole = accent is not None and accent.kind != "panelling" and accent.high is None
            covered = whole and accent is not None and len(accent.walls) > 1
            of = said.material in (None, finish.walls_of)
            printed = said.pattern in (None, finish.walls_pattern) and _alike_too(finish.walls_second, said.second)
            shown = " ".join(filter(None, (finish.walls, finish.walls_pattern, finish.walls_of)))
            return same and of and printed and not covered, shown
        case "floor":
            tone, laid = finish.floor.tone, finish.floor.pattern
            right = said.material in (None, finish.floor.material) and (said.color is None or tone == said.color)
            right = right and said.pattern in (None, laid) and _alike_too(finish.floor.second, said.second)
            return right, " ".join(filter(None, (tone, finish.floor.second, laid, finish.floor.material)))
        case "ceiling":
            if above is None:
                return said.color in ("white", None) and said.material in (None, "plaster"), "white plaster"
            right = said.material in (None, above.material) and (said.color is None or above.color == said.color)
            return right, f"{above.color} {above.material}"
        case "beams":
            there = above is not None and above.beams is not None
            return there, f"of {above.beams}" if there and above is not None else "missing"
        case "panels":
            if accent is None or accent.kind != "panelling" or len(accent.walls) < every:
                return False, "missing"
            high = _as_high(accent.high or LIMITS["panels"], said, room.height)
            return high and said.color in (None, accent.color), f"{accent.color}, {accent.high or 0.0:.2f} m high"
        case "tiled":
            tiles = finish.tiles
            if tiles is None or tiles.low > 0.0 or (tiles.walls is not None and len(tiles.walls) < every):
                return False, "missing"
            right = _alike(tiles.color, said.color or tiles.color) and said.pattern in (None, tiles.pattern)
            return right and _as_high(tiles.high, said, room.height), f"{tiles.color}, {tiles.high:.2f} m high"
        case "doors":
            return finish.doors is not None and _alike(finish.doors, said.color or ""), finish.doors or "as usual"
        case "lower" | "accent":
            if accent is None or accent.kind == "panelling":
                return False, "missing"
            if said.part == "lower":
                placed = len(accent.walls) == every and _as_high(accent.high or room.height, said, room.height)
            else:
                placed = len(accent.walls) == 1 and (
                    said.where == "any" or accent.walls[0] in walls_meant(said.where, room)
                )
            of = said.material in (None, "plaster", "paper", accent.of) and said.pattern in (None, accent.pattern)
            shown = " ".join(filter(None, (accent.color, accent.pattern, accent.of)))
            return placed and of and _alike(accent.color, said.color or accent.color), shown
        case "furniture":
            return _of_wood(survey.bodies, said.color or "")
        case "everything":
            return _all_of_it(survey, said)


def _as_high(is_: float, said: StatedFinish, ceiling: float) -> bool:
    """Whether something ends at the height that is told, or at the ceiling below it."""
    slack = fault_kind("wrong_room_finish").limits["height"]
    return said.high is None or abs(is_ - min(said.high, ceiling)) <= slack


def _alike_too(is_: str | None, want: str | None) -> bool:
    return want is None or (is_ is not None and _alike(is_, want))


def _of_wood(bodies: Sequence[Body], wood: str) -> tuple[bool, str]:
    """Whether most of what is of wood is of this one."""
    woods = {name for name, finish in finishes().items() if finish.family == "wood"}
    there = [str(b.item.attributes.get("material")) for b in bodies if b.item.attributes.get("material") in woods]
    good = sum(name == wood for name in there)
    return bool(there) and 2 * good >= len(there), f"{good} of {len(there)} wooden things are {wood}"


def _all_of_it(survey: Survey, said: StatedFinish) -> tuple[bool, str]:
    """Whether nearly all that is seen is in one colour, or in two, but for what has one of its own by the request."""
    wanted = {basic(color) for color in (said.color, said.second) if color}
    own = {e.id for e in survey.brief.entities if e.color or e.material}
    parts = {one.color for one in survey.brief.finishes if one is not said}
    good, whole = 0.0, 0.0
    for area, color, material, name in seen(survey):
        if survey.program.asked_of.get(name) in own or (not name and color in parts):
            continue
        whole += area
        good += area * bool({basic(color), basic(material)} & wanted)
    share, least = good / whole if whole else 1.0, fault_kind("wrong_room_finish").limits["everything"]
    names = " and ".join(filter(None, (said.color, said.second)))
    return share >= least, f"{share:.0%} of what is seen is {names}"


def _alike(is_: str, want: str) -> bool:
    return is_ == want or basic(is_) == basic(want) != ""
