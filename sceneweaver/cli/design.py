"""``sceneweaver design`` and ``demo``: from a request in words to a folder with a room."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.runtime.deadline import stoppable
from sceneweaver.scene import InputError

from .exit_codes import NOT_VALID, UNFINISHED
from .model_options import announce, request_of, told
from .output import headline, list_files, list_violations, print_json, relations_line
from .streams import no_chatter, spoken

if TYPE_CHECKING:
    from sceneweaver.agent import Result
    from sceneweaver.agent.memory import Step

DEMO = "a bedroom for a teenager with a desk by the window"
"""What ``make demo`` asks for."""

REPORT = "report.html"

TRANSCRIPT = "llm/transcript.md"
"""What a model thought, where one did."""


def run_design(prompt: str, out: Path, options: Mapping[str, Any], *, as_json: bool, began: float) -> int:
    """Design a room into a folder.

    Returns:
        0 when all that was asked for is so and written, 3 when the room is not so or a part of the program broke down,
        5 when it is so, and time or a signal left out some of the rest.

    Args:
        prompt: the request.
        out: the folder.
        options: of the design; None stands for its default.
        as_json: whether to print one JSON object alone.
        began: the moment of ``time.monotonic()`` [s] from which the time limit counts.
    """
    given = {name: value for name, value in options.items() if value is not None}
    prompt = request_of(prompt, given.get("replay") or given.get("start"))
    if out.suffix in (".json", ".html", ".png", ".glb") or out.is_file():
        raise InputError(f"--out: {out} is no folder; give a folder")
    if not as_json:
        announce(given)
    with no_chatter(), stoppable(ready=False) as stop:
        from sceneweaver.agent import design

        told_first: list[Result] = []

        def ready(first: Result, files: Sequence[str]) -> None:
            with suppress(OSError), spoken():  # nobody may listen
                if told_first:
                    typer.echo("  can be opened now; files for other tools and better pictures follow:")
                    list_files([out / name for name in files])
                else:
                    _verdict(first)
                    told_first.append(first)

        watchers = {} if as_json else {"said": _say, "ready": ready}
        result = design(prompt, out=out, began=began, stop=stop, **watchers, **given)
    code = exit_code(result)
    if as_json:
        print_json(_json(result, out, code))
        return code
    if told_first:
        _later(result, told_first[0])
    else:
        _verdict(result)
    told(result)
    typer.echo(f"  {len(result.steps)} steps, {result.seconds:.1f} s; ended: {result.finished}")
    list_files([out / name for name in _files(result, out)])
    for name in result.left_out:
        typer.secho(f"  left out for time: {out / name}", fg="yellow")
    return code


def _later(result: Result, first: Result) -> None:
    """What came to light after a result was told."""
    for text in result.undone[len(first.undone) :]:
        typer.secho(f"  undone  {text}", fg="yellow")
    for text in result.notes[len(first.notes) :]:
        typer.echo(f"  note    {text}")


def _verdict(result: Result) -> None:
    """What the room is, and what became of the request."""
    report, grades = result.report, result.review.grades
    headline(result.scene.room.type, report.valid, f"{report.placed} objects, {relations_line(report)}")
    typer.echo("  grades  " + ", ".join(f"{name} {value:.1f}" for name, value in grades.items()))
    typer.echo(f"  request {_became(result)}")
    for text in result.start.lines if result.start is not None else ():
        typer.echo(f"  start   {text}")
    list_violations(report)
    for text in result.unmet:
        typer.secho(f"  unmet   {text}", fg="yellow")
    for text in result.undone:
        typer.secho(f"  undone  {text}", fg="yellow")
    for text in result.notes:
        typer.echo(f"  note    {text}")
    if result.brief.unread:
        typer.echo("  not understood: " + ", ".join(word.words for word in result.brief.unread))


def _became(result: Result) -> str:
    """One line about the items of the request: how many there are, and of each status."""
    found = result.review.alignment.summary
    others = (
        f"{many} {name.replace('_', ' ')}" for name, many in found.items() if name not in ("total", "met") and many
    )
    return ", ".join([f"{found['met']} of {found['total']} as asked", *others])


def exit_code(result: Result) -> int:
    """How the command ends that led to a result."""
    if not result.report.valid or result.unmet or result.broken:
        return NOT_VALID
    return UNFINISHED if result.undone else 0


def _files(result: Result, out: Path) -> list[str]:
    """What was written, by paths inside the folder."""
    return [*result.files, *([TRANSCRIPT] if (out / TRANSCRIPT).exists() else [])]


def _say(step: Step) -> None:
    """One line on stderr for each step."""
    mean = sum(step.after.values()) / max(1, len(step.after))
    verb = "kept" if step.accepted else "rolled back"
    tool = step.call.tool if step.call else "-"
    by = f", planned by {step.plan.by}" if step.plan else ""
    text = f"step {step.number}: {tool:<16} {verb:<12} {step.objects:>3} objects, grade {mean:4.1f}"
    with suppress(OSError), spoken():
        typer.echo(f"{text}, {step.seconds:.1f} s{by}", err=True)


def _json(result: Result, out: Path, code: int) -> dict[str, Any]:
    return {
        "valid": result.report.valid,
        "satisfied": result.satisfied,
        "exit_code": code,
        "objects": result.report.placed,
        "grades": result.review.grades,
        "unmet": list(result.unmet),
        "undone": list(result.undone),
        "notes": list(result.notes),
        "unread": [word.words for word in result.brief.unread],
        "steps": [step.model_dump(mode="json") for step in result.steps],
        "seconds": round(result.seconds, 3),
        "finished": result.finished,
        "files": [str(out / name) for name in _files(result, out)],
        "left_out": [str(out / name) for name in result.left_out],
        "models": result.models.to_dict() if result.models is not None else None,
        "start": result.start.to_dict() if result.start is not None else None,
        "metrics": result.report.to_dict(),
    }
