"""scene.glb, read by trimesh and by hand: every object whole under its name, where it is, in its materials."""

from __future__ import annotations

import io
import json
import math
import struct
from typing import Any

import numpy as np
import pytest
import trimesh

from sceneweaver.assets import Asset, Material, Mesh, make
from sceneweaver.assets.textures import maps
from sceneweaver.assets.textures.relief import to_linear
from sceneweaver.export import glb_bytes, write_glb
from sceneweaver.export.images import linear
from sceneweaver.export.room import floor_mesh, wall_mesh
from sceneweaver.geometry.shell import WALL_THICKNESS, wall_plan
from sceneweaver.physics.leaves import leaves
from sceneweaver.physics.things import things_of
from sceneweaver.scene import Door, InputError, Part, Pose, Room, Scene, SceneObject, Support, Window

Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)

ROOM = Room(
    outline=((0, 0), (5, 0), (5, 3), (3, 3), (3, 4), (0, 4)),
    height=2.6,
    doors=(Door(id="door-0", wall=0, offset=0.5, width=0.9, height=2.0),),
    windows=(Window(id="window-0", wall=1, offset=1.0, width=1.2, sill=0.9, height=1.2),),
)


def _scene() -> tuple[Scene, dict[str, Asset]]:
    assets = {name: make(name, seed) for name, seed in (("desk", 3), ("table_lamp", 1), ("armchair", 2), ("vase", 4))}
    desk, tilt = assets["desk"], np.array([0.2, -0.1, 0.3, 0.9])
    x, y, z, w = (tilt / np.linalg.norm(tilt)).tolist()
    parts = (
        Part(polygon=((-0.3, -0.2), (0.3, -0.2), (0, 0.4)), z=(0, 0.5)),
        Part(polygon=((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)), z=(0.5, 0.8)),
    )
    objects = (
        desk.object("desk é/1", pose=Pose.from_yaw(1.0, 1.5, 0.0, 2.1)),
        desk.object("desk 2", pose=Pose.from_yaw(4.0, 1.5, 0.0, -0.7)),
        assets["table_lamp"].object(
            "lamp",
            pose=Pose.from_yaw(1, 1.5, 0.74, 0.3),
            support=Support(object="desk 2", surface=desk.surfaces[0].name),
        ),
        assets["armchair"].object("chair", pose=Pose(position=(2.0, 2.0, 0.1), quaternion=(x, y, z, w))),
        SceneObject(
            id="room:floor",
            category="plinth",
            size=(0.6, 0.6, 0.8),
            parts=parts,
            attributes={"color": "red"},
            pose=Pose.from_yaw(2.0, 0.8, 0.0, 1.0),
        ),
        SceneObject(id="scene", category="box", size=(0.3, 0.4, 0.5), pose=Pose.from_yaw(0.5, 3.5, 0.0, 0.4)),
    )
    return Scene(id="s", prompt="p", room=ROOM, objects=objects), {a.id: a for a in assets.values()}


@pytest.fixture(scope="module")
def made() -> tuple[Scene, dict[str, Asset], bytes]:
    scene, assets = _scene()
    return scene, assets, glb_bytes(scene, assets.__getitem__)


def _split(data: bytes) -> tuple[dict[str, Any], bytes]:
    magic, version, total = struct.unpack_from("<4sII", data)
    assert (magic, version, total) == (b"glTF", 2, len(data))
    length, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON" and length % 4 == 0
    size, kind = struct.unpack_from("<I4s", data, 20 + length)
    assert kind == b"BIN\0" and size % 4 == 0 and 28 + length + size == len(data)
    return json.loads(data[20 : 20 + length]), data[28 + length :]


def _world(thing: SceneObject, points: np.ndarray) -> np.ndarray:
    """Own arithmetic: rotates by q p q*."""
    axis, w = np.asarray(thing.pose.quaternion[:3]), thing.pose.quaternion[3]
    turned = points + 2 * np.cross(axis, np.cross(axis, points) + w * points)
    return turned + np.asarray(thing.pose.position)


