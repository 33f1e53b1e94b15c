"""What each of several things has: "six tables, each with a lamp and a stool", "a chair and a bin at every desk".

Things that are told of each one of a group are counted out over the group once (`distributed`), and remember it
(`Mention.per`), so that every relation to that group holds of each of its things with what is its own.
"""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.assets.taxonomy import likeliness

from .chunks import EACH, Chunk, NounPhrase
from .parsed import Mention, Parsed, Said
from .state import State
from .things import MANY, singular
from .vocabulary import Place, words

_TOGETHER = ("between", "around", "along", "below", "near")
"""Relations that one thing may have to two at once: a rug between both, or under both."""


def is_each(phrase: NounPhrase) -> bool:
    """Whether a phrase speaks of every single one of some things: "every desk", "each", "each of them"."""
    return phrase.determiner in EACH or (phrase.what == "pronoun" and phrase.value == "each")


def speaks_of_both(phrase: NounPhrase, kind: str, subjects: list[Mention] | None = None) -> bool:
    """Whether "both" means each of two: a lamp "on both", but no rug "between both", no "one mirror over both"."""
    if phrase.what != "pronoun" or phrase.value != "both" or kind in _TOGETHER:
        return False
    return not (kind == "above" and any(m.numbered and m.count == (1, 1) for m in subjects or ()))


def each_next(state: State, at: int) -> bool:
    """Whether the noun phrase at a chunk speaks of each of some things."""
    chunk = state.chunk(at)
    return chunk is not None and chunk.kind == "noun" and is_each(chunk.value)


def distributed(state: State, mentions: list[Mention], owner: Mention | None) -> list[Mention]:
    """Things of which each of an owner's has so many, counted out; where that many were named before it is these."""
    if owner is None:
        return mentions
    return [_counted_out(state, mention, owner) for mention in mentions]


