"""Replies that are too much: of text, of calls, of headers, of levels; some without an end."""

from __future__ import annotations

import functools
import json
import zlib
from collections.abc import Iterator
from typing import Any

from tests.llm.bad_answers import arguments, with_arguments
from tests.llm.bad_shapes import document
from tests.llm.misbehaviour import bad
from tests.llm.said import Asked, Said, output_tool
from tests.llm.wire import Wire

MEGABYTE = 1 << 20
LEVELS = 10_000
BOMB = 1 << 28
"""Bytes that a compressed reply of a quarter of a megabyte unfolds to."""


@bad("large")
def megabyte_of_words(asked: Asked, good: Said) -> Said:
    return Said(text="more " * (MEGABYTE // 5))


@bad("large")
def megabyte_of_arguments(asked: Asked, good: Said) -> Said:
    first = next(iter(arguments(good)), "text")
    return with_arguments(asked, good, arguments(good) | {first: "x" * MEGABYTE})


@bad("large")
def calls_2000(asked: Asked, good: Said) -> Said:
    return Said(calls=((output_tool(asked), arguments(good)),) * 2_000)


@bad("large")
def lists_of_10000(asked: Asked, good: Said) -> Said:
    longer = {
        key: value * (10_000 // len(value)) if isinstance(value, list) and value else value
        for key, value in arguments(good).items()
    }
    return with_arguments(asked, good, longer)


@bad("large")
def deep_arguments(asked: Asked, good: Said) -> Said:
    first = json.dumps(next(iter(arguments(good)), "text"))
    return with_arguments(asked, good, f"{{{first}: {'[' * LEVELS}{']' * LEVELS}}}")


@bad("large")
def deep_in_every_field(asked: Asked, good: Said) -> Said:
    """Not so deep that a parser minds."""
    deep: dict[str, Any] = {}
    for _ in range(150):
        deep = {"in": deep}
    changed = {key: deep if isinstance(value, dict) else value for key, value in arguments(good).items()}
    return with_arguments(asked, good, changed)


@bad("large")
def deep_document(asked: Asked, good: Said) -> Said:
    return document(b'{"choices": ' + b'{"a": ' * LEVELS + b"1" + b"}" * LEVELS + b"}")


@bad("large")
def huge_header(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), headers={"X-Huge": "h" * MEGABYTE}))


@bad("large")
def headers_without_end(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        wire.send(b"HTTP/1.1 200 OK\r\n")
        line = b"X-More: and more\r\n" * 1000
        while not wire.wait(0.0):
            wire.send(line)

    return Said(raw=raw)


@bad("large")
def body_without_end(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "application/json", "Transfer-Encoding": "chunked"})
        block = b'{"again": 1}, ' * 4000
        wire.chunk(b"[")
        while not wire.wait(0.0):
            wire.chunk(block)

    return Said(raw=raw)


@bad("large")
def stream_without_end(asked: Asked, good: Said) -> Said:
    """The same words again and again."""

    def repeated(wire: Wire) -> Iterator[bytes]:
        events = wire.events(Said(text="a chair, and " * 20))
        yield b"".join(events[:3])
        words = next(event for event in events if b"chair" in event)
        while True:
            yield words * 50

    return Said(raw=lambda wire: wire.stream(repeated(wire)))


@bad("large")
def line_without_end(asked: Asked, good: Said) -> Said:
    """One event of a stream that never ends its line."""

    def raw(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "text/event-stream", "Transfer-Encoding": "chunked"})
        wire.chunk(b'data: {"id": "')
        block = b"x" * 65_536
        while not wire.wait(0.0):
            wire.chunk(block)

    return Said(raw=raw)


@bad("large")
def gzip_bomb(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, bomb(), headers={"Content-Encoding": "gzip"}))


@bad("large")
def gzip_bomb_in_an_error(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(500, bomb(), headers={"Content-Encoding": "gzip"}))


@functools.cache
def bomb() -> bytes:
    """`BOMB` spaces, as gzip."""
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    block = b" " * MEGABYTE
    return b"".join([packer.compress(block) for _ in range(BOMB // MEGABYTE)] + [packer.flush()])