def test_structure(made) -> None:
    document, binary = _split(made[2])
    assert document["asset"]["version"] == "2.0"
    assert (
        document["buffers"] == [{"byteLength": len(binary)}] or len(binary) - document["buffers"][0]["byteLength"] < 4
    )
    sizes = {5126: ("<f4", 4), 5123: ("<u2", 2), 5125: ("<u4", 4)}
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
    views = document["bufferViews"]
    assert all(v["byteOffset"] % 4 == 0 and v["byteOffset"] + v["byteLength"] <= len(binary) for v in views)
    values = []
    for accessor in document["accessors"]:
        view = views[accessor["bufferView"]]
        kind, each = sizes[accessor["componentType"]]
        assert accessor["count"] * width[accessor["type"]] * each == view["byteLength"]
        data = np.frombuffer(binary, kind, accessor["count"] * width[accessor["type"]], view["byteOffset"])
        values.append(data.reshape(accessor["count"], -1))
        assert np.isfinite(data).all()
    for primitive in (p for mesh in document["meshes"] for p in mesh["primitives"]):
        position = document["accessors"][primitive["attributes"]["POSITION"]]
        points = values[primitive["attributes"]["POSITION"]]
        assert points.min(axis=0).tolist() == position["min"] and points.max(axis=0).tolist() == position["max"]
        assert values[primitive["indices"]].max() < len(points)
        assert 0 <= primitive["material"] < len(document["materials"])
    for node in document["nodes"]:
        assert math.isclose(sum(q * q for q in node.get("rotation", (0, 0, 0, 1))), 1, abs_tol=1e-9)
    names = [node["name"] for node in document["nodes"]]
    assert len(set(names)) == len(names)
    children = [c for node in document["nodes"] for c in node.get("children", ())]
    assert sorted([*children, *document["scenes"][0]["nodes"]]) == list(range(len(names)))
    assert b"\0" not in json.dumps(document).encode() and "\\u0000" not in json.dumps(document["nodes"])


def test_names_and_extras(made) -> None:
    scene, _, data = made
    document, _ = _split(data)
    nodes = {node["name"]: node for node in document["nodes"]}
    assert set(scene.ids) <= set(nodes)
    assert {f"room:wall:{k}" for k in range(6)} <= set(nodes)
    lamp = nodes["lamp"]["extras"]
    assert lamp["support"] == {"object": "desk 2", "surface": scene.object("lamp").support.surface}  # type: ignore[union-attr]
    assert lamp["category"] == "table_lamp" and lamp["asset"] == scene.object("lamp").asset
    assert nodes["desk é/1"]["mesh"] == nodes["desk 2"]["mesh"], "an asset is stored once"
    assert nodes["room:floor"]["extras"]["category"] == "plinth", "an object keeps its name, even a strange one"


def test_trimesh_finds_each_object_where_it_is(made) -> None:
    scene, assets, data = made
    loaded: Any = trimesh.load(io.BytesIO(data), file_type="glb", merge_primitives=True)
    assert set(scene.ids) <= set(loaded.graph.nodes_geometry)
    for thing in scene.objects:
        matrix, name = loaded.graph[thing.id]
        shape = loaded.geometry[name]
        if thing.asset is None:
            points = np.array([(*p, z) for part in thing.solids for z in part.z for p in part.polygon])
        else:
            points = assets[thing.asset].mesh.vertices
            own = trimesh.Trimesh(points, assets[thing.asset].mesh.faces, process=False)
            assert shape.volume == pytest.approx(own.volume, rel=1e-4)
            assert len(shape.faces) == len(own.faces)
        expected = _world(thing, points)
        found = trimesh.transform_points(shape.vertices, Z_UP @ matrix)
        np.testing.assert_allclose(found.min(axis=0), expected.min(axis=0), atol=1e-4)
        np.testing.assert_allclose(found.max(axis=0), expected.max(axis=0), atol=1e-4)
        closed = (shape.face_normals * shape.area_faces[:, None]).sum(axis=0)
        assert np.abs(closed).max() < 1e-5 and shape.volume > 0, "what is closed has as much to each side"


def _values(document: dict[str, Any], binary: bytes, number: int, width: int) -> np.ndarray:
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[accessor["componentType"]]
    return np.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)


