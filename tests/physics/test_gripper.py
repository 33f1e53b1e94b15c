"""A parallel gripper, held by nothing but its wrist, opens things by their handles: by friction of its fingers."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import Asset, Grasp, make
from sceneweaver.assets.parametric import makers
from sceneweaver.physics import build
from sceneweaver.scene import Pose, Scene
from tests.assets.grasps import HELD, OPENING, frame_of, hand
from tests.assets.items import ROOM

mujoco: Any = import_module("mujoco")

FORCE = 40.0
"""With which each finger closes [N], as hands for this size of things do."""


def _world(asset: Asset) -> Any:
    """The piece alone on a floor, and a hand whose frame is that of a grasp: its wrist follows a mocap body."""
    thing = asset.object("o", pose=Pose.from_yaw(0, 0, 0, 0), mount="floor")
    text = build(Scene(id="s", room=ROOM, objects=(thing,)), {asset.id: asset}.__getitem__).xml
    fingers = "".join(
        f'''<body name="{name}"><joint name="{name}" type="slide" axis="0 {-side} 0" range="0 {OPENING / 2}"
        limited="true" damping="200"/>{_geom(*hand(OPENING)[f"the {name} finger"])}</body>'''
        for name, side in (("left", 1), ("right", -1))
    )
    motors = "".join(f'<motor joint="{name}" ctrlrange="-{FORCE} {FORCE}"/>' for name in ("left", "right"))
    rest = f"""<worldbody><body name="wrist" mocap="true"/><body name="palm"><freejoint/>
    {_geom(*hand(OPENING)["the palm"])}{fingers}</body></worldbody>
    <equality><weld body1="wrist" body2="palm" solref="0.01 1"/></equality><actuator>{motors}</actuator></mujoco>"""
    return mujoco.MjModel.from_xml_string(text.replace("</mujoco>", rest))


def _geom(low: np.ndarray, high: np.ndarray) -> str:
    pos, size = (" ".join(map(str, v)) for v in ((low + high) / 2, (high - low) / 2))
    return f'<geom type="box" pos="{pos}" size="{size}" mass="0.1" friction="1 0.01 0.001" condim="4"/>'


def _open(asset: Asset, grasp: Grasp, share: float) -> float:
    """How far [rad] or [m] the hand opens the link of a grasp that it takes along by this share of its limit."""
    model = _world(asset)
    data = mujoco.MjData(model)
    link = asset.links[grasp.link - 1]
    joint = model.joint(f"o.{link.name}")
    far = max(link.limits, key=abs)
    axis, anchor = np.array(link.axis), np.array(link.anchor)
    at, turn = np.array(grasp.position), frame_of(grasp)
    palm = model.joint(model.body("palm").jntadr[0])

    def wrist(opened: float, back: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """Where the wrist has to be, and its quaternion."""
        point, way = at - back * turn[:, 2], turn
        if link.joint == "slide":
            return point + opened * axis, _quat(way)
        spin = np.zeros(9)
        quat = np.zeros(4)
        mujoco.mju_axisAngle2Quat(quat, axis, opened)
        mujoco.mju_quat2Mat(spin, quat)
        spin = spin.reshape(3, 3)
        return anchor + spin @ (point - anchor), _quat(spin @ way)

    data.qpos[palm.qposadr[0] : palm.qposadr[0] + 7] = np.concatenate(wrist(0.0, 0.15))
    for until, opened, back, force in (
        (0.2, (0, 0), (0.15, 0.15), -5.0),
        (1.0, (0, 0), (0.15, 0.0), -5.0),
        (1.5, (0, 0), (0.0, 0.0), FORCE),
        (5.0, (0, share * far), (0.0, 0.0), FORCE),
    ):
        start = data.time
        while data.time < until:
            part = (data.time - start) / (until - start)
            mix = [a + part * (b - a) for a, b in (opened, back)]
            data.mocap_pos[0], data.mocap_quat[0] = wrist(*mix)
            data.ctrl[:] = force
            mujoco.mj_step(model, data)
    return float(abs(data.qpos[joint.qposadr[0]])) / abs(far)


def _quat(turn: np.ndarray) -> np.ndarray:
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, turn.ravel())
    return quat


@pytest.mark.slow
@pytest.mark.parametrize(
    ("category", "share", "least"),
    [("dresser", 0.8, 0.7), ("fridge", 0.7, 60 / 95), ("kitchen_cabinet", 0.8, 0.7), ("oven_tower", 0.8, 0.7)],
)
def test_a_gripper_opens(category: str, share: float, least: float) -> None:
    asset = make(category, 0)
    grasp = next(g for g in asset.grasps if asset.links[g.link - 1].role in ("door", "drawer"))
    assert _open(asset, grasp, share) >= least


@pytest.mark.slow
def test_a_gripper_opens_nearly_all() -> None:
    """Of each piece a door, a drawer and a lid; not a bed in a cupboard, nor a lid heavier than its music box."""
    opened: dict[str, float] = {}
    for category in sorted(makers()):
        asset = make(category, 0)
        for grasp in (grasp for grasp in asset.grasps if grasp.link):
            link = asset.links[grasp.link - 1]
            if link.role in HELD and f"{category} {link.role}" not in opened:
                opened[f"{category} {link.role}"] = _open(asset, grasp, 0.8)
    shut = [name for name, share in opened.items() if share < 0.65]
    assert len(opened) > 60 and len(shut) <= 0.03 * len(opened), shut
