"""``design``: from a request in words to a furnished, verified room."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any, Unpack, get_args

from sceneweaver.assets import Library
from sceneweaver.export import formats_named
from sceneweaver.export.formats import USUAL
from sceneweaver.generate.asked_room import asked_room, headline
from sceneweaver.generate.draft import area_of
from sceneweaver.generate.kitchen_runs import sides_meant
from sceneweaver.generate.lamps import lamps_beside
from sceneweaver.generate.look import in_time, suited
from sceneweaver.generate.people import with_people
from sceneweaver.generate.stands import with_stands
from sceneweaver.knowledge import RoomType, match_room
from sceneweaver.knowledge.learned import all_rooms
from sceneweaver.knowledge.likely import likeliest_room, told_by
from sceneweaver.knowledge.names import room_of_part
from sceneweaver.knowledge.small_floors import on_floor
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.llm import Limits, Prices
from sceneweaver.runtime.deadline import Deadline, Stop
from sceneweaver.runtime.memory import freed_memory_given_back
from sceneweaver.runtime.options import DesignOptions, PictureSet, defaults_of
from sceneweaver.scene import InputError, Palette, Room
from sceneweaver.tools.registry import Registered
from sceneweaver.tools.registry import tools as registered

from .by_model.asking import Asking
from .by_model.session import RECORDS, Session
from .closing import closed
from .deliver import deliver
from .executor import Executor
from .folder import RunFolder
from .loop import Run
from .memory import Step
from .replayed import prompt_of, recorded, roles_of, settings_of
from .result import Result
from .roles import Roles
from .schedule import EXPECTED, LEAST, Schedule
from .settings import Settings
from .starting import TOOLS, Starting, check_tools

TIME, TIME_BY_MODEL = 120.0, 600.0
"""Time limit [s] where none is given, without and with a model."""


LIKELY = "living_room"
"""The kind of room that is made when the request names none and nothing in it tells."""

TOLD = 0.6
"""Share of the things of a request from which on they tell the kind of room that they belong to."""

BARE = "it holds what was asked for, what that needs, and light"
"""What is said of a room of a kind that nobody described."""


class AllOptions(DesignOptions, total=False):
    """The options that a design takes in Python: those of the command line, objects, and fields of `Settings`."""

    out: str | Path | None
    said: Callable[[Step], None] | None
    ready: Callable[[Result, Sequence[str]], None] | None
    began: float | None
    stop: Stop | None
    library: Library | None
    room: Room | None
    palette: Palette | None
    limits: Limits | None
    prices: Prices | None
    side_by_side: int
    finalists: int
    generations: int
    attempts: tuple[int, int]
    work: int
    grade: float
    patience: int
    replans: int
    choice: bool
    rules: bool
    reflect: bool
    physics: bool
    one_shot: bool
    tools: tuple[str, ...] | None


OBJECTS = dict.fromkeys(("out", "said", "ready", "began", "stop", "library", "room", "palette", "limits", "prices"))
"""Options that only Python has, with their defaults."""

NO_SETTINGS = {
    *OBJECTS,
    *("planner", "time_limit", "pictures", "export", "model", "base_url", "reader", "critic", "samples"),
    *("stream", "replay", "strict", "init", "scenes", "scene_model", "start", "source"),
}
"""Options that are no fields of `Settings`."""


def design(prompt: str = "", **options: Unpack[AllOptions]) -> Result:
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
        pictures: which pictures are drawn into ``out``: "full", all of them; "hero", those from above and the best one
            at eye level; "none", none, and no report. True and False mean "full" and "none".
        export: formats that are written into ``out``: glb, usd, mjcf, scenestate; "all" or "none"; None: glb, usd and
            mjcf.
        clutter: how lived-in the room looks, from 0, a show room, to 1: things that lie about, askew, on the floor.
        settle: whether to prefer layouts that physics leaves alone, to keep the poses in which things come to rest, and
            to measure the stability of the scene.
        said: called with each step as it ends.
        ready: called with the result and the files that can be opened, when the scene is there, and again when there
            are a first picture and the report: files for other tools and better pictures come after that.
        began: when the time began to run, by ``time.monotonic()``; None: now.
        stop: asks it to end before, with what is best then.
        library: where assets come from; None: the library of this user.
        room: the shell to furnish, as it is: neither its outline nor its doors and windows change, nor its finish where
            it has one. Its type says what it is where the request does not; what the request says of its size is not
            followed. None: a room is drawn for the request.
        palette: style and colours of what stands in it, as in ``scene.palette``; None: chosen for the request.
        init: what the room begins with: "library", the scene of ``scenes`` that is most like the request, adapted to
            it; "model", what ``scene_model`` answers; "llm", what a language model writes for the request; "prior", a
            draft of our own whose poses the learned prior draws; "auto": what the planner likes. Where that brings
            nothing, a draft of our own takes its place, and the result says so.
        scenes: a folder of scenes, of ours or of other systems; None: the scenes that come with the library.
        scene_model: an object with ``generate(request)`` (`SceneModel`), "module:attribute", the name of an entry
            point of the group "sceneweaver.scene_models", or a folder or file of a model's outputs.
        start: a scene to go on from, instead: a `Scene`, or a file of ours or of another system; "FILE#NAME" takes one
            of several. Without a request, that which the file gives is taken. ``result.start`` says what was changed.
        source: the format of that file, or of the outputs; "auto" looks at them.
        model: what is asked where a model does something: "openai:NAME", "anthropic:NAME", a name at ``base_url``, a
            client, or a model of pydantic-ai; None: what the environment names (SCENEWEAVER_MODEL).
        base_url: where the model is, such as "http://127.0.0.1:11434/v1"; None: as the environment says.
        reader: who reads the request, "rules" or "llm"; None: as the planner.
        critic: who grades, "symbolic", or "vlm" for a critic that looks at pictures as well; None: as the planner.
        samples: how often the critic that looks at pictures looks at a scene.
        limits: calls, tokens, cost and seconds that may be spent on the model.
        prices: what its tokens cost.
        stream: whether its replies come in pieces; None: as the environment says.
        replay: the folder of a run whose records answer in the model's place. The request, roles and settings are those
            of that run; what is given and not at its default has to be the same there.
        strict: whether to end where the model cannot be asked any more, instead of going on by rules.
        memory_length: last steps that a model which plans is told of.
        options: all of these by keyword, and other fields of `Settings`, such as ``reflect=False``.

    Raises:
        InputError: for a request that says nothing, arguments out of range, or a folder that cannot be used.
        MissingDependencyError: for a model or device that is not there, or is there no more in a strict run.

    Examples:
        >>> import sceneweaver as sw
        >>> result = sw.design("a store room with one shelf", seed=1, steps=1, candidates=8, device="cpu")
        >>> result.report.valid, result.unmet
        (True, ())
    """
    given: Any = {**OBJECTS, **defaults_of(DesignOptions), **options}
    began = time.monotonic() if given["began"] is None else given["began"]
    replay, out, time_limit = given["replay"], given["out"], given["time_limit"]
    asking = Asking(
        *(given[name] for name in ("model", "base_url", "limits", "prices", "stream", "strict")),
        replay=Path(replay) if replay is not None else None,
    )
    formats = formats_named(USUAL if given["export"] is None else given["export"])
    pictures = _picture_set(given["pictures"])
    starting = Starting.of(given)
    prompt = starting.prompt(prompt)
    chosen: dict[str, Any] = {name: value for name, value in given.items() if name not in NO_SETTINGS}
    chosen["begin"] = starting.kept
    who = given["planner"], given["reader"], given["critic"], given["samples"]
    if asking.replay is None:
        roles = Roles.of(*who)
        by_model = roles.by_model or starting.by_model
        usual = TIME_BY_MODEL if by_model else TIME
        settings = Settings(seconds=usual if time_limit == "auto" else time_limit, **chosen)
        asking.check(by_model)
    else:
        state = recorded(asking.replay)
        prompt, roles = prompt_of(state, prompt), roles_of(state, *who)
        settings = settings_of(state, chosen if time_limit == "auto" else {**chosen, "seconds": time_limit})
        starting = Starting.of({**given, **settings.begin.given(given)})
    offline = read_request(prompt)
    folder = RunFolder(Path(out)) if out is not None else None
    limit = Deadline(began + (settings.seconds or math.inf), stop=given["stop"] or Stop())
    with freed_memory_given_back(), folder.held() if folder is not None else nullcontext():
        if folder is not None:
            folder.check_roles(roles)  # before a model is asked in vain
        session = Session.opened(
            roles,
            asking,
            limit,
            folder.path / RECORDS if folder is not None else None,
            time.monotonic() - began,
            begins=starting.by_model,
        )
        with session.known_rooms(prompt):
            brief = in_time(session.read(offline, folder))
            room_type, remarks = chosen_room(brief, starting.kept.room)
            brief = with_stands(with_people(sides_meant(lamps_beside(brief), room_type), room_type), room_type)
            there = session.in_tools, starting.model is not None
            tools = {n: tool for n, tool in registered().items() if usable(n, tool, settings, room_type, *there)}
            if starting.alone:
                tools = {n: tool for n, tool in tools.items() if tool.card.role != "initializer" or n == TOOLS["prior"]}
            check_tools(starting, tools)
            library = given["library"] or Library()
            run = Run(brief, room_type, settings, tools, session.planner, library, folder=folder, said=given["said"])
            run.starting = starting
            run.deadline = run.limit = limit
            session.serve(run)
            if folder is None:
                return closed(run, (*session.notes, *remarks), began, session.use)
            _resume(run, folder)
            started = time.monotonic() - began - session.waited
            run.schedule = Schedule(started, EXPECTED, formats, pictures != "none")
            run.divide(replace(limit, end=limit.end - run.memory.seconds))
            result = closed(run, (*session.notes, *remarks), began, session.use)
            until, asked = limit.before(min(run.schedule.exit, LEAST)), given["export"] is not None
            return deliver(
                result,
                folder.path,
                library,
                settings.device,
                pictures,
                formats,
                until,
                started=started,
                asked=asked,
                ready=given["ready"] or (lambda result, files: None),
            )


