"""What every asset must keep, measured without the code that made it: sizes, parts, prisms, surfaces, balance.

``python -m tests.assets.rules [CATEGORY ...] [--seeds N]`` prints the faults and the worst figures.
"""

from __future__ import annotations

import argparse
import statistics
import time
from dataclasses import dataclass, field

import numpy as np

from sceneweaver.assets.asset import Asset
from sceneweaver.assets.body import Hull, Mesh
from sceneweaver.assets.category import Category, categories
from sceneweaver.assets.parametric import make, makers

SIZE_TOLERANCE = 1e-3
OUTSIDE = {"hard": 0.5e-3, "soft": 1e-2, "leaf": 1e-2}
MAX_EXCESS = 0.25
MAX_TRIANGLES = 20_000


def volume_of(mesh: Mesh) -> float:
    """Volume [m3] of the union of the mesh's closed pieces."""
    return float(_manifold(mesh.vertices, mesh.faces).volume())


def _manifold(vertices: np.ndarray, faces: np.ndarray):
    import manifold3d

    # Pieces overlap; manifold3d unites them when each is closed and faces outward.
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    n = len(vertices)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    graph = coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(n, n))
    count, label = connected_components(graph, directed=False)
    of_face = label[faces[:, 0]]
    bodies = []
    for k in range(count):
        mine = faces[of_face == k]
        if not len(mine):
            continue
        used, packed = np.unique(mine, return_inverse=True)
        mesh = manifold3d.Mesh64(vertices[used], packed.reshape(-1, 3).astype(np.uint64))
        bodies.append(manifold3d.Manifold(mesh))
    return manifold3d.Manifold.batch_boolean(bodies, manifold3d.OpType.Add)


@dataclass
class Findings:
    """Faults in words, and the figures that stand behind them."""

    faults: list[str] = field(default_factory=list)
    outside: float = 0.0
    excess: float = 0.0
    triangles: int = 0
    prisms: int = 0
    hulls: int = 0


def examine(asset: Asset, category: Category) -> Findings:
    """All rules on one asset."""
    found = Findings(triangles=len(asset.mesh.faces), prisms=len(asset.parts), hulls=len(asset.hulls))
    say = found.faults.append
    for name, value, (low, high) in zip(("depth", "width", "height"), asset.size, category.size.ranges, strict=True):
        if not low - SIZE_TOLERANCE <= value <= high + SIZE_TOLERANCE:
            say(f"{name} {value:.4f} outside {low} to {high}")
    least, most = category.mass
    if not least - 1e-3 <= asset.mass <= most + 1e-3:
        say(f"it weighs {asset.mass} kg, not {least} to {most}")
    if len(asset.masses) != len(asset.links) + 1 or min(asset.masses) <= 0:
        say(f"masses of its bodies: {asset.masses}")
    if found.triangles > MAX_TRIANGLES:
        say(f"{found.triangles} triangles")
    planes = []
    for k, hull in enumerate(asset.hulls):
        normals, offsets, problem = _planes(hull)
        if problem:
            say(f"hull {k}: {problem}")
        planes.append((normals, offsets))
    samples = _samples(asset)
    found.outside = _outside(samples[~_drinks(asset, samples)], planes, asset.hulls)
    if found.outside > OUTSIDE[category.body]:
        say(f"mesh stands {found.outside * 1e3:.2f} mm out of the parts")
    if not 1 <= found.prisms <= 8:
        say(f"{found.prisms} prisms")
    for part in asset.parts:
        if len(part.polygon) > 8:
            say(f"a prism of {len(part.polygon)} corners")
    for k, hull in enumerate(asset.hulls):
        if not any(_holds(part, hull.vertices) for part in asset.parts):
            say(f"hull {k} lies in no prism")
    try:
        volume = volume_of(asset.mesh)
    except Exception as error:
        say(f"the mesh is no set of closed pieces: {error}")
        volume = 0.0
    if volume <= 0:
        say("the mesh has no volume")
    elif category.body == "hard" and asset.mount == "floor":
        found.excess = _union(asset.hulls) / volume - 1
        if found.excess > MAX_EXCESS:
            say(f"parts are {found.excess * 100:.0f} % larger than the mesh")
    if asset.mount in ("floor", "surface"):
        _check_balance(asset, say)
    for surface in asset.surfaces:
        _check_surface(asset, surface, say)
    names = [link.name for link in asset.links]
    if len(set(names)) != len(names):
        say("two links of one name")
    for k, name in enumerate(names, start=1):
        if not (asset.mesh.face_link == k).any() or not any(h.link == k for h in asset.hulls):
            say(f"link {name} has no body")
    if not asset.mesh.materials:
        say("no material")
    return found


