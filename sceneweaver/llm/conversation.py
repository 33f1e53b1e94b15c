"""One question until its answer passes: asked, validated, told what is wrong, asked again."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from pydantic import ValidationError

from sceneweaver.scene import InputError

from .attempts import CALL, Account, Requests
from .endpoint import Answers
from .errors import BudgetSpent, ModelError, ModelFailed, ModelUnreachable
from .faults import fault
from .plain import plain
from .records import Record
from .reply import Reply
from .secrets import line, redact
from .waiting import CallQueue

if TYPE_CHECKING:
    from pydantic_ai import Agent
    from pydantic_ai.messages import ModelResponse
    from pydantic_ai.models import Model

Answer = TypeVar("Answer", bound=Reply)

ERRORS: dict[str, type[ModelError]] = {
    error.__name__: error for error in (ModelError, ModelFailed, ModelUnreachable, BudgetSpent)
}
"""Errors by the names that records give them."""

TEMPLATE = (
    "Answer with one JSON object that follows this JSON schema, and with nothing else: no words, no code fence.\n\n"
    "{schema}"
)
"""How a model without function calling is asked for data."""


class Conversation(Generic[Answer]):
    """Asks one question.

    Args:
        model: what is asked.
        account: budget of the run.
        record: gets the attempts and the outcome.
        kind: type of the answer.
        check: what the caller makes of an answer.
        retries: times that it is asked again after an answer that is refused.
        answers: how structured answers are asked for.
        stream: whether replies come in pieces.
        pictures: whether pictures are sent.
        calls: functions that the caller's thread is to call.
    """

    def __init__(
        self,
        model: Model,
        account: Account,
        record: Record,
        kind: type[Answer],
        check: Callable[[Answer], Answer | None] | None,
        *,
        retries: int,
        answers: Answers,
        stream: bool,
        pictures: bool,
        calls: CallQueue,
    ) -> None:
        self._account, self._record, self._kind, self._check = account, record, kind, check
        self._retries, self._answers, self._pictures, self._calls = retries, answers, pictures, calls
        self._requests = Requests(model, account, record, stream)
        self._model = model
        self._refused = ""

    async def run(self) -> Answer | None:
        """The answer as `check` left it; None when there is none, and `record.failure` says why. Raises nothing."""
        try:
            return (await self._agent().run(self._prompt())).output
        except ModelError as error:
            self._failed(error)
        except Exception as error:
            self._failed(ModelFailed(self._words(error)))
        return None

    def _agent(self) -> Agent[object, Answer]:
        from pydantic_ai import Agent, ModelRetry, NativeOutput, PromptedOutput, ToolOutput

        output: Any = {
            "tool": lambda: ToolOutput(self._kind, name=CALL, max_retries=self._retries),
            "native": lambda: NativeOutput(self._kind, name=CALL),
            "prompted": lambda: PromptedOutput(self._kind, template=TEMPLATE),
        }[self._answers]()
        agent: Agent[object, Answer] = Agent(
            _metered(self._model, self._requests, self._answers == "tool"),
            output_type=output,
            instructions=self._record.asked.instructions,
            retries=self._retries,
            name=CALL,
        )
        agent.instrument = False  # no telemetry of prompts, whatever else in the process has turned it on

        @agent.output_validator
        async def checked(answer: Answer) -> Answer:
            data, passed, words = await self._calls.call(lambda: accepted(answer, self._kind, self._check))
            self._record.attempts[-1]["answer"] = data
            if passed is None:
                self._refused = self._record.attempts[-1]["refused"] = words
                raise ModelRetry(words)
            self._record.answer = data
            return passed

        return agent

    def _prompt(self) -> list[Any]:
        """Text and pictures as pydantic-ai takes them; without pictures where the model takes none."""
        from pydantic_ai import BinaryContent

        prompt: list[Any] = []
        for part in self._record.asked.content:
            if isinstance(part, str):
                prompt.append(part)
            elif self._pictures:
                prompt.extend([f"Picture: {part.title}"] if part.title else [])
                prompt.append(BinaryContent(part.png, media_type="image/png"))
        return prompt

    def _failed(self, error: ModelError) -> None:
        self._record.answer = None
        self._record.failure = {
            "class": type(error).__name__,
            "words": line(f"{self._record.asked.purpose}: {error}", 400),
        }

    def _words(self, error: Exception) -> str:
        """Why pydantic-ai gave up."""
        from pydantic_ai.exceptions import OutputTokenLimitExceeded, UnexpectedModelBehavior

        if isinstance(error, OutputTokenLimitExceeded):
            return "the answer is longer than the endpoint lets it be; set SCENEWEAVER_MODEL_MAX_TOKENS"
        if isinstance(error, UnexpectedModelBehavior):
            last = self._refused or line(error.__cause__ or error.message.partition(", body")[0], 200)
            return f"no answer passed in {len(self._record.attempts)} replies; the last: {last}"
        return fault(error, self._account.endpoint).words


def error_of(record: Record) -> ModelError:
    """The error of a record without an answer."""
    failure = record.failure
    return ERRORS.get(failure.get("class", ""), ModelFailed)(failure.get("words", f"{record.asked.purpose}: no answer"))


def accepted(
    answer: Reply, kind: type[Answer], check: Callable[[Answer], Answer | None] | None
) -> tuple[dict[str, Any] | None, Answer | None, str]:
    """An answer as JSON data, and as the caller's check leaves it; or None and what is wrong with it.

    It goes through JSON first, as one from a record does, so that both are equal.
    """
    data: dict[str, Any] | None = None
    try:
        data = plain(redact(answer.model_dump(mode="json", by_alias=True)))
        read = kind.model_validate(data)
        return data, (check(read) if check else None) or read, ""
    except ValidationError as error:
        return data, None, "; ".join(f"{'.'.join(map(str, row['loc']))}: {row['msg']}" for row in error.errors()[:5])
    except InputError as error:
        return data, None, redact(str(error))


def _metered(model: Model, requests: Requests, mend: bool) -> Any:
    """A model whose requests go through `Requests`."""
    from pydantic_ai.models.wrapper import WrapperModel

    class Metered(WrapperModel):
        async def request(self, messages: Any, model_settings: Any, model_request_parameters: Any) -> ModelResponse:
            response = await requests.reply(messages, model_settings, model_request_parameters)
            return _as_call(response) if mend else response

    return Metered(model)


def _as_call(response: ModelResponse) -> ModelResponse:
    """A reply that writes the arguments of the function as text, as small models do, as the call that it stands for."""
    from pydantic_ai.messages import TextPart, ToolCallPart

    texts = [part for part in response.parts if isinstance(part, TextPart)]
    if len(texts) != 1 or any(isinstance(part, ToolCallPart) for part in response.parts):
        return response
    text = texts[0].content.strip()
    fenced = re.findall(r"```(?:json)?\s*(\{.*?\})\s*```", text, re.DOTALL)
    text = fenced[0] if len(fenced) == 1 else text
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        return response
    if not isinstance(data, dict):
        return response
    response.parts = [part for part in response.parts if part is not texts[0]]
    response.parts = [*response.parts, ToolCallPart(CALL, text, tool_call_id="text")]
    return response
