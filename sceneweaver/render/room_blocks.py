"""Meshes of prisms with a material each: what walls, doors, windows and skirting boards are put together from."""

from __future__ import annotations

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.geometry.walls import Wall

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
        """Any triangles: ``vertices`` [V, 3], ``faces`` [F, 3]."""
        self._paint(self._join(vertices), faces, material)

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
