"""Measures of looks and of small things: hues, woods, styles, copies, what there is too much of, and what is missed."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence

from sceneweaver.assets.materials import color_named, finishes, hue, own_look
from sceneweaver.knowledge.complete import expected_of
from sceneweaver.knowledge.lived_in import left_about
from sceneweaver.knowledge.small_things import belongs as at_home
from sceneweaver.knowledge.small_things import most_of
from sceneweaver.rules.design import room_groups
from sceneweaver.rules.faults import number
from sceneweaver.scene import InputError
from sceneweaver.scene.palette import Palette
from sceneweaver.verify.solids import Body

from .. import kinds
from ..survey import Survey
from .bodies import asked
from .query import kind_set
from .registry import measure

DARK = frozenset(("black", "dark brown"))

UNDYED = frozenset(("bottle", "food"))
"""Families of finishes that have the colours of what they are made of in any room."""


# ---- colours ---------------------------------------------------------------------------------------------------------


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
def hues(survey: Survey, least: float) -> list[str]:
    """The hues of furniture and cloth that are more than a share of what is seen of them."""
    return sorted(_seen(survey, False, least))


@measure
def woods(survey: Survey, least: float, alike: float) -> list[list[str]]:
    """The woods that are more than a share of what is seen, those that look alike (in sRGB) together."""
    return sorted(_tones(list(_seen(survey, True, least)), alike))


@measure
def in_hues(survey: Survey, names: Sequence[str]) -> list[Body]:
    """What has some hues."""
    seen = _seen(survey, False, 0.0)
    return [b for name in names for b in seen[name]]


@measure
def in_woods(survey: Survey, tones: Sequence[Sequence[str]]) -> list[Body]:
    """What is of some woods."""
    seen = _seen(survey, True, 0.0)
    return [b for tone in tones for name in tone for b in seen[name]]


@measure
def dark_share(survey: Survey) -> float:
    """Share of what is seen of furniture and cloth that is black or dark brown."""
    coloured = _coloured(survey)
    whole = sum(_area(b) for b, _ in coloured)
    return sum(_area(b) for b, colour in coloured if colour in DARK) / whole if whole > 0.0 else 0.0


@measure
def has_palette(survey: Survey) -> bool:
    """Whether the room has a palette."""
    return survey.scene.palette is not None


def _tones(woods: list[str], alike: float) -> list[list[str]]:
    """Woods that look alike, together."""
    groups: list[list[str]] = []
    for wood in sorted(woods):
        near = [g for g in groups if any(_like(wood, other, alike) for other in g)]
        groups = [g for g in groups if g not in near] + [[wood, *(w for g in near for w in g)]]
    return groups


def _like(a: str, b: str, alike: float) -> bool:
    one, other = (finishes()[n].material.color for n in (a, b))
    return math.dist(one, other) < alike


def off_palette(survey: Survey) -> tuple[list[Body], list[Body]]:
    """The small things that do not follow the room's palette or, where it has none, its style; and all that should.

    What was asked for and what has a look of its own need not; in a room without style and palette nothing does.
    """
    palette, style = survey.scene.palette, _style(survey)
    small = [
        b
        for b in survey.bodies
        if b.item.mount == "surface"
        and b.item.category not in own_look()
        and b.item.attributes.get("style")
        and not asked(survey, b)
    ]
    if not style:
        return [], []
    return [b for b in small if not _follows(b, palette, style)], small


def _style(survey: Survey) -> str:
    palette = survey.scene.palette
    return str((palette.style if palette is not None else survey.scene.provenance.get("style")) or "")


def _follows(body: Body, palette: Palette | None, style: str) -> bool:
    if palette is None:
        return body.item.attributes["style"] == style
    material = str(body.item.attributes.get("material"))
    if material in _finishes(palette) or _family(body) in UNDYED:
        return True
    dyes = [*palette.textiles, *(paint.removesuffix(" paint") for paint in palette.paints)]
    return material.rpartition(" ")[0] in dyes or _hue(_colour(body) or "") in {None, *map(_hue, dyes)}


def _finishes(palette: Palette) -> tuple[str, ...]:
    return (*palette.woods, *palette.paints, *palette.metals)


@measure
def styled(survey: Survey) -> list[Body]:
    """The small things that should follow the room's palette or style."""
    return off_palette(survey)[1]


@measure
def in_style(survey: Survey, o: Body) -> bool:
    """Whether a small thing follows the room's palette or, where it has none, its style."""
    return _follows(o, survey.scene.palette, _style(survey))


