"""Phrases about the room: its kind, its places and openings, who it is for, parts that stand for things."""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.assets.wordnet import of_head
from sceneweaver.knowledge.load import room_words

from .chunks import EACH, Chunk, NounPhrase
from .distribution import over_each
from .items import bind_target, name_nothing, name_things
from .parsed import Mention, Said
from .relating import ENDS_OF_ROOM, relate, relate_to_place, say
from .shares import ends_here, share_out
from .state import State, Waiting
from .tokens import Token
from .vocabulary import Place, category_of, family, group_rows, shows, words
from .wall_names import COMPASS, PARTS

_SAID_OF_ROOMS = (
    *("room_scale", "styles", "moods", "density", "color", "shape", "adjective", "scale", "material"),
    *("whom", "people_words", "finish", "adverbs"),
)
"""What words before the name of a room may be, without making another kind of room of it."""


def group_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A part of a room ("reading corner") stands for its things."""
    out = state.out
    if out.room_type is None and not state.names_a_room and phrase.text in room_words():
        out.room_type, out.room_words = room_words()[phrase.text], phrase.text
        describe_room(state, phrase)
    things = group_rows()[phrase.value]["things"]
    if phrase.definite:
        there = _already_there(state, list(things))
        if there and state.waiting is not None:
            name_things(state, there[:1], phrase, False)
            return
        if there:
            state.glue = ""
            return
    made = _made_of_group(state, phrase, things)
    for mention in made[1:]:
        say(state, Said("near", [mention], (made[0],), phrase.text, span=state.span_of(phrase), implied=True))
    out.note(f"'{phrase.text}' was taken for: {', '.join(m.noun for m in made)}")
    if not made:
        return
    if state.waiting is not None and state.waiting.place.type in ("inside", "on", "at"):
        state.waiting, state.glue = None, "start"
        return
    name_things(state, made[:1], phrase, True)
    state.party = made


def _already_there(state: State, names: list[str]) -> list[Mention]:
    """What was named of the things of a group, or serves as well; its first thing first."""
    serving = [category_of(name) for name in names]
    kin = {family(c) for c in serving} & {"seat", "bed_group", "table"}
    there = [m for m in state.out.mentions if m.category in serving or m.family in kin]
    return sorted(there, key=lambda m: m.family != family(serving[0]))


def _made_of_group(state: State, phrase: NounPhrase, things: dict[str, tuple[int, int]]) -> list[Mention]:
    """A mention for each thing that a group calls for, of what is there already where it was named."""
    made: list[Mention] = []
    least, most = phrase.count or (1, 1)
    if phrase.count is not None and phrase.value in words("groups")["collections"]:
        things, (least, most) = _shared(things, phrase.count), (1, 1)
    for name, (low, high) in things.items():
        category = category_of(name)
        mention = next((m for m in state.out.mentions if m.category == category and not m.implied), None)
        if mention is not None and mention.count is not None and mention.count[1] > high:
            continue  # a library of bookcases has one for its reading corner
        if mention is None:
            mention = Mention(name.replace("_", " "), category, (low * least, high * most), implied=True)
            mention.span = state.span_of(phrase)
            state.out.mentions.append(mention)
        made.append(mention)
    return made


def _shared(things: dict[str, tuple[int, int]], count: tuple[int, int]) -> dict[str, tuple[int, int]]:
    """So many things of several kinds together: "twelve toys" are four of each of three kinds."""
    kinds = list(things)[: max(1, count[0])]
    n = len(kinds)
    return {name: ((count[0] + k) // n, (count[1] + k) // n) for name, k in zip(kinds, reversed(range(n)), strict=True)}


def room_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """The kind of the room; a second one is another room."""
    out = state.out
    waiting, state.waiting = state.waiting, None
    if (
        out.room_type is None
        and phrase.text == "studio"
        and not set(words("groups")["studios"]).isdisjoint(_strange(phrase))
    ):
        unknown_room(state, phrase)
    elif out.room_type is None:
        out.room_type, out.room_words = phrase.value, phrase.text
        out.for_whom += [w for w in phrase.text.replace("'s", "").split() if w in words()["whom"]]
        describe_room(state, phrase)
    elif phrase.value != out.room_type:
        if phrase.value not in out.other_rooms:
            out.other_rooms.append(phrase.value)
        out.note(f"'{phrase.text}' is another room; only the {out.room_words} is made")
        if waiting is None and state.placed_next(state.at):
            name_nothing(state)  # "the bar in the left half, four tables": where the bar is says nothing of these
            return
    if waiting is not None and waiting.subjects and waiting.place.type == "centered_on":
        relate_to_place(state, Said("at", waiting.subjects, ("middle",), waiting.place.words))
    elif waiting is not None and not waiting.lost and waiting.place.type in ENDS_OF_ROOM:  # "at the back of the shop"
        place = Place("against", words=waiting.place.words)
        bind_target(state, replace(waiting, place=place), (ENDS_OF_ROOM[waiting.place.type],))
    elif waiting is not None and waiting.subjects is None and not waiting.lost:
        state.glue = "start"
        return
    state.glue = "" if state.glue != "start" else "start"
    if not state.subject and not state.frames:
        state.head = []


def unknown_room(state: State, phrase: NounPhrase) -> None:
    """The room is of a kind that is not known."""
    state.out.room_words = " ".join([*_strange(phrase), phrase.text])
    state.out.note(f"'{state.out.room_words}' is no kind of room that is known")


def describe_room(state: State, phrase: NounPhrase, room: bool = True) -> None:
    """Colours, styles, sizes and shapes of the room."""
    if phrase.sides is not None:
        state.leave_sides(phrase)
    for word in phrase.qualities:
        room_quality(state, word, room)


def room_quality(state: State, word: Token, room: bool) -> None:
    """What one word says of the room; its size and shape only where it is said of the ``room`` itself."""
    out = state.out
    if room and word.has("room_scale"):
        out.room_scale = float(word.get("room_scale"))
    if room and out.shape is None:
        out.shape = word.get("shape")
    if room and word.text in words("groups")["unmeasured"]:
        out.note(f"'{word.text}' gives no measure; give the sides of the room, such as 6 x 2 m")
    out.style = out.style or word.get("styles")
    out.density = out.density or word.get("density")
    of_thing = any(m.color == word.text for m in out.mentions[-1:])
    if word.has("color") and not of_thing and word.text not in out.colors:
        out.colors.append(word.text)
    if word.has("whom") and word.text not in out.for_whom:
        out.for_whom.append(word.text)


def place_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A part of the room: what waits is related to it."""
    place = str(phrase.value)
    has = phrase.determiner in EACH and _has_next(state)
    if place in ("window", "door") and state.waiting is None and not has:
        _count_openings(state, place, phrase)
        return
    if phrase.text in ("opposite wall", "wall across the room", "other wall"):
        place = "wall:opposite"
    waiting, state.waiting = state.waiting, None
    if waiting is None and phrase.determiner in EACH and place in _HOLDING and _has_next(state):
        where = Place(_HOLDING[place], words=f"{_HOLDING[place]} each", over_each=True)
        state.fronted, state.glue = [(where, (place,), chunk)], "start"  # "each corner gets a lamp"
        state.at += 1
        return
    if ":" in place:
        state.refer(phrase)
    if place == "room":
        _the_room(state, phrase, waiting)
    if waiting is None and place.partition(":")[2] in PARTS and _holds_next(state):
        state.fronted, state.glue = [(Place("inside", words="in"), (place,), chunk)], "start"  # "an alcove with a desk"
        state.at += 1
        return
    of_side = place.partition(":")[2] in _OF_ROOM and not phrase.determiner
    if waiting is None and of_side and (subjects := _told_before(state, chunk)):
        spoken = f"at the {phrase.text}"
        relate_to_place(state, Said("against", subjects, (place,), spoken, span=state.span_of(phrase)))
        state.glue = ""
        return
    if waiting is None:
        if place != "room":
            name_nothing(state)
        return
    subjects = waiting.subjects or []
    many = None
    if phrase.determiner in ("each", "every") and place in ("corner", "wall"):
        many = (4, 4)
    if phrase.count is not None and phrase.count[0] >= 2 and place == "corner":
        many = phrase.count
    each = phrase.determiner in EACH
    if each and place in ("window", "door"):
        for subject in subjects:
            subject.per_place = place
    for subject in subjects if many is not None else ():
        subject.count = many if subject.count == (1, 1) else subject.count
    if each and waiting.subjects is None:
        waiting.place = over_each(waiting.place)  # "in each corner a plant"
    if waiting.place.type == "between" and subjects:
        near = replace(waiting, place=Place("near", words=waiting.place.words))
        after = state.chunk(state.at)
        another = after is not None and after.kind == "and" and state.noun_next(1)
        if waiting.first is None and another and place in ("window", "door"):  # "between the window and the door"
            bind_target(state, near, (place,))
            state.waiting = near
            state.glue, state.at = "open", state.at + 1
            return
        if waiting.first is not None:
            relate(state, near.place, subjects, (waiting.first,), state.span_of(waiting.chunk))
    state.lit = state.lit or (waiting.place.type == "through" and place == "window" and state.lost)
    bind_target(state, waiting, (place,))
    state.glue = ""
    state.last_target = None
    if waiting.subjects is None:
        state.head = []


