"""``sceneweaver refine`` and ``sceneweaver demo``."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import typer

from sceneweaver.io import write_atomic
from sceneweaver.scene import Scene

from .exit_codes import NOT_VALID
from .output import headline, list_files, list_violations, no_chatter, print_json, progress_bar, relations_line, staged

if TYPE_CHECKING:
    from sceneweaver.layout import Solution
    from sceneweaver.verify import Report

SCENE, METRICS, PICTURE = "scene.json", "metrics.json", "views/top_annotated.png"


@dataclass(frozen=True)
class Result:
    """What a run found and wrote."""

    solution: Solution
    report: Report
    files: dict[str, Path]

    @property
    def valid_candidates(self) -> int:
        """How many candidates the engine calls valid."""
        return int((self.solution.status == 0).sum())

    @property
    def exit_code(self) -> int:
        """0, or 3 when the best scene is not valid."""
        return 0 if self.report.valid else NOT_VALID

    def to_dict(self) -> dict[str, Any]:
        """The result for machines."""
        return {
            "valid": self.report.valid,
            "exit_code": self.exit_code,
            "candidates": int(self.solution.candidates),
            "valid_candidates": self.valid_candidates,
            "seconds": float(self.solution.elapsed),
            "timed_out": bool(self.solution.timed_out),
            "explanation": self.solution.explanation,
            "device": str(self.solution.device),
            "seed": int(self.solution.seed),
            "files": {name: str(path) for name, path in self.files.items()},
            "metrics": self.report.to_dict(),
        }


def run_refine(
    source: Path,
    out: Path,
    *,
    candidates: int,
    seed: int,
    init: Literal["sample", "random", "current"],
    device: str,
    optimizer: str,
    time_limit: float | None,
    as_json: bool,
    picture: bool,
) -> int:
    """Refine a scene file into a folder, or into a scene file when ``out`` ends in .json."""
    from sceneweaver.layout import find_optimizer

    find_optimizer(optimizer)
    result = _run(
        Scene.load(source),
        out,
        picture=picture,
        candidates=candidates,
        seed=seed,
        init=init,
        device=device,
        optimizer=optimizer,
        time_limit=time_limit,
    )
    if as_json:
        print_json(result.to_dict())
        return result.exit_code
    report, solution = result.report, result.solution
    headline(solution.best.id, report.valid, f"{report.placed} objects, {relations_line(report)}")
    list_violations(report)
    _explain(result)
    typer.echo(
        f"  {result.valid_candidates} of {solution.candidates} candidates valid in {solution.elapsed:.2f} s "
        f"on {solution.device}"
    )
    list_files(list(result.files.values()))
    return result.exit_code


def _run(scene: Scene, out: Path, *, picture: bool, **options: Any) -> Result:
    """Refine, judge and write a scene."""
    single = out.suffix == ".json"
    folder, scene_name = (out.parent, out.name) if single else (out, SCENE)
    names = [scene_name] if single else [scene_name, METRICS, *([PICTURE] if picture else [])]
    with staged(folder, names) as temporary:
        start = time.perf_counter()
        with progress_bar(f"refining {scene.id}", options["candidates"]) as progress, no_chatter():
            from sceneweaver.explain import refine
            from sceneweaver.verify import check

            solution = refine(scene, progress=progress, **options)
            refined = time.perf_counter()
            best = solution.best
            report = check(best)
        seconds = {"refine": refined - start, "check": time.perf_counter() - refined}
        best.save(temporary / scene_name)
        if PICTURE in names:
            from sceneweaver.render import save_top

            drawn = time.perf_counter()
            (temporary / PICTURE).parent.mkdir()
            save_top(best, temporary / PICTURE, violations=report.violations, valid=report.valid)
            seconds["picture"] = time.perf_counter() - drawn
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
    keys = {scene_name: "scene", METRICS: "metrics", PICTURE: "picture"}
    return Result(solution, report, {keys[name]: folder / name for name in names})


def _explain(result: Result) -> None:
    if result.solution.timed_out:
        typer.echo("  stopped by the time limit")
    if not result.report.valid and result.solution.explanation:
        typer.echo(f"  {result.solution.explanation}")
