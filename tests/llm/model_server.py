"""A language model on a local port that says what a script tells it to.

    with ModelServer(answering({Plan: {...}, "phrase of the instructions": [first, second]})) as server:
        ...  # server.url for chat completions, server.root for messages
    assert server.requests[0].pictures

Errors of the script are status 400 for the client, and raised when the server is left.
"""

from __future__ import annotations

import contextlib
import json
import socket
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Any, Self

from tests.llm.said import Asked as Asked
from tests.llm.said import Said as Said
from tests.llm.said import Script as Script
from tests.llm.said import answering as answering
from tests.llm.said import output_tool as output_tool
from tests.llm.said import says as says
from tests.llm.wire import PROTOCOLS, Wire

MODEL = "scripted-1"
"""Name of the model under `GET /v1/models`; any name is answered."""

PATHS = {"/v1/chat/completions": "chat", "/v1/messages": "messages"}


class ModelServer:
    """Serves until it is left; threads, 127.0.0.1, a free port.

    Args:
        script: what it says; see `answering`.

    Attributes:
        requests: what it was asked, in the order in which requests arrived.
        keys_seen: every key that came in `Authorization: Bearer` or `x-api-key`.
        strays: method and path of requests that no protocol has.
    """

    def __init__(self, script: Script) -> None:
        self.script = script
        self.requests: list[Asked] = []
        self.keys_seen: set[str] = set()
        self.strays: list[str] = []
        self._failed: list[Exception] = []
        self._lock = threading.Lock()
        self._open: set[socket.socket] = set()
        self._stopping = threading.Event()
        self._http = _Server(self)

    @property
    def root(self) -> str:
        """`http://127.0.0.1:PORT`, what clients of messages take."""
        return f"http://127.0.0.1:{self._http.server_address[1]}"

    @property
    def url(self) -> str:
        """`http://127.0.0.1:PORT/v1`, what clients of chat completions take."""
        return f"{self.root}/v1"

    def __enter__(self) -> Self:
        threading.Thread(target=self._http.serve_forever, args=(0.01,), daemon=True).start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._stopping.set()
        self._http.shutdown()
        with self._lock:
            for connection in self._open:
                with contextlib.suppress(OSError):
                    connection.shutdown(socket.SHUT_RDWR)
        self._http.server_close()
        if self._failed and error is None:
            raise self._failed[0]

    def asked(self, api: str, body: dict[str, Any], headers: dict[str, str]) -> Asked:
        with self._lock:
            found = PROTOCOLS[api].read(body, headers, len(self.requests))
            self.requests.append(found)
            return found

    def saw_key(self, headers: dict[str, str]) -> None:
        for key in (headers.get("authorization", "").removeprefix("Bearer "), headers.get("x-api-key", "")):
            if key:
                self.keys_seen.add(key)

    def failed(self, error: Exception) -> None:
        self._failed.append(error)

    def opened(self, connection: socket.socket, is_open: bool) -> None:
        with self._lock:
            (self._open.add if is_open else self._open.discard)(connection)

    @property
    def stopping(self) -> threading.Event:
        """Set once it is left."""
        return self._stopping


class _Server(ThreadingHTTPServer):
    daemon_threads = True
    block_on_close = False
    request_queue_size = 128

    def __init__(self, owner: ModelServer) -> None:
        self.owner = owner
        super().__init__(("127.0.0.1", 0), _Handler)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A client that goes away in the middle is no matter."""


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: _Server  # pyright: ignore[reportIncompatibleVariableOverride]

    def setup(self) -> None:
        super().setup()
        self.server.owner.opened(self.connection, True)

    def finish(self) -> None:
        self.server.owner.opened(self.connection, False)
        with contextlib.suppress(OSError, ValueError):
            super().finish()

    def log_message(self, *args: Any) -> None:
        pass

    def do_GET(self) -> None:
        headers = {name.lower(): value for name, value in self.headers.items()}
        self.server.owner.saw_key(headers)
        if self.path == "/v1/models":
            model = {"id": MODEL, "object": "model", "created": 0, "owned_by": "tests", "type": "model"}
            self._plain(200, {"object": "list", "data": [model], "has_more": False})
        else:
            self._stray()

    def do_POST(self) -> None:
        owner = self.server.owner
        headers = {name.lower(): value for name, value in self.headers.items()}
        owner.saw_key(headers)
        data = self.rfile.read(int(headers.get("content-length", 0)))
        api = PATHS.get(self.path.partition("?")[0])
        if api is None:
            return self._stray()
        try:
            asked = owner.asked(api, json.loads(data), headers)
        except (KeyError, ValueError, TypeError, AttributeError) as error:
            owner.failed(error)
            return self._plain(400, {"error": {"message": f"no request of {api}: {error!r}", "type": "invalid"}})
        self.close_connection = True
        wire = Wire(self.connection, asked, owner.stopping)
        try:
            said = owner.script(asked)
        except Exception as error:
            owner.failed(error)
            return wire.error(400, f"the script failed: {error!r}")
        try:
            said.raw(wire) if said.raw else wire.reply(said)
        except OSError:
            return  # the client went away
        except Exception as error:
            owner.failed(error)

    def _stray(self) -> None:
        self.server.owner.strays.append(f"{self.command} {self.path}")
        self._plain(404, {"error": {"message": f"no such path: {self.path}", "type": "not_found"}})

    def _plain(self, status: int, body: dict[str, Any]) -> None:
        data = json.dumps(body).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)
