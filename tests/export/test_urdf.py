"""URDF folders of single pieces, read by MuJoCo and as plain XML."""

from __future__ import annotations

import os
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest
import trimesh
from scipy.optimize import linear_sum_assignment

from sceneweaver.assets import Asset, Hull, Link, Material, Mesh, Origin, make
from sceneweaver.export.urdf import write_urdf
from sceneweaver.physics.inertia import inertia_of
from sceneweaver.physics.solids import Solid
from sceneweaver.scene import InputError, Part, Pose, SceneObject, Support

mujoco: Any = import_module("mujoco")

FRIDGE, CABINET, CHAIR = make("fridge", 1), make("filing_cabinet", 1), make("armchair", 2)


def _block(low: tuple[float, ...], high: tuple[float, ...]) -> trimesh.Trimesh:
    return trimesh.creation.box(bounds=(low, high))


def _chest() -> Asset:
    """A wedge with a flap on a slanting hinge at its left and a drawer to the front: nothing of it is symmetric."""
    wedge = trimesh.convex.convex_hull(
        np.array([(-0.3, -0.2, 0), (0.1, -0.2, 0), (0.1, 0.3, 0), (-0.3, 0.3, 0), (-0.3, -0.1, 0.2), (-0.2, 0.3, 0.5)])
    )
    corners = [(-0.2, 0.1), (0.05, 0.1), (-0.05, 0.3), (-0.2, 0.3)]
    flap = trimesh.convex.convex_hull(np.array([(x, y, z) for x, z in corners for y in (0.3, 0.32)]))
    drawer = _block((0.1, -0.1, 0.05), (0.15, 0.2, 0.25))
    pieces = (wedge, flap, drawer)
    starts = np.cumsum([0, *(len(p.vertices) for p in pieces)])
    faces = np.concatenate([p.faces + s for p, s in zip(pieces, starts, strict=False)]).astype(np.int32)
    link = np.repeat(np.arange(3, dtype=np.int32), [len(p.faces) for p in pieces])
    mesh = Mesh(
        np.concatenate([p.vertices for p in pieces]),
        faces,
        np.minimum(link, 1),
        link,
        (
            Material("oak & <ash>", (0.7, 0.5, 0.3)),
            Material("smoked glass", (0.1, 0.2, 0.3), opacity=0.5, emission=0.2),
        ),
    )
    axis = np.array([0.6, 0.0, 0.8])
    return Asset(
        id="test:chest/1.0 é",
        category="odd chest",
        mesh=mesh,
        hulls=tuple(Hull(np.asarray(p.vertices), np.asarray(p.faces), k) for k, p in enumerate(pieces)),
        parts=(Part(polygon=((-0.3, -0.2), (0.15, -0.2), (0.15, 0.32), (-0.3, 0.32)), z=(0, 0.5)),),
        mount="floor",
        mass=12.5,
        friction=0.7,
        origin=Origin("test", "CC0"),
        links=(
            Link("flap 1", "hinge", tuple(axis.tolist()), (-0.2, 0.31, 0.1), (-0.4, 1.1)),
            Link("flap_1", "slide", (1.0, 0.0, 0.0), (0.1, -0.1, 0.05), (0.0, 0.2)),
        ),
    )


CHEST = _chest()


def _load(path: Path) -> Any:
    return mujoco.MjModel.from_xml_path(str(path))


def _bounds(model: Any, data: Any, geom: int) -> list[float]:
    """Lower and upper corner of a box or mesh in the world."""
    m = model.geom_dataid[geom]
    if m < 0:
        local = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * model.geom_size[geom]
    else:
        local = model.mesh_vert[model.mesh_vertadr[m] : model.mesh_vertadr[m] + model.mesh_vertnum[m]]
    points = local @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
    return [*points.min(axis=0).tolist(), *points.max(axis=0).tolist()]


def _seen(model: Any, data: Any, body: str) -> np.ndarray:
    """World vertices of what is seen of a body; what is not a box or part."""
    points = []
    for g in range(model.ngeom):
        if model.body(model.geom_bodyid[g]).name == body and model.geom_contype[g] == 0:
            m = model.geom_dataid[g]
            local = model.mesh_vert[model.mesh_vertadr[m] : model.mesh_vertadr[m] + model.mesh_vertnum[m]]
            points.append(local @ data.geom_xmat[g].reshape(3, 3).T + data.geom_xpos[g])
    return np.concatenate(points)