def _planes(hull: Hull) -> tuple[np.ndarray, np.ndarray, str]:
    v, f = hull.vertices, hull.faces
    edges = np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
    forward = {(int(a), int(b)) for a, b in edges}
    if len(forward) != len(edges) or any((b, a) not in forward for a, b in forward):
        return np.zeros((0, 3)), np.zeros(0), "not watertight"
    normal = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    area = np.linalg.norm(normal, axis=1)
    alive = area > 1e-12
    normal = normal[alive] / area[alive, None]
    offset = np.einsum("ij,ij->i", normal, v[f[alive, 0]])
    volume = float(np.einsum("ij,ij->i", v[f[:, 0]], np.cross(v[f[:, 1]], v[f[:, 2]])).sum() / 6)
    if volume <= 1e-12:
        return normal, offset, "no volume, or inside out"
    if float((v @ normal.T - offset).max()) > 2e-5:
        return normal, offset, f"not convex by {float((v @ normal.T - offset).max()) * 1e3:.3f} mm"
    return normal, offset, ""


def _samples(asset: Asset) -> np.ndarray:
    """Vertices, middles of edges and of faces of the mesh."""
    v, f = asset.mesh.vertices, asset.mesh.faces
    a, b, c = v[f[:, 0]], v[f[:, 1]], v[f[:, 2]]
    return np.concatenate([v, (a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3])


def _drinks(asset: Asset, points: np.ndarray) -> np.ndarray:
    """Which points [N, 3] lie in what a round vessel holds: between its floor and its rim, within its outline."""
    found = np.zeros(len(points), dtype=bool)
    for room in asset.interiors:
        if room.oval:
            wall = np.concatenate([h.vertices for h in asset.hulls if h.link == room.link])
            low, high = np.array(room.low), np.array(room.high)
            near = wall[(np.abs(wall - (low + high) / 2) < 0.75 * (high - low) + 0.02).all(axis=1)]
            inside = (points > np.r_[near.min(axis=0)[:2], low[2] - 1e-3]) & (
                points < np.r_[near.max(axis=0)[:2], high[2]]
            )
            found |= inside.all(axis=1)
    return found


def _outside(points: np.ndarray, planes: list, hulls: tuple[Hull, ...]) -> float:
    """How far the worst point lies outside the union of the hulls."""
    best = np.full(len(points), np.inf)
    for (normal, offset), hull in zip(planes, hulls, strict=True):
        low, high = hull.vertices.min(axis=0) - 0.02, hull.vertices.max(axis=0) + 0.02
        near = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1) & (best > 0))
        if len(near) and len(normal):
            best[near] = np.minimum(best[near], (points[near] @ normal.T - offset).max(axis=1))
    return float(max(0.0, min(best.max(initial=0.0), 1.0)))


def _holds(part, points: np.ndarray) -> bool:
    if points[:, 2].min() < part.z[0] - 1e-6 or points[:, 2].max() > part.z[1] + 1e-6:
        return False
    ring = np.array(part.polygon)
    edge = np.roll(ring, -1, axis=0) - ring
    normal = np.c_[edge[:, 1], -edge[:, 0]] / np.linalg.norm(edge, axis=1, keepdims=True)
    return bool((points[:, :2] @ normal.T - (normal * ring).sum(axis=1) <= 2e-6).all())


