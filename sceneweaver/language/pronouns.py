"""Phrases that refer to what was named: it, them, one, the other, each, two of them."""

from __future__ import annotations

from dataclasses import replace

from .chunks import Chunk, NounPhrase
from .distribution import owner_told_of, part_of_each
from .items import begin_clause, continue_with, give_target, name_things
from .nearness import carrier_root, carrying, nearest
from .parsed import Mention, Said
from .relating import relate_to_place
from .shares import ends_here, give_total, one_for_each, share_out
from .state import State, Waiting
from .stations import station_group
from .thing_phrases import new_thing
from .vocabulary import shows, words

_BESIDE_IT = ("next_to", "left_of", "right_of", "near", "in_front_of", "behind")
"""Relations of small things to "it": to another small thing, not to what carries both."""


_OF_ONE = ("above", "below", "around", "at", "in_front_of", "behind", "opposite", "facing", "flanking", "at_foot")
"""Relations of which several in a row are of the same thing: "a lamp above it and a rug under it"."""


def is_one_of_quality(chunk: Chunk, after: Chunk | None) -> bool:
    """Whether a word of quality and the pronoun after it are "the larger one"."""
    if chunk.kind != "adjective" or chunk.value.determiner != "the" or after is None or after.kind != "noun":
        return False
    return after.value.what == "pronoun" and after.text in ("one", "ones")


def number_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A number alone: "four on each side", "a table for six", "two of them"."""
    before, after = state.chunk(state.at - 2), state.chunk(state.at)
    if before is not None and before.kind == "purpose" and before.value == "people" and phrase.count != (0, 0):
        state.out.people = (phrase.count or (1, 1))[1]
        state.out.referred.append(state.span_of(phrase))
        state.glue = ""
        return
    meant = _meant_again(state, phrase)
    if meant:
        state.out.referred.append(state.span_of(phrase))
    if meant and state.waiting is not None:
        give_target(state, state.waiting, meant, phrase, False)
        return
    if meant:
        begin_clause(state, meant, state.glue)
        state.glue = ""
        return
    near = _at_hand(state)
    group = state.refs.several(near)
    count = phrase.count or (1, 1)
    if near and state.glue in ("and", "comma", "comma and") and after is not None and after.kind == "purpose":
        by = near[-1].per.count if near[-1].per is not None else None
        if by is not None and near[-1].count is not None and phrase.bound is None:
            low, high = near[-1].count  # "each with two chairs for customers and one for the clerk"
            near[-1].count = (low + count[0] * by[0], high + count[1] * by[1])
            state.out.referred.append(state.span_of(phrase))
            return
    if chunk.text == "one" and after is not None and after.kind == "purpose":
        state.out.referred.append(state.span_of(phrase))
        state.glue = ""
        return
    if group is None and state.glue == "bracket" and near and near[-1].count is None:
        group = near[-1]  # "toy chest (2)"
    total = phrase.bound is not None or phrase.value == "grouped" or state.glue == "bracket"
    total = total or (chunk.text.endswith(" them") and not _placed(state.chunk(state.at)))
    if group is not None and total and give_total(state, phrase, group):
        state.waiting, state.glue = None, ""
        return
    if phrase.value == "grouped":
        state.waiting, state.glue = None, ""
        return
    if group is None and part_of_each(state, after):
        group = near[-1] if near else None
    if group is None:
        if after is None or after.kind != "stop":
            state.leave_unread(chunk.text, chunk.start, chunk.end)
    elif part_of_each(state, after):
        more = _more_of_the_same(state, near, count, phrase)
        if more is not None:
            continue_with(state, [more])
        else:
            _say_of_some(state, group, count)
    elif (part := state.refs.part(near, count[1])) is not None:
        continue_with(state, [part])


def pronoun_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """It, them, each, one, the other."""
    kind, waiting = phrase.value, state.waiting
    if kind in ("partial", "rest"):
        _part_phrase(state, phrase, chunk)
    elif waiting is not None:
        _pronoun_target(state, phrase, waiting)
    elif kind == "each" and ends_here(state) and share_out(state):
        state.glue = ""
    elif kind == "each":
        group = state.refs.several(_at_hand(state))
        if group is not None and state.every > 1 and group.count is not None and group.count[0] > state.every:
            group, state.every = state.refs.part([group], group.count[0] // state.every), 1
        if group is not None:
            state.head, state.each, state.glue = [group], group, ""
            state.subject, state.subject_open = [group], True
            state.close_frames()
        elif state.out.people is None and (places := station_group(state)) is not None:
            state.head = state.subject = [places]
            state.each, state.glue, state.subject_open = places, "", True
            state.close_frames()
        elif state.out.people:
            state.per_person, state.glue = True, "start"  # "two boys, each has a bed"
    elif phrase.text not in ("which", "itself", "themselves"):
        found = state.refs.pronoun(phrase, state.subject, [])
        if found:
            begin_clause(state, found, state.glue)
            state.glue = ""
            if kind == "both" and len(found) == 1 and found[0].many and _comes_with(state.chunk(state.at)):
                state.each = found[0]


def _comes_with(after: Chunk | None) -> bool:
    """Whether what each of some things has is told next: "both have", "both with"."""
    return after is not None and (after.kind == "with" or (after.kind == "verb" and shows(after.value.lemma)))


def _placed(after: Chunk | None) -> bool:
    """Whether something is said of what a number names, so that it is some of the things that were named."""
    return after is not None and after.kind in ("place", "verb", "adjective", "with", "while")


def _meant_again(state: State, phrase: NounPhrase) -> list[Mention]:
    """ "The larger one", "between the two": what was named before, by what is said of it or by its number."""
    if phrase.determiner not in ("the", "these", "those", "that", "this"):
        return []
    apart = (state.waiting.subjects or []) if state.waiting is not None else []
    if phrase.count == (1, 1) and phrase.qualities:
        found = state.refs.by_quality(phrase.qualities, apart)
        return [found] if found is not None else []
    if phrase.qualities or phrase.count is None or phrase.count[0] != phrase.count[1] or phrase.count[0] < 2:
        return []
    return state.refs.last(phrase.count[0], apart)


def _at_hand(state: State) -> list[Mention]:
    return state.head or state.subject or state.previous


def _more_of_the_same(state: State, near: list[Mention], count: tuple[int, int], phrase: NounPhrase) -> Mention | None:
    """ "A chair at each end and three on each side": more of what has its places already. Of "eight chairs around the
    table, two on each side" they are some."""
    first = near[-1] if near else None
    told = [said for said in state.out.said if first in said.subjects and not said.implied]
    if first is None or not told or first.per is not None:
        return None
    sided = any(said.each or {"each", "either", "both"} & {*said.words.split()} for said in told)
    if not sided and first.count is not None and first.count[1] >= 2 * count[0]:
        return None
    more = first.copied(count=count, plural=count[1] > 1, span=state.span_of(phrase), id="")
    state.out.mentions.append(more)
    return more


