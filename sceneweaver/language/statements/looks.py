"""How the whole room looks: its style, the time that it is of, a theme, a mood, sets of colours, its light.

Words that are said of one thing alone ("a rustic table", "a retro fridge") are left to it, and what the request does
not want ("not gloomy", "nothing modern") is no look of the room.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from sceneweaver.assets.materials import color_named, color_words
from sceneweaver.assets.materials import hue as hue_of
from sceneweaver.knowledge.looks import Years, look_words, looks, time_of, unlike_words

from ..model import Span, StatedLook, StatedOpening
from ..parsed import Parsed
from ..source import Source
from ..vocabulary import vocabulary, words
from .phrases import one_of

FIRST, LAST = 1000, 2999
"""Years that four digits may mean."""

_BEFORE = re.compile(
    r"(?:\b(?:not|no|never|without|nothing|isn't|aren't|don't|non|avoid|less|too)\b(?:[ -]\w+)?[ -]*)$"
)
_INSIDE = re.compile(r"\b(?:on|of|in|aboard|inside|for) (?:a|an|the|our|my)(?: \w+){0,2} $")
"""Before a place that the room is a part of, and is not itself: "the mess of a whaling ship"."""

_NEXT = re.compile(r"[ -]*([a-z][a-z'-]*)")


def read_looks(source: Source, parsed: Parsed) -> None:
    """Read what a request says of the look of its room; what names nothing else goes out of the source."""
    _schemes(source, parsed)
    _sun_side(source, parsed)
    latest = _limit(source, parsed)
    _years(source, parsed)
    _unlike(source, parsed)
    _contrast(source, parsed)
    _glow(source, parsed)
    _flames(source, parsed)
    _one_lamp(source, parsed)
    for pattern, named in _patterns():

        def take(match: re.Match[str], named: bool = named) -> str | None:
            name = look_words()[_plain(match["look"])]
            if _is_denied(source.text, match.start("look")) or _is_of_thing(source.text, match, named):
                return None
            add(parsed, source, name, match)
            if (windows := looks()[name].windows) is not None and not _has_windows(parsed):
                parsed.openings["window"] = windows
            inside = _INSIDE.search(source.text[: match.start("look")])
            return None if _names_more(match["look"]) and not (inside and _is_place(match["look"])) else " "

        source.blank(pattern, take)
    _bare(source, parsed)
    if latest is not None and not any(one.years for one in parsed.room_looks):
        parsed.room_looks.append(StatedLook(name="", years=(latest[0] - 9, latest[0]), words=latest[1], span=latest[2]))


def add(parsed: Parsed, source: Source, name: str, match: re.Match[str], years: Years | None = None) -> None:
    """One more look, unless a longer phrase at the same place has been read."""
    span = source.span(*match.span())
    if any(one.span and one.span.start < span.end and span.start < one.span.end for one in parsed.room_looks):
        return
    row = looks().get(name)
    years = years or (row.years if row is not None else None)
    if not row_years(match) and any(one.name == name for one in parsed.room_looks):
        years = None  # said again: the year that was named counts
    parsed.room_looks.append(StatedLook(name=name, years=years, words=match[0].strip(" ,."), span=span))


def _schemes(source: Source, parsed: Parsed) -> None:
    """Colours that are said of somebody, and are the room's: "in the team colours navy and orange"."""

    def take(match: re.Match[str]) -> str:
        parsed.colors += _hue().findall(match["list"])
        parsed.referred.append(source.span(*match.span()))
        return " "

    source.blank(_scheme(), take)


@cache
def _hue() -> re.Pattern[str]:
    return re.compile(rf"\b(?:{one_of(color_words())})\b")


@cache
def _scheme() -> re.Pattern[str]:
    hue, whose = _hue().pattern, one_of(words("looks")["whose_colors"])
    listed = rf"(?P<list>{hue}(?:\s*(?:,\s*and\s|,|and|&|/)\s*{hue}){{0,4}})"
    own = r"(?:\bin )?(?:\b(?:the|our|his|her|my|their|its) )*"
    return re.compile(rf"{own}\b{whose} colou?rs?(?: (?:are|is|of|being)|\s*:|,)?\s+{listed}")


