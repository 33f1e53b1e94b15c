"""What PhysX, Newton and MuJoCo read beside UsdPhysics, so that a room behaves in each of them as in the others.

Schemas and attributes have the names of physx-usd-schemas 25.11 (Isaac Sim), newton-usd-schemas 0.6 and MuJoCo's
mjcPhysics. usd-core knows none of them, so they are written by name; readers that do not know them pass them over.
"""

from __future__ import annotations

from sceneweaver.physics.model import ARMATURE, SOLVER, STEP

from .usd_layer import Prim, apply, attribute, attributes

CONTACT_OFFSET = 0.005
"""Contacts are looked for at this distance [m]; PhysX's own choice grows with the size of a part."""

_DEPENETRATION = 1.0  # [m/s] at most, when things reach into each other: they part, and are not shot away
_POSITION_ITERATIONS, _VELOCITY_ITERATIONS = 16, 1
_SHARE = 0.05  # friction of joints as a share of the force in them
_SLEEP, _STABILIZE = 5e-5, 1e-5  # [m2/s2] kinetic energy by mass, below which bodies sleep and are damped


def tune_scene(scene: Prim) -> None:
    """Settings of the solvers: those of the model for MuJoCo, and PhysX's own solver with sleeping."""
    apply(scene, "PhysxSceneAPI", "NewtonSceneAPI", "MjcSceneAPI")
    attribute(scene, "physxScene:solverType", "Token", "TGS", uniform=True)
    attribute(scene, "physxScene:timeStepsPerSecond", "UInt", 120)
    attribute(scene, "newton:timeStepsPerSecond", "Int", round(1 / STEP), uniform=True)
    for key, kind, value in (
        ("option:timestep", "Double", STEP),
        ("option:integrator", "Token", SOLVER["integrator"]),
        ("option:cone", "Token", SOLVER["cone"]),
        ("option:impratio", "Double", SOLVER["impratio"]),
        ("flag:multiccd", "Bool", True),
    ):
        attribute(scene, f"mjc:{key}", kind, value, uniform=True)


def tune_body(body: Prim) -> None:
    """How PhysX solves, separates and rests a rigid body."""
    apply(body, "PhysxRigidBodyAPI")
    attributes(
        body,
        {
            "physxRigidBody:solverPositionIterationCount": ("Int", _POSITION_ITERATIONS),
            "physxRigidBody:solverVelocityIterationCount": ("Int", _VELOCITY_ITERATIONS),
            "physxRigidBody:maxDepenetrationVelocity": ("Float", _DEPENETRATION),
            "physxRigidBody:sleepThreshold": ("Float", _SLEEP),
            "physxRigidBody:stabilizationThreshold": ("Float", _STABILIZE),
        },
    )


def tune_collider(collider: Prim) -> None:
    """Distances at which contacts begin and rest.

    Things rest where their parts touch: rest offsets of 0 keep every pose as it is in the scene. Limits of hulls are
    not written, as none has as many vertices as PhysX and Newton take.
    """
    apply(collider, "PhysxCollisionAPI", "NewtonCollisionAPI")
    attribute(collider, "physxCollision:contactOffset", "Float", CONTACT_OFFSET)
    attribute(collider, "physxCollision:restOffset", "Float", 0.0)
    # Newton would take PhysX's offset as a margin of MuJoCo's contacts, which only costs time there.
    attribute(collider, "newton:contactGap", "Float", 0.0)


def tune_friction(material: Prim) -> None:
    """Of two materials the rougher one counts, as in MuJoCo; PhysX alone would take the mean."""
    apply(material, "PhysxMaterialAPI")
    attribute(material, "physxMaterial:frictionCombineMode", "Token", "max", uniform=True)


def tune_joint(joint: Prim, axis: str, friction: float) -> None:
    """Friction and inertia of a joint, which UsdPhysics has not.

    Args:
        joint: The joint.
        axis: "angular" or "linear".
        friction: [N m] or [N] that it takes to move it.
    """
    apply(joint, "PhysxJointAPI", f"PhysxJointAxisAPI:{axis}", "NewtonJointAPI", "MjcJointAPI")
    for key in ("staticFrictionEffort", "dynamicFrictionEffort"):
        attribute(joint, f"physxJointAxis:{axis}:{key}", "Float", friction)
    attribute(joint, f"physxJointAxis:{axis}:armature", "Float", ARMATURE)
    # What Isaac Sim read before 5.1, where friction is a share of the force in the joint.
    attribute(joint, "physxJoint:jointFriction", "Float", _SHARE)
    attribute(joint, "physxJoint:armature", "Float", ARMATURE)
    attribute(joint, "newton:friction", "Float", friction)
    attribute(joint, "newton:armature", "Float", ARMATURE)
    attribute(joint, "mjc:frictionloss", "Double", friction, uniform=True)
    attribute(joint, "mjc:armature", "Double", ARMATURE, uniform=True)
