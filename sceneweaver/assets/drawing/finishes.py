"""Finishes of a drawing: which material each role has, by the request, the room's palette and the style."""

from __future__ import annotations

from typing import Any

from sceneweaver.scene import InputError

from ..body import Material
from ..category import Category
from ..looks import read_words, roles_of_detail
from ..materials import STYLES, Finish, alike, color_name, color_named, expand, finish, finishes_named, tinted
from ..scheme import scheme_for
from .choices import Choices
from .request import Request


class Finishes(Choices):
    """Which finishes the request and the palette give to roles that are named one after the other.

    Args:
        category: What is drawn.
        seed: Its seed.
        request: All that is asked of it.
        any_material: Whether the asked material is given up, as no role can have it.
    """

    def __init__(self, category: Category, seed: int, request: Request | None = None, *, any_material: bool = False):
        super().__init__(category, seed, request)
        self.style = self.request.style or self.pick("style", STYLES)
        if self.style not in STYLES:
            raise InputError(f"style: '{self.style}' is unknown; use one of {', '.join(STYLES)}")
        self._scheme = scheme_for(category.name, self.request.palette)
        self.roles: dict[str, Material] = {}
        self.shown: dict[str, Any] = {}
        self._wanted = None if any_material else self.request.material
        self._main: str | None = None
        self._detailed: set[str] = set()

    @property
    def in_room(self) -> bool:
        """Whether it is for a room with a palette."""
        return self.request.palette is not None

    @property
    def main_material(self) -> Material | None:
        """That of the role that shows what was asked, or the first role's."""
        plain = [material for role, material in self.roles.items() if role not in self._detailed]
        return self.roles[self._main] if self._main else next(iter(plain or self.roles.values()), None)

    def material(self, role: str, *names: str) -> Material:
        """A finish for a role such as "top" or "legs": one of the names, "@wood" for any of a family.

        Names may come in one string, as "oak, walnut".

        The same role has the same finish all over. The first role that can do so takes the material that the user
        asked for, also one that is not among its names where its families allow it, and the first that can takes the
        colour; a style prefers finishes that suit it.
        """
        if role in self.roles:
            return self.roles[role]
        options = expand(tuple(one for name in names for one in name.split(", ")))
        detail = self._detail(role, options)
        if detail is not None:
            self.roles[role] = detail
            self._detailed.add(role)
            return detail
        asked = self._asked_finishes(options)
        options = asked or options
        color = self.request.color if "color" not in self.shown else None
        if self.lacks_material:  # "blue velvet": the colour waits for the velvet
            color = None
        chosen = self._colored(role, options, color) if color else None
        if asked or (chosen is not None and self._main is None):
            self._main = role
        self.roles[role] = chosen or (self._suiting(role, options) if asked else self._usual(role, options))
        return self.roles[role]

    def _detail(self, role: str, options: list[Finish]) -> Material | None:
        """The finish that is asked for of the part that has a role; None where nothing is, or another role shows it."""
        for part, look in self.request.details:
            shown = f"{part} finish"
            if role not in roles_of_detail(part) or shown in self.shown:
                continue
            words = read_words(look)
            of = finishes_named(look) or (finishes_named(words.material) if words.material else ())
            if not of and words.color is None:
                continue
            dyed = [one for one in options if one.tints] or [one for one in options if alike(one.family)] or options
            material = of[0].material if of else self._suiting(role, dyed)
            if words.color is not None and not finishes_named(look):
                material = tinted(material, words.color)
            self.shown[shown] = f"{color_name(material.color)} {material.name}"
            return material
        return None

    @property
    def lacks_material(self) -> bool:
        """Whether no role has had the asked material so far; at the end, draw again with ``any_material``."""
        return self._wanted is not None and "material" not in self.shown

    def _asked_finishes(self, options: list[Finish]) -> list[Finish]:
        """The finishes among some, or in place of them, that are of the asked material; none when there are none."""
        if not self._wanted or "material" in self.shown:
            return []
        wanted = finishes_named(self._wanted)
        like = [f for f in wanted if f in options]
        if not like:
            families = frozenset().union(*(alike(f.family) for f in options))
            like = [f for f in wanted if f.family in families]
            like = [f for f in like if not f.asked] or like
        if like:
            self.shown["material"] = self._wanted
        return like

    def _colored(self, role: str, options: list[Finish], color: str) -> Material | None:
        """A finish in the asked colour: one that has it, one that is dyed, or painted."""
        basic = color_named(color)
        like = [f for f in options if color_name(f.material.color) == basic]
        dyes = [f for f in options if f.tints]
        paints = [f for f in options if alike(f.family)]
        self.shown["color"] = basic
        if like and (color == basic or not dyes + paints):
            return self._suiting(role, like)
        if not dyes + paints:
            del self.shown["color"]
            return None
        return tinted(self._suiting(role, dyes or paints), color)

    def _suiting(self, role: str, options: list[Finish]) -> Material:
        """One of some finishes, rather one that suits the style."""
        return self.pick(f"material {role}", [f for f in options if self.style in f.styles] or options, True).material

    def _usual(self, role: str, options: list[Finish]) -> Material:
        """A finish of which nothing was asked: of the room's palette, furniture has the same all over the room."""
        if self._scheme is None:
            return self._suiting(role, options)
        large = self.category.mount[0] != "surface"
        looks = self._scheme.replaced(options, large)
        return looks[int(self._scheme.share(role) * len(looks))] if large else self.pick(f"material {role}", looks)

    def named(self, name: str) -> Material:
        """A finish without alternative, as the room's palette has it."""
        return finish(name).material if self._scheme is None else self._scheme.alone(name)
