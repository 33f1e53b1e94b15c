"""One thing that a phrase names twice, or names as what is not wanted: "a crate as a table", "a trunk that doubles as a
bench", "a settle, i.e. a bench", "benches instead of chairs", "six chairs in all".

The second name makes no second thing. It stays a name of the first one, by which the request may go on to speak of it.
"""

from __future__ import annotations

import re
from functools import cache

from ..chunks import bounded
from ..exclusions import names_of
from ..parsed import Left, Parsed, Role
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import vocabulary, words
from .phrases import NUMBER, Edits, noun_after, noun_before, number_of, one_of

REACH = 80
"""Characters before a phrase in which the thing that it is about is named."""

_DET = r"(?:(?:an?|the|our|my|his|her|their|one|some) )?"


def roles(source: Source, parsed: Parsed) -> None:
    """Read what things serve as, what they are in other words, what they are there for in place of, and totals."""
    _name_both(source, parsed)
    edits = Edits(source)
    for m in _serving().finditer(source.text):
        _serves(m, edits, parsed)
    for m in _ahead().finditer(source.text):
        _serves_ahead(m, edits, parsed)
    for m in _instead().finditer(source.text):
        _in_place_of(m, edits, parsed)
    for m in _made_of().finditer(source.text):
        _built(m, edits, parsed)
    for m in _TOTAL.finditer(source.text):
        _in_all(m, edits, parsed)
    for m in _TIMES.finditer(source.text):
        _times(m, edits, parsed)
    for m in _BEHIND.finditer(source.text):
        _behind(m, edits, parsed)
    for m in _BY_SO_MANY.finditer(source.text):
        _stacked(m, edits, parsed)


@cache
def _serving() -> re.Pattern[str]:
    data = words("roles")
    verb = rf"(?:(?:(?:that|which) )?(?:(?:can|may|will|should|also|is|are) )*{one_of(data['serving'])} )"
    plain = rf"(?:{verb}?(?:also )?as|{verb}(?:up )?into)"
    return re.compile(rf",? ?(?<![\w])(?:{plain}|(?P<means>{one_of(data['meaning'])}),?) {_DET}(?=[a-z])")


@cache
def _ahead() -> re.Pattern[str]:
    return re.compile(
        rf"(?:^|[.,]|\band\b) ?(?P<role>as {_DET}(?=[a-z]))(?P<noun>[a-z -]{{3,30}}?) ?"
        r"(?:,|there is|there's|there are|we have|we use|i use|use|i want) ?"
        r"(?P<thing>(?:an?|one|two|some|the|my|our) )"
    )


@cache
def _instead() -> re.Pattern[str]:
    return re.compile(rf",? ?\b{one_of(words('roles')['instead'])} (?:an? |the |any |some |normal |usual |ordinary )*")


@cache
def _made_of() -> re.Pattern[str]:
    made = one_of(words("roles")["made"])
    return re.compile(rf"\b{made} (?:of|from|out of|with) (?:[a-z-]+ ){{0,2}}?(?P<noun>[a-z]+s)\b")


_TOTAL = re.compile(
    rf",? ?(?:\b(?:so|thus|therefore|makes|making|that is|that makes|which makes|i\.e\.) )?\b(?P<n>{NUMBER}) "
    r"(?P<noun>[a-z-]+(?: [a-z-]+)??) (?:in total|in all|all together|altogether|overall|total)\b"
)
_TIMES = re.compile(r"(?<=[a-z]) ?\(?(?<![a-z0-9.])[x×] ?(?P<n>\d{1,2})\)?(?![\w.]| ?(?:m|cm|ft|x)\b| by \d)")


_TWO_KINDS = re.compile(
    rf"\b(?:{NUMBER}|an?) +(?P<one>[a-z-]+) ?(?:and|&|plus|,) (?:{NUMBER}|an?) +(?P<two>[a-z-]+) (?P<noun>[a-z]+)"
)


_BEHIND = re.compile(
    rf"(?:(?<=^)|(?<=[,.:])|(?<=[,.:] )|(?<=\band ))(?P<noun>[a-z]+(?: [a-z]+)?)[,.]? "
    rf"(?P<n>{NUMBER})(?:(?P<more> or more| and up| at least| min\.?| minimum)|(?=\s*(?:[,.]|$)))"
)
_BY_SO_MANY = re.compile(
    r"\b(?:stacked|piled)(?: up)? (?:by|in) (?P<n>twos|threes|fours|fives|sixes|sevens|eights|tens)\b"
)


