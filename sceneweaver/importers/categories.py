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
_CODE = re.compile(
    r"(?<![0-9a-z])(?:[0-9a-f]{8}(?:[-_][0-9a-f]{4}){3}[-_][0-9a-f]{12}"  # a UUID
    r"|(?:[0-9a-f]*[0-9][0-9a-f]*[-_]){2,}[0-9a-f]*[0-9][0-9a-f]*)(?![0-9a-z])",  # more of hexadecimal digits
    re.IGNORECASE,
)
_NUMBER = re.compile(r"\b(?:[0-9]+|[0-9a-f]{8,}|[0-9]{2,}[a-z]{1,2}|[a-z]*[0-9]+(?:[a-z]+[0-9]+)+[a-z]*)\b")
_COUNTED = re.compile(r"(?<=[a-z]{2})[0-9]+$|(?<=[a-z]{3})[0-9]+[a-z]$")
_WORD = re.compile(r"\b[^\W\d_]{3,}\b|\b[^\W\d_]{2}$")
"""What may be a word: three letters or more, or two at the end, which count where they are known ("tv")."""

SHORTEST = 3
"""Letters of a word that no category fits, but which is one."""

_SEPARATORS = re.compile(r"[-_.:|#]+")


class Named(NamedTuple):
    """A category with how sure it is (0 to 1), and the category whose body stands for it."""

    category: str
    confidence: float
    body: str


@lru_cache(maxsize=4096)
def category_of(label: str, mount: Mount | None = None) -> Named:
    """The category that a label means: "DiningTable_3", "king-size bed", "tv_stand-0", "Pendant Lamp".

    Args:
        label: as the file has it: words with blanks, underscores, hyphens or capitals between them; numbers and ids
            go. What is only an id or a code is no label: "object" with confidence 0.
        mount: what holds the thing, which decides what stands for an unknown word.

    Examples:
        >>> from sceneweaver.importers import category_of
        >>> category_of("NightStand_2").category, category_of("4602591c-785f-408d-bae3-10bc6bae9e6b").confidence
        ('nightstand', 0.0)
    """
    words = plain(label)
    known = _labels().get(words)
    if known is not None:
        match = resolve(known.replace("_", " "), mount)
        return Named(match.category, 0.9, match.body)
    match = resolve(words or "object", mount)
    if not words or (match.how == "generic" and len(words) < SHORTEST):
        return Named("object", 0.0, resolve("object", mount).body)
    return Named(match.category, SURE[match.how], match.body)


def plain(label: str) -> str:
    """A label as words: lower case, one blank between two, without numbers, ids and codes; "" where that is all."""
    text = _SEPARATORS.sub(" ", _CAMEL.sub(" ", _CODE.sub(" ", label))).replace("/", " or ").lower()
    words = _COUNTED.sub("", " ".join(_NUMBER.sub(" ", text).split(" or ")[0].split()))
    return words if _WORD.search(words) else ""


@lru_cache(maxsize=1)
def _labels() -> dict[str, str]:
    """What labels of the field's vocabularies mean that say something else, or nothing, as words."""
    data = read_yaml(resources.files("sceneweaver.importers").joinpath("labels.yaml"))
    return {plain(word): name for name, words in data.items() for word in words}
