"""All rooms of a home furnished together: in one look, side by side in processes, the same on any number of them."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Collection, Mapping
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.home import Home
from sceneweaver.language import read_request
from sceneweaver.runtime.deadline import Deadline, Stop
from sceneweaver.scene import InputError

from .jobs import DRAWS, FurnishedRoom, RoomJob
from .kinds import kind_of
from .requests import room_requests
from .scheme import Scheme, is_wet, scheme_of
from .side_by_side import RoomPool

Kept = Callable[[RoomJob], FurnishedRoom | None]
"""Finds a room that was furnished before."""

Finished = Callable[[RoomJob, FurnishedRoom], None]
"""Is told of each room that has just been made."""

Said = Callable[[FurnishedRoom], None]
"""Is told of each room when it is done."""


@dataclass(frozen=True)
class FurnishedHome:
    """A home with its rooms furnished, see `furnish_home`.

    Attributes:
        home: the home; a room of which nothing could be made is empty.
        rooms: by id, what became of each room that was to be furnished.
        style: of all of it.
        palette: its name.
        seconds: wall time [s].
        cut_off: what ended it before it was done; empty: nothing.
        jobs: by id, what was to be done with each room.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.FurnishedHome(sw.Home.example("flat"), {}).valid
        True
    """

    home: Home
    rooms: Mapping[str, FurnishedRoom]
    style: str = ""
    palette: str = ""
    seconds: float = 0.0
    cut_off: str = ""
    jobs: Mapping[str, RoomJob] = field(default_factory=dict, repr=False)

    @property
    def valid(self) -> bool:
        """Whether every room is."""
        return all(room.valid for room in self.rooms.values())

    @property
    def unmet(self) -> tuple[str, ...]:
        """What was asked for and is not so, each with its room."""
        return tuple(f"{name}: {text}" for name, room in self.rooms.items() for text in room.unmet)

    @property
    def processor_seconds(self) -> float:
        """Processor time of all rooms [s]."""
        return round(sum(room.seconds for room in self.rooms.values()), 3)


def furnish_home(
    home: Home,
    requests: Mapping[str, str] | None = None,
    *,
    only: Collection[str] | None = None,
    seed: int = 0,
    seeds: Mapping[str, int] | None = None,
    prompt: str = "",
    device: str = "cpu",
    workers: int | None = None,
    draws: int = DRAWS,
    time_limit: float | None = None,
    kept: Kept | None = None,
    said: Said | None = None,
    finished: Finished | None = None,
    stop: Stop | None = None,
    pool: RoomPool | None = None,
    **options: Any,
) -> FurnishedHome:
    """Furnish the rooms of a home together.

    Outlines, doors and windows stay as they are; leaves and passages are kept free on both of their sides. A room is
    the same whatever is furnished beside it, in whatever order, and on however many processes, unless a time limit cuts
    it off.

    Args:
        home: the plan. Rooms that are furnished already are furnished anew.
        requests: by id of a room, what it is to hold, in words; the others are furnished as such rooms usually are,
            so that the home as a whole lacks nothing, see `room_requests`.
        only: ids of the rooms that are furnished; the others stay as they are, and what they hold is not had twice.
            None: all.
        seed: equal seeds give equal homes.
        seeds: by id, seeds of rooms that differ from those that follow from ``seed``.
        prompt: the request for the whole home; its style and colours are those of all rooms.
        device: where layouts are computed: "cpu", "cuda" ...
        workers: processes; 1: this one alone, None: one for each core.
        draws: how often each room is furnished, from other seeds; the best is kept.
        time_limit: seconds that all may take; what is best then is kept. None: as long as it takes.
        kept: finds rooms that were furnished before, of the same job.
        said: called with each room when it is done.
        finished: called with the job of a room and the room when that has just been made.
        stop: asks it to end before, with what is best then.
        pool: processes that are used for several homes, instead of some of its own; ``workers`` does not count then.
        options: of `sceneweaver.design` for each room: steps, candidates, clutter, settle, library.

    Raises:
        InputError: for a room that the home has not, one of ``only`` that stays empty, or options out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> flat = sw.Home.example("flat")
        >>> some = flat.with_changes(rooms=flat.rooms[:1], doors=(), windows=())
        >>> done = sw.furnish_home(some, {"hall": "a hallway with a coat rack"}, workers=1, steps=1, candidates=8)
        >>> done.valid, [o.category for o in done.home.room("hall").scene.objects if "coat" in o.category]
        (True, ['coat_rack'])
    """
    began = time.monotonic()
    for name in (*(requests or {}), *(only or ())):
        home.room(name)
    if workers is not None and workers < 1:
        raise InputError(f"workers: {workers} is too few; give at least 1, or leave it out for one a core")
    if draws < 1:
        raise InputError(f"draws: {draws} is too few; give at least 1")
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit:g} is no time; give seconds above 0, or leave it out")
    deadline = Deadline(began + (time_limit or math.inf), stop=stop or Stop())
    others = [room for room in home.rooms if only is not None and room.id not in only]
    had = {room.id: room.scene.prompt for room in others if room.scene is not None and room.scene.prompt}
    scheme, jobs = room_jobs(home, {**had, **(requests or {})}, seed=seed, prompt=prompt, device=device, **options)
    jobs = [job for job in jobs if only is None or job.room_id in only]
    for name in sorted({*(only or ())} - {job.room_id for job in jobs}):
        raise InputError(f"only: {name} is of type {home.room(name).type}, which stays empty; leave it out")
    jobs = [replace(job, seed=(seeds or {}).get(job.room_id, job.seed), draws=draws) for job in jobs]
    done = {job.room_id: room for job in jobs if kept is not None and (room := kept(job)) is not None}
    left = [job for job in jobs if job.room_id not in done]
    if said is not None:
        for room in done.values():
            said(room)
    with nullcontext(pool) if pool is not None else RoomPool(workers) as made_by:
        for room in made_by.made(left, deadline):
            done[room.room_id] = room
            if finished is not None:
                finished(next(job for job in left if job.room_id == room.room_id), room)
            if said is not None:
                said(room)
    rooms = {job.room_id: done[job.room_id] for job in jobs}
    scenes = {room.id: room.scene for room in others} | {name: room.scene for name, room in rooms.items()}
    furnished = home.with_changes(
        rooms=tuple(room.model_copy(update={"scene": scenes.get(room.id)}) for room in home.rooms)
    )
    cut = next((room.cut_off for room in rooms.values() if room.cut_off), "")
    return FurnishedHome(
        furnished,
        rooms,
        scheme.style,
        scheme.palette.name,
        round(time.monotonic() - began, 3),
        cut or deadline.stop.reason,
        {job.room_id: job for job in jobs},
    )


def room_jobs(
    home: Home,
    requests: Mapping[str, str] | None = None,
    *,
    seed: int = 0,
    prompt: str = "",
    device: str = "cpu",
    **options: Any,
) -> tuple[Scheme, list[RoomJob]]:
    """The look of a home, and what is to be done with each of its rooms that does not stay empty."""
    texts = room_requests(home, requests)
    kinds = {room.id: kind for room in home.rooms if (kind := kind_of(room.type)) is not None}
    if not kinds:
        raise InputError("home: none of its rooms is of a kind that is furnished; give rooms types such as bedroom")
    scheme = scheme_of(list(kinds.values()), read_request(prompt or "a home"), seed)
    jobs = []
    for name, text in texts.items():
        kind, brief = kinds[name], read_request(text)
        floor = scheme.floor_of(kind, outdoor=home.room(name).outdoor, opens_to_dry=_opens_to_dry(home, name))
        bare = home.shell(name).model_copy(update={"type": kind.name})
        shell = scheme.shell(bare, kind, brief, floor)
        own, given = room_seed(name, seed), {"device": device, **options}
        jobs.append(RoomJob(name, text, shell, scheme.look(kind, brief), own, given))
    return scheme, jobs


def room_seed(room_id: str, seed: int) -> int:
    """The seed of a room that follows from that of its home."""
    return random.Random(f"room {room_id} of a home {seed}").randrange(2**32)


def _opens_to_dry(home: Home, room_id: str) -> bool:
    """Whether a passage without a leaf leads from a room to one with the floor of living rooms."""
    for door in home.doors_of(room_id):
        other = door.to if door.room == room_id else door.room
        kind = kind_of(home.room(other).type) if other is not None and door.kind == "open" else None
        if kind is not None and not is_wet(kind):
            return True
    return False
