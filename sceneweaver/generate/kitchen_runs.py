"""Whether a request sets a kitchen out in two runs, and what such a kitchen has no floor for."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence

from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph

WORDS = ("galley", "corridor")
"""Words of a kitchen that is set out so."""

WASHED = ("sink", "dishwasher")
"""Items of a run at which one washes: on one side; what one cooks at is on the other."""

WALLS = frozenset(
    frozenset(pair) for pair in (("left", "right"), ("near", "far"), ("north", "south"), ("east", "west"))
)
"""Walls that are opposite each other, as requests name them."""


def in_two_runs(brief: SceneGraph, categories: Collection[str]) -> bool:
    """Whether a request sets units out in two runs: by the word of its room, by rows at two walls, by what is opposite
    what, or by the walls that it names.

    Args:
        brief: the request.
        categories: of the units of a run; empty: there is none.
    """
    if not categories:
        return False
    if any(word in brief.room_words.lower() for word in WORDS):
        return True
    units = [a for a in brief.arrangements if brief.entity(a.entity) is None]
    if any(a.pattern == "walls" or (a.pattern == "rows" and a.rows == 2) for a in units):
        return True
    pieces = {e.id for e in brief.entities if any(c == e.category or c.endswith(f"_{e.category}") for c in categories)}
    if any(r.type == "opposite" and r.targets and {r.subject, *r.targets} <= pieces for r in brief.relations):
        return True
    named = {r.targets[0].partition(":")[2] for r in brief.relations if r.subject in pieces and at_wall(r.targets)}
    return any(frozenset(pair) in WALLS for pair in itertools.combinations(sorted(named), 2))


def run_categories(room_type: RoomType) -> frozenset[str]:
    """The categories of the units of a kind of room that stand in a run."""
    return frozenset(name for item in room_type.items if item.row == "run" for name in item.what)


def galley_spared(room_type: RoomType, brief: SceneGraph, roles: dict[str, tuple[str, ...]]) -> frozenset[str]:
    """The items of a kitchen for which there is no floor between two runs, and no corner: the table with its chairs
    and the corner unit, with what hangs there, where the request does not name them."""
    if not in_two_runs(brief, run_categories(room_type)):
        return frozenset()
    taken = {name for items in roles.values() for name in items}
    hosts = {item.with_ for item in room_type.items}
    gone = {
        item.id
        for item in room_type.items
        if item.id not in taken
        and ((item.row == "run" and _in_corner(item.place)) or (item.top == "dining" and item.id in hosts))
    }
    while more := {item.id for item in room_type.items if item.with_ in gone and item.id not in gone | taken}:
        gone |= more
    return frozenset(gone)


def sides_meant(brief: SceneGraph, room_type: RoomType) -> SceneGraph:
    """A request in which a unit "on the opposite side" is opposite the other run, and not opposite its own neighbour:
    "oven and hob on this side, sink and freezer on the other"."""
    units = run_categories(room_type)
    if not in_two_runs(brief, units):
        return brief
    washed = {name for item in room_type.items if item.id in WASHED for name in item.what}
    runs = {e.id: e.category in washed for e in brief.entities if e.category in units}
    relations = list(brief.relations)
    for k, said in enumerate(relations):
        names = [name for name in (said.subject, *said.targets) if name in runs]
        if said.type != "opposite" or "side" not in said.words or len(names) != 2 or runs[names[0]] != runs[names[1]]:
            continue
        other = next((name for name, wet in runs.items() if wet != runs[said.subject]), None)
        if other is not None:
            relations[k] = said.model_copy(update={"targets": (other,)})
    return brief.model_copy(update={"relations": tuple(relations)})


def at_wall(targets: Sequence[str]) -> bool:
    """Whether a relation is to a wall that is named."""
    return bool(targets) and targets[0].startswith("wall:")


def _in_corner(places: Sequence) -> bool:
    return any(place.type == "in_corner" for place in places)


__all__ = ["at_wall", "galley_spared", "in_two_runs", "run_categories", "sides_meant"]
