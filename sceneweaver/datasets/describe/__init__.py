"""Words for scenes: captions, questions and instructions, with their ground truth."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from sceneweaver.scene import Scene

from .captions import captions
from .facts import Facts
from .instructions import instructions
from .questions import questions


def describe(scene: Scene, seed: int) -> dict[str, bytes]:
    """Captions, questions and instructions of a scene, with what each follows from.

    Nothing is stated or asked but what the geometry of the scene decides with a margin. A function of its arguments
    alone.

    Args:
        scene: the scene; it should be valid.
        seed: what is drawn: wording, which facts are told and what is asked.

    Returns:
        By suffix, the contents of ``captions.json``, ``questions.jsonl`` and ``instructions.jsonl``.
    """
    facts = Facts(scene)
    rows = [{"id": f"q{k}", **question.to_dict()} for k, question in enumerate(questions(facts, seed))]
    return {
        "captions.json": _line(captions(facts, seed)),
        "questions.jsonl": _lines(rows),
        "instructions.jsonl": _lines(instructions(facts, seed)),
    }


def _line(data: Any) -> bytes:
    return (json.dumps(data, ensure_ascii=False) + "\n").encode()


def _lines(rows: Iterable[Any]) -> bytes:
    return b"".join(map(_line, rows))
