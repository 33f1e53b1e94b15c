"""Relations as they are said: who, where, and what is meant where it is not said."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets.taxonomy import category_named, likeliness

from .chunks import Chunk, NounPhrase
from .model import Span
from .nearness import SIDED, anchor, beside_those, carrier_root, chained, main_things, nearest
from .parsed import Mention, Said
from .state import State
from .things import SMALL
from .vocabulary import Place, family, mounts, words


def support_kind(state: State, kind: str, carrier: Mention) -> str:
    """Whether what something holds stands on or in it."""
    inside = words("relations")["insides"]
    if any(carrier.noun.endswith(word) or carrier.category.endswith(word) for word in inside):
        return "inside"
    on = words("relations")["tops"]
    if kind == "inside" and any(carrier.noun.endswith(word) for word in on):
        return "on"
    return kind


def relate(
    state: State,
    place: Place,
    subjects: list[Mention],
    targets: tuple[Any, ...],
    chunk: Chunk | None,
    count: tuple[int, int] | None = None,
    span: Span | None = None,
    implied: bool = False,
) -> None:
    """A relation between things, or of things and a place of the room."""
    subjects = [s for s in subjects if not any(s is t for t in targets)]
    if not subjects or not targets or any(t is None for t in targets):
        return
    spoken = place.words or (chunk.text if chunk else "")
    span = span or (state.source.span(chunk.start, chunk.end) if chunk is not None else None)
    kind, side, each = place.type, place.side, place.each
    target = targets[0]
    if isinstance(target, str):
        relate_to_place(state, kind, subjects, target, spoken, count, span, implied)
        return
    if (
        kind == "flanking"
        and len(subjects) == 1
        and subjects[0].count == (1, 1)
        and spoken != "flanking"
        and count is None
        and not spoken.startswith("flank")
    ):
        subjects[0].count = (2, 2)  # "a nightstand on either side of the bed"
    if kind == "through":
        return
    if (
        kind in ("at_head", "at_foot")
        and spoken.startswith("on")
        and all(mounts(s.category)[0] == "surface" for s in subjects)
    ):
        kind = "on"
    if kind == "above" and all(mounts(s.category)[0] == "floor" and "lamp" in s.noun for s in subjects):
        kind = "near"  # a floor lamp that arches over a sofa
    if kind in ("occupying", "covering"):
        kind = "on"
    if kind in ("on", "inside"):
        for subject in subjects:
            if subject.category in SMALL and "rug" not in target.category:
                subject.category = SMALL[subject.category]
    if kind == "above" and spoken.startswith("hang"):
        for subject in subjects:
            subject.category = words("nouns")["hung"]["ceiling"].get(subject.category, subject.category)
    if kind == "on" and "rug" in target.category:
        subjects = list(dict.fromkeys(carrier_root(state, s) if s.category != target.category else s for s in subjects))
    if kind == "centered_on":
        surface = all("surface" in mounts(s.category) for s in subjects)
        if surface or "rug" in target.category:
            say(state, "on", subjects, (target,), spoken, count, False, None, span, implied)
    one = subjects[0]
    if kind == "along" and "each" in spoken.split() and count is None and len(subjects) == 1 and one.count is not None:
        count, one.count = one.count, (2 * one.count[0], 2 * one.count[1])  # "two chairs on each long side"
    each = each and (count is not None or kind not in ("flanking", "along"))
    say(state, kind, subjects, targets, spoken, count, each, side, span, implied)


def say(
    state: State,
    kind: str,
    subjects: list[Mention],
    targets: tuple[Any, ...],
    spoken: str,
    count: Any,
    each: bool,
    side: str | None,
    span: Span | None,
    implied: bool,
) -> None:
    state.out.said.append(Said(kind, list(subjects), targets, spoken, count, each, side, implied, span))
    if not implied:
        state.last_subjects, state.head_related = list(subjects), True


def relate_to_place(
    state: State,
    kind: str,
    subjects: list[Mention],
    place: str,
    spoken: str,
    count: Any,
    span: Span | None,
    implied: bool,
) -> None:
    wall_hung = all(mounts(s.category)[0] == "wall" for s in subjects)
    if kind == "through":
        return
    if place == "room":
        if kind in ("centered_on", "at_center"):
            kind, place = "at", "middle"
        elif kind in ("opposite",):
            for target in nearest(state, subjects):
                say(state, "opposite", subjects, (target,), spoken, count, False, None, span, implied)
            return
        else:
            return
    if place == "floor":
        if kind in ("centered_on", "at_center"):
            kind, place = "at", "middle"
        elif kind == "on" and all(mounts(s.category)[0] == "surface" for s in subjects):
            pass
        else:
            return
    if place == "wall:opposite":
        others = main_things(state, subjects)
        if others:
            say(
                state,
                "opposite",
                subjects,
                (others[-1],),
                f"{spoken} the opposite wall",
                count,
                False,
                None,
                span,
                True,
            )
        place = "wall" if others else "wall:far"
    if place.startswith("wall"):
        if kind in ("inside", "at", "occupying", "along", "covering", "centered_on", "around", "flanking"):
            kind = "along" if kind == "along" else "against"
        elif kind == "on" and not wall_hung and all(mounts(s.category)[0] == "floor" for s in subjects):
            kind = "against"
    for subject in subjects if place in ("ceiling", "wall") or place.startswith("wall:") else ():
        hung = words("nouns")["hung"]["ceiling" if place == "ceiling" else "wall" if kind != "against" else "none"]
        subject.category = hung.get(subject.category, subject.category)
    if kind == "against" and not implied:
        subjects = [*subjects, *beside_those(state, subjects)]
    if place == "ceiling":
        kind = (
            "hanging_from"
            if kind
            in ("on", "from", "inside", "hanging_from", "at", "near", "against", "above", "below", "centered_on")
            else kind
        )
    if place in ("corner", "middle"):
        kind = "at" if kind not in ("facing", "far_from") else kind
    if place in ("window", "door") and kind in ("inside", "on", "occupying"):
        kind = "at"
    if kind == "far_from" and place not in ("door", "window"):
        state.out.note(f"'away from the {place}' cannot be said as a relation and was left out")
        return
    if place in ("corner", "middle") and kind == "far_from":
        return
    say(
        state,
        kind,
        subjects,
        (place,),
        f"{spoken} the {place.split(':')[0]}" if not spoken.endswith(place) else spoken,
        count,
        False,
        None,
        span,
        implied,
    )


def relate_to_nearest(state: State, place: Place, subjects: list[Mention] | None, chunk: Chunk) -> None:
    """A word of place without a target: "a rug in front", "to its left", "overhead"."""
    if subjects is None:
        frame_items = [m for f in state.frames[-1:] for m in f.items]
        if not frame_items and (state.refs.topics or state.out.mentions):
            targets = (
                main_things(state, []) if place.type == "opposite" and "room" in place.words else nearest(state, [])
            )
            if place.type == "centered_on" and state.surface is not None:
                targets = [state.surface]
            if targets and place.type in ("below", "near", "next_to", "opposite", "around"):
                targets = [carrier_root(state, targets[-1])]
            if "room" in place.words and place.type == "opposite" and not state.out.mentions:
                return
            state.fronted.append((place, tuple(targets[-1:]), chunk))
            return
        subjects = frame_items
    if not subjects:
        return
    floor = place.type in ("near", "next_to", "opposite", "left_of", "right_of", "behind", "in_front_of")
    near = main_things(state, subjects) if place.type == "opposite" else nearest(state, subjects, apart=floor)
    if "its" in place.words.split() and near and near[-1].many:
        it = NounPhrase("pronoun", "it", chunk.start, chunk.end, value="pron")
        near = state.refs.pronoun(it, [], [*subjects, *near]) or near
    if "its" in place.words.split() and place.type in SIDED:
        near = chained(state, near, subjects)
    if place.type == "inside" and not near:
        return
    if place.type in ("left_of", "right_of") and not near:
        relate_to_place(state, "against", subjects, f"wall:{place.type.split('_')[0]}", place.words, None, None, False)
        return
    small = all("surface" in mounts(s.category) for s in subjects)
    if place.type == "centered_on" and small and state.surface is not None:
        near = [state.surface]
    if not near and place.type != "centered_on":
        state.out.note(f"'{chunk.text}': it is not clear of what; it was left out")
        return
    if (
        place.type == "centered_on"
        and not near
        or place.type == "centered_on"
        and not any("surface" in mounts(s.category) for s in subjects)
    ):
        relate_to_place(
            state, "at", subjects, "middle", place.words, None, state.source.span(chunk.start, chunk.end), False
        )
        return
    seated = place.type == "in_front_of" and all(family(s.category) == "seat" for s in subjects)
    seated = seated and bool(near) and family(near[-1].category) not in ("table", "storage", "seat", "bed_group")
    if near and (seated or place.type in ("near", "above", "left_of", "right_of")):
        near = [anchor(state, near[-1], place.type, subjects)]
    target = near[-1] if len(near) == 1 or place.type not in ("above", "below") else near[0]
    owned = any(f.kind in ("with", "verb") and target in f.owner for f in state.frames)
    if place.type == "on" and not owned:
        target = state.refs.carrier(near, subjects) or target
    relate(state, place, subjects, (target,), chunk, count=state.subset)


def relate_mutually(state: State, place: Place, chunk: Chunk) -> None:
    """ "Two desks side by side", "a sofa and a bench facing each other"."""
    subjects = list(state.head)
    if state.subject_open and not state.frames and len(state.subject) > 1 or state.glue == "verb" and state.subject:
        subjects = list(state.subject)
    elif state.frames and len(state.frames[-1].items) > 1 and len(state.head) == 1 and not state.head[0].many:
        subjects = state.frames[-1].items[-2:] if place.type != "left_to_right" else list(state.frames[-1].items)
    span = state.source.span(chunk.start, chunk.end)
    if not subjects:
        return
    if place.type == "left_to_right":
        for one, two in zip(subjects, subjects[1:], strict=False):
            say(state, "right_of", [two], (one,), chunk.text, None, False, None, span, False)
        return
    say(state, place.type, subjects, ("each other",), chunk.text, None, False, None, span, False)
    state.head = subjects


def relate_to_owner(state: State, frame: Any, mentions: list[Mention], phrase: NounPhrase) -> None:
    """ "A desk with a lamp": what is small stands on what it came with, the rest is near it."""
    if not frame.owner:
        return
    owner = frame.owner[-1]
    for mention in mentions:
        if mention is owner or (owner in state.party and mention in state.party):
            continue
        small = mounts(mention.category)[0] == "surface" or (mention.generic and family(owner.category) == "table")
        carriers = [m for m in (state.party if owner in state.party else []) if m is not mention]
        if small and carriers:
            ranks = [
                (r, k, m) for k, m in enumerate(carriers) if (r := likeliness(mention.category, m.category)) is not None
            ]
            if not ranks:
                continue
            owner = min(ranks)[2]
        kind = "near"
        if small and mounts(owner.category)[0] in ("floor", "wall") or small and category_named(owner.category).holds:
            kind = support_kind(state, "on", owner)
        elif mounts(mention.category)[0] != "floor" or mounts(owner.category)[0] != "floor":
            if mounts(mention.category)[0] == "wall":
                kind = "above"
            else:
                continue
        elif family(mention.category) == "seat" and family(owner.category) == "table":
            kind = "at"
        elif mention.category == "nightstand":
            kind = "flanking" if mention.count == (2, 2) else "next_to"
        say(
            state,
            kind,
            [mention],
            (owner,),
            f"{owner.noun} with {mention.noun}",
            None,
            frame.each,
            None,
            state.source.span(phrase.start, phrase.end),
            True,
        )