def _picture_set(value: PictureSet | bool) -> PictureSet:
    if isinstance(value, bool):
        return "full" if value else "none"
    if value not in get_args(PictureSet):
        raise InputError(f"pictures: {value!r} is none of {', '.join(get_args(PictureSet))}")
    return value


def usable(
    name: str,
    tool: Registered,
    settings: Settings,
    room_type: RoomType,
    by_model: bool = False,
    scene_model: bool = False,
) -> bool:
    """Whether a tool may be called: the settings name it or none, its card is for such a room, and it needs no model
    where none works in tools, and no model of scenes where there is none."""
    if not {None: True, "model": by_model, "scene_model": scene_model}[tool.card.needs]:
        return False
    return (settings.tools is None or name in settings.tools) and tool.card.suits(room_type.name)


def chosen_room(brief: SceneGraph, room: Room | None = None) -> tuple[RoomType, tuple[str, ...]]:
    """The kind of room that a request means, in the look that it wants, and what was assumed where it does not say.

    Where it names none, a ``room`` that is given says it by its type.
    """
    told = all_rooms().get(room.type) if room is not None and brief.room_type is None else None
    kind, remarks = (told, ()) if told is not None else _kind_of_room(brief)
    if room is not None:
        kind = on_floor(kind, area_of(room))
    return suited(kind, brief), remarks


