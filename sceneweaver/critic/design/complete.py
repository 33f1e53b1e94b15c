"""Whether a room has what people look for in its kind of room."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from sceneweaver.knowledge.complete import expected_of

from ..grade import Finding
from ..survey import Survey
from .breach import breach
from .measure import applies

WET = frozenset(("bathroom", "guest_toilet"))
"""Rooms that have a window or tiles."""


def faults(survey: Survey) -> Iterator[Finding]:
    """One breach with all that is missed."""
    room = survey.room_type.name
    if not applies(survey, "complete_for_its_kind") or survey.brief.only or survey.brief.density == "sparse":
        return
    have = Counter(b.item.category for b in survey.bodies)
    missed = [
        row.why
        for row in expected_of(room)
        if (not row.where or any(have[c] for c in row.where)) and sum(have[c] for c in row.what) < row.count
    ]
    if room in WET and not survey.placed.windows and not tiled(survey):
        missed.append("window and no tiles")
    if missed:
        yield breach(
            "complete_for_its_kind",
            (),
            f"{len(missed)} of what such a room has is missed: no {', no '.join(missed)}",
            measured=float(len(missed)),
            weight=min(4.0, 0.6 + 0.4 * len(missed)),
            suggestion=f"add {', '.join(missed)}",
        )


def tiled(survey: Survey) -> bool:
    """Whether walls of the room have tiles."""
    finish = survey.scene.room.finish
    return finish is not None and finish.tiles is not None
