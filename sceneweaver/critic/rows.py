"""Whether equals stand in rows: tables of a restaurant, machines of a gym, the units of a kitchen."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator

import numpy as np

from sceneweaver.assets.roles import with_role
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding, moved
from .seats import seat_like, table_of
from .survey import QUARTER, Survey

ROW_GAP = (0.03, 0.12)
"""Offsets [m] between equals in a row that look like a mistake; less is not seen."""

PUSHED_IN = 0.06
"""Offset [m] between chairs at one table up to which they are as people leave them."""

IN_LINE = 0.15
"""Offset [m] up to which two tables stand in one row."""

FEWEST = 4
"""Equal tables from which rows are expected."""

JOINT = 0.12
"""Gap [m] between units of a kitchen that form one run."""

UNITS = with_role("kitchen_unit")


def faults(survey: Survey) -> Iterator[Finding]:
    """Rows that are uneven, or that are not there."""
    yield from _rows(survey)
    yield from _scattered(survey)
    yield from _run(survey)


def _rows(survey: Survey) -> Iterator[Finding]:
    """Three or more equals that nearly stand in line."""
    sets: dict[tuple[str, str | None], list[Body]] = defaultdict(list)
    for body in survey.standing:
        seat = seat_like(body)
        table = table_of(survey, body) if seat else None
        if body.item.category not in kinds.TALL_PLANTS and not (seat and table is None):
            sets[body.item.category, table.id if table else None].append(body)
    for (category, table), bodies in sets.items():
        if len(bodies) < (2 if table else 3):
            continue
        uneven = _uneven(bodies, table is not None)
        if uneven:
            ids = sorted({i for pair in uneven for i in pair[:2]})
            worst = max(uneven, key=lambda u: u[2])
            yield finding(
                "layout",
                "uneven_row",
                ids,
                f"{worst[0]} stands {100 * worst[2]:.0f} cm out of line with {worst[1]}",
                f"line up the {kinds.words(category)}s",
                points=min(1.5, (0.25 if table else 0.4) * len(uneven)),
                call=moved(*ids),
            )


def _uneven(bodies: list[Body], seats: bool) -> list[tuple[str, str, float]]:
    """Pairs (id, id, offset [m]) of near neighbours that nearly stand in line.

    ``seats`` at one table are compared side by side only: how far each is pushed in. Things of different sizes are in
    line where their fronts or their backs are.
    """
    centres = np.array([b.centre for b in bodies])
    yaws = np.array([b.yaw for b in bodies])
    halves = np.array([b.size[:2] for b in bodies]) / 2
    least = PUSHED_IN if seats else ROW_GAP[0]
    reach = 1.5 * max(max(b.size[:2]) for b in bodies) + 0.8
    found = []
    for body in bodies:
        ahead, aside = body.frame.to_local(centres).T
        same = np.abs(wrap_angle(yaws - body.yaw, QUARTER)) < math.radians(3)
        if seats:
            same &= np.cos(yaws - body.yaw) > 0.9
        turned = np.abs(np.cos(yaws - body.yaw)) < 0.5
        for k, (along, across) in enumerate(((aside, ahead), (ahead, aside))[: 1 if seats else 2]):
            mates = np.flatnonzero(same & (along > 0.05) & (along < reach) & (np.abs(across) < 0.2))
            if not len(mates):
                continue
            j = int(mates[np.argmin(along[mates])])
            wider = float(halves[j, 1 - k if turned[j] else k]) - body.size[k] / 2
            off = min(abs(float(across[j]) + edge * wider) for edge in (-1, 0, 1))  # a front, the middle or a back
            if least < off < ROW_GAP[1]:
                found.append((body.id, bodies[j].id, off))
    return found


def _scattered(survey: Survey) -> Iterator[Finding]:
    """Four or more equal tables of which many share no row with another."""
    for kind in (kinds.DINING, kinds.DESKS):
        tables = survey.on_floor(kind)
        if len(tables) < FEWEST:
            continue
        xy = SE2(yaw=survey.axis).to_local([b.centre for b in tables])
        gaps = np.abs(xy[:, None, :] - xy[None, :, :])
        gaps[np.arange(len(tables)), np.arange(len(tables))] = np.inf
        alone = [b.id for b, least in zip(tables, gaps.min(axis=(1, 2)), strict=True) if least > IN_LINE]
        share = len(alone) / len(tables)
        if share > 0.2:
            yield finding(
                "layout",
                "scattered",
                alone,
                f"{len(alone)} of {len(tables)} tables stand in no row with another",
                "set the tables out in rows",
                points=0.4 + 1.8 * share,
                call=moved(),
            )


def _run(survey: Survey) -> Iterator[Finding]:
    """Units of a kitchen that stand apart from all others."""
    units = survey.on_floor(UNITS)
    if len(units) < 3:
        return
    alone = [b for b in units if not any(o in units for o, _ in survey.near(b, JOINT))]
    if len(alone) <= max(1, 0.34 * len(units)):
        return
    others = [b for b in units if b not in alone] or units
    rows = [
        {"type": "side_by_side", "subject": b.id, "target": next(o for o in others if o is not b).id, "hard": False}
        for b in alone[:3]
    ]
    yield finding(
        "layout",
        "broken_run",
        (b.id for b in alone),
        f"{len(alone)} of {len(units)} kitchen units stand apart from all others",
        f"put {', '.join(b.id for b in alone[:3])} beside the other units",
        points=0.4 + len(alone) / len(units),
        call=("add_relation", {"relations": rows}),
    )
