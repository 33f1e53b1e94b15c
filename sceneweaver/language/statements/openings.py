"""Doors, windows and niches: in which wall, where on it, how wide and of what kind.

"Front door in the middle of one short wall, a window 1.8 m wide opposite" are two statements. The noun with its number
stays in the source, as the clauses may speak of it again ("a sideboard between them"); what is said of it goes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

from ..model import StatedOpening
from ..parsed import Parsed
from ..source import Source
from ..vocabulary import words
from .lengths import PLAIN, plain_length
from .phrases import one_of

_NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "a pair of": 2, "a row of": 3, "both": 2}
_COUNT = (
    r"(?:a pair of|a row of|row of|a single|single|one|two|three|four|five|six|\d{1,2}|an?\sadditional|an?\sextra|"
    r"(?:a|the)\s(?:second|third|further|other)|second|both|an?|the|another|its)\s"
)
_KNOWN = words("openings")
_KINDS = one_of([*_KNOWN["kinds"], *_KNOWN["plain"]]).replace(r"\ ", r"[\s-]")
_LISTED = one_of(["tall", "narrow", "small", "large", "big", "little", "slim", "old", "new", "round", "bright", "huge"])
"""Kinds that a comma may follow: any other is a place or the end of a measure, "at the back, double doors"."""

_HEAD = (
    r"(?P<part>doors?|doorways?|windows?|niches?|alcoves?|recess(?:es)?|chimney breasts?|chimneybreast|"
    rf"{one_of(_KNOWN['ways_in'])})"
    rf"(?!\s?-?{one_of(_KNOWN['not_behind'])}\b)"
)
_ODD = (
    rf"(?P<odd>(?!{one_of([*_KNOWN['before'], 'and', 'or', 'with'])}\s|{_KINDS}[\s,-]|{one_of(_KNOWN['ways_in'])}\b)"
    r"[a-z]+\s)?"
)
_PHRASE = re.compile(
    rf"(?<![a-z-])(?:(?P<count>{_COUNT}){_ODD})?(?:(?P<size>{PLAIN})\s?-?(?:wide|broad|big|large)?[\s-])?"
    rf"(?P<kinds>(?:(?:{_LISTED},|{_KINDS})[\s-]){{0,4}}){_HEAD}"
)
_BEFORE = re.compile(rf"\b(?P<word>{one_of(_KNOWN['before'])})\s$")
_AND_ONE = re.compile(
    r"\s?,?\s?(?:and\s|plus\s)?(?P<count>one|two|three|four|a single(?:\sone)?|another(?:\sone)?|a second(?:\sone)?|"
    r"the second(?:\sone)?|the other(?:\sone)?)\s(?P<kinds>)"
    r"(?=(?:is\s)?(?:in|on|at|opposite|across|facing|high|near)\b)"
)
_SIDES_WORD = (
    "left|right|lhs|rhs|far|back|rear|front|end|near|opposite|facing|other|long|longer|longest|short|shorter|shortest|"
    "narrow|ends|north|south|east|west|same|second|outer|outside|street"
)
_PLACE = re.compile(
    rf"\b(?:in|on|at|along|across|near|close to|by|into|to|set in|through)\s"
    rf"(?P<middle>(?:the\s|exact\s)*(?:middle|centre|center)\sof\s)?"
    rf"(?:the|one|a|an|its|each|both|either|that|two|three|all)?\s?(?:of\sthe\s)?"
    rf"(?P<side>{_SIDES_WORD}|{PLAIN})(?:[\s-]hand)?(?:\s(?P<more>{_SIDES_WORD}))?"
    r"(?:\s(?P<what>wall|walls|side|sides|end|ends|corner))?\b"
    r"(?!\sof\s(?:the|a|an|my|our|his|her|their|each)\s(?!room|hall))"
)
_BARE = re.compile(
    r"^\s*(?:(?:clear|free|opening|width|of|is|min|minimum|at least|about)\s){0,4}(?P<number>\d{2,4})"
    r"(?:\s(?:clear|wide|opening|free|minimum|min|or more))*\s*$"
)
_BOTH_ENDS = re.compile(
    r"\b(?:at|on|in)\s(?:each|both|either|opposite|the two)\s(?:of\sthe\s)?(?:short\s)?(?:(?P<end>ends?)|sides?)\b"
    r"(?!\s(?:walls?|of\s(?:an?|my|our|his|her|their|it|them|the\s(?!room|hall|shop|house|building|barn))))"
)
_EACH_SIDE = re.compile(r"\b(?:each|both|either)\s(?:of\sthe\s)?(?:two\s)?(?:long|short|narrow)")
_EACH_WALL = re.compile(r"\b(?:each|every|all(?:\sfour)?|all\sof\sthe)\s(?:walls?|sides?)\b")
_MIDDLE = re.compile(
    r"\b(?:in|at|on)\s(?:the\s)?(?:exact\s)?(?:middle|centre|center)(?:\sline)?\b|\bcent(?:red|ered)\b"
)
_CORNER = re.compile(
    r"\b(?:in|near|close to|at|by)\s(?:the|a|its|one)\s(?:(?P<side>left|right|far|near)\s)?corner\b"
    rf"(?:\s(?:of|in|on)\s(?:the|a|one|its)\s(?P<of>{_SIDES_WORD})\s(?:wall|side|end))?"
)
_WHOLE = re.compile(
    r"\b(?:from\s)?(?:wall to wall|end to end|the (?:full|whole|entire) (?:width|length)|(?:full|whole) width)\b"
)
_PAIR = re.compile(r"\s(?:of\s|about\s|only\s|is\s|measuring\s){0,2}(?P<sides>§\s*)")
_UP = re.compile(
    r"\b(?:set\s|placed\s|very\s|quite\s|fairly\s)?(?:high up(?:\sin\sthe\swall)?|up high|high (?=on the|in the)|"
    r"(?:just\s)?(?:near|under|below) the ceiling|at the top of the wall|above (?:eye|head) (?:level|height))\b"
)
_OPENS = re.compile(
    r"\b(?:(?:that|which|it|and|but|must|should|may|can|does|do|has to|to|is)\s){0,3}"
    r"(?P<never>(?:not|never|no|mustn't|shouldn't|can't|cannot|doesn't)\s(?:to\s|be\s)?)?"
    r"(?:opens?|opening|swings?|swinging)\s(?:to the\s)?"
    r"(?P<way>outwards?|out|outside|inwards?|into the room|in)\b"
)
_SLIDES = re.compile(r"\b(?:(?:that|which)\s)?(?:slides|slides? (?:open|aside)|sliding)\b")
_TAIL = re.compile(rf"\bwith\s(?:an?\s)?(?:[a-z]+\s)?(?P<tail>{one_of(_KNOWN['tails'])})\b(?!\s(?:at|of)\s\d)")
_OPPOSITE = re.compile(
    r"\b(?:(?:in|on)\sthe\swall\s)?(?:directly\s|right\s)?(?:opposite|across from|across)\b(?:\s(?:of|to|from))?"
    r"(?:\s(?:it|each other|(?:the\s)?(?P<what>door|window|entrance)))?(?!\s[a-z])"
)
_WIDE = re.compile(
    rf"(?P<width>{PLAIN})\s?(?:wide|broad|across|in width)|wide,?\s(?:at least\s)?(?P<after>{PLAIN})"
    rf"|\b(?:(?:clear|free)\s)?(?:opening|width)\s(?:(?:of|is|at least|about)\s){{0,2}}(?P<opening>{PLAIN})"
    rf"|(?P<clear>{PLAIN})\s(?:(?:clear|free)\s)(?:opening|width)\b"
)
_HIGH = re.compile(rf"(?P<height>{PLAIN})\s?(?:high|tall|in height)")
_DEEP = re.compile(rf"(?P<depth>{PLAIN})\s?(?:deep|in depth)")
_SILL = re.compile(
    rf"\bsill\s(?:at|of|height|is)?\s?(?P<sill>{PLAIN})|(?P<above>{PLAIN})\s(?:above|off|from) the floor"
)
_LEADS = r"(?:(?:that\s|which\s)?(?:leading|leads|going|goes|giving|opening|opens)\s(?:out\s|through\s)?)"
_TO = re.compile(
    rf"\b(?:{_LEADS}?(?:to|into|onto|leading to)\s(?:the|a|an|our|his|her)\s"
    rf"(?P<where>{one_of([*_KNOWN['outside'], *_KNOWN['rooms']])})"
    rf"|{_LEADS}(?:to|onto)\s(?:the|a|an)\s"
    r"(?P<any>(?!left|right|inside)[a-z]+(?:\s(?:room|store|shop|hall|area|yard))?))\b"
)
_GLASS = re.compile(
    r"\b(?P<kind>coloured|colored|stained|leaded|frosted|painted)[\s-]glass\s(?:in|for|on)\s(?:the\s|all\s|its\s)*"
    r"(?:side\s|big\s|front\s)?windows?\b"
)
_DOOR_TO = re.compile(rf"\bdoors?\s{_TO.pattern}")
_REST = re.compile(r"^(?:[^.,()]|[.,](?=\d)){0,120}")
_STOP = re.compile(
    rf"\b(?:and|with(?!\s(?:an?\s)?(?:[a-z]+\s)?{one_of([*_KNOWN['tails'], 'sill'])}\b)|for|so that|so|"
    r"(?:that|which)(?!\s(?:must\s|should\s|has to\s)?(?:opens?|swings?|slides?)\b)|where|but|because|while|"
    r"who|whose)\b"
)
_PANES = re.compile(
    r"\b(?:glass|glazing|glazed|windows)\s(?:on|along|at)\s(?P<many>two|three|four|all|both)\s(?:of\sits\s)?"
    r"(?:sides|walls)\b"
)
_FRONT = re.compile(
    r"\b(?:(?:a|the|one|its)\s)?(?:(?:fully|all|big|large|full)\s)?(?:glass|glazed)\s(?:shop\s)?"
    r"(?:front|facade|façade|wall|end)\b"
    r"|\b(?:one|the|a)\s(?:whole\s|entire\s)?"
    r"(?P<side>long|short|far|left|right|front|back|south|north|east|west|street)?\s?"
    r"(?:side|wall|end|front)\s(?:is|being|of|in|made of)\s(?:all\s|entirely\s|fully\s|only\s"
    r"|floor to ceiling\s)?glass\b"
)
_WALLS_OF = {"long": "long", "short": "short", "far": "far", "back": "far", "left": "left", "right": "right"} | {
    side: side for side in ("south", "north", "east", "west")
}
_WINDOWLESS = re.compile(
    r"\b(?:windowless|(?:has |have |with |gets |get |see |sees )?(?:no|without(?:\sany)?)\s(?:natural\s)?(?:daylight|"
    r"natural light|light from outside)(?:\s(?:at all|anywhere|please|whatsoever))*(?!\s(?:bulb|lamp|tube)s?\b)|"
    r"(?:has|have|had|with)\s(?:got\s)?no\swindows?\b(?!\s[a-z]+\s)|there(?:'s| is| are)\sno\swindows?|"
    r"(?:no|without(?:\sany)?)\swindows?(?:\s(?:at all|anywhere|please))?(?=\s?(?:[.,;)]|$|\band\b|\bbut\b)))"
)
_LONG = {"long": "long", "longer": "long", "longest": "long"}
_SHORT = {"short": "short", "shorter": "short", "shortest": "short", "narrow": "short", "end": "short", "ends": "short"}
_SEEN = {"left": "left", "right": "right", "lhs": "left", "rhs": "right", "far": "far", "back": "far", "rear": "far"}
_SEEN |= {"near": "near", "front": "near"}
_COMPASS = ("north", "south", "east", "west")
_SIDE_DOORS = {"side": "side", "back": "far", "rear": "far"}
"""Walls of doors that are named so, as seen by who comes in by another."""


@cache
def _apart() -> re.Pattern[str]:
    """What says that openings are in walls of their own: "no two on the same wall", "each in a different wall"."""
    walls = r"(?:in|on|through)\s"
    return re.compile(
        rf"\bno\stwo(?:\sof\sthem)?\s{walls}(?:the\ssame|one)\s(?:(?:bit|piece|stretch|part|run)\sof\s)?walls?\b"
        rf"|\b(?:each|all|every one|one)?(?:\sof\sthem|\sone)?\s?{walls}(?:a\sdifferent|different|its\sown|a\sseparate|"
        r"separate|another)\swalls?\b|\bone\s(?:in|on)\s(?:each|every)\swall\b"
    )


@dataclass
class _Told:
    """What was recognised of an opening, and the characters that said it."""

    fields: dict[str, Any]
    taken: list[tuple[int, int]]


def read_openings(source: Source, parsed: Parsed) -> None:
    """Reads statements about parts of the shell; the words about them are blanked, their nouns stay."""
    text = source.text
    blanks: list[tuple[int, int]] = []
    if (found := _WINDOWLESS.search(text)) is not None:
        parsed.openings["window"] = 0
        parsed.referred.append(source.span(*found.span()))
        blanks.append(found.span())
    source.text = text = _ways_in(source, parsed, blanks)
    for match in _PHRASE.finditer(text):
        if any(a < match.end() and match.start() < b for a, b in blanks):
            continue
        stated, taken = _stated(source, match, parsed.stated_openings)
        parsed.stated_openings += stated
        if stated:
            parsed.openings.setdefault(stated[0].part, 0)
        blanks += taken
    for match in _PANES.finditer(text):
        many = {"two": 2, "both": 2, "three": 3}.get(match["many"], 4)
        span = source.span(match.start(), match.end())
        parsed.stated_openings.append(
            StatedOpening(part="window", count=many, at="along", features=("glass",), words=match[0], span=span)
        )
        blanks.append((match.start(), match.end()))
    for match in _FRONT.finditer(text):
        span, wall = source.span(match.start(), match.end()), _WALLS_OF.get(match["side"] or "", "any")
        parsed.stated_openings.append(
            StatedOpening(
                part="window",
                wall=cast(Any, wall),
                at="along",
                features=("glass", "floor to ceiling"),
                words=match[0],
                span=span,
            )
        )
        blanks.append((match.start(), match.end()))
    for match in _GLASS.finditer(text):
        span, kind = source.span(match.start(), match.end()), match["kind"].replace("colored", "coloured")
        parsed.stated_openings.append(
            StatedOpening(part="window", features=(f"{kind} glass",), words=match[0], span=span)
        )
        blanks.append((match.start(), match.end()))
    _doors_to(source, parsed)
    for part in ("door", "window"):
        stated = [s for s in parsed.stated_openings if s.part == part]
        if stated:
            beyond = part == "door" and all(map(_is_another, stated))
            count = sum(s.count for s in stated) + beyond  # one comes in by a door of which nothing is said
            parsed.openings[part] = max(parsed.openings.get(part, 0), count)
    source.text = _blanked(text, blanks)


_IN_AND_OUT = re.compile(
    r"\b(?:in|enter|enters|entering|come in|entrance|way in|entry)\s(?:is\s|comes\s)?(?:by|through|at|on|via|from)?\s?"
    r"the\s(?P<in>left|right|front|back)(?:[\s-]hand)?(?:\s(?:door|side|end|doorway))?[\s,.]+(?:and\s|then\s)?"
    r"(?:out|leave|leaves|leaving|go out|exit|way out)\s(?:is\s)?(?:by|through|at|on|via|from)?\s?the\s"
    r"(?P<out>left|right|front|back|other)(?:[\s-]hand)?(?:\s(?:door|side|end|doorway|one))?\b"
)
"""Two doors that look at each other: one comes in by one of them and goes out by the other."""


def _ways_in(source: Source, parsed: Parsed, blanks: list[tuple[int, int]]) -> str:
    """What is said of ways in without the word for a door, or against it; the text without it."""
    text = source.text
    for m in _IN_AND_OUT.finditer(text):
        first = StatedOpening(part="door", words=" ".join(m[0].split()), span=source.span(*m.span()))
        name = f"opening-{len(parsed.stated_openings)}"
        parsed.stated_openings += [first, first.model_copy(update={"opposite": name})]
        blanks.append(m.span())
    for m in _NONE_OF.finditer(text):
        if m["kinds"] or m["to"]:  # such a door is never there unasked
            parsed.referred.append(source.span(*m.span()))
            blanks.append(m.span())
    for m in _gates().finditer(text):
        said, what = " ".join(m[0].split()), m["what"] or m["at"] or m["to"]
        parsed.stated_openings.append(
            StatedOpening(part="door", features=(what,), words=said, span=source.span(*m.span()))
        )
        blanks.append(m.span())
    return _blanked(text, blanks)


@cache
def _gates() -> re.Pattern[str]:
    """What closes the way in where that is no door: "an iron gate, not a door", "a grille at the entrance"."""
    gate = one_of(_KNOWN["gates"])
    out = one_of(["street", "yard", "road", "field", "courtyard", "alley", "lane", "drive"])
    return re.compile(
        rf"\b(?:an?\s|the\s)?(?:(?P<what>{gate}),?\s{one_of(_KNOWN['instead'])}\s(?:an?\s|the\s)doors?\b"
        rf"|(?P<at>{gate})\s(?:at|in|across|for|as)\s(?:the|an)\s(?:entrance|doorway|way in|entry)\b"
        r"|(?P<to>(?:roller|sectional|iron|steel|wooden|sliding)\s(?:gate|shutter))"
        rf"(?:\s(?:to|onto)\s(?:the|a)\s{out})?\b)"
    )


_NONE_OF = re.compile(
    rf"\b(?:no|without(?:\s(?:an?|any))?)\s(?P<kinds>(?:{_KINDS}[\s-]){{0,3}})doors?\b"
    rf"(?!\s?-?{one_of(_KNOWN['not_behind'])}\b)(?P<to>\s{_TO.pattern})?"
)
"""Doors of a kind, or to some place, that are not wanted."""

_PLACED: dict[str, set[str]] = dict.fromkeys(("entrance", "entrances"), {"wall", "opposite"})
"""Ways in that are doors where their wall is said as well; a hatch in a wall may be one to serve through."""

_EACH_OTHER = re.compile(
    r"\b(?:opposite|facing|across from)\s(?:each other|one another)\b|\b(?:at|on|in) opposite (?:ends|walls|sides)\b"
)
"""What puts two openings in walls that look at each other."""

_ALONG = {"full width", "wall to wall", "full length"}
"""Kinds that run along their wall."""


def _is_another(one: StatedOpening) -> bool:
    """Whether a door is told as one beside that by which one comes in."""
    return any(f.startswith("to the ") or f in _KNOWN["another"] for f in one.features)


def _stated(
    source: Source, match: re.Match[str], before: list[StatedOpening]
) -> tuple[list[StatedOpening], list[tuple[int, int]]]:
    """What a noun and what goes on from it say of openings, and the characters to blank; none where that is nothing."""
    text, determiner = source.text, (match["count"] or "").strip()
    kinds, part = _kinds(match["kinds"]), _part(match["part"])
    told = _told(text, match.end(), len(before))
    pair = _PAIR.match(text, match.end())
    if pair is not None and part in ("niche", "breast"):
        _take_sides(source, pair.span("sides"), part, told)
    if _is_reference(text, match, kinds, part, before, told.fields):
        return [], []
    if pair is not None:
        _take_sides(source, pair.span("sides"), part, told)
    if match["size"]:
        told.fields.setdefault("width", plain_length(match["size"]))
        told.taken.append(match.span("size"))
    if determiner.endswith(("second", "third", "further", "other", "another", "additional", "extra")):
        kinds = (*kinds, "another") if part == "door" else kinds
    way_in = match["part"] in _KNOWN["ways_in"]
    if _ALONG & set(kinds):
        told.fields.setdefault("at", "along")
    rest = re.match(r"[^.,;()]*", text[match.end() :])
    mutual = determiner == "two" and rest is not None and _EACH_OTHER.search(rest[0]) is not None
    counted = part in ("door", "window") and bool(match["count"])
    goes_on = mutual or (counted and _AND_ONE.match(text, match.end()) is not None)
    if (
        not (told.fields or goes_on)
        and (not kinds or (kinds == ("another",) and part == "window"))
        or (way_in and not ({"height", "width"} | _PLACED.get(match["part"], set())) & told.fields.keys() and not kinds)
    ):
        return [], []
    count = _count(match["count"], match["part"])
    if (
        match["part"] == "doors"
        and determiner in ("", "the", "its")
        and {"double", "sliding", "french", "patio", "swing", "swinging"} & set(kinds)
    ):
        count, kinds = 1, tuple(dict.fromkeys((*kinds, "double")))  # two leaves
    found: list[StatedOpening] = []
    last = match.start("count") if match["count"] else match.start("kinds")
    end = max([end for _, end in told.taken], default=match.end())
    bay = {"bay", "bow"} & set(kinds)  # "the bay window" is a place with a name of its own
    taken = [*([] if bay or part in ("niche", "breast") else [match.span("kinds")]), *told.taken]

    def add(count: int, told: _Told, start: int, end: int, kinds: tuple[str, ...] = kinds) -> None:
        fields = dict(told.fields)
        features = tuple(dict.fromkeys((*kinds, *fields.pop("features", ()))))
        if part == "door" and "wall" not in fields and not fields.get("opposite"):
            side = next((wall for word, wall in _SIDE_DOORS.items() if word in features), None)
            fields |= {"wall": side} if side is not None else {}
        span, said = source.span(start, end), " ".join(text[max(start, match.start("kinds")) : end].split())
        if pair is not None and "width" in fields:
            said = said.replace("§", f"{fields['width']:g} x {fields.get('height', fields.get('depth', 0)):g} m")
        one = StatedOpening(part=cast(Any, part), count=count, features=features, words=said, span=span, **fields)
        found.append(one)

    if mutual and rest is not None and (m := _EACH_OTHER.search(rest[0])) is not None:
        start, end = match.end() + m.start(), max(end, match.end() + m.end())
        taken.append((start, match.end() + m.end()))
        told.fields.pop("opposite", None)
        add(1, told, last, end)
        add(1, _Told({"opposite": f"opening-{len(before)}"}, []), last, end)
        return found, taken
    add(count, told, last, end)
    told_so_far = [*before, *found]
    several = _on_the_others(text[match.end() : end], told_so_far)
    found[-1] = told_so_far[-1]
    while not several and (more := _AND_ONE.match(text, end)) is not None:
        next_told = _told(text, more.end(), len(before) + len(found))
        if not next_told.fields:
            break
        end = max(b for _, b in next_told.taken)
        alone = tuple(k for k in kinds if k != "double") if "single" in more["count"] else kinds
        add(_NUMBERS.get(more["count"], 1), next_told, more.start("count"), end, alone)
        taken += [more.span(), *next_told.taken]
    if len(found) > 1 and not told.fields and sum(one.count for one in found[1:]) == count:
        if found[1].opposite.startswith("opening-"):
            found[1] = found[1].model_copy(update={"opposite": ""})
        shift = {f"opening-{len(before) + k}": f"opening-{len(before) + k - 1}" for k in range(1, len(found))}
        found = [one.model_copy(update={"opposite": shift.get(one.opposite, one.opposite)}) for one in found[1:]]
    return [*found, *several], taken


def _take_sides(source: Source, span: tuple[int, int], part: str, told: _Told) -> None:
    """The two sides that stand behind a noun: width and height of an opening, width and depth of a niche."""
    sides = source.sides.pop(span[0], None)
    if sides is not None:
        told.fields.setdefault("width", sides[0])
        told.fields.setdefault("height" if part in ("door", "window") else "depth", sides[1])
        told.taken.append(span)


def _is_reference(
    text: str,
    match: re.Match[str],
    kinds: tuple[str, ...],
    part: str,
    before: list[StatedOpening],
    fields: dict[str, Any],
) -> bool:
    """Whether a noun only names an opening that something else is at: "a bench under the long window"."""
    determiner = (match["count"] or "").strip()
    preposition = _BEFORE.search(text[: match.start()])
    sentence = re.split(r"[.;(]", text[: match.start()])[-1]
    joined = sentence.rstrip().endswith(" and") and re.search(r"\bbetween\b[^,]*$", sentence) is not None
    if preposition is None and not joined:
        return False
    if part in ("niche", "breast") and fields:
        return False  # "a bench in the recess opposite the door"
    if not joined and fields.keys() & {"width", "height", "sill"} and determiner in ("a", "an", "one", "two", "three"):
        return False
    told = set(kinds) - set(_KNOWN["usual"])
    if joined or not told or preposition is not None and preposition["word"] in ("to", "of", "from", "no", "without"):
        return determiner in ("the", "its", "both", "") or joined or not kinds
    return any(one.part == part and told <= set(one.features) for one in before)


def _on_the_others(said: str, stated: list[StatedOpening]) -> list[StatedOpening]:
    """The same opening in the other wall of two ("on each short side"), or in the three others ("in every wall")."""
    last, own = stated[-1], f"opening-{len(stated) - 1}"
    if _EACH_SIDE.search(said) and last.wall in ("long", "short"):
        return [last.model_copy(update={"wall": "any", "opposite": own})]
    if _BOTH_ENDS.search(said) and last.wall in ("long", "short") and last.part in ("door", "window"):
        stated[-1] = last.model_copy(update={"count": 1})
        return [stated[-1].model_copy(update={"wall": "any", "opposite": own})]
    if "apart" in last.features and last.count > 1:
        stated[-1] = last.model_copy(update={"count": 1})
        return [stated[-1]] * (last.count - 1)
    if _EACH_WALL.search(said):
        stated[-1] = last.model_copy(update={"wall": "left"})
        return [last.model_copy(update={"wall": wall}) for wall in ("right", "far", "near")]
    return []


def _told(text: str, at: int, number: int) -> _Told:
    """What stands after a noun: its own clause up to a word that begins another, and clauses that only go on."""
    told, first = _Told({}, []), True
    while True:
        rest = _REST.match(text[at:])
        clause = rest[0] if rest else ""
        stop = _STOP.search(clause)
        clause = clause[: stop.start()] if stop else clause
        fields = dict(told.fields)
        spans = _fields(clause, number, fields)
        # A clause after a comma goes on only where nothing but places and measures is in it.
        left = _blanked(clause, spans)
        if not first and re.sub(r"\b(?:at|least|the|a|just|about|wide|must|be|is|set|with)\b|\W", "", left):
            break
        told.fields = fields
        told.taken += [(at + a, at + b) for a, b in spans]
        at += len(clause)
        if stop or text[at : at + 1] != ",":
            break
        at, first = at + 1, False
    return told


def _fields(clause: str, number: int, fields: dict[str, Any]) -> list[tuple[int, int]]:
    spans: list[tuple[int, int]] = []
    for pattern, name in ((_WIDE, "width"), (_HIGH, "height"), (_SILL, "sill"), (_DEEP, "depth")):
        if (m := pattern.search(clause)) and name not in fields:
            value = next(g for g in m.groups() if g)
            fields[name] = plain_length(value)
            spans.append(m.span())
    if "width" not in fields and (m := re.search(rf"^\s*(?:of\s|about\s|at least\s|is\s)*({PLAIN})\s*$", clause)):
        fields["width"] = plain_length(m[1])
        spans.append(m.span(1))
    if "width" not in fields and (m := _BARE.search(clause)) is not None:
        number = int(m["number"])
        if 60 <= number <= 300 or 600 <= number <= 3000:  # as builders write it: "door 90", "door 900"
            fields["width"] = number / (100 if number <= 300 else 1000)
            spans.append(m.span())
    if m := _BOTH_ENDS.search(clause):
        fields.setdefault("wall", "short" if m["end"] else "long")
        spans.append(m.span())
    if m := _apart().search(clause):
        fields["features"] = (*fields.get("features", ()), "apart")
        spans.append(m.span())
    if m := _WHOLE.search(clause):
        fields.setdefault("at", "along")
        spans.append(m.span())
    if m := _CORNER.search(clause):
        fields.setdefault("at", m["side"] if m["side"] in ("left", "right") else "corner")
        for word in (m["of"],) if m["of"] else ():
            _wall_of(word, "wall", fields)
        spans.append(m.span())
    features: list[str] = []
    for pattern, feature in ((_UP, "high up"), (_OPENS, ""), (_SLIDES, "sliding"), (_TAIL, "")):
        if m := pattern.search(clause):
            told = m.groupdict()
            outward = str(told.get("way")).startswith("out") != bool(told.get("never"))
            way = "outward" if outward else "inward"
            features.append(feature or _KNOWN["tails"].get(told.get("tail"), "") or way)
            spans.append(m.span())
    for m in _PLACE.finditer(clause):
        if any(a < m.end() and m.start() < b for a, b in spans):
            continue
        if _placed(m, number, fields):
            spans.append(m.span())
    if (m := re.search(rf"\b(?:in|on)\s{_EACH_WALL.pattern}", clause)) is not None:
        fields.setdefault("wall", "any")
        spans.append(m.span())
    m = _MIDDLE.search(clause)
    if m is not None and not any(a < m.end() and m.start() < b for a, b in spans):
        fields.setdefault("at", "middle")
        spans.append(m.span())
    m = _OPPOSITE.search(clause) if "opposite" not in fields and "wall" not in fields else None
    if m is not None and (m["what"] or number):
        fields["opposite"] = {"entrance": "door"}.get(m["what"] or "", m["what"] or f"opening-{number - 1}")
        spans.append(m.span())
    if m := _TO.search(clause):
        features.append(f"to the {m['where'] or m['any']}")
        spans.append(m.span())
    if features:
        fields["features"] = tuple(dict.fromkeys((*fields.get("features", ()), *features)))
    return spans


def _placed(m: re.Match[str], number: int, fields: dict[str, Any]) -> bool:
    """Takes one place: a wall by its length or side, the wall across from another opening, or a corner."""
    side, more = m["side"], m["more"]
    what = m["what"] or ("end" if more == "end" else "")
    if m["middle"]:
        fields.setdefault("at", "middle")
    if what == "corner":
        fields.setdefault("at", side if side in ("left", "right") else "corner")
    elif side in ("opposite", "other", "facing", "second") and number:
        fields.setdefault("opposite", f"opening-{number - 1}")
    elif _wall_of(side, what, fields):
        if side in _SEEN and "across" in m[0].split()[:1]:
            fields.setdefault("at", "along")
        if more:
            _wall_of(more, what or "wall", fields)
    elif re.fullmatch(PLAIN, side) and what in ("wall", "walls", "side", "sides"):
        fields.setdefault("wall_length", plain_length(side))
    elif side == "same" and what:
        fields["features"] = (*fields.get("features", ()), "same wall")
    else:
        return bool(m["middle"]) or (side in ("outer", "outside", "street") and bool(what))
    return True


def _wall_of(side: str, what: str, fields: dict[str, Any]) -> bool:
    """Takes a wall by its length, its side or both ("the far short wall"); whether the word names one."""
    if side == "end" and not what:  # "at the end": of the way that one comes in
        fields.setdefault("wall", "far")
    length = "long" if side in _LONG else "short" if side in _SHORT else None
    name = _SEEN.get(side) or (side if side in _COMPASS else None)
    if length is not None:
        fields.setdefault("wall" if "wall" not in fields else "run", length)
    elif name is not None:
        if fields.get("wall") in ("long", "short") and "run" not in fields:
            fields["run"] = fields.pop("wall")
        fields.setdefault("wall", name)
    return length is not None or name is not None


def _doors_to(source: Source, parsed: Parsed) -> None:
    """A door that leads to a named place is one of its own, whether or not more is said of it."""
    for m in _DOOR_TO.finditer(source.text):
        span = source.span(m.start(), m.end())
        known = next((s for s in parsed.stated_openings if s.span and s.span.start <= span.start < s.span.end), None)
        feature = f"to the {m['where'] or m['any']}"
        if known is None:
            if any(feature in s.features for s in parsed.stated_openings):
                continue
            parsed.stated_openings.append(StatedOpening(part="door", features=(feature,), words=m[0], span=span))
        elif feature not in known.features:
            at = parsed.stated_openings.index(known)
            parsed.stated_openings[at] = known.model_copy(update={"features": (*known.features, feature)})


def _kinds(words_before: str) -> tuple[str, ...]:
    """The kinds that make a difference to what is drawn or checked."""
    found = (
        word.replace("-", " ").replace("colored", "coloured")
        for word in re.findall(rf"{_KINDS}(?![a-z])", words_before)
    )
    means = _KNOWN["means"]
    return tuple(dict.fromkeys(k for word in found if word not in _KNOWN["plain"] for k in means.get(word, [word])))


def _part(word: str) -> str:
    if word.startswith(("niche", "alcove", "recess")):
        return "niche"
    if word.startswith("chimney"):
        return "breast"
    return "window" if word.startswith("window") else "door"


def _count(determiner: str | None, noun: str) -> int:
    said = (determiner or "").strip()
    if said.isdigit():
        return max(1, min(int(said), 20))
    if said.endswith(("second", "third", "further", "other", "additional", "extra")):
        return 1
    return _NUMBERS.get(said, 2 if noun.endswith("s") and noun != "recess" and not said.startswith("a ") else 1)


def _blanked(text: str, spans: list[tuple[int, int]]) -> str:
    for start, end in spans:
        text = text[:start] + " " * (end - start) + text[end:]
    return text


__all__ = ["read_openings"]
