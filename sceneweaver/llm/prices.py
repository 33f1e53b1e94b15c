"""What tokens cost, by a table of the user's own. There are no prices in here: they change, and differ by contract."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sceneweaver.io import load_yaml
from sceneweaver.scene import InputError

KEYS = ("input", "cached_input", "output")


@dataclass(frozen=True)
class Price:
    """Price of a million tokens of a model.

    Attributes:
        input: tokens of the prompt.
        output: tokens of the answer.
        cached_input: tokens of the prompt that the endpoint had in its cache; None where they cost as much as others.
    """

    input: float
    output: float
    cached_input: float | None = None

    def cost(self, tokens_in: int, tokens_out: int, cached: int = 0) -> float:
        """Price of a request; ``cached`` of the tokens in came from the cache."""
        cached = min(cached, tokens_in)
        held = self.input if self.cached_input is None else self.cached_input
        return ((tokens_in - cached) * self.input + cached * held + tokens_out * self.output) / 1e6


@dataclass(frozen=True)
class Prices:
    """A price table.

    Attributes:
        models: prices by a model's name, with or without "openai:" before it.
        currency: a word that stands beside every sum, such as "EUR".
    """

    models: Mapping[str, Price] = field(default_factory=dict[str, Price])
    currency: str = ""

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Prices:
        """Read a table from YAML.

            currency: EUR
            models:
              openai:gpt-4.1: {input: 1.8, cached_input: 0.45, output: 7.2}  # of a million tokens

        Raises:
            InputError: when the file cannot be read or a price is wrong, naming the entry.
        """
        return cls.from_dict(load_yaml(path), os.fspath(path))

    @classmethod
    def from_dict(cls, data: Any, name: str = "prices") -> Prices:
        """The same from data; ``name`` stands in errors."""
        if not isinstance(data, dict) or not isinstance(models := data.get("models"), dict):
            raise InputError(f"{name}: has no table 'models'; see docs/models.md")
        if unknown := set(map(str, data)) - {"currency", "models"}:
            raise InputError(f"{name}: {sorted(unknown)[0]!r} is unknown here; only currency and models are")
        currency = data.get("currency", "")
        if not isinstance(currency, str):
            raise InputError(f"{name}: currency is no word; write one such as EUR")
        return cls({str(model): _price(f"{name}: models.{model}", row) for model, row in models.items()}, currency)

    def of(self, title: str) -> Price | None:
        """The price of a model by "openai:NAME" or NAME; None when the table has none."""
        return self.models.get(title) or self.models.get(title.partition(":")[2])


def _price(where: str, row: Any) -> Price:
    if not isinstance(row, dict) or not {"input", "output"} <= set(row):
        raise InputError(f"{where}: needs input and output, each the price of a million tokens")
    for key, value in row.items():
        if key not in KEYS:
            raise InputError(f"{where}.{key}: is unknown; only {', '.join(KEYS)} are")
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value < 1e9:
            raise InputError(f"{where}.{key}: {value!r} is no price")
    return Price(**{key: float(value) for key, value in row.items()})
