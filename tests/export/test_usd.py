"""USD stages, read back by pxr alone: what a simulator is told must be what the scene says."""

from __future__ import annotations

import math
import os
import re
from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from scipy.spatial import ConvexHull, Delaunay, KDTree

from sceneweaver.assets import make
from sceneweaver.assets.textures import maps
from sceneweaver.export.images import linear
from sceneweaver.export.room import floor_mesh
from sceneweaver.export.slices import FEW_VERTICES, sliced
from sceneweaver.export.usd import usd_layer, write_usd
from sceneweaver.export.usd_bodies import _turn
from sceneweaver.export.usd_mesh import corner_normals, hull_faces
from sceneweaver.physics.leaves import leaves
from sceneweaver.physics.solids import Solid
from sceneweaver.physics.things import things_of
from sceneweaver.scene import EXAMPLES, Door, InputError, Part, Pose, Room, Scene, SceneObject, Support, Window

Gf, Sdf, Usd, UsdGeom, UsdPhysics, UsdShade, UsdSemantics, UsdValidation = (
    import_module(f"pxr.{name}")
    for name in ("Gf", "Sdf", "Usd", "UsdGeom", "UsdPhysics", "UsdShade", "UsdSemantics", "UsdValidation")
)  # type: tuple[Any, ...]

ROOM = Room(
    outline=((0, 0), (6, 0), (6, 3), (4, 3), (4, 5), (0, 5)),
    height=2.6,
    doors=(
        Door(id="door-0", wall=0, offset=0.5, width=0.9, height=2.0),
        Door(id="door 1", wall=5, offset=2.5, width=0.9, height=2.1, swing="slide"),
    ),
    windows=(Window(id="window-0", wall=1, offset=1.0, width=1.2, sill=0.9, height=1.2),),
)
DESK, CABINET, COUNTER, MUG, RUG = (
    make("desk", 2),
    make("filing_cabinet", 1),
    make("kitchen_counter", 1),
    make("mug", 2),
    make("rug", 1),
)
ASSETS = {a.id: a for a in (DESK, CABINET, COUNTER, MUG, RUG)}
TILT = tuple((np.array([0.2, -0.1, 0.3, 0.9]) / np.linalg.norm([0.2, -0.1, 0.3, 0.9])).tolist())
SCALE = (1.2, 0.8, 1.1)


_FRAME = "sceneweaver:frame"


def _scaled(asset, object_id: str, scale, pose: Pose) -> SceneObject:
    """An object of an asset in another size."""
    x, y, z = scale
    parts = tuple(
        Part(polygon=tuple((a * x, b * y) for a, b in part.polygon), z=(part.z[0] * z, part.z[1] * z))
        for part in asset.parts
    )
    d, w, h = asset.size
    return SceneObject(
        id=object_id, category=asset.category, size=(d * x, w * y, h * z), pose=pose, asset=asset.id, parts=parts
    )


def _scene() -> Scene:
    top = DESK.surfaces[0]
    objects = (
        DESK.object("desk é/1", pose=Pose.from_yaw(1.5, 1.5, 0.0, 2.1)),
        DESK.object("desk é-1", pose=Pose.from_yaw(4.5, 1.5, 0.0, -1.2)),
        _scaled(DESK, "large desk", SCALE, Pose(position=(2.5, 3.8, 0.4), quaternion=TILT)),
        CABINET.object("cabinet", pose=Pose(position=(5.0, 1.5, 0.6), quaternion=TILT)),
        _scaled(CABINET, "wide cabinet", SCALE, Pose(position=(5.4, 2.5, 0.1), quaternion=TILT)),
        COUNTER.object("counter", pose=Pose.from_yaw(1.0, 4.4, 0.0, -math.pi / 2 + 0.1)),
        RUG.object("rug", pose=Pose.from_yaw(1.4, 1.4, 0.0, 0.5)),
        MUG.object(
            "mug", pose=Pose.from_yaw(1.5, 1.5, top.z, 0.3), support=Support(object="desk é/1", surface=top.name)
        ),
        SceneObject(id="box", category="unheard of", size=(0.3, 0.4, 0.5), pose=Pose.from_yaw(0.5, 3.5, 0.0, 0.4)),
        SceneObject(
            id="clock", category="clock", size=(0.1, 0.4, 0.4), pose=Pose.from_yaw(3.0, 0.1, 1.5, 1.6), mount="wall"
        ),
    )
    return Scene(id="s", prompt='an "office"', room=ROOM, objects=objects)


SCENE = _scene()


@pytest.fixture(scope="module")
def stage(tmp_path_factory) -> Any:
    path = tmp_path_factory.mktemp("usd") / "scene.usdc"
    write_usd(SCENE, path, ASSETS.__getitem__)
    return Usd.Stage.Open(str(path))


def _objects(stage) -> dict[str, Any]:
    found = stage.GetPrimAtPath("/World/Objects").GetChildren()
    return {prim.GetCustomDataByKey("sceneweaver:id"): prim for prim in found}


def _all(root) -> list[Any]:
    return list(Usd.PrimRange(root, Usd.TraverseInstanceProxies()))


def _world(prim) -> np.ndarray:
    """The matrix [4, 4] of a prim for column vectors."""
    return np.array(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())).T


def _matrix(position, quaternion) -> np.ndarray:
    x, y, z, w = quaternion
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    return np.block([[turn, np.asarray(position, dtype=float)[:, None]], [np.zeros(3), 1.0]])


def _colliders(root) -> list[Any]:
    return [p for p in _all(root) if p.HasAPI(UsdPhysics.CollisionAPI)]


def _bodies(root) -> list[Any]:
    return [p for p in _all(root) if p.HasAPI(UsdPhysics.RigidBodyAPI)]


