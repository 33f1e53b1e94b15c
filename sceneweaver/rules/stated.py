"""What requests say of where things stand: when a word holds, and what is asked of the engine for it.

The data is ``stated.yaml``. The critic judges a word by its `Word.holds`, the reader grounds it by its `Word.aims`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple

from .expression import Expression
from .relation import Way, load, ways_of

_ANY = ("corner", "ceiling", "floor", "middle", "half")
"""Places of which most words say the same."""

_PLACES = ("wall", "window", "door", "corner", "ceiling", "floor", "middle", "half")


class Meant(NamedTuple):
    """A relation of the catalogue of a pair, or of the pair ``swapped``; ``target``: the part of the room it is to."""

    type: str
    params: dict[str, Any] = {}
    hard: bool = True
    swapped: bool = False
    target: str | None = None


@dataclass(frozen=True, slots=True)
class Aim:
    """Relations of the catalogue that bring a word about, where a condition holds."""

    relations: tuple[Mapping[str, Any], ...]
    condition: Expression | None = None


@dataclass(frozen=True, slots=True)
class Word:
    """A word of requests.

    Attributes:
        holds: ways of rows of which one has to hold; empty where nothing can be measured.
        aims: what is asked of the engine: the first whose condition holds.
        side: the side of the target, in its own frame, that is meant where none is named.
        frame: whose left and right the sides of ``holds`` are.
    """

    holds: tuple[Way, ...] = ()
    aims: tuple[Aim, ...] = field(default=())
    side: str | None = None
    frame: str = "viewer"

    def meant(self, scope: Mapping[str, Any]) -> Iterator[Meant]:
        """The relations of the catalogue that it means.

        Args:
            scope: the names of its expressions, see ``stated.yaml``.
        """
        for aim in self.aims:
            if aim.condition is None or aim.condition.value(scope):
                yield from (_meant(row, scope) for row in aim.relations if _counts(row, scope))
                return


def _counts(row: Mapping[str, Any], scope: Mapping[str, Any]) -> bool:
    return "if" not in row or bool(row["if"].value(scope))


def _meant(row: Mapping[str, Any], scope: Mapping[str, Any]) -> Meant:
    kind = row["relation"]
    params: dict[str, Any] = {}
    for name, given in row["params"].items():
        value = [end.value(scope) for end in given] if isinstance(given, list) else given.value(scope)
        if value is not None:
            params[name] = value
    return Meant(
        kind if isinstance(kind, str) else kind[scope["side"]], params, row["hard"], row["swap"], row["target"]
    )


def _aim(entry: Mapping[str, Any]) -> Aim:
    rows = []
    for row in entry["then"]:
        rest = {key: value for key, value in row.items() if key not in ("relation", "hard", "swap", "if", "target")}
        params = {
            name: [Expression(end) for end in value] if isinstance(value, list) else Expression(value)
            for name, value in rest.items()
        }
        condition = {"if": Expression(row["if"])} if "if" in row else {}
        fixed = {"relation": row["relation"], "hard": row.get("hard", True), "swap": row.get("swap", False)}
        rows.append({**fixed, "target": row.get("target"), "params": params, **condition})
    return Aim(tuple(rows), Expression(entry["if"]) if "if" in entry else None)


def _word(label: str, entry: Mapping[str, Any]) -> Word:
    frame = entry.get("frame")
    holds = ways_of(label, entry.get("holds", ()), frame)
    return Word(holds, tuple(map(_aim, entry.get("aim", ()))), entry.get("side"), frame or "viewer")


@cache
def _words(of: str) -> dict[str, Word]:
    return {name: _word(f"{name} of {of}", entry) for name, entry in load("stated.yaml")[of].items()}


def word_of_things(name: str) -> Word | None:
    """What a word says of two things; None for one that says nothing of them."""
    return _words("things").get(name)


def word_of_place(name: str, place: str) -> Word:
    """What a word says of a thing and a part of the room; an empty one for what says nothing of it."""
    place = place.partition(":")[0]
    if place not in _PLACES:
        return Word()
    words = _words(place)
    aims = words.get(name) or words.get("", Word())
    own = words.get(name)
    if place == "door" and (own is None or not own.holds):  # a door is judged as a window is
        own = _words("window").get(name)
    judged = own or (words.get("", Word()) if "" in words and place in _ANY else Word())
    return Word(judged.holds, aims.aims, aims.side, judged.frame)


@cache
def at_side() -> Way:
    """What holds in addition where a request names a side of the target, such as "at its long side"."""
    return ways_of("beyond_side", [{"rows": load("stated.yaml")["beyond_side"]}], "viewer")[0]


def number(name: str) -> Any:
    """A number of what is said of groups, see ``numbers`` in ``stated.yaml``."""
    return load("stated.yaml")["numbers"][name]
