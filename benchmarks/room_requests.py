"""Requests for one room with what a careful reader takes from each, as data; and what a reading has of it.

The sixty texts were written at once, in the voices of different people, and split by a hash of the text into those that
the reader was developed on and those that were put away. ``python -m benchmarks.room_requests`` says for each set and
kind of expectation how much of it is read.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.io import load_yaml
from sceneweaver.language import Entity, SceneGraph, read_request

FOLDER = Path(__file__).parent / "data" / "room_requests"
SETS = ("development", "held_out")


@dataclass(frozen=True)
class Asked:
    """A request with what is to be read of it."""

    id: str
    text: str
    expect: dict[str, Any]


def room_requests(name: str) -> list[Asked]:
    """The requests of a set, one of `SETS`."""
    return [Asked(**row) for row in load_yaml(FOLDER / f"{name}.yaml")]


def verdicts(asked: Asked, graph: SceneGraph) -> Iterator[tuple[str, str, bool]]:
    """Each thing that is to be read of a request: its kind, it in words, and whether it was."""
    for key, value in asked.expect.items():
        for words, met in _VERDICTS[key](value, graph):
            yield key, words, met


def _names(entity: Entity) -> str:
    return f"{entity.noun} {entity.category.replace('_', ' ')}"


def _is(word: str, entity: Entity) -> bool:
    """Whether a thing is what a word of the data means, by its noun or its category."""
    return word.replace("_", " ") in _names(entity)


def _things(value: dict[str, int], graph: SceneGraph) -> Iterator[tuple[str, bool]]:
    for word, count in value.items():
        most = sum((entity.count or (1, 1))[1] for entity in graph.entities if _is(word, entity))
        yield f"{count} {word} (has {most})", most == count if count > 1 else most >= 1


def _none(value: list[str], graph: SceneGraph) -> Iterator[tuple[str, bool]]:
    for word in value:
        plain = word.replace("_", " ")
        found = [
            entity.noun
            for entity in graph.entities
            if {plain, f"{plain}s"} & {*entity.noun.split(), entity.noun, entity.category.replace("_", " ")}
        ]
        yield f"no {plain}{f' (has {found[0]})' if found else ''}", not found


def _excluded(value: list[str], graph: SceneGraph) -> Iterator[tuple[str, bool]]:
    for word in value:
        yield f"{word} ruled out", any(word in name for name in graph.without)


def _opening(part: str) -> Any:
    def check(value: list[str], graph: SceneGraph) -> Iterator[tuple[str, bool]]:
        told = " ".join(unread.words for unread in graph.unread)
        for kind in value:
            has = any(kind in feature for one in graph.openings if one.part == part for feature in one.features)
            yield f"{kind} {part}", has or kind in told

    return check


def _told(value: list[str], graph: SceneGraph) -> Iterator[tuple[str, bool]]:
    told = [unread.words for unread in graph.unread] + [
        graph.text[u.span.start : u.span.end].lower() for u in graph.unread if u.span is not None
    ]
    told += [feature for one in graph.openings for feature in (one.words, *one.features)]
    told += [one.words for one in graph.exclusions]
    for word in value:
        yield f"'{word}' told", any(word in words for words in told)


_VERDICTS: dict[str, Any] = {
    "things": _things,
    "none": _none,
    "excluded": _excluded,
    "door": _opening("door"),
    "window": _opening("window"),
    "told": _told,
}


def shares(name: str) -> dict[str, tuple[int, int]]:
    """By kind of expectation, how much of a set is read as meant, and of how much."""
    met, asked = Counter[str](), Counter[str]()
    for one in room_requests(name):
        for kind, _, held in verdicts(one, read_request(one.text)):
            met[kind] += held
            asked[kind] += 1
    return {kind: (met[kind], asked[kind]) for kind in asked}


if __name__ == "__main__":
    for name in SETS:
        found = shares(name)
        print(name, "; ".join(f"{kind} {met} of {asked}" for kind, (met, asked) in found.items()))
