"""A bar along the window where a request has stools there: nobody drinks coffee on a stool at a bare sill."""

from __future__ import annotations

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import Entity, StatedRelation

from .people_draft import PeopleDraft, is_vague, told

BAR = "bar_table"
"""What stools at a window are pulled up to."""

DEPTH, EACH = 0.55, 0.6
"""Depth [m] of such a bar, and its length for each of those at it."""

AT_WINDOW = ("at", "along", "below", "near", "next_to", "against", "in_front_of")
"""Stated relations of stools that are to stand along a window."""

FEW = 4
"""Stools at a window of which no number is said."""

ROOMS_WITHOUT = ("any_bed", "bathtub")
"""Roles of what is in rooms where a stool at a window is a single seat."""


def bars_at_windows(draft: PeopleDraft) -> None:
    """Puts several stools that are said to be at a window to a bar there; what was said of them is said of the bar."""
    if any(has_role(e.category, *ROOMS_WITHOUT) for e in draft.entities):
        return
    for stools in [e for e in draft.entities if e.category in ("stool", "bar_stool")]:
        at = [r for r in draft.relations if r.subject == stools.id and r.targets == ("window",) and r.type in AT_WINDOW]
        others = [r for r in draft.relations if r.subject == stools.id and r not in at and r.targets]
        if not at or others or not _several(stools):
            continue
        if is_vague(stools):
            draft.change(stools, count=(FEW, FEW), category="bar_stool")
        else:
            draft.change(stools, category="bar_stool")
        stools = draft.now(stools.id)
        count = stools.count[0] if stools.count else FEW
        bar = draft.add(BAR, 1)
        if bar is None:
            continue
        known = category_named(BAR).size
        assert known is not None
        length = min(max(round(count * EACH + 0.1, 3), known.width[0]), round(known.built[1][1], 3))
        draft.change(bar, size=(DEPTH, length, None))
        draft.relations = [r.model_copy(update={"subject": bar.id}) if r in at else r for r in draft.relations]
        # Its long side is at the wall of the window, not an end of it.
        name = f"relation-{len(draft.relations)}"
        below = StatedRelation(id=name, type="below", subject=bar.id, targets=("window",), implied=True)
        draft.relations.append(below)
        told(draft, stools, draft.now(bar.id), "at", count, False)


def _several(stools: Entity) -> bool:
    return is_vague(stools) or (stools.count is not None and stools.count[0] > 1)
