"""Finds secrets in text, however they are written: texts and secrets are brought into normal forms and compared.

A text is read as it stands and with its escapes taken back (percent, JSON, HTML, wide letters), each time without
white space, without all that is no letter or digit and in one case, and as what stands between quotes alone. A secret
is looked for as it is, rotated, as numbers of characters and in the base encodings, forwards and backwards. What is
packed (gzip, zlib, deflate) in base64 is unpacked, also once more within that, and looked at likewise.
"""

from __future__ import annotations

import base64
import html
import re
import string
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain, groupby, pairwise

from .packed import unpacked

HIDDEN = "[secret]"
"""What stands where a secret was."""

SHORTEST = 8
"""Characters from which on a value is taken for a secret: local servers are given keys such as "EMPTY"."""

PIECE = 12
"""Characters of a secret or of its code in a row that give it away: half of one in one field, half in the next."""

RANDOM_PIECE = 8
"""The same of secrets for pieces that no word looks like."""

SCATTERED_PIECE = 6
"""Letters and digits of pieces that give a secret away together, whatever stands between them."""

SCATTERED_SHARE = 0.6
"""Share of the letters and digits of a secret from which on such pieces are hidden."""

LAYERS = 2
"""Packings within each other that are taken off."""

ROUNDS = 4
"""Times that escapes are taken back: a percent sign may be written in percent itself."""

_ESCAPE = re.compile(
    r"%[0-9A-Fa-f]{2}|\\u\{[0-9A-Fa-f]{1,6}\}|\\u[0-9A-Fa-f]{4}|\\x[0-9A-Fa-f]{2}|\\[0-7]{3}|\\."
    r"|&\#?\w{1,10};|[^\x00-\x7f]",
    re.DOTALL,
)
_LETTERS = re.compile(r"[0-9A-Za-z]+")
_VISIBLE = re.compile(r"[^\s\x00\u00ad\u200b-\u200d\u2060\ufeff]+")
_READABLE = re.compile(rf"[\x00\s!-~]{{{SHORTEST}}}")
_QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"(\s*:)?', re.DOTALL)

_NUMBERS = (
    ("{}", 18),
    ("{:03}", 18),
    ("{:02x}", 16),
    ("0x{:02x}", 24),
    ("x{:02x}", 18),
    ("u{:04x}", 30),
    ("u{:02x}", 18),
    ("{:o}", 20),
    ("{:03o}", 18),
    ("0o{:o}", 30),
    ("{:07b}", 49),
    ("{:08b}", 48),
    ("0b{:b}", 60),
)
"""How the number of a character is written, and so many characters of a row of them that give a secret away."""

_BASES: tuple[tuple[Callable[[bytes], bytes], int, int], ...] = (
    (base64.b64encode, 6, 3),
    (base64.b32encode, 5, 5),
    (base64.b32hexencode, 5, 5),
)
"""Codes in letters and digits: bits of a character, bytes after which the code begins anew."""

_UPPER, _LOWER, _DIGITS = string.ascii_uppercase, string.ascii_lowercase, string.digits

_Spans = Sequence[tuple[int, int]]


class Cleaner:
    """Takes certain secrets out of texts. Shows none of them, wherever it is printed."""

    __slots__ = ("_exact", "_loose", "_scattered")

    def __init__(self, secrets: Iterable[str]) -> None:
        kept = list(secrets)
        self._exact = _Pieces(piece for secret in kept for piece in _exact(secret))
        self._loose = _Pieces(piece for secret in kept for piece in _loose(secret))
        self._scattered = [_Scattered(letters) for secret in kept if (letters := _random_letters(secret))]

    def clean(self, texts: Sequence[str]) -> list[str]:
        """The texts without secrets, also without one that goes on from text to text."""
        whole = "\n".join(texts)
        hidden = bytearray(len(whole))
        for start, end in self._found(whole):
            hidden[start:end] = b"\x01" * (end - start)
        if not any(hidden):
            return list(texts)
        cleaned: list[str] = []
        at = 0
        for text in texts:
            runs = groupby(zip(hidden[at : at + len(text)], text, strict=True), lambda pair: pair[0])
            cleaned.append("".join(HIDDEN if flag else "".join(letter for _, letter in run) for flag, run in runs))
            at += len(text) + 1
        return cleaned

    def _found(self, text: str, layers: int = LAYERS) -> Iterator[tuple[int, int]]:
        """Start and end of all that gives a secret away; ``layers`` of packing are taken off."""
        if not (self._exact or self._loose):
            return
        for read, places in _readings(text):
            packages = unpacked(read) if layers else ()
            packed = [(start, end) for start, end, said in packages if self._is_told(said, layers - 1)]
            visible, letters = ([match.span() for match in kind.finditer(read)] for kind in (_VISIBLE, _LETTERS))
            quoted = [match.span(1) for match in _QUOTED.finditer(read) if not match[2]]  # no names of fields
            values = [match.span() for start, end in quoted for match in _LETTERS.finditer(read, start, end)]
            small = read.translate(_SMALL)
            found = [self._loose.places(small, letters), self._loose.places(small, values)]
            found += [secret.places(small, letters) for secret in self._scattered]
            for start, end in chain(self._exact.places(read, visible), *found, packed):
                yield (start, end) if places is None else (places[start][0], places[end - 1][1])

    def _is_told(self, said: str | None, layers: int) -> bool:
        """Whether a text that was unpacked gives a secret away; one too large to look at (None) counts as such."""
        return said is None or (bool(_READABLE.search(said)) and any(True for _ in self._found(said, layers)))


