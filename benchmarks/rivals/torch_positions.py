"""Positions only, as the object placers of simulators do it: shared volume of boxes and hinges; yaw is never changed.

Written from a description of what such placers have in common, not from any one of them: Adam with one rate, the volume
that bounding boxes along the axes share times a large factor, and a hinge for each thing that is asked for.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.rivals.base import Rival, register
from benchmarks.rivals.hinges import Hinge, footprints, hinges
from benchmarks.rivals.numpy_descent import hull_planes
from benchmarks.rivals.torch_support import missing, on_cuda, pick
from benchmarks.starts import carry, movable
from sceneweaver.scene import Scene

if TYPE_CHECKING:
    from torch import Tensor

STEPS, RATE = 600, 0.01
SPACE = 10_000.0  # what a shared cubic metre costs, and a metre out of the room; a relation's hinge costs 1 a metre


class Placement:
    """Losses of middles [B, n, 2] of floor objects from one set of starts [B, N, 4]."""

    def __init__(self, scene: Scene, starts: np.ndarray, device: str) -> None:
        import torch

        like = {"device": device, "dtype": torch.float32}
        floor = movable(scene)
        self.half = torch.as_tensor(footprints(scene, starts), **like)
        pairs, heights = _pairs(scene, floor)
        self.pairs = torch.as_tensor(pairs.T.copy(), device=device)
        self.heights = torch.as_tensor(heights, **like)
        planes = hull_planes(scene)
        self.normals = torch.as_tensor(np.array([n for n, _ in planes]), **like)
        self.levels = torch.as_tensor([c for _, c in planes], **like)
        self.hinges = _packed(hinges(scene, starts), like)

    def __call__(self, p: Tensor) -> Tensor:
        """Loss of all candidates together."""
        loss = SPACE * self._overlap(p).sum()
        out = self.half @ self.normals.abs().T - (p @ self.normals.T - self.levels)
        loss = loss + SPACE * out.clamp(min=0.0).sum()
        for subject, target, direction, low, high in self.hinges:
            d = p[:, subject] - (p[:, target] if target is not None else 0.0)
            value = (d * direction).sum(-1) if direction is not None else (d * d).sum(-1).add(1e-9).sqrt()
            loss = loss + ((value - high).clamp(min=0.0) + (low - value).clamp(min=0.0)).sum()
        return loss

    def _overlap(self, p: Tensor) -> Tensor:
        """Shared volume of the pairs [B, P] [m3]."""
        a, b = self.pairs
        shared = self.half[:, a] + self.half[:, b] - (p[:, a] - p[:, b]).abs()
        inner = 2 * self.half[:, a].minimum(self.half[:, b])
        return shared.clamp(min=0.0).minimum(inner).prod(dim=-1) * self.heights


def _pairs(scene: Scene, floor: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of floor objects [P, 2] and how much height they share [P] [m]."""
    z = [(scene.objects[i].pose.position[2], scene.objects[i].size[2]) for i in floor]
    found = [(a, b, min(sum(z[a]), sum(z[b])) - max(z[a][0], z[b][0])) for a, b in combinations(range(len(floor)), 2)]
    found = [row for row in found if row[2] > 0]
    return np.array([row[:2] for row in found], dtype=int).reshape(-1, 2), np.array([row[2] for row in found])


def _packed(found: list[Hinge], like: dict) -> list[tuple[Tensor, Tensor | None, Tensor | None, Tensor, Tensor]]:
    """Hinges of one form at once: against the room, against objects, and distances."""
    import torch

    groups: dict[tuple[bool, bool], list[Hinge]] = {}
    for hinge in found:
        groups.setdefault((hinge.target < 0, hinge.direction is None), []).append(hinge)
    packed = []
    for (room, distance), members in groups.items():
        subject, target = (
            torch.tensor([getattr(h, name) for h in members], device=like["device"]) for name in ("subject", "target")
        )
        low, high = (
            torch.as_tensor(np.stack([getattr(h, name) for h in members], axis=1), **like) for name in ("low", "high")
        )
        way = None
        if not distance:
            way = torch.as_tensor(np.stack([h.direction for h in members if h.direction is not None], axis=1), **like)
        packed.append((subject, None if room else target, way, low, high))
    return packed


def solve(scene: Scene, starts: np.ndarray, seed: int, device: str) -> np.ndarray:
    """Move floor objects from the starts; nothing is drawn by chance, so that the seed does not matter."""
    import torch

    floor, poses = movable(scene), starts.astype(np.float64)
    placement = Placement(scene, starts, pick(device))
    p = torch.tensor(starts[:, floor, :2], dtype=torch.float32, device=pick(device), requires_grad=True)
    adam = torch.optim.Adam([p], lr=RATE)
    for _ in range(STEPS):
        adam.zero_grad()
        placement(p).backward()
        adam.step()
    poses[:, floor, :2] = p.detach().cpu().numpy()
    return carry(scene, poses)


def prepare(scene: Scene, starts: np.ndarray, device: str) -> None:
    """Load what Torch loads with its first step."""
    import torch

    p = torch.tensor(starts[:, movable(scene), :2], dtype=torch.float32, device=pick(device), requires_grad=True)
    Placement(scene, starts, pick(device))(p).backward()


def _most(objects: int, device: str) -> int:
    if on_cuda(device):
        return 8192 if objects <= 19 else 2048 if objects <= 70 else 256
    return 512 if objects <= 19 else 128 if objects <= 30 else 32 if objects <= 70 else 4


register(
    Rival(
        name="torch positions",
        about="positions only, as simulators place objects (Adam, rate 0.01, 600 steps, shared volume of bounding "
        "boxes times 10,000, hinges for sides, distances and bounds); yaws stay as they start, and it knows nothing of "
        "zones and doors.",
        solve=solve,
        prepare=prepare,
        missing=missing,
        most=_most,
    )
)