_OF_ROOM = ("left", "right", "far", "near", "side", "long", "short", *COMPASS)
"""Sides of a room that stand alone for where something is: "a gate, far end"."""


def _told_before(state: State, chunk: Chunk) -> list[Mention]:
    """What a side of the room alone is said of: "a stove and a sink, all port side", "a gate, far end"."""
    before, after = state.chunk(state.at - 2), state.chunk(state.at)
    ends = after is None or after.kind in ("stop", "comma", "bracket")
    if not ends or before is None or before.kind not in ("comma", "noun", "adjective", "word", "bracket"):
        return []
    placed = {m for said in state.out.said for m in said.subjects if isinstance(said.targets[0], str)}
    fresh = [m for m in state.out.mentions[state.begun :] if m.mount != "surface" and m not in placed]
    every = state.source.text[before.start : chunk.end].split()[:1] == ["all"] or chunk.text.startswith(
        ("all ", "both ")
    )
    every = every or before.text == "all"
    return fresh if every else fresh[-1:]


_HOLDING = {"corner": "at", "wall": "on", "window": "near", "door": "near"}
"""Where things are of which each part of the room has one."""


def _has_next(state: State) -> bool:
    """Whether a verb says next what there is: "every wall has a picture"."""
    after = state.chunk(state.at)
    return after is not None and after.kind == "verb" and shows(after.value.lemma)


