"""From a finished drawing to an asset: one mesh, hulls, prisms, surfaces, zones and links about one origin."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sceneweaver.scene import Part, Surface, Zone

from ..asset import Asset, Origin
from ..body import Hull, Mesh
from ..mirror import mirrored
from ..postures import postured
from ..prisms import prisms_of
from ..zones import access_zones, opening_zones
from .bare import Bare, Slot
from .box import Interval
from .contents import filled
from .drawing import Drawing
from .layout import texture_coordinates
from .marks import marked
from .masses import bulk_of
from .tree import Piece, vec3
from .watched import Watched

Bounds = tuple[Interval, Interval, Interval]


def asset_of(drawing: Drawing) -> Asset:
    """All that was drawn, as an asset with its origin at the bottom centre of its box."""
    return bare_of(drawing).finished(drawing.trace.given, drawing.finishes)


def bare_of(drawing: Drawing) -> Bare:
    """All that was drawn, without its finishes."""
    drawn, category, request = drawing.drawn, drawing.category, drawing.request
    slots: dict[Slot, int] = {}
    inside = filled(drawn.pieces, drawn.interiors, request.posture, category.name)
    inside += marked(drawn.pieces, request.posture, category.name)
    pieces = [*drawn.pieces, *inside]
    slot = np.array([slots.setdefault(_slot(piece), len(slots)) for piece in pieces], dtype=np.int32)
    mesh = _mesh(pieces, slot)
    low, high = mesh.bounds
    shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    mesh.vertices[:] -= shift
    # In one order in memory, as they come back from other processes.
    hulls = tuple(replace(h, vertices=h.vertices - shift, faces=np.ascontiguousarray(h.faces)) for h in drawn.hulls)
    surfaces = tuple(_moved(s, shift) for s in drawn.surfaces)
    d, w, h = (float(v) for v in high - low)
    x, y, z = vec3(shift)
    free = [box.move(-x, -y, -z) for box in drawn.clear]
    clear = [(box.x, box.y, box.z) for box in free] + [_above(s) for s in surfaces]
    zones = [Zone(name=k.name, polygon=_shifted(k.polygon, shift), z=k.z, hard=k.hard) for k in drawn.zones]
    zones += access_zones(category, (d, w, h), {k.name for k in zones})
    links = tuple(replace(k, anchor=vec3(np.array(k.anchor) - shift)) for k in drawn.links)
    if "surface" not in category.mount:
        zones += opening_zones(hulls, links, zones, (d, w, h), laden=bool(surfaces))
    shown: dict[str, Any] = dict(_counted(drawing))
    parts = prisms_of(hulls, drawn.groups, clear)
    if request.shape and outline_shape(hulls, drawing.outline_axes) == request.shape:
        shown["shape"] = request.shape
    asset = Asset(
        id="",
        category=request.label or category.name,
        mesh=mesh,
        hulls=hulls,
        parts=parts,
        mount=category.mount[0],
        mass=0.0,
        friction=category.friction,
        origin=Origin(source="parametric", licence="Apache-2.0", attribution="sceneweaver"),
        surfaces=tuple(_on_parts(s, parts) for s in surfaces),
        zones=tuple(zones),
        sides=category.sides,
        links=links,
        grasps=tuple(replace(k, position=vec3(np.array(k.position) - shift)) for k in drawn.grasps),
        interiors=tuple(
            replace(k, low=vec3(np.array(k.low) - shift), high=vec3(np.array(k.high) - shift)) for k in drawn.interiors
        ),
    )
    asset = mirrored(asset) if request.mirrored else asset
    if request.posture is not None:
        placed = postured(asset, request.posture, drawn.groups)
        if placed is not asset or drawing.posed or inside:
            shown["posture"] = request.posture
        asset = placed
    return Bare(
        asset=asset,
        slots=tuple(slots),
        slot=slot,
        faces=np.array([len(piece.faces) for piece in pieces], dtype=np.int32),
        bulk=bulk_of(pieces, len(drawn.links)),
        mass=category.mass,
        shown=shown,
    )


def _slot(piece: Piece) -> Slot:
    material = piece.material
    return material.number if isinstance(material, Watched) else material


def _mesh(pieces: Sequence[Piece], slot: np.ndarray) -> Mesh:
    starts = np.cumsum([0] + [len(piece.vertices) for piece in pieces])
    count = [len(piece.faces) for piece in pieces]
    return Mesh(
        vertices=np.concatenate([piece.placed for piece in pieces]),
        faces=np.concatenate([p.faces + s for p, s in zip(pieces, starts[:-1], strict=True)]).astype(np.int32),
        face_material=np.repeat(slot, count),
        face_link=np.repeat([piece.link for piece in pieces], count).astype(np.int32),
        materials=(),
        uv=texture_coordinates(pieces),
    )


def _counted(drawing: Drawing) -> dict[str, int]:
    """How many there are of the parts that were asked for, as far as they can be told from what was drawn."""
    roles = [link.role for link in drawing.drawn.links]
    there = {
        "drawers": roles.count("drawer"),
        "doors": roles.count("door"),
        "shelves": len(drawing.drawn.surfaces),
    }
    return {name: there[name] for name, _ in drawing.request.parts if there.get(name)}


def outline_shape(hulls: Sequence[Hull], axes: tuple[int, int] = (0, 1)) -> str | None:
    """Round, oval, square or rectangular: what the outline of some bodies is, along two axes; None: something else."""
    import shapely

    outline = shapely.MultiPoint(np.concatenate([h.vertices[:, list(axes)] for h in hulls])).convex_hull
    ring = shapely.get_coordinates(outline.minimum_rotated_rectangle)
    a, b = sorted(np.linalg.norm(ring[k + 1] - ring[k]) for k in (0, 1))
    fill, even = outline.area / max(a * b, 1e-12), b < 1.12 * a
    if fill > 0.9:
        return "square" if even else "rectangular"
    if 0.74 < fill < 0.87:
        return "round" if even else "oval"
    return None


THICK = 0.003
"""Height [m] by which a prism may stand above the surface that it carries, as it takes in a rim or a joint."""


def _on_parts(surface: Surface, parts: Sequence[Part]) -> Surface:
    """The surface as high as the prisms under it, so that what stands on it does not stand in them."""
    import shapely

    inner = shapely.Polygon(surface.polygon).buffer(-0.002)
    tops = [
        part.z[1]
        for part in parts
        if part.z[0] < surface.z < part.z[1] <= surface.z + THICK
        and shapely.Polygon(part.polygon).intersection(inner).area > 1e-4
    ]
    if not tops:
        return surface
    room = None if surface.headroom is None else surface.headroom - (max(tops) - surface.z)
    return surface.model_copy(update={"z": max(tops), "headroom": room})


def _moved(surface: Surface, shift: np.ndarray) -> Surface:
    return Surface(
        name=surface.name,
        polygon=_shifted(surface.polygon, shift),
        z=round(surface.z - float(shift[2]), 6),
        headroom=surface.headroom,
    )


def _shifted(polygon, shift: np.ndarray) -> tuple[tuple[float, float], ...]:
    return tuple((round(x - float(shift[0]), 6), round(y - float(shift[1]), 6)) for x, y in polygon)


def _above(surface: Surface) -> Bounds:
    """The box over a surface that must stay free of prisms, a little smaller than the room itself."""
    xs, ys = [p[0] for p in surface.polygon], [p[1] for p in surface.polygon]
    top = surface.z + min(surface.headroom or 0.3, 0.3)
    return (min(xs) + 1e-3, max(xs) - 1e-3), (min(ys) + 1e-3, max(ys) - 1e-3), (surface.z + 1e-3, top - 1e-3)