def _sun_side(source: Source, parsed: Parsed) -> None:
    """ "Late sun from the left": there is a window on that side."""
    pattern = re.compile(
        r"(?:\bsun(?:light|shine)?|\blight|\bdaylight)(?P<from> (?:\w+ ){0,2}?from the (?P<side>left|right))\b"
    )

    def take(match: re.Match[str]) -> str:
        start, end = match.start("from") + 1, match.end()
        if not any(one.part == "window" for one in parsed.stated_openings):
            side = "left" if match["side"] == "left" else "right"
            span = source.span(start, end)
            parsed.stated_openings.append(StatedOpening(part="window", wall=side, words=match[0], span=span))
        return match[0][: start - match.start()]

    source.blank(pattern, take)


def row_years(match: re.Match[str]) -> bool:
    """Whether a phrase names a year, a decade or a century itself."""
    return "look" not in match.groupdict()


def _glow(source: Source, parsed: Parsed) -> None:
    """Coloured light: "neon purple", "purple neon lights", "bathed in red light"."""
    for pattern in _glowing():

        def take(match: re.Match[str]) -> str | None:
            color = match["color"]
            basic = color_named(color)
            color = f"neon {basic}" if f"neon {basic}" in color_words() else color
            if hue_of(basic) is None or _is_denied(source.text, match.start("color")):
                return None
            span = source.span(*match.span())
            said = StatedLook(name="neon", color=color, words=match[0].strip(), span=span)
            parsed.room_looks.append(said)
            return " "

        source.blank(pattern, take)


@cache
def _glowing() -> tuple[re.Pattern[str], ...]:
    hue = one_of([name for name in color_words() if not name.startswith("neon")])
    before, lit = r"(?:bathed in |lit in |lit by |lit with |in |with )?\b", one_of(words("looks")["lit"])
    return (
        re.compile(rf"{before}neon[ -](?P<color>{hue})(?: (?:{lit})\b)?"),
        re.compile(rf"{before}(?P<color>{hue})(?: and \w+)? (?:neon )?(?:{lit})\b"),
    )


def _flames(source: Source, parsed: Parsed) -> None:
    """What burns is all the light there is: "lit by torches", "nothing but candles gives light"."""
    rows: dict[str, str] = words("looks")["flames"]

    def take(match: re.Match[str]) -> str | None:
        name = next((name for word, name in rows.items() if match["of"].split()[-1] == word.split()[-1]), "candle")
        if _is_denied(source.text, match.start()):
            return None
        add(parsed, source, name, match)
        kept = [one for one in (match["of"], match["more"]) if one and _is_thing_too(one)]
        return " and ".join(kept) if kept else " "

    source.blank(_burning(), take)


@cache
def _burning() -> re.Pattern[str]:
    burning = rf"(?:a |the |some |two |three |few )*(?:{one_of(words('looks')['flames'])})"
    return re.compile(
        rf"\b(?:all |the |only |its )*(?:light(?:ed|ing)?|lit|illuminated)(?: comes| is| coming)?"
        rf"(?: only| just| solely| mainly| mostly| up)* (?:from|by|with|of)(?: only| just)? (?P<of>{burning})"
        rf"(?:(?: and|,| or) (?:from |by )?(?P<more>{burning}))?(?: (?:only|alone))?\b"
    )


def _is_thing_too(spoken: str) -> bool:
    """Whether what burns is a thing of the room as well: a fireplace, some lanterns."""
    return spoken.split()[-1] in words("looks")["burning_things"]


def _one_lamp(source: Source, parsed: Parsed) -> None:
    """ "A single bare bulb", "one dim lamp", "no other lights": no lamps but those that are named."""

    def take(match: re.Match[str]) -> str | None:
        if _is_denied(source.text, match.start()):
            return None
        add(parsed, source, "one lamp", match)
        if not match["weak"]:
            return match[0]
        a, b = (at - match.start() for at in match.span("weak"))
        lamp = "pendant" if match[0].endswith("bulb") else match[0][b:].strip()  # a bulb alone is a part of a lamp
        return match[0][:a] + lamp  # how weak it is shows in the light of the room

    source.blank(_single_lamp(), take)
    source.blank(_no_other_lamp(), lambda found: add(parsed, source, "one lamp", found) or " ")


@cache
def _single_lamp() -> re.Pattern[str]:
    rows = words("looks")
    lamps, weak = one_of(rows["lamps"]), one_of(rows["weak"])
    one = rf"(?:a\ssingle|a\slone|a\ssolitary|single|one)\s(?P<weak>{weak})"
    one = rf"(?:(?:only|just)\s(?:one|a|a\ssingle)|(?:the\s)?only|{one}|one(?=\s(?:light\s)?bulb\b))"
    lit = r"(?:lit|light|lighted|illuminated)\s(?:only\s)?(?:by|from|with)\s(?:just\s)?(?:one|a\s(?:single|lone))"
    each = r"(?!\s(?:per|each|(?:for|at|on|by)\s(?:each|every))\b)"
    return re.compile(rf"\b(?:{one}|{lit})\s(?:[a-z-]+\s){{0,2}}?{lamps}\b{each}")


