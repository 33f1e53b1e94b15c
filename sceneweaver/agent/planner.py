"""Which tools to try next. A planner is a protocol; this one needs no model."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

from sceneweaver.assets import Library, resolve
from sceneweaver.critic import Fault, Review
from sceneweaver.generate.meant import decided_kinds, spared_kinds
from sceneweaver.generate.quantity import is_plain
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Scene
from sceneweaver.tools.card import ToolCard
from sceneweaver.verify import Report

from .memory import Call, Memory, Thought
from .settings import Settings

LISTS = {
    "add_objects": "objects",
    "add_relation": "relations",
    "add_tabletop": "supports",
    "add_crowd": "supports",
    "add_wall_objects": "walls",
    "remove_objects": "ids",
    "update_layout": "ids",
}
"""Tools whose calls for several faults are one call, and the input that holds what each of them asks for."""

ADDING = frozenset(("add_objects", "add_tabletop", "add_crowd", "add_wall_objects", "add_clutter"))
"""Tools that add things; where a request wants little beside what it names, only for what it asks."""

LAST_BEGINNING, ROOMIER = 4, 0.15
"""Ways to begin at most, and how much more floor each draw after the second has."""

LEANER = 0.8
"""Share of what a room usually holds that another draw of one puts into a shell that is given."""

FIRST = 6.0
"""How much more a point of what is not as asked counts than one of any other fault."""

ANEW = 1
"""Times that a whole room is laid out anew, once nothing cheaper is left to mend."""

LEAST = 0.15
"""Points [of ten] that a call should be worth."""


@dataclass(frozen=True)
class Situation:
    """What a planner knows; ``scene``, ``review`` and ``report`` are None before the first step.

    ``begin_by`` is the initialiser that a room has to begin with; None: any. ``whole`` asks for all calls from here to
    the end, which are carried out in order without looking again.
    """

    brief: SceneGraph
    room_type: RoomType
    scene: Scene | None
    review: Review | None
    memory: Memory
    cards: Mapping[str, ToolCard]
    settings: Settings
    report: Report | None = None
    library: Library | None = None
    whole: bool = False
    begin_by: str | None = None


class Planner(Protocol):
    """Chooses the calls of a step."""

    name: str

    def plan(self, situation: Situation) -> list[Call]:
        """Up to ``settings.side_by_side`` calls, the most promising first; none when nothing is left to mend."""
        ...


@runtime_checkable
class Thinker(Protocol):
    """A planner that says why, and may say that it is time to stop."""

    name: str

    def think(self, situation: Situation) -> Thought:
        """What it makes of a situation; ``ranked`` may have more calls than are carried out."""
        ...

    @property
    def thinking(self) -> bool:
        """Whether it still decides itself when to stop; False: it has to be told, as the rules are."""
        ...


class RulesPlanner:
    """Ranks tools by what the critic says they would mend, their cards' confidence and their record."""

    name = "rules"

    def plan(self, situation: Situation) -> list[Call]:
        """As `Planner.plan`."""
        if situation.scene is None or situation.review is None:
            return beginnings(situation)
        settings, memory = situation.settings, situation.memory
        calls: dict[str, Call] = {}
        for tool, faults in _by_tool(_sorted_out(_wanted(situation))).items():
            card = situation.cards.get(tool)
            if card is None:
                continue
            trust = card.confidence * memory.confidence.get(tool, 1.0)
            for chosen in _bundles(tool, faults):
                points, gain = sum(f.points for f in chosen), sum(_worth(f) for f in chosen)
                call = Call(
                    tool=tool,
                    instruction=" ".join(f.suggestion for f in chosen[:4] if f.suggestion),
                    inputs=_merged(tool, chosen),
                    seed=seed_of(settings.seed, len(memory.steps), tool),
                    confidence=round(min(1.0, trust), 4),
                    reason=f"{points:.1f} points: " + "; ".join(f.reason for f in chosen[:3]),
                )
                worth = gain * trust
                if call.signature in memory.failed or worth < LEAST:
                    continue
                if call.signature not in calls or worth > calls[call.signature].confidence:
                    calls[call.signature] = call.model_copy(update={"confidence": round(worth, 4)})
        ranked = sorted(calls.values(), key=lambda c: (-c.confidence, c.tool, c.signature))
        ranked = [c for c in ranked if not _anew(c)] or [c for c in ranked if _times_anew(memory) < ANEW][:1]
        return [c.model_copy(update={"confidence": min(1.0, c.confidence)}) for c in ranked[: settings.side_by_side]]


