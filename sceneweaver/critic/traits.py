"""The traits of a room that its grades follow beside its faults."""

from __future__ import annotations

import math

from sceneweaver.knowledge import RoomType
from sceneweaver.rules.grades import Traits

from .design import looks
from .survey import Survey


def traits_of(survey: Survey) -> Traits:
    """The traits of a room."""
    kinds = {body.item.category for body in survey.bodies}
    groups, ties = _known(survey.room_type)
    return Traits(groups, ties, math.log1p(len(kinds)), math.log1p(len(looks.supports(survey))))


def _known(kind: RoomType) -> tuple[float, float]:
    """Composed groups of a kind of room, and hard relations of an item."""
    ties = sum(not place.soft for item in kind.items for place in item.place)
    return float(len({item.group for item in kind.items if item.group})), ties / max(1, len(kind.items))
