"""The calls of the next step: planned anew, or from a plan that was made once."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .memory import Call, Memory, Thought
from .planner import LISTS, Planner, RulesPlanner, Situation, Thinker, told_beginnings

BLIND_PLAN = ("init_prior", "add_tabletop", "add_crowd", "add_wall_objects", "update_layout")
"""What is done, in this order, when there is no reflection: the tools that need not be told where to act."""

WHOLE_PLAN = 8
"""Calls of a plan that is made once, at most."""


@dataclass(frozen=True)
class Planned:
    """The calls of a step, the memory with what was decided, and what a planner that thinks said."""

    calls: tuple[Call, ...]
    memory: Memory
    thought: Thought | None = None

    @property
    def by_model(self) -> bool:
        """Whether a model made the plan."""
        return self.thought is not None and self.thought.by != "rules"


def next_calls(planner: Planner, situation: Situation) -> Planned:
    """What to try next; no calls when nothing is left to do."""
    settings, memory = situation.settings, situation.memory
    at = len(memory.steps)
    if situation.scene is None and (told := told_beginnings(situation)):
        return Planned(tuple(told), memory)
    free = not settings.reflect or settings.one_shot
    if situation.scene is None and at >= (1 if free else settings.steps) and isinstance(planner, Thinker):
        return _rescued(situation)
    if not settings.reflect:
        return _following(planner, replace(situation, whole=True), at - _vain_beginnings(memory))
    if not settings.one_shot:
        return _asked(planner, situation)
    if situation.scene is None:
        first = _asked(planner, situation)
        return replace(first, calls=first.calls[:1])
    wide = settings.model_copy(update={"side_by_side": WHOLE_PLAN})
    return _following(planner, replace(situation, whole=True, settings=wide), at - 1 - _vain_beginnings(memory))


def _vain_beginnings(memory: Memory) -> int:
    """Steps in which a beginning by a model failed and the rules' took its place in the plan."""
    return int(len(memory.steps) > 1 and not memory.steps[0].accepted and memory.steps[0].plan is not None)


def _rescued(situation: Situation) -> Planned:
    """The beginning by rules where no call of a model began a room and it may try no more: no run ends without one."""
    calls = tuple(RulesPlanner().plan(situation)[:1])
    note = f"step {len(situation.memory.steps) + 1}: the rules began the room, as no call of the model did"
    return Planned(calls, situation.memory.noted(note), Thought(ranked=calls, note=note))


def _asked(planner: Planner, situation: Situation) -> Planned:
    """What a planner says."""
    most = situation.settings.side_by_side
    if not isinstance(planner, Thinker):
        return Planned(tuple(planner.plan(situation)), situation.memory)
    thought = planner.think(situation)
    calls = thought.ranked if situation.whole else thought.ranked[:most]
    return Planned(calls, situation.memory.noted(thought.note), thought)


def _following(planner: Planner, situation: Situation, at: int) -> Planned:
    """The call at a place of the plan that is made once, and kept in the memory."""
    memory = situation.memory
    if memory.plan is not None:
        return Planned(memory.plan[at : at + 1], memory)
    blind = not situation.settings.reflect
    if blind and not isinstance(planner, Thinker):
        return Planned(_usual(situation)[at : at + 1], memory)
    made = _asked(planner, situation)
    plan = made.calls
    if not made.by_model:
        plan = _usual(situation) if blind else _once(plan)
    return replace(made, calls=plan[at : at + 1], memory=made.memory.model_copy(update={"plan": plan}))


def _usual(situation: Situation) -> tuple[Call, ...]:
    names = [name for name in BLIND_PLAN if name in situation.cards]
    return tuple(Call(tool=name, seed=situation.settings.seed, reason="fixed plan") for name in names)


def _once(calls: tuple[Call, ...]) -> tuple[Call, ...]:
    """Of calls for all faults and for one of them, that for all."""
    before = [{c.tool for c in calls[:k]} for k in range(len(calls))]
    return tuple(c for c, done in zip(calls, before, strict=True) if c.tool not in LISTS or c.tool not in done)
