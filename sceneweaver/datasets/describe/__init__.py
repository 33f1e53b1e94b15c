"""Words for scenes: captions, questions and instructions, with their ground truth."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import numpy as np

from sceneweaver.scene import Scene

from . import access
from . import questions as asked
from .asker import Asker, Question, Template
from .captions import captions
from .facts import Facts
from .instructions import instructions

TEMPLATES: tuple[Template, ...] = (*asked.TEMPLATES, *access.TEMPLATES)
"""All templates of questions; one that stands here twice asks twice."""


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


def questions(facts: Facts, seed: int) -> list[Question]:
    """Questions about a scene, each once, in the order of their templates.

    Args:
        facts: the scene.
        seed: what is drawn: what is asked about, how it is worded, which of two answers it has.
    """
    asker = Asker(facts, np.random.default_rng(seed))
    found: dict[str, Question] = {}
    for template in TEMPLATES:
        question = template(asker)
        if question is not None:
            found.setdefault(f"{question.template} {question.operands}", question)
    return list(found.values())


def _line(data: Any) -> bytes:
    return (json.dumps(data, ensure_ascii=False) + "\n").encode()


def _lines(rows: Iterable[Any]) -> bytes:
    return b"".join(map(_line, rows))
