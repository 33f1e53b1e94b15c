"""A pattern for any of some words."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from typing import Any

_WORD = re.compile(r"\w+")


def one_of(names: Iterable[str]) -> str:
    """A pattern for any of some words, the longest first.

    The words share their beginnings (a trie), so that a pattern of hundreds of words is compiled and matched in the
    time of a few: it matches what the alternation of all, the longest first, matches.
    """
    return _one_of(tuple(names))


@lru_cache(maxsize=1024)  # nearly all are of the lexicon, and each request asks for those again
def _one_of(names: tuple[str, ...]) -> str:
    """The pattern of these words."""
    trie: dict[str, Any] = {}
    for name in sorted(names):
        node = trie
        for letter in name:
            node = node.setdefault(letter, {})
        node[""] = {}
    return f"(?:{_of_trie(trie)})"


def _of_trie(trie: dict[str, Any]) -> str:
    """The pattern of what a trie holds; "" as a key: a word ends there."""
    ends = "" in trie
    branches = [re.escape(letter) + _of_trie(below) for letter, below in trie.items() if letter]
    if not branches:
        return ""
    if len(branches) == 1 and not ends:
        return branches[0]
    return f"(?:{'|'.join(branches)})" + ("?" if ends else "")


def first_words(names: Iterable[str]) -> frozenset[str]:
    """The words that some names begin with."""
    return frozenset(found[0] for name in names if (found := _WORD.match(name)) is not None)


def names_begin(text: str, firsts: frozenset[str]) -> bool:
    """Whether a text has one of these words, as it must where it has a whole name that begins with one.

    Worth asking before a pattern of a thousand names is compiled.
    """
    return not firsts.isdisjoint(_WORD.findall(text))


__all__ = ["first_words", "names_begin", "one_of"]
