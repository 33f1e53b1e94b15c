"""Doors, windows and niches: in which wall, where on it, how wide and of what kind.

"Front door in the middle of one short wall, a window 1.8 m wide opposite" are two statements. The noun with its number
stays in the source, as the clauses may speak of it again ("a sideboard between them"); what is said of it goes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, cast

from ..model import StatedOpening
from ..parsed import Parsed
from ..source import Source
from ..vocabulary import words
from .lengths import PLAIN, plain_length
from .phrases import one_of

_NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "a pair of": 2, "a row of": 3}
_COUNT = r"(?:a pair of|a row of|row of|a single|single|one|two|three|four|five|six|\d{1,2}|an?|the|another|its)\s"
_KNOWN = words("openings")
_KINDS = one_of([*_KNOWN["kinds"], *_KNOWN["plain"]]).replace(r"\ ", r"[\s-]")
_HEAD = (
    r"(?P<part>doors?|doorways?|windows?|niches?|alcoves?)"
    rf"(?!\s?-?{one_of(_KNOWN['not_behind'])}\b)"
)
_PHRASE = re.compile(
    rf"(?P<lead>^|[.,(]\s*|\b(?:and|with|has|have|plus|there is|there are|is there|want|need|by its)\s)"
    rf"(?P<count>{_COUNT})?(?:(?P<size>{PLAIN})\s?-?(?:wide|broad|big|large)?[\s-])?(?P<kinds>(?:{_KINDS},?[\s-]){{0,4}}){_HEAD}"
)
_SIDES_WORD = (
    "left|right|far|back|rear|end|near|opposite|facing|other|long|longer|longest|short|shorter|shortest|narrow|north|"
    "south|east|west|same|second|outer|outside|street"
)
_PLACE = re.compile(
    rf"\b(?:in|on|at|along|across|near|close to|by|into|to|set in|through)\s"
    rf"(?P<middle>(?:the\s|exact\s)*(?:middle|centre|center)\sof\s)?"
    rf"(?:the|one|a|an|its|each|both|either|that|two|three|all)?\s?(?:of\sthe\s)?"
    rf"(?P<side>{_SIDES_WORD}|{PLAIN})(?:[\s-]hand)?(?:\s(?P<what>wall|walls|side|sides|end|ends|corner))?\b"
)
_EACH_SIDE = re.compile(r"\b(?:each|both|either)\s(?:of\sthe\s)?(?:two\s)?(?:long|short|narrow)")
_EACH_WALL = re.compile(r"\b(?:each|every|all(?:\sfour)?|all\sof\sthe)\s(?:walls?|sides?)\b")
_MIDDLE = re.compile(
    r"\b(?:in|at|on)\s(?:the\s)?(?:exact\s)?(?:middle|centre|center)(?:\sline)?\b|\bcent(?:red|ered)\b"
)
_CORNER = re.compile(r"\b(?:in|near|close to|at|by)\s(?:the|a|its)\s(?:(?P<side>left|right|far|near)\s)?corner\b")
_OPPOSITE = re.compile(
    r"\b(?:(?:in|on)\sthe\swall\s)?(?:directly\s|right\s)?(?:opposite|across from|across)\b(?:\s(?:of|to|from))?"
    r"(?:\s(?:it|each other|(?:the\s)?(?P<what>door|window|entrance)))?(?!\s[a-z])"
)
_WIDE = re.compile(rf"(?P<width>{PLAIN})\s?(?:wide|broad|across|in width)|wide,?\s(?:at least\s)?(?P<after>{PLAIN})")
_HIGH = re.compile(rf"(?P<height>{PLAIN})\s?(?:high|tall|in height)")
_SILL = re.compile(
    rf"\bsill\s(?:at|of|height|is)?\s?(?P<sill>{PLAIN})|(?P<above>{PLAIN})\s(?:above|off|from) the floor"
)
_TO = re.compile(
    r"\b(?:to|into|onto|leading to)\s(?:the|a|an|our|his|her)\s"
    rf"(?P<where>{one_of([*_KNOWN['outside'], *_KNOWN['rooms']])})\b"
)
_GLASS = re.compile(
    r"\b(?P<kind>coloured|colored|stained|leaded|frosted|painted)[\s-]glass\s(?:in|for|on)\s(?:the\s|all\s|its\s)*"
    r"(?:side\s|big\s|front\s)?windows?\b"
)
_DOOR_TO = re.compile(rf"\bdoors?\s{_TO.pattern[2:]}")
_REST = re.compile(r"^(?:[^.,()]|[.,](?=\d)){0,120}")
_STOP = re.compile(r"\b(?:and|with|for|so that|so|that|which|where|but|because|while|who|whose)\b")
_PANES = re.compile(
    r"\b(?:glass|glazing|glazed|windows)\s(?:on|along|at)\s(?P<many>two|three|four|all|both)\s(?:of\sits\s)?(?:sides|walls)\b"
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
    r"\b(?:windowless|(?:has|have|had|with)\s(?:got\s)?no\swindows?\b(?!\s[a-z]+\s)|there(?:'s| is| are)\sno\swindows?)"
)
_LONG = {"long": "long", "longer": "long", "longest": "long"}
_SHORT = {"short": "short", "shorter": "short", "shortest": "short", "narrow": "short", "end": "short"}
_SEEN = {"left": "left", "right": "right", "far": "far", "back": "far", "rear": "far", "near": "near"}
_COMPASS = ("north", "south", "east", "west")


@dataclass
class _Told:
    """What was recognised of an opening, and the characters that said it."""

    fields: dict[str, Any]
    taken: list[tuple[int, int]]


def read_openings(source: Source, parsed: Parsed) -> None:
    """Reads statements about parts of the shell; the words about them are blanked, their nouns stay."""
    text = source.text
    blanks: list[tuple[int, int]] = []
    for match in _PHRASE.finditer(text):
        if match["count"] == "the " and match["lead"].strip() in ("and", "with"):
            continue  # "between the bed and the door, 90 cm wide" is about what lies between
        told = _told(text, match, len(parsed.stated_openings))
        if match["size"]:
            told.fields.setdefault("width", plain_length(match["size"]))
            told.taken.append(match.span("size"))
        kinds = _kinds(match["kinds"])
        if not told.fields and not kinds:
            continue
        part = _part(match["part"])
        count = _count(match["count"], match["part"])
        if match["part"] == "doors" and not match["count"] and {"double", "sliding", "french", "patio"} & set(kinds):
            count = 1
        if match["count"] and match["count"].strip() == "row of":
            count = 3
        end = max([end for _, end in told.taken], default=match.end())
        span = source.span(match.start("count") if match["count"] else match.start("kinds"), end)
        said = text[match.start("kinds") : end].strip()
        parsed.stated_openings.append(
            StatedOpening(part=cast(Any, part), count=count, features=kinds, words=said, span=span, **told.fields)
        )
        parsed.stated_openings += _on_the_others(text[match.end() : end], parsed.stated_openings)
        parsed.openings.setdefault(part, 0)
        noun = match.span("part") if part == "niche" else match.span("kinds")
        blanks += [(match.start("kinds"), noun[1]), *told.taken]
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
    if (found := _WINDOWLESS.search(text)) is not None:
        parsed.openings["window"] = 0
        blanks.append((found.start(), found.end()))
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
            beyond = part == "door" and all(any(f.startswith("to the ") for f in s.features) for s in stated)
            count = sum(s.count for s in stated) + beyond  # one comes in by a door of which nothing is said
            parsed.openings[part] = max(parsed.openings.get(part, 0), count)
    source.text = _blanked(text, blanks)


def _on_the_others(said: str, stated: list[StatedOpening]) -> list[StatedOpening]:
    """The same opening in the other wall of two ("on each short side"), or in the three others ("in every wall")."""
    last, own = stated[-1], f"opening-{len(stated) - 1}"
    if _EACH_SIDE.search(said) and last.wall in ("long", "short"):
        return [last.model_copy(update={"wall": "any", "opposite": own})]
    if _EACH_WALL.search(said):
        stated[-1] = last.model_copy(update={"wall": "left"})
        return [last.model_copy(update={"wall": wall}) for wall in ("right", "far", "near")]
    return []


def _told(text: str, match: re.Match[str], number: int) -> _Told:
    """What stands after a noun: its own clause up to a word that begins another, and clauses that only go on."""
    told = _Told({}, [])
    at, first = match.end(), True
    while True:
        rest = _REST.match(text[at:])
        clause = rest[0] if rest else ""
        stop = _STOP.search(clause)
        clause = clause[: stop.start()] if stop else clause
        fields = dict(told.fields)
        spans = _fields(clause, number, fields)
        # A clause after a comma goes on only where nothing but places and measures is in it.
        left = _blanked(clause, spans)
        if not first and re.sub(r"\b(?:at|least|the|a|just|about|wide|must|be|is)\b|\W", "", left):
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
    for pattern, name in ((_WIDE, "width"), (_HIGH, "height"), (_SILL, "sill")):
        if (m := pattern.search(clause)) and name not in fields:
            value = next(g for g in m.groups() if g)
            fields[name] = plain_length(value)
            spans.append(m.span())
    if "width" not in fields and (m := re.search(rf"^\s*(?:of\s|about\s|at least\s|is\s)*({PLAIN})\s*$", clause)):
        fields["width"] = plain_length(m[1])
        spans.append(m.span(1))
    if m := _CORNER.search(clause):
        fields.setdefault("at", m["side"] if m["side"] in ("left", "right") else "corner")
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
        spans.append(m.span())
    return spans


def _placed(m: re.Match[str], number: int, fields: dict[str, Any]) -> bool:
    """Takes one place: a wall by its length or side, the wall across from another opening, or a corner."""
    side, what = m["side"], m["what"] or ""
    if m["middle"]:
        fields.setdefault("at", "middle")
    if what == "corner":
        fields.setdefault("at", side if side in ("left", "right") else "corner")
    elif side in ("opposite", "other", "facing", "second") and number:
        fields.setdefault("opposite", f"opening-{number - 1}")
    elif side in _LONG:
        fields.setdefault("wall", "long")
    elif side in _SHORT and (what or side != "end"):
        fields.setdefault("wall", "short")
    elif side in _SEEN:
        fields.setdefault("wall", _SEEN[side])
        if "across" in m[0].split()[:1]:
            fields.setdefault("at", "along")
    elif side in _COMPASS:
        fields.setdefault("wall", side)
    elif re.fullmatch(PLAIN, side) and what in ("wall", "walls", "side", "sides"):
        fields.setdefault("wall_length", plain_length(side))
    else:
        return bool(m["middle"]) or (side in ("outer", "outside", "street", "same") and bool(what))
    return True


def _doors_to(source: Source, parsed: Parsed) -> None:
    """A door that leads to a named place is one of its own, whether or not more is said of it."""
    for m in _DOOR_TO.finditer(source.text):
        span = source.span(m.start(), m.end())
        known = next((s for s in parsed.stated_openings if s.span and s.span.start <= span.start < s.span.end), None)
        feature = f"to the {m['where']}"
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
    return tuple(dict.fromkeys(word for word in found if word not in _KNOWN["plain"]))


def _part(word: str) -> str:
    word = word.rstrip("s")
    return {"doorway": "door", "alcove": "niche"}.get(word, word)


def _count(determiner: str | None, noun: str) -> int:
    said = (determiner or "").strip()
    if said.isdigit():
        return max(1, min(int(said), 20))
    return _NUMBERS.get(said, 2 if noun.endswith("s") and not said.startswith("a ") else 1)


def _blanked(text: str, spans: list[tuple[int, int]]) -> str:
    for start, end in spans:
        text = text[:start] + " " * (end - start) + text[end:]
    return text


__all__ = ["read_openings"]
