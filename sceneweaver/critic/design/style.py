"""Colours and style of a room: few hues and woods, small things that follow them, pairs that match."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator

from sceneweaver.assets.materials import color_named, finishes, hue, own_look
from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.scene import InputError
from sceneweaver.scene.palette import Palette
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..survey import Survey
from .breach import breach
from .measure import applies, asked_for, names

SEEN = 0.04
"""Share of what is seen of furniture and cloth from which a colour counts."""

SAME_WOOD = 0.17
"""Distance in sRGB up to which two woods look like one."""

DARK = frozenset(("black", "dark brown"))

LAMPS = frozenset(("table_lamp", "desk_lamp"))

UNDYED = frozenset(("bottle", "food"))
"""Families of finishes that have the colours of what they are made of in any room."""

FEWEST = 6
"""Small things from which their style is looked at."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for colours and style."""
    if applies(survey, "three_hues", "two_woods", "not_one_colour"):
        yield from _colours(survey)
    if applies(survey, "small_things_in_style"):
        yield from _small(survey)
    if applies(survey, "pairs_match"):
        yield from _pairs(survey)


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


def _colours(survey: Survey) -> Iterator[Finding]:
    hues: dict[str, float] = defaultdict(float)
    woods: dict[str, float] = defaultdict(float)
    owners: dict[str, list[Body]] = defaultdict(list)
    whole = dark = 0.0
    for body in survey.bodies:
        colour = _colour(body)
        if body.item.mount == "surface" or colour is None or body.item.category in own_look():
            continue
        area = _area(body)
        whole += area
        dark += area if colour in DARK else 0.0
        family = _family(body)
        wood = family == "wood"
        name = str(body.item.attributes.get("material")) if wood else None if family == "metal" else _hue(colour)
        if name is not None and not asked_for(survey, body):
            (woods if wood else hues)[name] += area
            owners[name].append(body)
    if whole <= 0.0:
        return
    kept = [h for h, area in hues.items() if area > SEEN * whole]
    tones = _tones([w for w, area in woods.items() if area > SEEN * whole])
    most = limit("three_hues", "hues")
    if len(kept) + bool(tones) > most and survey.scene.palette is None:
        yield breach(
            "three_hues",
            (b.id for h in kept for b in owners[h]),
            f"{', '.join(sorted(kept))}{' and wood' if tones else ''}: {len(kept) + bool(tones)} hues in one room",
            measured=float(len(kept) + bool(tones)),
            allowed=(None, most),
            suggestion="take furniture and cloth of one palette",
        )
    most = limit("two_woods", "woods")
    if len(tones) > most:
        yield breach(
            "two_woods",
            (b.id for tone in tones for w in tone for b in owners[w]),
            f"{len(tones)} woods in one room: {', '.join(sorted(tone[0] for tone in tones))}",
            measured=float(len(tones)),
            allowed=(None, most),
            suggestion="take furniture of two woods",
        )
    share = dark / whole
    if share > limit("not_one_colour", "share"):
        yield breach(
            "not_one_colour",
            (),
            f"{share:.0%} of what is seen of the furniture is black or dark brown",
            measured=share,
            allowed=(None, limit("not_one_colour", "share")),
            suggestion="take furniture of a lighter colour",
        )


def _tones(woods: list[str]) -> list[list[str]]:
    """Woods that look alike, together."""
    groups: list[list[str]] = []
    for wood in sorted(woods):
        near = [g for g in groups if any(_like(wood, other) for other in g)]
        groups = [g for g in groups if g not in near] + [[wood, *(w for g in near for w in g)]]
    return groups


def _like(a: str, b: str) -> bool:
    one, other = (finishes()[n].material.color for n in (a, b))
    return math.dist(one, other) < SAME_WOOD


def _small(survey: Survey) -> Iterator[Finding]:
    """Small things of other styles than the room's, or of colours that its palette does not have."""
    share, palette = limit("small_things_in_style", "share"), survey.scene.palette
    off, small = off_palette(survey)
    if len(small) >= FEWEST and len(off) > share * len(small):
        read = "style" if palette is None else "color"
        styles = Counter(str(b.item.attributes.get(read)) for b in off).most_common(3)
        wanted = _style(survey) if palette is None else f"of the colours of {palette.name}"
        yield breach(
            "small_things_in_style",
            (b.id for b in off),
            f"{len(off)} of {len(small)} small things are not {wanted} but {', '.join(s for s, _ in styles)}",
            measured=len(off) / len(small),
            allowed=(None, share),
            weight=8.0 * (len(off) / len(small) - share) / (1 - share),
            suggestion="take small things of the room's style and palette",
        )


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
        and not asked_for(survey, b)
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


def _pairs(survey: Survey) -> Iterator[Finding]:
    """Nightstands at one bed, and the lamps on them, that differ."""
    size = design_rules()["pairs_match"].limits["size"]
    for bed in survey.on_floor(kinds.BEDS):
        stands = [b for b, _ in survey.near(bed, 0.5) if b.item.category == "nightstand"][:2]
        if len(stands) < 2:
            continue
        lamps = [[b for b in survey.carried.get(s.id, ()) if b.item.category in LAMPS] for s in stands]
        pairs = [stands, [row[0] for row in lamps]] if all(lamps) else [stands]
        for one, other in pairs:
            if not _match(one, other, size):
                yield breach(
                    "pairs_match",
                    (one.id, other.id),
                    f"{one.id} and {other.id} at the sides of {bed.id} differ",
                    measured=max(abs(a - b) for a, b in zip(one.size, other.size, strict=True)),
                    allowed=(0.0, size),
                    suggestion=f"take {names((one,))} for both sides",
                )


def _match(a: Body, b: Body, size: float) -> bool:
    alike = all(abs(x - y) <= size for x, y in zip(a.size, b.size, strict=True))
    return alike and all(a.item.attributes.get(k) == b.item.attributes.get(k) for k in ("material", "color"))
