"""Infinigen: plans whose shapes are expressions that are never evaluated, and the solver's state."""

from __future__ import annotations

import builtins
import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import (
    changed,
    compass,
    require_error,
    require_pose,
    rooms_of,
    things_of,
    without,
    written,
)

PLAN = {
    "rooms": {
        "dining-room_0/0": {"shape": "shapely.Polygon([(0, 0), (7, 0), (7, 2), (2.5, 7), (0, 7)])"},
        "kitchen_0/0": {"shape": "shapely.box(-2.5, 0, 0, 6)"},
    },
    "doors": {
        "door": {"shape": "shapely.LineString([(0, 4.1), (0, 5)])"},
        "door.001": {"shape": "shapely.LineString([(1, 0), (2.5, 0)])"},
    },
    "opens": {"open": {"shape": "shapely.LineString([(7, 2), (2.5, 7), (1, 7)])"}},
    "windows": {
        "window": {"shape": "shapely.LineString([(7, 0.5), (7, 1.4)])"},
        "window.001": {"shape": "shapely.LineString([(-2, 0), (-0.5, 0)])", "is_panoramic": 1},
    },
}


def as_data(plan):
    """The same plan as the JSON of the project has it: operations with arguments."""
    box = {"operation": "shapely.box", "args": [-2.5, 0, 0, 6]}
    polygon = {"operation": "shapely.Polygon", "args": [[[0, 0], [7, 0], [7, 2], [2.5, 7], [0, 7]]]}
    lines = {
        "door": [[0, 4.1], [0, 5]],
        "door.001": [[1, 0], [2.5, 0]],
        "open": [[7, 2], [2.5, 7], [1, 7]],
        "window": [[7, 0.5], [7, 1.4]],
        "window.001": [[-2, 0], [-0.5, 0]],
    }
    data = {"rooms": {"dining-room_0/0": polygon, "kitchen_0/0": box}}
    for key in ("doors", "opens", "windows"):
        data[key] = {n: {"operation": "shapely.LineString", "args": [lines[n]]} for n in plan[key]}
    data["windows"]["window.001"]["is_panoramic"] = 1
    return data


@pytest.mark.parametrize("form", [lambda plan: plan, as_data], ids=["text", "data"])
def test_a_plan(tmp_path, form):
    rooms = rooms_of("infinigen-plan", written(tmp_path, "predefined.json", form(PLAN)))
    dining, kitchen = rooms["dining-room_0/0"], rooms["kitchen_0/0"]
    assert dining.outline == ((0, 0), (7, 0), (7, 2), (2.5, 7), (0, 7))
    assert kitchen.outline == ((-2.5, 0), (0, 0), (0, 6), (-2.5, 6))
    assert (dining.type, kitchen.type) == ("dining-room", "kitchen")
    found = {o.name: o for o in dining.openings}
    assert set(found) == {"door", "door.001", "open", "open.1", "window"}
    assert (found["door"].start, found["door"].end, found["door"].leads_to) == ((0, 4.1), (0, 5), "kitchen_0/0")
    assert (found["open"].kind, found["open"].start, found["open"].end) == ("passage", (7, 2), (2.5, 7))
    assert (found["open.1"].start, found["open.1"].end, found["open.1"].leads_to) == ((2.5, 7), (1, 7), None)
    assert (found["window"].kind, found["window"].bottom) == ("window", 0.9)
    theirs = {o.name: o for o in kitchen.openings}
    assert set(theirs) == {"door", "window.001"}
    assert theirs["window.001"].bottom == 0.0


def test_rooms_become_empty_scenes(tmp_path):
    made = list(sw.read_scenes(written(tmp_path, "predefined.json", PLAN)))
    assert [(len(m.scene.objects), len(m.scene.room.doors), len(m.scene.room.windows)) for m in made] == [
        (0, 4, 1),
        (0, 1, 1),
    ]


@pytest.mark.parametrize(
    "expression",
    [
        "shapely.box(-2.5,0,0,6)",
        "  box( -2.5 , 0.0, 0, 6e0 ) ",
        "shapely.geometry.box(-2.5, 0, 0, 6,)",
        "Polygon([[-2.5, 0], (0, 0), (0, 6), [-2.5, 6], (-2.5, 0)])",
    ],
)
def test_ways_to_write_a_shape(tmp_path, expression):
    plan = {"rooms": {"kitchen": expression}}
    (room,) = rooms_of("infinigen-plan", written(tmp_path, "plan.json", plan)).values()
    assert room.outline == ((-2.5, 0), (0, 0), (0, 6), (-2.5, 6))


