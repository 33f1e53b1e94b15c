"""Relations as they are said: who, where, and what is meant where it is not said."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, likeliness

from .chunks import Chunk, NounPhrase
from .distribution import on_each_side
from .model import ANYTHING, Span
from .nearness import SIDED, anchor, beside_those, carrier_root, chained, main_things, nearest
from .parsed import Barred, Left, Mention, Said, Target, without
from .state import Frame, State
from .vocabulary import Place, mounts, words
from .wall_names import PARTS

FLAT = 0.05
"""Height [m] up to which what lies on floors is kept on shelves."""

_SIDES_OF_ROOM = ("near", "next_to", "opposite", "left_of", "right_of", "behind", "in_front_of")
"""Relations of what stands on the floor to something else that does."""


def support_kind(kind: str, carrier: Mention) -> str:
    """Whether what something holds stands on or in it."""
    relations = words("relations")
    if any(carrier.noun.endswith(word) or carrier.category.endswith(word) for word in relations["insides"]):
        return "inside"
    if kind == "inside" and any(carrier.noun.endswith(word) for word in relations["tops"]):
        return "on"
    return kind


def relate(
    state: State,
    place: Place,
    subjects: list[Mention],
    targets: tuple[Any, ...],
    span: Span | None,
    count: tuple[int, int] | None = None,
) -> None:
    """A relation between things, or of things and a place of the room, in the terms of the graph."""
    subjects = without(subjects, targets)
    if not subjects or not targets or any(t is None for t in targets):
        return
    if place.type in words("relations")["sitters"]:
        own, viewed = words("relations")["sitters"][place.type]
        place = replace(place, type=own if _is_sat_on(targets[0]) else viewed)
    said = Said(place.type, subjects, targets, place.words, count, span=span, nth=place.nth, params=place.params)
    target, one = targets[0], subjects[0]
    if target in state.party and one in state.party and span is not None and place.type in ("on", "inside"):
        return  # "office supplies in the drawer": in none of themselves
    if state.barred:
        _bar(state, said)
        return
    if isinstance(target, str):
        relate_to_place(state, said)
        return
    flanked = place.type == "flanking" and not place.words.startswith("flank")
    alone = flanked and len(subjects) == 1 and one.count == (1, 1) and count is None
    if alone:
        one.count = (2, 2)  # "a nightstand on either side of the bed"
    if place.type == "through":
        return
    kind = said.type = close_kind(_meant_kind(place.type, place.words, subjects), place.words, subjects, target)
    if kind in ("on", "inside") and not target.is_rug:
        call_by_place(subjects, "surface")
    lamps = [
        s for s in subjects if kind == "above" and s.category == "table_lamp" and target.family in ("table", "seat")
    ]
    if kind == "above" and place.words.startswith("hang"):
        call_by_place(subjects, "ceiling")
    elif lamps:  # "a lamp low over the table"
        call_by_place(lamps, "ceiling")
    elif kind == "above" and target.mount == "floor":
        call_by_place(subjects, "over_table" if has_role(target.category, "lit_table") else "over")
    if kind == "on" and target.is_rug:  # what stands on the table on the rug is not on the rug
        roots = (carrier_root(state, s) if s.category != target.category else s for s in subjects)
        said.subjects = list(dict.fromkeys(roots))
    if kind == "centered_on" and (target.is_rug or all(s.is_small for s in subjects)):
        say(state, replace(said, type="on", targets=(target,)))
    if kind in _SIDES_OF_ROOM and target.mount == "floor" and not target.is_rug and not said.implied:
        _apart_from_owner(state, said, target)
    said.side = place.side
    if kind in ("along", "flanking") and count is None and len(subjects) == 1 and not alone:
        on_each_side(said, place.words.split(), one, target)
    said.each = place.each and (said.count is not None or said.type not in ("flanking", "along"))
    say(state, said)


def _apart_from_owner(state: State, said: Said, target: Mention) -> None:
    """ "A bookcase with a chair in front and a lamp beside that": the lamp is not on the bookcase."""
    for one in [s for s in state.out.said[-6:] if s.implied and s.type in ("on", "inside")]:
        if one.subjects == said.subjects and target not in one.targets and " with " in one.words:
            state.out.said.remove(one)


def _bar(state: State, said: Said) -> None:
    """A relation that must not hold, said of what is wanted elsewhere or, of each other kind, of what is not wanted."""
    target = said.targets[0]
    kind = said.type
    if isinstance(target, str):
        if target in ("room", "floor") or kind == "through":
            spoken = f"{state.negation} {said.words} the {target}"
            where = said.span or state.chunk_span()
            state.out.unread.append(Left(spoken, span=where))
            return
        kind = _kind_at(kind, target, said.subjects)
    unwanted = {m for m in said.subjects if m in state.unwanted}
    for subject in said.subjects:
        names = tuple(subject.words) if subject in unwanted else ()
        spoken = f"no {subject.noun} {said.words}" if subject in unwanted else f"not {said.words}"
        spoken = f"{subject.noun} {said.words}" if names == (ANYTHING,) else spoken
        spoken = f"{spoken} the {target.partition(':')[0]}" if isinstance(target, str) else f"{spoken} {target.noun}"
        state.out.barred.append(Barred(kind, [subject], said.targets, spoken, span=said.span, categories=names))


def _meant_kind(kind: str, spoken: str, subjects: list[Mention]) -> str:
    """The type of relation that a word of place means of such things."""
    if kind in ("at_head", "at_foot") and spoken.startswith("on") and all(s.mount == "surface" for s in subjects):
        return "on"
    if kind == "above" and all(s.mount == "floor" and "lamp" in s.noun for s in subjects):
        return "near"  # a floor lamp that arches over a sofa
    return "on" if kind in ("occupying", "covering") else kind


def close_kind(kind: str, spoken: str, subjects: list[Mention], target: Target) -> str:
    """What "at" and "by" mean, which are nearer than "near": seats are at a table, other things next to it; at a wall
    is against it."""
    first = spoken.lower().partition(" ")[0]
    lying = all(s.is_small and s.mount == "surface" for s in subjects)
    if kind == "opposite" and spoken.lower().endswith("across") and lying and not isinstance(target, str):
        return "on"  # a scarf across a bench lies on it
    if kind != "near" or first not in ("at", "by"):
        return kind
    if isinstance(target, str):
        part = target.partition(":")[0]
        return {"wall": "against", "window": "at"}.get(part, kind)  # a door wants room to open
    if lying and not target.is_small:
        return kind  # a screen at a desk is on it
    seated = first == "at" and all(has_role(s.category, "pulled_up") for s in subjects)
    return "at" if seated and has_role(target.category, "pulled_up_to") else "next_to"


def call_by_place(subjects: list[Mention], where: str) -> None:
    """What things are called where they stand or hang: a plant on a table is a small one."""
    other = words("nouns")["hung"][where]
    for subject in subjects:
        subject.category = other.get(subject.category, subject.category)


def say(state: State, said: Said) -> None:
    """Adds a statement; who it is about may be meant by what follows, unless it only follows from "with"."""
    state.out.said.append(replace(said, subjects=list(said.subjects)))
    if not said.implied:
        state.last_subjects, state.head_related = list(said.subjects), True


def relate_to_place(state: State, said: Said) -> None:
    """A relation of things to a part of the room, its only target."""
    if state.barred:
        _bar(state, said)
        return
    kind, subjects, place = said.type, said.subjects, str(said.targets[0])
    if kind == "through":
        return
    if place in ("door", "window") and "back" in said.words.split():
        state.out.unread.append(Left(f"{said.words} the {place}", span=said.span or state.chunk_span()))
        return  # turned away from it, and not against it
    if place == "room" and kind == "next_to" and "side" in said.words.split():
        kind, place = "against", "wall:side"  # "to one side of the room"
    if place == "room" and kind in ENDS_OF_ROOM:
        kind, place = "against", ENDS_OF_ROOM[kind]
    if place == "room" and kind == "opposite":
        for target in nearest(state, subjects):
            say(state, replace(said, targets=(target,)))
        return
    if place in ("room", "floor"):
        if kind == "centered_on":
            kind, place = "at", "middle"
        elif place == "room" or kind != "on" or not all(s.mount == "surface" for s in subjects):
            return  # all furniture is in the room and on its floor
    if place == "wall:opposite":
        others = main_things(state, subjects)
        if others:
            of_wall = f"{said.words} the opposite wall"
            say(state, replace(said, type="opposite", targets=(others[-1],), words=of_wall, implied=True))
        place = "wall" if others else "wall:far"
    lone = kind == "flanking" and place in ("window", "door") and not said.words.startswith("flank")
    if lone and len(subjects) == 1 and subjects[0].count == (1, 1):
        subjects[0].count = (2, 2)  # "a plant on either side of the door"
    if place.startswith("wall") and kind in ("on", "against", "inside") and said.words.startswith("hang"):
        kind = "hanging_from"
    hung = all(s.mount in ("ceiling", "wall") for s in subjects)
    if place == "window" and kind == "opposite" and said.words == "across" and hung:
        kind = "in_front_of"  # "a line across the window"
    if place.startswith("wall") and kind == "opposite" and said.words.startswith("across"):
        kind = "against"  # "a stage across the far end"
    if place == "wall:breast" and kind in _BESIDE:
        kind, place = "against", "wall:beside_breast"
    if place == "wall:breast" and kind == "inside":
        kind, place = "against", "wall:breast_opening"
    if place == "wall:bay" and kind in _BESIDE:
        place = "window"
    kind = close_kind(kind, said.words, subjects, place)
    stated, kind = kind, _kind_at(kind, place, subjects)
    subjects = _carriers_of(state, kind, subjects, place)
    if place in ("wall", "ceiling") and kind in ("on", "hanging_from"):
        for one in state.out.said[-8:]:
            if one.implied and one.type == "on" and one.subjects == subjects:
                one.type = "above"  # "each bed has a lamp on the wall"
    if place == "ceiling":
        call_by_place(subjects, "ceiling")
    elif place.startswith("wall") and kind != "against":
        call_by_place(subjects, "wall")
    if {"against", "leaning_on"} & {stated, kind} and not said.implied:
        subjects = [*subjects, *beside_those(state, subjects)]
    if kind == "far_from" and place not in ("door", "window"):
        state.out.note(f"'away from the {place}' cannot be said as a relation and was left out")
        return
    part = place.partition(":")[2]
    name = part.replace("_", " ") if part in PARTS else place.split(":")[0]
    spoken = said.words if said.words.endswith((place, "each", "side of")) else f"{said.words} the {name}"
    say(state, replace(said, type=kind, subjects=subjects, targets=(place,), words=spoken))


_BESIDE = ("flanking", "next_to", "side_by_side", "left_of", "right_of")
"""What puts things at the wall beside a chimney breast."""


def _carriers_of(state: State, kind: str, subjects: list[Mention], place: str) -> list[Mention]:
    """What is at a wall, in a corner or by a window where small things were named last: "a rack with jars on the left
    wall" is about the rack."""
    frame = state.frames[-1] if state.frames else None
    if frame is None or frame.kind not in ("with", "verb") or not frame.owner or kind in ("facing", "below"):
        return subjects
    owner = frame.owner[-1]
    if place == "wall" and kind == "on" and all(s.category in words("nouns")["hung"]["wall"] for s in subjects):
        return subjects  # "each bed has a lamp on the wall"
    carried = all(
        s.is_small
        and s in frame.items
        and "wall" not in mounts(s.category)
        and (s.mount == "surface" or likeliness(s.category, owner.category) is not None)
        for s in subjects
    )
    stored = owner.family == "storage" or bool(category_named(owner.category).holds)
    carried = carried or (stored and all(s in frame.items and _is_less(s, owner) for s in subjects))
    stands = owner.mount in ("floor", "wall") and owner not in subjects
    return list(frame.owner) if subjects and carried and stands else subjects


