"""Doors, drawers and lids: nothing of their own piece is in their way, and they open and close in MuJoCo."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import Asset, make
from sceneweaver.export.mjcf import write_mjcf
from sceneweaver.physics import build
from sceneweaver.scene import Door, Pose, Room, Scene, SceneObject, Support
from tests.sizes import share

mujoco: Any = import_module("mujoco")

ROOM = Room(outline=((-5, -5), (5, -5), (5, 5), (-5, 5)), height=4)
DEEP = 2e-3
"""A moving part may reach so far [m] into the rest of its piece."""

ARTICULATED = (
    "bar_cabinet",
    "cabinet",
    "cash_register",
    "changing_table",
    "chest",
    "coffee_station",
    "computer_desk",
    "corner_cabinet",
    "corner_desk",
    "dishwasher",
    "display_cabinet",
    "double_vanity",
    "dresser",
    "dressing_table",
    "dryer",
    "filing_cabinet",
    "freezer",
    "fridge",
    "ice_machine",
    "jewelry_box",
    "kitchen_cabinet",
    "kitchen_cart",
    "kitchen_counter",
    "kitchen_island",
    "lab_bench",
    "laundry_hamper",
    "linen_cabinet",
    "locker",
    "medical_cabinet",
    "medicine_cabinet",
    "microwave",
    "minibar",
    "murphy_bed",
    "music_box",
    "nightstand",
    "oven_tower",
    "pedal_bin",
    "phone_booth",
    "reception_desk",
    "recycling_bin",
    "safe",
    "secretary_desk",
    "shoe_cabinet",
    "shower",
    "side_by_side_fridge",
    "sideboard",
    "sink_cabinet",
    "stove",
    "tall_cabinet",
    "tallboy",
    "teacher_desk",
    "toilet",
    "tool_cabinet",
    "tool_chest",
    "trophy_case",
    "tv_stand",
    "vanity",
    "vending_machine",
    "wall_cabinet",
    "wall_toilet",
    "wardrobe",
    "washing_machine",
    "wine_cooler",
)

EXPECTED = (
    "wardrobe",
    "cabinet",
    "dresser",
    "nightstand",
    "fridge",
    "stove",
    "oven_tower",
    "dishwasher",
    "microwave",
    "washing_machine",
    "filing_cabinet",
    "teacher_desk",
    "kitchen_counter",
    "sideboard",
)
"""What a person expects to open."""


def _alone(asset: Asset) -> tuple[Any, Any]:
    """A piece in the air, with all contacts within it."""
    thing = asset.object("o", pose=Pose.from_yaw(0, 0, 1.0, 0.0), mount="floor")
    model = mujoco.MjModel.from_xml_string(
        build(Scene(id="s", room=ROOM, objects=(thing,)), {asset.id: asset}.__getitem__).xml
    )
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
    model.exclude_signature[:] = -1
    return model, mujoco.MjData(model)


def _depth(model: Any, data: Any, body: int) -> float:
    """How deep [m] that body is in another one."""
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_collision(model, data)
    deep = 0.0
    for contact in data.contact[: data.ncon]:
        if body in model.geom_bodyid[contact.geom]:
            deep = max(deep, -float(contact.dist))
    return deep


def _sweep(asset: Asset, steps: int = 12) -> dict[str, float]:
    """How deep each link gets into the rest of its piece on its way from closed to open [m]."""
    model, data = _alone(asset)
    start, found = data.qpos.copy(), {}
    for link in asset.links:
        joint = model.joint(f"o.{link.name}")
        far = max(joint.range, key=abs)
        body, found[link.name] = model.body(f"o.{link.name}").id, 0.0
        for k in range(steps + 1):
            data.qpos[:] = start
            data.qpos[joint.qposadr[0]] = far * k / steps
            found[link.name] = max(found[link.name], _depth(model, data, body))
    return found


@pytest.mark.parametrize("category", share(ARTICULATED, 3))
def test_nothing_is_in_the_way(category: str) -> None:
    asset = make(category, seed=0)
    assert asset.links
    found = _sweep(asset)
    assert {name: deep for name, deep in found.items() if deep > DEEP} == {}


def test_what_a_person_expects_to_open_has_links() -> None:
    assert set(EXPECTED) <= set(ARTICULATED)
    for name in EXPECTED:
        for link in make(name, seed=1).links:
            span = max(map(abs, link.limits))
            assert span > (0.7 if link.joint == "hinge" else 0.1), f"{name} {link.name}: opens by {span}"
            assert 0.0 in link.limits, "drawn closed"


def _pull(model: Any, data: Any, joint: str, force: float, seconds: float) -> float:
    """Pull (or, with less than 0, push) at the far edge of a door or drawer; where its joint is then, 1: open."""
    at, body = model.joint(joint), model.body(joint).id
    far = max(at.range, key=abs)
    adr, dof = int(at.qposadr[0]), int(at.dofadr[0])
    way = np.sign(far) * force
    if at.type[0] == mujoco.mjtJoint.mjJNT_HINGE:  # the moment of that force at the edge
        mine = np.flatnonzero((model.geom_bodyid == body) & (model.geom_contype > 0))
        mujoco.mj_forward(model, data)
        axis, anchor = data.joint(joint).xaxis, data.joint(joint).xanchor
        arms = data.geom_xpos[mine] - anchor
        way *= 2 * np.linalg.norm(arms - np.outer(arms @ axis, axis), axis=1).mean()
    for _ in range(round(seconds / model.opt.timestep)):
        data.qfrc_applied[dof] = way
        mujoco.mj_step(model, data)
    data.qfrc_applied[dof] = 0.0
    return float(data.qpos[adr] / far)


@pytest.fixture(scope="module")
def bedroom(tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, dict[str, Asset]]:
    """A furnished room, exported and loaded again: things stand on what opens."""
    kinds = {"wardrobe": 0, "dresser": 0, "nightstand": 0, "cabinet": 0, "mug": 2, "table_lamp": 1, "dishwasher": 0}
    assets = {name: make(name, seed) for name, seed in kinds.items()}
    places = {
        "wardrobe": (-1.2, 1.5, -1.5),
        "dresser": (1.2, 1.6, -1.5),
        "nightstand": (-1.6, -0.6, 0.1),
        "cabinet": (1.5, -0.8, 3.0),
        "dishwasher": (0.2, -1.5, 1.6),
    }
    objects: list[SceneObject] = []
    for name, (x, y, yaw) in places.items():
        objects.append(assets[name].object(name, pose=Pose.from_yaw(x, y, 0.0, yaw)))
    for name, below in (("mug", "dresser"), ("table_lamp", "nightstand")):
        top = next(s for s in assets[below].surfaces if s.name == "top")
        (x, y, yaw) = places[below]
        support = Support(object=below, surface=top.name)
        objects.append(assets[name].object(name, pose=Pose.from_yaw(x, y, top.z, yaw), support=support))
    door = Door(id="door", wall=0, offset=1.0, width=0.9, height=2.0, swing="in-right")
    room = Room(outline=((-2.5, -2.2), (2.5, -2.2), (2.5, 2.2), (-2.5, 2.2)), doors=(door,))
    scene = Scene(id="s", room=room, objects=tuple(objects))
    load = {a.id: a for a in assets.values()}.__getitem__
    path = write_mjcf(scene, tmp_path_factory.mktemp("bedroom") / "out", load)
    return mujoco.MjModel.from_xml_path(str(path)), assets


def test_all_is_closed_and_stays_so(bedroom: tuple[Any, dict[str, Asset]]) -> None:
    model, _ = bedroom
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 250)
    for k in np.flatnonzero(model.jnt_type != mujoco.mjtJoint.mjJNT_FREE):
        assert abs(data.qpos[model.jnt_qposadr[k]]) < 0.02 * np.ptp(model.jnt_range[k]), model.joint(k).name


@pytest.mark.parametrize("thing", ["wardrobe", "dresser", "nightstand", "cabinet", "dishwasher"])
def test_it_opens_and_closes_in_a_room(bedroom: tuple[Any, dict[str, Asset]], thing: str) -> None:
    model, assets = bedroom
    for link in assets[thing].links[:2]:
        data = mujoco.MjData(model)
        joint, start = f"{thing}.{link.name}", data.qpos.copy()
        force = 30.0 if thing != "dishwasher" else 60.0  # its door falls open, and has to be lifted
        assert _pull(model, data, joint, force, 1.5) > 0.8
        assert -0.02 < _pull(model, data, joint, -force, 1.5) < 0.02
        for object_id in ("mug", "table_lamp", "cabinet", "wardrobe"):
            adr = int(model.joint(object_id).qposadr[0])
            assert np.linalg.norm(data.qpos[adr : adr + 3] - start[adr : adr + 3]) < 0.05, f"{object_id} stays"


def test_the_room_has_a_door_that_opens(bedroom: tuple[Any, dict[str, Asset]]) -> None:
    model, _ = bedroom
    data = mujoco.MjData(model)
    assert _pull(model, data, "room:door:door", 20.0, 2.0) > 0.95
    assert abs(_pull(model, data, "room:door:door", -20.0, 2.0)) < 0.02