@pytest.mark.parametrize(
    "expression",
    [
        "__import__('os').system('touch pwned')",
        "shapely.box(0, 0, open('x'), 4)",
        "shapely.box(0, 0, 2**9, 4)",
        "shapely.box(0, 0, 5, 4); 1",
        "shapely.box(0, 0, 5, 4).buffer(1)",
        "shapely.box(*[0, 0, 5, 4])",
        "shapely.box(0, 0, 5",
        "shapely.box(0 0 5 4)",
        "shapely.box(5, 4, 0, 0)",
        "shapely.Point(0, 0)",
        "shapely.Polygon([(0, 0), (1, 1)])",
        "shapely.LineString([(0, 0), (1, 1)])",
        "lambda: 0",
        "(" * 400,
        "shapely.Polygon(" + "[" * 400 + "]" * 400 + ")",
        "shapely.box(1e999, 0, 5, 4)",
        "",
    ],
)
def test_nothing_is_evaluated(tmp_path, monkeypatch, expression):
    """What is no shape is one line; neither eval nor exec nor compile is ever asked."""

    def never(*_args, **_more):
        raise AssertionError("evaluated")

    path = written(tmp_path, "plan.json", {"rooms": {"a": {"shape": expression}}})
    list(sw.read_scenes(written(tmp_path, "good.json", PLAN)))  # modules are loaded
    monkeypatch.chdir(tmp_path)
    for name in ("eval", "exec"):
        monkeypatch.setattr(builtins, name, never)
    require_error(path, "infinigen-plan", "rooms.a")
    assert not (tmp_path / "pwned").exists()


def test_broken_plans(tmp_path):
    text = written(tmp_path, "whole.json", PLAN).read_text()
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(PLAN, 7, "rooms", "kitchen_0/0", "shape"), ("kitchen_0/0.shape", "text")),
        ("missing.json", without(as_data(PLAN), "doors", "door", "args"), ("doors.door", "'args'")),
        ("nan.json", changed(as_data(PLAN), float("nan"), "rooms", "kitchen_0/0", "args", 2), ("args", "NaN")),
        ("empty.json", "", ("empty",)),
        ("none.json", {"rooms": {}}, ("rooms", "at least one")),
    ):
        # the place of an argument is that of its list
        require_error(written(tmp_path, name, data), "infinigen-plan", *(w for w in words if w != "args"))


SOFA, TABLE, VASE, ART = (
    f"{n}Factory(12{i}).spawn_asset({i})" for i, n in enumerate(("Sofa", "Table", "Vase", "WallArt"))
)


def relation(target, child, parent):
    return {
        "relation": {"child_tags": child, "parent_tags": parent, "margin": 0.01, "relation_type": "StableAgainst"},
        "target_name": target,
        "child_plane_idx": 0,
        "parent_plane_idx": 2,
    }


def state():
    floor = ["Subpart(support)", "-Subpart(ceiling)"], ["Subpart(bottom)"]
    return {
        "objs": {
            "living-room_0/0": {
                "obj": "living-room_0/0",
                "tags": ["Semantics(room)", "Semantics(living-room)"],
                "relations": [],
                "contour": [[0, 0], [5.3, 0], [5.3, 2.2], [3.1, 2.2], [3.1, 4.6], [0, 4.6]],
            },
            "kitchen_0/0": {"obj": "kitchen_0/0", "tags": ["Semantics(room)"], "relations": []},
            SOFA: {
                "obj": SOFA,
                "generator": "SofaFactory(120)",
                "tags": ["Semantics(furniture)", "Semantics(seating)"],
                "relations": [
                    relation("living-room_0/0", floor[1], floor[0]),
                    relation("living-room_0/0", ["Subpart(back)"], ["Subpart(wall)"]),
                ],
                "location": [1.4, 1.1, 0.0],
                "rotation_euler": [0.0, 0.0, 0.3],
                "dimensions": [0.95, 2.05, 0.8],
            },
            TABLE: {
                "obj": TABLE,
                "generator": "TableFactory(121)",
                "tags": [],
                "relations": [relation("living-room_0/0", floor[1], floor[0])],
                "pose": {
                    "location": [4.2, 1.0, 0.0],
                    "rotation_euler": [0.0, 0.0, -1.2],
                    "dimensions": [0.7, 1.2, 0.45],
                },
            },
            VASE: {
                "obj": VASE,
                "generator": "VaseFactory(122)",
                "tags": [],
                "relations": [relation(TABLE, ["Subpart(bottom)"], ["Subpart(support)", "Subpart(top)"])],
                "matrix_world": [
                    [math.cos(2.4), -math.sin(2.4), 0, 4.1],
                    [math.sin(2.4), math.cos(2.4), 0, 1.05],
                    [0, 0, 1, 0.45],
                    [0, 0, 0, 1],
                ],
                "size": [0.2, 0.22, 0.35],
            },
            ART: {
                "obj": ART,
                "generator": "WallArtFactory(123)",
                "tags": ["Semantics(wall-decoration)"],
                "relations": [relation("living-room_0/0", ["Subpart(back)"], ["Subpart(wall)"])],
                "location": [0.03, 3.0, 1.2],
                "rotation_euler": [0.0, 0.0, 0.0],
                "dimensions": [0.06, 1.1, 0.7],
            },
            "LampFactory(9).spawn_asset(1)": {"obj": "x", "generator": "LampFactory(9)", "tags": [], "relations": []},
        }
    }


