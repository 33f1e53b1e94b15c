"""Nodes of a GLB file: objects with what moves of them below, and the leaves of doors."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from sceneweaver.assets import Link, Mesh
from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.physics.leaves import Leaf
from sceneweaver.physics.things import Joint, moving_links

from .bodies import Body
from .glb_file import GlbFile
from .room import leaf_mesh

_SAME = (1.0, 1.0, 1.0)


def free_name(name: str, taken: set[str]) -> str:
    """The name, or a longer one where it is taken, which it is from now on: objects keep theirs."""
    while name in taken:
        name += " (room)"
    taken.add(name)
    return name


def add_object(file: GlbFile, body: Body, taken: set[str]) -> int:
    """An object's node: its mesh, its pose and what else is known of it; below it what moves of it.

    Args:
        file: Where it goes.
        body: The object; its id is its node's name.
        taken: Names that no other node may have.
    """
    thing = body.object
    extras: dict[str, Any] = {"category": thing.category, "mount": thing.mount, "size": list(thing.size)}
    if thing.asset is not None:
        extras["asset"] = thing.asset
    if thing.support is not None:
        extras["support"] = {"object": thing.support.object, "surface": thing.support.surface}
    if body.note:
        extras["note"] = body.note
    node: dict[str, Any] = {"translation": list(thing.pose.position), "rotation": list(thing.pose.quaternion)}
    moving = moving_links(body.asset) if body.asset is not None else frozenset()
    if not moving:
        if body.scale != _SAME:
            node["scale"] = list(body.scale)
        mesh = file.mesh(body.key, lambda: body.mesh, asset=body.asset)
        return file.node(thing.id, {"mesh": mesh, **node, "extras": extras})
    assert body.asset is not None
    # The scale goes into the meshes: a door that turns below a node of uneven scale would be sheared.
    key = body.key if body.scale == _SAME else f"{body.key}*{body.scale}"
    link_of = np.where(np.isin(body.mesh.face_link, list(moving)), body.mesh.face_link, 0)
    children = []
    for number in sorted(moving):
        link = body.asset.links[number - 1]
        anchor = np.asarray(link.anchor if link.joint == "hinge" else (0.0, 0.0, 0.0)) * body.scale
        below = {"translation": anchor.tolist(), "extras": {"joint": _joint(link, body.scale)}}
        if (link_of == number).any():
            part = partial(_part, body, link_of == number, anchor)
            place = (number, body.scale)
            below["mesh"] = file.mesh(f"{key}.{number}", part, f"{key}.{link.name}", body.asset, place)
        children.append(file.node(free_name(f"{thing.id}.{link.name}", taken), below))
    if (link_of == 0).any():
        base = partial(_part, body, link_of == 0, np.zeros(3))
        node["mesh"] = file.mesh(f"{key}.0", base, key, body.asset, (0, body.scale))
    return file.node(thing.id, {**node, "children": children, "extras": extras})


def add_leaf(file: GlbFile, leaf: Leaf, taken: set[str]) -> int:
    """The node of a door's leaf, closed."""
    joint = {"type": leaf.joint, "axis": list(leaf.axis), "limits": list(leaf.limits), "role": "door"}
    node: dict[str, Any] = {
        "mesh": file.mesh(f"\0{leaf.name}", lambda: leaf_mesh(leaf), leaf.name),
        "translation": list(leaf.position),
        "rotation": list(from_yaw(leaf.yaw)),
        "extras": {"joint": joint},
    }
    return file.node(free_name(leaf.name, taken), node)


def _joint(link: Link, scale: tuple[float, float, float]) -> dict[str, Any]:
    """How a node moves in its parent, with which it shares its axes: it turns about ``axis`` or goes along it by
    ``limits`` [rad] or [m], 0 is as it is; a free one can be taken."""
    joint = Joint.of(link, scale, 0.0)  # what it weighs matters to its friction alone
    if joint is None:
        return {"type": "free", "role": link.role, "category": link.category}
    return {"type": joint.kind, "axis": joint.axis.tolist(), "limits": list(joint.limits), "role": link.role}


def _part(body: Body, chosen: np.ndarray, origin: np.ndarray) -> Mesh:
    """Some faces of an object's mesh in its size, with their origin at a point of the object's frame."""
    mesh = body.mesh
    used, packed = np.unique(mesh.faces[chosen], return_inverse=True)
    return replace(
        mesh,
        vertices=mesh.vertices[used] * body.scale - origin,
        faces=packed.reshape(-1, 3).astype(np.int32),
        face_material=mesh.face_material[chosen],
        face_link=mesh.face_link[chosen],
        uv=None if mesh.uv is None else mesh.uv[chosen],
    )