def _corners(collider) -> np.ndarray:
    """The corners of a collider in the world [V, 3]."""
    if collider.IsA(UsdGeom.Cube):
        half = UsdGeom.Cube(collider).GetSizeAttr().Get() / 2
        points = np.array([(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)])
    else:
        points = np.array(UsdGeom.Mesh(collider).GetPointsAttr().Get(), dtype=float)
    matrix = _world(collider)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _errors(stage) -> list[str]:
    """What all validators of usd-core have against a stage."""
    registry = UsdValidation.ValidationRegistry()
    validators = registry.GetOrLoadAllValidators()
    assert len(validators) > 25
    return [e.GetErrorAsString() for e in UsdValidation.ValidationContext(validators).Validate(stage)]


def _uninstanced(stage) -> Any:
    """The stage in memory with nothing shared, so that each prim is looked at."""
    copy = Usd.Stage.Open(stage.Flatten())
    for prim in stage.Traverse():
        if prim.IsInstance():
            copy.GetPrimAtPath(prim.GetPath()).SetInstanceable(False)
    assert not any(prim.IsInstance() for prim in copy.Traverse())
    return copy


@pytest.mark.parametrize("suffix", ["usda", "usdc"])
def test_the_validators_of_usd_have_nothing_against_it(tmp_path, suffix) -> None:
    path = tmp_path / f"scene.{suffix}"
    write_usd(SCENE, path, ASSETS.__getitem__)
    stage = Usd.Stage.Open(str(path))
    assert not stage.GetCompositionErrors()
    assert _errors(stage) == []
    assert _errors(_uninstanced(stage)) == []
    assert sorted(os.listdir(tmp_path)) == [path.name, "textures"]
    # They do look: a body that has no place is found.
    UsdPhysics.RigidBodyAPI.Apply(stage.GetPrimAtPath("/World/Looks"))
    assert _errors(stage)


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_examples_are_valid(name) -> None:
    scene = Scene.example(name)
    bare = scene.model_copy(update={"objects": tuple(o.model_copy(update={"asset": None}) for o in scene.objects)})
    stage = Usd.Stage.Open(usd_layer(bare))
    assert _errors(stage) == []
    assert len(_objects(stage)) == len(scene.objects)


def test_the_stage_is_in_metres_and_kilograms_z_up(stage) -> None:
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1.0
    assert str(stage.GetDefaultPrim().GetPath()) == "/World"
    assert Usd.ModelAPI(stage.GetDefaultPrim()).GetKind() == "assembly"
    scenes = [UsdPhysics.Scene(p) for p in stage.Traverse() if p.IsA(UsdPhysics.Scene)]
    assert [s.GetGravityMagnitudeAttr().Get() for s in scenes] == [pytest.approx(9.81)]
    assert scenes[0].GetGravityDirectionAttr().Get() == Gf.Vec3f(0, 0, -1)
    assert all(prim.IsModel() for prim in _objects(stage).values())


def test_poses_come_back(stage) -> None:
    found = _objects(stage)
    assert list(found) == [o.id for o in SCENE.objects]
    for thing in SCENE.objects:
        prim = found[thing.id]
        assert prim.GetMetadata("displayName") == thing.id and Sdf.Path.IsValidIdentifier(prim.GetName())
        assert np.allclose(_world(prim), _matrix(thing.pose.position, thing.pose.quaternion), atol=1e-6)
        x, y, z, w = thing.pose.quaternion
        orient = prim.GetAttribute("xformOp:orient").Get()
        assert orient.GetReal() == pytest.approx(w) and np.allclose(orient.GetImaginary(), (x, y, z))
        assert list(prim.GetAttribute("xformOpOrder").Get()) == [
            "xformOp:translate",
            "xformOp:orient",
            "xformOp:scale",
        ]


def test_what_is_seen_is_the_mesh_at_its_place(stage) -> None:
    found = _objects(stage)
    for thing in SCENE.objects:
        if thing.asset is None:
            continue
        asset, points, faces, area = ASSETS[thing.asset], [], 0, 0
        for prim in _all(found[thing.id]):
            if not prim.IsA(UsdGeom.Mesh) or prim.HasAPI(UsdPhysics.CollisionAPI):
                continue
            mesh, matrix = UsdGeom.Mesh(prim), _world(prim)
            local = np.array(mesh.GetPointsAttr().Get(), dtype=float)
            points.append(local @ matrix[:3, :3].T + matrix[:3, 3])
            faces += len(mesh.GetFaceVertexCountsAttr().Get())
            area += 1
            assert np.allclose(mesh.GetExtentAttr().Get(), [local.min(axis=0), local.max(axis=0)], atol=1e-6)
            assert mesh.GetSubdivisionSchemeAttr().Get() == "none" and mesh.ComputePurpose() == "default"
            normals = UsdGeom.PrimvarsAPI(prim).GetPrimvar("normals")
            assert normals.GetInterpolation() == "faceVarying"
            shaded = np.array(normals.ComputeFlattened())
            assert len(shaded) == len(mesh.GetFaceVertexIndicesAttr().Get())
            assert np.allclose(np.linalg.norm(shaded, axis=1), 1, atol=1e-5)
        matrix = _matrix(thing.pose.position, thing.pose.quaternion)
        scale = np.asarray(thing.size) / np.asarray(asset.size)
        want = asset.mesh.vertices * scale @ matrix[:3, :3].T + matrix[:3, 3]
        got = np.concatenate(points)
        assert faces == len(asset.mesh.faces) and area == 1 + len(asset.links)
        assert np.allclose(got.min(0), want.min(0), atol=1e-5) and np.allclose(got.max(0), want.max(0), atol=1e-5)
        for one, other in ((got, want), (want, got)):
            assert KDTree(one).query(other)[0].max() < 1e-4, "every point is one of the other's"