def test_a_state_with_poses(tmp_path):
    rooms = rooms_of("infinigen", written(tmp_path, "solve_state.json", state()))
    room = rooms["living-room_0/0"]
    assert not rooms["kitchen_0/0"].objects
    assert room.outline is not None and len(room.outline) == 6
    assert room.type == "living-room"
    things = things_of(room)
    require_pose(things[SOFA], (1.4, 1.1, 0.4), compass(0.3))
    require_pose(things[TABLE], (4.2, 1.0, 0.225), compass(-1.2))
    require_pose(things[VASE], (4.1, 1.05, 0.625), compass(2.4))
    require_pose(things[ART], (0.03, 3.0, 1.55), (1, 0, 0))
    assert things[SOFA].size == (0.95, 2.05, 0.8)
    assert [things[n].mount for n in (SOFA, TABLE, VASE, ART)] == ["floor", "floor", "surface", "wall"]
    assert things[VASE].support == TABLE
    assert [things[n].label for n in (SOFA, ART)] == ["Sofa", "WallArt"]
    assert any("LampFactory(9)" in note and "left out" in note for note in room.notes)


def test_doors_and_windows_of_a_state(tmp_path):
    """What is cut from the walls of rooms, by its box: on the wall at x = 5.3, and on that at y = 4.6."""
    data = state()
    for name, rooms, place, yaw in (
        ("door.001", ("living-room_0/0", "kitchen_0/0"), [5.3, 1.1, 0.0], math.pi / 2),
        ("window", ("living-room_0/0",), [1.2, 4.6, 1.5], 0.0),
    ):
        cut = [{"relation": {"relation_type": "CutFrom"}, "target_name": room} for room in rooms]
        pose = {"location": place, "rotation_euler": [0, 0, yaw], "dimensions": [0.95, 0.1, 1.2]}
        data["objs"][name] = {"obj": name, "generator": None, "tags": [], "relations": cut, **pose}
    rooms = rooms_of("infinigen", written(tmp_path, "solve_state.json", data))
    door, window = rooms["living-room_0/0"].openings
    np.testing.assert_allclose((door.start, door.end), ((5.3, 0.625), (5.3, 1.575)), atol=1e-9)
    assert (door.kind, door.leads_to, door.bottom) == ("door", "kitchen_0/0", 0.0)
    np.testing.assert_allclose((window.start, window.end), ((0.725, 4.6), (1.675, 4.6)), atol=1e-9)
    assert (window.kind, window.leads_to) == ("window", None)
    assert window.bottom == pytest.approx(0.9)
    assert [o.name for o in rooms["kitchen_0/0"].openings] == ["door.001"]
    assert "window" not in things_of(rooms["living-room_0/0"])


