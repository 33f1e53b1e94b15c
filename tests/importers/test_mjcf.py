"""MJCF: boxes of bodies along their own axes, groups, robots, rooms from walls; our own export comes back."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.assets import Library
from sceneweaver.export.mjcf import write_mjcf
from tests.importers.reading import compass, require_error, require_pose, rooms_of, things_of, written

SCENE = """<mujoco model="a">
 <compiler angle="radian"/>
 <asset><mesh name="slab" vertex="-0.5 0 -0.2  0.7 0 -0.2  -0.5 1.4 -0.2  -0.5 0 0.1  0.7 1.4 0.1"/></asset>
 <worldbody>
  <geom name="floor" type="plane" size="5 5 0.1"/>
  <geom type="box" size="2.5 0.05 1.3" pos="0.5 -2.05 1.3"/>
  <geom name="wall_north" type="box" size="2.6 0.1 1.3" pos="0.5 1.5 1.3"/>
  <body name="wall_east" pos="3.1 0 1.3"><geom type="box" size="0.1 2 1.3"/></body>
  <body name="wall_west" pos="-1.85 0 1.3" euler="0 0 3.14159265"><geom type="box" size="0.05 2 1.3"/></body>
  <body name="window_1" pos="3.05 0.4 1.5"><geom type="box" size="0.04 0.6 0.5"/></body>
  <body name="bed" pos="1.1 -0.4 0.2" euler="0 0 0.3">
   <freejoint/>
   <geom type="box" size="0.9 0.6 0.1" pos="0.2 0.1 -0.1"/>
   <geom type="sphere" size="0.05" pos="-0.7 0.7 0.35"/>
  </body>
  <body name="furniture" pos="1 0.5 0">
   <body name="desk_1" pos="-2 -0.5 0" euler="0 0 -1.2">
    <geom type="box" size="0.35 0.7 0.37" pos="0 0 0.37"/>
    <body name="drawer" pos="0.35 0 0.5"><joint type="slide" axis="1 0 0"/><geom type="box" size="0.01 0.3 0.1"/></body>
   </body>
   <body name="lamp" pos="1.0 -1.9 0"><geom type="cylinder" size="0.1 0.6" pos="0 0 0.6"/></body>
  </body>
  <body name="cabinet" pos="0.4 0.9 0" quat="0.70710678 0.70710678 0 0"><geom type="mesh" mesh="slab"/></body>
  <body name="robot0_base" pos="0 0 0"><geom type="box" size="0.1 0.1 0.1" pos="0 0 0.1"/></body>
  <body name="arm" pos="0 -1 0"><geom type="box" size="0.1 0.1 0.1" pos="0 0 0.1"/>
   <body name="l1" pos="0 0 0.3"><joint name="a" type="hinge"/><geom type="box" size="0.05 0.05 0.1"/>
    <body name="l2" pos="0 0 0.3"><joint name="b" type="hinge"/><geom type="box" size="0.05 0.05 0.1"/>
     <body name="l3" pos="0 0 0.3"><joint name="c" type="hinge"/><geom type="box" size="0.05 0.05 0.1"/></body>
   </body></body></body>
 </worldbody>
 <actuator><motor joint="a"/><motor joint="b"/><motor joint="c"/></actuator>
