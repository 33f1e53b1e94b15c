"""Which word of place means which way of carrying for a pair of things: coats "on" a coat rack hang from it.

What is said of two things is told by how the one carries the other (`assets.carrying`): from hooks, in a cavity, on
top.
"""

from __future__ import annotations

import math
import re

from sceneweaver.assets import categories
from sceneweaver.assets.carrying import carrier, draped_words, hangs_from, hung_words, kind_for, on_wall
from sceneweaver.assets.roles import has_role

from .parsed import Mention, Parsed, Said

CARRYING = (
    "on",
    "inside",
    "above",
    "against",
    "leaning_on",
    "hanging_from",
    "below",
    "behind",
    "near",
    "at",
    "next_to",
)
"""Types of relations that may tell that one thing carries another."""

FULL = ("full of", "filled with")
"""Words before a list of what something holds."""

_WORD = re.compile(r"[a-z]+")
_AFTER_HEAD = re.compile(r" (?:of|on|in|over|from|with|hung|hanging) ")

MOST_WITHIN = 4
"""Things of which a vessel counts as full."""

ROW_OF = "coat_hooks"
"""What several of a plural noun are one board of."""


def told_by_carriers(parsed: Parsed, mentions: list[Mention]) -> None:
    """Give what is said of a thing and its carrier the type that is meant of these two."""
    _listed(parsed)
    _told_by_contents(parsed)
    _of_vessels(parsed)
    own = {m for one in parsed.said if not one.implied and one.type in ("on", "inside") for m in one.subjects}
    hung = [one for one in parsed.said if one.type in CARRYING and _of_things(one)]
    parsed.said = [piece for one in parsed.said for piece in (_split(one, own) if one in hung else [one])]
    for one in parsed.said:
        if one.type == "hanging_from" and any(isinstance(t, str) and t.split(":")[0] == "wall" for t in one.targets):
            for mention in one.subjects:
                mention.category = on_wall(mention.category)
    for mention in mentions:
        if is_board(mention):
            mention.count = (1, 1)
        elif each := _shown(mention):
            low, high = mention.count or (1, 1)
            mention.count = (1, 1) if low < high else (math.ceil(low / each), math.ceil(high / each))


def is_vessel(mention: Mention) -> bool:
    """Whether things are in it and never on it."""
    return carrier(mention.category, mention.noun).ways == ("inside",)


def is_board(mention: Mention) -> bool:
    """Whether a plural names one board of several: a row of hooks."""
    open_ = mention.count is None or mention.count[0] < mention.count[1]
    return mention.category == ROW_OF and mention.plural and open_


def _shown(mention: Mention) -> int:
    """How many of what a plural names one body shows: eight gowns on a rail; 0 where each has a body of its own."""
    known = categories().get(mention.category)
    head = _AFTER_HEAD.split(mention.noun)[0].split()[-1:]
    return known.several.get(head[0], 0) if known and head else 0


def _listed(parsed: Parsed) -> None:
    """What ends a list of what something is full of and has a place of its own is none of that: "shelves full of books
    and a globe on the desk"."""
    own = {m for one in parsed.said if one.words not in FULL and not one.implied for m in one.subjects}
    first: set[Mention] = set()
    for one in [said for said in parsed.said if said.words in FULL and _of_things(said)]:
        target = one.targets[0]
        assert isinstance(target, Mention)
        kept = [m for k, m in enumerate(one.subjects) if m not in own or (k == 0 and target not in first)]
        first.add(target)
        if kept:
            one.subjects = kept
        else:
            parsed.said.remove(one)


