"""Lamps that a request has on a bed or a seat: people mean the table beside it."""

from __future__ import annotations

from sceneweaver.assets.roles import groups_above, has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import Entity, SceneGraph, StatedRelation

BESIDE = ("next_to", "near", "flanking", "at", "left_of", "right_of", "at_head", "side_by_side")
"""Relations of a table to the bed or seat that it goes with."""


def lamps_beside(brief: SceneGraph) -> SceneGraph:
    """A request whose lamps for tables stand on the tables beside what they are said to be on, or near that where it
    names no table: "each bed with a nightstand and a lamp on it"."""
    relations = tuple(_beside(said, brief) for said in brief.relations)
    return brief if relations == brief.relations else brief.model_copy(update={"relations": relations})


def _beside(said: StatedRelation, brief: SceneGraph) -> StatedRelation:
    lamp, under = brief.entity(said.subject), [brief.entity(name) for name in said.targets]
    if said.type != "on" or lamp is None or len(under) != 1 or under[0] is None:
        return said
    if "lighting" not in groups_above(lamp.category) or category_named(lamp.category).mount[0] != "surface":
        return said
    if not {"bed_group", "seating"} & groups_above(under[0].category):
        return said
    table = _table_of(under[0], brief)
    if table is None:
        return said.model_copy(update={"type": "near"})
    return said.model_copy(update={"targets": (table.id,)})


def _table_of(one: Entity, brief: SceneGraph) -> Entity | None:
    """The table beside a bed or a seat that a request names; for a bed any that is meant for one."""
    told = [r.subject for r in brief.relations if r.type in BESIDE and one.id in r.targets]
    tables = [e for e in brief.entities if has_role(e.category, "table_of_seat", "bedside")]
    beds = "bed_group" in groups_above(one.category)
    own = [e for e in tables if e.id in told] or [e for e in tables if beds and has_role(e.category, "bedside")]
    return own[0] if own else None


__all__ = ["lamps_beside"]
