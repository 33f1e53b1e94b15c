"""From the labels of other systems to categories of the taxonomy, with how sure that is."""

from __future__ import annotations

import re
from functools import lru_cache
from importlib import resources
from typing import NamedTuple

from sceneweaver.assets import resolve
from sceneweaver.assets.category import read_yaml
from sceneweaver.assets.taxonomy import How

from .model import Mount

SURE: dict[How, float] = {
    "exact": 1.0,
    "synonym": 0.95,
    "plural": 0.95,
    "like": 0.8,
    "spelling": 0.7,
    "head": 0.7,
    "group": 0.5,
    "generic": 0.2,
}
"""How sure a category is, by how its word was found: an order, not a probability that was measured."""

_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
_NUMBER = re.compile(r"\b(?:[0-9]+|[0-9a-f]{16,}|(?:[a-z]*[0-9]+[a-z]*){2,})\b")


class Named(NamedTuple):
    """A category with how sure it is (0 to 1), and the category whose body stands for it."""

    category: str
    confidence: float
    body: str


@lru_cache(maxsize=4096)
def category_of(label: str, mount: Mount | None = None) -> Named:
    """The category that a label means: "DiningTable_3", "king-size bed", "tv_stand-0", "Pendant Lamp".

    Args:
        label: as the file has it: words with blanks, underscores, hyphens or capitals between them; numbers go.
        mount: what holds the thing, which decides what stands for an unknown word.
    """
    words = plain(label)
    known = _labels().get(words)
    if known is not None:
        match = resolve(known.replace("_", " "), mount)
        return Named(match.category, 0.9, match.body)
    if not words:
        return Named("object", 0.0, resolve("object", mount).body)
    match = resolve(words, mount)
    return Named(match.category, SURE[match.how], match.body)


def plain(label: str) -> str:
    """A label as words: lower case, one blank between two, without numbers and codes."""
    text = _CAMEL.sub(" ", label).replace("_", " ").replace("-", " ").replace("/", " or ").lower()
    return " ".join(_NUMBER.sub(" ", text).split(" or ")[0].split())


@lru_cache(maxsize=1)
def _labels() -> dict[str, str]:
    """What labels of the field's vocabularies mean that say something else, or nothing, as words."""
    data = read_yaml(resources.files("sceneweaver.importers").joinpath("labels.yaml"))
    return {plain(word): name for name, words in data.items() for word in words}
