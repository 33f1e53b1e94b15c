"""A room's palette as finishes: what takes the place of a finish that the palette does not have."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from sceneweaver.scene import InputError

from .body import Material
from .materials import Finish, color_name, color_named, finish, hue, own_look, paint, tinted

LARGE_CLOTH = (0, 0, 1, 0, 2)
"""Which colours of cloth large things have, in proportion."""

DYED = ("paint", "plastic", "pastel", "ceramic", "fabric", "leather")
"""Families of which what has a hue is dyed in one of the palette."""


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
        return one.family in self.avoid or one.material.name in self.avoid

    def _instead(self, one: Finish) -> Material:
        """What takes the place of a finish that the room does not have: a metal, cloth or wood of it."""
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
    # Furniture may be of concrete or steel in the place of wood.
    families = (
        (("wood", "stone", "metal"), woods),
        (("paint",), paints),
        (("metal",), metals),
    )
    wrong = [f.material.name for known, group in families for f in group if f.family not in known]
    if wrong:
        raise InputError(f"palette: {wrong[0]} stands in the wrong place; give woods, paints, metals, cloth and a seed")
    colors = [color_named(c) for c in groups[3]] + [color_name(f.material.color) for f in paints]
    hues = frozenset(found for c in colors if (found := hue(c)))
    return Scheme(woods, paints, metals, groups[3], int(groups[4][0]), hues, frozenset(*groups[5:]))


def scheme_for(category: str, code: str | None) -> Scheme | None:
    """The palette that a category follows; None for what has colours of its own, such as books."""
    return None if code is None or category in own_look() else scheme(code)
