"""``sceneweaver refine`` and ``sceneweaver demo``."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from importlib.metadata import version
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import typer

from sceneweaver.io import load_json, write_atomic
from sceneweaver.scene import Scene

from .clock import Clock, clock, keep_for
from .exit_codes import NOT_VALID
from .output import headline, list_files, list_violations, print_json, progress_bar, relations_line, staged
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.layout import Solution
    from sceneweaver.verify import Report

SCENE, METRICS, PICTURE = "scene.json", "metrics.json", "views/top_annotated.png"
TERMS = 'a JSON list of terms, such as [{"kind": "flow", "objects": ["a", "b"]}]'


@dataclass(frozen=True)
class Result:
    """What a run found and wrote; ``report`` is None where there was no time to judge."""

    solution: Solution
    report: Report | None
    files: dict[str, Path]
    until: Clock

    @property
    def valid_candidates(self) -> int:
        """How many candidates the engine calls valid."""
        return int((self.solution.status == 0).sum())

    @property
    def objective(self) -> float | None:
        """The value of the objective in the best layout; None where there is none."""
        values = self.solution.objective
        best = None if values is None else float(values[self.solution.order[0]])
        return None if best is None or not isfinite(best) else best

    @property
    def exit_code(self) -> int:
        """0, or 3 when the best scene is not valid, or 5 when time was up before all was judged and written."""
        return self.until.code(0 if self.report is not None and self.report.valid else NOT_VALID)

    def to_dict(self) -> dict[str, Any]:
        """The result for machines."""
        return {
            "valid": self.report.valid if self.report is not None else None,
            "exit_code": self.exit_code,
            "candidates": int(self.solution.candidates),
            "valid_candidates": self.valid_candidates,
            "seconds": float(self.solution.elapsed),
            "timed_out": bool(self.solution.timed_out),
            "objective": self.objective,
            "explanation": self.solution.explanation,
            "device": str(self.solution.device),
            "seed": int(self.solution.seed),
            "files": {name: str(path) for name, path in self.files.items()},
            "left_out": list(self.until.left_out),
            "metrics": self.report.to_dict() if self.report is not None else None,
        }


def run_refine(
    source: Path,
    out: Path,
    *,
    candidates: int,
    seed: int,
    init: Literal["sample", "random", "current", "prior"],
    device: str,
    optimizer: str,
    time_limit: float | None,
    objective: Path | None = None,
    as_json: bool,
    picture: bool,
    began: float,
) -> int:
    """Refine a scene file into a folder, or into a scene file when ``out`` ends in .json.

    The time limit [s] of all, files included, counts from ``began``, by ``time.monotonic()``.
    """
    from sceneweaver.layout import find_optimizer, terms_from

    find_optimizer(optimizer)
    terms = {} if objective is None else {"objective": terms_from(load_json(objective, wanted=TERMS))}
    result = _run(
        Scene.load(source),
        out,
        began,
        picture=picture,
        candidates=candidates,
        seed=seed,
        init=init,
        device=device,
        optimizer=optimizer,
        time_limit=time_limit,
        **terms,
    )
    if as_json:
        print_json(result.to_dict())
        return result.exit_code
    report, solution = result.report, result.solution
    if report is None:
        typer.echo(f"not judged  {solution.best.id}: {len(solution.best.objects)} objects")
    else:
        headline(solution.best.id, report.valid, f"{report.placed} objects, {relations_line(report)}")
        list_violations(report)
    _explain(result)
    typer.echo(
        f"  {result.valid_candidates} of {solution.candidates} candidates valid in {solution.elapsed:.2f} s "
        f"on {solution.device}"
    )
    if result.objective is not None:
        typer.echo(f"  objective {result.objective:.6g}")
    result.until.tell()
    list_files(list(result.files.values()))
    return result.exit_code


def _run(scene: Scene, out: Path, began: float, *, picture: bool, time_limit: float | None, **options: Any) -> Result:
    """Refine, judge and write a scene; what there is no time for is left out, but for the scene."""
    single = out.suffix == ".json"
    folder, scene_name = (out.parent, out.name) if single else (out, SCENE)
    names = [scene_name] if single else [scene_name, METRICS, *([PICTURE] if picture else [])]
    with no_chatter():  # before the clock listens to signals, so that one ends a command at once that still starts
        from sceneweaver.explain import refine
        from sceneweaver.render import save_top
        from sceneweaver.verify import check
    with clock(time_limit, began) as until, staged(folder, names) as temporary:
        start = time.perf_counter()
        seconds: dict[str, float] = {}
        reports: list[Report] = []
        with progress_bar(f"refining {scene.id}", options["candidates"]) as progress, no_chatter():
            solution = until.needed(
                "refine",
                lambda: refine(scene, progress=progress, time_limit=until.for_search(keep_for(scene)), **options),
            )
            seconds["refine"] = time.perf_counter() - start
            best = solution.best
            best.save(temporary / scene_name)
            until.extra("the judgement", lambda: reports.append(check(best)))
        seconds["check"] = time.perf_counter() - start - seconds["refine"]
        report = reports[0] if reports else None
        if PICTURE in names:
            drawn = time.perf_counter()
            (temporary / PICTURE).parent.mkdir()
            judged = {"violations": report.violations, "valid": report.valid} if report is not None else {}
            until.extra(PICTURE, lambda: save_top(best, temporary / PICTURE, **judged))
            seconds["picture"] = time.perf_counter() - drawn
        if report is not None:
            report = replace(
                report,
                seconds={"total": time.perf_counter() - start, **seconds},
                seed=solution.seed,
                device=solution.device,
                candidates=solution.candidates,
                versions={**report.versions, "warp-lang": version("warp-lang")},
            )
            if METRICS in names:
                write_atomic(temporary / METRICS, report.to_json() + "\n")
        names = [name for name in names if (temporary / name).exists()]
    keys = {scene_name: "scene", METRICS: "metrics", PICTURE: "picture"}
    return Result(solution, report, {keys[name]: folder / name for name in names}, until)


def _explain(result: Result) -> None:
    if result.solution.timed_out:
        typer.echo(f"  stopped by {result.until.deadline.stop.reason or 'the time limit'}")
    if result.solution.explanation:
        typer.echo(f"  {result.solution.explanation}")
