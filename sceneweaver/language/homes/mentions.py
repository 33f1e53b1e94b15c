"""Rooms as a request names them: kind, number, size, area, what they are like."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from sceneweaver.knowledge.load import room_types, room_words
from sceneweaver.language.model import Span
from sceneweaver.language.vocabulary import vocabulary
from sceneweaver.plans import room_types as plan_types

from .described import is_look, read_before, read_behind
from .lexicon import RoomKind, activities, data, plain, room_kinds
from .parts import Named, Reading
from .shared_rooms import PLACES_TO_WORK, SPACES, for_each, in_its_own, is_open, one_more_for
from .tokens import Token

_PLACES = ("places", "seats", "beds", "couches")
"""What is counted in one room: "twelve recovery places"."""

_LIKE = ("able", "ible", "y", "ed", "er", "est", "ful", "ous", "ive", "ish", "ic", "al", "ent", "ant", "less")
"""How words end that say what a room is like, and not what it is for."""

_SLEEP_IN = {
    "seniors": "senior_bedroom",
    "couples": "master_bedroom",
    "parents": "master_bedroom",
    "children": "childrens_room",
    "adults": "bedroom",
    "twins": "childrens_room",
    "babies": "nursery",
}
"""The kind of room that people sleep in, by their role."""

MANY = 5
"""People from which on a room of an office is one for a team."""

_BEDS = ("bed", "beds", "bd", "br", "bhk", "bedroomed", "bedder")
_LISTED = (
    "living",
    "dining",
    "waiting",
    "theatre",
    "recovery",
    "master",
    "entry",
    "check in",
    "administration",
    "ladies",
    "gents",
)
"""Names of rooms that are also other words: rooms only in lists."""

_BEHIND_LIST = ("and", "on", "of", "in", "for", "by", "/", "&", "or", "with", "at", "near")
_ONLY_COUNTED = (
    "room",
    "double",
    "chair",
    *PLACES_TO_WORK,
    "shower",
    "flat",
    "hall",
    "studio",
    "lounge",
    "bar",
    "ward",
    "gallery",
    "waiting",
    "theatre",
    "lab",
    "surgery",
)


def read_mentions(reading: Reading) -> None:
    """Finds the rooms that a request names."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if at == reading.use_at or token.done == "rooms":
            continue
        if (total := _total(reading, at)) is not None:
            reading.named.append(total)
            continue
        kind = _kind(reading, at)
        if kind is not None:
            reading.named.append(_named(reading, at, kind))
        elif token.text == "one" and (other := _another(reading, at)) is not None:
            reading.named.append(other)
        elif token.text in ("sleeps", "sleep", "together") and (sleeper := _sleeper(reading, at)) is not None:
            reading.named.append(sleeper)
    _en_suites(reading)


def _en_suites(reading: Reading) -> None:
    """ "Four en-suite bedrooms": the number is that of the bedrooms."""
    for one, two in zip(reading.named, reading.named[1:], strict=False):
        if (
            one.kind.name == "ensuite"
            and two.first == one.last + 1
            and two.kind.name in ("bedroom", "master_bedroom", "guest_room")
        ):
            two.count, two.told = (one.count, one.told) if one.told else (two.count, two.told)
            two.size = two.size or one.size
            one.count, one.told, one.size = 1, "", None


def _total(reading: Reading, at: int) -> Named | None:
    """ "3 bed", "three-room flat", "2-bedroom": how many rooms to sleep in a home has."""
    tokens = reading.tokens
    token, number = tokens[at], tokens[at - 1].get("number") if at else None
    if number is None or reading.use.plan not in ("flat", "house") or not 0 < number < 20:
        return None
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    glued = tokens[at - 1].glued
    leads = after is not None and (
        after.has("use", "storey") or after.get("number") is not None or after.text in ("place", "unit")
    )
    behind = tokens[at + 2] if at + 2 < len(tokens) else None
    if (
        after is not None
        and after.text in ("+", "and", "&", "/", ",")
        and behind is not None
        and (at < 2 or tokens[at - 2].breaks)
    ):
        leads = leads or token.text in _BEDS and (behind.text in ("bath", "baths") or behind.get("number") is not None)
    short = token.text in _BEDS and (leads or glued and not (after is not None and _heads(after)))
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


