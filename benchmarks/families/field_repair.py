"""Scenes of other systems before and after repair: what was wrong, how far things move, what still holds."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import yaml

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.importers import formats
from sceneweaver.importers.sizes import load_sizes
from sceneweaver.repairs.rows import KINDS, Row, object_rows, scene_row, summary
from sceneweaver.repairs.run import repair_many
from sceneweaver.repairs.sources import given_scenes
from sceneweaver.repairs.stream import CHUNK, Given
from sceneweaver.scene import InputError

SOURCES = Path(__file__).parents[1] / "field_sources.yaml"
VALID, MOVEMENT, KEPT = 0.99, 0.05, 0.95
"""Wanted: share valid of what is not proved infeasible, median movement [m] of all objects, share of relations kept."""

CANDIDATES, QUICK = 8, 6
SWEEP = (1, 4, 16)
"""Candidates in the table of what they are worth, and of the first set alone."""

BODIES = ("boxes", "own")
"""As the file has it, boxes alone; and our furniture in these sizes, with its zones to open, use and pass."""

WHERE = (Column("source", "source"), Column("bodies", "bodies"))
SHARES = (
    *WHERE,
    Column("scenes", "scenes", "count"),
    Column("objects", "objects", "count"),
    Column("before", "valid before", "share"),
    Column("after", "valid after", "share"),
    Column("infeasible", "proved infeasible", "count"),
    Column("of_feasible", "valid of the others", "share"),
    Column("kept", "relations kept", "share"),
    Column("relations", "relations before", "count"),
    Column("near_after", "nearly held, now hold", "share"),
    Column("p50", "movement p50 [m]", "number"),
    Column("p90", "p90", "number"),
    Column("most", "max", "number"),
    Column("moved_p50", "of moved p50", "number"),
    Column("moved", "moved", "share"),
    Column("seconds", "seconds", "number"),
)
VIOLATIONS = (*WHERE, Column("when", "when"), *(Column(kind, kind.replace("_", " "), "count") for kind in KINDS))
SWEPT = (
    Column("candidates", "candidates", "count"),
    Column("of_feasible", "valid of feasible", "share"),
    Column("kept", "relations kept", "share"),
    Column("p50", "movement p50 [m]", "number"),
    Column("mean", "mean [m]", "number"),
    Column("seconds", "seconds", "number"),
)
LEFT = (*WHERE, Column("scene", "scene"), Column("proved", "proved"), Column("explanation", "why"))


def run(settings: Settings, judge: Judge) -> Result:
    """Repair every set of scenes that is there, in both kinds of bodies."""
    del judge
    result = Result(
        "field_repair",
        "Repair of other systems' scenes",
        f"Public scenes of other systems, imported and repaired ({CANDIDATES} candidates a scene; hard: bodies, room, "
        "supports, zones, openings; soft relations that geometry shows are to be kept). Boxes: as the file has it. "
        "Own: our furniture in these sizes, with the zones to open, use and pass it. Valid is what sw.check says. "
        "Movement is in the plane, over all objects. Proved infeasible: by arithmetic no layout with all objects is "
        "valid. "
        f"Wanted: {VALID:.0%} of the others valid, a median movement of at most {100 * MOVEMENT:g} cm, {KEPT:.0%} of "
        "the relations that held before.",
    )
    shares = result.add("shares", "Before and after", SHARES, keys=2)
    kinds = result.add("violations", "Violations", VIOLATIONS, keys=3)
    left = result.add("left", "Scenes that stay invalid", LEFT, keys=3, detail=True)
    everything: dict[str, tuple[list[Row], list[Row], float]] = {bodies: ([], [], 0.0) for bodies in BODIES}
    first: list[Given] = []
    for source in yaml.safe_load(SOURCES.read_text("utf-8")):
        if _unsized(source, settings) and _files(source, settings):
            result.notes.append(f"{source['name']}: sizes unknown, boxes of 0.12 to 0.28 m; not part of all")
        for bodies in BODIES:
            given = list(_given(source, bodies, settings, result))
            if not given:
                break
            first = first or given
            scenes, objects, seconds = _repaired(given, settings, settings.size(CANDIDATES, 4))
            _tell(source["name"], bodies, scenes, objects, seconds, shares.rows, kinds.rows, left.rows)
            if _unsized(source, settings):
                continue
            rows, more, before = everything[bodies]
            everything[bodies] = [*rows, *scenes], [*more, *objects], before + seconds
    for bodies, (scenes, objects, seconds) in everything.items():
        if scenes:
            row = _tell("all", bodies, scenes, objects, seconds, shares.rows, kinds.rows, [])
            result.failures += _missed(bodies, row)
    if first and not settings.quick:
        swept = result.add("candidates", "What candidates are worth: the first set as boxes", SWEPT)
        swept.rows += [_swept(first, settings, count) for count in SWEEP]
    return result


def _given(source: dict[str, Any], bodies: str, settings: Settings, result: Result) -> Iterator[Given]:
    """The scenes of a set; a note says where there are none."""
    name = source["name"]
    files = _files(source, settings)
    if source["format"] not in formats() or not files:
        if bodies == BODIES[0]:
            why = "no such files under --designs" if source["format"] in formats() else "its format is not read here"
            result.notes.append(f"{name}: left out, {why}")
        return
    table = _table(source, settings)
    options: dict[str, Any] = {
        "assets": bodies,
        "folder": _assets(source, settings),
        "sizes": None if table is None else load_sizes(table),
    }
    count = 0
    for file in files:
        try:
            for given in given_scenes(file, source["format"], **options):
                if settings.quick and count >= QUICK:
                    return
                count += 1
                yield given
        except InputError as error:
            result.notes.append(f"{name}: {error}")


def _files(source: dict[str, Any], settings: Settings) -> list[Path]:
    return [file for folder in settings.designs for file in sorted(Path(folder).glob(source["files"]))]


def _table(source: dict[str, Any], settings: Settings) -> Path | None:
    return next((f for folder in settings.designs for f in Path(folder).glob(source.get("sizes", "-"))), None)


def _assets(source: dict[str, Any], settings: Settings) -> Path | None:
    """The folder with what is known of the assets of a set."""
    return next((f for folder in settings.designs for f in Path(folder).glob(source.get("assets", "-"))), None)


def _unsized(source: dict[str, Any], settings: Settings) -> bool:
    """Whether nothing says how large the objects of a set are."""
    told = _table(source, settings) or _assets(source, settings)
    return source.get("unsized", False) and told is None


def _repaired(given: Sequence[Given], settings: Settings, candidates: int) -> tuple[list[Row], list[Row], float]:
    scenes: list[Row] = []
    objects: list[Row] = []
    began = time.perf_counter()
    for k in range(0, len(given), CHUNK):
        some = given[k : k + CHUNK]
        done = repair_many(
            [each.scene for each in some],
            soft=True,
            candidates=candidates,
            seed=settings.seed,
            device=settings.device,
        )
        for each, repair in zip(some, done, strict=True):
            scenes.append(scene_row(each.name, repair, each.about))
            objects += object_rows(each.name, repair)
    return scenes, objects, time.perf_counter() - began


def _tell(
    name: str,
    bodies: str,
    scenes: Sequence[Row],
    objects: Sequence[Row],
    seconds: float,
    shares: list[Row],
    kinds: list[Row],
    left: list[Row],
) -> Row:
    """Add the rows about a set; returns that of the shares."""
    found, where = summary(scenes, objects), {"source": name, "bodies": bodies}
    row = {
        **where,
        "scenes": found["scenes"],
        "objects": found["objects"],
        "before": found["share_valid_before"],
        "after": found["share_valid_after"],
        "infeasible": found["infeasible"],
        "of_feasible": found["share_valid_of_feasible"],
        "kept": found["relations"]["share"],
        "relations": found["relations"]["before"],
        "near_after": found["relations_nearly"]["share"],
        "p50": found["movement_all"]["p50"],
        "p90": found["movement_all"]["p90"],
        "most": found["movement_all"]["max"],
        "moved_p50": found["movement_moved"]["p50"],
        "moved": found["share_moved"],
        "seconds": seconds,
    }
    shares.append(row)
    kinds += [{**where, "when": when, **found[f"violations_{when}"]} for when in ("before", "after")]
    for scene in scenes:
        if not scene["valid_after"]:
            why = {k: scene[v] for k, v in (("scene", "scene"), ("explanation", "explanation"))}
            left.append({**where, **why, "proved": "yes" if scene["proved_infeasible"] else "no"})
    return row


def _missed(bodies: str, row: Row) -> list[str]:
    """The bounds that were not reached."""
    missed = []
    if row["of_feasible"] is not None and row["of_feasible"] < VALID:
        missed.append(f"{bodies}: {row['of_feasible']:.2%} valid of what is not proved infeasible, not {VALID:.0%}")
    if row["p50"] is not None and row["p50"] > MOVEMENT:
        missed.append(f"{bodies}: a median movement of {100 * row['p50']:.1f} cm, not {100 * MOVEMENT:g}")
    if row["kept"] is not None and row["kept"] < KEPT:
        missed.append(f"{bodies}: {row['kept']:.1%} of the relations hold, not {KEPT:.0%}")
    return missed


def _swept(given: Sequence[Given], settings: Settings, candidates: int) -> Row:
    scenes, objects, seconds = _repaired(given, settings, candidates)
    found = summary(scenes, objects)
    return {
        "candidates": candidates,
        "of_feasible": found["share_valid_of_feasible"],
        "kept": found["relations"]["share"],
        "p50": found["movement_all"]["p50"],
        "mean": sum(row["distance"] for row in objects) / len(objects),
        "seconds": seconds,
    }
