"""What people are to see from their seats, as relations of the seats that stand by themselves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.language.vocabulary import family

from .program import Wanted

TURNED = {"see": 75.0, "face": 30.0, "not_back_to": 110.0}
"""Most angle [deg] between the front of a seat and what is seen from it, what it faces, what is not at its back."""

PLACED = ("arranged", "seated_at", "facing", "around")
"""Relations that turn a seat already."""


def turned_to_views(rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> Iterator[Grounded]:
    """The relations that turn seats to what is to be seen from them, where nothing else turns them."""
    turned = {row.subject for row in rows if row.type in PLACED}
    for view in brief.views:
        if view.kind not in TURNED:
            continue
        targets = [one for one in wanted if one.asked == view.target]
        for seat in wanted:
            free = seat.mount == "floor" and seat.support is None and family(seat.category) == "seat"
            named = seat.asked == view.entity or not view.entity
            if not free or not named or seat.id in turned or seat.parent is not None:
                continue
            params = {"degrees": TURNED[view.kind]}
            if targets and targets[0] is not seat:
                yield Grounded(view.id, "facing", seat.id, targets[0].id, params)
            elif view.target == "door":
                yield Grounded(view.id, "facing_door", seat.id, None, params)


__all__ = ["turned_to_views"]
