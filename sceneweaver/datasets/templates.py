"""Texts and pages of a data set: templates that lie beside the modules which fill them."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import jinja2

from sceneweaver.io import packaged

ROOT = Path(__file__).parent

_FILTERS = {"words": lambda name: name.replace("_", " "), "grouped": "{:,}".format}


def render(template: str, /, **fields: Any) -> str:
    """A text in Markdown.

    Args:
        template: its path from this folder.
        fields: what it shows.
    """
    return markdown().get_template(template).render(**fields)


@cache
def markdown() -> jinja2.Environment:
    """Templates of Markdown; lines of statements leave nothing behind, and what is not given is an error."""
    loader = jinja2.FileSystemLoader(ROOT)
    found = jinja2.Environment(
        loader=loader,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )
    found.filters |= _FILTERS
    return found


@cache
def html() -> jinja2.Environment:
    """Templates of HTML, without the ends of lines; all that they show is escaped unless it is said to be safe."""
    from sceneweaver.report.html import clean  # here, as the report brings much that workers do without

    loader = jinja2.FunctionLoader(
        lambda name: "".join(
            line.strip() for line in packaged.text("sceneweaver.datasets", *name.split("/")).splitlines()
        )
    )
    found = jinja2.Environment(autoescape=True, finalize=clean, loader=loader)
    found.filters |= _FILTERS
    return found
