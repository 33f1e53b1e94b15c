"""Our scenes beside those of other systems (docs/systems.md): ``python -m benchmarks comparison --samples DIR``."""

from __future__ import annotations

import argparse
import math
import re
import subprocess
import sys
import textwrap
from collections import Counter
from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import sceneeval_twin as twin
from benchmarks.console import say
from benchmarks.parallel import each
from benchmarks.settings import ROOT
from sceneweaver.assets.category import read_yaml
from sceneweaver.assets.roles import with_role
from sceneweaver.evaluation import (
    METRICS,
    Candidate,
    Comparison,
    Evaluation,
    Figure,
    Metric,
    Reading,
    SceneRow,
    candidates,
    compare,
    moving,
    standing,
)
from sceneweaver.evaluation.files import add_row, read_known, row_file, write_comparison
from sceneweaver.evaluation.openings import openings
from sceneweaver.evaluation.summary import number_text
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import InputError
from sceneweaver.verify import check
from sceneweaver.verify.solids import Placed

LIST = Path(__file__).with_name("system_scenes.yaml")
PAGE = ROOT / "docs" / "systems.md"
BEGIN, END = "<!-- table: python -m benchmarks comparison -->\n", "<!-- end of table -->\n"

KINDS = ("bedroom", "living room")
"""Kinds of rooms that are designed."""

LIMIT = 180
"""Seconds that a design may take."""

CLOSE = 0.05
"""Difference of two shares that counts as agreement."""

LONGEST = 120
"""Characters of a line of the page."""

TABLES = {"bedroom": "Bedrooms", "living room": "Living rooms", "sample": "SceneEval's samples", "other": "Other rooms"}


def main(arguments: Sequence[str] | None = None) -> int:
    """Design, judge, compare with SceneEval's definitions, and write the page."""
    p = argparse.ArgumentParser(prog="python -m benchmarks comparison", description=__doc__)
    p.add_argument("--samples", type=Path, required=True, help="folder with scenes of other systems")
    p.add_argument("--work", type=Path, default=ROOT / "out" / "comparison", help="folder for designs and results")
    p.add_argument("--count", type=int, default=10, help="designs of each kind (default: 10)")
    p.add_argument("--limit", type=int, help="scenes of each system at most (default: all)")
    p.add_argument("--agreement", type=int, default=5, help="scenes of each system for SceneEval's definitions")
    p.add_argument("--seed", type=int, default=0, help="first seed of the designs")
    p.add_argument("--jobs", type=int, default=cores())
    p.add_argument("--device", default="cpu")
    p.add_argument("--to", type=Path, default=PAGE, help="page whose table is written (default: docs/systems.md)")
    asked = p.parse_args(arguments)
    if not asked.samples.is_dir():
        raise InputError(f"--samples: {asked.samples} is no folder")
    asked.work.mkdir(parents=True, exist_ok=True)
    ours = {kind: designs(kind, asked) for kind in KINDS}
    there = [entry for entry in read_yaml(LIST) if (asked.samples / entry["path"]).exists()]
    systems: dict[str, Any] = {f"ours, {kind}s": ours[kind] for kind in KINDS}
    systems |= {entry["name"]: asked.samples / entry["path"] for entry in there}
    readings = {
        entry["name"]: Reading(
            folder=asked.samples / entry["folder"] if "folder" in entry else None,
            assume_sizes=entry.get("assume_sizes", False),
        )
        for entry in there
    }
    say(f"{len(systems)} systems ...")
    found = _compared(systems, readings, asked)
    write_comparison(found, asked.work, "comparison")
    say("SceneEval's definitions ...")
    agreed = agreement(list(dict.fromkeys(systems.values())), asked.agreement)
    kinds = {f"ours, {kind}s": kind for kind in KINDS} | {entry["name"]: entry["kind"] for entry in there}
    origin = {entry["name"]: entry["from"] for entry in there}
    _write(asked.to, _text(found, kinds, origin, agreed, asked))
    say(f"Wrote {asked.to}; the whole page is {asked.work / 'comparison.html'}")
    return 0


def designs(kind: str, asked: argparse.Namespace) -> Path:
    """A folder of designs of a kind by seed; those that are there are not made again."""
    folder = asked.work / "ours" / kind.replace(" ", "_")
    todo = [
        (kind, seed, folder / f"{seed:03d}", asked.device)
        for seed in range(asked.seed, asked.seed + asked.count)
        if not (folder / f"{seed:03d}" / "scene.json").is_file()
    ]
    if todo:
        say(f"{len(todo)} designs of a {kind} ...")
        each(_design, todo, asked.jobs)
    return folder


