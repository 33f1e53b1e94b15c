"""Scenes, solutions and verdicts as HTML for notebooks: a table with a top view, and the 3D view in a frame.

`sceneweaver.scene.display` names this module; nothing of it is loaded before something is shown.
"""

from __future__ import annotations

import html
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.layout import Solution
from sceneweaver.render import draw_top
from sceneweaver.report import ReportData, view_html
from sceneweaver.report.html import esc, number, picture_url
from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import Report

PICTURE = 420
"""Width [pixels] of the top view beside a table."""

LISTED = 8
"""Violations, or categories, that a table spells out."""

SMALLEST, LARGEST = 200, 4000
"""Sides [pixels] that a frame may have."""

Row = tuple[str, object]


@dataclass(frozen=True)
class Frame:
    """A page in a frame; a notebook shows it."""

    html: str

    def _repr_html_(self) -> str:
        return self.html


def summary(thing: Scene | Solution | Report) -> str:
    """A small table about a scene, a solution or a verdict, with a top view of the scene or the best layout."""
    if isinstance(thing, Report):
        return _table(_about_report(thing))
    if isinstance(thing, Solution):
        return _beside(thing.best, _about_solution(thing))
    return _beside(thing, _about_scene(thing))


def frame(
    thing: Scene | Solution, width: int = 900, height: int = 560, load: Callable[[str], Any] | None = None
) -> Frame:
    """The 3D view of a scene, or of a solution's best layout, as a frame that holds all it needs.

    Assets come from ``load``, or from the library of this user.

    Raises:
        InputError: a side is no whole number from 200 to 4000.
    """
    for name, value in (("width", width), ("height", height)):
        if isinstance(value, bool) or not isinstance(value, int) or not SMALLEST <= value <= LARGEST:
            raise InputError(f"{name}: {value!r} is not a whole number from {SMALLEST} to {LARGEST} pixels")
    page = view_html(ReportData(thing.best if isinstance(thing, Solution) else thing, load=load))
    return Frame(
        f'<iframe srcdoc="{html.escape(page)}" width="{width}" height="{height}" sandbox="allow-scripts" '
        'style="border: 0; max-width: 100%" title="3D view of the room"></iframe>'
    )


def _about_scene(scene: Scene) -> list[Row]:
    import shapely

    kinds = Counter(o.category.replace("_", " ") for o in scene.objects).most_common()
    named = [f"{count} {kind}" if count > 1 else kind for kind, count in kinds[:LISTED]]
    more = [f"{len(kinds) - LISTED} kinds more"] if len(kinds) > LISTED else []
    hard = sum(r.hard for r in scene.relations)
    area = shapely.Polygon(scene.room.outline).area
    rows: list[Row] = [
        ("scene", scene.id),
        ("room", f"{scene.room.type}, {number(area, 1)} m2, {number(scene.room.height)} m high"),
        ("objects", f"{len(scene.objects)}: {', '.join([*named, *more])}" if kinds else 0),
        ("relations", f"{hard} hard, {len(scene.relations) - hard} soft"),
    ]
    return rows + ([("dropped", ", ".join(d.id for d in scene.dropped))] if scene.dropped else [])


def _about_solution(solution: Solution) -> list[Row]:
    best = int(solution.order[0])
    rows: list[Row] = [
        ("scene", solution.source.id),
        ("valid", f"{len(solution.ranked)} of {solution.candidates} layouts"),
        ("energy of the best", f"{number(float(solution.energy[best]), 3)} m"),
        ("time", f"{number(solution.elapsed)} s on {solution.device}{', cut off' if solution.timed_out else ''}"),
    ]
    title = "what to know" if len(solution.ranked) else "why none is valid"
    return rows + ([(title, solution.explanation)] if solution.explanation else [])


def _about_report(report: Report) -> list[Row]:
    hard, soft = report.relations.hard, report.relations.soft
    wrong = sorted(report.violations, key=lambda v: not v.hard)
    rows: list[Row] = [
        ("valid", "yes" if report.valid else "no"),
        ("objects", f"{report.placed} of {report.requested}"),
        ("relations", f"{hard.satisfied} of {hard.total} hard, {soft.satisfied} of {soft.total} soft"),
    ]
    if report.walkable_share is not None:
        rows.append(("floor to walk on", f"{100 * report.walkable_share:.0f} % of what is free"))
    rows += [(v.kind.replace("_", " "), v.detail) for v in wrong[:LISTED]]
    return rows + ([("", f"and {len(wrong) - LISTED} more")] if len(wrong) > LISTED else [])


def _table(rows: Iterable[Row]) -> str:
    cells = (
        f'<tr><th style="text-align: left; vertical-align: top">{esc(name)}</th>'
        f'<td style="text-align: left">{esc(value)}</td></tr>'
        for name, value in rows
    )
    return f"<table>{''.join(cells)}</table>"


def _beside(scene: Scene, rows: Sequence[Row]) -> str:
    """A table beside the top view of a scene."""
    picture = picture_url(draw_top(scene, width=2 * PICTURE, annotated=False), PICTURE)
    image = f'<img src="{picture}" width="{PICTURE // 2}" alt="{esc(scene.id)} from above">'
    return f'<div style="display: flex; gap: 16px; align-items: flex-start">{image}{_table(rows)}</div>'