def _picture(document: dict[str, Any], binary: bytes, reference: dict[str, int]) -> np.ndarray:
    from PIL import Image

    image = document["images"][document["textures"][reference["index"]]["source"]]
    view = document["bufferViews"][image["bufferView"]]
    return np.asarray(Image.open(io.BytesIO(binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])))


def test_a_material_is_its_maps_times_its_numbers(made) -> None:
    scene, assets, data = made
    document, binary = _split(data)
    chair = next(n for n in document["nodes"] if n["name"] == "chair")
    mesh = assets[scene.object("chair").asset or ""].mesh
    primitives = document["meshes"][chair["mesh"]]["primitives"]
    used = [mesh.materials[k] for k in np.unique(mesh.face_material)]
    for primitive, wanted in zip(primitives, used, strict=True):
        material = document["materials"][primitive["material"]]
        assert material["name"] == wanted.name
        surface = material["pbrMetallicRoughness"]
        if maps(wanted.texture) is None:
            continue
        tint = to_linear(_picture(document, binary, surface["baseColorTexture"]) / 255.0).mean(axis=(0, 1))
        assert surface["baseColorFactor"][:3] * tint == pytest.approx(linear(wanted.color), rel=0.06)
        rough = surface.get("metallicRoughnessTexture")
        share = 1.0 if rough is None else _picture(document, binary, rough)[..., 1].mean() / 255
        assert surface["roughnessFactor"] * share == pytest.approx(wanted.roughness, rel=0.06)
    images = [image["name"] for image in document["images"]]
    assert len(set(images)) == len(images), "textures are shared"
    red = next(m for m in document["materials"] if m["name"] == "red clay")
    assert red["pbrMetallicRoughness"]["baseColorFactor"][0] == pytest.approx(0.462, rel=0.1)


def test_maps_lie_at_their_real_size_with_a_frame_of_tangents() -> None:
    """A wall of 5 m by 2.6 m with plaster of 0.6 m: the pattern repeats so often, u runs along the wall, v up."""
    document, binary = _split(glb_bytes(Scene(id="s", room=ROOM)))
    node = next(n for n in document["nodes"] if n["name"] == "room:wall:2")
    (primitive,) = document["meshes"][node["mesh"]]["primitives"]
    found = {
        name: _values(document, binary, number, {"TEXCOORD_0": 2, "TANGENT": 4}.get(name, 3))
        for name, number in primitive["attributes"].items()
    }
    size = maps(wall_mesh(ROOM, 2).materials[0].texture).size  # type: ignore[union-attr]
    normal, tangent = found["NORMAL"], found["TANGENT"]
    assert np.allclose(np.linalg.norm(normal, axis=1), 1, atol=1e-5)
    assert np.allclose(np.linalg.norm(tangent[:, :3], axis=1), 1, atol=1e-5)
    assert np.allclose((normal * tangent[:, :3]).sum(axis=1), 0, atol=1e-5)
    upright = np.abs(normal[:, 1]) < 0.1
    up = np.cross(normal, tangent[:, :3]) * tangent[:, 3:]
    np.testing.assert_allclose(up[upright], np.tile((0, 1, 0), (upright.sum(), 1)), atol=1e-5)
    inner = (normal @ np.array([0, 0, 1])) > 0.99
    spread = np.ptp(found["TEXCOORD_0"][inner], axis=0) * size
    np.testing.assert_allclose(spread, np.ptp(found["POSITION"][inner][:, [0, 1]], axis=0), rtol=1e-4)


def test_without_textures_a_file_is_small_and_has_the_same_shapes(made) -> None:
    scene, assets, data = made
    plain, _ = _split(glb_bytes(scene, assets.__getitem__, textures=False))
    document, _ = _split(data)
    assert "images" not in plain and len(plain["meshes"]) == len(document["meshes"])
    assert [m["name"] for m in plain["materials"]] == [m["name"] for m in document["materials"]]


