"""What a model answers when it plans, and what of it is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from sceneweaver.agent.memory import Call
from sceneweaver.agent.planner import Situation, seed_of
from sceneweaver.io.messages import printable_line, quote, suggest
from sceneweaver.language.by_model.leniency import absent, from_json
from sceneweaver.llm import Reply
from sceneweaver.scene import InputError

from .input_rules import check_extent

MOST_CALLS = 8
"""Calls that a plan may name."""

MOST_INPUTS = 20_000
"""Characters that the inputs of a call may have as JSON."""

SENTENCE = 600
"""Characters of what a model says that are kept, for each thing it says."""


class PlannedCall(Reply):
    """A call that may solve the problem."""

    tool: str = Field(description="Name of a tool card")
    confidence: float = Field(ge=0, le=1, description="How likely the call makes the room better")
    instruction: str = Field(description="What to do, in one or two sentences")
    inputs: Annotated[dict[str, Any] | None, BeforeValidator(lambda value: from_json(absent(value)))] = Field(
        default=None, description="As the card asks; leave it out when not sure"
    )


class Plan(Reply):
    """One step of reasoning: reflect on what was, find the problem, rank the tools, or stop."""

    last_step: str = Field(default="", description="What the last step did and whether it worked")
    solved: str = Field(default="", description="Which earlier problems are solved and which are not")
    problem: str = Field(default="", description="The most serious problem now, in one sentence")
    calls: list[PlannedCall] = Field(default=[], description="Tools that may solve it, the best first")
    stop: bool = Field(default=False, description="Whether nothing is left that is worth doing")
    stop_reason: str = ""


def checker(situation: Situation) -> Callable[[Plan], Plan]:
    """What refuses a plan, with words for the model; where some calls are good, the wrong ones are left out."""

    def check(plan: Plan) -> Plan:
        if plan.stop and not situation.whole:
            if situation.scene is None:
                raise InputError("stop: there is no room yet; begin with an initializer")
            return plan
        if not plan.calls:
            raise InputError("calls: give at least one call, or set stop and say why in stop_reason")
        good, wrong = list[PlannedCall](), list[str]()
        for k, call in enumerate(plan.calls[:MOST_CALLS]):
            try:
                _allowed(call, situation, first=not good)
                good.append(call)
            except InputError as error:
                wrong.append(f"calls[{k}]: {error}")
        if not good:
            raise InputError("; ".join(wrong))
        return plan.model_copy(update={"calls": good})

    return check


def calls_of(plan: Plan, situation: Situation) -> tuple[Call, ...]:
    """The calls of a plan that was let through, with their confidence times the record of their tools, best first."""
    memory, found = situation.memory, dict[str, Call]()
    for planned in plan.calls:
        call = _call(planned, situation)
        trust = memory.confidence.get(call.tool, 1.0)
        call = call.model_copy(update={"confidence": round(planned.confidence * trust, 4)})
        found.setdefault(call.signature, call)
    if situation.whole:
        return tuple(found.values())
    return tuple(sorted(found.values(), key=lambda call: -call.confidence))  # equal ones in the model's order


def _allowed(planned: PlannedCall, situation: Situation, first: bool) -> None:
    """InputError for a call of an unknown tool, of one that does not fit here, with wrong inputs, or in vain before."""
    card = situation.cards.get(planned.tool)
    if card is None:
        raise InputError(f"tool {quote(planned.tool)} is unknown{suggest(planned.tool[:100], situation.cards)}")
    beginning = situation.scene is None and (first or not situation.whole)
    if (card.role == "initializer") != beginning:
        known = ", ".join(name for name, c in situation.cards.items() if (c.role == "initializer") == beginning)
        why = "there is no room yet" if beginning else "there is a room already, which it would throw away"
        raise InputError(f"tool {card.name} cannot be used now: {why}; use one of {known}")
    if planned.inputs is not None:
        if withheld := sorted(set(card.withheld) & set(planned.inputs)):
            raise InputError(f"tool {card.name}: inputs.{withheld[0]} is not for you to give; leave it out")
        check_extent(planned.inputs)
        card.check(planned.inputs)
        if len(json.dumps(planned.inputs)) > MOST_INPUTS:
            raise InputError(f"tool {card.name}: inputs are longer than {MOST_INPUTS} characters; say less")
    if _call(planned, situation).signature in situation.memory.failed:
        raise InputError(f"tool {card.name}: this call brought nothing before; change its inputs or take another tool")


def _call(planned: PlannedCall, situation: Situation) -> Call:
    settings, memory = situation.settings, situation.memory
    beginning = situation.cards[planned.tool].role == "initializer"
    return Call(
        tool=planned.tool,
        instruction=printable_line(planned.instruction, SENTENCE),
        inputs=planned.inputs or {},
        seed=settings.seed if beginning else seed_of(settings.seed, len(memory.steps), planned.tool),
        confidence=planned.confidence,
        reason="chosen by the model",
        fill=planned.inputs is None and not beginning,  # initializers read the request themselves
        by_model=True,
    )
