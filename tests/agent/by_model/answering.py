"""Models for tests that answer with what they are given."""

from __future__ import annotations

import json
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


class Answering:
    """Answers with one piece of data after the other, the last of them again and again; keeps what it is told."""

    def __init__(self, *answers: Any) -> None:
        self.answers, self.told, self.asked, self.calls = answers, [], "", 0

    def __call__(self, messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        last = messages[-1]
        assert isinstance(last, ModelRequest)
        for part in last.parts:
            if isinstance(part, RetryPromptPart | ToolReturnPart):
                self.told.append(str(part.content))
            elif isinstance(part, UserPromptPart):
                self.asked = str(part.content)
        answer = self.answers[min(self.calls, len(self.answers) - 1)]
        self.calls += 1
        if isinstance(answer, Exception):
            raise answer
        return ModelResponse(parts=[ToolCallPart(info.output_tools[0].name, json.loads(json.dumps(answer)))])

    @property
    def client(self) -> ModelClient:
        """A client that asks it."""
        return ModelClient(FunctionModel(self))
