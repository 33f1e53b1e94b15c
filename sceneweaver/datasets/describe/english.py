"""English: categories as nouns with article or number, and sentences with the facts that they state."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import Any

from sceneweaver.assets.category import read_yaml
from sceneweaver.language.vocabulary import plural

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
