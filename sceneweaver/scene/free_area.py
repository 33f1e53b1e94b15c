"""Floor that a scene keeps free: room to turn, to play, to walk, to open and to pass."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from itertools import combinations, product
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from .base import FrozenModel
from .catalogue import CATALOGUE
from .fields import Id, Length, Name
from .limits import MAX_OBJECTS
from .objects import Pose
from .relation import Relation

FreeAreaKind = Literal["rectangle", "circle", "clearance", "gap", "path"]


class FreeArea(FrozenModel):
    """Floor that nothing taller than a rug stands on.

    A ``rectangle`` or ``circle`` lies at its pose, at its targets if it has some: the layout moves it with the
    furniture. A ``clearance`` is a strip along sides of each target. A ``gap`` lies between each target and each of the
    others, or between any two targets where there are no others. A ``path`` leads from a target to each of the others,
    or from the doors to all that stands on the floor. What is not in the scene does not count, so things may come and
    go.

    Examples:
        >>> import sceneweaver as sw
        >>> turning = sw.scene.FreeArea(id="turning", kind="circle", size=(1.5, 1.5))
        >>> turning.targets
        ()
    """

    _noun: ClassVar[str] = "free area"

    id: Id = Field(description="Unique among free areas")
    kind: FreeAreaKind
    size: tuple[Length, Length] = Field(
        description="Along its front and across [m]; the diameter of a circle or the least width of other kinds, twice"
    )
    most: Length | None = Field(default=None, description="Largest width of a gap or path [m]; null: any")
    pose: Pose = Field(
        default=Pose.model_construct(position=(0.0, 0.0, 0.0), quaternion=(0.0, 0.0, 0.0, 1.0)),
        description="Middle of a rectangle or circle, on the floor",
    )
    targets: Annotated[tuple[Name, ...], Field(max_length=MAX_OBJECTS)] = Field(
        default=(), description='Ids of objects, doors or windows, or "wall" or "middle"'
    )
    others: Annotated[tuple[Name, ...], Field(max_length=MAX_OBJECTS)] = Field(
        default=(), description="On the other side of a gap, at the end of a path; named like targets"
    )
    side: Literal["front", "back", "left", "right", "sides", "long", "around", "any"] = Field(
        default="any", description="Which sides of the targets; sides: left and right, long: both that are longer"
    )
    request: Name | None = Field(default=None, description="Id of what the request states; null: of nothing")

    def sides_of(self, depth: float, width: float) -> tuple[str, ...]:
        """The sides that a clearance is about, of a target of that depth along its front and that width [m]."""
        if self.side == "around":
            return ("front", "back", "left", "right")
        if self.side == "sides":
            return ("left", "right")
        if self.side == "long":
            return ("left", "right") if depth >= width else ("front", "back")
        return ("front",) if self.side == "any" else (self.side,)

    def pairs(self, ids: Collection[str], relations: Iterable[Relation]) -> list[tuple[str, str]]:
        """The pairs of things that a gap lies between, of those with some ids.

        Two of the targets that relations put nearer to each other than the gap (a row of racks) stand in one row.
        """
        here = [name for name in dict.fromkeys(self.targets) if name in ids]
        if self.others:
            there = [name for name in dict.fromkeys(self.others) if name in ids]
            return [(a, b) for a, b in product(here, there) if a != b]
        rows = _rows(relations, self.size[0])
        return [(a, b) for a, b in combinations(here, 2) if a not in rows or rows[a] != rows.get(b)]


def _rows(relations: Iterable[Relation], gap: float) -> dict[str, str]:
    """For each object that a relation puts nearer to another than a gap [m] the object that its row is named by."""
    parent: dict[str, str] = {}

    def row(name: str) -> str:
        while parent.setdefault(name, name) != name:
            name = parent[name]
        return name

    for relation in relations:
        spec = CATALOGUE[relation.type]
        if isinstance(relation.target, str) and spec.target_kind == "object" and "gap" in spec.params:
            span = spec.value(relation, "gap")
            if span is not None and (isinstance(span, str) or span[1] < gap):
                parent[row(relation.subject)] = row(relation.target)
    return {name: row(name) for name in list(parent)}
