"""The model of a run: what it is asked for, and who does that in its place."""

from __future__ import annotations

import math
import time
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Self

from sceneweaver.agent.executor import Outcome
from sceneweaver.agent.folder import RunFolder
from sceneweaver.agent.loop import Run
from sceneweaver.agent.memory import Call
from sceneweaver.agent.planner import Planner, RulesPlanner
from sceneweaver.agent.result import ModelUse
from sceneweaver.agent.roles import Roles
from sceneweaver.agent.transcript import NAME, transcript
from sceneweaver.io import write_atomic
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.language.by_model.reader import read_by_model
from sceneweaver.layout.devices import pick_devices
from sceneweaver.llm import ModelClient, ModelError
from sceneweaver.llm.opening import records_of
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.scene import InputError
from sceneweaver.tools.base import Context
from sceneweaver.tools.registry import Registered

from .asking import Asking
from .critic import look
from .inputs import filled, try_out
from .planner import ModelPlanner
from .rooms import learned_room, rooms_of_run

UNKNOWN = "is no kind of room that is known"
"""How the note of a reader ends where it is so."""

SOON = 1.0
"""Seconds left below which a model that gives no answer is no reason to end a strict run in another way."""

SHARE, RULES, LEAST = 0.5, 6.0, 10.0
"""How much of the time is kept from the model as long as there is no room, for the rules to make one: a share of it at
most; how often as long as starting up they take, and seconds [s] at least."""

RECORDS = "llm"
"""Folder of what was asked, in that of a run."""


