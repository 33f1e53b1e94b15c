"""Scripted policies for the drawn mobile robot: they act through `RoomEnv.step` alone, in real contact.

They know the room: a plan is made on its geometry, and then followed by targets of the joints.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np

from .env import PERIOD, RoomEnv
from .geometry import Articulation, grasps_of
from .planning import EXTENSIONS, YAWS, Planner, ToolPose, link_pose, strain, tool_of
from .predicates import rotate, to_world, turned
from .tasks import Open, PutIn, PutOn, Take

Array = np.ndarray
OnStep = Callable[[RoomEnv], None]

_STANDOFF = 0.09  # [m] before a handle
_LIFTED = 0.14  # [m] by which a thing is lifted before it is carried
_TUCKED = np.array([1.3, 0.0, 0.0, 0.0, 1.57, 0.0])
_TURN_NEAR = 0.5  # [m] before its end a way is driven with the yaw of the end
_DROP = 0.015  # [m] above its place a thing is let go
_CONTACT = 0.008  # [m] from the face that fingers push to their middle: less than they are thick
_OPEN, _CLOSED = 1.0, -1.0


class Failed(Exception):
    """The policy found no way; the text says at what."""


def solve(env: RoomEnv, on_step: OnStep | None = None) -> bool:
    """Do the task of an environment that has been reset, and say whether it is done.

    Args:
        env: With the drawn mobile robot and control "joint".
        on_step: Called after each step, for pictures say.

    Raises:
        Failed: there is no way to do it, or no policy for such a task.
    """
    run = _Run(env, on_step)
    task = env.task
    if isinstance(task, Open):
        run.open(task.joint, task.share)
    elif isinstance(task, PutIn | PutOn):
        run.pick(task.item)
        run.put(task.item, task.goal(env.world.geometry, env.state))
    elif isinstance(task, Take):
        run.pick(task.item)
    else:
        raise Failed(f"no policy for {type(task).__name__}")
    return run.success


class _Run:
    """One episode."""

    def __init__(self, env: RoomEnv, on_step: OnStep | None) -> None:
        self.env, self.world, self.on_step = env, env.world, on_step
        self.gripper = _OPEN
        self.success = self.ended = False

    # Motion

    @property
    def joints(self) -> Array:
        """Targets of the driven joints [9]."""
        return self.env.data.ctrl[self.world.indices.drive].copy()

    def act(self, target: Array, share: float = 1.0) -> None:
        """One step towards targets [9] at a share of the top speed."""
        now = self.joints
        step = target - now
        step[2] = (step[2] + np.pi) % (2 * np.pi) - np.pi
        most = self.world.indices.speeds * PERIOD * share
        step = step / max(1.0, float(np.max(np.abs(step) / most)))
        yaw = self.env.data.qpos[self.world.indices.drive_position[2]]
        step[:2] = turned(step[:2], -yaw)
        action = np.append(step / (self.world.indices.speeds * PERIOD), self.gripper)
        _, _, done, cut, _ = self.env.step(np.clip(action, -1, 1))
        self.success |= done
        self.ended |= cut
        if self.on_step is not None:
            self.on_step(self.env)
        if self.ended:
            raise Failed("time is up")

    def move(self, target: Array, share: float = 1.0, settle: int = 3) -> None:
        """Go to targets [9] on a straight line and wait for the joints to follow."""
        for _ in range(400):
            gap = target - self.joints
            gap[2] = (gap[2] + np.pi) % (2 * np.pi) - np.pi
            if np.abs(gap).max() < 1e-3:
                break
            self.act(target, share)
        for _ in range(settle):
            self.act(target, share)

    def grip(self, command: float, steps: int = 15) -> None:
        """Close or open the gripper, and wait."""
        self.gripper = command
        target = self.joints
        for _ in range(steps):
            self.act(target)

    def drive(self, planner: Planner, place: Array, yaw: float) -> None:
        """Drive with the arm folded to a place [2], and turn to ``yaw``."""
        tucked = self.joints
        tucked[3:] = _TUCKED
        self.move(tucked)
        now = tucked[:2]
        try:
            way = planner.floor.path(now, place)
        except LookupError as error:
            raise Failed(str(error)) from None
        for point in way[1:]:
            target = tucked.copy()
            ahead = np.arctan2(*(point - self.joints[:2])[::-1])
            target[:2], target[2] = point, yaw if np.linalg.norm(place - point) < _TURN_NEAR else ahead
            self.move(target, settle=0)
        target = np.concatenate([place, [yaw], tucked[3:]])
        self.move(target, settle=5)

    # Doors and drawers

    def open(self, joint: str, share: float) -> None:
        """Open a door or drawer: pull at its handle as far as there is a way, then push from behind."""
        door = self.world.geometry.articulations[joint]
        end = door.open_end * min(share + 0.04, 1.0)
        self._pull(joint, end)
        if not self.success and not door.slides:
            self._push(joint, end)

    def _pull(self, joint: str, end: float) -> None:
        geometry, state = self.world.geometry, self.env.state
        door = geometry.articulations[joint]
        pose = state.bodies[door.object]
        planner = Planner(self.world, self.env.data)
        count = max(int(np.ceil(abs(end) / (0.04 if door.slides else 0.09))), 2)
        openings = np.linspace(state.joints[joint], end, count)
        poses = [link_pose(door, pose, q) for q in openings]
        doors = [{}, *({joint: q} for q in openings)]
        ways = []
        for grasp in grasps_of(geometry, joint):
            tools = [tool_of(grasp, there) for there in poses]
            ways.append(planner.follow([tools[0].back(_STANDOFF), *tools], doors, [joint], 0.04))
        way = max(ways, key=len, default=[])
        if len(way) < 3:
            raise Failed(f"no way to the handle of {joint}")
        self._come(planner, way[0])
        self.move(way[1], 0.4, settle=8)
        self.grip(_CLOSED)
        self._swing(way[2:])
        self.grip(_OPEN, 8)
        retreat = self.joints
        tool = self.env.state.tool
        back = rotate(tool[3:], np.array([0.0, 0.0, -1.0])) * 0.12
        retreat[:2] += back[:2]
        self.move(retreat, 0.6)

    def _swing(self, way: list[Array]) -> None:
        """Follow configurations until the task is done; at the last of them wait for the joints."""
        for number, joints in enumerate(way, 1):
            self.move(joints, 0.5, settle=1 if number < len(way) else 20)
            if self.success:
                break

    def _come(self, planner: Planner, station: Array) -> None:
        """Drive to where a configuration has its base, with the arm ready, and go into it."""
        away = station.copy()
        direction = np.array([np.cos(station[2]), np.sin(station[2])])
        for back in (0.45, 0.3, 0.15, 0.0):
            away[:2] = station[:2] - back * direction
            if planner.on_floor(away):
                break
        self.drive(planner, away[:2], station[2])
        self.move(_drawn_in(away))
        self.move(away if planner.is_free(away) else _drawn_in(station))
        self.move(station, 0.6, settle=8)

    def _push(self, joint: str, end: float) -> None:
        """Put the closed fingers behind the edge of a door that is ajar, and swing it on."""
        geometry, state = self.world.geometry, self.env.state
        door = geometry.articulations[joint]
        pose, now = state.bodies[door.object], state.joints[joint]
        solids, grasp = geometry.leaf_of(joint), grasps_of(geometry, joint)[0]
        height = float((grasp.position - door.joint.anchor) @ door.joint.axis)
        planner = Planner(self.world, self.env.data)
        openings = np.linspace(now, end, max(int(np.ceil(abs(end - now) / 0.09)), 2))
        poses = [link_pose(door, pose, q) for q in openings]
        doors = [{}, *({joint: q} for q in openings)]
        ways = []
        for inset, tilt in product((0.06, 0.12), (0.3, 0.7, 1.1)):
            tools = [_behind(door, solids, height, grasp.approach, there, tilt, inset) for there in poses]
            ways.append(planner.follow([tools[0].back(0.2), *tools], doors, [joint], 0.0))
        best = max(ways, key=len)
        if len(best) < 3:
            raise Failed(f"no way behind {joint}, open by {now / door.open_end:.0%}")
        self._come(planner, best[0])
        self.grip(_CLOSED, 6)
        self._swing(best[1:])

    # Things

    def pick(self, name: str) -> None:
        """Take a thing from above and lift it."""
        geometry, state = self.world.geometry, self.env.state
        pose = state.bodies[name]
        planner = Planner(self.world, self.env.data)
        ways = [way for grasp in grasps_of(geometry, name) for way in planner.stations(tool_of(grasp, pose))]
        joints, above = self._reach(planner, sorted(ways, key=strain), name, "grasp {}")
        self.move(joints, 0.4, settle=6)
        self.grip(_CLOSED, 20)
        self.move(above, 0.4, settle=4)
        risen = self.env.state.bodies[name][2] - pose[2]
        if risen < _LIFTED / 2:
            raise Failed(f"{name} slipped out of the hand")
        self.move(_drawn_in(above), 0.6)

    def put(self, name: str, goal: Array) -> None:
        """Bring the thing that is held to a place [3] of its middle, and let go a little above."""
        planner = Planner(self.world, self.env.data)
        joints, above = self._reach(planner, self._stations_over(planner, name, goal), name, "put {} down")
        self.move(joints, 0.3, settle=8)
        self.grip(_OPEN, 10)
        self.move(above, 0.5)
        self.move(_drawn_in(above), 0.6)
        for _ in range(25):
            if self.success:
                break
            self.act(self.joints)

    def _stations_over(self, planner: Planner, name: str, goal: Array) -> list[Array]:
        """Configurations [9] with which the thing in the hand is over a place [3], the least strained first.

        The wrist stays as it is: only the base, the lift and the telescope move, and the thing turns with the base.
        """
        state, held = self.env.state, self.joints
        middle = to_world(state.bodies[name], self.world.geometry.items[name].centre)
        ahead = turned(middle[:2] - held[:2], -held[2])
        found = []
        for yaw in YAWS:
            for extend in EXTENSIONS:
                joints = held.copy()
                joints[:2] = goal[:2] - turned(ahead + [extend - held[4] - held[5], 0.0], yaw)
                joints[2], joints[4:6] = yaw, extend / 2
                joints[3] += goal[2] + _DROP - middle[2]
                if planner.on_floor(joints):
                    found.append(joints)
        return sorted(found, key=strain)

    def _above(self, planner: Planner, joints: Array, name: str) -> Array | None:
        """The same configuration lifted, where hand and telescope come and go without touching."""
        above = joints.copy()
        above[3] = min(joints[3] + _LIFTED, 1.57)
        if not planner.is_free(joints, 0.04, [name]):
            return None
        for share in (1.0, 0.6, 0.3, 0.0):
            way = above.copy()
            way[4:6] = above[4:6] * share
            if not planner.is_free(way, 0.04, [name]):
                return None
        return above

    def _reach(self, planner: Planner, ways: list[Array], name: str, what: str) -> tuple[Array, Array]:
        """Drive to the first configuration that is free, lift, and extend; returns it, and lifted."""
        found = ((joints, self._above(planner, joints, name)) for joints in ways)
        joints, above = next(((one, two) for one, two in found if two is not None), (None, None))
        if joints is None or above is None:
            raise Failed(f"no way to {what.format(name)}")
        self.drive(planner, above[:2], above[2])
        self.move(_drawn_in(above))
        self.move(above, 0.7, settle=5)
        return joints, above


def _drawn_in(joints: Array) -> Array:
    """A configuration [9] with the telescope drawn in."""
    drawn = joints.copy()
    drawn[4:6] = 0.0
    return drawn


def _behind(
    door: Articulation, solids: list[Array], height: float, inner: Array, pose: Array, tilt: float, inset: float
) -> ToolPose:
    """The tool behind a door at ``pose`` [7], ready to swing it open.

    Args:
        door: The door.
        solids: Points [V, 3] of its parts without handles, closed.
        height: Along its axis from its anchor [m].
        inner: Unit vector [3] into the piece, closed.
        tilt: Of the hand off the plane of the door [rad].
        inset: Of the fingertips from its free edge [m].
    """
    across = np.cross(door.joint.axis, inner)
    ends = [points - door.joint.anchor for points in solids]
    edge = max((np.concatenate(ends) @ across).tolist(), key=abs)
    free, length = across * np.sign(edge), abs(edge) - inset

    def covers(points: Array, axis: Array, at: float) -> bool:
        return bool((points @ axis).min() - 0.02 < at < (points @ axis).max() + 0.02)

    met = [p for p in ends if covers(p, free, length) and covers(p, door.joint.axis, height)]
    behind = max((float((p @ inner).max()) for p in met), default=0.0) + _CONTACT
    place = door.joint.anchor + length * free + height * door.joint.axis + behind * inner
    approach = -np.cos(tilt) * free - np.sin(tilt) * inner
    return ToolPose(to_world(pose, place), rotate(pose[3:], approach), rotate(pose[3:], door.joint.axis))
