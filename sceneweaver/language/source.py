"""The text of a request in lower case with the place of each character in the original, and its measures."""

from __future__ import annotations

import math
import re
import unicodedata
from dataclasses import dataclass, field

from sceneweaver.scene import InputError

from .model import Span
from .quantities import plain_quantities
from .translation import NAMES, language_of, translated
from .vocabulary import vocabulary

MOST = 100_000
"""Characters that a request has at most."""

LONGEST_RUN = 16
"""Digits or blanks in a row that are read; the rest is left out."""

LONGEST = 20_000
"""Characters that are read; a longer request is cut there, with a note."""

FOOT, INCH = 0.3048, 0.0254
TATAMI = 1.653
"""Floor [m2] under one mat."""

SQUARE_FOOT = FOOT**2

_GAP = r"\s{0,9}"
"""White space inside a measure. It has an end, as has all that patterns repeat: their time is linear then."""

_NUMBER = r"(\d{1,9}(?:[.,]\d{1,6})?)"
_LENGTH = r"(meters?|metres?|m|cm|centimet(?:er|re)s?|feet|foot|ft|')"
_BY = rf"{_GAP}(?:x|×|by|\*){_GAP}"
_AXIS = rf"{_GAP}(?:long|wide|deep|broad|in\s{{1,9}}length|in\s{{1,9}}width)"
_SQUARE = re.compile(
    rf"{_NUMBER}{_GAP}-?{_GAP}(m2|m²|sqm|sq\.?{_GAP}m(?:et(?:er|re)s?)?|square[\s-]?met(?:er|re)s?|square[\s-]?m|"
    rf"sq\.?{_GAP}ft\.?|sqft|square[\s-]?f(?:ee|oo)t|ft2|ft²)(?![a-z])"
)
_MATS = re.compile(
    rf"{_NUMBER}{_GAP}-?{_GAP}(?:tatami|jo|jō|mat)(?:\s{{1,9}}mats?)?(?=\s{{0,9}}(?:room|tea|floor|in size|[.,;)]|$))"
)
"""A floor of so many mats, as Japanese rooms are measured."""

_FREE = r"(?:free|clear|open|empty|unobstructed|uncluttered|unoccupied|spare)"
_FREE_BEHIND = re.compile(
    rf"{_GAP}(?:of{_GAP})?(?:(?:must|should|has|have|to|is|are|be|stay|stays|remain|kept|left|completely|totally|at all"
    rf"|floor|space|area|the){_GAP}){{0,6}}{_FREE}(?![a-z])"
)
_FREE_BEFORE = re.compile(
    rf"(?<![a-z]){_FREE}{_GAP}(?:floor|space|area|room|ground|zone|spot|patch)?{_GAP}(?:space|area)?{_GAP}"
    rf"(?:of{_GAP})?(?:(?:at{_GAP}least|about|around|roughly|approximately|some){_GAP})?$"
)
_KEPT = re.compile(rf"(?:keep|leave|leaving|keeping){_GAP}(?:(?:at{_GAP}least|about|around|some){_GAP})?$")

