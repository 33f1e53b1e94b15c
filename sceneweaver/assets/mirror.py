"""An asset as a mirror shows it: what is at its left is at its right, so a door hangs at the other side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sceneweaver.scene import Zone

from .asset import Asset
from .body import Grasp, Hull, Interior, Link, Mesh

_FLIP = np.array([1.0, -1.0, 1.0])
_OTHER = {"left": "right", "right": "left"}

Vector = tuple[float, float, float]
Polygon = tuple[tuple[float, float], ...]


def mirrored(asset: Asset) -> Asset:
    """The asset with y turned into -y; its id stays."""
    return replace(
        asset,
        mesh=_mesh(asset.mesh),
        hulls=tuple(_hull(hull) for hull in asset.hulls),
        parts=tuple(part.model_copy(update={"polygon": _polygon(part.polygon)}) for part in asset.parts),
        surfaces=tuple(s.model_copy(update={"polygon": _polygon(s.polygon)}) for s in asset.surfaces),
        zones=tuple(mirrored_zone(zone) for zone in asset.zones),
        sides=tuple(_OTHER.get(side, side) for side in asset.sides),
        links=tuple(_link(link) for link in asset.links),
        grasps=tuple(_grasp(grasp) for grasp in asset.grasps),
        interiors=tuple(_interior(room) for room in asset.interiors),
    )


def mirrored_zone(zone: Zone) -> Zone:
    """A zone at the other side."""
    return zone.model_copy(update={"name": _OTHER.get(zone.name, zone.name), "polygon": _polygon(zone.polygon)})


def _mesh(mesh: Mesh) -> Mesh:
    uv = None if mesh.uv is None else np.ascontiguousarray(mesh.uv[:, ::-1])
    return replace(mesh, vertices=mesh.vertices * _FLIP, faces=np.ascontiguousarray(mesh.faces[:, ::-1]), uv=uv)


def _hull(hull: Hull) -> Hull:
    return replace(hull, vertices=hull.vertices * _FLIP, faces=np.ascontiguousarray(hull.faces[:, ::-1]))


def _link(link: Link) -> Link:
    low, high = link.limits
    limits = (-high + 0.0, -low + 0.0) if link.joint == "hinge" else link.limits  # a turn goes the other way
    return replace(link, axis=_vector(link.axis), anchor=_vector(link.anchor), limits=limits)


def _grasp(grasp: Grasp) -> Grasp:
    return replace(
        grasp,
        position=_vector(grasp.position),
        approach=_vector(grasp.approach),
        closing=_vector(grasp.closing),
    )


def _interior(room: Interior) -> Interior:
    (x0, y0, z0), (x1, y1, z1) = room.low, room.high
    return replace(room, low=(x0, -y1, z0), high=(x1, -y0, z1), entry=_vector(room.entry))


def _vector(v: Vector) -> Vector:
    return v[0], 0.0 - v[1], v[2]


def _polygon(polygon: Polygon) -> Polygon:
    """The corners, counter-clockwise again."""
    return tuple((x, 0.0 - y) for x, y in reversed(polygon))
