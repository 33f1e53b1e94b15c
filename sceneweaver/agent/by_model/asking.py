"""Which model a run asks, as the arguments of a design say it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.llm import Endpoint, Limits, ModelClient, Prices, open_client, redact
from sceneweaver.llm.opening import check_price
from sceneweaver.llm.records import Recorder
from sceneweaver.llm.secrets import guard_logs
from sceneweaver.scene import InputError

from .strict import StrictClient


@dataclass(frozen=True)
class Asking:
    """Which model is asked and how, as the arguments of a design say it.

    Attributes:
        model: "openai:NAME", "anthropic:NAME", a name at ``base_url``, a client, or a model of pydantic-ai; None: what
            the environment names.
        base_url: where, for a server of one's own.
        limits: what may be spent.
        prices: what tokens cost.
        stream: whether replies come in pieces; None: as the environment says.
        strict: whether a run ends where the model cannot be asked any more.
        replay: the folder of a recorded run that answers in the model's place.
    """

    model: str | ModelClient | Any | None = None
    base_url: str | None = None
    limits: Limits | None = None
    prices: Prices | None = None
    stream: bool | None = None
    strict: bool = False
    replay: Path | None = None

    def check(self, needed: bool) -> None:
        """Find what is wrong before anything is written.

        Args:
            needed: whether a model has anything to do.

        Raises:
            InputError: when something is wrong with an argument.
            MissingDependencyError: when a model is needed and none is configured, or its key is missing.
        """
        if not needed or self.replay is not None:
            return
        if self.model is None or isinstance(self.model, str):
            Endpoint.of(self.model, self.base_url, stream=self.stream)
        elif isinstance(self.model, ModelClient):
            for name in ("base_url", "limits", "prices", "stream"):
                if getattr(self, name) is not None:
                    raise InputError(f"{name}: a client has its own; give it to open_client, or give a model's name")

    def client(
        self,
        records: Path | None,
        left: Callable[[], float],
        stopped: Callable[[], bool],
        over: Callable[[], bool] = bool,
    ) -> ModelClient:
        """What asks; questions and answers go to ``records``.

        Args:
            records: a folder; None: nothing is written.
            left: seconds that the model may take from now on.
            stopped: whether the run is to stop.
            over: whether the run has no time left for anything, so that a strict one ends as any other does.

        Raises:
            InputError: when a cost is limited without a price.
            MissingDependencyError: when no model is configured, its key is missing, or pydantic-ai is not installed.
        """
        if self.replay is not None:
            client = open_client(replay=self.replay, records=records)
        elif isinstance(self.model, ModelClient):
            client = self.model
        elif self.model is None or isinstance(self.model, str):
            client = open_client(
                Endpoint.of(self.model, self.base_url, stream=self.stream),
                limits=self.limits,
                prices=self.prices,
                records=records,
                left=left,
                stopped=stopped,
            )
        else:
            facts = {"title": redact(str(self.model.model_name)), "pictures": True}
            check_price(facts["title"], self.limits, self.prices)
            guard_logs()
            client = ModelClient(
                self.model,
                limits=self.limits,
                prices=self.prices,
                recorder=Recorder(records, facts) if records is not None else None,
                left=left,
                stopped=stopped,
            )
        return StrictClient(client, over) if self.strict else client