def _counted_out(state: State, mention: Mention, owner: Mention) -> Mention:
    if mention is owner or mention.per is not None or owner.per is mention:
        return mention
    low, high = mention.count or (1, 1)
    if mention.count == MANY and mention.plural:
        low, high = 1, 1  # "tables, each with chairs"
    by = owner.count or ((1, 1) if not owner.plural else MANY)
    if state.every > 1:
        by = (max(1, by[0] // state.every), max(1, by[1] // state.every))
    if low == high > 1 and by[0] == by[1] > 1 and low % by[0] == 0 and _is_placed(state, mention):
        mention.per = owner  # "five mats lie around the bowl, aligned with each chair"
        return mention
    count = (low * by[0], high * by[1])
    named = _named_before(state, mention, count, owner) if by[0] > 1 else None
    if named is not None:
        state.out.mentions.remove(mention)
        named.per = owner
        return named
    mention.count, mention.per = count, owner if state.every == 1 else None
    return mention


def at_each_place(mentions: list[Mention], place: str) -> None:
    """ "In each corner a plant": four of a rectangle's corners and walls, as many of its windows as are told."""
    for mention in mentions:
        if place in ("window", "door"):
            mention.per_place = place
        elif place in ("corner", "wall"):
            low, high = mention.count or (1, 1)
            mention.count = (4 * low, 4 * high)


def count_out_again(state: State, owner: Mention, count: tuple[int, int]) -> None:
    """ "One chair per desk, six desks": how many there are of what was named by "each" alone."""
    known, owner.count, owner.uncounted = owner.count, count, False
    if known == count:
        return
    for mention in state.out.mentions:
        if mention.per is owner:
            low, high = mention.count or (1, 1)
            mention.count = (low * count[0], high * count[1])


def _is_placed(state: State, mention: Mention) -> bool:
    """Whether something was placed before "each" is said of it, so that its number is that of all."""
    return any(mention in said.subjects and not said.implied for said in state.out.said)


def _named_before(state: State, mention: Mention, count: tuple[int, int], owner: Mention) -> Mention | None:
    """ "Four desks and four chairs, a chair at each desk": the things that are now told of one by one."""
    if mention not in state.out.mentions or any(mention in said.subjects for said in state.out.said):
        return None
    noun, placed = singular(mention.noun), {m for said in state.out.said for m in said.subjects if not said.implied}
    for other in state.out.mentions[: state.out.mentions.index(mention)][-12:]:
        alike = singular(other.noun) == noun and other.count == count and (other.color or "") == (mention.color or "")
        if alike and other is not owner and other.per is None and other not in placed:
            return other
    return None


def listed_before(state: State, listed: list[Mention], owner: Mention | None) -> list[Mention]:
    """The things of a list that "at every desk" behind it is said of: all since the desks, as far as none has a place
    of its own or stands at a wall."""
    placed = {m for said in state.out.said for m in said.subjects if not said.implied}
    found: list[Mention] = []
    for mention in reversed(listed):
        apart = mention is owner or mention in placed or mention.per is not None
        if apart or (found and (mention.mount == "wall" or mention.family in ("storage", "bed_group"))):
            break
        found.insert(0, mention)
    return found


def over_each(place: Place) -> Place:
    """A word of place said of each of its targets."""
    return replace(place, each=True, over_each=True)


def share_in(state: State, subjects: list[Mention], target: Mention) -> list[Mention]:
    """What is placed at one of the things that each of a group has is there for each of these: "every bed has a
    nightstand with a lamp on it"."""
    fresh = state.out.mentions[state.begun :]
    if target.per is None or target not in fresh:
        return subjects
    own = [s for s in subjects if s in fresh and s.per is None and s.count in (None, (1, 1)) and not s.plural]
    shared = distributed(state, own, target)
    swapped = dict(zip(own, shared, strict=True))
    return [swapped.get(s, s) for s in subjects]


def stands_for_each(state: State, phrase: NounPhrase) -> bool:
    """Whether "each place", "every station" means each of the things that people are at there."""
    return phrase.determiner in EACH and singular(phrase.text) in words("nouns")["stations"]


def group_used_by_people(state: State) -> Mention | None:
    """The things that places, seats and stations are: the last group that people are at, else the last group."""
    several = [m for m in reversed(state.out.mentions[-20:]) if m.many and m.count not in (None, MANY)]
    used = (m for m in several if m.family in ("table", "seat", "bed_group") and m.per is None)
    return next(used, next(iter(several), None))


def on_each_side(said: Said, spoken: list[str], one: Mention, target: Mention) -> None:
    """ "Two chairs on each long side", "three on each side of every table": counted out over the sides of each target.

    Seats are along both long sides of a table; a number "on either side" or "on both sides" is that of all, unless it
    is odd.
    """
    if one.count is None or one.count[0] != one.count[1] or (said.type == "flanking" and one.count == (1, 1)):
        return
    if one.count == (1, 1) and {"either", "both"} & {*spoken}:
        spoken = ["each"]  # "a lamp at either end"
    least = one.count[0]
    by = target.count[0] if target.count is not None and target.count[0] == target.count[1] else 1
    shared = by if one.per is target else 1
    of_all = said.type == "along" or least // shared % 2 == 0
    if of_all and "each" not in spoken and "every" not in spoken:
        return
    if said.type == "flanking" and one.family == "seat" and target.family == "table":
        said.type, said.side = "along", "long"
    if said.type == "along":
        said.count = (least // shared, least // shared)
    total = 2 * least * (by // shared)
    one.count = (total, total)
    one.per = target if by > 1 else one.per


def owner_told_of(state: State, subjects: list[Mention], on: bool = False) -> Mention | None:
    """ "A box on each bench, a stool at each": the things of which the sentence told so, or those of which it then
    named several that each of these has, but for what is rather ``on`` the former."""
    for mention in reversed(state.out.mentions[state.begun :]):
        if mention in subjects or mention.per is None:
            continue
        if mention.per in subjects:
            return None
        several = mention.count is not None and mention.per.count is not None and mention.count > mention.per.count
        if several and not (on and _rather(subjects, mention.per, mention)):
            return mention
        return mention.per
    return None


def _rather(subjects: list[Mention], one: Mention, other: Mention) -> bool:
    """Whether things usually stand on one thing rather than on another."""
    ranks = [likeliness(subjects[0].category, m.category) for m in (one, other)] if subjects else [None, None]
    if ranks == [None, None] and other.family == "seat":
        return one.family in ("table", "storage")
    return ranks[0] is not None and (ranks[1] is None or ranks[0] < ranks[1])


def every_so_many(phrase: NounPhrase) -> int:
    """2 for "every second chair" and "every two chairs", which the phrase then says no more; 1 for every single one."""
    if phrase.determiner not in EACH or phrase.of_group:
        return 1
    if phrase.count is not None and phrase.count[0] == phrase.count[1] > 1:
        many, phrase.count = phrase.count[0], None
        return many
    table = words("nouns")["every"]
    found = next((token for token in phrase.qualities if token.text in table), None)
    if found is None:
        return 1
    phrase.qualities.remove(found)
    return int(table[found.text])


def part_of_each(state: State, chunk: Chunk | None) -> bool:
    """Whether a number before these words is how many each of some things or sides have: "one next to each bed"."""
    if chunk is None or chunk.kind != "place":
        return False
    return bool(chunk.value.each) or each_next(state, state.at + 1)


def tell_each(parsed: Parsed) -> None:
    """Relations of what was counted out over a group hold of each of the group with its own."""
    for mention in parsed.mentions:
        many = parsed.openings.get(mention.per_place, 0)
        if many > 1:  # "a table at each window, three windows"
            low, high = mention.count or (1, 1)
            mention.count, mention.per_place = (low * many, high * many), ""
    for said in parsed.said:
        if len(said.targets) != 1 or said.each or not isinstance(target := said.targets[0], Mention):
            continue
        if said.type == "along" or not target.many:
            continue
        if said.subjects == [target.per]:  # "three chairs, each facing a mirror"
            said.each = True
            continue
        if all(s.per is not None and s.per in (target, target.per) for s in said.subjects):
            said.each = True
