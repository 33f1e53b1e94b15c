"""How deep prisms sink into each other, in Torch: boxes in closed form, other convex polygons by separating axes.

The candidate is the last axis in here, so that taking the rows of a pair copies whole stretches of memory. Imported
inside functions only: it needs torch.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from benchmarks.rivals.prisms import Prism, rectangle


class Frames:
    """Where the owners of prisms are: x, y, cosine and sine of the yaw, [n + 1, B] each; the last one stands still."""

    def __init__(self, x: Tensor) -> None:
        still = torch.zeros_like(x[0, :1])
        self.x, self.y = torch.cat([x[0], still]), torch.cat([x[1], still])
        self.c, self.s = torch.cat([x[2].cos(), still + 1.0]), torch.cat([x[2].sin(), still])


def columns(values: Sequence[float] | np.ndarray, like: dict) -> Tensor:
    """Numbers [K] as a column [K, 1], to go with every candidate."""
    return torch.as_tensor(np.asarray(values, dtype=np.float64), **like).reshape(-1, 1)


class Boxes:
    """Pairs [P, 2] of prisms that are boxes."""

    def __init__(self, prisms: Sequence[Prism], pairs: np.ndarray, like: dict) -> None:
        shapes = [rectangle(p.corners) or (np.zeros(2), np.zeros(2), 0.0) for p in prisms]
        self.owner = torch.as_tensor([p.owner for p in prisms], device=like["device"])
        self.mx, self.my = (columns([m[k] for m, _, _ in shapes], like) for k in (0, 1))
        self.hx, self.hy = (columns([h[k] for _, h, _ in shapes], like) for k in (0, 1))
        self.turn_c = columns([np.cos(turn) for _, _, turn in shapes], like)
        self.turn_s = columns([np.sin(turn) for _, _, turn in shapes], like)
        self.all = self.pairs = torch.as_tensor(pairs.T.copy(), device=like["device"])

    def placed(self, at: Frames) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """Middle, cosine and sine of all boxes [K, B]."""
        owner = torch.where(self.owner < 0, len(at.x) - 1, self.owner)
        c, s = at.c[owner], at.s[owner]
        x = at.x[owner] + c * self.mx - s * self.my
        y = at.y[owner] + s * self.mx + c * self.my
        return x, y, c * self.turn_c - s * self.turn_s, s * self.turn_c + c * self.turn_s

    def depth(self, at: Frames) -> Tensor:
        """Depth [P, B] of the pairs; negative: the widest gap along a face normal."""
        a, b = self.pairs
        x, y, c, s = self.placed(at)
        dx, dy, ca, sa, cb, sb = x[b] - x[a], y[b] - y[a], c[a], s[a], c[b], s[b]
        cos, sin = (ca * cb + sa * sb).abs(), (ca * sb - sa * cb).abs()
        ax, ay, bx, by = self.hx[a], self.hy[a], self.hx[b], self.hy[b]
        along_a = ax + bx * cos + by * sin - (ca * dx + sa * dy).abs()
        aside_a = ay + bx * sin + by * cos - (ca * dy - sa * dx).abs()
        along_b = bx + ax * cos + ay * sin - (cb * dx + sb * dy).abs()
        aside_b = by + ax * sin + ay * cos - (cb * dy - sb * dx).abs()
        return along_a.minimum(aside_a).minimum(along_b.minimum(aside_b))

    def look(self, at: Frames, slack: float) -> None:
        """Keep only pairs that come within ``slack`` [m] in some candidate."""
        a, b = self.all
        x, y, _, _ = self.placed(at)
        radius = torch.hypot(self.hx, self.hy)
        near = torch.hypot(x[b] - x[a], y[b] - y[a]) < radius[a] + radius[b] + slack
        self.pairs = self.all[:, near.any(dim=1)]


class Polygons:
    """Pairs [P, 2] of prisms of which at least one is no box. Corners are filled up to the most that any has."""

    def __init__(self, prisms: Sequence[Prism], pairs: np.ndarray, like: dict) -> None:
        most = max((len(p.corners) for p in prisms), default=3)
        corners = np.zeros((len(prisms), most, 2))
        normals = np.zeros((len(prisms), most, 2))
        for k, prism in enumerate(prisms):
            edge = np.roll(prism.corners, -1, axis=0) - prism.corners
            out = np.stack([edge[:, 1], -edge[:, 0]], -1) / np.linalg.norm(edge, axis=1)[:, None]
            real = np.minimum(np.arange(most), len(edge) - 1)  # the last corner and side again: they change nothing
            corners[k], normals[k] = prism.corners[real], out[real]
        self.owner = torch.as_tensor([p.owner for p in prisms], device=like["device"])
        self.corners, self.normals = (torch.as_tensor(v, **like)[..., None] for v in (corners, normals))
        self.radius = self.corners.norm(dim=2).amax(dim=1)
        self.all = self.pairs = torch.as_tensor(pairs.T.copy(), device=like["device"])

    def placed(self, at: Frames) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """x and y of corners and of outward normals of all prisms [K, V, B]."""
        owner = torch.where(self.owner < 0, len(at.x) - 1, self.owner)
        c, s = at.c[owner][:, None], at.s[owner][:, None]
        (px, py), (nx, ny) = self.corners.unbind(2), self.normals.unbind(2)
        x, y = at.x[owner][:, None] + c * px - s * py, at.y[owner][:, None] + s * px + c * py
        return x, y, c * nx - s * ny, s * nx + c * ny

    def depth(self, at: Frames) -> Tensor:
        """Depth [P, B] of the pairs; negative: the widest gap along a face normal."""
        a, b = self.pairs
        x, y, nx, ny = self.placed(at)
        gap = None
        for i, j in ((a, b), (b, a)):  # faces of one against corners of the other
            nxi, nyi, xj, yj = nx[i], ny[i], x[j], y[j]
            low = None
            for k in range(xj.shape[1]):  # corner by corner: several times faster than a reduction once compiled
                corner = nxi * xj[:, k, None] + nyi * yj[:, k, None]
                low = corner if low is None else low.minimum(corner)
            ahead = low - (nxi * x[i] + nyi * y[i])
            for k in range(ahead.shape[1]):
                gap = ahead[:, k] if gap is None else gap.maximum(ahead[:, k])
        return -gap

    def look(self, at: Frames, slack: float) -> None:
        """Keep only pairs that come within ``slack`` [m] in some candidate."""
        a, b = self.all
        owner = torch.where(self.owner < 0, len(at.x) - 1, self.owner)
        x, y = at.x[owner], at.y[owner]
        near = torch.hypot(x[b] - x[a], y[b] - y[a]) < self.radius[a] + self.radius[b] + slack
        self.pairs = self.all[:, near.any(dim=1)]