def _told_by_contents(parsed: Parsed) -> None:
    """A rack is what its contents make it, and as many as fill a shelf are not in a bucket."""
    for one in parsed.said:
        if one.type not in ("on", "inside", "hanging_from") or not _of_things(one):
            continue
        target = one.targets[0]
        assert isinstance(target, Mention)
        kind = kind_for(target.noun, one.subjects[0].category) if one.subjects else None
        if kind is not None and target not in one.subjects:
            target.category, target.generic = kind, False
        if one.words in FULL and carrier(target.category, target.noun).ways == ("inside",):
            nouns = {m.noun for m in one.subjects}
            parsed.amounts = [
                a.model_copy(update={"least": MOST_WITHIN}) if a.entity in nouns and a.least else a
                for a in parsed.amounts
            ]


def _of_vessels(parsed: Parsed) -> None:
    """ "A bowl with keys in it on the desk": what is said of contents after their small vessel is said of that."""
    within: dict[Mention, Mention] = {}
    placed = {m for one in parsed.said if not one.implied and one.type in ("on", "inside") for m in one.subjects}
    for one in parsed.said:
        target = one.targets[0] if one.targets else ""
        vessels = [within.get(m) for m in one.subjects]
        vessel = vessels[0] if vessels else None
        if one.type == "inside" and isinstance(target, Mention):
            within |= {m: target for m in one.subjects if target.is_small and target not in placed}
        elif one.type == "on" and vessel is not None and vessel is not target and set(vessels) == {vessel}:
            one.subjects = [vessel]


def _of_things(said: Said) -> bool:
    return len(said.targets) == 1 and isinstance(said.targets[0], Mention)


def _split(said: Said, own: set[Mention]) -> list[Said]:
    """A relation as it is meant of each of its subjects, of those with the same meaning together."""
    target = said.targets[0]
    assert isinstance(target, Mention)
    meant: dict[str, list[Mention]] = {}
    for subject in said.subjects:
        kind = (
            said.type if said.implied and " with " in said.words and subject in own else _meant(said, subject, target)
        )
        meant.setdefault(kind, []).append(subject)
    if list(meant) == [said.type]:
        return [said]
    return [_typed(said, kind, subjects) for kind, subjects in meant.items()]


def _typed(said: Said, kind: str, subjects: list[Mention]) -> Said:
    given = {name: getattr(said, name) for name in ("targets", "words", "count", "each", "side", "implied", "span")}
    return Said(kind, subjects, **given, params=dict(said.params), nth=said.nth)


def _meant(said: Said, thing: Mention, target: Mention) -> str:
    """The type of relation that is meant of a thing and what is to carry it."""
    spoken = set(_WORD.findall(said.words.lower()))
    kind = carrier(target.category, target.noun)
    on_top = "top" in spoken or "atop" in spoken
    if not spoken.isdisjoint(hung_words()):
        if not spoken.isdisjoint(draped_words()) and not kind.carries("hang"):
            return said.type
        if said.type == "inside" and not kind.pure:
            return said.type  # jackets that hang in a locker
        flat = "ceiling" in (thing.mount, target.mount) and thing.mount != "surface"
        return said.type if on_top or flat or thing.is_rug or target.is_rug else _hung(said, thing)
    with_it = said.implied and "with" in spoken
    if (said.type in ("on", "inside") or with_it) and not on_top and hangs_from(thing.category, thing.noun, kind):
        return "hanging_from" if thing.mount != "ceiling" else said.type
    if with_it and said.type == "near" and thing.is_small and has_role(target.category, "shelves"):
        return "on"
    stands_in = any(a.value.startswith("as ") for a in target.attributes) or thing.family == "lighting"
    goes_in = kind.ways == ("inside",) and thing.is_small and target is not thing and not stands_in
    if said.type == "on" and goes_in and not on_top:
        return "inside"  # fruit "on" a bowl; no lamp, and nothing on a crate that is used as a table
    return said.type


def _hung(said: Said, thing: Mention) -> str:
    """What "hung" and a word of place say: over a table it hangs above it, elsewhere from the thing."""
    if said.type in ("above", "near", "at", "next_to") or (said.type == "below" and not thing.is_small):
        return said.type
    return "hanging_from"


__all__ = ["is_board", "is_vessel", "told_by_carriers"]
