"""Names for the things of a scene: words that mean one of them and no other."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from sceneweaver.assets.materials import finishes
from sceneweaver.verify.solids import Body

from .facts import Facts, group_of
from .nouns import noun, nouns

_COLOURED = frozenset(("furniture", "seating", "chair_group", "table_group", "bed_group", "storage", "textile"))
_OWN_COLOURS = frozenset(("window_blind", "curtain", "sheer_curtain", "display_cabinet", "display_case", "bath_mat"))
_UPHOLSTERED = frozenset(("sofa", "loveseat", "sectional_sofa", "sofa_bed", "recliner", "armchair", "mattress", "pouf"))
"""What nobody calls wooden, even where its frame is what its material names."""

_PLAIN = {
    "white": "pale", "cream": "pale", "beige": "pale", "light grey": "pale", "silver": "pale", "tan": "tan",
    "gold": "tan", "mustard": "yellow", "yellow": "yellow", "orange": "orange", "brown": "brown",
    "dark brown": "brown", "black": "black", "grey": "grey", "red": "red", "burgundy": "red", "pink": "pink",
    "green": "green", "dark green": "green", "sage": "green", "teal": "teal", "blue": "blue", "light blue": "blue",
    "navy": "navy", "purple": "purple",
}  # fmt: skip
"""Colours that nobody confuses, by name; those of one value are near to each other."""


@dataclass(frozen=True)
class Name:
    """Words that mean one object, and the ids that they speak of: its own first."""

    text: str
    ids: tuple[str, ...]


def color_families() -> dict[str, str]:
    """The colours that have a name here, each with the family in which one may be taken for the other."""
    return dict(_PLAIN)


def color(body: Body) -> str | None:
    """The colour of a body as a word, where its kind has one that is seen at a glance."""
    said = body.item.attributes.get("color")
    if not isinstance(said, str) or said not in _PLAIN or body.item.category in _OWN_COLOURS:
        return None
    material = finishes().get(str(body.item.attributes.get("material")))
    if material is not None and material.family == "wood" and body.item.category in _UPHOLSTERED:
        return None
    return said if group_of(body.item.category) in _COLOURED else None


def look(body: Body) -> tuple[str, str] | None:
    """An adjective for a body and the attribute that says so: ("walnut", "material") or ("cream", "color")."""
    said = color(body)
    material = body.item.attributes.get("material")
    if said is None:
        return None
    words = noun(body.item.category)
    if isinstance(material, str) and material in finishes() and material.split()[-1] != "wood":
        family = finishes()[material].family
        if family == "wood" or (family in ("leather", "metal", "stone", "woven") and "metal" not in words):
            return material, "material"
    return said, "color"


def names(facts: Facts) -> dict[str, Name]:
    """By id, the things that words can tell from all others; worked out once for each `Facts`."""
    if facts.names is None:
        facts.names = _names(facts)
    return facts.names


def _names(facts: Facts) -> dict[str, Name]:
    found: dict[str, Name] = {}
    categories = facts.by_category
    ambiguous = {c for c in categories if any(d != c and _may_mean(c, d) for d in categories)}
    for category, bodies in categories.items():
        if category not in ambiguous and len(bodies) == 1:
            found[bodies[0].id] = Name(f"the {noun(category)}", (bodies[0].id,))
    plain = dict(found)
    for category, bodies in categories.items():
        if category in ambiguous or len(bodies) < 2:
            continue
        colors = [color(b) for b in bodies]
        hues = [_PLAIN[c] if c else None for c in colors]
        for body, said, hue in zip(bodies, colors, hues, strict=True):
            if said is not None and None not in hues and hues.count(hue) == 1:
                found[body.id] = Name(f"the {said} {noun(category)}", (body.id,))
        _by_carrier(facts, category, bodies, plain, found)
        _by_wall(facts, category, bodies, found)
    return found


def _by_carrier(facts: Facts, category: str, bodies: list[Body], plain: dict[str, Name], found: dict) -> None:
    for (carrier, how), things in facts.carried.items():
        mine = [b for b in things if b.item.category == category]
        inner = facts.carried.get((carrier, "in" if how == "on" else "on"), ())
        if len(mine) != 1 or carrier not in plain or any(b.item.category == category for b in inner):
            continue
        if mine[0].id not in found and len(bodies) > 1:
            text = f"the {noun(category)} {how} {plain[carrier].text}"
            found[mine[0].id] = Name(text, (mine[0].id, carrier))


def _by_wall(facts: Facts, category: str, bodies: list[Body], found: dict) -> None:
    if any(b.item.mount != "wall" for b in bodies):
        return
    on = {b.id: facts.wall_at(b) for b in bodies}
    for body in bodies:
        wall = on[body.id]
        if wall in facts.wall_names and list(on.values()).count(wall) == 1 and None not in on.values():
            found.setdefault(body.id, Name(f"the {noun(category)} on {facts.wall_names[wall]}", (body.id,)))


@lru_cache(maxsize=2**16)
def _may_mean(category: str, other: str) -> bool:
    """Whether the noun of one category may be said of the other: "chair" of a dining chair."""
    mine, theirs = noun(category), noun(other)
    return theirs.endswith(f" {mine}") or theirs == mine or nouns(category) in theirs
