"""Numbers for categories and kinds of rooms, kept in a file, so that a model and its data agree for good."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from sceneweaver.io import InputError, load_json, write_atomic

SCHEMA = "sceneweaver.vocabulary/1"
PADDING, UNKNOWN = 0, 1
FIRST = 2


@dataclass(frozen=True)
class Vocabulary:
    """Numbers of names: 0 is padding, 1 what is not known, then the names in order.

    Attributes:
        categories: of objects, sorted.
        rooms: kinds of rooms, sorted.

    Examples:
        >>> from sceneweaver.datasets import Vocabulary
        >>> words = Vocabulary.of(["bed", "lamp", "bed"], ["bedroom"])
        >>> words.category("lamp"), words.category("harp"), words.size
        (3, 1, 4)
        >>> words.name(3)
        'lamp'
    """

    categories: tuple[str, ...]
    rooms: tuple[str, ...]

    @classmethod
    def of(cls, categories: Iterable[str], rooms: Iterable[str]) -> Vocabulary:
        """The vocabulary of some names, each once, in alphabetical order."""
        return cls(tuple(sorted(set(categories))), tuple(sorted(set(rooms))))

    @property
    def size(self) -> int:
        """How many numbers categories have, padding and unknown among them: rows of an embedding."""
        return FIRST + len(self.categories)

    @cached_property
    def _numbers(self) -> tuple[dict[str, int], dict[str, int]]:
        return tuple({n: i for i, n in enumerate(names, FIRST)} for names in (self.categories, self.rooms))  # pyright: ignore[reportReturnType]

    def category(self, name: str) -> int:
        """The number of a category; 1 where it is not known."""
        return self._numbers[0].get(name, UNKNOWN)

    def room(self, name: str) -> int:
        """The number of a kind of room; 1 where it is not known."""
        return self._numbers[1].get(name, UNKNOWN)

    def name(self, number: int) -> str:
        """The category of a number; "" for padding and "?" for what is not known.

        Raises:
            InputError: it has no such number.
        """
        if number in (PADDING, UNKNOWN):
            return ("", "?")[number]
        if not FIRST <= number < self.size:
            raise InputError(f"number: {number} is not from 0 to {self.size - 1}, the numbers of this vocabulary")
        return self.categories[number - FIRST]

    def save(self, path: str | Path) -> None:
        """Write it as JSON."""
        content = {"schema": SCHEMA, "categories": self.categories, "rooms": self.rooms}
        write_atomic(Path(path), (json.dumps(content, indent=1, ensure_ascii=False) + "\n").encode())

    @classmethod
    def load(cls, path: str | Path) -> Vocabulary:
        """Read what `save` wrote.

        Raises:
            InputError: the file is missing or something else.
        """
        data = load_json(Path(path))
        if not isinstance(data, dict) or data.get("schema") != SCHEMA:
            raise InputError(f"{path}: no vocabulary; its schema has to be {SCHEMA}")
        names = [data.get(key) for key in ("categories", "rooms")]
        for key, value in zip(("categories", "rooms"), names, strict=True):
            if (
                not isinstance(value, list)
                or not all(isinstance(n, str) for n in value)
                or len(set(value)) < len(value)
            ):
                raise InputError(f"{path}: {key} is not a list of different names")
        return cls(tuple(names[0] or ()), tuple(names[1] or ()))
