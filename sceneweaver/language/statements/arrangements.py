"""Arrangements in words: rows, grids, circles, groups, backs together, stacks, screens so many wide and high.

A pattern is said of a noun before or behind it. Where it says how many there are, that number takes its place in the
source, so that the clause grammar counts the things; what it says of where they are is blanked.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, get_args

from ..model import Arrangement, Pattern, Span
from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import family
from .aisles import ROWS, aisle_at, width_of
from .lengths import LENGTH, UNIT, length_of
from .phrases import NUMBER, Edits, noun_after, noun_before, number_of, table_before

_N, _M = rf"(?P<n>{NUMBER})", rf"(?P<m>{NUMBER})"
PLACED = (
    r"(?:,? ?(?:all |neatly )?"
    r"(?:laid out|set out|set up|arranged|laid|placed|lined up|standing|put|grouped|running|going) )?"
)
"""What may stand before the words of a pattern."""

_AREA = r"(?:grid|array|matrix|pattern|formation|raster)"
GROUP = r"(?:groups?|clusters?|pods?|sets?|bunches)"
_HEIGHTS = {"knee": 0.5, "waist": 1.0, "hip": 0.95, "chest": 1.25, "shoulder": 1.4, "head": 1.7}
"""Heights [m] that are named after a part of the body."""

ALL_WALLS = 8
"""Stacks that stand along all walls: two at each."""

_SPACED = re.compile(
    rf"\s*,?\s*(?:and |with |at )?(?:about |around |roughly |at least |a gap of |gaps of )*{LENGTH}"
    r"(?: of)?(?: clear| free| empty)?(?: space| gap| room| floor| gaps)? ?"
    r"(?:between (?:them|each other|each of them|each|one another|the rows|rows|neighbours)|apart(?: from each other)?)"
)
_FACING = re.compile(
    r"\s*,?\s*(?:and |all |both |with )?(?:(?:their |the )?fronts? )?(?:facing|looking at|turned to|towards?) "
    r"(?P<what>each other|one another)|\s*,?\s*face to face(?P<face>)"
)
_LOOKING = re.compile(
    r"\s*,?\s*(?:and |all |both |that |which )*(?:facing|looking (?:out )?(?:at|to|over|onto|of|through|towards?)|"
    r"(?:turned|oriented|pointed|pointing|directed) (?:to|towards?|at)|face|towards) (?:the |an? )?"
)
_LOOKING_OUT = re.compile(r"\s*,?\s*(?:and |all |both )*looking out(?:side|wards)?(?=\s*(?:$|[.,;)]|with\b|and\b))")
_IN_STACKS = re.compile(
    rf"\s*,?\s*(?:and )?(?:(?:in|into|as|making) )?(?P<n>{NUMBER}) (?:stacks?|piles?|towers?|columns?|heaps?)\b"
    r"(?: (?:next to|beside) (?:each other|one another)| side by side)?"
    rf"(?: of (?P<m>{NUMBER})(?: each)?)?(?:,? (?:each )?(?P<high>{NUMBER}) high)?"
)
_EACH_ROW = re.compile(
    rf"\s*,?\s*(?:with |of )?(?P<n>{NUMBER})(?: [a-z]+)? (?:in|per|to|on|at) (?:each|a|every|the)?"
    r"(?: ?(?:row|line|side|one)\b)?"
)
_AMID = re.compile(
    r"\s*,?\s*(?:with |and |around )?(?:an? |the )(?P<what>(?:[a-z-]+ ){0,2}?[a-z-]+)(?P<place> in (?:the|its) "
    r"(?:middle|centre|center)(?: of (?:it|them|the circle))?)"
)
_ABOUT = re.compile(r"\s*(?:around|round|about) (?:the |an? )?")
EACH_AROUND = re.compile(
    rf"\s*,?\s*(?:with )?(?:each|every)(?: {GROUP}| one)?(?: arranged| set)?(?: around| round| about| at) "
    r"(?P<a>an? |its own )"
)


def arrangements(source: Source, parsed: Parsed) -> None:
    """Reads how things are set out; see `Arrangement`."""
    edits = Edits(source)
    for pattern, read in _PATTERNS:
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                read(m, edits, parsed)


def add(
    edits: Edits,
    parsed: Parsed,
    m: re.Match[str],
    pattern: Pattern,
    noun: str,
    *,
    instead: str = "",
    end: int | None = None,
    blank: bool = True,
    **given: Any,
) -> bool:
    """Adds an arrangement of a noun, with what follows of spacing and facing; whether there is a noun.

    ``end`` is where the words of it end, from where spacing is looked for; ``instead`` takes the place of the match.
    """
    if not noun or pattern not in get_args(Pattern) or UNIT.match(noun):
        return False  # "a yard clear on either side" is no arrangement
    at = m.end() if end is None else end
    text = edits.source.text
    facing, spacing = "", given.pop("spacing", None)
    for _ in range(3):
        if pattern in ROWS and (way := aisle_at(text, at)):
            given["aisle"] = width_of(way)
            edits.take(way.start(), way.end())
            at = way.end()
        if spaced := _SPACED.match(text, at):
            spacing = length_of(spaced)[0]
            edits.take(spaced.start(), spaced.end())
            at = spaced.end()
        if faced := _FACING.match(text, at):
            facing = "each other"
            edits.take(faced.start(), faced.end())
            at = faced.end()
        elif out := _LOOKING_OUT.match(text, at):
            facing = "window"
            edits.take(out.start(), out.end())
            at = out.end()
        elif looks := _LOOKING.match(text, at):
            facing, at = noun_after(text, looks.end())
            break
    words = text[m.start() : max(at, m.end())].strip(" ,")
    short = re.compile(r"\s*w/ ").match(text, m.end())  # there is room now to write it out
    last, instead = (short.end(), f"{instead} with") if short and blank else (m.end(), instead)
    if blank:
        edits.take(m.start(), last, instead)
    span: Span = edits.source.span(m.start(), max(at, m.end()))
    said = Arrangement(entity=noun, pattern=pattern, spacing=spacing, facing=facing, words=words, span=span, **given)
    parsed.arrangements.append(said)
    return True


def _rows_of(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two rows of five racks"."""
    noun, end = noun_after(edits.source.text, m.end())
    rows, columns = number_of(m["n"]), number_of(m["m"])
    pattern: Pattern = "rows" if rows > 1 else "row"
    if m["kind"].startswith("column"):
        rows, columns = columns, rows
    add(edits, parsed, m, pattern, noun, end=end, instead=str(rows * columns), rows=rows, columns=columns)


