"""Statuses that are not 200."""

from __future__ import annotations

from tests.llm.misbehaviour import bad
from tests.llm.said import Asked, Said

NOWHERE = "http://127.0.0.1:9/v1/elsewhere"
DAY = 86_400


def status(code: int, message: str = "no", **headers: str) -> Said:
    """An error in the words of the protocol."""
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return Said(raw=lambda wire: wire.error(code, message, named))


@bad("statuses")
def too_many(asked: Asked, good: Said) -> Said:
    return status(429, "slow down")


@bad("statuses")
def too_many_wait_a_moment(asked: Asked, good: Said) -> Said:
    return status(429, "slow down", Retry_After="0.2")


@bad("statuses")
def too_many_wait_a_day(asked: Asked, good: Said) -> Said:
    return status(429, "come back tomorrow", Retry_After=str(DAY), retry_after_ms=str(DAY * 1000))


@bad("statuses")
def too_many_wait_for_rubbish(asked: Asked, good: Said) -> Said:
    return status(429, "slow down", Retry_After="Infinity", x_should_retry="true")


@bad("statuses")
def wait_until_a_date(asked: Asked, good: Said) -> Said:
    return status(503, "closed", Retry_After="Fri, 31 Dec 9999 23:59:59 GMT")


@bad("statuses")
def server_error(asked: Asked, good: Said) -> Said:
    return status(500, "it hurts")


@bad("statuses")
def unavailable(asked: Asked, good: Said) -> Said:
    return status(503, "overloaded")


@bad("statuses")
def overloaded(asked: Asked, good: Said) -> Said:
    return status(529, "overloaded")


@bad("statuses")
def bad_request(asked: Asked, good: Said) -> Said:
    return status(400, "tools are not supported\nTraceback (most recent call last):\n" + "  at line 1\n" * 50)


@bad("statuses")
def unauthorized(asked: Asked, good: Said) -> Said:
    return status(401, "no such key")


@bad("statuses")
def not_found(asked: Asked, good: Said) -> Said:
    return status(404, "no such model")


@bad("statuses")
def status_999(asked: Asked, good: Said) -> Said:
    return status(999, "request denied")


@bad("statuses")
def no_content(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.head(204))


@bad("statuses")
def redirect(asked: Asked, good: Said) -> Said:
    return redirect_to(NOWHERE)


@bad("statuses")
def redirect_to_itself(asked: Asked, good: Said) -> Said:
    path = "/v1/chat/completions" if asked.api == "chat" else "/v1/messages"
    return redirect_to(f"http://{asked.headers['host']}{path}")


def redirect_to(url: str) -> Said:
    """Sends the client elsewhere, with method and body."""
    return Said(raw=lambda wire: wire.document(307, b"", headers={"Location": url}))