def _design(kind: str, seed: int, folder: Path, device: str) -> None:
    command = [sys.executable, "-m", "sceneweaver", "design", f"a {kind}", "--seed", str(seed), "-o", str(folder)]
    command += ["--no-pictures", "--export", "none", "--time-limit", str(LIMIT), "--device", device]
    done = subprocess.run(command, capture_output=True, text=True, timeout=2 * LIMIT, check=False, cwd=ROOT)
    if not (folder / "scene.json").is_file():
        raise RuntimeError(f"no design of a {kind} with seed {seed}: {done.stderr.strip()[-300:]}")


def _compared(systems: dict[str, Any], readings: dict[str, Reading], asked: argparse.Namespace) -> Comparison:
    known = read_known(asked.work)
    with row_file(asked.work) as file:

        def keep(row: SceneRow) -> None:
            add_row(file, row)

        return compare(
            systems,
            readings=readings,
            limit=asked.limit,
            jobs=asked.jobs,
            known=known,
            on_row=keep,
            pictures=3,
        )


class Agreement(NamedTuple):
    """Of a figure how many verdicts (of objects, pairs, openings or rooms) are those of SceneEval's definition."""

    name: str
    alike: int
    all: int
    remark: str


def agreement(systems: Sequence[Path], most: int) -> list[Agreement]:
    """The figures against SceneEval's definitions, over some scenes of each system, sizes assumed where need be."""
    alike, whole = Counter[str](), Counter[str]()
    for sources in systems:
        for candidate in islice(candidates(sources, Reading(assume_sizes=True), lambda _: None), most):
            for name, (same, count) in _verdicts(candidate).items():
                alike[name] += same
                whole[name] += count
    return [Agreement(name, alike[name], whole[name], _REMARKS[name]) for name in _REMARKS]


_REMARKS = {
    "collision": "pairs; ours counts from 1 mm, SceneEval what still overlaps when moved apart by 5 mm",
    "collision, of all found": "pairs that either has; SceneEval counts furniture on rugs of 0.5 mm",
    "collision, without sheets": "pairs that either has, but for things thinner than the move of 5 mm",
    "out of bounds in plan": "objects; ours from 1 mm, SceneEval under 99 % of the surface",
    "out of bounds in plan, of all found": "objects that either has; 1 mm may be under 1 %",
    "sunk into the floor": "objects that SceneEval has out of bounds for that; ours: unsupported",
    "support": "objects",
    "navigability": f"rooms, within {CLOSE:g}; one of three widths of the base, as cells are 5 cm",
    "accessibility": f"things, within {CLOSE:g}",
    "opening clearance": f"openings, within {CLOSE:g} of their area",
}


def _verdicts(candidate: Candidate) -> dict[str, tuple[int, int]]:
    scene = candidate.scene
    if any(abs(o.pose.quaternion[0]) + abs(o.pose.quaternion[1]) > 1e-3 for o in scene.objects):  # noqa: PLR2004
        return {}  # the pictures of the twin are of upright things
    placed, things = Placed.of(scene), twin.things_of(scene)
    report = check(scene, walkable=False)
    ours = {frozenset(v.objects): v.amount for v in report.violations if v.kind == "collision"}
    theirs = twin.collisions(things)
    pairs = math.comb(len(things), 2)
    either = set(ours) | theirs
    sheets = {o.id for o in scene.objects if o.size[2] < twin.APART}
    thick = {pair for pair in either if not pair & sheets}
    outside = {v.objects[0] for v in report.violations if v.kind == "out_of_bounds"}
    flat, deep = (twin.out_of_bounds(scene, things, deep=d) for d in (False, True))
    low = {name for name, share in flat.items() if share < twin.IN_BOUNDS}
    sunk = {name for name, share in deep.items() if share < twin.IN_BOUNDS} - low
    held = dict(zip((b.id for b in placed.bodies), standing.supported(placed), strict=True))
    their_held = twin.supported(scene, things)
    free = moving.navigability(placed)
    their_free = [twin.navigability(scene, things, moving.BASE + d) for d in (-0.05, 0.0, 0.05)]
    near = moving.accessibility(placed), list(twin.accessibility(scene, things).values())
    before = {o.id: o.share for o in openings(placed)}
    their_before = twin.openings_covered(scene, things, with_role("window_dressing"))
    return {
        "collision": (pairs - len(set(ours) ^ theirs), pairs),
        "collision, of all found": (len(set(ours) & theirs), len(either)),
        "collision, without sheets": (len(set(ours) & theirs & thick), len(thick)),
        "out of bounds in plan": (len(things) - len(outside ^ low), len(things)),
        "out of bounds in plan, of all found": (len(low & outside), len(low | outside)),
        "sunk into the floor": (sum(not held[name] for name in sunk), len(sunk)),
        "support": (sum(held[name] == their_held[name] for name in held), len(held)),
        "navigability": (_near(free, their_free), 1),
        "accessibility": (sum(abs(a - b) <= CLOSE for a, b in zip(*near, strict=True)), len(near[0])),
        "opening clearance": (sum(abs(before[k] - their_before[k]) <= CLOSE for k in before), len(before)),
    }


