"""Exports whose meshes and images lie in the store of a data set: the same rooms as those of the usual writers."""

from __future__ import annotations

import io
import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.textures import maps, patterns
from sceneweaver.datasets import Folder, Sample
from sceneweaver.datasets.reading import extract
from sceneweaver.datasets.samples import write_block
from sceneweaver.datasets.store import AssetStore
from sceneweaver.datasets.store.scene_files import SceneFiles, asset_rows, references
from sceneweaver.export import glb_bytes, write_mjcf, write_usd
from sceneweaver.scene import Door, InputError, Pose, Room, Scene, Support, Window

ROOM = Room(
    outline=((0, 0), (5, 0), (5, 4), (0, 4)),
    height=2.6,
    doors=(Door(id="door-0", wall=0, offset=0.5, width=0.9, height=2.0),),
    windows=(Window(id="window-0", wall=1, offset=1.0, width=1.2, sill=0.9, height=1.2),),
)
LOAD = Library().load
DESK = LOAD("parametric:desk?seed=3")
CABINET = LOAD("parametric:dresser?seed=2")
LAMP = LOAD("parametric:table_lamp?seed=1")
BOWL = LOAD("parametric:fruit_bowl?seed=1")


def _scene(name: str, x: float) -> Scene:
    """A room; its chest is larger than drawn, and another desk is as drawn."""
    large = CABINET.object("chest", pose=Pose.from_yaw(4.0, 3.0, 0.0, -1.6))
    depth, width, height = large.size
    on_desk = Support(object="desk", surface=DESK.surfaces[0].name)
    objects = (
        DESK.object("desk", pose=Pose.from_yaw(x, 1.5, 0.0, 2.1)),
        DESK.object("desk 2", pose=Pose.from_yaw(3.5, 1.0, 0.0, -0.7)),
        LAMP.object("lamp", pose=Pose.from_yaw(x, 1.5, DESK.surfaces[0].z, 0.3), support=on_desk),
        BOWL.object("bowl", pose=Pose.from_yaw(x + 0.3, 1.5, DESK.surfaces[0].z, 0.3), support=on_desk),
        large.model_copy(update={"size": (depth, round(1.25 * width, 6), height)}),
    )
    return Scene(id=name, prompt="p", room=ROOM, objects=objects)


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data set with two scenes that stand beside the store."""
    root = tmp_path_factory.mktemp("set")
    store = AssetStore(root)
    writer = SceneFiles(store, LOAD)
    for k in range(2):
        for suffix, content in writer.of(_scene(f"s{k}", 1.0 + k / 4), ("glb", "mjcf", "usd")).items():
            (root / f"{k}.{suffix}").write_bytes(content)
    store.sync()
    store.close()
    return root


def _document(path: Path) -> dict[str, Any]:
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + length])


def test_glb_is_the_room_of_the_usual_one(root: Path) -> None:
    import trimesh

    way: Any = {"process": False, "merge_primitives": True}
    whole: Any = trimesh.load(io.BytesIO(glb_bytes(_scene("s1", 1.25), LOAD)), file_type="glb", **way)
    shared: Any = trimesh.load(root / "1.glb", **way)
    assert set(whole.graph.nodes_geometry) == set(shared.graph.nodes_geometry)
    for node in whole.graph.nodes_geometry:
        (place, mesh), (other, twin) = (
            (scene.graph.get(node)[0], scene.geometry[scene.graph.get(node)[1]]) for scene in (whole, shared)
        )
        np.testing.assert_allclose(place, other)
        np.testing.assert_array_equal(mesh.vertices, twin.vertices)
        np.testing.assert_array_equal(mesh.faces, twin.faces)
        assert type(mesh.visual) is type(twin.visual)
    document = _document(root / "1.glb")
    assert all("uri" in image for image in document["images"])
    named = [buffer["uri"] for buffer in document["buffers"] if "uri" in buffer]
    assert named and len(named) == len(set(named)) and "uri" not in document["buffers"][0]
    for buffer in document["buffers"][1:]:
        assert (root / buffer["uri"]).stat().st_size >= buffer["byteLength"]
    assert (root / "1.glb").stat().st_size < 80_000


def test_mjcf_is_the_model_of_the_usual_one(root: Path, tmp_path: Path) -> None:
    mujoco: Any = pytest.importorskip("mujoco")

    scene = _scene("s0", 1.0)
    usual = mujoco.MjModel.from_xml_path(str(write_mjcf(scene, tmp_path / "out", LOAD)))
    shared = mujoco.MjModel.from_xml_path(str(root / "0.xml"))
    _assert_equal(usual, shared)
    assert {path.suffix for path in root.glob("assets/*/*")} == {".bin", ".jpg", ".png", ".xml"}


def _assert_equal(one: Any, two: Any) -> None:
    """What moves and collides to a micrometre; what is seen to 0.01 mm, with four decimals of places on images."""
    for field in ("body_mass", "body_inertia", "body_pos", "geom_type", "geom_matid", "mat_rgba", "tex_data"):
        np.testing.assert_allclose(getattr(one, field), getattr(two, field), atol=1e-6, err_msg=field)
    collides = one.geom_group != 2  # the size of what is seen is in axes that a round thing has in any way
    np.testing.assert_allclose(one.geom_size[collides], two.geom_size[collides], atol=1e-6)
    for g in range(one.ngeom):
        found, wanted = _seen(one, g), _seen(two, g)
        np.testing.assert_allclose(found[:, :3], wanted[:, :3], atol=1e-5)
        np.testing.assert_allclose(found[:, 3:], wanted[:, 3:], atol=1e-4)


def _seen(model: Any, geom: int) -> np.ndarray:
    """The corners of a geom's mesh in its body, sorted, each with its texture coordinates where it has some."""
    mujoco: Any = pytest.importorskip("mujoco")
    which = int(model.geom_dataid[geom])
    if which < 0:
        return np.zeros((0, 3))
    first, count = model.mesh_faceadr[which], model.mesh_facenum[which]
    vert, turn = model.mesh_vertadr[which], np.zeros(9)
    mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
    corners = model.mesh_vert[vert + model.mesh_face[first : first + count].reshape(-1)] @ turn.reshape(3, 3).T
    corners = corners + model.geom_pos[geom]
    if model.mesh_texcoordadr[which] >= 0:
        at = model.mesh_texcoordadr[which] + model.mesh_facetexcoord[first : first + count].reshape(-1)
        corners = np.column_stack([corners, model.mesh_texcoord[at]])
    elif model.geom_group[geom] == 3:  # a hull may be cut into other triangles
        corners = np.unique(corners.round(5), axis=0)
    return corners


