"""Classes of things for data sets: the forty of NYU-Depth V2, by the words of a category."""

from __future__ import annotations

from functools import cache
from importlib import resources

from sceneweaver.assets.category import categories, read_yaml
from sceneweaver.scene import SceneObject

UNLABELLED = 0
"""The class of what is none of them: the world outside, and pixels that show nothing."""

_FURNITURE, _PROP = "otherfurniture", "otherprop"


@cache
def class_names() -> tuple[str, ...]:
    """Names of the classes; the id of the first one is 1."""
    return tuple(row["name"] for row in _table())


def class_of(thing: SceneObject) -> int:
    """The class of an object: by the words of its category, else by its group in the library, else a piece of furniture
    or a prop."""
    found = class_named(thing.category)
    if found == UNLABELLED:
        large = thing.mount == "floor" and max(thing.size) > 0.5
        found = class_names().index(_FURNITURE if large else _PROP) + 1
    return found


@cache
def class_named(category: str) -> int:
    """The class that the words of a category name, or `UNLABELLED`."""
    words = category.lower().replace("_", " ").replace("-", " ").split()
    by_words = {text: k + 1 for k, row in enumerate(_table()) for text in row["words"]}
    for start in range(len(words)):  # the longest end that is known
        text = " ".join(words[start:])
        if text in by_words:
            return by_words[text]
    by_group = {text: k + 1 for k, row in enumerate(_table()) for text in row.get("groups", ())}
    entry = categories().get("_".join(words))
    while entry is not None and entry.parent is not None:
        if entry.parent in by_group:
            return by_group[entry.parent]
        entry = categories().get(entry.parent)
    return UNLABELLED


@cache
def _table() -> list[dict]:
    return read_yaml(resources.files(__package__ or "").joinpath("nyu40.yaml"))
