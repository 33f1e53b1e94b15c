"""Rooms as a request names them: kind, number, size, area, what they are like."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from sceneweaver.knowledge.load import room_types, room_words
from sceneweaver.language.model import Span
from sceneweaver.language.vocabulary import vocabulary

from .lexicon import RoomKind, plain, room_kinds
from .parts import Named, Reading
from .tokens import Token

_DEFINITE = ("the", "our", "my", "their", "his", "her", "its", "your")
_BEDS = ("bed", "beds", "bd", "br", "bhk", "bedroomed", "bedder")
_LISTED = ("living", "dining", "waiting", "theatre", "recovery", "master", "entry", "check in", "administration", "ladies", "gents")
"""Names of rooms that are also other words: rooms only in lists."""

_BEHIND_LIST = ("and", "on", "of", "in", "for", "by", "/", "&", "or", "with", "at", "near")
_ONLY_COUNTED = ("room", "double", "chair", "desk", "hot desk", "shower", "flat", "hall", "studio", "lounge", "bar", "ward", "gallery",
                 "waiting", "theatre", "lab", "surgery")
_LOOK_KINDS = ("styles", "moods", "color", "materials", "material", "finish", "adjective", "density", "room_scale", "scale", "shape")


def read_mentions(reading: Reading) -> None:
    """Finds the rooms that a request names."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if at == reading.use_at:
            continue
        if (total := _total(reading, at)) is not None:
            reading.named.append(total)
            continue
        kind = _kind(reading, at)
        if kind is not None:
            reading.named.append(_named(reading, at, kind))
        elif token.text in ("sleeps", "sleep") and (sleeper := _sleeper(reading, at)) is not None:
            reading.named.append(sleeper)


def _total(reading: Reading, at: int) -> Named | None:
    """ "3 bed", "three-room flat", "2-bedroom": how many rooms to sleep in a home has."""
    tokens = reading.tokens
    token, number = tokens[at], tokens[at - 1].get("number") if at else None
    if number is None or reading.use.plan not in ("flat", "house") or not 0 < number < 20:
        return None
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    glued = tokens[at - 1].glued
    leads = after is not None and (after.has("use") or after.get("number") is not None or after.text in ("place", "unit"))
    short = token.text in _BEDS and (leads or glued and not (after is not None and is_thing(after)))
    compound = token.text in ("bedroom", "bedrooms") and (leads or glued)
    rooms = token.text in ("room", "rooms", "roomed") and (leads or glued) and not token.plural
    if not (short or compound or rooms) or (rooms and after is not None and after.text == "of"):
        return None
    count = int(number) - (1 if rooms else 0)
    span = _over(tokens[at - 1], token)
    reading.did(at - 1, "rooms")
    reading.did(at, "rooms")
    if count < 1:
        return None
    if rooms:
        reading.notes.append(f"{int(number)} rooms were counted as a living room and {count} to sleep in")
    return Named(room_kinds()["bedroom"], at, at - 1, at, span, count, "total")


def _sleeper(reading: Reading, at: int) -> Named | None:
    """ "Grandad sleeps downstairs": his bedroom."""
    before = reading.tokens[at - 1] if at else None
    kinds = {"seniors": "senior_bedroom", "couples": "master_bedroom", "parents": "master_bedroom", "children": "childrens_room", "adults": "bedroom",
             "twins": "childrens_room", "babies": "nursery"}
    name = kinds.get(before.get("person")) if before is not None and reading.use.plan in ("flat", "house") else None
    if name is None:
        return None
    reading.did(at, "rooms")
    return Named(room_kinds()[name], at, at, at, reading.tokens[at].span, 1, "", definite=True, noun=room_kinds()[name].noun)


def _kind(reading: Reading, at: int) -> RoomKind | None:
    """The kind of room that a token names here; None where it names none."""
    tokens, use = reading.tokens, reading.use
    token = tokens[at]
    if not token.has("room", "means", "known_room", "use"):
        return None
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    single = plain(_singular(token))
    meant = use.means.get(single)
    if meant is None and not token.has("room", "known_room"):
        return None
    if after is not None and not token.plural and is_thing(after) and not after.breaks:
        return None  # "kitchen table", "bathroom door"
    if after is not None and after.text in ("door", "doors", "wall", "window", "windows", "furniture") and not after.breaks:
        return None
    if single in _LISTED and meant is None and not (after is None or after.breaks or after.text in _BEHIND_LIST):
        return None
    if single in _ONLY_COUNTED and not _may_be(tokens, at, single):
        return None
    if single == "room" and at and not tokens[at - 1].kinds and _unknown_room(tokens, at):
        words = _words_before(tokens, at)
        base = room_kinds()[meant or "bedroom"] if use.plan not in ("flat", "house") else room_kinds()["hobby_room"]
        return RoomKind(base.name, base.type, " ".join([*words, "room"]), base.counts_as)
    if meant is not None:
        options = [option for option in meant.split("|") if option in room_kinds()]
        return room_kinds()[options[0]] if options else None
    if token.has("room"):
        return room_kinds()[token.get("room")]
    return known_room(token.get("known_room"), single)


def _may_be(tokens: Sequence[Token], at: int, single: str) -> bool:
    """Whether a word that is often no room is one here: it is counted, in the plural, or its own."""
    before = tokens[at - 1] if at else None
    counted = any(t.get("number") is not None or t.text in ("a", "an") for t in tokens[max(0, at - 4) : at])
    if single == "room":
        own = before is not None and before.has("own")
        told = before is not None and (before.get("number") is not None or not before.kinds or before.has("own", "soft", "size"))
        in_one = before is not None and before.text in ("one", "single", "same") and at > 1 and tokens[at - 2].text in ("in", "same")
        return (tokens[at].plural or own or told) and not in_one
    if single in ("double", "chair", "desk", "hot desk", "shower"):
        return tokens[at].plural or (single == "double" and counted)
    return True


