"""Rigid bodies, joints and filtered pairs of a USD stage."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import Quaternion, from_matrix
from sceneweaver.physics.inertia import Inertia
from sceneweaver.physics.things import Joint

from .usd_engines import tune_body, tune_joint
from .usd_layer import Prim, apply, attribute, attributes, prim, relate, rotation, triple

_LIGHTEST = 1e-3  # [kg]: without a mass of its own, a simulator would make one up
_LEAST_INERTIA = 1e-7  # [kg m2] about each axis: single precision and a time step take no less
_STRONGEST = 10.0  # times what it takes to move a joint, that its drive gives at most


@dataclass(frozen=True)
class Solids:
    """What of an object takes part in contacts: the paths of its rigid bodies; of one that has none, its colliders."""

    bodies: tuple[Any, ...]
    colliders: tuple[Any, ...] = ()


def rigid(target: Prim, inertia: Inertia) -> None:
    """Make a prim a rigid body of this mass, centre and inertia, in the prim's frame."""
    apply(target, "PhysicsRigidBodyAPI", "PhysicsMassAPI")
    moments, axes = _principal(inertia.tensor)
    attributes(
        target,
        {
            "physics:mass": ("Float", max(inertia.mass, _LIGHTEST)),
            "physics:centerOfMass": ("Point3f", triple(inertia.centre)),
            "physics:diagonalInertia": ("Float3", triple(moments)),
            "physics:principalAxes": ("Quatf", rotation("Quatf", axes)),
        },
    )
    tune_body(target)


def weld(parent: Prim, name: str, frame: Prim, body: Prim) -> None:
    """Fix a body to the place of ``frame``, a prim that is no body and whose frame it shares: so to the world.

    As the joint names the frame, it goes along when someone moves the whole stage.
    """
    made = prim(parent, name, "PhysicsFixedJoint")
    _between(made, frame, body)
    _frames(made, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def join(parent: Prim, name: str, base: Prim, body: Prim, joint: Joint) -> None:
    """A joint between two bodies, closed at 0, with friction, and a damper that keeps it from swinging freely.

    Its axis is the coordinate axis that is nearest, turned the rest of the way.
    """
    turns = joint.kind == "hinge"
    made = prim(parent, name, "PhysicsRevoluteJoint" if turns else "PhysicsPrismaticJoint")
    _between(made, base, body)
    axis = np.asarray(joint.axis, dtype=float) / np.linalg.norm(joint.axis)
    number = int(np.argmax(np.abs(axis)))
    attribute(made, "physics:axis", "Token", "XYZ"[number], uniform=True)
    _frames(made, joint.anchor, _turn(number, axis))
    # USD counts angles in degrees, those of dampers too.
    unit = 180 / math.pi if turns else 1.0
    low, high = (float(v) * unit for v in joint.limits)
    attributes(made, {"physics:lowerLimit": ("Float", low), "physics:upperLimit": ("Float", high)})
    drive = "angular" if turns else "linear"
    apply(made, f"PhysicsDriveAPI:{drive}")
    attribute(made, f"drive:{drive}:physics:type", "Token", "force", uniform=True)
    values = {"stiffness": 0.0, "damping": joint.hold / unit, "targetPosition": 0.0, "targetVelocity": 0.0}
    for key, value in (values | {"maxForce": _STRONGEST * joint.hold}).items():
        attribute(made, f"drive:{drive}:physics:{key}", "Float", float(value))
    tune_joint(made, drive, float(joint.hold))


def filter_pair(one: Solids, two: Solids, layer: Any) -> None:
    """Leave out contacts between two objects; nothing to do where neither can move."""
    owner, other = (one, two) if one.bodies else (two, one)
    for path in owner.bodies:
        body = layer.GetPrimAtPath(path)
        apply(body, "PhysicsFilteredPairsAPI")
        relate(body, "physics:filteredPairs", *(other.bodies or other.colliders))


def _between(made: Prim, one: Prim, two: Prim) -> None:
    relate(made, "physics:body0", one.path)
    relate(made, "physics:body1", two.path)


def _frames(made: Prim, position: Sequence[float] | np.ndarray, quaternion: Sequence[float]) -> None:
    """The joint's frame, which is the same in both bodies; the quaternion is (x, y, z, w)."""
    turn = rotation("Quatf", quaternion)
    for side in "01":
        attribute(made, f"physics:localPos{side}", "Point3f", triple(position))
        attribute(made, f"physics:localRot{side}", "Quatf", turn)


def _principal(tensor: np.ndarray) -> tuple[np.ndarray, Quaternion]:
    """The moments [3] of an inertia tensor [3, 3], and the rotation (x, y, z, w) of the axes that have them.

    Each is at least ``_LEAST_INERTIA`` and, in single precision as well, at most the sum of the others, as of sheets.
    """
    off = tensor - np.diag(np.diag(tensor))
    moments, axes = np.diag(tensor).copy(), np.eye(3)
    if np.abs(off).max() > 1e-9 * np.trace(tensor):
        moments, axes = np.linalg.eigh(tensor)
        axes[:, 2] *= np.sign(np.linalg.det(axes))
    moments = np.maximum(moments, _LEAST_INERTIA)
    largest = int(moments.argmax())
    moments[largest] = min(moments[largest], (1 - 1e-5) * (moments.sum() - moments[largest]))
    return moments, from_matrix(axes)


def _turn(number: int, axis: np.ndarray) -> tuple[float, float, float, float]:
    """The shortest rotation (x, y, z, w) of coordinate axis ``number`` to a unit vector [3]."""
    x, y, z = np.cross(np.eye(3)[number], axis)
    full = np.array([x, y, z, 1 + axis[number]])
    if np.linalg.norm(full) < 1e-9:  # the other way round: half a turn about another axis
        full = np.array([*np.eye(3)[(number + 1) % 3], 0.0])
    x, y, z, w = full / np.linalg.norm(full)
    return float(x), float(y), float(z), float(w)
