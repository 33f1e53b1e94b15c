"""docs/models_rooms.md from the rooms of ``python -m benchmarks by_model``: requests, both rooms, the run to read.

python -m benchmarks.model_rooms_page out/benchmarks/by_model
"""

from __future__ import annotations

import argparse
import json
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from benchmarks.gallery import IMAGES
from benchmarks.rooms_by_model import Room, rooms
from benchmarks.settings import ROOT
from sceneweaver.agent.memory import Memory, Step
from sceneweaver.agent.transcript import calls_of
from sceneweaver.llm.records import read_records

PAGE = ROOT / "docs" / "models_rooms.md"
LINE, CELL = 120, 400
"""Characters of a line, and of what one call came to."""

SHOWN = "eye level, from a corner"
"""Title of the picture that is taken."""


def page(folder: Path, eyes: Mapping[str, str]) -> str:
    """The page: each room with its request, pictures, what eyes say, and the steps of the run with the model."""
    parts = [
        "# Five rooms with a model and without",
        _wrapped(
            "The rooms of `python -m benchmarks by_model` ([table](models.md#five-rooms)): first by rules alone, then "
            "with the scripted model, whose replies were written after a look at what it was shown "
            "(`benchmarks/data/by_model/`). What follows each pair is the run with the model as its files tell it: "
            "what was planned, what each call came to, what was kept. `python -m benchmarks.model_rooms_page` makes "
            "this page."
        ),
    ]
    for room in rooms().values():
        parts += _room(room, folder / room.name, eyes.get(room.name, ""))
    return "\n\n".join(parts) + "\n"


def _room(room: Room, folder: Path, eyes: str) -> Iterator[str]:
    state = json.loads((folder / "model" / "state.json").read_text("utf-8"))
    metrics = json.loads((folder / "model" / "metrics.json").read_text("utf-8"))
    memory, used = Memory.model_validate(state["memory"]), metrics["models"]
    yield f"## {room.name.replace('_', ' ').capitalize()}"
    yield "\n".join(textwrap.wrap(room.prompt, LINE - 2, initial_indent="> ", subsequent_indent="> "))
    for side in ("rules", "model"):
        words = f"By {side}" if side == "rules" else "With the model"
        yield f"![{words}: {room.name.replace('_', ' ')}](images/by_model/{room.name}-{side}.jpg)"
    if eyes:
        yield _wrapped(f"**Seen by eye:** {eyes}")
    rows = [f"- {_plain(row)}" for row in used["disagreements"][:6]]
    if rows:
        more = len(used["disagreements"]) - len(rows)
        rows += [f"- and {more} more"] if more > 0 else []
        yield "Where the readers disagree:"
        yield "\n".join(_wrapped(row, "  ") for row in rows)
    for step in memory.steps:
        yield from _step(step, folder / "model" / "steps" / f"{step.number:02}" / "review.json")
    yield _wrapped(_sentence(f"The run ended: {_plain(memory.finished)}"))
    refused = [
        f"- `{record['purpose']}`: {_plain(attempt['refused'])}"
        for record in read_records(folder / "model" / "llm")
        for attempt in record["attempts"]
        if attempt.get("refused")
    ]
    if refused:
        yield "Answers that were refused on the way:"
        yield "\n".join(_wrapped(row, "  ") for row in refused)


def _step(step: Step, review: Path) -> Iterator[str]:
    thought = step.plan
    by = thought.by if thought is not None else "rules"
    problem = f" {_plain(thought.problem)}" if thought is not None and thought.problem else ""
    yield _wrapped(f"**Step {step.number}**, planned by {by}.{problem}")
    lines = [
        _wrapped(f"- {call.confidence:.2f} `{call.tool}`: {_plain(call.instruction)} → {_plain(outcome)}", "  ")
        for call, outcome in calls_of(step)
    ]
    yield "\n".join(lines)
    kept = "Kept" if step.accepted else f"Rolled back: {_plain(step.note)}"
    grades = ", ".join(f"{name} {grade:.1f}" for name, grade in step.after.items())
    seen = json.loads(review.read_text("utf-8")).get("seen") if review.exists() else None
    sight = ", ".join(f"{name} {grade:.1f}" for name, grade in seen["grades"].items()) if seen else ""
    yield _wrapped(f"{kept}. {step.objects} objects; {grades}{f'; seen: {sight}' if sight else ''}.")


def _sentence(text: str) -> str:
    return text if text.endswith(".") else f"{text}."


def _plain(text: str) -> str:
    """Text as one line in which no Markdown begins."""
    flat = " ".join(text.split())
    flat = flat if len(flat) <= CELL else flat[: CELL - 1] + "…"
    return "".join(f"\\{c}" if c in "\\`*[]<>#_" else c for c in flat)


def _wrapped(text: str, indent: str = "") -> str:
    return "\n".join(
        textwrap.wrap(text, LINE, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
    )


def picture(records: Path, to: Path) -> None:
    """What the critic was shown last at eye level, as a light JPEG."""
    from PIL import Image

    looks = [record for record in read_records(records) if record["purpose"] == "look"]
    name = next(part["picture"] for part in looks[-1]["content"] if part.get("title", "").startswith(SHOWN))
    to.parent.mkdir(parents=True, exist_ok=True)
    with Image.open(records / "pictures" / name) as drawn:
        drawn.convert("RGB").save(to, quality=82, optimize=True)


def main() -> int:
    """Write pictures and page."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="of the rooms")
    options = parser.parse_args()
    eyes: dict[str, Any] = {name: room.eyes for name, room in rooms().items()}
    for name in rooms():
        for side, records in {"rules": "looks", "model": "model/llm"}.items():
            picture(options.folder / name / records, IMAGES / "by_model" / f"{name}-{side}.jpg")
    PAGE.write_text(page(options.folder, eyes), "utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
