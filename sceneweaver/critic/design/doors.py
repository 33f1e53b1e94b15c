"""Doors: what stands at their frame, and what their leaf meets as it swings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body, Opening

from ..grade import Finding
from ..survey import FLAT, Survey
from .breach import Call, breach
from .measure import along, movable

AT_FRAME = 0.5
"""Distance [m] from the wall of a door within which things are beside its frame."""


SLACK = 0.05
"""Gap [m] that may lack beside a frame."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for doors."""
    yield from _frames(survey)
    yield from _swings(survey)


def _frames(survey: Survey) -> Iterator[Finding]:
    gap, touching = limit("door_frame", "gap"), limit("door_frame", "touching")
    for door in survey.placed.doors:
        opening = (door.item.offset, door.item.offset + door.item.width)
        for body in survey.standing:
            (u0, u1), (v0, v1) = along(door, body)
            beside = max(u0 - opening[1], opening[0] - u1)
            if v0 > AT_FRAME or v1 < 0 or not -0.05 < beside < gap - SLACK or movable(body):
                continue
            yield breach(
                "door_frame",
                (body.id, door.item.id),
                f"{body.id} stands {max(0.0, beside):.2f} m from the frame of {door.item.id}",
                measured=beside,
                allowed=(gap, None),
                weight=1.0 if beside < touching else 0.5,
                suggestion=f"move {body.id} at least {gap:g} m from the frame",
                call=_off(body, door, gap),
            )


def _swings(survey: Survey) -> Iterator[Finding]:
    import shapely

    least = limit("swing_free", "gap")
    for door in survey.placed.doors:
        leaf = swing(door)
        if leaf is None:
            continue
        for row in survey.tree.query(leaf, predicate="dwithin", distance=least):
            body = survey.bodies[int(row)]
            if body.item.mount in ("surface", "ceiling") or body.z[1] <= FLAT or body.z[0] > 2.0:
                continue
            (u0, u1), (v0, _) = along(door, body)
            if v0 < AT_FRAME and (u1 < door.item.offset or u0 > door.item.offset + door.item.width):
                continue  # beside the frame, said above
            gap = float(shapely.distance(leaf, survey.footprint(body)))
            if gap < least:
                yield breach(
                    "swing_free",
                    (body.id, door.item.id),
                    f"{body.id} leaves {gap:.2f} m to the leaf of {door.item.id} as it opens",
                    measured=gap,
                    allowed=(least, None),
                    suggestion=f"move {body.id} away from {door.item.id}",
                    call=_off(body, door, 2 * least),
                )


def _off(body: Body, door: Opening, gap: float) -> Call:
    """The call that keeps something a gap [m] off the space before a door, as far as there is room."""
    row = {"type": "away_from_door", "subject": body.id, "target": door.item.id, "params": {"min": gap}, "hard": False}
    return "add_relation", {"relations": [row]}


def swing(door: Opening) -> Any:
    """The quarter disc that a leaf sweeps in plan; None where it opens outward or slides."""
    import shapely

    kind = getattr(door.item, "swing", "")
    if not kind.startswith("in-"):
        return None
    width, start = door.item.width, door.item.offset
    left = kind == "in-left"
    turns = np.linspace(0.0, math.pi / 2, 9)
    u = start + width * np.cos(turns) if left else start + width - width * np.cos(turns)
    v = width * np.sin(turns)
    hinge = door.wall.point(start if left else start + width)
    return shapely.Polygon([hinge, *(door.wall.point(float(a), float(b)) for a, b in zip(u, v, strict=True))])