_SIDE = rf"{_NUMBER}{_GAP}{_LENGTH}?"
_SIDES = re.compile(rf"{_SIDE}(?:{_AXIS})?{_BY}{_SIDE}(?:{_AXIS})?(?:{_BY}{_SIDE})?(?![\w])")
_LONG_WIDE = re.compile(
    rf"{_NUMBER}{_GAP}{_LENGTH}{_AXIS}{_GAP}(?:and|,){_GAP}{_NUMBER}{_GAP}{_LENGTH}{_AXIS}(?![a-z])"
)
_CEILING = re.compile(
    rf"(?:{_NUMBER}{_GAP}-?{_GAP}{_LENGTH}{_GAP}-?{_GAP}(?:high|tall)?{_GAP}-?{_GAP}ceilings?"
    rf"|(?:ceilings?|headroom|head{_GAP}height){_GAP}(?:height)?{_GAP}(?:of|is|at|:|only)?{_GAP}{_NUMBER}{_GAP}{_LENGTH}"
    rf"(?:{_GAP}high)?"
    rf"|{_NUMBER}{_GAP}{_LENGTH}{_GAP}(?:high{_GAP})?(?:at|to){_GAP}(?:the|its){_GAP}(?:ridge|apex|peak|highest(?:{_GAP}point)?)"
    rf"|(?:room\s{{1,9}})?height{_GAP}(?:of|is|:)?{_GAP}{_NUMBER}{_GAP}{_LENGTH})(?![a-z])"
)
_LOW_CEILING = re.compile(
    rf"ceilings?{_GAP},?{_GAP}(?:(?:is|of|only|about|at|most|max|maximum|under|no|more|than){_GAP}){{0,4}}"
    rf"{_NUMBER}{_GAP}{_LENGTH}(?:{_GAP}(?:at{_GAP}most|at{_GAP}least|max(?:imum)?|high))?(?![a-z])"
)
_PARTIAL = ("low", "half", "knee", "height", "high", "partition", "dividing", "pony", "a")
_OF_ROOM = "".join(rf"(?<!{word} )" for word in _PARTIAL)  # a low wall is none of the room's
_WALLS_HIGH = re.compile(rf"{_OF_ROOM}\bwalls?{_GAP}(?:of{_GAP})?{_NUMBER}{_GAP}{_LENGTH}{_GAP}(?:high|tall)(?![a-z])")
_AND_HIGH = re.compile(rf"§\s{{0,40}}(?:and|,){_GAP}{_NUMBER}{_GAP}{_LENGTH}{_GAP}(?:high|tall)(?![a-z])")
_PARTS = re.compile(r"(?<![\w.])(\d{1,2})\s?(?:m|meters?|metres?)\s(\d\d)(?![\w.]|\s?(?:cm|mm|m|inch))")
"""Metres and centimetres in two numbers: "2 metres 10"."""

_ON = re.compile(rf"{_NUMBER}{_GAP}{_LENGTH}{_GAP}on{_GAP}{_NUMBER}{_GAP}{_LENGTH}(?![a-z])")
_WORDS = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen"
_DIGITS = dict(zip([*_WORDS.split(), "eighteen", "nineteen", "twenty"], range(1, 21), strict=True))
_SPELT_BY = re.compile(r"(?<=\bby )(" + "|".join(_DIGITS) + r")\b")
_SPELT = re.compile(
    r"\b(" + "|".join(_DIGITS) + rf")\b(?={_GAP}-?{_GAP}(?:by|x|square|sq|m|met(?:er|re)s?|feet|foot|ft|cm)\b)"
)
_FAR = re.compile(rf"{_NUMBER}{_GAP}(?:km|kilomet(?:er|re)s?|miles?)\b")
_ENDLESS = re.compile(r"\d{10,}")
_ENDLESS_WORD = re.compile(r"[^\W\d_]{81,}")
"""No language with spaces has such a word; what looks for its end at each of its letters would take long."""

_ENDLESS_JOINED = re.compile(r"[a-z'/_-]{81,}")
"""Words with hyphens between them, too many for one: they are read as words of their own."""

_WRAPPED = re.compile(r"(?<=[^\n]{60})(?<!\s)\s*\n(?=[a-z])")
"""The end of a long line that was wrapped. It begins with the first white space, so that its time is linear."""

_SHORTENED = re.compile(r"(?<![a-z])(min|max|approx|ca|incl)\.(?=\s{0,9}\d)")
"""Shortened words, whose full stop ends no sentence."""

_LISTED = re.compile(r"(?<=[a-z0-9)]) [+/] (?=[a-z0-9])")
"""Signs between the items of a list."""

_COUNTED = "|".join([*_DIGITS, r"\d{1,9}(?:[.,]\d{1,3})?"])
_NO_COUNT = re.compile(rf"(?<![\w.,/§-])(?P<sign>minus |(?<=[a-z] )-)?(?P<number>{_COUNTED})(?= [a-z])")
"""Numbers before words, of which those below zero and between whole ones count no things."""

