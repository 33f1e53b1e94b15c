"""What a scripted model is asked and what it says, whatever the protocol."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel

if TYPE_CHECKING:
    from tests.llm.wire import Wire


@dataclass(frozen=True)
class Asked:
    """One request.

    Attributes:
        api: "chat" (OpenAI chat completions) or "messages" (Anthropic).
        headers: names in lower case.
        model: name of the model.
        messages: as they came.
        instructions: text of the system prompt.
        text: all text of the user, in order, without what it is told about refused answers.
        told: what it was told about its answers so far (results of tools, calls to try again), the oldest first.
        pictures: bytes of the pictures, in order.
        tools: name of each tool -> JSON schema of its arguments.
        answer_schema: schema of the answer that is asked for: of the output tool, or of `response_format`.
        as_text: whether the answer is to be text (`response_format`, or no tools at all) rather than a call.
        stream: whether it is to be streamed.
        ordinal: 0 for the first request to this server.
        body: the whole request.
    """

    api: str
    headers: dict[str, str] = field(repr=False)
    model: str
    messages: list[dict[str, Any]]
    instructions: str
    text: str
    told: list[str]
    pictures: list[bytes]
    tools: dict[str, dict[str, Any]]
    answer_schema: dict[str, Any]
    as_text: bool
    stream: bool
    ordinal: int
    body: dict[str, Any] = field(repr=False)

    def wants(self, kind: type[BaseModel]) -> bool:
        """Whether the answer that is asked for has the fields of this type: purposes themselves are not sent."""
        names = set(kind.model_json_schema(by_alias=True).get("properties", {}))
        return set(self.answer_schema.get("properties", {})) == names


@dataclass(frozen=True)
class Said:
    """One reply.

    Attributes:
        text: what it says in words.
        calls: tools that it calls, each with arguments: a mapping, or any text, sent as it is.
        refusal: a refusal in words (`refusal` in chat completions, stop reason "refusal" in messages).
        finish: why it stopped, in the words of the protocol; "" for what is usual for the rest.
        tokens: in and out.
        raw: does what it likes with the connection; nothing else is sent then.
    """

    text: str = ""
    calls: tuple[tuple[str, Mapping[str, Any] | str], ...] = ()
    refusal: str = ""
    finish: str = ""
    tokens: tuple[int, int] = (100, 20)
    raw: Callable[[Wire], None] | None = None


Script = Callable[[Asked], Said]


def schema_of(instructions: str, *schemas: dict[str, Any]) -> dict[str, Any]:
    """The schema of the answer: the first that is given, or one that the instructions print."""
    for schema in (*schemas, *_printed(instructions)):
        if schema:
            name = schema.get("$ref", "").removeprefix("#/$defs/")
            return schema.get("$defs", {}).get(name, schema)
    return {}


def _printed(instructions: str) -> Iterator[dict[str, Any]]:
    for start in (match.start() for match in re.finditer(r"^\{", instructions, re.MULTILINE)):
        try:
            found = json.JSONDecoder().raw_decode(instructions, start)[0]
        except ValueError:
            continue
        if "properties" in found or "$ref" in found:
            yield found


ANSWER = "answer"
"""Name of the tool that answers."""


def says(answer: Any, asked: Asked) -> Said:
    """A `Said` from anything: itself, a model of pydantic or a mapping (a call of the output tool, or the same as text
    where text is asked for), or a text."""
    if isinstance(answer, Said):
        return answer
    if isinstance(answer, str):
        return Said(text=answer)
    data = answer.model_dump(mode="json", by_alias=True) if isinstance(answer, BaseModel) else dict(answer)
    if asked.as_text:
        return Said(text=json.dumps(data))
    return Said(calls=((output_tool(asked), data),))


def output_tool(asked: Asked) -> str:
    """Name of the tool that answers this request."""
    return ANSWER if ANSWER in asked.tools or not asked.tools else next(iter(asked.tools))


def answering(replies: Mapping[Any, Any] | Callable[[Asked], Any], otherwise: Any = None) -> Script:
    """A script from replies.

    Args:
        replies: a function of what was asked; or replies by what is asked for: the type of the answer (matched by its
            fields), or a phrase of the instructions. A reply is anything that `says` takes, a function that gives one,
            or a list of these: one after the other, the last one for ever.
        otherwise: the reply where none of them fits; without it that is an error of the script (status 400, and
            raised when the server is left).
    """
    turns: dict[int, int] = {}

    def resolved(reply: Any, asked: Asked) -> Said:
        if isinstance(reply, list):
            turn = turns.get(id(reply), 0)
            turns[id(reply)] = turn + 1
            reply = reply[min(turn, len(reply) - 1)]
        return says(reply(asked) if callable(reply) else reply, asked)

    def script(asked: Asked) -> Said:
        if callable(replies):
            return says(replies(asked), asked)
        for key, reply in replies.items():
            if key in asked.instructions if isinstance(key, str) else asked.wants(key):
                return resolved(reply, asked)
        if otherwise is None:
            fields = sorted(asked.answer_schema.get("properties", {}))
            raise LookupError(f"no reply for an answer with the fields {fields}: {asked.instructions[:200]}")
        return resolved(otherwise, asked)

    return script