def seen_before(state: State, place: Place, target: Mention) -> Mention:
    """What "it" is in "a rack to the left of the fire, a basket to the right of it": the fire, and not the rack."""
    last = state.out.said[-1] if state.out.said else None
    if last is None or {last.type, place.type} != {"left_of", "right_of"} or target not in last.subjects:
        return target
    return last.targets[0] if isinstance(last.targets[0], Mention) else target


def _is_less(thing: Mention, other: Mention) -> bool:
    """Whether a thing on the floor is so much smaller than another that it is on or in it: mats with a shelf."""
    one, two = category_named(thing.category).size, category_named(other.category).size
    if one is None or two is None or "wall" in mounts(thing.category):
        return False
    return one.height[1] <= FLAT or 3 * one.height[1] * one.width[1] <= two.height[1] * two.width[1]


def _kind_at(kind: str, place: str, subjects: list[Mention]) -> str:
    """The type of relation to a part of the room."""
    if place.startswith("wall"):
        if kind in ("inside", "at", "occupying", "covering", "around", "flanking"):
            return "against"
        stand = bool(subjects) and all(s.mount == "floor" for s in subjects)
        return "against" if kind == "on" and stand else kind
    if place == "ceiling" and kind in _AT_CEILING:
        return "hanging_from"
    if place.partition(":")[0] in ("corner", "middle", "half") and kind not in ("facing", "far_from"):
        return "at"
    if place in ("window", "door") and kind in ("inside", "on", "occupying", "covering"):
        return "at"
    return _meant_kind(kind, "", subjects)