def _another(reading: Reading, at: int) -> Named | None:
    """ "Two small meeting rooms, a large one": one more of the kind."""
    tokens = reading.tokens
    last = reading.named[-1] if reading.named else None
    if last is not None and one_more_for(reading, last, at):
        name = "master_bedroom" if tokens[at + 2].has("we") else last.kind.name
        reading.did(at, "rooms")
        return Named(room_kinds()[name], at, at, at, tokens[at].span, 1, "article", noun=room_kinds()[name].noun)
    if (
        last is None
        or at < 2
        or not tokens[at - 1].has("size", "own")
        or tokens[at - 2].text not in ("a", "an", "another")
    ):
        return None
    found = Named(
        last.kind, at, at - 2, at, _over(tokens[at - 2], tokens[at]), 1, "number", noun=last.noun, said=last.said
    )
    found.size, found.more = tokens[at - 1].get("size"), True
    for k in range(at - 2, at + 1):
        reading.did(k, "rooms")
    return found


def _sleeper(reading: Reading, at: int) -> Named | None:
    """ "Grandad sleeps downstairs", "the twins together in one big bed": their bedroom."""
    before = reading.tokens[at - 1] if at else None
    name = _SLEEP_IN.get(before.get("person")) if before is not None and reading.use.plan in ("flat", "house") else None
    if name is None or reading.tokens[at].text == "together" and name != "childrens_room":
        return None
    reading.did(at, "rooms")
    return Named(
        room_kinds()[name], at, at, at, reading.tokens[at].span, 1, "", definite=True, noun=room_kinds()[name].noun
    )


def _of_person(reading: Reading, at: int) -> str | None:
    """The kind of "Gran's room", or of "her room" where a person was told before; None where it is nobody's."""
    tokens = reading.tokens
    before = tokens[at - 1] if at else None
    if (
        before is None
        or reading.use.plan not in ("flat", "house")
        or at + 1 < len(tokens)
        and tokens[at + 1].text == "for"
    ):
        return None
    if before.has("person") and before.text.endswith(("'s", "s'")):
        return _SLEEP_IN.get(before.get("person"))
    if before.text not in ("her", "his"):
        return None
    told = next((t for t in reversed(tokens[max(0, at - 14) : at - 1]) if t.has("person")), None)
    return _SLEEP_IN.get(told.get("person")) if told is not None and not told.plural else None


def _kind(reading: Reading, at: int) -> RoomKind | None:
    """The kind of room that a token names here; None where it names none."""
    tokens, use = reading.tokens, reading.use_of(at)
    token = tokens[at]
    if reading.second is not None and token.has("trade") and reading.business[at]:
        return room_kinds()[use.means.get(plain(_singular(token)), next(iter(use.needs)).split("|")[0])]
    if token.text in ("space", "area") and use.plan == "office" and use.name != "school":
        return room_kinds()["open_office"] if is_open(tokens, at, token.text) else None
    if token.text == "ours" and at and tokens[at - 1].has("joint") and use.plan in ("flat", "house"):
        return room_kinds()["master_bedroom"]
    if not token.has("room", "means", "known_room", "use"):
        return None
    if token.text in ("bath", "shower") and _is_in_bathroom(reading, at):
        return None
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    single = plain(_singular(token))
    meant = use.means.get(single)
    if meant is None and not token.has("room", "known_room"):
        return None
    if after is not None and not token.plural and _heads(after) and not after.breaks:
        return None  # "kitchen table", "bathroom door"
    if (
        after is not None
        and after.text in ("door", "doors", "wall", "window", "windows", "furniture")
        and not after.breaks
    ):
        return None
    if (
        single in _LISTED
        and meant is None
        and not (after is None or after.breaks or after.has("joint") or after.text in (*_BEHIND_LIST, *_PLACES))
    ):
        return None
    if at and (_is_compound_thing(tokens[at - 1], token) or _worked_in(tokens, at)):
        return None
    if use.plan == "office" and use.name != "school" and is_open(tokens, at, single):
        return room_kinds()["open_office"]
    if for_each(reading, at):
        return room_kinds()[meant or "bedroom"]
    if single in ("room", "bedroom") and not token.plural and (theirs := _of_person(reading, at)) is not None:
        return room_kinds()[theirs]
    if single in _ONLY_COUNTED and not _may_be(tokens, at, single):
        return None
    if single == "room" and (done := _by_activity(reading, at)) is not None:
        return done
    if single == "room" and at and not tokens[at - 1].kinds and _unknown_room(tokens, at):
        words = _words_before(tokens, at)
        last, home = words[-1] if words else "", use.plan in ("flat", "house")
        if home and "noun" not in vocabulary().get(last, {}) and (is_look(tokens[at - 1]) or last.endswith(_LIKE)):
            return room_kinds()[meant or "bedroom"]  # "a lockable room"
        base = room_kinds()[meant or "bedroom"]
        if home or last.endswith("ing"):  # "a grooming room", "a printing room": what is done there
            base = room_kinds()["hobby_room" if home else "storage_room" if use.plan == "office" else base.name]
        return RoomKind(base.name, base.type, " ".join([*words, "room"]), base.counts_as)
    if meant is not None:
        options = [option for option in meant.split("|") if option in room_kinds()]
        return room_kinds()[options[0]] if options else None
    if token.has("room"):
        return room_kinds()[token.get("room")]
    return known_room(token.get("known_room"), single)


