"""How near texts about scenes are to a request: cosines of TF-IDF vectors over stems."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from .purposes import stems


def text_likeness(asked: str, texts: Sequence[str]) -> list[float]:
    """How alike a request and each of some texts are, 0 to 1.

    Term frequencies are damped, ``1 + log(n)``, and weighed by how few of the texts have the stem, smoothed:
    ``log((1 + N) / (1 + n)) + 1`` (Salton and Buckley 1988, "Term-weighting approaches in automatic text retrieval").
    What a text says beyond the request makes it less alike, as the cosine is of whole vectors.

    Examples:
        >>> from sceneweaver.knowledge.scene_words import text_likeness
        >>> a, b = text_likeness("a bedroom with a desk", ["desk and chair in a bedroom", "a kitchen"])
        >>> a > 0.4, b
        (True, 0.0)
    """
    bags = [Counter(stems(text)) for text in texts]
    spread = Counter(stem for bag in bags for stem in bag)

    def vector(bag: Counter[str]) -> dict[str, float]:
        return {s: (1 + math.log(n)) * (math.log((1 + len(bags)) / (1 + spread[s])) + 1) for s, n in bag.items()}

    query = vector(Counter(stems(asked)))
    length = _norm(query)
    found = []
    for bag in bags:
        row = vector(bag)
        dot = sum(value * row.get(s, 0.0) for s, value in query.items())
        found.append(dot / (length * _norm(row)) if dot else 0.0)
    return found


def _norm(vector: dict[str, float]) -> float:
    return math.sqrt(sum(value * value for value in vector.values()))
