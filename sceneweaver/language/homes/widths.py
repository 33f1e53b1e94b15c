"""Widths that are asked for: of all doors, of halls and corridors."""

from __future__ import annotations

from .parts import Named, Reading
from .tokens import Token

DOORS, WAYS = (0.7, 1.6), (0.8, 4.0)
"""Clear widths [m] that doors and halls are asked to have; others are no such widths."""

REACH = 6
"""Tokens between a width and what it is said of."""

_WAYS = ("hallway", "entrance_hall", "landing")
_CENTIMETRES = ("cm", "centimetre", "centimetres", "centimeter", "centimeters")
_EACH = ("each", "every", "all", "any", "both")


def read_widths(reading: Reading) -> None:
    """ "All doors at least 90 cm", "corridors 1.3 m wide": what each door or hall has to have."""
    for at, token in enumerate(reading.tokens):
        found = None if token.done else _width(reading, at)
        if found is None:
            continue
        width, last = found
        said = _said_of(reading, at, last)
        if said == "doors" and DOORS[0] <= width <= DOORS[1]:
            reading.doors = max(reading.doors or 0.0, width)
        elif isinstance(said, Named) and WAYS[0] <= width <= WAYS[1]:
            reading.ways = max(reading.ways or 0.0, width)
            if said.count is None:
                said.count = 1  # "corridors of 1.2 m" tells no number of them
        else:
            continue
        what = "doors" if said == "doors" else "halls"
        reading.rows.append((token.span, "profile", f"{what} of {width:g} m"))
        for k in range(at, last + 1):
            reading.did(k, "profile")
        for k in range(max(0, at - REACH), min(last + REACH, len(reading.tokens))):
            if said == "doors" and _is_doors(reading.tokens, k) or k == last + 1 and reading.tokens[k].has("wide"):
                reading.did(k, "profile")


def _width(reading: Reading, at: int) -> tuple[float, int] | None:
    """A length [m] with the number of its last token; None where there is none."""
    tokens = reading.tokens
    if (metres := tokens[at].get("length")) is not None:
        return float(metres), at
    number = tokens[at].get("number")
    if number is not None and at + 1 < len(tokens) and tokens[at + 1].text in _CENTIMETRES:
        return round(float(number) / 100, 3), at + 1
    return None


def _said_of(reading: Reading, at: int, last: int) -> Named | str | None:
    """What a width is said of: "doors", the halls of a name, or None; in its clause, the nearest, first before it."""
    tokens = reading.tokens
    before, after = range(at - 1, max(-1, at - REACH - 1), -1), range(last + 1, min(last + 4, len(tokens)))
    for numbers in (before, after):
        for k in numbers:
            if tokens[k].breaks:
                break
            if _is_doors(tokens, k):
                return "doors"
            named = next((one for one in reading.named if one.first <= k <= one.last), None)
            if named is not None:
                if named.kind.name in _WAYS:
                    return named
                break
    return None


def _is_doors(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether a token is about all doors, and not about one of them."""
    words = tokens[at].text.split()
    if {"doors", "doorways"} & {*words}:
        return True
    one = bool({"door", "doorway"} & {*words})
    width = at + 1 < len(tokens) and tokens[at + 1].text in ("width", "widths")
    return one and (width or any(t.text in _EACH for t in tokens[max(0, at - 2) : at]))
