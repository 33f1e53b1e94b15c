"""English for the things of a scene: nouns, names that mean one thing and no other, and sentences with their facts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from importlib import resources
from typing import Any, TypeVar

import numpy as np

from sceneweaver.assets.category import read_yaml
from sceneweaver.assets.materials import finishes
from sceneweaver.assets.roles import has_role
from sceneweaver.language.vocabulary import plural
from sceneweaver.verify.solids import Body

from .facts import Facts, group_of

_NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_SPOKEN_AS_VOWEL = ("hour", "IV ", "8")
_SPOKEN_AS_CONSONANT = ("uni", "uri", "use", "ute", "one")


@cache
def _table() -> dict[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("nouns.yaml"))


@cache
def noun(category: str) -> str:
    """The noun of a category: "round dining table"."""
    return _table()["things"].get(category, [category.replace("_", " ").strip()])[0]


@cache
def nouns(category: str) -> str:
    """The plural of `noun`."""
    found = _table()["things"].get(category)
    return found[1] if found else plural(noun(category))


@cache
def room_noun(kind: str) -> str:
    """The noun of a kind of room."""
    return _table()["rooms"].get(kind, kind.replace("_", " ").strip())


@cache
def color_families() -> dict[str, str]:
    """The colours that have a name here, each with the family in which one may be taken for the other."""
    return {color: family for family, colors in _table()["colours"].items() for color in colors}


def colors_apart(one: str, other: str) -> bool:
    """Whether two colours are told apart at once."""
    return one != other and not any({one, other} <= set(group) for group in _table()["alike"])


def with_article(words: str) -> str:
    """A noun, or words before one, after "a" or "an"."""
    lower = words.lower()
    vowel = (
        words.startswith(_SPOKEN_AS_VOWEL)
        or words.split()[0] in ("11", "18")
        or (lower[:1] in "aeiou" and not lower.startswith(_SPOKEN_AS_CONSONANT))
    )
    return f"{'an' if vowel else 'a'} {words}"


def number(count: int) -> str:
    """A count in words, as far as they are usual."""
    return _NUMBERS[count] if 0 <= count < len(_NUMBERS) else str(count)


def counted(count: int, category: str, look: str = "") -> str:
    """So many of a category, with a word on how they look: "a cream nightstand", "two oak chairs"."""
    words = noun(category) if count == 1 else nouns(category)
    words = f"{look} {words}" if look else words
    return with_article(words) if count == 1 else f"{number(count)} {words}"


def listed(words: Sequence[str], last: str = "and") -> str:
    """Words in a row, with "and" before the last."""
    return f"{', '.join(words[:-1])} {last} {words[-1]}" if len(words) > 1 else "".join(words)


def sentence(words: str) -> str:
    """Words with a capital letter and a full stop."""
    return f"{words[0].upper()}{words[1:]}."


@dataclass(frozen=True)
class Statement:
    """One fact that a text states.

    Attributes:
        predicate: a relation of the catalogue that holds with its own numbers (``against_wall``, ``facing``,
            ``between``, ...), or one of: ``room_type``, ``floor_area`` [m2], ``extent`` (sides of a rectangular room
            [m], the longer first), ``corners``, ``doors``, ``windows``, ``window_side`` (of who comes in), ``count``
            (objects of a category), ``color``, ``material``, ``rests_on``, ``rests_in`` (an upper or an inner surface
            of the second object), ``along_wall``, ``on_wall``, ``on_floor``, ``on_ceiling``, ``left_from_door``,
            ``right_from_door`` (over 25 degrees aside for who looks straight in), ``ahead_of_door`` (under 10).
        objects: ids, the subject first.
        value: what is said of them, where the predicate needs it.
    """

    predicate: str
    objects: tuple[str, ...] = ()
    value: Any = None

    def to_dict(self) -> dict[str, Any]:
        """JSON data."""
        data: dict[str, Any] = {"predicate": self.predicate, "objects": list(self.objects)}
        return data if self.value is None else {**data, "value": self.value}


@dataclass(frozen=True)
class Text:
    """Some words and the facts that they state."""

    words: str
    statements: tuple[Statement, ...] = field(default=())

    def to_dict(self) -> dict[str, Any]:
        """JSON data."""
        return {"text": self.words, "statements": [s.to_dict() for s in self.statements]}


def joined(texts: Iterable[Text], between: str = " ") -> Text:
    """Several sentences as one text."""
    parts = list(texts)
    facts = dict.fromkeys(_key(s) for t in parts for s in t.statements)
    by_key = {_key(s): s for t in parts for s in t.statements}
    return Text(between.join(t.words for t in parts), tuple(by_key[k] for k in facts))


def said(words: str, *statements: Statement) -> Text:
    """A sentence with its facts."""
    return Text(sentence(words), statements)


def _key(statement: Statement) -> str:
    return f"{statement.predicate} {statement.objects} {statement.value}"


_COLOURED = frozenset(("furniture", "seating", "chair_group", "table_group", "bed_group", "storage", "textile"))


T = TypeVar("T")


@dataclass(frozen=True)
class Name:
    """Words that mean one object, and the ids that they speak of: its own first."""

    text: str
    ids: tuple[str, ...]


def color(body: Body) -> str | None:
    """The colour of a body as a word, where its kind has one that is seen at a glance."""
    said = body.item.attributes.get("color")
    if not isinstance(said, str) or said not in color_families() or has_role(body.item.category, "own_colours"):
        return None
    material = finishes().get(str(body.item.attributes.get("material")))
    if material is not None and material.family == "wood" and has_role(body.item.category, "upholstered"):
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
        hues = [color_families()[c] if c else None for c in colors]
        for body, shown, hue in zip(bodies, colors, hues, strict=True):
            if shown is not None and None not in hues and hues.count(hue) == 1:
                found[body.id] = Name(f"the {shown} {noun(category)}", (body.id,))
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


@cache
def wordings() -> dict[str, dict[str, Any]]:
    """``wordings.yaml``: by template its wordings, and of questions how the answer is given and found."""
    return read_yaml(resources.files(__package__ or "").joinpath("wordings.yaml"))


class Speaker:
    """The facts of a scene, the names of its things, and draws of what is said of it."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        self.facts = facts
        self.rng = rng
        self.names: dict[str, Name] = names(facts)

    def coin(self) -> bool:
        """True or false, each as often."""
        return bool(self.rng.integers(2))

    def one(self, items: Sequence[T]) -> T:
        """One of some items."""
        return items[int(self.rng.integers(len(items)))]

    def shuffled(self, items: Iterable[T]) -> list[T]:
        """The items in a drawn order."""
        found = list(items)
        return [found[int(k)] for k in self.rng.permutation(len(found))]

    def name(self, body: Body) -> str:
        """The words that mean a body."""
        return self.names[body.id].text

    def say(self, template: str, *things: str, **fields: Any) -> str:
        """One of the wordings of a template."""
        return self.one(wordings()[template]["say"]).format(*things, **fields)


