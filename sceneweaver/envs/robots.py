"""Robots: an MJCF model and which of its joints, actuators and sites mean what. Two are drawn here from primitives."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from sceneweaver.io import load_mjcf, read_text
from sceneweaver.scene import InputError

_SPEEDS = {"base_x": 0.6, "base_y": 0.6, "base_yaw": 1.2, "lift": 0.4, "extend_1": 0.3, "extend_2": 0.3}

RADIUS = 0.2
"""Radius of the drawn robot's base [m]."""

HAND = 0.26
"""From the wrist of the drawn robots to the middle between the tips of their fingers [m]."""


@dataclass(frozen=True)
class Robot:
    """A robot to put into rooms.

    Every joint that is driven has a position actuator; all names are those of the robot's own MJCF.

    Attributes:
        name: What it is called.
        xml: Text of its MJCF; its root body stands on z = 0 with its front +x.
        folder: Where the files that the text names are looked for.
        base: Joints that move the base along x and y of the room and about z; empty: the robot stands where it is put.
        arm: Driven joints from the base to the hand.
        gripper: Actuators of the fingers; the lower end of their control range is closed, the upper one open.
        tool: Site between the fingertips: +z along the approach of the hand, +y along the closing of the fingers.
        home: Positions [rad] or [m] of joints at the start, 0 for those left out.
        speeds: Top speed [rad/s] or [m/s] by joint; 1 for those left out.
        radius: Of the disc on the floor that it needs [m].
        reach: How far from the base's axis the tool gets at most [m].
        heights: Lowest and highest place of the tool [m].
        payload: The heaviest thing that it lifts [kg].

    Examples:
        >>> from sceneweaver import envs
        >>> robot = envs.mobile_manipulator()
        >>> robot.tool, robot.gripper
        ('tool', ('finger_left', 'finger_right'))
    """

    name: str
    xml: str
    base: tuple[str, ...] = ()
    arm: tuple[str, ...] = ()
    gripper: tuple[str, ...] = ()
    tool: str = "tool"
    home: Mapping[str, float] = field(default_factory=dict)
    speeds: Mapping[str, float] = field(default_factory=dict)
    radius: float = RADIUS
    reach: float = 0.95
    heights: tuple[float, float] = (0.1, 1.6)
    payload: float = 3.0
    folder: Path | None = None

    @classmethod
    def from_mjcf(
        cls, path: str | os.PathLike[str], *, tool: str, arm: Sequence[str], gripper: Sequence[str], **more: object
    ) -> Robot:
        """A robot from a file, as those of MuJoCo Menagerie.

        Args:
            path: The file; meshes are looked for as it names them.
            tool: Its site between the fingertips.
            arm: Its driven joints.
            gripper: Actuators of its fingers.
            more: Other attributes of `Robot`.

        Raises:
            InputError: the file cannot be read.

        Examples:
            >>> from sceneweaver import envs
            >>> envs.Robot.from_mjcf("none.xml", tool="grip", arm=["joint1"], gripper=["hand"])
            Traceback (most recent call last):
            ...
            sceneweaver.io.errors.InputError: robot: none.xml: no such file; check the path
        """
        file = Path(path)
        try:
            load_mjcf(file)
            text = read_text(file)
        except InputError as error:
            raise InputError(f"robot: {error}") from None
        made = cls(file.stem, text, arm=tuple(arm), gripper=tuple(gripper), tool=tool, folder=file.parent.resolve())
        return replace(made, **more)  # type: ignore[arg-type]


def mobile_manipulator() -> Robot:
    """A slim base that drives in all directions, a lift, a telescope, a wrist with three axes and a gripper of 8 cm.

    Its tool reaches from the floor to 1.6 m, and 0.66 m beyond its base.

    Examples:
        >>> from sceneweaver import envs
        >>> robot = envs.mobile_manipulator()
        >>> robot.base, len(robot.arm)
        (('base_x', 'base_y', 'base_yaw'), 6)
    """
    base = ("base_x", "base_y", "base_yaw")
    driven = """
      <joint name="base_x" type="slide" axis="1 0 0" armature="2"/>
      <joint name="base_y" type="slide" axis="0 1 0" armature="2"/>
      <joint name="base_yaw" type="hinge" axis="0 0 1" armature="0.5"/>"""
    drives = """
    <position name="base_x" joint="base_x" kp="8000" kv="1600" ctrlrange="-100 100" forcerange="-300 300"/>
    <position name="base_y" joint="base_y" kp="8000" kv="1600" ctrlrange="-100 100" forcerange="-300 300"/>
    <position name="base_yaw" joint="base_yaw" kp="2000" kv="300" ctrlrange="-1000 1000" forcerange="-120 120"/>"""
    return Robot("mobile", _model(driven, drives), base, _ARM, ("finger_left", "finger_right"), **_COMMON)


def fixed_arm() -> Robot:
    """The arm of the mobile manipulator on a stand that does not move.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.fixed_arm().base
        ()
    """
    return Robot("arm", _model("", ""), (), _ARM, ("finger_left", "finger_right"), **_COMMON)


ROBOTS = {"mobile": mobile_manipulator, "arm": fixed_arm}
"""Robots by name."""


