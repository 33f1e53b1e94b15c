"""A mesh file as an asset: normalised, simplified, with collision parts, surfaces, zones and mass."""

from __future__ import annotations

import hashlib
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.runtime.deadline import SEARCH, Deadline, TimeUp
from sceneweaver.scene import InputError, Zone

from ..asset import Asset, Origin
from ..body import Hull, Mesh
from ..category import Category, categories
from ..prisms import prisms_of
from ..shapes import hull
from ..zones import access_zones
from .collision import convex_parts
from .hints import Hints
from .limited import LimitedError, run_limited
from .load import RawMesh, load
from .normalise import normalise
from .surfaces import find_surfaces

MAX_TRIANGLES = 20_000
_DENSITY = 180.0
"""Mass [kg] of a cubic metre of hulls, where no category says more: furniture is mostly boards and air."""


def prepare(hints: Hints, *, cache: Path | None = None, seconds: float = 60.0) -> Asset:
    """Read, normalise and complete one mesh.

    ``cache`` is a folder for convex decompositions; ``seconds`` limits all of it.

    Raises:
        InputError: when the file cannot be used, or not in time, in one line that names it.
    """
    deadline = Deadline(time.monotonic() + seconds)
    try:
        with deadline.enforced():
            return _prepared(hints, cache, deadline)
    except TimeUp:
        if not deadline.passed:  # it was that of a block around this one
            raise
        line = f"{hints.path.name}: not done within {seconds:g} s; raise --time-limit, or simplify the mesh"
        raise InputError(line) from None


def _prepared(hints: Hints, cache: Path | None, deadline: Deadline) -> Asset:
    category = _category(hints)
    raw, notes = _simplified(load(hints.path, deadline.left), hints, SEARCH * deadline.left)
    body = normalise(raw, hints, category)
    mesh = body.mesh
    if hints.hulls:
        hulls, more = _given_hulls(hints, raw, body), []
    else:
        found, more = convex_parts(mesh.vertices, mesh.faces, cache=cache, seconds=SEARCH * deadline.left)
        hulls = tuple(found)
    # A seat is flat as well: only what is meant to carry things, or is not known, has surfaces.
    carries = category is None or (bool(category.holds) and category.body == "hard")
    surfaces = find_surfaces(mesh.vertices, mesh.faces) if carries else ()
    low, high = mesh.bounds
    size = tuple(float(v) for v in high - low)
    clear = [
        (
            (min(x for x, _ in s.polygon), max(x for x, _ in s.polygon)),
            (min(y for _, y in s.polygon), max(y for _, y in s.polygon)),
            (s.z + 1e-3, s.z + min(s.headroom or 0.3, 0.3)),
        )
        for s in surfaces
    ]
    mount = hints.mount or (category.mount[0] if category else "surface" if max(size) < 0.35 else "floor")
    zones: tuple[Zone, ...] = access_zones(category, size) if category else ()
    asset = Asset(
        id="",
        category=category.name if category else hints.category or "object",
        mesh=mesh,
        hulls=hulls,
        parts=prisms_of(hulls, None, clear),
        mount=mount,  # pyright: ignore[reportArgumentType] - Hints.mount is checked when a scene uses it
        mass=hints.mass if hints.mass is not None else _mass(category, hulls, size),
        friction=hints.friction if hints.friction is not None else category.friction if category else 0.5,
        origin=Origin(
            source=hints.source,
            licence=hints.licence,
            attribution=hints.attribution,
            axes=body.axes,
            metres_per_unit=body.metres,
            front_confidence=body.confidence,
            notes=(*notes, *body.notes, *more),
        ),
        surfaces=surfaces,
        zones=zones,
        sides=category.sides if category else (),
        attributes=_attributes(hints, mesh),
        description=hints.description,
    )
    return replace(asset, id=f"{hints.source}:{_slug(hints.name)}-{content_hash(asset)[:12]}")


