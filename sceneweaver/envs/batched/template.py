"""The MuJoCo model that all worlds of a batch share: a floor, slots and a robot.

In the model the slots stand in their order: boxes that stand still, hinges, slides, free bodies; the robot comes after
them.

What touches what is a matter of slots and the same in all worlds: free bodies and the robot touch everything, links do
not touch each other nor what stands still. Their ranges end where something is in the way.
"""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree as Xml

from sceneweaver.envs.joining import PREFIX, attach
from sceneweaver.envs.robots import Robot
from sceneweaver.physics.model import ARMATURE, STEP, STOP, add_options
from sceneweaver.physics.xml import child
from sceneweaver.runtime.mujoco_module import load_mujoco

from .bank import PARKED, Slots

FIRST = {"geom": 1, "body": 1}
"""Where slots begin in arrays of the model: 0 is the floor, and the world. All else begins at 0."""

STILL, LINK, LOOSE = 1, 4, 8
"""Bits of contact: what stands still, links, free bodies; the robot has 2."""

_ASKEW = {"pos": "0.1 0.2 0.3", "quat": "0.9 0.1 0.2 0.3"}
"""Place of boxes in the template, so that the matrix of inertia of no body counts as diagonal."""


def template_of(slots: Slots, robot: Robot, timestep: float = STEP) -> Any:
    """The MjModel of some slots and a robot.

    Raises:
        InputError: the robot's MJCF cannot be read.
    """
    mujoco = load_mujoco()
    spec = mujoco.MjSpec.from_string(_xml(slots, timestep))
    attach(spec, robot, touching=STILL | LINK | LOOSE)
    model = spec.compile()
    # MuJoCo leaves out what it need not compute for boxes and inertias in the frame of their body; these may differ.
    model.geom_sameframe[:], model.body_sameframe[:] = 0, 0
    assert int(model.geom(f"still:{slots.still - 1}").id) == slots.still if slots.still else True
    assert model.body(1 + len(slots.parts)).name.startswith(PREFIX)
    return model


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
