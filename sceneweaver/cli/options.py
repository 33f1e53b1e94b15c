"""Options that commands share."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Annotated

import typer


def device_name(value: str) -> str:
    """A name of a device, checked."""
    if not re.fullmatch(r"auto|cpu|cuda(:(\d+|all))?", value):
        raise typer.BadParameter(f"'{value}' is not a device; give auto, cpu, cuda, cuda:0 or cuda:all")
    return value


def positive_seconds(value: float | None) -> float | None:
    """A number of seconds, checked."""
    if value is not None and not (math.isfinite(value) and value > 0):
        raise typer.BadParameter(f"{value} is not a number of seconds above 0")
    return value


Input = Annotated[Path, typer.Argument(metavar="IN", help="A scene.json.", show_default=False)]
Out = Annotated[
    Path,
    typer.Option(
        "--out", "-o", metavar="OUT", help="A folder, or a .json file for the scene alone.", show_default=False
    ),
]
Png = Annotated[Path, typer.Option("--out", "-o", metavar="PNG", help="The picture.", show_default=False)]
Picture = Annotated[bool, typer.Option("--picture/--no-picture", help="Draw the annotated top view.")]
Candidates = Annotated[int, typer.Option(min=1, help="How many layouts are refined at once.")]
Seed = Annotated[int, typer.Option(min=0, max=2**32 - 1, help="Equal seeds give equal results.")]
Device = Annotated[str, typer.Option(callback=device_name, metavar="auto|cpu|cuda[:k|:all]", help="Where to compute.")]
TimeLimit = Annotated[
    float | None,
    typer.Option(
        callback=positive_seconds,
        help="Seconds that all may take, files included; what is done by then is written.",
        show_default=False,
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]
