"""MetaScenes: scans as meshes in the scan's frame, with matrices of their physical simulation where these are there."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import InputError, load_json, named_inside
from sceneweaver.io.messages import path_name, quote

from ..frames import affine, yaw_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..shells import box_along
from ..values import Entry

_SCENES, _PHYSICS, _LAYOUT = "Annotation_scenes", "Physical_simu", "Layout"
_SUFFIXES = (".obj", ".glb", ".ply")


def _matches(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return (path / _SCENES).is_dir() or _is_scan(path)
    return path.suffix.lower() == ".json" and path.parent.name == _PHYSICS and b'"matrix"' in head


def _is_scan(path: Path) -> bool:
    return path.parent.name == _SCENES and any(_mesh(p) is not None for p in sorted(path.iterdir()) if p.is_dir())


def _mesh(folder: Path) -> Path | None:
    """The mesh of an instance: ``<inst>/<inst>.obj``, or ``mesh.obj`` there."""
    for stem in (folder.name, "mesh"):
        for suffix in _SUFFIXES:
            if (folder / f"{stem}{suffix}").is_file():
                return folder / f"{stem}{suffix}"
    return None


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    if path.is_dir() and (path / _SCENES).is_dir():
        scans = sorted(p for p in (path / _SCENES).iterdir() if p.is_dir())
        if not scans:
            raise InputError(f"{path_name(path)}: {_SCENES} holds no scan; unpack the data set there")
        for scan in scans:
            if options.room in (None, scan.name):
                yield _scan(scan, path, scan.name)
    elif path.is_dir():
        yield _scan(path, path.parent.parent, "")
    else:
        root = path.parent.parent
        roots = [root / _SCENES, *([options.folder, options.folder / _SCENES] if options.folder else [])]
        scan = next((r / path.stem for r in roots if (r / path.stem).is_dir()), None)
        if scan is None:
            Entry.of(path, load_json(path))["matrix"].mapping()
            raise InputError(
                f"{path_name(path)}: no {_SCENES}/{path.stem} beside {_PHYSICS}; give that folder as --asset-folder"
            )
        yield _scan(scan, root, "", path)


def _scan(scan: Path, root: Path, name: str, physics: Path | None = None) -> SourceRoom:
    notes: list[str] = []
    file = root / _PHYSICS / f"{scan.name}.json" if physics is None else physics
    matrices: dict[str, Entry] = {}
    if file.is_file():
        matrices = dict(Entry.of(file, load_json(file))["matrix"].items())
        notes.append("poses are those of the physical simulation; without its file they are the annotated ones")
    meshes = {p.name: m for p in sorted(scan.iterdir()) if p.is_dir() and (m := _mesh(p)) is not None}
    if missing := [k for k in matrices if k not in meshes]:
        shown = ", ".join(quote(k) for k in missing[:10])
        notes.append(f"without a mesh, left out: {shown}{' ...' if len(missing) > 10 else ''}")
    if not meshes:
        raise InputError(f"{path_name(scan)}: no <inst>/<inst>.obj in it; unpack the scan there")
    if matrices and (rest := [k for k in meshes if k not in matrices]):
        notes.append(f"{len(rest)} things have no matrix and stay where they were annotated")
    points = {k: _points(m) for k, m in meshes.items()}
    poses = {k: _pose(matrices.get(k), points[k]) for k in points}
    placed = {k: points[k] @ turn.T + at for k, (turn, at) in poses.items()}
    middle = np.mean([p[:, :2].min(axis=0) + np.ptp(p[:, :2], axis=0) / 2 for p in placed.values()], axis=0)
    objects = tuple(_object(k, meshes, points[k], placed[k], poses[k], middle) for k in meshes)
    notes.append("there are no categories and no fronts: boxes are the least ones seen from above, facing the middle")
    outline = _outline(root / _LAYOUT, scan.name, notes)
    return SourceRoom(name, "", outline, None, (), objects, "", tuple(notes))


def _points(mesh: Path) -> np.ndarray:
    from sceneweaver.assets.imports.load import load

    raw = load(mesh)
    points = raw.vertices[np.unique(raw.faces)]
    return points[:, [0, 2, 1]] * (1.0, -1.0, 1.0) if mesh.suffix.lower() == ".glb" else points


def _pose(matrix: Entry | None, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Linear part [3, 3] and translation [3]: a matrix is applied after the mesh was centred on its box."""
    if matrix is None:
        return np.eye(3), np.zeros(3)
    values = matrix.matrix(4, 4)
    try:
        at, turn, scale = affine(values)
    except ValueError as error:
        raise matrix.error(f"{error}; give 4 rows of 4 numbers") from None
    linear = turn * scale
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return linear, at - linear @ centre


