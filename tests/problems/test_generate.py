"""The generator keeps what it promises: size, tightness, density, a witness; and says so where it can not."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver import problems
from sceneweaver.problems.measures import tightness_of
from sceneweaver.problems.recipes import RECIPES
from sceneweaver.scene import InputError, Scene

EASY = {"packing": (9, 0.6), "walls": (9, 0.5), "relations": (9, 0.3), "rooms": (12, 0.4), "bodies": (9, 0.5)}
EASY |= {"groups": (12, 0.4), "surfaces": (16, 0.5), "halls": (60, 0.4), "preferences": (9, 0.4)}


@pytest.mark.parametrize("family", RECIPES)
@pytest.mark.parametrize("seed", [11, 12])
def test_every_family_makes_verified_problems_of_the_size_and_tightness_asked_for(family, seed):
    objects, tightness = EASY[family]
    case = problems.generate(family, objects, tightness, seed)
    problems.verify(case)
    assert len(case.scene.objects) == objects
    assert tightness_of(case.layout(case.witness)) == pytest.approx(tightness, abs=0.01)


@pytest.mark.parametrize("tightness", [0.2, 0.4, 0.6, 0.8])
def test_tightness_goes_up_and_down(tightness):
    case = problems.generate("packing", 15, tightness, seed=2)
    assert case.facts["tightness"] == pytest.approx(tightness, abs=0.01)


def test_tightness_is_what_it_is_said_to_be():
    box = {"id": "a", "category": "box", "size": [1, 2, 1], "pose": {"position": [2, 2, 0]}}
    zone = {"name": "front", "polygon": [[0.5, -1], [1.0, -1], [1.0, 1], [0.5, 1]], "z": [0, 1], "hard": True}
    door = {"id": "d", "wall": 0, "offset": 0.0, "width": 1.0, "height": 2.0}
    room = {"type": "room", "outline": [[0, 0], [4, 0], [4, 4], [0, 4]], "doors": [door]}
    data = {"schema": "sceneweaver.scene/1", "id": "s", "room": room, "objects": [{**box, "zones": [zone]}]}
    assert tightness_of(Scene.from_json(data)) == pytest.approx((2 + 1) / (16 - 1))


@pytest.mark.parametrize("density", [0.5, 1.5, 3.0])
def test_density_is_the_number_of_hard_relations_an_object(density):
    case = problems.generate("relations", 12, 0.3, seed=4, density=density)
    assert case.facts["density"] == pytest.approx(density, abs=0.05)
    problems.verify(case)


def test_equal_arguments_give_equal_problems_and_another_seed_another_one():
    one, same, other = (problems.generate("bodies", 10, 0.5, seed=s) for s in (1, 1, 2))
    assert one.hash == same.hash != other.hash
    assert np.array_equal(one.witness, same.witness)


def test_a_room_has_the_shape_asked_for():
    corners = {shape: problems.generate("rooms", 12, 0.4, 3, shape=shape).scene.room.outline for shape in "LTUS"}
    assert {shape: len(c) for shape, c in corners.items()} == {"L": 6, "T": 8, "U": 8, "S": 8}


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"family": "boxes"}, "family: 'boxes'"),
        ({"family": "packing", "objects": 1}, "objects: 1"),
        ({"family": "packing", "objects": 1001}, "objects: 1001"),
        ({"family": "packing", "tightness": 0.95}, "tightness: 0.95"),
        ({"family": "packing", "tightness": float("nan")}, "tightness: nan"),
        ({"family": "packing", "seed": -1}, "seed: -1"),
        ({"family": "packing", "density": 11}, "density: 11"),
        ({"family": "packing", "shape": "heart"}, "shape: 'heart'"),
        ({"family": "walls", "shape": "L"}, "shape: 'L'"),
        ({"family": "walls", "objects": 60, "tightness": 0.88}, "try a lower one"),
    ],
)
def test_bad_input_is_one_line(arguments, text):
    with pytest.raises(InputError, match=text) as error:
        problems.generate(**arguments)
    assert "\n" not in str(error.value)
