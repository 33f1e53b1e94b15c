"""Five requests by rules and with a scripted model that reads, plans, fills in tools, learns rooms and looks."""

from __future__ import annotations

from statistics import fmean
from typing import Any

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.rooms_by_model import Pair, pair, rooms
from benchmarks.settings import Settings

CRITERIA = ("realism", "functionality", "layout", "completion")
QUICK = "podcast_studio"

COLUMNS = (
    Column("room", "request"),
    Column("side", "by"),
    Column("kind", "made as"),
    Column("valid", "valid"),
    Column("objects", "objects", "count"),
    Column("met", "met", "count"),
    Column("asked", "of", "count"),
    *(Column(name, name[:4] + ".", "number") for name in CRITERIA),
    *(Column(f"seen_{name}", f"seen {name[:4]}.", "number") for name in CRITERIA),
    Column("steps", "steps", "count"),
    Column("calls", "calls", "count"),
    Column("tokens", "tokens", "count"),
    Column("seconds", "s", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Design each request twice."""
    del judge
    result = Result(
        "by_model",
        "With a model and without",
        "Each request once by rules alone and once with a model that reads it, plans, fills in tools and looks at "
        "the room. The model is a server that speaks chat completions and says what was written down for these "
        "requests. Met is measured with the same reading of the request, the model's, for both; grades are the "
        "symbolic critic's by that side's own reading, 'seen' is what was written down after a look at its pictures.",
    )
    table = result.add("rooms", "Rooms", COLUMNS, keys=2)
    chosen = [rooms()[QUICK]] if settings.quick else [*rooms().values()]
    options: dict[str, Any] = {"steps": 2, "candidates": 8} if settings.quick else {}
    for room in chosen:
        made = pair(room, settings.out / "by_model" / room.name, looks=not settings.quick, **options)
        table.rows += rows(made)
        result.failures += [f"{room.name} by {s.side}: not valid" for s in made.sides if not s.metrics["valid"]]
        if made.missing:
            result.notes.append(f"{room.name}: no replies for {', '.join(made.missing)}; they were refused.")
        if made.changed:
            result.notes.append(
                f"{room.name}: replies were written for other words of the questions {', '.join(made.changed)}."
            )
    for side in ("rules", "model"):
        mine = [row for row in table.rows if row["side"] == side]
        share = fmean(row["met"] / max(1, row["asked"]) for row in mine)
        result.notes.append(f"By {side}: {share:.0%} of what is asked is met, mean over the requests.")
    return result


def rows(made: Pair) -> list[dict[str, Any]]:
    """A row for each side."""
    found: list[dict[str, Any]] = []
    for side in made.sides:
        metrics = side.metrics
        usage = (metrics.get("models") or {}).get("usage", {})
        found.append(
            {
                "room": made.room.name,
                "side": side.side,
                "kind": side.scene.room.type,
                "valid": "yes" if metrics["valid"] else "no",
                "objects": len(side.scene.objects),
                "met": side.met,
                "asked": side.asked,
                **{name: metrics["scores"][name] for name in CRITERIA},
                **{f"seen_{name}": side.seen.get(name) for name in CRITERIA},
                "steps": side.steps,
                "calls": usage.get("calls", 0),
                "tokens": usage.get("tokens_in", 0) + usage.get("tokens_out", 0),
                "seconds": side.seconds,
            }
        )
    return found
