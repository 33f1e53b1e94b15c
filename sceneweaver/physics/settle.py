"""Stability of a scene, and its settled poses, by MuJoCo on the CPU."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import transform, xyzw
from sceneweaver.scene import InputError, Pose, Scene

from .model import Model, build
from .worlds import stepped, steps_of

LITTLE = 0.01
"""A settled pose is taken over when the object moved at most this far [m]; farther is a fault."""

_FULL = "objects: more contacts than MuJoCo has room for; take objects apart that overlap, or use fewer"


@dataclass(frozen=True)
class Settled:
    """The scene at rest; ``moved`` is how far [m] each free object went, ``faults`` the ids that went too far."""

    scene: Scene
    moved: dict[str, float]
    faults: tuple[str, ...]


def stability(scene: Scene, load: Load | None = None, seconds: float = 3.0) -> dict[str, Any]:
    """How far free objects move in ``seconds`` when physics is let loose.

    Returns:
        ``moved_over_0_1m`` and ``moved_over_0_01m``: shares in 0..1 of the objects that may move; ``mean_shift_m``:
        their mean shift [m]; ``moved``: the shift [m] by id; ``free``: how many may move; ``fixed``: how many not.
        The shift is that of the middle of the object's box, so that what tips over has moved.
    """
    model = build(scene, load)
    shift = _shifts(scene, model, _run(model, seconds))
    return measures(shift) | {"free": len(model.free), "fixed": len(model.fixed)}


def settle(scene: Scene, load: Load | None = None, seconds: float = 3.0) -> Settled:
    """Let things come to rest; what moved at most ``LITTLE`` gets its new pose, what moved farther is a fault."""
    model = build(scene, load)
    poses = _run(model, seconds)
    shift = _shifts(scene, model, poses)
    little = {object_id: poses[object_id] for object_id, far in shift.items() if far <= LITTLE}
    return Settled(
        scene.replace_poses(little), shift, tuple(object_id for object_id, far in shift.items() if far > LITTLE)
    )


def measures(shift: dict[str, float]) -> dict[str, Any]:
    """The numbers of ``stability`` from shifts [m] by id."""
    far = np.array(list(shift.values())) if shift else np.zeros(1)
    return {
        "moved_over_0_1m": float((far > 0.1).mean()),
        "moved_over_0_01m": float((far > 0.01).mean()),
        "mean_shift_m": float(far.mean()),
        "moved": dict(shift),
    }


def _run(model: Model, seconds: float) -> dict[str, Pose]:
    """The poses of the free bodies after that time.

    Raises:
        InputError: there was no room for all contacts, or the simulation diverged: no pose would mean anything.
    """
    mujoco: Any = import_module("mujoco")  # its types are not to be seen from outside
    steps = steps_of(seconds)
    loaded = mujoco.MjModel.from_xml_string(model.xml, model.files)
    data = mujoco.MjData(loaded)
    went = stepped(loaded, data, steps)
    if went.full:
        raise InputError(_FULL)
    if went.astray is not None:
        near = _near(loaded, went.astray)
        raise InputError(f"objects: the simulation diverged{near}; take objects apart that overlap deeply")
    poses = {}
    for object_id in model.free:
        where = data.joint(object_id).qpos
        poses[object_id] = Pose(position=where[:3].tolist(), quaternion=xyzw(where[3:]).tolist())
    return poses


def _near(model: Any, dof: int) -> str:
    """Words for the object that a degree of freedom belongs to."""
    return f" at '{model.body(int(model.body_rootid[model.dof_bodyid[dof]])).name}'" if 0 <= dof < model.nv else ""


def _shifts(scene: Scene, model: Model, poses: dict[str, Pose]) -> dict[str, float]:
    found = {}
    for object_id in model.free:
        thing = scene.object(object_id)
        both = np.array([(*pose.position, *pose.quaternion) for pose in (poses[object_id], thing.pose)])
        end, start = transform(both, np.array([0.0, 0.0, thing.size[2] / 2]))
        found[object_id] = float(np.linalg.norm(end - start))
    return found