_HALF = re.compile(r"\bhalf an? (?=[a-z])")
_TWICE_NOT = re.compile(r"\bnot not\b")
_TAG = re.compile(r"<[^<>]{0,200}>")
_PLAIN = {"‘": "'", "’": "'", "“": '"', "”": '"', "–": "-", "—": ",", "…": ".", "\u00a0": " ", "²": "2"}


@dataclass
class Source:
    """Characters to read, with the index of each in the request; measures are blanked out of them.

    ``sides`` are [m] by the place where they stood; ``size``, ``area`` [m2] and ``height`` [m] are the room's.
    """

    text: str
    origin: list[int]
    size: tuple[float, float] | None = None
    area: float | None = None
    height: float | None = None
    sides: dict[int, tuple[float, ...]] = field(default_factory=dict)
    free: set[int] = field(default_factory=set[int])
    """Where sides stood that are of floor to keep free."""
    colons: set[int] = field(default_factory=set[int])
    spoken: str = ""
    """All of the text in lower case, before anything is taken out; characters stand where they do in ``text``."""
    notes: list[str] = field(default_factory=list)
    language: str = "en"
    slips: dict[str, str] = field(default_factory=dict[str, str])
    """Words that were mended, with what was meant."""
    told: dict[Span, float] = field(default_factory=dict[Span, float])
    """Numbers that were written out, by where their words stand in the request."""

    def span(self, start: int, end: int) -> Span:
        """Where characters [start, end) stand in the request."""
        last = max(min(end, len(self.origin)) - 1, start)
        if self.language == "en":
            return Span(self.origin[start], self.origin[last] + 1)
        places = self.origin[start : last + 1]  # words of another language may stand in another order
        return Span(min(places), max(places) + 1)

    def insert(self, at: int, text: str, like: int) -> None:
        """Puts words in before character ``at``, which stand in the request where those from ``like`` on do."""
        n = len(text)
        self.text = self.text[:at] + text + self.text[at:]
        self.spoken = self.spoken[:at] + text + self.spoken[at:]
        own = [self.origin[min(max(like, like + k - n + len(text.lstrip())), len(self.origin) - 1)] for k in range(n)]
        self.origin = self.origin[:at] + own + self.origin[at:]
        self.sides = {k + n * (k >= at): sides for k, sides in self.sides.items()}
        self.free = {k + n * (k >= at) for k in self.free}
        self.colons = {k + n * (k >= at) for k in self.colons}

    def replace(self, start: int, end: int, instead: str = "") -> None:
        """Blanks characters [start, end) and puts words behind them, which stand in the request where these did."""
        self.text = self.text[:start] + " " * (end - start) + self.text[end:]
        if instead:
            self.insert(end, instead, start)

    def blank(self, pattern: re.Pattern[str], read: object) -> None:
        """Measures of a pattern are taken out when ``read`` understands them; the length stays the same."""

        def replace(m: re.Match[str]) -> str:
            filler = read(m)  # type: ignore[operator]
            return m[0] if filler is None else filler[: len(m[0])].ljust(len(m[0]))

        self.text = pattern.sub(replace, self.text)


def check_text(text: object) -> None:
    """Refuse what is no request: nothing, or a book.

    Raises:
        InputError: one line that says what to give.
    """
    if not isinstance(text, str) or not text.strip():
        raise InputError('prompt: it is empty; say what room you want, such as "a bedroom with a desk"')
    if len(text) > MOST:
        raise InputError(f"prompt: it has {len(text)} characters; give {MOST} at most, the first {LONGEST} are read")


