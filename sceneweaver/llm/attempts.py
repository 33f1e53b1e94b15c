"""One request of a question: within the budget, made again after errors that pass, its reply without secrets."""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .budget import Limits, Usage
from .endpoint import Endpoint
from .errors import BudgetSpent, ModelError, ModelFailed, ModelUnreachable
from .faults import Fault, fault
from .records import Record
from .responses import as_data, cleaned, length, natural, refusal, told

if TYPE_CHECKING:
    from pydantic_ai.messages import ModelMessage, ModelResponse
    from pydantic_ai.models import Model, ModelRequestParameters
    from pydantic_ai.settings import ModelSettings

FIRST_WAIT = 0.5
"""Seconds before a request is made again; twice as long before each further time."""

LONGEST_WAIT = 60.0
"""Seconds that we wait at most. A server that asks for more is given up."""

SLOW_TRIES = 2
"""Times that a request may take all its time: each costs the whole time-out."""

CALL = "answer"
"""Name of the function by which a model answers."""


@dataclass
class Account:
    """What the questions of a client share.

    Attributes:
        usage: what is spent.
        limits: what may be spent.
        endpoint: what is asked; None for a model that was handed in.
        left: seconds until the run has to end.
        next_start: moment of `time.monotonic` before which no request may start.
    """

    usage: Usage
    limits: Limits
    endpoint: Endpoint | None
    left: Callable[[], float]
    next_start: float = -math.inf
    started: dict[int, float] = field(default_factory=dict[int, float])

    def seconds_left(self) -> float:
        """Until the run ends or the seconds for models are spent."""
        left = self.left()
        if self.limits.seconds is not None:
            left = min(left, self.limits.seconds - self.usage.total.seconds - self.waited())
        return left

    def waited(self) -> float:
        """Seconds since the first question that still waits was asked."""
        return time.monotonic() - min(self.started.values()) if self.started else 0.0

    def refuse_if_spent(self) -> None:
        """Raise `BudgetSpent` when nothing more may be asked."""
        if spent := self.usage.spent(self.limits, self.waited()):
            raise BudgetSpent(spent)
        if self.left() <= 0:
            raise BudgetSpent("the time for the model is over; what is left is kept to finish the room")


class Requests:
    """The requests of one question.

    Args:
        model: what is asked.
        account: budget of the run.
        record: gets every attempt.
        stream: whether replies come in pieces.
    """

    def __init__(self, model: Model, account: Account, record: Record, stream: bool) -> None:
        self._model, self._account, self._record, self._stream = model, account, record, stream

    async def reply(
        self, messages: list[ModelMessage], settings: ModelSettings | None, parameters: ModelRequestParameters
    ) -> ModelResponse:
        """A reply to messages.

        Raises:
            ModelError: when there is none.
        """
        words = told(messages)
        tries = self._account.endpoint.tries if self._account.endpoint else 1
        tried = slow = refused = 0
        while True:
            await self._may_start()
            attempt: dict[str, Any] = {"told": words} if words else {}
            self._record.attempts.append(attempt)
            self._spend(calls=1)
            try:
                response = await self._one(messages, settings, parameters)
            except asyncio.CancelledError:
                attempt["error"] = "cut off"
                self._spend(failed=1, **self._prompt(messages))
                raise
            except ModelError as error:
                attempt["error"] = str(error)
                self._spend(failed=1, **self._prompt(messages))
                raise
            except Exception as error:
                found = fault(error, self._account.endpoint)
                attempt["error"] = found.words
                self._spend(failed=1, **(self._prompt(messages) if isinstance(error, TimeoutError) else {}))
                tried += 1
                slow += isinstance(error, TimeoutError)
                await self._wait_or_give_up(found, tried, tries if slow < SLOW_TRIES else tried)
                continue
            self._count(response, messages, attempt)
            attempt.update(as_data(response))
            if response.finish_reason != "content_filter":
                return response
            refused += 1
            if refused == 2:
                raise ModelFailed(f"the model refuses to answer{refusal(response)}")

    async def _may_start(self) -> None:
        """Wait for the rate limit; raise when nothing more may be spent."""
        account = self._account
        account.refuse_if_spent()
        pace = account.endpoint.per_minute if account.endpoint else None
        if pace is None:
            return
        now = time.monotonic()
        start = max(now, account.next_start)
        account.next_start = start + 60.0 / pace
        await self._sleep(start - now)

    async def _sleep(self, seconds: float) -> None:
        if seconds <= 0:
            return
        if seconds >= self._account.seconds_left():
            raise BudgetSpent("the time for the model would be over before the next request may be made")
        await asyncio.sleep(seconds)
        self._account.refuse_if_spent()

    async def _one(
        self, messages: list[ModelMessage], settings: ModelSettings | None, parameters: ModelRequestParameters
    ) -> ModelResponse:
        endpoint = self._account.endpoint
        left = self._account.seconds_left()
        longest = min(endpoint.timeout if endpoint else math.inf, left)
        try:
            async with asyncio.timeout(longest if longest < math.inf else None):
                if not self._stream:
                    return cleaned(await self._model.request(messages, settings, parameters))
                async with self._model.request_stream(messages, settings, parameters) as pieces:
                    async for _ in pieces:
                        pass
                    return cleaned(pieces.get())
        except TimeoutError:
            if self._account.seconds_left() <= 0:
                raise BudgetSpent("the time for the model was over before the reply was there") from None
            raise

    async def _wait_or_give_up(self, found: Fault, tried: int, tries: int) -> None:
        if found.verdict == "unreachable":
            raise ModelUnreachable(found.words)
        if found.verdict == "failed":
            raise ModelFailed(found.words)
        if tried >= tries:
            kind = ModelUnreachable if found.verdict == "again" else ModelFailed
            raise kind(found.words + (f" ({tried} tries)" if tried > 1 else ""))
        wait = FIRST_WAIT * 2 ** (tried - 1) if found.wait is None else max(found.wait, 0.0)
        if not wait <= LONGEST_WAIT:
            raise ModelUnreachable(f"{found.words}, and asks to wait for {wait:g} s")
        await self._sleep(wait)

    def _count(self, response: ModelResponse, messages: Sequence[ModelMessage], attempt: dict[str, Any]) -> None:
        said = response.usage
        tokens_in, tokens_out, cached = map(natural, (said.input_tokens, said.output_tokens, said.cache_read_tokens))
        estimated = int(not tokens_in and not tokens_out)
        if estimated:
            tokens_in = -(-sum(length(message) for message in messages) // 4)
            tokens_out = -(-length(response) // 4)
        price = self._account.usage.price
        cost = price.cost(tokens_in, tokens_out, cached) if price else 0.0
        spent = {"tokens_in": tokens_in, "tokens_out": tokens_out, "cached": cached, "estimated": estimated}
        attempt["usage"] = spent
        self._spend(**spent, cost=cost)

    def _prompt(self, messages: Sequence[ModelMessage]) -> dict[str, float]:
        """What a request costs that was cut off: its prompt was read, and vendors count it."""
        tokens = -(-sum(length(message) for message in messages) // 4)
        price = self._account.usage.price
        return {"tokens_in": tokens, "estimated": 1, "cost": price.cost(tokens, 0) if price else 0.0}

    def _spend(self, **spent: float) -> None:
        self._account.usage.add(self._record.asked.purpose, spent)
        for name, value in spent.items():
            self._record.usage[name] = self._record.usage.get(name, 0) + value
