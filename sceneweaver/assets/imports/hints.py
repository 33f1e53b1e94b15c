"""What is known of a mesh before it is looked at: from a manifest, another library's metadata, or the user."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

Axis = str  # "x", "-x", "y", "-y", "z", "-z"
AXES = ("x", "-x", "y", "-y", "z", "-z")


@dataclass(frozen=True)
class SeenFront:
    """Where someone who looked at a mesh sees its front: quarter turns counter-clockwise from where its shape says that
    it is, how sure (0 to 1), and who looked."""

    quarters: int
    confidence: float
    by: str


@dataclass(frozen=True)
class Hints:
    """Facts about one mesh file; None is "not known", and is then found out from the geometry.

    ``metres`` are metres per unit; ``size`` is the wanted (depth, width, height) [m] with None where free;
    ``yaw`` [rad] is turned on top of ``front``; ``transform`` is a 4x4 matrix applied to the file's vertices first.
    ``seen`` counts only where there is no ``front``.
    """

    path: Path
    name: str
    category: str | None = None
    description: str = ""
    up: Axis | None = None
    front: Axis | None = None
    yaw: float = 0.0
    metres: float | None = None
    size: tuple[float | None, float | None, float | None] = (None, None, None)
    transform: tuple[tuple[float, ...], ...] | None = None
    mass: float | None = None
    friction: float | None = None
    mount: str | None = None
    source: str = "folder"
    licence: str = "unknown"
    attribution: str = ""
    attributes: dict[str, Any] = field(default_factory=dict)
    hulls: tuple[Path, ...] = ()
    seen: SeenFront | None = None

    def with_(self, **changes: Any) -> Hints:
        """The same with the changes that are not None."""
        return replace(self, **{k: v for k, v in changes.items() if v is not None})
