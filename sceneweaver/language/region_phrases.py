"""Parts of things: tops, middles, sides, shelves, headboards."""

from __future__ import annotations

from dataclasses import replace

from .chunks import EACH, Chunk, NounPhrase
from .items import bind_target, name_nothing, name_things
from .model import Attribute
from .nearness import carrier_root, main_things, nearest
from .parsed import Mention, Said
from .relating import say
from .room_phrases import place_phrase, room_phrase
from .state import State, Waiting
from .thing_phrases import is_part, named_thing, new_thing
from .things import match_of
from .vocabulary import Place, words

_TWO = ("two", "double", "dual")


def thing_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """What a noun names: a thing, or a part of the thing that it comes with."""
    if is_part(state, phrase):
        part_phrase(state, phrase, chunk)
    else:
        named_thing(state, phrase, chunk)


def region_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """The top, the middle, a corner, a side: of a thing, or of the room."""
    of = phrase.of
    if of is not None and of.what == "room" and state.waiting is None and state.out.room_type is None:
        room_phrase(state, of, chunk)
        return
    waiting, state.waiting = state.waiting, None
    owner = _owner(state, phrase, waiting)
    with_owner = bool(state.frames) and state.frames[-1].kind == "with" and bool(state.frames[-1].owner)
    if waiting is None and of is None and with_owner and not phrase.definite:
        part_phrase(state, phrase, chunk)
        return
    if phrase.determiner in EACH and phrase.value == "corner" and of is None:
        state.waiting = waiting
        place_phrase(state, replace(phrase, what="place", value="corner"), chunk)
        return
    if waiting is None:
        _region_alone(state, phrase, owner)
        return
    if owner is None:
        owner = _owner_meant(state, phrase, waiting)
    if owner is None:
        state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
        name_nothing(state)
        return
    if isinstance(owner, str):
        _of_room(state, phrase, waiting, owner)
    else:
        kind = _kind_on(str(phrase.value), phrase, waiting, owner)
        if phrase.determiner in EACH and phrase.value in ("end", "side") and waiting.place.type != "flanking":
            flank = Place("along", "short", True, "at each") if owner.family == "table" else None
            waiting = replace(waiting, place=flank or Place("flanking", None, True, "at each"))
            kind = waiting.place.type
        place = Place(kind, waiting.place.side, waiting.place.each, f"{waiting.place.words} {phrase.text}")
        bind_target(state, replace(waiting, place=place), (owner,))
    state.glue, state.last_target = "", None
    if waiting.subjects is None:
        state.head = []


def _owner(state: State, phrase: NounPhrase, waiting: Waiting | None) -> Mention | str | None:
    """What a region is of where the phrase says so: "the top of the desk", "the desk top"."""
    of, subjects = phrase.of, (waiting.subjects or []) if waiting is not None else []
    if of is not None:
        if of.what in ("room", "place"):
            return str(of.value) if of.what == "place" and of.value not in ("floor", "room") else "room"
        if of.what == "pronoun":  # its word of place is bound already, so that nothing is left out
            return next(iter(state.refs.pronoun(of, nearest(state, []), [])[-1:]), None)
        if of.what != "thing":
            return None
        known = state.refs.known(of, True, [])
        if known is not None:
            state.refer(of)
        return known if known is not None else new_thing(state, of)
    if any(t.has("room") and not t.has("noun") for t in phrase.qualities):
        return "room"
    named = [t for t in phrase.qualities if t.has("noun")]
    if not named:
        return None
    inner = NounPhrase("thing", named[-1].text, phrase.start, phrase.end, determiner="the")
    return state.refs.known(inner, True, subjects)


def _region_alone(state: State, phrase: NounPhrase, owner: Mention | str | None) -> None:
    """A region that is no target is about what it is of: "its top carries a globe"."""
    if phrase.value in ("center", "corner", "side"):
        name_nothing(state)
        return
    found: Mention | None = owner if isinstance(owner, Mention) else None
    if found is None:
        own = [m for m in state.subject[-1:] if phrase.determiner == "its" and m.mount == "floor"]
        near = [*state.subject, *nearest(state, [])]
        found = own[0] if own else state.refs.carrier(near, [], "top", phrase.text)
        found = found if phrase.definite else None
    if found is not None:
        name_things(state, [found], phrase, False)
    else:
        name_nothing(state)


