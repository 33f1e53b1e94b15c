"""What became of one scene on its way to another."""

from __future__ import annotations

import math

from pydantic import BaseModel, Field

from sceneweaver.scene import Relation, Scene, SceneObject

SOFT = "soft: "
"""Stands before a relation that need not hold."""


class Moved(BaseModel):
    """How far an object went."""

    id: str
    distance: float = Field(description="In the plane [m]")
    rise: float = Field(description="Upwards [m]")
    turn: float = Field(description="Counter-clockwise [degrees]")


class Resized(BaseModel):
    """The size of an object before and after: depth, width, height [m]."""

    id: str
    before: tuple[float, float, float]
    after: tuple[float, float, float]


class Difference(BaseModel):
    """Everything in which two versions of a scene differ."""

    added: list[str] = Field(default=[], description="Ids of objects that are new")
    removed: list[str] = Field(default=[], description="Ids of objects that are gone")
    moved: list[Moved] = []
    resized: list[Resized] = []
    changed: list[str] = Field(default=[], description="Ids of objects that changed in something else")
    related: list[str] = Field(default=[], description="Relations that are new")
    unrelated: list[str] = Field(default=[], description="Relations that are gone")
    room: bool = Field(default=False, description="Whether the room itself changed")

    @property
    def empty(self) -> bool:
        """Whether there is none."""
        return self == Difference()


def difference(before: Scene, after: Scene) -> Difference:
    """What was added, removed, moved, resized, changed and related between two scenes."""
    old, new = ({o.id: o for o in scene.objects} for scene in (before, after))
    both = [(old[name], obj) for name, obj in new.items() if name in old]
    was, now = ([relation_words(r) for r in scene.relations] for scene in (before, after))
    return Difference(
        added=[name for name in new if name not in old],
        removed=[name for name in old if name not in new],
        moved=[_moved(a, b) for a, b in both if a.pose != b.pose],
        resized=[Resized(id=b.id, before=a.size, after=b.size) for a, b in both if a.size != b.size],
        changed=[b.id for a, b in both if _rest(a) != _rest(b)],
        related=_without(now, was),
        unrelated=_without(was, now),
        room=before.room != after.room,
    )


def relation_words(relation: Relation) -> str:
    """A relation as one line: "desk against_wall wall:2", "soft" in front where it need not hold."""
    line = " ".join((relation.subject, relation.type, *relation.targets))
    params = ", ".join(f"{key} {value}" for key, value in (relation.params or {}).items())
    return ("" if relation.hard else SOFT) + line + (f" ({params})" if params else "")


def _moved(a: SceneObject, b: SceneObject) -> Moved:
    (x, y, z), (u, v, w) = a.pose.position, b.pose.position
    turn = math.degrees(math.remainder(b.pose.yaw - a.pose.yaw, 2 * math.pi))
    return Moved(id=b.id, distance=round(math.hypot(u - x, v - y), 4), rise=round(w - z, 4), turn=round(turn, 2))


def _rest(obj: SceneObject) -> dict[str, object]:
    """What of an object is neither pose nor size, nor follows from its size."""
    gone = ("pose", "size", "parts", "zones", "surfaces")
    return {name: getattr(obj, name) for name in type(obj).model_fields if name not in gone}


def _without(lines: list[str], others: list[str]) -> list[str]:
    left, out = list(others), []
    for line in lines:
        left.remove(line) if line in left else out.append(line)
    return out