def _turned(points: np.ndarray, axis: np.ndarray, anchor: np.ndarray, angle: float) -> np.ndarray:
    """Rodrigues' formula."""
    p = points - anchor
    along = np.outer(p @ axis, axis)
    return anchor + along + np.cos(angle) * (p - along) + np.sin(angle) * np.cross(axis, p)


@pytest.mark.parametrize("asset", [FRIDGE, CABINET, CHAIR, CHEST], ids=lambda a: a.category)
def test_mujoco_reads_links_joints_and_mass(asset, tmp_path, monkeypatch) -> None:
    path = write_urdf(asset, tmp_path / "out")
    moved = path.parent.rename(tmp_path / "elsewhere") / path.name
    monkeypatch.chdir("/")
    model = _load(moved)
    assert model.njnt == len(asset.links) and model.nbody == 2 + len(asset.links)
    assert model.body_mass.sum() == pytest.approx(asset.mass, rel=1e-6)
    slide, hinge = mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_HINGE
    for k, link in enumerate(asset.links):
        assert model.jnt_type[k] == (slide if link.joint == "slide" else hinge)
        np.testing.assert_allclose(model.jnt_axis[k], link.axis, atol=1e-8)
        np.testing.assert_allclose(model.jnt_range[k], link.limits, atol=1e-8)
        assert model.dof_damping[k] > 0 and model.dof_frictionloss[k] > 0
    # Collision parts are those of the asset, each in its link and where the asset has it.
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    solids = [g for g in range(model.ngeom) if model.geom_contype[g]]
    found = np.array([(model.geom_bodyid[g] - 1, *_bounds(model, data, g)) for g in solids])
    wanted = np.array([(h.link, *h.vertices.min(axis=0), *h.vertices.max(axis=0)) for h in asset.hulls])
    assert len(found) == len(wanted)
    apart = np.abs(found[:, None] - wanted[None]).max(axis=2)
    one, two = linear_sum_assignment(apart)
    assert apart[one, two].max() < 5e-3, "what is nearly a box may be one that is a little narrower"
    assert np.abs(found[one] - wanted[two])[:, [0, 3, 6]].max() < 2e-5, "but as high and on the same level"


@pytest.mark.parametrize("asset", [FRIDGE, CABINET, CHEST], ids=lambda a: a.category)
def test_doors_move_about_their_axes(asset, tmp_path) -> None:
    model = _load(write_urdf(asset, tmp_path / "out"))
    data = mujoco.MjData(model)
    names = [model.body(k + 2).name for k in range(len(asset.links))]
    for share in (0.0, 0.6):
        data.qpos[:] = [link.limits[0] + share * (link.limits[1] - link.limits[0]) for link in asset.links]
        if share == 0.0:
            data.qpos[:] = 0.0
        mujoco.mj_forward(model, data)
        for k, (name, link) in enumerate(zip(["base", *names], [None, *asset.links], strict=True)):
            at = 0.0 if link is None else float(data.qpos[k - 1])
            own = asset.mesh.vertices[np.unique(asset.mesh.faces[asset.mesh.face_link == k])]
            if link is not None and link.joint == "slide":
                own = own + np.asarray(link.axis) * at
            elif link is not None:
                own = _turned(own, np.asarray(link.axis), np.asarray(link.anchor), at)
            found = _seen(model, data, name)
            np.testing.assert_allclose(found.min(axis=0), own.min(axis=0), atol=1e-5)
            np.testing.assert_allclose(found.max(axis=0), own.max(axis=0), atol=1e-5)


@pytest.mark.parametrize("asset", [FRIDGE, CABINET], ids=lambda a: a.category)
@pytest.mark.parametrize("fixed", [True, False])
def test_a_pull_opens_what_friction_holds(asset, fixed, tmp_path) -> None:
    spec = mujoco.MjSpec.from_file(str(write_urdf(asset, tmp_path / "out")))
    spec.option.timestep, spec.option.integrator = 0.004, mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    names = [link.name for link in spec.bodies if link.name not in ("world", "base")]
    for name in names if fixed else ():
        left = spec.add_exclude()
        left.bodyname1, left.bodyname2 = "base", name
    if not fixed:
        spec.body("base").add_freejoint()
        spec.option.gravity = (0, 0, 0)
    model = spec.compile()
    data = mujoco.MjData(model)
    joints = [model.joint(f"{name}_joint") for name in names]
    at, dof = [int(j.qposadr[0]) for j in joints], [int(j.dofadr[0]) for j in joints]
    for _ in range(100):
        mujoco.mj_step(model, data)
    assert data.ncon == 0 and np.abs(data.qpos[at]).max() < 1e-3, "closed, and nothing pushes"
    goal = 0.9 * np.array([j.range[1] for j in joints])
    for _ in range(1500):
        pull = np.clip(400 * (goal - data.qpos[at]), -20, 20) - 20 * data.qvel[dof]
        data.qfrc_applied[dof] = pull
        mujoco.mj_step(model, data)
        assert data.ncon == 0
    np.testing.assert_allclose(data.qpos[at], goal, rtol=0.05)


