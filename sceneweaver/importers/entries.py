"""Fields of a file of somebody else, read one by one: what is wrong is one line with file, field and fix."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, path_name, quote, show

LARGEST = 1e4
"""Largest coordinate [m] of a scene: beyond it a file is in another unit, or damaged."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A value of a file's data, with the name of the file and the place of the value in it."""

    value: Any
    file: str
    place: str = ""

    @classmethod
    def of(cls, path: Path, data: Any, place: str = "") -> Entry:
        """The data of a file as an entry."""
        return cls(data, path_name(path), place)

    def error(self, text: str) -> InputError:
        """An error that names the file and this place: ``text`` says what is wrong and the fix."""
        return InputError(f"{self.file}: {self.place}: {text}" if self.place else f"{self.file}: {text}")

    def has(self, key: str) -> bool:
        """Whether it is an object that holds more than null under a key."""
        return isinstance(self.value, dict) and self.value.get(key) is not None

    def find(self, key: str) -> Entry | None:
        """What stands under a key, or None where that is missing or null."""
        return self[key] if self.mapping().get(key) is not None else None

    def __getitem__(self, key: str) -> Entry:
        """What has to stand under a key."""
        if self.mapping().get(key) is None:
            raise self.error(f"{quote(key)} is missing")
        return Entry(self.value[key], self.file, f"{self.place}.{key}" if self.place else key)

    def get(self, key: str) -> Any:
        """The plain value under a key of an object, None where that is missing."""
        return self.mapping().get(key)

    def kept(self, *keys: str) -> dict[str, Any]:
        """The plain values under those keys that it has, for what is kept as it is."""
        return {key: self.value[key] for key in keys if key in self.mapping()}

    def words(self, key: str) -> list[str]:
        """The texts in the list under a key, whatever else is in it; a text alone is a list of one."""
        found = self.get(key)
        return [
            w
            for w in ([found] if isinstance(found, str) else found if isinstance(found, list) else [])
            if isinstance(w, str) and w
        ]

    def mapping(self) -> dict[str, Any]:
        """It as an object."""
        if not isinstance(self.value, dict):
            raise self.error(f'must be an object {{"...": ...}}, not {show(self.value)}')
        return self.value

    def items(self) -> Iterator[tuple[str, Entry]]:
        """Names and values of an object."""
        for key, value in self.mapping().items():
            yield key, Entry(value, self.file, f"{self.place}.{key}" if self.place else key)

    def entries(self) -> Iterator[Entry]:
        """The values of a list."""
        if not isinstance(self.value, list):
            raise self.error(f"must be a list [...], not {show(self.value)}")
        for i, value in enumerate(self.value):
            yield Entry(value, self.file, f"{self.place}[{i}]")

    def listed(self, key: str) -> Iterator[Entry]:
        """The values of the list under a key, none where that is missing."""
        found = self.find(key)
        return iter(()) if found is None else found.entries()

    def text(self) -> str:
        """It as text."""
        if not isinstance(self.value, str):
            raise self.error(f"must be text, not {show(self.value)}")
        return self.value

    def word(self, key: str, default: str = "") -> str:
        """The text under a key, or a default where that is missing or no text."""
        found = self.value.get(key) if isinstance(self.value, dict) else None
        return found if isinstance(found, str) and found else default

    def number(self, low: float = -LARGEST, high: float = LARGEST) -> float:
        """It as a finite number within limits."""
        if not is_number(self.value) or not math.isfinite(self.value):
            raise self.error(f"must be a finite number, not {show(self.value)}")
        if not low <= self.value <= high:
            raise self.error(f"must lie in {low:g} .. {high:g}, not {show(self.value)}")
        return float(self.value)

    def length(self) -> float:
        """It as a length [m] of at least 0."""
        return self.number(0.0)

    def numbers(self, count: int, low: float = -LARGEST, high: float = LARGEST) -> list[float]:
        """It as a list of finite numbers."""
        values = [entry.number(low, high) for entry in self.entries()]
        if len(values) != count:
            raise self.error(f"must hold {count} numbers, not {len(values)}")
        return values

    def named(self, keys: Sequence[str], low: float = -LARGEST, high: float = LARGEST) -> list[float]:
        """The numbers under keys, such as x, y and z."""
        return [self[key].number(low, high) for key in keys]

    def matrix(self, rows: int, columns: int) -> np.ndarray:
        """It as rows of finite numbers, or all of them in one list, row after row."""
        listed = list(self.entries())
        if listed and isinstance(listed[0].value, list):
            found = [entry.numbers(columns) for entry in listed]
            if len(found) != rows:
                raise self.error(f"must hold {rows} rows, not {len(found)}")
            return np.array(found)
        return np.array(self.numbers(rows * columns)).reshape(rows, columns)

    def sides(self, values: Sequence[float]) -> tuple[float, float, float]:
        """Three lengths of it as a size; one of 0 is refused."""
        if not all(v > 0 for v in values):
            raise self.error(f"must be lengths above 0, not {show(min(values))}")
        a, b, c = values
        return a, b, c
