"""The page as one file: style and scripts of the folder ``web`` go into it, and nothing is loaded from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import os
from dataclasses import replace
from functools import cache
from typing import Any

import jinja2

from sceneweaver.io import packaged, write_atomic

from . import request, sections
from .data import ReportData
from .facts import faults_of, relation_rows
from .html import clean, counted, json_block, number, picture_url
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
    return _document(data, packed, {**request.context(data), **sections.context(data, faults, rows)})


def view_html(data: ReportData) -> str:
    """A page with the 3D view alone, as large as its window; it opens without a network as well."""
    packed = pack(data.scene, relation_rows(data.scene, data.metrics), faults_of(data.metrics), data.load)
    return _document(data, packed, {"alone": True})


def _document(data: ReportData, packed: Packed, context: dict[str, Any]) -> str:
    """The whole text, with style, script, and what the view shows."""
    items = {"request": request.phrase_items(data), "seen": request.fault_items(data)}
    return rendered(
        "page.html",
        {**packed.data, **items},
        packed.meshes,
        data=data,
        scene=data.scene,
        title=data.title or data.scene.id,
        # The picture under the canvas shows until the view runs.
        still=next((data.pictures[n] for n in ("corner", "top", "top_annotated") if n in data.pictures), None),
        **context,
    )


def rendered(template: str, shown: dict[str, Any], meshes: str, style: str = "", **context: Any) -> str:
    """A page with a 3D view as one text.

    Args:
        template: Name of the template in the folder ``web``.
        shown: What the view shows, for JSON.
        meshes: Its meshes, packed.
        style: Style sheet of that folder on top of the common one.
        context: All else that the template asks for.
    """
    script = _script()
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    return (
        _templates()
        .get_template(template)
        .render(
            policy=f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data:; "
            "base-uri 'none'; form-action 'none'",
            style=_text("style.css") + (_text(style) if style else ""),
            facts_json=json_block("scene-data", shown),
            meshes=meshes,
            script=script,
            **context,
        )
    )


@cache
def _templates() -> jinja2.Environment:
    """The templates; all that they show is escaped unless it is said to be safe."""

    def source(name: str) -> str:
        return "".join(line.strip() for line in _text(name).splitlines())

    loader = jinja2.FunctionLoader(source)
    env = jinja2.Environment(loader=loader, autoescape=True, finalize=clean, undefined=jinja2.ChainableUndefined)
    env.filters |= {"words": lambda text: text.replace("_", " "), "picture": picture_url, "number": number}
    env.filters["count"] = counted
    return env


@cache
def _script() -> str:
    return '"use strict";(() => {\n' + "\n".join(_text(name) for name in _SCRIPTS) + "\n})();"


@cache
def _text(name: str) -> str:
    return packaged.text(__package__ or "", "web", name)
