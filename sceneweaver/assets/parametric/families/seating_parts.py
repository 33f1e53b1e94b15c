"""What seats share: legs, star bases, pillows, curved shells."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from ... import shapes
from ...body import Material
from ...shapes.convex import Shape
from ..builder import Builder, Interval

Finish = Material | str
Point = tuple[float, float, float]


def leg(b: Builder, foot: Point, head: Point, low: float, high: float, material: Finish, segments: int = 12) -> None:
    """A round leg between two points with these radii, its ends cut level."""
    angle = (np.arange(segments) + 0.5) * (2 * np.pi / segments)
    circle = np.c_[np.cos(angle), np.sin(angle), np.zeros(segments)]
    points = np.concatenate([np.asarray(foot) + low * circle, np.asarray(head) + high * circle])
    fan = np.arange(1, segments - 1)
    caps = np.concatenate([np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + segments])
    b.add((points, np.concatenate([ring_faces(0, segments, segments), caps]).astype(np.int32)), material)


def square_leg(b: Builder, foot: Point, head: Point, low: float, high: float, material: Finish) -> None:
    """A leg of square section between two points, ``low`` and ``high`` wide at its ends."""
    circle = np.array([(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)])
    points = np.concatenate([np.asarray(foot) + low * circle, np.asarray(head) + high * circle])
    caps = np.array([(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7)])
    b.add((points, np.concatenate([ring_faces(0, 4, 4), caps]).astype(np.int32)), material)


def splayed(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Finish,
    splay: float = 0.06,
    low: float = 0.012,
    high: float = 0.02,
) -> None:
    """Four round legs whose feet stand in the corners of x, y; their heads are drawn in by ``splay``."""
    for sx, cx in ((1, x[0] + low), (-1, x[1] - low)):
        for sy, cy in ((1, y[0] + low), (-1, y[1] - low)):
            leg(b, (cx, cy, z[0]), (cx + sx * splay, cy + sy * splay, z[1]), low, high, material)


def pillow(b: Builder, depth: float, width: float, thick: float, material: Finish, lift: float = 0.0) -> None:
    """A stuffed pillow with drawn-in edges, lying flat about the frame's origin with its foot at z = ``lift``."""
    n = 9
    t = np.sin(np.linspace(-1, 1, n) * math.pi / 2)
    u, v = np.meshgrid(t, t, indexing="ij")
    x = depth / 2 * u * (1 - 0.07 * (1 - v**2))
    y = width / 2 * v * (1 - 0.07 * (1 - u**2))
    z = thick / 2 * np.clip((1 - u**2) * (1 - v**2), 0, 1) ** 0.42
    z = np.maximum(z, 0.002)
    top = np.stack([x, y, lift + thick / 2 + z], axis=-1).reshape(-1, 3)
    low = np.stack([x, y, lift + thick / 2 - z], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
    a = (i * n + j).ravel()
    quads = np.concatenate([np.c_[a, a + n, a + n + 1], np.c_[a, a + n + 1, a + 1]])
    rim = np.concatenate(
        [np.arange(n), n - 1 + n * np.arange(1, n), (n - 1) * n + np.arange(n - 2, -1, -1), n * np.arange(n - 2, 0, -1)]
    )
    after = np.roll(rim, -1)
    k = n * n
    edge = np.concatenate([np.c_[rim, k + after, k + rim], np.c_[rim, after, k + after]])
    shape = np.concatenate([top, low]), np.concatenate([quads, quads[:, ::-1] + k, edge]).astype(np.int32)
    b.add(shape, material, [shapes.containing_hull(shape[0])])


def shell(b: Builder, grid: np.ndarray, thickness: float, material: Finish, rows: int, columns: int) -> None:
    """A shell bent both ways: points [N, M, 3]; its hulls are patches, ``rows`` along N times ``columns`` along M."""
    shape = shapes.sheet(grid, thickness)
    n, m = grid.shape[:2]
    both = shape[0].reshape(2, n, m, 3)
    down, across = (np.unique(np.linspace(0, k - 1, c + 1).round().astype(int)) for k, c in ((n, rows), (m, columns)))
    hulls = [
        shapes.hull(both[:, a : c + 1, e : f + 1].reshape(-1, 3))
        for a, c in zip(down[:-1], down[1:], strict=True)
        for e, f in zip(across[:-1], across[1:], strict=True)
    ]
    b.add(shape, material, hulls)


def bent(profile: list[tuple[float, float]], half: list[float], lift, count: int = 7) -> np.ndarray:
    """A grid for a shell: (x, z) points along the sitter's back, half widths there, ``lift`` moves an edge point.

    ``lift(k, s)`` gives the (x, z) shift at row k and share s in -1..1 of the half width.
    """
    share = np.linspace(-1, 1, count)
    rows = []
    for k, ((x, z), w) in enumerate(zip(profile, half, strict=True)):
        shift = [lift(k, s) for s in share]
        rows.append([(x + dx, w * s, z + dz) for s, (dx, dz) in zip(share, shift, strict=True)])
    return np.array(rows)


def arc_panel(
    b: Builder,
    width: float,
    z: Interval,
    thickness: float,
    bulge: float,
    material: Finish,
    lean: float = 0.0,
    count: int = 9,
    narrow: float = 1.0,
) -> None:
    """A back rest bent around the sitter: its edges come forward by ``bulge``, its top leans back by ``lean`` [m]."""
    rows = []
    for s in np.linspace(-1, 1, count):
        forward = bulge * (1 - math.cos(s * 1.2)) / (1 - math.cos(1.2))
        rows.append(
            [
                (forward - lean * t, s * width / 2 * (1 + (narrow - 1) * t), z[0] + t * (z[1] - z[0]))
                for t in (0.0, 0.5, 1.0)
            ]
        )
    b.sheet(np.array(rows), thickness, material, cells=(count - 1) // 2)


def star_base(b: Builder, reach: float, top: float, metal: Finish, castors: bool = True) -> None:
    """Five arms of ``reach`` on castors or glides, a gas lift up to height ``top``."""
    for k in range(5):
        angle = math.pi + (k + 0.5) * 2 * math.pi / 5
        c, s = math.cos(angle), math.sin(angle)
        tip = reach - 0.03
        b.bar((0.03 * c, 0.03 * s, 0.11), (tip * c, tip * s, 0.078), 0.016, metal, segments=8)
        if castors:
            for side in (-1, 1):
                turn = angle + math.pi / 2
                at = tip * c - side * 0.014 * math.sin(turn), tip * s + side * 0.014 * math.cos(turn)
                with b.frame(*at, 0.028, yaw=turn, roll=math.pi / 2):
                    b.frustum(0.028, 0.028, (-0.009, 0.009), "black plastic", segments=14, bevel=0.003)
            b.bar((tip * c, tip * s, 0.03), (tip * c, tip * s, 0.075), 0.008, "black plastic", segments=6)
        else:
            b.bar((tip * c, tip * s, 0.0), (tip * c, tip * s, 0.075), 0.014, "black plastic", segments=8)
    b.frustum(0.045, 0.032, (0.07, 0.14), metal, segments=16)
    b.frustum(0.026, 0.024, (0.14, 0.14 + 0.5 * (top - 0.14)), "black plastic", segments=14)
    b.frustum(0.015, 0.015, (0.14 + 0.5 * (top - 0.14), top), metal, segments=12)


def ring_shape(
    x: Interval,
    y: Interval,
    z: Interval,
    corner: float,
    wave: float = 0.0,
    phase: float = 0.0,
    top: float = 0.04,
    step: float = 0.06,
) -> Shape:
    """Cloth that hangs over a box: a flat top with round edges, and skirts that swing by ``wave`` at the hem."""
    core_x, core_y = (x[0] + corner + wave, x[1] - corner - wave), (y[0] + corner + wave, y[1] - corner - wave)
    points, normals = [], []
    corners = [
        (core_x[1], core_y[0], -90),
        (core_x[1], core_y[1], 0),
        (core_x[0], core_y[1], 90),
        (core_x[0], core_y[0], 180),
    ]
    for k, (cx, cy, start) in enumerate(corners):
        for a in (0, 30, 60, 90):
            angle = math.radians(start + a)
            points.append((cx, cy))
            normals.append((math.cos(angle), math.sin(angle)))
        nx, ny, _ = corners[(k + 1) % 4]
        length = math.hypot(nx - cx, ny - cy)
        count = max(1, round(length / step)) if wave > 0 else 1
        for i in range(1, count):
            points.append((cx + (nx - cx) * i / count, cy + (ny - cy) * i / count))
            normals.append(
                normals[-1] if i > 1 else (math.cos(math.radians(start + 90)), math.sin(math.radians(start + 90)))
            )
    base, out = np.array(points), np.array(normals)
    n = len(base)
    run = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(base + corner * out, axis=0), axis=1))])
    swing = 0.5 + 0.35 * np.sin(run * 19 + phase) + 0.15 * np.sin(run * 41 + 2 * phase)
    swing *= np.clip(1 + 1.5 * out[:, 0], 0, 1)  # none at the head
    r = min(top, 0.9 * corner)
    rings = []
    for share in (1.0, 0.55, 0.15) if wave > 0 else (1.0,):
        height = z[0] + (1 - share) * (z[1] - r - z[0])
        rings.append(np.c_[base + out * (corner + wave * share * swing)[:, None], np.full(n, height)])
    for a in (0, 30, 60, 90):
        s = math.radians(a)
        rings.append(np.c_[base + out * (corner - r * (1 - math.cos(s))), np.full(n, z[1] - r + r * math.sin(s))])
    faces = [ring_faces(k * n, (k + 1) * n, n) for k in range(len(rings) - 1)]
    fan = np.arange(1, n - 1)
    faces.append(np.c_[0 * fan, fan + 1, fan])
    faces.append(np.c_[0 * fan, fan, fan + 1] + (len(rings) - 1) * n)
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)
