"""Measures of looks and of small things: hues, woods, styles, copies, what there is too much of, and what is missed."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from sceneweaver.assets.materials import color_named, finishes, hue, own_look
from sceneweaver.knowledge.complete import expected_of
from sceneweaver.knowledge.small_things import belongs as at_home
from sceneweaver.knowledge.small_things import left_about, most_of
from sceneweaver.rules.design import room_groups
from sceneweaver.rules.faults import number
from sceneweaver.scene import InputError
from sceneweaver.scene.palette import Palette
from sceneweaver.verify.solids import Body

from .. import kinds
from ..survey import Survey
from .bodies import asked, groups
from .query import kind_set
from .registry import measure

UNDYED = frozenset(("bottle", "food"))
"""Families of finishes that have the colours of what they are made of in any room."""


# ---- colours ---------------------------------------------------------------------------------------------------------


class Look(NamedTuple):
    """A hue, or woods that look alike, and what has them."""

    names: tuple[str, ...]
    bodies: tuple[Body, ...]


def _area(body: Body) -> float:
    """Largest side of a body's box [m2]: about what is seen of it."""
    d, w, h = body.size
    return max(d * w, w * h, d * h)


def _family(body: Body) -> str | None:
    row = finishes().get(str(body.item.attributes.get("material")))
    return row.family if row is not None else None


def _colour(body: Body) -> str | None:
    value = body.item.attributes.get("color")
    return value if isinstance(value, str) else None


def _hue(colour: str) -> str | None:
    """The hue of a colour by any name ("rust" is orange); None for a neutral or an unknown one."""
    try:
        return hue(color_named(colour))
    except InputError:
        return None


def _coloured(survey: Survey) -> list[tuple[Body, str]]:
    """The furniture and cloth whose colour is known, with it."""
    found = [(b, _colour(b)) for b in survey.bodies if b.item.mount != "surface" and b.item.category not in own_look()]
    return [(b, colour) for b, colour in found if colour is not None]


def _seen(survey: Survey, wood: bool, least: float) -> dict[str, list[Body]]:
    """Hues, or woods, that are more than a share of what is seen of furniture and cloth, with what has them."""
    coloured = _coloured(survey)
    owners: dict[str, list[Body]] = defaultdict(list)
    for body, colour in coloured:
        family = _family(body)
        name = str(body.item.attributes.get("material")) if wood else None if family == "metal" else _hue(colour)
        if (family == "wood") is wood and name is not None and not asked(survey, body):
            owners[name].append(body)
    whole = sum(_area(b) for b, _ in coloured)
    return {name: row for name, row in owners.items() if sum(map(_area, row)) > least * whole}


@measure
def hues(survey: Survey, least: float) -> list[Look]:
    """The hues of furniture and cloth that are more than a share of what is seen of them."""
    return sorted(Look((name,), tuple(row)) for name, row in _seen(survey, False, least).items())


@measure
def woods(survey: Survey, least: float, alike: float) -> list[Look]:
    """The woods that are more than a share of what is seen, those that look alike (in sRGB) together."""
    seen = _seen(survey, True, least)
    tones = sorted(_tones(list(seen), alike))
    return [Look(tuple(tone), tuple(b for name in tone for b in seen[name])) for tone in tones]


@measure
def share_of_colours(survey: Survey, colours: Sequence[str]) -> float:
    """Share of what is seen of furniture and cloth that has any of some colours."""
    coloured = _coloured(survey)
    whole = sum(_area(b) for b, _ in coloured)
    return sum(_area(b) for b, colour in coloured if colour in colours) / whole if whole > 0.0 else 0.0


def _tones(woods: list[str], alike: float) -> list[list[str]]:
    """Woods that look alike, together."""
    tones: list[list[str]] = []
    for wood in sorted(woods):
        near = [t for t in tones if any(_like(wood, other, alike) for other in t)]
        tones = [t for t in tones if t not in near] + [[wood, *(w for t in near for w in t)]]
    return tones


def _like(a: str, b: str, alike: float) -> bool:
    one, other = (finishes()[n].material.color for n in (a, b))
    return math.dist(one, other) < alike


