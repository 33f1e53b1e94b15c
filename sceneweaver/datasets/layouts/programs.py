"""Programs: rooms with their furniture and relations, before anything has a place."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing import current_process

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.riders import searched
from sceneweaver.assets import Library
from sceneweaver.language import read_request
from sceneweaver.runtime.processes import pool
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.base import Context
from sceneweaver.tools.registry import tools

from ..requests import Request
from ..spec import Spec

AT_ONCE = 8
"""Programs from which on other processes draw them."""


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


Draw = Callable[[Sequence[tuple[Request, int]]], list[Program]]
"""What draws the programs of some attempts, in their order."""


@contextmanager
def drawing(spec: Spec, requests: Sequence[Request]) -> Iterator[Draw]:
    """What draws programs of some requests, attempt after attempt.

    Other processes do it where there are many and this is not one of several workers; they stay until the end, since
    to begin one costs as much as to draw ten programs.
    """
    helpers = min(cores(), sum(request.scene is None for request in requests))
    if len(requests) < AT_ONCE or helpers < 2 or current_process().daemon:
        yield lambda attempts: [draw(spec, attempt, request) for request, attempt in attempts]
        return
    with pool(helpers) as processes:
        yield lambda attempts: list(processes.map(partial(_draw_one, spec), attempts))


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
    return as_tall_as_it_stands(searched(scene))


def as_tall_as_it_stands(scene: Scene) -> Scene:
    """The scene with sizes that reach up to what stands on things, which is part of them.

    By these sizes a search keeps a shelf above a counter; the judge keeps it above all parts of the counter.
    """
    tops = [max(part.z[1] for part in o.solids) for o in scene.objects]
    return scene.model_copy(
        update={
            "objects": tuple(
                o.model_copy(update={"size": (*o.size[:2], top)}) if top > o.size[2] else o
                for o, top in zip(scene.objects, tops, strict=True)
            )
        }
    )