def test_usd_is_the_stage_of_the_usual_one(root: Path, tmp_path: Path) -> None:
    Usd, UsdShade = (pytest.importorskip(f"pxr.{name}") for name in ("Usd", "UsdShade"))

    write_usd(_scene("s0", 1.0), tmp_path / "s.usdc", LOAD)
    usual, shared = (Usd.Stage.Open(str(path)) for path in (tmp_path / "s.usdc", root / "0.usdc"))
    assert [p.GetPath() for p in usual.Traverse()] == [p.GetPath() for p in shared.Traverse()]
    images = [
        shader.GetInput("file").Get().path
        for p in shared.Traverse()
        if (shader := UsdShade.Shader(p)) and shader.GetInput("file")
    ]
    assert images and all((root / path).is_file() for path in images)


def test_scenes_share_files_and_the_store_knows_what_they_are_of(root: Path) -> None:
    files = [
        {path.suffix[1:]: path.read_bytes() for path in (root / f"{k}.{s}" for s in ("glb", "xml", "usdc"))}
        for k in range(2)
    ]
    first, second = (references(one) for one in files)
    assert first == second  # another place, the same things
    kept = {path.relative_to(root).as_posix() for path in root.glob("assets/*/*")}
    assert kept == set(first)
    rows = asset_rows(AssetStore(root))
    assert [row["asset"] for row in rows] == sorted(a.id for a in (DESK, CABINET, LAMP, BOWL))
    assert all(set(row["files"]) <= kept and row["bytes"] > 0 and row["licence"] == "Apache-2.0" for row in rows)


def test_equal_scenes_give_equal_bytes_whatever_was_written_before(root: Path, tmp_path: Path) -> None:
    alone = SceneFiles(AssetStore(tmp_path), LOAD).of(_scene("s1", 1.25), ("glb", "mjcf", "usd"))
    assert alone == {suffix: (root / f"1.{suffix}").read_bytes() for suffix in alone}


def test_a_store_mends_what_is_short(tmp_path: Path) -> None:
    store = AssetStore(tmp_path)
    good, bad = store.put(b"good", "bin"), store.put(b"bad", "bin")
    store.sync()
    (tmp_path / bad).write_bytes(b"ba")
    assert AssetStore(tmp_path).put(b"bad", "bin") == bad
    assert [(tmp_path / name).read_bytes() for name in (good, bad)] == [b"good", b"bad"]


