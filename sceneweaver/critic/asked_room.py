"""What became of what a request says of the room itself, of its style and of its colours."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from sceneweaver.assets.materials import color_named, color_words
from sceneweaver.geometry.angles import cross
from sceneweaver.rules.faults import fault_kind, number
from sceneweaver.scene import InputError
from sceneweaver.verify.measure import Measurement

from . import asked_look, asked_openings, kinds
from .survey import Survey
from .verdict import Asked, counted, met, not_understood, partly, unmet

BEGIN = "start again with a room as asked"


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each fact about the room that the request states, and the words that were not understood."""
    brief, room, area = survey.brief, survey.scene.room, survey.area
    if brief.room_type is not None:
        is_, want = kinds.a(survey.room_type.name), kinds.a(brief.room_type)
        holds = brief.room_type == survey.room_type.name
        yield _fact("room_type", holds, f"{is_}; {want} was asked for", None, "wrong_room")
    if brief.other_rooms:
        named = ", ".join(name.replace("_", " ") for name in brief.other_rooms)
        yield met("room", "room.other_rooms", (), f"one room is made; the request names {named} as well", assumed=True)
    yield from _areas(survey)
    if brief.shape is not None:
        shape = shape_of(survey)
        yield _fact(
            "shape",
            shape == brief.shape,
            f"the floor is {shape}-shaped, '{brief.shape}' was asked for",
            None,
            "wrong_shape",
            points=fault_kind("wrong_shape").limits["room"],
        )
    if brief.wing is not None and brief.size is not None:
        yield _wing(survey, max(brief.size), brief.wing)
    if brief.height is not None:
        slack = fault_kind("wrong_height").limits["slack"]
        high = Measurement("height", room.height, brief.height - slack, brief.height + slack)
        reason = f"the ceiling is {room.height:.2f} m high, {brief.height:.2f} m was asked for"
        yield _fact("height", high.ok(1e-9), reason, high, "wrong_height")
    if brief.people is not None and survey.room_type.area_per_person is not None and not _asked_area(survey):
        least = fault_kind("too_small").limits["per_person"] * survey.room_type.area_per_person
        each = Measurement("floor a person", area / max(1, brief.people), least, math.inf, "m2")
        if not each.ok():  # that there is floor for them does not mean that they have places, which are counted apart
            yield _fact("people", False, f"{each.value:.1f} m2 a person for {brief.people} people", each, "too_small")
    for name, asked, have in (("door", brief.doors, room.doors), ("window", brief.windows, room.windows)):
        if asked is not None:
            number = counted(f"{name}s", len(have), asked, asked)
            reason = f"{len(have)} {name}s, {asked} were asked for"
            yield _fact(f"{name}s", number.ok(), reason, number, f"wrong_{name}s")
    yield from asked_openings.outcomes(survey)
    yield from _style(survey)
    yield from asked_look.outcomes(survey)
    for k, unread in enumerate(brief.unread):
        yield not_understood("unread", f"unread-{k}", (), f"'{unread.words}' was not understood")


def _fact(
    name: str,
    holds: bool,
    reason: str,
    m: Measurement | None,
    fault: str,
    objects: Iterable[str] = (),
    suggestion: str = BEGIN,
    share: float = 1.0,
    points: float | None = None,
) -> Asked:
    ids = tuple(objects)
    if holds:
        return met("room", f"room.{name}", ids, f"{name.replace('_', ' ')} as asked", m)
    return unmet("room", f"room.{name}", ids, reason, m, fault=fault, points=points, suggestion=suggestion, share=share)


def _asked_area(survey: Survey) -> float | None:
    brief = survey.brief
    if brief.size is None:
        return brief.area
    return brief.size[0] * brief.size[1] + (brief.wing[0] * brief.wing[1] if brief.wing is not None else 0.0)


def _wing(survey: Survey, main: float, wing: tuple[float, float]) -> Asked:
    """Whether the walls of the floor have the lengths of its main part and of both sides of what sticks out."""
    lengths = [wall.length for wall in survey.placed.walls]
    slack = number("wall_length")
    off = max(min(abs(length - side) for length in lengths) for side in (main, *wing))
    m = Measurement("difference of a wall", off, 0.0, slack)
    sides = f"{wing[0]:g} x {wing[1]:g} m"
    return _fact(
        "wing", m.ok(1e-9), f"no part of the floor of {sides} sticks out of one {main:g} m long", m, "wrong_shape"
    )


