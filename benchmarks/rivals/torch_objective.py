"""The objective of the engine's own problem in Torch: collisions, bounds, zones, openings and relations, in batches.

Imported inside functions only: it needs torch.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from benchmarks.rivals.numpy_descent import hull_planes
from benchmarks.rivals.prisms import Prism, openings, pockets, rectangle, solids, tied, zones
from benchmarks.rivals.torch_overlap import Boxes, Frames, Polygons
from benchmarks.rivals.torch_relations import Relations, penalty
from benchmarks.starts import movable
from sceneweaver.scene import Scene

MARGIN = 0.002  # [m] that everything is to keep free beyond what is asked


class Objective:
    """Losses of a scene; zero where everything holds. The candidate is the last axis."""

    def __init__(self, scene: Scene, device: str, dtype: torch.dtype = torch.float32) -> None:
        like = {"device": device, "dtype": dtype}
        self.count = len(movable(scene))
        prisms, pairs = meetings(scene)
        boxy = np.array([rectangle(p.corners) is not None for p in prisms], dtype=bool)
        plain = boxy[pairs].all(axis=1)
        found = (Boxes(prisms, pairs[plain], like), Polygons(prisms, pairs[~plain], like))
        self.overlaps = [o for o in found if o.pairs.shape[1]]
        self.relations = Relations(scene, like)
        size = torch.as_tensor([scene.objects[i].size for i in movable(scene)], **like).reshape(-1, 3)
        self.half = size[:, :2] / 2
        planes = hull_planes(scene)
        self.normals = torch.as_tensor(np.array([n for n, _ in planes]), **like)
        self.levels = torch.as_tensor([c for _, c in planes], **like)

    def __call__(self, x: Tensor) -> tuple[Tensor, Tensor]:
        """Losses [B] of space and of relations at x, y [m] and yaw [rad] of floor objects [3, n, B]."""
        at = Frames(x)
        space = self._bounds(at)
        for overlap in self.overlaps:
            space = space + penalty(overlap.depth(at) + MARGIN).sum(dim=0)
        return space, self.relations(x)

    def look(self, x: Tensor, slack: float) -> None:
        """Leave out pairs further apart than ``slack`` [m] in every candidate, until the next look."""
        for overlap in self.overlaps:
            overlap.look(Frames(x), slack)

    def _bounds(self, at: Frames) -> Tensor:
        """Boxes of objects beyond the hull of the outline."""
        x, y, c, s = (v[: self.count] for v in (at.x, at.y, at.c, at.s))
        nx, ny = self.normals[:, 0, None, None], self.normals[:, 1, None, None]  # [W, 1, 1] against [n, B]
        along, aside = (c * nx + s * ny).abs(), (c * ny - s * nx).abs()
        extent = self.half[:, 0, None] * along + self.half[:, 1, None] * aside
        out = extent + MARGIN - (x * nx + y * ny - self.levels[:, None, None])
        return penalty(out).sum(dim=(0, 1))


def meetings(scene: Scene) -> tuple[list[Prism], np.ndarray]:
    """Prisms of a scene and the pairs [P, 2] of them that must not overlap: solids with solids and with clear space."""
    bodies, room = solids(scene), pockets(scene)
    clear, exempt = [*zones(scene), *openings(scene)], tied(scene)
    prisms = [*bodies, *room, *clear]
    first = len(bodies) + len(room)

    def meet(i: int, j: int) -> bool:
        a, b = prisms[i], prisms[j]
        return a.owner != b.owner and a.overlaps_height(b) and not (j >= first and (a.item, b.item) in exempt)

    pairs = [(i, j) for j in range(len(prisms)) for i in range(min(j, len(bodies))) if meet(i, j)]
    return prisms, np.array(pairs, dtype=int).reshape(-1, 2)


def batch(poses: np.ndarray, floor: Sequence[int] | np.ndarray, device: str) -> Tensor:
    """x, y and yaw [3, n, B] of floor objects out of poses [B, N, 4]."""
    plane = np.ascontiguousarray(poses[:, floor][:, :, (0, 1, 3)].transpose(2, 1, 0))
    return torch.as_tensor(plane, dtype=torch.float32, device=device)