def test_finishes_of_one_drawing_share_their_meshes(tmp_path: Path) -> None:
    """A desk as drawn, one in other colours, and one whose images have another size: that one's lie otherwise."""
    import trimesh

    mujoco: Any = pytest.importorskip("mujoco")
    first = next(k for k, m in enumerate(DESK.mesh.materials) if m.texture != "plain" and k in DESK.mesh.face_material)
    sizes = maps(DESK.mesh.materials[first].texture).size  # type: ignore[union-attr]
    other = next(name for name in patterns() if (found := maps(name)) is not None and found.size != sizes)
    looks = [replace(m, name=f"{m.name} 2", color=(0.1, 0.2, 0.3)) for m in DESK.mesh.materials]
    changed = [replace(m, texture=other) if k == first else m for k, m in enumerate(looks)]
    assets = {"desk": DESK} | {
        name: replace(DESK, id=name, drawn_as=DESK.geometry, mesh=replace(DESK.mesh, materials=tuple(materials)))
        for name, materials in (("blue", looks), ("stone", changed))
    }
    things = [a.object(n, pose=Pose.from_yaw(1.0 + k, 2.0, 0.0, 0.0)) for k, (n, a) in enumerate(assets.items())]
    load = {a.id: a for a in assets.values()}.__getitem__
    store, scene = AssetStore(tmp_path), Scene(id="s", room=ROOM, objects=tuple(things))
    for suffix, content in SceneFiles(store, load).of(scene, ("glb", "mjcf")).items():
        (tmp_path / f"scene.{suffix}").write_bytes(content)
    rows = {row["asset"]: row["files"] for row in asset_rows(store)}
    drawn, blue, stone = (set(rows[load(i).id]) for i in (DESK.id, "blue", "stone"))
    assert drawn == blue and not drawn & stone
    alone = SceneFiles(AssetStore(tmp_path / "alone"), load)
    alone.of(scene.model_copy(update={"objects": tuple(things[2:])}), ("glb", "mjcf"))
    names = {path.name for path in (tmp_path / "alone").glob("assets/*/*") if path.suffix in (".xml", ".bin")}
    assert names == {Path(name).name for name in stone}

    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    seen, usual = (
        trimesh.load_scene(file, file_type="glb").geometry
        for file in (tmp_path / "scene.glb", io.BytesIO(glb_bytes(scene, load)))
    )
    assert seen.keys() == usual.keys()
    for name in seen:
        assert seen[name].visual.material.main_color.tolist() == usual[name].visual.material.main_color.tolist()
    twin = mujoco.MjModel.from_xml_path(str(write_mjcf(scene, tmp_path / "out", load)))
    _assert_equal(model, twin)


def test_another_process_makes_nothing_anew(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = AssetStore(root)
    kept: list[str] = []
    monkeypatch.setattr(store, "put", lambda content, suffix: kept.append(suffix))
    again = SceneFiles(store, LOAD).of(_scene("s1", 1.25), ("glb", "mjcf", "usd"))
    assert kept == []
    assert again == {suffix: (root / f"1.{suffix}").read_bytes() for suffix in again}


def test_a_scene_taken_out_stands_alone(root: Path, tmp_path: Path) -> None:
    """Of a set that is still made: block 0 has scene 0, and scene 1 was not delivered."""
    import trimesh

    mujoco: Any = pytest.importorskip("mujoco")
    kept = {path.suffix[1:]: path.read_bytes() for path in root.glob("0.*")}
    kept["scene.json"] = json.dumps(_scene("s0", 1.0).to_json()).encode()
    samples = [Sample(0, "00000000", "ok", {}, kept), Sample(1, "00000001", "rejected", {"reason": "gate: grade"})]
    write_block(Folder(root).block(0), samples)
    files = extract(root, "00000000", tmp_path / "one")
    assert {path.name for path in files} == {"scene.json", "scene.glb", "scene.xml", "scene.usdc"}
    assert mujoco.MjModel.from_xml_path(str(tmp_path / "one" / "scene.xml")).nmesh > 5
    assert len(trimesh.load_scene(tmp_path / "one" / "scene.glb").geometry) > 5
    named = {path.relative_to(tmp_path / "one").as_posix() for path in (tmp_path / "one").glob("assets/*/*")}
    assert named == set(references(kept))
    with pytest.raises(InputError, match="is there already"):
        extract(root, "00000000", tmp_path / "one")
    with pytest.raises(InputError, match=r"not delivered \(gate: grade\)"):
        extract(root, "00000001", tmp_path / "two")
    with pytest.raises(InputError, match="no scene '7'"):
        extract(root, "7", tmp_path / "two")
    assert [path.name for path in tmp_path.iterdir()] == ["one"]
