"""What an edit of a live session did."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sceneweaver.repairs import Move
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

Freed = Literal["nothing", "edited", "named", "both", "anywhere", "all"]
"""What was free to move in the end: nothing at all, what was edited, what violations named, both, what was added
anywhere in the room, or everything."""


@dataclass(frozen=True)
class EditResult:
    """A scene after an edit.

    Attributes:
        scene: the scene as it is now.
        report: the judge on it; without the share of floor that can be walked on.
        moves: what was moved so that the scene is valid, beyond the edit itself.
        freed: what was free to move in the end, see `Freed`.
        seconds: from call to return.

    Examples:
        >>> import sceneweaver as sw
        >>> session = sw.EditSession(sw.Scene.example("bedroom"), device="cpu")
        >>> result = session.move("chair", by=(0.0, 0.05))
        >>> result.valid, result.scene is session.scene
        (True, True)
    """

    scene: Scene
    report: Report
    moves: tuple[Move, ...]
    freed: Freed
    seconds: float

    def __repr__(self) -> str:
        valid = "valid" if self.valid else f"{sum(v.hard for v in self.report.violations)} violations"
        return f"EditResult({valid}, {len(self.moves)} moved, {1e3 * self.seconds:.0f} ms)"

    @property
    def valid(self) -> bool:
        """Whether the judge calls the scene valid."""
        return self.report.valid