def _is_in_bathroom(reading: Reading, at: int) -> bool:
    """ "A bathroom with a bath": the thing, and no second bathroom."""
    last = reading.named[-1] if reading.named else None
    if last is None or not {"bathroom"} & {last.kind.name, last.kind.type, *last.kind.counts_as}:
        return False
    return [t.text for t in reading.tokens[last.last + 1 : at]] in (["with", "a"], ["with", "bath", "and"])


def _by_activity(reading: Reading, at: int) -> RoomKind | None:
    """A room by what is done in it: "one big room for cooking, eating and sitting", "a homework room"."""
    tokens = reading.tokens
    if at and tokens[at - 1].text in activities():
        return room_kinds()[activities()[tokens[at - 1].text]]
    if at + 2 >= len(tokens) or tokens[at + 1].text not in ("for", "to", "where"):
        return None
    if reading.use.plan == "office" and reading.use.name != "school" and (tokens[at + 2].number or 0) >= MANY:
        return room_kinds()["open_office"]
    found: list[str] = []
    for k in range(at + 2, min(at + 12, len(tokens))):
        if tokens[k].text in activities():
            found.append(activities()[tokens[k].text])
            reading.did(k, "rooms")
        elif not (tokens[k].text in (",", "and", "or", "&") or tokens[k].has("function", "we", "me")):
            break
    if not found:
        return None
    if "kitchen" in found and len(found) > 1:
        return room_kinds()["living_kitchen"]
    return room_kinds()["living_dining" if {"dining_room", "living_room"} <= {*found} else found[0]]


def _may_be(tokens: Sequence[Token], at: int, single: str) -> bool:
    """Whether a word that is often no room is one here: it is counted, in the plural, or its own."""
    before = tokens[at - 1] if at else None
    if single == "room" and in_its_own(tokens, at):
        return False
    counted = any(t.get("number") is not None or t.text in ("a", "an") for t in tokens[max(0, at - 4) : at])
    if single == "room" and before is not None and before.text in data("words")["not_bedrooms"]:
        return False
    if single == "room":
        own = before is not None and before.has("own")
        told = before is not None and (
            before.get("number") is not None or not before.kinds or before.has("own", "soft", "size")
        )
        in_one = (
            before is not None
            and before.text in ("one", "single", "same")
            and at > 1
            and tokens[at - 2].text in ("in", "same")
        )
        return (tokens[at].plural or own or told) and not in_one
    if single == "hall" and before is not None:
        return before.breaks or before.number is not None or before.has("function", "own", "size", "soft")
    if single in ("double", "chair", *PLACES_TO_WORK, "shower"):
        return tokens[at].plural or (single == "double" and counted)
    return True


def _unknown_room(tokens: Sequence[Token], at: int) -> bool:
    word = tokens[at - 1]
    return word.text.isalpha() and not word.breaks


def _words_before(tokens: Sequence[Token], at: int) -> list[str]:
    found: list[str] = []
    k = at - 1
    while (
        k >= 0
        and len(found) < 3
        and not tokens[k].kinds
        and tokens[k].text.replace("'", "").isalpha()
        and not tokens[k].done
    ):
        found.insert(0, tokens[k].text)
        k -= 1
    return found


