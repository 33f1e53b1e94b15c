"""What comes of a plan of another system: a home, what was assumed, and the plan as its file has it."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.home import Home

from ..model import SourceRoom


@dataclass(frozen=True)
class ImportedHome:
    """A home of another system, and what became of its plan.

    ``notes`` say in one line each what was assumed, changed or left out; ``raw`` are the rooms as the file has them,
    with their openings and objects, metres.
    """

    home: Home
    format: str
    notes: tuple[str, ...]
    raw: tuple[SourceRoom, ...]