@pytest.mark.parametrize("asset", [FRIDGE, CABINET, CHAIR, CHEST], ids=lambda a: a.category)
def test_inertias_are_those_of_the_parts(asset, tmp_path) -> None:
    root = Xml.parse(write_urdf(asset, tmp_path / "out")).getroot()
    slack = 1e-6 if asset is CHEST else 0.03  # elsewhere hulls that are nearly boxes have become boxes
    hulls = [(h.link, trimesh.convex.convex_hull(h.vertices)) for h in asset.hulls]
    volumes = [sum(shape.volume for number, shape in hulls if number == k) for k in range(len(asset.links) + 1)]
    masses = np.array(asset.masses or volumes) * asset.mass / sum(asset.masses or volumes)
    anchors = [np.zeros(3), *(np.asarray(link.anchor) for link in asset.links)]
    for k, link in enumerate(root.iter("link")):
        inertial = link.find("inertial")
        assert inertial is not None
        entries = {name: float(v) for name, v in inertial.find("inertia").attrib.items()}  # type: ignore[union-attr]
        tensor = np.array([[entries["i" + "".join(sorted(a + b))] for b in "xyz"] for a in "xyz"])
        centre = np.array(inertial.find("origin").get("xyz").split(), dtype=float)  # type: ignore[union-attr]
        low, middle, high = np.linalg.eigvalsh(tensor)
        assert low > 0 and high <= low + middle + 1e-9
        mass, total, spread = 0.0, np.zeros(3), np.zeros((3, 3))
        for number, shape in hulls:
            if number == k:
                shape.density = masses[k] / volumes[k]
                off = shape.center_mass - (centre + anchors[k])
                mass, total = mass + shape.mass, total + shape.mass * shape.center_mass
                spread += shape.moment_inertia + shape.mass * (off @ off * np.eye(3) - np.outer(off, off))
        assert float(inertial.find("mass").get("value")) == pytest.approx(mass, rel=slack)  # type: ignore[union-attr]
        np.testing.assert_allclose(centre + anchors[k], total / mass, atol=slack)
        np.testing.assert_allclose(tensor, spread, atol=slack * np.trace(spread))


def test_inertia_of_a_tetrahedron_by_sampling() -> None:
    corners = np.array([(0, 0, 0), (1, 0, 0), (0.2, 2, 0), (0.3, 0.4, 3)], dtype=float) + 5
    rng = np.random.default_rng(0)
    weights = rng.dirichlet((1, 1, 1, 1), 400_000)  # even over the tetrahedron
    points = weights @ corners
    found = inertia_of([Solid(corners, 1.0)], [2.0])
    off = points - points.mean(axis=0)
    tensor = 2.0 * ((off**2).sum(axis=1).mean() * np.eye(3) - off.T @ off / len(off))
    np.testing.assert_allclose(found.centre, points.mean(axis=0), atol=5e-3)
    np.testing.assert_allclose(found.tensor, tensor, atol=5e-3)
    assert found.mass == 2.0


def test_names_colours_and_meshes(tmp_path) -> None:
    path = write_urdf(CHEST, tmp_path / "out")
    root = Xml.parse(path).getroot()
    assert [link.get("name") for link in root.iter("link")] == ["base", "flap_1", "flap_1_2"]
    colors = {m.get("name"): m.find("color").get("rgba") for m in root.findall("material")}  # type: ignore[union-attr]
    assert colors == {"oak____ash_": "0.7 0.5 0.3 1", "smoked_glass": "0.1 0.2 0.3 0.5"}
    named = {m.get("filename") for m in root.iter("mesh")}
    assert all((path.parent / str(name)).is_file() for name in named)
    assert {f"meshes/{n}" for n in os.listdir(path.parent / "meshes")} == named | {"meshes/materials.mtl"}
    shape: Any = trimesh.load(path.parent / "meshes" / "flap_1-smoked_glass.obj", force="mesh")
    assert shape.is_watertight and shape.volume == pytest.approx((0.25 + 0.15) / 2 * 0.02 * 0.2)
    looks = shape.visual.material
    np.testing.assert_allclose(np.asarray(looks.diffuse[:3]) / 255, (0.1, 0.2, 0.3), atol=5e-3)
    for name in os.listdir(path.parent / "meshes"):
        if "-part-" in name:
            part: Any = trimesh.load(path.parent / "meshes" / name, force="mesh")
            assert part.is_watertight and part.volume > 0 and part.is_convex