def test_what_may_move_is_a_body_of_its_mass(stage) -> None:
    found = _objects(stage)
    for thing in things_of(SCENE, ASSETS.__getitem__):
        prim = found[thing.object.id]
        bodies = _bodies(prim)
        if thing.asset is not None and thing.asset.links:
            assert prim not in bodies and len(bodies) == 1 + len(thing.asset.links)
            assert all(body.GetParent() == prim for body in bodies)
        else:
            assert bodies == ([prim] if thing.free else [])
        if bodies:
            masses = [UsdPhysics.MassAPI(body).GetMassAttr().Get() for body in bodies]
            assert sum(masses) == pytest.approx(thing.mass, rel=1e-5) and min(masses) > 0
    assert not _bodies(found["clock"]) and _colliders(found["clock"])
    assert _bodies(found["box"]) == [found["box"]]
    for body in _bodies(stage.GetPseudoRoot()):
        above = body.GetParent()
        while above:
            assert not above.HasAPI(UsdPhysics.RigidBodyAPI)
            above = above.GetParent()


def test_inertia_is_that_of_the_parts(stage) -> None:
    """Against what the mass properties of the colliders are, found by random points in them."""
    rng = np.random.default_rng(1)
    found = _objects(stage)
    thing = next(t for t in things_of(SCENE, ASSETS.__getitem__) if t.object.id == "large desk")
    body = UsdPhysics.MassAPI(found["large desk"])
    boxes = [(s.points.min(axis=0), s.points.max(axis=0), s) for s in thing.solids]
    weights = np.array([s.volume for _, _, s in boxes])
    samples, shares = [], []
    for (low, high, solid), weight in zip(boxes, weights, strict=True):
        inside = rng.uniform(low, high, (4000, 3))
        if solid.box is None:
            inside = inside[Delaunay(solid.points).find_simplex(inside) >= 0]
        samples.append(inside)
        shares.append(np.full(len(inside), weight / weights.sum() / len(inside)))
    points, share = np.concatenate(samples), np.concatenate(shares)
    centre = share @ points
    assert np.allclose(body.GetCenterOfMassAttr().Get(), centre, atol=5e-3)
    off = points - centre
    spread = thing.mass * (off * share[:, None]).T @ off
    want = np.trace(spread) * np.eye(3) - spread
    axes = body.GetPrincipalAxesAttr().Get()
    turn = _matrix((0, 0, 0), (*axes.GetImaginary(), axes.GetReal()))[:3, :3]
    got = turn @ np.diag(body.GetDiagonalInertiaAttr().Get()) @ turn.T
    assert np.allclose(got, want, atol=0.03 * np.abs(want).max())


def test_engines_are_told_what_usd_has_no_words_for(stage) -> None:
    """Each in its own schema, so that a drawer is as hard to move in all of them."""
    found = _objects(stage)
    joint = next(p for p in _all(found["cabinet"]) if p.IsA(UsdPhysics.PrismaticJoint))
    friction = joint.GetAttribute("newton:friction").Get()
    assert friction >= 1.0 and joint.GetAttribute("mjc:frictionloss").Get() == pytest.approx(friction)
    assert joint.GetAttribute("physxJointAxis:linear:staticFrictionEffort").Get() == pytest.approx(friction)
    assert joint.GetAttribute("drive:linear:physics:maxForce").Get() > 2 * friction
    for collider in _colliders(stage.GetPrimAtPath("/World")):
        assert collider.GetAttribute("physxCollision:restOffset").Get() == 0
        assert 0 < collider.GetAttribute("physxCollision:contactOffset").Get() <= 0.01


def _pieces(thing, solid: Solid) -> list[Solid]:
    """What a part of a thing is cut into, which is done in the size of its asset."""
    scale = np.asarray(thing.scale)
    cut = sliced(solid if solid.box else replace(solid, points=solid.points / scale))
    return [piece if piece.box else replace(piece, points=piece.points * scale) for piece in cut]


def test_no_hull_is_too_oblong_for_a_gpu() -> None:
    """A round board of 6 mm and a tilted rod: their slices fill them, and have a ball of a hundredth inside."""
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    ring = 0.3 * np.column_stack([np.cos(turn), np.sin(turn)])
    board = np.concatenate([np.column_stack([ring, np.full(24, z)]) for z in (0.0, 0.006)])
    rod = board * (0.02, 0.02, 250.0) @ _matrix((0, 0, 0), TILT)[:3, :3].T
    for points in (board, rod):
        pieces = [piece.points for piece in sliced(Solid(points, 1.0))]
        hulls = [ConvexHull(piece) for piece in pieces]
        assert 1 < len(pieces) <= 16
        assert sum(hull.volume for hull in hulls) == pytest.approx(ConvexHull(points).volume)
        for piece, hull in zip(pieces, hulls, strict=True):
            inside = -(hull.equations[:, :3] @ piece.mean(axis=0) + hull.equations[:, 3]).max()
            assert np.ptp(piece, axis=0).max() < 100 * inside
    assert len(sliced(Solid(board * (1, 1, 10), 1.0))) == 1


def test_hulls_are_of_few_vertices_and_stand_as_they_did() -> None:
    """A vase of 64 vertices, which would tilt in PhysX: fewer of the same, the underside as wide."""
    vase = make("flower_vase", seed=3)
    thing = SceneObject(id="vase", category="flower_vase", asset="vase", size=vase.size, pose=Pose(position=(0, 0, 0)))
    room = Room(outline=((0, 0), (2, 0), (2, 2), (0, 2)), height=2.5)
    (found,) = things_of(Scene(id="s", room=room, objects=(thing,)), {"vase": vase}.__getitem__)
    rich = [solid for solid in found.solids if len(solid.points) > FEW_VERTICES]
    assert rich
    for solid in rich:
        (piece,) = sliced(solid)
        assert len(piece.points) <= FEW_VERTICES
        assert {tuple(p) for p in piece.points} <= {tuple(p) for p in solid.points}
        assert ConvexHull(piece.points).volume > 0.9 * solid.volume
    before, after = (s.points[s.points[:, 2] < 1e-5, :2] for s in (rich[0], *sliced(rich[0])))
    assert len(before) >= 8 and ConvexHull(after).volume == pytest.approx(ConvexHull(before).volume)