@cache
def _no_other_lamp() -> re.Pattern[str]:
    lamps = one_of(words("looks")["lamps"])
    return re.compile(
        rf"\b(?:and\s)?(?:no|without(?:\sany)?)\s(?:other|further|more|additional)\s(?:[a-z]+\s)?{lamps}s?\b"
    )


def _has_windows(parsed: Parsed) -> bool:
    return "window" in parsed.openings or any(one.part == "window" for one in parsed.stated_openings)


def _contrast(source: Source, parsed: Parsed) -> None:
    """ "Strong contrast between floor and walls": parts of the room stand out from each other."""

    def take(match: re.Match[str]) -> str | None:
        if _is_denied(source.text, match.start()):
            return None
        add(parsed, source, "contrast", match)
        return " "

    source.blank(_contrasting(), take)


@cache
def _contrasting() -> re.Pattern[str]:
    strong = one_of(words("looks")["strong"])
    parts = (
        r"(?:\s(?:the|all|its|their|every)|\s(?:walls?|floors?|fittings|doors?|edges?|surfaces|frames?|and|,|from|to))*"
    )
    return re.compile(
        rf"\b(?:{strong}\s)*contrasts?(?:\s(?:of|in)\s(?:colou?rs?|tone))?"
        rf"(?:\s(?:between|of|at|on|along|for|around){parts})?"
        rf"(?=\s*(?:[a-z]|[,.;:!?)]|$))"
    )


def _unlike(source: Source, parsed: Parsed) -> None:
    """ "Must not look like a hospital", "nothing clinical about it": the look of a room that is unlike it."""

    def take(match: re.Match[str]) -> str | None:
        if match["no"] and not match["tail"]:
            return None  # "no office" is no room, "no office feel" no look
        rows = dict.fromkeys(unlike_words()[_plain(word)] for word in re.findall(_unlike_word(), match["listed"]))
        span = source.span(*match.span())
        for name in rows:
            parsed.room_looks.append(StatedLook(name=name, words=match[0].strip(" ,."), span=span))
        return " "

    source.blank(_denied_likeness(), take)


@cache
def _unlike_word() -> str:
    return rf"(?<![\w-]){one_of(unlike_words())}(?![\w-])"


@cache
def _denied_likeness() -> re.Pattern[str]:
    """A denial, words about looking so, and what the room is not to be like, with nothing that it would be said of."""
    rows = words("looks")
    denial = one_of(rows["denials"])
    filler = rf"(?:\s+{one_of(rows['likeness'])}){{0,10}}"
    listed = rf"{_unlike_word()}(?:\s*(?:,|\bor\b|\bnor\b|\band\b)*\s*(?:like\s)?(?:an?\s)?{_unlike_word()})*"
    tail = rf"(?P<tail>(?:\s+{one_of(rows['likeness_after'])}){{0,3}})"
    begins = r"(?:\b(?:it|this|that|the\sroom|room|which|he|she|they|we|i)\s)?(?:\b(?:please|pls)\s)?"
    return re.compile(
        rf"{begins}\b(?:(?P<no>no|without|nor)|{denial}){filler}\s+(?P<listed>{listed}){tail}"
        r"(?=\s*(?:$|[.,;:!?)\n-]|(?:and|but|please|for|as|because|though|so|just|or|in|at|with)\b))"
    )


def _bare(source: Source, parsed: Parsed) -> None:
    """Words that are a look where they are all of a clause: "dark, only the fire burns"."""
    rows: dict[str, str] = words("looks")["bare"]

    def take(match: re.Match[str]) -> str | None:
        if _is_denied(source.text, match.start("look")):
            return None
        add(parsed, source, rows[match["look"]], match)
        return " "

    source.blank(_bare_look(), take)


@cache
def _bare_look() -> re.Pattern[str]:
    before = r"(?:(?:very|quite|all|rather|it is|it's|must be|should be|should feel|feels) )*"
    return re.compile(
        r"(?:(?<=^)|(?<=[,.;:!?] )|(?<=[,.;:!?])|(?<= and )|(?<= but )|(?<= feel )|(?<= feels ))"
        rf"{before}(?P<look>{one_of(words('looks')['bare'])})(?=\s*(?:[,.;!?]|$)| and )"
    )


