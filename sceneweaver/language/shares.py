"""How many there are of things of which a request says how many each has, or how many there are in all."""

from __future__ import annotations

from sceneweaver.assets.taxonomy import likeliness

from .chunks import NounPhrase
from .distribution import distributed, is_each
from .parsed import Mention, Said
from .relating import owned_kind, say
from .state import State
from .things import MANY, new_mention

_OF_US = ("us", "them", "you")
_EVERYBODY = ("everybody", "everyone")
_ENDS = ("stop", "comma", "bracket", "and")


def ends_here(state: State) -> bool:
    """Whether a list or the sentence ends with the chunk in hand."""
    after = state.chunk(state.at)
    return after is None or after.kind in _ENDS or (after.kind == "noun" and after.text == "one")


def multiply(mentions: list[Mention], by: tuple[int, int]) -> None:
    """So many of each for every one of so many."""
    for mention in mentions:
        low, high = mention.count or ((1, 1) if not mention.plural else MANY)
        if mention.count == MANY and mention.plural:
            low, high = 1, 1
        mention.count = (low * by[0], high * by[1])


def last_items(state: State) -> list[Mention]:
    """What the words just before are about: the last thing, and the small ones that are listed with it."""
    found: list[Mention] = []
    if (bound := _bound_list(state)) is not None:
        return bound
    for mention in reversed(state.out.mentions[state.begun :]):
        large = mention.family in ("table", "storage", "bed_group", "seat")
        if found and (large or not found[0].is_small or mention.count not in (None, (1, 1))):
            break
        found.append(mention)
    return found


def _bound_list(state: State) -> list[Mention] | None:
    """All that a sentence names, where that is one list of single things that "and" binds: "a cabinet, a drip stand and
    a chair per bed"; but of "a sofa and one chair per bed" the chair alone."""
    frame = state.frames[-1] if state.frames else None
    if frame is not None and frame.kind == "with" and frame.closed and len(frame.items) > 1:
        tied = {m for said in state.out.said for m in said.subjects if not said.implied}
        return [m for m in reversed(frame.items) if m.per is None and (m not in tied or m is frame.items[-1])]
    fresh = [m for m in state.out.mentions[state.begun :] if not m.implied]
    related = {m for said in state.out.said for m in said.subjects if not said.implied}
    single = all(m.count in (None, (1, 1)) and not m.plural and m.per is None and m not in related for m in fresh)
    named = [c for c in state.chunks[: state.at] if c.kind in ("noun", "and", "stop")]
    while any(c.kind == "stop" for c in named):
        named.pop(0)
    bound = any(c.kind == "and" for c in named)
    items = [c for c in named if c.kind == "noun" and c.value.what == "thing"]
    numbered = any(c.value.count is not None and c.value.determiner not in ("a", "an") for c in items)
    return fresh[::-1] if single and bound and len(fresh) > 1 and not numbered else None


def owners_of(state: State, items: list[Mention]) -> Mention | None:
    """The things of which each has the items: the last of which there are several."""
    owner = state.frames[-1].owner[-1:] if state.frames else []
    if owner and owner[0] in state.out.stations:
        return owner[0]  # "two stations with a couch and a lamp each"
    stand = any(m.mount == "floor" for m in items)
    for mention in reversed(state.out.mentions[-12:]):
        if stand and mention.mount == "surface":
            continue  # mugs have no beds
        if mention not in items and mention.count is not None and mention.count[0] == mention.count[1] > 1:
            return mention
    return None


def share_out(
    state: State, owner: Mention | None = None, of_people: bool = False, items: list[Mention] | None = None
) -> bool:
    """ "Three chairs each", "a towel for each guest", "one locker per bed": multiplies what was named last."""
    items = items or last_items(state)
    owner = None if of_people else owner or owners_of(state, items)
    if owner in items:
        items = [m for m in items if m is not owner]
    people = state.out.people
    by = owner.count if owner is not None else (people, people) if people else None
    if not items or by is None:
        return False
    if owner is None:
        multiply(items, by)
    else:
        items = distributed(state, items, owner)
        _belong(state, items, owner)
    return True


def one_for_each(state: State, near: list[Mention]) -> bool:
    """ "Four microscopes, one each", "three sinks, one for each pupil": whether "one" only says whose they are.

    Their number stays; what each of which has one is as many, and people are as many where no number was told.
    """
    ahead = state.chunk(state.at)
    skip = int(ahead is not None and ahead.kind in ("word", "purpose") and ahead.text == "for")
    chunk = state.chunk(state.at + skip)
    if chunk is None or chunk.kind != "noun":
        return False
    of_people = chunk.value.what == "people" and chunk.value.text.split()[-1] in _OF_US
    if not (is_each(chunk.value) or of_people or chunk.text in _EVERYBODY):
        return False
    group, phrase = state.refs.several(near), chunk.value
    if group is None or group.count is None or group.count[0] != group.count[1] or (phrase.of_group and not of_people):
        return False
    after = state.chunk(state.at + skip + 1)
    if after is not None and after.kind in ("with", "verb"):
        return False
    many = group.count[0]
    state.at += skip + 1
    state.out.referred.append(state.span_of(chunk))
    if phrase.what == "people" and state.out.people is None:
        state.out.people = many
    elif phrase.what == "thing":
        owner = state.refs.known(phrase, True, [group])
        if owner is None:
            owner = new_mention(phrase, state.source)
            owner.uncounted = True
            state.out.mentions.append(owner)
        if owner.count is None or owner.count == MANY or owner.uncounted:
            owner.count = (many, many)
        if owner.count == group.count and owner.per is not group:
            group.per = owner
            _belong(state, [group], owner)
    state.head, state.glue = [group], ""
    return True


def _belong(state: State, items: list[Mention], owner: Mention) -> None:
    """What each of some things has is where it usually stands to them, unless that was said."""
    related = {m for said in state.out.said for m in said.subjects if owner in said.targets}
    for item in items:
        kind = owned_kind(item, owner, item.mount == "surface") if item not in related else None
        if kind == "on" and owner.family == "bed_group" and likeliness(item.category, owner.category) is None:
            kind = "near"  # a lamp for each bed lies on none
        if kind is not None:
            spoken = f"{item.noun} for each {owner.noun}"
            say(
                state,
                Said(kind, [item], (owner,), spoken, each=state.every == 1, implied=True, span=state.chunk_span()),
            )


def give_total(state: State, phrase: NounPhrase, group: Mention) -> bool:
    """ "At least 20 of them", "(min. 15)", "in two rows of four": how many there are of what had no number."""
    count = phrase.count or (1, 1)
    related = state.last_subjects if group in state.last_subjects else state.subject or state.head
    listed = [m for m in related if m.plural and m.count in (None, MANY)]
    open_ = group.count is None or group.count == MANY or (state.glue == "bracket" and group.count[0] < group.count[1])
    listed = listed if group in listed else [group] if open_ else []
    if not listed:
        return False
    least, most = (-(-n // len(listed)) for n in count)
    for mention in listed:
        mention.count = (least, most)
    return True


def share_total(state: State, total: tuple[int, int], begun: int) -> bool:
    """ "Ten objects, mugs and bottles": so many in all of the kinds that were named since; whether there are any."""
    listed = [m for m in state.out.mentions[begun:] if m.plural and m.count in (None, MANY)]
    for k, mention in enumerate(listed):
        mention.count = tuple((n + len(listed) - 1 - k) // len(listed) for n in total)  # type: ignore[assignment]
    return bool(listed)
