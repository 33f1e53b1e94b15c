"""What an error of a library or a server means: try again, give up this question, or give up the model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from .secrets import line

if TYPE_CHECKING:
    from .endpoint import Endpoint

PASSING = frozenset((408, 409, 425, 429, 500, 502, 503, 504, 520, 521, 522, 523, 524, 529))
"""Statuses of HTTP after which the same request may succeed."""

Verdict = Literal["unreachable", "again", "unreadable", "failed"]
"""Give up the model; try again and then give it up; try again and then give up the question; give up the question."""


class TooLong(Exception):
    """A reply has more bytes than an endpoint may send."""


@dataclass(frozen=True)
class Fault:
    """An error of a request.

    Attributes:
        verdict: what to do.
        words: one line without secrets.
        wait: seconds that the server asks us to wait; None when it does not say.
    """

    verdict: Verdict
    words: str
    wait: float | None = None


def fault(error: Exception, endpoint: Endpoint | None) -> Fault:
    """What an error that a request ended with means."""
    from pydantic_ai.exceptions import ModelAPIError, ModelConnectionError, ModelHTTPError, UserError

    chain = list(_chain(error))
    for item in chain:
        if isinstance(item, TooLong):
            return Fault("failed", line(item))
    if isinstance(error, TimeoutError):
        return Fault("again", "no whole reply in time")
    if isinstance(error, ModelHTTPError):
        return _status(error.status_code, error, endpoint)
    for item in chain:  # those below 400 are no errors to every library
        if isinstance(status := getattr(item, "status_code", None), int) and status >= 300:
            return _status(status, item, endpoint)
    if isinstance(error, ModelConnectionError) or _is_transport(chain):
        where = f" to {endpoint.url}" if endpoint else ""
        return Fault("again", line(f"no connection{where}, or it broke off ({_innermost(chain)})"))
    if isinstance(error, ModelAPIError):
        return Fault("unreadable", f"the reply is of no use: {line(error.message, 200)}")
    if isinstance(error, UserError):
        return Fault("failed", f"the question cannot be asked: {line(error, 200)}")
    return Fault("unreadable", f"the reply cannot be read: {type(error).__name__}: {line(error, 200)}")


def _status(status: int, error: object, endpoint: Endpoint | None) -> Fault:
    if status in (401, 403):  # the words of such replies may hold part of the key
        key = (endpoint.key_name if endpoint else None) or "SCENEWEAVER_API_KEY"
        return Fault("unreachable", f"the endpoint refuses the key (status {status}); set {key} in the environment")
    if status == 404:
        return Fault(
            "unreachable",
            f"the endpoint has no such model or path (status 404{f': {endpoint.name}' if endpoint else ''}); "
            "set SCENEWEAVER_MODEL or SCENEWEAVER_BASE_URL",
        )
    said = line(_message(getattr(error, "body", None)), 200)
    words = f"the endpoint answers with status {status}" + (f": {said}" if said else "")
    if status in PASSING or status >= 500:
        return Fault("again", words, getattr(error, "retry_after", None))
    if 300 <= status < 400:
        return Fault("unreachable", f"{words}; set SCENEWEAVER_BASE_URL to where it leads")
    return Fault("unreachable" if status == 402 else "failed", words)


def _message(body: object) -> str:
    """What an error document says."""
    for _ in range(3):
        if not isinstance(body, dict):
            break
        body = next((body[key] for key in ("error", "message", "detail") if body.get(key)), "")
    return "" if body is None else str(body)


def _is_transport(chain: list[BaseException]) -> bool:
    import httpx2

    return any(isinstance(item, httpx2.TransportError | OSError) for item in chain)


def _innermost(chain: list[BaseException]) -> str:
    named = [item for item in chain if str(item)]
    return f"{type(named[-1]).__name__}: {named[-1]}" if named else type(chain[-1]).__name__


def _chain(error: BaseException | None) -> Iterator[BaseException]:
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        yield error
        error = error.__cause__ or error.__context__
