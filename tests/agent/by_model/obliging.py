"""A model that does its best: an answer that fits to every question of a design of a store room with one shelf."""

from __future__ import annotations

import re
from typing import Any

from sceneweaver.agent.by_model.look_reply import Look
from sceneweaver.agent.by_model.plan_reply import Plan
from sceneweaver.language.by_model.reply import RequestReply
from tests.llm.model_server import Asked, Said, answering

ROOM = "a store room with one shelf"

READ = {
    "language": "English",
    "room": {"kind": "store room", "quote": "store room"},
    "things": [{"id": "shelf", "name": "shelf", "quote": "one shelf", "count": [1, 1]}],
    "relations": [],
}
LOOK = {
    **{name: {"comment": "It will do.", "grade": 7} for name in ("realism", "functionality", "layout", "completion")},
    "faults": [{"criterion": "completion", "objects": [], "wrong": "The shelf is bare.", "severity": 1}],
}


def call(tool: str, inputs: dict[str, Any] | None = None, confidence: float = 0.8) -> dict[str, Any]:
    """One call of a plan; without inputs it asks for them apart."""
    return {"tool": tool, "confidence": confidence, "instruction": f"Use {tool}.", "inputs": inputs}


PLANS: list[dict[str, Any]] = [
    {"problem": "There is no room.", "calls": [call("init_prior")]},
    {"problem": "The shelf is bare.", "calls": [call("add_crowd", {"supports": []}), call("add_objects")]},
    {"problem": "It could be better.", "calls": [call("update_layout", {}), call("add_tabletop", {})]},
    {"stop": True, "stop_reason": "All is there."},
]
"""One for each step, the last for all that follow."""


def plan(asked: Asked) -> dict[str, Any]:
    """What is planned in the step that the question says it is."""
    step = int((re.search(r'"step":\s*(\d+)', asked.text) or [0, "1"])[1])
    if "There is no room yet" in asked.text:
        return PLANS[0]
    return PLANS[min(max(step, 2), len(PLANS)) - 1]


def usual(schema: dict[str, Any], root: dict[str, Any] | None = None) -> Any:
    """Something that fits a JSON schema: what it requires, and no more."""
    root = schema if root is None else root
    if "$ref" in schema:
        return usual(root["$defs"][schema["$ref"].rpartition("/")[2]], root)
    for some in ("anyOf", "oneOf", "allOf"):
        if some in schema:
            return usual(schema[some][0], root)
    if "enum" in schema or "const" in schema:
        return schema.get("const", (schema.get("enum") or [None])[0])
    kind = schema.get("type", "object")
    kind = kind[0] if isinstance(kind, list) else kind
    if kind == "object":
        names = schema.get("required", [])
        return {name: usual(schema.get("properties", {}).get(name, {"type": "string"}), root) for name in names}
    if kind == "array":
        return [usual(schema.get("items", {"type": "string"}), root) for _ in range(schema.get("minItems", 1))]
    if kind in ("number", "integer"):
        return schema.get("minimum", 0) + (0 if kind == "integer" else 0.5)
    return {"boolean": False, "null": None}.get(kind, "box")


def obliging(asked: Asked) -> Said:
    """An answer that fits."""
    replies = {Plan: plan, RequestReply: READ, Look: LOOK}
    return answering(replies, otherwise=lambda question: usual(question.answer_schema))(asked)
