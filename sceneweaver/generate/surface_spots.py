"""A free place for one thing more on furniture that carries others: what is added singly, or stands there anew."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from sceneweaver.geometry.polygons import counter_clockwise, rectangle
from sceneweaver.scene import Pose, Room, SceneObject, Support, Surface

from .carry import carried, has_place, world
from .surface_field import Array, Field, Piece, Prism, Shape
from .surface_scene import clear_space, on_surface, solids_of

GAP = 0.01
"""Gap [m] that is left between things on a surface, and to its edge."""

LIFT = 0.005
"""Height [m] that is left under a board."""

FINEST = 22
"""Candidates along each side of a surface."""

CHANCE = 0.8
"""How much chance weighs against a place toward the back: what is added singly is off the place of who sits there."""


def spot_on(
    objects: Mapping[str, SceneObject], room: Room, supports: Sequence[str], size: tuple[float, float, float], seed: int
) -> tuple[Support, Pose] | None:
    """A free place for a box of that size (depth, width, height) [m].

    Supports are tried as they come, of each its roomiest surface first. Returns what it stands on and its world pose,
    or None when it fits nowhere.
    """
    box = Shape((Prism(counter_clockwise(rectangle(*size[:2])), 0.0, size[2]),), size)
    for id in supports:
        carrier = objects[id]
        # Where a carrier waits for its place in the room, nothing is known to be above it but what it carries.
        near = {*carried(objects, id)}
        if has_place(carrier):
            near |= {other for other, o in objects.items() if has_place(o)}
        there = [p for i in near - {id} for p in solids_of(objects[i], zones=False)]
        there += [p for _, p in clear_space(room, doors=False)] if has_place(carrier) else []
        own = [p for p in solids_of(carrier, zones=False)]
        for surface in sorted(carrier.surfaces, key=_room_on, reverse=True):
            if not fits_on(surface, size):
                continue
            field = on_surface(carrier, surface, [*there, *own], edge=GAP / 2)
            rng = random.Random(f"{seed} {id} {surface.name}")
            for yaw in (0.0, math.pi / 2):  # facing as the carrier does, else turned by a quarter
                piece = Piece(box, yaw)
                at = None if field.empty else field.place([piece], _toward_the_back(field, piece, rng), GAP)
                if at is not None:
                    pose = world(carrier.pose, float(at[0]), float(at[1]), surface.z, yaw)
                    return Support(object=id, surface=surface.name), pose
    return None


def _toward_the_back(field: Field, piece: Piece, rng: random.Random) -> Iterator[Array]:
    """A grid over a surface, by how far a place is from its back, and by chance."""
    low, high = piece.box
    first, last = field.low - low, field.high - high
    if (last < first).any():
        return
    grid = np.stack(np.meshgrid(*np.linspace(first, last, FINEST).T, indexing="ij"), axis=-1).reshape(-1, 2)
    back = (grid[:, 0] - first[0]) / max(float(last[0] - first[0]), 1e-6)
    yield grid[np.argsort(back + CHANCE * np.array([rng.random() for _ in grid]), kind="stable")]


def fits_on(surface: Surface, size: tuple[float, float, float]) -> bool:
    """Whether an empty surface could carry a box of that size (depth, width, height) [m], as far as its bounds say."""
    if surface.headroom is not None and surface.headroom < size[2] + LIFT:
        return False
    room = sorted(np.ptp(np.asarray(surface.polygon), axis=0).tolist())
    own = sorted(size[:2])
    return room[0] >= own[0] and room[1] >= own[1]


def _room_on(surface: Surface) -> float:
    import shapely

    return shapely.Polygon(surface.polygon).area + 0.2 * surface.z