def test_colliders_are_the_convex_parts(stage) -> None:
    found = _objects(stage)
    for thing in things_of(SCENE, ASSETS.__getitem__):
        matrix = _matrix(thing.object.pose.position, thing.object.pose.quaternion)
        prim = found[thing.object.id]
        colliders = _colliders(prim)
        by_link = [
            piece for solid in sorted(thing.solids, key=lambda solid: solid.link) for piece in _pieces(thing, solid)
        ]
        assert len(colliders) == len(by_link)
        for collider, solid in zip(colliders, by_link, strict=True):
            assert UsdGeom.Imageable(collider).ComputePurpose() == "guide"
            local = solid.points
            if solid.box is not None:
                (x, y, z), (a, b, c) = solid.box
                local = np.array([(x - a, y - b, z - c), (x + a, y + b, z + c)])
                local = np.array([(p[0], q[1], r[2]) for p in local for q in local for r in local])
                assert collider.IsA(UsdGeom.Cube)
            else:
                assert UsdPhysics.MeshCollisionAPI(collider).GetApproximationAttr().Get() == "convexHull"
            want = local @ matrix[:3, :3].T + matrix[:3, 3]
            assert np.allclose(_corners(collider), want, atol=1e-5)


def test_a_simulator_finds_bodies_shapes_and_articulations(stage) -> None:
    """As usd-core's own reader of physics, which simulators are built on, sees the stage."""
    parsed = UsdPhysics.UsdPhysicsLoadStageFromPrimRange(stage, ["/"])
    kinds = {str(kind): dict(zip(map(str, paths), descs, strict=True)) for kind, (paths, descs) in parsed.items()}
    assert all(desc.isValid for descs in kinds.values() for desc in descs.values())
    found = _objects(stage)
    desk = found["desk é/1"].GetPath()
    assert len(kinds["RigidBody"][str(desk)].collisions) == len(_colliders(found["desk é/1"]))
    counter, cabinet = found["counter"].GetPath(), found["cabinet"].GetPath()
    assert kinds["Articulation"][str(counter)].rootPrims == [counter.AppendPath("joints/counter_base_joint")]
    assert kinds["Articulation"][str(cabinet)].rootPrims == [cabinet.AppendChild("cabinet_base")]
    root = kinds["FixedJoint"][str(counter.AppendPath("joints/counter_base_joint"))]
    assert root.body0 == Sdf.Path.emptyPath and root.body1 == counter.AppendChild("counter_base")
    assert np.allclose(root.localPose0Position, SCENE.object("counter").pose.position, atol=1e-5)
    shapes = {**kinds["CubeShape"], **kinds["MeshShape"]}
    still = [d for p, d in shapes.items() if p.startswith(("/World/Room/Walls", "/World/Room/Floor"))]
    assert still and all(d.rigidBody == Sdf.Path.emptyPath for d in still)
    assert all(d.materials for d in shapes.values())


def test_friction_and_looks_are_bound(stage) -> None:
    found = _objects(stage)
    for thing in things_of(SCENE, ASSETS.__getitem__):
        for collider in _colliders(found[thing.object.id]):
            bound, _ = UsdShade.MaterialBindingAPI(collider).ComputeBoundMaterial("physics")
            rub = UsdPhysics.MaterialAPI(bound.GetPrim())
            assert collider.HasAPI(UsdShade.MaterialBindingAPI)  # without it, no simulator looks for one
            assert rub.GetStaticFrictionAttr().Get() == pytest.approx(thing.friction, abs=1e-4)
            assert rub.GetDynamicFrictionAttr().Get() == pytest.approx(thing.friction, abs=1e-4)
    for object_id in ("desk é-1", "large desk"):
        (mesh,) = [p for p in _all(found[object_id]) if p.IsA(UsdGeom.Mesh) and not p.HasAPI(UsdPhysics.CollisionAPI)]
        subsets = UsdShade.MaterialBindingAPI(mesh).GetMaterialBindSubsets()
        covered = np.sort(np.concatenate([s.GetIndicesAttr().Get() for s in subsets]))
        assert np.array_equal(covered, np.arange(len(DESK.mesh.faces)))
        for subset in subsets:
            bound, _ = UsdShade.MaterialBindingAPI(subset).ComputeBoundMaterial()
            shader, *_ = bound.ComputeSurfaceSource()
            assert shader.GetIdAttr().Get() == "UsdPreviewSurface"
            face = subset.GetIndicesAttr().Get()[0]
            want = DESK.mesh.materials[DESK.mesh.face_material[face]]
            assert np.allclose(shader.GetInput("diffuseColor").Get(), linear(want.color), atol=1e-6)
            source = shader.GetInput("diffuseColor").GetConnectedSource()
            assert bool(source) == (want.texture != "plain")
            for key in ("roughness", "metallic", "opacity"):
                assert shader.GetInput(key).Get() == pytest.approx(getattr(want, key))


