"""Groups in words: at right angles, along both walls, one between each two, on all sides, head to head, in pairs.

They come before the plainer patterns of `arrangements`, which read what these leave.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

from sceneweaver.assets.taxonomy import category_named

from ..model import Arrangement
from ..parsed import Left, Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import family, mounts
from .aisles import AISLE, ROWS, WIDE, leads, width_of
from .arrangements import EACH_AROUND, GROUP, PLACED, add
from .lengths import PLAIN, plain_length
from .phrases import NUMBER, Edits, noun_after, noun_before, number_of, table_before

PAIRS = {"pairs": 2, "twos": 2, "threes": 3, "fours": 4, "couples": 2}

MOST_SIDES = 4

IN_ROW = 4
"""Things of a row by an aisle of which no number is said."""

FEW = 3
"""Things of a group of which no number is said."""

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
        lead = ", " if m[0].startswith(",") else ""  # what stands before it is a thing of its own
        add(edits, parsed, m, "between", noun, around=host, instead=f"{lead}{m['with'] or ''}{m['a']}{noun}")


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
    other = 0 if re.search(r"at (?:the|one) (?:head|end|short side)\b|at one", m[0]) else short
    table = table_before(text, m.start()) or "table"
    instead = f"{2 * long + short + other} {noun}"
    add(edits, parsed, m, "sides", noun, sides=(long, long, short, other), around=table, instead=instead)


def _mutual(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Chairs facing each other", more than two of them: in two rows; "across a table": with that between."""
    text = edits.source.text
    noun, others = _members(text, m.start())
    if m["what"] and re.search(r"\beach\b[^.;]{0,60}$", text[: m.start()]):
        parsed.unread.append(Left(m[0].strip(" ,"), span=edits.take(m.start(), m.end())))
        return  # those of each have theirs between them already, as they are at it
    if m["what"]:
        add(edits, parsed, m, "between", m["what"], around=noun, instead=f"{m['how']}{m['a']}{m['what']}")
    count = _count_of(noun, text, m.start()) if noun else 2
    if others or not noun or count == 2 or singular(noun) == noun or count % 2:
        return
    columns = 1 if m["what"] and not count else None
    if m["what"]:
        span, words = parsed.arrangements[-1].span, parsed.arrangements[-1].words
    else:
        span, words = edits.take(m.start(), m.end()), m[0].strip(" ,")
    told = Arrangement(entity=noun, pattern="rows", rows=2, columns=columns, facing="each other", words=words)
    parsed.arrangements.append(told.model_copy(update={"span": span}))


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
    several = not count and singular(noun) != noun
    several = several or (
        count > 1 and re.match(r",? ?(?:and )?looking out\b", edits.source.text[m.end() :]) is not None
    )
    if named and not others and (several or count >= 3 or (count and m["parted"] is not None)):
        add(edits, parsed, m, "row", noun, rows=1, columns=count or None)


