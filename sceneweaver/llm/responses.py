"""Replies and requests of pydantic-ai as what we keep of them: without secrets, as JSON data, counted."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .plain import sendable
from .secrets import line, redact

if TYPE_CHECKING:
    from pydantic_ai.messages import ModelMessage, ModelResponse


def natural(value: object) -> int:
    """A number of tokens that a server tells; one below zero would buy back what is spent."""
    return value if isinstance(value, int) and value > 0 else 0


def cleaned(response: ModelResponse) -> ModelResponse:
    """A reply without secrets, and without what it does not need: a server may echo a key anywhere."""
    from pydantic_ai.messages import TextPart, ThinkingPart, ToolCallPart

    parts: list[Any] = []
    for part in response.parts:
        if isinstance(part, TextPart | ThinkingPart):
            parts.append(replace(part, content=sendable(redact(part.content))))
        elif isinstance(part, ToolCallPart):
            name, identity = sendable(redact(part.tool_name)), sendable(redact(part.tool_call_id))
            parts.append(replace(part, tool_name=name, args=sendable(redact(part.args)), tool_call_id=identity))
    return replace(response, parts=parts, provider_details=redact(response.provider_details))


def as_data(response: ModelResponse) -> dict[str, Any]:
    """A reply as JSON data."""
    from pydantic_ai.messages import TextPart, ThinkingPart, ToolCallPart

    said: list[dict[str, Any]] = []
    for part in response.parts:
        if isinstance(part, TextPart):
            said.append({"text": part.content})
        elif isinstance(part, ThinkingPart):
            said.append({"thinking": part.content})
        elif isinstance(part, ToolCallPart):
            said.append({"tool": part.tool_name, "arguments": part.args})
    raw: dict[str, Any] = {"reply": said, "finish": response.finish_reason}
    if said_no := (response.provider_details or {}).get("refusal"):
        raw["refusal"] = said_no
    return raw


def refusal(response: ModelResponse) -> str:
    """The words of a refusal, after a colon; "" when there are none."""
    words = line((response.provider_details or {}).get("refusal") or "", 150)
    return f": {words}" if words else ""


def told(messages: Sequence[ModelMessage]) -> str:
    """What the model is told about its last answer; "" for a first request."""
    if len(messages) < 2:
        return ""
    words: list[str] = []
    for part in messages[-1].parts:
        content = getattr(part, "content", None)
        if content is not None:
            words.append(content if isinstance(content, str) else json.dumps(content, default=str))
    return redact("\n".join(words))


def length(message: ModelMessage | ModelResponse) -> int:
    """Characters of a message; a picture counts as 4000, about a thousand tokens."""
    size = len(getattr(message, "instructions", None) or "")
    for part in message.parts:
        content = getattr(part, "content", None) or getattr(part, "args", None) or ""
        items = content if isinstance(content, list | tuple) else [content]
        size += sum(4000 if hasattr(item, "data") else len(str(item)) for item in items)
    return size
