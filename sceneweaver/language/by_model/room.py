"""What a model's reading says of the room, checked."""

from __future__ import annotations

from sceneweaver.io.messages import quote as shown
from sceneweaver.knowledge import match_room, room_types

from ..parsed import Left
from ..source import check_measures
from ..vocabulary import words
from .draft import OPEN, OUT, SCALES, Draft
from .english import LONGEST, cut, english, is_color
from .reply import RoomReply

MOST_PEOPLE, MOST_OPENINGS, MOST_WORDS = 400, 40, 12


def add_room(room: RoomReply, draft: Draft) -> None:
    """Puts the room of a reply into a draft."""
    _kind(room, draft)
    parsed, problems = draft.parsed, draft.problems
    parsed.shape, parsed.style, parsed.density = room.shape, room.style, room.density
    if room.scale is not None:
        if SCALES[0] <= room.scale <= SCALES[1]:
            parsed.room_scale = room.scale
        else:
            problems[f"room: scale {room.scale:g} cannot be; 1 is usual, 1.3 large, 0.75 small"] = OPEN
    parsed.people = _whole(room.people, (1, MOST_PEOPLE), "people", problems)
    for name in ("window", "door"):
        number = _whole(getattr(room, f"{name}s"), (0, MOST_OPENINGS), f"{name}s", problems)
        if number is not None:
            parsed.openings[name] = number
    parsed.for_whom = [cut(who) for who in room.for_whom[:MOST_WORDS] if who]
    _colors(room, draft)
    _measures(room, draft)


def _kind(room: RoomReply, draft: Draft) -> None:
    """The kind of room by its English name, and further rooms."""
    parsed = draft.parsed
    problem = f"room: {shown(cut(room.quote))} is not in the request; copy the words for its kind"
    span = draft.find(room.quote, None, problem, "the kind that the model named is kept")
    if span is not None:
        parsed.room_words = cut(draft.quotes.text[span.start : span.end], 2 * LONGEST)
    if name := english(room.kind):
        parsed.room_words = parsed.room_words or name
        parsed.room_type = known_room(name)
        if parsed.room_type is None and name not in ("room", "space"):
            draft.doubts.append(
                f"room: no kind of room is known as {shown(name)}; if one of these means the same give that, else say "
                f"it again: {', '.join(room_types()).replace('_', ' ')}"
            )
            parsed.note(f"'{name}' is no kind of room that is known")
            if span is not None:
                parsed.unread.append(Left(parsed.room_words, *span))
    elif room.kind:
        draft.problems[f"room: kind {shown(cut(room.kind))} is not English; say it in English"] = OPEN
    for other in room.others[:MOST_WORDS]:
        kind = known_room(english(other))
        if kind is not None and kind != parsed.room_type and kind not in parsed.other_rooms:
            parsed.other_rooms.append(kind)
            parsed.note(f"'{cut(other)}' is another room; only the {parsed.room_words or 'first'} is made")


def known_room(name: str) -> str | None:
    """The kind of room that an English name means; None when none is known."""
    found = match_room(name) if name else None
    return found[0] if found is not None else None


def _colors(room: RoomReply, draft: Draft) -> None:
    for given in room.colors[:MOST_WORDS]:
        color = english(given)
        if is_color(color) or color in words()["materials"]:
            draft.parsed.colors.append(color)
        else:
            draft.problems[f"room: color {shown(cut(given))} is unknown; use a plain English colour"] = OUT


def _measures(room: RoomReply, draft: Draft) -> None:
    """Sides, floor and ceiling [m], as far as a room can have them."""
    source = draft.source
    if len(room.sides) >= 2:
        source.size = (max(room.sides[:2]), min(room.sides[:2]))
    elif room.sides:
        draft.problems["room: sides are two numbers of metres"] = OPEN
    source.area, source.height = room.area, room.height
    if source.height is None and len(room.sides) > 2:
        source.height = room.sides[2]
    before = len(source.notes)
    check_measures(source)
    draft.problems |= {f"room: {note.partition(';')[0]}": OPEN for note in source.notes[before:]}
    del source.notes[before:]


def _whole(value: int | None, bounds: tuple[int, int], name: str, problems: dict[str, str]) -> int | None:
    if value is None or bounds[0] <= value <= bounds[1]:
        return value
    spoken = f"{name} {value if abs(value) < 10**9 else 'that many'}"
    problems[f"room: {spoken} cannot be; it is {bounds[0]} to {bounds[1]}, or null"] = OPEN
    return None
