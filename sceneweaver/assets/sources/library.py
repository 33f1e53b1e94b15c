"""Retrieval over several sources: by category, size, style words and colour, and by text embeddings if any."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError

from ..asset import Asset
from ..looks import read_words
from ..materials import color_named
from ..taxonomy import Match, resolve
from .base import Card, Source, Wish
from .parametric import ParametricSource
from .stored import StoreSource

Embed = Callable[[Sequence[str]], np.ndarray]
"""Texts to unit vectors [N, D]; see ``embedder``."""


@dataclass(frozen=True)
class Found:
    """What a search brought: cards, best first, with a score each in 0..1, and what the noun was taken for."""

    match: Match
    cards: tuple[Card, ...]
    scores: tuple[float, ...]


class Library:
    """All sources of assets as one. Earlier sources win where scores are equal."""

    def __init__(self, sources: Sequence[Source] | None = None, embed: Embed | None = None):
        self.sources: tuple[Source, ...] = (
            tuple(sources) if sources is not None else (StoreSource(), ParametricSource())
        )
        self._embed = embed

    def find(self, noun: str, wish: Wish | None = None) -> Found:
        """The assets that suit a noun ("desk chair") and a wish, best first."""
        wish = _read(wish or Wish())
        match = resolve(noun, wish.mount)
        scored: list[tuple[float, int, Card]] = []
        for source in self.sources:
            for card in source.find(match.category, wish):
                if wish.licences is None or card.licence in wish.licences:
                    scored.append((self._score(card, wish), len(scored), card))
        if self._embed is not None and scored and wish.words:
            vectors = self._embed([wish.words, *(card.text for *_, card in scored)])
            near = vectors[1:] @ vectors[0]
            scored = [(0.5 * s + 0.5 * float(n), i, c) for (s, i, c), n in zip(scored, near, strict=True)]
        scored.sort(key=lambda row: (-row[0], row[1]))
        return Found(match, tuple(c for *_, c in scored), tuple(s for s, *_ in scored))

    def choose(self, noun: str, count: int = 1, wish: Wish | None = None, same: bool = True) -> list[Asset]:
        """Assets for ``count`` instances: all the best one (six equal dining chairs), or different ones (books).

        Raises:
            InputError: when no source has anything that suits.
        """
        wish = wish or Wish()
        found = self.find(noun, replace(wish, count=max(wish.count, 1 if same else count)))
        if not found.cards:
            raise InputError(f"asset: nothing suits '{noun}'; allow more licences or import some")
        cards = [found.cards[0]] * count if same else [found.cards[k % len(found.cards)] for k in range(count)]
        made = {asset_id: self.load(asset_id) for asset_id in {card.id for card in cards}}
        return [made[card.id] for card in cards]

    def load(self, asset_id: str) -> Asset:
        """The asset of an id, from the source that owns it; InputError when none does."""
        checkpoint()  # a drawing takes long
        for source in self.sources:
            if source.owns(asset_id):
                return source.load(asset_id)
        raise InputError(f"asset: no source has '{asset_id}'; import it, or use parametric:CATEGORY?seed=N")

    @staticmethod
    def _score(card: Card, wish: Wish) -> float:
        """Fit of size (a quarter off in one extent halves it), colour, material and words; 1 is all that was asked."""
        terms = [1.0]
        for want, have in zip(wish.size, card.size, strict=True):
            if want is not None:
                terms.append(math.exp(-abs(math.log(have / want)) / 0.32))
        text = card.text
        if wish.color:
            terms.append(1.0 if color_named(wish.color) in str(card.attributes.get("color", "")) else 0.3)
        for word in (wish.material, wish.style):
            if word:
                terms.append(1.0 if word.lower() in text else 0.5)
        if wish.words:
            asked = set(re.findall(r"[a-z]+", wish.words.lower()))
            terms.append(0.5 + 0.5 * len(asked & set(re.findall(r"[a-z]+", text))) / max(1, len(asked)))
        return math.prod(terms) ** (1 / len(terms))


def _read(wish: Wish) -> Wish:
    """The wish with what its words say of a look, where it says nothing of that itself."""
    read = read_words(wish.words)
    return replace(
        wish,
        color=wish.color or read.color,
        material=wish.material or read.material,
        style=wish.style or read.style,
        shape=wish.shape or read.shape,
        parts=wish.parts or read.parts,
    )


def embedder(model: str) -> Embed:
    """Text embeddings by a local sentence-transformers model (a folder).

    Raises:
        MissingDependencyError: when sentence-transformers is not installed.
        InputError: when the folder is not there.
    """
    from pathlib import Path

    from sceneweaver.scene import MissingDependencyError

    if not Path(model).is_dir():
        raise InputError(f"embeddings: {model} is no folder with a model")
    try:
        from sentence_transformers import SentenceTransformer  # pyright: ignore[reportMissingImports]
    except ModuleNotFoundError as error:
        raise MissingDependencyError(
            "text embeddings need sentence-transformers; install it with: pip install sentence-transformers"
        ) from error
    loaded = SentenceTransformer(model)
    return lambda texts: np.asarray(loaded.encode(list(texts), normalize_embeddings=True))