def content_hash(asset: Asset) -> str:
    """SHA-256 of all that makes the asset what it is, its id aside."""
    digest = hashlib.sha256()
    for array in (asset.mesh.vertices, asset.mesh.faces, asset.mesh.face_material, asset.mesh.face_link):
        digest.update(np.ascontiguousarray(array).tobytes())
    for h in asset.hulls:
        digest.update(h.vertices.tobytes() + h.faces.tobytes() + bytes([h.link & 255]))
    rest = (
        asset.category,
        asset.mesh.materials,
        asset.parts,
        asset.mount,
        asset.mass,
        asset.friction,
        asset.surfaces,
        asset.zones,
        asset.sides,
        asset.links,
        asset.grasps,
        asset.interiors,
        asset.masses,
        sorted(asset.attributes.items()),
        asset.origin,
        asset.description,
    )
    digest.update(repr(rest).encode())
    return digest.hexdigest()


def _category(hints: Hints) -> Category | None:
    if hints.category is None:
        return None
    from ..taxonomy import resolve

    match = resolve(hints.category)
    return None if match.generic else categories()[match.category]


def _simplified(raw: RawMesh, hints: Hints, seconds: float) -> tuple[RawMesh, tuple[str, ...]]:
    if len(raw.faces) <= MAX_TRIANGLES:
        return raw, ()
    given = {
        "vertices": raw.vertices,
        "faces": raw.faces,
        "groups": raw.face_material,
        "target": np.array(int(0.95 * MAX_TRIANGLES)),
    }
    try:
        made = run_limited("simplify", given, seconds)
    except LimitedError as error:
        raise InputError(f"{hints.path.name}: {len(raw.faces)} triangles could not be simplified ({error})") from error
    if not 4 <= len(made["faces"]) <= 2 * MAX_TRIANGLES:
        raise InputError(f"{hints.path.name}: {len(raw.faces)} triangles could not be simplified to {MAX_TRIANGLES}")
    slim = replace(raw, vertices=made["vertices"], faces=made["faces"], face_material=made["groups"])
    return slim, (f"simplified from {len(raw.faces)} to {len(slim.faces)} triangles",)


def _given_hulls(hints: Hints, raw: RawMesh, body) -> tuple[Hull, ...]:
    """Collision meshes that came with the asset, moved as the visual mesh was."""
    before = raw.vertices[np.unique(raw.faces)]
    # The one similarity that took the file's vertices to ours, found again from the two point sets.
    a, b = np.c_[before, np.ones(len(before))], body.mesh.vertices
    matrix, *_ = np.linalg.lstsq(a, b, rcond=None)
    made = []
    for path in hints.hulls:
        other = load(path)
        points = np.c_[other.vertices, np.ones(len(other.vertices))] @ matrix
        try:
            made.append(Hull(*hull(points)))
        except ValueError as error:
            raise InputError(f"{path.name}: a collision part without volume") from error
    return tuple(made)


def _mass(category: Category | None, hulls: tuple[Hull, ...], size: tuple[float, ...]) -> float:
    if category is not None and category.size is not None:
        low, high = category.mass
        least, most = (float(np.prod([r[k] for r in category.size.ranges])) for k in (0, 1))
        share = (float(np.prod(size)) - least) / max(1e-12, most - least)
        return round(low + (high - low) * min(1.0, max(0.0, share)), 3)
    boxes = sum(float(np.prod(np.ptp(h.vertices, axis=0))) for h in hulls)
    return round(max(0.01, _DENSITY * boxes), 3)


def _attributes(hints: Hints, mesh: Mesh) -> dict[str, Any]:
    from ..materials import color_name

    given = {k: v for k, v in hints.attributes.items() if v not in (None, "", [])}
    if "color" not in given and mesh.materials:
        a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
        area = np.bincount(mesh.face_material, np.linalg.norm(np.cross(b - a, c - a), axis=1), len(mesh.materials))
        given["color"] = color_name(mesh.materials[int(area.argmax())].color)
    return given


def _slug(name: str) -> str:
    kept = "".join(c if c.isalnum() else "-" for c in name.lower())
    return "-".join(part for part in kept.split("-") if part)[:60] or "asset"