class _Pieces:
    """Texts to look for, by how they begin."""

    __slots__ = ("_known",)

    def __init__(self, pieces: Iterable[str]) -> None:
        self._known: dict[str, set[str]] = {}
        for piece in pieces:
            self._known.setdefault(piece[:SHORTEST], set()).add(piece)

    def __bool__(self) -> bool:
        return bool(self._known)

    def places(self, text: str, kept: _Spans) -> Iterator[tuple[int, int]]:
        """Where they are in the kept parts of a text, taken together; start and end in the text."""
        known = self._known
        joined = "".join(text[start:end] for start, end in kept)
        begun = [at for at in range(len(joined) - SHORTEST + 1) if joined[at : at + SHORTEST] in known]
        if not begun:
            return
        place = list(chain.from_iterable(range(start, end) for start, end in kept))
        for at in begun:
            for piece in known[joined[at : at + SHORTEST]]:
                if joined.startswith(piece, at):
                    yield place[at], place[at + len(piece) - 1] + 1


class _Scattered:
    """The letters and digits of one secret, to be found in pieces with other words between them."""

    __slots__ = ("_count", "_known")

    def __init__(self, letters: str) -> None:
        self._count = len(letters)
        self._known: dict[str, int] = {piece: at for at, piece in enumerate(_pieces(letters, SCATTERED_PIECE))}

    def places(self, text: str, kept: _Spans) -> Iterator[tuple[int, int]]:
        """Where its pieces are in the kept parts of a text, taken together, where they are most of it."""
        joined = "".join(text[start:end] for start, end in kept)
        size, known = SCATTERED_PIECE, self._known
        begun = [at for at in range(len(joined) - size + 1) if joined[at : at + size] in known]
        covered = {known[joined[at : at + size]] + k for at in begun for k in range(size)}
        if len(covered) < SCATTERED_SHARE * self._count:
            return
        place = list(chain.from_iterable(range(start, end) for start, end in kept))
        for at in begun:
            yield place[at], place[at + size - 1] + 1


def _readings(text: str) -> Iterator[tuple[str, _Spans | None]]:
    """A text as it stands, and with its escapes taken back once, twice ...; and where its characters were."""
    yield text, None
    places: _Spans = [(at, at + 1) for at in range(len(text))] if _ESCAPE.search(text) else []
    for _ in range(ROUNDS if places else 0):
        parts: list[str] = []
        found: list[tuple[int, int]] = []
        at = 0
        for match in _ESCAPE.finditer(text):
            start, end = match.span()
            plain = _plain(match[0])
            parts += (text[at:start], plain)
            found += places[at:start]
            found += [(places[start][0], places[end - 1][1])] * len(plain)
            at = end
        read = "".join(parts) + text[at:]
        if read == text:
            return
        text, places = read, [*found, *places[at:]]
        yield text, places


def _plain(escape: str) -> str:
    """What an escape stands for."""
    if escape[0] == "%":
        return chr(int(escape[1:], 16))
    if escape[0] == "&":
        return html.unescape(escape)
    if escape[0] != "\\":
        return unicodedata.normalize("NFKC", escape)
    digits = escape[2:].strip("{}")
    if digits:
        number = int(digits, 16) if escape[1] in "ux" else int(escape[1:], 8)
        return chr(number) if number <= 0x10FFFF else ""
    return " " if escape[1] in "nrtfbv0" else escape[1]


