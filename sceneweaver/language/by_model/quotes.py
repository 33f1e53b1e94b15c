"""Where in a text the words stand that a model quotes from it.

Characters that people take for one (a letter with its marks, an emoji of several code points, the parts of a Hangul
syllable) are never cut, and spans count characters of the text as it was given. Case, kinds of blanks, apostrophes and
hyphens, composed or decomposed letters and characters that nobody sees make no difference; where nothing is found,
marks on letters make none either.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from ..model import Span

_PLAIN = str.maketrans({"‘": "'", "’": "'", "ʼ": "'", "´": "'", "`": "'", "“": '"', "”": '"', "„": '"', "«": '"'})
_MORE = str.maketrans({"»": '"', "‐": "-", "‑": "-", "–": "-", "—": "-", "−": "-", "\u0640": None})
_JOINER = "\u200d"

_UNSPACED = (
    (0x0E00, 0x0EFF),
    (0x1000, 0x109F),
    (0x1780, 0x17FF),
    (0x2E80, 0x9FFF),
    (0xF900, 0xFAFF),
    (0xFF66, 0xFF9F),
    (0x20000, 0x3FFFF),
)

MOST = 100
"""Places of the same words that are looked at."""


class Quotes:
    """A text to find words in."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._folded = _Folded(text, marks=True)
        self._bare: _Folded | None = None
        self._known: dict[str, list[Span]] = {}

    def all(self, quote: str) -> list[Span]:
        """The places of some words, in order, at most `MOST`; only whole words where there are any of these."""
        if quote not in self._known:
            self._known[quote] = self._all(quote)
        return self._known[quote]

    def _all(self, quote: str) -> list[Span]:
        found = self._folded.places(quote)
        if not found:
            self._bare = self._bare or _Folded(self.text, marks=False)
            found = self._bare.places(quote)
        whole = [span for span in found if self._is_whole(span)]
        return whole or found

    def next(self, quote: str, taken: set[Span]) -> Span | None:
        """The first place that is not taken, else the first; None: not there."""
        found = self.all(quote)
        return next((span for span in found if span not in taken), found[0] if found else None)

    def nearest(self, quote: str, to: Span | None) -> Span | None:
        """The place nearest to another; None: not there."""
        found = self.all(quote)
        if to is None or not found:
            return found[0] if found else None
        return min(found, key=lambda span: (max(to.start - span.end, span.start - to.end, 0), span.start))

    def _is_whole(self, span: Span) -> bool:
        """Whether a span begins and ends where words do; in scripts without blanks everything does."""
        before, after = self.text[max(0, span.start - 1) : span.start], self.text[span.end : span.end + 1]
        return not (_joined(before, self.text[span.start]) or _joined(self.text[span.end - 1], after))


def _joined(one: str, other: str) -> bool:
    """Whether two characters are within one word."""
    return bool(one and other) and one.isalnum() and other.isalnum() and not (_unspaced(one) or _unspaced(other))


def _unspaced(letter: str) -> bool:
    """Whether a letter is of a script that sets no blanks between words: Thai to Khmer, kana, Chinese characters."""
    code = ord(letter)
    return any(low <= code <= high for low, high in _UNSPACED)


class _Folded:
    """A text as it is compared, with the characters of the original that each of its characters stands for."""

    def __init__(self, text: str, marks: bool) -> None:
        self._marks = marks
        letters: list[str] = []
        self._clusters: list[Span] = []
        for span in _clusters(text):
            folded = _fold(text[span.start : span.end], marks)
            if folded == " " and letters[-1:] == [" "]:
                continue
            letters += folded
            self._clusters += [span] * len(folded)
        self._text = "".join(letters)

    def places(self, quote: str) -> list[Span]:
        """Where a quote stands."""
        asked = "".join(_fold(quote[span.start : span.end], self._marks) for span in _clusters(quote))
        asked = " ".join(asked.split())
        if not asked:
            return []
        found: list[Span] = []
        at = self._text.find(asked)
        while at >= 0 and len(found) < MOST:
            last = at + len(asked) - 1
            span = Span(self._clusters[at].start, self._clusters[last].end)
            begins = at == 0 or self._clusters[at - 1] != self._clusters[at]
            ends = last + 1 == len(self._text) or self._clusters[last + 1] != self._clusters[last]
            if begins and ends:
                found.append(span)
            at = self._text.find(asked, at + 1)
        return found


def _fold(cluster: str, marks: bool) -> str:
    """One cluster as it is compared; nothing where it cannot be seen."""
    plain = unicodedata.normalize("NFKC", cluster.translate(_PLAIN).translate(_MORE)).casefold()
    if not marks:
        plain = "".join(c for c in unicodedata.normalize("NFKD", plain) if not unicodedata.combining(c))
    plain = re.sub(r"\s+", " ", plain)
    return "".join(c for c in plain if c == " " or not _unseen(c))


def _unseen(letter: str) -> bool:
    return unicodedata.category(letter) in ("Cf", "Cc") or 0xFE00 <= ord(letter) <= 0xFE0F


def _clusters(text: str) -> Iterator[Span]:
    """What is read as one character: a base with all that belongs to it."""
    start = 0
    for at in range(1, len(text) + 1):
        if at < len(text) and _extends(text, at):
            continue
        yield Span(start, at)
        start = at


def _extends(text: str, at: int) -> bool:
    """Whether the character there belongs to the one before."""
    code, before = ord(text[at]), text[at - 1]
    return (
        unicodedata.category(text[at]) in ("Mn", "Mc", "Me")
        or text[at] == _JOINER
        or before == _JOINER
        or 0x1F3FB <= code <= 0x1F3FF
        or (0x1160 <= code <= 0x11FF and 0x1100 <= ord(before) <= 0x11FF)
    )