ENDS_OF_ROOM = {
    "at_foot": "wall:short",
    "along": "wall:short",
    "behind": "wall:far",
    "in_front_of": "wall:near",
    "left_of": "wall:left",
    "right_of": "wall:right",
}
"""Where "at the end of", "at the back of", "on the left side of" the room are, by their types."""

_AT_CEILING = frozenset(
    ("on", "from", "inside", "hanging_from", "at", "near", "against", "above", "below", "centered_on", "covering")
)


def relate_to_nearest(state: State, place: Place, subjects: list[Mention] | None, chunk: Chunk) -> None:
    """A word of place without a target: "a rug in front", "to its left", "overhead"."""
    if subjects is None:
        subjects = [m for f in state.frames[-1:] for m in f.items]
        if not subjects and (state.refs.topics or state.out.mentions):
            _front(state, place, chunk)
            return
    if not subjects:
        return
    its, sideways = "its" in place.words.split(), place.type in ("left_of", "right_of")
    end = words("relations")["ends"].get(place.words)
    if end is not None and all(s.mount != "surface" for s in subjects):
        relate_to_place(state, Said(_at_end(end), subjects, (end,), place.words, span=state.span_of(chunk)))
        return
    if place.type in words("relations")["sitters"]:
        _beside_sitter(state, place, subjects, chunk)
        return
    near = main_things(state, subjects) if place.type == "opposite" else None
    if near is None:
        near = nearest(state, subjects, apart=place.type in _SIDES_OF_ROOM)
    if its and near and near[-1].many:
        it = NounPhrase("pronoun", "it", chunk.start, chunk.end, value="pron")
        near = state.refs.pronoun(it, [], [*subjects, *near]) or near
    if its and place.type in SIDED:
        near = chained(state, near, subjects)
    if place.type == "inside" and not near:
        return
    if sideways and (not near or (not its and _seen_from_door(state, near[-1]))):
        relate_to_place(state, Said("against", subjects, (f"wall:{place.type.split('_')[0]}",), place.words))
        return
    if place.type == "centered_on":
        if state.surface is not None and all(s.is_small for s in subjects):
            near = [state.surface]
        if not near or not any(s.is_small for s in subjects):
            relate_to_place(state, Said("at", subjects, ("middle",), place.words, span=state.span_of(chunk)))
            return
    if not near:
        state.out.note(f"'{chunk.text}': it is not clear of what; it was left out")
        return
    seated = place.type == "in_front_of" and all(s.family == "seat" for s in subjects)
    seated = seated and near[-1].family not in ("table", "storage", "seat", "bed_group")
    if seated or sideways or place.type in ("near", "above"):
        near = [anchor(state, near[-1], place.type, subjects)]
    target = near[0] if place.type in ("above", "below") else near[-1]
    owned = any(f.kind in ("with", "verb") and target in f.owner for f in state.frames)
    if place.type == "on" and not owned:
        target = state.refs.carrier(near, subjects) or target
    relate(state, place, subjects, (target,), state.span_of(chunk), count=state.subset)


