"""Clients of HTTP that go away in the middle of a call: their work ends, as nobody would read what comes of it."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any, TypeVar

import anyio
from starlette.types import ASGIApp, Message, Receive, Scope, Send

Result = TypeVar("Result")

LEFT = "sceneweaver.left"
"""Key of a request's scope: an event that is set when the client has closed the connection."""


class Watched:
    """An application whose requests know when their client has left."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a request."""
        left = anyio.Event()

        async def heard() -> Message:
            message = await receive()
            if message["type"] == "http.disconnect":
                left.set()
            return message

        await self._app({**scope, LEFT: left}, heard, send)


async def unless_left(request: Any, call: Callable[[], Awaitable[Result]]) -> Result | None:
    """What a call gives; None where the client of the request left before.

    Args:
        request: that of HTTP; None for other transports.
        call: what is cancelled when the client leaves.
    """
    left = getattr(request, "scope", {}).get(LEFT)
    if left is None:
        return await call()
    result: Result | None = None
    error: Exception | None = None
    async with anyio.create_task_group() as group:

        async def watch() -> None:
            await left.wait()
            group.cancel_scope.cancel()

        group.start_soon(watch)
        try:
            result = await call()
        except Exception as raised:  # a group of tasks would wrap it
            error = raised
        group.cancel_scope.cancel()
    if error is not None:
        raise error
    return result
