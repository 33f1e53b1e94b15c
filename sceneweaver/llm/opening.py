"""From an endpoint, or from the records of a run, to a client."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from sceneweaver.scene import InputError

from .budget import Limits
from .client import ModelClient
from .endpoint import Endpoint
from .prices import Prices
from .records import Recorder, read_folder
from .replay import ReplayClient
from .secrets import guard_logs

Place = str | os.PathLike[str]


def open_client(
    endpoint: Endpoint | None = None,
    *,
    limits: Limits | None = None,
    prices: Prices | None = None,
    records: Place | None = None,
    replay: Place | None = None,
    left: Callable[[], float] | None = None,
    stopped: Callable[[], bool] | None = None,
) -> ModelClient:
    """A client of a model. Nothing is sent before the first question.

    Args:
        endpoint: what is asked; None for the one that the environment names.
        limits: what the run may spend.
        prices: what tokens cost.
        records: folder for questions and answers. Where it holds some of an earlier session, numbers and sums go on.
        replay: folder of records to answer from instead, without a network; limits and times are those of the record.
        left: seconds until the run has to end.
        stopped: whether the run is to stop; looked at twenty times a second while waiting.

    Raises:
        InputError: when something is wrong with an argument, or a cost is limited without a price.
        MissingDependencyError: when no model is configured, its key is missing, or pydantic-ai is not installed.
    """
    if replay is not None:
        source = records_of(replay)
        old = read_folder(source)
        same = records is not None and Path(records).resolve() == source.resolve()
        recorder = Recorder(Path(records), _facts(old)) if records is not None and not same else None
        return ReplayClient(source, recorder)
    endpoint = endpoint or Endpoint.of()
    check_price(endpoint.title, limits, prices)
    from .transport import model_of

    model = model_of(endpoint)
    guard_logs()
    facts = {"title": endpoint.title, **endpoint.to_dict()}
    if prices is not None:
        facts |= {"priced": prices.of(endpoint.title) is not None, "currency": prices.currency}
    recorder = Recorder(Path(records), facts) if records is not None else None
    return ModelClient(
        model, endpoint=endpoint, limits=limits, prices=prices, recorder=recorder, left=left, stopped=stopped
    )


def check_price(name: str, limits: Limits | None, prices: Prices | None) -> None:
    """InputError when a cost is limited and the price of a model is not known: it would never be reached."""
    if limits is not None and limits.cost is not None and (prices is None or prices.of(name) is None):
        raise InputError(f"limits.cost: no price of {name} is known; give a price table that has it")


def records_of(folder: Place) -> Path:
    """The folder of records in the folder of a run, or the same where it is one already."""
    place = Path(folder)
    return place / "llm" if not (place / "endpoint.json").exists() and (place / "llm").is_dir() else place


def _facts(old: dict[str, object]) -> dict[str, object]:
    return {key: value for key, value in old.items() if key not in ("schema", "sessions")}
