"""What a tool is: it reads the scene so far and an instruction, and answers with typed edits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from sceneweaver.generate.setup import Proposal as Proposal
from sceneweaver.generate.setup import Setup
from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.llm import ModelClient

from .beginning import Beginning


@dataclass(frozen=True)
class Context(Setup):
    """What a tool may read.

    ``scene`` is the scene so far (for an initialiser an empty one, whose room may be replaced); ``seed`` decides all
    that is drawn; ``instruction`` is a sentence, ``inputs`` what the tool's card asks for. ``hurried`` says whether
    much of the time is over: what could be drawn once more is then left as it is. ``clutter`` in 0..1 is how lived-in
    the room should look. ``client`` asks a model; None: there is none, and a tool that needs one says so.
    ``beginning`` says where scenes to begin with come from.
    """

    instruction: str = ""
    inputs: Mapping[str, Any] = field(default_factory=dict)
    hurried: Callable[[], bool] = bool
    clutter: float = CLUTTER
    client: ModelClient | None = None
    beginning: Beginning = Beginning()


class Tool(Protocol):
    """A tool. Its name is that of its card; it proposes and never solves poses for the room."""

    name: str

    def propose(self, context: Context) -> Proposal:
        """Answer an instruction; InputError for inputs that its card forbids or that name what is not there."""
        ...
