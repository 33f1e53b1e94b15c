"""``sceneweaver repair``."""

from __future__ import annotations

from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io import write_atomic
from sceneweaver.scene import Scene

from .clock import Clock, clock, keep_for
from .exit_codes import NOT_VALID
from .output import headline, list_files, list_violations, print_json, relations_line, staged
from .refine import METRICS, PICTURE, SCENE
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.repairs import Move, Repair
    from sceneweaver.verify import Report

MOST_MOVES = 12
"""Moved objects that are listed on a terminal, the furthest first; --json has them all."""


def run_repair(
    source: Path,
    out: Path,
    *,
    relations: bool,
    soft: bool,
    drop: bool,
    candidates: int | None,
    seed: int,
    device: str,
    time_limit: float | None,
    as_json: bool,
    picture: bool,
    began: float,
) -> int:
    """Repair a scene file into a folder, or into a scene file when ``out`` ends in .json.

    The time limit [s] of all, files included, counts from ``began``, by ``time.monotonic()``.
    """
    scene = Scene.load(source)
    single = out.suffix == ".json"
    folder, scene_name = (out.parent, out.name) if single else (out, SCENE)
    names = [scene_name] if single else [scene_name, METRICS, *([PICTURE] if picture else [])]
    budget = {"soft": soft, "drop": drop, "candidates": candidates, "seed": seed, "device": device}
    with no_chatter():  # before the clock listens to signals, so that one ends a command at once that still starts
        import sceneweaver.layout  # noqa: F401 - what a repair loads where there is something to repair
        from sceneweaver.repairs import repair_report
    with clock(time_limit, began) as until, staged(folder, names) as temporary:
        with no_chatter():
            limit = until.for_search(keep_for(scene) / 2)  # it judges by itself
            done = until.needed("repair", lambda: repair_report(scene, relations=relations, time_limit=limit, **budget))
        _write(done, temporary, names, scene_name, until)
        names = [name for name in names if (temporary / name).exists()]
    keys = {scene_name: "scene", METRICS: "metrics", PICTURE: "picture"}
    files = {keys[name]: folder / name for name in names}
    code = until.code(0 if done.valid else NOT_VALID)
    if as_json:
        written = {key: str(path) for key, path in files.items()}
        print_json({"exit_code": code, **done.to_dict(), "files": written, "left_out": list(until.left_out)})
        return code
    _tell(done, until)
    list_files(list(files.values()))
    return code


def _write(done: Repair, folder: Path, names: list[str], scene_name: str, until: Clock) -> None:
    done.scene.save(folder / scene_name)
    if PICTURE in names:
        from sceneweaver.render import save_top

        (folder / PICTURE).parent.mkdir()
        after = done.after
        until.extra(
            PICTURE, lambda: save_top(done.scene, folder / PICTURE, violations=after.violations, valid=done.valid)
        )
    if METRICS in names:
        report = replace(
            done.after,
            seconds={"total": done.seconds, "check": done.after.seconds["total"]},
            seed=done.seed,
            device=done.device,
            versions={**done.after.versions, "warp-lang": version("warp-lang")},
        )
        write_atomic(folder / METRICS, report.to_json() + "\n")


def _tell(done: Repair, until: Clock) -> None:
    """What was wrong, what is, and who moved."""
    headline(done.scene.id, done.valid, f"{done.after.placed} objects, {relations_line(done.after)}")
    if done.scene is done.source:
        typer.echo("  nothing to repair; unchanged" if done.valid else "  nothing better was found; unchanged")
    else:
        _tables(done)
    list_violations(done.after)
    if done.taken_out:
        typer.echo(f"  taken out: {', '.join(done.taken_out)}")
    if done.held:
        typer.echo(f"  {len(done.held) - len(done.lost)} of {len(done.held)} soft relations that held still do")
    for note in done.notes:
        typer.echo(f"  note: {note}")
    if done.timed_out:
        typer.echo(f"  stopped by {until.deadline.stop.reason or 'the time limit'}")
    if done.explanation:
        typer.echo(f"  {done.explanation}")
    until.tell()


def _tables(done: Repair) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(title=f"repaired in {done.seconds:.2f} s on {done.device}", title_justify="left")
    table.add_column("wrong")
    for name in ("before", "after"):
        table.add_column(name, justify="right", no_wrap=True)
    for (name, before), (_, after) in zip(_counts(done.before), _counts(done.after), strict=True):
        table.add_row(name, str(before), str(after))
    moved = Table(title=_moved(done), title_justify="left")
    moved.add_column("moved")
    for name in ("m", "up m", "turned"):
        moved.add_column(name, justify="right", no_wrap=True)
    furthest = sorted(done.moves, key=lambda m: -(m.distance + abs(m.rise)))
    for move in furthest[:MOST_MOVES]:
        moved.add_row(move.id, *_numbers(move))
    if len(furthest) > MOST_MOVES:
        moved.add_row(f"and {len(furthest) - MOST_MOVES} more", "", "", "")
    Console().print(table, moved)


def _moved(done: Repair) -> str:
    return f"{len(done.moves)} of {len(done.scene.objects)} objects moved"


def _numbers(move: Move) -> tuple[str, str, str]:
    return f"{move.distance:.3f}", f"{move.rise:+.3f}" if abs(move.rise) > 5e-4 else "", f"{move.turn:+.1f}°"


def _counts(report: Report) -> list[tuple[str, Any]]:
    hard, soft = report.relations.hard, report.relations.soft
    return [
        ("collisions", report.collisions),
        ("out of bounds", report.out_of_bounds),
        ("unsupported", report.unsupported),
        ("blocked zones", report.blocked_zones),
        ("blocked openings", report.blocked_openings),
        ("hard relations unmet", hard.total - hard.satisfied),
        ("soft relations unmet", soft.total - soft.satisfied),
    ]
