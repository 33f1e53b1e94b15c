"""What the agent remembers: the calls it made, what came of them, and how far each tool is to be trusted."""

from __future__ import annotations

from pydantic import Field

from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import JsonDict

FORGIVING = 0.6
"""Factor on a tool's confidence when a call of it brought nothing."""


class Call(FrozenModel):
    """One use of a tool; ``confidence`` in 0..1 and ``reason`` say why it was chosen.

    With ``fill`` a model writes the inputs when the call is carried out, from the instruction and the scene then. Those
    of a call that is ``by_model`` are tried out first.
    """

    tool: str
    instruction: str = ""
    inputs: JsonDict = {}
    seed: int = 0
    confidence: float = 1.0
    reason: str = ""
    fill: bool = False
    by_model: bool = False

    @property
    def signature(self) -> str:
        """Equal for calls that ask for the same."""
        import json

        inputs = {"instruction": self.instruction} if self.fill else self.inputs
        return f"{self.tool} {json.dumps(inputs, sort_keys=True)}"

    @classmethod
    def of(cls, signature: str) -> Call:
        """A call with a signature."""
        import json

        tool, _, inputs = signature.partition(" ")
        return cls(tool=tool, inputs=json.loads(inputs))


class Thought(FrozenModel):
    """What a planner said before a step.

    ``ranked`` are all the calls that it named, the best first, with its confidence times the record of their tools; the
    first few are carried out. ``stop`` says why to end here instead, empty to go on.
    """

    by: str = Field(default="rules", description="rules, or the name of the model")
    last_step: str = Field(default="", description="What the step before did")
    solved: str = Field(default="", description="Which earlier problems are solved")
    problem: str = Field(default="", description="The most serious problem now")
    ranked: tuple[Call, ...] = ()
    stop: str = ""
    overruled: str = Field(default="", description="Why the model would have stopped, where it was not allowed to")
    note: str = Field(default="", description="Why the rules planned in the model's place")


class Step(FrozenModel):
    """What one step did. ``tried`` holds every call of it with what it reached or why it failed.

    ``plan`` is what a model thought before it; None where none was asked.
    """

    number: int
    call: Call | None
    accepted: bool
    before: dict[str, float] = {}
    after: dict[str, float] = {}
    violations: int = 0
    objects: int = 0
    seconds: float = 0.0
    tried: tuple[JsonDict, ...] = ()
    note: str = ""
    plan: Thought | None = None


class Memory(FrozenModel):
    """The history of a run; its JSON form is all that a run needs to go on, besides the scene."""

    steps: tuple[Step, ...] = ()
    confidence: dict[str, float] = Field(default={}, description="Factor on each tool's own confidence")
    failed: tuple[str, ...] = Field(default=(), description="Signatures of calls that brought nothing")
    seconds: float = 0.0
    attempts: int = Field(default=0, ge=0, description="Layouts begun anew, for all candidates")
    stale: int = 0
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    plan: tuple[Call, ...] | None = Field(default=None, description="What is to be done, where that is decided once")
    finished: str = Field(default="", description="Why the run ended; empty while it goes on")
    spent: bool = Field(
        default=False, description="Whether it ended with a budget, so that it goes on with a larger one"
    )

    def after(
        self, step: Step, losers: list[Call], notes: tuple[str, ...], unmet: tuple[str, ...], attempts: int = 0
    ) -> Memory:
        """The memory with one more step; calls that brought nothing lower the trust in their tools."""
        confidence = dict(self.confidence)
        failed = list(self.failed)
        for call in losers:
            confidence[call.tool] = FORGIVING * confidence.get(call.tool, 1.0)
            failed.append(call.signature)
        if step.accepted and step.call is not None:
            confidence[step.call.tool] = min(1.0, confidence.get(step.call.tool, 1.0) / FORGIVING**0.5)
        return self.model_copy(
            update={
                "steps": (*self.steps, step),
                "confidence": confidence,
                "failed": tuple(failed),
                "seconds": self.seconds + step.seconds,
                "attempts": self.attempts + attempts,
                "stale": 0 if step.accepted else self.stale + 1,
                "notes": _more(self.notes, notes),
                "unmet": _more(self.unmet, unmet),
            }
        )

    def noted(self, *notes: str) -> Memory:
        """The memory with some more notes."""
        return self.model_copy(update={"notes": _more(self.notes, tuple(note for note in notes if note))})


def _more(old: tuple[str, ...], new: tuple[str, ...]) -> tuple[str, ...]:
    return (*old, *(text for text in dict.fromkeys(new) if text not in old))
