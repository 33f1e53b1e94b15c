"""Parts of things: tops, middles, sides, shelves, headboards."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .items import bind_target, name_nothing, name_things
from .model import Attribute
from .nearness import carrier_root, main_things, nearest
from .parsed import Mention
from .relating import say
from .room_phrases import place_phrase, room_phrase
from .state import State
from .thing_phrases import is_part, named_thing, new_thing
from .vocabulary import Place, family, mounts

_TWO = ("two", "double", "dual")


def thing_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    if is_part(state, phrase):
        part_phrase(state, phrase, chunk)
    else:
        named_thing(state, phrase, chunk)


def _whose(state: State, of: NounPhrase) -> Mention | None:
    """What a part is of."""
    without = (state.waiting.subjects or []) if state.waiting is not None else []
    if of.what == "pronoun":
        found = state.refs.pronoun(of, nearest(state, without), without)
        return found[-1] if found else None
    if of.what != "thing":
        return None
    found_one = state.refs.known(of, True, without)
    return found_one if found_one is not None else new_thing(state, of)


def region_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """The top, the middle, a corner, a side: of a thing, or of the room."""
    region, of = str(phrase.value), phrase.of
    if of is not None and of.what == "room" and state.waiting is None and state.out.room_type is None:
        room_phrase(state, of, chunk)
        return
    waiting, state.waiting = state.waiting, None
    owner: Mention | str | None = None
    if of is not None:
        if of.what in ("room", "place"):
            owner = str(of.value) if of.what == "place" and of.value not in ("floor", "room") else "room"
        elif of.what in ("thing", "pronoun"):
            owner = _whose(state, of)
    else:
        named = [t for t in phrase.qualities if t.has("noun")]
        if named:
            inner = NounPhrase("thing", named[-1].text, phrase.start, phrase.end, value=None, determiner="the")
            owner = state.refs.known(inner, True, (waiting.subjects or []) if waiting else [])
        if any(t.has("room") and not t.has("noun") for t in phrase.qualities):
            owner = "room"
    if (
        waiting is None
        and not phrase.definite
        and state.frames
        and state.frames[-1].kind == "with"
        and state.frames[-1].owner
        and of is None
    ):
        part_phrase(state, phrase, chunk)
        return
    if waiting is None:
        if region in ("center", "corner", "side"):
            name_nothing(state)
        elif owner is not None and isinstance(owner, Mention):
            name_things(state, [owner], phrase, chunk, False)
        else:
            own = state.subject[-1:] if phrase.determiner == "its" else []
            own = [m for m in own if mounts(m.category)[0] == "floor"]
            found = own[0] if own else state.refs.carrier([*state.subject, *nearest(state, [])], [], "top", phrase.text)
            if found is not None and phrase.definite:
                name_things(state, [found], phrase, chunk, False)
            else:
                name_nothing(state)
        return
    subjects = waiting.subjects or []
    if (
        owner is None
        and region == "corner"
        and phrase.determiner not in ("its", "their")
        and (
            waiting.place.words in ("in", "inside", "into", "near", "fill", "fills")
            or waiting.place.type == "occupying"
            or not subjects
            or any(mounts(s.category)[0] == "floor" for s in subjects)
        )
    ):
        owner = "room"
    if owner is None and region == "center":
        small = bool(subjects) and all("surface" in mounts(s.category) for s in subjects)
        frame = state.frames[-1] if state.frames else None
        if frame is not None and frame.kind == "with" and any(family(o.category) == "table" for o in frame.owner):
            small = small or any(
                s in frame.items and family(s.category) not in ("seat", "table") and "rug" not in s.category
                for s in subjects
            )
        near = nearest(state, subjects) if subjects else (state.refs.topics[-1] if state.refs.topics else [])
        root = carrier_root(state, near[-1]) if near else None
        if small and state.surface is not None and phrase.determiner not in ("its", "their"):
            owner = state.surface
        elif small and root is not None and root is not near[-1] and root not in subjects:
            owner = root
        elif (small or phrase.determiner in ("its", "their")) and near:
            owner = state.refs.carrier(near, subjects) or near[-1]
        else:
            owner = "room"
    if owner is None:
        near = nearest(state, subjects)
        if phrase.determiner == "its" and near and near[-1].many:
            pronoun = NounPhrase("pronoun", "it", phrase.start, phrase.end, value="pron")
            near = state.refs.pronoun(pronoun, [], [*subjects, *near]) or near
        owner = state.refs.carrier(near, subjects, "top" if region == "top" else region, phrase.text) or (
            near[-1] if near else None
        )
    if owner is None:
        name_nothing(state)
        return
    if isinstance(owner, str):
        if any(t.text == "opposite" for t in phrase.qualities) and subjects:
            others = main_things(state, subjects)
            if others:
                say(
                    state, "opposite", subjects, (others[-1],), phrase.text, None, False, None, state.chunk_span(), True
                )
        place = {"corner": "corner", "center": "middle"}.get(region, "room")
        if owner in ("wall", "window", "door", "ceiling") or owner.startswith("wall:"):
            place = owner
        if phrase.determiner in ("each", "every", "all") or phrase.text == "corners":
            for subject in subjects:
                if subject.count == (1, 1):
                    subject.count = phrase.count or (4, 4)
        bind_target(
            state,
            waiting._replace_place(Place("at", words=waiting.place.words))
            if place in ("corner", "middle")
            else waiting,
            (place,),
        )
    else:
        kind = waiting.place.type
        if region == "center" and kind in (
            "inside",
            "on",
            "at",
            "near",
            "centered_on",
            "occupying",
            "along",
            "covering",
        ):
            kind = "centered_on"
        elif region == "inside":
            kind = "inside"
        elif region in ("top", "corner") and kind in ("inside", "at", "occupying", "covering", "on"):
            kind = "on"
        elif region == "end" and kind in ("at", "on", "near"):
            kind = (
                "on"
                if subjects and all("surface" in mounts(s.category) for s in subjects)
                else "at_foot"
                if "bed" in owner.category
                else "next_to"
            )
        elif phrase.text in ("edge", "rim", "ledge", "lip") and kind in ("near", "next_to"):
            kind = "on"
        elif region in ("foot", "head") and kind in ("at", "near", "by", "on"):
            kind = {"foot": "at_foot", "head": "at_head"}[region]
        elif region in ("side", "front", "back") and kind in ("on", "at", "by", "near", "inside"):
            kind = {"side": "next_to", "front": "in_front_of", "back": "behind"}[region]
        if kind == "occupying":
            kind = "on"
        place = Place(kind, waiting.place.side, waiting.place.each, f"{waiting.place.words} {phrase.text}")
        bind_target(state, waiting._replace_place(place), (owner,))
    state.glue, state.last_target = "", None
    if waiting.subjects is None:
        state.head = []


def part_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """What a thing has is said of it: "with three drawers", "a tufted headboard"."""
    owners = state.frames[-1].owner if state.frames and state.frames[-1].kind in ("with", "verb") else []
    owners = owners or (state.head if state.glue in ("open", "", "and") else [])
    opening = phrase.text.split()[-1].rstrip("s")
    if state.waiting is not None and opening in ("door", "window"):
        phrase.what, phrase.value = "place", opening
        place_phrase(state, phrase, chunk)
        return
    waiting, state.waiting = state.waiting, None
    if waiting is not None and phrase.definite and waiting.subjects:  # "a pillow against the headboard"
        near = [m for m in reversed(state.out.mentions[-20:]) if any(a.value == phrase.text for a in m.attributes)]
        near = [m for m in near if m not in waiting.subjects] or nearest(state, waiting.subjects)
        if near:
            bind_target(state, waiting, (near[0],))
        state.glue = ""
        return
    if waiting is not None and waiting.subjects:
        owners = waiting.subjects
    span = state.source.span(phrase.start, phrase.end)
    said = state.source.text[phrase.start : phrase.end]
    for owner in owners[-1:]:
        owner.attributes.append(
            Attribute(kind="part", value=phrase.text, words=" ".join(said.split()), count=phrase.count, span=span)
        )
        for token in phrase.qualities:
            if token.has("material", "adjective", "color", "shape", "styles", "scale"):
                owner.attributes.append(
                    Attribute(
                        kind="part",
                        value=f"{token.text} {phrase.text}",
                        words=f"{token.text} {phrase.text}",
                        span=span,
                    )
                )
    if not owners and not phrase.definite:
        number, _, noun = phrase.text.partition(" ")
        if number in _TWO and noun:  # "two sinks" that no cabinet has
            phrase.count, phrase.text, phrase.plural = (2, 2), noun, True
        mention = new_thing(state, phrase) if phrase.determiner or phrase.count else None
        if mention is not None:
            name_things(state, [mention], phrase, chunk, True)
            return
    state.glue = ""
    state.head = list(owners[-1:]) if owners else state.head
