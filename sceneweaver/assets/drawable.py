"""What our own drawings can show of the words about a thing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from .looks import extents_of, read_words
from .materials import STYLES, color_named, finishes_named
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
    wish = Wish(size, read.color, read.material, style, shape=read.shape, parts=read.parts, count=1)
    (card,) = ParametricSource().find(category, wish)
    shown = card.attributes
    wanted = {_kind(f.material.name) for f in finishes_named(read.material)} if read.material else set()
    holds = {
        "color": read.color is None or shown.get("color") == color_named(read.color),
        "material": read.material is None or _kind(str(shown.get("material"))) in wanted,
        "style": True,
        "size": True,
        "shape": read.shape is None or shown.get("shape") == read.shape,
    }
    holds |= {name: shown.get(name) == count for name, count in read.parts}
    met = [*narrowed, *(said[kind] for kind in said if holds[kind])]
    unmet += [said[kind] for kind in said if not holds[kind]]
    return Look(
        category=category,
        color=read.color if holds["color"] else None,
        material=read.material if holds["material"] else None,
        style=style,
        shape=read.shape if holds["shape"] else None,
        size=size,
        parts=tuple((name, count) for name, count in read.parts if holds[name]),
        met=tuple(dict.fromkeys(met)),
        unmet=tuple(dict.fromkeys(w for w in unmet if w not in met)),
    )


def _narrower(category: str, words: str) -> tuple[str, str, tuple[str, ...]]:
    """The category that the words make of one, the words that are left, and those that were used."""
    match = resolve(f"{words} {category.replace('_', ' ')}")
    if match.generic or match.category == category:
        return category, words, ()
    rest = " ".join(match.modifiers)
    used = tuple(word for word in words.lower().replace("-", " ").split() if word not in match.modifiers)
    return match.category, rest, used


def _kind(finish: str) -> str:
    """What is left of a finish's name when it is dyed: "velvet" of "green velvet"."""
    return finish.rpartition(" ")[2]
