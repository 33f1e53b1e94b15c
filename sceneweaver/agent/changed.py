"""What a design changed of the scene that it began with."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from statistics import median
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Scene

LEAST_MOVE, LEAST_TURN, LEAST_SIZE = 1e-3, math.radians(0.1), 1e-3
"""Distance [m], angle [rad] and extent [m] from which on something counts as changed."""

NAMED = 6
"""Ids that a line names."""


@dataclass(frozen=True)
class Shift:
    """How far an object of the first scene went: in space [m], and turned counter-clockwise [degrees]."""

    id: str
    distance: float
    turn: float


@dataclass(frozen=True)
class Start:
    """The scene that a design began with, and what is left of it.

    Attributes:
        name: the file, model or library scene.
        objects: how many it had.
        moved: those that are elsewhere by a millimetre or a tenth of a degree, or more.
        resized: ids of those of other extents.
        exchanged: ids of those with another body or of another category.
        added: ids of what it did not have.
        removed: ids of what is gone.
        room: what is other about outline, height and openings, in words; empty: nothing.

    Examples:
        >>> import sceneweaver as sw
        >>> result = sw.design("a bedroom", start=sw.Scene.example("bedroom"), steps=1, candidates=8, device="cpu")
        >>> result.start.objects, result.start.removed
        (16, ())
    """

    name: str
    objects: int
    moved: tuple[Shift, ...] = ()
    resized: tuple[str, ...] = ()
    exchanged: tuple[str, ...] = ()
    added: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()
    room: str = ""

    @property
    def lines(self) -> tuple[str, ...]:
        """What was changed, a line for each kind of change."""
        stayed = self.objects - len(self.removed) - len({s.id for s in self.moved})
        said = [f"{self.name}: {stayed} of {self.objects} objects stand where they stood"]
        if self.moved:
            far = [s.distance for s in self.moved]
            said.append(f"moved {len(far)}, by {median(far):.2f} m in the median and {max(far):.2f} m at most")
        for word, ids in (
            ("resized", self.resized),
            ("exchanged", self.exchanged),
            ("removed", self.removed),
            ("added", self.added),
        ):
            if ids:
                more = f" and {len(ids) - NAMED} more" if len(ids) > NAMED else ""
                said.append(f"{word} {len(ids)}: {', '.join(ids[:NAMED])}{more}")
        return (*said, *([self.room] if self.room else []))

    def to_dict(self) -> dict[str, Any]:
        """As JSON data: the key ``start`` of ``metrics.json``."""
        data = asdict(self)
        data["moved"] = [{k: v if k == "id" else round(v, 4) for k, v in row.items()} for row in data["moved"]]
        return {k: list(v) if isinstance(v, tuple) else v for k, v in data.items()}


def start_of(name: str, before: Scene, after: Scene) -> Start:
    """What became of a scene; objects are told by their ids.

    Args:
        name: what it is called.
        before: as it came.
        after: as the design left it.
    """
    old, new = {o.id: o for o in before.objects}, {o.id: o for o in after.objects}
    both = [name for name in old if name in new]
    moved = []
    for one in both:
        a, b = old[one].pose, new[one].pose
        distance, turn = math.dist(a.position, b.position), wrap_angle(b.yaw - a.yaw)
        if distance >= LEAST_MOVE or abs(turn) >= LEAST_TURN:
            moved.append(Shift(one, distance, math.degrees(turn)))
    return Start(
        name=name,
        objects=len(old),
        moved=tuple(moved),
        resized=tuple(
            one
            for one in both
            if max(abs(a - b) for a, b in zip(old[one].size, new[one].size, strict=True)) >= LEAST_SIZE
        ),
        exchanged=tuple(
            one for one in both if (old[one].asset, old[one].category) != (new[one].asset, new[one].category)
        ),
        added=tuple(one for one in new if one not in old),
        removed=tuple(one for one in old if one not in new),
        room=_room(before, after),
    )


def _room(before: Scene, after: Scene) -> str:
    a, b, said = before.room, after.room, list[str]()
    if a.outline != b.outline:
        said.append("its outline")
    if abs(a.height - b.height) >= LEAST_SIZE:
        said.append(f"its height from {a.height:.2f} to {b.height:.2f} m")
    for word, mine, theirs in (("doors", a.doors, b.doors), ("windows", a.windows, b.windows)):
        if mine != theirs:
            said.append(f"{word} from {len(mine)} to {len(theirs)}" if len(mine) != len(theirs) else f"its {word}")
    return f"the room: {', '.join(said)} changed" if said else ""
