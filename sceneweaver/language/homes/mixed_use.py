"""Homes with a business: a shop, bakery, studio or practice with a flat is both, each with the rooms that it needs."""

from __future__ import annotations

from collections.abc import Sequence

from .lexicon import Use, trades, uses
from .parts import Reading
from .resolve import Room, bedroomlike
from .tokens import Token
from .use_named import is_named_home, is_setting

_RUN = (
    "run",
    "runs",
    "running",
    "own",
    "owns",
    "work",
    "works",
    "worked",
    "left",
    "sold",
    "manage",
    "manages",
    "teach",
)
"""Words before a business that is elsewhere: "she runs a clinic", "I work at a bank"."""

REACH = 4
"""Tokens before a business among which such a word stands."""


def mixed_in(tokens: Sequence[Token]) -> tuple[Use, int, Use, int] | None:
    """The home and the business that a request names, each with the number of its token; None where it names one only.

    A home over or beside a business that is somebody else's is one only: "a flat above a bakery".
    """
    homes = [at for at, token in enumerate(tokens) if is_named_home(tokens, at)]
    works = [at for at in range(len(tokens)) if (_business(tokens, at)) is not None]
    if not homes or not works:
        return None
    business = _business(tokens, works[0])
    assert business is not None
    return uses()["house"], homes[0], business, works[0]


def regions(tokens: Sequence[Token]) -> list[bool]:
    """For each token whether it tells of the business: from its name up to that of the home, within a sentence."""
    found, inside = list[bool](), False
    for at, token in enumerate(tokens):
        if token.stops or is_named_home(tokens, at):
            inside = False
        elif _business(tokens, at) is not None:
            inside = True
        found.append(inside)
    return found


def join_business(reading: Reading) -> None:
    """One room of a business that is named by the business and again by itself: "a bakery with a shop"."""
    if reading.second is None:
        return
    main = next(iter(reading.second.needs)).split("|")[0]
    names = [one for one in reading.named if one.kind.name == main and reading.business[one.at]]
    for one in names[1:]:
        if one.told in ("", "article"):
            one.of, one.count = names[0], None
    for at, token in enumerate(reading.tokens):
        if (reading.business[at] and token.has("use")) or (token.has("trade") and any(n.at == at for n in names)):
            reading.did(at, "use")


def place_business(reading: Reading, rooms: list[Room]) -> list[str]:
    """Rooms of a business lie on the ground floor where the home is upstairs; the main one has a door outside."""
    if reading.second is None:
        return []
    own = [room for room in rooms if _is_of_business(reading, room)]
    upstairs = reading.live_storey or any(
        bedroomlike(room.kind) and room.storey not in (None, "ground") for room in rooms
    )
    for room in own:
        if upstairs and room.storey is None:
            room.storey = "ground"
    main = next(iter(reading.second.needs)).split("|")[0]
    first = next((room for room in own if room.counts_as(main)), own[0] if own else None)
    for one in first.named if first is not None else ():
        one.outside = one.outside or "also"
    return [f"{first.id}: a door of its own outside, as a business has it"] if first is not None and first.named else []


def _is_of_business(reading: Reading, room: Room) -> bool:
    assert reading.second is not None
    if room.named:
        return any(one.at >= 0 and reading.business[one.at] for one in room.named)
    needs = {name for names in reading.second.needs for name in names.split("|")}
    return any(room.counts_as(name) for name in needs) and not any(room.counts_as(n) for n in reading.use.needs)


def _business(tokens: Sequence[Token], at: int) -> Use | None:
    """The business that a token names as a part of what is asked for."""
    token = tokens[at]
    named = token.get("use")
    use = trades()[token.get("trade")] if token.has("trade") else uses()[named[0]] if named and not named[1] else None
    if use is None or token.plural or token.has("room", "means") or use.plan == "house":
        return None
    before = {word for t in tokens[max(0, at - REACH) : at] for word in t.text.split()}
    return None if before & {*_RUN} or is_setting(tokens, at) else use
