"""What a noun phrase is in its clause: the target of a word of place, an item of an open list, or a subject."""

from __future__ import annotations

from typing import Any

from .chunks import Chunk, NounPhrase
from .parsed import Mention, Said
from .relating import relate, relate_to_owner, say, support_kind
from .state import Frame, State, Waiting
from .vocabulary import Place, family, mounts


def name_things(state: State, mentions: list[Mention], phrase: NounPhrase, chunk: Chunk, new: bool) -> None:
    """Things that were named take their place: target, item of a list, or subject."""
    if state.waiting is not None:
        give_target(state, mentions, phrase, new)
        return
    glue, state.glue = state.glue, ""
    more = glue in ("and", "or", "comma and") and (not new or (state.done and not state.frames and glue == "and"))
    if more and state.last_target is not None and not state.verb_follows(state.at):
        _one_more_target(state, mentions)
        return
    if glue == "open" and state.frames:
        _add_item(state, mentions, phrase)
        return
    if state.inverted and state.frames and state.frames[0].kind == "fronted" and not state.verb_follows(state.at):
        if glue.startswith("comma"):
            state.frames = state.frames[:1]
        _add_item(state, mentions, phrase)
        return
    clause = glue in ("start", "while", "comma", "comma and", "and") and (
        (state.done and state.verb_follows(state.at))
        or (bool(state.frames) and state.verb_follows(state.at) and not state.subject_open)
    )
    if glue in ("start", "while") or clause or not (state.subject or state.frames or state.fronted):
        begin_clause(state, mentions, glue)
        return
    if state.fronted and not (state.frames and glue == ""):
        begin_clause(state, mentions, glue, keep=bool(state.first_items) and state.subject_open and glue in ("and",))
        return
    _coordinate(state, mentions, phrase, glue)


def begin_clause(state: State, mentions: list[Mention], glue: str, keep: bool = False) -> None:
    """A new clause, or an item of its own."""
    if state.subject and not keep:
        state.previous = list(state.subject)
        if glue != "start":
            state.refs.topics.append(list(state.subject))
    if glue != "start" or not state.frames:
        state.frames = [f for f in state.frames[:1] if f.kind == "list"]
    state.subject = [*state.subject, *mentions] if keep else list(mentions)
    state.head, state.first_items = list(mentions), [*state.first_items, *mentions]
    state.subject_open, state.lost, state.inverted, state.done, state.last_target = True, False, False, False, None
    state.head_related, state.joined = False, ""
    if state.frames and state.frames[0].kind == "list":
        state.frames[0].items += mentions
    fronted, state.fronted = state.fronted, []
    for place, targets, at in fronted:
        relate(state, place, mentions, targets, at)
        if place.type in ("on", "inside") and isinstance(targets[0], Mention):
            open_surface(state, targets[0], place.words)
    if fronted:
        state.frames.append(Frame("fronted", fronted=fronted, items=list(mentions)))


def _coordinate(state: State, mentions: list[Mention], phrase: NounPhrase, glue: str) -> None:
    """One more of a list: with "and" of the innermost, after a comma of the outermost one."""
    state.joined = (
        "and" if glue in ("and", "or", "comma and") and not (glue == "comma and" and state.head_related) else "comma"
    )
    state.last_target = None
    if glue in ("comma", "comma and", "bracket") and state.frames:
        base = state.frames[0]
        if len(state.frames) > 1 and not _goes_on(state, mentions, phrase):
            state.frames = state.frames[:1]
        elif (
            base.kind in ("with", "verb")
            and not base.finite
            and state.subject_open
            and state.placed_next(state.at)
            or base.kind == "fronted"
            and not base.finite
            and state.placed_next(state.at)
        ):
            state.frames = []
    elif (
        glue in ("and", "or")
        and state.frames
        and state.frames[-1].kind == "fronted"
        and not state.frames[-1].finite
        and state.placed_next(state.at)
    ):
        state.frames.pop()
    if state.frames:
        _add_item(state, mentions, phrase)
        return
    if state.subject_open:
        state.previous = list(state.subject[-1:])
        if not (glue == "and" and not state.done) and glue.startswith("comma") and state.head_related:
            state.subject = list(mentions)
        else:
            state.subject = [*state.subject, *mentions]
    else:
        state.previous = list(state.subject)
        state.subject, state.subject_open = list(mentions), True
    state.head, state.first_items = list(mentions), [*state.first_items, *mentions]
    state.head_related = False


def _goes_on(state: State, mentions: list[Mention], phrase: NounPhrase) -> bool:
    """Whether a comma does not end an inner list: small things after small things that something holds."""
    inner = state.frames[-1]
    small = all(mounts(m.category)[0] == "surface" for m in mentions) and not state.placed_next(state.at)
    held = inner.kind == "verb" and inner.type in ("on", "inside")
    if held and state.frames[0].kind == "list":
        return small and bool(inner.items)
    first = inner.items[:1]
    carrier = inner.kind == "with" and bool(inner.owner) and family(inner.owner[-1].category) in ("table", "storage")
    if carrier and state.frames[0].kind in ("list", "fronted"):
        return small and bool(first) and mounts(first[0].category)[0] == "surface"
    if held and state.frames[0].kind == "with" and phrase.count and small:
        return bool(first and first[0].noun in inner.numbered)
    return bool(
        inner.kind == "with" and small and phrase.count and first and first[0].count and first[0].noun in inner.numbered
    )


