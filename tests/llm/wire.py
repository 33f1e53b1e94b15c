"""One connection on which a reply is written, as it should be or as a misbehaviour likes."""

from __future__ import annotations

import json
import socket
import struct
import threading
from collections.abc import Iterable, Mapping
from http import HTTPStatus
from types import ModuleType

from tests.llm import chat_wire, messages_wire
from tests.llm.said import Asked, Said

PROTOCOLS: dict[str, ModuleType] = {"chat": chat_wire, "messages": messages_wire}


class Wire:
    """What a misbehaviour writes with.

    Attributes:
        asked: the request.
        stopping: set when the server is left: whoever writes for ever ends then.
    """

    def __init__(self, connection: socket.socket, asked: Asked, stopping: threading.Event) -> None:
        self.asked = asked
        self.stopping = stopping
        self._connection = connection
        self._protocol = PROTOCOLS[asked.api]

    def body(self, said: Said) -> bytes:
        """A whole reply as it should be, not streamed."""
        return json.dumps(self._protocol.whole(said, self.asked)).encode()

    def events(self, said: Said) -> list[bytes]:
        """The events of a streamed reply."""
        return list(self._protocol.events(said, self.asked))

    def send(self, data: bytes) -> None:
        """Bytes as they are.

        Raises:
            OSError: when the client is gone.
        """
        self._connection.sendall(data)

    def head(self, status: int = 200, headers: Mapping[str, str] | None = None) -> None:
        """Status line and headers; the connection is closed after the reply."""
        try:
            phrase = HTTPStatus(status).phrase
        except ValueError:
            phrase = "Unknown"
        lines = [f"HTTP/1.1 {status} {phrase}"]
        lines += [f"{name}: {value}" for name, value in ({"Connection": "close"} | dict(headers or {})).items()]
        self.send(("\r\n".join(lines) + "\r\n\r\n").encode("latin-1", "replace"))

    def reply(self, said: Said) -> None:
        """A reply as it should be, streamed if asked for."""
        if self.asked.stream:
            self.stream(self._protocol.events(said, self.asked))
        else:
            self.document(200, self.body(said))

    def document(
        self, status: int, body: bytes, kind: str = "application/json", headers: Mapping[str, str] | None = None
    ) -> None:
        """A whole document."""
        self.head(status, {"Content-Type": kind, "Content-Length": str(len(body))} | dict(headers or {}))
        self.send(body)

    def error(self, status: int, message: str, headers: Mapping[str, str] | None = None) -> None:
        """An error in the words of the protocol."""
        self.document(status, json.dumps(self._protocol.error(status, message)).encode(), headers=headers)

    def stream(self, events: Iterable[bytes], pause: float = 0.0) -> None:
        """Events as chunks; ends early when the server is left."""
        self.head(200, {"Content-Type": "text/event-stream", "Transfer-Encoding": "chunked"})
        for event in events:
            self.chunk(event)
            if self.wait(pause):
                return
        self.send(b"0\r\n\r\n")

    def chunk(self, data: bytes) -> None:
        """One chunk of a chunked body."""
        self.send(f"{len(data):x}\r\n".encode() + data + b"\r\n")

    def wait(self, seconds: float) -> bool:
        """Waits; True once the server is left."""
        return self.stopping.wait(seconds) if seconds else self.stopping.is_set()

    def cut(self) -> None:
        """Ends the connection with a reset."""
        self._connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self._connection.close()
