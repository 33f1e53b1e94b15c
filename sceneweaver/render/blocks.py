"""What rooms are put together from: prisms with a material each, and the materials of floors, walls and joinery."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.room_looks import FLOORS, RoomLooks, room_looks
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import RoomFinish, Scene

Range = tuple[float, float]


class Builder:
    """Collects convex prisms in the world's frame [m] and turns them into one mesh; all are cut at ``top`` [m]."""

    def __init__(self, top: float = float("inf")) -> None:
        self.top = top
        self._vertices: list[np.ndarray] = []
        self._faces: list[np.ndarray] = []
        self._kinds: list[np.ndarray] = []
        self._materials: dict[Material, int] = {}
        self._count = 0

    def prism(
        self, plan: np.ndarray, z: Range, material: Material, top: Material | None = None, first: Material | None = None
    ) -> None:
        """A convex counter-clockwise ``plan`` [N, 2] from ``z[0]`` to ``z[1]``.

        ``top`` is the look of its lid and ``first`` that of the side from its first corner to the second.
        """
        if z[0] >= self.top - 1e-9:
            return
        z = (z[0], min(z[1], self.top))
        n = len(plan)
        vertices, faces = prism_mesh(plan, z)
        bottom, lid, sides = np.split(faces, (n - 2, 2 * n - 4))
        start = self._join(vertices)
        self._paint(start, np.concatenate([bottom, np.delete(sides, (0, n), axis=0)]), material)
        self._paint(start, sides[[0, n]], first or material)
        self._paint(start, lid, top or material)

    def add(self, vertices: np.ndarray, faces: np.ndarray, material: Material) -> None:
        """Any triangles: ``vertices`` [V, 3], ``faces`` [F, 3]; what is higher than ``top`` is pressed flat to it."""
        self._paint(self._join(np.minimum(vertices, (np.inf, np.inf, self.top))), faces, material)

    def _join(self, vertices: np.ndarray) -> int:
        start = self._count
        self._vertices.append(np.asarray(vertices, dtype=float))
        self._count += len(vertices)
        return start

    def _paint(self, start: int, faces: np.ndarray, material: Material) -> None:
        kind = self._materials.setdefault(material, len(self._materials))
        self._faces.append(np.asarray(faces, dtype=np.int32) + start)
        self._kinds.append(np.full(len(faces), kind, dtype=np.int32))

    def mesh(self) -> Mesh | None:
        """Everything as one mesh, or None when there is nothing."""
        if not self._faces:
            return None
        kinds = np.concatenate(self._kinds)
        faces = np.concatenate(self._faces).astype(np.int32)
        return Mesh(np.concatenate(self._vertices), faces, kinds, np.zeros_like(kinds), tuple(self._materials))


def wall_block(wall: Wall, along: Range, outward: Range) -> np.ndarray:
    """The plan [4, 2] of a block in a wall, counter-clockwise: offsets along it, depths out of the room [m]."""
    return np.array(wall.strip(along[0], along[1] - along[0], -outward[1], -outward[0]))


@dataclass(frozen=True)
class Finishes:
    """Materials of the shell. ``looks`` are those of floor and walls, ``plan`` says where accents and tiles are."""

    looks: RoomLooks
    plan: RoomFinish
    outside: Material = Material("wall outside", (0.88, 0.87, 0.85), roughness=0.95)
    cut: Material = Material("wall cut", (0.83, 0.82, 0.80), roughness=0.9)
    ceiling: Material = Material("ceiling", (0.955, 0.952, 0.945), roughness=0.95)
    trim: Material = Material("trim", (0.95, 0.945, 0.93), roughness=0.55)
    leaf: Material = Material("door leaf", (0.73, 0.57, 0.41), roughness=0.5, texture="oak")
    metal: Material = Material("door handle", (0.74, 0.74, 0.75), roughness=0.3, metallic=1.0)
    glass: Material = Material("pane", (0.82, 0.92, 0.97), roughness=0.06, opacity=0.12)
    daylight: Material = Material("daylight", (0.96, 0.985, 1.0), roughness=1.0, emission=0.9)

    def accented(self, wall: int) -> str | None:
        """How a wall is done that is an accent, if it is one."""
        accent = self.plan.accent
        return accent.kind if accent is not None and wall in accent.walls else None

    def tiled(self, wall: int) -> tuple[float, float] | None:
        """Heights [m] between which a wall is tiled, if it is."""
        tiles = self.plan.tiles
        if tiles is None or (tiles.walls is not None and wall not in tiles.walls):
            return None
        return tiles.low, tiles.high

    def wall(self, wall: int) -> Material:
        """The paint of a wall; of one in two colours the upper one."""
        accent = self.plan.accent
        whole = accent is not None and accent.high is None and self.accented(wall) in ("paint", "paper")
        return (self.looks.accent if whole else None) or self.looks.wall


_PANES = {
    "overcast": ((0.80, 0.83, 0.86), 0.6),
    "dusk": ((0.62, 0.44, 0.42), 0.35),
    "night": ((0.07, 0.09, 0.17), 0.05),
}
"""Colour and emission of windows in pictures from above, where it is no bright day."""


def finishes_of(scene: Scene, cut: tuple[float, float, float] | None = None) -> Finishes:
    """The finishes of a scene's room; ``cut`` is the sRGB colour of walls where they are cut.

    Raises:
        InputError: for a colour or a wood of ``room.finish`` that nobody knows.
    """
    looks = room_looks(scene.room)
    more = {} if cut is None else {"cut": Material("wall cut", cut, roughness=0.9)}
    light = scene.room.light
    if light is not None and light.daylight in _PANES:
        color, glow = _PANES[light.daylight]
        more["daylight"] = Material("daylight", color, roughness=1.0, emission=glow)
    if looks.ceiling is not None:
        more["ceiling"] = looks.ceiling
    if looks.trim is not None:
        more |= {"trim": looks.trim, "leaf": looks.trim}
    if looks.doors is not None:
        more["leaf"] = looks.doors
    return Finishes(looks, scene.room.finish or RoomFinish(), **more)


__all__ = ["FLOORS", "Finishes", "finishes_of"]