def _union(hulls: tuple[Hull, ...]) -> float:
    import manifold3d

    bodies = [manifold3d.Manifold(manifold3d.Mesh64(h.vertices, h.faces.astype(np.uint64))) for h in hulls]
    return float(manifold3d.Manifold.batch_boolean(bodies, manifold3d.OpType.Add).volume())


def _check_balance(asset: Asset, say) -> None:
    """The middle of mass must stand over the contact with the ground."""
    import shapely

    total, moment = 0.0, np.zeros(3)
    for hull in asset.hulls:
        v, f = hull.vertices, hull.faces
        volume = np.einsum("ij,ij->i", v[f[:, 0]], np.cross(v[f[:, 1]], v[f[:, 2]])) / 6
        total += volume.sum()
        moment += (volume[:, None] * (v[f[:, 0]] + v[f[:, 1]] + v[f[:, 2]]) / 4).sum(axis=0)
    points = np.concatenate([h.vertices for h in asset.hulls])
    ground = points[points[:, 2] < points[:, 2].min() + 0.004]
    base = shapely.MultiPoint(ground[:, :2]).convex_hull
    if total > 0 and not base.buffer(1e-6).covers(shapely.Point(moment[:2] / total)):
        say(f"falls over: middle of mass at {np.round(moment[:2] / total, 3).tolist()} is not over its feet")


def _check_surface(asset: Asset, surface, say) -> None:
    import shapely

    name = f"surface {surface.name}"
    ring = shapely.Polygon(surface.polygon)
    if not ring.is_valid or ring.area < 1e-5:
        say(f"{name}: polygon of no use")
        return
    still = asset.mesh.face_link == 0
    triangles = asset.mesh.vertices[asset.mesh.faces[still]]
    inner = ring.buffer(-min(0.01, 0.2 * np.sqrt(ring.area)))
    points = _grid(inner if not inner.is_empty else ring)
    down = _vertical(triangles, points, surface.z + 0.01, up=False)
    flat = np.abs(down - 0.01) < 2e-3  # as far as the judge lets things stand off their surface
    if flat.mean() < 0.95:
        say(f"{name}: {100 * flat.mean():.0f} % of it is flat at z {surface.z:.3f}")
    up = _vertical(triangles, points, surface.z + 0.003, up=True) + 0.003
    room = np.inf if surface.headroom is None else surface.headroom
    lack = up < (min(room, 5.0) - 1.5e-3)
    if lack.any():
        say(f"{name}: only {up.min():.3f} m of head room, not {room}")
    start = np.c_[points, np.full(len(points), surface.z + min(0.05, 0.5 * min(room, 1.0)))]
    free = np.isinf(_vertical(triangles, points, float(start[0, 2]), up=True))
    for k in range(8):
        angle = k * np.pi / 4
        direction = np.array([np.cos(angle), np.sin(angle), 0.0])
        todo = np.flatnonzero(~free)
        if len(todo):
            free[todo] = ~_hits(triangles, start[todo], direction)
    if free.mean() < 0.6:
        say(f"{name}: {100 * free.mean():.0f} % of it can be reached")
    top = surface.z + min(room, 0.25)
    core = ring.buffer(-0.004)
    for part in asset.parts:
        if part.z[0] < top - 2e-3 and part.z[1] > surface.z + 2e-3:
            share = shapely.Polygon(part.polygon).intersection(core).area / ring.area
            if share > 0.01:
                say(f"{name}: a prism at z {part.z[0]:.3f} to {part.z[1]:.3f} fills {100 * share:.0f} % of its room")


