"""What a noun phrase is in its clause: the target of a word of place, an item of an open list, or a subject."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from .chunks import NounPhrase
from .distribution import at_each_place, distributed, is_each, over_each, share_in, speaks_of_both
from .model import ANYTHING
from .parsed import Mention, Said
from .relating import relate, relate_to_owner, say, seen_before, support_kind
from .state import Frame, Fronted, State, Waiting
from .things import MANY
from .vocabulary import Place

_FULL = ("full of", "filled with")

_BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "behind", "opposite", "between")
"""Relations that a thing has to one of its own size."""


def name_things(state: State, mentions: list[Mention], phrase: NounPhrase, new: bool) -> None:
    """Things that were named take their place: target, item of a list, or subject."""
    if state.waiting is not None:
        give_target(state, state.waiting, mentions, phrase, new)
        return
    glue, state.glue = state.glue, ""
    has_verb = state.verb_follows(state.at)
    bound = glue in ("and", "or", "comma and")
    more = not new or (state.done and not state.frames and glue == "and")
    apart = new and state.placed_next(state.at)  # "faces the fire and there is a lamp behind it"
    if bound and more and state.last_target is not None and not has_verb and not apart:
        last, _ = state.last_target  # "next to the bed and the door"
        bind_target(state, replace(last, first=None), tuple(mentions))
        return
    inverted = state.inverted and state.frames and state.frames[0].kind == "fronted" and not has_verb
    if (glue == "open" and state.frames) or inverted:
        if glue.startswith("comma"):
            state.frames = state.frames[:1]
        _add_item(state, mentions, phrase)
        return
    clause = glue in ("start", "while", "comma", "comma and", "and") and has_verb
    clause = clause and (state.done or (bool(state.frames) and not state.subject_open))
    if glue in ("start", "while") or clause or not (state.subject or state.frames or state.fronted):
        begin_clause(state, mentions, glue)
    elif state.fronted and not (state.frames and glue == "" and state.frames[-1].kind != "list"):
        keep = bool(state.first_items) and state.subject_open and glue == "and"
        begin_clause(state, mentions, glue, keep=keep)
    else:
        _coordinate(state, mentions, phrase, glue)


def begin_clause(state: State, mentions: list[Mention], glue: str, keep: bool = False) -> None:
    """Things become the subject of a new clause; ``keep`` adds them to the one that there is."""
    mentions = _over_fronted(state, state.fronted, mentions)
    if state.subject and not keep:
        state.previous = list(state.subject)
        if glue != "start":
            state.refs.tell_of(state.subject)
    if glue != "start" or not state.frames:
        state.close_frames()
    state.subject = [*state.subject, *mentions] if keep else list(mentions)
    state.head = list(mentions)
    state.name_first(mentions)
    state.subject_open, state.lost, state.inverted, state.done, state.last_target = True, False, False, False, None
    state.head_related, state.joined = False, ""
    if state.frames and state.frames[0].kind == "list":
        state.frames[0].items += mentions
    fronted, state.fronted = state.fronted, []
    if fronted:
        _relate_fronted(state, fronted, mentions)
        state.frames.append(Frame("fronted", fronted=fronted, items=list(mentions)))


def _over_fronted(state: State, fronted: list[Fronted], mentions: list[Mention]) -> list[Mention]:
    """Things after "at every desk" counted out over the desks."""
    for place, targets, _ in fronted:
        if place.over_each and isinstance(targets[0], Mention):
            mentions = distributed(state, mentions, targets[0])
        elif place.over_each:
            at_each_place(mentions, targets[0])
    return mentions


def _relate_fronted(state: State, fronted: list[Fronted], mentions: list[Mention]) -> None:
    """ "On the desk sits a laptop": what was said ahead of who it is about."""
    for place, targets, at in fronted:
        relate(state, place, mentions, targets, state.span_of(at))
        if place.type in ("on", "inside") and isinstance(targets[0], Mention):
            open_surface(state, targets[0], place.words)


def _coordinate(state: State, mentions: list[Mention], phrase: NounPhrase, glue: str) -> None:
    """One more of a list: with "and" of the innermost, after a comma of the outermost one."""
    bound = glue in ("and", "or") or (glue == "comma and" and not state.head_related)
    state.joined = "and" if bound else "comma"
    state.last_target = None
    placed = state.placed_next(state.at)
    if glue in ("comma", "comma and", "bracket") and state.frames:
        base = state.frames[0]
        ends = base.is_fronting or (base.kind in ("with", "verb") and not base.finite and state.subject_open)
        if len(state.frames) > 1 and not _inner_list_goes_on(state, mentions, phrase):
            state.frames = state.frames[:1]
        elif (ends and (placed or _is_apart(state, base, mentions))) or (base.each and base.closed and glue == "comma"):
            state.frames = []  # "each has a phone and two chairs, a sofa"
    elif glue in ("and", "or") and state.frames and placed and state.frames[-1].is_fronting:
        state.frames.pop()
    if state.frames:
        _add_item(state, mentions, phrase)
        return
    if state.subject_open:
        state.previous = list(state.subject[-1:])
        another = glue.startswith("comma") and state.head_related
        state.subject = list(mentions) if another else [*state.subject, *mentions]
    else:
        state.previous = list(state.subject)
        state.subject, state.subject_open = list(mentions), True
    state.head = list(mentions)
    state.name_first(mentions)
    state.head_related = False


def _is_apart(state: State, base: Frame, mentions: list[Mention]) -> bool:
    """ "A stove with a kettle on, a table": whether furniture is none of a list of small things with their places."""
    stands = all(m.mount == "floor" and not m.is_small and m.family != "seat" and not m.is_rug for m in mentions)
    return stands and bool(base.items) and state.head_related and all(m.is_small for m in base.items)


def _inner_list_goes_on(state: State, mentions: list[Mention], phrase: NounPhrase) -> bool:
    """Whether a comma does not end an inner list: small things after small things that something holds."""
    inner, outer = state.frames[-1], state.frames[0].kind
    if inner.kind == "with" and inner.each and not inner.closed and _list_ends_with_and(state):
        return True  # "each with a chair, a trolley and a lamp"
    if state.placed_next(state.at) or not all(m.mount == "surface" for m in mentions):
        return False
    held = inner.kind == "verb" and inner.type in ("on", "inside")
    if inner.words in _FULL and inner.items and (phrase.determiner or phrase.count) and not inner.numbered:
        return False  # "a sink full of dishes, a bin"
    if held and outer == "list":
        return bool(inner.items)
    if not inner.items:
        return False
    first = inner.items[0]
    carrier = inner.kind == "with" and bool(inner.owner) and inner.owner[-1].family in ("table", "storage")
    if carrier and outer in ("list", "fronted"):
        return first.mount == "surface"
    if not phrase.count or first.noun not in inner.numbered:
        return False
    return (held and outer == "with") or (inner.kind == "with" and first.count is not None)


def _list_ends_with_and(state: State) -> bool:
    """Whether the list that goes on here has its last item after "and", and nothing says where that is."""
    for k, chunk in enumerate(state.chunks[state.at : state.at + 14], start=state.at):
        if chunk.kind == "and":
            return state.noun_next(k + 1 - state.at) and not state.placed_next(k + 2)
        if chunk.kind not in ("comma", "noun", "adjective"):
            return False
    return False


def _add_item(state: State, mentions: list[Mention], phrase: NounPhrase) -> None:
    """What is named in an open list."""
    frame = state.frames[-1]
    if frame.each or phrase.determiner == "each":
        mentions = distributed(state, mentions, _counted_owner(frame.owner))
    elif frame.kind == "fronted":
        mentions = _over_fronted(state, frame.fronted, mentions)
    elif frame.kind in ("with", "verb") and len(frame.owner) == 1:
        mentions = share_in(state, mentions, frame.owner[0])
    if frame.items:
        state.previous = list(frame.items[-1:])
    frame.items += mentions
    frame.closed = frame.closed or (state.joined == "and" and len(frame.items) > len(mentions))
    if phrase.count is not None:
        frame.numbered += [m.noun for m in mentions]
    state.head, state.glue, state.head_related = list(mentions), "", False
    if frame.kind == "list":
        state.name_first(mentions)
        state.subject = list(mentions)
        if frame.type == "centered":
            frame.type = ""
            state.out.said.append(Said("at", list(mentions), ("middle",), frame.words))
    elif frame.kind == "fronted":
        _relate_fronted(state, frame.fronted, mentions)
        state.subject = [*state.subject, *mentions]
    elif frame.kind == "with":
        relate_to_owner(state, frame, mentions, phrase)
    else:
        _place_item(state, frame, mentions)


def _counted_owner(owners: list[Mention]) -> Mention | None:
    return next((o for o in owners if o.count is not None), next(iter(owners), None))


def _place_item(state: State, frame: Frame, mentions: list[Mention]) -> None:
    """What a verb places relative to the owner of its list: "a sideboard holds a vase"."""
    kind = frame.type
    if not frame.owner:
        return
    holds = kind in ("on", "inside")
    targets = tuple(frame.owner if kind == "between" else frame.owner[:1] if holds else frame.owner[-1:])
    if kind == "beside":
        seat = all(m.family == "seat" for m in mentions) and frame.owner[0].family == "table"
        night = len(mentions) == 1 and mentions[0].category == "nightstand" and mentions[0].count == (2, 2)
        kind = "at" if seat else "flanking" if night else "next_to"
    elif holds:
        kind = support_kind(kind, frame.owner[0])
    place = Place(kind, words=frame.words, each=frame.each or kind == "flanking", nth=frame.nth)
    relate(state, place, mentions, targets, state.chunk_span())


def give_target(state: State, waiting: Waiting, mentions: list[Mention], phrase: NounPhrase, new: bool) -> None:
    """A word of place gets its target."""
    between = waiting.place.type == "between"
    if between and waiting.first is None and len(mentions) == 1 and not mentions[0].many:
        waiting.first = mentions[0]
        state.glue = "open"
        return
    state.waiting = None
    if state.each is not None and new and waiting.subjects:
        mentions = distributed(state, mentions, state.each)
    if phrase.what == "pronoun" and len(mentions) == 1:
        mentions = [seen_before(state, waiting.place, mentions[0])]
    targets: tuple[Any, ...] = tuple(mentions)
    if between:
        targets = (waiting.first, mentions[0]) if waiting.first is not None else (mentions[0], mentions[-1])
    elif waiting.place.type != "around" and phrase.what != "pronoun":
        targets = targets[:1]
        if targets and (waiting.barred or is_each(phrase)) and phrase.what == "thing":
            targets = _with_its_parts(state, targets[0])
    if is_each(phrase) and len(targets) > 1 and waiting.subjects:
        _on_each_of(state, waiting, targets)
        return
    _on_both(waiting, mentions, phrase)
    each = is_each(phrase) or speaks_of_both(phrase, waiting.place.type, waiting.subjects)
    bind_target(state, waiting, targets, each)
    if waiting.subjects is not None and new and not waiting.lost:
        state.head = list(mentions)
    elif waiting.subjects is None:
        state.head = []
    state.glue = ""
    if waiting.lost and not waiting.subjects:  # "light falls on a bench": the sentence is about the bench
        state.head, state.lost = list(mentions), False
        state.subject = state.subject or list(mentions)
        if state.lit and new:
            span = state.chunk_span()
            say(state, Said("near", mentions, ("window",), "through the window", span=span, implied=True))
        state.lit = False
    state.last_target = None if between else (waiting, targets)


def _with_its_parts(state: State, thing: Mention) -> tuple[Mention, ...]:
    """A thing with what was parted from it before: "two of them stacked ... no shelf near the beds"."""
    if thing.span is None:
        return (thing,)
    return tuple(m for m in state.out.mentions if m is thing or (m.span == thing.span and m.noun == thing.noun))


def _on_each_of(state: State, waiting: Waiting, targets: tuple[Any, ...]) -> None:
    """ "A sofa and two armchairs, a cushion on each": so many for each thing of each kind."""
    subjects = list(waiting.subjects or [])
    copies = [[m.copied(id="") for m in subjects] for _ in targets[1:]]
    state.out.mentions += [m for own in copies for m in own]
    for target, own in zip(targets, [subjects, *copies], strict=True):
        place = over_each(waiting.place) if target.many else waiting.place
        own = distributed(state, own, target) if target.many else own
        relate(state, place, own, (target,), state.span_of(waiting.chunk))
    state.head, state.glue, state.last_target = subjects, "", None


def _on_both(waiting: Waiting, mentions: list[Mention], phrase: NounPhrase) -> None:
    """ "A lamp on both nightstands" is a lamp on each."""
    if not phrase.both or len(mentions) != 1 or mentions[0].count is None:
        return
    for subject in waiting.subjects or ():
        if subject.count in (None, (1, 1)) and not subject.plural:
            subject.count = mentions[0].count
            waiting.place = replace(waiting.place, each=True)


def bind_target(state: State, waiting: Waiting, targets: tuple[Any, ...], each: bool = False) -> None:
    """Relates who a word of place is about to its targets, or keeps these for who comes after them."""
    subjects, place = waiting.subjects, waiting.place
    if waiting.lost and not subjects:
        return
    if subjects and place.type in _BESIDE:
        subjects = _carried_beside(state, subjects, targets)
    if waiting.barred and subjects:
        state.barred = True
        for target in [targets] if place.type == "between" else [(target,) for target in targets]:
            relate(state, place, subjects, target, state.span_of(waiting.chunk))
        if any(m.words == [ANYTHING] for m in subjects):
            state.nowhere = (place, targets, waiting.chunk)
        state.barred, state.unwanted = False, []
        return
    target = targets[0]
    each = each and len(targets) == 1 and isinstance(target, Mention)
    place = over_each(place) if each and state.every == 1 else place
    if subjects is None:
        state.fronted.append((place, targets, waiting.chunk))
        if isinstance(target, Mention) and place.type in ("above", "below", "on", "inside"):
            state.fronted_it = [target]  # "on the desk a lamp, under it a bin"
        return
    if isinstance(target, Mention) and len(targets) == 1:
        subjects = _each_with_its_own(state, subjects, target, waiting, each)
    groups = [targets] if len(targets) < 2 or place.type == "between" else [(target,) for target in targets]
    for group in groups:
        relate(state, place, subjects, group, state.span_of(waiting.chunk), count=waiting.count)


def _carried_beside(state: State, subjects: list[Mention], targets: tuple[Any, ...]) -> list[Mention]:
    """ "A press on the bench next to the vise": what is beside a small thing is what the bench carries; "a desk with a
    lamp next to the bed": what is beside furniture is what carries the lamp."""
    frame = state.frames[-1] if state.frames else None
    stands = all(isinstance(t, Mention) and t.mount == "floor" and not t.is_small and not t.is_rug for t in targets)
    if stands and frame is not None and frame.kind == "with" and len(frame.owner) == 1 and not frame.each:
        owner, listed = frame.owner[0], all(s in frame.items and s.mount == "surface" for s in subjects)
        if listed and owner.mount in ("floor", "wall") and owner not in targets and not owner.is_small:
            return [owner]
    last = state.out.said[-1] if state.out.said else None
    small = all(isinstance(t, Mention) and t.mount == "surface" for t in targets)
    if last is None or last.type not in ("on", "inside") or not small or [*last.targets] != subjects:
        return subjects
    return list(last.subjects) if all(s.mount == "floor" for s in subjects) else subjects


