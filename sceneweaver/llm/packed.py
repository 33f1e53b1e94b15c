"""Finds what is packed (gzip, zlib, deflate) and written in base64 within a text, and unpacks a bounded part of it."""

from __future__ import annotations

import base64
import re
import zlib
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

MOST = 2**20
"""Bytes that one packed text is unpacked to at most."""

MOST_IN_ALL = 2**25
"""Bytes that all packed texts within a text are unpacked to at most."""

_AT_A_TIME = 32
"""Letters that are decoded at a time, a multiple of four: what comes before damage is not lost."""

_RUN = re.compile(r"[A-Za-z0-9+/_-]{12,}(?:\s+[A-Za-z0-9+/_-]{4,})*={0,2}")
_START = re.compile(r"(?<!\S)(?=[A-Za-z0-9+/_-]{12})|(?=H4sI|e[AFJN])")  # of a word, of gzip, of zlib
_LETTER = re.compile(r"[^\s=]")
_STANDARD = str.maketrans("-_", "+/")
_HEADERS = (47, -15)  # zlib's words for a header of gzip or zlib, and for none


class Unpacked(NamedTuple):
    """Where a packed text stands, from start to end, and what it says; None: it is more than is unpacked."""

    start: int
    end: int
    said: str | None


def unpacked(text: str) -> Iterator[Unpacked]:
    """All that unpacks, if only its beginning, on one line or several; much of it is chance, and says nothing."""
    left = MOST_IN_ALL
    for run in _RUN.finditer(text):
        for start in (match.start() for match in _START.finditer(run[0])):
            for header in _HEADERS:
                data, end = _inflated(run[0], start, header, min(MOST, left))
                left = max(0, left - (MOST if data is None else len(data)))
                if data is None or data:
                    said = None if data is None else data.decode(errors="replace")
                    yield Unpacked(run.start() + start, run.start() + end, said)


def _inflated(text: str, start: int, header: int, most: int) -> tuple[bytes | None, int]:
    """What the base64 from some place on unpacks to (None: to more than ``most`` bytes, which take all the text), and
    where that ends."""
    inflater, found, end = zlib.decompressobj(header), bytearray(), start
    letters = _LETTER.finditer(text, start)
    while not inflater.eof and (taken := list(islice(letters, _AT_A_TIME))):
        code, end = "".join(letter[0] for letter in taken), taken[-1].end()
        try:
            piece = base64.b64decode(code.translate(_STANDARD) + "=" * (-len(code) % 4))
            found += inflater.decompress(piece, most - len(found) + 1)
        except (ValueError, zlib.error):
            break
        if len(found) > most:
            return None, len(text)
    return bytes(found), end
