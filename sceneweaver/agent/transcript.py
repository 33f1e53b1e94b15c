"""``llm/transcript.md``: what the planner thought before each step, and what came of it, to read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sceneweaver.io.messages import shorten

from .memory import Call, Memory, Step, Thought

CELL = 400
"""Characters of a cell of a table."""

NAME = "transcript.md"


def transcript(prompt: str, memory: Memory, read_by: str, disagreements: Sequence[str]) -> str:
    """A run as Markdown. Equal runs give equal text."""
    parts = [f"# {_line(prompt, 200)}", f"The request was read by {_line(read_by)}."]
    if disagreements:
        parts.append("Where the readers disagree:\n\n" + "\n".join(f"- {_line(row)}" for row in disagreements))
    parts += [part for step in memory.steps for part in _step(step)]
    if memory.finished:
        parts.append(f"The run ended: {_line(memory.finished)}.")
    if memory.notes:
        parts.append("## Notes\n\n" + "\n".join(f"- {_line(note)}" for note in memory.notes))
    return "\n\n".join(parts) + "\n"


def _step(step: Step) -> Iterator[str]:
    thought = step.plan or Thought()
    yield f"## Step {step.number}, planned by {_line(thought.by)}"
    said = [
        ("Last step", thought.last_step),
        ("Solved", thought.solved),
        ("Problem", thought.problem),
        ("Would have stopped", thought.overruled),
        ("Note", thought.note),
    ]
    if any(text for _, text in said):
        yield "\n".join(f"- {name}: {_line(text)}" for name, text in said if text)
    head = "| confidence | tool | instruction | what came of it |\n| --: | --- | --- | --- |"
    yield "\n".join((head, *(_row(call, outcome) for call, outcome in calls_of(step))))
    grades = ", ".join(
        f"{name} {step.before[name]:.1f} to {grade:.1f}" if name in step.before else f"{name} {grade:.1f}"
        for name, grade in step.after.items()
    )
    kept = "Kept" if step.accepted else f"Rolled back: {_line(step.note)}"
    yield f"{kept}. {step.objects} objects, {step.violations} violations; {grades}."


def calls_of(step: Step) -> list[tuple[Call, str]]:
    """The calls that were named before a step, the best first, with what came of each."""
    ranked = step.plan.ranked if step.plan is not None else ()
    calls = list(ranked) or ([step.call] if step.call is not None else [])
    return [(call, _outcome(step.tried[k] if k < len(step.tried) else {})) for k, call in enumerate(calls)]


def _outcome(tried: Mapping[str, Any]) -> str:
    if not tried:
        return "not carried out"
    if "failed" in tried:
        return f"failed: {tried['failed']}"
    outcome = f"grade {tried['grades']['total']:.2f}, {tried['violations']} violations"
    return outcome + "".join(f"; {text}" for text in tried.get("left", ()))


def _row(call: Call, outcome: str) -> str:
    cells = (f"{call.confidence:.2f}", call.tool, call.instruction or call.reason, outcome)
    return "| " + " | ".join(_line(cell).replace("|", "\\|") for cell in cells) + " |"


def _line(text: str, most: int = CELL) -> str:
    """Text as one line in which no Markdown or HTML begins."""
    flat = shorten(" ".join(text.split()), most)
    return "".join(f"\\{c}" if c in "\\`*[]<>#" else c for c in flat)
