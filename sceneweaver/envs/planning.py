"""Ways for the drawn mobile robot: what collides is asked of MuJoCo on a copy of the room."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib import import_module
from typing import Any

import numpy as np

from .geometry import Articulation, GraspFrame
from .joining import PREFIX
from .kinematics import ToolPose, configuration
from .navigation import FloorMap
from .predicates import rotate, to_world
from .world import World

Array = np.ndarray

YAWS = np.arange(24) * np.pi / 12
EXTENSIONS = np.arange(0.0, 0.57, 0.08)

_DEEP = -0.002  # [m]; contacts that are less deep than this do not count
_TURN = 0.4  # cost [m] of a turn of the base by 1 rad


class Planner:
    """Checks configurations of the robot against a room as it is now, and finds ways.

    Args:
        world: The room with the mobile robot.
        data: Its simulation, of which a copy is made.
    """

    def __init__(self, world: World, data: Any) -> None:
        """Copy the state and lay the map of the floor."""
        mujoco: Any = import_module("mujoco")
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
        mujoco: Any = import_module("mujoco")
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
        layers: list[tuple[list[Array], list[float], list[int]]] = []
        for tool, there in zip(tools, doors, strict=True):
            best: list[tuple[Array, float, int]] = []
            for joints in self.stations(tool):
                if layers:
                    before, costs, _ = layers[-1]
                    prices = [c + _step(joints, b) for b, c in zip(before, costs, strict=True)]
                    number = int(np.argmin(prices))
                    if _step(joints, before[number]) > 0.6:
                        continue
                    price = prices[number]
                else:
                    number, price = -1, 0.0
                best.append((joints, price, number))
            best.sort(key=lambda entry: entry[1])
            kept: list[tuple[Array, float, int]] = []
            for entry in best:
                if len(kept) >= 24:
                    break
                if self.is_free(entry[0], opening, touching, there):
                    kept.append(entry)
            if not kept:
                break
            layers.append(([k[0] for k in kept], [k[1] for k in kept], [k[2] for k in kept]))
        if not layers:
            return []
        number = int(np.argmin(layers[-1][1]))
        way = []
        for joints, _, before in reversed(layers):
            way.append(joints[number])
            number = before[number]
        return way[::-1]


def strain(joints: Array) -> float:
    """How far a configuration [9] is from the telescope half out and the wrist straight; what is low leaves most room
    both ways.

    Examples:
        >>> from sceneweaver.envs.planning import strain
        >>> strain(np.array([0, 0, 0, 1, 0.15, 0.15, 0, 0, 0]))
        0.0
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
    mujoco: Any = import_module("mujoco")
    if door.slides:
        return np.concatenate([to_world(pose, position * door.axis), pose[3:]])
    turn, total = np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, door.axis, position)
    mujoco.mju_mulQuat(total, pose[3:], turn)
    return np.concatenate([to_world(pose, door.anchor - rotate(turn, door.anchor)), total])
