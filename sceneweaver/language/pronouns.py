"""Phrases that refer to what was named: it, them, one, the other, each, two of them."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .items import begin_clause, continue_with, give_target, name_things
from .nearness import nearest
from .parsed import Mention
from .relating import relate_to_place
from .state import State
from .vocabulary import mounts


def number_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A number alone: "four on each side", "a table for six", "two of them"."""
    before = state.chunks[state.at - 2] if state.at >= 2 else None
    if before is not None and before.kind == "purpose" and before.value == "people":
        state.out.people = (phrase.count or (1, 1))[1]
        state.glue = ""
        return
    after = state.chunks[state.at] if state.at < len(state.chunks) else None
    near = state.head or state.subject or state.previous
    group = state.refs.several(near)
    count = phrase.count or (1, 1)
    if group is None:
        if after is None or after.kind != "stop":
            state.leave_unread(chunk.text, chunk.start, chunk.end)
        return
    if after is not None and after.kind == "place" and after.value.each:
        state.subset, state.head, state.glue = count, [group], ""
        state.subject = state.subject or [group]
        return
    part = state.refs.part(near, count[1])
    if part is not None:
        continue_with(state, [part])


def pronoun_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    kind = phrase.value
    without = (state.waiting.subjects or []) if state.waiting is not None else []
    near = nearest(state, without) if state.waiting is not None else (state.head or state.subject or state.previous)
    if kind in ("partial", "rest"):
        after = state.chunks[state.at] if state.at < len(state.chunks) else None
        if kind == "partial" and after is not None and after.kind == "place" and after.value.each:
            group = state.refs.several(near)
            if group is not None:
                state.subset, state.head, state.glue = (1, 1), [group], ""
                state.subject = state.subject or [group]
            return
        if phrase.text.startswith("another") and state.refs.rest is not None:
            found: Mention | None = state.refs.rest
        else:
            found = state.refs.part(near) if kind == "partial" else state.refs.rest
        if found is None and kind == "partial":
            found = _one_more(state, near)
        if found is None:
            state.leave_unread(phrase.text, chunk.start, chunk.end)
            return
        if state.waiting is not None:
            give_target(state, [found], phrase, False)
        elif state.glue == "open":
            name_things(state, [found], phrase, chunk, False)
        else:
            continue_with(state, [found])
        return
    if kind == "each" and state.waiting is None:
        group = state.refs.several(near)
        if group is not None:
            state.head, state.each, state.glue = [group], True, ""
            state.subject = [group]
            state.subject_open, state.frames = True, [f for f in state.frames[:1] if f.kind == "list"]
        return
    if (
        state.waiting is not None
        and phrase.text == "it"
        and state.previous
        and state.waiting.place.type in ("next_to", "left_of", "right_of", "near", "in_front_of", "behind")
    ):
        small = [*without, state.previous[-1]]
        if without and all(mounts(m.category)[0] == "surface" for m in small) and state.previous[-1] not in without:
            near = state.previous[-1:]  # a lamp beside "it" is beside the laptop, not beside the desk
    found_all = state.refs.pronoun(phrase, near if state.waiting is not None else state.subject, without)
    if state.waiting is not None:
        if not found_all and phrase.text == "it" and len(without) > 1:
            found_all = without[:1]  # "a fireplace and bookshelves on either side of it"
        if found_all:
            give_target(state, found_all, phrase, False)
        elif phrase.text == "it" and _window_before(state):
            waiting, state.waiting = state.waiting, None
            relate_to_place(
                state, waiting.place.type, without, "window", waiting.place.words, None, state.chunk_span(), False
            )
            state.glue = ""
        else:
            state.waiting = None
        return
    if phrase.text in ("which", "itself", "themselves"):
        return
    if found_all:
        topic = found_all
        begin_clause(state, topic, state.glue)
        state.glue = ""


def _window_before(state: State) -> bool:
    """Whether the sentence named a window: "light falls through a window onto a desk beneath it"."""
    for chunk in reversed(state.chunks[: state.at - 1]):
        if chunk.kind == "stop":
            return False
        if chunk.kind == "noun" and chunk.value.what == "place" and chunk.value.value == "window":
            return True
    return False


def _one_more(state: State, near: list[Mention]) -> Mention | None:
    """ "Another stands to the right": one more of what was named last."""
    for mention in [*reversed(near), *reversed(state.out.mentions[-3:])]:
        if mention.count == (1, 1):
            more = Mention(
                mention.noun,
                mention.category,
                (1, 1),
                mention.generic,
                mention.color,
                mention.material,
                mention.style,
            )
            more.attributes, more.span = list(mention.attributes), state.chunk_span()
            state.out.mentions.append(more)
            return more
    return None
