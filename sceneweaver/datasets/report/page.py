"""``report.html``: what a data set is made of, in one file that loads nothing from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

from sceneweaver.report.html import esc
from sceneweaver.scene import InputError, write_atomic

from ..engines import open_dataset, read_records
from . import sections
from .collect import PICTURES, Gathered, gather

NAME = "report.html"


def write_report(
    path: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    pictures: int = PICTURES,
    workers: int = 1,
) -> Path:
    """Write the report of a data set, packed or still being made.

    Args:
        path: the data set.
        out: the file; None: ``report.html`` in the data set.
        pictures: scenes that are drawn, at most; each takes about 12 kB.
        workers: processes that read scenes, where there are many.

    Returns:
        Where it was written.

    Raises:
        InputError: no data set, or nothing is made yet.
        MissingDependencyError: when pyarrow is not installed.
    """
    dataset = open_dataset(Path(path))
    folder = dataset.folder
    found = gather(folder, dataset.spec.product, pictures=pictures, workers=workers)
    if not found.numbers["requests"]:
        raise InputError(f"{folder.path}: nothing is made yet; try again when the first block is there")
    verification = folder.path / "verification.json"
    whole = folder.table(dataset.spec.product).is_file()
    verified = json.loads(verification.read_bytes()) if verification.is_file() and whole else None
    target = folder.path / NAME if out is None else Path(out)
    write_atomic(target, page(dataset.spec.name, found, read_records(folder), verified, whole))
    return target


def page(
    name: str,
    found: Gathered,
    records: Sequence[Mapping[str, Any]] = (),
    verification: Mapping[str, Any] | None = None,
    whole: bool = True,
) -> str:
    """The text of the page."""
    script, style = _web("report.js"), _web("report.css")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data:"
    body = "".join(
        (
            sections.header(name, found.numbers, verification, whole),
            sections.wall(found),
            sections.contents(found),
            sections.places(found),
            sections.together(found),
            sections.relations(found),
            sections.shells(found),
            sections.coverage(found),
            sections.gates(found),
            sections.near_duplicates(found),
            sections.progress(records),
        )
    )
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{esc(name)}: data set</title><style>{style}</style></head>"
        f"<body><main>{body}</main><script>{script}</script></body></html>\n"
    )


def _web(name: str) -> str:
    return resources.files(__package__ or "").joinpath("web", name).read_text(encoding="utf-8")
