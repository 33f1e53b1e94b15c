"""Groups in words: at right angles, along both walls, one between each two, on all sides, head to head, in pairs.

They come before the plainer patterns of `arrangements`, which read what these leave.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

from ..model import Arrangement
from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import family
from .aisles import AISLE, ROWS, width_of
from .arrangements import PLACED, add
from .phrases import NUMBER, Edits, noun_after, noun_before, number_of, table_before

PAIRS = {"pairs": 2, "twos": 2, "threes": 3, "fours": 4, "couples": 2}

MOST_SIDES = 4

_N = rf"(?P<n>{NUMBER})"
_NOUN = r"(?P<noun>[a-z][a-z'-]*(?: [a-z][a-z'-]*){0,2}?)"
_END = r"(?=\s*(?:$|[.,;:()]|with\b|and\b|around\b|in\b|on\b|by\b|near\b|so\b|facing\b|to\b|plus\b|at\b))"
_EACH_OTHER = r"(?: (?:to|with|from) (?:each other|one another|it|them))?"
_THE = r"(?:the |an? |its |their )?"


def groups(source: Source, parsed: Parsed) -> None:
    """Reads how several things are set to each other; see `Arrangement`."""
    edits = Edits(source)
    for pattern, read in _patterns():
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                read(m, edits, parsed)


def _members(text: str, at: int) -> tuple[str, tuple[str, ...]]:
    """The things that words at a place are said of: the noun before, or "a sofa and a loveseat"."""
    start = max(text.rfind(".", 0, at), text.rfind("(", 0, at)) + 1
    thing = rf"(?:the|an?|{NUMBER}) ((?:[a-z][a-z'-]* ){{0,2}}?[a-z][a-z'-]*)"
    both = re.search(rf"\b{thing} and {thing}[ ,]*$", text[start:at])
    if both and not _closed(both[1]) and not _closed(both[2]):
        return both[1], (both[2],)
    return noun_before(text, at), ()


def _closed(words: str) -> bool:
    """Whether words are more than one thing: they hold a preposition."""
    return bool(re.search(r"\b(?:with|and|of|in|on|at|by|from|to)\b", words))


def _right_angle(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two sofas at right angles", "a sofa and a loveseat in an L"."""
    noun, others = _members(edits.source.text, m.start())
    if noun and family(match_of(singular(noun)).category) != "kitchen":
        add(edits, parsed, m, "right_angle", noun, others=others)


