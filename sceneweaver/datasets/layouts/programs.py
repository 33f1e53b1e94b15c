"""Programs: rooms with their furniture and relations, before anything has a place."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing import current_process, get_context

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.riders import searched
from sceneweaver.assets import Library
from sceneweaver.brief import read_request
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.edits import apply_all
from sceneweaver.scene.threads import cores
from sceneweaver.tools.base import Context
from sceneweaver.tools.registry import tools

from ..requests import Request
from ..spec import Spec

AT_ONCE = 4
"""Programs from which on other processes help to draw them, where a GPU waits for them."""


@dataclass(frozen=True)
class Program:
    """What layouts are wanted of: a scene of boxes and prisms, or the reason why there is none."""

    request: Request
    attempt: int
    scene: Scene | None
    reason: str = ""

    @property
    def seed(self) -> int:
        """What its layouts follow from."""
        return self.request.attempt(self.attempt)


def draw(spec: Spec, attempt: int, request: Request) -> Program:
    """An attempt at the program of a request.

    What stands on furniture is part of its boxes. Scenes of users are taken as they are.
    """
    try:
        if request.scene is not None:
            scene = Scene.load(request.scene)
        else:
            scene = _furnished(request, request.attempt(attempt))
    except InputError as error:
        return Program(request, attempt, None, str(error))
    least, most = spec.rooms.objects
    if not least <= len(scene.objects) <= most:
        return Program(request, attempt, None, f"{len(scene.objects)} objects, not {least} to {most}")
    return Program(request, attempt, scene)


def draw_all(spec: Spec, attempts: Sequence[tuple[Request, int]], device: str) -> list[Program]:
    """The programs of some attempts, drawn by other processes as well where a GPU would wait for them."""
    helpers = min(cores(), len(attempts))
    if device == "cpu" or len(attempts) < AT_ONCE or helpers < 2 or current_process().daemon:
        return [draw(spec, attempt, request) for request, attempt in attempts]
    with ProcessPoolExecutor(helpers, mp_context=get_context("spawn")) as pool:
        return list(pool.map(partial(_draw_one, spec), attempts, chunksize=2))


def _draw_one(spec: Spec, one: tuple[Request, int]) -> Program:
    request, attempt = one
    return draw(spec, attempt, request)


@cache
def _library() -> Library:
    return Library()


def _furnished(request: Request, seed: int) -> Scene:
    """The room of a request as the search sees it."""
    brief = read_request(request.prompt)
    kind, _ = chosen_room(brief)
    context = Context(brief, kind, empty_scene(brief, kind), _library(), seed)
    proposal = tools()["init_prior"].load().propose(context)
    assert proposal.scene is not None
    scene = apply_all(proposal.scene, proposal.edits)[0]
    if proposal.variants:
        chosen = proposal.variants[seed % len(proposal.variants)]
        scene = scene.model_copy(update={"relations": (*scene.relations, *chosen)})
    return searched(scene)
