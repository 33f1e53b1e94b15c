"""What the worker processes do: each job takes plain data and scenes, and gives them back."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from sceneweaver.scene import Scene

from . import jobs_homes
from .job import Job, drawing_device, report_of
from .jobs_edits import edit, exact

EXPLAINED_BY = 64
"""Layouts that are looked for before it is said why there is none."""


def design(job: Job, *, prompt: str, out: str, **options: Any) -> dict[str, Any]:
    """A room from a request in words, written into a folder."""
    from sceneweaver.agent import design as make
    from sceneweaver.agent.memory import Step

    steps = options["steps"]

    def said(step: Step) -> None:
        job.say(step.number, steps, step_words(step, steps))

    job.say(0, steps, "the request is read")
    result = make(prompt, out=out, device=job.device, said=said, stop=job.stop, **options)
    return {
        "scene": result.scene,
        "report": result.report.to_dict(),
        "review": result.review.model_dump(mode="json"),
        "steps": [step_words(step, steps) for step in result.steps],
        "notes": list(result.notes),
        "unmet": list(result.unmet),
        "undone": list(result.undone),
        "finished": result.finished,
        "model": result.models.to_dict() if result.models else None,
    }


def step_words(step: Any, most: int) -> str:
    """A step of the agent as one line."""
    what = f"{step.call.tool} {'kept' if step.accepted else 'not kept'}" if step.call else "nothing to do"
    return f"step {step.number} of {most}: {what}, {step.objects} objects, {step.violations} violations"


def check(job: Job, *, scene: Scene, physics: bool = False, openable: bool = False) -> dict[str, Any]:
    """The judge's report."""
    from sceneweaver.verify import check as judge

    return judge(scene, physics=physics, openable=openable).to_dict()


def refine(job: Job, *, scene: Scene, init: str, candidates: int, seed: int) -> dict[str, Any]:
    """The best of many layouts."""
    from sceneweaver.explain import refine as lay_out

    def progress(done: int, total: int, valid: int, _: float) -> None:
        job.say(done, total, f"{done} of {total} layouts refined, {valid} valid")

    solution = lay_out(
        scene,
        candidates=candidates,
        seed=seed,
        init=init,
        device=job.device,
        time_limit=0.8 * job.seconds,
        progress=progress,
    )
    notes = ["stopped by the time limit"] if solution.timed_out else []
    return {
        "scene": solution.best,
        "report": report_of(solution.best),
        "moves": [],
        "notes": notes + _lines(solution.explanation),
        "valid": int((solution.status == 0).sum()),
    }


def repair(job: Job, *, scene: Scene, relations: bool, seed: int) -> dict[str, Any]:
    """The scene with its objects moved as little as makes it valid."""
    from sceneweaver.repairs import repair_report

    done = repair_report(scene, relations=relations, seed=seed, device=job.device, time_limit=0.8 * job.seconds)
    notes = [*done.notes, *(["stopped by the time limit"] if done.timed_out else []), *_lines(done.explanation)]
    return {
        "scene": done.scene,
        "report": report_of(done.scene),
        "moves": [asdict(m) for m in done.moves],
        "notes": notes,
    }


def explain(job: Job, *, scene: Scene, seed: int) -> dict[str, Any]:
    """Whether the scene has a valid layout at all, and if not, what stands against it."""
    from sceneweaver.explain import refine as lay_out

    solution = lay_out(scene, candidates=EXPLAINED_BY, seed=seed, device=job.device, time_limit=0.8 * job.seconds)
    return {
        "found": int((solution.status == 0).sum()),
        "tried": int(solution.candidates),
        "timed_out": bool(solution.timed_out),
        "lines": _lines(solution.explanation),
    }


def render(
    job: Job, *, scene: Scene, views: Sequence[str], width: int, height: int
) -> list[tuple[str, int, int, bytes]]:
    """Pictures as PNG: (view, width, height, data)."""
    from sceneweaver.render import draw_rooms, draw_top
    from sceneweaver.verify import check as judge

    pictures: dict[str, Any] = {}
    if "plan" in views:
        judged = judge(scene, walkable=False)
        pictures["plan"] = draw_top(scene, width=width, violations=judged.violations, valid=judged.valid)
    drawn = [view for view in views if view != "plan"]
    for k, view in enumerate(drawn):
        job.say(k, len(drawn), f"drawing {view}")
        pictures |= draw_rooms(scene, None, (view,), width, height, device=drawing_device(job.device))
    out = []
    for view in views:
        content = io.BytesIO()
        pictures[view].save(content, format="PNG", optimize=True)
        out.append((view, *pictures[view].size, content.getvalue()))
    return out


def export(job: Job, *, scene: Scene, folder: str, formats: Sequence[str], textures: bool) -> dict[str, str]:
    """Files for other tools, in a folder; the file of each format."""
    done = {}
    if "scene" in formats:
        scene.save(Path(folder, "scene.json"))
        done["scene"] = "scene.json"
    others = [name for name in formats if name != "scene"]
    if others:
        from sceneweaver.export import export_scene

        files = export_scene(scene, folder, others, textures=textures)
        done |= {name: path.relative_to(folder).as_posix() for name, path in files.items()}
    return done


def furniture(job: Job, *, words: str | None) -> dict[str, Any]:
    """What can be added by words, with usual sizes, and the kinds of rooms that are known."""
    from .furniture import listing

    return listing(words)


def _lines(text: str | None) -> list[str]:
    return text.splitlines() if text else []


JOBS: Mapping[str, Callable[..., Any]] = {
    each.__name__: each for each in (design, edit, exact, check, refine, repair, explain, render, export, furniture)
} | jobs_homes.JOBS
"""All jobs by name."""

LONG_RUNNERS = ("design", *jobs_homes.LONG_RUNNERS)
"""Jobs that watch their time and their stop themselves, and end in good order."""
