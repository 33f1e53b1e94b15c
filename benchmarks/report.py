"""``python -m benchmarks report``: docs/benchmarks.md from the JSON files of one or more runs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks import plots
from benchmarks.families import FAMILIES
from benchmarks.markdown import result_lines, wrapped
from benchmarks.results import Result

HEAD = (
    "This page is written by `python -m benchmarks report` from the results of `python -m benchmarks`; edits by hand "
    "are lost. Quality stands next to time, rivals run in the same run, and a family fails when an answer is wrong, "
    "never because it is slow. `make bench` runs everything; `python -m benchmarks --help` says how to run a part. "
    "Some rivals need packages that are not among the development dependencies (`uv pip install torch drake`); without "
    "them they are left out, and a note says so."
)


def load(folder: Path) -> list[Result]:
    """The results in a folder, in the order of the families.

    Raises:
        ValueError: the folder holds none, or a file that is something else.
    """
    paths = [folder / f"{name}.json" for name in FAMILIES]
    found = [Result.load(path) for path in paths if path.is_file()]
    if not found:
        raise ValueError(f"{folder} holds no results; run `python -m benchmarks` first")
    return found


def machine_lines(machine: dict[str, Any]) -> list[str]:
    """What the numbers were measured on, as a list."""
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    rows = (
        ("Device", f"{machine['device_name']} ({machine['device']})"),
        ("Processor", f"{machine['cpu']}, {machine['cores']} cores, {machine['memory_gib']} GiB"),
        ("System", machine["system"]),
        ("Versions", versions),
    )
    return [line for name, text in rows for line in wrapped(f"{name}: {text}", "- ")]


def run_line(result: Result) -> list[str]:
    """When and how one family was run."""
    options = result.options
    asked = [f"seed {options['seed']}"]
    if options["rooms"]:
        asked.append("rooms " + ", ".join(options["rooms"]))
    if options["most"]:
        asked.append(f"at most {options['most']} candidates")
    load = result.machine["load"]
    text = f"Commit {result.machine['commit']}, {result.machine['date']}, {', '.join(asked)}, {result.seconds:.0f} s"
    text += "" if load is None else f", load at the start {load}"
    quick = ["**Quick sizes: these numbers only show that everything works.**", ""] if options["quick"] else []
    return [*quick, *wrapped(text + ".")]


def write(folders: Sequence[Path], path: Path) -> None:
    """Write the page."""
    lines = ["# Benchmarks", "", *wrapped(HEAD)]
    for folder in folders:
        results = load(folder)
        lines += ["", f"## On {results[0].machine['device_name']}", "", *machine_lines(results[0].machine)]
        for result in results:
            head, *rest = result_lines(result, level=3)
            lines += ["", head, "", *run_line(result), *rest]
            for picture in plots.draw(result, path.parent / "images", page=True) or ():
                lines += ["", f"![{result.title}](images/{picture.name})"]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(line.rstrip() for line in lines) + "\n", "utf-8")
