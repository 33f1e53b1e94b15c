"""Ways for the drawn mobile robot: what collides is asked of MuJoCo on a copy of the room.

Where its joints have to be for a pose of the tool is a closed form with two numbers free. The wrist's axes meet in a
point ``HAND`` behind the tool, at the end of the telescope. So the lift has the height of that point, and the base is
behind it by what the telescope is long, in any direction: yaw of the base and length of the telescope are free, all
else follows.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from sceneweaver.runtime.mujoco_module import load_mujoco

from .geometry import Articulation, GraspFrame
from .joining import PREFIX
from .navigation import FloorMap
from .predicates import rotate, to_world
from .robots import HAND
from .world import World

Array = np.ndarray

YAWS = np.arange(24) * np.pi / 12
EXTENSIONS = np.arange(0.0, 0.57, 0.08)

_DEEP = -0.002  # [m]; contacts that are less deep than this do not count
_TURN = 0.4  # cost [m] of a turn of the base by 1 rad
_FAR = 0.6  # cost [m] of a move from one pose of the tool to the next at most
_KEPT = 24  # configurations that are tried further for each pose of the tool

WRIST = 0.25
"""From the axis of the base to the wrist with the telescope drawn in [m]."""

STROKE = 0.56
"""How far the telescope comes out [m]."""

_LIMITS = {"lift": (0.125, 1.575), "wrist_yaw": (-1.98, 1.98), "wrist_pitch": (-0.78, 1.88)}


@dataclass(frozen=True)
class ToolPose:
    """Where the tool is to be: ``position`` [3], unit vectors ``approach`` and ``closing`` [3], in the room's frame."""

    position: Array
    approach: Array
    closing: Array

    def moved(self, shift: Array) -> ToolPose:
        """The same, moved by [3]."""
        return ToolPose(self.position + shift, self.approach, self.closing)

    def back(self, distance: float) -> ToolPose:
        """The same, ``distance`` [m] before it along the approach."""
        return self.moved(-distance * self.approach)


def configuration(tool: ToolPose, yaw: float, extend: float) -> Array | None:
    """Joints [9] of the mobile robot: base x, y, yaw, lift, the two stages, wrist yaw, pitch and roll.

    Args:
        tool: Where the tool is to be.
        yaw: Of the base [rad].
        extend: Of both stages of the telescope together [m].

    Returns:
        None where a joint would be beyond its limits.
    """
    wrist = tool.position - HAND * tool.approach
    along = np.array([np.cos(yaw), np.sin(yaw)])
    base = wrist[:2] - (WRIST + extend) * along
    level = float(np.hypot(*tool.approach[:2]))
    pitch = float(np.arctan2(-tool.approach[2], level))
    heading = float(np.arctan2(tool.approach[1], tool.approach[0])) if level > 1e-3 else yaw
    turn = _wrapped(heading - yaw)
    side = np.array([-np.sin(yaw + turn), np.cos(yaw + turn), 0.0])
    up = np.cross(tool.approach, side)
    roll = float(np.arctan2(tool.closing @ up, tool.closing @ side))
    roll = (roll + np.pi / 2) % np.pi - np.pi / 2  # the two fingers are alike
    values = {"lift": float(wrist[2]), "wrist_yaw": turn, "wrist_pitch": pitch}
    if not 0 <= extend <= STROKE or any(not low <= values[k] <= high for k, (low, high) in _LIMITS.items()):
        return None
    return np.array([*base, yaw, wrist[2], extend / 2, extend / 2, turn, pitch, roll])


def _wrapped(angle: float) -> float:
    return float((angle + np.pi) % (2 * np.pi) - np.pi)


