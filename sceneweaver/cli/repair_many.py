"""``sceneweaver repair`` of a folder, or of files of other systems: many scenes, one table."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io.messages import printable_line
from sceneweaver.scene import InputError

from .clock import clock
from .exit_codes import NOT_VALID, UNFINISHED
from .output import LONGEST, complain, print_json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.repairs.stream import Choice, Streamed

MOST_TOLD = 12
"""Scenes that stayed invalid that are listed on a terminal; repair.json has them all."""

CANDIDATES = 8
"""Repairs of each scene to choose from, unless something else is asked for."""

ROWS = {
    "collision": "collisions",
    "out_of_bounds": "out of bounds",
    "unsupported": "unsupported",
    "blocked_zone": "blocked zones",
    "blocked_opening": "blocked openings",
    "yaw_domain": "yaws not allowed",
    "relation": "hard relations unmet",
}


def is_single(source: Path, format_name: str) -> bool:
    """Whether a path is one scene of ours, or no file that anything else could be: then its own reader says why."""
    if format_name != "auto" or source.is_dir():
        return False
    if not source.is_file():
        return True
    with no_chatter():
        from sceneweaver.importers import format_of
        from sceneweaver.importers.own import is_own
    if is_own(source):
        return True
    try:
        format_of(source)
    except InputError:
        return True
    return False


def choose(soft: bool, options: dict[str, Any]) -> Choice:
    """How to repair many scenes."""
    from sceneweaver.repairs.stream import Choice

    return Choice(**{**options, "soft": soft, "candidates": options["candidates"] or CANDIDATES})


def run_repair_many(
    source: Path,
    out: Path,
    *,
    choice: Choice,
    format_name: str,
    assets: str,
    folder: Path | None,
    sizes: Path | None,
    jobs: int,
    limit: int | None,
    time_limit: float | None,
    as_json: bool,
    began: float,
) -> int:
    """Repair all scenes of a folder or file into a folder, from where an earlier run of the same stopped.

    Ends with `NOT_VALID` where a scene stayed invalid, with `UNFINISHED` where time was up.
    """
    if out.suffix == ".json":
        raise InputError(f"--out: {out} is a file, but there may be many scenes; give a folder")
    if not source.exists():
        raise InputError(f"{source}: no such file or folder")
    refused: list[str] = []

    def refuse(line: str) -> None:
        refused.append(line)
        complain(line)

    with no_chatter():
        from sceneweaver.importers.sizes import load_sizes
        from sceneweaver.repairs.sources import given_scenes
        from sceneweaver.repairs.stream import repair_stream

        table = None if sizes is None else load_sizes(sizes)
    with clock(time_limit, began) as until, no_chatter():
        given = given_scenes(source, format_name, on_error=refuse, assets=assets, folder=folder, sizes=table)
        named = {"path": os.fspath(source), "format": format_name, "assets": assets, "limit": limit}
        told = None if as_json else _Progress()
        done = repair_stream(
            _first(given, limit),
            out,
            choice,
            source=named,
            jobs=jobs,
            stop=lambda: until.deadline.passed,
            **({} if told is None else {"told": told}),
        )
    report = done.report
    if not report["scenes"] and not refused:
        raise InputError(f"{source}: no scene in it; say with --from what it is")
    code = UNFINISHED if not done.done else NOT_VALID if report["valid_after"] < report["scenes"] or refused else 0
    if as_json:
        print_json({"exit_code": code, "seconds": done.seconds, "refused": refused, **report, "out": str(out)})
        return code
    _tell(done, refused, out, time.monotonic() - began)
    return code


def _first(given: Any, limit: int | None) -> Any:
    from itertools import islice

    return given if limit is None else islice(given, limit)


class _Progress:
    """A line on stderr now and then."""

    def __init__(self) -> None:
        self._last = time.monotonic()

    def __call__(self, scenes: int, valid: int) -> None:
        if time.monotonic() - self._last > 5.0:
            self._last = time.monotonic()
            typer.echo(f"{scenes} scenes repaired, {valid} valid", err=True)


def _tell(done: Streamed, refused: list[str], out: Path, seconds: float) -> None:
    from rich.console import Console
    from rich.table import Table

    report = done.report
    title = f"{report['scenes']} scenes, {report['objects']} objects, {done.seconds:.1f} s of work in {seconds:.1f} s"
    table = Table(title=title, title_justify="left")
    table.add_column("wrong")
    for name in ("before", "after"):
        table.add_column(name, justify="right", no_wrap=True)
    for kind, words in ROWS.items():
        counts = [report[f"violations_{when}"][kind] for when in ("before", "after")]
        if any(counts):
            table.add_row(words, *map(str, counts))
    table.add_row("scenes valid", str(report["valid_before"]), str(report["valid_after"]))
    table.add_row("share valid", _share(report["share_valid_before"]), _share(report["share_valid_after"]))
    for key, words in (("relations", "soft relations that hold"), ("relations_nearly", "those that nearly held")):
        kept = report[key]
        table.add_row(words, str(kept["before"] if key == "relations" else 0), str(kept["after"]))
    Console().print(table)
    if report["infeasible"]:
        of_rest = _share(report["share_valid_of_feasible"])
        typer.echo(f"  {report['infeasible']} scenes have no valid layout, by proof; valid of the others: {of_rest}")
    for key, words in (("movement_moved", "moved objects"), ("movement_all", "all objects")):
        p = report[key]
        if p["p50"] is not None:
            typer.echo(f"  movement of {words}: p50 {p['p50']:.3f} m, p90 {p['p90']:.3f} m, max {p['max']:.3f} m")
    if report["relations"]["share"] is not None:
        kept, near = report["relations"], report["relations_nearly"]
        typer.echo(f"  relations kept: {kept['after']} of {kept['before']} ({_share(kept['share'])})" + _mended(near))
    if report["taken_out"]:
        typer.echo(f"  taken out: {report['taken_out']} objects")
    told = [row for row in done.scenes if not row["valid_after"] or row["taken_out"]]
    for row in told[:MOST_TOLD]:
        gone = f"without {', '.join(row['taken_out'])}: " if row["taken_out"] else ""
        typer.echo(printable_line(f"  {row['scene']}: {gone}{row['explanation'] or 'not valid'}", LONGEST))
    if len(told) > MOST_TOLD:
        typer.echo(f"  and {len(told) - MOST_TOLD} scenes more; repair.json has them")
    if refused:
        typer.echo(f"  {len(refused)} files or rooms refused")
    if not done.done:
        typer.echo("  stopped by the time limit; the same command goes on from here")
    typer.echo(f"  {out}")


def _mended(near: dict[str, Any]) -> str:
    return f"; {near['after']} of {near['before']} that nearly held do" if near["before"] else ""


def _share(value: float | None) -> str:
    return "-" if value is None else f"{100 * value:.1f} %"