def _each_with_its_own(
    state: State, subjects: list[Mention], target: Mention, waiting: Waiting, each: bool
) -> list[Mention]:
    """The subjects counted out over a target of which each is meant, or which is each one's own."""
    if not each:
        return share_in(state, subjects, target)
    if waiting.count is None:
        fresh = [s for s in subjects if s in state.out.mentions[state.begun :]]
        swapped = dict(zip(fresh, distributed(state, fresh, target), strict=True))
        return [swapped.get(s, s) for s in subjects]
    for subject in subjects:  # "chairs, two at each table"
        if subject.count in (None, MANY) and target.count is not None:
            subject.count = (waiting.count[0] * target.count[0], waiting.count[1] * target.count[1])
            subject.per = target
    return subjects


def continue_with(state: State, mentions: list[Mention]) -> None:
    """What follows is about some of what was just named."""
    state.head = list(mentions)
    if state.verb_follows(state.at) or state.glue in ("start", "while"):
        state.subject, state.subject_open = list(mentions), True
        state.close_frames()
    state.glue = ""


def name_nothing(state: State) -> None:
    """What was named is no object, so that what is said of it is said of nothing."""
    if state.frames and state.glue == "open":
        state.head = []
    elif state.glue in ("start", "while", "comma", "comma and", "and"):
        state.head = []
        if state.glue in ("start", "while") or state.verb_follows(state.at):
            state.subject, state.fronted = [], []
        elif state.placed_next(state.at):  # what it is said of is not what was named before
            state.subject = []
    state.lost = True
    state.glue = ""


def open_surface(state: State, surface: Mention, words: str) -> None:
    """The small things that come after it in the sentence stand there."""
    if state.surface is not surface:
        close_surface(state, last=True)
    state.surface, state.surface_words = surface, words


def close_surface(state: State, last: bool = False) -> None:
    """ "On the desk, a lamp is beside a book, and a mug ...": small things of the sentence stand there as well."""
    surface, state.surface = state.surface, None
    started, state.started = state.started, len(state.out.mentions)
    if surface is None:
        return
    placing = [s for s in state.out.said if s.type in ("on", "inside") or isinstance(s.targets[0], str)]
    held = {m for said in placing for m in said.subjects}
    for mention in state.out.mentions[started : -1 if last else None]:
        if mention not in held and mention is not surface and mention.is_small:
            said = Said("on", [mention], (surface,), state.surface_words, implied=True, span=mention.span)
            state.out.said.append(said)
