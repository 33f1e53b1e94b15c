"""Meshes of prisms with a material each: what walls, doors, windows and skirting boards are put together from."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.assets.body import Material, Mesh

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
        ring = np.arange(n)
        after = (ring + 1) % n
        fan = np.array([(0, k, k + 1) for k in range(1, n - 1)])
        sides = np.stack([ring, after, after + n, ring, after + n, ring + n], 1).reshape(-1, 3)
        vertices = np.concatenate([np.column_stack([plan, np.full(n, level)]) for level in z])
        start = self._join(vertices)
        self._paint(start, np.concatenate([fan[:, ::-1], sides[2:]]), material)
        self._paint(start, sides[:2], first or material)
        self._paint(start, fan + n, top or material)

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


class WallFrame:
    """A wall's own coordinates: ``s`` along it from its first corner, ``t`` out of the room, both in metres."""

    def __init__(self, start: Sequence[float], end: Sequence[float]) -> None:
        self.start, self.end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
        self.length = float(np.linalg.norm(self.end - self.start))
        self.along = (self.end - self.start) / max(self.length, 1e-9)
        self.outward = np.array([self.along[1], -self.along[0]])

    def points(self, pairs: Sequence[tuple[float, float]]) -> np.ndarray:
        """World points [N, 2] of pairs (s, t)."""
        pairs_ = np.asarray(pairs, dtype=float)
        return self.start + pairs_[:, :1] * self.along + pairs_[:, 1:] * self.outward

    def block(self, s: Range, t: Range) -> np.ndarray:
        """The plan [4, 2] of a block, counter-clockwise from above."""
        return self.points([(s[0], t[1]), (s[1], t[1]), (s[1], t[0]), (s[0], t[0])])
