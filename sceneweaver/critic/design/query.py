"""What a row of a rule is about: a named selector, or members that are found one after the other.

A member is written ``name: "[mount] sets [of list] [near other distance] [if condition] [by key]"``: a mount of
objects, ``standing`` or ``any``; sets are roles of categories (`sceneweaver.assets.roles`), categories after ``=``, and
with ``-`` before them what is left out. Instead of sets there may be ``= expression``. A plain name stands for each
object in turn, ``name*`` for all of them, ``name?`` for the first (or none), and ``name!`` for the first, without which
there is no case. Under ``from`` stands a named selector whose names the members may use.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, Protocol

from sceneweaver.assets import categories
from sceneweaver.assets.roles import with_role
from sceneweaver.assets.taxonomy import members
from sceneweaver.rules.expression import Expression

MOUNTS = frozenset(("floor", "wall", "ceiling", "surface", "standing", "any"))

Case = dict[str, Any]


class World(Protocol):
    """Objects whose poses are known, or not."""

    functions: Mapping[str, Callable[..., Any]]

    def members(self, mount: str) -> Iterable[Any]:
        """The objects of a mount ("standing": on the floor and higher than what is walked on); "": all."""
        ...

    def near(self, o: Any, distance: float) -> Iterable[Any]:
        """What stands within a distance [m] of an object, the nearest first; where poses are unknown, what is tied."""
        ...

    def category(self, o: Any) -> str:
        """The category of an object."""
        ...

    def named(self, selector: str) -> Iterator[Case]:
        """The cases of a named selector."""
        ...


@cache
def kind_set(text: str) -> frozenset[str]:
    """The categories of a list of roles, ``=category`` and, with ``-`` before them, what is left out of it or of all.

    Raises:
        ValueError: for a name that is neither role, category nor group.
    """
    found: set[str] = set()
    gone: set[str] = set()
    for word in text.split():
        (gone if word.startswith("-") else found).update(_meant(word.removeprefix("-")))
    return frozenset((found or categories().keys()) - gone)


def listed(value: Any) -> Sequence[Any]:
    """One thing or several as a sequence; None is none. A named tuple, such as an opening, is one."""
    several = isinstance(value, (tuple, list)) and not hasattr(value, "_fields")
    return value if several else () if value is None else (value,)


def _meant(word: str) -> frozenset[str]:
    if not word.startswith("="):
        try:
            return with_role(word)
        except KeyError:
            pass
    name = word.removeprefix("=")
    row = categories().get(name)
    if row is None:
        raise ValueError(f"{word} is no role, category or group")
    return frozenset((name,)) if row.size is not None else frozenset(members(name))


def _cut(text: str, word: str) -> tuple[str, str]:
    """The text before and after the first place of a word outside of brackets; nothing after it where it is not."""
    depth = 0
    for k, letter in enumerate(text):
        depth += (letter in "([{") - (letter in ")]}")
        if depth == 0 and text.startswith(word, k):
            return text[:k], text[k + len(word) :]
    return text, ""


@dataclass(frozen=True)
class Member:
    """One member of a query."""

    name: str
    how: str
    mount: str
    kinds: frozenset[str] | None
    source: Expression | None
    near: str
    distance: Expression
    where: Expression | None
    key: Expression | None

    @classmethod
    @cache
    def parse(cls, name: str, text: str) -> Member:
        """A member from its text; ValueError where that has an unknown name."""
        how = name[-1] if name[-1] in "*?!" else ""
        name = name.rstrip("*?!")
        text, key = _cut(" ".join(text.split()), " by ")
        text, where = _cut(text, " if ")
        rest = {"where": Expression(where) if where else None, "key": Expression(key) if key else None}
        if text.startswith("= "):
            return cls(name, how, "", None, Expression(text[2:].strip()), "", Expression(0.0), **rest)
        mount, near, distance, source, words = "", "", Expression(0.0), None, []
        tokens = text.split()
        while tokens:
            word = tokens.pop(0)
            if word in MOUNTS and not words:
                mount = "" if word == "any" else word
            elif word == "of":
                source = Expression(tokens.pop(0))
            elif word == "near":
                near, distance = tokens.pop(0), Expression(tokens.pop(0))
            else:
                words.append(word)
        return cls(name, how, mount, kind_set(" ".join(words)) if words else None, source, near, distance, **rest)

    def found(self, world: World, case: Case) -> list[Any]:
        """The objects of this member beside those that a case has."""
        if self.near:
            pool = world.near(case[self.near], self.distance.value(case))
        elif self.source is not None:
            pool = listed(self.source.value(case))
        else:
            pool = world.members(self.mount)
        if self.mount and (self.near or self.source is not None):
            of_mount = set(map(id, world.members(self.mount)))
            pool = [o for o in pool if id(o) in of_mount]
        if self.kinds is not None:
            pool = [o for o in pool if world.category(o) in self.kinds]
        if self.where is not None:
            pool = [o for o in pool if self.where.value({**case, self.name: o})]
        if self.key is not None:
            key = self.key
            pool = sorted(pool, key=lambda o: key.value({**case, self.name: o}))
        return list(pool)


def cases(world: World, of: str | Mapping[str, str], scope: Mapping[str, Any]) -> Iterator[Case]:
    """The cases of a selector: by name the objects of each member, and all names of a scope."""
    if isinstance(of, str):
        of = {"from": of} if of else {}
    parts = [Member.parse(name, text) for name, text in of.items() if name != "from"]
    begin = {**world.functions, **scope}
    for case in world.named(of["from"]) if "from" in of else ({},):
        yield from _filled(world, parts, {**begin, **case})


def _filled(world: World, parts: list[Member], case: Case) -> Iterator[Case]:
    if not parts:
        yield case
        return
    member, rest = parts[0], parts[1:]
    found = member.found(world, case)
    if member.how == "":
        for o in found:
            yield from _filled(world, rest, {**case, member.name: o})
    elif member.how == "*":
        yield from _filled(world, rest, {**case, member.name: tuple(found)})
    elif found or member.how == "?":
        yield from _filled(world, rest, {**case, member.name: found[0] if found else None})
