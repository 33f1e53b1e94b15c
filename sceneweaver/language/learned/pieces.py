"""Text as words, and words as pieces of a fixed vocabulary (WordPiece: Schuster and Nakajima, 2012)."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

_WORD = re.compile(r"\w+(?:[’'-]\w+)*|[^\w\s]")
_PART = re.compile(r"[^\W_]+|[^\w\s]|_")

UNKNOWN, START, END = "[UNK]", "[CLS]", "[SEP]"

LONGEST_WORD = 100
"""Characters of a word that is taken apart; trying all pieces of a longer one takes time with its square."""


@dataclass(frozen=True)
class Pieces:
    """A text in pieces.

    Attributes:
        words: where each word begins and ends in the text.
        ids: numbers of the pieces, with `START` before and `END` after them.
        first: of each word, the place in ``ids`` of its first piece.
    """

    words: tuple[tuple[int, int], ...]
    ids: tuple[int, ...]
    first: tuple[int, ...]


class Vocabulary:
    """Pieces by name; those that go on with a word begin with ``##``."""

    def __init__(self, names: Iterable[str]) -> None:
        self._ids: Mapping[str, int] = {name: number for number, name in enumerate(names)}

    def split(self, text: str, most: int) -> Pieces:
        """A text as words and pieces; of a long text the first words that make at most ``most`` pieces."""
        ids, words, first = [self._ids[START]], list[tuple[int, int]](), list[int]()
        for found in _WORD.finditer(text):
            pieces = self.pieces(found[0])
            if len(ids) + len(pieces) >= most:
                break
            words.append(found.span())
            first.append(len(ids))
            ids += pieces
        ids.append(self._ids[END])
        return Pieces(tuple(words), tuple(ids), tuple(first))

    def pieces(self, word: str) -> list[int]:
        """Numbers of the pieces of one word, accents and capitals aside: the longest that fits, again and again."""
        if len(word) > LONGEST_WORD:
            return [self._ids[UNKNOWN]]
        plain = unicodedata.normalize("NFD", word.lower())
        plain = "".join(c for c in plain if unicodedata.category(c) != "Mn")
        return [number for part in _PART.findall(plain) for number in self._of_part(part)] or [self._ids[UNKNOWN]]

    def _of_part(self, part: str) -> list[int]:
        found, start = list[int](), 0
        while start < len(part):
            before = "##" if start else ""
            ends = range(len(part), start, -1)
            end = next((end for end in ends if before + part[start:end] in self._ids), None)
            if end is None:
                return [self._ids[UNKNOWN]]
            found.append(self._ids[before + part[start:end]])
            start = end
        return found
