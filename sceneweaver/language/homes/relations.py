"""Relations of rooms by meaning: walls that are not shared, ways from one into another, the front and the back."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.language.model import Span

from .lexicon import data
from .parts import Joint, Named, Reading
from .tokens import Token

TOUCH = (
    "against",
    "touch",
    "touches",
    "touching",
    "border",
    "borders",
    "bordering",
    "adjoin",
    "adjoins",
    "abut",
    "abuts",
)
"""Words for rooms that a wall alone lies between; also said of furniture and walls."""

NOT = ("isn't", "aren't", "mustn't", "shouldn't", "can't", "cannot", "nowhere", "hasn't", "doesn't", "don't", "won't")
"""Words that turn what is said into its contrary, beside those of words.yaml."""

REACH = 7
"""Tokens between a room and what is said of it."""

_SMALL = ("the", "a", "an", "our", "my", "his", "her", "their", "its", "any", "of", "to", "be", "lie", "go", "get")
_MOVES = (
    "go",
    "walk",
    "step",
    "get",
    "come",
    "straight",
    "directly",
    "direct",
    "right",
    "door",
    "access",
    "way",
    "reach",
)
_INTO = ("into", "to", "onto", "through to", "over to")


def read_relations(reading: Reading) -> None:
    """Reads relations that take more than one word between two rooms; see above."""
    for sentence in reading.sentences():
        names = sorted((n for n in reading.named if n.at in sentence and n.of is None), key=lambda n: n.at)
        for at in sentence:
            token = reading.tokens[at]
            if token.done:
                continue
            if token.text.split()[-1] == "from":
                _from_into(reading, names, sentence, at)
            elif token.has("side"):
                _side(reading, names, sentence, at)
            elif token.has("alone") and (room := _room_before(names, at)) is not None:
                room.alone = token.span
                reading.did(at, "joint")
            elif token.text in TOUCH:
                _touch(reading, names, sentence, at)


def is_denied(tokens: Sequence[Token], start: int, stop: int) -> bool:
    """Whether a "not" stands among some tokens."""
    return any(token.has("no") and not token.done or token.text in NOT for token in tokens[start:stop])


def deny(reading: Reading, start: int, stop: int) -> None:
    """The "not" among some tokens is accounted for."""
    for k in range(start, stop):
        if reading.tokens[k].has("no") or reading.tokens[k].text in NOT:
            reading.did(k, "joint")


def no_room(reading: Reading, room: Named) -> bool:
    """Whether "no" stands before a room: "no bedroom next to the kitchen" is said of all bedrooms."""
    at = room.first - 1
    if at < 0 or not reading.tokens[at].has("no") or reading.tokens[at].done:
        return False
    reading.did(at, "joint")
    room.all, room.count, room.told = True, None, ""
    return True


def _from_into(reading: Reading, names: Sequence[Named], sentence: range, at: int) -> None:
    """ "Straight from the bedroom into the bathroom": a door."""
    tokens = reading.tokens
    one = _room_behind(names, tokens, at + 1)
    if one is None:
        return
    k = one.last + 1
    while k < sentence.stop and (tokens[k].text in _MOVES or tokens[k].text in ("you", "i", "we", "can", "should")):
        k += 1
    if k >= sentence.stop or tokens[k].text not in _INTO:
        return
    two = _room_behind(names, tokens, k + 1)
    clause = max((j for j in range(sentence.start, at) if tokens[j].breaks), default=sentence.start - 1) + 1
    moves = tokens[k].text == "into" or any(word in _MOVES for t in tokens[clause:k] for word in t.text.split())
    if two is None or two is one or not moves:
        return
    denied = is_denied(tokens, clause, at)
    span = Span(tokens[at].span.start, tokens[k].span.end)
    reading.joints.append(Joint(one, two, "apart" if denied else "door", span))
    deny(reading, clause, at)
    for j in (*(j for j in range(clause, k) if tokens[j].text in (*_MOVES, "want", "able")), at, k):
        reading.did(j, "joint")


def _side(reading: Reading, names: Sequence[Named], sentence: range, at: int) -> None:
    """ "Bedrooms at the back", "on the street side the kitchen and a study"."""
    tokens = reading.tokens
    if any(t.has("windows") for t in tokens[max(sentence.start, at - 4) : at]):
        return  # which sides have windows
    before = _room_before(names, at)
    gap = tokens[before.last + 1 : at] if before is not None else ()
    rooms = list[Named]()
    if before is not None and not any(t.breaks for t in gap) and len(gap) <= REACH:
        rooms = [before, *_with_and(names, tokens, before)]
    else:
        after = _room_behind(names, tokens, at + 1)
        while after is not None:
            rooms.append(after)
            k = after.last + 1
            joins = k < sentence.stop and tokens[k].text == "and"
            after = _room_behind(names, tokens, k + 1) if joins else None
    if not rooms:
        return
    denied = bool(gap) and is_denied(tokens, at - len(gap), at)
    kind = "apart" if denied else "near"
    for room in rooms:
        reading.joints.append(Joint(room, str(tokens[at].get("side")), kind, tokens[at].span))
    deny(reading, at - len(gap), at)
    reading.did(at, "joint")


def _touch(reading: Reading, names: Sequence[Named], sentence: range, at: int) -> None:
    """ "The nursery must not touch the cinema", "a music room with no bedroom against it"."""
    tokens = reading.tokens
    one = _room_before(names, at)
    if one is None or any(t.breaks for t in tokens[one.last + 1 : at]):
        return
    two = _room_behind(names, tokens, at + 1)
    pronoun = next((k for k in range(at + 1, min(at + 3, sentence.stop)) if tokens[k].text in ("it", "them")), None)
    if two is None and pronoun is not None:
        two = next((n for n in reversed([*reading.named]) if n.at < one.first and n.of is None), None)
    if two is None or two is one:
        return
    denied = is_denied(tokens, one.last + 1, at)
    deny(reading, one.last + 1, at)
    for k in range(one.last + 1, at):
        if tokens[k].text in ("lie", "lies", "lying", "sit", "sits", "stand", "stands", "right", "directly"):
            reading.did(k, "joint")
    denied = no_room(reading, one) or denied
    reading.joints.append(Joint(one, two, "apart" if denied else "near", tokens[at].span, each=True))
    reading.did(at, "joint")


def _room_before(names: Sequence[Named], at: int) -> Named | None:
    return next((one for one in reversed(names) if one.last < at), None)


def _room_behind(names: Sequence[Named], tokens: Sequence[Token], at: int) -> Named | None:
    """The room that begins at a token, behind small words."""
    while at < len(tokens):
        found = next((one for one in names if one.first <= at <= one.at), None)
        if found is not None:
            return found
        if tokens[at].text not in _SMALL and not tokens[at].has("own", "size"):
            return None
        at += 1
    return None


def _with_and(names: Sequence[Named], tokens: Sequence[Token], last: Named) -> list[Named]:
    """The room that "and" joins to the last one before a word."""
    before = _room_before(names, last.first)
    gap = [t.text for t in tokens[before.last + 1 : last.first]] if before is not None else []
    return [before] if before is not None and gap[:1] == ["and"] and len(gap) <= 2 else []


def apart_from_people(alone: Sequence[str], kinds: dict[str, frozenset[str]]) -> list[tuple[str, str]]:
    """Pairs of rooms that nobody is to be heard from, with all where people sleep, live or work."""
    lived = data("words")["lived_in"]
    return [(a, b) for a in alone for b, roles in kinds.items() if a != b and roles & {*lived}]
