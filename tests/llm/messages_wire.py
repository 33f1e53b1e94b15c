"""Anthropic messages: requests read, replies written."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import Any

from tests.llm.chat_wire import pieces
from tests.llm.said import ANSWER, Asked, Said, schema_of


def read(body: dict[str, Any], headers: dict[str, str], ordinal: int) -> Asked:
    if not isinstance(body["max_tokens"], int):
        raise ValueError("max_tokens is no whole number")
    system = body.get("system") or []
    system = [{"text": system}] if isinstance(system, str) else system
    text, told, pictures = [], [], []
    answered = False
    for message in body["messages"]:
        answered = answered or message["role"] == "assistant"
        if message["role"] == "user":
            for part in _parts(message):
                _take(part, told if answered else text, told, pictures)
    tools = {tool["name"]: tool.get("input_schema", {}) for tool in body.get("tools", [])}
    form = ((body.get("output_config") or {}).get("format") or body.get("output_format") or {}).get("schema", {})
    instructions = "\n".join(part["text"] for part in system)
    return Asked(
        api="messages",
        headers=headers,
        model=body["model"],
        messages=body["messages"],
        instructions=instructions,
        text="\n".join(text),
        told=told,
        pictures=pictures,
        tools=tools,
        answer_schema=schema_of(instructions, tools.get(ANSWER, {}), form, *tools.values()),
        as_text=bool(form) or not tools,
        stream=bool(body.get("stream")),
        ordinal=ordinal,
        body=body,
    )


def whole(said: Said, asked: Asked) -> dict[str, Any]:
    """The body of a reply that is not streamed."""
    return _frame(asked) | {
        "content": _blocks(said, asked),
        "stop_reason": _stop(said),
        "usage": {"input_tokens": said.tokens[0], "output_tokens": said.tokens[1]},
    }


def events(said: Said, asked: Asked) -> Iterator[bytes]:
    """The events of a reply that is streamed, `message_stop` the last."""
    for event in _events(said, asked):
        yield f"event: {event['type']}\ndata: {json.dumps(event)}\n\n".encode()


def _events(said: Said, asked: Asked) -> Iterator[dict[str, Any]]:
    start = _frame(asked) | {"content": [], "usage": {"input_tokens": said.tokens[0], "output_tokens": 1}}
    yield {"type": "message_start", "message": start}
    yield {"type": "ping"}
    for i, block in enumerate(_blocks(said, asked, raw=True)):
        if block["type"] == "text":
            empty, key, kind, words = block | {"text": ""}, "text", "text_delta", block["text"]
        else:
            empty, key, kind, words = block | {"input": {}}, "partial_json", "input_json_delta", block["input"]
        yield {"type": "content_block_start", "index": i, "content_block": empty}
        for piece in pieces(words):
            yield {"type": "content_block_delta", "index": i, "delta": {"type": kind, key: piece}}
        yield {"type": "content_block_stop", "index": i}
    delta = {"stop_reason": _stop(said), "stop_sequence": None}
    yield {"type": "message_delta", "delta": delta, "usage": {"output_tokens": said.tokens[1]}}
    yield {"type": "message_stop"}


def error(status: int, message: str) -> dict[str, Any]:
    kinds = {401: "authentication_error", 404: "not_found_error", 429: "rate_limit_error", 529: "overloaded_error"}
    kind = kinds.get(status, "api_error" if status >= 500 else "invalid_request_error")
    return {"type": "error", "error": {"type": kind, "message": message}, "request_id": "req_0"}


def _parts(message: dict[str, Any]) -> list[dict[str, Any]]:
    content = message["content"]
    return [{"type": "text", "text": content}] if isinstance(content, str) else content


def _take(part: dict[str, Any], words: list[str], told: list[str], pictures: list[bytes]) -> None:
    if part["type"] == "text":
        words.append(part["text"])
    elif part["type"] == "tool_result":
        content = part.get("content") or ""
        told += [content] if isinstance(content, str) else [piece["text"] for piece in content]
    elif part["type"] == "image":
        source = part["source"]
        if source["type"] != "base64" or not source["media_type"].startswith("image/"):
            raise ValueError(f"not a picture: {source['type']} {source.get('media_type')}")
        pictures.append(base64.b64decode(source["data"], validate=True))
    else:
        raise ValueError(f"a part of type {part['type']}")


def _frame(asked: Asked) -> dict[str, Any]:
    return {
        "id": f"msg_{asked.ordinal}",
        "type": "message",
        "role": "assistant",
        "model": asked.model,
        "stop_reason": None,
        "stop_sequence": None,
    }


def _blocks(said: Said, asked: Asked, raw: bool = False) -> list[dict[str, Any]]:
    blocks: list[dict[str, Any]] = []
    if said.text or said.refusal:
        blocks.append({"type": "text", "text": said.text or said.refusal})
    for i, (name, arguments) in enumerate(said.calls):
        words = arguments if isinstance(arguments, str) else json.dumps(arguments)
        tool_input = words if raw else _object(words)
        blocks.append({"type": "tool_use", "id": f"toolu_{asked.ordinal}_{i}", "name": name, "input": tool_input})
    return blocks


def _object(words: str) -> Any:
    """Arguments are JSON in JSON there: broken text can only be sent as a string."""
    try:
        return json.loads(words)
    except (ValueError, RecursionError):
        return words


def _stop(said: Said) -> str:
    chat = {"length": "max_tokens", "content_filter": "refusal", "stop": "end_turn", "tool_calls": "tool_use"}
    usual = "refusal" if said.refusal else "tool_use" if said.calls else "end_turn"
    return chat.get(said.finish, said.finish) or usual
