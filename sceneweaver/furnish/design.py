"""``design_home``: from a request in words to a whole home, planned, furnished, checked and written."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Mapping
from contextlib import nullcontext, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, get_args

from sceneweaver.assets import Library
from sceneweaver.export import format_named, formats_named
from sceneweaver.export.formats import USUAL
from sceneweaver.home import Home
from sceneweaver.language.homes import is_home
from sceneweaver.plans import Envelope, PlanReport, Programme, check_plan
from sceneweaver.runtime.deadline import Deadline, Stop
from sceneweaver.runtime.options import PictureSet
from sceneweaver.scene import InputError
from sceneweaver.verify.home import HomeReport, check_home

from .asked import Asked
from .deliver import deliver
from .demands import raised
from .folder import HomeFolder, digest
from .giving_way import missed, softer
from .home import FurnishedHome, furnish_home
from .jobs import DRAWS, FurnishedRoom, RoomJob
from .planning import ChosenPlan, plan_home
from .result import HomeResult, unmet_of
from .side_by_side import RoomPool

TIME = 600.0
"""Time limit [s] where none is given."""

AGAIN = 2
"""Times at most that the plan is solved again because its rooms could not be furnished."""

WALKS = 2
"""Times at most that rooms are furnished anew in which something cannot be walked to."""

PLANS, FILES = 0.25, 0.3
"""Shares of the time that plans may take, and that is kept for files and pictures."""

FEWER = 4
"""By how much fewer plans are searched for at once of each programme that asks for less."""


def design_home(
    prompt: str = "",
    *,
    seed: int = 0,
    out: str | Path | None = None,
    programme: Programme | None = None,
    envelope: Envelope | None = None,
    profile: str | None = None,
    device: str = "auto",
    workers: int | None = None,
    plans: int = 1024,
    candidates: int | None = None,
    steps: int = 10,
    clutter: float = 0.4,
    draws: int = DRAWS,
    time_limit: float | str | None = "auto",
    pictures: PictureSet | bool = "full",
    export: str | tuple[str, ...] | list[str] | None = None,
    library: Library | None = None,
    said: Callable[[str], None] | None = None,
    stop: Stop | None = None,
    began: float | None = None,
) -> HomeResult:
    """Design a whole home from a request in words, or from a programme.

    The request becomes a programme of rooms with areas and neighbourhoods; what their furniture needs is asked of the
    plan before it is solved. Of many valid plans the best is furnished, all rooms together. Where a room of it cannot
    hold what it has to, the programme asks for more of that room and the plan is solved again, at most twice.

    Args:
        prompt: the request, in English; may be empty where a programme is given.
        seed: equal seeds give equal homes.
        out: a folder for the home, its pictures and models; a run that was cut off goes on there.
        programme: the rooms, instead of those that the request names.
        envelope: what the plan has to fit into; None: as the request says, or chosen for the programme.
        profile: rules that the plan keeps, such as "accessible"; None: as the request says.
        device: "auto", "cpu", "cuda" or "cuda:k".
        workers: processes that furnish rooms side by side; None: one for each core.
        plans: plans that are searched for at once.
        candidates: layouts that are refined for each call of a tool in a room; None: by the kind of device.
        steps: steps of the agent in a room at most.
        clutter: how lived-in the rooms look, from 0 to 1.
        draws: how often each room is furnished; the best is kept.
        time_limit: seconds that all may take, files included; None: as long as it takes; "auto": 600.
        pictures: "full", all of them; "hero", plans and views from above; "none", plans alone and no page. True and
            False mean "full" and "none".
        export: models that are written into ``out``: glb, usd, mjcf, sdf, urdf; "all" or "none"; None: glb, usd, mjcf.
        library: where assets come from; None: the library of this user.
        said: called with a line for each thing that was done.
        stop: asks it to end before, with what is best then.
        began: when the time began to run, by ``time.monotonic()``; None: now.

    Raises:
        InputError: for a request that says nothing, arguments out of range, a folder that cannot be used, or a
            programme of which no plan keeps all rules.

    Examples:
        >>> import sceneweaver as sw
        >>> text = "a studio flat of 30 m2"
        >>> result = sw.design_home(text, seed=1, plans=64, steps=1, candidates=8, workers=1, device="cpu")
        >>> result.plan_report.valid, all(room.scene is not None for room in result.rooms.values())
        (True, True)
    """
    started = time.monotonic() if began is None else began
    wanted = _pictures(pictures)
    formats = formats_named(USUAL if export is None else export, homes=True)
    for name in formats:
        format_named(name).for_homes()  # says what homes are not written in
    if isinstance(time_limit, str) and time_limit != "auto":
        raise InputError(f"time_limit: {time_limit!r} is no time; give seconds, None or 'auto'")
    seconds = TIME if isinstance(time_limit, str) else time_limit
    if seconds is not None and not seconds > 0:
        raise InputError(f"time_limit: {seconds:g} is no time; give seconds above 0, or None")
    if not prompt.strip() and programme is None:
        raise InputError("prompt: is empty; say what home is wanted, or give a programme")
    limit = Deadline(started + (seconds or math.inf), stop=stop or Stop())
    asked = Asked.of(prompt, programme, envelope, profile)
    folder = HomeFolder(Path(out)) if out is not None else None
    rooms = {"steps": steps, "candidates": candidates, "clutter": clutter, "draws": draws}
    drawn = {"library": library} if library is not None else {}
    if workers is not None and workers < 1:
        raise InputError(f"workers: {workers} is too few; give at least 1, or leave it out for one a core")
    run = _Run(asked, seed, device, RoomPool(workers), plans, rooms, drawn, limit, folder, said)
    with folder.held() if folder is not None else nullcontext():
        with run.pool:
            result = run.go(started)
        if folder is None:
            return result
        done = deliver(result, folder.path, library or Library(), device, wanted, formats, limit)
        return replace(done, out=folder.path, seconds=_total(done.seconds, started))


def asks_for_home(prompt: str) -> bool:
    """Whether a request is for a whole home, practice or office, and not for one room.

    Examples:
        >>> from sceneweaver.furnish import asks_for_home
        >>> asks_for_home("a two-bedroom flat"), asks_for_home("a bedroom with a desk")
        (True, False)
    """
    return is_home(prompt)


def _pictures(value: PictureSet | bool) -> PictureSet:
    if isinstance(value, bool):
        return "full" if value else "none"
    if value not in get_args(PictureSet):
        raise InputError(f"pictures: {value!r} is none of {', '.join(get_args(PictureSet))}")
    return value


def _total(seconds: Mapping[str, float], started: float) -> dict[str, float]:
    return {**seconds, "total": round(time.monotonic() - started, 3)}


@dataclass
class _Run:
    """A request on its way to a home."""

    asked: Asked
    seed: int
    device: str
    pool: RoomPool
    plans: int
    rooms: Mapping[str, Any]
    drawn: Mapping[str, Any]
    limit: Deadline
    folder: HomeFolder | None
    said: Callable[[str], None] | None
    made: dict[tuple[str, str], FurnishedRoom] = field(default_factory=dict)
    log: list[str] = field(default_factory=list)
    spent: dict[str, float] = field(default_factory=dict)

    def go(self, started: float) -> HomeResult:
        """Plan, furnish, and go back to the plan where that does not hold what it has to."""
        self.pool.begin(len(self.asked.programme.rooms))
        programme, raises = self.asked.possible()
        first, home = 0, None
        if self.folder is not None:
            had = self.folder.begin(self._key)
            home = self.folder.plan() if had else None
            if home is not None:
                first, self.log = int(had["round"]), [str(line) for line in had["log"] or ()]
                programme = Programme.loads(str(had["asked"]))
                self._say("went on from the plan of the run that was cut off")
        if home is None:
            self._say(*raises)
        best: tuple[tuple[float, ...], FurnishedHome, Programme, PlanReport] | None = None
        before = dict[str, tuple[tuple[str, ...], int]]()
        for round_ in range(first, AGAIN + 1):
            if home is None:
                try:
                    home, programme = self._planned(programme, round_)
                except InputError:
                    if best is None:
                        raise
                    self._say("no plan gives these rooms more; the one before stays")
                    break
            plan_report = check_plan(home, programme, self.asked.profile)
            done = self._furnished(home)
            worth = _worth(done)
            if best is None or worth > best[0]:
                best = worth, done, programme, plan_report
            failing = [name for name, room in done.rooms.items() if not room.satisfied and _known(programme, name)]
            if not failing or round_ == AGAIN or self.limit.passed or done.cut_off:
                break
            wrong = {name: (done.rooms[name].lacking, len(done.rooms[name].unmet)) for name in failing}
            helped = [name for name in failing if before.get(name) != wrong[name]]
            if not helped:
                self._say(f"more floor does not help {', '.join(failing)}")
                break
            before = wrong
            programme, raises = raised(programme, helped)
            programme = self.asked.within(programme)
            self._say(*raises)
            home = None
        assert best is not None
        _, done, programme, plan_report = best
        bare = done.home.with_changes(rooms=tuple(r.model_copy(update={"scene": None}) for r in done.home.rooms))
        self._keep_plan(bare, programme, AGAIN)  # a run that is started again takes this one, and no other plan
        done, report = self._walked(done)
        if self.folder is not None:
            for name, room in done.rooms.items():
                self.folder.keep(done.jobs[name], room)
        unmet = (*done.unmet, *(f"{n}: it has no {what}" for n, r in done.rooms.items() for what in r.lacking))
        failed = [f"{name}: {room.failed}" for name, room in done.rooms.items() if room.failed]
        demands = self.asked.demands(done.home)
        failed += unmet_of(demands)
        wanted, default = missed(self.asked.programme, done.home, self.asked.profile, self.asked.areas)
        return HomeResult(
            done.home,
            report,
            plan_report,
            programme,
            done.rooms,
            tuple(dict.fromkeys((*unmet, *failed, *wanted))),
            (*self.asked.notes, *default),
            tuple(self.log),
            done.style,
            _total(self.spent, started),
            (f"rooms: {done.cut_off}",) if done.cut_off else (),
            demands=demands,
            remarks=self.asked.remarks,
        )

    @property
    def _key(self) -> dict[str, Any]:
        asked = self.asked
        envelope = None if asked.envelope is None else asked.envelope.model_dump(mode="json")
        return {
            "prompt": asked.prompt,
            "programme": asked.programme.dumps(),
            "envelope": envelope,
            "profile": asked.profile.name,
            "seed": self.seed,
            "plans": self.plans,
            "rooms": dict(self.rooms),
        }

    def _say(self, *lines: str) -> None:
        for line in lines:
            self.log.append(line)
            if self.said is not None:
                self.said(line)

    def _lap(self, name: str, began: float) -> None:
        self.spent[name] = round(self.spent.get(name, 0.0) + time.monotonic() - began, 3)

    def _planned(self, programme: Programme, round_: int) -> tuple[Home, Programme]:
        """The plan of a programme, and that programme, or one that asks for less where it has no plan."""
        began = time.monotonic()
        try:
            chosen = self.asked.fitted(programme, self.seed, partial(self._solved, programme, self.plans))
        except InputError as error:
            chosen, wrong, fewer = None, error, max(1, self.plans // FEWER)
            for step in softer(programme, self.asked.request) if not round_ else ():
                if self.limit.passed or self.limit.stop.reason:
                    break
                self._say(step.line)
                less = self.asked.within(step.programme)
                fits = self.asked.envelope_of(less, self.seed, step.own_envelope)
                with suppress(InputError):
                    chosen, programme = self._solved(less, fewer, fits), less
                    break
            if chosen is None:
                raise wrong from None
        self._lap("plan", began)
        short = "".join(f"; {name} lacks {more:.2f} m of wall" for name, more in chosen.lacking.items())
        self._say(
            f"plan {round_ + 1}: {chosen.valid} valid plans, the best of {chosen.distinct} distinct ones has "
            f"{len(chosen.report.soft)} soft rules unmet{short}"
        )
        self._keep_plan(chosen.home, programme, round_)
        return chosen.home, programme

    def _solved(self, programme: Programme, plans: int, envelope: Envelope) -> ChosenPlan:
        """The best of so many plans of a programme in an envelope.

        Raises:
            InputError: none is valid.
        """
        left = self.limit.left
        return plan_home(
            programme,
            envelope,
            seed=self.seed,
            profile=self.asked.profile,
            candidates=plans,
            device=self.device,
            time_limit=None if math.isinf(left) else max(1.0, PLANS * left),
            prompt=self.asked.prompt,
            outside=self.asked.outside,
        )

    def _keep_plan(self, home: Home, programme: Programme, round_: int) -> None:
        """Write what a run that is cut off goes on from."""
        if self.folder is not None:
            asked = programme.dumps()
            self.folder.planned(self._key, home, asked, round=round_, log=self.log, asked=asked)

    def _furnished(self, home: Home, seeds: Mapping[str, int] | None = None) -> FurnishedHome:
        began, left = time.monotonic(), self.limit.left
        done = furnish_home(
            home,
            self.asked.told(home),
            seed=self.seed,
            seeds=seeds,
            prompt=self.asked.style,
            device=self._rooms_on,
            time_limit=None if math.isinf(left) else max(1.0, (1 - FILES) * left),
            kept=self._kept,
            said=self._room_said,
            finished=self._finished,
            stop=self.limit.stop,
            pool=self.pool,
            **self.rooms,
            **self.drawn,
        )
        self._lap("rooms", began)
        return done

    def _kept(self, job: RoomJob) -> FurnishedRoom | None:
        """A room of the same job that this run, or the one that was cut off, has made; None: there is none."""
        made = self.made.get((job.room_id, digest(job)))
        return self.folder.kept(job) if made is None and self.folder is not None else made

    def _finished(self, job: RoomJob, room: FurnishedRoom) -> None:
        if not room.cut_off and not room.failed:
            self.made[job.room_id, digest(job)] = room
        if self.folder is not None:
            self.folder.keep(job, room)

    @property
    def _rooms_on(self) -> str:
        """Where rooms are laid out: side by side on the cores, unless a GPU is asked for by name."""
        return "cpu" if self.device == "auto" else self.device

    def _room_said(self, room: FurnishedRoom) -> None:
        grade = f"grade {room.review.total:.1f}" if room.review is not None else "failed"
        wrong = "; ".join(
            [*room.unmet, *(f"no {what}" for what in room.lacking), *([room.failed] if room.failed else [])]
        )
        objects = len(room.scene.objects) if room.scene is not None else 0
        self._say(f"{room.room_id}: {objects} objects, {grade}" + (f"; {wrong}" if wrong else ""))

    def _walked(self, done: FurnishedHome) -> tuple[FurnishedHome, HomeReport]:
        """The home, with rooms furnished anew in which something cannot be walked to, and the judge's verdict on it."""
        began = time.monotonic()
        report = check_home(done.home)
        seeds: dict[str, int] = {}
        for again in range(WALKS):
            names = sorted(_in_the_way(done.home, report) & done.rooms.keys())
            if not names or self.limit.passed or self.limit.stop.reason:
                break
            self._say(f"not all can be walked to in {', '.join(names)}: furnished anew")
            seeds |= {name: random.Random(f"walk {name} {again} {self.seed}").randrange(2**32) for name in names}
            other = self._furnished(done.home, seeds)
            verdict = check_home(other.home)
            if _reached(verdict) > _reached(report):
                done, report = other, verdict
            else:
                seeds = {name: seed for name, seed in seeds.items() if name not in names}
        self._lap("walks", began)
        return done, report


