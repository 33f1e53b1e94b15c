import pytest

from sceneweaver.assets.parametric import make, makers
from sceneweaver.physics.things import things_of
from sceneweaver.scene import Pose, Scene
from tests.assets.items import ROOM, faults_of


@pytest.mark.parametrize("name", ["book_stack", "cup_and_saucer", "cutlery_set"])
def test_what_lies_in_things_rests_where_it_is_drawn(name):
    asset = make(name, 1)
    assert any(link.role == "item" and link.joint == "free" for link in asset.links)
    assert not list(faults_of(asset))


@pytest.mark.slow
def test_all_that_lies_in_things_rests_where_it_is_drawn():
    assets = [make(name, seed) for name in sorted(makers()) for seed in range(2)]
    loose = [asset for asset in assets if any(link.joint == "free" for link in asset.links)]
    assert len(loose) > 20
    assert not [f"{asset.id}: {fault}" for asset in loose for fault in faults_of(asset)]


def test_welded_things_are_one_body():
    bowl = make("fruit_bowl", 0)
    scene = Scene(id="s", room=ROOM, objects=(bowl.object("o", pose=Pose.from_yaw(0, 0, 0, 0), mount="floor"),))
    load = {bowl.id: bowl}.__getitem__
    (loose,), (welded,) = things_of(scene, load), things_of(scene, load, loose=False)
    assert len(loose.bodies) == 1 + len(bowl.links)
    assert len(welded.bodies) == 1
    assert sum(b.mass for b in loose.bodies) == pytest.approx(welded.bodies[0].mass, rel=1e-6)
