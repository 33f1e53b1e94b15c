"""Where things hang from hooks, rails and backs: places below or before the body of what carries them.

Each hung thing gets a surface of its own, as high as its bottom is: engine and judge then know it as they know what
stands on something, and it goes where its carrier goes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from sceneweaver.assets import Asset, Library, Wish
from sceneweaver.assets.carrying import HOOK, Carrier, bare_body, carrier, hung
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.scene import InputError, Pose, SceneObject, Support, Surface

from .carry import world
from .cavities import upright
from .program import Wanted

BARE = "bare"
"""The shape of a carrier without what usually hangs from it: what is asked for hangs there instead."""

TOUCH = 0.001
"""Gap [m] between a thing and what it hangs from."""

GRID = 0.02
"""Distance [m] of the places that are tried."""

CLEAR = 0.03
"""Least height [m] of what hangs above the floor."""

LOWER = (0.0, 0.06, 0.15, 0.3, 0.45, 0.6)
"""How far [m] below the upper edge of a board something hangs before it, the highest first."""

APART = 0.25
"""Distance [m] from what hangs there already beyond which more is no better."""

LAST = 5.0
"""What it counts that something hangs in another way than the usual one."""

TURNED = 0.1
"""What it counts beside that it is turned otherwise than usual."""

FLAT = 0.6
"""Height of a thing, in lengths of its longer side, up to which it is turned on end to hang: a pan, a coil of rope."""

SIDES = {"front": (1, 0, 0.0), "back": (-1, 0, math.pi), "left": (0, 1, math.pi / 2), "right": (0, -1, -math.pi / 2)}
"""Of the sides of a thing: the way out of it, and the turn [rad] of what hangs before it."""


CEILING = 2.4
"""Height [m] of a ceiling that is not known yet."""

GROWN = (1.0, 1.35)
"""Widths, in shares of the widest of its kind, to which a carrier grows when what is to hang from it has no room."""

SLIM = "hung_towel"
"""The category of the body of cloth that takes the least room."""


class Hanging(Protocol):
    """What things are called by id in the request, the objects that have a place, and hooks by the carrier's id."""

    nouns: dict[str, str]
    objects: dict[str, SceneObject]
    hooks: dict[str, tuple[Surface, ...]]


@dataclass(frozen=True)
class Place:
    """Where a thing hangs in the frame of its carrier: middle [m], height of its bottom [m], turn [rad]."""

    x: float
    y: float
    z: float
    yaw: float


def hung_body(asset: Asset, category: str, noun: str, wish: Wish | None, library: Library) -> Asset:
    """The body that a thing has where it hangs: a towel falls, a pan hangs by its handle; of the same category."""
    row = hung(category, noun)
    if row is not None and row.body and wish is not None:
        try:
            made = library.choose(
                row.body, 1, replace(wish, size=(None, None, None), shape=None, mount=None, suite=None)
            )[0]
        except InputError:
            return asset
        return replace(made, category=asset.category)
    depth, width, height = asset.size
    if height <= FLAT * max(depth, width) and "hung" not in category:
        return upright(asset, category, wish, library)
    return asset


def bare(asset: Asset, category: str, wish: Wish | None, library: Library) -> Asset:
    """A carrier without what usually hangs from it, of the same size; as it is where there is no such body."""
    if wish is None or wish.shape is not None:
        return asset
    depth, width, height = asset.size
    other = bare_body(category)
    wanted = replace(wish, shape=BARE, size=(depth, width, None if other else height), beyond=True)
    try:
        return replace(library.choose(other or category, 1, wanted)[0], category=asset.category)
    except InputError:
        return asset