def _exact(secret: str) -> Iterator[str]:
    """What is looked for as it stands, but for white space."""
    seen = "".join(_VISIBLE.findall(secret))
    for text in (seen, seen[::-1]):
        yield from _whole(text)
        if not _is_words(secret):
            yield from _pieces(text, PIECE)
            yield from filter(_is_random, _pieces(text, RANDOM_PIECE))
    raw = secret.encode(errors="surrogateescape")
    yield from _pieces(seen.translate(_ROT47), PIECE)
    for shift in range(4):
        last = 5 * ((shift + len(raw)) // 4)
        for encode in (base64.a85encode, base64.b85encode):
            yield from _pieces(encode(b"\x01" * shift + raw).decode()[5 * min(shift, 1) : last], PIECE)


def _loose(secret: str) -> Iterator[str]:
    """What is looked for among letters and digits alone, in small letters."""
    for text in (secret, secret[::-1]):
        for form, size in _NUMBERS:
            yield from _pieces("".join(form.format(ord(character)) for character in text), size)
        raw = text.encode(errors="surrogateescape")
        for encode, bits, period in _BASES:
            for shift in range(period):  # the same bytes look different by how many stand before them
                code = encode(bytes(shift) + raw).decode()[-(-shift * 8 // bits) : (shift + len(raw)) * 8 // bits]
                for way in (code, code[::-1]):
                    yield from _pieces("".join(_LETTERS.findall(way)).lower(), PIECE)
    plain = unicodedata.normalize("NFKC", secret)
    for read in {plain, [text for text, _ in _readings(plain)][-1]}:
        letters = "".join(_LETTERS.findall(read))
        if _is_words(secret) or not (len(letters) >= PIECE or _is_random(letters)):
            continue
        for text in (letters, letters[::-1]):
            yield from _whole(text.lower())
            for size in (RANDOM_PIECE, PIECE):
                yield from (piece.lower() for piece in _pieces(text, size) if _is_random(piece))
            for rotation in _ROTATIONS:
                if (rotated := text.lower().translate(rotation)) != text.lower():
                    yield from _pieces(rotated, PIECE)


def _random_letters(secret: str) -> str:
    """Letters and digits of a secret in small letters; "" of one that may be made of words."""
    letters = "".join(_LETTERS.findall(unicodedata.normalize("NFKC", secret)))
    return letters.lower() if _is_random(letters) and not _is_words(secret) and len(letters) >= PIECE else ""


def _whole(text: str) -> Iterator[str]:
    if len(text) >= SHORTEST:
        yield text


def _pieces(text: str, size: int) -> Iterator[str]:
    """All pieces of a size, or a shorter text as a whole."""
    if len(text) < size:
        return _whole(text)
    return (text[at : at + size] for at in range(len(text) - size + 1))


def _is_words(secret: str) -> bool:
    """Whether it is a path or a sentence, as some such variables hold: its parts are words of others as well."""
    return secret.startswith(("/", ".", "~")) or bool(re.search(r"\s", secret))


def _is_random(text: str) -> bool:
    """Whether letters, digits and signs change as they do in no word: "CamelCase2" is one change from small to large,
    and one to a digit; a large letter before a small one is none, and "-" and "_" do not count."""
    small, large = (True, False), (False, True)
    signs = re.sub(r"[-_.]", "", text)
    kinds = ["digit" if sign.isdigit() else (sign.islower(), sign.isupper()) for sign in signs]
    return sum(one != other and (one, other) != (large, small) for one, other in pairwise(kinds)) >= 2


_SMALL = str.maketrans(_UPPER, _LOWER)
_ROT47 = {ord("!") + i: ord("!") + (i + 47) % 94 for i in range(94)}
_ROTATIONS = [
    *(str.maketrans(_LOWER, _LOWER[by:] + _LOWER[:by]) for by in range(1, 26)),
    str.maketrans(_LOWER + _DIGITS, _LOWER[13:] + _LOWER[:13] + _DIGITS[5:] + _DIGITS[:5]),
    str.maketrans(_LOWER, _LOWER[::-1]),
]