def robot_named(robot: str | Robot) -> Robot:
    """A robot by its name, or the robot itself.

    Raises:
        InputError: for a name that is none.
    """
    if isinstance(robot, Robot):
        return robot
    if robot not in ROBOTS:
        raise InputError(f"robot: '{robot}' is not known; use {', '.join(ROBOTS)}, or a Robot from Robot.from_mjcf")
    return ROBOTS[robot]()


_ARM = ("lift", "extend_1", "extend_2", "wrist_yaw", "wrist_pitch", "wrist_roll")
_COMMON: dict = {"home": {"lift": 1.3, "wrist_pitch": 1.57}, "speeds": _SPEEDS}


def _model(joints: str, actuators: str) -> str:
    """MJCF of the drawn robot.

    Gravity of its arm is compensated for, as the controllers of real ones do. By their bits its parts touch the room
    and not each other.
    """
    fingers = "".join(_finger(name, side) for name, side in (("left", 1), ("right", -1)))
    return f"""<mujoco model="robot">
  <compiler angle="radian"/>
  <default>
    <default class="robot">
      <geom type="box" group="2" contype="2" conaffinity="1" rgba="0.86 0.87 0.89 1" friction="0.6"/>
      <joint damping="1" armature="0.05"/>
      <position kp="400" kv="40" forcerange="-30 30" inheritrange="1"/>
      <default class="pad">
        <geom rgba="0.12 0.12 0.13 1" friction="1.5 0.02 0.001" condim="4" solref="0.01 1"/>
      </default>
    </default>
  </default>
  <worldbody>
    <body name="base" childclass="robot">{joints}
      <geom name="base" type="cylinder" size="{RADIUS} 0.1" pos="0 0 0.125" mass="45" rgba="0.25 0.27 0.3 1"/>
      <geom name="column" size="0.045 0.06 0.72" pos="-0.13 0 0.94" mass="8" rgba="0.55 0.57 0.6 1"/>
      <body name="carriage" gravcomp="1">
        <joint name="lift" type="slide" axis="0 0 1" range="0.12 1.58"/>
        <geom name="carriage" size="0.05 0.07 0.06" pos="-0.03 0 0" mass="1.5" rgba="0.25 0.27 0.3 1"/>
        <geom name="tube" size="0.18 0.035 0.035" pos="0.03 0 0" mass="1"/>
        <body name="stage_1" gravcomp="1">
          <joint name="extend_1" type="slide" axis="1 0 0" range="0 0.28"/>
          <geom name="stage_1" size="0.17 0.028 0.028" pos="0.045 0 0" mass="0.6" rgba="0.7 0.72 0.75 1"/>
          <body name="stage_2" gravcomp="1">
            <joint name="extend_2" type="slide" axis="1 0 0" range="0 0.28"/>
            <geom name="stage_2" size="0.165 0.022 0.022" pos="0.05 0 0" mass="0.5" rgba="0.55 0.57 0.6 1"/>
            <body name="wrist" pos="0.25 0 0" gravcomp="1">
              <joint name="wrist_yaw" axis="0 0 1" range="-2 2"/>
              <geom name="wrist" type="sphere" size="0.034" mass="0.3" rgba="0.25 0.27 0.3 1"/>
              <body name="elbow" gravcomp="1">
                <joint name="wrist_pitch" axis="0 1 0" range="-0.8 1.9"/>
                <geom name="elbow" type="capsule" size="0.026" fromto="0.03 0 0 0.11 0 0" mass="0.3"/>
                <body name="palm" pos="0.14 0 0" gravcomp="1">
                  <joint name="wrist_roll" axis="1 0 0" range="-3.2 3.2"/>
                  <geom name="palm" size="0.02 0.055 0.022" mass="0.3" rgba="0.25 0.27 0.3 1"/>
                  <site name="tool" pos="{HAND - 0.14} 0 0" xyaxes="0 0 -1 0 1 0" size="0.005" group="4"/>{fingers}
                </body>
              </body>
            </body>
          </body>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>{actuators}
    <position name="lift" joint="lift" class="robot" kp="12000" kv="700" forcerange="-400 400"/>
    <position name="extend_1" joint="extend_1" class="robot" kp="8000" kv="400" forcerange="-150 150"/>
    <position name="extend_2" joint="extend_2" class="robot" kp="8000" kv="400" forcerange="-150 150"/>
    <position name="wrist_yaw" joint="wrist_yaw" class="robot"/>
    <position name="wrist_pitch" joint="wrist_pitch" class="robot"/>
    <position name="wrist_roll" joint="wrist_roll" class="robot"/>
    <position name="finger_left" joint="finger_left" class="robot" kp="2500" kv="60" forcerange="-40 40"/>
    <position name="finger_right" joint="finger_right" class="robot" kp="2500" kv="60" forcerange="-40 40"/>
  </actuator>
</mujoco>
"""


def _finger(name: str, side: int) -> str:
    """A finger that opens by 4 cm to its side; its tip is a pad of rubber."""
    return f"""
                  <body name="finger_{name}" gravcomp="1">
                    <joint name="finger_{name}" type="slide" axis="0 {side} 0" range="0 0.04"/>
                    <geom name="finger_{name}" size="0.03 0.006 0.012" pos="0.05 {side * 0.008} 0" mass="0.05"/>
                    <geom name="pad_{name}" class="pad" size="0.026 0.004 0.011" pos="0.106 {side * 0.004} 0"
                          mass="0.03"/>
                  </body>"""
