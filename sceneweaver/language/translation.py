"""Simple requests in German, Spanish, French and Chinese, word by word into the English that the reader knows.

The words are data (``lexicon/translations``). Each English character keeps the place of the word that it stands for, so
that all that is read still points into the request as it was written. Words that are not in the tables stay as they
are, and are told as not understood.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

from .vocabulary import plural, vocabulary, words

LANGUAGES = ("de", "es", "fr", "zh")

NAMES = {"de": "German", "es": "Spanish", "fr": "French", "zh": "Chinese"}

LONGEST = 4
"""Words of the longest phrase in the tables; characters, in Chinese twice as many."""

SHORTEST_HEAD = 5
"""Letters of the last part of a word, and of what stands before it, for it to be one of two."""

_KINDS = ("nouns", "adjectives", "numbers", "words", "postpositions")
_WORD = re.compile(r"(?:[ldjnsc]|qu)['’](?=\w)|[^\W\d_]+(?:-[^\W\d_]+)*|\d+(?:[.,]\d+)?|\S", re.UNICODE)
_CHINESE = re.compile(r"[\u4e00-\u9fff]")
_ENGLISH = frozenset(["the", "and", "with", "of", "for", "on", "in", "at", "to", "by", "is", "are", "room"])
_UMLAUTS = str.maketrans("äöü", "aou")


class Told(NamedTuple):
    """A word or phrase in English, what kind of word it is, and the characters [start, end) that it stands for."""

    text: str
    kind: str
    start: int
    end: int


@dataclass(frozen=True)
class Tables:
    """The words of a language: phrase to English and kind; endings of inflected words; words between count and noun;
    beginnings of words that make no compound of two nouns."""

    phrases: Mapping[str, tuple[str, str]]
    endings: tuple[str, ...]
    measures: frozenset[str]
    prefixes: frozenset[str]


@cache
def tables(language: str) -> Tables:
    """The words of a language, kinds of rooms in it among them."""
    from sceneweaver.knowledge.load import room_types

    data: Mapping[str, Any] = words(f"translations/{language}")
    found: dict[str, tuple[str, str]] = {}
    for room in room_types():
        for name in room_types().names_of(room, language):
            found[name.lower()] = (room.replace("_", " "), "nouns")
    for kind in _KINDS:
        found |= {phrase: (english, kind) for phrase, english in (data.get(kind) or {}).items()}
    return Tables(
        found, tuple(data.get("endings", ())), frozenset(data.get("measures", ())), frozenset(data.get("prefixes", ()))
    )


def language_of(text: str) -> str:
    """The language of a text in lower case, "en" where it is no other one that is known."""
    letters = sum(c.isalpha() for c in text)
    if not letters:
        return "en"
    if len(_CHINESE.findall(text)) > 0.3 * letters:
        return "zh"
    spoken = _WORD.findall(text)
    english = sum(word in _ENGLISH for word in spoken)
    plain = {word for word in spoken if len(word) > 1 and word not in _ENGLISH and word not in vocabulary()}
    scores = {
        name: sum(word in tables(name).phrases and tables(name).phrases[word][1] != "nouns" for word in plain)
        for name in ("de", "es", "fr")
    }
    if not english:  # a few words: a noun tells as well, beside a word of grammar
        nouns = {name: sum(word in tables(name).phrases for word in plain) for name in scores}
        scores = {name: nouns[name] if told else 0 for name, told in scores.items()}
    best = max(scores, key=lambda name: scores[name])
    return best if scores[best] >= 2 and scores[best] > 2 * english else "en"


def translated(text: str, origin: Sequence[int], language: str, request: str) -> tuple[str, list[int]]:
    """A text in lower case as English, with the place of each of its characters in the request."""
    names = _capitals(text, origin, request) if language == "de" else frozenset[int]()
    told = _chinese(text) if language == "zh" else _spaced(text, language, names)
    ordered = _postposed(told) if language == "zh" else _adjectives_first(told) if language in ("es", "fr") else told
    letters: list[str] = []
    places: list[int] = []
    for one in ordered:
        if not one.text:
            continue
        if letters and not (len(one.text) == 1 and one.text in ",.;:!?"):
            letters.append(" ")
            places.append(origin[one.start])
        step = (one.end - one.start - 1) / max(1, len(one.text) - 1)
        letters += one.text
        places += [origin[one.start + round(k * step)] for k in range(len(one.text))]
    return "".join(letters), places


def unknown_words(text: str, language: str) -> list[tuple[int, int]]:
    """Where words of a text in lower case stand that no table has, as characters [start, end)."""
    told = _chinese(text) if language == "zh" else _spaced(text, language)
    return [
        (one.start, one.end)
        for one in told
        if not one.kind and one.text.isalpha() and (len(one.text) > 2 or language == "zh")
    ]


def _capitals(text: str, origin: Sequence[int], request: str) -> frozenset[int]:
    """Where words of a text begin with a capital letter within a sentence: nouns, in German."""
    found: set[int] = set()
    before = "."
    for m in _WORD.finditer(text):
        if before not in (".", "!", "?") and request[origin[m.start()]].isupper():
            found.add(m.start())
        before = m[0]
    return frozenset(found)


def _spaced(text: str, language: str, names: frozenset[int] = frozenset()) -> list[Told]:
    """The words of a language that sets them apart, the longest known phrases first; those at ``names`` are nouns."""
    found = list(_WORD.finditer(text))
    table, told, at = tables(language), list[Told](), 0
    while at < len(found):
        for many in range(min(LONGEST, len(found) - at), 0, -1):
            start, end = found[at].start(), found[at + many - 1].end()
            phrase = re.sub(r"\s+", " ", text[start:end]).replace("’", "'")
            known = table.phrases.get(phrase) or (_inflected(phrase, table) if many == 1 else _plural(phrase, table))
            if many == 1 and start in names and known is not None and known[1] == "words":
                known = _inflected(phrase, table) or known  # "die Liegen" are things, "sie liegen" is none
            if known is None and many == 1 and language == "de":
                known = _compound(phrase, table) or _diminutive(phrase, table)
            if known is not None:
                told.append(Told(known[0], known[1], start, end))
                at += many
                break
        else:
            told.append(Told(text[found[at].start() : found[at].end()], "", found[at].start(), found[at].end()))
            at += 1
    return told


def _inflected(word: str, table: Tables) -> tuple[str, str] | None:
    """A word with an ending: a noun in the plural, or another word as it is."""
    for ending in table.endings:
        if not word.endswith(ending) or len(word) - len(ending) < 3:
            continue
        stem = word[: -len(ending)]
        for form in (stem, _plain(stem), f"{stem}e"):
            known = table.phrases.get(form)
            if known is not None and known[1] != "words":
                return (plural(known[0]), "nouns") if known[1] == "nouns" else known
    return None


def _plain(stem: str) -> str:
    """A stem of German without its last umlaut, as it is before an ending."""
    last = max(map(stem.rfind, "äöü"))
    return stem[:last] + stem[last:].translate(_UMLAUTS) if last >= 0 else stem


def _plural(phrase: str, table: Tables) -> tuple[str, str] | None:
    """A phrase whose first word is in the plural, or all whose words are."""
    first, *others = phrase.split()
    for form in (
        " ".join([first.removesuffix("s"), *others]),
        " ".join(word.removesuffix("s") for word in phrase.split()),
    ):
        known = table.phrases.get(form)
        if form != phrase and known is not None and known[1] == "nouns":
            return plural(known[0]), "nouns"
    return None


def _compound(word: str, table: Tables) -> tuple[str, str] | None:
    """Two nouns in one word, the second of which is the thing; a long word by that one where the first is not known."""
    last: tuple[str, str] | None = None
    for cut in range(3, len(word) - 2):
        head = table.phrases.get(word[cut:]) or _inflected(word[cut:], table)
        if head is None or head[1] != "nouns":
            continue
        if word[:cut] in table.prefixes:
            return None  # "Durchmesser" is no knife
        if last is None and min(cut, len(word) - cut) >= SHORTEST_HEAD:
            last = head
        for first in (word[:cut], word[:cut].rstrip("s"), word[:cut].removesuffix("en"), word[:cut].removesuffix("n")):
            known = table.phrases.get(first)
            if known is not None and known[1] in ("nouns", "adjectives"):
                return f"{known[0]} {head[0]}", "nouns"
    return last


def _diminutive(word: str, table: Tables) -> tuple[str, str] | None:
    """A small one of a noun, of German: "Schränkchen"."""
    for ending in ("chen", "lein"):
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < 3:
            continue
        for form in (stem, _plain(stem), f"{stem}e", f"{_plain(stem)}e"):
            known = table.phrases.get(form) or _compound(form, table)
            if known is not None and known[1] == "nouns":
                return f"small {known[0]}", "nouns"
    return None


def _adjectives_first(told: Sequence[Told]) -> list[Told]:
    """Adjectives that follow their noun go before it."""
    found: list[Told] = []
    for one in told:
        at = len(found)
        while one.kind == "adjectives" and at and found[at - 1].kind == "nouns":
            at -= 1
        found.insert(at, one)
    return found


def _chinese(text: str) -> list[Told]:
    """The longest known phrases of a text without blanks; other scripts stay as they are."""
    table, told, at = tables("zh"), list[Told](), 0
    longest = max(map(len, table.phrases))
    while at < len(text):
        for many in range(min(longest, len(text) - at), 0, -1):
            known = table.phrases.get(text[at : at + many])
            if known is not None:
                told.append(Told(known[0], known[1], at, at + many))
                at += many
                break
        else:
            if told and told[-1].kind == "numbers" and text[at] in table.measures:
                at += 1
                continue
            if match := re.match(r"[^\W\d_\u4e00-\u9fff]+|\d+(?:[.,]\d+)?", text[at:]):
                told.append(Told(match[0], "numbers" if match[0][0].isdigit() else "", at, at + len(match[0])))
                at += len(match[0])
                continue
            if not text[at].isspace():
                sign = {"，": ",", "。": ".", "、": ",", "；": ";"}.get(text[at], text[at])
                told.append(Told(sign, "", at, at + 1))
            at += 1
    return told


def _postposed(told: Sequence[Told]) -> list[Told]:
    """Words of place that follow their noun go before it: "bed beside" is "beside bed"."""
    found: list[Told] = []
    for one in told:
        at = len(found)
        if one.kind == "postpositions":
            while at and found[at - 1].kind in ("nouns", "adjectives", "numbers"):
                at -= 1
        if one.kind == "nouns" and found and found[-1].kind == "numbers" and found[-1].text not in ("a", "one", "1"):
            one = one._replace(text=plural(one.text))
        found.insert(at, one)
    return found


__all__ = ["LANGUAGES", "NAMES", "language_of", "translated", "unknown_words"]