def test_textures_lie_beside_the_stage_and_on_the_mesh_at_their_size(tmp_path) -> None:
    """Coordinates are metres over the size of the maps."""
    write_usd(SCENE.model_copy(update={"objects": ()}), tmp_path / "scene.usda")
    (tmp_path / "scene.usda").rename(tmp_path / "moved.usda")
    stage = Usd.Stage.Open(str(tmp_path / "moved.usda"))
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Room/Floor/Mesh"))
    bound, _ = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()
    surface, *_ = bound.ComputeSurfaceSource()
    image = UsdShade.Shader(surface.GetInput("diffuseColor").GetConnectedSource()[0].GetPrim())
    path = image.GetInput("file").Get()
    assert path.path.startswith("./textures/") and os.path.isfile(path.resolvedPath)
    look = floor_mesh(SCENE.room).materials[0]
    found = maps(look.texture)
    assert found is not None
    assert image.GetInput("scale").Get()[:3] == pytest.approx([c * found.gain for c in linear(look.color)], abs=1e-4)
    st = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
    assert st.GetInterpolation() == "faceVarying"
    places = np.array(st.ComputeFlattened()).reshape(-1, 3, 2) * found.size
    points = np.array(mesh.GetPointsAttr().Get())[np.array(mesh.GetFaceVertexIndicesAttr().Get())].reshape(-1, 3, 3)
    top = (points[..., 2] == 0).all(axis=1)
    apart = places[top] - points[top][..., :2]
    np.testing.assert_allclose(apart - apart[0, 0], 0, atol=1e-3)


def test_everything_is_labelled(stage) -> None:
    for thing in SCENE.objects:
        prim = _objects(stage)[thing.id]
        labels = UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get()
        assert list(labels) == [thing.category]
        assert prim.GetAttribute("semantic:Semantics:params:semanticType").Get() == "class"
        assert prim.GetAttribute("semantic:Semantics:params:semanticData").Get() == thing.category
        assert "SemanticsAPI:Semantics" in prim.GetMetadata("apiSchemas").GetAddedOrExplicitItems()
    room = {
        UsdSemantics.LabelsAPI(p, "class").GetLabelsAttr().Get()[0]
        for p in _all(stage.GetPrimAtPath("/World/Room"))
        if p.HasAPI(UsdSemantics.LabelsAPI, "class")
    }
    assert room == {"floor", "wall", "window", "door"}


def test_equal_assets_are_instances_of_one_prototype(stage) -> None:
    found = _objects(stage)
    desks = [found[object_id].GetChild("Geometry") for object_id in ("desk é/1", "desk é-1", "large desk")]
    assert len({str(d.GetPrototype().GetPath()) for d in desks}) == 1
    assert all(not p.HasAPI(UsdPhysics.RigidBodyAPI) for p in stage.Traverse() if p.IsInstanceable())
    assert all(not p.HasAPI(UsdPhysics.RigidBodyAPI) for q in stage.GetPrototypes() for p in Usd.PrimRange(q))
    assert not [p for p in stage.Traverse() if p.GetPath().HasPrefix("/World/Prototypes/")]  # not in the scene itself