def _holds_next(state: State) -> bool:
    """Whether it is told next what is there: "a recess with a desk", "an alcove where a bed stands"."""
    after = state.chunk(state.at)
    return after is not None and (after.kind == "with" or after.text in ("where", "in which") or _has_next(state))


def _the_room(state: State, phrase: NounPhrase, waiting: Waiting | None) -> None:
    """The word "room" and its like, which name no kind of room unless a word before them does."""
    out, strange = state.out, _strange(phrase)
    if out.room_type is None and not out.room_words and strange:
        unknown_room(state, phrase)
        state.leave_unread(" ".join(strange), phrase.start, phrase.end)
    twin = next((t.text for t in phrase.qualities if t.text in ("twin", "double", "single")), None)
    counted = twin or {(1, 1): "single", (2, 2): "twin"}.get(phrase.count or (0, 0))
    if counted and out.room_type is None and phrase.text == "room" and waiting is None:
        out.people = 1 if counted == "single" else 2  # "a twin room"
        out.room_type, out.room_words = "bedroom", f"{counted} room"
        out.note(f"'{counted} room' was taken for a bedroom")
    if not phrase.definite or waiting is None:
        describe_room(state, phrase)


def _count_openings(state: State, place: str, phrase: NounPhrase) -> None:
    """Windows and doors as parts of the room: "two windows", "with a window"."""
    openings = state.out.openings
    if phrase.count is not None:
        told = any(one.part == place for one in state.out.stated_openings)
        openings[place] = max(phrase.count[0], openings.get(place, 0) if told else 0)
    elif phrase.determiner in ("a", "an", "another"):
        openings[place] = max(1, openings.get(place, 0))
    name_nothing(state)


def people_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """Who the room is for, and how many they are."""
    out, text = state.out, phrase.text
    state.waiting = None
    if phrase.determiner in ("each", "every") or text in ("everybody", "everyone"):
        if not (ends_here(state) and share_out(state, of_people=True)):
            state.per_person = True
        state.glue = "" if state.glue != "start" else "start"
        return
    inner = phrase.of.count if phrase.of is not None else None
    known = of_head(text)
    if phrase.count is not None and known is not None and known.kind in ("animal", "vehicle"):
        state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)  # "for four ponies"
    elif phrase.count is not None:
        out.people = max(phrase.count[1], out.people or 0)  # four pupils at each bench are some of the twenty
        out.referred.append(state.span_of(phrase))
    elif out.people is None and text in ("couple", "young couple", "parents", "elderly couple"):
        out.people = 2
    elif out.people is None and text == "family":
        out.people = inner[1] if inner else 4
    if inner and phrase.of is not None and phrase.of.what == "number":
        out.people = inner[1]
    for word in [*(t.text for t in phrase.qualities), text]:
        if word in words()["whom"] and word not in out.for_whom:
            out.for_whom.append(word)
    state.glue = "" if state.glue != "start" else "start"


def abstract_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """What is no thing: an atmosphere, a layout, "a retreat" for the room."""
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
    state.lost = state.lost and not (start and phrase.text in words("groups")["rooms"])


def matter_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """What is no object and no mood: a way, a step, an event. Other readers may know it; here it is not understood."""
    state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
    phrase.count = None
    phrase.qualities = [word for word in phrase.qualities if not word.has("color")]  # red dust makes no red room
    abstract_phrase(state, phrase, chunk)


def _strange(phrase: NounPhrase) -> list[str]:
    """The words before a name of a room that make another kind of room of it."""
    return [t.text for t in phrase.qualities if not t.has(*_SAID_OF_ROOMS)]
