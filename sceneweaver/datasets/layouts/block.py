"""A block of programs with their layouts, written whole or not at all."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing import current_process
from pathlib import Path
from typing import Any

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.riders import searched
from sceneweaver.assets import Library
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.io import read_bytes, write_atomic
from sceneweaver.language import read_request
from sceneweaver.layout.compile import CompiledScene, compile_scene
from sceneweaver.layout.devices import pick_devices
from sceneweaver.layout.sampling import Drawn, first_layouts, joined
from sceneweaver.runtime.processes import pool
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.base import Context
from sceneweaver.tools.registry import tools

from ..requests import Request, Requests
from ..samples import ROWS, SECONDS, scene_columns, whole_folder
from ..spec import Spec
from ..tables import write_lines
from .collect import Collection, collect
from .tables import Writers, row_groups, schema, tables

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


def draw(spec: Spec, one: tuple[Request, int]) -> Program:
    """An attempt at the program of a request.

    What stands on furniture is part of its boxes. Scenes of users are taken as they are, but for free floor: rows have
    the poses of objects alone.
    """
    request, attempt = one
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
    return Program(request, attempt, scene.model_copy(update={"free_areas": ()}) if scene.free_areas else scene)


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
        yield lambda attempts: [draw(spec, one) for one in attempts]
        return
    with pool(helpers) as processes:
        yield lambda attempts: list(processes.map(partial(draw, spec), attempts))


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


ATTEMPTS = {"cpu": 4, "gpu": 20}
"""How often each of the first layouts is begun anew; attempts on a GPU are shorter."""

PROBE = 12
"""Layouts of a program that are searched on a CPU before all the others; one without a valid layout is given up."""

LEAST_FIRST = 2
"""Valid layouts among the first ones that a program needs to be taken."""


@dataclass(frozen=True)
class Taken:
    """A program that layouts are made of, with the first of them."""

    program: Program
    scene: CompiledScene
    first: Drawn


def write_programs(
    path: Path, requests: Requests, chosen: Sequence[Request], device: str, failed: Mapping[int, str] | None = None
) -> None:
    """Write some programs and their layouts, unless they are there.

    Args:
        path: the folder that they lie in, which is there as soon as it is whole.
        requests: what is asked for, with its specification.
        chosen: the programs.
        device: where layouts are made.
        failed: why programs are not even tried, by room.
    """
    if path.exists():
        return
    where, given_up = pick_devices(device)[0], failed or {}
    with whole_folder(path) as draft, Writers(draft, schema(width(requests))) as writers:
        tried = [request for request in chosen if request.room not in given_up]
        found = {row["room"]: (row, times) for row, times in _made(requests.spec, tried, writers, where)}
        for request in chosen:
            if request.room in given_up:
                reason = given_up[request.room]
                row = _base(Program(request, 0, None)) | {"status": "failed", "reason": reason}
                found[request.room] = row, {"index": request.index}
        pairs = [found[request.room] for request in chosen]
        write_lines(draft / ROWS, (row for row, _ in pairs))
        write_lines(draft / SECONDS, (times for _, times in pairs))


def join(path: Path, requests: Requests, parts: Sequence[Path]) -> None:
    """Write a block from folders of one program each, as if it had been written at once."""
    if path.exists():
        return
    with whole_folder(path) as draft, Writers(draft, schema(width(requests))) as writers:
        for position, part in enumerate(parts):
            for table in tables(row_groups(part)):
                writers.write(position, table)
        for name in (ROWS, SECONDS):
            write_atomic(draft / name, b"".join(read_bytes(part / name) for part in parts))


def width(requests: Requests) -> int:
    """The objects that rows have poses for: the most that a program may have, or that a scene of the user has."""
    most = requests.spec.rooms.objects[1]
    if requests.spec.requests.scenes is None:
        return most
    counts = [len(Scene.load(requests.folder / name).objects) for name in requests.spec.requests.scenes]
    return min(most, max(counts))


def _made(
    spec: Spec, block: Sequence[Request], writers: Writers, device: str
) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """The rows and times of a block's programs, in their order; their layouts go to the writers."""
    began = time.monotonic()
    taken, refused = taken_programs(spec, block, device)
    drawn = time.monotonic()
    order = [request.room for request in block if request.room in taken]
    chosen = [taken[room] for room in order]
    positions = {request.room: position for position, request in enumerate(block)}
    collections = [
        Collection(positions[room], room, one.scene, one.program.request.layouts, writers.add)
        for room, one in zip(order, chosen, strict=True)
    ]
    steps = 0
    if chosen:
        scenes, first = [one.scene for one in chosen], [one.first for one in chosen]
        steps = collect(scenes, first, [one.program.seed for one in chosen], collections, device)
    ended = time.monotonic()
    found = dict(zip(order, collections, strict=True))
    share = 1 / max(1, len(block))
    times = {"programs": share * (drawn - began), "layouts": share * (ended - drawn)}
    rows = []
    for request in block:
        if request.room in taken:
            row = _row(taken[request.room], found[request.room].count, spec, steps)
        else:
            row = _base(refused[request.room]) | {"status": "rejected", "reason": refused[request.room].reason}
        rows.append((row, {"index": request.index, **times}))
    return rows


