"""A block of programs with their layouts, written whole or not at all."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import sceneweaver
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.layout.compile import CompiledScene, compile_scene
from sceneweaver.layout.devices import pick_devices
from sceneweaver.layout.sampling import Drawn, first_layouts, joined
from sceneweaver.scene import Scene
from sceneweaver.scene.files import temporary_folder

from ..blocks import ROWS, SECONDS
from ..folder import Folder
from ..requests import Request, Requests
from ..spec import Spec
from .collect import Collection, collect
from .programs import Program, drawing
from .tables import Writers, row_groups, schema, tables

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


def make_block(folder: Folder, requests: Requests, number: int, device: str = "auto") -> None:
    """Make one block of programs and their layouts, unless it is there.

    Args:
        folder: the data set.
        requests: what is asked for, with its specification.
        number: which block.
        device: where layouts are made.
    """
    write_programs(folder.block(number), requests, requests.block(number), device)


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
    with _draft(path) as draft, Writers(draft, schema(width(requests))) as writers:
        tried = [request for request in chosen if request.room not in given_up]
        found = {row["room"]: (row, times) for row, times in _made(requests.spec, tried, writers, where)}
        for request in chosen:
            if request.room in given_up:
                reason = given_up[request.room]
                row = _base(Program(request, 0, None)) | {"status": "failed", "reason": reason}
                found[request.room] = row, {"index": request.index}
        _write_rows(draft, [found[request.room] for request in chosen])


def join(path: Path, requests: Requests, parts: Sequence[Path]) -> None:
    """Write a block from folders of one program each, as if it had been written at once."""
    if path.exists():
        return
    with _draft(path) as draft, Writers(draft, schema(width(requests))) as writers:
        for position, part in enumerate(parts):
            for table in tables(row_groups(part)):
                writers.write(position, table)
        for name in (ROWS, SECONDS):
            (draft / name).write_bytes(b"".join((part / name).read_bytes() for part in parts))


@contextmanager
def _draft(path: Path) -> Iterator[Path]:
    """A folder that is renamed to a path when it is whole."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with temporary_folder(path.parent) as temporary:
        draft = temporary / path.name
        draft.mkdir()
        yield draft
        try:
            os.rename(draft, path)
        except OSError:  # the folder is not empty: another process was as quick
            if not path.exists():
                raise


def _write_rows(folder: Path, found: Sequence[tuple[dict[str, Any], dict[str, Any]]]) -> None:
    for name, data in zip((ROWS, SECONDS), zip(*found, strict=True), strict=True):
        text = "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in data)
        (folder / name).write_text(text)


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
    return {
        "index": request.index,
        "key": request.key(0),
        "room": request.room,
        "attempt": program.attempt,
        "seed": request.seed,
        "prompt": request.prompt,
        "kind": request.kind,
        "version": sceneweaver.__version__,
    }


def _row(taken: Taken, count: int, spec: Spec, steps: int) -> dict[str, Any]:
    scene, wanted = taken.scene.scene, taken.program.request.layouts
    return _base(taken.program) | {
        "status": "ok" if count else "rejected",
        "reason": None if count == wanted else f"{count} of {wanted} layouts after {steps} steps",
        "layouts": count,
        "first_valid": len(taken.first.poses) / spec.rooms.candidates,
        "room_type": scene.room.type,
        "area": round(abs(float(signed_area(scene.room.outline))), 3),
        "wall_count": len(scene.room.outline),
        "object_count": len(scene.objects),
        "categories": sorted({o.category for o in scene.objects}),
        "relation_count": len(scene.relations),
        "scene": json.dumps(scene.to_json(), ensure_ascii=False, separators=(",", ":")),
    }
