"""Bare drawings as bytes, exact to the bit: facts as JSON, and all numbers of the mesh in three blocks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import asdict
from typing import Any

import numpy as np

from sceneweaver.scene import Part, Surface, Zone

from ..asset import Asset, Origin
from ..body import Grasp, Hull, Interior, Link, Material, Mesh
from .bare import Bare
from .masses import Bulk

_KINDS = (np.float64, np.int32, np.float32)


def packed(bare: Bare) -> tuple[dict[str, Any], bytes]:
    """A row for JSON and the numbers of a bare drawing."""
    asset, mesh, bulk = bare.asset, bare.asset.mesh, bare.bulk
    assert mesh.uv is not None
    pieces = len(bare.slot)
    floats = [bulk.volume, bulk.area, mesh.vertices, *(hull.vertices for hull in asset.hulls)]
    whole = [bare.slot, bare.faces, bulk.link, mesh.faces, mesh.face_material, mesh.face_link]
    whole += [hull.faces for hull in asset.hulls]
    blocks = [_block(arrays, kind) for arrays, kind in zip((floats, whole, [mesh.uv]), _KINDS, strict=True)]
    row = {
        "blocks": [len(block) for block in blocks],
        "counts": [pieces, len(mesh.vertices), len(mesh.faces)],
        "hulls": [[len(h.vertices), len(h.faces), h.link, h.handle] for h in asset.hulls],
        "slots": [slot if isinstance(slot, int) else asdict(slot) for slot in bare.slots],
        "links": bulk.links,
        "mass": bare.mass,
        "shown": bare.shown,
        "asset": {
            "category": asset.category,
            "mount": asset.mount,
            "friction": asset.friction,
            "sides": asset.sides,
        },
        "origin": asdict(asset.origin),
        "parts": [[part.polygon, part.z] for part in asset.parts],
        "surfaces": [[s.name, s.polygon, s.z, s.headroom] for s in asset.surfaces],
        "zones": [[zone.name, zone.polygon, zone.z, zone.hard] for zone in asset.zones],
        "moves": [list(vars(link).values()) for link in asset.links],
        "grasps": [list(vars(grasp).values()) for grasp in asset.grasps],
        "interiors": [list(vars(room).values()) for room in asset.interiors],
        "key": bare.key,
    }
    return row, b"".join(blocks)


def unpacked(row: dict[str, Any], data: bytes | memoryview) -> Bare:
    """The bare drawing of a row and its numbers; nothing is checked again, as all comes from `packed`."""
    pieces, vertices, faces = row["counts"]
    hulls = row["hulls"]
    a, b, _ = row["blocks"]
    buffer = bytearray(data)  # arrays that may be written, as those of a drawing
    floats = np.frombuffer(buffer, np.float64, a // 8)
    whole = np.frombuffer(buffer, np.int32, b // 4, a)
    uv = np.frombuffer(buffer, np.float32, -1, a + b).reshape(-1, 3, 2)
    volume, area, points, *corners = _cut(floats, [pieces, pieces, 3 * vertices, *(3 * h[0] for h in hulls)])
    counts = [pieces, pieces, pieces, 3 * faces, faces, faces, *(3 * h[1] for h in hulls)]
    slot, count, link, triangles, material, moved, *sides = _cut(whole, counts)
    asset = Asset(
        id="",
        **(row["asset"] | {"sides": tuple(row["asset"]["sides"])}),
        mesh=Mesh(points.reshape(-1, 3), triangles.reshape(-1, 3), material, moved, (), uv),
        hulls=tuple(
            Hull(own.reshape(-1, 3), side.reshape(-1, 3), number, handle)
            for own, side, (_, _, number, handle) in zip(corners, sides, hulls, strict=True)
        ),
        parts=tuple(Part.model_construct(polygon=_polygon(plan), z=tuple(z)) for plan, z in row["parts"]),
        mass=0.0,
        origin=Origin(**_tuples(row["origin"])),
        surfaces=tuple(
            Surface.model_construct(name=name, polygon=_polygon(plan), z=z, headroom=headroom)
            for name, plan, z, headroom in row["surfaces"]
        ),
        zones=tuple(
            Zone.model_construct(name=name, polygon=_polygon(plan), z=tuple(z), hard=hard)
            for name, plan, z, hard in row["zones"]
        ),
        links=tuple(Link(*map(_tuple, values)) for values in row["moves"]),
        grasps=tuple(Grasp(*map(_tuple, values)) for values in row["grasps"]),
        interiors=tuple(Interior(*map(_tuple, values)) for values in row["interiors"]),
    )
    bare = Bare(
        asset=asset,
        slots=tuple(slot if isinstance(slot, int) else Material(**_tuples(slot)) for slot in row["slots"]),
        slot=slot,
        faces=count,
        bulk=Bulk(volume, area, link, row["links"]),
        mass=_tuple(row["mass"]),
        shown=row["shown"],
    )
    vars(bare)["key"] = row["key"]
    return bare


def _block(arrays: Iterable[np.ndarray], kind: type) -> bytes:
    found = [np.ascontiguousarray(array) for array in arrays]
    assert all(array.dtype == kind for array in found)
    return b"".join(array.tobytes() for array in found)


def _cut(block: np.ndarray, counts: Iterable[int]) -> Iterator[np.ndarray]:
    at = 0
    for count in counts:
        yield block[at : at + count]
        at += count


def _polygon(rows: list[list[float]]) -> Any:
    return tuple(map(tuple, rows))


def _tuple(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _tuples(row: dict[str, Any]) -> dict[str, Any]:
    return {key: _tuple(value) for key, value in row.items()}
