"""Words into tokens: the longest known phrase at each place, with everything that it can mean."""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from typing import Any

from .clean import metres
from .tables import LONGEST, NUMBERS, vocabulary

_WORD = re.compile(r"§\d+|\d+(?:[.,]\d+)?|[a-z][a-z'&/]*|[^\W\d_]+|[.,()&]")
_UNIT = re.compile(r"^(meters?|metres?|m|cm|centimeters?|centimetres?|ft|feet|foot|inch(?:es)?|in)$")
_RANGE = re.compile(r"(\d+)\s*(?:-|to|or)\s*(\d+)")

SHORT = 5
"""Letters that a word must have for its spelling to be mended."""


LONG = 8
"""Letters from which two slips are forgiven."""


@dataclass
class Token:
    """One phrase: ``kinds`` maps what it can be to its value; a word that is not known has none."""

    text: str
    kinds: dict[str, Any] = field(default_factory=dict)

    def has(self, *kinds: str) -> bool:
        """Whether it can be one of these."""
        return any(kind in self.kinds for kind in kinds)

    def get(self, kind: str) -> Any:
        """What it means as one of a kind; None when it cannot be that."""
        return self.kinds.get(kind)


def tokens(text: str, notes: list[str], sides: Sequence[tuple[float, ...]] = ()) -> list[Token]:
    """The tokens of a clean text, where "§k" stands for ``sides[k]`` [m]; corrected spellings are noted."""
    text = _RANGE.sub(r"\1 ~ \2", text.replace("-", "-"))
    raw = _WORD.findall(text.replace("~", " rangeto ").replace("-", " "))
    table = vocabulary()
    found: list[Token] = []
    at = 0
    while at < len(raw):
        word = raw[at]
        if word in ".,()":
            found.append(Token(word, {"break": word}))
            at += 1
            continue
        if word[0] == "§":
            found.append(Token("sides", {"sides": sides[int(word[1:])]}))
            at += 1
            continue
        if word[0].isdigit():
            at = _number(raw, at, found)
            continue
        for length in range(min(LONGEST, len(raw) - at), 0, -1):
            phrase = " ".join(raw[at : at + length])
            if phrase in table:
                found.append(Token(phrase, dict(table[phrase])))
                at += length
                break
        else:
            found.append(_mended(raw, at, notes))
            at += 1
    return _tens(found)


def _number(raw: list[str], at: int, found: list[Token]) -> int:
    """A number: a count, a range of counts, or a length with its unit."""
    word = raw[at]
    after = raw[at + 1] if at + 1 < len(raw) else ""
    if after == "rangeto" and at + 2 < len(raw) and word.isdigit() and raw[at + 2].isdigit():
        low, high = sorted((int(word), int(raw[at + 2])))
        found.append(Token(f"{word} to {raw[at + 2]}", {"amount": (low, high)}))
        return at + 3
    if _UNIT.match(after):
        length = metres(word, after) if not after.startswith("in") else float(word.replace(",", ".")) * 0.0254
        found.append(Token(f"{word} {after}", {"length": length}))
        return at + 2
    kinds: dict[str, Any] = {"number": int(word)} if word.isdigit() and len(word) < 6 else {}
    found.append(Token(word, kinds))
    return at + 1


def _mended(raw: list[str], at: int, notes: list[str]) -> Token:
    """A word that is not known, or the one that it was probably meant to be."""
    word = raw[at]
    if len(word) >= SHORT and word.isascii():
        near = _nearest(word)
        if (
            near
            and near[0][0] == word[0]
            and near[0] not in (word + "er", word + "or")
            and (_slips(word, near[0]) <= (1 if len(word) < LONG else 2))
        ):  # "print" stays
            notes.append(f"'{word}' was read as '{near[0]}'")
            return Token(near[0], dict(vocabulary()[near[0]]))
        if at + 1 < len(raw):
            pair = f"{word} {raw[at + 1]}"
            if pair in vocabulary():
                return Token(pair, dict(vocabulary()[pair]))
    return Token(word)


def _slips(a: str, b: str) -> int:
    """Letters wrong, missing, too many or changed round between two words."""
    rows = [list(range(len(b) + 1))]
    for i, x in enumerate(a, start=1):
        row = [i]
        for j, y in enumerate(b, start=1):
            best = min(rows[-1][j] + 1, row[-1] + 1, rows[-1][j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                best = min(best, rows[-2][j - 2] + 1)
            row.append(best)
        rows.append(row)
    return rows[-1][-1]


@lru_cache(maxsize=4096)
def _nearest(word: str) -> list[str]:
    """The known word that is most like one, if any is; it is the slow part of a long text of unknown words."""
    return difflib.get_close_matches(word, _single_words(), n=1, cutoff=0.82)


@cache
def _single_words() -> list[str]:
    useful = ("noun", "room", "color", "styles", "relation", "place", "number", "material", "shape")
    return sorted(
        w
        for w, kinds in vocabulary().items()
        if " " not in w and len(w) >= SHORT - 1 and any(k in kinds for k in useful)
    )


def _tens(found: list[Token]) -> list[Token]:
    """ "twenty five" is 25, "two hundred" 200."""
    out: list[Token] = []
    for token in found:
        last = out[-1].get("number") if out else None
        value = token.get("number")
        if isinstance(last, int) and isinstance(value, int) and token.text in NUMBERS and out[-1].text in NUMBERS:
            if last >= 20 and last % 10 == 0 and 0 < value < 10:
                out[-1] = Token(f"{out[-1].text} {token.text}", {"number": last + value})
                continue
            if value == 100 and 0 < last < 10:
                out[-1] = Token(f"{out[-1].text} {token.text}", {"number": 100 * last})
                continue
        out.append(token)
    return out