def _behind(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Plants 5 or more", "beds 2, desks 2"."""
    noun, count = m["noun"], number_of(m["n"])
    last = singular(noun.split()[-1])
    known = "noun" in vocabulary().get(last, {}) and match_of(singular(noun)).how != "generic"
    known = known and "people_words" not in vocabulary().get(noun.split()[-1], {})  # "a table seats eight"
    if not known or not count or not edits.free(m.end("noun"), m.end()) or len(noun.split()[0]) < 2:
        return
    if any(noun.split()[-1] in verbs for verbs in words("people")["verbs"].values()):
        return  # "table seats eight"
    parsed.bounds.append(((noun,), *bounded((count, count), "least" if m["more"] else None)))
    parsed.referred.append(edits.take(m.end("noun"), m.end()))


def _stacked(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Stacked by fives" is in stacks of five."""
    edits.take(m.start(), m.end(), f"in stacks of {number_of(m['n'].removesuffix('s').replace('sixe', 'six'))}")


_EACH_SIDE = re.compile(
    r"(?<=[a-z0-9])(?<!\bon)(?<!\bat)(?<!\balong)(?<!\bfrom) (?=(?:each|either) side(?: of\b|\s*(?:[,.)]|$)))"
)
_IN_EACH_ROW = re.compile(
    rf"\brows of (?P<noun>[a-z]+),? (?P<n>{NUMBER}) (?:(?P=noun) )?(?:in|to|per|a) ?(?:(?:each|every|a|the) )?row\b"
)
_OF_TWO = re.compile(r"\bhis (?:and|&) hers?\b")


def _name_both(source: Source, parsed: Parsed) -> None:
    """ "Two upper and two lower bunks" are upper bunks and lower bunks: the noun is said once for both. The number of a
    row goes before its things, and what is "each side of" something is on each side."""
    for m in reversed([*_TWO_KINDS.finditer(source.text)]):
        noun, _ = _thing_at(source.text, m.start("noun"))
        if noun and not _is_quality(noun) and all(_is_quality(m[name]) for name in ("one", "two")):
            source.insert(m.end("one"), f" {noun}", m.start("noun"))
    source.blank(_OF_TWO, lambda m: "two")
    for m in reversed([*_EACH_SIDE.finditer(source.text)]):
        source.insert(m.end(), "on ", m.end())
    for m in reversed([*_IN_EACH_ROW.finditer(source.text)]):  # "three rows of tables, two in each row"
        at, number = m.start("noun"), source.text[m.start("n") : m.end("n")]
        parsed.referred.append(source.span(m.end("noun"), m.end()))
        source.replace(m.end("noun"), m.end())
        source.insert(at, f"{number} ", m.start("n"))


def _is_quality(word: str) -> bool:
    """Whether a word can only say what a thing is like."""
    kinds = vocabulary().get(word, {}).keys()
    like = {"color", "scale", "shape", "finish", "adjective", "styles", "material"}
    return word in words("roles")["qualities"] or (bool(kinds & like) and not kinds & {"noun", "room", "each"})


def _thing_at(text: str, at: int) -> tuple[str, int]:
    """The longest known noun that begins at a place, and where it ends; "" where there is none."""
    noun, _ = noun_after(text, at)
    parts = noun.split()
    while parts:
        name = " ".join(parts)
        last = parts[-1]
        kinds = vocabulary().get(last, {}).keys() | vocabulary().get(singular(last), {}).keys()
        if "noun" in kinds and not kinds & {"abstract"} and match_of(singular(name)).how != "generic":
            m = re.compile(rf"\s*{re.escape(name)}").match(text, at)
            return (name, m.end()) if m is not None else ("", at)
        parts.pop()
    return "", at


def _just_before(text: str, at: int) -> str:
    """The noun that stands right before a place."""
    start = max(0, at - REACH)
    start = max(start, text.find(" ", start, at)) if start else 0
    return noun_before(text[start:at], at - start)


def _is_thing(noun: str) -> bool:
    """Whether a noun names a body that there is a drawing of, and no opening or building material."""
    last = singular(noun.split()[-1])
    return last not in words("roles")["no_bodies"] and match_of(singular(noun)).how != "generic"


def _serves(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A beer crate as a table": the crate is called a table, too. An old door as a desk is a desk."""
    text = edits.source.text
    role, end = _thing_at(text, m.end())
    thing = _just_before(text, m.start()) if role else ""
    before = re.search(r"([a-z'-]+)\W*$", text[max(0, m.start() - REACH) : m.start()])
    if not thing or before is None or before[1] != thing.split()[-1] or not edits.free(m.start(), end):
        return
    if before[1] in words("roles")["no_role_after"] or singular(thing) == singular(role):
        return
    at, means = before.start(1) + max(0, m.start() - REACH), m["means"] is not None
    if _is_thing(thing) and not means:
        span = edits.take(m.start(), end, " ")
        parsed.roles.append(Role(at, role, " ".join(text[m.start() : end].split()).strip(" ,"), span))
        return
    start = text.rfind(thing, 0, m.start())
    if start < 0:
        return
    span = edits.take(start, m.end())
    if means:
        parsed.referred.append(span)  # "a settle, i.e. a bench"
    else:
        parsed.unread.append(Left(" ".join(text[start : m.end()].split()), span=span))


def _serves_ahead(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "As a table, a beer crate"."""
    text = edits.source.text
    role, end = _thing_at(text, m.end("role"))
    thing, last = noun_after(text, m.end("thing"))
    if not role or end < m.end("noun") or not edits.free(m.start("role"), end):
        return
    while thing and match_of(singular(thing)).how == "generic" and " " in thing:
        thing = thing.rpartition(" ")[0]
    if not thing or not _is_thing(thing):
        return
    last = text.index(thing, m.end("thing")) + len(thing)
    span = edits.take(m.start("role"), m.start("thing"))
    parsed.roles.append(Role(last - 1, role, f"as {role}", span))


def _in_place_of(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Instead of a wardrobe a rail": there is to be no wardrobe."""
    text = edits.source.text
    noun, end = _thing_at(text, m.end())
    if not noun or not edits.free(m.start(), end):
        return
    head, apart = singular(noun.split()[-1]), text[: m.start()] + text[end:]
    names = names_of(noun)
    if not names or re.search(rf"\b{re.escape(head)}(?:s|es)?\b", apart) or _qualified(noun):
        return  # "two small tables instead of one large table" rules out no table
    again = re.compile(r" (?:and|or) (?:an? |the )?").match(text, end)
    ahead = re.search(r"[a-z]", text[max(text.rfind(c, 0, m.start()) for c in ".,") + 1 : m.start()]) is None
    if again is not None and not ahead:
        more, last = _thing_at(text, again.end())
        if more and names_of(more):
            parsed.without.append((more, names_of(more), edits.source.span(again.end(), last)))
            end = last
    span = edits.take(m.start(), end, "," if ahead and m.start() else "")
    parsed.without.append((noun, names, span))


def _built(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A shelf made from crates": no crates beside the shelf."""
    one, known = singular(m["noun"]), _thing_at(edits.source.text, m.start("noun"))[0]
    if known != m["noun"] or one == known or not edits.free(m.start(), m.end()):
        return
    spoken = edits.source.text[m.start() : m.end()]
    parsed.unread.append(Left(spoken, span=edits.take(m.start(), m.end())))


def _qualified(noun: str) -> bool:
    """Whether only some of a kind are meant: "a second bed"."""
    first = vocabulary().get(noun.split()[0], {})
    return " " in noun and bool(first.keys() & {"number", "scale", "color", "material", "every", "adjective"})


def _in_all(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Three tables with two chairs each, so six chairs in all": the chairs that were named, and how many."""
    text = edits.source.text
    noun = m["noun"]
    head = singular(noun.split()[-1])
    if match_of(singular(noun)).how == "generic" or not edits.free(m.start(), m.end()):
        return
    if re.search(rf"\b{re.escape(head)}(?:s|es)?\b", text[: m.start()]) is None:
        return
    count = number_of(m["n"])
    span = edits.take(m.start(), m.end())
    parsed.bounds.append(((noun,), count, count))
    parsed.referred.append(span)


def _times(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Wig heads x3"."""
    noun = _just_before(edits.source.text, m.start())
    if not noun or not edits.free(m.start(), m.end()) or match_of(singular(noun)).how == "generic":
        return
    count = int(m["n"])
    if count:
        parsed.bounds.append(((noun,), count, count))
        parsed.referred.append(edits.take(m.start(), m.end()))


__all__ = ["roles"]
