"""Which home, practice, office or school a request is for, and whether it is for one at all."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from sceneweaver.language.vocabulary import vocabulary

from .lexicon import Use, data, room_kinds, uses
from .tokens import Token

_SETTING = (
    "in",
    "of",
    "at",
    "from",
    "near",
    "to",
    "into",
    "inside",
    "by",
    "on",
    "around",
    "outside",
    "behind",
    "under",
    "above",
    "below",
)
_DETERMINERS = ("a", "an", "the", "our", "my", "your", "his", "her", "their", "this", "that", "some")
_ASKING = (
    "need",
    "needs",
    "want",
    "wants",
    "for",
    "of",
    "and",
    "or",
    "in",
    "new",
    "shared",
    "my",
    "buy",
    "rent",
    "buying",
    "design",
    "plan",
)
_WEAK = ("place", "unit", "residence", "home", "hall", "annexe")
"""Names of homes that are also other words."""


def use_in(tokens: Sequence[Token]) -> tuple[Use, int] | None:
    """The use that a request names as what it is for, and the number of its token; None where it names none."""
    found: list[tuple[bool, int, str]] = []
    for at, token in enumerate(tokens):
        named = token.get("use")
        if named is None or is_setting(tokens, at) or _is_modifier(tokens, at) or _is_one_room(tokens, at):
            continue
        if named[1] and (token.plural or not _is_noun(tokens, at)):
            continue
        if token.text in _WEAK and not _is_asked(tokens, at):
            continue
        if not named[1] and token.has("room", "means") and _after_rooms(tokens, at):
            continue
        found.append((not (named[1] or not token.has("room", "means")), at, named[0]))
    if not found:
        return None
    _, at, name = min(found, key=lambda one: one[:2])  # an "office" is a room of a flat
    return uses()[name], at


def is_named_home(tokens: Sequence[Token], at: int) -> bool:
    """Whether a token names a home that is asked for, beside a business: "upstairs a flat", "and our house"."""
    named = tokens[at].get("use")
    if named is None or not named[1] or tokens[at].plural or tokens[at].text in _WEAK and not _is_asked(tokens, at):
        return False
    return not (is_setting(tokens, at) or _is_modifier(tokens, at) or _is_one_room(tokens, at)) and _is_noun(tokens, at)


def is_setting(tokens: Sequence[Token], at: int) -> bool:
    """Whether a home is only where the room is: "in a flat", "of our house"."""
    k = at - 1
    while k >= 0 and not tokens[k].breaks and at - k < 6:
        token = tokens[k]
        if k and tokens[k - 1].glued:
            k -= 1  # "walk-in health centre"
            continue
        if token.text == "for":
            return any(t.has("room", "known_room") for t in tokens[:k] if not t.has("use"))
        if token.text == "to" and not (tokens[k + 1].text in _DETERMINERS or tokens[k + 1].number is not None):
            return False  # "we want to share a flat"
        if token.text in _SETTING or token.has("joint") and not token.has("own", "size"):
            return not _is_wish_of(tokens, k)
        in_phrase = (
            token.text in _DETERMINERS
            or token.number is not None
            or token.has("own", "soft", "size", "person", "storey_words")
            or not token.kinds
        )
        in_phrase = (
            in_phrase
            or token.text in ("bedroom", "bed", "room", "bath", "bathroom")
            and tokens[k - 1].number is not None
        )
        if not in_phrase:
            return False
        k -= 1
    return False


def _is_wish_of(tokens: Sequence[Token], at: int) -> bool:
    """ "The plan of a house", "a kind of cottage": what stands before it is no room."""
    before = tokens[at - 1].text if at else ""
    return tokens[at].text == "of" and before in (
        "plan",
        "kind",
        "sort",
        "type",
        "layout",
        "design",
        "model",
        "floor plan",
    )


def _is_noun(tokens: Sequence[Token], at: int) -> bool:
    """Whether a name of a home is a noun here, with an article, a number or nothing before what it is like: nothing
    "lies flat"."""
    for k in range(at - 1, max(-1, at - 7), -1):
        token = tokens[k]
        if (
            token.breaks
            or token.text in _DETERMINERS
            or token.number is not None
            or token.has("room", "use", "storey_words")
        ):
            return True
        if token.has("function") and not token.has("own", "size", "soft", "person"):
            return tokens[at].text != "flat" or token.text in _ASKING
        if tokens[at].text == "flat" and "verb" in vocabulary().get(token.text, {}):
            return False
    return True


def _is_modifier(tokens: Sequence[Token], at: int) -> bool:
    """Whether a home only says what kind of thing or room follows: "cabin living room", "house plants"."""
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    if after is None or after.breaks or after.number is not None:
        return False
    if tokens[at].text == "flat" and not after.kinds:
        return True
    if after.text in data("words")["buildings"] and not tokens[at].get("use")[1]:
        return False
    k = at + 1
    while k < len(tokens) and k < at + 4 and not tokens[k].kinds:
        k += 1
    if k > at + 1 and k < len(tokens) and tokens[k].has("room") and not tokens[k].plural:
        return True  # "a farmhouse retreat bedroom"
    if after.text in (
        "style",
        "styled",
        "themed",
        "like",
        "type",
        "feel",
        "atmosphere",
        "vibe",
        "room",
        "rooms",
        "corner",
        "nook",
    ):
        return True
    if after.has("room", "known_room") and not after.has("joint", "storey", "own", "function"):
        return after.text not in ("living",)
    if after.kinds or tokens[at].plural:
        return False
    kinds = vocabulary().get(after.text, {})
    return bool(kinds.keys() & {"noun", "room", "group"}) and "verb" not in kinds and "preposition" not in kinds


def _is_one_room(tokens: Sequence[Token], at: int) -> bool:
    """ "A studio apartment", "a tiny house" are one room."""
    before = tokens[at - 1].text if at else ""
    two = f"{tokens[at - 2].text} {before}" if at > 1 else ""
    after = [t.text for t in tokens[at + 1 : at + 4]]
    if after in (["of", "one", "room"], ["with", "one", "room"], ["in", "one", "room"]):
        return True
    return (
        before in data("words")["of_one_room"]
        or two in data("words")["of_one_room"]
        or (before == "room" and at > 1 and tokens[at - 2].text in ("one", "1", "single"))
    )


def _is_asked(tokens: Sequence[Token], at: int) -> bool:
    """Whether a word that often is no home is one: with an article, or behind its rooms."""
    token = tokens[at]
    before = [t.text for t in tokens[max(0, at - 4) : at]]
    behind_rooms = bool({"bed", "beds", "bath", "baths", "bedroom", "bedrooms", "storey", "story"} & set(before))
    if token.text in ("place", "unit", "hall") or token.plural:
        return behind_rooms and not token.plural
    first = at == 0 or tokens[at - 1].breaks
    return first or behind_rooms or bool({"a", "an", "new", "our", "the", "this", "family", "one"} & set(before))


def _after_rooms(tokens: Sequence[Token], at: int) -> bool:
    """Whether other rooms are named before, so that this is one of them."""
    if tokens[at].plural:
        return True
    number = next((t.get("number") for t in reversed(tokens[max(0, at - 3) : at]) if t.get("number") is not None), None)
    if (
        number is not None
        and number > 1
        and not any(t.text in ("storey", "floor") for t in tokens[max(0, at - 3) : at])
    ):
        return True
    return any(t.has("room") and not t.has("use") for t in tokens[:at])


@cache
def _roles() -> frozenset[str]:
    return frozenset(name for row in data("uses").values() for name in row.get("needs", {}))


def use_by_rooms(kinds: Sequence[str], storeys: int) -> Use:
    """The use that rooms tell, where none is named: where people sleep or cook they live."""
    types = {room_kinds()[kind].type if kind in room_kinds() else kind for kind in kinds}
    if types & {"examination_room", "doctors_office", "treatment_room", "waiting_room", "operating_theatre", "ward"}:
        return uses()["clinic"]
    if types & {"classroom"}:
        return uses()["school"]
    if types & {"open_office", "meeting_room", "private_office"} and not types & {"bedroom", "living_room"}:
        return uses()["office"]
    return uses()["house" if storeys > 1 or "garage" in types else "flat"]
