"""The page as one file: style and scripts of the folder ``web`` go into it, and nothing is loaded from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import os
from dataclasses import replace
from functools import cache
from importlib import resources

from sceneweaver.scene import write_atomic

from . import models, request, sections, seen
from .data import ReportData
from .facts import faults_of, relation_rows
from .html import esc, json_block, picture_url
from .view3d import Packed, pack

_SCRIPTS = (
    "linear.js",
    "decode.js",
    "shaders.js",
    "renderer.js",
    "targets.js",
    "marks.js",
    "orbit.js",
    "panel.js",
    "request.js",
    "main.js",
)
_BUTTONS = (
    ("button-reset", "Reset view", None),
    ("button-top", "Top view", None),
    ("button-labels", "Labels", "false"),
    ("button-boxes", "Boxes", "false"),
    ("button-walls", "Hide walls", "false"),
)


def write_report(path: str | os.PathLike[str], data: ReportData) -> None:
    """Write the page under a temporary name and rename it; InputError when that cannot be done."""
    write_atomic(path, report_html(data))


def report_html(data: ReportData) -> str:
    """The page's text. It opens without a network, and only the scripts that belong to it can run in it."""
    faults = faults_of(data.metrics)
    rows = relation_rows(data.scene, data.metrics)
    packed = pack(data.scene, rows, faults, data.load)
    measured = tuple(str(w) for w in data.metrics.get("warnings") or ())
    data = replace(data, warnings=(*dict.fromkeys((*data.warnings, *measured, *packed.warnings)),))
    valid = data.metrics.get("valid") if isinstance(data.metrics.get("valid"), bool) else None
    body = "".join(
        [
            sections.header(data, valid),
            request.section(data),
            _view(data),
            sections.scores(data.review, data.metrics),
            seen.section(data),
            models.section(data),
            sections.findings(data, faults),
            sections.pictures(data),
            sections.steps(data.steps),
            sections.columns((sections.relations(rows), sections.measures(data.metrics))),
        ]
    )
    return _document(data, packed, f"<main>{body}</main>")


def view_html(data: ReportData) -> str:
    """A page with the 3D view alone, as large as its window; it opens without a network as well."""
    packed = pack(data.scene, relation_rows(data.scene, data.metrics), faults_of(data.metrics), data.load)
    return _document(data, packed, f'<main class="view-alone">{_view(data)}</main>')


def _document(data: ReportData, packed: Packed, body: str) -> str:
    """The whole text around a body, with style, script, and what the view shows."""
    script = _script()
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="color-scheme" content="light dark"><meta name="generator" content="sceneweaver">'
        f"<title>{esc(data.title or data.scene.id)}</title><style>{_style()}</style></head><body>{body}"
        f"{json_block('scene-data', {**packed.data, 'request': request.items(data), 'seen': seen.items(data)})}"
        f'<script type="text/plain" id="scene-meshes">{packed.meshes}</script>'
        f"<script>{script}</script></body></html>\n"
    )


def _view(data: ReportData) -> str:
    """The 3D view with its buttons, list and panel; the picture under the canvas shows until the view runs."""
    still = next((data.pictures[n] for n in ("corner", "top", "top_annotated") if n in data.pictures), None)
    image = f'<img class="still" src="{picture_url(still, 1100)}" alt="The room">' if still is not None else ""
    buttons = "".join(
        f'<button type="button" id="{element_id}"'
        + (f' aria-pressed="{pressed}"' if pressed else "")
        + f">{text}</button>"
        for element_id, text, pressed in _BUTTONS
    )
    return (
        '<section id="room" aria-label="Interactive 3D view"><div class="stage" id="stage">'
        f'{image}<p class="stage-note" id="stage-note">The interactive view needs JavaScript and WebGL 2.</p>'
        '<canvas id="view" tabindex="0" role="application" aria-label="3D view of the room: drag or use the arrow keys '
        'to turn, plus and minus to zoom, Home to reset, T for the top view"></canvas>'
        '<div id="labels" class="labels" aria-hidden="true"></div>'
        f'<div class="tools" role="toolbar" aria-label="View">{buttons}</div>'
        '<p class="hint">Drag to turn, scroll to zoom, shift-drag to move, click an object</p></div>'
        '<aside class="panel" id="object-panel" aria-label="Selected object" hidden></aside>'
        f'<nav class="objects" aria-label="Objects"><div class="objects-head"><h2>Objects</h2>'
        f'<span class="count">{len(data.scene.objects)}</span></div>'
        '<input id="object-search" type="search" placeholder="Filter" aria-label="Filter objects" autocomplete="off">'
        '<ul id="object-list"></ul></nav>'
        '<p id="announce" class="quiet" role="status" aria-live="polite"></p></section>'
    )


@cache
def _script() -> str:
    folder = resources.files(__package__ or "").joinpath("web")
    parts = [folder.joinpath(name).read_text(encoding="utf-8") for name in _SCRIPTS]
    return '"use strict";(() => {\n' + "\n".join(parts) + "\n})();"


@cache
def _style() -> str:
    return resources.files(__package__ or "").joinpath("web", "style.css").read_text(encoding="utf-8")
