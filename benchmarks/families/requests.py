"""Requests as people write them: what was asked, what is so in the room, and whether the rest was reported."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from benchmarks.judging import Judge
from benchmarks.parallel import each
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.agent import design
from sceneweaver.knowledge.load import read_yaml

FILE = Path(__file__).parents[1] / "requests.yaml"

COLUMNS = (
    Column("number", "no.", "count"),
    Column("request", "request"),
    Column("room", "room"),
    Column("objects", "objects", "count"),
    Column("physical", "faults", "count"),
    Column("asked", "asked", "count"),
    Column("met", "met", "count"),
    Column("seconds", "s", "number"),
)
REPORTED = (COLUMNS[0], Column("reported", "reported as unmet or not understood"))

LONGEST = {"request": 54, "reported": 104}
"""Characters of a cell; what is longer is cut."""


def requests() -> list[str]:
    """All requests of the file."""
    return read_yaml(FILE.read_text(encoding="utf-8"))


def run(settings: Settings, judge: Judge) -> Result:
    """Design every request and compare what was asked with what is there."""
    del judge
    result = Result(
        "requests",
        "Requests in words",
        "What a request asks for: things with their counts, relations, what must not be there, size, people. Met as "
        "the critic measures it; what is not met or not understood is reported with the scene. Faults are physical "
        "ones, by the judge.",
    )
    texts = requests()[:1] if settings.quick else requests()
    calls = [(text, settings, settings.seed + number) for number, text in enumerate(texts)]
    tabulate(result, each(row_of, calls, settings.jobs))
    return result


def tabulate(result: Result, rows: list[dict[str, Any]]) -> None:
    """Put the rows of all requests into two tables: what was asked and met, and what was reported."""
    table = result.add("requests", "Requests", COLUMNS)
    said = result.add("reported", "Reported", REPORTED)
    for number, row in enumerate(rows, 1):
        table.rows.append({**row, "number": number, "request": _cut(row["request"], LONGEST["request"])})
        if row["reported"]:
            said.rows.append({"number": number, "reported": _cut(row["reported"], LONGEST["reported"])})
    met = sum(row["asked"] == row["met"] for row in rows)
    result.notes.append(
        f"All that was asked is so in {met} of {len(rows)}; words that were not understood stand in quotes."
    )


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 1].rstrip() + "…"


def row_of(text: str, settings: Settings, seed: int) -> dict[str, Any]:
    """Design one request and compare."""
    began = time.perf_counter()
    made = design(text, seed=seed, device=settings.device, candidates=settings.most)
    brief = made.brief
    asked = len(brief.entities) + len(brief.relations) + len(brief.exclusions)
    said = (brief.size, brief.area, brief.people, brief.shape, brief.height, brief.windows)
    asked += sum(value is not None for value in said)
    physical = [v for v in made.report.violations if v.hard and v.relation is None and v.kind != "dropped"]
    reported = [*made.unmet, *(f"'{word.words}'" for word in brief.unread)]
    return {
        "request": text,
        "room": made.scene.room.type,
        "objects": made.report.placed,
        "physical": len(physical),
        "asked": asked,
        "met": max(0, asked - len(made.unmet)),
        "reported": "; ".join(reported),
        "seconds": time.perf_counter() - began,
    }
