"""What each request asks for, as a room that is not laid out yet."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.agent.design import LONGEST, chosen_room
from sceneweaver.agent.executor import Executor
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import Library
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context, Proposal
from sceneweaver.tools.init_prior import InitPrior

from ..requests import Request
from ..spec import Spec


@dataclass(frozen=True)
class Draft:
    """A room with all that it is to hold.

    Attributes:
        request: what it answers.
        proposal: the room, its furniture and relations, none of them placed.
        executor: judges and searches for this room.
        context: what tools may look at.
        notes: what was assumed.
    """

    request: Request
    proposal: Proposal
    executor: Executor
    context: Context
    notes: tuple[str, ...]

    @property
    def scene(self) -> Scene:
        """The scene of the proposal; its poses mean nothing."""
        assert self.proposal.scene is not None
        return self.proposal.scene

    @property
    def seed(self) -> int:
        """What all draws of this attempt follow from."""
        return self.context.seed


def drafted(spec: Spec, request: Request, seed: int, library: Library, device: str) -> Draft:
    """The room that a request asks for, drawn from a seed.

    Raises:
        InputError: a request that says nothing.
    """
    brief = read_request(request.prompt[:LONGEST])
    room_type, remarks = chosen_room(brief)
    settings = Settings(
        seed=seed,
        candidates=spec.rooms.candidates,
        device=device,
        seconds=None,
        clutter=request.clutter,
        generations=0,
    )
    context = Context(brief, room_type, empty_scene(brief, room_type), library, seed, clutter=request.clutter)
    proposal = InitPrior().propose(context)
    return Draft(request, proposal, Executor(room_type, brief, settings, library), context, remarks)
