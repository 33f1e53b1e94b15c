"""Things that lie in or on each other begin where they touch."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.physics import build
from sceneweaver.physics.nested import cut_apart
from sceneweaver.physics.solids import Solid, solid_of
from sceneweaver.scene import Pose, Room, Scene, SceneObject, Support, Surface

ROOM = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)))
TOP = Surface(name="s", polygon=((-0.7, -0.7), (0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)), z=0.5)
TABLE = SceneObject(
    id="table", category="block", size=(1.5, 1.5, 0.5), pose=Pose.from_yaw(2, 2, 0.0, 0.0), surfaces=(TOP,)
)


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
    [("plate_stack", 0, None), ("plate_stack", 1, None), ("fruit_bowl", 0, (0.26, 0.28, 0.14)), ("book_stack", 0, None)],
)
def test_nothing_begins_inside_another(category, seed, size):
    asset = make(category, seed)
    pose, support = Pose.from_yaw(2, 2, 0.5, 0.3), Support(object="table", surface="s")
    thing = asset.object("t", pose=pose, support=support)
    if size is not None:
        thing = thing.model_copy(update={"size": size})
    assert deepest(Scene(id="x", room=ROOM, objects=(TABLE, thing)), {asset.id: asset}.__getitem__) < 1e-5


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
