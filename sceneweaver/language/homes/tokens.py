"""A request for a home as tokens: measures, numbers and the longest phrases that the lexicon knows."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from sceneweaver.language.model import Span
from sceneweaver.language.source import FOOT, SQUARE_FOOT, check_text
from sceneweaver.language.translation import language_of, tables, translated
from sceneweaver.language.vocabulary import NUMBERS
from sceneweaver.language.word_forms import Tables, keys

from .lexicon import LONGEST, data, known

MOST = 4000
"""Characters that are read."""

_NUMBER = r"\d{1,3}(?:[, ]\d{3})+|\d{1,6}(?:[.,]\d{1,2})?"
_SQUARE = r"(?:m2|m²|sqm|sq\.? ?m(?:et(?:er|re)s?)?\b|square[- ]met(?:er|re)s?|square m\b|qm\b)"
_FEET2 = r"(?:sq\.? ?ft\.?|sqft|square[- ]f(?:ee|oo)t|ft2|ft²)"
_LENGTH = r"(?:met(?:er|re)s?|m|feet|foot|ft)"
_TOKEN = re.compile(
    rf"(?P<area>(?P<low>{_NUMBER})(?: ?(?:to|-|–) ?(?P<high>{_NUMBER}))?[ -]?"
    rf"(?:(?P<sqm>{_SQUARE})|(?P<sqft>{_FEET2})))(?![\w])"
    rf"|(?P<dims>(?P<w>{_NUMBER}) ?(?P<wu>{_LENGTH})? ?(?:x|×|by|\*) ?(?P<d>{_NUMBER}) ?(?P<du>{_LENGTH}))(?![\w])"
    rf"|(?P<length>(?P<l>{_NUMBER})[ -]?(?P<lu>{_LENGTH}))(?![\w²])"
    r"|(?P<number>\d+(?:\.\d+)?)"
    r"|(?P<short>\bw/(?!c\b|o\b))"
    r"|(?P<word>[^\W\d_]+(?:'[^\W\d_]+|'(?=\s|-|$))?|&)"
    r"|(?P<sign>[.;:,()!?/+\n])"
)
_PLAIN = {"‘": "'", "’": "'", "“": " ", "”": " ", "–": "-", "—": ",", "…": ".", "\u00a0": " ", "²": "2", "•": "\n"}
_DASH = re.compile(r"(?<=[^\W\d]) - |(?<=[!?)]) - ")
_TENS = {n for n in NUMBERS.values() if 20 <= n < 100}


@dataclass
class Token:
    """A phrase of the request: ``kinds`` is all that it may mean; ``span`` is where it stands."""

    text: str
    kinds: Mapping[str, Any]
    span: Span
    plural: bool = False
    glued: bool = False
    """Whether a hyphen joins it to the next."""
    done: str = ""
    """What became of it; empty while nothing did."""
    extra: dict[str, Any] = field(default_factory=dict[str, Any])

    def get(self, kind: str) -> Any:
        """What it means as one of a kind; None where it is none."""
        return self.kinds.get(kind)

    def has(self, *kinds: str) -> bool:
        """Whether it may be one of these kinds."""
        return any(kind in self.kinds for kind in kinds)

    @property
    def number(self) -> int | None:
        """The whole number that it is; 1 for an article."""
        value = self.kinds.get("number")
        return int(value) if value is not None else 1 if self.text in ("a", "an") else None

    @property
    def stops(self) -> bool:
        """Whether a sentence ends with it."""
        return self.text in (".", ";", "!", "?", "\n")

    @property
    def breaks(self) -> bool:
        """Whether it separates parts of a sentence."""
        return self.stops or self.text in (",", ":", "(", ")")


@dataclass(frozen=True)
class Spoken:
    """A request as tokens, in English; ``language`` is that of the request."""

    text: str
    language: str
    tokens: tuple[Token, ...]


@dataclass
class _Raw:
    text: str
    start: int
    end: int
    kinds: dict[str, Any]
    glued: bool = False


def spoken(text: str) -> Spoken:
    """The tokens of a request.

    Raises:
        InputError: when there is nothing to read, or far too much.
    """
    check_text(text)
    letters: list[str] = []
    origin: list[int] = []
    text_read = _DASH.sub(" , ", text[:MOST])  # a dash between words separates, as a comma does
    for index, letter in enumerate(text_read):
        for one in unicodedata.normalize("NFKC", _PLAIN.get(letter, letter)).lower():
            letters.append(one)
            origin.append(index)
    said = "".join(letters)
    language = language_of(said)
    if language != "en":
        said, origin = translated(said, origin, language, text, _tables(language))
    raw = _raw(said)
    found = _phrases(raw, origin)
    return Spoken(text, language, tuple(_numbers(found)))


@cache
def _tables(language: str) -> Tables:
    """The words of a language with those of homes, some of which mean something else in a single room."""
    known = tables(language)
    own = {
        str(phrase): (str(english), kind)
        for kind, rows in data("translations")[language].items()
        for phrase, english in rows.items()
    }
    phrases = {**known.phrases, **own}
    plain, nouns, adjectives = keys(phrases, language)
    rooms = {name: kind for name, kind in known.rooms.items() if name not in own}
    return replace(known, phrases=phrases, plain=plain, nouns=nouns, adjectives=adjectives, rooms=rooms)


def _value(text: str) -> float:
    text = re.sub(r"(?<=\d)[, ](?=\d{3}(?:\D|$))", "", text)
    return float(text.replace(",", ".").replace(" ", ""))


def _metres(number: str, unit: str | None) -> float:
    return round(_value(number) * (FOOT if unit and unit.startswith("f") else 1.0), 3)


def _raw(text: str) -> list[_Raw]:
    found: list[_Raw] = []
    for m in _TOKEN.finditer(text):
        kinds: dict[str, Any] = {}
        if m["area"]:
            factor = SQUARE_FOOT if m["sqft"] else 1.0
            low = _value(m["low"]) * factor
            high = _value(m["high"]) * factor if m["high"] else low
            kinds["area"] = (round(low, 2), round(high, 2))
        elif m["dims"]:
            kinds["dims"] = (_metres(m["w"], m["wu"] or m["du"]), _metres(m["d"], m["du"]))
        elif m["length"]:
            kinds["length"] = _metres(m["l"], m["lu"])
        elif m["number"]:
            kinds["number"] = float(m["number"])
        elif m["sign"]:
            kinds["sign"] = True
        found.append(_Raw("with" if m["short"] else m[0], m.start(), m.end(), kinds))
    for one, two in zip(found, found[1:], strict=False):
        one.glued = text[one.end : two.start] == "-"
    return found


def _phrases(raw: Sequence[_Raw], origin: Sequence[int]) -> list[Token]:
    found: list[Token] = []
    at = 0
    while at < len(raw):
        one = raw[at]
        end, kinds, plural = at + 1, one.kinds, False
        if not kinds:
            if one.text in NUMBERS:
                kinds = {"number": float(NUMBERS[one.text])}
            for length in range(min(LONGEST, len(raw) - at), 0, -1):
                if any(word.kinds and word.text != "/" for word in raw[at : at + length]):
                    continue
                said = (
                    "place" if word.text == "somewhere" and length > 1 else word.text for word in raw[at : at + length]
                )
                meant = known(" ".join(said))
                if meant is not None:
                    end, plural = at + length, meant[1]
                    kinds = {**meant[0], **kinds} if length == 1 else meant[0]
                    break
        last = raw[end - 1]
        places = origin[one.start : last.end] or [origin[-1]]
        span = Span(min(places), max(places) + 1)
        text = " ".join(word.text for word in raw[at:end])
        found.append(Token(text, kinds, span, plural, last.glued))
        at = end
    return found


def _numbers(found: Sequence[Token]) -> list[Token]:
    """ "Twenty five" is one number; "seventy square metres" an area, "six metres" a length."""
    out: list[Token] = []
    for token in found:
        last = out[-1] if out else None
        before = last.get("number") if last is not None else None
        own = token.get("number")
        if last is not None and before is not None:
            if own is not None and before in _TENS and own < 10 and not last.text.isdigit():
                value = before + own
                out[-1] = Token(f"{last.text} {token.text}", {"number": value}, _over(last, token), glued=token.glued)
                continue
            if token.text == "hundred":
                out[-1] = Token(f"{last.text} hundred", {"number": before * 100}, _over(last, token), glued=token.glued)
                continue
            if token.text in ("square metre", "square metres", "square meters", "square meter"):
                out[-1] = Token(f"{last.text} m2", {"area": (before, before)}, _over(last, token))
                continue
            if token.text in ("square feet", "square foot"):
                value = round(before * SQUARE_FOOT, 1)
                out[-1] = Token(f"{last.text} sq ft", {"area": (value, value)}, _over(last, token))
                continue
            if token.text in ("metres", "meters", "metre", "meter") and not last.text.isdigit():
                out[-1] = Token(f"{last.text} m", {"length": float(before)}, _over(last, token))
                continue
        out.append(token)
    return out


def _over(one: Token, two: Token) -> Span:
    return Span(min(one.span.start, two.span.start), max(one.span.end, two.span.end))
