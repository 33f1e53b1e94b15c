"""``sceneweaver design`` of whole homes, ``plan``, and ``check`` of a home."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.home import Home
from sceneweaver.io import own_folder, write_atomic
from sceneweaver.runtime.deadline import stoppable
from sceneweaver.runtime.options import DesignOptions, defaults_of
from sceneweaver.scene import InputError

from .clock import clock
from .exit_codes import NOT_VALID, UNFINISHED
from .output import headline, list_files, print_json
from .streams import no_chatter, spoken

if TYPE_CHECKING:
    from sceneweaver.furnish import HomeResult
    from sceneweaver.plans import PlanReport
    from sceneweaver.verify.home import HomeReport

OF_HOMES = ("seed", "steps", "candidates", "device", "time_limit", "pictures", "export", "clutter")
"""Options of `design` that the design of a home takes."""

MOST_LINES = 12
"""Violations that are listed."""


def wants_home(prompt: str, *, home: bool | None, options: Mapping[str, Any]) -> bool:
    """Whether a request is designed as a whole home: as the flags say, else as it is read."""
    if home is not None:
        return home
    if not prompt.strip() or options.get("replay") or options.get("start"):
        return False
    from sceneweaver.furnish import asks_for_home

    return asks_for_home(prompt)


def run_design_home(prompt: str, out: Path, options: Mapping[str, Any], *, as_json: bool, began: float) -> int:
    """Design a home into a folder; the exit code is that of `design`."""
    usual = {name: value for name, value in defaults_of(DesignOptions).items() if value is not None}
    given = {name: value for name, value in options.items() if value is not None}
    for name, value in given.items():
        if name not in OF_HOMES and usual.get(name) != value:
            flag = name.replace("_", "-")
            raise InputError(f"--{flag}: homes are designed without it; leave it out, or give --room for one room")
    if out.suffix in (".json", ".html", ".png", ".glb") or out.is_file():
        raise InputError(f"--out: {out} is no folder; give a folder")
    chosen = {name: given[name] for name in OF_HOMES if name in given}

    def said(line: str) -> None:
        with suppress(OSError), spoken():
            typer.echo(f"  {line}", err=True)

    with no_chatter(), stoppable(ready=True) as stop:
        from sceneweaver.furnish import design_home

        result = design_home(prompt, out=out, began=began, stop=stop, said=None if as_json else said, **chosen)
    code = exit_code(result)
    if as_json:
        print_json(_json(result, out, code))
        return code
    rooms = [room for room in result.rooms.values() if room.scene is not None]
    floor = sum(result.plan_report.areas.values())
    headline("home", result.valid, f"{len(rooms)} rooms, {floor:.0f} m2, {result.style}")
    for name, room in result.rooms.items():
        grade = f"{room.review.total:4.1f}" if room.review is not None else "   -"
        objects = len(room.scene.objects) if room.scene is not None else 0
        typer.echo(f"  {grade}  {name}: {objects} objects; {room.request}")
    _access(result.report)
    if result.demands:
        told = ", ".join(f"{sum(d.status == s for d in result.demands)} {s}" for s in result.shares)
        typer.echo(f"  {result.alignment:4.1f}  of 10 for what was asked: {len(result.demands)} demands, {told}")
    for text in result.unmet:
        typer.secho(f"  unmet   {text}", fg="yellow")
    for text in result.undone:
        typer.secho(f"  undone  {text}", fg="yellow")
    for text in result.notes:
        typer.echo(f"  note    {text}")
    for text in result.remarks:
        typer.echo(f"  said    {text} (no demand)")
    _violations(result.report)
    typer.echo(f"  {result.seconds.get('total', 0.0):.1f} s")
    list_files([out / name for name in result.files])
    return code


def run_plan(
    source: Path,
    out: Path,
    *,
    seed: int,
    candidates: int,
    count: int,
    profile: str,
    device: str,
    time_limit: float | None,
    as_json: bool,
    began: float,
) -> int:
    """Solve the plan of a programme, and draw the best ones into a folder."""
    from sceneweaver.plans import Programme, envelope_for

    programme = Programme.load(source)
    if out.suffix or out.is_file():
        raise InputError(f"--out: {out} is no folder; give a folder")
    with clock(time_limit, began) as until:
        with no_chatter():
            from sceneweaver.plans.solve import solve_plans
            from sceneweaver.plans.solve_solution import COMPARED

            solution = until.needed(
                "plans",
                lambda: solve_plans(
                    programme,
                    envelope_for(programme, seed),
                    candidates=candidates,
                    seed=seed,
                    profile=profile,
                    device=device,
                    time_limit=until.for_search(2.0),
                ),
            )
        plans = solution.ranked(max(count, COMPARED))[:count]
        out.mkdir(parents=True, exist_ok=True)
        files = [path for number, plan in enumerate(plans) for path in _drawn(out, number, *plan)]
    valid = [report for _, report in plans if report.valid]
    code = until.code(0 if valid else NOT_VALID)
    found = len(solution.valid)
    if as_json:
        rows = [{**report.to_dict(), "home": str(out / _name(n))} for n, (_, report) in enumerate(plans)]
        print_json({"valid": found, "candidates": candidates, "plans": rows, "explanation": solution.explanation})
        return code
    headline(programme.name, bool(valid), f"{found} of {candidates} plans keep all rules")
    for number, (_, report) in enumerate(plans):
        text = ", ".join(dict.fromkeys(v.rule for v in (report.soft if report.valid else report.violations)))
        typer.echo(
            f"  {_name(number)}: {sum(report.areas.values()):.0f} m2, cost {report.cost:.3f}; {text or 'all kept'}"
        )
    if not valid and solution.explanation:
        typer.secho(f"  {solution.explanation}", fg="yellow")
    until.tell()
    list_files(files)
    return code


def run_check_home(
    source: Path,
    *,
    programme: Path | None,
    profile: str,
    as_json: bool,
    metrics: Path | None,
    physics: bool,
    openable: bool,
    robot_radius: float | None,
    time_limit: float | None,
    began: float,
) -> int:
    """Judge a home: its plan by a profile of rules, its rooms, and what joins them."""
    home = Home.load(source)
    from sceneweaver.plans import Programme, check_plan
    from sceneweaver.verify.home import check_home
    from sceneweaver.verify.home.floors import RADIUS

    asked = None if programme is None else Programme.load(programme)
    with clock(time_limit, began) as until:
        with no_chatter():
            plan = check_plan(home, asked, profile)
            radius = RADIUS if robot_radius is None else robot_radius
            report = until.needed(
                "check", lambda: check_home(home, plan, robot_radius=radius, physics=physics, openable=openable)
            )
        if metrics is not None:
            write_atomic(metrics, report.to_json() + "\n")
    code = until.code(0 if report.valid else NOT_VALID)
    if as_json:
        print_json(report.to_dict())
        return code
    furnished = len(report.rooms)
    headline(home.id, report.valid, f"{len(home.rooms)} rooms, {furnished} furnished, plan {_kept(plan)}")
    _access(report)
    _violations(report)
    for violation in plan.violations[:MOST_LINES]:
        typer.secho(f"  plan    {violation.rule}: {violation.detail}", fg="red")
    until.tell()
    list_files([metrics] if metrics is not None else [])
    return code


def exit_code(result: HomeResult) -> int:
    """How the command ends that led to a home."""
    if not result.valid or result.unmet or result.broken:
        return NOT_VALID
    return UNFINISHED if result.undone else 0


def _drawn(out: Path, number: int, home: Home, report: PlanReport) -> list[Path]:
    """Write one plan: the home, its drawing and its verdict."""
    from sceneweaver.render.home import draw_plan

    own_folder(out)
    home.save(out / _name(number))
    drawing = out / f"plan_{number:02d}.svg"
    write_atomic(drawing, draw_plan(home))
    return [out / _name(number), drawing]


def _name(number: int) -> str:
    return f"plan_{number:02d}.json"


def _kept(plan: PlanReport) -> str:
    return "keeps all rules" if plan.valid else f"breaks {len(plan.violations)} rules"


def _access(report: HomeReport) -> None:
    access = report.access
    text = f"  a base of {access.robot_radius:g} m reaches {access.walkable_share:.0%} of the floor from the entrance"
    typer.echo(f"{text} and {access.reachable_share:.0%} of what is used")


def _violations(report: HomeReport) -> None:
    for violation in report.violations[:MOST_LINES]:
        typer.secho(f"  {violation.kind}: {violation.detail}", fg="red")
    if (more := len(report.violations) - MOST_LINES) > 0:
        typer.echo(f"  and {more} more")


def _json(result: HomeResult, out: Path, code: int) -> dict[str, Any]:
    return {
        "valid": result.valid,
        "exit_code": code,
        **result.to_dict(),
        "files": [str(out / name) for name in result.files],
        "metrics": result.report.to_dict(),
    }
