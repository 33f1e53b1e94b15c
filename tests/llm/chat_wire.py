"""OpenAI chat completions: requests read, replies written."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import Any

from tests.llm.said import ANSWER, Asked, Said, schema_of

PIECE = 24
"""Characters of text or arguments in one event of a stream."""


def read(body: dict[str, Any], headers: dict[str, str], ordinal: int) -> Asked:
    instructions, text, told, pictures = [], [], [], []
    answered = False
    for message in body["messages"]:
        answered = answered or message["role"] == "assistant"
        content: Any = message.get("content") or []
        parts: list[dict[str, Any]] = [{"type": "text", "text": content}] if isinstance(content, str) else content
        if message["role"] in ("system", "developer"):
            instructions += [part["text"] for part in parts]
        elif message["role"] == "tool":
            told += [part["text"] for part in parts]
        elif message["role"] == "user":
            for part in parts:
                if part["type"] == "text":
                    (told if answered else text).append(part["text"])
                elif part["type"] == "image_url":
                    pictures.append(data_url(part["image_url"]["url"]))
                else:
                    raise ValueError(f"a part of type {part['type']}")
    tools = {tool["function"]["name"]: tool["function"].get("parameters", {}) for tool in body.get("tools", [])}
    form = (body.get("response_format") or {}).get("json_schema", {}).get("schema", {})
    return Asked(
        api="chat",
        headers=headers,
        model=body["model"],
        messages=body["messages"],
        instructions="\n".join(instructions),
        text="\n".join(text),
        told=told,
        pictures=pictures,
        tools=tools,
        answer_schema=schema_of("\n".join(instructions), tools.get(ANSWER, {}), form, *tools.values()),
        as_text="response_format" in body or not tools,
        stream=bool(body.get("stream")),
        ordinal=ordinal,
        body=body,
    )


def data_url(url: str) -> bytes:
    """Bytes of a data URL.

    Raises:
        ValueError: when it is none, or not of a picture.
    """
    head, _, data = url.partition(",")
    if not head.startswith("data:image/") or not head.endswith(";base64"):
        raise ValueError(f"not a picture as a data URL: {url[:60]}")
    return base64.b64decode(data, validate=True)


def whole(said: Said, asked: Asked) -> dict[str, Any]:
    """The body of a reply that is not streamed."""
    calls = [_call(i, name, arguments, asked) for i, (name, arguments) in enumerate(said.calls)]
    message = {"role": "assistant", "content": said.text or None, "refusal": said.refusal or None}
    return _frame("chat.completion", asked) | {
        "choices": [
            {
                "index": 0,
                "message": message | ({"tool_calls": calls} if calls else {}),
                "logprobs": None,
                "finish_reason": _finish(said),
            }
        ],
        "usage": _usage(said),
    }


def events(said: Said, asked: Asked) -> Iterator[bytes]:
    """The events of a reply that is streamed, `[DONE]` the last."""
    frame = _frame("chat.completion.chunk", asked)
    for delta in _deltas(said, asked):
        yield _event(frame | {"choices": [{"index": 0, "delta": delta, "finish_reason": None}]})
    yield _event(frame | {"choices": [{"index": 0, "delta": {}, "finish_reason": _finish(said)}]})
    if (asked.body.get("stream_options") or {}).get("include_usage"):
        yield _event(frame | {"choices": [], "usage": _usage(said)})
    yield b"data: [DONE]\n\n"


def _deltas(said: Said, asked: Asked) -> Iterator[dict[str, Any]]:
    yield {"role": "assistant", "content": "" if said.text else None}
    yield from ({"content": piece} for piece in pieces(said.text))
    yield from ({"refusal": piece} for piece in pieces(said.refusal))
    for i, (name, arguments) in enumerate(said.calls):
        call = _call(i, name, arguments, asked)
        words = call["function"]["arguments"]
        call["function"]["arguments"] = ""
        yield {"tool_calls": [call | {"index": i}]}
        yield from ({"tool_calls": [{"index": i, "function": {"arguments": piece}}]} for piece in pieces(words))


def _event(data: dict[str, Any]) -> bytes:
    return b"data: " + json.dumps(data).encode() + b"\n\n"


def error(status: int, message: str) -> dict[str, Any]:
    kind = "rate_limit_error" if status == 429 else "server_error" if status >= 500 else "invalid_request_error"
    return {"error": {"message": message, "type": kind, "param": None, "code": None}}


def pieces(text: str) -> list[str]:
    """Text in pieces, as tokens come."""
    step = max(PIECE, len(text) // 200)
    return [text[i : i + step] for i in range(0, len(text), step)]


def _frame(kind: str, asked: Asked) -> dict[str, Any]:
    return {"id": f"chatcmpl-{asked.ordinal}", "object": kind, "created": 1_700_000_000, "model": asked.model}


def _call(index: int, name: str, arguments: Any, asked: Asked) -> dict[str, Any]:
    words = arguments if isinstance(arguments, str) else json.dumps(arguments)
    return {
        "id": f"call_{asked.ordinal}_{index}",
        "type": "function",
        "function": {"name": name, "arguments": words},
    }


def _finish(said: Said) -> str:
    return said.finish or ("tool_calls" if said.calls else "stop")


def _usage(said: Said) -> dict[str, int]:
    asked, answered = said.tokens
    return {"prompt_tokens": asked, "completion_tokens": answered, "total_tokens": asked + answered}
