"""The network that analyses requests: a small encoder, marks of words, links of mentions.

The encoder is a transformer with layers normalised after each sum (Devlin and others, "BERT", 2019). Each word gets
scores for the marks of `labels.MARKS`; each ordered pair of mentions scores for the links of `labels.LINKS`, by a
bilinear form of both (Dozat and Manning, "Deep biaffine attention for neural dependency parsing", 2017) with terms for
their kinds, how far they stand from each other, and what the rules read of them. The same code runs on NumPy arrays,
where requests are read, and on JAX arrays, where it is trained: ``xp`` is the module.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Weights = Mapping[str, Any]
Drop = Callable[[Any], Any]

HEADS, WIDTH = 12, 384
LONGEST = 256
"""Most pieces of a text."""

NEAR = (1, 2, 3, 4, 6, 8, 11, 15, 22, 32, 64)
"""Words between two mentions at which their distance counts as another."""

DISTANCES = 2 * (len(NEAR) + 1) + 1
"""Kinds of distances: before, after, and to the room as a whole."""


def _same(x: Any) -> Any:
    return x


def encode(xp: Any, weights: Weights, ids: Any, mask: Any, layers: int, drop: Drop = _same) -> Any:
    """Vectors of pieces.

    Args:
        xp: ``numpy`` or ``jax.numpy``.
        weights: arrays by name.
        ids: numbers of pieces (texts, pieces).
        mask: 1 where there is a piece, else 0 (texts, pieces).
        layers: how many the encoder has.
        drop: leaves out some numbers while it is trained.

    Returns:
        (texts, pieces, `WIDTH`).
    """
    texts, length = ids.shape
    x = weights["pieces"][ids] + weights["places"][:length] + weights["kind"]
    x = drop(_normalised(xp, x, weights["norm.gain"], weights["norm.shift"]))
    hidden = (1.0 - mask)[:, None, None, :] * -1e9

    def heads(name: str, x: Any) -> Any:
        return _linear(weights, name, x).reshape(texts, length, HEADS, WIDTH // HEADS).transpose(0, 2, 1, 3)

    for layer in (f"{number}." for number in range(layers)):
        query, key, value = (heads(layer + name, x) for name in ("query", "key", "value"))
        seen = query @ key.transpose(0, 1, 3, 2) / (WIDTH / HEADS) ** 0.5 + hidden
        seen = xp.exp(seen - seen.max(-1, keepdims=True))
        seen = seen / seen.sum(-1, keepdims=True)
        read = (seen @ value).transpose(0, 2, 1, 3).reshape(texts, length, WIDTH)
        x = x + drop(_linear(weights, layer + "read", read))
        x = _normalised(xp, x, weights[layer + "norm1.gain"], weights[layer + "norm1.shift"])
        wide = _linear(weights, layer + "wide", x)
        wide = 0.5 * wide * (1.0 + xp.tanh(0.7978845608 * (wide + 0.044715 * wide * wide * wide)))
        x = x + drop(_linear(weights, layer + "narrow", wide))
        x = _normalised(xp, x, weights[layer + "norm2.gain"], weights[layer + "norm2.shift"])
    return x


def mark_scores(weights: Weights, words: Any, evidence: Any) -> Any:
    """Scores of marks (texts, words, marks) of vectors of words, with what the rules read there (texts, words)."""
    return _linear(weights, "mark", words) + weights["mark.ruled"][evidence]


def link_scores(
    xp: Any,
    weights: Weights,
    words: Any,
    first: Any,
    last: Any,
    kinds: Any,
    apart: Any,
    evidence: Any,
    drop: Drop = _same,
) -> Any:
    """Scores of links from each mention to each.

    Args:
        xp: ``numpy`` or ``jax.numpy``.
        weights: arrays by name.
        words: vectors of words (texts, words, `WIDTH`).
        first: number of the first word of each mention (texts, mentions). The first mention is the room as a whole.
        last: of its last word.
        kinds: of mentions (texts, mentions).
        apart: what `distances` says (texts, mentions, mentions).
        evidence: what the rules read of a pair (texts, mentions, mentions).
        drop: leaves out some numbers while it is trained.

    Returns:
        (texts, mentions, mentions, links).
    """
    room = xp.zeros_like(words[:, :1]) + weights["room"]
    begins, ends = (
        xp.concatenate([room, xp.take_along_axis(words, where[:, 1:, None], axis=1)], 1) for where in (first, last)
    )
    both = drop(xp.concatenate([begins, ends, weights["kinds"][kinds]], -1))
    one, other = (drop(xp.maximum(_linear(weights, name, both), 0.0)) for name in ("from", "to"))
    crossed = xp.einsum("bms,lst->bmlt", one, weights["cross"])
    scores = xp.einsum("bmlt,bnt->bmnl", crossed, other)
    scores = scores + (one @ weights["from.link"])[:, :, None] + (other @ weights["to.link"])[:, None]
    scores = scores + weights["apart"][apart] + weights["pair"][kinds[:, :, None], kinds[:, None, :]]
    return scores + weights["ruled"][evidence] + weights["ruled.back"][evidence.transpose(0, 2, 1)]


def distances(first: np.ndarray) -> np.ndarray:
    """Kinds of distances between mentions that begin at such words (mentions, mentions); the first is the room."""
    gap = first[:, None] - first[None]
    kind = np.searchsorted(NEAR, np.abs(gap), side="right")
    kind = np.where(gap < 0, kind + len(NEAR) + 1, kind)
    kind[0], kind[:, 0] = DISTANCES - 1, DISTANCES - 1
    return kind


def _linear(weights: Weights, name: str, x: Any) -> Any:
    return x @ weights[name] + weights[name + ".shift"]


def _normalised(xp: Any, x: Any, gain: Any, shift: Any) -> Any:
    mean = x.mean(-1, keepdims=True)
    spread = ((x - mean) ** 2).mean(-1, keepdims=True)
    return (x - mean) / xp.sqrt(spread + 1e-12) * gain + shift
