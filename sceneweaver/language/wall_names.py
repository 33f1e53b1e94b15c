"""Which way a wall is that a request names."""

from __future__ import annotations

from sceneweaver.scene import Room

COMPASS = {"north": (0.0, 1.0), "south": (0.0, -1.0), "east": (1.0, 0.0), "west": (-1.0, 0.0)}


def direction_of(name: str, room: Room) -> tuple[float, float] | None:
    """Unit vector out of the room through the wall of that name: a compass point, or as one sees it who comes in by
    the first door (left, right, far, opposite, back, near, front); None for another name."""
    x, y = room.walls[room.doors[0].wall if room.doors else 0].inward
    ahead, behind = (x, y), (-x, -y)
    seen = {"far": ahead, "opposite": ahead, "back": ahead, "near": behind, "front": behind}
    return (seen | {"left": (-y, x), "right": (y, -x)} | COMPASS).get(name)
