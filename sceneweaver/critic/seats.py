"""Which seats belong to which table."""

from __future__ import annotations

from sceneweaver.assets.roles import has_role
from sceneweaver.rules.faults import number
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from . import kinds
from .survey import SEAT_TIES, Survey


def seat_like(body: Body) -> bool:
    """Whether people may sit on it at a table."""
    return has_role(body.item.category, "sits_at_table")


def seats_at(survey: Survey, table: Body) -> list[Body]:
    """The seats that belong to a table: tied to it, or near it and nearer to it than to any other."""
    near = survey.near(table, number("at_table"))
    return [other for other, _ in near if seat_like(other) and table_of(survey, other) is table]


def table_of(survey: Survey, seat: Body) -> Body | None:
    """The table or desk that a seat belongs to: the one it is tied to, else the nearest one close by."""
    kept = survey.__dict__.setdefault("_table_of", {})
    if seat.id not in kept:
        kept[seat.id] = _find_table(survey, seat)
    return kept[seat.id]


def _find_table(survey: Survey, seat: Body) -> Body | None:
    for kind, target in survey.ties.get(seat.id, ()):
        other = survey.placed.by_id[target]
        if kind in SEAT_TIES and other.item.category in kinds.SEATED_AT:
            return other
        if kind in CATALOGUE.with_role("seat"):
            return other  # whatever it is, the seat is meant for it
    best: tuple[float, Body] | None = None
    if not _goes_with_table(survey, seat):
        return None
    for other, gap in survey.near(seat, number("at_table")):
        if other.item.category not in kinds.SEATED_AT:
            continue
        ahead, _ = seat.local(other.centre)
        score = gap + (0.0 if ahead > 0 else number("behind"))
        if best is None or score < best[0] - 1e-4:
            best = score, other
    return best[1] if best else None


def _goes_with_table(survey: Survey, seat: Body) -> bool:
    """Whether the room's item for a seat belongs to a table, as in a waiting room it does not; seats of no item may."""
    name = survey.program.item_of.get(seat.id)
    if name is None:
        return True
    item = survey.room_type.item(name)
    others = {item.with_, *(p.to for p in item.place)}
    return any(i.id in others and set(i.what) & kinds.SEATED_AT for i in survey.room_type.items)
