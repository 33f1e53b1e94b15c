"""Objects as USD prims: prototypes with mesh and colliders, and instances of them below rigid bodies."""

from __future__ import annotations

import zlib
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sceneweaver.physics.frames import frames_of
from sceneweaver.physics.solids import Solid
from sceneweaver.physics.things import RigidBody, Thing
from sceneweaver.runtime.deadline import checkpoint

from .bodies import Body, body_of
from .names import Names
from .slices import sliced
from .usd_bodies import Solids, filter_pair, join, rigid, weld
from .usd_layer import Prim, apply, label, place, prim, prim_names, usd
from .usd_looks import Looks
from .usd_mesh import collider, render_mesh
from .usd_views import add_frames, add_lamp

GEOMETRY = "Geometry"
"""Name of the instance below each body."""


@dataclass(frozen=True)
class _Prototype:
    path: Any
    colliders: tuple[str, ...]  # paths below it


class Prototypes:
    """The bodies that objects are instances of, in the sizes of their assets: one for each link of each asset."""

    def __init__(self, scope: Prim, looks: Looks):
        self._scope, self._looks = scope, looks
        self._names = prim_names()
        self._made: dict[tuple[str, float, int], _Prototype] = {}

    def instance(self, parent: Prim, thing: Thing, body: Body, part: RigidBody) -> tuple[Any, ...]:
        """Put one body of an object below a prim; returns the paths of its colliders there."""
        # Without hulls of its own, an asset collides as the parts of each object, which need not be scaled ones.
        own = thing.asset is not None and not thing.asset.hulls
        key = (thing.key if own else body.key, thing.friction, part.number)
        if key not in self._made:
            self._made[key] = self._make(thing, body, part)
        prototype = self._made[key]
        made = prim(parent, GEOMETRY, instanceable=True)
        made.referenceList.prependedItems.append(usd().Sdf.Reference("", prototype.path))
        if body.scale != (1.0, 1.0, 1.0):
            place(made, scale=body.scale)
        if part.number == 0:
            add_lamp(parent, body.mesh, body.scale)
        add_frames(parent, frames_of(thing, part))
        return tuple(made.path.AppendPath(name) for name in prototype.colliders)

    def _make(self, thing: Thing, body: Body, part: RigidBody) -> _Prototype:
        noun = thing.asset.category if thing.asset is not None else thing.object.category
        title = f"{noun}_{zlib.crc32(body.key.encode()):08x}"
        if len(thing.bodies) > 1:
            title += f"_{part.link.name if part.link is not None else 'base'}"
        made = prim(self._scope, self._names(title), abstract=True, displayName=thing.object.asset or noun)
        mesh = body.mesh if thing.asset is None else replace(body.mesh, face_link=thing.face_body)
        render_mesh(made, "Mesh", mesh, self._looks, part.number)
        scope, names = prim(made, "Collision", "Scope"), []
        solids = [piece for solid in part.solids for piece in sliced(_unscaled(solid, body.scale))]
        for number, solid in enumerate(solids):
            collider(scope, f"part_{number}", solid, self._looks, thing.friction)
            names.append(f"Collision/part_{number}")
        return _Prototype(made.path, tuple(names))


def add_object(parent: Prim, name: str, thing: Thing, prototypes: Prototypes, names: Names) -> Solids:
    """One object at its pose: a rigid body when it may move, else colliders that stand still.

    ``names`` gives those of its bodies and joints: `<object>_<link>`, `<object>_base`, and both with `_joint` behind.

    A piece with doors or drawers is an articulation: its base and each of them are bodies side by side, and the base
    of one that stands still is fixed to the world. So all doors of a piece can be driven in the same way.
    """
    checkpoint()
    item, body = thing.object, body_of(thing)
    made = prim(parent, name, kind="component", displayName=item.id)
    made.SetInfo("customData", {"sceneweaver": _facts(thing)})
    label(made, item.category, item.id)
    place(made, item.pose.position, item.pose.quaternion)
    if len(thing.bodies) > 1:
        return _articulated(made, thing, body, prototypes, names)
    colliders = prototypes.instance(made, thing, body, thing.bodies[0])
    if not thing.free:
        return Solids((), colliders)
    rigid(made, thing.bodies[0].inertia)
    return Solids((made.path,))


def _articulated(made: Prim, thing: Thing, body: Body, prototypes: Prototypes, names: Names) -> Solids:
    """The base, its doors and drawers, and what can be taken off it, as bodies side by side."""
    placed: list[Prim] = []
    for part in thing.bodies:
        title = "base" if part.link is None else part.link.name
        mine = prim(made, names(f"{made.name}_{title}"), displayName=title)
        place(mine)
        rigid(mine, part.inertia)
        facts = {"name": part.name} if part.link is None else {"name": part.name, "role": part.link.role}
        mine.SetInfo("customData", {"sceneweaver": facts})
        if part.loose and part.link is not None:
            label(mine, part.link.category or part.link.name, part.name)
        prototypes.instance(mine, thing, body, part)
        placed.append(mine)
    base, layer = placed[0], made.layer
    moving = [(p, m) for p, m in zip(thing.bodies, placed, strict=True) if p.joint is not None]
    if moving:
        apply(made, "PhysicsArticulationRootAPI")
    if moving or not thing.free:
        joints = prim(made, "joints", "Scope")
        if not thing.free:
            weld(joints, names(f"{base.name}_joint"), made, base)
        for part, mine in moving:
            assert part.link is not None and part.joint is not None
            join(joints, names(f"{mine.name}_joint"), base, mine, part.joint)
            filter_pair(Solids((base.path,)), Solids((mine.path,)), layer)
    return Solids(tuple(b.path for b in placed))


def _facts(thing: Thing) -> dict[str, Any]:
    """What is known of an object and has no place of its own in USD."""
    item = thing.object
    facts: dict[str, Any] = {"id": item.id, "category": item.category, "mount": item.mount}
    if item.asset is not None:
        facts["asset"] = item.asset
    if item.support is not None:
        facts["support"] = {"object": item.support.object, "surface": item.support.surface}
    return facts


def _unscaled(solid: Solid, scale: tuple[float, float, float]) -> Solid:
    """A part of a scaled object in the size of its asset."""
    if scale == (1.0, 1.0, 1.0):
        return solid
    by = np.asarray(scale)
    box = None if solid.box is None else (solid.box[0] / by, solid.box[1] / by)
    return Solid(solid.points / by, solid.volume / float(np.prod(by)), solid.link, box)