def _say_of_some(state: State, group: Mention, count: tuple[int, int]) -> None:
    """What follows is said of so many of a group, on each of some sides."""
    state.subset, state.head, state.glue = count, [group], ""
    state.subject = state.subject or [group]


def _of_several(state: State) -> Mention | None:
    """The things that are named with the one that is meant: "on the third of eight chairs"."""
    of, named = state.chunk(state.at), state.chunk(state.at + 1)
    if of is None or of.text != "of" or named is None or named.kind != "noun" or named.value.what != "thing":
        return None
    phrase: NounPhrase = named.value
    known = state.refs.known(phrase, True, []) if phrase.definite else None
    state.at += 2
    return known if known is not None else new_thing(state, phrase)


def _part_phrase(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """ "One of them", "another", "the other"."""
    waiting, partial = state.waiting, phrase.value == "partial"
    before = state.chunk(state.at - 2)
    if before is not None and is_one_of_quality(before, chunk):
        apart = (waiting.subjects or []) if waiting is not None else []
        one = state.refs.by_quality(before.value.qualities, apart)
        if one is not None:
            state.out.referred.append(state.span_of(before))
        if one is not None and waiting is not None:
            give_target(state, waiting, [one], phrase, False)
        elif one is not None:
            begin_clause(state, [one], state.glue)
            state.glue = ""
        else:
            state.leave_unread(f"{before.text} {chunk.text}", before.start, chunk.end)
        return
    near = nearest(state, waiting.subjects or []) if waiting is not None else _at_hand(state)
    if waiting is not None and (several := _of_several(state)) is not None:
        near = [several]
    if waiting is not None and (meant := state.refs.in_row(phrase.text.split()[1:2], state.refs.several(near))):
        state.out.referred.append(state.span_of(phrase))
        group, nth = meant
        state.waiting = replace(waiting, place=replace(waiting.place, nth=nth))
        give_target(state, state.waiting, [group], phrase, False)
        return
    after = state.chunk(state.at)
    if waiting is None and after is not None and after.kind == "with":
        meant = state.refs.in_row(phrase.text.split()[1:2], state.refs.several(near))
        if meant:
            state.out.referred.append(state.span_of(phrase))
            state.nth = meant
            begin_clause(state, [meant[0]], state.glue)
            state.glue = ""
            return
    if phrase.text == "one" and waiting is None:
        if one_for_each(state, near):
            return
        after = state.chunk(state.at)
        if after is not None and (after.kind == "purpose" or (after.kind == "word" and after.text == "for")):
            state.out.referred.append(state.span_of(phrase))  # "two chairs, one for the teacher, one for the pupil"
            state.glue = ""
            return
    if partial and part_of_each(state, state.chunk(state.at)):
        more = _more_of_the_same(state, near, (1, 1), phrase)
        group = state.refs.several(near)
        if more is not None:
            continue_with(state, [more])
        elif group is not None:
            _say_of_some(state, group, (1, 1))
        return
    found = state.refs.rest
    if not partial and found is not None and found.many and phrase.text.split()[1] in ("second", "third", "fourth"):
        found = state.refs.part([found])
    if partial and (found is None or not phrase.text.startswith("another")):
        found = state.refs.part(near) or _one_more(state, near)
    if found is None and waiting is not None and waiting.barred:
        found = state.refs.several(near)  # "a coat on the third hook, nothing on the others"
    if found is None:
        state.leave_unread(phrase.text, chunk.start, chunk.end)
        return
    if phrase.text in words()["superlative"]:
        state.leave_unread(phrase.text, chunk.start, chunk.end)  # one of them, and nothing shows which
    else:
        state.out.referred.append(state.span_of(phrase))
    if waiting is not None:
        give_target(state, waiting, [found], phrase, False)
    elif state.glue == "open":
        name_things(state, [found], phrase, False)
    else:
        continue_with(state, [found])


def _pronoun_target(state: State, phrase: NounPhrase, waiting: Waiting) -> None:
    """ "Beside it", "around them": what a word of place is said of."""
    subjects, it = waiting.subjects or [], phrase.text == "it"
    near = nearest(state, subjects)
    if it and subjects and state.previous and waiting.place.type in _BESIDE_IT:
        last = state.previous[-1]
        if last not in subjects and all(m.mount == "surface" for m in (*subjects, last)):
            near = [last]  # a lamp beside "it" is beside the laptop, not beside the desk
    if it and waiting.place.type in ("on", "inside"):
        near = carrying(state, near, subjects)
    if it and waiting.barred and near and near[-1].is_small:
        near = [carrier_root(state, near[-1])]  # "a bell on the counter, nothing else on it"
    if it and state.each is not None and state.each not in subjects:
        near = [state.each]
    elif it and waiting.place.type in _OF_ONE and state.meant_by_it and near and _beside_it(state, near[-1]):
        near = state.meant_by_it
    owner = owner_told_of(state, subjects, waiting.place.type == "on") if phrase.value == "each" else None
    if it and waiting.subjects is None and waiting.place.type in ("above", "below", "on", "inside"):
        state.fronted_it = state.fronted_it or state.refs.pronoun(phrase, near, subjects)  # "over it X, under it Y"
        near = state.fronted_it
    if it and near and near[-1] is state.each:
        found = near
    else:
        found = [owner] if owner is not None else state.refs.pronoun(phrase, near, subjects)
    if it:
        state.meant_by_it = list(found)
    if not found and it and len(subjects) > 1:
        found = subjects[:1]  # "a fireplace and bookshelves on either side of it"
    if found:
        beside = waiting.place.type in _BESIDE_IT and bool(subjects) and all(m.mount == "floor" for m in subjects)
        hung = waiting.place.type == "above" and bool(subjects) and all(m.mount == "wall" for m in subjects)
        if it and (beside or hung) and found[-1].mount == "surface":  # a fridge next to "it" is next to the counter
            found = [carrier_root(state, found[-1])]
        give_target(state, waiting, found, phrase, False)
        return
    state.waiting = None
    if it and _window_before(state):
        place = waiting.place
        relate_to_place(state, Said(place.type, subjects, ("window",), place.words, span=state.chunk_span()))
        state.glue = ""


def _beside_it(state: State, thing: Mention) -> bool:
    """Whether a thing was just placed by what "it" means: "a lamp above it and a rug under it"."""
    return any(thing in said.subjects and said.targets[0] in state.meant_by_it for said in state.out.said[-6:])


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
            plain = {"size": [None] * 3, "scale": 1.0, "words": [], "plural": False, "implied": False}
            more = mention.copied(span=state.chunk_span(), **plain)
            state.out.mentions.append(more)
            return more
    return None