def test_88_objects_share_their_meshes(tmp_path) -> None:
    poses = [Pose.from_yaw(0.3 + 0.3 * (k % 11), 0.3 + 0.3 * (k // 11), 0.0, 0.1 * k) for k in range(88)]
    scene = Scene(
        id="s", room=ROOM, objects=tuple(MUG.object(f"mug-{k}", pose=p, mount="floor") for k, p in enumerate(poses))
    )
    sizes = []
    for count in (1, 88):
        path = tmp_path / f"{count}.usdc"
        write_usd(scene.model_copy(update={"objects": scene.objects[:count]}), path, ASSETS.__getitem__)
        sizes.append(path.stat().st_size)
    stage = Usd.Stage.Open(str(path))
    assert len(stage.GetPrototypes()) == 1 and sum(p.IsInstance() for p in stage.Traverse()) == 88
    assert sizes[1] < 2 * sizes[0]


def test_an_asset_without_hulls_collides_as_the_parts_of_its_object() -> None:
    bare = replace(MUG, hulls=())
    poses = [Pose(position=(1.0 + k, 1.0, 0.5), quaternion=TILT) for k in range(2)]
    small, large = bare.object("a", mount="floor", pose=poses[0]), _scaled(bare, "b", SCALE, poses[1])
    cut = tuple(part.model_copy(update={"z": (part.z[0], 0.5 * part.z[1])}) for part in large.parts or ())
    objects = (small, large.model_copy(update={"parts": cut}))
    stage = Usd.Stage.Open(usd_layer(Scene(id="s", room=ROOM, objects=objects), {MUG.id: bare}.__getitem__))
    assert _errors(stage) == []
    for thing in objects:
        matrix = _matrix(thing.pose.position, thing.pose.quaternion)
        local = [(x, y, z) for part in thing.solids for x, y in part.polygon for z in part.z]
        want = np.array(local) @ matrix[:3, :3].T + matrix[:3, 3]
        got = np.concatenate([_corners(c) for c in _colliders(_objects(stage)[thing.id])])
        assert np.allclose(got.min(0), want.min(0), atol=1e-5) and np.allclose(got.max(0), want.max(0), atol=1e-5)


def _frames(joint) -> tuple[np.ndarray, np.ndarray]:
    """The world matrices of a joint's frame by its first and its second body."""
    sides = []
    for side in "01":
        (target,) = joint.GetRelationship(f"physics:body{side}").GetTargets()
        turn = joint.GetAttribute(f"physics:localRot{side}").Get()
        local = _matrix(joint.GetAttribute(f"physics:localPos{side}").Get(), (*turn.GetImaginary(), turn.GetReal()))
        sides.append(_world(joint.GetStage().GetPrimAtPath(target)) @ local)
    return sides[0], sides[1]


def _axis(joint) -> np.ndarray:
    return _frames(joint)[0][:3, :3] @ np.eye(3)["XYZ".index(joint.GetAttribute("physics:axis").Get())]


@pytest.mark.parametrize("object_id", ["cabinet", "wide cabinet", "counter"])
def test_doors_and_drawers_have_their_joints(stage, object_id) -> None:
    prim, thing = _objects(stage)[object_id], SCENE.object(object_id)
    assert thing.asset is not None
    asset = ASSETS[thing.asset]
    scale = np.asarray(thing.size) / np.asarray(asset.size)
    matrix = _matrix(thing.pose.position, thing.pose.quaternion)
    assert prim.HasAPI(UsdPhysics.ArticulationRootAPI)
    joints = [p for p in prim.GetChild("joints").GetChildren() if not p.IsA(UsdPhysics.FixedJoint)]
    base = prim.GetChild(f"{prim.GetName()}_base")
    assert len(joints) == len(asset.links) > 0
    for joint, link in zip(joints, asset.links, strict=True):
        one, two = _frames(joint)
        assert np.allclose(one, two, atol=1e-6)
        anchor = matrix[:3, :3] @ (np.asarray(link.anchor) * scale) + matrix[:3, 3]
        assert np.allclose(one[:3, 3], anchor, atol=1e-5)
        along = np.asarray(link.axis) * (scale if link.joint == "slide" else 1.0)
        stretch = np.linalg.norm(along)
        assert np.allclose(_axis(joint), matrix[:3, :3] @ along / stretch, atol=1e-6)
        limits = [joint.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper")]
        want = np.degrees(link.limits) if link.joint == "hinge" else np.asarray(link.limits) * stretch
        assert joint.IsA(UsdPhysics.RevoluteJoint if link.joint == "hinge" else UsdPhysics.PrismaticJoint)
        assert np.allclose(limits, want, rtol=1e-5)
        assert limits[0] <= 0 <= limits[1]  # closed as it is
        drive = UsdPhysics.DriveAPI(joint, "angular" if link.joint == "hinge" else "linear")
        assert drive.GetDampingAttr().Get() > 0 and drive.GetStiffnessAttr().Get() == 0
        (moving,) = joint.GetRelationship("physics:body1").GetTargets()
        assert joint.GetRelationship("physics:body0").GetTargets() == [base.GetPath()]
        assert moving in UsdPhysics.FilteredPairsAPI(base).GetFilteredPairsRel().GetTargets()
    fixed = [p for p in prim.GetChild("joints").GetChildren() if p.IsA(UsdPhysics.FixedJoint)]
    assert len(fixed) == (object_id == "counter")
    for joint in fixed:
        one, two = _frames(joint)
        assert np.allclose(one, two, atol=1e-6)


def test_any_axis_is_reached_by_a_turn() -> None:
    rng = np.random.default_rng(3)
    some = rng.normal(size=(200, 3))
    near = -np.eye(3) + 1e-7 * rng.normal(size=(3, 3))
    for axis in np.concatenate([some, np.eye(3), -np.eye(3), near]):
        axis = axis / np.linalg.norm(axis)
        number = int(np.argmax(np.abs(axis)))
        turn = _turn(number, axis)
        assert np.linalg.norm(turn) == pytest.approx(1)
        assert np.allclose(_matrix((0, 0, 0), turn)[:3, number], axis, atol=1e-7)


def test_the_leaves_of_the_doors_open(stage) -> None:
    doors = {d.GetCustomDataByKey("sceneweaver:id"): d for d in stage.GetPrimAtPath("/World/Room/Doors").GetChildren()}
    for leaf in leaves(ROOM):
        door = doors[leaf.door]
        panel = door.GetChild(f"{door.GetName()}_leaf")
        turn = (0.0, 0.0, math.sin(leaf.yaw / 2), math.cos(leaf.yaw / 2))
        assert np.allclose(_world(panel), _matrix(leaf.position, turn), atol=1e-6)
        assert UsdPhysics.MassAPI(panel).GetMassAttr().Get() == pytest.approx(leaf.mass)
        joint = door.GetPrimAtPath(f"joints/{door.GetName()}_joint")
        one, two = _frames(joint)
        assert np.allclose(one, two, atol=1e-6)
        assert np.allclose(_axis(joint), _matrix((0, 0, 0), turn)[:3, :3] @ leaf.axis, atol=1e-6)
        upper = joint.GetAttribute("physics:upperLimit").Get()
        assert upper == pytest.approx(math.degrees(leaf.limits[1]) if leaf.joint == "hinge" else leaf.limits[1])
        assert len(_colliders(panel)) == len(leaf.boxes)
        filtered = UsdPhysics.FilteredPairsAPI(panel).GetFilteredPairsRel().GetTargets()
        wall = next(d.wall for d in ROOM.doors if d.id == leaf.door)
        assert {str(p) for p in filtered} >= {
            str(c.GetPath()) for c in _colliders(stage.GetPrimAtPath(f"/World/Room/Walls/Wall_{wall}"))
        }


def test_a_rug_does_not_lift_what_stands_on_it(stage) -> None:
    found = _objects(stage)
    pairs = set()
    for prim in stage.Traverse():
        if prim.HasAPI(UsdPhysics.FilteredPairsAPI):
            targets = UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets()
            assert all(stage.GetPrimAtPath(t) for t in targets)
            pairs |= {frozenset((prim.GetPath(), t)) for t in targets}
    rug = found["rug"].GetPath()
    assert frozenset((rug, found["desk é/1"].GetPath())) in pairs
    assert frozenset((rug, found["desk é-1"].GetPath())) not in pairs  # far away
    assert frozenset((rug, found["mug"].GetPath())) not in pairs  # on the desk
    assert frozenset((rug, Sdf.Path("/World/Room/Doors/room_door_door_0/room_door_door_0_leaf"))) in pairs


def test_a_rug_under_what_stands_still_names_its_colliders() -> None:
    poses = {"rug": Pose.from_yaw(2.0, 2.0, 0.0, 0.0), "shelf": Pose.from_yaw(2.2, 2.0, 0.0, 0.0)}
    shelf = SceneObject(id="shelf", category="shelf", size=(0.3, 0.9, 1.8), pose=poses["shelf"], fixed=True)
    for order in (1, -1):
        objects = (RUG.object("rug", pose=poses["rug"]), shelf)[::order]
        stage = Usd.Stage.Open(usd_layer(Scene(id="s", room=ROOM, objects=objects), ASSETS.__getitem__))
        targets = UsdPhysics.FilteredPairsAPI(_objects(stage)["rug"]).GetFilteredPairsRel().GetTargets()
        assert {str(c.GetPath()) for c in _colliders(_objects(stage)["shelf"])} <= {str(t) for t in targets}


def test_frames_lie_where_the_asset_has_them(stage) -> None:
    """Those of a scaled and tilted cabinet, in the bodies that carry them; the spawn frame looks into the room."""
    frames = {
        prim.GetMetadata("displayName"): prim for prim in _all(stage.GetPseudoRoot()) if prim.GetCustomDataByKey(_FRAME)
    }
    things = [t for t in things_of(SCENE, ASSETS.__getitem__) if t.asset is not None and t.asset.grasps]
    assert things
    for thing in things:
        for grasp in thing.asset.grasps:
            body = next(b for b in thing.bodies if b.number == thing.body_of(grasp.link))
            prim = frames[f"{body.name}:grasp:{grasp.name}"]
            pose = _matrix(thing.object.pose.position, thing.object.pose.quaternion)
            world = _world(prim)
            place = np.asarray(grasp.position) * thing.scale
            assert np.allclose(world[:3, 3], pose[:3, :3] @ place + pose[:3, 3], atol=1e-6)
            assert np.allclose(world[:3, 2], pose[:3, :3] @ grasp.approach, atol=1e-6)
            assert np.allclose(world[:3, 1], pose[:3, :3] @ grasp.closing, atol=1e-6)
            size = prim.GetCustomDataByKey("sceneweaver:size")
            assert np.allclose(size[:2], (grasp.length, grasp.width))
    spawn = _world(frames["room:spawn:door-0"])
    assert np.allclose(spawn[:3, 3], (0.95, 0.45, 0.0)) and np.allclose(spawn[:3, 0], (0, 1, 0), atol=1e-9)


def test_lights_and_cameras(stage) -> None:
    """The sun shines in through the window; cameras stand in the room and look at its middle."""
    sun = stage.GetPrimAtPath("/World/Lights/Sun")
    way = -_world(sun)[:3, 2]
    assert way[2] < -0.3 and way @ (-1, 0, 0) > 0.5, "the window is in the wall at x = 6"
    assert stage.GetPrimAtPath("/World/Lights/Sky").GetTypeName() == "DomeLight"
    middle = np.array([3.0, 2.5, 1.0])
    for camera in stage.GetPrimAtPath("/World/Cameras").GetChildren():
        matrix = _world(camera)
        toward = middle - matrix[:3, 3]
        assert -matrix[:3, 2] @ toward / np.linalg.norm(toward) > 0.95
        if "eye" in camera.GetName():
            assert 0 <= matrix[0, 3] <= 6 and 0 <= matrix[1, 3] <= 5 and matrix[2, 3] < ROOM.height
            assert matrix[2, 1] > 0.9, "upright"


def test_walls_are_solid_around_their_openings(stage) -> None:
    """Points in the middle of the walls: in a collider and behind the mesh, but for the openings."""
    rng = np.random.default_rng(0)
    n = len(ROOM.outline)
    for k in range(n):
        wall = stage.GetPrimAtPath(f"/World/Room/Walls/Wall_{k}")
        boxes = [(c.min(axis=0), c.max(axis=0)) for c in map(_corners, _colliders(wall))]
        start, end = np.array(ROOM.outline[k]), np.array(ROOM.outline[(k + 1) % n])
        length = np.linalg.norm(end - start)
        along = (end - start) / length
        outward = np.array([along[1], -along[0]])
        holes = [(d.offset, d.offset + d.width, 0.0, d.height) for d in ROOM.doors if d.wall == k]
        holes += [(w.offset, w.offset + w.width, w.sill, w.sill + w.height) for w in ROOM.windows if w.wall == k]
        for s, z in rng.uniform((0.01, 0.01), (length - 0.01, ROOM.height - 0.01), (200, 2)):
            point = np.array([*(start + s * along + 0.05 * outward), z])
            free = any(a < s < b and low < z < high for a, b, low, high in holes)
            solid = any((low - 1e-6 <= point).all() and (point <= high + 1e-6).all() for low, high in boxes)
            assert solid != free
        (mesh,) = [p for p in wall.GetChildren() if p.IsA(UsdGeom.Mesh)]
        matrix = _world(mesh)
        points = np.array(UsdGeom.Mesh(mesh).GetPointsAttr().Get()) @ matrix[:3, :3].T + matrix[:3, 3]
        depth = (points[:, :2] - start) @ outward
        assert depth.min() == pytest.approx(0, abs=1e-5) and depth.max() == pytest.approx(0.1, abs=1e-5)
    (floor,) = _colliders(stage.GetPrimAtPath("/World/Room/Floor"))
    assert _corners(floor)[:, 2].max() == pytest.approx(0, abs=1e-9)
    (pane,) = _colliders(stage.GetPrimAtPath("/World/Room/Windows"))
    assert np.allclose(_corners(pane).min(0)[1:], (1.0, 0.9)) and np.allclose(_corners(pane).max(0)[1:], (2.2, 2.1))


def test_it_can_be_put_into_another_stage(tmp_path) -> None:
    """Materials, prototypes and joints go along with the default prim, and the world joint with its place."""
    write_usd(SCENE, tmp_path / "scene.usda", ASSETS.__getitem__)
    outer = Usd.Stage.CreateNew(str(tmp_path / "outer.usda"))
    prim = outer.DefinePrim("/env/room", "Xform")
    prim.GetReferences().AddReference("./scene.usda")
    UsdGeom.Xformable(prim).AddTranslateOp().Set((10, 20, 0))
    assert not outer.GetCompositionErrors()
    assert not [p for p in outer.Traverse() if p.IsA(UsdPhysics.Scene)]
    (mesh,) = [p for p in _all(outer.GetPrimAtPath("/env/room/Objects/mug")) if p.GetName() == "Mesh"]
    targets = [mesh, *UsdGeom.Subset.GetAllGeomSubsets(UsdGeom.Mesh(mesh))]
    assert any(UsdShade.MaterialBindingAPI(t).ComputeBoundMaterial()[0] for t in targets)
    parsed = UsdPhysics.UsdPhysicsLoadStageFromPrimRange(outer, ["/"])
    paths, descs = parsed[UsdPhysics.ObjectType.FixedJoint]
    joint = dict(zip(map(str, paths), descs, strict=True))["/env/room/Objects/counter/joints/counter_base_joint"]
    want = np.array(SCENE.object("counter").pose.position) + (10, 20, 0)
    assert np.allclose(joint.localPose0Position, want, atol=1e-5)


def test_normals_keep_edges_and_round_what_is_round() -> None:
    cube = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 2)], dtype=float)
    faces = hull_faces(cube)
    normals, index = corner_normals(cube, faces)
    assert len(normals) == 6 and len(index) == 36
    a, b, c = (cube[faces[:, k]] for k in range(3))
    flat = np.cross(b - a, c - a)
    flat /= np.linalg.norm(flat, axis=1, keepdims=True)
    assert np.allclose(normals[index].reshape(-1, 3, 3), flat[:, None], atol=1e-4)
    middle = (a + b + c) / 3 - cube.mean(axis=0)
    assert ((flat * middle).sum(axis=1) > 0).all()
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    rod = np.concatenate([np.column_stack([ring, np.full(24, z)]) for z in (0.0, 1.0)])
    faces = hull_faces(rod)
    normals, index = corner_normals(rod, faces)
    shaded = normals[index].reshape(-1, 3, 3)
    side = np.abs(shaded[..., 2]) < 0.5
    assert np.allclose(shaded[side][:, :2], rod[faces][side][:, :2], atol=0.05)  # as on the cylinder itself
    assert np.allclose(np.abs(shaded[~side][:, 2]), 1, atol=1e-4)
    folded = np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 0, 0)], dtype=float)
    assert np.isfinite(corner_normals(folded, np.array([[0, 1, 2], [0, 3, 1]]))[0]).all()


