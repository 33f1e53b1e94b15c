"""The MJCF folder, read by MuJoCo itself."""

from __future__ import annotations

import errno
import os
import re
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.assets.textures import maps
from sceneweaver.assets.textures.relief import to_linear
from sceneweaver.export.mjcf import write_mjcf
from sceneweaver.scene import Door, InputError, Pose, Room, Scene, SceneObject, Support, Window

mujoco: Any = import_module("mujoco")

ROOM = Room(
    outline=((0, 0), (5, 0), (5, 3), (3, 3), (3, 4), (0, 4)),
    height=2.6,
    doors=(Door(id="door-0", wall=0, offset=0.5, width=0.9, height=2.0),),
    windows=(Window(id="window-0", wall=1, offset=1.0, width=1.2, sill=0.9, height=1.2),),
)
ASSETS = {a.id: a for a in (make("desk", 3), make("filing_cabinet", 1), make("mug", 2))}
DESK, CABINET, MUG = ASSETS.values()
TILT = tuple((np.array([0.2, -0.1, 0.3, 0.9]) / np.linalg.norm([0.2, -0.1, 0.3, 0.9])).tolist())


def _scene() -> Scene:
    top = DESK.surfaces[0]
    objects = (
        DESK.object("desk é/1", pose=Pose.from_yaw(1.5, 1.5, 0.0, 2.1)),
        CABINET.object("cabinet", pose=Pose(position=(4.0, 1.5, 0.6), quaternion=TILT)),
        MUG.object(
            "mug", pose=Pose.from_yaw(1.5, 1.5, top.z, 0.3), support=Support(object="desk é/1", surface=top.name)
        ),
        SceneObject(id="box", category="unheard of", size=(0.3, 0.4, 0.5), pose=Pose.from_yaw(0.5, 3.5, 0.0, 0.4)),
    )
    return Scene(id="s", room=ROOM, objects=objects)


def test_what_is_seen_has_the_colours_of_its_materials(tmp_path) -> None:
    model = mujoco.MjModel.from_xml_path(str(write_mjcf(_scene(), tmp_path / "out", ASSETS.__getitem__)))
    seen = np.flatnonzero(model.geom_group == 2)
    assert len(seen) and (model.geom_matid[seen] >= 0).all()
    # Another colour of a geom than MuJoCo's default would be shown in place of the material's.
    assert np.allclose(model.geom_rgba[seen], [0.5, 0.5, 0.5, 1.0])
    looks = [m for a in (DESK, CABINET, MUG) for m in a.mesh.materials]
    wanted = to_linear(np.array([m.color for m in looks])) * [[_gain(m)] for m in looks]
    for color in model.mat_rgba[model.geom_matid[seen], :3]:
        assert np.abs(np.minimum(wanted, 1) - to_linear(color)).max(axis=1).min() < 1e-3


def test_materials_with_maps_have_their_image_on_the_mesh(tmp_path) -> None:
    model = mujoco.MjModel.from_xml_path(str(write_mjcf(_scene(), tmp_path / "out", ASSETS.__getitem__)))
    for geom in np.flatnonzero(model.geom_group == 2):
        texture = model.mat_texid[model.geom_matid[geom]].max()
        mesh = model.geom_dataid[geom]
        assert (texture >= 0) == (model.mesh_texcoordadr[mesh] >= 0)
    images = {p.stem for p in (tmp_path / "out" / "textures").iterdir()}
    looks = [m.texture for a in (DESK, CABINET, MUG) for m in a.mesh.materials]
    assert images == {"floorboards", *looks} - {"plain"}
    bare = write_mjcf(_scene(), tmp_path / "bare", ASSETS.__getitem__, textures=False)
    assert not (bare.parent / "textures").exists() and mujoco.MjModel.from_xml_path(str(bare)).ntex == 1
    ground = model.geom("room:floor").id
    assert np.allclose(model.geom_rgba[ground], [0.5, 0.5, 0.5, 1.0]), "the material's colour is shown"
    floor = model.mat_texrepeat[model.geom_matid[ground]]
    assert 1 / floor == pytest.approx(maps("floorboards").size, rel=1e-4)  # type: ignore[union-attr]


def _gain(material) -> float:
    found = maps(material.texture)
    return 1.0 if found is None else found.gain