def _unknown_room(tokens: Sequence[Token], at: int) -> bool:
    word = tokens[at - 1]
    return word.text.isalpha() and not word.breaks


def _words_before(tokens: Sequence[Token], at: int) -> list[str]:
    found: list[str] = []
    k = at - 1
    while k >= 0 and len(found) < 3 and not tokens[k].kinds and tokens[k].text.replace("'", "").isalpha() and not tokens[k].done:
        found.insert(0, tokens[k].text)
        k -= 1
    return found


@cache
def known_room(name: str, said: str) -> RoomKind:
    """A kind of room of the knowledge base that plans have no type of its own for: it takes that of its kin."""
    from sceneweaver.plans import room_types as plan_types

    if name in plan_types():
        return RoomKind(name, name, said)
    area = room_types()[name].area
    if area[1] < 6:
        return RoomKind(name, "storage_room", said)
    return RoomKind(name, "training_room" if area[1] > 25 else "playroom", said)


def _named(reading: Reading, at: int, kind: RoomKind) -> Named:
    tokens = reading.tokens
    token = tokens[at]
    said = _singular(token)
    noun = said if said in room_words() or said.endswith(f" {kind.noun}") else kind.noun
    found = Named(kind, at, at, at, token.span, noun=noun)
    if kind.noun.endswith(" room") and said == "room":
        found.first = at - len(kind.noun.split()) + 1
    _left(reading, found)
    _right(reading, found)
    first, last = tokens[found.first], tokens[found.last]
    found.span = _over(first, last)
    if found.told == "" and not token.plural:
        found.count = 1
    for k in range(found.first, found.last + 1):
        reading.did(k, "rooms")
    return found


def _left(reading: Reading, found: Named) -> None:
    """What stands before the name of a room: how many, how large, what it is like."""
    tokens = reading.tokens
    k, strange = found.first - 1, 0
    while k >= 0:
        token = tokens[k]
        if token.breaks or k == reading.use_at or token.done == "rooms" or token.has("joint", "place") and not token.has("own", "size"):
            break
        if token.get("number") is not None and not token.has("area"):
            found.count, found.told = int(token.get("number")), "number"
            if token.text == "one" and tokens[found.at].plural:
                found.count, found.told = None, ""
        elif token.text in ("a", "an", "another"):
            found.count, found.told = 1, "article"
        elif token.text in _DEFINITE:
            found.definite = True
        elif token.has("size"):
            found.size = token.get("size")
        elif token.has("area"):
            found.area = token.get("area")
        elif token.has("equal"):
            found.equal = True
        elif token.has("accessible"):
            found.accessible = True
        elif token.text in ("each", "both", "every", "all"):
            found.all = True
        elif token.has("own", "soft"):
            if token.text in ("several", "many", "few"):
                found.count = None
        elif token.has("person", "visitors", "staff", "me", "we") or token.text in ("guest", "staff"):
            if token.text.endswith(("'s", "s'")) or token.text in ("guest", "staff"):
                found.definite = found.definite or not found.told
                if token.text.endswith(("'s", "s'")):
                    found.looks.append("")
            else:
                break
        elif (looks := _look(token)) and strange < 3:
            found.looks.insert(0, token.text)
            strange += 1
        else:
            break
        found.first = k
        k -= 1
    found.looks = [word for word in found.looks if word]


def _look(token: Token) -> bool:
    """Whether a word says what a room is like."""
    kinds = vocabulary().get(token.text, {})
    return any(kind in kinds for kind in _LOOK_KINDS) and "verb" not in kinds and not token.has("function")


def _right(reading: Reading, found: Named) -> None:
    """The area behind the name of a room: "of 12 to 14 sqm each", "(18 m2)", "20 m2"."""
    tokens = reading.tokens
    k, seen = found.at + 1, False
    while k < len(tokens) and k < found.at + 7:
        token = tokens[k]
        if token.has("area"):
            found.area, seen = token.get("area"), True
            found.last = k
            least = any(t.text in ("at least", "minimum") for t in tokens[found.at + 1 : k])
            most = any(t.text in ("at most", "up to", "maximum") for t in tokens[found.at + 1 : k])
            if least:
                found.area = (found.area[0], round(found.area[1] * 1.35, 1))
            elif most:
                found.area = (round(found.area[0] * 0.75, 1), found.area[1])
        elif seen and token.text in ("each", ")", "per"):
            found.last = k
        elif seen or not (token.text in ("of", "about", "around", "(", "approx", "roughly", "ca", "circa", "with", "each", "some", "is", "only")
                          or token.has("soft")):
            break
        k += 1


def is_thing(token: Token) -> bool:
    """Whether a token is a thing by the vocabulary of rooms, and nothing of a home."""
    if token.kinds and not set(token.kinds) <= {"staff", "envelope"}:
        return False
    kinds = vocabulary().get(token.text, {})
    return "noun" in kinds and "room" not in kinds and "verb" not in kinds


def _singular(token: Token) -> str:
    from sceneweaver.assets.plurals import singular

    if not token.plural:
        return token.text
    head, _, last = token.text.rpartition(" ")
    return f"{head} {singular(last)}".strip()


def _over(one: Token, two: Token) -> Span:
    return Span(min(one.span.start, two.span.start), max(one.span.end, two.span.end))

