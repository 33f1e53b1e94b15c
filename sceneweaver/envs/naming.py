"""Which bodies of a room words mean: "mug-0", "the metal_bed", "the black steel desk lamp", "the nightstand"."""

from __future__ import annotations

import re

from sceneweaver.assets import categories
from sceneweaver.assets.looks import read_words, shows

from .geometry import SceneGeometry

_ARTICLES = ("the ", "a ", "an ")


def plain(text: str) -> str:
    """Words in lower case without an article, with spaces for what joins them in names."""
    words = " ".join(re.sub(r"[_\-]+", " ", text.lower()).split())
    for article in _ARTICLES:
        words = words.removeprefix(article)
    return words


def fit(words: str, name: str, geometry: SceneGeometry) -> float:
    """How well words mean a body, 0: not at all.

    The body's name counts 4, its object's 3, its category or another word for it 2, a part of the category 1. Words
    about its look may stand before the category, as a material, a colour or a style: all of them must be true of the
    object, and add a tenth.
    """
    words, owner = plain(words), geometry.owner[name]
    for said, score in ((name, 4.0), (owner, 3.0)):
        if words == plain(said):
            return score
    category = geometry.items[owner if name in geometry.articulations else name].category
    parts = words.split()
    for first in range(len(parts)):
        score = _kind(" ".join(parts[first:]), category)
        if score and (
            not first or (name in (owner, *geometry.articulations) and _looks(parts[:first], owner, geometry))
        ):
            return score + 0.1 * (first > 0)
    return 0.0


def _kind(words: str, category: str) -> float:
    """How well words mean a category."""
    known = categories().get(category.strip().lower().replace(" ", "_"))
    own = plain(category)
    if words == own or (known is not None and words in map(plain, known.synonyms)):
        return 2.0
    return 1.0 if set(words.split()) <= set(own.split()) else 0.0


def _looks(words: list[str], owner: str, geometry: SceneGeometry) -> bool:
    """Whether all words are about looks, and an object has these."""
    found = read_words(words)
    attributes = next(thing.object.attributes for thing in geometry.things if thing.object.id == owner)
    styled = found.style is None or attributes.get("style") == found.style
    return not found.left and styled and all(shows(attributes, found).values())