def _add_item(state: State, mentions: list[Mention], phrase: NounPhrase) -> None:
    """What is named in an open list."""
    frame = state.frames[-1]
    if frame.items:
        state.previous = list(frame.items[-1:])
    frame.items += mentions
    if phrase.count is not None:
        frame.numbered += [m.noun for m in mentions]
    state.head, state.glue, state.head_related = list(mentions), "", False
    if frame.kind == "list":
        state.first_items = [*state.first_items, *mentions]
        state.subject = list(mentions)
        if frame.type == "centered":
            frame.type = ""
            state.out.said.append(Said("at", list(mentions), ("middle",), frame.words, implied=False))
    elif frame.kind == "fronted":
        for place, targets, at in frame.fronted:
            relate(state, place, mentions, targets, at)
            if place.type in ("on", "inside") and isinstance(targets[0], Mention):
                open_surface(state, targets[0], place.words)
        state.subject = [*state.subject, *mentions]
    elif frame.kind == "with":
        relate_to_owner(state, frame, mentions, phrase)
    else:
        _place_item(state, frame, mentions)
    if frame.each or phrase.determiner == "each":
        _multiply(state, frame.owner, mentions)


def _multiply(state: State, owners: list[Mention], mentions: list[Mention]) -> None:
    many = next((o.count for o in owners if o.count is not None), None)
    for mention in mentions:
        if many is not None and mention.count is not None:
            mention.count = (mention.count[0] * many[0], mention.count[1] * many[1])


def _place_item(state: State, frame: Frame, mentions: list[Mention]) -> None:
    kind = frame.type
    targets = tuple(frame.owner[-1:] if kind != "between" else frame.owner)
    if frame.owner and len(frame.owner) > 1 and kind in ("on", "inside"):
        targets = tuple(frame.owner[:1])
    if not targets:
        return
    if kind == "beside":
        seat = all(family(m.category) == "seat" for m in mentions) and family(frame.owner[0].category) == "table"
        night = len(mentions) == 1 and mentions[0].category == "nightstand" and mentions[0].count == (2, 2)
        kind = "at" if seat else "flanking" if night else "next_to"
    elif kind in ("on", "inside"):
        kind = support_kind(state, kind, frame.owner[0])
    place = Place(kind, words=frame.words, each=frame.each or kind == "flanking")
    relate(state, place, mentions, targets, None, span=state.chunk_span())


def give_target(state: State, mentions: list[Mention], phrase: NounPhrase, new: bool) -> None:
    """A word of place gets its target."""
    waiting = state.waiting
    assert waiting is not None
    if waiting.place.type == "between" and waiting.first is None and len(mentions) == 1 and not (mentions[0].many):
        waiting.first = mentions[0]
        state.glue = "open"
        return
    state.waiting = None
    if state.each and new and waiting.subjects:
        _multiply(state, waiting.subjects, mentions)
    targets: tuple[Any, ...] = tuple(mentions)
    if waiting.place.type == "between":
        targets = (waiting.first, mentions[0]) if waiting.first is not None else (mentions[0], mentions[-1])
    elif waiting.place.type not in ("around",):
        targets = targets[:1] if phrase.what != "pronoun" or len(mentions) == 1 else targets
    each = phrase.determiner in ("each", "every")
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
            say(state, "near", mentions, ("window",), "through the window", None, False, None, state.chunk_span(), True)
        state.lit = False
    state.last_target = (waiting, targets) if waiting.place.type not in ("between",) else None


def bind_target(state: State, waiting: Waiting, targets: tuple[Any, ...], each: bool = False) -> None:
    if waiting.lost and not waiting.subjects:
        return
    if waiting.subjects is None:
        state.fronted.append((waiting.place, targets, waiting.chunk))
        return
    place = waiting.place
    if each:
        place = Place(place.type, place.side, True, place.words)
        target = targets[0]
        if isinstance(target, Mention):
            for subject in waiting.subjects:
                n = target.count
                if subject.count is not None and n is not None and waiting.count is None and subject.count != n:
                    subject.count = (subject.count[0] * n[0], subject.count[1] * n[1])
    if len(targets) > 1 and place.type != "between":
        for target in targets:
            relate(state, place, waiting.subjects, (target,), waiting.chunk, count=waiting.count)
    else:
        relate(state, place, waiting.subjects, targets, waiting.chunk, count=waiting.count)


def _one_more_target(state: State, mentions: list[Mention]) -> None:
    assert state.last_target is not None
    waiting, _ = state.last_target
    bind_target(
        state,
        Waiting(waiting.place, waiting.subjects, waiting.chunk, waiting.count, lost=waiting.lost),
        tuple(mentions),
    )


def continue_with(state: State, mentions: list[Mention]) -> None:
    """What follows is about some of what was just named."""
    state.head = list(mentions)
    if state.verb_follows(state.at) or state.glue in ("start", "while"):
        state.subject, state.subject_open, state.frames = (
            list(mentions),
            True,
            [f for f in state.frames[:1] if f.kind == "list"],
        )
    state.glue = ""


def name_nothing(state: State) -> None:
    """What was named is no object, so that what is said of it is said of nothing."""
    if state.frames and state.glue == "open":
        state.head = []
    elif state.glue in ("start", "while", "comma", "comma and", "and"):
        state.head = []
        if state.glue in ("start", "while") or state.verb_follows(state.at):
            state.subject, state.fronted = [], []
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
    held = {
        id(m) for s in state.out.said for m in s.subjects if s.type in ("on", "inside") or isinstance(s.targets[0], str)
    }
    for mention in state.out.mentions[started : -1 if last else None]:
        if id(mention) not in held and mention is not surface and "surface" in mounts(mention.category):
            state.out.said.append(
                Said("on", [mention], (surface,), state.surface_words, implied=True, span=mention.span)
            )