def _owner_meant(state: State, phrase: NounPhrase, waiting: Waiting) -> Mention | str | None:
    """What a region is of where nothing says so."""
    region, subjects, own = str(phrase.value), waiting.subjects or [], phrase.determiner in ("its", "their")
    if region == "corner" and not own:
        filled = waiting.place.type == "occupying" or waiting.place.words in words("relations")["of_corners"]
        if filled or not subjects or any(s.mount == "floor" for s in subjects):
            return "room"
    if region == "center":
        return _center_meant(state, own, subjects)
    if region == "end" and not own and _is_end_of_room(state, phrase, subjects):
        return "room"
    sides = {t.text for t in phrase.qualities} & {"left", "right", "far", "near"}
    if region == "side" and len(sides) == 1 and not own and waiting.place.type == "along":
        return f"wall:{sides.pop()}"  # "lockers down the left side"
    if region in ("head", "foot"):  # these are of beds, whatever was named last
        beds = [m for m in state.out.mentions if m.family == "bed_group" and m not in subjects]
        if beds:
            return beds[-1]
    stand = region in ("side", "end") and bool(subjects) and all(s.mount == "floor" for s in subjects)
    near = nearest(state, subjects, apart=stand)  # stools are along no pan that hangs over the island
    if phrase.determiner == "its" and near and near[-1].many:
        pronoun = NounPhrase("pronoun", "it", phrase.start, phrase.end, value="pron")
        near = state.refs.pronoun(pronoun, [], [*subjects, *near]) or near
    return state.refs.carrier(near, subjects, region, phrase.text) or next(iter(near[-1:]), None)


def _is_end_of_room(state: State, phrase: NounPhrase, subjects: list[Mention]) -> bool:
    """Whether "one end" and "the other end" are the room's: of furniture that is told to be there, of no table."""
    spoken = state.source.text[phrase.start : phrase.end].split()
    of_two = not {phrase.determiner, *spoken}.isdisjoint(words("relations")["one_of_two"])
    framed = any(f.kind in ("with", "verb") and f.owner for f in state.frames[-1:])
    stands = bool(subjects) and all(s.mount in ("floor", "wall") and s.family != "seat" for s in subjects)
    return of_two and stands and not framed


def _center_meant(state: State, own: bool, subjects: list[Mention]) -> Mention | str:
    """The middle of what small things stand on, else of the room."""
    small = bool(subjects) and all(s.is_small for s in subjects)
    frame = state.frames[-1] if state.frames else None
    if frame is not None and frame.kind == "with" and any(o.family == "table" for o in frame.owner):
        small = small or any(s in frame.items and s.family not in ("seat", "table") and not s.is_rug for s in subjects)
    near = nearest(state, subjects) if subjects else (state.refs.topics[-1] if state.refs.topics else [])
    root = carrier_root(state, near[-1]) if near else None
    if small and state.surface is not None and not own:
        return state.surface
    if small and root is not None and root is not near[-1] and root not in subjects:
        return root
    if (small or own) and near:
        return state.refs.carrier(near, subjects) or near[-1]
    return "room"


def _of_room(state: State, phrase: NounPhrase, waiting: Waiting, owner: str) -> None:
    """Relates what waits to the middle, a corner or a wall of the room."""
    subjects = waiting.subjects or []
    if subjects and any(t.text == "opposite" for t in phrase.qualities):
        for other in main_things(state, subjects)[-1:]:
            say(state, Said("opposite", subjects, (other,), phrase.text, span=state.chunk_span(), implied=True))
    place = {"corner": "corner", "center": "middle", "end": "wall:short", "side": "wall"}.get(str(phrase.value), "room")
    if owner in ("wall", "window", "door", "ceiling") or owner.startswith("wall:"):
        place = owner
    if phrase.determiner in ("each", "every", "all") or phrase.text == "corners":
        for subject in subjects:
            subject.count = (phrase.count or (4, 4)) if subject.count == (1, 1) else subject.count
    if place in ("corner", "middle"):
        waiting = replace(waiting, place=Place("at", words=waiting.place.words))
    if place.startswith("wall") and phrase.value == "center":  # "in the middle of the far wall"
        waiting = replace(waiting, place=Place("centered_on", words=f"{waiting.place.words} the middle of"))
    bind_target(state, waiting, (place,))


