"""The MuJoCo model that all worlds of a batch share: a floor, slots and a robot.

In the model the slots stand in their order: boxes that stand still, hinges, slides, free bodies; the robot comes after
them.

What touches what is a matter of slots and the same in all worlds: free bodies and the robot touch everything, links do
not touch each other nor what stands still. Their ranges end where something is in the way.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.envs.robots import Robot
from sceneweaver.physics.model import ARMATURE, STEP, STOP, add_options
from sceneweaver.physics.xml import child
from sceneweaver.scene import InputError

from .bank import PARKED, Slots

ROBOT = "robot:"
"""Names of the robot begin so."""

FIRST = {"geom": 1, "body": 1}
"""Where slots begin in arrays of the model: 0 is the floor, and the world. All else begins at 0."""

STILL, LINK, LOOSE = 1, 4, 8
"""Bits of contact: what stands still, links, free bodies; the robot has 2."""

_ASKEW = {"pos": "0.1 0.2 0.3", "quat": "0.9 0.1 0.2 0.3"}
"""Place of boxes in the template, so that the matrix of inertia of no body counts as diagonal."""


@dataclass(frozen=True)
class RobotIndices:
    """Where the robot is in the model.

    Attributes:
        base: Positions in ``qpos`` of its base's x, y and yaw; empty for a robot that stands on its place.
        body: Its root body.
        tool: Its site between the fingertips.
        drive: Actuators in the order of its actions: base, arm; their positions in ``qpos`` are ``drive_position``.
        fingers: Actuators of the gripper; their positions in ``qpos`` are ``finger_position``.
        home: [nq - n] positions of the robot at the start.
    """

    base: tuple[int, ...]
    body: int
    tool: int
    drive: tuple[int, ...]
    drive_position: tuple[int, ...]
    fingers: tuple[int, ...]
    finger_position: tuple[int, ...]
    home: np.ndarray


def template_of(slots: Slots, robot: Robot, timestep: float = STEP) -> Any:
    """The MjModel of some slots and a robot.

    Raises:
        InputError: the robot's MJCF cannot be read.
    """
    mujoco: Any = import_module("mujoco")  # its types are not to be seen from outside
    spec = mujoco.MjSpec.from_string(_xml(slots, timestep))
    try:
        if robot.folder is None:
            hand = mujoco.MjSpec.from_string(robot.xml)
        else:
            hand = mujoco.MjSpec.from_string(robot.xml, include=None)
            hand.modelfiledir = str(robot.folder)
    except (ValueError, TypeError) as error:
        raise InputError(f"robot: {robot.name}: {str(error).splitlines()[0]}") from None
    for geom in hand.geoms:
        if geom.contype or geom.conaffinity:
            geom.conaffinity |= STILL | LINK | LOOSE
    root = hand.worldbody.first_body().name
    spec.attach(hand, frame=spec.worldbody.add_frame(), prefix=ROBOT)
    model = spec.compile()
    # MuJoCo leaves out what it need not compute for boxes and inertias in the frame of their body; these may differ.
    model.geom_sameframe[:], model.body_sameframe[:] = 0, 0
    assert int(model.geom(f"still:{slots.still - 1}").id) == slots.still if slots.still else True
    assert int(model.body(ROBOT + root).id) == 1 + len(slots.parts)
    return model


def indices_of(model: Any, slots: Slots, robot: Robot) -> RobotIndices:
    """Where the robot is in the model of ``template_of``."""

    def position(joint: str) -> int:
        return int(model.joint(ROBOT + joint).qposadr[0])

    home = np.array(model.qpos0[slots.links + 7 * len(slots.free) :])
    for joint, value in robot.home.items():
        home[position(joint) - slots.links - 7 * len(slots.free)] = value
    drive = [*robot.base, *robot.arm]
    by_joint = {int(model.actuator_trnid[a, 0]): a for a in range(model.nu)}
    fingers = tuple(int(model.actuator(ROBOT + name).id) for name in robot.gripper)
    return RobotIndices(
        tuple(position(j) for j in robot.base),
        1 + len(slots.parts),
        int(model.site(ROBOT + robot.tool).id),
        tuple(by_joint[int(model.joint(ROBOT + j).id)] for j in drive),
        tuple(position(j) for j in drive),
        fingers,
        tuple(int(model.jnt_qposadr[model.actuator_trnid[a, 0]]) for a in fingers),
        home,
    )


def _xml(slots: Slots, timestep: float) -> str:
    root = Xml.Element("mujoco", model="batch")
    child(root, "compiler", angle="radian", boundinertia="1e-7")
    add_options(root, timestep)
    world = child(root, "worldbody")
    child(world, "geom", name="floor", type="plane", size="0 0 1", contype=STILL, conaffinity="0", friction="0.8")
    for k in range(slots.still):
        place = (k % 16, k // 16, PARKED)
        child(world, "geom", name=f"still:{k}", type="box", size="1 1 1", pos=place, contype=STILL, conaffinity="0")
    for kind, parts in (("hinge", slots.hinges), ("slide", slots.slides), ("free", slots.free)):
        for k, count in enumerate(parts):
            body = child(world, "body", name=f"{kind}:{k}", pos=(k, 0, PARKED), gravcomp="1")
            if kind == "free":
                child(body, "freejoint", name=f"{kind}:{k}")
                bits = {"contype": LOOSE, "conaffinity": STILL | LINK | LOOSE}
            else:
                held = {"damping": "1", "frictionloss": "1", "armature": ARMATURE, "solreflimit": STOP}
                child(body, "joint", {"name": f"{kind}:{k}", "type": kind, "axis": "0 0 1", "range": "-1 1", **held})
                bits = {"contype": LINK, "conaffinity": 0}
            for _ in range(count):
                child(body, "geom", {"type": "box", "size": "1 2 3", "mass": "1", **_ASKEW, **bits})
    return Xml.tostring(root, encoding="unicode")