def beginnings(situation: Situation) -> list[Call]:
    """The initialisers that suit the request, best first; then the best again with other seeds and more floor."""
    settings, memory = situation.settings, situation.memory
    found = []
    for name, card in situation.cards.items():
        if card.role == "initializer" and card.needs is None:
            found.append((card.confidence * memory.confidence.get(name, 1.0), name))
    found.sort(key=lambda row: (-row[0], row[1]))
    if not found:
        return []
    text = situation.brief.text
    calls = [
        Call(tool=name, instruction=text, seed=settings.seed, confidence=trust, reason="there is no scene yet")
        for trust, name in found
    ]
    brief, begin = situation.brief, settings.begin
    fixed = brief.size is not None or brief.area is not None or begin.room is not None
    for k in range(len(calls), LAST_BEGINNING):
        leaner = {"fill": LEANER} if begin.room is not None else {}
        inputs = leaner if fixed else {"roomier": round(1.0 + ROOMIER * (k - len(found)), 2)}
        reason = "another draw" if fixed or k == len(found) else "another draw, with more floor"
        calls.append(
            calls[0].model_copy(update={"seed": seed_of(settings.seed, k, "init"), "inputs": inputs, "reason": reason})
        )
    first, *others = [c for c in calls if c.signature not in memory.failed or fixed]
    again = [c for c in others if c.tool == first.tool]
    rest = [c for c in others if c.tool != first.tool]
    return [first, *again[:1], *rest, *again[1:]][: settings.side_by_side]


def told_beginnings(situation: Situation) -> list[Call]:
    """The initialiser that somebody told the room to begin with, then the best other one in case that it brings
    nothing; empty where nobody told any, or both brought nothing."""
    tool, memory = situation.begin_by, situation.memory
    if tool is None:
        return []
    usual = beginnings(situation)
    if situation.cards[tool].needs is None and any(call.tool == tool for call in usual):
        own = [call for call in usual if call.tool == tool]
    else:
        reason = "the design was told to begin so"
        own = [Call(tool=tool, instruction=situation.brief.text, seed=situation.settings.seed, reason=reason)]
    others = [call for call in usual if call.tool != tool][:1] if situation.settings.begin.start is None else []
    return [call for call in (*own, *others) if call.signature not in memory.failed]


def _anew(call: Call) -> bool:
    """Whether a call lays out the whole room anew, which takes as long as its first layout."""
    return call.tool == "update_layout" and not call.inputs.get("ids")


def _times_anew(memory: Memory) -> int:
    """How often the whole room was laid out anew."""
    known = [*(Call.of(name) for name in memory.failed), *(step.call for step in memory.steps if step.accepted)]
    return sum(call is not None and _anew(call) for call in known)


def _wanted(situation: Situation) -> list[Fault]:
    """The faults, without those that would add what is of a kind that the request names, beside what it asks for, what
    does not belong in such a room, or anything where little is wanted."""
    named = decided_kinds(situation.brief, situation.room_type) | spared_kinds(situation.brief, situation.room_type)
    kept = []
    plain = is_plain(situation.brief)
    for fault in situation.review.faults if situation.review is not None else ():
        if plain and fault.tool in ADDING and fault.criterion != "alignment":
            continue
        if fault.tool == "add_objects" and fault.criterion != "alignment":
            rows = [row for row in fault.inputs.get("objects", ()) if resolve(row["category"]).category not in named]
            if not rows:
                continue
            fault = fault.model_copy(update={"inputs": {**fault.inputs, "objects": rows}})
        kept.append(fault)
    return kept


def _sorted_out(faults: Sequence[Fault]) -> list[Fault]:
    """The faults, where shelves are not filled that another fault wants arranged."""
    laid = {object_id for f in faults if f.tool == "add_tabletop" for object_id in f.inputs.get("supports", ())}
    kept = []
    for fault in faults:
        if fault.tool == "add_crowd" and laid:
            supports = [object_id for object_id in fault.inputs.get("supports", ()) if object_id not in laid]
            if not supports:
                continue
            fault = fault.model_copy(update={"inputs": {**fault.inputs, "supports": supports}})
        kept.append(fault)
    return kept


def _by_tool(faults: Sequence[Fault]) -> dict[str, list[Fault]]:
    found: dict[str, list[Fault]] = {}
    for fault in faults:
        if fault.tool is not None:
            found.setdefault(fault.tool, []).append(fault)
    return found


def _worth(fault: Fault) -> float:
    """Points of a fault, by which calls are ranked."""
    return fault.points * (FIRST if fault.criterion == "alignment" else 1.0)


def _bundles(tool: str, faults: list[Fault]) -> list[list[Fault]]:
    """All of a tool's faults in one call where that is possible, those of what was asked for, and the gravest alone."""
    if tool not in LISTS or len(faults) == 1:
        return [[fault] for fault in faults]
    asked = [fault for fault in faults if fault.criterion == "alignment"]
    found = [faults, asked] if 1 < len(asked) < len(faults) else [faults]
    return [*found, [max(faults, key=_worth)]]


def _merged(tool: str, faults: Sequence[Fault]) -> dict[str, Any]:
    if len(faults) == 1 or tool not in LISTS:
        return dict(faults[0].inputs)
    key = LISTS[tool]
    items: list[Any] = []
    for fault in faults:
        listed = fault.inputs.get(key, [])
        if not listed and tool in ("add_tabletop", "add_crowd", "add_wall_objects", "update_layout"):
            return {key: []}  # an empty list stands for all
        items += [item for item in listed if item not in items]
    things = [] if key == "objects" else [row for fault in faults for row in fault.inputs.get("objects", ())]
    # what else a fault asks for is its own: for several, the tool decides
    return {key: items, "objects": things} if things else {key: items}


def seed_of(seed: int, step: int, tool: str) -> int:
    """The seed of a call."""
    return random.Random(f"{seed} {step} {tool}").randrange(2**32)
