"""LayoutVLM's optimiser in PyTorch: overlap of oriented boxes and differentiable spatial relations, projected steps.

After Sun et al., "LayoutVLM: Differentiable Optimization of 3D Layout via Vision-Language Models" (CVPR 2025), section
4: Adam on the sum of a semantic loss (distance, align_with, point_towards, against_wall) and a physical one (the
distance-IoU of oriented boxes of all pairs that overlap), with positions projected back into the room every few steps.
Written anew from the paper's description; PyTorch is under BSD-3.

Fairness: it starts where all do; the paper's start comes from a language model, with relations dropped that its own
start contradicts (``consistent``). It sees one oriented box for an object, pairs that share a height, the hull of the
room, any yaw, and of relations what its four losses say: sides of faces are a distance and an alignment, walls are the
nearest at the start. It knows nothing of zones, doors, corners of the outline, exact intervals, or objectives, and will
lose by what it does not know; with ``polish`` the engine's projection has the last word.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np
import torch
from torch import Tensor

from sceneweaver.layout import Problem
from sceneweaver.scene import CATALOGUE, Scene

from .quarter_turns import QuarterTurns, quarter_turns

INNER = 20  # steps of Adam in one of the protocol
SIDES = {"front": 0.0, "left": math.pi / 2, "back": math.pi, "right": -math.pi / 2}


@dataclass
class Walk:
    problem: Problem
    given: np.ndarray
    boxes: Boxes
    p: Tensor  # [B, n, 2]
    yaw: Tensor  # [B, n]
    relations: list[Any]
    adam: torch.optim.Adam
    steps: int = 0
    polished: np.ndarray | None = None
    began: float = field(default_factory=time.process_time)


@dataclass(frozen=True)
class LayoutVlm:
    rate: float = 0.03  # [m] and [rad]; falls to a hundredth
    overlap: float = 10.0  # weight of a pair's distance-IoU
    project_every: int = 10
    consistent: bool = False
    polish: bool = False  # give the end to the engine's projection
    seconds: float = math.inf  # of processor time, two thirds of which are for the descent where it is polished
    steps: int = 20

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "rate": [0.01, 0.03, 0.1],
        "overlap": [1.0, 10.0, 100.0],
        "project_every": [1, 10, 50],
    }

    def configure(self, objective: Sequence[Any], seconds: float) -> LayoutVlm:
        """The optimiser for a budget [s]; it knows no objectives."""
        return replace(self, seconds=seconds)

    def init(self, problem: Problem, poses: Any, key: int) -> Walk:
        torch.set_num_threads(1)  # of tensors this small: more cost processor time and save none
        given = np.asarray(poses.numpy(), dtype=np.float32)
        device = "cuda" if problem.device.startswith("cuda") else "cpu"
        boxes = Boxes(problem, device)
        start = torch.as_tensor(given[:, boxes.index], device=device)
        p, yaw = start[..., :2].clone().requires_grad_(), start[..., 3].clone().requires_grad_()
        relations = relations_of(problem.scenes[0], boxes, start)
        if self.consistent:
            relations = [loss for loss in relations if float(loss(p, yaw).mean()) < 0.1]
        return Walk(problem, given, boxes, p, yaw, relations, torch.optim.Adam([p, yaw], lr=self.rate))

    def step(self, state: Walk) -> Walk:
        total = INNER * self.steps
        for _ in range(INNER):
            for group in state.adam.param_groups:
                group["lr"] = self.rate * 0.01 ** (state.steps / total)
            state.adam.zero_grad()
            loss = self.overlap * state.boxes.overlap(state.p, state.yaw).sum()
            for relation in state.relations:
                loss = loss + relation(state.p, state.yaw).sum()
            loss.backward()
            for tensor, free in ((state.p, state.boxes.moves), (state.yaw, state.boxes.turns)):
                if tensor.grad is not None:
                    tensor.grad = torch.nan_to_num(tensor.grad) * free
            state.adam.step()
            state.steps += 1
            if state.steps % self.project_every == 0:
                state.boxes.project(state.p, state.yaw)
        late = time.process_time() - state.began > 2 / 3 * self.seconds
        if self.polish and (state.steps == total or late):
            state.polished = state.problem.project(state.problem.carry(self.best(state), like=state.given))
        return state

    def done(self, state: Walk) -> bool:
        """Whether it was polished."""
        return state.polished is not None

    def best(self, state: Walk) -> np.ndarray:
        if state.polished is not None:
            return state.polished
        found = state.given.copy()
        with torch.no_grad():
            p, yaw = state.p.clone(), state.yaw
            state.boxes.project(p, yaw)
            found[:, state.boxes.index, :2], found[:, state.boxes.index, 3] = p.cpu().numpy(), yaw.cpu().numpy()
        return found

    def counts(self, state: Walk) -> tuple[int, int]:
        return state.steps, state.steps * len(state.given)


class Boxes:
    """Oriented boxes of what stands in the room itself, and the pairs of them that share a height."""

    def __init__(self, problem: Problem, device: str) -> None:
        view: QuarterTurns = quarter_turns(problem)
        objects, roots = problem.scenes[0].objects, problem.roots[0]
        self.index = [i for i in range(len(objects)) if roots[i] == i]
        free = problem.free[0, self.index]
        self.moves = torch.as_tensor(free[:, :2], device=device).float()
        self.turns = torch.as_tensor(free[:, 3], device=device).float()
        sizes = np.array([objects[i].size for i in self.index]).reshape(-1, 3)
        self.half = torch.as_tensor(sizes[:, :2] / 2, device=device).float()
        low = problem.home[0, self.index, 2]
        both = np.argwhere(np.triu(np.ones((len(low), len(low)), dtype=bool), 1))
        shared = np.minimum(low[both] + sizes[both, 2], 1e9).min(axis=1) - low[both].max(axis=1) > 1e-3
        either = free[both, 0].any(axis=1)
        self.pairs = torch.as_tensor(both[shared & either].T.copy(), device=device)
        c, s = math.cos(view.angle), math.sin(view.angle)
        normals = view.planes[:, :2] @ np.array([[c, s], [-s, c]])
        self.normals = torch.as_tensor(normals, device=device).float()
        self.levels = torch.as_tensor(view.planes[:, 2], device=device).float()

    def corners(self, p: Tensor, yaw: Tensor) -> Tensor:
        """Corners [B, n, 4, 2], counter-clockwise."""
        signs = torch.tensor([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]], device=p.device)
        x, y = (signs * self.half[:, None]).unbind(-1)
        c, s = yaw.cos()[..., None], yaw.sin()[..., None]
        return p[..., None, :] + torch.stack([c * x - s * y, s * x + c * y], dim=-1)

    def overlap(self, p: Tensor, yaw: Tensor) -> Tensor:
        """Distance-IoU of pairs [B, P]: IoU less the squared share of the middles' distance; 0 where none overlaps."""
        if not self.pairs.shape[1]:
            return torch.zeros((len(p), 0), device=p.device)
        at = self.corners(p, yaw)
        with torch.no_grad():
            near = (p[:, self.pairs[0]] - p[:, self.pairs[1]]).norm(dim=-1)
            reach = self.half.norm(dim=-1)
            rows, cols = torch.nonzero(near < reach[self.pairs[0]] + reach[self.pairs[1]], as_tuple=True)
        i, j = self.pairs[0, cols], self.pairs[1, cols]
        a, b = at[rows, i], at[rows, j]
        shared = shared_area(a, b)
        area = 4 * self.half.prod(dim=-1)
        iou = shared / (area[i] + area[j] - shared)
        both = torch.cat([a, b], dim=1)
        around = (both.amax(dim=1) - both.amin(dim=1)).square().sum(dim=-1)
        away = (p[rows, i] - p[rows, j]).square().sum(dim=-1)
        return torch.where(shared > 0, iou - away / around, 0.0)

    def project(self, p: Tensor, yaw: Tensor) -> None:
        """Positions moved back until boxes are inside of the room's hull, in place."""
        with torch.no_grad():
            for _ in range(2):
                inside = (self.corners(p, yaw) @ self.normals.T - self.levels).amin(dim=2)  # [B, n, K]
                p += ((-inside).clamp(min=0.0) @ self.normals) * self.moves


