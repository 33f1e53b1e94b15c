"""The things of two readings of one request: which are the same, and what the model left out of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..graph import MOST
from ..model import Entity, Exclusion, SceneGraph, Span, StatedRelation
from .disagreements import Disagreement, count_of, head_of, overlap, size_of, thing_of
from .english import LONGEST


class UnionThings:
    """Goes through the things of both readings."""

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


__all__ = ["UnionThings"]
