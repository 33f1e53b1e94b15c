"""What a user asks of a drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple
from urllib.parse import quote


class Size(NamedTuple):
    """Depth along the front, width, height [m]."""

    depth: float
    width: float
    height: float


@dataclass(frozen=True)
class Request:
    """What a user asks of an asset; None leaves the choice to the seed.

    ``shape`` is a name of ``looks.yaml``, ``parts`` are counted ones (("drawers", 3), ...); a drawing that cannot show
    them leaves them out. ``label`` is what a body that stands for an unknown noun is called. ``palette`` is the code of
    the room's, which all that is not asked otherwise follows. Pieces of one ``suite`` (any number) match, of whatever
    category: fronts, handles and worktops of a kitchen. ``mirrored`` turns left into right: a door then hangs at its
    other side. ``posture`` is one of `postures`, or one that drawings of the category know: a curtain that is drawn.
    ``details`` are looks of parts, (("top", "black marble"), ...), by the names of ``looks.yaml``.
    """

    size: tuple[float | None, float | None, float | None] = (None, None, None)
    color: str | None = None
    material: str | None = None
    style: str | None = None
    shape: str | None = None
    parts: tuple[tuple[str, int], ...] = ()
    label: str | None = None
    palette: str | None = None
    suite: int | None = None
    mirrored: bool = False
    posture: str | None = None
    details: tuple[tuple[str, str], ...] = ()

    @property
    def bare(self) -> Request:
        """What of it a drawing sees: size, shape, parts, label, hand and posture."""
        return replace(self, color=None, material=None, style=None, palette=None, suite=None, details=())

    @property
    def suffix(self) -> str:
        """The request as the end of an asset id; empty when nothing is asked."""
        parts = []
        if any(v is not None for v in self.size):
            parts.append("size=" + ",".join("" if v is None else f"{v:g}" for v in self.size))
        named = ("color", "material", "style", "shape", "label")
        parts += [f"{k}={quote(v)}" for k in named if (v := getattr(self, k)) is not None]
        if self.parts:
            parts.append("parts=" + ",".join(f"{name}:{count}" for name, count in self.parts))
        if self.palette is not None:
            parts.append("palette=" + quote(self.palette, safe="/,"))
        if self.suite is not None:
            parts.append(f"suite={self.suite}")
        if self.details:
            parts.append("details=" + ",".join(f"{name}:{quote(look)}" for name, look in self.details))
        if self.posture is not None:
            parts.append("posture=" + quote(self.posture))
        if self.mirrored:
            parts.append("mirrored=1")
        return "".join(f"&{part}" for part in parts)