@cache
def known_room(name: str, said: str) -> RoomKind:
    """A kind of room of the knowledge base that plans have no type of its own for: it takes that of its kin."""
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
    found = Named(kind, at, at, at, token.span, noun=_noun(kind, said))
    found.said = said
    if kind.noun.endswith(" room") and said == "room":
        found.first = at - len(kind.noun.split()) + 1
    read_before(reading, found)
    read_behind(reading, found)
    first, last = tokens[found.first], tokens[found.last]
    found.span = _over(first, last)
    _places_in(reading, found)
    if found.told == "" and not token.plural:
        found.count = 1
    if said in PLACES_TO_WORK:  # in one room
        reading.workers = found.count or reading.workers
        if found.count is not None and found.count > 1:
            found.wishes.append(f"with {found.count} workstations")  # each a desk with its chair
        found.count, found.told = 1, ""
    if kind.name == "open_office" and said in SPACES:  # where those who were named work
        found.count, found.told = 1, ""
        found.definite = any(one.kind.name == kind.name for one in reading.named)
    if for_each(reading, at):
        found.count, found.told = None, "each"
    after = found.at + 1
    if found.last == found.at and not said.endswith("room") and after < len(tokens) and tokens[after].text == "room":
        found.last = after  # "an archive room"
    for k in range(found.first, found.last + 1):
        reading.did(k, "rooms")
    return found


def _places_in(reading: Reading, found: Named) -> None:
    """ "Twelve recovery places": one room for so many."""
    k = found.last + 1
    if k >= len(reading.tokens) or found.told != "number" or found.last != found.at:
        return
    if reading.tokens[k].text in _PLACES:
        words = reading.tokens[found.first : found.at]
        number = next((t.text for t in words if t.get("number") is not None), "")
        found.wishes.append(f"for {number}")
        found.count, found.told, found.last = 1, "article", k


def _noun(kind: RoomKind, said: str) -> str:
    """What the room's own request calls it: as said, where the reader of rooms knows a kind by that."""
    row = data("rooms").get(kind.name, {})
    if said.split()[0] in ("double", "single", "twin") and said.endswith(f" {kind.noun}"):
        return said
    meant = room_words().get(said)
    if meant is None or "noun" in row:
        return kind.noun
    own = meant in (kind.name, plan_types()[kind.type].furnish)
    return said if own or meant not in plan_types() else kind.noun


def _heads(token: Token) -> bool:
    """Whether the name of a room before a word only says which: "kitchen table"."""
    return is_thing(token) and "verb" not in vocabulary().get(token.text, {})


def _worked_in(tokens: Sequence[Token], at: int) -> bool:
    """Whether a room is where somebody works elsewhere: "she teaches in a classroom", but not "works in the study"."""
    if at < 3 or tokens[at - 1].text not in ("a", "an") or tokens[at - 2].text not in ("at", "in", "on"):
        return False
    for token in reversed(tokens[max(0, at - 6) : at - 2]):
        if token.breaks:
            return False
        if token.text in ("work", "works", "working", "worked"):
            return True
    return False


def _is_compound_thing(before: Token, token: Token) -> bool:
    """Whether a word that may be a room ends the name of a thing: "grab bars", "breakfast bar"."""
    kinds = vocabulary().get(f"{plain(before.text)} {plain(token.text)}", {})
    return "noun" in kinds and "room" not in kinds


def is_thing(token: Token) -> bool:
    """Whether a token is a thing of a room by the vocabulary, and nothing of a home."""
    if token.kinds and not set(token.kinds) <= {"trade", "plot", "means", "place", "staff"}:
        return False
    kinds = vocabulary().get(plain(token.text), {})
    return "noun" in kinds and "room" not in kinds


def _singular(token: Token) -> str:
    from sceneweaver.assets.plurals import singular

    if not token.plural:
        return token.text
    head, _, last = token.text.rpartition(" ")
    return f"{head} {singular(last)}".strip()


def _over(one: Token, two: Token) -> Span:
    return Span(min(one.span.start, two.span.start), max(one.span.end, two.span.end))