def _walls(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Beds along both long walls", "six beds, three along each wall", "five chairs on each side of the room"."""
    words = m.groupdict()
    each = m["which"] in ("each", "either")
    many = number_of(m["n"]) if words.get("n") else 0
    noun = words.get("noun") or noun_before(edits.source.text, m.start())
    kind = {"long": "wall:long", "longer": "wall:long", "short": "wall:short", "side": "wall:side"}
    where = kind.get(words.get("kind") or "", "wall")
    sides = (many, many) if many and each else ()
    instead = f"{2 * many if each else many} {noun}" if words.get("noun") else ""
    if words.get("noun") and not many:
        instead = noun
    add(edits, parsed, m, "walls", noun, sides=sides, around=where, instead=instead)


def _between_each(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Beds with a locker between each two", "a curtain between every bed"."""
    text = edits.source.text
    noun = m["noun"]
    host = (m["host"] or "").strip()
    if not host:
        before = text[: m.start()]
        host = parsed.arrangements[-1].entity if parsed.arrangements else noun_before(text, len(before))
    if host:
        add(edits, parsed, m, "between", noun, around=host, instead=f"{m['with'] or ''}{m['a']}{noun}")


def _between_them(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two armchairs and a table between them"."""
    host, others = _members(edits.source.text, m.start())
    mutual = edits.source.text[: m.start()].rstrip(" ,").endswith(("each other", "one another"))
    if not host or others or mutual or _closed(m["noun"]):
        return
    plain = f" with {m['a']}{m['noun']} between them"
    if len(plain) > m.end() - m.start():
        plain = plain.removesuffix(" them")
    if len(plain) <= m.end() - m.start():
        edits.take(m.start(), m.end(), plain)  # the clauses read it so
    else:
        add(edits, parsed, m, "between", m["noun"], around=host, instead=f"{m['how']}{m['a']}{m['noun']}")


def _ends(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two beds head to head", "tables end to end"."""
    text = edits.source.text
    noun = noun_before(text, m.start())
    add(edits, parsed, m, "head_to_head" if m["one"] == m["two"] != "end" else "end_to_end", noun)


def _on_sides(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Four chairs, one on each side", "eight chairs around a table, four on either side"."""
    text = edits.source.text
    each = number_of(m["m"])
    noun = (m["noun"] or "").strip() or noun_before(text, m.start())
    if not noun or not _sits(noun):
        return
    total = number_of(m["n"]) if m["noun"] and m["n"] else _count_of(noun, text, m.start())
    parts = total // each if each and total and total % each == 0 else 2 if m["side"] == "either" else 0
    table = (m["at"] or "").strip() or table_before(text, m.start())
    if table in ("it", "them", "table") or not table:
        table = table_before(text, m.start()) or table_before(text, len(text)) or "table"
    if parts in (2, MOST_SIDES):
        instead = f"{m['n']} {noun}" if m["noun"] and m["n"] else ""
        add(edits, parsed, m, "sides", noun, sides=(each,) * parts, around=table, instead=instead)


def _all_around(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Three chairs on each long side and one at each end"."""
    text = edits.source.text
    noun = (m["noun"] or "").strip()
    if not _sits(noun):
        return
    long, short = number_of(m["m"]), number_of(m["ends"])
    table = table_before(text, m.start()) or "table"
    instead = f"{2 * (long + short)} {noun}"
    add(edits, parsed, m, "sides", noun, sides=(long, long, short, short), around=table, instead=instead)


def _mutual(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Chairs facing each other", more than two of them: in two rows; "across a table": with that between."""
    text = edits.source.text
    noun, others = _members(text, m.start())
    if m["what"]:
        add(edits, parsed, m, "between", m["what"], around=noun, instead=f"{m['how']}{m['a']}{m['what']}")
    count = _count_of(noun, text, m.start()) if noun else 2
    if others or not noun or count == 2 or singular(noun) == noun or count % 2:
        return
    columns = None if count else 1 if m["what"] else 2
    if m["what"]:
        span, words = parsed.arrangements[-1].span, parsed.arrangements[-1].words
    else:
        span, words = edits.take(m.start(), m.end()), m[0].strip(" ,")
    told = Arrangement(entity=noun, pattern="rows", rows=2, columns=columns, facing="each other", words=words)
    parsed.arrangements.append(told.model_copy(update={"span": span}))


def _amid(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A table in the middle of them" is between them."""
    edits.take(m.start(), m.end(), "between them")


def _two_walls(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Shelves along two walls": around the corner of these."""
    noun, _ = _members(edits.source.text, m.start())
    add(edits, parsed, m, "right_angle", noun, around="wall")


def _sits(noun: str) -> bool:
    return family(match_of(singular(noun)).category) == "seat"


def _count_of(noun: str, text: str, at: int) -> int:
    """The number that stands before a noun; 0 where there is none."""
    found = re.findall(rf"\b({NUMBER}) (?:[a-z]+ )?{re.escape(noun)}\b", text[:at])
    return number_of(found[-1]) if found else 0


def _many_beside(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Six washing machines side by side": a row, from three on, or with something between."""
    noun, others = _members(edits.source.text, m.start())
    count = _count_of(noun, edits.source.text, m.start()) if noun else 0
    named = bool(noun) and match_of(singular(noun)).how != "generic"
    if named and not others and (count >= 3 or (count and m["parted"] is not None)):
        add(edits, parsed, m, "row", noun, rows=1, columns=count)


def _row_of_some(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A row of lockers", "rows of pews": without a number."""
    noun, end = noun_after(edits.source.text, m.end())
    if not noun or match_of(singular(noun)).how == "generic":
        return
    many = m["rows"].endswith("s")
    if many:
        add(edits, parsed, m, "rows", noun, end=end)
    else:
        add(edits, parsed, m, "row", noun, end=end, rows=1)


def _in_pairs(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Desks in pairs", "chairs in threes", "crates stacked in threes"."""
    noun = noun_before(edits.source.text, m.start())
    if m["stacked"]:
        add(edits, parsed, m, "stack", noun, rows=PAIRS[m["pairs"]])
        return
    add(edits, parsed, m, "cluster", noun, columns=PAIRS[m["pairs"]])


def _pushed(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Four desks pushed together": one block."""
    noun = noun_before(edits.source.text, m.start())
    count = _count_of(noun, edits.source.text, m.start()) if noun else 0
    add(edits, parsed, m, "cluster", noun, groups=1, columns=count or None)


def _islands(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Three workbenches as islands"."""
    add(edits, parsed, m, "islands", noun_before(edits.source.text, m.start()))


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], Callable[[re.Match[str], Edits, Parsed], None]], ...]:
    angles = r"(?:right[- ]angles?|90[- ]degrees?(?: angles?)?|l(?:[ -]shape(?:d (?:arrangement|formation|group))?)?)"
    sides = r"(?:walls?|sides? of (?:the )?(?:room|hall|ward|barn|space|dorm|dormitory)|side ?walls?)"
    which = r"(?P<which>both|each|either|the two|two opposite|opposite|opposing)"
    kind = r"(?: (?:of the )?(?P<kind>long|longer|short|side|opposite))?"
    along = r"(?:along|down|against|on|at|by|lining)"
    each = r"(?:each|every)"
    rows = (
        (rf"{PLACED}\b(?:at|in|forming|as) (?:an? )?{angles}{_EACH_OTHER}{_END}", _right_angle),
        (r"\bin the (?:middle|centre|center) (?:of|between) (?:them|both|these|the two)\b", _amid),
        (
            rf"{PLACED}\b(?:(?:in|as) an? l(?:[ -]shape)? )?(?:along|against|on|lining) two (?:adjacent |adjoining |"
            r"neighbou?ring )?walls(?! of\b)",
            _two_walls,
        ),
        (
            r"(?P<how>,? ?\b(?:facing|face) (?:each other|one another) )(?:across|over|on either side of) "
            r"(?P<a>an? |the )"
            r"(?P<what>(?:[a-z-]+ ){0,2}?[a-z-]*(?:table|stove|fire|fireplace|desk|counter|chest|bench))\b"
            r"(?: (?:in )?between(?: them)?)?",
            _mutual,
        ),
        (rf"{PLACED}\bperpendicular (?:to (?:each other|one another))", _right_angle),
        (
            rf"(?:,? ?(?:with |and )?)\b(?P<with>with |and |)(?P<a>an? |one )(?P<noun>(?:[a-z-]+ ){{0,2}}?[a-z-]+)"
            rf"(?: standing| placed| set)? (?:in )?between {each}(?: two\b| pair\b| other\b| couple\b)?"
            rf"(?: of (?:them|the [a-z]+))?(?: (?!(?:and|with|in|on|at|of|facing)\b)(?P<host>[a-z]+))?",
            _between_each,
        ),
        (
            rf"(?P<how>,? ?(?:and|plus|,|;|&) )(?P<a>an? |one |the )(?P<noun>(?:[a-z-]+ ){{0,2}}?[a-z-]+)"
            rf"(?: standing| placed| set)? (?:in[ -]?)?between(?: them| the two(?! [a-z])| both(?! [a-z])|{_END})",
            _between_them,
        ),
        (
            rf"\b{_N} {_NOUN} {along} {which}{kind} {sides}(?! of\b)",
            _walls,
        ),
        (rf",? ?(?:and )?(?:\b{_N} )?{PLACED}\b{along} {which}{kind} {sides}(?! of\b)", _walls),
        (rf"{PLACED}\b(?:along|down) {which} (?:sides?|flanks?)(?! of\b)", _walls),
        (
            rf"\b(?P<m>{NUMBER}) {_NOUN} (?:on|at|along|to) (?:each|either|both|every) (?:of the )?(?:long )?sides?,? "
            rf"(?:and|plus|with) (?P<ends>{NUMBER}) (?:on|at) (?:each|either|both|the|every) (?:of the )?"
            r"(?:ends?|heads?|short sides?)(?: of (?:it|the table))?",
            _all_around,
        ),
        (
            rf"\b{_N} {_NOUN},? (?:with )?(?P<m>{NUMBER}) (?:on|at|to|along|for|per) (?P<side>each|every|either)"
            rf" side(?: of (?:the )?(?P<at>it|them|[a-z]+))?",
            _on_sides,
        ),
        (
            rf"(?P<noun>(?!))?,? ?(?P<n>(?!))?\b(?P<m>{NUMBER}) (?:on|at|to|along) (?P<side>each|every|either) side"
            rf"(?: of (?:the )?(?P<at>it|them|[a-z]+))?{_END}",
            _on_sides,
        ),
        (rf"{PLACED},? ?\b(?P<one>head|foot|end|toe)s?[- ]to[- ](?P<two>head|foot|end|toe|tail)s?\b", _ends),
        (
            rf"{PLACED}\b(?:side by side|next to (?:each other|one another)|shoulder to shoulder|in line|"
            rf"beside (?:each other|one another))\b(?P<parted>(?= with (?:an?|one|the) [a-z -]*\bbetween\b))?",
            _many_beside,
        ),
        (rf"\b(?:an? |the |two |several )?(?:{_STRAIGHT})?(?P<rows>rows?|lines?|banks?) of (?!{NUMBER})", _row_of_some),
        (rf"{PLACED}(?P<stacked>,? ?\b(?:stacked|piled)(?: up)? )?\bin (?P<pairs>{'|'.join(PAIRS)})\b", _in_pairs),
        (rf"{PLACED}\b(?:pushed|shoved|put|joined) together\b(?: in(?:to| the)? [a-z]+)?", _pushed),
        (rf"{PLACED}\b(?:as|like) (?:free-?standing )?(?:islands?|an island)\b", _islands),
    )
    return tuple((re.compile(pattern), read) for pattern, read in rows)


_STRAIGHT = r"straight |long |single |neat |whole "


def aisles(source: Source, parsed: Parsed) -> None:
    """Reads aisles of rows: what parts a block of them from front to back."""
    edits = Edits(source)
    rows = [one for one in parsed.arrangements if one.pattern in ROWS]
    for m in AISLE.finditer(source.text) if rows else ():
        if not re.search(r"middle|cent(?:re|er|ral)|between", m[0]) and rows[-1].pattern not in ("sides", "walls"):
            continue
        ahead = [one for one in rows if one.span is None or one.span.start <= source.span(m.start(), m.end()).start]
        told = (ahead or rows)[-1]
        k = parsed.arrangements.index(told)
        more = (*told.more, edits.take(m.start(), m.end()))
        parsed.arrangements[k] = told.model_copy(update={"aisle": width_of(m), "more": more})
        rows = [parsed.arrangements[k] if one is told else one for one in rows]


_FACING = re.compile(
    r",? ?\b(?:that |which |all |and )?(?:are )?(?:facing|face) (?:each other|one another)\b(?P<what>(?!))?"
)


def facing_rows(source: Source, parsed: Parsed) -> None:
    """Reads more than two things that face each other, where no pattern has them: two rows."""
    edits = Edits(source)
    for m in _FACING.finditer(source.text):
        noun = noun_before(source.text, m.start())
        if noun and source.text[: m.start()].endswith(noun) and noun not in {a.entity for a in parsed.arrangements}:
            _mutual(m, edits, parsed)


_OUTSIDE = re.compile(
    r"\b(?:all )?(?:on|along|around|round|at|to) the (?P<where>out|in)(?:side|ner side|er side|ner|er edge)s?"
    r"(?: of (?:the |this )?(?:u|horseshoe|tables|desks|it))?\b"
)
_OPEN = re.compile(
    r",? ?(?:and |with )?\b(?:the |its )?open (?:end|side|part)(?: of (?:the u|it))? ?(?:is )?"
    r"(?:to|towards?|facing|pointing (?:to|at|towards?)|points (?:to|at|towards?)|faces|looking at) (?:the |an? )?"
)


def horseshoes(source: Source, parsed: Parsed) -> None:
    """Reads of a U at which side of it people sit, and what it opens to."""
    curves = [one for one in parsed.arrangements if one.pattern in ("u", "semicircle")]
    edits = Edits(source)
    for m in _OPEN.finditer(source.text) if curves else ():
        noun, end = noun_after(source.text, m.end())
        told, k = curves[-1], parsed.arrangements.index(curves[-1])
        more = (*told.more, source.span(m.start(), end))
        curves[-1] = parsed.arrangements[k] = told.model_copy(update={"facing": noun, "more": more})
        edits.take(m.start(), m.end(), ", a ")
    for m in _OUTSIDE.finditer(source.text) if curves else ():
        noun = noun_before(source.text, m.start())
        if noun and noun != curves[-1].entity and _sits(noun):
            add(edits, parsed, m, "outside" if m["where"] == "out" else "inside", noun, around=curves[-1].entity)


def merged(parsed: Parsed) -> None:
    """One arrangement of "two rows of six, back to back", and of a U with what is said of its seats."""
    found: list[Arrangement] = []
    for one in parsed.arrangements:
        before = next((o for o in found if o.entity == one.entity and o.pattern in ("rows", "grid")), None)
        if one.pattern == "back_to_back" and before is not None:
            k = found.index(before)
            update = {"pattern": "back_to_back", "words": f"{before.words}, {one.words}"}
            found[k] = before.model_copy(update=update)
            continue
        found.append(one)
    parsed.arrangements[:] = found


__all__ = ["aisles", "facing_rows", "groups", "horseshoes", "merged"]
