"""What our own drawings can show of the words about a thing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from .asset import Mount
from .looks import extents_of, is_look, read_words, shows
from .materials import STYLES
from .taxonomy import category_named, resolve


@dataclass(frozen=True)
class Look:
    """What is set for a thing, in the terms of ``Wish``, and what of the words can and cannot be drawn.

    ``category`` is narrower than the one asked where a word makes it so: a round mirror is a ``round_mirror``.
    ``size`` is depth, width, height [m], None where nothing was said. ``met`` and ``unmet`` are phrases of the request;
    ``unmet`` are attributes that no drawing of the category shows, and words that say nothing of a look.
    """

    category: str
    color: str | None = None
    material: str | None = None
    style: str | None = None
    shape: str | None = None
    size: tuple[float | None, float | None, float | None] = (None, None, None)
    parts: tuple[tuple[str, int], ...] = ()
    mount: Mount | None = None
    met: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()


@lru_cache(maxsize=4096)
def drawable(category: str, words: str) -> Look:
    """What words such as "large round glass" set for a category, and which of them cannot be drawn.

    One body is drawn to find out, so that the answer is that of the drawing itself.
    """
    from .sources.base import Wish
    from .sources.parametric import ParametricSource

    category, words, narrowed = _narrower(category, words)
    read = read_words(words)
    known = category_named(category)
    size = extents_of(known, read)
    said = dict(read.said)
    style = read.style if read.style in STYLES else None
    unmet = list(read.left)
    wish = Wish(size, read.color, read.material, style, shape=read.shape, parts=read.parts, count=1, beyond=True)
    (card,) = ParametricSource().find(category, wish)
    mount = read.mount if read.mount in known.mount else None
    holds = {"style": True, "size": True, "mount": mount is not None} | shows(card.attributes, read)
    met = [*narrowed, *(said[kind] for kind in said if holds[kind])]
    unmet += [said[kind] for kind in said if not holds[kind]]
    return Look(
        category=category,
        color=read.color if holds.get("color") else None,
        material=read.material if holds.get("material") else None,
        style=style,
        shape=read.shape if holds.get("shape") else None,
        size=size,
        parts=tuple((name, count) for name, count in read.parts if holds[name]),
        mount=mount,
        met=tuple(dict.fromkeys(met)),
        unmet=tuple(dict.fromkeys(w for w in unmet if w not in met)),
    )


def _narrower(category: str, words: str) -> tuple[str, str, tuple[str, ...]]:
    """The category that the words make of one, the words that are left, and those that are part of its name.

    What is said of a look is left although it is part of the name: a metal shelf has to be of metal.
    """
    match = resolve(f"{words} {category.replace('_', ' ')}")
    if match.generic or match.how == "like":
        return category, words, ()
    plain = words.lower().replace("-", " ").replace("_", " ").split()
    used = tuple(word for word in plain if word not in match.modifiers)
    kept = [word for word in used if is_look(word)]
    return match.category, " ".join([*kept, *match.modifiers]), used
