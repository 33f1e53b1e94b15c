"""The home as a whole: its area, what it stands on, its light, and whether everybody can move in it."""

from __future__ import annotations

from .limits import ABOVE, ROOM, limit_of, say_limit
from .parts import Reading

WHOLE = 0.5
"""Share of what a word for a size changes of one room that it changes of all of them."""

SMALLEST = 14.0
"""Least floor of a home [m2]."""


def read_site(reading: Reading) -> None:
    """Reads area, sides, shape and light of a home, and whether the accessible profile is asked for."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if token.done:
            continue
        if token.has("area"):
            _area(reading, at)
        elif token.has("dims"):
            reading.width, reading.depth = token.get("dims")
            reading.rows.append((token.span, "envelope", f"{reading.width:g} x {reading.depth:g} m"))
            reading.did(at, "envelope")
        elif token.has("length"):
            _length(reading, at)
        elif token.has("l_shape"):
            reading.l_shape = True
            reading.rows.append((token.span, "envelope", "L-shaped"))
            reading.did(at, "envelope")
        elif token.has("one_side", "two_sides", "three_sides") and _of_windows(reading, at):
            reading.window_sides = next(
                n for n, k in ((1, "one_side"), (2, "two_sides"), (3, "three_sides")) if token.has(k)
            )
            reading.rows.append((token.span, "envelope", f"windows on {reading.window_sides} sides"))
            for k in range(max(0, at - 4), at + 1):
                if k == at or tokens[k].has("windows"):
                    reading.did(k, "envelope")
        elif token.has("accessible"):
            _accessible(reading, at)
    _size(reading)
    _light(reading)
    _sides_by(reading)
    at_home = reading.use.plan in ("flat", "house")  # an accessible toilet alone makes no practice of another profile
    if (
        reading.use.profile == "accessible"
        or at_home
        and any(one.accessible or one.kind.name.startswith("accessible") for one in reading.named)
    ):
        reading.accessible = True


def _size(reading: Reading) -> None:
    """ "A small clinic", "a big house": all of its rooms are somewhat smaller or larger."""
    k = (reading.use_at or 0) - 1
    while k >= 0 and not reading.tokens[k].breaks and (reading.use_at or 0) - k < 5:
        token = reading.tokens[k]
        if token.has("size") and not token.done and not token.has("vague"):
            reading.scale = 1.0 + (token.get("size") - 1.0) * WHOLE
            reading.rows.append((token.span, "area", f"rooms of {reading.scale:.0%} of their usual floor"))
            reading.did(k, "area")
        k -= 1


def _area(reading: Reading, at: int) -> None:
    """The area of the home, where no room is right beside it."""
    token = reading.tokens[at]
    low, high = token.get("area")
    before = next((one for one in reversed(reading.named) if one.last < at), None)
    if (
        before is not None
        and not (before.told == "total" and before.last < (reading.use_at or -1) < at)
        and before.root.area is None
        and 0 < at - before.last <= 4
        and not any(t.breaks for t in reading.tokens[before.last + 1 : at])
    ):
        before.root.area = (low, high)
        say_limit(reading, before.root, at)
    elif high < SMALLEST and reading.named:
        return  # no home is as small
    else:
        limit, words = limit_of(reading.tokens, at)
        if limit == "most":
            reading.most, low = high, round(ROOM * high, 1)
        elif limit == "least":
            reading.least, high = low, round(ABOVE * low, 1)
        for k in words:
            reading.did(k, "area")
        reading.area = (low, high)
        said = {"most": "at most ", "least": "at least ", "": ""}[limit]
        number = {"most": high, "least": low, "": (low + high) / 2}[limit]
        reading.rows.append((token.span, "area", f"{said}{number:g} m2 in all"))
    reading.did(at, "area")


def _length(reading: Reading, at: int) -> None:
    """ "A plot of 6 m", "6 m wide", "7 metre wide plot": width, unless it is said to be deep."""
    tokens = reading.tokens
    near = tokens[max(0, at - 3) : at + 3]
    token = tokens[at]
    room = next((one for one in reversed(reading.named) if one.last < at), None)
    if room is not None and at - room.last <= 4 and not any(t.breaks for t in tokens[room.last : at]):
        room.root.side = token.get("length")
        reading.did(at, "rooms")
        if at + 1 < len(tokens) and tokens[at + 1].has("wide"):
            reading.did(at + 1, "rooms")
        return
    deep = any(t.has("deep") for t in tokens[at + 1 : at + 2])
    if not (deep or any(t.has("plot", "wide", "deep") or t.text == "narrow" for t in near)):
        return
    if deep:
        reading.depth = token.get("length")
    else:
        reading.width = token.get("length")
    reading.rows.append((token.span, "envelope", f"{token.get('length'):g} m {'deep' if deep else 'wide'}"))
    for k in range(max(0, at - 3), min(at + 3, len(tokens))):
        if k == at or tokens[k].has("plot", "wide", "deep", "wide plot") or tokens[k].text == "narrow":
            reading.did(k, "envelope")


def _sides_by(reading: Reading) -> None:
    """ "14 m by 12 m", where both were read as lengths."""
    tokens = reading.tokens
    for at, token in enumerate(tokens[:-2]):
        if token.has("length") and tokens[at + 1].text in ("by", "x") and tokens[at + 2].has("length"):
            reading.width, reading.depth = token.get("length"), tokens[at + 2].get("length")
            reading.rows.append((token.span, "envelope", f"{reading.width:g} x {reading.depth:g} m"))
            for k in (at, at + 1, at + 2):
                reading.did(k, "envelope")


def _of_windows(reading: Reading, at: int) -> bool:
    return any(t.has("windows") for t in reading.tokens[max(0, at - 4) : at])


def _light(reading: Reading) -> None:
    """Rooms that are to have daylight, or none: "without windows", "daylight in every exam room"."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if token.done or token.text not in ("windows", "window", "daylight", "light", "windowless"):
            continue
        before = next((one for one in reversed(reading.named) if one.last < at), None)
        after = next((one for one in reading.named if one.first > at), None)
        no = at and tokens[at - 1].has("no") or token.text == "windowless"
        if (
            token.text in ("daylight", "light")
            and after is not None
            and after.first - at <= 3
            and tokens[at + 1].text in ("in", "for")
        ):
            after.root.daylight = True
        elif before is not None and at - before.last <= 5 and not any(t.stops for t in tokens[before.last : at]):
            if no:
                before.root.daylight = False
                reading.did(at - 1, "light")
            elif token.text in ("daylight", "light"):
                before.root.daylight = True
            else:
                continue
        elif reading.window_sides is None:
            continue
        reading.did(at, "light")


def _accessible(reading: Reading, at: int) -> None:
    """Who moves on wheels or with a frame asks for the accessible profile; so do rooms that are told to be."""
    token = reading.tokens[at]
    inside = next((one for one in reading.named if one.first <= at <= one.last), None)
    no = at and reading.tokens[at - 1].has("no")
    if no and token.text not in ("no thresholds",):
        return
    if inside is None:
        reading.accessible = True
        reading.rows.append((token.span, "profile", "accessible"))
        reading.did(at, "profile")
        if token.text in ("turn in", "turning circle"):
            room = next((one for one in reversed(reading.named) if one.last < at), None)
            if room is not None:
                room.accessible = True
