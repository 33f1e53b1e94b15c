"""``comparison.html``: one table, pictures side by side, what each system's files lack."""

from __future__ import annotations

import math
import time
from functools import cache
from typing import Any

import jinja2

from sceneweaver.importers import formats
from sceneweaver.importers.own import OWN
from sceneweaver.io import packaged
from sceneweaver.report.html import clean, counted, picture_url
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import SceneWeaverError
from sceneweaver.verify import check

from .candidate import Candidate
from .compare import Comparison
from .metrics import METRICS, Metric
from .summary import Evaluation, Figure, number_text

PIXELS = 460
"""Width of a picture."""

PATIENCE = 20.0
"""Seconds that a picture may take; without it there is a line."""

_BETTER = {"more": "more is better", "less": "less is better", "": ""}


def page(found: Comparison, deadline: Deadline | None = None) -> str:
    """The page as HTML that needs nothing else.

    Args:
        found: what it shows.
        deadline: after which no more pictures are drawn.
    """
    names = ", ".join(system.name for system in found.systems)
    several = len(found.systems) > 1
    return _template().render(
        title="Systems side by side" if several else f"Scenes of {names}",
        about=f"Scenes of {names}, judged by sceneweaver {found.settings.get('version', '')}.".replace(" .", "."),
        style=packaged.text("sceneweaver.evaluation", "web", "style.css"),
        systems=[_system(system) for system in found.systems],
        rows=[_row(metric, found) for metric in METRICS],
        pictures=_pictures(found, deadline),
        assumed=any(f.assumed for system in found.systems for f in system.figures.values()),
    )


@cache
def _template() -> jinja2.Template:
    text = packaged.text("sceneweaver.evaluation", "web", "page.html")
    return jinja2.Environment(autoescape=True, finalize=clean, undefined=jinja2.StrictUndefined).from_string(text)


def _system(system: Evaluation) -> dict[str, Any]:
    told = [f"{reason} ({counted(scenes, 'scene')} of {system.judged})" for reason, scenes in system.lacks.items()]
    told += [f"{row.scene}: not judged, {row.error}" for row in system.failed[:5]]
    told += [f"not read: {line}" for line in system.refused[:5]]
    if system.cut_off:
        told.append("time was up before all scenes were judged")
    known = formats()
    said = [note for name in system.formats if name in known for note in known[name].notes]
    return {
        "name": system.name,
        "scenes": f"n = {system.judged}",
        "formats": ", ".join(f"{counted(n, 'scene')} of {_title(name)}" for name, n in system.formats.items()),
        "lacks": told,
        "notes": [*said, *(f"{note} ({counted(scenes, 'scene')})" for note, scenes in system.notes)],
    }


def _title(name: str) -> str:
    if name == OWN:
        return "our own format"
    known = formats()
    return known[name].title if name in known else name


def _row(metric: Metric, found: Comparison) -> dict[str, Any]:
    cells = [_cell(metric, system.figures[metric.key]) for system in found.systems]
    return {
        "title": metric.title,
        "better": _BETTER[metric.better],
        "definition": metric.definition,
        "source": metric.source,
        "cells": cells,
    }


def _cell(metric: Metric, figure: Figure) -> dict[str, str]:
    of = counted(figure.scenes, "scene")
    if figure.value is None:
        return {"kind": "none", "text": figure.missing, "interval": "", "of": of}
    ends = [number_text(end, metric) for end in (figure.low, figure.high) if end is not None]
    text = number_text(figure.value, metric)
    return {
        "kind": "assumed" if figure.assumed else "",
        "text": f"~ {text}" if figure.assumed else text,
        "interval": " to ".join(ends),
        "of": of,
    }


def _pictures(found: Comparison, deadline: Deadline | None) -> list[list[dict[str, str]]]:
    """Lines of pictures, one of each system in a line."""
    most = max((len(some) for some in found.shown.values()), default=0)
    none = {"system": "", "scene": "", "url": "", "alt": ""}
    return [
        [_picture(name, some[k], deadline) if k < len(some) else none for name, some in found.shown.items()]
        for k in range(most)
    ]


def _picture(system: str, candidate: Candidate, deadline: Deadline | None) -> dict[str, str]:
    shown = {"system": system, "scene": candidate.name, "url": "", "alt": "no time was left to draw it"}
    if deadline is not None and deadline.passed:
        return shown
    end = Deadline(min(time.monotonic() + PATIENCE, deadline.moment if deadline is not None else math.inf))
    try:
        with end.enforced():
            from sceneweaver.render import draw_top

            wrong, said = [], "where things are; their sizes are not in the files"
            if "sizes" not in candidate.lacks:
                report, said = check(candidate.scene, walkable=False), ""
                wrong = [v for v in report.violations if v.kind in ("collision", "out_of_bounds")]
            drawn = draw_top(candidate.scene, width=2 * PIXELS, annotated=False, violations=wrong)
            name = f"{candidate.name}: {said}" if said else candidate.name
            url = picture_url(drawn, PIXELS)
            return {**shown, "scene": name, "url": url, "alt": f"{candidate.name} from above"}
    except TimeUp:
        return shown
    except SceneWeaverError as error:
        return {**shown, "alt": f"not drawn: {error}"}