def _kind_on(region: str, phrase: NounPhrase, waiting: Waiting, owner: Mention) -> str:
    """The type of relation that a word of place and a region of a thing make together."""
    kind, subjects = waiting.place.type, waiting.subjects or []
    if region == "end" and kind in ("at", "on", "near"):
        if subjects and all(s.is_small for s in subjects):
            return "on"
        return "at_foot" if "bed" in owner.category else "next_to"
    table = words("relations")["regions"]
    found = table.get(region, {}).get(kind) or table.get(phrase.text, {}).get(kind)
    return found or ("inside" if region == "inside" else "on" if kind == "occupying" else kind)


def part_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """What a thing has is said of it: "with three drawers", "a tufted headboard"."""
    if phrase.determiner in EACH and state.refs.known(phrase, True, []) is not None:
        named_thing(state, phrase, chunk)  # "seven wheels, at every wheel a stool"
        return
    owners = state.frames[-1].owner if state.frames and state.frames[-1].kind in ("with", "verb") else []
    owners = owners or (state.head if state.glue in ("open", "", "and") else [])
    opening = phrase.text.split()[-1].rstrip("s")
    if state.waiting is not None and opening in ("door", "window"):
        phrase.what, phrase.value = "place", opening
        place_phrase(state, phrase, chunk)
        return
    after = state.chunk(state.at)
    over = (
        phrase.plural and after is not None and after.kind == "place" and after.value.type in ("above", "hanging_from")
    )
    if (phrase.count is not None or over) and state.waiting is None and _stands_apart(state, phrase):
        named_thing(state, phrase, chunk)  # "five hooks above it"
        return
    waiting, state.waiting = state.waiting, None
    if waiting is not None and waiting.subjects and phrase.definite:  # "a pillow against the headboard"
        near = [m for m in reversed(state.out.mentions[-20:]) if any(a.value == phrase.text for a in m.attributes)]
        near = [m for m in near if m not in waiting.subjects] or nearest(state, waiting.subjects)
        if near:
            bind_target(state, waiting, (near[0],))
        state.glue = ""
        return
    if waiting is not None and waiting.subjects:
        owners = waiting.subjects
    for owner in owners[-1:]:
        owner.attributes += _said_of_part(state, phrase)
    if not owners and not phrase.definite:
        number, _, noun = phrase.text.partition(" ")
        if number in _TWO and noun:  # "two sinks" that no cabinet has
            phrase.count, phrase.text, phrase.plural = (2, 2), noun, True
        hung = phrase.plural and after is not None and after.kind == "verb" and after.value.form == "ed"
        mention = new_thing(state, phrase) if phrase.determiner or phrase.count or hung else None
        if mention is not None:
            name_things(state, [mention], phrase, True)
            return
    if not owners and state.glue == "comma" and state.placed_next(state.at):
        name_nothing(state)  # "drawers under the bunk": of the drawers, not of what was named before
        return
    state.glue = ""
    state.head = list(owners[-1:]) if owners else state.head


def _stands_apart(state: State, phrase: NounPhrase) -> bool:
    """Whether what may be a part of a thing is told of as a thing: it is known as one, and words say where it is."""
    after = state.chunk(state.at)
    placed = after is not None and after.kind == "place" and after.value.type in ("above", "below", "next_to", "beside")
    return placed and match_of(phrase.text).how in ("exact", "synonym", "plural")


def _said_of_part(state: State, phrase: NounPhrase) -> list[Attribute]:
    """A part, and each word of quality with it: "carved legs" are legs and carved legs."""
    span = state.span_of(phrase)
    spoken = " ".join(state.source.text[phrase.start : phrase.end].split())
    found = [Attribute(kind="part", value=phrase.text, words=spoken, count=phrase.count, span=span)]
    for token in phrase.qualities:
        if token.has("material", "adjective", "color", "shape", "styles", "scale"):
            both = f"{token.text} {phrase.text}"
            found.append(Attribute(kind="part", value=both, words=both, span=span))
    return found