def _beside_sitter(state: State, place: Place, subjects: list[Mention], chunk: Chunk) -> None:
    """ "A table at her right hand": beside what was named last that people sit or lie on."""
    subjects = [m for m in subjects if not _is_sat_on(m)]
    named = without([*nearest(state, subjects)[::-1], *reversed(state.out.mentions[-20:])], subjects)
    seats = [m for m in named if _is_sat_on(m)]
    if not seats or not subjects:
        state.leave_unread(chunk.text, chunk.start, chunk.end)
        return
    relate(state, place, subjects, (seats[0],), state.span_of(chunk), count=state.subset)


def _is_sat_on(thing: Target) -> bool:
    """Whether people sit or lie on a thing, so that it has sides of theirs."""
    if isinstance(thing, str):
        return False
    return not {thing.family, thing.category}.isdisjoint(words("relations")["sat_on"])


def _at_end(place: str) -> str:
    """How things are at an end of the room that a word alone means: a door wants room to open."""
    return "against" if place.startswith("wall") else "near"


def _seen_from_door(state: State, thing: Mention) -> bool:
    """Whether a thing is at the left or right of the room itself: what is at the other side after it is so as well."""
    sides = ("wall:left", "wall:right")
    return any(thing in said.subjects and said.targets[0] in sides for said in state.out.said if said.by_side)


