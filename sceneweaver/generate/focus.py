"""What all look at from tables that stand in rows: a board, a screen. Everybody sits on the side away from it."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.assets.roles import has_role
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import Arrangement

from .program import Wanted

IN_ROWS = ("row", "rows", "grid")
"""Patterns of tables whose seats all look the same way."""

SEES = ("see", "face")
"""Kinds of views that say what people look at."""

BETWEEN = 0.6
"""Way [m] behind the seats of a row, to the tables of the next."""


def focus_of(said: Arrangement, brief: SceneGraph) -> str | None:
    """The entity that those who sit at the tables of an arrangement look at, as the request says it in some way: of the
    rows, of the tables, of their seats or of everybody; None where it says nothing of it."""
    if said.pattern not in IN_ROWS or said.facing == "each other":
        return None
    if brief.entity(said.facing) is not None:
        return said.facing
    seats = {r.subject for r in brief.relations if said.entity in r.targets and _is_seat(r.subject, brief)}
    looking = {said.entity, *seats}
    told = [r.targets[0] for r in brief.relations if r.type in ("facing", "opposite") and r.subject in looking]
    told += [view.target for view in brief.views if view.kind in SEES and (not view.entity or view.entity in looking)]
    return next((name for name in told if _is_watched(name, brief)), None)


def faced_from(table: Wanted, brief: SceneGraph) -> bool:
    """Whether a table stands in rows that look at something."""
    return any(said.entity == table.asked and focus_of(said, brief) is not None for said in brief.arrangements)


def focus_in(said: Arrangement, brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Wanted]:
    """The things that the rows of an arrangement look at."""
    name = focus_of(said, brief)
    return [w for w in wanted if name is not None and w.asked == name]


def _is_watched(name: str, brief: SceneGraph) -> bool:
    one = brief.entity(name)
    if one is None or has_role(one.category, "upright_seat"):
        return False
    return has_role(one.category, "desk") or not has_role(one.category, "pulled_up_to")


def _is_seat(name: str, brief: SceneGraph) -> bool:
    one = brief.entity(name)
    return one is not None and has_role(one.category, "upright_seat")


__all__ = ["BETWEEN", "IN_ROWS", "faced_from", "focus_in", "focus_of"]