def hang_on(support: Wanted, riders: Sequence[Wanted], library: Library, names: Hanging, fixed: bool) -> list[Wanted]:
    """Hang things from one carrier, which grows for them where it may; those without room are given back.

    Args:
        support: the carrier; what usually hangs from it gives way.
        riders: what hangs from it; they get the bodies that they have there.
        library: where bodies come from.
        names: what things are called, and where the surfaces and objects go.
        fixed: whether the carrier's body has to stay as it is.
    """
    kind = carrier(support.category, names.nouns.get(support.asked or "", ""))
    held = names.objects.get(support.id)
    if held is None and not fixed:
        stripped = bare(support.asset, support.category, support.wish, library)
        if stripped is not support.asset and support.wish is not None:
            support.asset, support.wish = stripped, replace(support.wish, shape=BARE)
    bodies = [
        hung_body(one.asset, one.category, names.nouns.get(one.asked or "", ""), one.wish, library) for one in riders
    ]
    found = _found(support, held, kind, bodies)
    usual = category_named(support.category).size
    for share in GROWN if None in found and held is None and not fixed and usual is not None else ():
        assert usual is not None
        width = usual.width[1] * share
        if width <= support.asset.size[1] or support.wish is None:
            continue
        wish = replace(support.wish, size=(support.asset.size[0], round(width, 3), support.asset.size[2]), beyond=True)
        try:
            larger = library.choose(bare_body(support.category) or support.category, 1, wish)[0]
        except InputError:
            continue
        again = _found(support, None, kind, bodies, larger)
        if again.count(None) < found.count(None):
            support.asset, found = replace(larger, category=support.asset.category), again
        if None not in found:
            break
    if None in found:  # closer together: as slim as they come
        slim = [_slimmer(body, one, library) for body, one in zip(bodies, riders, strict=True)]
        again = _found(support, held, kind, slim)
        if again.count(None) < found.count(None):
            bodies, found = slim, again
    good = [(one, body, place) for one, body, place in zip(riders, bodies, found, strict=True) if place is not None]
    hooks = hooks_of([(body, place) for _, body, place in good])
    if held is not None:
        names.objects[support.id] = held.model_copy(update={"surfaces": (*held.surfaces, *hooks)})
    else:
        names.hooks[support.id] = tuple(hooks)
    pose = held.pose if held is not None else Pose()
    for (one, body, place), surface in zip(good, hooks, strict=True):
        one.asset = body
        names.objects[one.id] = body.object(
            one.id,
            pose=world(pose, place.x, place.y, place.z, place.yaw),
            support=Support(object=support.id, surface=surface.name),
        )
    return [one for one, place in zip(riders, found, strict=True) if place is None]


def _found(
    support: Wanted, held: SceneObject | None, kind: Carrier, bodies: Sequence[Asset], asset: Asset | None = None
) -> list[Place | None]:
    asset = asset or support.asset
    mount = held.mount if held is not None else support.mount
    obj = held or asset.object(support.id, mount="floor" if mount == "surface" else mount)  # type: ignore[arg-type]
    return hang(obj, kind, bodies, lift_of(mount, asset, CEILING, support.hung), mount == "wall")


def _slimmer(body: Asset, one: Wanted, library: Library) -> Asset:
    """A body that takes less room: a towel folded over where a shirt is too long, else the smallest of its kind."""
    drawn = (body.drawn_as or body.id).split("/")[0]
    row = hung(one.category, "") or hung(one.category, drawn)
    if one.wish is None or row is None or not row.body:
        return body
    known = category_named(SLIM).size
    assert known is not None
    size = (known.depth[0], known.width[0], known.height[0])
    try:
        made = library.choose(SLIM, 1, replace(one.wish, size=size, shape=None, mount=None))[0]
    except InputError:
        return body
    return replace(made, category=body.category)


def lift_of(mount: str, asset: Asset, ceiling: float, between: tuple[float, float] | None) -> float:
    """How high [m] the bottom of a carrier is above the floor."""
    if mount == "wall":
        low, high = between or category_named(asset.category).bottom or (1.4, 1.6)
        return (low + high) / 2
    return ceiling - asset.size[2] if mount == "ceiling" else 0.0


def hang(
    obj: SceneObject, kind: Carrier, bodies: Sequence[Asset], lift: float, ahead: bool = False
) -> list[Place | None]:
    """Places for some bodies on one carrier, spread along it; None for those without room.

    Args:
        obj: the carrier, with the solids that nothing may be in.
        kind: how it carries.
        bodies: what hangs from it, in this order along it.
        lift: height [m] of its bottom above the floor.
        ahead: whether it hangs on a wall, so that nothing goes behind it.
    """
    found = _hang(obj, kind, bodies, lift, ahead, [(k + 0.5) / len(bodies) - 0.5 for k in range(len(bodies))])
    if None in found and len(bodies) > 1:  # close together, the outer ones at the very ends
        again = _hang(obj, kind, bodies, lift, ahead, [k / (len(bodies) - 1) - 0.5 for k in range(len(bodies))])
        found = again if again.count(None) < found.count(None) else found
    return found


