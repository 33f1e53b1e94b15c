"""The relations of a model's reading, checked: who, where, how far, and that nothing stands on itself in the end."""

from __future__ import annotations

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.scene.messages import quote as shown

from ..graph import MOST
from ..grounding import FURTHEST
from ..model import PLACES
from ..parsed import Left, Mention, Said, Target
from ..vocabulary import mounts, words
from ..wall_names import COMPASS
from .draft import OUT, Draft, counted
from .english import LONGEST, cut
from .leniency import term
from .quotes import Quotes
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


class Relations:
    """Puts the relations of a reply into a draft that has its things."""

    def __init__(self, quotes: Quotes, draft: Draft) -> None:
        self._quotes, self._draft = quotes, draft
        self._carrier: dict[int, Mention] = {}

    def run(self, relations: tuple[RelationReply, ...]) -> None:
        """All of them, in the order of the reply."""
        for number, relation in enumerate(relations[: 4 * MOST]):
            if not self._relation(f"relation {number} ({relation.type})", relation) and relation.quote:
                span = self._quotes.nearest(relation.quote, None)
                self._draft.parsed.unread.append(Left(cut(relation.quote, 2 * LONGEST), *(span or (0, 0))))
        if len(relations) > 4 * MOST:
            problem = f"relations: there are {len(relations)}; say at most {4 * MOST}"
            self._draft.problems[problem] = "the rest was left out"

    def _relation(self, where: str, said: RelationReply) -> bool:
        """Whether a relation could be said."""
        draft = self._draft
        subject = self._target(said.subject)
        if not isinstance(subject, Mention):
            return self._wrong(f"{where}: subject {shown(cut(said.subject))} is no thing; {self._ids()}")
        targets: list[Target] = []
        for name in said.targets[:LISTED]:
            target = self._target(name)
            if target is None:
                return self._wrong(
                    f"{where}: target {shown(cut(name))} is neither a thing nor a place; {self._ids()}; places: "
                    f"{', '.join(PLACES)}"
                )
            targets += [target] if not any(target is other for other in targets) else []
        if not targets:
            return self._wrong(f"{where}: it has no targets; name what it is said of")
        if any(target is subject for target in targets):
            targets = [target for target in targets if target is not subject]
            if not targets and (subject.count is None or subject.count[1] < 2):
                return self._wrong(f"{where}: {shown(said.subject)} cannot stand to itself; name another target")
            targets = targets or ["each other"]
        if not self._params(where, said):
            return False
        if said.type == "between" and not self._two(targets):
            return self._wrong(f"{where}: between needs two targets, or one of which there are two")
        count = counted(said.count, where, draft.problems)
        return all([self._say(where, said, subject, group, count) for group in _grouped(said.type, targets)])

    def _say(
        self,
        where: str,
        said: RelationReply,
        subject: Mention,
        targets: tuple[Target, ...],
        count: tuple[int, int] | None,
    ) -> bool:
        kind, first = said.type, targets[0]
        if kind in HOLDING and isinstance(first, Mention):
            if self._holds(subject, first):
                return self._wrong(f"{where}: {shown(said.subject)} would carry what carries it; drop one")
            self._carrier.setdefault(id(subject), first)
        if isinstance(first, str) and first in ("corner", "middle"):
            kind = "at"
        elif kind == "between" and (len(targets) == 1 and isinstance(first, str) or any(t in PLACES for t in targets)):
            kind = "near"
        kind = _as_usual(kind, subject, first)
        if kind == "between" and len(targets) == 1 and targets[0] != "each other":
            targets = (first, first)  # between two of a kind
        span = self._quotes.nearest(said.quote, subject.span) if said.quote else None
        if said.quote and span is None:
            self._draft.doubts.append(f"{where}: {shown(cut(said.quote))} is not in the request; copy its words")
        params = {name: value for name, value in (("min", said.min), ("max", said.max)) if value is not None}
        self._draft.parsed.said.append(
            Said(
                kind,
                [subject],
                targets,
                cut(said.quote, 2 * LONGEST) or said.type.replace("_", " "),
                count,
                said.each,
                said.side,
                said.implied,
                span,
                params,
            )
        )
        return True

    def _target(self, name: str) -> Target | None:
        """A thing by its id or, where that tells one, by its name; a place by its own."""
        draft = self._draft
        if name in draft.things:
            return draft.things[name]
        if name in draft.places:
            return draft.places[name]
        place = _place(name)
        if isinstance(place, str) and (place in PLACES or place.removeprefix("wall:") in WALLS and ":" in place):
            return place
        named = draft.names.get(name.lower(), [])
        return draft.things[named[0]] if len(named) == 1 else None

    def _params(self, where: str, said: RelationReply) -> bool:
        """Whether the distances make sense."""
        low, high = said.min or 0.0, FURTHEST if said.max is None else said.max
        if 0.0 <= low <= high <= FURTHEST:
            return True
        return self._wrong(f"{where}: min and max are metres, 0 <= min <= max <= {FURTHEST:g}, or null")

    @staticmethod
    def _two(targets: list[Target]) -> bool:
        """Whether something may be between."""
        first = targets[0]
        several = isinstance(first, Mention) and (first.many or first.count is None)
        return len(targets) > 1 or several or first == "each other" or isinstance(first, str)

    def _holds(self, thing: Mention, other: Mention) -> bool:
        """Whether a thing carries another in the end."""
        for _ in range(len(self._carrier) + 1):
            if other is thing:
                return True
            if id(other) not in self._carrier:
                return False
            other = self._carrier[id(other)]
        return True

    def _ids(self) -> str:
        """The ids that there are, as a message says them."""
        known = [cut(name) for name in self._draft.things]
        rest = f" and {len(known) - LISTED} more" if len(known) > LISTED else ""
        return f"things: {', '.join(known[:LISTED])}{rest}" if known else "there are no things"

    def _wrong(self, problem: str) -> bool:
        self._draft.problems[problem] = OUT
        return False


def _grouped(kind: str, targets: list[Target]) -> list[tuple[Target, ...]]:
    """The targets that one relation is said of: all together, or each on its own."""
    things = tuple(target for target in targets if isinstance(target, Mention))
    if kind in SHARED and len(things) == len(targets):
        return [things]
    return [(target,) for target in targets]


def _as_usual(kind: str, subject: Mention, target: Target) -> str:
    """What is meant by usage: a plant on a table is a small one, a lamp that hangs no floor lamp."""
    hung = words("nouns")["hung"]
    if isinstance(target, str):
        if target == "ceiling" or target.startswith("wall") and kind in ("on", "hanging_from"):
            place = "ceiling" if target == "ceiling" else "wall"
            subject.category = hung[place].get(subject.category, subject.category)
        return "on" if kind == "hanging_from" and target.startswith("wall") else kind
    if kind in ("on", "inside") and "rug" not in target.category:
        subject.category = hung["surface"].get(subject.category, subject.category)
    if kind == "hanging_from" and mounts(target.category)[0] not in ("ceiling", "wall") and _is_hung(subject):
        return "above"
    return kind


def _is_hung(thing: Mention) -> bool:
    return category_named(thing.category).mount[0] == "ceiling"
