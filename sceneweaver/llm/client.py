"""One way to ask a model: a purpose, instructions, text and pictures in; a checked, typed answer out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from sceneweaver.scene import InputError, MissingDependencyError

from .errors import ModelError, ModelFailed
from .reply import Picture, Reply

if TYPE_CHECKING:
    from pydantic_ai.models import Model

Answer = TypeVar("Answer", bound=Reply)

RETRIES = 3
"""Times that a model is told what is wrong with its answer, and asked again."""


class ModelClient:
    """Asks one model.

    Args:
        model: a model of pydantic-ai, such as a `FunctionModel` in tests.
    """

    def __init__(self, model: Model) -> None:
        self._model = model

    def ask(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = RETRIES,
    ) -> Answer:
        """One answer.

        Args:
            purpose: short name of what is asked for, such as "plan"; records and budgets name it.
            kind: the type of the answer.
            instructions: what the model is and how it is to answer.
            content: text and pictures, in order. Equal for equal runs: no clock, no paths.
            check: refuses an answer by an `InputError`, whose words the model is told; may give back a mended answer.
            retries: times that it is asked again after an answer that is refused.

        Raises:
            ModelError: when there is no answer that passes.
        """
        try:
            from pydantic_ai import Agent, BinaryContent, ModelRetry, ToolOutput
            from pydantic_ai.exceptions import AgentRunError
        except ImportError:
            raise MissingDependencyError("models need pydantic-ai; pip install 'sceneweaver[llm]'") from None
        agent = Agent(
            self._model,
            output_type=ToolOutput(kind, name="answer", max_retries=retries),
            instructions=instructions,
            retries=retries,
        )

        @agent.output_validator
        def checked(answer: Answer) -> Answer:
            try:
                return (check(answer) if check else None) or answer
            except InputError as error:
                raise ModelRetry(str(error)) from None

        prompt = [
            BinaryContent(part.png, media_type="image/png") if isinstance(part, Picture) else part for part in content
        ]
        try:
            return agent.run_sync(prompt).output
        except AgentRunError as error:
            raise ModelFailed(f"{purpose}: {error}") from None

    def ask_many(
        self,
        purpose: str,
        kind: type[Answer],
        instructions: str,
        content: Sequence[str | Picture],
        *,
        samples: int,
        check: Callable[[Answer], Answer | None] | None = None,
        retries: int = RETRIES,
    ) -> list[Answer | ModelError]:
        """Several independent answers to the same question, side by side; an error in the place of one that failed."""
        found: list[Answer | ModelError] = []
        for _ in range(samples):
            try:
                found.append(self.ask(purpose, kind, instructions, content, check=check, retries=retries))
            except ModelError as error:
                found.append(error)
        return found
