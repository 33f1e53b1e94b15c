"""What a tool is: it reads the scene so far and an instruction, and answers with typed edits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from sceneweaver.generate.setup import Setup
from sceneweaver.knowledge.lived_in import CLUTTER
from sceneweaver.llm import ModelClient
from sceneweaver.scene import Relation, Room, Scene
from sceneweaver.scene.edits import AnyEdit


@dataclass(frozen=True)
class Context(Setup):
    """What a tool may read.

    ``scene`` is the scene so far (for an initialiser an empty one, whose room may be replaced); ``seed`` decides all
    that is drawn; ``instruction`` is a sentence, ``inputs`` what the tool's card asks for. ``hurried`` says whether
    much of the time is over: what could be drawn once more is then left as it is. ``clutter`` in 0..1 is how lived-in
    the room should look. ``client`` asks a model; None: there is none, and a tool that needs one says so.
    """

    instruction: str = ""
    inputs: Mapping[str, Any] = field(default_factory=dict)
    hurried: Callable[[], bool] = bool
    clutter: float = CLUTTER
    client: ModelClient | None = None


@dataclass(frozen=True)
class Proposal:
    """What a tool answers.

    ``scene`` replaces the whole scene (initialisers only), then ``edits`` apply to it in order. Poses in edits are
    proposals: the executor refines them. Each of ``variants`` holds relations that are added to the scene's; of the
    layouts of all variants the best wins. ``rooms`` are others for the same things, with as many walls, doors and
    windows: where the scene's own does not do, the best is taken; ``larger`` ones are for what was asked for and has
    no place. ``notes`` say what was decided, ``unmet`` what could not be done and why. ``fresh`` asks for a layout from
    scratch instead of the least movement.
    """

    edits: tuple[AnyEdit, ...] = ()
    scene: Scene | None = None
    variants: tuple[tuple[Relation, ...], ...] = ()
    rooms: tuple[Room, ...] = ()
    larger: tuple[Room, ...] = ()
    fresh: bool = False
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()


class Tool(Protocol):
    """A tool. Its name is that of its card; it proposes and never solves poses for the room."""

    name: str

    def propose(self, context: Context) -> Proposal:
        """Answer an instruction; InputError for inputs that its card forbids or that name what is not there."""
        ...
