"""Phrases about the room: its kind, its places and openings, who it is for, parts that stand for things."""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.knowledge.load import room_words

from .chunks import Chunk, NounPhrase
from .items import bind_target, name_nothing, name_things
from .parsed import Mention
from .relating import relate, relate_to_place, say
from .state import State
from .tokens import Token
from .vocabulary import Place, category_of, family, words

_ROOMS = (
    "nook",
    "space",
    "retreat",
    "area",
    "zone",
    "hub",
    "haven",
    "oasis",
    "setup",
    "quarters",
    "setting",
    "spot",
    "scene",
)
"""Words for a room of some kind."""

_STUDIOS = frozenset(
    (
        *("podcast", "photo", "photography", "recording", "film", "filming", "video", "radio", "tv", "television"),
        *("broadcast", "streaming", "sound", "news", "tattoo", "pottery", "ceramics", "sculpture", "sewing", "fashion"),
    )
)
"""What a studio may be for that is no flat."""

_SAID_OF_ROOMS = (
    *("room_scale", "styles", "moods", "density", "color", "shape", "adjective", "scale", "material"),
    *("whom", "people_words", "finish", "adverbs"),
)
"""What words before the name of a room may be, without making another kind of room of it."""


def group_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A part of a room ("reading corner") stands for its things."""
    if state.out.room_type is None and not names_a_room(state) and phrase.text in room_words():
        state.out.room_type, state.out.room_words = room_words()[phrase.text], phrase.text
        describe_room(state, phrase)
    row = words("groups")["groups"][phrase.value]
    if phrase.definite:
        serving = {category_of(name) for name in row["things"]}
        kin = {family(c) for c in serving} & {"seat", "bed_group", "table"}
        there = [m for m in state.out.mentions if m.category in serving or family(m.category) in kin]
        first = family(category_of(next(iter(row["things"]))))
        there.sort(key=lambda m: family(m.category) != first)
        if there and state.waiting is not None:
            name_things(state, there[:1], phrase, False)
            return
        if there:
            state.glue = ""
            return
    made = []
    least, most = phrase.count or (1, 1)
    for name, (low, high) in row["things"].items():
        category = category_of(name)
        mention = next((m for m in state.out.mentions if m.category == category and not m.implied), None)
        if mention is not None and mention.count is not None and mention.count[1] > high:
            continue  # a library of bookcases has one for its reading corner
        if mention is None:
            mention = Mention(name.replace("_", " "), category, (low * least, high * most), implied=True)
            mention.span = state.source.span(phrase.start, phrase.end)
            state.out.mentions.append(mention)
        made.append(mention)
    span = state.source.span(phrase.start, phrase.end)
    for mention in made[1:]:
        say(state, "near", [mention], (made[0],), phrase.text, span=span, implied=True)
    state.out.note(f"'{phrase.text}' was taken for: {', '.join(m.noun for m in made)}")
    if not made:
        return
    if state.waiting is not None and state.waiting.place.type in ("inside", "on", "at"):
        state.waiting, state.glue = None, "start"
        return
    name_things(state, made[:1], phrase, True)
    state.party = made


def names_a_room(state: State) -> bool:
    return any(c.kind == "noun" and c.value.what == "room" for c in state.chunks)


def room_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    out = state.out
    waiting, state.waiting = state.waiting, None
    if out.room_type is None and phrase.text == "studio" and _STUDIOS.intersection(_strange(phrase)):
        unknown_room(state, phrase)
    elif out.room_type is None:
        out.room_type, out.room_words = phrase.value, phrase.text
        spoken = phrase.text.replace("'s", "").split()
        out.for_whom += [w for w in spoken if w in words()["whom"]]
        describe_room(state, phrase, room=True)
    elif phrase.value != out.room_type:
        if phrase.value not in out.other_rooms:
            out.other_rooms.append(phrase.value)
        out.note(f"'{phrase.text}' is another room; only the {out.room_words} is made")
    if waiting is not None and waiting.subjects and waiting.place.type in ("centered_on",):
        relate_to_place(state, "at", waiting.subjects, "middle", waiting.place.words)
    elif waiting is not None and waiting.subjects is None and waiting.lost is False:
        state.glue = "start"
        return
    state.glue = "" if state.glue != "start" else "start"
    if not state.subject and not state.frames:
        state.head = []


def unknown_room(state: State, phrase: NounPhrase) -> None:
    state.out.room_words = " ".join([*_strange(phrase), phrase.text])
    state.out.note(f"'{state.out.room_words}' is no kind of room that is known")


def describe_room(state: State, phrase: NounPhrase, room: bool = True) -> None:
    """Colours, styles, sizes and shapes of the room."""
    out = state.out
    if phrase.sides is not None:
        out.sides.append(phrase.sides)
    for word in phrase.qualities:
        room_quality(state, word, room)


def room_quality(state: State, word: Token, room: bool) -> None:
    out = state.out
    if room and word.has("room_scale"):
        out.room_scale = float(word.get("room_scale"))
    if room and word.has("shape") and out.shape is None:
        out.shape = word.get("shape")
    if room and word.text in ("long", "narrow", "elongated", "oblong", "long narrow", "long and narrow"):
        out.note(f"'{word.text}' gives no measure; give the sides of the room, such as 6 x 2 m")
    if word.has("styles") and out.style is None:
        out.style = word.get("styles")
    if word.has("density") and out.density is None:
        out.density = word.get("density")
    if word.has("color") and not any(m.color == word.text for m in out.mentions[-1:]) and word.text not in out.colors:
        out.colors.append(word.text)
    if word.has("whom") and word.text not in out.for_whom:
        out.for_whom.append(word.text)


def place_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    place = str(phrase.value)
    if place in ("window", "door") and _opening(state, place, phrase):
        return
    if phrase.text in ("opposite wall", "wall across the room", "other wall"):
        place = "wall:opposite"
    waiting, state.waiting = state.waiting, None
    if place == "room":
        if state.out.room_type is None and not state.out.room_words and _strange(phrase):
            unknown_room(state, phrase)
            state.leave_unread(" ".join(_strange(phrase)), phrase.start, phrase.end)
        twin = next((t.text for t in phrase.qualities if t.text in ("twin", "double", "single")), None)
        if (
            (phrase.count in ((1, 1), (2, 2)) or twin)
            and state.out.room_type is None
            and phrase.text == "room"
            and not waiting
        ):
            _counted_room(state, twin or ("single" if phrase.count == (1, 1) else "twin"))
        if not phrase.definite or waiting is None:
            describe_room(state, phrase)
    if phrase.what == "place" and place in ("wall", "floor", "ceiling") and waiting is None:
        name_nothing(state)
        return
    if waiting is None:
        if place != "room":
            name_nothing(state)
        return
    if phrase.count is not None and phrase.count[0] >= 2 and place == "corner" and waiting.subjects:
        for subject in waiting.subjects:
            if subject.count == (1, 1):
                subject.count = phrase.count
    if phrase.determiner in ("each", "every") and place in ("corner", "wall") and waiting.subjects:
        for subject in waiting.subjects:
            if subject.count == (1, 1):
                subject.count = (4, 4)
    if waiting.place.type == "between" and waiting.first is None and waiting.subjects and place in ("window", "door"):
        after = state.chunk(state.at)
        if after is not None and after.kind == "and" and state.noun_next(1):  # "between the window and the door"
            bind_target(state, replace(waiting, place=Place("near", words=waiting.place.words)), (place,))
            state.waiting = replace(waiting, place=Place("near", words=waiting.place.words))
            state.glue, state.at = "open", state.at + 1
            return
    if waiting.place.type == "between" and waiting.first is not None and waiting.subjects:
        relate(state, Place("near", words=waiting.place.words), waiting.subjects, (waiting.first,), waiting.chunk)
    state.lit = state.lit or (waiting.place.type == "through" and place == "window" and state.lost)
    bind_target(state, waiting, (place,))
    state.glue = ""
    state.last_target = None
    if waiting.subjects is None:
        state.head = []


def _counted_room(state: State, word: str) -> None:
    state.out.people = 1 if word == "single" else 2  # "a twin room"
    if state.out.room_type is None:
        state.out.room_type, state.out.room_words = "bedroom", f"{word} room"
        state.out.note(f"'{word} room' was taken for a bedroom")


def _opening(state: State, place: str, phrase: NounPhrase) -> bool:
    """Windows and doors as parts of the room: "two windows", "with a window"."""
    if state.waiting is not None:
        return False
    if phrase.count is not None:
        state.out.openings[place] = phrase.count[0]
    elif phrase.determiner in ("a", "an", "another"):
        state.out.openings[place] = max(1, state.out.openings.get(place, 0))
    name_nothing(state)
    return True


def people_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    out, text = state.out, phrase.text
    state.waiting = None
    if phrase.count is not None:
        out.people = phrase.count[1]
    elif text in ("couple", "young couple", "parents", "elderly couple") and out.people is None:
        out.people = 2
    elif text == "family" and out.people is None:
        out.people = phrase.of.count[1] if phrase.of is not None and phrase.of.count else 4
    if phrase.of is not None and phrase.of.what == "number" and phrase.of.count:
        out.people = phrase.of.count[1]
    for word in [*(t.text for t in phrase.qualities), text]:
        if word in words()["whom"] and word not in out.for_whom:
            out.for_whom.append(word)
    state.glue = "" if state.glue != "start" else "start"


def abstract_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    describe_room(state, phrase, room=phrase.text in ("space", "retreat", "area", "layout"))
    if phrase.count is not None:
        state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
    waiting, state.waiting = state.waiting, None
    if waiting is not None:
        state.glue = ""
        return
    if state.glue == "open" and state.frames and state.frames[-1].owner:  # "casting light over the bench"
        state.head, state.glue = state.frames.pop().owner, ""
        return
    start = state.glue == "start" and not state.out.mentions
    name_nothing(state)
    state.lost = state.lost and not (start and phrase.text in _ROOMS)


def _strange(phrase: NounPhrase) -> list[str]:
    """The words before a name of a room that make another kind of room of it."""
    return [t.text for t in phrase.qualities if not t.has(*_SAID_OF_ROOMS)]
