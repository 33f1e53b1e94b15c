"""A room's palette as finishes: what takes the place of a finish that the palette does not have."""

from __future__ import annotations

import math
import zlib
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cache

from sceneweaver.scene import InputError

from .body import Material
from .materials import Finish, color_name, color_named, finish, finishes, hue, own_look, paint, shade, tinted
from .roles import groups_above

LARGE_CLOTH = (0, 0, 1, 0, 2)
"""Which colours of cloth large things have, in proportion."""

DYED = ("paint", "plastic", "pastel", "ceramic", "fabric", "leather")
"""Families of which what has a hue is dyed in one of the palette."""


PAINTED = ("wood", "woven", "cloth", "cardboard")
"""Families of which what is there is painted where everything is in one colour."""


@dataclass(frozen=True)
class Scheme:
    """The finishes of a palette; make it with `scheme`."""

    woods: tuple[Finish, ...]
    paints: tuple[Finish, ...]
    metals: tuple[Finish, ...]
    textiles: tuple[str, ...]
    seed: int
    hues: frozenset[str]
    avoid: frozenset[str] = frozenset()
    """Finishes, families of them and basic colours of which nothing is; "seating:black" holds for seats alone."""
    plain: bool = False
    """Whether a thing has looks of its own, of which only what is avoided goes."""

    @property
    def painted(self) -> bool:
        """Whether everything is in the colours of the room, as far as it can be painted or dyed."""
        return self.woods[0].family == "paint"

    def replaced(self, options: Sequence[Finish], large: bool) -> list[Material]:
        """What some finishes become, one for each, of like families beside each other.

        Args:
            options: finishes that would do.
            large: whether it is furniture, which has the first wood and painted finishes of the room.
        """
        options = [o for o in options if not self._avoids(o)] or options
        order = sorted(range(len(options)), key=lambda k: (options[k].family, k))
        return [self._one(options[k], k, options, large) for k in order]

    def share(self, role: str) -> float:
        """A number in 0..1 that decides the finish of a role of furniture, the same for the whole room."""
        return zlib.crc32(f"{self.seed}/{role}".encode()) / 2**32

    def alone(self, name: str) -> Material:
        """What a finish without alternative becomes."""
        one = finish(name)
        return self._one(one, zlib.crc32(name.encode()) % 97, (one,), False)

    def _one(self, one: Finish, k: int, options: Sequence[Finish], large: bool) -> Material:
        choice = len(options) > 1
        if self._avoids(one):
            return self._instead(one)
        if self.painted and one.family == "metal":
            return self.metals[0].material
        if self.painted and one.family in (*DYED, *PAINTED):
            if one.family in ("wood", "paint", *PAINTED):
                return self.woods[0 if large else k % len(self.woods)].material
            return tinted(one.material, self.textiles[0 if large else k % len(self.textiles)])
        if self.plain:
            return one.material
        if one.family == "wood":
            return self.woods[0 if large else k % len(self.woods)].material
        if one.family == "metal":
            return self._metal(one, options) if choice else one.material
        if one.family == "pigment":
            return one.material if self._has(one.material) else finish("sand pigment").material
        if one.family == "fabric" and any(hue(color_name(o.material.color)) for o in options):
            n = LARGE_CLOTH[k % len(LARGE_CLOTH)] if large else k
            return tinted(one.material, self.textiles[n % len(self.textiles)])
        if one.family == "paint" and choice and large:
            return self.paints[k % len(self.paints)].material
        if one.family not in DYED or self._has(one.material):
            return one.material
        colors = [c for c in self.textiles if hue(color_named(c))] or self.textiles
        return tinted(one.material, colors[k % len(colors)])

    def _avoids(self, one: Finish) -> bool:
        return is_avoided(one, self.avoid)

    def _instead(self, one: Finish) -> Material:
        """What takes the place of a finish that the room does not have: the like of it in another colour, else a metal,
        cloth or wood of the room."""
        if (other := _like(one, self.avoid)) is not None:
            return other.material
        if one.family == "metal":
            return self.metals[0].material
        if one.family in ("fabric", "leather", "cloth"):
            return tinted(finish("natural linen").material, self.textiles[0])
        if one.family in DYED and one.family not in self.avoid:
            return tinted(one.material, self.textiles[0])
        return self.woods[0].material

    def _metal(self, one: Finish, options: Sequence[Finish]) -> Material:
        """The room's metal where it would do or is like the one meant, else the one meant unless it is a warm one."""
        meant = [m for m in self.metals if m in options] or [m for m in self.metals if _tone(m) == _tone(one)]
        cool = [m for m in options if m.family == "metal" and _tone(m) != "warm"]
        return (meant or (cool if _tone(one) == "warm" else [one]) or [self.metals[0]])[0].material

    def _has(self, material: Material) -> bool:
        found = hue(color_name(material.color))
        return found is None or found in self.hues


