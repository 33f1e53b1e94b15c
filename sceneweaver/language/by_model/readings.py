"""Two readings of one request: where they disagree, and what of the offline reader's stays where a model's is used."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from ..graph import MOST
from ..model import Entity, Exclusion, SceneGraph, Span, StatedRelation
from .disagreements import Disagreement, count_of, fact_of, head_of, overlap, size_of, thing_of
from .english import LONGEST
from .relations import HOLDING

ROOM = (
    "room_type",
    "shape",
    "size",
    "area",
    "height",
    "scale",
    "people",
    "style",
    "windows",
    "doors",
    "density",
    "only",
)
"""Facts about the room of which there is one."""

MUTUAL = ("next_to", "near", "far_from", "side_by_side", "opposite", "parallel", "aligned", "back_to_back")
"""Types that say the same of the target and the subject."""

LISTS = ("other_rooms", "for_whom", "colors")
"""Facts about the room of which there are several."""


def united(
    model: SceneGraph, offline: SceneGraph, marked: Sequence[Span]
) -> tuple[SceneGraph, tuple[Disagreement, ...]]:
    """The graph to work from, and each disagreement.

    The model's reading is used. What it did not mention must not vanish, so that of the offline reading stays in it:

    - a thing that was read from a known noun, when the model said of that noun nothing at all, neither as a thing nor
      as a word about one, as what must not be there or as the name of the room (``marked``);
    - a word about a thing, likewise, and what it says (colour, material, style); its count and its size, where the
      model gave none;
    - a relation between things or places that both have, when the model took its words for nothing else and has
      none between the two;
    - what must not be there, unless the model has it as a thing or took the words for something else;
    - facts about the room that the model did not give;
    - words that the offline reader could not read and the model did not mention, under ``unread``.

    Where the model did say something else of the same words, its reading stands. Either way it is a row. What only a
    part of the room calls for (``implied``) is left to the model.

    Args:
        model: the graph of the model.
        offline: that of the offline reader, of the same text.
        marked: where the words stand of which the model said what they are.
    """
    work = _Union(model, offline, marked)
    work.things()
    work.relations()
    work.exclusions()
    work.room()
    return work.graph(), tuple(work.rows)


class _Union:
    """Goes through all that both read."""

    def __init__(self, model: SceneGraph, offline: SceneGraph, marked: Sequence[Span]) -> None:
        self.model, self.offline, self.marked = model, offline, marked
        self.entities = list(model.entities)
        self.added_relations: list[StatedRelation] = []
        self.added_exclusions: list[Exclusion] = []
        self.facts: dict[str, Any] = {}
        self.rows: list[Disagreement] = []
        self.same: dict[str, list[str]] = {}
        """Ids of the graph by ids of offline entities."""

    def row(self, item: str, field: str, offline: str, model: str, used: str, span: Span | None = None) -> None:
        """One more disagreement."""
        self.rows.append(
            Disagreement(item=item, field=field, offline=offline, model=model, used=used, span=span)  # type: ignore[arg-type]
        )

    def things(self) -> None:
        """Pairs the things of both and goes through them."""
        self._pair()
        paired = {name for names in self.same.values() for name in names}
        for mine in self.offline.entities:
            if mine.id not in self.same:
                self._missing(mine)
        for theirs in self.model.entities:
            if theirs.id not in paired:
                self.row(theirs.id, "thing", "", thing_of(theirs), "model", theirs.span)
        seen: set[str] = set()
        for mine in self.offline.entities:
            for name in self.same.get(mine.id, ())[:1]:
                if name not in seen and name in {e.id for e in self.model.entities}:
                    seen.add(name)
                    self._compare(name)

    def _pair(self) -> None:
        """What is on the same words is the same; else what is of the same kind: a model may quote another mention."""
        before: dict[Span | None, int] = {}
        for mine in self.offline.entities:
            head = head_of(mine.span, self.offline.text)
            words = mine.span if mine.generic else head  # of a noun that is not known any word may be the noun
            over = [e for e in self.model.entities if overlap(words, e.span)]
            alike = [e.id for e in over if e.category == mine.category]
            other = [e.id for e in over if e.span is not None and e.span.end - e.span.start <= LONGEST]
            if alike:  # the second of two that share their words is the second of the model's
                k = before[head] = before.get(head, -1) + 1
                self.same[mine.id] = [*alike[k % len(alike) :], *alike[: k % len(alike)]]
            elif other:
                self.same[mine.id] = other[:1]
        taken = {name for names in self.same.values() for name in names}
        for mine in self.offline.entities:
            head = head_of(mine.span, self.offline.text)
            if mine.id in self.same or (head is not None and not mine.implied and self._is_marked(head)):
                continue
            for theirs in self.model.entities:
                if theirs.id not in taken and theirs.category == mine.category:
                    self.same[mine.id] = [theirs.id]
                    taken.add(theirs.id)
                    break

    def _missing(self, mine: Entity) -> None:
        """A thing that the model has not."""
        head = head_of(mine.span, self.offline.text)
        excluded = mine.category in self.model.without
        keep = not (mine.implied or mine.generic or excluded or head is None or self._is_marked(head))
        keep = keep and len(self.entities) < MOST
        if not keep:
            self.row(mine.id, "thing", thing_of(mine), "", "model", mine.span)
            return
        name = _free(mine.category, {e.id for e in self.entities})
        attributes = tuple(a.model_copy(update={"id": f"{name}/{k}"}) for k, a in enumerate(mine.attributes))
        self.entities.append(mine.model_copy(update={"id": name, "attributes": attributes}))
        self.same[mine.id] = [name]
        self.row(name, "thing", thing_of(mine), "", "offline", mine.span)

    def _compare(self, name: str) -> None:
        """The things of the offline reader that are one of the model's, and what else of these is the same."""
        mine = [e for e in self.offline.entities if name in self.same.get(e.id, ())]
        ids = {other for e in mine for other in self.same[e.id]}
        theirs = [e for e in self.model.entities if e.id in ids]
        first, one = mine[0], next(e for e in theirs if e.id == name)
        if first.category != one.category:
            self.row(name, "category", first.category, one.category, "model", one.span)
        spoken, given = _sum(mine), _sum(theirs)
        update: dict[str, Any] = {}
        if spoken != given and spoken is not None:
            if given is None and len(theirs) == len(mine) == 1:
                update["count"] = spoken
            self.row(name, "count", count_of(spoken), count_of(given), "offline" if update else "model", one.span)
        if len(mine) == 1 and len(theirs) == 1:
            update |= self._filled(first, one)
        if update:
            self.entities = [e.model_copy(update=update) if e.id == name else e for e in self.entities]

    def _filled(self, mine: Entity, theirs: Entity) -> dict[str, Any]:
        """Words and sizes that the model did not give."""
        update: dict[str, Any] = {}
        free = [a for a in mine.attributes if a.span is not None and not self._is_marked(a.span)]
        free = [a for a in free if a.value not in theirs.noun.lower().split()]
        said = {a.kind for a in free}
        for kind in ("color", "material", "style"):
            one, other = getattr(mine, kind), getattr(theirs, kind)
            if one is None or one == other:
                continue
            if other is None and kind in said:
                update[kind] = one
            self.row(theirs.id, kind, one, other or "", "offline" if kind in update else "model", theirs.span)
        if free:
            first = len(theirs.attributes)
            more = [a.model_copy(update={"id": f"{theirs.id}/{k}"}) for k, a in enumerate(free, start=first)]
            update["attributes"] = (*theirs.attributes, *more)
            update["words"] = tuple(dict.fromkeys([*theirs.words, *(a.value for a in free if a.value in mine.words)]))
            for a in free:
                if a.kind not in ("color", "material", "style"):
                    self.row(theirs.id, a.kind, a.value, "", "offline", a.span)
            if "size" in said and theirs.scale == 1.0 != mine.scale:
                update["scale"] = mine.scale
        if mine.size != theirs.size and mine.size != (None, None, None):
            if theirs.size == (None, None, None):
                update["size"] = mine.size
            self.row(
                theirs.id, "size", size_of(mine.size), size_of(theirs.size), "offline" if "size" in update else "model"
            )
        return update

    def _there(self, name: str) -> str:
        """The id in the graph of what an offline relation names; "" where there is none."""
        if self.offline.entity(name) is None:
            return name
        return self.same.get(name, [""])[0]

    def _is_marked(self, span: Span) -> bool:
        return any(overlap(span, other) for other in self.marked)

    def relations(self) -> None:
        """What each says of where the things are that both have."""
        here = {e.id for e in self.entities}
        said: set[str] = set()
        for mine in self.offline.relations:
            targets = tuple(self._there(name) for name in mine.targets)
            subject = self._there(mine.subject)
            if subject not in here or not all(targets):
                continue
            between = [r for r in self.model.relations if r.subject == subject and _meet(r.targets, targets)]
            between += [r for r in self.model.relations if mine.type in MUTUAL and _swapped(r, subject, targets)]
            said |= {r.id for r in between}
            if mine.implied or any(r.type == mine.type for r in between):
                continue
            spoken = f"{mine.type} {', '.join(targets)}"
            if between:
                theirs = f"{between[0].type} {', '.join(between[0].targets)}"
                self.row(between[0].id, "relation", f"{subject} {spoken}", f"{subject} {theirs}", "model", mine.span)
                continue
            elsewhere = [r for r in self.model.relations if _may_say(r, subject, mine.span)]
            copy = mine.model_copy(update={"subject": subject, "targets": targets})
            keep = not elsewhere and mine.span is not None and not self._circular(copy)
            if keep:
                name = f"relation-{len(self.model.relations) + len(self.added_relations)}"
                self.added_relations.append(copy.model_copy(update={"id": name}))
            self.row(
                self.added_relations[-1].id if keep else mine.id,
                "relation",
                f"{subject} {spoken}",
                "",
                "offline" if keep else "model",
                mine.span,
            )
        for theirs in self.model.relations:
            if theirs.id not in said and not theirs.implied:
                spoken = f"{theirs.subject} {theirs.type} {', '.join(theirs.targets)}"
                self.row(theirs.id, "relation", "", spoken, "model", theirs.span)

    def _circular(self, said: StatedRelation) -> bool:
        """Whether something would be held twice, or stand on itself in the end."""
        if said.type not in HOLDING:
            return False
        held = {r.subject: r.targets for r in (*self.model.relations, *self.added_relations) if r.type in HOLDING}
        if said.subject in held:
            return True
        open_, seen = list(said.targets), set[str]()
        while open_:
            name = open_.pop()
            if name == said.subject:
                return True
            if name not in seen:
                seen.add(name)
                open_ += held.get(name, ())
        return False

    def exclusions(self) -> None:
        """What must not be there."""
        wanted = {e.category for e in self.model.entities}
        for mine in self.offline.exclusions:
            missing = [c for c in mine.categories if c not in self.model.without]
            if not missing:
                continue
            marked = mine.span is not None and self._is_marked(mine.span)
            keep = not marked and not wanted & set(missing)
            if keep:
                name = f"exclusion-{len(self.model.exclusions) + len(self.added_exclusions)}"
                self.added_exclusions.append(mine.model_copy(update={"id": name}))
            item = self.added_exclusions[-1].id if keep else mine.id
            self.row(item, "exclusion", f"no {mine.words}", "", "offline" if keep else "model", mine.span)
        for theirs in self.model.exclusions:
            if not set(theirs.categories) & set(self.offline.without):
                self.row(theirs.id, "exclusion", "", f"no {', '.join(theirs.categories)}", "model", theirs.span)

    def room(self) -> None:
        """Facts about the room."""
        for name in (*ROOM, *LISTS):
            usual = SceneGraph.model_fields[name].default
            mine, theirs = getattr(self.offline, name), getattr(self.model, name)
            if mine == theirs or (name in LISTS and (mine == usual or theirs != usual)):
                continue
            keep = theirs == usual and not (name == "room_type" and self.model.room_words)  # it named another kind
            if keep:
                self.facts[name] = mine
                if name == "room_type":
                    self.facts["room_words"] = self.offline.room_words
            shown = ["" if value == usual else fact_of(value) for value in (mine, theirs)]
            self.row("room", name, shown[0], shown[1], "offline" if keep else "model")

    def graph(self) -> SceneGraph:
        """What there is in the end."""
        told = [e.span for e in (*self.entities, *self.model.relations, *self.model.unread) if e.span is not None]
        rest = [
            left
            for left in self.offline.unread
            if left.span is not None and not any(overlap(left.span, span) for span in (*told, *self.marked))
        ]
        known = {left.words for left in self.model.unread}
        return self.model.model_copy(
            update={
                **self.facts,
                "entities": tuple(self.entities),
                "relations": (*self.model.relations, *self.added_relations),
                "exclusions": (*self.model.exclusions, *self.added_exclusions),
                "unread": (
                    *self.model.unread,
                    *(left for left in rest if left.words not in known),
                ),
            }
        )


def _may_say(said: StatedRelation, subject: str, span: Span | None) -> bool:
    """Whether a relation is the model's reading of some words: quoted from there or, of that thing, from nowhere."""
    return overlap(said.span, span) if said.span is not None else said.subject == subject


def _swapped(said: StatedRelation, subject: str, targets: Sequence[str]) -> bool:
    """Whether a relation of the same two things says it the other way about."""
    return said.type in MUTUAL and said.subject in targets and subject in said.targets


def _meet(ones: Iterable[str], others: Iterable[str]) -> bool:
    """Whether two lists of targets name one that is the same; a wall is a wall, whichever it is."""
    return bool({name.partition(":")[0] for name in ones} & {name.partition(":")[0] for name in others})


def _free(category: str, taken: set[str]) -> str:
    """An id for one more of a category."""
    n = 1
    while (name := category if n == 1 else f"{category}-{n}") in taken:
        n += 1
    return name


def _sum(things: Sequence[Entity]) -> tuple[int, int] | None:
    counts = [thing.count for thing in things]
    known = [count for count in counts if count is not None]
    return (sum(low for low, _ in known), sum(high for _, high in known)) if known and None not in counts else None
