"""Where beds stand: their head, the corner of a child's bed, the rug under them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..groups import ALL_BEDS, groups_of
from ..survey import Survey
from .breach import breach

ON_WALL = 0.3
"""Gap [m] up to which the head of a bed is on a wall."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for beds."""
    yield from _on_door_wall(survey)
    if design_rules()["child_bed_in_corner"].applies(survey.room_type.name):
        yield from _in_corner(survey)
    yield from _rugs(survey)


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
            suggestion=f"put the head of {bed.id} on another wall",
        )


def _in_corner(survey: Survey) -> Iterator[Finding]:
    """Children's beds of which neither long side is at a wall."""
    most = limit("child_bed_in_corner", "gap")
    for bed in survey.of_kind(ALL_BEDS - {"crib"}):
        gap = min(survey.clear_ahead(bed, side) for side in ("left", "right"))
        if gap > most:
            yield breach(
                "child_bed_in_corner",
                (bed.id,),
                f"both long sides of {bed.id} are open, the nearer wall is {gap:.2f} m away",
                measured=gap,
                allowed=(None, most),
                suggestion=f"put {bed.id} in a corner",
            )


def _rugs(survey: Survey) -> Iterator[Finding]:
    """Rugs under a bed that are too small or lie too far from the head."""
    beyond, under = limit("rug_beyond_bed", "beyond"), limit("rug_beyond_bed", "under")
    for group in groups_of(survey).sleepings:
        bed, rug = group.bed, group.rug
        if rug is None or bed.item.category not in kinds.BEDS or groups_of(survey).overlap(rug, bed) <= 0.0:
            continue
        (ahead, aside), (depth, width) = bed.local(rug.centre), _extent(bed, rug)
        left, right = (width / 2 + s * aside - bed.size[1] / 2 for s in (1, -1))
        covered = min(1.0, (bed.size[0] / 2 - (ahead - depth / 2)) / bed.size[0])
        least = min(left, right)
        if least < beyond - 0.05 or covered < under - 0.05:
            yield breach(
                "rug_beyond_bed",
                (rug.id, bed.id),
                f"{rug.id} reaches {least:.2f} m beyond a side of {bed.id} and lies under {covered:.0%} of it",
                measured=least,
                allowed=(beyond, None),
                suggestion=f"take a larger rug for {bed.id} and lay it under two thirds of it",
            )


def _extent(base: Body, body: Body) -> tuple[float, float]:
    """Depth and width [m] of a body's box in the axes of another."""
    turn = abs(math.cos(body.yaw - base.yaw)), abs(math.sin(body.yaw - base.yaw))
    depth, width = body.size[:2]
    return depth * turn[0] + width * turn[1], depth * turn[1] + width * turn[0]
