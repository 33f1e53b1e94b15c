"""Relations as losses in Torch, all of one kind at once: the relations, and the choices, that ``pulls.py`` knows.

A kind takes x, y and yaw [R, 1, B] of subjects and of targets and the numbers [R, O, 1] of its relations, each with O
options (which wall, which side), and gives the losses of the options [R, O, B]; the best option counts. Gradients go
to subject and target. Imported inside functions only: it needs torch.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
import torch
from torch import Tensor

from benchmarks.rivals.pulls import ANGLES, ARM, SIDES, SLACK, Room, shrunk
from benchmarks.starts import movable
from sceneweaver.scene import CATALOGUE, Relation, Scene, SceneObject

Pose = tuple[Tensor, ...]
Numbers = dict[str, Tensor]
Kind = Callable[[Pose, Pose, Numbers], Tensor]
Option = dict[str, float]

WIDTH = 0.05  # [m] up to which a penalty is quadratic
OFFSET = 0.07  # [m] aimed at where ``centered_on`` allows 0.1
CORNER = (0.0, 0.1)  # [m] from both walls, where 0.15 is allowed
WINDOW = (0.0, 0.9)  # [m] before a window, where 1 is allowed


def penalty(value: Tensor) -> Tensor:
    """Of a length that is missing [m] (negative: none is): quadratic, then linear."""
    low = value.clamp(0.0, WIDTH)
    return low * (value - low / 2) / WIDTH


def outside(value: Tensor, low: Tensor | float, high: Tensor | float) -> Tensor:
    """Penalty of what lies outside of an interval."""
    middle, half = (high + low) / 2, (high - low) / 2
    return penalty((value - middle).abs() - half)


def turned(angle: Tensor, step: float, limit: Tensor) -> Tensor:
    """Penalty of angles [rad] further than a limit from the next multiple of ``step``."""
    return penalty(ARM * ((angle - step * torch.round(angle.detach() / step)).abs() - limit))


def walls(a: Pose, _: Pose, v: Numbers) -> Tensor:
    """A side at a wall, along its length."""
    dx, dy = a[0] - v["px"], a[1] - v["py"]
    off = outside(dx * v["nx"] + dy * v["ny"] - v["half"], v["low"], v["high"])
    aside = outside(dx * v["ny"] - dy * v["nx"], v["inset"], v["far"])
    return off + aside + turned(a[2] - v["wanted"], 2 * math.pi, v["limit"])


def _extent(yaw: Tensor, v: Numbers, nx: Tensor, ny: Tensor) -> Tensor:
    """How far turned boxes reach along a direction."""
    c, s = yaw.cos(), yaw.sin()
    return v["hx"] * (c * nx + s * ny).abs() + v["hy"] * (c * ny - s * nx).abs()


def _from_box(dx: Tensor, dy: Tensor, yaw: Tensor, hx: Tensor, hy: Tensor) -> Tensor:
    """Distance of points, seen from the middles of boxes, from those boxes."""
    c, s = yaw.cos(), yaw.sin()
    u, v = ((c * dx + s * dy).abs() - hx).clamp(min=0.0), ((c * dy - s * dx).abs() - hy).clamp(min=0.0)
    return (u * u + v * v + 1e-9).sqrt()


def corners(a: Pose, _: Pose, v: Numbers) -> Tensor:
    """A footprint near a corner, its box near both walls."""
    dx, dy = a[0] - v["px"], a[1] - v["py"]
    total = penalty(_from_box(dx, dy, a[2], v["kx"], v["ky"]) - v["inside"] - v["reach"])
    for nx, ny in ((v["nx"], v["ny"]), (v["mx"], v["my"])):
        total = total + outside(dx * nx + dy * ny - _extent(a[2], v, nx, ny), *CORNER)
    return total


def windows(a: Pose, _: Pose, v: Numbers) -> Tensor:
    """A box before a window."""
    dx, dy = a[0] - v["px"], a[1] - v["py"]
    off = outside(dx * v["nx"] + dy * v["ny"] - _extent(a[2], v, v["nx"], v["ny"]), *WINDOW)
    return off + outside(dx * v["ny"] - dy * v["nx"], v["inset"], v["far"])


def faces(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """Side to side."""
    c, s = b[2].cos(), b[2].sin()
    dx, dy = a[0] - b[0], a[1] - b[1]
    front, left = c * dx + s * dy, c * dy - s * dx
    off = outside(v["ox"] * front + v["oy"] * left - v["base"], v["low"], v["high"])
    aside = outside(v["ox"] * left - v["oy"] * front, -v["reach"], v["reach"])
    return off + aside + turned(a[2] - b[2] - v["wanted"], 2 * math.pi, v["limit"])


def centred(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """The smaller offset in the target's frame."""
    c, s = b[2].cos(), b[2].sin()
    dx, dy = a[0] - b[0], a[1] - b[1]
    return penalty((c * dx + s * dy).abs().minimum((c * dy - s * dx).abs()) - v["offset"])