</mujoco>"""


def test_any_model(tmp_path):
    (room,) = rooms_of("mjcf", written(tmp_path, "a.xml", SCENE)).values()
    things = things_of(room)
    assert set(things) == {"bed", "desk_1", "lamp", "cabinet"}
    assert any("robot0_base" in note and "arm" in note for note in room.notes)
    # inner faces: x from -1.8 to 3.0, y from -2.0 to 1.4
    np.testing.assert_allclose(room.outline, [(-1.8, -2.0), (3.0, -2.0), (3.0, 1.4), (-1.8, 1.4)], atol=1e-6)
    assert room.height == pytest.approx(2.6)
    (window,) = room.openings
    assert window.kind == "window" and {round(window.start[1], 6), round(window.end[1], 6)} == {-0.2, 1.0}
    assert (window.bottom, window.height) == (pytest.approx(1.0), pytest.approx(1.0))
    # bed: x -0.75 .. 1.1, y -0.5 .. 0.75, z -0.2 .. 0.4 about the body
    c, s = math.cos(0.3), math.sin(0.3)
    mx, my = 0.175, 0.125
    require_pose(things["bed"], (1.1 + c * mx - s * my, -0.4 + s * mx + c * my, 0.3), compass(0.3))
    np.testing.assert_allclose(things["bed"].size, (1.85, 1.25, 0.6), atol=1e-6)
    # desk: its drawer reaches 1 cm beyond its front
    c, s = math.cos(-1.2), math.sin(-1.2)
    require_pose(things["desk_1"], (-1 + c * 0.005, s * 0.005, 0.37), compass(-1.2))
    np.testing.assert_allclose(things["desk_1"].size, (0.71, 1.4, 0.74), atol=1e-6)
    require_pose(things["lamp"], (2.0, -1.4, 0.6), (1, 0, 0))
    # cabinet: y of its mesh is up, so x stays its front; z of the mesh points to -y of the room
    require_pose(things["cabinet"], (0.5, 0.95, 0.7), (1, 0, 0))
    np.testing.assert_allclose(things["cabinet"].size, (1.2, 0.3, 1.4), atol=1e-6)


def test_what_we_write_comes_back(tmp_path):
    scene = sw.Scene.example("bedroom")
    path = write_mjcf(scene, tmp_path / "out", lambda asset: pytest.fail(asset))
    (back,) = sw.read_scenes(path, assets="boxes", relations=False)
    np.testing.assert_allclose(back.scene.room.outline, scene.room.outline, atol=1e-6)
    assert back.scene.room.height == pytest.approx(scene.room.height)
    assert {o.id for o in back.scene.objects} == {o.id for o in scene.objects}
    for thing in scene.objects:
        other = back.scene.object(thing.id)
        np.testing.assert_allclose(other.pose.position, thing.pose.position, atol=1e-5, err_msg=thing.id)
        assert abs(math.remainder(other.pose.yaw - thing.pose.yaw, 2 * math.pi)) < 1e-5
        np.testing.assert_allclose(other.size, thing.size, atol=1e-5, err_msg=thing.id)
    for kind in ("doors", "windows"):
        mine, theirs = getattr(scene.room, kind), getattr(back.scene.room, kind)
        for a, b in zip(mine, theirs, strict=True):
            assert a.wall == b.wall and a.height == pytest.approx(b.height, abs=1e-5)
            np.testing.assert_allclose((a.offset, a.width), (b.offset, b.width), atol=1e-5)


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (SCENE[:900], ("damaged XML",)),
        ("", ("damaged XML",)),
        ("<mujoco><worldbody><body><geom type='ball'/></body></worldbody></mujoco>", ("MuJoCo refuses",)),
        (SCENE.replace('pos="1.1 -0.4 0.2"', 'pos="1.1 nan 0.2"'), ()),
        (SCENE.replace("<asset>", '<asset><mesh name="x" file="../../../etc/passwd"/>'), ("outside",)),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]>" + SCENE, ("DOCTYPE",)),
        ("<mujoco/>", ("neither an outline nor an object",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "broken.xml", broken), "mjcf", *words)


def test_our_furniture_comes_back_whole(tmp_path):
    """Drawers, doors and what can be taken off belong to their piece; hulls that bulge do not make it larger."""
    scene = sw.Scene.example("bedroom")
    drawn = {}
    for name, category in (("books", "book_stack"), ("dresser", "dresser"), ("armchair", "armchair")):
        thing = scene.object(name)
        asset = Library().load(f"parametric:{category}?seed=0&size={','.join(f'{v:g}' for v in thing.size)}")
        drawn[name] = thing.model_copy(update={"asset": asset.id, "size": asset.size, "parts": asset.parts})
    scene = scene.model_copy(update={"objects": tuple(drawn.get(o.id, o) for o in scene.objects)})
    path = write_mjcf(scene, tmp_path / "out", textures=False)
    (back,) = sw.read_scenes(path, assets="boxes", relations=False)
    assert {o.id for o in back.scene.objects} == {o.id for o in scene.objects}
    for name, thing in drawn.items():
        other = back.scene.object(name)
        np.testing.assert_allclose(other.pose.position, thing.pose.position, atol=1e-5, err_msg=name)
        np.testing.assert_allclose(other.size, thing.size, atol=1e-5, err_msg=name)