def test_poses_from_the_export_beside_a_state(tmp_path):
    """By names as USD has them; what carries what is still the state's."""
    pytest.importorskip("sceneweaver.importers.formats.usd")
    from pxr import Gf, Usd, UsdGeom

    bare = state()
    for item in bare["objs"].values():
        for key in ("location", "rotation_euler", "dimensions", "pose", "matrix_world", "size"):
            item.pop(key, None)
    path = written(tmp_path, "export/solve_state.json", bare)
    (tmp_path / "export" / "export_scene.blend").mkdir()
    stage = Usd.Stage.CreateNew(str(tmp_path / "export" / "export_scene.blend" / "export_scene.usdc"))
    UsdGeom.SetStageUpAxis(stage, "Z")
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetDefaultPrim(UsdGeom.Xform.Define(stage, "/root").GetPrim())
    boxes = {  # bottom, yaw, sides
        SOFA: ((1.4, 1.1, 0.0), 0.3, (0.95, 2.05, 0.8)),
        TABLE: ((4.2, 1.0, 0.0), -1.2, (0.7, 1.2, 0.45)),
        VASE: ((4.1, 1.05, 0.45), 2.4, (0.2, 0.22, 0.35)),
    }
    for name, (place, yaw, (x, y, z)) in boxes.items():
        prim = UsdGeom.Xform.Define(stage, "/root/" + "".join(c if c.isalnum() else "_" for c in name))
        prim.AddTranslateOp().Set(Gf.Vec3d(*place))
        prim.AddRotateZOp().Set(math.degrees(yaw))
        mesh = UsdGeom.Mesh.Define(stage, f"{prim.GetPath()}/mesh")
        corners = [(i * x / 2, j * y / 2, k * z) for i in (-1, 1) for j in (-1, 1) for k in (0, 1)]
        mesh.GetPointsAttr().Set([Gf.Vec3f(*c) for c in corners])
        mesh.GetFaceVertexCountsAttr().Set([4] * 6)
        faces = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
        mesh.GetFaceVertexIndicesAttr().Set(faces)
    stage.GetRootLayer().Save()
    room = rooms_of("infinigen", path)["living-room_0/0"]
    things = things_of(room)
    require_pose(things[SOFA], (1.4, 1.1, 0.4), compass(0.3))
    require_pose(things[TABLE], (4.2, 1.0, 0.225), compass(-1.2))
    require_pose(things[VASE], (4.1, 1.05, 0.625), compass(2.4))
    np.testing.assert_allclose(things[SOFA].size, (0.95, 2.05, 0.8), atol=1e-6)
    assert (things[VASE].support, things[SOFA].mount, ART in things) == (TABLE, "floor", False)
    assert any("export_scene.usdc" in note for note in room.notes)


def test_a_state_as_infinigen_writes_it_has_no_poses(tmp_path):
    bare = state()
    for item in bare["objs"].values():
        for key in ("location", "rotation_euler", "dimensions", "pose", "matrix_world", "size"):
            item.pop(key, None)
    require_error(written(tmp_path, "solve_state.json", bare), "infinigen", "no object has a pose", "USD")


@pytest.mark.parametrize(
    ("generator", "obj", "label"),
    [
        ("KitchenCabinetFactory(780816)", "x", "KitchenCabinet"),
        ("ACDC", "MonitorFactory(3610974).spawn_asset(964244)", "Monitor"),
        (None, "BookStackFactory(12).spawn_asset(3)", "BookStack"),
        (None, "780816_LargeShelfFactory", "LargeShelf"),
    ],
)
def test_labels(tmp_path, generator, obj, label):
    data = state()
    data["objs"]["thing"] = {**data["objs"][SOFA], "generator": generator, "obj": obj}
    data["objs"]["thing"]["relations"] = [{"relation": {}, "target_name": None}, *data["objs"][SOFA]["relations"]]
    things = things_of(rooms_of("infinigen", written(tmp_path, "solve_state.json", data))["living-room_0/0"])
    assert things["thing"].label == label


def test_broken_states(tmp_path):
    whole = state()
    text = written(tmp_path, "whole.json", whole).read_text()
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(whole, {"x": 1}, "objs", SOFA, "location"), ("location", "list")),
        ("missing.json", without(state(), "objs"), ("'objs' is missing",)),
        ("nan.json", changed(whole, float("nan"), "objs", SOFA, "dimensions", 1), ("dimensions[1]", "NaN")),
        ("empty.json", "", ("empty",)),
        ("mirror.json", changed(whole, np.diag([1, -1, 1, 1]).tolist(), "objs", VASE, "matrix_world"), ("mirrors",)),
    ):
        require_error(written(tmp_path, name, data), "infinigen", *words)