def shared_area(a: Tensor, b: Tensor) -> Tensor:
    """Area [Q] that convex quadrilaterals [Q, 4, 2] share: corners in the other and crossings, ordered by angle."""
    inside_a, inside_b = _within(a, b), _within(b, a)
    u, v = a.roll(-1, 1) - a, b.roll(-1, 1) - b
    d = b[:, None] - a[:, :, None]  # [Q, 4, 4, 2]
    turn = _cross(u[:, :, None], v[:, None])
    safe = torch.where(turn.abs() < 1e-9, 1.0, turn)
    s, t = _cross(d, v[:, None]) / safe, _cross(d, u[:, :, None]) / safe
    crossing = (turn.abs() >= 1e-9) & (s > 0) & (s < 1) & (t > 0) & (t < 1)
    crossings = (a[:, :, None] + s[..., None] * u[:, :, None]).flatten(1, 2)
    points = torch.cat([a, b, crossings], dim=1)
    mask = torch.cat([inside_a, inside_b, crossing.flatten(1, 2)], dim=1)
    count = mask.sum(dim=1)
    middle = (points * mask[..., None]).sum(dim=1) / count.clamp(min=1)[:, None]
    angle = torch.atan2(*(points - middle[:, None]).detach().flip(-1).unbind(-1))
    order = torch.where(mask, angle, torch.inf).argsort(dim=1)
    ordered = points.gather(1, order[..., None].expand(-1, -1, 2))
    # what is not a corner falls together with the first, where it adds nothing
    kept = (torch.arange(points.shape[1], device=a.device) < count[:, None])[..., None]
    ring = torch.where(kept, ordered, ordered[:, :1])
    area = 0.5 * _cross(ring, ring.roll(-1, 1)).sum(dim=1)
    return torch.where(count >= 3, area.clamp(min=0.0), 0.0)


