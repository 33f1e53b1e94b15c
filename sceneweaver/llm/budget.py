"""What a run may spend on models, and what it has spent."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from sceneweaver.scene import InputError

from .prices import Price


@dataclass(frozen=True)
class Limits:
    """What a run may spend; None for no limit. A limit is looked at before each request.

    Tokens and cost are known only after a reply, so the last one may go over; requests side by side as well.

    Attributes:
        calls: requests to the endpoint, those made again counted.
        tokens: tokens in and out.
        cost: in the currency of the price table.
        seconds: waiting for models.
    """

    calls: int | None = None
    tokens: int | None = None
    cost: float | None = None
    seconds: float | None = None

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if value is None:
                continue
            if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value < math.inf:
                raise InputError(f"limits.{item.name}: {value!r} is no number of zero or more")


@dataclass
class Count:
    """Requests and tokens, in total or of one purpose.

    Attributes:
        asks: questions that were asked.
        calls: requests to the endpoint.
        failed: requests without a usable reply.
        tokens_in: tokens of prompts.
        tokens_out: tokens of answers.
        cached: tokens of prompts that the endpoint had in its cache.
        estimated: requests whose tokens the endpoint did not tell, counted as a quarter of the characters.
        seconds: waiting for replies.
        cost: by the price table; 0 without one.
    """

    asks: int = 0
    calls: int = 0
    failed: int = 0
    tokens_in: int = 0
    tokens_out: int = 0
    cached: int = 0
    estimated: int = 0
    seconds: float = 0.0
    cost: float = 0.0

    def add(self, other: Mapping[str, Any]) -> None:
        """Add what a record of an ask says."""
        for item in fields(self):
            value = other.get(item.name, 0)
            if isinstance(value, int | float):
                setattr(self, item.name, getattr(self, item.name) + value)


@dataclass
class Usage:
    """What a run has spent.

    Attributes:
        price: of the model; None when no price is known.
        priced: whether the cost is known.
        currency: of the price.
        total: everything.
        by_purpose: the same for each purpose.
    """

    price: Price | None = None
    priced: bool = False
    currency: str = ""
    total: Count = field(default_factory=Count)
    by_purpose: dict[str, Count] = field(default_factory=dict[str, Count])

    def add(self, purpose: str, spent: Mapping[str, Any]) -> None:
        """Add to the total and to a purpose."""
        self.total.add(spent)
        self.by_purpose.setdefault(purpose, Count()).add(spent)

    def restore(self, data: Mapping[str, Any]) -> None:
        """Go on from what `to_dict` gave in an earlier session."""
        self.total.add(data)
        for purpose, row in data.get("by_purpose", {}).items():
            self.by_purpose.setdefault(purpose, Count()).add(row)

    def spent(self, limits: Limits, more_seconds: float = 0.0) -> str:
        """Which limit is reached; "" when none is.

        Args:
            limits: what may be spent.
            more_seconds: waited since the last `add`.
        """
        total = self.total
        if limits.calls is not None and total.calls >= limits.calls:
            return f"the limit of {limits.calls} calls is reached"
        if limits.tokens is not None and total.tokens_in + total.tokens_out >= limits.tokens:
            return f"the limit of {limits.tokens} tokens is reached"
        if limits.cost is not None and total.cost >= limits.cost:
            return f"the limit of {limits.cost:g} {self.currency}".rstrip() + " is reached"
        if limits.seconds is not None and total.seconds + more_seconds >= limits.seconds:
            return f"the limit of {limits.seconds:g} s for models is reached"
        return ""

    def to_dict(self) -> dict[str, Any]:
        """As JSON data; cost is None where no price is known."""

        def row(count: Count) -> dict[str, Any]:
            data = asdict(count)
            return {
                **data,
                "seconds": round(count.seconds, 3),
                "cost": round(count.cost, 9) if self.priced else None,
            }

        return {
            **row(self.total),
            "currency": self.currency,
            "by_purpose": {name: row(count) for name, count in sorted(self.by_purpose.items())},
        }