def test_one_material_keeps_its_numbers() -> None:
    glass = Material("g", (0.5, 0.25, 1.0), roughness=0.1, metallic=0.2, opacity=0.3, emission=0.5)
    base = make("vase", 1)
    mesh = base.mesh
    plain = Mesh(mesh.vertices, mesh.faces, np.zeros_like(mesh.face_material), mesh.face_link, (glass,))
    asset = Asset(**{**base.__dict__, "mesh": plain})
    scene = Scene(id="s", room=ROOM, objects=(asset.object("vase", mount="floor"),))
    document, _ = _split(glb_bytes(scene, lambda _: asset))
    material = next(m for m in document["materials"] if m["name"] == "g")
    assert material["pbrMetallicRoughness"] == {
        "baseColorFactor": [*linear(glass.color), 0.3],
        "metallicFactor": 0.2,
        "roughnessFactor": 0.1,
    }
    assert material["alphaMode"] == "BLEND"
    np.testing.assert_allclose(material["emissiveFactor"], [0.107, 0.0254, 0.5], atol=1e-3)


def test_another_size_than_the_asset_has() -> None:
    asset = make("desk", 3)
    d, w, h = asset.size
    thing = asset.object("desk").model_copy(update={"size": (d, w * 1.5, h)})
    loaded: Any = trimesh.load(
        io.BytesIO(glb_bytes(Scene(id="s", room=ROOM, objects=(thing,)), lambda _: asset)),
        file_type="glb",
        merge_primitives=True,
    )
    matrix, name = loaded.graph["desk"]
    points = trimesh.transform_points(loaded.geometry[name].vertices, Z_UP @ matrix)
    np.testing.assert_allclose(np.ptp(points, axis=0), (d, w * 1.5, h), atol=1e-4)


def test_walls_and_floor() -> None:
    walls = [wall_mesh(ROOM, k) for k in range(6)]
    volumes = [float(trimesh.Trimesh(m.vertices, m.faces).volume) for m in walls]
    perimeter = sum(math.dist(a, b) for a, b in zip(ROOM.outline, [*ROOM.outline[1:], ROOM.outline[0]], strict=True))
    # Outward corners add a square each, the one reflex corner takes one away.
    solid = (perimeter * WALL_THICKNESS + 4 * WALL_THICKNESS**2) * ROOM.height
    holes = (0.9 * 2.0 + 1.2 * 1.2) * WALL_THICKNESS
    assert sum(volumes) == pytest.approx(solid - holes, rel=1e-4)
    floor = trimesh.Trimesh(*(getattr(floor_mesh(ROOM), name) for name in ("vertices", "faces")))
    assert floor.is_watertight and floor.bounds[1][2] == pytest.approx(0, abs=1e-6)
    for mesh in walls:
        body = trimesh.Trimesh(mesh.vertices, mesh.faces)
        assert body.is_watertight and body.bounds[0][2] == pytest.approx(0, abs=1e-6)
    inner = walls[0].vertices[np.abs(walls[0].vertices[:, 1]) < 1e-6]
    assert {(0.5, 2.0), (1.4, 2.0), (0.5, 0.0), (1.4, 0.0)} <= {(round(x, 6), round(z, 6)) for x, _, z in inner}


@pytest.mark.parametrize(
    "outline",
    [
        ((0, 0), (6, 0), (0.3, 0.4)),  # a sharp corner
        ((0, 0), (4, 0), (4, 3), (2.05, 3), (2.05, 2.95), (1.95, 2.95), (1.95, 3), (0, 3)),  # a tiny niche
        ((0, 0), (2, 0), (4, 0), (4, 3), (0, 3)),  # a straight corner
    ],
)
def test_awkward_rooms(outline) -> None:
    room = Room(outline=outline)
    for k in range(len(outline)):
        assert trimesh.Trimesh(wall_mesh(room, k).vertices, wall_mesh(room, k).faces).volume > 0
        assert len(wall_plan(room.walls, k)) == 4
    trimesh.load(io.BytesIO(glb_bytes(Scene(id="s", room=room))), file_type="glb")