def _hang(
    obj: SceneObject, kind: Carrier, bodies: Sequence[Asset], lift: float, ahead: bool, shares: Sequence[float]
) -> list[Place | None]:
    """Places near some shares of the length of a carrier."""
    import shapely

    solids = [(shapely.Polygon(part.polygon), part.z) for part in obj.solids]
    taken: list[tuple[Any, tuple[float, float]]] = []
    found: list[Place | None] = []
    for body, share in zip(bodies, shares, strict=True):
        best: tuple[float, Place, Any] | None = None
        for number, (way, xs, ys, top, yaw) in enumerate(_rows(obj, kind, solids, body)):
            z = top - body.size[2]
            if lift + z < CLEAR or (best is not None and best[0] < LAST * way):
                continue
            deep, wide = (body.size[0], body.size[1]) if abs(math.sin(yaw)) < 0.5 else (body.size[1], body.size[0])
            boxes = shapely.box(xs - deep / 2, ys - wide / 2, xs + deep / 2, ys + wide / 2)
            bad = np.zeros(len(xs), dtype=bool)
            if ahead:
                bad |= xs - deep / 2 < -obj.size[0] / 2 - 1e-6
            for shape, (low, high) in (*solids, *taken):
                if low < z + body.size[2] - 1e-6 and high > z + 1e-6:
                    bad |= shapely.area(shapely.intersection(boxes, shape)) > 1e-7
            along, off = (ys / obj.size[1], xs) if obj.size[1] >= obj.size[0] else (xs / obj.size[0], ys)
            cost = (
                2.0 * (obj.size[2] - top)
                + 4.0 * np.abs(along - share)
                + (2.0 if kind.along else 0.1) * np.abs(off)
                + 0.0005 * number
                + LAST * way
            )
            if taken:
                others = [shape for shape, _ in taken]
                near = np.min([shapely.distance(shapely.points(xs, ys), other) for other in others], axis=0)
                cost = cost + (APART - np.minimum(near, APART))
            cost = np.where(bad, np.inf, cost)
            at = int(np.argmin(cost))
            if cost[at] < np.inf and (best is None or cost[at] < best[0]):
                best = float(cost[at]), Place(float(xs[at]), float(ys[at]), z, yaw), boxes[at]
        found.append(best[1] if best is not None else None)
        if best is not None:
            taken.append((best[2], (best[1].z, best[1].z + body.size[2])))
    return found


def hooks_of(found: Sequence[tuple[Asset, Place]], first: int = 0) -> list[Surface]:
    """The surfaces of what hangs somewhere, as high as their bottoms are."""
    made = []
    for k, (body, place) in enumerate(found, first):
        deep, wide = body.size[:2]
        deep, wide = (deep, wide) if abs(math.sin(place.yaw)) < 0.5 else (wide, deep)
        ring = tuple((x + place.x, y + place.y) for x, y in rectangle(deep + 2 * TOUCH, wide + 2 * TOUCH))
        made.append(Surface(name=f"{HOOK}-{k}", polygon=ring, z=place.z, headroom=body.size[2] + 2 * TOUCH))
    return made


def _rows(
    obj: SceneObject, kind: Carrier, solids: Sequence[tuple[Any, tuple[float, float]]], body: Asset
) -> Iterator[tuple[float, np.ndarray, np.ndarray, float, float]]:
    """Rows of places for a body: the number of the way, x and y of its middle [n], height of its top, and turn."""
    import shapely

    thin, flat = min(body.size[:2]), (0.0 if body.size[0] <= body.size[1] else math.pi / 2)
    for number, way in enumerate(kind.at):
        for shape, (low, high) in sorted(solids, key=lambda one: -one[1][0 if way == "under" else 1]):
            x0, y0, x1, y1 = shape.bounds
            if way == "under":
                xs, ys = (np.append(np.arange(a, b, GRID), (a + b) / 2) for a, b in ((x0, x1), (y0, y1)))
                x, y = (grid.ravel() for grid in np.meshgrid(xs, ys))
                inner = shapely.contains_xy(shape.buffer(1e-3), x, y)
                for turn, yaw in enumerate(_turns(kind, obj, body)):
                    yield number + TURNED * turn, x[inner], y[inner], low - TOUCH, yaw + flat
                continue
            for side in kind.sides:
                ax, ay, yaw = SIDES[side]
                half = thin / 2 + TOUCH
                lows, highs = (y0, y1) if ax else (x0, x1)
                lateral = np.append(np.arange(lows, highs, GRID), (lows + highs) / 2)
                line = np.full(len(lateral), ((x1 if ax > 0 else x0) + ax * half) if ax else
                               ((y1 if ay > 0 else y0) + ay * half))  # fmt: skip
                x, y = (line, lateral) if ax else (lateral, line)
                for down in LOWER:
                    if high - down > max(low, high - 0.7):
                        yield number, x, y, high - down, yaw + flat


def _turns(kind: Carrier, obj: SceneObject, body: Asset) -> tuple[float, ...]:
    """How a body is turned that hangs under something: side by side on a rail that has the depth for it."""
    across = 2 * min(body.size[:2]) < max(body.size[:2]) <= obj.size[0] + 0.05
    if kind.along and across:
        return (math.pi / 2, 0.0)
    return (0.0,) if obj.mount == "wall" else (0.0, math.pi / 2)


__all__ = ["BARE", "Hanging", "Place", "bare", "hang", "hang_on", "hooks_of", "hung_body", "lift_of"]