def _tone(metal: Finish) -> str:
    r, _, b = metal.material.color
    return "warm" if r - b > 0.1 else "dark" if r < 0.4 else "light"


@cache
def scheme(code: str) -> Scheme:
    """The finishes of a palette's code.

    Raises:
        InputError: for a code that is none, or names what is unknown.
    """
    groups = [tuple(part for part in group.split(",") if part) for group in code.split("/")]
    if len(groups) not in (5, 6) or not all(groups) or not groups[4][0].isdecimal():
        raise InputError(f"palette: '{code}' is none; give woods, paints, metals, cloth and a seed")
    try:
        woods, paints, metals = (tuple(paint(name) for name in group) for group in groups[:3])
    except KeyError as error:
        raise InputError(f"palette: {error} is no finish; see assets/materials.yaml") from None
    # Furniture may be of concrete or steel in the place of wood, or painted where all of a room is in one colour.
    families = (
        (("wood", "stone", "metal", "paint"), woods),
        (("paint",), paints),
        (("metal",), metals),
    )
    wrong = [f.material.name for known, group in families for f in group if f.family not in known]
    if wrong:
        raise InputError(f"palette: {wrong[0]} stands in the wrong place; give woods, paints, metals, cloth and a seed")
    colors = [color_named(c) for c in groups[3]] + [color_name(f.material.color) for f in paints]
    hues = frozenset(found for c in colors if (found := hue(c)))
    return Scheme(woods, paints, metals, groups[3], int(groups[4][0]), hues, frozenset(*groups[5:]))


@cache
def scheme_for(category: str, code: str | None) -> Scheme | None:
    """The palette that a category follows; None for what has colours of its own, such as books, and may have all."""
    if code is None:
        return None
    whole, names = scheme(code), {category, *groups_above(category)}
    avoid = frozenset(what for entry in whole.avoid for of, _, what in [entry.rpartition(":")] if not of or of in names)
    plain = category in own_look()
    if plain and not avoid and not whole.painted:
        return None
    return replace(_cleaned(whole, avoid), avoid=avoid, plain=plain)


def is_avoided(one: Finish, avoid: Collection[str]) -> bool:
    """Whether a finish is one of some, of a family of them, or of one of these basic colours."""
    return bool(avoid) and (
        one.family in avoid or one.material.name in avoid or color_name(one.material.color) in avoid
    )


def _cleaned(whole: Scheme, avoid: frozenset[str]) -> Scheme:
    """A palette in which nothing is of what is avoided, as far as there is something like it."""

    def kept(group: Sequence[Finish]) -> tuple[Finish, ...]:
        found = (one if not is_avoided(one, avoid) else _like(one, avoid) for one in group)
        return tuple(dict.fromkeys(one for one in found if one is not None))

    paints = kept(whole.paints) or whole.paints
    woods = kept(whole.woods) or paints
    metals = kept(whole.metals) or paints
    cloth = tuple(dict.fromkeys(allowed_color(color, avoid) for color in whole.textiles))
    return replace(whole, woods=woods, paints=paints, metals=metals, textiles=cloth)


NEUTRAL = ("white", "cream", "light grey", "beige", "grey", "tan", "black", "sage", "light blue")
"""What takes the place of a colour that is not wanted: the nearest of the first few that may be."""


def allowed_color(color: str, avoid: Collection[str]) -> str:
    """A colour, or a calm one in its place where it is of a basic colour that is avoided."""
    if color_named(color) not in avoid:
        return color
    free = [name for name in NEUTRAL if name not in avoid] or [color]
    light = sum(shade(color))
    return min(free[:5], key=lambda name: abs(sum(shade(name)) - light))


@cache
def _like(one: Finish, avoid: frozenset[str]) -> Finish | None:
    """The finish of the same family that is nearest in colour and not avoided; paint has any colour."""
    near = [other for other in finishes().values() if other.family == one.family and not is_avoided(other, avoid)]
    near = [other for other in near if other.asked <= one.asked] or near
    if hue(color_name(one.material.color)) is None:  # grey, and not navy, for black
        near = [other for other in near if hue(color_name(other.material.color)) is None] or near
    return min(near, key=lambda other: math.dist(other.material.color, one.material.color), default=None)
