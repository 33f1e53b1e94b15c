"""Requests in German, Spanish, French and Chinese, put into the English that the reader knows.

The words are data (``lexicon/translations``); their forms and their order are told by rules (`word_forms`, `numerals`,
`word_order`). Each English character keeps the place of the word that it stands for, so that all that is read still
points into the request as it was written. A word that is not in the tables becomes one that no English word is like
(``UNKNOWN``): it is told as not understood.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from sceneweaver.assets.taxonomy import phrases as names_of_things

from .numerals import decades, numerals
from .vocabulary import vocabulary, words
from .word_forms import Entry, Tables, german, inflected, keys, romance, several
from .word_order import Told, chinese_order, german_order, romance_order

LANGUAGES = ("de", "es", "fr", "zh")

NAMES = {"de": "German", "es": "Spanish", "fr": "French", "zh": "Chinese"}

LONGEST = 6
"""Words of the longest phrase in the tables."""

UNKNOWN = "ǀ"
"""The letter that a word of no table begins with, so that it is never read as an English one."""

_KINDS = ("nouns", "adjectives", "numbers", "words", "postpositions")
_LISTS = ("particles", "relatives", "modals", "infinitives", "finals", "of", "by", "made_of", "genitives")
_WORD = re.compile(
    r"['’]s(?!\w)|(?:[ldjnscmt]|qu|lorsqu|jusqu)['’](?=\w)|(?:[cdm]?m[23]|[23]d)(?!\w)|[^\W\d_]+(?:-[^\W\d_]+)*|\d+(?:[.,]\d+)?|\S",
    re.UNICODE,
)
_CHINESE = re.compile(r"[\u4e00-\u9fff]")
_ENGLISH = frozenset(["the", "and", "with", "of", "for", "on", "in", "at", "to", "by", "is", "are", "room"])
_UNITS = frozenset(["m", "cm", "mm", "m2", "km", "kg", "x", "×"])
_SIGNS = {"，": ",", "。": ".", "、": ",", "；": ";", "¿": "", "¡": "", "«": '"', "»": '"'}
_BY_PLACE = ("wall", "desk", "potted", "upright")
"""First words of categories that requests hardly say."""

_METRES = re.compile(r"([一二两三四五六七八九十\d]+)米([一二三四五六七八九半])(?![米百十平个张把])")
"""A length of metres and tenths: "一米八"."""

_DIGITS = dict(zip("一二三四五六七八九半", "1234567895", strict=True))


@cache
def tables(language: str) -> Tables:
    """The words of a language, kinds of rooms and names of things in it among them."""
    from sceneweaver.knowledge.load import room_types

    data: Mapping[str, Any] = words(f"translations/{language}")
    found: dict[str, Entry] = {}
    rooms: dict[str, str] = {}
    for room in room_types():
        for name in room_types().names_of(room, language):
            found[name.lower()] = (room.replace("_", " "), "nouns")
            rooms[name.lower()] = room.replace("_", " ")
    for category, names in words(f"translations/{language}_things").items():
        found |= {name: (english_of(category), "nouns") for name in names.split(", ")}
    for kind in _KINDS:
        found |= {phrase: (english, kind) for phrase, english in (data.get(kind) or {}).items()}
    found |= {name: (str(n), "numbers") for name, n in numerals(language).items() if n > 2 or name not in found}
    found |= {name: (f"{decade}s", "words") for name, decade in decades(language).items()}
    found |= _contracted(found, language)
    rooms |= data.get("rooms") or {}
    rules = {name: frozenset(data.get(name, ())) for name in _LISTS}
    return Tables(
        found,
        tuple(data.get("endings", ())),
        frozenset(data.get("measures", ())),
        frozenset(data.get("prefixes", ())),
        rules,
        rooms,
        data.get("senses") or {},
        *keys(found, language),
    )


@cache
def english_of(category: str) -> str:
    """A name that is read as a category: its own, or the first that is, without words of place in it."""
    own = category.replace("_", " ")
    first, _, rest = own.partition(" ")
    if first in _BY_PLACE and names_of_things().get(rest) == category:
        return rest  # so that "round mirror" is still one of its own
    meant = _names_by_category().get(category, [])
    plain = [name for name in meant if not {"on", "with", "in", "of"} & set(name.split())]
    return own if own in plain else (plain or meant or [own])[0]


@cache
def _names_by_category() -> dict[str, list[str]]:
    """The names of things, turned around: once, as a language has more than a thousand categories to look up."""
    found: dict[str, list[str]] = {}
    for name, category in names_of_things().items():
        found.setdefault(category, []).append(name)
    return found


def _contracted(phrases: Mapping[str, Entry], language: str) -> dict[str, Entry]:
    """Phrases whose last word is one with the article after it: "près de" and "près du"."""
    joined = {
        "es": {"de": {"del": " the"}, "a": {"al": " the"}},
        "fr": {"de": {"du": " the", "des": " the", "d'": ""}, "à": {"au": " the", "aux": " the"}},
    }
    found: dict[str, Entry] = {}
    for phrase, (english, kind) in phrases.items():
        head, _, last = phrase.rpartition(" ")
        for form, the in joined.get(language, {}).get(last, {}).items():
            if head and kind == "words" and f"{head} {form}" not in phrases:
                found[f"{head} {form}"] = (english + the if english else "", kind)
    return found


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


def translated(
    text: str, origin: Sequence[int], language: str, request: str, table: Tables | None = None
) -> tuple[str, list[int]]:
    """A text in lower case as English, with the place of each of its characters in the request.

    ``table``: the words of the language; `tables` where it is not given.
    """
    table = table or tables(language)
    names, small = _capitals(text, origin, request) if language == "de" else (frozenset[int](), frozenset[int]())
    told = _told(text, language, table, names, small)
    if names:  # an unknown word in small letters is none for a thing
        told = [one for one in told if one.kind or one.start not in small]
    order = {"de": german_order, "es": romance_order, "fr": romance_order, "zh": chinese_order}[language]
    letters: list[str] = []
    places: list[int] = []
    for one in order(told, table):
        if not one.text or (not letters and not one.text[0].isalnum()):
            continue
        english = one.text if one.kind else _unknown(one.text)
        if letters and not (len(english) == 1 and english in ",.;:!?"):
            letters.append(" ")
            places.append(origin[one.start])
        step = (one.end - one.start - 1) / max(1, len(english) - 1)
        letters += english
        places += [origin[one.start + round(k * step)] for k in range(len(english))]
    return "".join(letters), places


def unknown_words(text: str, language: str) -> list[tuple[int, int]]:
    """Where words of a text in lower case stand that no table has, as characters [start, end)."""
    return [
        (one.start, one.end)
        for one in _told(text, language, tables(language))
        if not one.kind and one.text.isalpha() and (len(one.text) > 2 or language == "zh")
    ]


def content_words(text: str, language: str) -> list[tuple[str, int, int]]:
    """Nouns and adjectives of a text in lower case: English, and the characters [start, end) that it stands for."""
    return [
        (one.text, one.start, one.end)
        for one in _told(text, language, tables(language))
        if one.kind in ("nouns", "adjectives") and one.text
    ]


def _told(
    text: str, language: str, table: Tables, names: frozenset[int] = frozenset(), small: frozenset[int] = frozenset()
) -> list[Told]:
    return _chinese(text, table) if language == "zh" else _spaced(text, language, table, names, small)


def _unknown(word: str) -> str:
    """A word of no table as one that is like no English word; a sign stays."""
    return UNKNOWN + re.sub(r"[\W\d_]", "", word) if word[0].isalpha() else word


def _capitals(text: str, origin: Sequence[int], request: str) -> tuple[frozenset[int], frozenset[int]]:
    """Where words of a text begin with a capital letter within a sentence (nouns, in German), and where with a small
    one."""
    found: set[int] = set()
    small: set[int] = set()
    before = "."
    for m in _WORD.finditer(text):
        if request[origin[m.start()]].islower():
            small.add(m.start())
        elif before not in (".", "!", "?", ":") and request[origin[m.start()]].isupper():
            found.add(m.start())
        before = m[0]
    return frozenset(found), frozenset(small)


def _spaced(text: str, language: str, table: Tables, names: frozenset[int], small: frozenset[int]) -> list[Told]:
    """The words of a language that sets them apart, the longest known phrases first; those at ``names`` are nouns, and
    those at ``small`` none."""
    found = list(_WORD.finditer(text))
    told, at = list[Told](), 0
    first = True
    while at < len(found):
        for many in range(min(LONGEST, len(found) - at), 0, -1):
            start, end = found[at].start(), found[at + many - 1].end()
            phrase = re.sub(r"\s+", " ", text[start:end]).replace("’", "'")
            known = _known(phrase, many, table, language)
            if many == 1 and start in names and known is not None and known[1] in ("words", "adjectives"):
                known = inflected(phrase, table, ("nouns",)) or known  # "die Liegen" are things, "sie liegen" is none
            if names and known is not None and start in small and known[1] == "nouns" and phrase not in table.phrases:
                known = inflected(phrase, table, ("adjectives",))  # "unterfahrbar" is no bar
            if known is not None:
                if known[1] == "nouns":
                    known = _sense(phrase, known, text, table)
                    # what a request begins with is the room: "bureau", "Bibliothek"
                    known = (table.rooms.get(phrase, known[0]), "nouns") if first else known
                    first = first and not vocabulary().get(known[0], {}).keys() & {"noun", "room"}
                told.append(Told(known[0], known[1], start, end, phrase))
                at += many
                break
        else:
            word = found[at][0]
            kind = "numbers" if word[0].isdigit() and word not in _UNITS else "words" if word in _UNITS else ""
            told.append(Told(_SIGNS.get(word, word), kind, found[at].start(), found[at].end(), word))
            at += 1
    return told


def _sense(phrase: str, known: Entry, text: str, table: Tables) -> Entry:
    """What a noun of several meanings means beside other words of the text: "barra" of a bakery is a loaf."""
    for name, meanings in table.senses.items():
        if phrase.startswith(name):
            for english, cues in meanings.items():
                if any(re.search(rf"\b{cue}", text) for cue in cues):
                    return (english if phrase == name else several(english)), "nouns"
    return known


def _known(phrase: str, many: int, table: Tables, language: str) -> Entry | None:
    """What a phrase of so many words means."""
    if phrase in table.phrases:
        return table.phrases[phrase]
    if not phrase[0].isalpha() or phrase in _UNITS:
        return None
    if language == "de":
        return german(phrase, table) if many == 1 else None
    known = romance(phrase, table, language)
    if known is None and "-" in phrase and many == 1:  # "librairie-café": the thing comes first
        return romance(phrase.partition("-")[0], table, language)
    return known


def _chinese(text: str, table: Tables) -> list[Told]:
    """A text without blanks in known phrases, so that the fewest characters are left over; other scripts stay."""
    told = list[Told]()
    at = 0
    while at < len(text):
        tenths = _METRES.match(text, at)
        other = re.compile(r"[^\W\d_\u4e00-\u9fff]+|\d+(?:[.,]\d+)?").match(text, at)
        if tenths is not None:
            whole = tenths[1] if tenths[1].isdigit() else str(numerals("zh").get(tenths[1], 1))
            told.append(Told(f"{whole}.{_DIGITS[tenths[2]]} m", "words", at, tenths.end(), tenths[0]))
            at = tenths.end()
        elif other is not None:
            kind = "numbers" if other[0][0].isdigit() else "words" if other[0] in _UNITS else ""
            known = table.phrases.get(other[0])
            told.append(Told(*(known or (other[0], kind)), at, other.end(), other[0]))
            at = other.end()
        elif _CHINESE.match(text, at):
            end = at
            while end < len(text) and _CHINESE.match(text, end) and (end == at or not _METRES.match(text, end)):
                end += 1
            told += _segments(text, at, end, table)
            at = end
        else:
            if not text[at].isspace():
                told.append(Told(_SIGNS.get(text[at], text[at]), "", at, at + 1, text[at]))
            at += 1
    return [one for k, one in enumerate(told) if not (one.kind == "measures" and not _counts(told, k))]


def _counts(told: Sequence[Told], at: int) -> bool:
    """Whether what stands before a measure word is no number, so that it is none."""
    return not at or told[at - 1].kind not in ("numbers", "measures")


@cache
def _longest(language: str) -> int:
    return max(map(len, tables(language).phrases))


def _segments(text: str, start: int, end: int, table: Tables) -> list[Told]:
    """Characters [start, end) in known phrases: fewest characters unknown, then fewest phrases, the first the longest.

    Time grows with the number of characters times those of the longest phrase.
    """
    best: list[tuple[int, int, int]] = [(0, 0, end)] * (end - start + 1)  # unknown, phrases, end of the first
    for at in range(end - 1, start - 1, -1):
        options: list[tuple[int, int, int]] = []
        for after in range(min(end, at + _longest("zh")), at, -1):
            piece = text[at:after]
            rest = best[after - start]
            if piece in table.phrases:
                options.append((rest[0], rest[1] + 1, after))
            elif after == at + 1:
                options.append((rest[0] + (piece not in table.measures), rest[1] + 1, after))
        best[at - start] = min(options, key=lambda option: option[:2])
    told: list[Told] = []
    at = start
    while at < end:
        after = best[at - start][2]
        piece = text[at:after]
        known = table.phrases.get(piece)
        counted = bool(told) and told[-1].kind == "numbers" and piece in table.measures
        if counted:
            told.append(Told("", "measures", at, after, piece))
        elif known is not None:
            told.append(Told(*known, at, after, piece))
        elif told and not told[-1].kind and told[-1].end == at:
            told[-1] = told[-1]._replace(text=told[-1].text + piece, end=after, source=told[-1].source + piece)
        else:
            told.append(Told(piece, "", at, after, piece))
        at = after
    return told


__all__ = [
    "LANGUAGES",
    "NAMES",
    "UNKNOWN",
    "content_words",
    "english_of",
    "language_of",
    "tables",
    "translated",
    "unknown_words",
]
