"""Real plans against a profile of rules: ``python -m benchmarks real_plans --plans DIR``.

DIR has a folder a source, each with files that `sceneweaver.read_homes` reads. A file ``source.yaml`` in it may say
what its plans do not tell, ``not_judged: {rule: why}``; rows about windows are left out as well for a source none of
whose files has a window. A plan is whole where it has an entrance, a door to each room and one storey, or stairs
between storeys; what is not (half a house, doors that were not drawn) is counted alone.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from benchmarks.console import say
from sceneweaver.home import Home
from sceneweaver.importers import read_homes, repair_plan
from sceneweaver.io import load_yaml
from sceneweaver.plans import PlanReport, Profile, check_plan
from sceneweaver.scene import InputError

LIGHT = ("dark", "glazing", "escape", "sun", "light_sides")
"""Measures that need windows."""

SHOWN = 40
"""Exceptions that are listed on the terminal; --json has them all."""


@dataclass
class Judged:
    """A plan: where it comes from, whether it is whole, the rules it breaks before and after it was repaired."""

    source: str
    plan: str
    rooms: int
    whole: bool
    broken: dict[str, list[str]]
    after: dict[str, list[str]] | None = None
    moved: float | None = None


@dataclass
class Source:
    """A folder of plans."""

    name: str
    plans: list[Judged] = field(default_factory=list)
    refused: list[str] = field(default_factory=list)
    left_out: dict[str, str] = field(default_factory=dict)


def main(arguments: Sequence[str]) -> int:
    """Judge the plans of a folder and print the tables; 0 however many pass."""
    p = argparse.ArgumentParser(prog="python -m benchmarks real_plans", description=__doc__)
    p.add_argument("--plans", type=Path, required=True, help="folder with a folder of plans a source")
    p.add_argument("--profile", default="base", help="rules: a name, or a file")
    p.add_argument("--limit", type=int, default=None, help="most plans of a source")
    p.add_argument("--repair", action="store_true", help="repair what breaks a rule, and judge it again")
    p.add_argument("--json", type=Path, default=None, help="write every plan with its rules here")
    options = p.parse_args(arguments)
    profile = Profile.load(options.profile) if options.profile.endswith(".yaml") else Profile.named(options.profile)
    if not options.plans.is_dir():
        raise InputError(f"--plans: {options.plans} is no folder; give one with a folder of plans a source")
    sources = [
        judge(folder, profile, options.limit, options.repair)
        for folder in sorted(options.plans.iterdir())
        if folder.is_dir()
    ]
    for line in table(sources, profile.name, options.repair):
        say(line)
    if options.json is not None:
        options.json.write_text(json.dumps([asdict(s) for s in sources], indent=1, ensure_ascii=False) + "\n")
    return 0


def judge(folder: Path, profile: Profile, limit: int | None, repaired: bool) -> Source:
    """The plans of a source, each judged."""
    found = Source(folder.name)
    homes = [h for h in read_homes(folder, on_error=found.refused.append)][:limit]
    if (folder / "source.yaml").is_file():
        said = load_yaml(folder / "source.yaml")
        found.left_out = {str(k): str(v) for k, v in (said.get("not_judged") or {}).items()}
    if not any(h.home.windows for h in homes):
        found.left_out |= {row.id: "its files have no windows" for row in profile.rows if row.measure in LIGHT}
    profile = profile.without(*(row.id for row in profile.rows if row.id in found.left_out))
    for imported in homes:
        home = imported.home
        report = check_plan(home, profile=profile)
        entry = Judged(
            folder.name, home.id, len(home.rooms), "entrance" in found.left_out or whole(home), _broken(report)
        )
        if repaired and not report.valid:
            mended = repair_plan(home, profile=profile)
            entry.after = _broken(mended.after)
            entry.moved = max((abs(m.by) for m in mended.moved if not m.how.startswith("added")), default=0.0)
        found.plans.append(entry)
    return found


def whole(home: Home) -> bool:
    """Whether a plan has an entrance, a door to each room, and stairs where it has several storeys."""
    joined = {room for door in home.doors for room in (door.room, door.to)}
    shut = [room.id for room in home.rooms if room.id not in joined]
    return bool(home.entrances) and not shut and len(home.stairs) >= len(home.storeys) - 1


def _broken(report: PlanReport) -> dict[str, list[str]]:
    rules: dict[str, list[str]] = {}
    for violation in report.violations:
        rules.setdefault(violation.rule, []).append(violation.detail)
    return rules


def table(sources: Sequence[Source], profile: str, repaired: bool) -> list[str]:
    """The tables as lines: sources, rules by how many whole plans break them, and plans one by one."""
    lines = [f"profile {profile}", ""]
    lines += ["| source | read | refused | whole | valid | share |" + (" valid after repair |" if repaired else "")]
    lines += ["| --- " * (7 if repaired else 6) + "|"]
    for source in sources:
        kept = [p for p in source.plans if p.whole]
        good = sum(not p.broken for p in kept)
        after = sum(not (p.broken if p.after is None else p.after) for p in kept)
        share = f"{100 * good / len(kept):.1f} %" if kept else "-"
        row = f"| {source.name} | {len(source.plans)} | {len(source.refused)} | {len(kept)} | {good} | {share} |"
        lines.append(row + (f" {after} |" if repaired else ""))
    for source in sources:
        for why in sorted(set(source.left_out.values())):
            names = ", ".join(k for k, v in source.left_out.items() if v == why)
            lines.append(f"{source.name}: not judged, {why}: {names}")
    lines += ["", "| rule | plans | alone | " + ("after repair | " if repaired else "") + "an example |"]
    lines += ["| --- " * (5 if repaired else 4) + "|"]
    plans = [p for s in sources for p in s.plans if p.whole]
    count = Counter(rule for p in plans for rule in p.broken)
    left = Counter(rule for p in plans for rule in (p.broken if p.after is None else p.after))
    for rule, number in count.most_common():
        alone = sum(set(p.broken) == {rule} for p in plans)
        example = next(f"{p.plan}: {p.broken[rule][0]}" for p in plans if rule in p.broken)
        lines.append(f"| {rule} | {number} | {alone} | " + (f"{left[rule]} | " if repaired else "") + f"{example} |")
    bad = [p for p in plans if p.broken]
    lines += ["", f"{len(plans) - len(bad)} of {len(plans)} whole plans keep every rule; the others:"]
    lines += [f"- {p.source}/{p.plan}: {', '.join(p.broken)}" for p in bad[:SHOWN]]
    if len(bad) > SHOWN:
        lines.append(f"- and {len(bad) - SHOWN} more; --json has them")
    return lines
