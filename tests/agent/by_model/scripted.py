"""Models that say what a test tells them to, and what they were told."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from pydantic_ai.messages import (
    ModelMessage,
    ModelRequest,
    ModelResponse,
    RetryPromptPart,
    ToolCallPart,
    ToolReturnPart,
    UserPromptPart,
)
from pydantic_ai.models.function import AgentInfo, FunctionModel

from sceneweaver.llm import ModelClient


class Script:
    """A client whose model gives these answers in turn, the last again and again.

    ``refusals`` are what it was told of answers that were refused, ``prompts`` what it was asked.
    """

    def __init__(self, *answers: Any | Callable[[str], Any]) -> None:
        self._answers: Sequence[Any] = answers
        self.prompts: list[str] = []
        self.refusals: list[str] = []
        self.calls = 0
        self.client = ModelClient(FunctionModel(self._answer))

    def _answer(self, messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        said = [part for message in messages if isinstance(message, ModelRequest) for part in message.parts]
        prompts = [p.content for p in said if isinstance(p, UserPromptPart)]
        text = "\n".join(c if isinstance(c, str) else "\n".join(map(str, c)) for c in prompts)
        if text not in self.prompts:
            self.prompts.append(text)
        told = [str(p.content) for p in said if isinstance(p, RetryPromptPart | ToolReturnPart)]
        self.refusals += [line for line in told if line not in self.refusals]
        answer = self._answers[min(self.calls, len(self._answers) - 1)]
        self.calls += 1
        name = info.output_tools[0].name
        return ModelResponse(parts=[ToolCallPart(name, answer(text) if callable(answer) else answer)])