@measure
def size_difference(_: Survey, a: Body, b: Body) -> float:
    """The most [m] that two boxes differ along an axis."""
    return max(abs(x - y) for x, y in zip(a.size, b.size, strict=True))


@measure
def alike(survey: Survey, a: Body, b: Body, size: float) -> bool:
    """Whether two pieces are of one size, up to a difference [m], one material and one colour."""
    same = all(a.item.attributes.get(k) == b.item.attributes.get(k) for k in ("material", "color"))
    return same and size_difference(survey, a, b) <= size


@measure
def carried_each(survey: Survey, bases: Sequence[Body], kinds_: str) -> list[Body]:
    """The first of some categories on each of some pieces; none where one has none."""
    rows = [[b for b in survey.carried.get(base.id, ()) if b.item.category in kind_set(kinds_)] for base in bases]
    return [row[0] for row in rows] if all(rows) else []


# ---- small things ----------------------------------------------------------------------------------------------------


@measure
def belongs(survey: Survey, o: Body) -> bool:
    """Whether people have a thing in such a room."""
    return at_home(o.item.category, survey.room_type.name)


@measure
def a_room(survey: Survey) -> str:
    """The kind of room with its article."""
    return kinds.a(survey.room_type.name)


@measure
def too_many(survey: Survey) -> list[Body]:
    """What there is beyond as many as such a room has, where nobody asked for more."""
    spare: list[Body] = []
    for bodies in _by_category(survey).values():
        most = most_of(bodies[0].item.category, survey.room_type.name)
        one_each = len(_tables_below(survey, bodies)) == len(bodies)  # as in a restaurant
        if most and len(bodies) > most and not one_each and not any(asked(survey, b) for b in bodies):
            spare += bodies[most:]
    return spare


@measure
def of_kinds(survey: Survey, bodies: Sequence[Body]) -> list[Body]:
    """All of the categories of some things."""
    by, names = _by_category(survey), dict.fromkeys(b.item.category for b in bodies)
    return [b for name in names for b in by[name]]


def _by_category(survey: Survey) -> dict[str, list[Body]]:
    found: dict[str, list[Body]] = defaultdict(list)
    for body in survey.bodies:
        found[body.item.category].append(body)
    return found


def _tables_below(survey: Survey, bodies: Sequence[Body]) -> set[str]:
    """The tables that people sit around on which some things stand."""
    bases = [survey.placed.by_id.get(b.item.support.object) for b in bodies if b.item.support is not None]
    return {b.id for b in bases if b is not None and b.item.category in kind_set("dining_table")}


@measure
def kinds_of(survey: Survey, kinds_: str) -> list[str]:
    """The categories of a set that are there."""
    return list(dict.fromkeys(b.item.category for b in survey.of_kind(kind_set(kinds_))))


def _look(body: Body) -> tuple[str, str]:
    asset = (body.item.asset or "").split("&size")[0]
    return body.item.category, asset or str(body.item.attributes.get("material"))


@measure
def copies(_: Survey, o: Body, bodies: Sequence[Body]) -> int:
    """How many of some things look exactly like one of them, itself included."""
    return sum(_look(b) == _look(o) for b in bodies)


@measure
def by_look(_: Survey, bodies: Sequence[Body]) -> list[Body]:
    """Some things, those that look alike together."""
    order = {look: k for k, look in reversed([*enumerate(map(_look, bodies))])}
    return sorted(bodies, key=lambda b: order[_look(b)])


@measure
def number_of(survey: Survey, o: Body) -> int:
    """How many of a category there are."""
    return sum(b.item.category == o.item.category for b in survey.bodies)


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
def carries(_: Survey, o: Body) -> bool:
    """Whether something should stand on or in it."""
    return kinds.carries(o.item.category)


@measure
def on(survey: Survey, o: Body) -> Sequence[Body]:
    """What stands on it."""
    return survey.carried.get(o.id, ())


@measure
def boards(_: Survey, o: Body) -> int:
    """How many surfaces it has."""
    return len(o.item.surfaces)


@measure
def top_taken(survey: Survey, table: Body) -> float:
    """Share of the top of a table that the boxes of the things on it take."""
    d, w, _h = table.size
    top = (math.pi / 4 if abs(d - w) < 0.02 else 1.0) * d * w
    return sum(b.size[0] * b.size[1] for b in survey.carried.get(table.id, ())) / max(1e-6, top)


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
