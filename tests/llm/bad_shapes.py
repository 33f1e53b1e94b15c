"""Documents that are JSON, or say so, and are no reply."""

from __future__ import annotations

import json
from typing import Any

from tests.llm.misbehaviour import bad
from tests.llm.said import Asked, Said
from tests.llm.wire import Wire


def document(body: Any) -> Said:
    """This JSON with status 200, whether streamed or not (then as one event)."""

    def raw(wire: Wire) -> None:
        data = body if isinstance(body, bytes) else json.dumps(body).encode()
        if wire.asked.stream:
            wire.stream([b"data: " + data + b"\n\n", b"data: [DONE]\n\n"])
        else:
            wire.document(200, data)

    return Said(raw=raw)


def changed(asked: Asked, good: Said, **fields: Any) -> Said:
    """The good reply with other fields at its top (and of each event)."""

    def raw(wire: Wire) -> None:
        if not asked.stream:
            return wire.document(200, json.dumps(json.loads(wire.body(good)) | fields).encode())
        wire.stream(_event(event, fields) for event in wire.events(good))

    return Said(raw=raw)


def _event(event: bytes, fields: dict[str, Any]) -> bytes:
    head, _, data = event.partition(b"data: ")
    if data.startswith(b"[DONE]"):
        return event
    found = json.loads(data)
    inner = found.get("message")
    found = found | ({"message": inner | fields} if isinstance(inner, dict) else fields)
    return head + b"data: " + json.dumps(found).encode() + b"\n\n"


@bad("shapes")
def no_choices(asked: Asked, good: Said) -> Said:
    return changed(asked, good, choices=[], content=[])


@bad("shapes")
def choices_null(asked: Asked, good: Said) -> Said:
    return changed(asked, good, choices=None, content=None)


@bad("shapes")
def choices_of_numbers(asked: Asked, good: Said) -> Said:
    return changed(asked, good, choices=[1, "two"], content=[1, "two"])


@bad("shapes")
def calls_without_function(asked: Asked, good: Said) -> Said:
    call = {"id": None, "type": "function", "function": None, "index": 0}
    choice = {"index": 0, "message": {"role": "assistant", "tool_calls": [call]}, "delta": {"tool_calls": [call]}}
    return changed(asked, good, choices=[choice], content=[{"type": "tool_use", "id": None, "name": None}])


@bad("shapes")
def usage_of_words(asked: Asked, good: Said) -> Said:
    return changed(asked, good, usage="plenty")


@bad("shapes")
def usage_below_zero(asked: Asked, good: Said) -> Said:
    return Said(good.text, good.calls, tokens=(-1_000_000, -1_000_000))


@bad("shapes")
def usage_without_end(asked: Asked, good: Said) -> Said:
    return Said(good.text, good.calls, tokens=(10**18, 10**18))


@bad("shapes")
def created_far_away(asked: Asked, good: Said) -> Said:
    return changed(asked, good, created=10**18)


@bad("shapes")
def error_with_status_200(asked: Asked, good: Said) -> Said:
    return document({"error": {"message": "no GPU left", "type": "server_error", "code": 500}})


@bad("shapes")
def a_list(asked: Asked, good: Said) -> Said:
    return document([])


@bad("shapes")
def a_null(asked: Asked, good: Said) -> Said:
    return document(None)


@bad("shapes")
def half_a_document(asked: Asked, good: Said) -> Said:
    return document(b'{"id": "chatcmpl-1", "choices": [{"index"')


@bad("shapes")
def not_utf8(asked: Asked, good: Said) -> Said:
    return document(b'{"id": "\xff\xfe\xc3(", "choices": [{"index": 0, "message": {"content": "\xf0\x28\x8c\x28"}}]}')


@bad("shapes")
def empty_document(asked: Asked, good: Said) -> Said:
    return document(b"")
