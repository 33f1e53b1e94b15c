"""A client for runs that must not go on without their model."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sceneweaver.llm import BudgetSpent, ModelClient, ModelError, ModelUnreachable, Picture
from sceneweaver.scene import MissingDependencyError


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

    def ask_many(self, *question: Any, **options: Any) -> list[Any]:
        """As `ModelClient.ask_many`, by which `ModelClient.ask` asks as well.

        Raises:
            MissingDependencyError: when the model cannot be asked any more.
        """
        found = self._client.ask_many(*question, **options)
        for one in found:
            gone = isinstance(one, ModelUnreachable | BudgetSpent) or bool(getattr(self._client, "lost", ""))
            if isinstance(one, ModelError) and gone and not self._over():
                raise MissingDependencyError(f"the run is strict and its model cannot be asked any more: {one}")
        return found

    def shown(self, purpose: str) -> tuple[Picture, ...] | None:
        """As `ModelClient.shown`."""
        return self._client.shown(purpose)
