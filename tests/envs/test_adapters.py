"""Rooms for others' environments: what is read, and what is said where their libraries are missing."""

from __future__ import annotations

import importlib.util

import pytest

from sceneweaver.envs.adapters.isaac_lab import scene_cfg
from sceneweaver.envs.adapters.maniskill import register, room_files
from sceneweaver.export.urdf import room_urdf
from sceneweaver.scene import InputError, MissingDependencyError
from tests.envs.rooms import kitchen, load


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    folder = tmp_path_factory.mktemp("room")
    for name, content in room_urdf(kitchen(), load).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return folder


def test_files_of_a_room_are_found(room):
    rows = room_files(room)
    assert {row["name"] for row in rows} >= {o.id for o in kitchen().objects}
    with pytest.raises(InputError, match="rooms: .*scene.urdf.json is not there"):
        room_files(room / "urdf")


@pytest.mark.skipif(importlib.util.find_spec("mani_skill") is not None, reason="ManiSkill is here")
def test_maniskill_is_named_where_it_is_missing(room):
    with pytest.raises(MissingDependencyError, match="pip install mani_skill"):
        register([room])


@pytest.mark.skipif(importlib.util.find_spec("isaaclab") is not None, reason="Isaac Lab is here")
def test_isaac_lab_is_named_where_it_is_missing(room):
    with pytest.raises(MissingDependencyError, match="Isaac Lab is not there"):
        scene_cfg([room / "scene.urdf.json"], 2)
    with pytest.raises(InputError, match="rooms: .*none.usdc is not there"):
        scene_cfg([room / "none.usdc"], 2)