def taken_programs(spec: Spec, block: Sequence[Request], device: str) -> tuple[dict[int, Taken], dict[int, Program]]:
    """The programs of a block by their room, and the last attempt at those that came to nothing."""
    taken: dict[int, Taken] = {}
    refused: dict[int, Program] = {}
    with drawing(spec, block) as draw:
        for attempt in range(spec.rooms.attempts):
            left = [(request, attempt) for request in block if request.room not in taken]
            if not left:
                break
            programs = draw(left)
            refused |= {p.request.room: p for p in programs if p.scene is None}
            good = [p for p in programs if p.scene is not None]
            scenes = [compile_scene(p.scene) for p in good if p.scene is not None]
            first = _first(scenes, spec.rooms.candidates, [p.seed for p in good], device)
            for program, scene, layouts in zip(good, scenes, first, strict=True):
                if len(layouts.poses) < min(LEAST_FIRST, program.request.layouts):
                    reason = f"{len(layouts.poses)} of {spec.rooms.candidates} layouts are valid"
                    refused[program.request.room] = Program(program.request, attempt, None, reason)
                else:
                    taken[program.request.room] = Taken(program, scene, layouts)
    return taken, refused


def _first(scenes: Sequence[CompiledScene], candidates: int, seeds: Sequence[int], device: str) -> list[Drawn]:
    """The first layouts of some programs; on a CPU the most are searched only where a few have led to a valid one."""
    kind, probe = ("cpu", min(PROBE, candidates)) if device == "cpu" else ("gpu", candidates)
    first = first_layouts(scenes, range(probe), ATTEMPTS[kind], seeds, device)
    hopeful = [k for k, drawn in enumerate(first) if len(drawn.poses)]
    if probe < candidates and hopeful:
        chosen = [scenes[k] for k in hopeful], [seeds[k] for k in hopeful]
        more = first_layouts(chosen[0], range(probe, candidates), ATTEMPTS[kind], chosen[1], device)
        for k, drawn in zip(hopeful, more, strict=True):
            first[k] = joined(first[k], drawn)
    return first


def _base(program: Program) -> dict[str, Any]:
    request = program.request
    return {"index": request.index, "key": request.key(0), **request.columns(program.attempt)}


def _row(taken: Taken, count: int, spec: Spec, steps: int) -> dict[str, Any]:
    scene, wanted = taken.scene.scene, taken.program.request.layouts
    return _base(taken.program) | {
        "status": "ok" if count else "rejected",
        "reason": None if count == wanted else f"{count} of {wanted} layouts after {steps} steps",
        "layouts": count,
        "first_valid": len(taken.first.poses) / spec.rooms.candidates,
        **scene_columns(scene),
        "area": round(abs(float(signed_area(scene.room.outline))), 3),
        "scene": json.dumps(scene.to_json(), ensure_ascii=False, separators=(",", ":")),
    }