def test_an_object_in_its_size(tmp_path) -> None:
    d, w, h = CHEST.size
    where = Pose.from_yaw(3.0, 1.0, 0.5, 2.0)
    thing = CHEST.object("x", pose=where, support=Support(object="y", surface="top"))
    thing = thing.model_copy(update={"size": (d * 1.5, w * 0.8, h * 2.0)})
    model = _load(write_urdf(thing, tmp_path / "out", {CHEST.id: CHEST}.__getitem__))
    assert model.body_mass.sum() == pytest.approx(12.5 * 1.5 * 0.8 * 2.0, rel=1e-6)
    np.testing.assert_allclose(model.jnt_range[1], (0, 0.2 * 1.5), atol=1e-8)
    np.testing.assert_allclose(model.jnt_range[0], (-0.4, 1.1), atol=1e-8)
    np.testing.assert_allclose(model.body_pos[2], np.array([-0.2, 0.31, 0.1]) * (1.5, 0.8, 2.0), atol=1e-8)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    base = CHEST.mesh.vertices[np.unique(CHEST.mesh.faces[CHEST.mesh.face_link == 0])] * (1.5, 0.8, 2.0)
    np.testing.assert_allclose(_seen(model, data, "base").max(axis=0), base.max(axis=0), atol=1e-6)


def test_pieces_without_asset_or_parts(tmp_path) -> None:
    parts = (
        Part(polygon=((-0.3, -0.2), (0.3, -0.2), (0, 0.4)), z=(0, 0.5)),
        Part(polygon=((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)), z=(0.5, 0.8)),
    )
    plinth = SceneObject(id="p", category="unheard of", size=(0.6, 0.6, 0.8), parts=parts)
    model = _load(write_urdf(plinth, tmp_path / "plinth"))
    assert model.nbody == 2 and sum(model.geom_contype > 0) == 2
    assert model.body_mass.sum() == pytest.approx(150 * (0.5 * 0.6 * 0.6 * 0.5 + 0.04 * 0.3), rel=1e-6)
    bare = replace(CHAIR, hulls=(), parts=())
    model = _load(write_urdf(bare, tmp_path / "chair"))
    assert sum(model.geom_contype > 0) == 1 and model.body_mass.sum() == pytest.approx(CHAIR.mass, rel=1e-6)
    # Doors without parts of their own do not move.
    half = replace(FRIDGE, hulls=tuple(hull for hull in FRIDGE.hulls if hull.link == 0))
    model = _load(write_urdf(half, tmp_path / "fridge"))
    assert model.nbody == 2 and (model.body_mass[1:] > 0).all()


def test_errors_leave_nothing_behind(tmp_path) -> None:
    bare = {name: getattr(CHAIR.mesh, name)[:0] for name in ("faces", "face_material", "face_link")}
    empty = replace(CHAIR, mesh=replace(CHAIR.mesh, **bare))

    def gone(object_id: str) -> Asset:
        raise InputError(f"asset: no source has '{object_id}'")

    cases = [
        (lambda: write_urdf(empty, tmp_path / "out"), r"^asset: '.*' has no mesh; "),
        (lambda: write_urdf(CHAIR.object("c"), tmp_path / "out", {CHAIR.id: empty}.__getitem__), r"^asset: .* no mesh"),
        (lambda: write_urdf(CHAIR.object("c"), tmp_path / "out", gone), r"^asset: no source has"),
        (lambda: write_urdf(CHAIR, tmp_path / "no" / "out"), r"^folder: .*no is no folder; make it first"),
        (lambda: write_urdf(CHAIR, "/proc/out"), r"^folder: /proc/out cannot be written"),
    ]
    for call, message in cases:
        with pytest.raises(InputError, match=message) as caught:
            call()
        assert "\n" not in str(caught.value)
        assert os.listdir(tmp_path) == []


def test_only_exports_are_replaced(tmp_path) -> None:
    first = write_urdf(CHAIR, tmp_path / "out")
    second = write_urdf(FRIDGE, tmp_path / "out")
    assert not first.exists() and second.exists() and _load(second).njnt == 2
    (tmp_path / "out" / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="holds other things"):
        write_urdf(CHAIR, tmp_path / "out")
    assert second.exists() and (tmp_path / "out" / "notes.txt").read_text() == "mine"
    assert os.listdir(tmp_path) == ["out"]
