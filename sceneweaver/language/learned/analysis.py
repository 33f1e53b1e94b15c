"""What a request mentions and how that is linked, by the network that ships with the package."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from ..model import Span
from ..parsed import Parsed
from .evidence import of_pairs, of_words
from .labels import KINDS, LINKS, MARKS
from .network import LONGEST, distances, encode, link_scores, mark_scores
from .pieces import Pieces
from .weights import Model, load_model

_KINDS = tuple(KINDS)


@dataclass(frozen=True)
class Named:
    """A mention: where it stands, its kind (one of `KINDS`), and how sure that is."""

    span: Span
    kind: str
    sure: float


@dataclass(frozen=True)
class Link:
    """What is said of two mentions, by their numbers (-1: the room as a whole), and how sure that is."""

    name: str
    one: int
    other: int
    sure: float


@dataclass(frozen=True)
class Analysis:
    """What a request mentions, in order, and what is said of what."""

    named: tuple[Named, ...]
    links: tuple[Link, ...]
    shares: np.ndarray
    """Of all pairs of mentions and links: how sure (mentions + 1, mentions + 1, links); number 0 is the room."""

    def meant(self, number: int) -> int:
        """The mention that a reference stands for; another mention is itself."""
        for _ in range(4):
            if number < 0 or self.named[number].kind != "reference":
                break
            found = [link for link in self.links if link.name == "same" and link.one == number]
            if not found:
                break
            number = max(found, key=lambda link: link.sure).other
        return number


@cache
def shipped() -> Model:
    """The network of the package."""
    with resources.as_file(resources.files(__package__ or "") / "weights.npz") as path:
        return load_model(path)


def analyse(text: str, parsed: Parsed) -> Analysis:
    """What a request mentions and how that is linked, with what the rules read of it; of a long one its beginning."""
    return analysis_of(shipped(), text, parsed)


def analysis_of(model: Model, text: str, parsed: Parsed) -> Analysis:
    """What a network finds in a text."""
    pieces = model.vocabulary.split(text, LONGEST)
    if not pieces.words:
        return Analysis((), (), np.zeros((1, 1, len(LINKS)), np.float32))
    mask = np.ones((1, len(pieces.ids)), np.float32)
    vectors = encode(np, model.weights, np.array([pieces.ids]), mask, model.layers)
    words = vectors[:, list(pieces.first)]
    marks = _shares(mark_scores(model.weights, words, of_words(parsed, pieces.words)[None])[0])
    spans = mentions_of(marks.argmax(-1))
    first = np.array([0, *(begin for begin, _, _ in spans)])
    last = np.array([0, *(end - 1 for _, end, _ in spans)])
    kinds = np.array([len(KINDS), *(_KINDS.index(kind) for _, _, kind in spans)])
    evidence = of_pairs(parsed, [(pieces.words[begin][0], pieces.words[end - 1][1]) for begin, end, _ in spans])
    scores = link_scores(
        np, model.weights, words, first[None], last[None], kinds[None], distances(first)[None], evidence[None]
    )
    return _told(pieces, marks, spans, _shares(scores[0]))


def mentions_of(marks: Sequence[Any] | np.ndarray) -> list[tuple[int, int, str]]:
    """Mentions of marked words: number of the first word, of the word after the last, kind."""
    found = list[tuple[int, int, str]]()
    for at, mark in enumerate(marks):
        how, _, kind = MARKS[int(mark)].partition(" ")
        if how == "inside" and found and found[-1][1:] == (at, kind):
            found[-1] = (found[-1][0], at + 1, kind)
        elif how != "outside":
            found.append((at, at + 1, kind))
    return found


def _told(pieces: Pieces, marks: np.ndarray, spans: list[tuple[int, int, str]], shares: np.ndarray) -> Analysis:
    named = list[Named]()
    for begin, end, kind in spans:
        own = [MARKS.index(f"{how} {kind}") for how in ("begin", "inside")]
        sure = float(marks[begin:end, own].sum(-1).min())
        named.append(Named(Span(pieces.words[begin][0], pieces.words[end - 1][1]), kind, sure))
    best = shares.argmax(-1)
    links = [
        Link(LINKS[best[one, other]], one - 1, other - 1, float(shares[one, other, best[one, other]]))
        for one in range(1, len(best))
        for other in range(len(best))
        if one != other and best[one, other]
    ]
    return Analysis(tuple(named), tuple(links), shares)


def _shares(scores: np.ndarray) -> np.ndarray:
    shares = np.exp(scores - scores.max(-1, keepdims=True))
    return shares / shares.sum(-1, keepdims=True)
