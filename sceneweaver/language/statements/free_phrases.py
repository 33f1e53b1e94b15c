"""How people ask for free floor: one template for each way of saying it.

Every template needs a word that floor is what is meant ("free", "aisle", "between", "around"), so that measures of
things and of the room never match. In a template a space is any white space, ``¤`` a length, ``§`` two sides,
``<name>`` one of `_WORDS`, and ``<A>`` or ``<B>`` the words for a thing.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Literal, NamedTuple

TURNING = 1.5
"""Diameter of the circle in which a wheelchair turns [m]."""

WALK = 0.8
"""Width of a way that one person walks [m]."""

REACH = 0.7
"""Free width at a side from which something can be used [m]."""

OPEN_MIDDLE = 1.5
"""Diameter of a free middle of a room of which no more is said [m]."""

_STOP = (
    "and|or|to|with|so|because|for|at|in|on|must|should|shall|can|could|would|will|is|are|be|has|have|which|that|where|"
    "when|as|but|of|by|from|wide|free|clear|minimum|please|not|no|since|if|while|like|than|then|also|around|between|"
    "without|inside|near|next|behind|before|front|i|we|they|he|she|you|there|even|everywhere|always|stay|stays|remain|"
    "remains|needs|need|open|empty|along|against|through|past|about|least|a|an|the|over|under|above|below"
)
_DETERMINERS = (
    "the|a|an|all|each|every|any|both|either|of|two|three|four|five|six|our|my|its|this|that|these|those|their|"
    r"\d{1,2}"
)
_NAME = rf"(?!(?:{_STOP})\b)[a-z][a-z'/-]{{0,24}}"


def _thing(name: str) -> str:
    return (
        rf"(?:(?:{_DETERMINERS})\s+){{0,3}}(?P<{name}>chest\s+of\s+drawers|{_NAME}(?:\s+{_NAME}){{0,3}})"
        r"(?:\s+of\s+the\s+(?:room|floor))?"
    )


_WORDS = {
    "free": "(?:free|clear|open|empty|unobstructed|uncluttered|unoccupied|spare|bare|clearance)",
    "floor": "(?:(?:floor|manoeuvring|maneuvering)(?:[\\s-](?:space|area|room))?|space|area|room|spot|patch|zone|place|"
    "square|rectangle|clearance|width|distance)",
    "keep": "(?:keep|leave|leaves|reserve|have|has|need|needs|want|wants|allow|provide)",
    "how": "(?:(?:clear|free|straight|wide|direct|unobstructed|open|narrow|single|main|central|cold|hot|unblocked) )*?",
    "way": "(?:aisles?|paths?|pathways?|passages?|passageways?|walkways?|corridors?|gangways?|routes?|lanes?|circulation|"
    "thoroughfares?|(?:clear |free |straight |access )ways?)",
    "gap": "(?:gaps?|spaces?|spacing|distance|room|clearance|space)",
    "turn": "(?:wheelchair )?(?:turning|manoeuvring|maneuvering)[\\s-](?:circle|space|area|room|diameter|spot)",
    "round": "(?:(?:all )?(?:a)?round|(?:on |at |to |along )?(?:every|each|all|(?P<both>either|both))(?: of)?(?: the| its)?"
    "(?: (?P<long>long|longer))?(?: two| three| four)? sides?)",
    "front": "(?P<side>in front|before|behind|at the back|at the front|"
    "(?:to|on|at) (?:the|its|her|his) (?:left|right|foot|front|back)(?: side)?)",
    "for": "(?: (?:for|to) (?!the (?:door|wall|window))[a-z'\\s-]{2,40}?(?= ?[.,;)§¤]| (?:and|in|of|at|on|by)\\b|$))?",
    "near": "(?: (?:right |just )?(?P<where>inside|in front of|before|behind|beside|next to|by|near|at|around|in) <A>)?",
    "be": "(?:,? (?:is|are|should|must|has to|have to|to|be|stay|stays|remain|remains|kept|left|shall|needs to|of|at|least|"
    "say|about|around|roughly|approximately|approx\\.|ca\\.|maybe|perhaps|some|minimum|measuring|which|that|,))*?",
    "room": "(?: of (?:the )?(?:room|floor|space|studio|hall))?",
}


class Phrase(NamedTuple):
    """One way of asking for free floor.

    ``width`` [m] is what is meant where no measure is given (None: one has to be); ``side`` is that of its target.
    """

    kind: Literal["rectangle", "circle", "clearance", "gap", "path"]
    template: str
    width: float | None = None
    side: str = "any"


PHRASES: tuple[Phrase, ...] = (
    Phrase("circle", "<turn><be> ¤<near>"),
    Phrase("circle", "(?P<radius>turning radius)<be> ¤<near>"),
    Phrase("circle", "¤ (?:wide )?<turn><near>"),
    Phrase(
        "circle", "¤ (?:of )?(?:space |room )?(?:for (?:a |the )?wheelchair )?to turn(?: (?:a|the|her|his|my) wheelchair)?"
    ),
    Phrase("circle", "(?:<free> )?circle (?:of )?¤(?: (?:in diameter|across|wide))?(?:<be> <free>)?<near>"),
    Phrase("circle", "¤ (?:wide )?(?:<free> )?circle(?:<be> <free>)?<near>"),
    Phrase("circle", "<turn>(?: for (?:a |the |her |his |my )?(?:wheelchair|walker|rollator))?<near>", TURNING),
    Phrase(
        "circle",
        "(?:space|room) (?:for (?:a|the|her|his|my) wheelchair to turn|to turn (?:a|the|her|his|my) wheelchair)(?: (?:a)?round)?",
        TURNING,
    ),
    Phrase("rectangle", "<free> <floor><for><be>,? §(?: m)?<for><near>"),
    Phrase("rectangle", "(?:<floor> of )?§(?: m)?(?: of)?<be> <free>(?! of| from)(?: <floor>)?<for><near>"),
    Phrase("rectangle", "<free> (?:an? )?(?:<floor> of )?§(?: m)?(?: <floor>)?<for><near>"),
    Phrase("rectangle", "(?P<square>¤ square)(?: of)?<be> <free>(?: <floor>)?<for><near>"),
    Phrase("rectangle", "<free> (?:<floor>|(?P<plain>square))<for><be>,? (?P<square>¤ square)<near>"),
    Phrase("circle", "<keep> (?:the )?(?P<a>middle|centre|center)<room> <free><for>", OPEN_MIDDLE),
    Phrase("circle", "(?P<a>middle|centre|center)<room><be> <free>(?! wall)<for>", OPEN_MIDDLE),
    Phrase("path", "<how><way>,?<be>(?: with a width of| width)? ¤(?: (?:wide|across|clear|free))*,? (?:leading |running )?from <A>(?: straight)? to <B>"),
    Phrase("path", "<how><way>,?<be>(?: with a width of| width)? ¤(?: (?:wide|across|clear|free))*,? (?:leading |running )?(?:up )?to(?:wards)? <B>"),
    Phrase("path", "¤ (?:(?:wide|clear|free) )*<how><way> (?:leading |running |straight )?from <A>(?: straight)? to <B>"),
    Phrase("path", "¤ (?:(?:wide|clear|free) )*<how><way> (?:leading |running )?to(?:wards)? <B>"),
    Phrase("path", "¤ (?:wide|clear|free|open)(?: (?:wide|clear|free|open|way))? from <A> to <B>"),
    Phrase("path", "<how><way> (?:leading |running |straight )?from <A>(?: straight)? to <B>(?:<be>,? ¤(?: (?:wide|across))?)?", WALK),
    Phrase("path", "(?:the )?(?:way|<how><way>) between (?:the )?(?P<a>door|entrance|entry) and <B>(?:<be>,? ¤(?: (?:wide|across))?|<be> <free>)?", WALK),
    Phrase(
        "path",
        "(?:nothing|no [a-z]{2,15})(?: (?:may|must|should|shall|can|is to|to|is|are|be|stand|standing|stands|stored|placed|"
        "put|left|in|on|the|floor|way|lie|block|blocks|there))* between <A> and <B>(?:,? ¤(?: (?:wide|across))?)?",
        WALK,
    ),
    Phrase("path", "all (?:the )?<how><way><be>,? ¤(?: (?:wide|clear|across))?"),
    Phrase("path", "<how><way> (?:everywhere|throughout)<be>,? ¤"),
    Phrase("path", "¤ (?:(?:wide|clear|free|of|space|room|<way>) )*(?:everywhere|throughout)(?! between)"),
    Phrase("path", "<how><way> (?:down|in|through|along) the (?:middle|centre|center)<room>(?:<be>,? ¤(?: (?:wide|across))?)?", WALK),
    Phrase("path", "¤ (?:(?:wide|clear|free) )*<how><way> (?:down|in|through|along) the (?:middle|centre|center)<room>"),
    Phrase("gap", "(?:<how><way>|<gap>) (?:in )?between <A> and (?!to )<B><be>,? ¤"),
    Phrase("gap", "(?:<how><way>|<gap>) (?:in )?between <A><be>,? ¤"),
    Phrase("gap", "¤ (?:(?:<free>|<gap>|<way>|of|wide|everywhere|left|apart) )*(?:to (?:pass|walk) )?(?:in )?between <A> and (?!to )<B>"),
    Phrase("gap", "¤ (?:(?:<free>|<gap>|<way>|of|wide|everywhere|left|apart) )*(?:to (?:pass|walk) )?(?:in )?between <A>(?: and to <WAY_TO>)?"),
    Phrase("path", "(?:to )?(?:pass|walk|get)(?: through)? ¤ in between"),
    Phrase("gap", "(?:<how><way>|<gap>) of ¤ (?:wide )?(?:in )?between <A>(?: and <B>)?"),
    Phrase("gap", "¤ (?:(?:<free>|<gap>|<way>|of|wide) )*in between"),
    Phrase("gap", "(?:<how><way>|<gap>) (?:in )?between <A> ¤"),
    Phrase("gap", "¤ (?:away from|off|from|clear of|out from|free of) (?:(?:any|all|every|each|the|both) )*(?P<b>walls?)(?! (?:unit|cabinet|shel))"),
    Phrase("clearance", "¤ (?:of )?(?:(?:<free>|space|room|distance|floor|left) )*<round>(?: (?:of )?<A>)?", side="around"),
    Phrase("clearance", "(?:<free> )?(?:space|room|clearance|zone|strip|band|area) (?:of )?¤ <round>(?: (?:of )?<A>)?", side="around"),
    Phrase("clearance", "(?:clearance|<free> (?:space|room|zone|strip|area)) <round> (?:of )?<A><be> ¤", side="around"),
    Phrase("clearance", "¤ (?:of )?(?:(?:<free>|space|room|floor|left|kept) )+<front>(?: of <A>| <B>)?"),
    Phrase("clearance", "¤ <front>(?: of <A>| <B>)?<be> <free>"),
    Phrase("clearance", "(?:clearance|<free> (?:space|room|zone|floor|area)) (?:of )?¤ <front>(?: of <A>| <B>)?"),
    Phrase("clearance", "(?:clearance|<free> (?:space|room|zone|floor|area)) <front>(?: of <A>| <B>)?<be>,? ¤"),
    Phrase("clearance", "<keep> ¤ <front>(?: of <A>| <B>)"),
    Phrase("clearance", "¤ (?:of )?<free> (?:space |room |floor )?(?P<where>by|beside|next to|at|near) <A>"),
    Phrase(
        "clearance",
        "(?:standing free )?(?:so (?:that )?)?(?:(?:it|they|you|one) )?(?:(?:can|must|should|to|is|be) )*"
        "(?:reached|accessible|access|accessed|approached|reachable|used) (?:to it )?(?:from|on) "
        "(?:all|(?P<both>both|either)|every|each|three|four)(?: of)?(?: its| the)?(?: (?P<long>long|longer))?(?: two| four)? sides?",
        REACH,
        "around",
    ),
    Phrase("clearance", "(?:space|room) (?:for [a-z\\s]{2,20} )?to (?:walk|go|move|get) (?:all )?(?:a)?round <A>", REACH, "around"),
)  # fmt: skip
"""In the order in which they are tried; the first that fits takes its words."""

_LEADS = re.compile(
    r"(?:\b(?:please|keep|leave|allow|provide|reserve|have|make|sure|with|and|but|so|want|wants|get|gets|plus|give|also|"
    r"only|just|still|there|there's|is|are|should|must|be|i|we|you|they|a|an|some|the|enough|nice|clean|proper|to|it|"
    r"comfortable|comfortably|possible|straight|direct|one|of|at|least|needs?|requires?|requiring|staff|people|has|"
    r"which|that|would|like|for|as|left|around|walkers?|wheelchairs?|customers?|door|stays?|where)\s+)+$"
)
"""Words before a phrase that say no more than that it is wanted."""

_ENDS = re.compile(
    r"\s{0,2},?\s{0,2}(?:at\s+(?:the\s+very\s+)?least|(?:as\s+a\s+)?minimum|min\b\.?|or\s+(?:more|wider|so)\b|wide\b|"
    r"across\b|in\s+(?:width|diameter|total)\b|deep\b|please\b|because\s+of\s+[a-z' -]{2,40}(?=[.,;)]|$)|"
    r"(?:for|so)\s+(?:the\s+|a\s+)?(?:staff|safety|wheelchairs?|people|customers?|walkers?|prams?|strollers?|trolleys?)\b|"
    r"and\s+to\s+(?:these|those|the)\s+[a-z]{2,20}\b(?=\s*[.,;)]|$)|"
    r"(?:for\s+[a-z]{2,12}\s+)?to\s+(?:pass|walk|get\s+(?:by|past|through)|move)\b)"
)
"""Words behind a phrase that belong to it."""


@cache
def compiled(phrase: Phrase) -> re.Pattern[str]:
    """The pattern of a phrase."""
    text = phrase.template
    for _ in range(2):  # words have words in them
        for name, words in _WORDS.items():
            text = text.replace(f"<{name}>", words)
    text = text.replace(" ", r"\s+").replace(r"\s+?", r"\s*").replace("¤", r"¤\s*")
    for name in ("a", "b", "way_to"):
        text = text.replace(f"<{name.upper()}>", _thing(name))
    return re.compile(rf"(?<![\w-]){text}(?![\w-])")


def widened(text: str, start: int, end: int) -> tuple[int, int]:
    """The place of a phrase with the words before and behind it that say nothing else."""
    before = _LEADS.search(text, max(0, start - 120), start)
    while (behind := _ENDS.match(text, end)) is not None:
        end = behind.end()
    return (before.start() if before is not None else start), end


PLACE_WORDS = {
    **dict.fromkeys(("door", "doors", "doorway", "entrance", "entry", "exit"), "door"),
    **dict.fromkeys(("window", "windows"), "window"),
    **dict.fromkeys(("wall", "walls"), "wall"),
    **dict.fromkeys(("middle", "centre", "center"), "middle"),
}
"""Parts of the room by the last word of how they are called."""

__all__ = ["PHRASES", "PLACE_WORDS", "Phrase", "compiled", "widened"]
