"""``design``: from a request in words to a furnished, verified room."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

from sceneweaver.assets import Library
from sceneweaver.brief import SceneGraph, read_request
from sceneweaver.critic import Review
from sceneweaver.export import formats_named
from sceneweaver.knowledge import RoomType, match_room, room_types
from sceneweaver.knowledge.likely import likeliest_room
from sceneweaver.llm import ModelClient
from sceneweaver.tools.base import CLUTTER
from sceneweaver.tools.registry import Registered
from sceneweaver.tools.registry import tools as registered
from sceneweaver.verify import Report

from .by_model.session import Session
from .deadline import Deadline, Stop
from .deliver import deliver
from .executor import Executor
from .folder import RunFolder
from .interrupt import TimeUp
from .lived_in import lived_in
from .loop import Run
from .memory import Step
from .openability import opened
from .result import Result
from .roles import Roles
from .settings import Settings
from .settling import settled

LEAST_RESERVE, WRITING, EXIT = 2.0, 2.5, 0.25
"""Least time [s] that is kept for writing the results; what that and ending a process take, in times of starting up."""

TIME, TIME_BY_MODEL = 120.0, 600.0
"""Time limit [s] where none is given, without and with a model."""

MOST_RESERVE = 0.4
"""Share of a time limit that is kept for writing the results at most."""

LONGEST = 100_000
"""Characters of a request that are read."""

LIKELY = "living_room"
"""The kind of room that is made when the request names none and nothing in it tells."""


def design(
    prompt: str,
    *,
    seed: int = 0,
    planner: str = "rules",
    out: str | Path | None = None,
    steps: int = 10,
    candidates: int | None = None,
    device: str = "auto",
    time_limit: float | Literal["auto"] | None = "auto",
    pictures: bool = True,
    export: str | Iterable[str] = ("glb", "usd", "mjcf"),
    clutter: float = CLUTTER,
    settle: bool = False,
    said: Callable[[Step], None] | None = None,
    began: float | None = None,
    stop: Stop | None = None,
    library: Library | None = None,
    model: ModelClient | None = None,
    reader: str | None = None,
    critic: str | None = None,
    samples: int = 1,
    strict: bool = False,
    **switches: Any,
) -> Result:
    """Design a room from a request in words.

    Args:
        prompt: the request, in English.
        seed: equal seeds give equal scenes.
        planner: "rules", which needs no model, or "llm".
        out: a folder for the scene, its pictures and report, and every step; a run that was cut off goes on there.
        steps: steps of the agent at most.
        candidates: layouts that are refined for each call of a tool; None decides by the kind of device.
        device: "auto", "cpu", "cuda" or "cuda:k".
        time_limit: seconds that all may take, files included; what is best then is kept, and ``finished`` says so.
            None: as long as it takes. "auto": 120 without a model, 600 with one.
        pictures: whether pictures and the report are drawn into ``out``.
        export: formats that are written into ``out``: glb, usd, mjcf, scenestate; "all" or "none".
        clutter: how lived-in the room looks, from 0, a show room, to 1: things that lie about, askew, on the floor.
        settle: whether to prefer layouts that physics leaves alone, to keep the poses in which things come to rest, and
            to measure the stability of the scene.
        said: called with each step as it ends.
        began: when the time began to run, by ``time.monotonic()``; None: now.
        stop: asks it to end before, with what is best then.
        library: where assets come from; None: the library of this user.
        model: what is asked where a model does something.
        reader: who reads the request, "rules" or "llm"; None: who plans.
        critic: who grades, "symbolic", or "vlm" for a critic that looks at pictures as well; None: as the planner.
        samples: how often the critic that looks at pictures looks at a scene.
        strict: whether to end where the model cannot be asked any more, instead of going on without it.
        switches: other fields of `Settings`, such as ``reflect=False``.

    Raises:
        InputError: for a request that says nothing, arguments out of range, or a folder that cannot be used.
        MissingDependencyError: for a model or device that is not there, or is there no more in a strict run.

    Examples:
        >>> import sceneweaver as sw
        >>> result = sw.design("a store room with one shelf", seed=1, steps=1, candidates=8, device="cpu")
        >>> result.report.valid, result.unmet
        (True, ())
    """
    began = time.monotonic() if began is None else began
    roles = Roles.of(planner, reader, critic, samples)
    session = Session.opened(roles, model, strict=strict)
    formats = formats_named(export)
    settings = Settings(
        seed=seed,
        steps=steps,
        candidates=candidates,
        device=device,
        seconds=(TIME_BY_MODEL if roles.by_model else TIME) if time_limit == "auto" else time_limit,
        clutter=clutter,
        settle=settle,
        **switches,
    )
    brief = read_request(prompt[:LONGEST])
    room_type, remarks = chosen_room(brief)
    folder = RunFolder(Path(out)) if out is not None else None
    tools = {name: tool for name, tool in registered().items() if usable(name, tool, settings, room_type)}
    run = Run(brief, room_type, settings, tools, session.planner(), library or Library(), folder=folder, said=said)
    limit = Deadline(began + (settings.seconds or math.inf), stop=stop or Stop())
    if folder is None:
        run.deadline = limit
        return _result(run, remarks, began)
    with folder.held():
        _resume(run, folder)
        started = time.monotonic() - began
        limit.stop.allowance = max(LEAST_RESERVE, WRITING * started)
        kept = reserve(settings.seconds, started) if settings.seconds else limit.stop.allowance
        run.deadline = replace(limit, end=limit.end - run.memory.seconds).before(kept)
        result = _result(run, remarks, began)
        return deliver(result, folder.path, run.library, device, pictures, formats, limit.before(EXIT * started))


def reserve(limit: float, started: float) -> float:
    """Seconds of a time limit that are kept for writing the results.

    To write the results of a room in their quickest form takes about two and a half times as long as to start up, which
    so measures how fast this machine is just now.

    Args:
        limit: the time limit [s].
        started: seconds that it took to start up and to read the request.
    """
    return min(MOST_RESERVE * limit, max(LEAST_RESERVE, 0.12 * limit, WRITING * started))


def _result(run: Run, remarks: Sequence[str], began: float) -> Result:
    brief, settings = run.brief, run.settings
    best = run.go()
    stopped = run.deadline.stop.reason
    said = [f"the work was cut off: {run.cut_off}"] if run.cut_off else []
    if not run.cut_off:
        try:
            with run.deadline.enforced():
                best = lived_in(best, Executor(run.room_type, brief, settings), run.context(best.scene, settings.seed))
        except TimeUp:
            said.append("the room is tidier than usual: time was up")
    try:
        with run.deadline.enforced():
            best, mended = opened(best, Executor(run.room_type, brief, settings))
        said += mended
    except TimeUp:
        said.append("whether doors and drawers open was not looked at: time was up")
    if settings.settle:
        try:
            with run.deadline.enforced():
                best, moved = settled(best, Executor(run.room_type, brief, settings))
            said += moved
        except TimeUp:
            said.append("things have not settled: time was up")
    unmet = tuple(dict.fromkeys((*run.memory.unmet, *run.unmet, *_unmet(best.review))))
    return Result(
        scene=best.scene,
        report=_complete(best.report, best.review, settings, run, began),
        review=best.review,
        brief=brief,
        steps=run.memory.steps,
        notes=tuple(dict.fromkeys((*brief.notes, *remarks, *run.memory.notes, *run.notes, *said))),
        unmet=unmet,
        seconds=time.monotonic() - began,
        finished=run.memory.finished,
        undone=run.undone + ((f"what would have come after {stopped}",) if run.cut_off and stopped else ()),
        out=run.folder.path if run.folder else None,
    )


def usable(name: str, tool: Registered, settings: Settings, room_type: RoomType) -> bool:
    """Whether a tool may be called: it needs no model, settings name it or none, and its card is for such a room."""
    chosen = settings.tools is None or name in settings.tools
    return tool.card.needs is None and chosen and tool.card.suits(room_type.name)


def chosen_room(brief: SceneGraph) -> tuple[RoomType, tuple[str, ...]]:
    """The kind of room that a request means, and what was assumed where it does not say."""
    known = room_types()
    if brief.room_type is not None and brief.room_type in known:
        return known[brief.room_type], ()
    if brief.room_words:
        found = match_room(brief.room_words)
        if found is not None:
            return known[found[0]], ()
    best = (likeliest_room((e.category for e in brief.entities), brief.text) or known[LIKELY]).name
    said = f"'{brief.room_words}' is no kind of room that is known" if brief.room_words else "no kind of room was named"
    return known[best], (f"{said}; made as a {best.replace('_', ' ')}",)


def _resume(run: Run, folder: RunFolder) -> None:
    kept = folder.resume(run.brief, run.settings)
    if kept is not None:
        memory = kept[0]
        if memory.spent and len(memory.steps) < run.settings.steps:  # a larger budget goes on
            memory = memory.model_copy(update={"finished": "", "spent": False})
        run.memory = memory
        run.best = Executor(run.room_type, run.brief, run.settings).judged(kept[1])


def _unmet(review: Review) -> list[str]:
    """What the critic finds missing of the request."""
    return [fault.reason for fault in review.faults if fault.criterion == "alignment"]


def _complete(report: Report, review: Review, settings: Settings, run: Run, began: float) -> Report:
    from importlib.metadata import version

    scores = {"critic": review.critic, **{k: round(v, 2) for k, v in review.grades.items()}}
    steps = {f"step {s.number}": s.seconds for s in run.memory.steps}
    return replace(
        report,
        scores=scores,
        alignment=review.alignment.summary,
        seed=settings.seed,
        device=settings.device,
        candidates=settings.layouts,
        cut_off=run.cut_off or None,
        seconds={"total": round(time.monotonic() - began, 3), **steps},
        versions={**report.versions, "warp-lang": version("warp-lang")},
    )
