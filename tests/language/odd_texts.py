"""Texts that nobody writes, from a seed: strange letters, bytes, known words in any order, sentences gone wrong."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator

from sceneweaver.language.source import LONGEST
from sceneweaver.language.vocabulary import vocabulary
from tests.language.made_requests import MadeRequests

LETTERS = (
    range(0x20, 0x7F),  # ASCII
    range(0x00, 0x20),  # control
    range(0x7F, 0xA0),
    range(0xA0, 0x250),  # Latin
    range(0x300, 0x370),  # combining
    range(0x370, 0x530),  # Greek, Cyrillic
    range(0x590, 0x700),  # right to left, digits of Arabic
    range(0x900, 0x980),  # Devanagari and its digits
    range(0xE00, 0xE60),  # Thai
    range(0x2000, 0x2070),  # wide and zero-width blanks, changes of direction
    range(0x2070, 0x20A0),  # raised and lowered digits
    range(0x2150, 0x2190),  # fractions, Roman numbers
    range(0x2460, 0x2500),  # numbers in circles and brackets
    range(0x2776, 0x2794),
    range(0x3000, 0x3100),
    range(0x4E00, 0x4F00),
    range(0xD800, 0xE000),  # halves of pairs
    range(0xE000, 0xE010),  # private
    range(0xFB00, 0xFB10),  # ligatures
    range(0xFE00, 0xFE10),  # variation selectors
    range(0xFF00, 0xFF60),  # wide
    range(0x1D7CE, 0x1D800),  # mathematical digits
    range(0x1F300, 0x1F650),  # emoji
    range(0x1F3FB, 0x1F400),
    range(0xE0000, 0xE0080),  # tags
)

GLUE = """
, . : ; ! ? ( ) [ ] { } < > / \\ - -- ' " & § % # * | and or of is are was with no not each two one it them another
the other its a an to in on by at for 3 4.5 2,5 1e9 x 0
""".split()  # noqa: SIM905

NUMBERS = (
    "9" * 12,
    "0",
    "-7",
    "1e999",
    "3.5",
    "2,25",
    "1.2.3",
    "007",
    "½",
    "❽",
    "Ⅷ",
    "٣",
    "twelve",
    "999999",
    "9" * 400,
)
UNITS = ("m", "cm", "m2", "m²", "sq ft", "'", "feet", "by", "x 3 m", "km", "%", "people", "mm", "m high", "m ceiling")


class OddTexts:
    """Endless texts from a seed; equal seeds give equal texts."""

    def __init__(self, seed: int) -> None:
        self._rng = random.Random(seed)
        self._made = MadeRequests(seed)
        self._kinds: dict[str, list[str]] = {}
        for phrase, meant in vocabulary().items():
            for kind in meant:
                self._kinds.setdefault(kind, []).append(phrase)
        self._names = sorted(self._kinds)
        self._ways: tuple[Callable[[], str], ...] = (
            self._letters,
            self._bytes,
            self._words,
            self._words,
            self._measures,
            self._broken,
            self._broken,
            lambda: f"{self._words()} {self._letters()} {self._words()}",
        )

    def __iter__(self) -> Iterator[str]:
        while True:
            yield self._rng.choice(self._ways)()

    def long(self) -> Iterator[str]:
        """Texts as long as any that is read, each of a few words over and over."""
        while True:
            unit = self._rng.choice((self._words, self._words, self._measures, self._letters, self._broken))()
            unit = " ".join(unit.split(" ")[: self._rng.choice((1, 1, 2, 3, 5, 9))])
            unit += self._rng.choice((" ", " ", " ", "", ", ", ". ", " and ", " of ", "\n"))
            yield unit * (LONGEST // len(unit) + 1) if unit.strip() else "x"

    def _letters(self) -> str:
        """Letters of a few scripts."""
        scripts = self._rng.sample(LETTERS, self._rng.randint(1, 4))
        return "".join(chr(self._rng.choice(self._rng.choice(scripts))) for _ in range(self._rng.randint(1, 80)))

    def _bytes(self) -> str:
        raw = self._rng.randbytes(self._rng.randint(1, 120))
        encoding, errors = self._rng.choice(
            (("latin-1", "strict"), ("utf-8", "replace"), ("utf-8", "surrogateescape"), ("utf-16", "replace"))
        )
        return raw.decode(encoding, errors)

    def _word(self) -> str:
        return self._rng.choice(self._kinds[self._rng.choice(self._names)])

    def _words(self) -> str:
        """What the reader knows, in any order."""
        often = self._rng.choice((0.1, 0.4, 0.7))
        length = self._rng.randint(1, 24)
        found = [self._rng.choice(GLUE) if self._rng.random() < often else self._word() for _ in range(length)]
        return self._rng.choice((" ", " ", " ", "-", "")).join(found)

    def _measures(self) -> str:
        found: list[str] = []
        for _ in range(self._rng.randint(1, 8)):
            found += [self._rng.choice(NUMBERS), self._rng.choice(UNITS), self._word()]
        return " ".join(w for w in found if self._rng.random() < 0.8)

    def _broken(self) -> str:
        """A request with words that are gone, doubled, changed round, cut or strange."""
        words = self._made.request().split(" ")
        for _ in range(self._rng.randint(1, 6)):
            at = self._rng.randrange(len(words))
            words[at : at + 1] = self._rng.choice(
                (
                    [],
                    [words[at]] * 3,
                    [words[at][::-1]],
                    [words[at][: self._rng.randint(0, len(words[at]))]],
                    [words[at].upper()],
                    [self._word(), words[at]],
                    [words[at], self._rng.choice(GLUE)],
                    [self._letters()],
                    [words[at], *self._made.request().split(" ")[:4]],
                    [self._rng.choice(NUMBERS), words[at]],
                )
            )
            words = words or ["."]
        return " ".join(words)