def test_the_same_scene_gives_the_same_text(tmp_path) -> None:
    for name in ("a.usda", "b.usda"):
        write_usd(SCENE, tmp_path / name, ASSETS.__getitem__)
    assert (tmp_path / "a.usda").read_bytes() == (tmp_path / "b.usda").read_bytes()


def _no_asset(object_id: str) -> Any:
    raise InputError(f"asset: no asset {object_id!r}; check the id")


def test_errors_are_one_line_and_leave_nothing_behind(tmp_path, monkeypatch) -> None:
    (tmp_path / "file").write_text("x")
    (tmp_path / "folder.usda").mkdir()
    bare = SCENE.model_copy(update={"objects": ()})
    cases = [
        (SCENE, "scene.usdz", "must end in .usda"),
        (SCENE, "scene", "must end in .usda"),
        (bare, "folder.usda", "is a folder"),
        (bare, "nowhere/scene.usda", "does not exist"),
        (bare, "file/scene.usdc", "cannot be written"),
    ]
    for scene, name, words in cases:
        with pytest.raises(InputError, match=words) as caught:
            write_usd(scene, tmp_path / name)
        assert "\n" not in str(caught.value) and str(caught.value).startswith("path: ")
    with pytest.raises(InputError, match=r"^objects\[0\]\.asset: ") as caught:
        write_usd(SCENE, tmp_path / "scene.usda", _no_asset)
    assert "\n" not in str(caught.value)
    assert sorted(os.listdir(tmp_path)) == ["file", "folder.usda"]

    write_usd(bare, tmp_path / "scene.usda")
    before, images = (tmp_path / "scene.usda").read_bytes(), sorted(os.listdir(tmp_path / "textures"))

    def fail(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(InputError, match="No space left"):
        write_usd(SCENE, tmp_path / "scene.usda", ASSETS.__getitem__)
    assert (tmp_path / "scene.usda").read_bytes() == before
    assert sorted(os.listdir(tmp_path)) == ["file", "folder.usda", "scene.usda", "textures"]
    assert sorted(os.listdir(tmp_path / "textures")) == images


def test_no_two_bodies_or_joints_are_named_alike(stage) -> None:
    """Importers that know names and no paths, and engines that list joints by name, mean one thing by each."""
    moving = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.RigidBodyAPI) or p.IsA(UsdPhysics.Joint)]
    names = [p.GetName() for p in moving]
    assert len(names) > 20 and sorted(set(names)) == sorted(names)
    cabinet = _objects(stage)["cabinet"]
    links = {link.name for asset in [ASSETS[SCENE.object("cabinet").asset or ""]] for link in asset.links}
    for link in links:
        title = re.sub(r"\W", "_", f"cabinet_{link}")
        assert cabinet.GetChild(title) and cabinet.GetPrimAtPath(f"joints/{title}_joint")
