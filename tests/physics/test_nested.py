"""Things in and on each other begin where they touch, and lids open without their boxes."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.physics import build
from sceneweaver.physics.nested import cut_apart
from sceneweaver.physics.solids import Solid, solid_of
from sceneweaver.physics.things import things_of
from sceneweaver.scene import Pose, Room, Scene, SceneObject, Support, Surface

ROOM = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)))
TOP = Surface(name="s", polygon=((-0.7, -0.7), (0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)), z=0.5)
TABLE = SceneObject(
    id="table", category="block", size=(1.5, 1.5, 0.5), pose=Pose.from_yaw(2, 2, 0.0, 0.0), surfaces=(TOP,)
)


def opened_by_hand(category: str, seconds: float = 2.0) -> tuple[float, float]:
    """A hand pulls at the far edge of a lid until it is open by 90 %: how far [m] the box went, and how far it opened.

    The hand carries the lid, overcomes what holds it, and keeps to its speed.
    """
    asset = make(category, 0)
    pose = Pose.from_yaw(2, 2, 0.5 if asset.mount == "surface" else 0.0, 0.0)
    support = Support(object="table", surface="s") if asset.mount == "surface" else None
    thing = asset.object("t", pose=pose, support=support)
    scene = Scene(id="x", room=ROOM, objects=(TABLE, thing) if support else (thing,))
    load = {asset.id: asset}.__getitem__
    body = next(b for t in things_of(scene, load) if t.object.id == "t" for b in t.bodies if b.joint is not None)
    assert body.joint is not None
    model = mujoco.MjModel.from_xml_string(build(scene, load).xml)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 25)
    start, joint, lid = data.body("t").xpos.copy(), model.joint(body.name), model.body(body.name).id
    points = np.concatenate([solid.points for solid in body.solids]) - body.joint.anchor
    reach = np.linalg.norm(points - np.outer(points @ body.joint.axis, body.joint.axis), axis=1).max()
    end, dof, worst = 0.9 * max(body.joint.limits, key=abs), joint.dofadr[0], 0.0
    for k in range(round(seconds / model.opt.timestep)):
        time, axis = k * model.opt.timestep, data.xaxis[joint.id]
        speed = end / (0.75 * seconds) if time < 0.75 * seconds else 0.0
        out = data.xipos[lid] - data.xanchor[joint.id]
        out -= axis * (out @ axis)
        weight = body.mass * 9.81
        off = end * min(1.0, time / (0.75 * seconds)) - data.qpos[joint.qposadr[0]]
        pull = -weight * out @ np.cross(axis, [0, 0, 1]) + body.joint.hold * (np.sign(speed) + speed)
        pull += weight * reach * (2 * off + 0.3 * (speed - data.qvel[dof]))
        edge = out / np.linalg.norm(out) * reach
        data.qfrc_applied[:] = 0.0
        at = data.xanchor[joint.id] + edge
        mujoco.mj_applyFT(model, data, np.cross(pull * axis, edge) / reach**2, np.zeros(3), at, lid, data.qfrc_applied)
        mujoco.mj_step(model, data)
        worst = max(worst, float(np.linalg.norm(data.body("t").xpos - start)))
    return worst, float(data.qpos[joint.qposadr[0]] / end * 0.9)


def like(points: np.ndarray, solid: Solid) -> Solid:
    return solid_of(points, solid.link, solid.handle)


def deepest(scene: Scene, load) -> float:
    """How far [m] two bodies reach into each other at the start, at most."""
    model = mujoco.MjModel.from_xml_string(build(scene, load).xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return -min((c.dist for c in data.contact[: data.ncon]), default=0.0)


@pytest.mark.parametrize(
    ("category", "seed", "size"),
    [
        ("plate_stack", 0, None),
        ("plate_stack", 1, None),
        ("fruit_bowl", 0, (0.26, 0.28, 0.14)),
        ("book_stack", 0, None),
    ],
)
def test_nothing_begins_inside_another(category, seed, size):
    asset = make(category, seed)
    pose, support = Pose.from_yaw(2, 2, 0.5, 0.3), Support(object="table", surface="s")
    thing = asset.object("t", pose=pose, support=support)
    if size is not None:
        thing = thing.model_copy(update={"size": size})
    assert deepest(Scene(id="x", room=ROOM, objects=(TABLE, thing)), {asset.id: asset}.__getitem__) < 1e-5


@pytest.mark.parametrize("category", ["music_box", "jewelry_box", "laundry_hamper", "pedal_bin"])
def test_a_box_stays_where_it_is_when_its_lid_is_opened(category):
    moved, share = opened_by_hand(category)
    assert moved < 0.002 and share == pytest.approx(0.9, abs=0.05)


def test_no_lid_weighs_more_than_a_quarter_of_its_box():
    asset = make("jewelry_box", 0)
    assert asset.masses[1] > asset.masses[0], "as drawn: a board with a mirror on a hollow box"
    pose, support = Pose.from_yaw(2, 2, 0.5, 0.0), Support(object="table", surface="s")
    scene = Scene(id="x", room=ROOM, objects=(TABLE, asset.object("t", pose=pose, support=support)))
    base, lid = things_of(scene, {asset.id: asset}.__getitem__)[1].bodies
    assert lid.mass == pytest.approx(asset.mass / 4) and base.mass + lid.mass == pytest.approx(asset.mass)


def test_a_part_is_cut_where_it_reaches_into_another():
    box = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    base, loose = solid_of(box, 0), solid_of(box + [0.2, 0.2, 0.9], 1)
    same, other = cut_apart([base, loose], {1}, like)
    assert same is base and other.points[:, 2].min() == pytest.approx(1.0, abs=1e-5), "the loose one gives way"
    assert other.box is not None and other.points[:, 2].max() == pytest.approx(1.9)
    one, two = cut_apart([solid_of(box, 1), solid_of(box + [0, 0, 0.9], 2)], {1, 2}, like)
    assert one.points[:, 2].max() == pytest.approx(0.95, abs=1e-5) == two.points[:, 2].min() - 0.0
    whole = [solid_of(box, 0), solid_of(box * 0.5 + 0.25, 1)]
    assert cut_apart(whole, {1}, like) == whole, "what is inside was meant to be there"
    assert cut_apart([base, loose], (), like) == [base, loose], "links on hinges are as they are"
