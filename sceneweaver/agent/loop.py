"""Reason, act, reflect: the loop of the agent."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.critic import CRITERIA, Review
from sceneweaver.generate.shell import floor_area, shell_of
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.language import SceneGraph
from sceneweaver.llm import ModelClient, ModelError
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.scene import InputError, Room, Scene, SceneWeaverError
from sceneweaver.tools.base import Context, Proposal, Tool
from sceneweaver.tools.registry import Registered
from sceneweaver.verify import check

from .executor import Executor, Outcome
from .faults import fault
from .folder import RunFolder
from .learned_starts import learned_starts
from .memory import Call, Memory, Step, Thought
from .planner import Planner, Situation, Thinker
from .plans import next_calls
from .relaxation import REASON, cleared
from .schedule import EXPECTED, GROWTH, LEAST, Schedule
from .settings import Settings
from .sight import Look, looked
from .starting import Starting

GRACE, FIRST_GRACE, LEAST_GRACE = 0.1, 0.4, 1.0
"""How much of the time kept for what comes after a step has to end in good order, how much as long as there is no
layout, and how many seconds at least."""

REVIEW = 0.5
"""How much of the time kept for what comes after has passed when a last review has to be done."""

JUDGED = 0.25
"""Share of the time kept for what comes after the search that the judgement may take at most."""

WAIT = 0.5
"""Share of the time left that a model of scenes may take for its answer."""

HURRY = 0.5
"""Share of the time left when a tool begins after which it has to hurry."""

MOST_LEFT, SAID = 4, 240
"""Sentences that a step keeps of what gave way in an outcome, and characters of each."""

MESSY = 0.9
"""How lived-in a room is of which the request says that it is messy or full, where nobody sets that."""

NOTHING_YET = "time was up before anything was placed"

Said = Callable[[Step], None]

Fill = Callable[[Registered, Context, Call], Call]
"""Has a model write the inputs of a call; InputError or ModelError when it does not."""

GOOD = {"layout": 0.85, "functionality": 0.87}
"""Shares of the grades without a fault from which on a first layout that lacks nothing is taken without another draw;
what is needed and out of reach takes more off functionality than is left."""

MANY_SEARCHES = 5
"""Searches of a first layout from which on the room is not drawn again: what it asks for has no place in another draw
either, and that takes as long."""


@dataclass
class Run:
    """One request on its way to a scene.

    ``memory`` and ``best`` are what the steps led to. What the end of the run adds is apart from them, so that a run
    which goes on in its folder does not see it: ``notes``, ``unmet``, what cut it off (``cut_off``), and the tools that
    broke down (``undone``). ``limit`` is when all has to be done, ``deadline`` when the search has, and ``schedule``
    says how much is kept in between; what it keeps for the judgement is in ``closing``. ``client`` is for tools that
    ask a model, ``fill`` and ``look`` ask one; None where there is none. ``kept`` is called when a step is over and
    written. ``thought`` is the last plan. ``starting`` says what the room begins with, ``origin`` is the scene of
    somebody else that it began with, as it was; None: it began with none.
    """

    brief: SceneGraph
    room_type: RoomType
    settings: Settings
    tools: Mapping[str, Registered]
    planner: Planner
    library: Library = field(default_factory=Library)
    folder: RunFolder | None = None
    deadline: Deadline = NEVER
    limit: Deadline = NEVER
    schedule: Schedule | None = None
    said: Said | None = None
    client: ModelClient | None = None
    fill: Fill | None = None
    look: Look | None = None
    kept: Callable[[], None] | None = None
    thought: Thought | None = None
    starting: Starting = Starting()
    origin: Scene | None = None
    memory: Memory = Memory()
    best: Outcome | None = None
    first: Outcome | None = None
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    undone: tuple[str, ...] = ()
    cut_off: str = ""
    _judgement: float = 0.0
    _origins: dict[int, Scene | None] = field(default_factory=dict)

    def go(self) -> Outcome:
        """Take steps until the scene is good, nothing more can be mended, or the budget is spent.

        Returns:
            The best scene, without what is wrong in its layout. When time is up before the first step ends, that is the
            best layout so far or, before there is one, the empty room; the step does not count, and a run that goes on
            in the folder takes it again.

        Raises:
            InputError: when not even a first scene can be made.
        """
        executor = Executor(self.room_type, self.brief, self.settings, self.library, self.deadline, found=self._offer)
        if self.starting.kept.init == "prior":
            executor.starts, why = learned_starts()
            self.notes = (*self.notes, *([why] if why else ()))
        if self.best is None and self.folder is not None:
            bare = self._bare()
            self.folder.keep(bare, check(bare))
        self.limit.stop.ready = True
        reason, spent = self.memory.finished, self.memory.spent
        while not reason:
            if self.best is not None:
                self._divided(len(self.best.scene.objects) + GROWTH)
                executor.deadline = self.deadline
            reason = self._spent()
            spent = bool(reason)
            if reason or (reason := self._done()):
                break
            started, executor.attempts = time.monotonic(), 0
            calls = self._calls()
            if not calls:
                reason = self._stopped()
                break
            outcomes, tried = self._tried(executor, calls)
            if tried:  # else time ran out before the first
                self._take(outcomes, tried, calls[: len(tried)], time.monotonic() - started, executor.attempts)
            elif self.best is None:
                reason, spent = self._cut(), True
        best = self.best
        if best is None and (self.cut_off or self.undone):
            best = self.first
            if best is None:
                bare = self._bare()
                first = Outcome(bare, check(bare), Review(grades=dict.fromkeys(CRITERIA, 0.0)))
                best = replace(self._judged(executor, first), unmet=(NOTHING_YET,) if self.cut_off else ())
            self.notes, self.unmet = best.notes, best.unmet
        if best is None:
            raise InputError("prompt: " + (self.memory.steps[-1].note if self.memory.steps else "no tool can begin"))
        self.memory = self.memory.model_copy(update={"finished": reason, "spent": spent})
        if self.folder is not None:
            self.folder.state(self.folder.kept_scene(), self.memory, self.brief, self.settings)
        if best.faults and self.settings.physics:
            lighter, report = cleared(best.scene, best.report)
            self.notes, self.unmet = (*self.notes, *lighter.notes), (*self.unmet, *lighter.unmet)
            best = self._judged(executor, replace(best, scene=lighter.scene, report=report))
        return best

    def _bare(self) -> Scene:
        """The room with nothing in it."""
        empty = empty_scene(self.brief, self.room_type)
        setup, begin = self.context(empty, self.settings.seed), self.settings.begin
        area = floor_area(self.room_type, self.brief, self.settings.seed, begin.room)[0]
        return empty.model_copy(update={"room": shell_of(setup, area)[0]})

    @property
    def closing(self) -> Deadline:
        """When the judgement of the best scene has to be done."""
        return self.deadline.before(-min(self._judgement, self.deadline.margin))

    def divide(self, limit: Deadline) -> None:
        """Begin with a time limit, of which the schedule keeps a part from the search."""
        self.limit = limit
        self._divided(EXPECTED)

    def _divided(self, objects: int) -> None:
        """Keep as much from the search as a room of so many objects needs."""
        if self.schedule is None:
            return
        schedule = replace(self.schedule, objects=objects)
        seconds = self.settings.seconds
        kept = schedule.kept(seconds) if seconds else LEAST + schedule.judgement
        self._judgement = min(schedule.judgement, JUDGED * kept)
        self.deadline = self.limit.before(kept)

    def _judged(self, executor: Executor, outcome: Outcome) -> Outcome:
        """A last outcome with a review of its own, if there is time for one."""
        try:
            with self.deadline.before(-REVIEW * self.deadline.margin).enforced():
                return executor.judged(outcome.scene, outcome.report)
        except TimeUp:
            return outcome

    def _offer(self, outcome: Outcome) -> None:
        """Keep a layout of the first step, in case that time is up before it ends."""
        if self.best is None and (self.first is None or outcome.key < self.first.key):
            self.first = outcome
            self._keep(outcome)

    def _keep(self, outcome: Outcome) -> None:
        """Write a scene to the folder, without what is wrong in its layout."""
        if self.folder is not None:
            lighter, report = cleared(outcome.scene, outcome.report)
            self.folder.keep(lighter.scene, report)

    def _grace(self) -> float:
        """Seconds after the deadline that a step has to end."""
        nothing = self.best is None and self.first is None
        return max(LEAST_GRACE, (FIRST_GRACE if nothing else GRACE) * self.deadline.margin)

    def _cut(self) -> str:
        """Note that time is up, and say why."""
        seconds, kept = self.settings.seconds or 0.0, self.deadline.margin
        rest = f", {kept:.0f} of them kept for judgement, files and pictures" if kept >= 0.5 else ""
        self.cut_off = self.deadline.stop.reason or f"{seconds:g} seconds{rest}"
        return self.cut_off

    def _spent(self) -> str:
        """The budget that is spent; empty when there is some left of each."""
        s, memory = self.settings, self.memory
        if self.best is not None and self.deadline.passed:
            return self._cut()
        rescue = self.best is None and isinstance(self.planner, Thinker)  # no run of a model ends without a room
        if len(memory.steps) >= s.steps + rescue:
            return f"{s.steps} steps"
        if memory.attempts >= s.work:
            return f"{s.work} attempts"
        return ""

    def _done(self) -> str:
        """Why the scene is as good as it gets; empty to go on."""
        s, memory = self.settings, self.memory
        if self._free:
            return ""
        if isinstance(self.planner, Thinker) and self.planner.thinking:  # it says itself when to stop
            vain = sum(not step.accepted for step in memory.steps)
            return f"{vain} steps brought nothing" if self.best is not None and vain > s.replans else ""
        if memory.stale >= s.patience:
            return f"no progress in {memory.stale} steps"
        if self.best is not None and self.best.report.valid and self.best.review.to_gain <= s.to_gain:
            open_calls = any(f.tool for f in self.best.review.faults if f.points >= 0.5)
            return "" if open_calls else f"grade {self.best.review.total:.1f}"
        return ""

    def _stopped(self) -> str:
        """Why there are no more calls."""
        stop = self.thought.stop if self.thought is not None else ""
        return f"the planner stopped: {stop}" if stop else "nothing is left that a tool can mend"

    def _calls(self) -> list[Call]:
        """What to try in the next step."""
        best = self.best
        situation = Situation(
            self.brief,
            self.room_type,
            best.scene if best else None,
            best.review if best else None,
            self.memory,
            {name: tool.card for name, tool in self.tools.items()},
            self.settings,
            best.report if best else None,
            self.library,
            begin_by=self.starting.tool,
        )
        planned = next_calls(self.planner, situation)
        self.memory, self.thought = planned.memory, planned.thought
        return list(planned.calls)

    def _tried(self, executor: Executor, calls: list[Call]) -> tuple[dict[int, Outcome], list[dict[str, Any]]]:
        """What each call leads to; one that fails says why and leaves the others alone, and time may be up in one."""
        outcomes: dict[int, Outcome] = {}
        tried: list[dict[str, Any]] = []
        for k, call in enumerate(calls):
            if (self.best or outcomes) and self.deadline.passed:
                break
            row: dict[str, Any] = {"tool": call.tool, "confidence": call.confidence, "reason": call.reason}
            began = time.monotonic()
            try:
                tool = self.tools[call.tool].load()
                with self.deadline.enforced(self._grace):
                    scene = self.best.scene if self.best else empty_scene(self.brief, self.room_type)
                    call = calls[k] = self._filled(call, scene)
                    proposal = self._propose(tool, call, scene)
                    self._origins[k] = proposal.origin
                    if self.best and not proposal.edits and not proposal.fresh and proposal.scene is None:
                        row["failed"] = "nothing to change" + (f": {proposal.unmet[0]}" if proposal.unmet else "")
                    else:
                        outcomes[k] = executor.run(scene, proposal, call.seed, self._rival(outcomes))
                        row["grades"] = {**outcomes[k].review.grades, "total": round(outcomes[k].review.total, 3)}
                        row["violations"] = int(outcomes[k].key[0])
                        row |= _left(outcomes[k])
            except (InputError, ModelError) as error:
                row["failed"] = str(error)
            except SceneWeaverError:
                raise
            except TimeUp:
                break
            except Exception as error:
                row["failed"] = fault(call.tool, error)
                self.undone = (*self.undone, row["failed"])
            row["seconds"] = round(time.monotonic() - began, 3)
            tried.append(row)
            hard = executor.attempts >= MANY_SEARCHES * self.settings.attempts[0]
            told = call.tool == self.starting.tool and self.starting.kept.init != "prior"
            if self.best is None and k in outcomes and (told or hard or _complete(outcomes[k])):
                break  # another draw of the room costs as much again
        return outcomes, tried

    @property
    def _free(self) -> bool:
        """Whether what is done is kept without a comparison."""
        return not self.settings.reflect or self.settings.one_shot

    def _rival(self, outcomes: Mapping[int, Outcome]) -> Outcome | None:
        """The best that there is already where the next call of a step begins; None where no scene is compared."""
        if self._free:
            return None
        known = [*outcomes.values(), *([self.best] if self.best is not None else [])]
        return min(known, key=lambda o: o.key, default=None)

    def _filled(self, call: Call, scene: Scene) -> Call:
        """A call with its inputs: where a model chose it, tried out or written by it."""
        if self.fill is not None and call.by_model:
            context = replace(self.context(scene, call.seed), instruction=call.instruction, inputs=call.inputs)
            call = self.fill(self.tools[call.tool], context, call).model_copy(update={"fill": False})
            if call.signature in self.memory.failed and not self._free:
                raise InputError(f"tool {call.tool}: a call with these inputs brought nothing before")
        return call

    def _propose(self, tool: Tool, call: Call, scene: Scene) -> Proposal:
        left = self.deadline.left

        def hurried() -> bool:
            return self.deadline.left < HURRY * left

        return tool.propose(
            replace(self.context(scene, call.seed), instruction=call.instruction, inputs=call.inputs, hurried=hurried)
        )

    def context(self, scene: Scene, seed: int) -> Context:
        """What a tool may look at."""
        clutter = self.settings.clutter
        if clutter == CLUTTER and self.brief.density == "full":
            clutter = MESSY
        beginning = self.starting.beginning(lambda: WAIT * self.deadline.left)
        return Context(
            self.brief,
            self.room_type,
            scene,
            self.library,
            seed,
            clutter=clutter,
            client=self.client,
            beginning=beginning,
            room=self.settings.begin.room,
            palette=self.settings.begin.palette,
        )

    def _take(
        self, outcomes: dict[int, Outcome], tried: list[dict[str, Any]], calls: list[Call], spent: float, attempts: int
    ) -> None:
        """Keep the best outcome if it beats what there is; else roll back and trust the tools less."""
        began, old, free = time.monotonic(), self.best, self._free
        before = dict(old.review.grades) if old else {}
        winner = min(outcomes, key=lambda k: outcomes[k].key) if outcomes else None
        accepted = winner is not None and (old is None or free or outcomes[winner].key < old.key)
        seen = ""
        if winner is not None and self.look is not None and not (free and old is not None):
            outcomes[winner], accepted, seen = looked(old, outcomes[winner], accepted, self.look)
        vain = [k for k in range(len(calls)) if k not in outcomes or (old and outcomes[k].key >= old.key)]
        if winner is not None and (winner in vain) == accepted and seen:
            vain = [k for k in vain if k != winner] if accepted else [*vain, winner]
        losers = [] if free else [calls[k] for k in vain]
        if accepted and winner is not None:
            if old is None and (origin := self._origins.get(winner)) is not None:
                self.origin = origin
                if self.folder is not None:
                    self.folder.began(origin)
            self.best = outcomes[winner]
        current = self.best
        failed = next((row["failed"] for row in tried if "failed" in row), "no better than before")
        note = seen or ("" if accepted else failed)
        spent += time.monotonic() - began
        step = Step(
            number=len(self.memory.steps) + 1,
            call=calls[winner] if winner is not None else calls[0],
            accepted=accepted,
            before=before,
            after=dict(current.review.grades) if current else {},
            violations=int(current.key[0]) if current else 0,
            objects=len(current.scene.objects) if current else 0,
            seconds=round(spent, 3),
            tried=tuple(tried),
            note=note,
            plan=self.thought,
        )
        new: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())
        if accepted and winner is not None:
            notes, unmet = outcomes[winner].notes, outcomes[winner].unmet
            asked = self.tools[calls[winner].tool].card.role == "initializer"  # the others act on faults, not on wishes
            new = (notes, unmet) if asked else ((*notes, *unmet), ())
        self.memory = self.memory.after(step, losers, *new, attempts).noted(self._instead(old, step))
        if self.folder is not None and current is not None:
            self.folder.step(
                step.number, current.scene, current.report, current.review, self.memory, self.brief, self.settings
            )
            self._keep(current)
        if self.kept is not None:
            self.kept()
        if self.said is not None:
            self.said(step)

    def _instead(self, old: Outcome | None, step: Step) -> str:
        """What is said where the room does not begin as it was told to; empty where it does."""
        why = next((row["failed"] for row in step.tried if row["tool"] == self.starting.tool and "failed" in row), "")
        if old is not None or not why or not step.accepted or step.call is None or step.call.tool == self.starting.tool:
            return ""
        return f"{why}; the room was begun by {step.call.tool} instead"


def _left(outcome: Outcome) -> dict[str, list[str]]:
    """What gave way in an outcome, for a planner to know why it is no better."""
    dropped = (f"{gone.id} was dropped: {gone.reason}" for gone in outcome.scene.dropped)
    left = [shorten(text, SAID) for text in (*outcome.unmet, *dropped, *outcome.notes)]
    return {"left": list(dict.fromkeys(left))[:MOST_LEFT]} if left else {}


def _complete(outcome: Outcome) -> bool:
    """Whether a first layout is valid, has all that it was meant to have, and is well laid out."""
    review = outcome.review
    if any(review.grades[name] < share * review.best(name) for name, share in GOOD.items()):
        return False
    return outcome.report.valid and not (
        outcome.unmet or outcome.scene.dropped or any(REASON in note for note in outcome.notes)
    )


def empty_scene(brief: SceneGraph, room_type: RoomType) -> Scene:
    """The scene before the first step; initialisers replace its room."""
    side = max(2.0, round(room_type.area[1] ** 0.5, 2))
    outline = ((0.0, 0.0), (side, 0.0), (side, side), (0.0, side))
    return Scene(
        id=room_type.name, prompt=brief.text, room=Room(type=room_type.name, outline=outline, height=room_type.height)
    )