def read_source(text: str) -> Source:
    """Lower case, without control characters and markup, and without measures."""
    notes: list[str] = []
    letters: list[str] = []
    origin: list[int] = []
    last, run = "", 0
    for index, letter in enumerate(text):
        if len(letters) >= LONGEST:  # one letter may stand for twenty
            notes.append(f"only the first {index} of {len(text)} characters were read")
            break
        for plain in unicodedata.normalize("NFKC", _PLAIN.get(letter, letter)).lower():
            if plain.isdigit() and not plain.isdecimal():  # in a circle, raised ...: no number that int() reads
                plain = str(unicodedata.digit(plain))
            plain = plain if plain.isprintable() or plain in "\n\t" else " "
            kind = "9" if plain.isdigit() else plain if plain.isspace() else ""
            run = run + 1 if kind and kind == last else 1
            last = kind
            if run <= LONGEST_RUN:  # of digits or blanks more say no more, and patterns look at each from each
                letters.append(plain)
                origin.append(index)
    spoken = "".join(letters).replace("§", " ")
    language = language_of(spoken)
    if language != "en":
        spoken, origin = translated(spoken, origin, language, text)
        notes.append(f"read as {NAMES[language]}, word by word")
    told: dict[Span, float] = {}
    spoken, origin = plain_quantities(spoken, origin, told)
    found = Source(spoken, origin, notes=notes, language=language, told=told)
    found.blank(_TAG, lambda m: " ")
    found.blank(_ENDLESS, lambda m: _endless(m, found))
    found.blank(_ENDLESS_WORD, lambda m: _endless_word(m, found))
    found.blank(_ENDLESS_JOINED, lambda m: re.sub("[^a-z]", " ", m[0]))
    found.blank(_WRAPPED, lambda m: " ")
    found.blank(_SHORTENED, lambda m: m[1])
    found.blank(_LISTED, lambda m: " & ")
    found.blank(_TWICE_NOT, lambda m: " ")
    found.spoken = found.text
    found.colons = {k for k, letter in enumerate(found.text) if letter == ":"}
    found.text = re.sub(r"[\n;:!?•*|]|(?<=\s)-(?=\s)", ".", found.text)
    found.blank(_SPELT, lambda m: str(_DIGITS[m[1]]))
    found.blank(_SPELT_BY, lambda m: str(_DIGITS[m[1]]))
    found.blank(_PARTS, lambda m: f"{m[1]}.{m[2]} m")
    found.blank(_FAR, lambda m: _too_far(m, found))
    found.blank(_CEILING, lambda m: _ceiling(m, found))
    found.blank(_LOW_CEILING, lambda m: _ceiling(m, found))
    found.blank(_SQUARE, lambda m: _free_square(m, found) or _square(m, found))
    found.blank(_MATS, lambda m: _mats(m, found))
    found.blank(_LONG_WIDE, lambda m: _sides(m, found))
    found.blank(_SIDES, lambda m: _sides(m, found))
    found.blank(_ON, lambda m: _on(m, found))
    found.blank(_AND_HIGH, lambda m: "§" if _ceiling(m, found) else None)
    found.blank(_NO_COUNT, lambda m: _whole(m, found))
    found.blank(_HALF, lambda m: _no_half(m, found))
    found.blank(_WALLS_HIGH, lambda m: _walls(m, found))
    return found


def metres(number: str, unit: str | None) -> float:
    """A length in metres."""
    value = float(number.replace(",", "."))
    if unit and unit.startswith(("cm", "centi")):
        return value / 100
    if unit and unit.startswith(("mm", "milli")):
        return value / 1000
    if unit and unit.startswith(("in", '"')):
        return value * INCH
    if unit and unit.startswith(("f", "'")):
        return value * FOOT
    if unit and unit.startswith("y"):
        return value * 3 * FOOT
    return value


def _ceiling(m: re.Match[str], found: Source) -> str:
    groups = [g for g in m.groups() if g]
    found.height = metres(groups[0], groups[1])
    return " ,"


def _walls(m: re.Match[str], found: Source) -> str:
    """Walls of a height need a ceiling as high; the word stays, as something may be said of them."""
    found.height = max(found.height or 0.0, metres(m[1], m[2]))
    return "wall"


def _on(m: re.Match[str], found: Source) -> str:
    """ "2.1 m on 4 m" are sides, where a room may have them."""
    sides = metres(m[1], m[2]), metres(m[3], m[4])
    if min(sides) < 1.5:
        return m[0]
    found.sides[m.start()] = sides
    return "§"


def _square(m: re.Match[str], found: Source) -> str:
    found.area = float(m[1].replace(",", ".")) * (SQUARE_FOOT if "f" in m[2] else 1.0)
    return " "


