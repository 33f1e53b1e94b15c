"""What every client has to find in a room: poses of bodies, joints and limits, by sceneweaver's own arithmetic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.export.home.built import BuiltHome
from sceneweaver.geometry.rotations import from_yaw, matrix, wxyz
from sceneweaver.home import Home
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.physics.things import Thing, things_of
from sceneweaver.scene import Scene


def expected(scene: Scene, load: Load | None = None, *, loose: bool = True) -> dict[str, Mapping[str, Any]]:
    """``bodies`` and ``joints`` by name; ``loose`` as for `things_of`.

    A body has its pose (position, quaternion w x y z) as "object", in the frame that all bodies of an object share, as
    "link", with the frame at its joint's anchor, and as "node", with the frame at a hinge's anchor; whether it is
    ``free``, whether it or something on it ``moves``, and the ``middle`` of its box in the first.
    A joint has its kind, limits [rad] or [m], and its axis and anchor in the world.
    """
    return expected_of(things_of(scene, load, loose=loose), leaves(scene.room))


def expected_of_home(home: Home, load: Load | None = None) -> dict[str, Mapping[str, Any]]:
    """The same for a home."""
    built = BuiltHome.of(home, load)
    return expected_of(built.things, [leaf for found in built.leaves for leaf in found])


def expected_of(things: Sequence[Thing], doors: Sequence[Leaf]) -> dict[str, Mapping[str, Any]]:
    """What `expected` has, of things and the leaves of doors."""
    bodies: dict[str, Any] = {}
    joints: dict[str, Any] = {}
    for thing in things:
        pose = thing.object.pose
        turn, at, facing = matrix(pose.quaternion), np.asarray(pose.position), wxyz(pose.quaternion)
        for body in thing.bodies:
            points = np.concatenate([solid.points for solid in body.solids])
            here = (list(pose.position), list(facing))
            row = bodies[body.name] = {
                "object": here,
                "link": here,
                "node": here,
                "free": thing.free if body.link is None else body.loose,
                "moves": thing.free or len(thing.bodies) > 1,
                "middle": ((points.min(axis=0) + points.max(axis=0)) / 2).tolist(),
            }
            joint = body.joint
            if joint is not None:
                anchor = at + turn @ joint.anchor
                row["link"] = (anchor.tolist(), list(facing))
                row["node"] = row["link"] if joint.kind == "hinge" else here
                joints[body.name] = _joint(joint.kind, turn @ joint.axis, anchor, joint.limits)
    for leaf in doors:
        facing = list(wxyz(from_yaw(leaf.yaw)))
        bodies[leaf.name] = {
            "object": (list(leaf.position), facing),
            "node": (list(leaf.position), facing),
            "link": (list(leaf.position), [1.0, 0.0, 0.0, 0.0]),
            "free": False,
            "moves": True,
            "middle": [0.0, 0.0, 0.0],
        }
        axis = matrix(from_yaw(leaf.yaw)) @ np.asarray(leaf.axis)
        joints[leaf.name] = _joint(leaf.joint, axis, np.asarray(leaf.position), leaf.limits)
    return {"bodies": bodies, "joints": joints}


def _joint(kind: str, axis: np.ndarray, anchor: np.ndarray, limits: tuple[float, float]) -> dict[str, Any]:
    return {"kind": kind, "axis": axis.tolist(), "anchor": anchor.tolist(), "limits": list(limits)}
