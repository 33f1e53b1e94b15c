"""The command line: run families, write their results, and the page of them all."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from benchmarks import (
    dataset_homes,
    dataset_layouts,
    dataset_scenes,
    layout_bench,
    noun_table,
    plots,
    prior_data,
    prior_memory,
    prior_train,
    problems,
    real_plans,
    report,
    system_scenes,
)
from benchmarks.console import console, print_result, say
from benchmarks.families import FAMILIES, ablations
from benchmarks.judging import Judge
from benchmarks.machine import facts, resolve
from benchmarks.markdown import result_lines
from benchmarks.results import Result
from benchmarks.rivals import RIVALS
from benchmarks.rooms import ROOMS
from benchmarks.settings import OUT, ROOT, Settings
from sceneweaver.knowledge import room_types
from sceneweaver.plans import programme_names
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import SceneWeaverError

PAGE = ROOT / "docs" / "benchmarks.md"
DONE, WRONG, BAD_INPUT = 0, 1, 2


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what was asked for; 1 when an answer was wrong or a family broke down, 2 on bad input."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if words[:1] == ["problems"]:
            return problems.main(words[1:])
        if words[:1] == ["layout_bench"]:
            return layout_bench.main(words[1:])
        if words[:1] == ["layouts"]:
            return dataset_layouts.main(words[1:])
        if words[:1] == ["datasets"]:
            return dataset_scenes.main(words[1:])
        if words[:1] == ["homes"]:
            return dataset_homes.main(words[1:])
        if words[:1] == ["prior_data"]:
            return prior_data.main(words[1:])
        if words[:1] == ["prior_memory"]:
            return prior_memory.main(words[1:])
        if words[:1] == ["prior_train"]:
            return prior_train.main(words[1:])
        if words[:1] == ["nouns"]:
            return noun_table.main(words[1:])
        if words[:1] == ["real_plans"]:
            return real_plans.main(words[1:])
        if words[:1] == ["comparison"]:
            return system_scenes.main(words[1:])
        return _report(words[1:]) if words[:1] == ["report"] else _run(words)
    except (ValueError, SceneWeaverError) as error:
        console.print(f"benchmarks: {error}", style="bold red", markup=False)
        return BAD_INPUT


def _names(text: str, known: Sequence[str], what: str) -> tuple[str, ...]:
    names = tuple(n for n in text.replace(",", " ").split() if n)
    for name in names:
        if name not in known:
            raise ValueError(f'{what} "{name}" is unknown; give some of {", ".join(known)}')
    return names


def parser() -> argparse.ArgumentParser:
    """The options of a run."""
    p = argparse.ArgumentParser(
        prog="python -m benchmarks",
        description="Measure sceneweaver. Ends with 1 when an answer is wrong, never because it is slow.",
        epilog="python -m benchmarks report --help: write the page of results; problems --help: the zoo of problems; "
        "layouts --help: layouts as a data set; datasets --help: scenes of one; "
        "homes --help: homes of one; "
        "prior_data, prior_train, prior_memory --help: the learned prior; nouns --help: the table of nouns; "
        "real_plans --help: plans of other systems against the rules; "
        "comparison --help: our scenes beside those of other systems.",
    )
    p.add_argument("families", nargs="*", metavar="FAMILY", help=f"some of {', '.join(FAMILIES)} (default: all)")
    p.add_argument("--rooms", default="", metavar="A,B", help="rooms of the zoo, with commas between them")
    p.add_argument("--kinds", default="", metavar="A,B", help="kinds of rooms to design, with commas between them")
    p.add_argument("--programmes", default="", metavar="A,B", help="programmes of homes, with commas between them")
    p.add_argument("--variants", nargs="+", default=[], choices=ablations.VARIANTS, help="variants of the ablations")
    p.add_argument("--designs", nargs="+", type=Path, default=[], metavar="DIR", help="designs to read, not to make")
    p.add_argument("--all", action="store_true", help="all rooms of the zoo where a family takes only some")
    p.add_argument("--device", default="auto", help="auto, cpu, cuda, cuda:k or cuda:all (default: auto)")
    p.add_argument("--quick", action="store_true", help="small sizes, to see that everything works")
    p.add_argument("--seed", type=int, default=0, help="first seed (default: 0)")
    p.add_argument("--most", type=int, help="at most so many candidates a call")
    p.add_argument("--count", type=int, help="designs of a family that makes many of one kind")
    p.add_argument("--jobs", type=int, default=cores(), help="processes (default: one for each core)")
    p.add_argument("--rivals", metavar="A,B", help=f"some of {', '.join(map(repr, RIVALS))}, or none (default: all)")
    p.add_argument("--out", type=Path, default=OUT, help="folder for results (default: out/benchmarks)")
    p.add_argument("--commit", help="commit to note in a tree without git")
    return p


def _rivals(text: str | None) -> tuple[str, ...] | None:
    if text is None:
        return None
    names = tuple(n.strip() for n in text.split(",") if n.strip() and n.strip() != "none")
    for name in names:
        if name not in RIVALS:
            raise ValueError(f'rival "{name}" is unknown; give some of {", ".join(RIVALS)}, or none')
    return names


def _settings(options: argparse.Namespace) -> Settings:
    for name in ("most", "count", "jobs"):
        value = getattr(options, name)
        if value is not None and value < 1:
            raise ValueError(f"--{name}: {value} is not at least 1")
    if not 0 <= options.seed < 2**31:
        raise ValueError(f"--seed: {options.seed} is not from 0 to 2**31 - 1")
    return Settings(
        rooms=_names(options.rooms, ROOMS, "room"),
        kinds=_names(options.kinds, tuple(room_types()), "kind of room"),
        programmes=_names(options.programmes, programme_names(), "programme"),
        variants=tuple(options.variants),
        designs=tuple(options.designs),
        device=resolve(options.device),
        quick=options.quick,
        everything=options.all,
        seed=options.seed,
        most=options.most,
        count=options.count,
        jobs=options.jobs,
        rivals=_rivals(options.rivals),
        out=options.out,
        commit=options.commit,
    )


def _run(words: list[str]) -> int:
    options = parser().parse_args(words)
    families = _names(" ".join(options.families), tuple(FAMILIES), "family") or tuple(FAMILIES)
    settings = _settings(options)
    failed = []
    with Judge(settings.jobs) as judge:
        for name in families:
            result = run_family(name, settings, judge)
            print_result(result)
            failed += [name] if result.failures else []
    console.print(f"Results are in {settings.out}", markup=False)
    if failed:
        console.print(f"WRONG answers in: {', '.join(failed)}", style="bold red", markup=False)
    return WRONG if failed else DONE


def run_family(name: str, settings: Settings, judge: Judge) -> Result:
    """Run one family and write its files; one that breaks down is a failure of its own, and the others still run."""
    say(f"{name} ...")
    machine, began = facts(settings), time.perf_counter()
    try:
        result = FAMILIES[name](settings, judge)
    except Exception as error:
        console.print_exception()
        result = Result(name, name.capitalize(), "This family broke down.")
        text = " ".join(str(error).split())[:500]
        result.failures.append(f"{name} broke down: {type(error).__name__}: {text}")
    result = replace(result, machine=machine, options=settings.options(), seconds=time.perf_counter() - began)
    if result.plots and plots.draw(result, settings.out) is None:
        say(plots.MISSING)
    result.save(settings.out)
    text = "\n".join([*result_lines(result), "", *report.run_line(result)])
    (settings.out / f"{name}.md").write_text(text + "\n", "utf-8")
    return result


def _report(words: list[str]) -> int:
    p = argparse.ArgumentParser(prog="python -m benchmarks report", description="Write the page of results.")
    p.add_argument("--from", dest="folders", type=Path, nargs="+", default=[OUT], help="folders with results")
    p.add_argument("--to", type=Path, default=PAGE, help="the page (default: docs/benchmarks.md)")
    options = p.parse_args(words)
    report.write(options.folders, options.to)
    for folder in options.folders:
        for result in report.load(folder):
            plots.draw(result, folder)
    console.print(f"Wrote {options.to}", markup=False)
    return DONE
