"""Nouns for people, as all readers know them: "two seamstresses and a cutter" are three people.

What WordNet knows as a person and the vocabulary knows as no thing is somebody where a number stands before it. Several
of them that "and" binds are counted together. Who comes in a wheelchair is a wheelchair, and somewhere to sit a chair.
"""

from __future__ import annotations

import re
from functools import cache

from sceneweaver.assets.wordnet import of_head

from ..parsed import Parsed
from ..source import Source
from ..vocabulary import vocabulary, words
from .phrases import NUMBER, Edits, listed, number_of, one_of, table_before

MOST_BEFORE = 2
"""Words between a number and the noun that says who they are: "three young glass blowers"."""

_NO_ONE = frozenset(
    ("noun", "room", "group", "place", "region", "collective", "number", "amount", "color", "material", "adjective")
)
"""What a word may be that names a thing, a part of the room or a number, and nobody."""

_WORDS = re.compile(r" ([a-z]+(?:-[a-z]+)*)")
_OF_US = re.compile(rf"\b(?P<n>{NUMBER})(?P<of> of us)\b(?! (?:four|five|six|seven|eight|nine|ten)\b)")
_ROUNDS = re.compile(rf"\brounds(?= (?:of|for|seating) {NUMBER})")
_A_SIDE = re.compile(rf"\b(?P<n>{NUMBER}) (?:a|per|each) side\b")
_ONE = rf"(?:an?|one|{NUMBER})"
_COUNTED = re.compile(rf"(?<![\w'-]){NUMBER}(?= [a-z])")
_ME = re.compile(rf"\b(?:me|myself)(?= (?:and|plus|with) {_ONE} )")
_A = re.compile(r"(?<![\w'-])an?(?= [a-z])")
_OWN = re.compile(r"\b(?:my|our|his|her|their)(?= [a-z])")
_AND_OWN = re.compile(r" and (?:my|our|his|her|their|an?)(?= [a-z])")
_NEXT = re.compile(rf"(?:,? (?:and|plus|with)|,)(?P<gap> )(?P<n>{_ONE})(?= [a-z])")


def persons(source: Source, parsed: Parsed) -> None:
    """Puts who is counted, and what they come with, in words that the readers after it know."""
    for m in reversed(list(_ROUNDS.finditer(source.text))):
        source.insert(m.end() - 1, " table", m.start())  # "5 rounds of 8"
    for m in reversed(list(_A_SIDE.finditer(source.text))):
        what = next((row for word, row in words("people")["a_side"].items() if word in source.spoken), None)
        if what is not None and not table_before(source.text, m.start()):
            source.replace(*m.span(), f" {2 * number_of(m['n'])} {what}")
    edits = Edits(source)
    _in_wheelchairs(source, parsed, edits)
    _somewhere_to(source, parsed, edits)
    for m in list(_OF_US.finditer(source.text)):
        edits.take(*m.span("of"), "men".rjust(len(m["of"])))
    for m in [*_ME.finditer(source.text), *_COUNTED.finditer(source.text), *_A.finditer(source.text)]:
        if edits.free(*m.span()):
            _counted(m, source, edits)
    for m in _OWN.finditer(source.text):
        _of_one(m, source, parsed)


def _of_one(m: re.Match[str], source: Source, parsed: Parsed) -> None:
    """ "My grandson and his friend" are two, who stay in the source for whom the room is."""
    total, end = 1, somebody(source.text, m.end(), plural=False)
    while end and (more := _AND_OWN.match(source.text, end)) is not None:
        then = somebody(source.text, more.end(), plural=False)
        if not then:
            break
        total, end = total + 1, then
    if total > 1 and parsed.people is None:
        parsed.people = total
        parsed.referred.append(source.span(m.start(), end))


def _counted(m: re.Match[str], source: Source, edits: Edits) -> None:
    """One number with who they are, and those that "and" binds to them."""
    me = m[0] in ("me", "myself")
    alone = me or m[0] in ("a", "an")
    total = 1 if alone else number_of(m[0])
    end = m.end() if me else somebody(source.text, m.end(), plural=not alone and m[0] not in _SINGLE)
    if not end or not total:
        return
    parts = 1
    while (more := _NEXT.match(source.text, end)) is not None:
        count = 1 if more["n"] in ("a", "an") else number_of(more["n"])
        then = somebody(source.text, more.end(), plural=count > 1)
        if not then:
            break
        total, end, parts = total + count, then, parts + 1
    if parts == 1 and (alone or _is_known(source.text[m.end() : end])):
        return
    number = str(total) if parts > 1 else m[0]
    room = end - m.start() - len(number)
    noun = next((n for n in (("people", "men") if total > 1 else ("person", "man")) if len(n) < room), "")
    if noun:
        edits.take(m.start(), end, number + noun.rjust(room))