def test_a_missing_asset_is_named(tmp_path) -> None:
    thing = SceneObject(id="a", category="desk", size=(1, 1, 1), asset="nobody:1")
    scene = Scene(id="s", room=ROOM, objects=(thing,))
    with pytest.raises(InputError, match=r"objects\[0\]\.asset: .*nobody:1"):
        write_glb(scene, tmp_path / "scene.glb")
    assert not list(tmp_path.iterdir())
    document, _ = _split(glb_bytes(scene, missing="parts"))
    assert "missing" in next(n for n in document["nodes"] if n["name"] == "a")["extras"]["note"]


def test_equal_scenes_give_equal_bytes(made) -> None:
    scene, assets, data = made
    assert glb_bytes(scene, assets.__getitem__) == data


def test_doors_and_drawers_are_nodes_with_their_origin_on_the_hinge() -> None:
    """Whoever turns a node about the axis of its joint opens a door as a simulator does."""
    cabinet = make("filing_cabinet", 1)
    wide = cabinet.object("wide", pose=Pose.from_yaw(3.5, 2.0, 0.0, 0.4))
    scale = np.array([1.2, 0.8, 1.1])
    wide = wide.model_copy(update={"size": tuple((np.asarray(cabinet.size) * scale).tolist())})
    objects = (cabinet.object("one", pose=Pose.from_yaw(1.0, 2.0, 0.0, 0.4)), wide, cabinet.object("two"))
    scene = Scene(id="s", room=ROOM, objects=objects)
    data = glb_bytes(scene, lambda _: cabinet)
    document, _ = _split(data)
    nodes = {node["name"]: node for node in document["nodes"]}
    loaded: Any = trimesh.load(io.BytesIO(data), file_type="glb", process=False, merge_primitives=True)
    for thing in things_of(scene, lambda _: cabinet):
        assert {document["nodes"][k]["name"] for k in nodes[thing.object.id]["children"]} == {
            body.name for body in thing.bodies[1:]
        }
        whole = []
        for body in thing.bodies:
            matrix, geometry = loaded.graph[body.name]
            points = trimesh.transform_points(loaded.geometry[geometry].vertices, Z_UP @ matrix)
            whole.append(points)
            if body.link is not None and body.joint is not None:
                axis, limits = body.joint.axis, body.joint.limits
                joint = nodes[body.name]["extras"]["joint"]
                assert joint["type"] == body.link.joint and joint["role"] == body.link.role
                assert joint["axis_z_up"] == pytest.approx(axis.tolist()) and joint["limits"] == pytest.approx(limits)
                assert joint["axis"] == pytest.approx([axis[0], axis[2], -axis[1]])
        want = _world(thing.object, cabinet.mesh.vertices * np.asarray(thing.scale))
        got = np.concatenate(whole)
        assert np.allclose(got.min(0), want.min(0), atol=1e-5) and np.allclose(got.max(0), want.max(0), atol=1e-5)
    # Those of one asset share their meshes.
    assert nodes["one"]["mesh"] == nodes["two"]["mesh"] != nodes["wide"]["mesh"]


def test_the_room_has_doors_and_panes(made) -> None:
    nodes = {node["name"]: node for node in _split(made[2])[0]["nodes"]}
    (leaf,) = leaves(ROOM)
    x, y, z = leaf.position
    assert nodes[leaf.name]["translation"] == pytest.approx((x, z, -y))
    assert nodes[leaf.name]["extras"]["joint"]["limits"] == pytest.approx(leaf.limits)
    loaded: Any = trimesh.load(io.BytesIO(made[2]), file_type="glb", process=False, merge_primitives=True)
    matrix, geometry = loaded.graph["room:window:window-0"]
    points = trimesh.transform_points(loaded.geometry[geometry].vertices, Z_UP @ matrix)
    assert points[:, 1].min() == pytest.approx(0.97) and points[:, 2].max() == pytest.approx(2.1)


def _moved(matrix: np.ndarray, joint: dict[str, Any], axis: list[float]) -> np.ndarray:
    """The frame [4, 4] of a node, opened as far as its joint says: turned about its origin or pushed, in its frame."""
    far = max(joint["limits"], key=abs)
    if joint["type"] == "hinge":
        return matrix @ trimesh.transformations.rotation_matrix(far, axis)
    return matrix @ trimesh.transformations.translation_matrix(far * np.asarray(axis))