def _mats(m: re.Match[str], found: Source) -> str | None:
    """A floor of 3 mats and more; mats lie on it, so they stay as words where they are named."""
    count = float(m[1].replace(",", "."))
    if count < 3 or found.area is not None or ("mat" in m[0] and "tatami" not in m[0] and count % 0.5):
        return None
    found.area = round(count * TATAMI, 2)
    return " tatami" if "tatami" in m[0] else " "


def _free_square(m: re.Match[str], found: Source) -> str | None:
    """Square metres that are to stay free are no floor of a room: a square of that area stands for them."""
    before, behind = m.string[max(0, m.start() - 60) : m.start()], m.string[m.end() :]
    free = _FREE_BEHIND.match(behind) or _FREE_BEFORE.search(before)
    if free is None and not (_KEPT.search(before) and re.search(rf"(?<![a-z]){_FREE}(?![a-z])", behind[:30])):
        return None
    side = round(math.sqrt(float(m[1].replace(",", ".")) * (SQUARE_FOOT if "f" in m[2] else 1.0)), 4)
    found.sides[m.start()] = (side, side)
    found.free.add(m.start())
    return "§"


def _sides(m: re.Match[str], found: Source) -> str | None:
    groups = [*m.groups(), None, None][:6]
    unit = groups[5] or groups[3] or groups[1]
    if unit is None:  # whose they may be tells the unit of bare numbers (`statements.room_sides`)
        return None
    values = [metres(n, u or unit) for n, u in zip(groups[::2], groups[1::2], strict=True) if n]
    found.sides[m.start()] = tuple(round(v, 4) for v in values)
    return "§"


def _endless(m: re.Match[str], found: Source) -> str:
    found.notes.append(f"'{m[0][:10]}...' is no number that a room has; it was read as the largest there is")
    return "9" * 9


def _whole(m: re.Match[str], found: Source) -> str | None:
    """A number of things that is none, as -3 and 2.5, with a note; a measure and a whole number stay as they are."""
    decimal = re.search("[.,]", m["number"]) is not None
    if not (m["sign"] or decimal) or not _things_follow(m):
        return None
    number = m["number"] if m["number"] in _DIGITS else str(max(1, int(float(m["number"].replace(",", ".")))))
    found.notes.append(f"'{m[0]}' is no number of things; it was read as {number}")
    return number


def _no_half(m: re.Match[str], found: Source) -> str | None:
    """A half of a thing is a whole one, with a note."""
    if not _things_follow(m):
        return None
    found.notes.append(f"'{m[0].strip()}' is no number of things; it was read as one")
    return "a "


def _things_follow(m: re.Match[str]) -> bool:
    """Whether a match stands before the name of a thing."""
    spoken = re.findall(r"[a-z]+", m.string[m.end() : m.end() + 60])[:3]
    if not spoken or re.fullmatch(_LENGTH, spoken[0]):
        return False
    return any("noun" in vocabulary().get(name, {}) for name in (" ".join(spoken[:2]), spoken[0]))


def _endless_word(m: re.Match[str], found: Source) -> str:
    found.notes.append(f"'{m[0][:10]}...' is no word, with its {len(m[0])} letters; it was left out")
    return " "


def _too_far(m: re.Match[str], found: Source) -> str:
    found.notes.append(f"'{m[0]}' is no measure of a room; it was left open")
    return " "


def check_measures(found: Source) -> None:
    """Measures that no room has are left out, with a note."""
    if found.size is not None and (min(found.size) < 0.8 or max(found.size) > 100):
        found.notes.append(f"a room of {found.size[0]:g} x {found.size[1]:g} m cannot be made; its size was left open")
        found.size = None
    if found.area is not None and not 1.0 <= found.area <= 3000:
        found.notes.append(f"a floor of {found.area:g} m2 cannot be made; its size was left open")
        found.area = None
    if found.height is not None and not 1.8 <= found.height <= 12:
        found.notes.append(f"a ceiling at {found.height:g} m cannot be made; its height was left open")
        found.height = None
