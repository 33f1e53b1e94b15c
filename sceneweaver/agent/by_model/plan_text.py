"""What a model is told when it plans: equal situations give equal text, without clocks and paths."""

from __future__ import annotations

from typing import Any

from sceneweaver.agent.memory import Call, Step
from sceneweaver.agent.planner import Situation
from sceneweaver.critic import VisualReview
from sceneweaver.io.messages import shorten

from .scene_text import compact, facts_text, prompt, rounded, scene_text

REQUEST, SENTENCE = 8000, 300
"""Characters of the request, and of each sentence of the memory, that are told."""

MOST_SEEN = 10
"""Faults of the critic by vision that are told, the gravest first."""

MOST_FAILED = 20
"""Calls in vain that are told, the last ones."""


def instructions(situation: Situation) -> str:
    """What the model is and how it is to answer, with the cards of its tools."""
    idle = {"rooms", "needs", "withheld", "confidence"}
    cards = ",\n".join(compact(card.model_dump(mode="json", exclude=idle)) for card in situation.cards.values())
    parts = [prompt("planner"), prompt("scene"), f"Tools:\n[\n{cards}\n]"]
    if situation.whole:
        parts.append(prompt("plan_whole"))
    return "\n\n".join(parts)


def content(situation: Situation) -> str:
    """The request, the tools' record, the last steps, what was measured, and the scene, as JSON under headings."""
    brief, memory, settings = situation.brief, situation.memory, situation.settings
    graph = brief.model_dump(mode="json", exclude_defaults=True, exclude={"text", "notes"})
    said = {"text": shorten(brief.text, REQUEST), "read_as": graph, "kind_of_room": situation.room_type.name}
    parts = [f"Request: {compact(said)}"]
    state: dict[str, Any] = {
        "step": len(memory.steps) + 1,
        "steps_at_most": settings.steps,
        "calls_side_by_side": 1 if situation.whole else settings.side_by_side,
        "trust": {
            name: rounded(card.confidence * memory.confidence.get(name, 1.0)) for name, card in situation.cards.items()
        },
    }
    if memory.failed:
        state["failed_calls"] = [shorten(name, SENTENCE) for name in memory.failed[-MOST_FAILED:]]
    parts.append(f"State: {compact(state)}")
    if settings.memory_length and memory.steps:
        rows = ",\n".join(compact(_step(step)) for step in memory.steps[-settings.memory_length :])
        parts.append(f"Last steps: [\n{rows}\n]")
    if situation.scene is None:
        return "\n\n".join((*parts, "There is no room yet."))
    if situation.report is not None and situation.review is not None:
        parts.append(f"Measured: {facts_text(situation.report, situation.review)}")
        if situation.review.seen is not None:
            parts.append(f"Critic by vision: {compact(_seen(situation.review.seen))}")
    return "\n\n".join((*parts, f"Scene: {scene_text(situation.scene)}"))


def _seen(seen: VisualReview) -> dict[str, Any]:
    """What a critic by vision said, cut to what helps to plan."""
    return {
        "grades": {name: rounded(grade, 1) for name, grade in seen.grades.items()},
        "spread": rounded(seen.spread, 1),
        "comments": {name: [shorten(text, SENTENCE) for text in said[:2]] for name, said in seen.comments.items()},
        "faults": [
            {
                "criterion": fault.criterion,
                "objects": [shorten(name, 60) for name in fault.objects],
                "reason": shorten(fault.reason, SENTENCE),
                "suggestion": shorten(fault.suggestion, SENTENCE),
                **({"tool": fault.tool} if fault.tool else {}),
            }
            for fault in seen.faults[:MOST_SEEN]
        ],
    }


def _step(step: Step) -> dict[str, Any]:
    """A step as the model remembers it."""
    data: dict[str, Any] = {"step": step.number}
    if step.plan is not None and step.plan.problem:
        data["problem"] = shorten(step.plan.problem, SENTENCE)
    if step.call is not None:
        data |= _call(step.call)
    data["kept"] = step.accepted
    if not step.accepted:
        data["why_not"] = shorten(step.note, SENTENCE)
    data["grades_before"] = {name: rounded(grade, 1) for name, grade in step.before.items()}
    data["grades_after"] = {name: rounded(grade, 1) for name, grade in step.after.items()}
    data["violations"], data["objects"] = step.violations, step.objects
    data["tried"] = [
        {key: shorten(str(row[key]), SENTENCE) for key in ("tool", "failed") if key in row}
        | ({"left": row["left"]} if "left" in row else {})
        | ({"total_grade": rounded(row["grades"]["total"], 1)} if "total" in row.get("grades", {}) else {})
        for row in step.tried
    ]
    return data


def _call(call: Call) -> dict[str, Any]:
    return {
        "tool": call.tool,
        "instruction": shorten(call.instruction, SENTENCE),
        "inputs": shorten(compact(call.inputs), SENTENCE),
    }