# ---- times -----------------------------------------------------------------------------------------------------------


def _limit(source: Source, parsed: Parsed):
    """ "Nothing younger than 1940": the last year that there is, its words and their place, if there is such."""
    found: list[tuple[int, str, Span | None]] = []

    def take(match: re.Match[str]) -> str:
        if match["year"]:
            found.append((int(match["year"]), match[0], source.span(*match.span())))
        else:  # "nothing newer than that": the time that the request names
            parsed.room_looks.append(StatedLook(name="", words=match[0], span=source.span(*match.span())))
        return " "

    source.blank(_younger(), take)
    return found[0] if found else None


@cache
def _younger() -> re.Pattern[str]:
    younger = one_of(words("looks")["younger"])
    return re.compile(
        rf"\b(?:nothing|no \w+|none)(?: \w+){{0,4}}? {younger} (?:than )?(?:(?P<year>\d{{4}})\b|that\b|this\b)"
    )


def _years(source: Source, parsed: Parsed) -> None:
    """Years, decades and centuries, in digits or words."""
    rows = words("looks")
    for pattern in _times():

        def take(match: re.Match[str]) -> str | None:
            years = _years_of(match.groupdict(), rows["decades"], rows["ordinals"], rows)
            if years is None or _counts(source.text, match):
                return None
            add(parsed, source, time_of(years).name, match, years)
            return " "

        source.blank(pattern, take)


@cache
def _times() -> tuple[re.Pattern[str], ...]:
    rows = words("looks")
    decades, numbers, hundred = one_of(rows["decades"]), one_of(rows["ordinals"]), one_of(rows["hundreds"])
    about = rf"(?:(?:{one_of(rows['about'])})[ ,]*){{0,5}}"
    part = rf"(?:(?P<part>{one_of(rows['parts'])})[ -]+)?"
    after = rf"(?:[ -]+(?:{one_of(rows['after'])})\b){{0,4}}"
    return (
        re.compile(rf"\b{about}{part}(?P<year>[12]\d{{3}})(?P<s>'?s)?(?![\d,.]\d|\w){after}"),
        re.compile(rf"(?<!\d)(?<!\d[.,])\b{about}{part}'?(?P<short>[2-9]0)(?P<s>'?s)(?!\w){after}"),
        re.compile(rf"\b{about}{part}(?:(?P<hundred>{hundred})[ -])?(?P<decade>{decades})\b{after}"),
        re.compile(rf"\b{about}{part}(?P<century>\d{{1,2}}(?:st|nd|rd|th)|{numbers})[ -]century{after}"),
    )


def _years_of(said: dict, decades: dict, ordinals: dict, rows: dict) -> Years | None:
    """First and last year of a time in words."""
    if said.get("year"):
        first = int(said["year"])
        if not said["s"]:
            return (first, first) if FIRST <= first <= LAST else None
        long = 99 if first % 100 == 0 and first < 1900 else 14 if first == 1900 else 9
        years = (first, first + long)
    elif said.get("short"):
        years = (1900 + int(said["short"]), 1909 + int(said["short"]))
    elif said.get("decade"):
        first = rows["hundreds"].get(said.get("hundred") or "", 1900) + int(decades[said["decade"]])
        years = (first, first + 9)
    else:
        word = said["century"]
        number = int(re.sub(r"\D", "", word)) if word[0].isdecimal() else int(ordinals[word])
        if not 1 <= number <= 29:
            return None
        years = (100 * (number - 1), 100 * (number - 1) + 99)
    share = rows["parts"].get(said.get("part") or "")
    if share:
        length = years[1] - years[0] + 1
        years = (years[0] + round(share[0] * length), years[0] + round(share[1] * length) - 1)
    return years


def _counts(text: str, match: re.Match[str]) -> bool:
    """Whether a number counts things or measures something: "1500 books", "1200 mm", "2000 x 900"."""
    rows, groups = words("looks"), match.groupdict()
    if groups.get("s") or groups.get("decade") or groups.get("century"):
        return bool(groups.get("decade")) and _is_people(text, match)
    following = _NEXT.match(text, match.end())
    told = match[0].strip()[0].isalpha() and match[0].strip().split()[0] not in ("in",)
    if following is None:
        return bool(re.match(r"\s*(?:[x×*/€$£%]|by\b)", text[match.end() :]))
    if following[1] in rows["units"]:
        return True
    entry = vocabulary().get(following[1], {})
    return not told and "noun" in entry and following[1].endswith("s") and "room" not in entry