@pytest.mark.parametrize("frames", ["of the file", "of an importer that is z up"])
def test_doors_open_by_their_nodes_as_they_do_in_the_room(frames) -> None:
    """Opened by the axis in ``extras``, leaves and doors are where simulators have them: in frames as the file has
    them, and in those that Blender makes of them, which turns each node's frame."""
    fridge = make("fridge", 1)
    chest = make("filing_cabinet", 1)
    objects = (
        fridge.object("fridge", pose=Pose.from_yaw(1.0, 2.0, 0.0, 0.4)),
        chest.object("chest", pose=Pose.from_yaw(3.5, 2.0, 0.0, 2.0)),
    )
    scene, load = Scene(id="s", room=ROOM, objects=objects), {a.id: a for a in (fridge, chest)}.__getitem__
    data = glb_bytes(scene, load)
    nodes = {node["name"]: node for node in _split(data)[0]["nodes"]}
    loaded: Any = trimesh.load(io.BytesIO(data), file_type="glb", process=False, merge_primitives=True)
    seen = 0
    for thing in things_of(scene, load):
        for body in thing.bodies:
            if body.joint is None:
                continue
            joint = nodes[body.name]["extras"]["joint"]
            matrix, geometry = loaded.graph[body.name]
            points = loaded.geometry[geometry].vertices
            if frames == "of the file":
                found = trimesh.transform_points(points, Z_UP @ _moved(matrix, joint, joint["axis"]))
            else:
                inner = Z_UP @ matrix @ Z_UP.T
                points = trimesh.transform_points(points, Z_UP)
                found = trimesh.transform_points(points, _moved(inner, joint, joint["axis_z_up"]))
            assert thing.asset is not None
            own = thing.asset.mesh.vertices[np.unique(thing.asset.mesh.faces[thing.face_body == body.number])]
            far = max(body.joint.limits, key=abs)
            if body.joint.kind == "hinge":
                turn = trimesh.transformations.rotation_matrix(far, body.joint.axis, body.joint.anchor)
                own = trimesh.transform_points(own, turn)
            else:
                own = own + far * body.joint.axis
            wanted = _world(thing.object, own)
            np.testing.assert_allclose(found.min(axis=0), wanted.min(axis=0), atol=1e-4)
            np.testing.assert_allclose(found.max(axis=0), wanted.max(axis=0), atol=1e-4)
            seen += 1
    assert seen >= 4
    (leaf,) = leaves(ROOM)
    joint, (matrix, geometry) = nodes[leaf.name]["extras"]["joint"], loaded.graph[leaf.name]
    points = loaded.geometry[geometry].vertices
    if frames == "of the file":
        found = trimesh.transform_points(points, Z_UP @ _moved(matrix, joint, joint["axis"]))
    else:
        points = trimesh.transform_points(points, Z_UP)
        found = trimesh.transform_points(points, _moved(Z_UP @ matrix @ Z_UP.T, joint, joint["axis_z_up"]))
    low, high, y0 = found.min(axis=0), found.max(axis=0), leaf.position[1]
    # Open, it stands upright in the room, across the wall of y = 0 that it hangs in.
    assert low[2] > 0.0 and high[2] < 2.0 and high[1] - y0 == pytest.approx(0.9, abs=0.02) and high[0] - low[0] < 0.2


def test_frames_are_those_of_the_scene_after_an_importer_has_turned_them(made) -> None:
    scene, _, data = made
    loaded: Any = trimesh.load(io.BytesIO(data), file_type="glb", merge_primitives=True)
    for thing in scene.objects:
        matrix, _ = loaded.graph[thing.id]
        frame = Z_UP @ matrix @ Z_UP.T  # as Blender has it
        turn = trimesh.transformations.quaternion_matrix(np.roll(thing.pose.quaternion, 1))[:3, :3]
        np.testing.assert_allclose(frame[:3, :3], turn, atol=1e-6)
        np.testing.assert_allclose(frame[:3, 3], thing.pose.position, atol=1e-6)
