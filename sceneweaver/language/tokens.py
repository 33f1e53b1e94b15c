"""A request as tokens: the longest known phrase at each place with everything that it can mean, and where it stood."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from sceneweaver.knowledge.learned import learned_words

from .source import Source, metres
from .spelling import mended
from .vocabulary import LONGEST, NUMBERS, Place, Verb, vocabulary, words

_FORMAT = rf"(?:{words('quantities')['formats']}|\d{{1,5}}(?:{'|'.join(words('quantities')['glued'])}))(?![a-z0-9])"
_WORD = re.compile(
    rf"§|[23]d(?![a-z])|(?<![a-z0-9]){_FORMAT}|"
    r"\d+(?:[.,]\d+)?|[a-z][a-z'&/]*|[^\W\d_]+|[.,()&\"{}\[\]<>\\/=]"
)
_LIST = re.compile(r"[a-z]+(?:/[a-z]+){2,}")
_UNIT = re.compile(r"^(meters?|metres?|m|cm|centimeters?|centimetres?|ft|feet|foot|yards?|yds?|inch(?:es)?|in)$")
_MEASURES = re.compile(
    r"^(mm|milli(?:meter|metre)s?|lit(?:er|re)s?|l|ml|kg|(?:kilo)?grams?|lbs?|pounds?|oz|ounces?|gallons?|watts?|kw|"
    r"volts?|megapixels?|gb|tb|k?hz|quarts?|piece)$"
)
"""What a number before it says of the thing that follows, rather than how many there are: "a 35 mm camera"."""

_ADJECTIVE = re.compile(
    r".{3,}(?:ed|ish|ful|less|ous|ive|able|ible|ic|ical|ent|ant|ary|style|shaped|inspired|themed|like|colored|coloured|sized)$"
)
_NAME_ENDS = frozenset(
    ("preposition", "and", "with", "while", "neg", "det", "pron", "modal", "place_adverb", "stop", "verb")
)
"""Kinds of words that end the name of a thing."""

_ONE = ("a", "an", "another", "the", "one")
"""Words before a number that counts the parts of one thing: "a four drawer cabinet"."""

_SINGULAR = ("a", "an", "one", "single", "this", "each", "every", "another", "1")


@dataclass
class Token:
    """One phrase at characters [start, end) of the source; ``kinds`` maps what it can be to its value."""

    text: str
    start: int
    end: int
    kinds: dict[str, Any] = field(default_factory=dict)

    def has(self, *kinds: str) -> bool:
        """Whether it can be one of these."""
        return not self.kinds.keys().isdisjoint(kinds)

    def get(self, kind: str) -> Any:
        """What it means as one of a kind; None when it cannot be that."""
        return self.kinds.get(kind)


@dataclass
class _Raw:
    text: str
    start: int
    end: int
    glued: bool = False  # whether a hyphen joins it to the next


def tokens(source: Source, notes: list[str]) -> list[Token]:
    """The tokens of a source; corrected spellings are noted."""
    learned = learned_words()
    raw = list(_mended(_raw(source.text), source, notes, learned))
    found: list[Token] = []
    at = 0
    while at < len(raw):
        word = raw[at]
        if word.text == "§":
            found.append(Token("sides", word.start, word.end, {"sides": source.sides.get(word.start, (1.0, 1.0))}))
            at += 1
        elif word.text in ".,()":
            found.append(Token(word.text, word.start, word.end, {"break": word.text}))
            at += 1
        elif not word.text[0].isalnum() and word.text != "&":
            at += 1
        elif (end := _spec_end(raw, at)) is not None:
            text = _joined(raw, at, end)
            found.append(Token(text, word.start, raw[end - 1].end, {"adjective": text}))
            at = end
        else:
            token, at = _number(raw, at) if _is_figure(word.text) else _phrase(raw, at, notes, learned)
            found.append(token)
    return list(_measured_places(list(_either(list(_tens(_cut(found)))))))


def _raw(text: str) -> list[_Raw]:
    found = [_Raw(m[0], m.start(), m.end()) for m in _WORD.finditer(_LIST.sub(_listed, text))]
    for one, two in zip(found, found[1:], strict=False):
        between = text[one.end : two.start]
        one.glued = between in ("-", "_") and one.text[0].isalnum() and two.text[0].isalnum()
    return found


def _mended(raw: list[_Raw], source: Source, notes: list[str], learned: Mapping[str, str]) -> Iterator[_Raw]:
    """The words without slips of the pen; what was meant as two is two."""
    named = {word for phrase in learned for word in phrase.split()}
    glued = False
    for word in raw:
        known = None if glued or word.glued or word.text in named else mended(word.text, notes)
        glued = word.glued
        if known is None:
            yield word
            continue
        source.slips[word.text] = known
        for part in known.split():
            yield _Raw(part, word.start, word.end)


def _listed(m: re.Match[str]) -> str:
    """ "Sofa/bed/desk": a list, where all of it are nouns that are known."""
    table = vocabulary()
    return m[0].replace("/", ",") if all("noun" in table.get(word, {}) for word in m[0].split("/")) else m[0]


def _joined(raw: list[_Raw], start: int, end: int) -> str:
    return " ".join(word.text for word in raw[start:end])


def _number(raw: list[_Raw], at: int) -> tuple[Token, int]:
    """A number: a count, a range of counts, or a length with its unit."""
    word = raw[at]
    after = [w.text for w in raw[at + 1 : at + 3]]
    low_high = None
    if word.text.isdigit() and len(word.text) < 6:
        if len(after) == 2 and after[0] in ("to", "or") and after[1].isdigit():
            low_high = at + 2
        elif word.glued and after[0].isdigit():
            low_high = at + 1
    if low_high is not None:
        low, high = sorted((int(word.text), int(raw[low_high].text[:5])))
        kinds: dict[str, Any] = {"amount": (low, high)}
        return Token(f"{word.text} to {raw[low_high].text}", word.start, raw[low_high].end, kinds), low_high + 1
    if (
        after
        and after[0] in ("x", "×")
        and len(after) == 2
        and after[1].isalpha()
        and "number" not in vocabulary().get(after[1], {})
    ):
        return Token(
            f"{word.text} x", word.start, raw[at + 1].end, {"number": int(float(word.text.replace(",", ".")))}
        ), at + 2
    place = after[:1] == ["in"] and after[1:] and after[1] in ("the", "a", "an", "each", "every", "total")
    if after and _UNIT.match(after[0]) and not place:
        length = metres(word.text, after[0])
        return Token(f"{word.text} {after[0]}", word.start, raw[at + 1].end, {"length": length}), at + 2
    if after and _MEASURES.match(after[0]):
        text = f"{word.text} {after[0]}"
        return Token(text, word.start, raw[at + 1].end, {"adjective": text}), at + 2
    if word.glued:  # "4-burner stove"
        return _compound(raw, at)
    kinds = {"number": int(word.text)} if word.text.isdigit() else {}
    return Token(word.text, word.start, word.end, kinds), at + 1


def _phrase(raw: list[_Raw], at: int, notes: list[str], learned: Mapping[str, str]) -> tuple[Token, int]:
    """The longest known phrase, which ends in the middle of a compound with hyphens only where a number does.

    ``learned`` are names of rooms that the user has learned: known where the vocabulary does not know them.
    """
    table = vocabulary()
    for length in range(min(LONGEST, len(raw) - at), 0, -1):
        end = at + length
        phrase = _joined(raw, at, end)
        if phrase in learned and phrase not in table:
            return Token(phrase, raw[at].start, raw[end - 1].end, {"room": learned[phrase]}), end
        if phrase not in table or (length > 1 and "place_adverb" in table[phrase] and _noun_begins(raw, end - 1)):
            continue
        if length > 1 and raw[end - 1].text == "seats" and end < len(raw) and _is_number(raw[end].text):
            continue  # "a table seats eight"
        if length > 1 and raw[at].text in ("a", "in") and "noun" in table[phrase] and not raw[at].glued:
            continue  # "a board" is no "A-board", "bulbs in trays" are in no "in-tray"
        if raw[end - 1].glued and not (length == 1 and phrase in NUMBERS and _tens_follow(raw, end)):
            continue
        return Token(phrase, raw[at].start, raw[end - 1].end, dict(table[phrase])), end
    if raw[at].glued:
        return _compound(raw, at)
    kinds = {"adverbs": raw[at].text} if _is_adverb(raw[at].text) else {}
    return Token(raw[at].text, raw[at].start, raw[at].end, kinds), at + 1


@cache
def _format() -> re.Pattern[str]:
    return re.compile(_FORMAT)


def _spec_end(raw: list[_Raw], at: int) -> int | None:
    """Where words end that say by a number what a thing is like, and not how many there are; None where they do not.

    A format or a number with its unit ("an A0 plan", "a 12v fridge"), a number by name ("size 12"), and how many parts
    the one thing behind has ("a 2 burner hob"): a part in the singular, behind a number of more than one.
    """
    data, word = words("quantities"), raw[at]
    after = raw[at + 1] if at + 1 < len(raw) else None
    if _format().fullmatch(word.text):
        return at + 1
    if after is None:
        return None
    if word.text in data["named"]:
        return at + 2 if after.text.isdigit() or (after.text in NUMBERS and not _tens_follow(raw, at + 2)) else None
    if word.glued or not _is_number(word.text) or word.text in ("1", "one") or after.text not in data["parts_of"]:
        return None
    if _joined(raw, at, at + 2) in vocabulary():
        return None
    sure = after.text in data["always_parts"] or (at > 0 and raw[at - 1].text in _ONE)
    return at + 2 if _is_part_of_one(raw, at + 1, sure) else None


def _is_part_of_one(raw: list[_Raw], at: int, sure: bool) -> bool:
    """Whether the name of one thing follows a word, which, unless it is ``sure`` to be a part, is no part of that name
    itself: no "plate rack"."""
    table = vocabulary()
    for end in () if sure else (at + 2, at + 3):
        if table.get(_joined(raw, at, end), {}).keys() & {"noun", "place", "group"}:
            return False
    ahead: list[str] = []
    for word in raw[at + 1 : at + 4]:
        kinds = table.get(word.text, {})
        if not word.text.isalpha() or kinds.keys() & _NAME_ENDS and "noun" not in kinds:
            break
        ahead.append(word.text)
    return bool(ahead) and "plural" not in table.get(ahead[-1], {}) and any("noun" in table.get(w, {}) for w in ahead)


def _is_figure(word: str) -> bool:
    """Whether a word is written in digits; "3d" is none: what it begins is a name."""
    return word[0].isdigit() and not word[-1].isalpha()


def _is_number(word: str) -> bool:
    return word.isdigit() or word in NUMBERS


def _is_adverb(word: str) -> bool:
    """Whether a word that is not known has the ending of an adverb: it belongs to no name of a thing."""
    return len(word) > 5 and word.endswith("ly") and not word.endswith(tuple(words("nothings")["nouns_in_ly"]))


def _noun_begins(raw: list[_Raw], at: int) -> bool:
    """Whether a longer noun begins with a word: "on the side table" is no "on the side"."""
    table = vocabulary()
    for end in range(at + 2, min(at + 4, len(raw)) + 1):
        if table.get(_joined(raw, at, end), {}).keys() & {"noun", "place", "region"}:
            return True
    return False


def _tens_follow(raw: list[_Raw], end: int) -> bool:
    return end < len(raw) and raw[end].text in NUMBERS


def _compound(raw: list[_Raw], at: int) -> tuple[Token, int]:
    """Words with hyphens that are no known phrase together: said of the noun after them, or a noun of two words."""
    end = at
    while end < len(raw) - 1 and raw[end].glued and end - at < 6:
        end += 1
    end += 1
    table, phrase = vocabulary(), _joined(raw, at, end)
    if phrase in table:
        kinds = dict(table[phrase])
    elif table.get(raw[end - 1].text, {}).get("noun") and len(raw[at].text) > 1 and _noun_ends(raw, end):
        kinds = {"noun": table[raw[end - 1].text]["noun"]}
    else:
        kinds = {"adjective": phrase}
    return Token(phrase, raw[at].start, raw[end - 1].end, kinds), end


def _noun_ends(raw: list[_Raw], end: int) -> bool:
    """Whether no noun follows, so that a compound is one itself: "a side-table by the window"."""
    after = vocabulary().get(raw[end].text, {}) if end < len(raw) and raw[end].text.isalpha() else {"break": 1}
    return any(kind in after for kind in ("break", "preposition", "and", "with", "verb", "while", "place_adverb"))


def looks_adjective(word: str) -> bool:
    """Whether a word that is not known has the ending of an adjective."""
    return bool(_ADJECTIVE.match(word))


def _cut(found: list[Token]) -> Iterator[Token]:
    """ "A tall plant stands": after a singular article no plural follows, so that its end is a verb."""
    table = vocabulary()
    for index, token in enumerate(found):
        head, _, last = token.text.rpartition(" ")
        after = found[index + 1] if index + 1 < len(found) else None
        longer = f"{last} {after.text}" if after is not None else ""
        if head in table and longer in table and "noun" in table[longer] and token.has("noun") and after is not None:
            found[index + 1] = Token(longer, token.end - len(last), after.end, dict(table[longer]))
            yield Token(head, token.start, token.end - len(last) - 1, dict(table[head]))  # "glass pendant lights"
            continue
        verb = table.get(last, {}).get("verb")
        if head in table and "noun" in table[head] and isinstance(verb, Verb) and token.has("plural"):
            before = [t.text for t in found[max(0, index - 6) : index]]
            while before and not (before[-1] in _SINGULAR or before[-1] in (".", ",", "and", "with", "the", *NUMBERS)):
                before.pop()
            if before and before[-1] in _SINGULAR:
                yield Token(head, token.start, token.end - len(last) - 1, dict(table[head]))
                yield Token(last, token.end - len(last), token.end, dict(table[last]))
                continue
        yield token


def _either(found: list[Token]) -> Iterator[Token]:
    """ "One or two" and "three to five" are a number between them."""
    at = 0
    while at < len(found):
        token, end = found[at], at + 3
        if token.has("number") and end <= len(found) and found[at + 1].text in ("or", "to", "-"):
            low, high = token.get("number"), found[at + 2].get("number")
            if isinstance(low, int) and isinstance(high, int) and 0 < low < high <= max(12, 2 * low):
                text = f"{token.text} {found[at + 1].text} {found[at + 2].text}"
                yield Token(text, token.start, found[at + 2].end, {"amount": (low, high)})
                at = end
                continue
        yield token
        at += 1


def _measured_places(found: list[Token]) -> Iterator[Token]:
    """ "At least 2 m from the door", "within a metre of it": a word of place with its distance."""
    data = words("quantities")
    at = 0
    while at < len(found):
        token = found[at]
        first = at + (token.has("bound") or token.text in data["within"])
        length, off, to = (found[k] if k < len(found) else None for k in (first, first + 1, first + 2))
        within = token.text in data["within"]
        if (
            length is None or off is None or to is None or not length.has("length")
            or to.has("break", "verb", "and", "with", "while", "adverbs")
            or (off.text != "of" if within else off.text not in data["apart"])
        ):  # fmt: skip
            yield token
            at += 1
            continue
        bound = "most" if within else token.get("bound") if first > at else None
        low, high = _reach(length.get("length"), bound)
        place = Place("far_from" if high is None else "near", gap=(low, high))
        words_ = " ".join(t.text for t in found[at : first + 2])
        yield Token(words_, token.start, off.end, {"preposition": replace(place, words=words_)})
        at = first + 2


NEARER, FARTHER = 0.1, 0.25
"""Shares by which a distance may be less, and more, than one that is told without a bound."""


def _reach(length: float, bound: str | None) -> tuple[float | None, float | None]:
    """Least and largest distance [m] of a length with a bound."""
    if bound in ("least", "above"):
        return length, None
    if bound in ("most", "below"):
        return None, length
    share = 2.0 if bound == "about" else 1.0
    return round(length * (1 - share * NEARER), 3), round(length * (1 + share * FARTHER), 3)


_SCORES = (100, 1000, 1_000_000, 1_000_000_000)


def _tens(found: Iterator[Token]) -> Iterator[Token]:
    """ "twenty five" is 25, "two hundred" 200."""
    last: Token | None = None
    for token in found:
        one, two = last.get("number") if last else None, token.get("number")
        if last is not None and isinstance(one, int) and isinstance(two, int) and {last.text, token.text} <= {*NUMBERS}:
            value = one + two if one >= 20 and one % 10 == 0 and 0 < two < 10 else None
            value = one * two if two in _SCORES and 0 < one < 100 else value
            if value is not None:
                last = Token(f"{last.text} {token.text}", last.start, token.end, {"number": value})
                continue
        if last is not None:
            yield last
        last = token
    if last is not None:
        yield last