def near(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """The circle inside of the subject within a distance of a part of the target."""
    c, s = b[2].cos(), b[2].sin()
    dx, dy = a[0] - b[0] - c * v["ox"] + s * v["oy"], a[1] - b[1] - s * v["ox"] - c * v["oy"]
    return penalty(_from_box(dx, dy, b[2], v["hx"], v["hy"]) - v["inside"] - v["reach"])


def facing(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """Turned to the target's middle."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    off = torch.atan2(dy, dx + 1e-9)
    return turned(a[2] - off, 2 * math.pi, v["limit"])


def aligned(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """Equal up to quarter turns."""
    return turned(a[2] - b[2], math.pi / 2, v["limit"])


def parallel(a: Pose, b: Pose, v: Numbers) -> Tensor:
    """Equal up to half turns."""
    return turned(a[2] - b[2], math.pi, v["limit"])


class Relations:
    """The losses of a scene's relations among floor objects."""

    def __init__(self, scene: Scene, like: dict[str, Any]) -> None:
        floor = movable(scene)
        index = {scene.objects[i].id: k for k, i in enumerate(floor)}
        rows: dict[Kind, list[tuple[int, int, list[Option]]]] = {}
        for rel in scene.relations:
            a = index.get(rel.subject, -1)
            b = index.get(rel.target, -1) if isinstance(rel.target, str) else -1
            kind, options = _options(scene, rel, floor[a], floor[b] if b >= 0 else -1) if a >= 0 else (None, [])
            if kind is not None and options:
                rows.setdefault(kind, []).append((a, b, options))
        self._losses = [partial(_best, kind, *_packed(rows_of, like)) for kind, rows_of in rows.items()]

    def __call__(self, x: Tensor) -> Tensor:
        """Sum over all relations [B] at x, y and yaw of floor objects [3, n, B]."""
        total = torch.zeros_like(x[0, 0])
        for loss in self._losses:
            total = total + loss(x).sum(dim=0)
        return total


def _packed(rows: list[tuple[int, int, list[Option]]], like: dict[str, Any]) -> tuple[Tensor, Tensor, Numbers]:
    """Subjects and targets [R] and numbers [R, O, 1]; the last option is repeated where there are fewer."""
    most = max(len(options) for _, _, options in rows)
    filled = [[*options, *[options[-1]] * (most - len(options))] for _, _, options in rows]
    numbers = {key: torch.tensor([[o[key] for o in row] for row in filled], **like)[..., None] for key in filled[0][0]}
    a, b = (torch.tensor([row[k] for row in rows], device=like["device"]) for k in (0, 1))
    return a, b.clamp(min=0), numbers


def _best(kind: Kind, a: Tensor, b: Tensor, numbers: Numbers, x: Tensor) -> Tensor:
    """The loss of the best option [R, B]."""
    subject, target = (tuple(v[rows][:, None] for v in x) for rows in (a, b))
    return kind(subject, target, numbers).amin(dim=1)


def _options(scene: Scene, rel: Relation, a: int, b: int) -> tuple[Kind | None, list[Option]]:
    """What kind a relation is and its options; objects by index in the scene, ``b`` is -1 where none is meant."""
    spec, room = CATALOGUE[rel.type], Room(scene)
    size = scene.objects[a].size
    if rel.type in ("against_wall", "side_against_wall"):
        return walls, _wall_options(room, rel, size)
    if rel.type == "in_corner":
        return corners, _corner_options(room, scene.objects[a], SLACK * spec.value(rel, "to_corner"))
    if rel.type == "at_window":
        return windows, [
            {**_at(room.p[w.wall], room.n[w.wall], size), "inset": w.offset, "far": w.offset + w.width}
            for w in scene.room.windows
            if rel.target in (None, w.id)
        ]
    if b < 0:
        return None, []
    if spec.subject_sides and spec.target_sides:
        return faces, _face_options(scene, rel, a, b)
    if rel.type == "centered_on":
        return centred, [{"offset": OFFSET}]
    if rel.type == "near":
        return near, _near_options(scene.objects[a], scene.objects[b], SLACK * spec.value(rel, "max"))
    kind = {"facing": facing, "aligned": aligned, "parallel": parallel}.get(rel.type)
    return kind, [{"limit": SLACK * math.radians(spec.value(rel, "degrees"))}] if kind else []


def _at(point: np.ndarray, normal: np.ndarray, size: Sequence[float]) -> Option:
    """A point of a wall, its inward normal, and half of a box."""
    return {"px": point[0], "py": point[1], "nx": normal[0], "ny": normal[1], "hx": size[0] / 2, "hy": size[1] / 2}


def _corner_options(room: Room, obj: SceneObject, reach: float) -> list[Option]:
    """An object with parts is taken as the circle inside of its box, another one as the box."""
    depth, width, _ = obj.size
    foot = {"kx": depth / 2, "ky": width / 2, "inside": 0.0}
    if obj.parts:
        foot = {"kx": 0.0, "ky": 0.0, "inside": min(depth, width) / 2}
    return [
        {**_at(room.p[c], room.n[c], obj.size), "mx": m[0], "my": m[1], "reach": reach, **foot}
        for c, m in ((c, room.n[c - 1]) for c in room.convex)
    ]


def _near_options(ours: SceneObject, theirs: SceneObject, reach: float) -> list[Option]:
    """One for each part of the target, as the box around it."""
    options = []
    for part in theirs.solids:
        low, high = np.min(part.polygon, axis=0), np.max(part.polygon, axis=0)
        (ox, oy), (hx, hy) = (low + high) / 2, (high - low) / 2
        option = {"ox": ox, "oy": oy, "hx": hx, "hy": hy}
        options.append(option | {"inside": min(ours.size[:2]) / 2, "reach": reach})
    return options


def _wall_options(room: Room, rel: Relation, size: Sequence[float]) -> list[Option]:
    spec = CATALOGUE[rel.type]
    low, high = shrunk(*spec.gap_range(rel, size[0]))
    limit = SLACK * math.radians(spec.value(rel, "degrees"))
    chosen = [int(rel.target.partition(":")[2])] if isinstance(rel.target, str) else range(len(room.p))
    options = []
    for w in chosen:
        outward = math.atan2(-room.n[w, 1], -room.n[w, 0])
        for side in spec.subject_sides:
            k, _ = SIDES[side]
            inset = min(size[1 - k], room.length[w]) / 2
            option = {**_at(room.p[w], room.n[w], size), "half": size[k] / 2, "low": low, "high": high, "limit": limit}
            option |= {"inset": inset, "far": room.length[w] - inset, "wanted": outward - ANGLES[side]}
            options.append(option)
    return options


def _face_options(scene: Scene, rel: Relation, a: int, b: int) -> list[Option]:
    """Tucked gaps begin at zero between two plain boxes: there is nothing to reach under."""
    spec, (ours, theirs) = CATALOGUE[rel.type], (scene.objects[a], scene.objects[b])
    low, high = spec.gap_range(rel, ours.size[0])
    low, high = shrunk(low if ours.parts or theirs.parts else max(low, 0.0), high)
    limit, overlap = SLACK * math.radians(spec.value(rel, "degrees")), spec.value(rel, "overlap")
    options = []
    for target_side in spec.target_sides:
        kb, sign = SIDES[target_side]
        for side in spec.subject_sides:
            ka, _ = SIDES[side]
            wide = (ours.size[1 - ka], theirs.size[1 - kb])
            option = {"ox": sign * (kb == 0), "oy": sign * (kb == 1), "base": (ours.size[ka] + theirs.size[kb]) / 2}
            option |= {"low": low, "high": high, "limit": limit}
            option["reach"] = sum(wide) / 2 - min(1.0, overlap + 0.1) * min(wide)
            option["wanted"] = ANGLES[target_side] + math.pi - ANGLES[side]
            options.append(option)
    return options