_SINGLE = ("one", "1")


def somebody(text: str, at: int, plural: bool) -> int:
    """Where the noun ends that names people behind a number or an article; 0 where none does."""
    spoken: list[str] = []
    while len(spoken) <= MOST_BEFORE and (m := _WORDS.match(text, at)) is not None:
        spoken.append(m[1])
        at = m.end()
        if _is_person(" ".join(spoken[-2:]), plural):
            after = _WORDS.match(text, at)
            kinds = vocabulary().get(after[1], {}).keys() if after is not None else ()
            goes_on = after is not None and not kinds and after[1] not in _closed()
            head = goes_on or not {"noun", "room", "group", "matter", "parts"}.isdisjoint(kinds)
            return 0 if head and not plural else at  # "one nurse station"
        if spoken[-1] in _closed() or not vocabulary().get(spoken[-1], {}).keys().isdisjoint(_NO_ONE):
            return 0
    return 0


@cache
def _is_person(noun: str, plural: bool) -> bool:
    """Whether a noun of one or two words names people by its form."""
    last = noun.split()[-1]
    if last in words("people")["no_people"] or (plural and not last.endswith("s") and last not in _IRREGULAR):
        return False
    if not plural and last.endswith("s") and not last.endswith(("ss", "us")):
        return False
    if last in listed("people"):
        return True
    if not vocabulary().get(last, {}).keys().isdisjoint(_NO_ONE) or last in words("people")["place_of"]:
        return False
    known = of_head(noun)
    return known is not None and known.kind == "person"


_IRREGULAR = ("people", "men", "women", "children", "staff", "folk")


def _is_known(said: str) -> bool:
    """Whether all readers know the noun as it is."""
    return "people_words" in vocabulary().get(said.split()[-1], {})


@cache
def _closed() -> frozenset[str]:
    return frozenset((*listed("closed"), *listed("prepositions"), "of"))


def _in_wheelchairs(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "Eight readers of whom two come in wheelchairs": two wheelchairs are there."""
    for m in list(_wheelchairs().finditer(source.text)):
        count = number_of(m["n"])
        said = "a wheelchair" if count == 1 else f"{count} wheelchairs"
        for instead in (f", {said}", said):
            if len(instead) <= m.end() - m.start():
                parsed.referred.append(edits.take(m.start(), m.end(), instead))
                break


@cache
def _wheelchairs() -> re.Pattern[str]:
    return re.compile(
        rf"(?:, )?(?:of whom |of them |and )?\b(?P<n>one|{NUMBER})(?: of (?:them|us|whom|these))?"
        r"(?: (?:come|comes|coming|arrive|arrives|are|is|sit|sits|get about|move|use|uses|using|moves))?"
        r"(?: in| on| with| uses?| using) (?:(?:an?|their|his|her) )?(?:power |electric )?wheelchairs?\b"
    )


def _somewhere_to(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "Somewhere for Pat to sit" is a chair."""
    for m in list(_somewhere().finditer(source.text)):
        does = next(name for name, verbs in words("people")["somewhere"].items() if m["does"] in verbs["to"])
        said = words("people")["somewhere"][does]["is"]
        if len(said) <= m.end() - m.start():
            parsed.referred.append(edits.take(m.start(), m.end(), said))


@cache
def _somewhere() -> re.Pattern[str]:
    does = one_of([verb for row in words("people")["somewhere"].values() for verb in row["to"]])
    return re.compile(
        r"\b(?:somewhere|an? (?:[a-z]+ )?(?:place|spot|perch))(?: for (?:[a-z']+ ){1,3}?| )to "
        rf"(?P<does>{does})\b(?: (?:and|or) (?:chat|gossip|talk|watch|read|rest|wait|think))?"
        r"(?! (?:at|on|in|by|near)\b)"
    )


__all__ = ["persons", "somebody"]
