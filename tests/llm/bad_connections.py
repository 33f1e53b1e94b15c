"""Connections that break, documents that are not what they say; and servers that take their time."""

from __future__ import annotations

from tests.llm.misbehaviour import bad
from tests.llm.said import Asked, Said
from tests.llm.wire import Wire

HTML = b"<!doctype html><title>Sign in</title><h1>Welcome to the hotel network</h1>"


@bad("broken")
def html(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, HTML, "text/html; charset=utf-8"))


@bad("broken")
def html_called_json(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, HTML))


@bad("broken")
def wrong_content_type(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), "image/png"))


@bad("broken")
def streamed_or_not_the_other_way(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        wire.document(200, wire.body(good)) if asked.stream else wire.stream(wire.events(good))

    return Said(raw=raw)


@bad("broken")
def length_too_long(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), headers={"Content-Length": "99999"}))


@bad("broken")
def length_too_short(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), headers={"Content-Length": "20"}))


@bad("broken")
def length_no_number(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), headers={"Content-Length": "-1e9"}))


@bad("broken")
def closed_before_headers(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: None)


@bad("broken")
def reset_before_headers(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.cut())


@bad("broken")
def closed_in_headers(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.send(b"HTTP/1.1 200 OK\r\nContent-Ty"))


@bad("broken")
def reset_in_body(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        if asked.stream:
            return reset_in_stream(wire)
        body = wire.body(good)
        wire.head(200, {"Content-Type": "application/json", "Content-Length": str(len(body))})
        wire.send(body[: len(body) // 2])
        wire.wait(0.05)
        wire.cut()

    def reset_in_stream(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "text/event-stream", "Transfer-Encoding": "chunked"})
        for event in wire.events(good)[:3]:
            wire.chunk(event)
        wire.wait(0.05)
        wire.cut()

    return Said(raw=raw)


@bad("broken")
def closed_in_body(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        body = b"".join(wire.events(good)) if asked.stream else wire.body(good)
        kind = "text/event-stream" if asked.stream else "application/json"
        wire.head(200, {"Content-Type": kind, "Transfer-Encoding": "chunked"})
        wire.chunk(body[: len(body) // 2])

    return Said(raw=raw)


@bad("broken")
def ended_in_the_middle(asked: Asked, good: Said) -> Said:
    """As if whole to HTTP; half of what was to be said is missing."""

    def raw(wire: Wire) -> None:
        events = wire.events(good)
        body = wire.body(good)
        wire.stream(events[: len(events) // 2]) if asked.stream else wire.document(200, body[: len(body) // 2])

    return Said(raw=raw)


@bad("broken")
def not_http(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.send(b"SSH-2.0-OpenSSH_9.9\r\n\x00\x01\x02"))


@bad("broken")
def switches_protocols(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.head(101, {"Upgrade": "websocket", "Connection": "Upgrade"}))


@bad("broken")
def not_the_encoding_it_says(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(200, wire.body(good), headers={"Content-Encoding": "gzip"}))


@bad("slow")
def silence(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: dripped(wire, b""))


@bad("slow")
def dripped_headers(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: dripped(wire, b"HTTP/1.1 200 OK\r\nX-Slow: " + b"z" * 10_000))


@bad("slow")
def dripped_body(asked: Asked, good: Said) -> Said:
    def raw(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "application/json", "Content-Length": "100000"})
        dripped(wire, b" " * 99_000)

    return Said(raw=raw)


@bad("slow")
def comments_for_ever(asked: Asked, good: Said) -> Said:
    """A stream that keeps itself alive and says nothing."""

    def raw(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "text/event-stream"})
        dripped(wire, b": ping\n\n" * 20_000, at_once=8)

    return Said(raw=raw)


@bad("slow")
def dripped_events(asked: Asked, good: Said) -> Said:
    """A word now and then, for ever: no time-out between bytes ends it."""

    def raw(wire: Wire) -> None:
        wire.head(200, {"Content-Type": "text/event-stream"})
        events = wire.events(Said(text="and so on " * 40))
        for event in events[:2]:
            wire.send(event)
        while not wire.wait(0.1):
            wire.send(events[2])

    return Said(raw=raw)


def dripped(wire: Wire, data: bytes, at_once: int = 1) -> None:
    """A byte at a time until the client or the server leaves; then silence."""
    for i in range(0, len(data), at_once):
        wire.send(data[i : i + at_once])
        if wire.wait(0.1):
            return
    while not wire.wait(0.1):
        pass
