"""A planner that asks a language model, and the rules in its place where that gives no plan."""

from __future__ import annotations

from dataclasses import dataclass, field

from sceneweaver.agent.memory import Call, Thought
from sceneweaver.agent.planner import RulesPlanner, Situation, beginnings
from sceneweaver.io.messages import shorten
from sceneweaver.layout.devices import pick_devices
from sceneweaver.llm import BudgetSpent, ModelClient, ModelError, ModelUnreachable, Picture
from sceneweaver.scene import SceneWeaverError

from .pictures import top_picture
from .plan_reply import SENTENCE, Plan, calls_of, checker
from .plan_text import content, instructions

RETRIES = 3
"""Times that a plan is refused with the validator's words before the rules plan the step."""


BEGINNINGS = 2
"""Steps in which the model may begin a room in vain before the rules do."""


@dataclass
class ModelPlanner:
    """Reasons, ranks tools and says when to stop, by one structured answer a step.

    Everything that the model says is checked: tools, inputs, calls in vain. Where it gives no answer that passes, the
    rules plan the step; where it cannot be asked any more, they plan all that follow. ``lost`` says why.
    """

    client: ModelClient
    lost: str = ""
    rules: RulesPlanner = field(default_factory=RulesPlanner)
    name: str = "llm"

    @property
    def thinking(self) -> bool:
        """Whether the model is still there to decide."""
        return not self.lost

    def plan(self, situation: Situation) -> list[Call]:
        """As `Planner.plan`."""
        return list(self.think(situation).ranked[: situation.settings.side_by_side])

    def think(self, situation: Situation) -> Thought:
        """As `Thinker.think`."""
        if self.lost:
            return self._by_rules(situation)
        number = len(situation.memory.steps) + 1
        if situation.scene is None and number > BEGINNINGS:
            return self._by_rules(situation, f"step {number}: the rules planned, as no call of the model began a room")
        try:
            plan = self.client.ask(
                "plan",
                Plan,
                instructions(situation),
                [content(situation), *self._pictures(situation)],
                check=checker(situation),
                retries=RETRIES,
            )
        except ModelError as error:
            gone = isinstance(error, ModelUnreachable | BudgetSpent) or bool(self.client.lost)
            if not gone:
                return self._by_rules(situation, f"step {number}: the rules planned, not the model ({error})")
            self.lost = str(error)
            return self._by_rules(situation, f"planned by rules from step {number}, without the model ({error})")
        said = Thought(
            by=self.client.name,
            last_step=shorten(plan.last_step, SENTENCE),
            solved=shorten(plan.solved, SENTENCE),
            problem=shorten(plan.problem, SENTENCE),
            ranked=() if plan.stop and not situation.whole else calls_of(plan, situation),
            stop=(shorten(plan.stop_reason, SENTENCE) or "nothing is worth doing") if plan.stop else "",
        )
        if said.stop and not situation.whole:
            return self._stopped(said, situation)
        if situation.scene is None and not situation.whole:
            return said.model_copy(update={"ranked": _drawn_again(said.ranked, situation)})
        return said

    def _stopped(self, said: Thought, situation: Situation) -> Thought:
        """A stop, or what the rules do instead while the scene is not valid or lacks what a tool can bring; once."""
        report, review = situation.report, situation.review
        asked = [] if review is None else [f for f in review.faults if f.criterion == "alignment" and f.tool]
        mendable = [f for f in asked if f.tool in situation.cards]
        if report is None or (report.valid and not mendable):
            return said
        if any(step.plan is not None and step.plan.overruled for step in situation.memory.steps):
            return said
        calls = self.rules.plan(situation)
        if not calls:
            return said
        why = "the scene is not valid" if not report.valid else f"what was asked for is missing: {mendable[0].reason}"
        number = len(situation.memory.steps) + 1
        note = f"step {number}: the model would have stopped ({said.stop}), but {why}; the rules planned one step more"
        return said.model_copy(
            update={"by": "rules", "ranked": tuple(calls), "stop": "", "overruled": said.stop, "note": note}
        )

    def _by_rules(self, situation: Situation, note: str = "") -> Thought:
        return Thought(ranked=tuple(self.rules.plan(situation)), note=note)

    def _pictures(self, situation: Situation) -> list[Picture]:
        """The top view with its marks, where the model takes pictures and it can be drawn."""
        if situation.scene is None or not self.client.pictures:
            return []
        if (shown := self.client.shown("plan")) is not None:
            return [*shown]
        load = situation.library.load if situation.library is not None else None
        try:
            return [top_picture(situation.scene, load, device=pick_devices(situation.settings.device)[0])]
        except SceneWeaverError:
            return []


def _drawn_again(calls: tuple[Call, ...], situation: Situation) -> tuple[Call, ...]:
    """The ways to begin; one alone gets another draw beside it, as rooms differ with the seed."""
    if len(calls) != 1 or calls[0].tool == "init_llm":
        return calls
    again = [c for c in beginnings(situation) if c.tool == calls[0].tool and c.seed != calls[0].seed]
    return (*calls, *(c.model_copy(update={"instruction": calls[0].instruction}) for c in again[:1]))
