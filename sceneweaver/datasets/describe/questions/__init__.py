"""Questions about a scene, with answers by geometry."""

from __future__ import annotations

import numpy as np

from ..facts import Facts
from . import access, counts, places
from .question import Asker, Question, Template

TEMPLATES: tuple[Template, ...] = (*counts.TEMPLATES, *places.TEMPLATES, *access.TEMPLATES)
"""All templates; one that stands here twice asks twice."""


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


__all__ = ["TEMPLATES", "Asker", "Question", "questions"]
