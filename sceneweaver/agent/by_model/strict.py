"""A client for runs that must not go on without their model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from sceneweaver.llm import BudgetSpent, ModelClient, ModelError, ModelUnreachable, Picture, Reply
from sceneweaver.scene import MissingDependencyError

Answer = TypeVar("Answer", bound=Reply)


class StrictClient(ModelClient):
    """Asks as another client does, but where that can ask no more, the run ends instead of going on by rules.

    A single answer that cannot be used is still a `ModelFailed`. Where the run is ``over``, as its time is up or a
    signal stops it, it ends as any other does.
    """

    def __init__(self, client: ModelClient, over: Callable[[], bool] = bool) -> None:
        self._client = client
        self._over = over

    def __getattr__(self, name: str) -> Any:
        return getattr(self._client, name)

    def ask(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = 3,
    ) -> Answer:
        """As `ModelClient.ask`.

        Raises:
            MissingDependencyError: when the model cannot be asked any more.
        """
        try:
            return self._client.ask(purpose, kind, instructions, content, check=check, retries=retries)
        except ModelError as error:
            raise self._ended(error) from None

    def ask_many(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        samples: int,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = 3,
    ) -> list[Answer | ModelError]:
        """As `ModelClient.ask_many`.

        Raises:
            MissingDependencyError: when the model cannot be asked any more.
        """
        found = self._client.ask_many(
            purpose, kind, instructions, content, samples=samples, check=check, retries=retries
        )
        for one in found:
            if isinstance(one, ModelError) and one is not (ended := self._ended(one)):
                raise ended from None
        return found

    def shown(self, purpose: str) -> tuple[Picture, ...] | None:
        """As `ModelClient.shown`."""
        return self._client.shown(purpose)

    def _ended(self, error: ModelError) -> Exception:
        """What to raise for an error."""
        if self._over():
            return error
        if isinstance(error, ModelUnreachable | BudgetSpent) or getattr(self._client, "lost", ""):
            return MissingDependencyError(f"the run is strict and its model cannot be asked any more: {error}")
        return error
