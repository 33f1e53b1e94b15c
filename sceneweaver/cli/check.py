"""``sceneweaver check``."""

from __future__ import annotations

from pathlib import Path

import typer

from sceneweaver.io import write_atomic
from sceneweaver.scene import InputError, Scene

from .clock import clock
from .exit_codes import NOT_VALID
from .output import headline, list_files, list_violations, print_json, relations_line
from .render import require_png
from .streams import no_chatter


def run_check(
    source: Path,
    *,
    as_json: bool,
    metrics: Path | None,
    meshes: Path | None,
    picture: Path | None,
    physics: bool,
    openable: bool,
    robot_radius: float | None,
    time_limit: float | None,
    began: float,
) -> int:
    """Judge a scene file; the time limit [s] counts from ``began``, by ``time.monotonic()``."""
    if picture is not None:
        require_png(picture, "--picture")
    if meshes is not None and not meshes.is_dir():
        raise InputError(f"--meshes: {meshes} is no folder; give the one that holds the mesh files")
    scene = Scene.load(source)
    from sceneweaver.verify import check
    from sceneweaver.verify.walkable import RADIUS

    with clock(time_limit, began) as until:
        with no_chatter():
            radius = RADIUS if robot_radius is None else robot_radius
            options = {"meshes": meshes, "physics": physics, "openable": openable, "robot_radius": radius}
            report = until.needed("check", lambda: check(scene, **options))
        if metrics is not None:
            write_atomic(metrics, report.to_json() + "\n")
        if picture is not None:
            from sceneweaver.render import save_top

            png = picture
            until.extra(str(png), lambda: save_top(scene, png, violations=report.violations, valid=report.valid))
    code = until.code(0 if report.valid else NOT_VALID)
    if as_json:
        print_json(report.to_dict())
        return code
    headline(scene.id, report.valid, f"{report.placed} of {report.requested} objects, {relations_line(report)}")
    list_violations(report)
    if report.walkable_share is not None and report.reachable_share is not None:
        floor = f"  {report.walkable_share:.0%} of the floor walkable, {report.reachable_share:.0%} of it in reach"
        floor += "" if report.robot_radius is None else f" for a robot of radius {report.robot_radius:g} m"
        share = report.openable_share
        typer.echo(floor + ("" if share is None else f"; {share:.0%} of doors, drawers and lids open"))
    if report.stability is not None:
        moved, shift = report.stability["moved_over_0_01m"], report.stability["mean_shift_m"]
        typer.echo(
            f"  in 3 s of physics {moved:.1%} of the movable objects move over 1 cm, {1000 * shift:.2f} mm on average"
        )
    for warning in report.warnings:
        typer.echo(f"  note: {warning}")
    until.tell()
    list_files([path for path in (metrics, picture) if path is not None and str(path) not in until.left_out])
    return code
