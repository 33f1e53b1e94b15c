"""Stability of a scene, and its settled poses, by MuJoCo on the CPU."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import transform, xyzw
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import InputError, Pose, Scene

from .model import build
from .worlds import Template, stepped, steps_of

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
    template = Template.of(build(scene, load), scene)
    shift = _shifts(scene, _run(template, seconds))
    return measures(shift) | {"free": len(template.free), "fixed": len(template.fixed)}


def settle(scene: Scene, load: Load | None = None, seconds: float = 3.0) -> Settled:
    """Let things come to rest; what moved at most ``LITTLE`` gets its new pose, what moved farther is a fault."""
    template = Template.of(build(scene, load), scene)
    poses = _run(template, seconds)
    return settled(scene, poses, _shifts(scene, poses))


def settled(scene: Scene, poses: Mapping[str, Pose], shift: dict[str, float]) -> Settled:
    """A scene after some time of physics, from poses and shifts [m] by id."""
    little = {name: poses[name] for name, far in shift.items() if far <= LITTLE}
    return Settled(scene.replace_poses(little), shift, tuple(name for name, far in shift.items() if far > LITTLE))


def pose_of(row: np.ndarray) -> Pose:
    """A row [7]: x, y, z and the quaternion x, y, z, w."""
    return Pose(position=row[:3].tolist(), quaternion=row[3:].tolist())


def measures(shift: dict[str, float]) -> dict[str, Any]:
    """The numbers of ``stability`` from shifts [m] by id."""
    far = np.array(list(shift.values())) if shift else np.zeros(1)
    return {
        "moved_over_0_1m": float((far > 0.1).mean()),
        "moved_over_0_01m": float((far > 0.01).mean()),
        "mean_shift_m": float(far.mean()),
        "moved": dict(shift),
    }


def _run(template: Template, seconds: float) -> dict[str, Pose]:
    """The poses of the free bodies after that time.

    Raises:
        InputError: there was no room for all contacts, or the simulation diverged: no pose would mean anything.
    """
    mujoco = load_mujoco()
    data = mujoco.MjData(template.model)
    went = stepped(template.model, data, steps_of(seconds))
    if went.full:
        raise InputError(_FULL)
    if went.astray is not None:
        near = _near(template.model, went.astray)
        raise InputError(f"objects: the simulation diverged{near}; take objects apart that overlap deeply")
    joints = {name: data.joint(name).qpos for name in template.free}
    return {name: pose_of(np.concatenate([at[:3], xyzw(at[3:])])) for name, at in joints.items()}


def _near(model: Any, dof: int) -> str:
    """Words for the object that a degree of freedom belongs to."""
    return f" at '{model.body(int(model.body_rootid[model.dof_bodyid[dof]])).name}'" if 0 <= dof < model.nv else ""


def _shifts(scene: Scene, poses: Mapping[str, Pose]) -> dict[str, float]:
    """How far the middle of each free object's box went [m]."""
    found = {}
    for name, pose in poses.items():
        thing = scene.object(name)
        both = np.array([(*each.position, *each.quaternion) for each in (pose, thing.pose)])
        end, start = transform(both, np.array([0.0, 0.0, thing.size[2] / 2]))
        found[name] = float(np.linalg.norm(end - start))
    return found