def _grid(shape, count: int = 8) -> np.ndarray:
    import shapely

    x0, y0, x1, y1 = shape.bounds
    x, y = np.meshgrid(
        x0 + (np.arange(count) + 0.493) / count * (x1 - x0), y0 + (np.arange(count) + 0.507) / count * (y1 - y0)
    )
    points = np.c_[x.ravel(), y.ravel()]
    inside = points[shapely.contains_xy(shape, points)]
    return inside if len(inside) else np.array([shape.representative_point().coords[0]])


def _vertical(triangles: np.ndarray, points: np.ndarray, z: float, up: bool) -> np.ndarray:
    """Distance from height z to the first triangle above (or below) each point; inf when there is none."""
    best = np.full(len(points), np.inf)
    low, high = triangles[..., :2].min(axis=1), triangles[..., :2].max(axis=1)
    for i, (x, y) in enumerate(points):
        near = triangles[((low <= (x, y)) & (high >= (x, y))).all(axis=1)]
        a, b, c = near[:, 0], near[:, 1], near[:, 2]
        det = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
        good = np.abs(det) > 1e-14
        a, b, c, det = a[good], b[good], c[good], det[good]
        u = ((x - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (y - a[:, 1])) / det
        v = ((b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (x - a[:, 0]) * (b[:, 1] - a[:, 1])) / det
        height = a[:, 2] + u * (b[:, 2] - a[:, 2]) + v * (c[:, 2] - a[:, 2]) - z
        gap = (height if up else -height)[(u >= 0) & (v >= 0) & (u + v <= 1)]
        best[i] = gap[gap >= 0].min(initial=np.inf)
    return best


def _hits(triangles: np.ndarray, origins: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """Whether a ray from each origin meets a triangle (Moeller and Trumbore)."""
    a, e1, e2 = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    p = np.cross(direction, e2)
    det = np.einsum("ij,ij->i", e1, p)
    good = np.abs(det) > 1e-14
    a, e1, e2, p, det = a[good], e1[good], e2[good], p[good], det[good]
    hit = np.zeros(len(origins), dtype=bool)
    for i, origin in enumerate(origins):
        t = origin - a
        u = np.einsum("ij,ij->i", t, p) / det
        q = np.cross(t, e1)
        v = q @ direction / det
        s = np.einsum("ij,ij->i", e2, q) / det
        hit[i] = bool(((u >= 0) & (v >= 0) & (u + v <= 1) & (s > 1e-6)).any())
    return hit


def main() -> int:
    """Examine categories and print faults, the worst ten and times."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("categories", nargs="*")
    parser.add_argument("--seeds", type=int, default=20)
    options = parser.parse_args()
    names = options.categories or sorted(makers())
    rows, bad, seconds = [], 0, []
    make(names[0], 0)
    for name in names:
        worst = Findings()
        for seed in range(options.seeds):
            start = time.perf_counter()
            asset = make(name, seed)
            seconds.append(time.perf_counter() - start)
            found = examine(asset, categories()[name])
            for fault in found.faults:
                print(f"{name} seed {seed}: {fault}")
            bad += bool(found.faults)
            for key in ("outside", "excess", "triangles", "prisms", "hulls"):
                setattr(worst, key, max(getattr(worst, key), getattr(found, key)))
        rows.append((name, worst, statistics.median(seconds[-options.seeds :])))
    print(
        f"{len(names)} categories x {options.seeds} seeds: {bad} assets with faults; "
        f"median {1e3 * statistics.median(seconds):.1f} ms, slowest {1e3 * max(seconds):.0f} ms"
    )
    rows.sort(key=lambda row: (-row[1].excess, -row[1].outside))
    print("worst ten by excess: category | excess % | outside mm | triangles | hulls | prisms | ms")
    for name, worst, took in rows[:10]:
        print(
            f"{name} | {100 * worst.excess:.1f} | {1e3 * worst.outside:.3f} | {worst.triangles} | {worst.hulls} | "
            f"{worst.prisms} | {1e3 * took:.1f}"
        )
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