def _front(state: State, place: Place, chunk: Chunk) -> None:
    """ "Across the room stands a wardrobe": a word of place that comes before who it is about."""
    end = words("relations")["ends"].get(place.words)
    if end is not None:
        state.fronted.append((Place(_at_end(end), words=place.words), (end,), chunk))
        return
    across = place.type == "opposite" and "room" in place.words
    targets = main_things(state, []) if across else nearest(state, [])
    if place.type == "centered_on" and state.surface is not None:
        targets = [state.surface]
    if targets and place.type in ("below", "near", "next_to", "opposite", "around"):
        targets = [carrier_root(state, targets[-1])]
    if not across or state.out.mentions:
        state.fronted.append((place, tuple(targets[-1:]), chunk))


def relate_mutually(state: State, place: Place, chunk: Chunk) -> None:
    """ "Two desks side by side", "a sofa and a bench facing each other"."""
    subjects = list(state.head)
    items = state.frames[-1].items if state.frames else []
    if state.subject_open and not state.frames and len(state.subject) > 1 or state.glue == "verb" and state.subject:
        subjects = list(state.subject)
    elif len(items) > 1 and len(state.head) == 1 and not state.head[0].many:
        subjects = items[-2:] if place.type != "left_to_right" else list(items)
    span = state.span_of(chunk)
    if not subjects:
        return
    if place.type == "left_to_right":
        for one, two in pairwise(subjects):
            say(state, Said("right_of", [two], (one,), chunk.text, span=span))
        return
    say(state, Said(place.type, subjects, ("each other",), chunk.text, span=span))
    state.head = subjects


def relate_to_owner(state: State, frame: Frame, mentions: list[Mention], phrase: NounPhrase) -> None:
    """ "A desk with a lamp": what is small stands on what it came with, the rest is near it."""
    if not frame.owner:
        return
    owner = frame.owner[-1]
    for mention in mentions:
        party = state.party if owner in state.party else []
        if mention is owner or mention in party:
            continue
        small = mention.mount == "surface" or (mention.generic and owner.family == "table")
        if small and without(party, [mention]):
            ranks = [
                (rank, k, m)
                for k, m in enumerate(without(party, [mention]))
                if (rank := likeliness(mention.category, m.category)) is not None
            ]
            if not ranks:
                continue
            owner = min(ranks)[2]
        kind = owned_kind(mention, owner, small)
        if kind is not None:
            spoken, span = f"{owner.noun} with {mention.noun}", state.span_of(phrase)
            said = Said(kind, [mention], (owner,), spoken, each=frame.each, span=span, implied=True, nth=frame.nth)
            say(state, said)


def owned_kind(mention: Mention, owner: Mention, small: bool) -> str | None:
    """How what something comes with usually stands to it; None where "with" says nothing of places."""
    if small and (owner.mount in ("floor", "wall") or category_named(owner.category).holds):
        return support_kind("on", owner)
    if mention.mount != "floor" or owner.mount != "floor":
        return "above" if mention.mount == "wall" else None
    seat = mention.family == "seat" or has_role(mention.category, "upright_seat")
    if seat and (owner.family == "table" or has_role(owner.category, "seated_at", "pulled_up_to", "dressing_place")):
        return "at"
    if mention.category == "nightstand":
        beds = owner.count[0] if mention.per is owner and owner.count is not None else 1
        return "flanking" if mention.count == (2 * beds, 2 * beds) else "next_to"
    return "near"
