"""The order of words in German, Spanish, French and Chinese as English has it, after each word is put into English."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from .vocabulary import plural, vocabulary
from .word_forms import Tables, several


class Told(NamedTuple):
    """A word or phrase in English, what kind of word it is, the characters [start, end) that it stands for, and these
    in lower case. A kind is "" for what no table has."""

    text: str
    kind: str
    start: int
    end: int
    source: str = ""


_STOPS = frozenset(".,;:!?()")
_UNITS = ("m", "cm", "mm", "m2")
_FIGURES = {"a": "1", "one": "1", "two": "2"}
_NAMED = ("nouns", "adjectives", "numbers")


def _is_stop(told: Sequence[Told], at: int) -> bool:
    """Whether a clause ends at a place."""
    return not 0 <= at < len(told) or told[at].text in _STOPS


def _is_unknown(one: Told) -> bool:
    return not one.kind and one.text[:1].isalpha()


def _by(told: Sequence[Told], table: Tables) -> list[Told]:
    """Between two measures "4 mal 5 Meter" is a product."""
    found = list(told)
    for k in range(1, len(found) - 1):
        if found[k].source in table.rules["by"] and found[k + 1].kind == "numbers":
            before = found[k - 1]
            unit = before.text in ("m", "cm", "mm") and k > 1 and found[k - 2].kind == "numbers"
            if before.kind == "numbers" or unit or before.text.endswith(" m"):
                found[k] = found[k]._replace(text="x", kind="words")
                found[k + 1] = found[k + 1]._replace(text=_FIGURES.get(found[k + 1].text, found[k + 1].text))
    return found


def german_order(told: Sequence[Told], table: Tables) -> list[Told]:
    """Particles and verbs at the end of clauses go; relative pronouns become what English says instead."""
    found = _materials(_by(told, table), table)
    for k in range(1, len(found) - 1):  # "die Küche einer Schule"
        between = found[k - 1].kind == "nouns" and found[k + 1].kind in ("nouns", "adjectives")
        if between and found[k].source in table.rules["genitives"]:
            found[k] = found[k]._replace(text=f"of {found[k].text}")
    start = 0
    for end in range(len(found) + 1):
        if not _is_stop(found, end):
            continue
        _german_clause(found, start, end, table)
        start = end + 1
    return _several([one for k, one in enumerate(found) if not _is_lost_adjective(found, k)])


def _materials(told: Sequence[Told], table: Tables) -> list[Told]:
    """What a thing is made of goes before it: "ein Tisch aus Eiche", "une table en chêne"."""
    found: list[Told] = []
    at = 0
    while at < len(told):
        one = told[at]
        where = len(found)
        while where and found[where - 1].kind == "nouns":
            where -= 1
        if one.kind == "adjectives" and one.source.split()[0] in table.rules["made_of"] and where < len(found):
            found.insert(where, one)
            at += 1
            continue
        if one.source in table.rules["made_of"] and where < len(found):
            end = at + 1
            while end < len(told) and told[end].kind == "adjectives":
                end += 1
            if end < len(told) and told[end].kind == "nouns" and _is_material(told[end].text):
                found[where:where] = [*told[at + 1 : end], told[end]]
                at = end + 1
                continue
        found.append(one)
        at += 1
    return found


def _is_material(text: str) -> bool:
    table = vocabulary()
    return "material" in table.get(text, {}) or ("material" in table.get(text.split()[-1], {}) and " " in text)


def _neither(told: Sequence[Told]) -> list[Told]:
    """What is said to be absent, with "or" between, is told one by one: "no rug and no plant"."""
    found = list(told)
    absent = False
    for k, one in enumerate(found):
        absent = one.text in ("no", "without", "nor") or (
            absent and one.text not in _STOPS and one.kind != "words" or one.text == "or" and absent
        )
        if absent and one.text == "or" and one.kind == "words":
            found[k] = one._replace(text="and no")
    return found


def _several(told: Sequence[Told]) -> list[Told]:
    """After a number of more than one a noun is in the plural, whether its own language shows it or not."""
    found = _neither(told)
    for k, one in enumerate(found):
        if one.kind == "numbers" and k + 1 < len(found) and found[k + 1].text in _UNITS:
            found[k] = one._replace(text=_FIGURES.get(one.text, one.text))
            continue
        if one.kind != "numbers" or one.text in ("a", "one", "1", "0") or not one.text.isalnum():
            continue
        end = k + 1
        while end < len(found) and found[end].kind == "adjectives":
            end += 1
        while end + 1 < len(found) and found[end].kind == found[end + 1].kind == "nouns":
            end += 1
        if end < len(found) and found[end].kind == "nouns" and _is_singular(found[end].text):
            found[end] = found[end]._replace(text=several(found[end].text))
    return found


def _is_singular(text: str) -> bool:
    kinds = vocabulary().get(text, {})
    if "plural" in kinds or (text.endswith("s") and not text.endswith("ss")):
        return False
    return "people_words" not in kinds or plural(text) in vocabulary()  # "people" is none


def _is_lost_adjective(found: Sequence[Told], at: int) -> bool:
    """Whether an unknown word in small letters stands before a noun, of which it says something that is not known."""
    one = found[at]
    after = found[at + 1] if at + 1 < len(found) else None
    return _is_unknown(one) and after is not None and after.kind in ("nouns", "adjectives")


def _german_clause(found: list[Told], start: int, end: int, table: Tables) -> None:
    """One clause [start, end) as English has it."""
    rules = table.rules
    last = end - 1
    while last > start and not found[last].text:
        last -= 1
    if last > start and found[last].source in rules["particles"] and found[last].kind == "words":
        found[last] = found[last]._replace(text="")  # "hängt das Bild auf"
    modal = next((k for k in range(start, end) if found[k].source in rules["modals"]), None)
    if modal is not None and last > start and found[last].source in rules["infinitives"]:
        many = found[modal].source.endswith("n")  # "in der Ecke soll ein Bett stehen"
        found[modal] = found[modal]._replace(text="are" if many else "is")
        found[last] = found[last]._replace(text="")
    for k in range(start, end):
        if found[k].source == "weder":
            found[k] = found[k]._replace(text="no")
            for other in range(k + 1, min(end, k + 8)):
                if found[other].source == "noch":
                    found[other] = found[other]._replace(text="and no")
                    break
    if end - start < 3 or start == 0 or found[start - 1].text != ",":
        return
    one, two = found[start], found[start + 1]
    of_phrase = one.source.rpartition(" ")[2]
    if of_phrase != one.source and of_phrase in rules["relatives"] and (two.kind == "numbers" or two.text == "no"):
        found[start] = one._replace(text=f"{one.text.removesuffix(' the')} {'them' if of_phrase == 'denen' else 'it'}")
        _drop_final(found, last, table)  # ", neben dem ein Stuhl steht"
        return
    if two.source in rules["relatives"] and one.kind == "words" and start + 2 < end:
        if found[start + 2].kind == "numbers" or found[start + 2].text == "no":  # ", neben dem ein Stuhl steht"
            found[start + 1] = two._replace(text="them" if two.source == "denen" else "it")
            _drop_final(found, last, table)
    elif one.source in rules["relatives"] and found[last].source in rules["finals"] and two.kind == "words":
        many = found[last].source.endswith("n")  # ", der an der Wand steht"
        found[start] = one._replace(text="that are" if many else "that is")
        _drop_final(found, last, table)


def _drop_final(found: list[Told], last: int, table: Tables) -> None:
    if found[last].source in table.rules["finals"]:
        found[last] = found[last]._replace(text="")


def romance_order(told: Sequence[Told], table: Tables) -> list[Told]:
    """Nouns that are joined by "de" stand the other way round, and adjectives go before their noun."""
    found = [one for one in _by(told, table) if one.text]
    for k, one in enumerate(found[:-1]):  # "unas veinte"
        if one.text == "some" and found[k + 1].kind == "numbers":
            found[k] = one._replace(text="about", kind="words")
    found = _materials(found, table)
    found = _joined_nouns(_without_unknown(found), table)
    ordered: list[Told] = []
    at = 0
    while at < len(found):
        one = found[at]
        further = one.text == "and" and ordered and ordered[-1].kind == "nouns" and _was_adjective(found, at)
        if further and at + 1 < len(found) and found[at + 1].kind == "adjectives" and not _names(found, at + 2):
            at += 1  # "ronde et basse"
            one = found[at]
        where = len(ordered)
        while one.kind == "adjectives" and where and ordered[where - 1].kind == "nouns":
            where -= 1
        ordered.insert(where, one)
        at += 1
    for k, one in enumerate(ordered):  # "en la pared"
        if one.source == "en" and _lies_ahead(ordered, k + 1):
            ordered[k] = one._replace(text="on")
    return _several(ordered)


_FACES = ("wall", "walls", "floor", "ceiling")
"""Nouns that things are on, not in."""


def _lies_ahead(ordered: Sequence[Told], at: int) -> bool:
    """Whether the next noun is a wall, the floor or the ceiling."""
    while at < len(ordered) and (
        ordered[at].kind in ("adjectives", "numbers") or ordered[at].text in ("the", "each", "both", "all")
    ):
        at += 1
    return at < len(ordered) and ordered[at].kind == "nouns" and ordered[at].text.split()[-1] in _FACES


def _was_adjective(found: Sequence[Told], at: int) -> bool:
    """Whether an adjective stands before a place, of its own or at the end of a name: "table ronde"."""
    return at > 0 and (found[at - 1].kind == "adjectives" or " " in found[at - 1].source)


def _names(found: Sequence[Told], at: int) -> bool:
    return at < len(found) and found[at].kind == "nouns"


def _without_unknown(told: Sequence[Told]) -> list[Told]:
    """Without unknown words that say something of the noun before them, as adjectives do or behind "de"."""
    found: list[Told] = []
    for one in told:
        if _is_unknown(one) and found:
            if found[-1].kind in ("nouns", "adjectives"):
                continue
            if len(found) > 1 and found[-1].text in ("of", "to", "at") and found[-2].kind in ("nouns", "adjectives"):
                found.pop()
                continue
        found.append(one)
    return found


def _joined_nouns(told: Sequence[Told], table: Tables) -> list[Told]:
    """ "Mesa de cocina" is a kitchen table; what is in a container, or in a row, stays behind it."""
    found: list[Told] = []
    for at, one in enumerate(told):
        before = found[-2:]
        if (
            one.kind == "nouns"
            and len(before) == 2
            and before[1].source in table.rules["of"]
            and before[0].kind == "nouns"
            and not _holds(before[0].text)
            and not (at + 1 < len(told) and told[at + 1].source in table.rules["of"] and _holds(one.text))
        ):
            head = before[0]
            found[-2:] = [one._replace(text=_single(one.text)), head]
            continue
        found.append(one)
    return found


def _single(text: str) -> str:
    """A plural noun as it stands before another: "livres" of "étagère à livres"."""
    table = vocabulary()
    for form in (text.removesuffix("s"), text.removesuffix("es")):
        if form != text and plural(form) == text and table.get(form, {}):
            return form
    return text


def _holds(text: str) -> bool:
    """Whether a noun is one of containers and collections: a stack of books is no book stack."""
    for form in (text, text.removesuffix("s"), text.removesuffix("es")):
        if vocabulary().get(form.split()[-1] if form else "", {}).keys() & {
            "containers",
            "collective",
            "abstract",
            "amount",
        }:
            return True
    return False


def chinese_order(told: Sequence[Told], table: Tables) -> list[Told]:
    """Words of place, numbers and what stands before 的 go where English has them."""
    found = _sized(_counted(_by(told, table)))
    found = [one for k, one in enumerate(found) if not (_is_unknown(one) and len(one.source) == 1)]
    found = [one for k, one in enumerate(found) if not _is_lost_adjective(found, k)]
    return _several(_attributes(_postposed(found)))


def _counted(told: Sequence[Told]) -> list[Told]:
    """A number with its measure word behind a noun goes before it: "椅子六把"."""
    found: list[Told] = []
    for at, one in enumerate(told):
        after = told[at + 1] if at + 1 < len(told) else None
        ends = (
            after is None
            or after.kind not in ("nouns", "adjectives", "measures", "numbers")
            and after.text not in ("m", "cm", "m2", "x", "people")
        )
        where = len(found)
        while one.kind == "numbers" and ends and where and found[where - 1].kind in ("nouns", "adjectives"):
            where -= 1
        found.insert(where, one)
    return found


def _sized(told: Sequence[Told]) -> list[Told]:
    """ "长四米" is 4 m long."""
    found = list(told)
    at = 0
    while at + 2 < len(found):
        if (
            found[at].text in ("long", "wide", "high", "deep")
            and found[at + 1].kind == "numbers"
            and found[at + 2].text in ("m", "cm")
        ):
            found[at : at + 3] = [found[at + 1], found[at + 2], found[at]]
            if at + 3 < len(found) and found[at + 3].text in ("long", "wide", "high", "deep"):
                found.insert(at + 3, Told("and", "words", found[at].start, found[at].end))
        at += 1
    return found


def _postposed(told: Sequence[Told]) -> list[Told]:
    """Words of place that follow their noun go before it: "bed beside" is "beside bed"; without one they are of it."""
    found: list[Told] = []
    for one in told:
        if one.kind == "measures":
            continue
        if one.kind == "postpositions" and found and found[-1].source == "的":
            found.pop()  # "床的对面"
        at = len(found)
        if one.kind == "postpositions":
            while at and (
                found[at - 1].kind in _NAMED or (found[at - 1].text == "and" and one.text.startswith("between"))
            ):
                at -= 1
            behind, _, alone = one.text.partition("|")
            joined = any(told.text == "and" for told in found[at:])
            between, _, middle = behind.partition("/")  # "A和B中间", "房间中间"
            behind = middle if middle and not joined else between
            one = one._replace(text=behind if at < len(found) else alone or f"{behind} it")
        found.insert(at, one)
    return found


def _attributes(told: Sequence[Told]) -> list[Told]:
    """What says before 的 where a thing is goes behind it: "窗边的书桌" is a desk by the window."""
    found: list[Told] = []
    at = 0
    while at < len(told):
        one = told[at]
        start = next((k for k in range(len(found) - 1, -1, -1) if _begins_place(found[k])), None)
        placed = (
            one.source == "的"
            and start is not None
            and all(f.kind in (*_NAMED, "words", "postpositions") and f.text not in _STOPS for f in found[start:])
            and not (" the " in found[start].text and any(f.kind == "numbers" for f in found[start:]))
        )
        if placed and start is not None and at + 1 < len(told) and told[at + 1].kind in _NAMED:
            segment, found = found[start:], found[:start]
            at += 1
            while at < len(told) and told[at].kind in _NAMED:
                found.append(told[at])
                at += 1
            found += segment
            continue
        found.append(one)
        at += 1
    return found


_PLACES = (
    "by ",
    "on ",
    "in ",
    "at ",
    "against ",
    "near",
    "next to",
    "under",
    "above",
    "below",
    "beside",
    "along ",
    "opposite",
    "facing",
    "with ",
)


def _begins_place(one: Told) -> bool:
    return one.kind in ("words", "postpositions") and f"{one.text} ".startswith(_PLACES)
