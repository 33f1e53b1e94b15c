"""What every object of a scene looks like: a mesh in its own frame, shared by all that have the same one."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from sceneweaver.assets import Asset, Mesh
from sceneweaver.assets.placed import Load, loader, parts_mesh, plain_material, scaled_asset
from sceneweaver.physics.things import Joint, Thing, moving_links
from sceneweaver.scene import InputError, Scene, SceneObject

Missing = Literal["error", "parts"]
"""What happens to an object whose asset cannot be loaded: an error, or it is shown as its parts."""


@dataclass(frozen=True)
class Body:
    """The look of one object.

    ``mesh`` is in the frame of the asset; bodies with an equal ``key`` have the same. ``scale`` [3] brings it to the
    object's size, (1, 1, 1) unless someone gave the object another size than its asset has. ``note`` says what had
    to be done without, empty when nothing.
    """

    object: SceneObject
    key: str
    mesh: Mesh
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    note: str = ""
    asset: Asset | None = None


def bodies_of(scene: Scene, load: Load | None = None, missing: Missing = "error") -> list[Body]:
    """The bodies of all objects, in their order; each asset is loaded once.

    Raises:
        InputError: when an asset cannot be loaded, unless ``missing`` is "parts".
    """
    load, found = loader(load), []
    for index, thing in enumerate(scene.objects):
        try:
            found.append(_body(thing, *scaled_asset(index, thing, load)))
        except InputError:
            if missing == "error":
                raise
            found.append(_plain(thing, f"{thing.id}: its mesh is missing, its collision parts are shown"))
    return found


def body_of(thing: Thing) -> Body:
    """The look of what a simulator has."""
    return _body(thing.object, thing.asset, thing.scale)


@dataclass(frozen=True)
class MovingPart:
    """A door, drawer or lid of a body, closed.

    ``mesh`` is in the frame of the asset as that of the body, ``axis`` (a unit vector) and ``anchor`` [m] are in the
    object's frame and size; ``limits`` are those of `sceneweaver.physics.things.Joint` [rad] or [m].
    """

    name: str
    number: int
    mesh: Mesh
    kind: Literal["hinge", "slide"]
    axis: tuple[float, float, float]
    anchor: tuple[float, float, float]
    limits: tuple[float, float]


def moving_parts(body: Body) -> tuple[Mesh | None, list[MovingPart]]:
    """The mesh of a body without its doors, drawers and lids (None: nothing is left), and these; controls, as knobs,
    and what can be taken stay with the rest."""
    if body.asset is None:
        return body.mesh, []
    parts, left = [], np.ones(len(body.mesh.faces), dtype=bool)
    for number in sorted(moving_links(body.asset)):
        link, chosen = body.asset.links[number - 1], body.mesh.face_link == number
        joint = Joint.of(link, body.scale, 0.0)  # what it weighs matters to its friction alone
        if joint is None or link.role == "control" or not chosen.any():
            continue
        left &= ~chosen
        mesh = some_faces(body.mesh, chosen)
        ax, ay, az = joint.axis.tolist()
        x, y, z = joint.anchor.tolist()
        parts.append(MovingPart(link.name, number, mesh, joint.kind, (ax, ay, az), (x, y, z), joint.limits))
    if not parts:
        return body.mesh, []
    return some_faces(body.mesh, left) if left.any() else None, parts


def some_faces(mesh: Mesh, chosen: np.ndarray) -> Mesh:
    """Some faces of a mesh."""
    used, packed = np.unique(mesh.faces[chosen], return_inverse=True)
    return replace(
        mesh,
        vertices=mesh.vertices[used],
        faces=packed.reshape(-1, 3).astype(np.int32),
        face_material=mesh.face_material[chosen],
        face_link=mesh.face_link[chosen],
        uv=None if mesh.uv is None else mesh.uv[chosen],
    )


def _body(thing: SceneObject, asset: Asset | None, scale: tuple[float, float, float]) -> Body:
    if asset is None or thing.asset is None:
        return _plain(thing)
    return Body(thing, thing.asset, asset.mesh, scale, asset=asset)


def _plain(thing: SceneObject, note: str = "") -> Body:
    """The parts of an object as they are."""
    material = plain_material(thing)
    shape = ";".join(f"{p.polygon}{p.z}" for p in thing.solids)
    return Body(thing, f"parts:{material.name}:{shape}", parts_mesh(thing.solids, material), note=note)


def with_mesh(load: Load | None) -> Load:
    """The loader, which refuses assets without a single triangle; None: that of this user's library."""
    given = loader(load)

    def checked(object_id: str) -> Asset:
        asset = given(object_id)
        if not len(asset.mesh.faces):
            raise InputError(f"asset: '{object_id}' has no mesh; import it again or choose another asset")
        return asset

    return checked
