"""USD: up axes, units, row vectors, instances and nesting; our own export comes back."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.export.usd import write_usd
from tests.importers.reading import compass, require_error, require_pose, rooms_of, things_of, written

# centimetres, y up, (x, y, z) becomes (x, -z, y) / 100; kinds, an instance, a scale, a turn about y
Y_UP = """#usda 1.0
(
    defaultPrim = "World"
    metersPerUnit = 0.01
    upAxis = "Y"
)
def Xform "World" (kind = "assembly")
{
    def Xform "Floor" (kind = "component")
    {
        def Mesh "m" { point3f[] points = [(-100, 0, -200), (300, 0, -200), (300, 0, 150), (-100, 0, 150)]; }
    }
    def Xform "Group" (kind = "group")
    {
        double3 xformOp:translate = (20, 0, -30)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        def Xform "Desk_01" (kind = "component")
        {
            double3 xformOp:translate = (100, 0, 50)
            float xformOp:rotateY = 30
            float3 xformOp:scale = (2, 1, 0.5)
            uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateY", "xformOp:scale"]
            def Mesh "m" { point3f[] points = [(-30, 0, -60), (50, 0, -60), (50, 74, 40), (-30, 74, 40)]; }
            def Sphere "hidden" { token visibility = "invisible"; double radius = 500; }
            def Cube "guide" { uniform token purpose = "guide"; double size = 900; }
        }
    }
    def "Lamp" (
        kind = "component"
        instanceable = true
        references = </Prototype>
    )
    {
        double3 xformOp:translate = (-50, 70, 80)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
}
def Xform "Prototype"
{
    token[] semantics:labels:class = ["table_lamp"]
    def Cylinder "c" { double radius = 10; double height = 40; uniform token axis = "Y"; }
}
"""

# metres, z up, no kinds, everything below one prim; a model turned from y up to z up within itself
Z_UP = """#usda 1.0
(
    defaultPrim = "Root"
    metersPerUnit = 1
    upAxis = "Z"
)
def Xform "Root"
{
    def Xform "scene"
    {
        def Scope "Furniture"
        {
            def Xform "sofa"
            {
                double3 xformOp:translate = (1, 2, 0)
                float xformOp:rotateZ = -68.75493541569878
                uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
                def Cube "a" { double size = 1; double3 xformOp:translate = (0.1, 0.2, 0.5);
                    uniform token[] xformOpOrder = ["xformOp:translate"]; }
                def Cube "b" { double size = 1; double3 xformOp:translate = (0.6, 0.2, 0.5);
                    uniform token[] xformOpOrder = ["xformOp:translate"]; }
            }
            def Xform "chair"
            {
                double3 xformOp:translate = (-1, 0.5, 0)
                float xformOp:rotateX = 90
                uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateX"]
                def Mesh "m" { point3f[] points = [(-0.2, 0, -0.3), (0.25, 0.9, 0.2)]; }
            }
        }
        def Mesh "Wall_1" { point3f[] points = [(-3, -2, 0), (-3, 3, 0), (-2.9, 3, 2.5), (-2.9, -2, 2.5)]; }
        def Mesh "Wall_2" { point3f[] points = [(4, -2, 0), (4, 3, 0), (4.2, 3, 2.5), (4.2, -2, 2.5)]; }
        def Mesh "Wall_3" { point3f[] points = [(-3, -2, 0), (4, -2, 0), (4, -1.8, 2.5), (-3, -1.8, 2.5)]; }
        def Mesh "Wall_4" { point3f[] points = [(-3, 3, 0), (4, 3, 0), (4, 3.1, 2.5), (-3, 3.1, 2.5)]; }
    }
}
"""


def test_y_up_in_centimetres(tmp_path):
    (room,) = rooms_of("usd", written(tmp_path, "a.usda", Y_UP)).values()
    things = things_of(room)
    assert set(things) == {"Desk_01", "Lamp"} and things["Lamp"].label == "table_lamp"
    np.testing.assert_allclose(room.outline, [(-1, -1.5), (3, -1.5), (3, 2), (-1, 2)], atol=1e-6)
    # the desk: its +z, which is -y of ours, is its front; scaled it is 0.5 m deep, 1.6 m wide, 0.74 m high
    a = math.radians(30) - math.pi / 2
    front, left = np.array(compass(a)), np.array(compass(a + math.pi / 2))
    # +x of the model is to the left of its front; its middle is 0.2 m to the left and 0.05 m behind
    middle = np.array((1.2, -0.2, 0.37)) + 0.2 * left - 0.05 * front
    require_pose(things["Desk_01"], middle, front)
    np.testing.assert_allclose(things["Desk_01"].size, (0.5, 1.6, 0.74), atol=1e-6)
    require_pose(things["Lamp"], (-0.5, -0.8, 0.7), (0, -1, 0))
    np.testing.assert_allclose(things["Lamp"].size, (0.2, 0.2, 0.4), atol=1e-6)


def test_no_kinds(tmp_path):
    (room,) = rooms_of("usd", written(tmp_path, "b.usda", Z_UP)).values()
    things = things_of(room)
    assert set(things) == {"sofa", "chair"}
    np.testing.assert_allclose(room.outline, [(-2.9, -1.8), (4, -1.8), (4, 3), (-2.9, 3)], atol=1e-6)
    assert room.height == pytest.approx(2.5)
    c, s = math.cos(-1.2), math.sin(-1.2)
    require_pose(things["sofa"], (1 + c * 0.35 - s * 0.2, 2 + s * 0.35 + c * 0.2, 0.5), compass(-1.2))
    np.testing.assert_allclose(things["sofa"].size, (1.5, 1.0, 1.0), atol=1e-6)
    # y of the chair is up: z of it points to -y of the room
    require_pose(things["chair"], (-1 + 0.025, 0.5 + 0.05, 0.45), (1, 0, 0))
    np.testing.assert_allclose(things["chair"].size, (0.45, 0.5, 0.9), atol=1e-6)


@pytest.mark.parametrize("suffix", ["usda", "usdc"])
def test_what_we_write_comes_back(tmp_path, suffix):
    scene = sw.Scene.example("bedroom")
    path = tmp_path / f"scene.{suffix}"
    write_usd(scene, path, lambda asset: pytest.fail(asset), textures=False)
    (back,) = sw.read_scenes(path, assets="boxes", relations=False)
    np.testing.assert_allclose(back.scene.room.outline, scene.room.outline, atol=1e-6)
    assert back.scene.room.height == pytest.approx(scene.room.height)
    assert back.scene.room.type == scene.room.type and back.scene.prompt == scene.prompt
    assert {o.id for o in back.scene.objects} == {o.id for o in scene.objects}
    for thing in scene.objects:
        other = back.scene.object(thing.id)
        np.testing.assert_allclose(other.pose.position, thing.pose.position, atol=1e-5, err_msg=thing.id)
        assert abs(math.remainder(other.pose.yaw - thing.pose.yaw, 2 * math.pi)) < 1e-5
        np.testing.assert_allclose(other.size, thing.size, atol=1e-5, err_msg=thing.id)
        assert (other.support and other.support.object) == (thing.support and thing.support.object)
    for kind in ("doors", "windows"):
        for a, b in zip(getattr(scene.room, kind), getattr(back.scene.room, kind), strict=True):
            assert a.wall == b.wall and a.height == pytest.approx(b.height, abs=1e-5)
            np.testing.assert_allclose((a.offset, a.width), (b.offset, b.width), atol=1e-5)


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (Y_UP[:700], ("damaged",)),
        ("", ()),
        ("#usda 1.0\n", ("neither an outline nor an object",)),
        (Y_UP.replace("(100, 0, 50)", "(100, nan, 50)"), ("Desk_01", "not finite")),
        (Y_UP.replace("</Prototype>", "@../../../../../../../../etc/passwd@"), ("outside",)),
        (Y_UP.replace("(-30, 0, -60), (50", "(-30, 0), (50"), ("damaged",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "broken.usda", broken), "usd", *words)
