"""How the server is reached: over its standard streams, or over HTTP from this computer alone."""

from __future__ import annotations

import os
import signal
import socket
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

import anyio
import uvicorn
from mcp.server.transport_security import TransportSecuritySettings
from starlette.applications import Starlette

from sceneweaver.scene import InputError

from .leaving import Watched
from .server import SceneServer

HOST = "127.0.0.1"
PATH = "/mcp"
SIGNALS = (signal.SIGTERM, signal.SIGINT)

CLOSED_AFTER = 1
"""Seconds that open connections have when the server ends."""

IDLE = 3600.0
"""Seconds after which a session that nobody uses is forgotten."""


def serve_stdio(server: SceneServer) -> None:
    """Serve one client over stdin and stdout until it closes them, or a signal comes."""
    with _ending(server):
        try:
            anyio.run(server.run_stdio_async)
        finally:
            server.service.workers.close()


def serve_http(server: SceneServer, port: int) -> None:
    """Serve clients of this computer over streamable HTTP until a signal comes.

    Raises:
        InputError: when the port is none, or not free.
    """
    if not 0 <= port <= 65535:
        raise InputError(f"--port: {port} is no port; give one from 1024 to 65535, or 0 for any")
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
        listener.listen(128)
    except OSError:
        listener.close()
        raise InputError(f"--port: {port} is not free; give another, or 0 for any") from None
    port = listener.getsockname()[1]
    config = uvicorn.Config(
        Watched(http_app(server, port)),
        log_level="warning",
        timeout_graceful_shutdown=CLOSED_AFTER,
        access_log=False,
    )
    with listener:
        try:
            _Server(config).run(sockets=[listener])
        finally:
            server.service.workers.close()


class _Server(uvicorn.Server):
    """A server that says where it is once it can be reached, and ends in order on a signal.

    It is done then; uvicorn's own would raise the signal once more.
    """

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to answer, and say where."""
        await super().startup(sockets)
        for one in sockets or ():
            sys.stderr.write(f"sceneweaver: MCP at http://{HOST}:{one.getsockname()[1]}{PATH}  (Ctrl-C ends)\n")
        sys.stderr.flush()

    @contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Let signals end the server while the block runs."""
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = {number: signal.signal(number, self.handle_exit) for number in SIGNALS}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)


def http_app(server: SceneServer, port: int) -> Starlette:
    """The application, which answers only to names of this computer: other sites may let theirs resolve to it."""
    names = (f"{HOST}:{port}", f"localhost:{port}")
    security = TransportSecuritySettings(
        enable_dns_rebinding_protection=True,
        allowed_hosts=list(names),
        allowed_origins=[f"http://{name}" for name in names],
    )
    return server.streamable_http_app(
        streamable_http_path=PATH, host=HOST, transport_security=security, session_idle_timeout=IDLE
    )


@contextmanager
def _ending(server: SceneServer) -> Iterator[None]:
    """Signals end the process at once, but for what has to be cleared up: a thread waits for stdin and cannot."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def end(number: int, _: FrameType | None) -> None:
        server.service.workers.close()
        os._exit(0)

    before = {number: signal.signal(number, end) for number in SIGNALS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
