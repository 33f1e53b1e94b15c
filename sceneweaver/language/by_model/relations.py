"""The relations of a model's reading, checked: who, where, how far, and that nothing stands on itself in the end."""

from __future__ import annotations

from sceneweaver.io.messages import quote as shown

from ..graph import MOST
from ..grounding import FURTHEST
from ..model import PLACES
from ..parsed import Mention, Said, Target
from ..relating import call_by_place, close_kind
from ..wall_names import COMPASS
from .draft import OUT, Draft, counted
from .english import LONGEST, cut
from .leniency import term
from .reply import RelationReply

WALLS = ("left", "right", "far", "near", "opposite", "back", "front", *COMPASS)
"""What may come after ``wall:``."""

HOLDING = ("on", "inside", "hanging_from", "leaning_on")
"""Types by which one thing holds another."""

SHARED = ("on", "inside", "around", "between")
"""Types that are said of all their targets together."""

LISTED = 12
"""Ids that a message names."""

_place = term([*PLACES, *(f"wall:{name}" for name in WALLS)])


class _Refused(Exception):
    """What is wrong with a relation, so that it is left out."""


def add_relations(relations: tuple[RelationReply, ...], draft: Draft) -> None:
    """Puts the relations of a reply into a draft that has its things."""
    carriers: dict[Mention, Mention] = {}
    for number, relation in enumerate(relations[: 4 * MOST]):
        where = f"relation {number} ({relation.type})"
        try:
            _add(where, relation, draft, carriers)
        except _Refused as wrong:
            draft.problems[f"{where}: {wrong}"] = OUT
            if relation.quote:
                draft.leave_unread(relation.quote, 2 * LONGEST)
    if len(relations) > 4 * MOST:
        draft.problems[f"relations: there are {len(relations)}; say at most {4 * MOST}"] = "the rest was left out"


def _add(where: str, said: RelationReply, draft: Draft, carriers: dict[Mention, Mention]) -> None:
    """One of them, for each group of its targets."""
    subject = _target(said.subject, draft)
    if not isinstance(subject, Mention):
        raise _Refused(f"subject {shown(cut(said.subject))} is no thing; {_ids(draft)}")
    targets: list[Target] = []
    for name in said.targets[:LISTED]:
        target = _target(name, draft)
        if target is None:
            raise _Refused(
                f"target {shown(cut(name))} is neither a thing nor a place; {_ids(draft)}; places: {', '.join(PLACES)}"
            )
        targets += [target] if target not in targets else []
    if not targets:
        raise _Refused("it has no targets; name what it is said of")
    if subject in targets:
        targets.remove(subject)
        if not targets and (subject.count is None or subject.count[1] < 2):
            raise _Refused(f"{shown(said.subject)} cannot stand to itself; name another target")
        targets = targets or ["each other"]
    if not 0.0 <= (said.min or 0.0) <= (FURTHEST if said.max is None else said.max) <= FURTHEST:
        raise _Refused(f"min and max are metres, 0 <= min <= max <= {FURTHEST:g}, or null")
    if said.type == "between" and not _are_two(targets):
        raise _Refused("between needs two targets, or one of which there are two")
    count = counted(said.count, where, draft.problems)
    refused: _Refused | None = None
    for group in _grouped(said.type, targets):
        try:
            _say(where, said, subject, group, count, draft, carriers)
        except _Refused as wrong:
            refused = wrong  # what is said of the others stays
    if refused is not None:
        raise refused


def _say(
    where: str,
    said: RelationReply,
    subject: Mention,
    targets: tuple[Target, ...],
    count: tuple[int, int] | None,
    draft: Draft,
    carriers: dict[Mention, Mention],
) -> None:
    kind, first = said.type, targets[0]
    if kind in HOLDING and isinstance(first, Mention):
        if _holds(subject, first, carriers):
            raise _Refused(f"{shown(said.subject)} would carry what carries it; drop one")
        carriers.setdefault(subject, first)
    if isinstance(first, str) and first in ("corner", "middle"):
        kind = "at"
    elif kind == "between" and (len(targets) == 1 and isinstance(first, str) or any(t in PLACES for t in targets)):
        kind = "near"
    kind = _as_usual(kind, subject, first)
    if kind == "between" and len(targets) == 1 and targets[0] != "each other":
        targets = (first, first)  # between two of a kind
    span = draft.quotes.nearest(said.quote, subject.span) if said.quote else None
    if said.quote and span is None:
        draft.doubts.append(f"{where}: {shown(cut(said.quote))} is not in the request; copy its words")
    kind = close_kind(kind, said.quote or "", [subject], first)
    params = {name: value for name, value in (("min", said.min), ("max", said.max)) if value is not None}
    words = cut(said.quote, 2 * LONGEST) or said.type.replace("_", " ")
    draft.parsed.said.append(
        Said(kind, [subject], targets, words, count, said.each, said.side, said.implied, span, params)
    )


def _target(name: str, draft: Draft) -> Target | None:
    """A thing by its id or, where that tells one, by its name; a place by its own."""
    if name in draft.things or name in draft.places:
        return draft.things.get(name) or draft.places[name]
    place = _place(name)
    if isinstance(place, str) and (place in PLACES or place.removeprefix("wall:") in WALLS and ":" in place):
        return place
    named = draft.names.get(name.lower(), [])
    return draft.things[named[0]] if len(named) == 1 else None


def _are_two(targets: list[Target]) -> bool:
    """Whether something may be between."""
    first = targets[0]
    return len(targets) > 1 or isinstance(first, str) or first.many or first.count is None


def _holds(thing: Mention, other: Mention, carriers: dict[Mention, Mention]) -> bool:
    """Whether a thing carries another in the end."""
    for _ in range(len(carriers) + 1):
        if other is thing:
            return True
        if other not in carriers:
            return False
        other = carriers[other]
    return True


def _ids(draft: Draft) -> str:
    """The ids that there are, as a message says them."""
    known = [cut(name) for name in draft.things]
    rest = f" and {len(known) - LISTED} more" if len(known) > LISTED else ""
    return f"things: {', '.join(known[:LISTED])}{rest}" if known else "there are no things"


def _grouped(kind: str, targets: list[Target]) -> list[tuple[Target, ...]]:
    """The targets that one relation is said of: all together, or each on its own."""
    things = tuple(target for target in targets if isinstance(target, Mention))
    if kind in SHARED and len(things) == len(targets):
        return [things]
    return [(target,) for target in targets]


def _as_usual(kind: str, subject: Mention, target: Target) -> str:
    """What is meant by usage: a plant on a table is a small one, a lamp that hangs no floor lamp."""
    if isinstance(target, str):
        on_wall = target.startswith("wall")
        if target == "ceiling" or (on_wall and kind in ("on", "hanging_from")):
            call_by_place([subject], "wall" if on_wall else "ceiling")
        return "on" if kind == "hanging_from" and on_wall else kind
    if kind in ("on", "inside") and "rug" not in target.category:
        call_by_place([subject], "surface")
    hung = subject.mount == "ceiling" and target.mount not in ("ceiling", "wall")
    return "above" if kind == "hanging_from" and hung else kind
