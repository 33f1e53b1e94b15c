"""``sceneweaver problems``: the zoo of layout problems."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io import write_atomic
from sceneweaver.scene import InputError, SceneWeaverError

from .exit_codes import NOT_VALID
from .output import list_files, print_json, staged
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.problems import ProblemCase


def run_list(*, family: str | None, feasible: bool | None, as_json: bool) -> int:
    """List the problems."""
    from sceneweaver import problems
    from sceneweaver.problems.store import manifest

    rows = {name: manifest()[name] for name in problems.names(family, feasible)}
    if as_json:
        print_json({"families": problems.families(), "problems": [{"name": name, **row} for name, row in rows.items()]})
        return 0
    for name, row in rows.items():
        kind = f"{row['facts']['tightness']:.2f} of the floor" if row["feasible"] else "no layout is valid"
        typer.echo(f"{name:<32} {row['objects']:>4} objects {row['relations']:>4} relations  {kind}")
    return 0


def run_show(name: str, *, as_json: bool) -> int:
    """Print a problem's card."""
    from sceneweaver import problems

    case = problems.load(name)
    if as_json:
        print_json(_facts(case))
    else:
        typer.echo(case.card.rstrip("\n"))
    return 0


def run_export(name: str, out: Path, *, as_json: bool) -> int:
    """Write a problem's files."""
    from sceneweaver import problems

    case = problems.load(name)
    names = ["problem.json", "card.md", "scene.json"] + (["witness.json"] if case.feasible else [])
    if out.suffix == ".json":
        raise InputError(f"--out: {out} is a file; give a folder")
    with staged(out, names) as folder:
        write_atomic(folder / "problem.json", problems.canonical(case) + b"\n")
        write_atomic(folder / "card.md", case.card)
        case.scene.save(folder / "scene.json")
        if case.witness is not None:
            case.layout(case.witness).save(folder / "witness.json")
    files = [out / name for name in names]
    if as_json:
        print_json({**_facts(case), "files": [str(path) for path in files]})
    else:
        typer.echo(f"{case.name}  {case.hash[:16]}")
        list_files(files)
    return 0


def run_verify(name: str | None, *, split: str | None, seed_file: Path | None, as_json: bool) -> int:
    """Verify one problem, all, or those of a split, which are made anew."""
    from sceneweaver import problems

    wrong: dict[str, str] = {}
    if split is None:
        if seed_file is not None:
            raise InputError("--seed-file: is for --split test")
        chosen = problems.names() if name is None else (problems.load(name).name,)
        found = {each: partial(problems.load, each) for each in chosen}
    else:
        if name is not None:
            raise InputError(f"--split: a split is verified as a whole; leave {name} out")
        cases = problems.layout_bench.make(split, seed_file)
        chosen = tuple(case.name for case in cases)
        found = {case.name: partial(_itself, case) for case in cases}
        try:
            problems.layout_bench.verify_split(split, seed_file)
        except SceneWeaverError as error:
            wrong[f"the split {split}"] = str(error)
    for each in chosen:
        try:
            with no_chatter():
                problems.verify(found[each]())
        except SceneWeaverError as error:
            wrong[each] = str(error)
    right = sum(each not in wrong for each in chosen)
    if as_json:
        print_json({"verified": right, "wrong": wrong})
    else:
        typer.echo(f"{right} of {len(chosen)} problems are in order")
        for text in wrong.values():
            typer.echo(f"  {text}")
    return NOT_VALID if wrong else 0


def _itself(case: ProblemCase) -> ProblemCase:
    return case


def _facts(case: ProblemCase) -> dict[str, Any]:
    from sceneweaver import problems

    return {
        "name": case.name,
        "family": case.family,
        "version": case.version,
        "hash": case.hash,
        "objects": len(case.scene.objects),
        "relations": len(case.scene.relations),
        "feasible": case.feasible,
        "facts": dict(case.facts),
        "best_energy": case.best_energy,
        "objective": [term.to_dict() for term in case.objective],
        "best_objective": case.best_objective,
        "tier": problems.layout_bench.tier_of(case.name) or None,
        "certificate": case.certificate,
        "difficulty": dict(case.difficulty),
        "starts": list(case.starts),
    }
