"""Two readings of one request: where they disagree, and what of the offline reader's stays where a model's is used."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..model import SceneGraph, Span, StatedRelation
from .disagreements import Disagreement, fact_of, overlap
from .relations import HOLDING
from .union_things import UnionThings

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


class _Union(UnionThings):
    """Goes through all that both read."""

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


__all__ = ["united"]