class Words(Speaker):
    """Words for the things of one scene, with what they state."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        super().__init__(facts, rng)
        self.told: set[frozenset[str]] = set()
        self.furniture = [b for b in facts.furniture if b.id in self.names]

    def groups(self, bodies: Sequence[Body]) -> list[tuple[str, list[Body]]]:
        """Bodies by category, in the order in which they come."""
        found: dict[str, list[Body]] = defaultdict(list)
        for body in bodies:
            found[body.item.category].append(body)
        return list(found.items())

    def group(self, category: str, bodies: Sequence[Body], looks: bool = True) -> Text:
        """Some things of one category: "two cream nightstands"."""
        seen = {look(b) for b in bodies}
        shared = next(iter(seen)) if len(seen) == 1 and looks else None
        statements = []
        words = counted(len(bodies), category)
        if shared is not None and not set(shared[0].split()) & set(noun(category).split()):
            words = counted(len(bodies), category, shared[0])
            statements = [Statement(shared[1], (b.id,), shared[0]) for b in bodies]
        return Text(words, tuple(statements))

    def inventory(self, bodies: Sequence[Body], looks: bool = False) -> Text:
        """Things in a row: "a vase, two books and a lamp"."""
        parts = [self.group(category, group, looks) for category, group in self.groups(bodies)]
        return Text(listed([p.words for p in parts]), tuple(s for p in parts for s in p.statements))

    def totals(self, bodies: Sequence[Body]) -> tuple[Statement, ...]:
        """That there are so many of each category, of what is all there."""
        everything = self.facts.by_category
        return tuple(
            Statement("count", tuple(b.id for b in everything[c]), {"category": c, "count": len(everything[c])})
            for c, _ in self.groups(bodies)
        )

    def main(self) -> list[tuple[str, list[Body]]]:
        """Categories of furniture by how much room they take."""
        groups = [(c, [b for b in bs if b.item.mount == "floor"]) for c, bs in self.groups(self.facts.furniture)]
        return sorted(groups, key=lambda g: (-round(sum(b.size[0] * b.size[1] * b.size[2] for b in g[1]), 6), g[0]))

    def resting(self, body: Body, how: str, things: Sequence[Body]) -> Text:
        """What rests on or in a thing, all of it or with the number of the rest."""
        chosen = list(things)
        groups = self.groups(chosen)
        if len(groups) > 5:
            groups = groups[:4]
            rest = len(chosen) - sum(len(bodies) for _, bodies in groups)
            chosen = [b for _, bodies in groups for b in bodies]
            others = f"{number(rest)} other {'thing' if rest == 1 else 'things'}"
            words = listed([*(counted(len(bs), c) for c, bs in groups), others])
        else:
            words = self.inventory(chosen).words
        be = "is" if len(things) == 1 else "are"
        stated = [Statement(f"rests_{how}", (b.id, body.id)) for b in things]
        return said(f"{how} {self.names[body.id].text} {be} {words}", *stated)