def _row_of_some(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A row of lockers", "rows of pews": without a number."""
    noun, end = noun_after(edits.source.text, m.end())
    if not noun or match_of(singular(noun)).how == "generic":
        return
    many = m["rows"].endswith("s")
    if many:
        add(edits, parsed, m, "rows", noun, end=end, rows=number_of(m["n"]) if m["n"] else None)
    else:
        add(edits, parsed, m, "row", noun, end=end, rows=1)


def _bare_rows(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Twelve carrels, two rows of six": rows of what was named before."""
    noun = noun_before(edits.source.text, m.start())
    add(edits, parsed, m, "rows", noun, rows=number_of(m["n"]), columns=number_of(m["m"]))


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
    add(edits, parsed, m, "cluster", noun, groups=1, columns=count or None, instead=m["middle"] or "")


def _some_groups(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two groups of armchairs, each group around a low table": so many groups of a few."""
    text = edits.source.text
    noun, end = noun_after(text, m.end())
    if not noun or match_of(singular(noun)).how == "generic":
        return
    many, around = number_of(m["n"]), ""
    if each := EACH_AROUND.match(text, end):
        around, _ = noun_after(text, each.end("a"))
        edits.take(each.start(), each.end("a"), ", a ")
    add(edits, parsed, m, "cluster", noun, end=end, instead=str(FEW * many), groups=many, columns=FEW, around=around)


def _backs_first(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Desks back to back in two rows": what comes before the rows."""
    add(edits, parsed, m, "back_to_back", noun_before(edits.source.text, m.start()))


def _two_by_two(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Four tables two by two facing each other"."""
    noun = noun_before(edits.source.text, m.start())
    count = _count_of(noun, edits.source.text, m.start()) if noun else 0
    add(edits, parsed, m, "rows", noun, rows=2, columns=count // 2 or None)


def _parallels(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two islands parallel to each other": side by side, or behind each other if they are wider than deep."""
    noun = noun_before(edits.source.text, m.start())
    size = category_named(match_of(singular(noun)).category).size if noun else None
    count = _count_of(noun, edits.source.text, m.start()) if noun else 0
    if not count:
        return
    if size is not None and size.width[0] > size.depth[0]:
        add(edits, parsed, m, "rows", noun, rows=count, columns=1)
    else:
        add(edits, parsed, m, "row", noun, rows=1, columns=count)


def _left_and_right(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two bunks on the left wall and two on the right": so many at either side wall."""
    noun = m["noun"] or noun_before(edits.source.text, m.start())
    before = edits.source.text[: m.start()]
    if m["one"] == m["two"] or not noun or re.search(r"each other|one another", before):
        return
    numbers = number_of(m["n"]), number_of(m["m"])
    sides = numbers if m["one"] == "left" else numbers[::-1]
    named = re.search(rf"\b{re.escape(singular(noun))}(?:e?s)?\b", before)  # "two desks, one desk on the left ..."
    instead = f"{sum(numbers)} {m['noun']}" if m["noun"] and not named else ""
    add(edits, parsed, m, "walls", noun, sides=sides, around="wall:side", instead=instead)


def _by_an_aisle(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Pews on both sides of a central aisle"."""
    width = re.search(PLAIN, m[0])
    wide = plain_length(width[0]) if width else WIDE
    count = _count_of(m["noun"], edits.source.text, m.end())
    each = m["m"] or m["k"]
    if count and "either" in m[0]:
        return  # so many on either side
    columns = number_of(each) if each else count // 2 if count else IN_ROW
    add(edits, parsed, m, "rows", m["noun"], instead=m["noun"], rows=2, columns=columns, aisle=wide)


def _both_sides(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A long table and benches on both sides"."""
    text = edits.source.text
    table, noun = table_before(text, m.start()), m["noun"]
    if not table or not _sits(noun):
        return
    count = _count_of(noun, text, m.end())
    long = match_of(singular(noun)).category.endswith("bench")
    each = count // 2 if count else 1 if long else 2
    add(edits, parsed, m, "sides", noun, instead=noun, sides=(each, each), around=table)


def _full_wall(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A whole wall of shelves": side by side along one wall, over most of it."""
    noun, end = noun_after(edits.source.text, m.end())
    category = match_of(singular(noun)).category if noun else ""
    if noun and "floor" in mounts(category) and not re.match(r",? ?\w+ wide\b", edits.source.text[end:]):
        add(edits, parsed, m, "wall", noun, end=end)


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
        (
            rf"{PLACED}\b(?:(?:in|as) an? l(?:[ -]shape)? )?(?:along|against|on|lining|round|around) two "
            r"(?:adjacent |adjoining |neighbou?ring )?walls(?! of\b)",
            _two_walls,
        ),
        (
            r"(?P<how>,? ?\b(?:facing|face) (?:each other|one another) )(?:across|over|on either side of) "
            r"(?P<a>an? |the )"
            r"(?P<what>(?:[a-z-]+ ){0,2}?[a-z-]*(?:table|stove|fire|fireplace|desk|counter|chest|bench))\b"
            r"(?: (?:in )?between(?: them)?)?",
            _mutual,
        ),
        (rf"\b{_N} (?:small |separate |cosy |equal )?{GROUP} of (?!{NUMBER})", _some_groups),
        (rf"{PLACED},? ?\bback[ -]to[ -]back(?= (?:in|as)\b)", _backs_first),
        (rf"{PLACED},? ?\b(?:two by two|2 by 2|in two by two)\b", _two_by_two),
        (rf"{PLACED},? ?\bparallel(?: to (?:each other|one another))\b", _parallels),
        (
            r"\b(?:an? |one |the )?(?:(?:whole|entire|full|complete) )?wall (?:full )?of "
            rf"(?!{NUMBER}|the\b|glass\b|windows?\b)",
            _full_wall,
        ),
        (
            r",? ?\b(?:which |that )?(?:form|forms|forming|make|makes|making) (?:an? )"
            r"(?:l(?:[ -]shape)?|right angle|corner)\b(?! (?:room|desk|sofa|couch|table|unit))",
            _right_angle,
        ),
        (
            rf"\b(?P<n>{NUMBER})(?: {_NOUN})? (?:on|at|along|against|by|to) the (?P<one>left|right)"
            rf"(?:[- ]hand)?(?: wall| side)?,? (?:and |, ?)?(?P<m>{NUMBER})(?: (?P=noun))? "
            r"(?:on|at|along|against|by|to) the (?P<two>left|right)(?:[- ]hand)?(?: wall| side)?\b",
            _left_and_right,
        ),
        (
            r"\b(?P<noun>[a-z-]+) (?:on (?:both|either) sides? of|(?:to the )?left and right of) "
            rf"(?:an? |the )(?:central |middle |centre |center |wide )?(?:{PLAIN} )?(?:aisle|gangway|walkway)\b"
            rf"(?:,? (?:with )?(?P<m>{NUMBER}) (?:on|at|to) (?:each|either) side| with (?P<k>{NUMBER}) each)?",
            _by_an_aisle,
        ),
        (rf"\b(?P<noun>[a-z-]+) on both (?:long )?sides{_END}", _both_sides),
        (rf"{PLACED}\bperpendicular (?:to (?:each other|one another))", _right_angle),
        (
            rf",? ?\b(?P<with>with |and |)(?P<a>an? |one )(?P<noun>(?:[a-z-]+ ){{0,2}}?[a-z-]+)"
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
        (rf"{PLACED}\b(?:along|down) {which} (?:sides?|flanks?)\b(?! of\b)", _walls),
        (
            rf"\b(?P<m>{NUMBER}) {_NOUN} (?:on|at|along|to) (?:each|either|both|every) (?:of the )?(?:long )?sides?,? "
            rf"(?:and|plus|with) (?P<ends>{NUMBER}) (?:on|at) (?:each|either|both|the|every|one) (?:of the )?"
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
            rf"{PLACED}\b(?:lined up(?! in\b(?! front))|side by side|next to (?:each other|one another)|"
            r"shoulder to shoulder|in line|beside (?:each other|one another))\b"
            r"(?P<parted>(?= with (?:an?|one|the) [a-z -]*\bbetween\b))?",
            _many_beside,
        ),
        (
            rf"\b(?:(?P<n>{NUMBER}) |the |several )?(?:{_STRAIGHT})?(?P<rows>rows?|lines?|banks?) of (?!{NUMBER})",
            _row_of_some,
        ),
        (
            rf"[,;:] (?:in )?{_N} (?:{_STRAIGHT})?(?:rows|lines) of (?P<m>{NUMBER})(?: each)?"
            r"(?=\s*(?:$|[.,;)]|back\b|facing\b|with\b|and\b|along\b))",
            _bare_rows,
        ),
        (rf"{PLACED}(?P<stacked>,? ?\b(?:stacked|piled)(?: up)? )?\bin (?P<pairs>{'|'.join(PAIRS)})\b", _in_pairs),
        (
            rf"{PLACED}\b(?:pushed|shoved|put|joined) together\b"
            r"(?P<middle> in the (?:middle|centre|center))?"
            r"(?: (?:as|into|to form|to make|like) (?:one|an?) (?:(?:big|large|long|single) )*"
            r"(?:table|block|island|desk|unit))?",
            _pushed,
        ),
        (rf"{PLACED}\b(?:as|like) (?:free-?standing )?(?:islands?|an island)\b", _islands),
    )
    return tuple((re.compile(pattern), read) for pattern, read in rows)


_STRAIGHT = r"curved |tiered |raked |stepped |straight |long |single |neat |whole "


def aisles(source: Source, parsed: Parsed) -> None:
    """Reads aisles of rows: what parts a block of them from front to back."""
    edits = Edits(source)
    rows = [one for one in parsed.arrangements if one.pattern in ROWS]
    for m in AISLE.finditer(source.text) if rows else ():
        parted = rows[-1].aisle is not None or rows[-1].pattern in ("sides", "walls")
        if leads(source.text, m.end()) or not (parted or re.search(r"middle|cent(?:re|er|ral)|between", m[0])):
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
    r",? ?(?:and |with |that is |which is )?\b(?:(?:the |its )?open (?:end|side|part)(?: of (?:the u|it))? ?(?:is )?"
    r"|open(?:ing|s|ed)? (?=to\b|towards?\b|facing\b))"
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
    """One arrangement of "two rows of four, back to back", and of a U with what is said of its seats."""
    found: list[Arrangement] = []
    for one in parsed.arrangements:
        told = ("rows", "grid") if one.pattern == "back_to_back" else ("back_to_back",) if one.pattern == "rows" else ()
        before = next((o for o in found if o.entity == one.entity and o.pattern in told), None)
        if before is not None:
            rows = before if before.pattern != "back_to_back" else one
            more = tuple(span for o in (before, one) if o is not rows and o.span is not None for span in (o.span,))
            words = f"{before.words}, {one.words}"
            update = {"pattern": "back_to_back", "words": words, "more": (*rows.more, *more)}
            found[found.index(before)] = rows.model_copy(update=update)
            continue
        found.append(one)
    parsed.arrangements[:] = found


__all__ = ["aisles", "facing_rows", "groups", "horseshoes", "merged"]