def _is_people(text: str, match: re.Match[str]) -> bool:
    """Whether a decade is an age: "a woman in her eighties", "people in their sixties"."""
    return bool(re.search(r"\b(?:her|his|their|my|our|your)(?: \w+)? $", text[: match.start("decade")]))


# ---- words -----------------------------------------------------------------------------------------------------------


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], bool], ...]:
    """Patterns of looks: with words such as "style" or "mood" behind them, which make them the room's, then bare."""
    rows = words("looks")
    either = one_of(list(look_words()))
    before = rf"(?:\b(?:{one_of(rows['before'])})[ ]+){{0,5}}"
    after = rf"(?:[ -]+(?:{one_of(rows['after'])})\b)"
    look = rf"(?<![\w-])(?P<look>{either})(?![\w])"
    return (
        (re.compile(rf"{before}{look}{after}+"), True),
        (re.compile(rf"{before}{look}"), False),
    )


def _plain(text: str) -> str:
    return text.replace("-", " ") if text not in look_words() else text


def _is_denied(text: str, at: int) -> bool:
    before = text[max(0, at - 24) : at]
    return bool(_BEFORE.search(before))


def _is_of_thing(text: str, match: re.Match[str], named: bool) -> bool:
    """Whether a look is said of the one thing that is named after it, and not of the room.

    The first noun after it decides: what is a kind of room or no thing is the room's.
    """
    row = looks()[look_words()[_plain(match["look"])]]
    if row.kind in ("light", "scheme"):
        return _light_of_thing(text, match, row.kind == "scheme")
    at, spoken = match.end(), list[str]()
    before = re.search(r"\b(?:a|an|the|two|three|four|my|our|its|some|\d+) (?:[a-z-]+ ){0,2}$", text[: match.start()])
    for _ in range(5):
        following = _NEXT.match(text, at)
        if following is None or following[1] in words("looks")["ends"]:
            break
        spoken.append(following[1])
        at = following.end()
    if not spoken:
        return False
    kinds = [kind for kind in _noun_kinds(spoken)]
    if not kinds:
        return False
    return "room" not in kinds and (not named or before is None) and not _all_of_it(text, match)


def _all_of_it(text: str, match: re.Match[str]) -> bool:
    """ "Modern furniture", "vintage decor": all that is in the room."""
    return bool(_all_things().match(text[match.end() :]))


@cache
def _all_things() -> re.Pattern[str]:
    return re.compile(rf"[ -]+(?:[a-z]+ )?{one_of(words('looks')['all'])}\b")


def _light_of_thing(text: str, match: re.Match[str], scheme: bool) -> bool:
    """ "Neon sign", "warm light oak", "a black and white photo": the word is a part of a thing's name."""
    following = _NEXT.match(text, match.end())
    if following is None:
        return False
    kinds = vocabulary().get(following[1], {})
    scheme = scheme and set(re.findall(r"[a-z]+", match["look"])) <= {*color_words(), "and"}
    of_thing = scheme and "noun" in kinds and "room" not in kinds and not _all_of_it(text, match)
    return of_thing or following[1] in words("looks")["lit_things"]


def _noun_kinds(spoken: list[str]) -> Iterator[str]:
    """Of the nouns at the beginning of some words whether each names a thing or a room, the longest first."""
    table, at = vocabulary(), 0
    while at < len(spoken):
        for length in range(min(4, len(spoken) - at), 0, -1):
            entry = table.get(" ".join(spoken[at : at + length]).replace("-", " "), {})
            if "room" in entry or "region" in entry or "abstract" in entry:
                yield "room"
                break
            if "noun" in entry:
                yield "noun"
                break
        else:
            entry = table.get(spoken[at], {})
            if not entry or "color" in entry or "material" in entry or "adjective" in entry or "styles" in entry:
                at += 1
                continue
            return
        at += length


def _is_place(word: str) -> bool:
    """Whether a look is that of a place, which the words name: a hut, a ship."""
    return word.split()[-1] in words("looks")["places"]


def _names_more(word: str) -> bool:
    """Whether a look's word names a place or a thing as well: a saloon, a bunker, candles."""
    entry = vocabulary().get(word.replace("-", " "), {})
    if _is_place(word):
        return True
    if looks()[look_words()[_plain(word)]].kind in ("scheme", "mood") and "density" not in entry:
        return False
    if "noun" in entry or "room" in entry or "styles" in entry or "density" in entry:
        return True
    last = vocabulary().get(word.split()[-1], {})
    return "room" in last or ("noun" in last and word in words("looks")["things"])