def test_poses_come_back(tmp_path, monkeypatch) -> None:
    scene = _scene()
    path = write_mjcf(scene, tmp_path / "out", ASSETS.__getitem__)
    moved = path.parent.rename(tmp_path / "elsewhere")
    monkeypatch.chdir("/")
    model = mujoco.MjModel.from_xml_path(str(moved / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for thing in scene.objects:
        body = data.body(thing.id.replace("/", "-"))
        x, y, z, w = thing.pose.quaternion
        assert np.allclose(body.xpos, thing.pose.position, atol=1e-6)
        assert abs(abs(np.dot(body.xquat, (w, x, y, z))) - 1) < 1e-6
    for asset, object_id in ((DESK, "desk é/1"), (MUG, "mug")):
        assert model.body_subtreemass[model.body(object_id.replace("/", "-")).id] == pytest.approx(asset.mass, rel=1e-3)
    assert not [n for n in os.listdir(tmp_path) if n.endswith((".tmp", ".old"))]


def test_what_is_seen_is_the_mesh_where_the_scene_has_it(tmp_path) -> None:
    scene = _scene()
    model = mujoco.MjModel.from_xml_path(str(write_mjcf(scene, tmp_path / "out", ASSETS.__getitem__)))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    mine = model.body("cabinet").id
    points = []
    for g in range(model.ngeom):
        if model.body_rootid[model.geom_bodyid[g]] == mine and model.geom_group[g] == 2:
            m = model.geom_dataid[g]
            start, count = model.mesh_vertadr[m], model.mesh_vertnum[m]
            local = model.mesh_vert[start : start + count]
            points.append(local @ data.geom_xmat[g].reshape(3, 3).T + data.geom_xpos[g])
    found = np.concatenate(points)
    axis, w = np.array(TILT[:3]), TILT[3]
    v = CABINET.mesh.vertices
    want = v + 2 * np.cross(axis, np.cross(axis, v) + w * v) + np.array([4.0, 1.5, 0.6])
    assert np.allclose(found.min(0), want.min(0), atol=1e-4) and np.allclose(found.max(0), want.max(0), atol=1e-4)


def test_a_drawer_opens_and_closes_without_hitting_its_cabinet(tmp_path) -> None:
    room = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)))
    scene = Scene(id="s", room=room, objects=(CABINET.object("cabinet", pose=Pose.from_yaw(2, 2, 0, 0.7)),))
    model = mujoco.MjModel.from_xml_path(str(write_mjcf(scene, tmp_path / "out", ASSETS.__getitem__)))
    data = mujoco.MjData(model)
    link = next(k for k in CABINET.links if k.joint == "slide")
    joint, body = data.joint(f"cabinet.{link.name}"), data.body(f"cabinet.{link.name}")
    axis = data.joint(f"cabinet.{link.name}").xaxis
    mujoco.mj_step(model, data, 50)
    assert abs(joint.qpos[0]) < 1e-3
    reached = []
    for sign in (1, -1):
        for _ in range(500):
            body.xfrc_applied[:3] = sign * 15 * np.array(axis)
            mujoco.mj_step(model, data)
        reached.append(float(joint.qpos[0]))
    assert reached[0] > 0.9 * link.limits[1] and abs(reached[1]) < 0.01


def test_places_that_cannot_be_written(tmp_path) -> None:
    scene = _scene()
    (tmp_path / "file").write_text("dear")
    for place in (tmp_path / "no" / "out", tmp_path / "file" / "out"):
        with pytest.raises(InputError, match=f"folder: {re.escape(str(place.parent))} is no folder; make it first"):
            write_mjcf(scene, place, ASSETS.__getitem__)
    for place in (tmp_path / ("x" * 300), tmp_path / "a\0b"):
        with pytest.raises(InputError, match="folder: .* cannot be written"):
            write_mjcf(scene, place, ASSETS.__getitem__)
    (tmp_path / "file").unlink()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letters.txt").write_text("dear")
    with pytest.raises(InputError, match="holds other things"):
        write_mjcf(scene, tmp_path / "mine", ASSETS.__getitem__)
    assert (tmp_path / "mine" / "letters.txt").read_text() == "dear"
    write_mjcf(scene, tmp_path / "out", ASSETS.__getitem__)
    write_mjcf(scene, tmp_path / "out", ASSETS.__getitem__)  # an older export is replaced
    assert sorted(os.listdir(tmp_path)) == ["mine", "out"]


def test_a_disk_that_fills_up_leaves_nothing_half_written(tmp_path, monkeypatch) -> None:
    scene, out = _scene(), tmp_path / "out"
    write_mjcf(scene, out, ASSETS.__getitem__)
    before = {p: p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file()}
    count = 0

    def full(*_: object) -> None:
        nonlocal count
        count += 1
        if count > 3:
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    fewer = scene.model_copy(update={"objects": scene.objects[:2]})
    with pytest.raises(InputError, match=f"folder: {re.escape(str(out))} cannot be written .No space left"):
        write_mjcf(fewer, out, ASSETS.__getitem__)
    assert {p: p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file()} == before
    assert os.listdir(tmp_path) == ["out"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is forbidden to root")
def test_a_folder_that_may_not_be_written(tmp_path) -> None:
    shut = tmp_path / "shut"
    shut.mkdir(mode=0o500)
    with pytest.raises(
        InputError, match=f"folder: {re.escape(str(shut / 'out'))} cannot be written .Permission denied"
    ):
        write_mjcf(_scene(), shut / "out", ASSETS.__getitem__)
    assert not os.listdir(shut)


def test_a_missing_asset_is_named(tmp_path) -> None:
    def none(object_id: str):
        raise InputError(f"asset: no source has '{object_id}'")

    with pytest.raises(InputError, match=r"objects\[0\].asset"):
        write_mjcf(_scene(), tmp_path / "out", none)
    assert not os.listdir(tmp_path)
