"""Which way a wall is that a request names."""

from __future__ import annotations

from sceneweaver.scene import Room

COMPASS = {"north": (0.0, 1.0), "south": (0.0, -1.0), "east": (1.0, 0.0), "west": (-1.0, 0.0)}


def direction_of(name: str, room: Room) -> tuple[float, float] | None:
    """Unit vector out of the room through the wall of that name: a compass point, or as one sees it who comes in by
    the first door (left, right, far, opposite, back, near, front); "long-0" and "long-1" are the two long ones,
    "short-0" and "short-1" the others; None for another name."""
    x, y = room.walls[room.doors[0].wall if room.doors else 0].inward
    ahead, behind = (x, y), (-x, -y)
    seen = {"far": ahead, "opposite": ahead, "back": ahead, "near": behind, "front": behind}
    sides = [max(p[k] for p in room.outline) - min(p[k] for p in room.outline) for k in (0, 1)]
    over, along = ((0.0, 1.0), (1.0, 0.0)) if sides[0] >= sides[1] else ((1.0, 0.0), (0.0, 1.0))
    for k, sign in enumerate((1.0, -1.0)):
        seen[f"long-{k}"], seen[f"short-{k}"] = ((sign * way[0], sign * way[1]) for way in (over, along))
    return (seen | {"left": (-y, x), "right": (y, -x)} | COMPASS).get(name)