class Planner:
    """Checks configurations of the robot against a room as it is now, and finds ways.

    Args:
        world: The room with the mobile robot.
        data: Its simulation, of which a copy is made.
    """

    def __init__(self, world: World, data: Any) -> None:
        """Copy the state and lay the map of the floor."""
        mujoco = load_mujoco()
        self.world = world
        self.data = mujoco.MjData(world.model)
        self.data.qpos[:] = data.qpos
        mujoco.mj_kinematics(world.model, self.data)
        self.floor = FloorMap(world, self.data)
        self.reached = self.floor.reached(world.base(data)[:2])
        self._fingers = [world.model.joint(PREFIX + name).qposadr[0] for name in ("finger_left", "finger_right")]
        self._owner = world.model.geom_bodyid

    def on_floor(self, joints: Array) -> bool:
        """Whether the base stands on a free place that can be driven to."""
        gap = np.linalg.norm(self.floor.points - joints[:2], axis=-1)
        row, column = np.unravel_index(np.argmin(gap), gap.shape)
        return bool(self.reached[row, column] and gap[row, column] < 0.05)

    def is_free(
        self, joints: Array, opening: float = 0.04, touching: Iterable[str] = (), doors: dict[str, float] | None = None
    ) -> bool:
        """Whether the robot touches nothing but the bodies ``touching``.

        Args:
            joints: Base and arm [9].
            opening: Of each finger [m].
            touching: Names of bodies that it may touch.
            doors: Positions of doors and drawers that are not as now.
        """
        mujoco = load_mujoco()
        model, data = self.world.model, self.data
        kept = data.qpos.copy()
        data.qpos[self.world.indices.drive_position] = joints
        data.qpos[self._fingers] = opening
        for name, value in (doors or {}).items():
            data.qpos[model.joint(name).qposadr[0]] = value
        mujoco.mj_kinematics(model, data)
        mujoco.mj_collision(model, data)
        data.qpos[:] = kept
        count = data.ncon
        if not count:
            return True
        pairs = data.contact.geom[:count]
        robot = self.world.robot_geoms
        mine = robot[pairs[:, 0]] != robot[pairs[:, 1]]
        others = np.where(robot[pairs[:, 0]], pairs[:, 1], pairs[:, 0])
        allowed = [model.body(name).id for name in touching]
        hits = mine & (data.contact.dist[:count] < _DEEP) & ~np.isin(self._owner[others], allowed)
        return not hits.any()

    def stations(self, tool: ToolPose) -> list[Array]:
        """Configurations [9] for a pose of the tool whose base stands on free floor, the least strained first."""
        found = []
        for yaw in YAWS:
            for extend in EXTENSIONS:
                joints = configuration(tool, yaw, extend)
                if joints is not None and self.on_floor(joints):
                    found.append(joints)
        return sorted(found, key=strain)

    def follow(
        self,
        tools: Sequence[ToolPose],
        doors: Sequence[dict[str, float]],
        touching: Iterable[str],
        opening: float,
    ) -> list[Array]:
        """Configurations for poses of the tool one after the other with the least driving, as far as there are any.

        Args:
            tools: Poses of the tool.
            doors: Positions of doors and drawers at each.
            touching: Bodies that may be touched.
            opening: Of each finger [m].
        """
        layers: list[list[_Stop]] = []
        for tool, there in zip(tools, doors, strict=True):
            best: list[_Stop] = []
            for joints in self.stations(tool):
                if layers:
                    prices = [stop.price + _step(joints, stop.joints) for stop in layers[-1]]
                    before = layers[-1][int(np.argmin(prices))]
                    if _step(joints, before.joints) <= _FAR:
                        best.append(_Stop(joints, min(prices), before))
                else:
                    best.append(_Stop(joints, 0.0, None))
            best.sort(key=lambda stop: stop.price)
            free = (stop for stop in best if self.is_free(stop.joints, opening, touching, there))
            kept = list(islice(free, _KEPT))
            if not kept:
                break
            layers.append(kept)
        way: list[Array] = []
        stop = min(layers[-1], key=lambda stop: stop.price) if layers else None
        while stop is not None:
            way.append(stop.joints)
            stop = stop.before
        return way[::-1]


@dataclass(frozen=True, eq=False)
class _Stop:
    """A configuration [9] on a way, the cost [m] of the way to it, and what comes before."""

    joints: Array
    price: float
    before: _Stop | None


def strain(joints: Array) -> float:
    """How far a configuration [9] is from the telescope half out and the wrist straight; what is low leaves most room
    both ways.
    """
    return float(abs(joints[4] + joints[5] - 0.3) + 0.3 * abs(joints[6]))


def _step(joints: Array, before: Array) -> float:
    """Cost [m] of a move between two configurations."""
    turn = abs((joints[2] - before[2] + np.pi) % (2 * np.pi) - np.pi)
    return float(np.linalg.norm(joints[:2] - before[:2]) + _TURN * turn + 0.2 * abs(joints[4] - before[4]))


def tool_of(grasp: GraspFrame, pose: Array) -> ToolPose:
    """A grasp of a body at ``pose`` [7] in the room's frame."""
    return ToolPose(to_world(pose, grasp.position), rotate(pose[3:], grasp.approach), rotate(pose[3:], grasp.closing))


def link_pose(door: Articulation, pose: Array, position: float) -> Array:
    """The pose [7] of a door's body, opened by ``position`` [rad] or [m], of an object at ``pose`` [7]."""
    mujoco = load_mujoco()
    if door.slides:
        return np.concatenate([to_world(pose, position * door.joint.axis), pose[3:]])
    turn, total = np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, door.joint.axis, position)
    mujoco.mju_mulQuat(total, pose[3:], turn)
    return np.concatenate([to_world(pose, door.joint.anchor - rotate(turn, door.joint.anchor)), total])
