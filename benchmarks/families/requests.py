"""Requests as people write them: what was asked, what is so in the room, and whether the rest was reported."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.agent import design
from sceneweaver.knowledge.load import read_yaml

FILE = Path(__file__).parents[1] / "requests.yaml"

COLUMNS = (
    Column("request", "request"),
    Column("room", "room"),
    Column("objects", "objects", "count"),
    Column("physical", "physical faults", "count"),
    Column("asked", "asked", "count"),
    Column("met", "met", "count"),
    Column("reported", "unmet, reported"),
    Column("seconds", "seconds", "number"),
)


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
        "the critic measures it; what is not met or not understood is reported with the scene.",
    )
    table = result.add("requests", "Requests", COLUMNS)
    for number, text in enumerate(requests()[:1] if settings.quick else requests()):
        table.rows.append(_row(text, settings, settings.seed + number))
    result.notes.append("Words that were not understood stand in quotes among what was reported.")
    return result


def _row(text: str, settings: Settings, seed: int) -> dict[str, Any]:
    began = time.perf_counter()
    made = design(text, seed=seed, device=settings.device, candidates=settings.most)
    brief = made.brief
    asked = len(brief.objects) + len(brief.relations) + len(brief.without)
    said = (brief.size, brief.area, brief.people, brief.shape, brief.height, brief.windows)
    asked += sum(value is not None for value in said)
    physical = [v for v in made.report.violations if v.kind not in ("soft_relation", "relation", "dropped")]
    reported = [*made.unmet, *(f"'{word}'" for word in brief.unread)]
    return {
        "request": text,
        "room": made.scene.room.type,
        "objects": made.report.placed,
        "physical": len(physical),
        "asked": asked,
        "met": max(0, asked - len(made.unmet)),
        "reported": "; ".join(reported) or "-",
        "seconds": time.perf_counter() - began,
    }
