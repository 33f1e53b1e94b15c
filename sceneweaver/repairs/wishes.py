"""What a repair is to keep where it can: soft relations that hold or nearly do, and objects square to the room."""

from __future__ import annotations

import math
from collections.abc import Iterable

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import Scene
from sceneweaver.verify.relations import nearly_holds
from sceneweaver.verify.solids import Placed

NEARLY = 0.3  # [m] by which a soft relation may be missed that a repair is to mend, too


def holding(scene: Scene, numbers: Iterable[int] | None = None, slack: float = 0.0) -> frozenset[int]:
    """The numbers of the soft relations, or of those of ``numbers``, that hold in a scene by the judge.

    With ``slack`` [m] also those that are missed by so much at most.
    """
    chosen = [k for k, r in enumerate(scene.relations) if not r.hard] if numbers is None else list(numbers)
    if not chosen:
        return frozenset()
    placed = Placed.of(scene)
    return frozenset(k for k in chosen if nearly_holds(placed, scene.relations[k], slack))


SQUARE = math.radians(0.5)  # by which an object may be off the direction of a wall and count as square to it


def squared(scene: Scene) -> frozenset[int]:
    """The numbers of the objects that are parallel to a wall, or at right angles to it, and may turn."""
    walls = [math.atan2(wall.inward[1], wall.inward[0]) for wall in walls_of(scene.room.outline)]
    quarter = math.pi / 2

    def off(yaw: float) -> float:
        return min(abs((yaw - wall + quarter / 2) % quarter - quarter / 2) for wall in walls)

    loose = [i for i, o in enumerate(scene.objects) if not o.fixed and o.yaw_domain is None]
    return frozenset(i for i in loose if off(scene.objects[i].pose.yaw) <= SQUARE)
