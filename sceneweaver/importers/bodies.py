"""What stands for an imported object: our furniture of that category and size, its own mesh, or its box."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np

from sceneweaver.assets import Asset, Library, Store
from sceneweaver.assets.category import Sizes
from sceneweaver.assets.sources.stored import OF_SCENES
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.scene import InputError, Part, SceneObject, Surface, Zone

from .categories import Named
from .model import Corners, Mount, SourceObject

Assets = Literal["own", "theirs", "boxes"]

STEP = 0.05
"""Drawings are made in steps of this size [m] and then stretched to the exact one, so that equal ones are shared."""

STRETCH = 2.0
"""Most factor by which a drawing is stretched along one of its axes; a box stands for what is further off."""


def with_body(thing: SceneObject, source: SourceObject, named: Named, assets: Assets, notes: list[str]) -> SceneObject:
    """The object with a body in its size.

    Args:
        thing: the object as a plain box.
        source: what the file says of it.
        named: its category.
        assets: whose furniture stands for it.
        notes: gets a line where a box has to do.
    """
    if assets == "theirs" and source.mesh is not None:
        try:
            return _stretched(thing, _imported(source, named.category, thing.mount))
        except InputError as error:
            notes.append(f"{thing.id}: its mesh is not taken ({error}); our own furniture stands for it")
    if source.parts:
        return _hollow(thing, source)
    if assets == "theirs" and source.mesh is None:
        notes.append(f"{thing.id}: no mesh in the asset folder; our own furniture stands for it")
    if assets != "boxes":
        asset = _drawn(named.body, _steps(named.body, thing.size))
        if asset is not None and _near(asset.size, thing.size):
            return _stretched(thing, asset)
    return _box(thing)


def _steps(body: str, size: tuple[float, float, float]) -> tuple[float, float, float]:
    """The size [m] nearest to one in which a category can be drawn, in steps."""
    sizes = category_named(body).size
    d, w, h = (_within(v, sizes, k) for k, v in enumerate(size))
    return d, w, h


def _within(value: float, sizes: Sizes | None, axis: int) -> float:
    low, high = sizes.ranges[axis] if sizes is not None else (value, value)
    return round(min(max(STEP * round(value / STEP), low), high), 4)


@lru_cache(maxsize=4096)
def _drawn(category: str, size: tuple[float, float, float]) -> Asset | None:
    """Our furniture of a category; None when there is no drawing of it in about that size."""
    try:
        return Library().load(f"parametric:{category}?seed=0&size={','.join(f'{v:g}' for v in size)}")
    except InputError:
        return None


@lru_cache(maxsize=1)
def _store() -> Store:
    return Store()


def _imported(source: SourceObject, category: str, mount: Mount) -> Asset:
    """The user's mesh as an asset of the store; the same content is kept once."""
    from sceneweaver.assets.imports.hints import Hints
    from sceneweaver.assets.imports.prepare import content_hash, prepare

    assert source.mesh is not None
    linear = source.mesh_axes @ np.diag(source.scale)
    transform = tuple((*(float(v) for v in row), 0.0) for row in linear)
    hints = Hints(
        path=source.mesh,
        name=source.asset or source.mesh.stem,
        category=category,
        up="z",
        front="x",
        metres=1.0,
        mount=mount,
        transform=(*transform, (0.0, 0.0, 0.0, 1.0)),
        source=OF_SCENES,
    )
    asset = prepare(hints, cache=_store().cache)
    _store().add(asset, content_hash(asset))
    return asset


def _near(drawn: tuple[float, float, float], wanted: tuple[float, float, float]) -> bool:
    return all(1 / STRETCH <= w / d <= STRETCH for d, w in zip(drawn, wanted, strict=True))


def _stretched(thing: SceneObject, asset: Asset) -> SceneObject:
    """The object with an asset's body, stretched to the object's size."""
    x, y, z = (w / d for d, w in zip(asset.size, thing.size, strict=True))

    def flat(polygon):
        return tuple((px * x, py * y) for px, py in polygon)

    def span(interval):
        return interval[0] * z, interval[1] * z

    return thing.model_copy(
        update={
            "asset": asset.id,
            "parts": tuple(Part(polygon=flat(p.polygon), z=span(p.z)) for p in asset.parts),
            "zones": tuple(Zone(name=o.name, polygon=flat(o.polygon), z=span(o.z), hard=o.hard) for o in asset.zones),
            "surfaces": tuple(
                Surface(
                    name=s.name,
                    polygon=flat(s.polygon),
                    z=s.z * z,
                    headroom=None if s.headroom is None else s.headroom * z,
                )
                for s in asset.surfaces
            ),
            "attributes": {**asset.attributes, **thing.attributes},
        }
    )


def _hollow(thing: SceneObject, source: SourceObject) -> SceneObject:
    """The object as the boxes that its file says it consists of; the tops of all of them carry, and hollows too."""
    parts = tuple(Part(polygon=_flat(box), z=(box[0][2], box[1][2])) for box in source.parts)
    hollows = [Surface(name=f"hollow_{k}", polygon=_flat(box), z=box[0][2]) for k, box in enumerate(source.hollows)]
    tops = [p for p in parts if p.z[1] < thing.size[2] - 1e-6]
    surfaces = [Surface(name=f"part_{k}", polygon=p.polygon, z=p.z[1]) for k, p in enumerate(tops)]
    made = _box(thing)
    return made.model_copy(update={"parts": parts, "surfaces": (*hollows, *made.surfaces, *surfaces)})


def _flat(box: Corners) -> tuple[tuple[float, float], ...]:
    (x0, y0, _), (x1, y1, _) = box
    return (x0, y0), (x1, y0), (x1, y1), (x0, y1)


def _box(thing: SceneObject) -> SceneObject:
    """The object as a box with a top that carries."""
    top = Surface(name="top", polygon=rectangle(*thing.size[:2]), z=thing.size[2])
    return thing.model_copy(update={"surfaces": (top,)})
