import numpy as np
import pytest

from sceneweaver.assets.body import Grasp
from sceneweaver.assets.parametric import make, makers
from tests.assets.grasps import crosses, faults_of, grasp_faults

SOME = ("fridge", "kitchen_counter", "tallboy", "washing_machine", "toilet", "locker", "pedal_bin", "safe")


@pytest.mark.parametrize("name", SOME)
def test_a_gripper_takes_hold_of_doors_drawers_and_lids(name):
    asset = make(name, 0)
    assert asset.grasps
    assert not list(faults_of(asset))


@pytest.mark.slow
def test_a_gripper_takes_hold_of_all():
    faults = [
        f"{name} {seed}: {f}" for name in sorted(makers()) for seed in range(3) for f in faults_of(make(name, seed))
    ]
    assert not faults


def test_bad_grasps_are_told():
    fridge = make("fridge", 0)
    good = next(g for g in fridge.grasps if g.name == "bar")
    assert not list(grasp_faults(fridge, good))
    x, y, z = good.position
    changed = {
        "collision part": Grasp("bar", good.link, (x - 0.03, y, z), *_rest(good)),  # fingers in the door
        "out of the middle": Grasp("bar", good.link, (x, y + 0.008, z), *_rest(good)),
        "between the fingers": Grasp("bar", good.link, (x + 0.1, y, z), *_rest(good)),
        "in the floor": Grasp("bar", good.link, (x, y, 0.005), *_rest(good)),
        "closes to": Grasp("bar", good.link, good.position, good.approach, good.closing, 0.05, good.length),
        "wide": Grasp("bar", good.link, good.position, good.approach, good.closing, 0.09, good.length),
    }
    for words, grasp in changed.items():
        assert any(words in fault for fault in grasp_faults(fridge, grasp)), words


def test_triangles_cross_a_box_or_do_not():
    low, high = np.zeros(3), np.ones(3)
    through = np.array([[[-9.0, 0.5, 0.5], [9.0, 0.6, 0.5], [9.0, 0.5, 0.6]]])  # no corner of it is in the box
    past_the_corner = np.array([[[1.9, 0.0, 0.5], [0.0, 2.2, 0.5], [2.5, 2.5, 0.5]]])  # their bounds overlap
    assert crosses(through, low, high)
    assert not crosses(past_the_corner, low, high)


def _rest(grasp):
    return grasp.approach, grasp.closing, grasp.width, grasp.length