def off_palette(survey: Survey) -> tuple[list[Body], list[Body]]:
    """The small things that do not follow the room's palette or, where it has none, its style; and all that should."""
    follows = [(b, in_style(survey, b)) for b in survey.bodies if b.item.mount == "surface"]
    return [b for b, right in follows if right is False], [b for b, right in follows if right is not None]


@measure
def in_style(survey: Survey, o: Body) -> bool | None:
    """Whether a small thing follows the room's palette or, where it has none, its style; None where it need not.

    What was asked for and what has a look of its own need not; in a room without style and palette nothing does.
    """
    palette, style = survey.scene.palette, _style(survey)
    own = o.item.category in own_look() or not o.item.attributes.get("style") or asked(survey, o)
    return None if own or not style else _follows(o, palette, style)


def _style(survey: Survey) -> str:
    palette = survey.scene.palette
    return str((palette.style if palette is not None else survey.scene.provenance.get("style")) or "")


def _follows(body: Body, palette: Palette | None, style: str) -> bool:
    if palette is None:
        return body.item.attributes["style"] == style
    material = str(body.item.attributes.get("material"))
    if material in (*palette.woods, *palette.paints, *palette.metals) or _family(body) in UNDYED:
        return True
    dyes = [*palette.textiles, *(paint.removesuffix(" paint") for paint in palette.paints)]
    return material.rpartition(" ")[0] in dyes or _hue(_colour(body) or "") in {None, *map(_hue, dyes)}


# ---- small things ----------------------------------------------------------------------------------------------------


@measure
def belongs(survey: Survey, o: Body) -> bool:
    """Whether people have a thing in such a room."""
    return at_home(o.item.category, survey.room_type.name)


@measure
def too_many(survey: Survey) -> list[Body]:
    """What there is beyond as many as such a room has, where nobody asked for more."""
    spare: list[Body] = []
    for bodies in groups(survey, survey.bodies, [b.item.category for b in survey.bodies]):
        most = most_of(bodies[0].item.category, survey.room_type.name)
        one_each = len(_tables_below(survey, bodies)) == len(bodies)  # as in a restaurant
        if most and len(bodies) > most and not one_each and not any(asked(survey, b) for b in bodies):
            spare += bodies[most:]
    return spare


def _tables_below(survey: Survey, bodies: Sequence[Body]) -> set[str]:
    """The tables that people sit around on which some things stand."""
    bases = [survey.placed.by_id.get(b.item.support.object) for b in bodies if b.item.support is not None]
    return {b.id for b in bases if b is not None and b.item.category in kind_set("dining_table")}


@measure
def look(_: Survey, o: Body) -> tuple[str, str]:
    """What things have in common that look exactly alike."""
    asset = (o.item.asset or "").split("&size")[0]
    return o.item.category, asset or str(o.item.attributes.get("material"))


@measure
def supports(survey: Survey) -> list[Body]:
    """Furniture that should carry something."""
    return [
        b
        for b in survey.bodies
        if b.item.surfaces
        and kinds.carries(b.item.category)
        and b.item.mount != "surface"
        and not left_about(b.item.category, survey.room_type.name)
        and any(within_reach(b, s.z) for s in b.item.surfaces)
    ]


def within_reach(body: Body, z: float) -> bool:
    """Whether a surface at a height [m] over the lower end of a body is low enough to put things on."""
    return body.position[2] + z < number("reached")


@measure
def missed(survey: Survey) -> list[str]:
    """What people look for in such a room and do not find, in words."""
    room, have = survey.room_type.name, Counter(b.item.category for b in survey.bodies)
    found = [
        row.why
        for row in expected_of(room)
        if (not row.where or any(have[c] for c in row.where)) and sum(have[c] for c in row.what) < row.count
    ]
    finish_ = survey.scene.room.finish
    tiled = finish_ is not None and finish_.tiles is not None
    wet = room in room_groups()["wet"]
    return [*found, "window and no tiles"] if wet and not survey.placed.windows and not tiled else found