def _near(free: float | None, theirs: Sequence[float]) -> int:
    return int(free is not None and min(theirs) - CLOSE <= free <= max(theirs) + CLOSE)


def _text(
    found: Comparison,
    kinds: dict[str, str],
    origin: dict[str, str],
    agreed: Sequence[Agreement],
    asked: argparse.Namespace,
) -> str:
    lines = []
    for kind, title in TABLES.items():
        own = [system for system in found.systems if kinds[system.name] == kind]
        if not own:
            continue
        lines += [f"### {title}", ""]
        lines += tables(own)
        for system in own:
            lines += _told(system, origin.get(system.name, ""))
        lines.append("")
    lines += ["### Agreement with SceneEval's definitions", ""]
    lines += [f"Over at most {asked.agreement} scenes of each system, sizes assumed where the files have none.", ""]
    lines += ["| figure | the same | of | what is counted |", "| --- | ---: | ---: | --- |"]
    for row in agreed:
        share = f"{100 * row.alike / row.all:.1f} %" if row.all else "-"
        lines.append(f"| {row.name} | {share} | {row.all} | {row.remark} |")
    return "\n".join(lines) + "\n"


def tables(systems: Sequence[Evaluation]) -> list[str]:
    """The figures of some systems as Markdown, in as many tables as keep their lines short, without those that none of
    them has; which of these only the files are to blame for is said below."""
    shown, without = [], []
    for metric in METRICS:
        figures = [s.figures[metric.key] for s in systems]
        if _asks(metric):
            continue
        if any(f.value is not None for f in figures):
            shown.append(metric)
        elif any("not in the files" in f.missing for f in figures):
            without.append(metric.title)
    told = f"What these figures need is in none of the files: {'; '.join(without)}."
    return [*_tables(systems, shown), *([*_wrapped(told), ""] if without else [])]


def _tables(systems: Sequence[Evaluation], metrics: Sequence[Metric]) -> list[str]:
    heads = [f"{s.name} (n = {s.judged})" for s in systems]
    lines = ["| figure | " + " | ".join(heads) + " |", "| --- |" + " ---: |" * len(heads)]
    for metric in metrics:
        lines.append(f"| {metric.title} | " + " | ".join(_cell(s.figures[metric.key], metric) for s in systems) + " |")
    if len(systems) > 1 and max(map(len, lines)) > LONGEST:
        middle = (len(systems) + 1) // 2
        return [*_tables(systems[:middle], metrics), *_tables(systems[middle:], metrics)]
    return [*lines, ""]


def _asks(metric: Metric) -> bool:
    return not {"prompts", "reference"}.isdisjoint(metric.needs)


def _cell(figure: Figure, metric: Metric) -> str:
    if figure.value is None:
        return "not in the files" if "not in the files" in figure.missing else "-"
    shown = "~ " * figure.assumed + number_text(figure.value, metric)
    if figure.low is not None and figure.high is not None:
        shown += f" ({_bare(figure.low, metric)} to {_bare(figure.high, metric)})"
    return shown


def _bare(value: float, metric: Metric) -> str:
    return number_text(value, metric).removesuffix(" %").removesuffix(" mm")


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(
        text, LONGEST, subsequent_indent="  " * text.startswith("- "), break_long_words=False, break_on_hyphens=False
    )


def _told(system: Evaluation, origin: str) -> list[str]:
    """What there is to say of a system's files, a line each."""
    lines = [f"- **{system.name}**" + (f" ({origin})" if origin else " (designs by seed, without pictures)") + ":"]
    missing = [
        f"{reason} ({scenes} of {system.judged})" for reason, scenes in system.lacks.items() if "--" not in reason
    ]
    lines[0] += " " + ("; ".join(missing) or "nothing is missing") + "."
    if system.failed or system.refused:
        lines[0] += f" {len(system.failed)} scenes could not be judged, {len(system.refused)} not be read."
    return [line for text in lines for line in _wrapped(text)]


def _write(page: Path, text: str) -> None:
    """Put the tables between the marks of a page; a page without marks gets them at its end."""
    old = page.read_text(encoding="utf-8") if page.is_file() else f"# Systems side by side\n\n{BEGIN}{END}"
    if BEGIN not in old or END not in old:
        raise InputError(f"{page}: the marks of the table are missing")
    wrapped = f"{BEGIN}\n{text}\n{END}"
    page.write_text(re.sub(re.escape(BEGIN) + ".*?" + re.escape(END), lambda _: wrapped, old, flags=re.S), "utf-8")
