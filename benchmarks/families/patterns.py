"""How often the patterns that strict eyes counted are in rooms: new ones, or designs that were made before."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from benchmarks.design_files import design_files, read_scene
from benchmarks.designs import PAPER
from benchmarks.judging import Judge
from benchmarks.made import Task, made_side_by_side
from benchmarks.parallel import each
from benchmarks.patterns.room import Hits
from benchmarks.patterns.sets import SET_PATTERNS, SetPattern
from benchmarks.patterns.single import PATTERNS, Pattern, measured
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.scene import Scene

SEEDS = 3
"""Seeds of each kind of room."""

LIMIT = 120.0
"""Time limit of a design [s]."""

FEW = 4
"""Rooms from which on it is worth to start processes."""

NAMED = 4
"""Rooms that the table names."""

COLUMNS = (
    Column("pattern", "pattern"),
    Column("found", "found", "count"),
    Column("of", "of", "count"),
    Column("unit", "counted"),
    Column("seen", "strict eyes"),
    Column("rooms", "rooms"),
)
WHERE = (Column("pattern", "pattern"), Column("room", "room"), Column("objects", "objects"))


def run(settings: Settings, judge: Judge) -> Result:
    """Read or design the rooms and count."""
    del judge
    result = Result(
        "patterns",
        "Patterns that strict eyes counted",
        "How often each pattern is there: most by the critic's design rules, the others by geometry and metadata. "
        "Strict eyes: how often they saw it in rooms of an earlier version. Patterns of pictures are told by cameras "
        "and poses alone.",
    )
    if settings.designs:
        scenes = {name: read_scene(path) for name, path in design_files(settings.designs).items()}
    else:
        kinds = settings.kinds or tuple(PAPER)[: 1 if settings.quick else None]
        seeds = range(settings.seed, settings.seed + (settings.count or (1 if settings.quick else SEEDS)))
        made = made_side_by_side([Task(kind, seed) for seed in seeds for kind in kinds], settings, LIMIT)
        scenes = {one.task.name: one.scene for one in made}
    tabulate(result, scenes, counted(scenes, settings.jobs))
    return result


def counted(scenes: Mapping[str, Scene], jobs: int) -> dict[str, dict[str, Hits]]:
    """Every pattern in every room, by room and pattern."""
    few = len(scenes) < FEW
    return dict(zip(scenes, each(measured, [(s,) for s in scenes.values()], 1 if few else jobs), strict=True))


def tabulate(result: Result, scenes: Mapping[str, Scene], hits: Mapping[str, Mapping[str, Hits]]) -> None:
    """One line for each pattern; where each one is in a table of its own."""
    table = result.add("patterns", f"Patterns in {len(scenes)} rooms", COLUMNS)
    where = result.add("where", "Where they are", WHERE, keys=2, detail=True)
    for name, pattern in PATTERNS.items():
        rooms = [room for room in hits if hits[room][name].found]
        found, of = (sum(getattr(hits[room][name], field) for room in hits) for field in ("found", "of"))
        table.rows.append(_row(pattern, found, of, rooms))
        for room in rooms:
            row = {"room": room, "objects": " ".join(hits[room][name].objects)}
            where.rows.append({"pattern": pattern.text, **row})
    for pattern in SET_PATTERNS.values():
        found = pattern.measure(scenes)
        table.rows.append(_row(pattern, found.found, found.of, found.objects))
        where.rows += [{"pattern": pattern.text, "room": room, "objects": ""} for room in found.objects]


def _row(pattern: Pattern | SetPattern, found: int, of: int, rooms: Sequence[str]) -> dict[str, str | int]:
    more = f" and {len(rooms) - NAMED} more" if len(rooms) > NAMED else ""
    row = {"pattern": pattern.text, "unit": pattern.unit, "seen": pattern.seen}
    return {**row, "found": found, "of": of, "rooms": ", ".join(rooms[:NAMED]) + more}