def _object(
    name: str,
    meshes: dict[str, Path],
    points: np.ndarray,
    placed: np.ndarray,
    pose: tuple[np.ndarray, np.ndarray],
    middle: np.ndarray,
) -> SourceObject:
    """An object with the least box of its mesh, seen from above in the annotated frame, turned as the matrix says."""
    linear, _ = pose
    turn = linear / np.linalg.norm(linear, axis=0)
    yaw = _least(points)
    inward = turn.T @ np.array([*(middle - (placed.min(axis=0) + placed.max(axis=0))[:2] / 2), 0.0])
    sides = [yaw + k * np.pi / 2 for k in range(4)]
    front = max(sides, key=lambda a: round(float(np.cos(a) * inward[0] + np.sin(a) * inward[1]), 9))
    own = yaw_matrix(front)
    centre, size = box_along(placed, turn @ own)
    parent = name.partition("-")[0] if "-" in name else ""
    return SourceObject(
        name,
        "",
        (float(centre[0]), float(centre[1]), float(centre[2])),
        turn @ own,
        size,
        asset=f"{meshes[name].parent.parent.name}/{name}",
        mesh=meshes[name],
        mesh_axes=own.T,
        support=parent if parent in meshes and parent != name else None,
    )


def _least(points: np.ndarray) -> float:
    """The angle [rad] in [0, pi/2) of the least rectangle around points seen from above."""
    import shapely

    hull = shapely.MultiPoint(points[:, :2]).convex_hull
    ring = shapely.get_coordinates(hull.minimum_rotated_rectangle)
    if len(ring) < 4:
        return 0.0
    dx, dy = ring[1] - ring[0]
    angle = float(np.arctan2(dy, dx) % (np.pi / 2))
    return 0.0 if angle > np.pi / 2 - 1e-9 else angle


def _outline(folder: Path, scan: str, notes: list[str]) -> tuple[tuple[float, float], ...] | None:
    """The floor of the heuristic layout, whose corners are listed first; that of RoomFormer is in another frame."""
    file = named_inside(folder, folder / "Heuristic" / f"{scan}.json")
    if file is None or not file.is_file():
        if (folder / "RoomFormer" / f"{scan}.json").is_file():
            notes.append("the layout of RoomFormer is in a frame of its own; it is not read")
        return None
    data = Entry.of(file, load_json(file))
    corners = [[v.number() for v in p.entries()] for p in data["vert" if data.has("vert") else "verts"].entries()]
    if len(corners) < 4 or any(len(p) < 2 for p in corners):
        raise data.error("'vert' must hold at least four points [x, y, z]")
    return tuple((p[0], p[1]) for p in corners[:4])


FORMAT = SourceFormat(
    "metascenes",
    "MetaScenes (Annotation_scenes, Physical_simu)",
    _matches,
    _read,
    notes=(
        "Read: the folder of the data set (each scan a room), one scan below Annotation_scenes, or the file of a scan "
        "below Physical_simu. Meshes lie in the scan's frame (z up, metres); a matrix (row by row) is applied after "
        "the mesh is centred on its box. Small things (`<inst>-<k>`) stand on their instance. The outline is the "
        "floor of Layout/Heuristic.",
        "Assumed: the least rectangle seen from above is an object's box, and the side of it that faces the middle of "
        "the scan is its front: the data set has neither fronts nor categories.",
        "Lost: RoomFormer's layouts, doors and windows.",
    ),
    licence="MetaScenes terms of use (data)",
)
