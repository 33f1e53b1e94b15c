"""Forms of words in German, Spanish and French by rule: plurals, gender, cases, accents left out, compounds.

A table of words has each word once. What a request has of it is found by keys, which a word and its forms share, or by
taking endings off.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from .vocabulary import plural

Entry = tuple[str, str]
"""English and the kind of a word: nouns, adjectives, numbers, words, postpositions."""

SHORTEST_HEAD, SHORTEST_UNKNOWN = 5, 4
"""Letters of the last part of a compound, of whose first part nothing is known, and of that part."""

SHORTEST_FIRST = 3
"""Letters of the first part of a compound: "Eingang" has nothing of an egg."""

_UMLAUTS = str.maketrans("äöü", "aou")
_SPELT_OUT = (("ae", "ä"), ("oe", "ö"), ("ue", "ü"), ("ss", "ß"))
_LINKS = ("s", "es", "en", "n", "er", "ens")
"""What joins the parts of a German compound."""

_CUT_OFF = ("e", "en")
"""What a noun loses at the end of the first part: "Schulbank", "Kirchturm"."""

_TONES = {"hell": "light", "dunkel": "dark", "tief": "dark", "blass": "pale", "zart": "pale", "knall": "bright"}
_SPANISH_SMALL = ("ecito", "ecita", "cito", "cita", "ito", "ita")


@dataclass(frozen=True)
class Tables:
    """The words of a language.

    Attributes:
        phrases: phrase to English and kind.
        endings: of inflected words.
        measures: words between count and noun.
        prefixes: beginnings of words that make no compound of two nouns.
        rules: other lists of words that the order of words is told by.
        rooms: kinds of rooms whose names are those of things as well.
        senses: nouns of several meanings: other meaning, and the beginnings of words beside which it is meant.
        plain: phrases without accents.
        nouns, adjectives: keys of phrases with English and the phrase.
    """

    phrases: Mapping[str, Entry]
    endings: tuple[str, ...] = ()
    measures: frozenset[str] = frozenset()
    prefixes: frozenset[str] = frozenset()
    rules: Mapping[str, frozenset[str]] = field(default_factory=dict[str, frozenset[str]])
    rooms: Mapping[str, str] = field(default_factory=dict[str, str])
    senses: Mapping[str, Mapping[str, list[str]]] = field(default_factory=dict[str, Mapping[str, list[str]]])
    plain: Mapping[str, Entry] = field(default_factory=dict[str, Entry])
    nouns: Mapping[str, tuple[str, str]] = field(default_factory=dict[str, tuple[str, str]])
    adjectives: Mapping[str, str] = field(default_factory=dict[str, str])


def several(english: str) -> str:
    """An English noun in the plural, where it is not in it."""
    if english.endswith("s") and not english.endswith("ss"):
        return english
    return f"{english[:-1]}ves" if english.endswith(("loaf", "leaf")) else plural(english)


def without_accents(text: str) -> str:
    """Letters without their marks."""
    return "".join(c for c in unicodedata.normalize("NFD", text) if not unicodedata.combining(c))


def keys(
    phrases: Mapping[str, Entry], language: str
) -> tuple[dict[str, Entry], dict[str, tuple[str, str]], dict[str, str]]:
    """Phrases without accents, nouns by the key that singular and plural share, adjectives by that of all forms."""
    plain: dict[str, Entry] = {}
    nouns: dict[str, tuple[str, str]] = {}
    adjectives: dict[str, str] = {}
    for phrase, (english, kind) in phrases.items():
        plain.setdefault(without_accents(phrase), (english, kind))
        if kind == "nouns":
            nouns.setdefault(_noun_key(phrase, language), (english, phrase))
        elif kind == "adjectives":
            adjectives.setdefault(_adjective_key(phrase, language), english)
    return plain, nouns, adjectives


def romance(phrase: str, table: Tables, language: str) -> Entry | None:
    """What a phrase of Spanish or French means, in whatever number and gender it stands, accents left out or not."""
    known = table.phrases.get(phrase) or table.plain.get(without_accents(phrase))
    if known is not None:
        return known
    found = table.nouns.get(_noun_key(phrase, language))
    if found is not None:
        english, own = found
        many = phrase.split()[0][-1] in "sx" and own.split()[0][-1] not in "sx"
        return (several(english) if many else english), "nouns"
    adjective = table.adjectives.get(_adjective_key(phrase, language))
    if adjective is not None:
        return adjective, "adjectives"
    return _spanish_small(phrase, table) if language == "es" and " " not in phrase else None


def german(word: str, table: Tables) -> Entry | None:
    """What a German word means, in whatever case it stands, with umlauts spelt out or not."""
    for form in _spellings(word):
        known = table.phrases.get(form) or inflected(form, table)
        if known is not None:
            return known
    for form in _spellings(word):
        known = _tone(form, table) or _compound(form, table) or _diminutive(form, table)
        if known is not None:
            return known
    if "-" in word:
        return german(word.replace("-", ""), table) or german(word.rpartition("-")[2], table)
    return None


def inflected(word: str, table: Tables, kinds: tuple[str, ...] = ("nouns", "adjectives")) -> Entry | None:
    """A German word with an ending, of some kinds: a noun in the plural or genitive, or another word as it is."""
    for ending in table.endings:
        if not word.endswith(ending) or len(word) - len(ending) < 3:
            continue
        stem = word[: -len(ending)]
        if ending in ("sen", "se") and stem[-1] != "s":
            continue
        for form in (stem, _plain(stem), *((f"{stem}e",) if ending in ("r", "m") else ())):
            known = table.phrases.get(form)
            if known is None or known[1] not in kinds:
                continue
            genitive = ending == "es" or (ending == "s" and stem[-1] not in "aeiouy")
            return (known[0] if genitive else several(known[0]), "nouns") if known[1] == "nouns" else known
    return None


def _spellings(word: str) -> Iterator[str]:
    yield word
    for spelt, letter in _SPELT_OUT:
        if spelt in word:
            yield word.replace(spelt, letter)


def _plain(stem: str) -> str:
    """A stem of German without its last umlaut, as it is before an ending."""
    last = max(map(stem.rfind, "äöü"))
    return stem[:last] + stem[last:].translate(_UMLAUTS) if last >= 0 else stem


def _tone(word: str, table: Tables) -> Entry | None:
    """A light or dark colour in one word: "hellgrau"."""
    for before, english in _TONES.items():
        rest = word.removeprefix(before)
        if rest != word and len(rest) > 2:
            known = table.phrases.get(rest) or inflected(rest, table)
            if known is not None and known[1] == "adjectives":
                return f"{english} {known[0]}", "adjectives"
    return None


def _compound(word: str, table: Tables) -> Entry | None:
    """Two nouns or more in one word, the last of which is the thing; a long word by that one where nothing is known of
    the first."""
    last: Entry | None = None
    for cut in range(SHORTEST_FIRST, len(word) - 2):
        head = table.phrases.get(word[cut:]) or inflected(word[cut:], table)
        if head is None or head[1] != "nouns":
            continue
        if word[:cut] in table.prefixes:
            return None  # "Durchmesser" is no knife
        if last is None and cut >= SHORTEST_UNKNOWN and len(word) - cut >= SHORTEST_HEAD:
            last = head
        first = _first(word[:cut], table)
        if first is not None:
            return f"{first} {head[0]}", "nouns"
    return last


def _first(part: str, table: Tables) -> str | None:
    """What the first part of a compound says of the rest."""
    forms = [part, *(part.removesuffix(link) for link in _LINKS), *(part + end for end in _CUT_OFF)]
    forms = sorted(dict.fromkeys(forms), key=len, reverse=True)  # "Buchenholz" is of the beech, not of books
    forms.remove(part)
    forms.insert(0, part)
    for form in forms:
        known = table.phrases.get(form) if len(form) >= SHORTEST_FIRST else None
        if known is not None and known[1] in ("nouns", "adjectives") and known[0]:
            return known[0]
    for form in forms:
        made = _compound(form, table) if len(form) > 2 * SHORTEST_FIRST else None
        if made is not None:
            return made[0]
    return None


def _diminutive(word: str, table: Tables) -> Entry | None:
    """A small one of a noun, of German: "Schränkchen"."""
    for ending in ("chen", "lein", "chens", "leins"):
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < 3:
            continue
        for form in (stem, _plain(stem), f"{stem}e", f"{_plain(stem)}e"):
            known = table.phrases.get(form) or _compound(form, table)
            if known is not None and known[1] == "nouns":
                return f"small {known[0]}", "nouns"
    return None


def _noun_key(phrase: str, language: str) -> str:
    return " ".join(_number_off(word, language) for word in without_accents(phrase).split())


def _number_off(word: str, language: str) -> str:
    """A word without accents as its singular and its plural both give it."""
    if len(word) < 4:
        return word
    if language == "fr":
        if word.endswith("aux") and not word.endswith("eaux"):
            return f"{word[:-3]}al"
        return word[:-1] if word[-1] in "sx" else word
    word = word[:-1] if word[-1] == "s" and word[-2] in "aeiou" else word
    word = word[:-1] if word[-1] == "e" and len(word) > 3 else word
    return f"{word[:-1]}c" if word[-1] == "z" else word


_OF_NOUNS = ("de", "d'", "en", "a", "à", "con", "para")
"""What adjectives begin with that are made of nouns: "de madera"."""

_FEMININE = {
    "aux": "al",
    "euse": "eu",
    "ere": "er",
    "ve": "f",
    "che": "c",
    "gue": "g",
    "lle": "l",
    "nne": "n",
    "tte": "t",
    "sse": "",
    "se": "",
}


def _adjective_key(phrase: str, language: str) -> str:
    if phrase.split()[0] in _OF_NOUNS:
        return _noun_key(phrase, language)
    return " ".join(_gender_off(word, language) for word in without_accents(phrase).split())


def _gender_off(word: str, language: str) -> str:
    """A word without accents as all its forms give it."""
    if len(word) < 3:
        return word
    if language == "fr":
        word = word[:-1] if word[-1] in "sx" and not word.endswith("aux") else word
        for ending, instead in _FEMININE.items():
            if word.endswith(ending) and len(word) - len(ending) >= 2:
                return word[: -len(ending)] + instead
        return word.rstrip("e")
    word = word[:-1] if word[-1] == "s" and word[-2] in "aeo" else word
    return word[:-1] if word[-1] in "aeo" else word


def _spanish_small(word: str, table: Tables) -> Entry | None:
    """A small one of a noun, of Spanish: "mesita"."""
    one = word[:-1] if word.endswith("s") else word
    for ending in _SPANISH_SMALL:
        stem = one.removesuffix(ending)
        if stem == one or len(stem) < 3:
            continue
        for form in (f"{stem}{ending[-1]}", stem, f"{stem}e"):
            found = table.nouns.get(_noun_key(form, "es"))
            if found is not None:
                return f"small {several(found[0]) if one != word else found[0]}", "nouns"
    return None