def _known(programme: Programme, name: str) -> bool:
    return any(spec.id == name for spec in programme.rooms)


def _worth(done: FurnishedHome) -> tuple[float, ...]:
    """Larger is better: rooms that are as they should be, then the grades of all."""
    rooms = list(done.rooms.values())
    grades = [room.review.total for room in rooms if room.review is not None]
    return float(sum(r.satisfied for r in rooms) - len(rooms)), round(sum(grades) / max(1, len(rooms)), 6)


def _reached(report: HomeReport) -> tuple[float, ...]:
    access = report.access
    lost = len(access.unreached_rooms) + len(access.blocked_doors)
    return float(report.valid), -float(lost), -float(len(report.violations)), round(access.walkable_share, 6)


def _in_the_way(home: Home, report: HomeReport) -> set[str]:
    """Rooms whose furniture may be why something is not walked to: those of the things, and of blocked doors; rooms
    that are not reached, and those beside them that are."""
    access = report.access
    found = {name.partition("/")[0] for name in access.unreached_objects}
    doors = {door.id: door for door in home.doors}
    for name in access.blocked_doors:
        found |= {doors[name].room, doors[name].to or doors[name].room} if name in doors else set()
    lost = {*access.unreached_rooms}
    if lost:
        graph = home.graph()
        beside = {room for name in lost for room, _ in graph[name]} - lost
        found |= beside | lost
    found |= {name for v in report.violations if v.kind in ("through_wall", "blocked_leaf", "room") for name in v.rooms}
    return found
