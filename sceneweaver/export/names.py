"""Names that readers take: of models and files, and of parts that must not be named alike."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable


class Names:
    """Names from any text, each given once.

    Args:
        legal: From a text to a name that readers take.
        taken: Names that are not given.
    """

    def __init__(self, legal: Callable[[str], str], *taken: str):
        self._legal, self._taken = legal, set(taken)

    def __call__(self, text: str) -> str:
        """A name that looks like the text and that was not given before."""
        stem = name = self._legal(text)
        number = 1
        while name in self._taken:
            number += 1
            name = f"{stem}_{number}"
        self._taken.add(name)
        return name


def legal_name(text: str) -> str:
    """A text as a name of letters, digits and ``_`` only."""
    return re.sub(r"[^A-Za-z0-9_]", "_", text) or "link"


def model_name(key: str, category: str) -> str:
    """A name for a mesh: letters, digits, ``_`` and ``-`` only, another one for each key.

    Readers take model ids apart at dots and use them as names of files, and ids of assets may hold anything.
    """
    word = re.sub(r"[^a-z0-9]+", "_", category.lower()).strip("_")[:40] or "object"
    return f"{word}-{hashlib.sha256(key.encode()).hexdigest()[:10]}"