@dataclass
class Session:
    """Who does what in one run. ``client`` is None where no model has anything to do.

    The client is told how much time is left by ``deadline``, that of the run once there is one, and whether its stop is
    asked for. ``waited`` are the
    seconds that it took to read the request, ``reserve`` those that it may not take as long as there is no room.
    ``begins`` says whether it writes down the room that the run begins with, whoever plans.
    """

    roles: Roles
    client: ModelClient | None = None
    deadline: Deadline = NEVER
    records: Path | None = None
    replay: Path | None = None
    read_by: str = "rules"
    disagreements: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    waited: float = 0.0
    reserve: float = 0.0
    run: Run | None = None
    begins: bool = False

    @classmethod
    def opened(
        cls,
        roles: Roles,
        asking: Asking,
        deadline: Deadline,
        records: Path | None,
        started: float = 0.0,
        begins: bool = False,
    ) -> Self:
        """A session with a model, if the roles ask for one or it begins, in a run that took so many seconds to start.

        Raises:
            InputError: when something is wrong with an argument.
            MissingDependencyError: when a model is needed and none is there.
        """
        session = cls(roles, deadline=deadline, begins=begins)
        session.reserve = 0.0 if math.isinf(deadline.left) else min(SHARE * deadline.left, max(LEAST, RULES * started))
        if roles.by_model or begins:
            session.records, session.replay = records, records_of(asking.replay) if asking.replay else None
            session.client = asking.client(
                records,
                lambda: session.left,
                lambda: bool(deadline.stop.reason),
                lambda: bool(deadline.stop.reason) or session.time.left < SOON,
            )
            session.client.keep()  # a run that is killed before its first step is over has saved nothing of its own
        return session

    @property
    def time(self) -> Deadline:
        """When the search of the run has to be done."""
        return self.deadline if self.run is None else self.run.deadline

    @property
    def left(self) -> float:
        """Seconds that the model may take from now on."""
        begun = self.run is not None and self.run.best is not None
        return self.time.left - (0.0 if begun else self.reserve)

    def known_rooms(self, prompt: str) -> AbstractContextManager[None]:
        """Within it the run knows the kinds of rooms that it knew when it began."""
        return rooms_of_run(prompt, self.records, self.replay) if self.client is not None else nullcontext()

    def read(self, offline: SceneGraph, folder: RunFolder | None) -> SceneGraph:
        """The request as a model reads it, or as the rules read it where none is to, or gives no reading.

        A kind of room that nobody knows is learned. A run goes on with the reading that it began with.
        """
        kept = folder.kept() if folder is not None else None
        brief, began = offline, time.monotonic()
        if self.client is not None:
            offline = read_request(offline.text)  # with the rooms of the run
            if kept is not None and kept.memory.steps and kept.roles.by_model:
                brief = SceneGraph.model_validate(kept.brief)
                self.read_by, self.disagreements = kept.read_by, kept.disagreements
            else:
                brief = self._learned(*self._read(self.client, offline))
        self.waited = time.monotonic() - began
        if folder is not None:
            folder.roles, folder.read_by, folder.disagreements = self.roles, self.read_by, self.disagreements
        return brief

    def _read(self, client: ModelClient, offline: SceneGraph) -> tuple[SceneGraph, str]:
        """A reading, and the kind of room in it, in words."""
        if self.roles.reader != "llm":
            return offline, offline.room_words
        try:
            reading = read_by_model(client, offline.text, offline)
        except ModelError as error:
            self.notes = (*self.notes, f"the request was read by rules, not by the model ({error})")
            return offline, offline.room_words
        self.read_by, self.disagreements = client.name, tuple(str(row) for row in reading.disagreements)
        return reading.graph, reading.room or reading.graph.room_words

    def _learned(self, brief: SceneGraph, words: str) -> SceneGraph:
        """A reading with the kind of room that its words name; where they name none, nobody learns any."""
        if self.client is None or self.client.lost or brief.room_type is not None or not words.strip():
            return brief
        try:
            room = learned_room(self.client, words, self.records, keep=self.replay is None)
        except InputError:
            return brief
        except ModelError as error:
            self.notes = (*self.notes, f"'{words}' was not learned as a kind of room ({error})")
            return brief
        said = tuple(note for note in brief.notes if not note.endswith(UNKNOWN))
        known = f"'{words}' is a kind of room as a model described it"
        unread = tuple(left for left in brief.unread if left.words != brief.room_words)
        return brief.model_copy(update={"room_type": room.name, "notes": (*said, known), "unread": unread})

    def serve(self, run: Run) -> None:
        """Give a run what asks the model in it."""
        self.run = run
        if self.client is not None:
            run.kept = self.keep
        if self.in_tools:
            run.client = self.client
        if self.plans:
            run.fill = self.fill
        if self.roles.critic == "vlm":
            run.look = self.look

    @property
    def planner(self) -> Planner:
        """Who plans."""
        return ModelPlanner(self.client) if self.plans and self.client is not None else RulesPlanner()

    @property
    def plans(self) -> bool:
        """Whether a model plans, and so works in tools as well."""
        return self.roles.planner == "llm"

    @property
    def in_tools(self) -> bool:
        """Whether a model works in tools."""
        return self.plans or self.begins

    def fill(self, tool: Registered, context: Context, call: Call) -> Call:
        """A call that a model chose, with inputs that were tried out: those that it gave, or where these are refused or
        there are none, others that it is asked for.

        Raises:
            ModelError: when the model gives none.
            InputError: when the tool does not load.
        """
        assert self.client is not None
        if not call.fill and tool.card.role == "initializer":
            return call
        if not call.fill:
            try:
                return try_out(tool, context, call)
            except InputError as error:
                call = call.model_copy(update={"reason": f"these inputs were refused: {error}"})
        return filled(self.client, tool, context, call)

    def look(self, outcome: Outcome) -> Outcome:
        """An outcome with what a critic by vision sees of it in its review, or as it was where it gives no answer."""
        assert self.client is not None and self.run is not None
        run = self.run
        if self.client.lost or run.deadline.passed:
            return outcome
        try:
            with run.deadline.enforced():
                seen = look(
                    self.client,
                    outcome.scene,
                    outcome.report,
                    run.brief,
                    run.room_type,
                    run.library,
                    samples=self.roles.samples,
                    device=pick_devices(run.settings.device)[0],
                    deadline=run.deadline,
                )
        except (ModelError, TimeUp) as error:
            why = "time was up" if isinstance(error, TimeUp) else str(error)
            run.notes = (*run.notes, f"the critic by vision gave no answer ({why})")
            return outcome
        return replace(outcome, review=outcome.review.model_copy(update={"seen": seen}))

    def keep(self) -> None:
        """Mark what was asked as part of what is saved, and write the transcript."""
        assert self.client is not None and self.run is not None
        self.client.keep()
        if self.records is not None:
            text = transcript(self.run.brief.text, self.run.memory, self.read_by, self.disagreements)
            write_atomic(self.records / NAME, text, within=self.records.parent)

    def use(self) -> ModelUse | None:
        """What the model did; None where it had nothing to do."""
        if self.client is None or self.run is None:
            return None
        self.keep()
        return ModelUse(
            name=self.client.name,
            roles=self.roles,
            planned=tuple(step.plan.by if step.plan is not None else "rules" for step in self.run.memory.steps),
            read=self.read_by,
            lost=self.client.lost,
            disagreements=self.disagreements,
            usage=self.client.usage.to_dict(),
        )
