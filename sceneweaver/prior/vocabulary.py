"""Numbers of the names that the prior was trained with."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sceneweaver.io import InputError

UNKNOWN = 0
"""The number of a category or a kind of room that the prior was not trained with."""


@dataclass(frozen=True)
class Words:
    """Names with numbers: of categories and kinds from 1 on, of relation types from 0 on.

    Attributes:
        categories: of objects.
        kinds: of rooms.
        relations: types of relations.
    """

    categories: tuple[str, ...]
    kinds: tuple[str, ...]
    relations: tuple[str, ...]

    @classmethod
    def of(cls, categories: Iterable[str], kinds: Iterable[str], relations: Iterable[str]) -> Words:
        """Those of some names, each once, in alphabetical order."""
        return cls(tuple(sorted(set(categories))), tuple(sorted(set(kinds))), tuple(sorted(set(relations))))

    @classmethod
    def from_json(cls, data: Any) -> Words:
        """What `to_json` gave.

        Raises:
            InputError: it is something else.
        """
        names = [data.get(key) if isinstance(data, dict) else None for key in ("categories", "kinds", "relations")]
        for key, value in zip(("categories", "kinds", "relations"), names, strict=True):
            if not isinstance(value, list) or not all(isinstance(n, str) for n in value):
                raise InputError(f"prior: {key} is not a list of names; take weights that sceneweaver wrote")
        return cls(*(tuple(value or ()) for value in names))

    def to_json(self) -> dict[str, list[str]]:
        """As JSON data."""
        return {"categories": [*self.categories], "kinds": [*self.kinds], "relations": [*self.relations]}

    @cached_property
    def _numbers(self) -> tuple[dict[str, int], dict[str, int], dict[str, int]]:
        known = ({n: i for i, n in enumerate(names, 1)} for names in (self.categories, self.kinds))
        return (*known, {n: i for i, n in enumerate(self.relations)})  # pyright: ignore[reportReturnType]

    def category(self, name: str) -> int:
        """The number of a category."""
        return self._numbers[0].get(name, UNKNOWN)

    def kind(self, name: str) -> int:
        """The number of a kind of room."""
        return self._numbers[1].get(name, UNKNOWN)

    def relation(self, name: str) -> int | None:
        """The number of a relation type; None for one of a user's own."""
        return self._numbers[2].get(name)