def _cross(u: Tensor, v: Tensor) -> Tensor:
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def _within(points: Tensor, other: Tensor) -> Tensor:
    """Which points [Q, 4, 2] lie inside of counter-clockwise quadrilaterals [Q, 4, 2]."""
    edge = other.roll(-1, 1) - other
    return (_cross(edge[:, None], points[:, :, None] - other[:, None]) >= -1e-7).all(dim=2)


def relations_of(scene: Scene, boxes: Boxes, start: Tensor) -> list[Any]:
    """Losses ``loss(p, yaw)`` [B] of the relations that the paper's vocabulary can say."""
    number = {scene.objects[i].id: k for k, i in enumerate(boxes.index)}
    found = []
    for rel in scene.relations:
        a = number.get(rel.subject)
        b = number.get(rel.target) if isinstance(rel.target, str) else None
        spec = CATALOGUE[rel.type]
        if a is None:
            continue
        if rel.type in ("against_wall", "side_against_wall"):
            found.append(_against_wall(boxes, a, spec.subject_sides[0], _wall(scene, rel.target, start[:, a, :2])))
        elif b is not None and spec.subject_sides and spec.target_sides:
            own, theirs = spec.subject_sides[0], spec.target_sides[0]
            reach = _reach(boxes, a, own) + _reach(boxes, b, theirs)
            found.append(_distance(a, b, reach, reach + max(0.02, spec.gap_range(rel, 0.0)[1])))
            found.append(_aligned(a, b, SIDES[theirs] + math.pi - SIDES[own]))
            found.append(_ahead(b, a, SIDES[theirs]))
        elif b is not None and rel.type in ("near", "distance"):
            around = float(boxes.half[a].min() + boxes.half[b].min())
            least = spec.value(rel, "min") if rel.type == "distance" else 0.0
            most = spec.value(rel, "max")
            found.append(_distance(a, b, around + (least or 0.0), 1e3 if most is None else around + most))
        elif b is not None and rel.type == "facing":
            found.append(_ahead(a, b, 0.0))
        elif b is not None and rel.type in ("parallel", "aligned"):
            found.append(_aligned(a, b, 0.0))
        elif b is not None and rel.type in ("in_front_of", "behind", "left_of", "right_of"):
            side = {"in_front_of": "front", "behind": "back", "left_of": "left", "right_of": "right"}[rel.type]
            found.append(_ahead(b, a, SIDES[side]))
    return found


def _reach(boxes: Boxes, k: int, side: str) -> float:
    return float(boxes.half[k, 0 if side in ("front", "back") else 1])


def _distance(a: int, b: int, low: float, high: float) -> Any:
    def loss(p: Tensor, yaw: Tensor) -> Tensor:
        d = (p[:, a] - p[:, b]).square().sum(-1).add(1e-9).sqrt()
        return (d - high).clamp(min=0.0).square() + (low - d).clamp(min=0.0).square()

    return loss


def _aligned(a: int, b: int, by: float) -> Any:
    return lambda p, yaw: 1 - (yaw[:, a] - yaw[:, b] - by).cos()


def _ahead(a: int, b: int, by: float) -> Any:
    """``a``, turned by an angle, points towards ``b``."""

    def loss(p: Tensor, yaw: Tensor) -> Tensor:
        d = p[:, b] - p[:, a]
        wanted = torch.stack([(yaw[:, a] + by).cos(), (yaw[:, a] + by).sin()], -1)
        return 1 - (wanted * d).sum(-1) / (d.square().sum(-1) + 1e-6).sqrt()

    return loss


def _wall(scene: Scene, target: Any, at: Tensor) -> Tensor:
    """Start, inward normal [B, 2, 2] of the wall that is meant: the nearest at the start."""
    walls = scene.room.walls
    starts = torch.tensor([w.start for w in walls], device=at.device, dtype=torch.float32)
    normals = torch.tensor([w.inward for w in walls], device=at.device, dtype=torch.float32)
    if isinstance(target, str):
        chosen = torch.full((len(at),), int(target.partition(":")[2]), device=at.device)
    else:
        chosen = ((at[:, None] - starts) * normals).sum(-1).abs().argmin(dim=1)
    return torch.stack([starts[chosen], normals[chosen]], dim=1)


def _against_wall(boxes: Boxes, a: int, side: str, wall: Tensor) -> Any:
    reach, turned = _reach(boxes, a, side), SIDES[side]

    def loss(p: Tensor, yaw: Tensor) -> Tensor:
        off = ((p[:, a] - wall[:, 0]) * wall[:, 1]).sum(-1) - reach
        wanted = torch.stack([(yaw[:, a] + turned).cos(), (yaw[:, a] + turned).sin()], -1)
        return (off - 0.02).square() + 1 + (wanted * wall[:, 1]).sum(-1)

    return loss