def _in_rows(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Six wheels in two rows of three", "seats in two rows", "desks in rows"."""
    noun = noun_before(edits.source.text, m.start())
    rows = number_of(m["n"]) if m["n"] else None
    columns = number_of(m["m"]) if m["m"] else None
    end = m.end()
    if columns is None and (each := _EACH_ROW.match(edits.source.text, end)):
        columns, end = number_of(each["n"]), each.end()
        edits.take(each.start(), each.end())
    if m["kind"].startswith("column"):
        rows, columns = columns, rows
    add(edits, parsed, m, "rows", noun, end=end, rows=rows, columns=columns)


def _grid(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "15 mats in a 3 x 5 grid", "in a grid of 3 by 5", "a 4 x 3 grid of tiles"."""
    numbers = sorted(number_of(m[k]) for k in ("n", "m") if m[k])
    rows, columns = (numbers[0], numbers[1]) if len(numbers) == 2 else (None, None)
    if m.groupdict().get("of"):
        noun, end = noun_after(edits.source.text, m.end())
        count = str(rows * columns) if rows and columns else ""
        add(edits, parsed, m, "grid", noun, end=end, instead=count, rows=rows, columns=columns)
    else:
        noun = noun_before(edits.source.text, m.start())
        add(edits, parsed, m, "grid", noun, rows=rows, columns=columns)


def _in_row(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    add(edits, parsed, m, "row", noun_before(edits.source.text, m.start()), rows=1)


def _row_of(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A row of five hooks"."""
    noun, end = noun_after(edits.source.text, m.end())
    columns = number_of(m["n"])
    add(edits, parsed, m, "row", noun, end=end, instead=m["n"], rows=1, columns=columns)


def _curve(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Chairs in a circle", "in a semicircle around the stage", "in a u"."""
    shape = m["shape"].replace("-", "").replace(" ", "")
    pattern: Pattern = "circle" if shape in ("circle", "ring", "round") else "semicircle"
    if shape.startswith(("u", "horse")):
        pattern = "u"
    text = edits.source.text
    noun, around = noun_before(text, m.start()), ""
    if follows := _ABOUT.match(text, m.end()):
        around, _ = noun_after(text, follows.end())
    elif amid := _AMID.match(text, m.end()):
        around = amid["what"]
        edits.take(amid.start("place"), amid.end("place"))
    add(edits, parsed, m, pattern, noun, around=around)


def _curve_of(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A circle of eight chairs"."""
    noun, end = noun_after(edits.source.text, m.end())
    pattern: Pattern = "circle" if m["shape"] in ("circle", "ring") else "semicircle"
    if m["shape"].startswith(("u", "horse")):
        pattern = "u"
    follows = _ABOUT.match(edits.source.text, end)
    around = noun_after(edits.source.text, follows.end())[0] if follows else ""
    if m["n"] or (noun and match_of(singular(noun)).how != "generic"):
        add(edits, parsed, m, pattern, noun, end=end, instead=m["n"] or "", around=around)


def _backs(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    add(edits, parsed, m, "back_to_back", noun_before(edits.source.text, m.start()))


def _groups(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two groups of four armchairs, each around a small table", "armchairs in two groups of four"."""
    text = edits.source.text
    noun, end = noun_after(text, m.end())
    groups, size = number_of(m["n"]), number_of(m["m"])
    instead = str(groups * size)
    if not noun or m["in"]:
        noun, end, instead = noun_before(text, m.start()), m.end(), ""
    around = ""
    if each := EACH_AROUND.match(text, end):
        around, _ = noun_after(text, each.end("a"))
        edits.take(each.start(), each.end("a"), ", a ")
    add(edits, parsed, m, "cluster", noun, end=end, instead=instead, groups=groups, columns=size, around=around)


def _wide_and_high(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A wall of screens six wide and two high"."""
    columns, rows = number_of(m["n"]), number_of(m["m"])
    noun = m["noun"]
    if noun:
        instead = f"{rows * columns} {noun}"
        add(edits, parsed, m, "grid", noun, instead=instead, rows=rows, columns=columns, upright=True)


def _stack(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Boxes stacked to shoulder height", "three radios stacked"."""
    height = _HEIGHTS.get(m["body"] or "")
    if height is None and m["low"]:
        height = length_of(m)[0]
    rows = number_of(m["n"]) if m["n"] else None
    noun = noun_before(edits.source.text, m.start())
    walls = re.compile(r" ?(?:along|around|against) (?:all )?(?:of )?the walls\b").match(edits.source.text, m.end())
    groups, end = ALL_WALLS if walls else None, m.end()
    if told := _IN_STACKS.match(edits.source.text, end):
        groups, end = number_of(told["n"]), told.end()
        deep = told["m"] or told["high"]
        rows = number_of(deep) if deep and rows is None else rows
        edits.take(told.start(), told.end())
    add(edits, parsed, m, "stack", noun, end=end, rows=rows, height=height, groups=groups)


def _in_stacks(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Crates in four stacks of five", "in three piles, four high"."""
    rows = number_of(m["m"] or m["high"]) if m["m"] or m["high"] else None
    noun = noun_before(edits.source.text, m.start())
    add(edits, parsed, m, "stack", noun, rows=rows, groups=number_of(m["n"]))


def _stacks_of(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A stack of four crates", "two stacks of three boxes"."""
    noun, end = noun_after(edits.source.text, m.end())
    groups = 1 if m["n"] is None else number_of(m["n"])
    rows = number_of(m["m"])
    add(edits, parsed, m, "stack", noun, end=end, instead=str(groups * rows), rows=rows, groups=groups)


def _parallel(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Five parallel bins": one behind the other, their long sides along each other."""
    noun, end = noun_after(edits.source.text, m.end())
    if number_of(m["n"]) > 1:
        rows = number_of(m["n"])
        add(edits, parsed, m, "rows", noun, end=end, instead=m["n"], rows=rows, columns=1)


def _islands(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    noun, end = noun_after(edits.source.text, m.end())
    add(edits, parsed, m, "islands", noun, end=end, instead=m["n"])


def _each_side(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Six pews on each side of the aisle": a block of rows at either hand."""
    with_it = re.search(r"[a-z] with (?:the )?$", edits.source.text[: m.start()])
    if with_it and table_before(edits.source.text, m.start()):
        return  # "tables with three chairs on each side": the sides are theirs
    many = number_of(m["n"])
    instead = f"{2 * many} {m['noun']}"
    if family(match_of(singular(m["noun"])).category) == "bed_group" and "aisle" not in m[0]:
        add(edits, parsed, m, "walls", m["noun"], instead=instead, sides=(many, many), around="wall")
        return
    seat = family(match_of(singular(m["noun"])).category) == "seat" and not re.search("aisle|gangway|walkway", m[0])
    around = table_before(edits.source.text, m.start()) if seat else ""
    add(edits, parsed, m, "sides", m["noun"], instead=instead, sides=(many, many), around=around)


def _two_sides(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two chairs on one side of the table, one on the other"."""
    one, other = number_of(m["n"]), number_of(m["m"])
    instead = f"{one + other} {m['noun']}"
    around = (m["at"] or "").strip()
    if around in ("", "it"):
        around = table_before(edits.source.text, m.start()) or noun_before(edits.source.text, m.start())
    elif len(instead) + len(around) + 8 <= m.end() - m.start():
        instead += f" at a {around}"
    add(edits, parsed, m, "sides", m["noun"], instead=instead, sides=(one, other), around=around)


_NOUN = r"(?P<noun>[a-z][a-z'-]*(?: [a-z][a-z'-]*){0,2}?)"
_LINES = r"(?P<kind>rows|lines|ranks|columns)"
_STRAIGHT = r"(?:curved |tiered |raked |stepped |straight |parallel |long |equal |neat |staggered )?"

_PATTERNS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str], Edits, Parsed], None]], ...] = (
    (
        re.compile(
            rf"\b{_N} {_NOUN} on one side(?: of (?:the )?(?P<at>it|[a-z]+))?,? ?(?:and )?"
            rf"{_M}(?: (?P=noun)s?)? on the (?:other|opposite)(?: side)?\b"
        ),
        _two_sides,
    ),
    (
        re.compile(
            rf"\b{_N} {_NOUN} (?:on|at|to) (?:each|either) side"
            r"(?: of (?:the |an? )?(?:central |middle |centre |center )?"
            r"(?:aisle|gangway|walkway))?(?! of\b)(?=[^a-z]*(?:$|[.,)]|with\b|and\b|facing\b))"
        ),
        _each_side,
    ),
    (
        re.compile(
            rf"\b{_N} {_STRAIGHT}(?P<kind>rows|lines|ranks|columns|row) of {_M} "
            r"(?=[a-z])(?!(?:in|with|and|back|facing|on|along|each|at|standing|against|by|near|side|next|parallel)\b|w/)"
        ),
        _rows_of,
    ),
    (re.compile(rf"{PLACED}\b(?:in|into|as) {_N} {_STRAIGHT}{_LINES}(?: of {_M}(?: each)?)?\b"), _in_rows),
    (re.compile(rf"{PLACED}\bin {_STRAIGHT}{_LINES}(?: of {_M}(?: each)?)?\b(?P<n>(?!))?"), _in_rows),
    (re.compile(rf"\b(?:an? )?{_N} ?(?:x|by|×) ?{_M} {_AREA} (?P<of>of) "), _grid),
    (re.compile(rf"{PLACED}\b(?:in|on|as|into) an? (?:regular |tight )?{_N} ?(?:x|by|×) ?{_M} {_AREA}\b"), _grid),
    (
        re.compile(rf"{PLACED}\b(?:in|on|as|into) an? (?:regular |tight )?{_AREA}(?: of {_N} ?(?:x|by|×) ?{_M})?\b"),
        _grid,
    ),
    (
        re.compile(
            rf"\b(?:an? (?:wall|bank|array) of )?(?:{NUMBER} )?(?P<noun>[a-z][a-z'-]*)(?: wall)?,? "
            rf"{_N} wide(?:,| and| by| x)? {_M} (?:high|tall)\b"
        ),
        _wide_and_high,
    ),
    (re.compile(rf"\b(?:{PLACED}(?P<in>in|into) )?{_N} (?:small |equal )?{GROUP} of {_M}(?: each)?\b ?"), _groups),
    (re.compile(rf"\b(?:an? )(?:{_STRAIGHT})row of {_N} "), _row_of),
    (re.compile(rf"{PLACED}\b(?:in|as) (?:an?|one|a single) {_STRAIGHT}(?:row|line)\b(?! of)"), _in_row),
    (
        re.compile(
            rf"{PLACED}\b(?:in|as) an? (?:loose |wide |open |large |small )?"
            r"(?P<shape>semi-?circle|half[ -](?:circle|ring|moon)|crescent|arc|circle|ring|"
            r"u(?:[ -]shape)?|horseshoe(?: shape)?)\b"
        ),
        _curve,
    ),
    (
        re.compile(
            r"\b(?:an? |the )?(?:(?!half\b)[a-z]+ )?"
            r"(?P<shape>semi-?circle|half[ -](?:circle|ring|moon)|circle|ring|arc|u(?:[ -]shape)?|horseshoe) of "
            rf"(?:{_N} )?(?=[a-z])"
        ),
        _curve_of,
    ),
    (
        re.compile(
            rf",? ?\b(?:(?:{NUMBER} and {NUMBER}|in pairs|in twos|in two pairs|pairwise),? )?"
            r"(?:with (?:the|their) backs? (?:together|touching|to each other|to one another|against each other)"
            r"|back[ -]to[ -]back(?! with (?!each other|one another)))\b"
        ),
        _backs,
    ),
    (re.compile(rf"\b(?:an?|(?P<n>{NUMBER})) (?:stacks?|piles?) of {_M} (?=[a-z])"), _stacks_of),
    (
        re.compile(
            rf",? ?\b(?:stacked|piled)(?: up)?(?: (?P<n>{NUMBER}) high| (?:up )?to (?:about )?(?P<body>[a-z]+) height"
            rf"| (?:up )?to (?:about )?{LENGTH}(?: height| high)?)?(?: on (?:top of )?(?:each other|one another))?"
        ),
        _stack,
    ),
    (
        re.compile(
            rf"(?:,? ?\b(?:stacked|piled)(?: up)?)? ?\b(?:in|into|as) {_N} (?:stacks?|piles?|towers?)\b"
            rf"(?: of {_M}(?: each)?)?(?:,? (?:each )?(?P<high>{NUMBER}) high)?"
        ),
        _in_stacks,
    ),
    (re.compile(rf"\b{_N} parallel (?=[a-z])"), _parallel),
    (re.compile(rf"\b{_N} (?:free-?standing )?island (?=[a-z])"), _islands),
)
"""Each pattern with what reads it, in order: what the ones before it took is no more in the text."""

__all__ = ["arrangements"]