def _kind_of_room(brief: SceneGraph) -> tuple[RoomType, tuple[str, ...]]:
    known = all_rooms()
    if brief.room_type is not None and brief.room_type in known:
        return known[brief.room_type], ()
    if brief.room_words:
        found = match_room(brief.room_words)
        if found is not None:
            return known[found[0]], ()
    words = brief.room_words or headline(brief)
    if (part := room_of_part(words)) is not None:
        return known[part], ()
    things = [e.category for e in brief.entities]
    text = brief.text.lower().replace(words.lower(), " ") if words else brief.text.lower()  # no flat, a podcast studio
    likely = likeliest_room(things, text)
    said = f"'{words}' is no kind of room that is known" if words else "no kind of room was named"
    if things and (words or likely is None or told_by(things, likely) < TOLD):
        return asked_room(brief, words, likely), (f"{said}; {BARE}",)
    best = (likely or known[LIKELY]).name
    return known[best], (f"{said}; made as a {best.replace('_', ' ')}",)


def _resume(run: Run, folder: RunFolder) -> None:
    kept = folder.resume(run.brief, run.settings)
    if kept is not None:
        memory = kept[0]
        if memory.spent and len(memory.steps) < run.settings.steps:  # a larger budget goes on
            memory = memory.model_copy(update={"finished": "", "spent": False})
        run.memory = memory
        run.best = Executor(run.room_type, run.brief, run.settings, run.library).judged(kept[1])
        run.origin = folder.origin()