def _areas(survey: Survey) -> Iterator[Asked]:
    brief, area, want = survey.brief, survey.area, _asked_area(survey)
    limits = fault_kind("wrong_area").limits
    if want is not None:
        m = Measurement("floor", area, want * (1.0 - limits["slack"]), want * (1.0 + limits["slack"]), "m2")
        reason = f"{area:.1f} m2 of floor, {want:.1f} m2 were asked for"
        yield _fact("area" if brief.size is None else "size", m.ok(1e-9), reason, m, "wrong_area")
    elif brief.scale != 1.0:
        usual = survey.room_type.area[1]
        low, high = (usual, math.inf) if brief.scale > 1.0 else (-math.inf, usual)
        m = Measurement("floor", area, low, high, "m2", 1e-9)
        word = "large" if brief.scale > 1.0 else "small"
        reason = f"{area:.1f} m2 of floor for a {word} room; usual are {usual:.1f} m2"
        yield _fact("scale", m.ok(), reason, m, "wrong_area", points=limits["vague"])


def shape_of(survey: Survey) -> str:
    """The shape of the floor by its corners that turn inward and outward."""
    walls = survey.placed.walls
    sines = [cross(walls[wall.index - 1].along, wall.along) for wall in walls]
    limits = fault_kind("wrong_shape").limits
    turns = [sine for sine in sines if abs(sine) > limits["straight"]]
    inward = sum(t < 0 for t in turns)
    if inward == 0:
        return "rectangle" if len(turns) == 4 else "round" if len(turns) >= limits["round_corners"] else "polygon"
    if inward == 1:
        return "L"
    if inward == 2:
        signs = [t < 0 for t in turns]
        between = [i for i, s in enumerate(signs) if s]
        gap = min(between[1] - between[0], len(signs) - between[1] + between[0])
        return "U" if gap == 1 else "T"
    return "polygon"


def basic_color(name: str) -> str:
    """The basic colour of a name; the name itself where it is none."""
    try:
        return color_named(name)
    except InputError:
        return name.lower()


def _style(survey: Survey) -> Iterator[Asked]:
    brief = survey.brief
    furniture = [b for b in survey.bodies if b.item.mount == "floor"]
    if brief.style is not None and not brief.looks:  # else its look is measured as a whole
        told, limits = [b for b in furniture if "style" in b.item.attributes], fault_kind("wrong_style").limits
        other = [b for b in told if b.item.attributes["style"] != brief.style]
        share = counted("pieces of the style", len(told) - len(other), math.ceil(len(told) / 2))
        reason = f"{len(told) - len(other)} of {len(told)} pieces are {brief.style}"
        if share.ok():  # as they were chosen; how it looks is not measured
            yield met("room", "room.style", (), reason, share, assumed=True)
        else:
            yield _fact(
                "style",
                False,
                reason,
                share,
                "wrong_style",
                [b.id for b in other[: limits["shown"]]],
                f"choose {brief.style} furniture",
                len(other) / max(1, len(told)),
                limits["room"],
            )
    if brief.colors:
        yield _colors(survey)


def _colors(survey: Survey) -> Asked:
    """The colours that are named for the room: each is there, and together they are a good part of what is seen."""
    wanted = {basic_color(c): c for c in survey.brief.colors}
    shown, whole = dict.fromkeys(wanted, 0.0), 0.0
    for area, color, material, _ in asked_look.seen(survey):
        whole += area
        for name in {asked_look.basic(color), asked_look.basic(material)} & set(shown):
            shown[name] += area
    share = sum(shown.values()) / whole if whole else 1.0
    missing = [wanted[name] for name, area in shown.items() if area == 0.0]
    m = counted("share in the colours", share, fault_kind("wrong_colors").limits["share"])
    item, names = "room.colors", " and ".join(survey.brief.colors)
    if len(missing) == len(wanted) and whole:
        return unmet(
            "room", item, (), f"nothing is {names}", m, fault="wrong_colors", suggestion=f"choose furniture in {names}"
        )
    unread = {word for left in survey.brief.unread for word in left.words.lower().split()}.intersection(color_words())
    if not missing and unread:
        return partly("room", item, (), f"'{min(unread)}' was not understood", m)
    if missing or not m.ok():
        lack = f"nothing is {' or '.join(missing)}" if missing else f"{share:.0%} of what is seen is {names}"
        return partly("room", item, (), lack, m)
    return met("room", item, (), "colors as asked", m)
