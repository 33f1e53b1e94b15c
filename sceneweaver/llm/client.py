"""One way to ask a model: a purpose, instructions, text and pictures in; a checked, typed answer out."""

from __future__ import annotations

import math
import os
import threading
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import MissingDependencyError

from .attempts import Account
from .budget import Limits, Usage
from .conversation import ERRORS, Conversation, error_of
from .endpoint import Endpoint
from .errors import BudgetSpent, ModelError, ModelFailed, ModelUnreachable
from .prices import Prices
from .records import Asked, Record, Recorder
from .reply import Picture, Reply
from .secrets import redact
from .waiting import CallQueue, Waiting

if TYPE_CHECKING:
    from pydantic_ai.models import Model

Answer = TypeVar("Answer", bound=Reply)

RETRIES = 3
"""Times that a model is told what is wrong with its answer, and asked again."""

STRIKES = 3
"""Questions in a row without any reply that can be read, after which the model counts as lost."""


class ModelClient:
    """Asks one model.

    Args:
        model: a model of pydantic-ai, such as a `FunctionModel` in tests; `open_client` makes one of an `Endpoint`.
        endpoint: how it is asked; None for a model without a network.
        limits: what the run may spend.
        prices: what tokens cost; see `Prices`.
        recorder: where questions and answers are written.
        left: seconds until the run has to end.
        stopped: whether the run is to stop; looked at while waiting.

    Attributes:
        usage: what is spent.
        lost: why no further question is asked; "" while they are.
        pictures: whether the model takes pictures.
        name: of the model, for reports.
    """

    def __init__(
        self,
        model: Model | None,
        *,
        endpoint: Endpoint | None = None,
        limits: Limits | None = None,
        prices: Prices | None = None,
        recorder: Recorder | None = None,
        left: Callable[[], float] | None = None,
        stopped: Callable[[], bool] | None = None,
    ) -> None:
        self._model = model
        self.name = endpoint.title if endpoint else redact(str(getattr(model, "model_name", "model")))
        self.pictures = endpoint.pictures if endpoint else True
        self.lost = ""
        price = prices.of(self.name) if prices else None
        self.usage = Usage(price, price is not None, prices.currency if prices else "")
        self._account = Account(self.usage, limits or Limits(), endpoint, left or _forever)
        self._recorder, self._stopped = recorder, stopped or _never
        self._loss: type[ModelError] = ModelUnreachable
        self._strikes = 0
        self._lock = threading.RLock()
        if recorder and recorder.usage:
            self.usage.restore(recorder.usage)

    def ask(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = RETRIES,
    ) -> Answer:
        """One answer.

        Args:
            purpose: short name of what is asked for, such as "plan"; records and budgets name it.
            kind: the type of the answer.
            instructions: what the model is and how it is to answer.
            content: text and pictures, in order. Equal for equal runs: no clock, no paths.
            check: refuses an answer by an `InputError`, whose words the model is told; may give back a mended answer.
                Called in the thread of the caller. A replay calls it with the same answers in the same order.
            retries: times that it is asked again after an answer that is refused.

        Raises:
            ModelError: when there is no answer that passes.
        """
        found = self.ask_many(purpose, kind, instructions, content, samples=1, check=check, retries=retries)[0]
        if isinstance(found, ModelError):
            raise found
        return found

    def ask_many(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        samples: int,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = RETRIES,
    ) -> list[Answer | ModelError]:
        """Several independent answers to the same question, side by side; an error in the place of one that failed."""
        if self.lost:
            return [self._lost_error(purpose) for _ in range(samples)]
        parts = tuple(_clean(part) for part in content)
        asked = Asked(purpose, kind.__name__, redact(instructions), parts, kind.model_json_schema())
        with self._lock:  # threads may ask side by side
            records = [Record(asked, number=self._next_number()) for _ in range(samples)]
        return self._answers(records, kind, check, retries)

    def shown(self, purpose: str) -> tuple[Picture, ...] | None:
        """In a replay the pictures that the next question of a purpose came with, so that nobody draws them again; None
        with a live model."""
        del purpose
        return None

    def keep(self) -> None:
        """Mark that what was asked so far is part of what the run has saved; for runs that are resumed."""
        if self._recorder:
            self._recorder.keep(self.usage.to_dict())

    def _answers(
        self,
        records: Sequence[Record],
        kind: type[Answer],
        check: Callable[[Answer], Answer | None] | None,
        retries: int,
    ) -> list[Answer | ModelError]:
        """Ask, side by side, and write what came of it."""
        import asyncio

        os.environ.setdefault("PYDANTIC_AI_NO_BANNER", "1")  # it would greet our users
        try:
            import pydantic_ai  # noqa: F401  # pyright: ignore[reportUnusedImport]
        except ImportError:
            raise MissingDependencyError(missing_extra("llm", "models need pydantic-ai")) from None
        assert self._model is not None
        endpoint = self._account.endpoint
        stream = endpoint.stream if endpoint else getattr(self._model, "function", True) is None
        calls = CallQueue()
        conversations = [
            Conversation(
                self._model,
                self._account,
                record,
                kind,
                check,
                retries=retries,
                answers=endpoint.answers if endpoint else "tool",
                stream=stream,
                pictures=self.pictures,
                calls=calls,
            )
            for record in records
        ]

        async def all_of_them() -> list[Answer | None]:
            return await asyncio.gather(*(conversation.run() for conversation in conversations))

        began = time.monotonic()
        self._account.started[id(calls)] = began
        answers: list[Answer | None] | None = None
        ended = "the run was interrupted before the answer was there"
        try:
            with Waiting(all_of_them(), calls) as waiting:
                answers = waiting.result(self._stopped)
                ended = "" if answers is not None else "the run was stopped before the answer was there"
        finally:
            del self._account.started[id(calls)]
            with self._lock:
                self._finish(records, time.monotonic() - began, ended)
        told = answers if answers is not None else [None for _ in records]
        return [error_of(record) if answer is None else answer for answer, record in zip(told, records, strict=True)]

    def _finish(self, records: Sequence[Record], seconds: float, ended: str) -> None:
        """Count a question, see whether the model is lost, write the records."""
        share: dict[str, float] = {"asks": 1, "seconds": round(seconds / len(records), 3)}
        for record in records:
            self.usage.add(record.asked.purpose, share)
            record.usage |= share
            if ended:
                record.answer = None
                record.failure = {"class": BudgetSpent.__name__, "words": f"{record.asked.purpose}: {ended}"}
            self._see(record)
            self._note(record)

    def _note(self, record: Record) -> None:
        """Lose the model where a record says so; write the record."""
        if record.lost and not self.lost:
            spent = ERRORS.get(record.failure.get("class", "")) is BudgetSpent
            self.lost, self._loss = record.lost, BudgetSpent if spent else ModelUnreachable
        if self._recorder:
            self._recorder.write(record, self.usage.to_dict())

    def _see(self, record: Record) -> None:
        """Say that the model is lost after an error that the next question would meet as well."""
        kind = ERRORS.get(record.failure.get("class", ""))
        unread = kind is ModelFailed and not any("reply" in attempt for attempt in record.attempts)
        self._strikes = self._strikes + 1 if unread else 0
        if self.lost:
            record.lost = self.lost
        elif kind in (ModelUnreachable, BudgetSpent):
            record.lost = record.failure["words"]
        elif self._strikes >= STRIKES:
            record.lost = f"{record.failure['words']} ({STRIKES} questions in a row without a reply)"

    def _lost_error(self, purpose: str) -> ModelError:
        return self._loss(f"{purpose}: not asked, as the model was given up: {self.lost}")

    def _next_number(self) -> int:
        return self._recorder.next_number() if self._recorder else 0


def _clean(part: str | Picture) -> str | Picture:
    return redact(part) if isinstance(part, str) else Picture(part.png, redact(part.title))


def _forever() -> float:
    return math.inf


def _never() -> bool:
    return False
