"""Where beds stand: their head, and the corner of a child's bed."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import design_rules

from .. import kinds
from ..grade import Finding
from ..survey import Survey
from .breach import breach

ON_WALL = 0.3
"""Gap [m] up to which the head of a bed is on a wall."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for beds."""
    if design_rules()["bed_off_door_wall"].applies(survey.room_type.name):
        yield from _on_door_wall(survey)


def _on_door_wall(survey: Survey) -> Iterator[Finding]:
    doors = {door.wall.index for door in survey.placed.doors}
    for bed in survey.of_kind(kinds.BEDS):
        back = survey.back_wall(bed)
        if back is None or back[1] > ON_WALL or math.degrees(back[2]) > 20 or back[0].index not in doors:
            continue
        yield breach(
            "bed_off_door_wall",
            (bed.id,),
            f"the head of {bed.id} is on the wall of the door: the door is not seen from it",
            suggestion=f"put {bed.id} on the wall opposite the door",
        )
