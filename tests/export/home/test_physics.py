"""Homes in MuJoCo: every door opens, things stay, and nothing falls through floors or walls."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.export.home.built import BuiltHome
from sceneweaver.export.home.mjcf import home_mjcf
from sceneweaver.home import Home
from sceneweaver.physics import Model
from sceneweaver.physics.model import assemble
from tests.clients.doors import opened
from tests.export.home.homes import flat, house, load, slanted

mujoco: Any = import_module("mujoco")


def compiled(home: Home) -> Any:
    """Collision parts only."""
    built = BuiltHome.of(home, load)
    made: Model = assemble(built.enclosure(), built.things)
    return mujoco.MjModel.from_xml_string(made.xml)


@pytest.mark.parametrize("home", [flat, house, slanted], ids=["flat", "house", "slanted"])
def test_every_door_opens(home) -> None:
    found = opened(compiled(home()), "home:door:")
    doors = [d for d in home().doors if d.kind != "open"]
    assert len(found) == len(doors) + sum(d.kind == "double" for d in doors)
    for name, (at, end, touched) in found.items():
        assert at > 0.98 * end, (name, touched)
        assert touched == []
    hinged = [f"home:door:{d.id}" for d in doors if d.kind == "hinged"]
    assert all(found[name][1] == pytest.approx(math.pi / 2, abs=1e-3) for name in hinged)


def test_a_door_that_something_stands_before_does_not_open() -> None:
    """The measure sees what is in the way."""
    home = flat()
    scene = home.room("hall").scene
    assert scene is not None
    crate = scene.objects[0]
    there = crate.pose.model_copy(update={"position": (5.5, 0.7, 0.0)})
    blocked = scene.model_copy(update={"objects": (crate.model_copy(update={"pose": there, "fixed": True}),)})
    found = opened(compiled(home.with_scene("hall", blocked)), "home:door:front-door")
    ((at, end, touched),) = found.values()
    assert at < 0.9 * end
    assert touched == ["hall:crate"]


@pytest.mark.parametrize("shape", ["straight", "u"])
def test_things_stay_on_both_storeys(shape) -> None:
    model = compiled(house(shape))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = data.xipos.copy()
    mujoco.mj_step(model, data, 500)
    assert np.linalg.norm(data.xipos - before, axis=1).max() < 2e-3


def test_cubes_come_to_rest_on_floors_steps_and_balconies() -> None:
    """Cubes dropped all over a house come to rest on what is below them."""
    home = house()
    built = BuiltHome.of(home, load)
    spec = mujoco.MjSpec.from_string(assemble(built.enclosure(), []).xml)
    places = {
        "hall": (3.0, 2.0, 0.3),
        "bedroom": (3.0, 2.0, 3.3),
        "balcony": (6.4, 1.5, 3.3),
        "landing": (0.8, 4.8, 3.3),
    }
    places["tread"] = (0.8, 0.3 + 5.5 * 0.25, 6 * 3.0 / 16 + 0.3)
    for name, at in places.items():
        cube = spec.worldbody.add_body(name=name, pos=at)
        cube.add_freejoint()
        cube.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[0.05, 0.05, 0.05])
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 400)
    for name, at in places.items():
        height = data.body(name).xpos[2]
        assert height == pytest.approx(at[2] - 0.25, abs=2e-3), name


def test_the_file_for_robots_of_others_has_no_slashes() -> None:
    """dm_control keeps "/" for itself; the names of homes are without it."""
    xml = home_mjcf(BuiltHome.of(flat(), load), textures=False).xml
    assert 'name="bedroom:desk"' in xml
    assert not [line for line in xml.splitlines() if 'name="' in line and "/" in line.split('name="')[1].split('"')[0]]
