"""Many layouts at once: each as if it were alone, by MuJoCo C and by MuJoCo Warp; and what has no room is said."""

from __future__ import annotations

from dataclasses import replace
from xml.etree import ElementTree as Xml

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from sceneweaver.assets import make
from sceneweaver.physics import batch, settle, stability
from sceneweaver.physics.batch import model_of, poses_of, settle_many, settle_scenes, stability_many
from sceneweaver.physics.boxes import boxed
from sceneweaver.physics.worlds import SimulationResult, Template, merged, run_c, shifts
from sceneweaver.scene import InputError, Pose, Room, Scene, SceneObject, Support

ROOM = Room(outline=((0, 0), (5, 0), (5, 5), (0, 5)))
ASSETS = {a.id: a for a in (make("desk", 3), make("mug", 3), make("toilet", 1), make("rug", 1), make("dresser", 2))}
DESK, MUG, TOILET, RUG, DRESSER = ASSETS.values()
LOAD = ASSETS.__getitem__
TOP = DESK.surfaces[0]
SECONDS = 0.6


def _box(object_id: str, x: float, y: float, z: float, **more) -> SceneObject:
    return SceneObject(id=object_id, category="box", size=(0.3, 0.2, 0.4), pose=Pose.from_yaw(x, y, z, 0.5), **more)


def _scene(*objects: SceneObject) -> Scene:
    return Scene(id="s", room=ROOM, objects=objects)


def _furnished() -> Scene:
    """A desk with a mug, a toilet (a fixture) with a box on its box, and a shelf on the wall with a box on it."""
    shelf = SceneObject(
        id="shelf", category="shelf", size=(0.4, 0.8, 0.05), mount="wall", pose=Pose.from_yaw(0.2, 3, 1, 0)
    )
    return _scene(
        DESK.object("desk", pose=Pose.from_yaw(2, 2, 0, 0.9)),
        MUG.object("mug", pose=Pose.from_yaw(2, 2, TOP.z, 0.4), support=Support(object="desk", surface=TOP.name)),
        shelf,
        TOILET.object("toilet", pose=Pose.from_yaw(4, 4, 0, 2)),
        _box("b", 0.2, 3, 1.05),
    )


def _rows(scene: Scene) -> np.ndarray:
    return np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])


def _layouts() -> tuple[Scene, np.ndarray]:
    """Four layouts: as it is; all turned about the room's middle; the mug lifted; shelf and box elsewhere."""
    scene = _furnished()
    poses = np.tile(_rows(scene), (4, 1, 1))
    poses[1, :, :2] = 5 - poses[1, :, :2]
    poses[1, :, 3] += np.pi
    poses[2, 1, 2] += 0.05
    poses[3, [2, 4], 1] -= 1.5
    poses[3, [2, 4], 2] += 0.4
    return scene, poses


def _at(scene: Scene, rows: np.ndarray) -> Scene:
    return scene.replace_poses({o.id: Pose.from_yaw(*map(float, r)) for o, r in zip(scene.objects, rows, strict=True)})


def test_each_world_is_as_if_alone() -> None:
    scene, poses = _layouts()
    found = settle_many(scene, poses, LOAD, SECONDS, device="cpu", threads=3)
    assert found.free == ("desk", "mug", "b") and found.fixed == ("shelf", "toilet") and found.backend == "c"
    assert found.moved.tolist() == [[False] * 3, [False] * 3, [False, True, False], [False] * 3]
    assert not found.overflow.any() and not found.diverged.any() and found.problem is None
    for k, rows in enumerate(poses):
        alone = settle(_at(scene, rows), LOAD, SECONDS)
        assert found.settled(k).moved == pytest.approx(alone.moved, abs=1e-6)
        assert found.settled(k).faults == alone.faults
        for one, two in zip(found.settled(k).scene.objects, alone.scene.objects, strict=True):
            assert one.pose.position == pytest.approx(two.pose.position, abs=1e-6), (k, one.id)
            assert one.pose.quaternion == pytest.approx(two.pose.quaternion, abs=1e-6), (k, one.id)
    assert found.outcome.contacts > 0 and found.outcome.constraints > 0


def test_scenes_and_poses_are_the_same_and_measures_too() -> None:
    scene, poses = _layouts()
    scenes = [_at(scene, rows) for rows in poses]
    one, two = (settle_many(scene, c, LOAD, 0.1, device="cpu", threads=1) for c in (poses, scenes))
    assert np.allclose(one.poses, two.poses, atol=1e-6)
    assert np.allclose(one.shift, settle_many(scene, poses[::-1], LOAD, 0.1, device="cpu").shift[::-1], atol=1e-9)
    measured = stability_many(scene, scenes, LOAD, seconds=SECONDS, device="cpu")
    for k, each in enumerate(scenes):
        alone = stability(each, LOAD, SECONDS)
        assert measured[k].pop("moved") == pytest.approx(alone.pop("moved"), abs=1e-6)
        assert measured[k] == pytest.approx(alone, abs=1e-6)


def test_scenes_of_any_kind_in_their_order() -> None:
    scene, poses = _layouts()
    scenes = [_at(scene, poses[0]), _scene(_box("up", 1, 1, 0.3)), _at(scene, poses[3]), _scene(_box("c", 2, 2, 0))]
    found = settle_scenes(scenes, LOAD, seconds=SECONDS, device="cpu")
    assert [sorted(f.moved) if f else None for f in found] == [
        ["b", "desk", "mug"],
        ["up"],
        ["b", "desk", "mug"],
        ["c"],
    ]
    assert [f.faults for f in found if f] == [(), ("up",), (), ()]
    for one, scene in zip(found, scenes, strict=True):
        assert one is not None and one.scene.objects[0].pose.position[:2] == pytest.approx(
            scene.objects[0].pose.position[:2], abs=2e-3
        )


def test_a_rug_lies_under_what_another_layout_puts_over_it() -> None:
    scene = _scene(
        RUG.object("rug", pose=Pose.from_yaw(1.5, 3.5, 0, 0)), DRESSER.object("dresser", pose=Pose.from_yaw(4, 1, 0, 1))
    )
    assert len(DRESSER.links) > 0
    poses = np.tile(_rows(scene), (2, 1, 1))
    poses[1, 1] = (1.5, 3.5, 0, 1)
    assert not settle_many(scene, poses, LOAD, SECONDS, device="cpu").moved.any()


def test_boxes_have_the_volume_height_and_mass_of_the_hulls() -> None:
    scene = _furnished()
    hulls, boxes = model_of(scene, LOAD), model_of(scene, LOAD, "box")
    assert "<mesh" in hulls.xml and "<mesh" not in boxes.xml and boxes.free == hulls.free

    def bodies(xml: str) -> dict[str, tuple[float, float, float, float]]:
        root, found = Xml.fromstring(xml), {}
        meshes = {m.get("name"): np.array(m.get("vertex").split(), float).reshape(-1, 3) for m in root.iter("mesh")}
        for body in root.iter("body"):
            low, high, mass, volume = np.inf, -np.inf, 0.0, 0.0
            for geom in body.findall("geom"):
                if geom.get("mesh"):
                    points = meshes[geom.get("mesh")]
                    volume += ConvexHull(points).volume
                else:
                    half = np.array(geom.get("size").split(), float)
                    points = np.array(geom.get("pos", "0 0 0").split(), float) + np.array([-half, half])
                    volume += float(np.prod(2 * half))
                low, high = min(low, points[:, 2].min()), max(high, points[:, 2].max())
                mass += float(geom.get("mass", 0))
            found[body.get("name")] = (low, high, mass, volume)
        return found

    one, two = bodies(hulls.xml), bodies(boxes.xml)
    assert one.keys() == two.keys()
    for name, (low, high, mass, volume) in one.items():
        if not np.isfinite(low):
            continue
        assert two[name][:3] == pytest.approx((low, high, mass), abs=1e-4), name
        assert 0.99 * volume <= two[name][3] + 1e-9 and two[name][3] <= 1.25 * volume + 1e-6, name
    found = settle_many(scene, None, LOAD, SECONDS, shapes="box", device="cpu")
    assert found.shift.shape == (1, 3) and not found.moved.any()


def test_boxes_of_boxes_are_the_model_itself() -> None:
    model = model_of(_scene(_box("b", 1, 1, 0)))
    assert Xml.canonicalize(boxed(model).xml) == Xml.canonicalize(model.xml)


def test_what_goes_astray_is_marked() -> None:
    model = model_of(_scene(_box("b", 1, 1, 0)))
    template = Template.of(model, _scene(_box("b", 1, 1, 0)))
    start = np.tile(poses_of(_scene(_box("b", 1, 1, 0))), (3, 1, 1))
    start[1, 0, 0] = 1e12
    found = run_c(template, start, 10, threads=2)
    assert found.diverged.tolist() == [False, True, False]
    assert shifts(template, start, found.poses)[[0, 2]].max() < 1e-3


def test_what_had_no_room_is_never_taken_for_an_answer(monkeypatch) -> None:
    scene, poses = _layouts()

    def full(template, start, steps, device, backend, threads):
        overflow, astray = np.array([0, 1, 0, 0], bool), np.array([0, 0, 1, 0], bool)
        return SimulationResult(start.copy(), overflow, astray, 9.0, 9, 0.1, problem="candidates: no room"), "c", "cpu"

    monkeypatch.setattr(batch, "run", full)
    found = settle_many(scene, poses, LOAD)
    assert np.isnan(found.shift[1:3]).all() and found.moved[1:3].all() and not found.moved[[0, 3]].any()
    with pytest.raises(InputError, match="candidates: no room"):
        found.settled(1)
    with pytest.raises(InputError, match="objects: the simulation went astray"):
        found.settled(2)
    assert [m is None for m in stability_many(scene, poses, LOAD)] == [False, True, True, False]
    assert [f is None for f in settle_scenes([_at(scene, r) for r in poses], LOAD)] == [False, True, True, False]


def test_parts_of_a_run_are_one() -> None:
    one = SimulationResult(np.zeros((2, 1, 7)), np.array([True, False]), np.zeros(2, bool), 3.0, 5, 1.0, 1, problem="p")
    two = replace(one, overflow=np.zeros(2, bool), constraints=9, problem=None, grown=0)
    both = merged([two, one])
    assert both.poses.shape == (4, 1, 7) and both.overflow.tolist() == [False, False, True, False]
    assert (both.constraints, both.seconds, both.grown, both.problem) == (9, 2.0, 1, "p")


def test_scenes_with_nothing_that_may_move() -> None:
    for scene in (_scene(), _scene(_box("b", 1, 1, 1, fixed=True))):
        found = settle_many(scene, np.tile(_rows(scene).reshape(-1, 4), (3, 1, 1)), seconds=0.1, device="cpu")
        assert found.shift.shape == (3, 0) and found.settled(2).scene == scene
        assert all(m and m["moved_over_0_01m"] == 0 for m in stability_many(scene, None, seconds=0.1, device="cpu"))


@pytest.mark.parametrize(
    ("candidates", "options", "words"),
    [
        (np.zeros((2, 4)), {}, "candidates: shape"),
        (np.zeros((2, 3, 4)), {}, r"give \[B, 5, 4\]"),
        (np.zeros((0, 5, 4)), {}, "candidates: shape"),
        (np.full((1, 5, 4), np.nan), {}, "candidates: some numbers are not finite"),
        ([], {}, "candidates: there are none"),
        ([_scene(_box("b", 1, 1, 0))], {}, r"candidates\[0\]: differs from the scene in more than poses"),
        (None, {"shapes": "ball"}, "shapes: "),
        (None, {"device": "gpu"}, "device: "),
        (None, {"device": "cuda:x"}, "device: "),
        (None, {"device": "cpu", "backend": "d"}, "backend: "),
        (None, {"seconds": -1.0}, "seconds: "),
        (None, {"seconds": float("nan")}, "seconds: "),
    ],
)
def test_bad_input(candidates, options, words) -> None:
    with pytest.raises(InputError, match=words):
        settle_many(_furnished(), candidates, LOAD, **options)


@pytest.mark.slow
def test_warp_agrees_with_c_and_says_what_has_no_room(monkeypatch) -> None:
    from sceneweaver.physics import worlds_warp

    scene, poses = _layouts()
    c, warp = (settle_many(scene, poses, LOAD, 0.4, device="cpu", backend=b) for b in ("c", "warp"))
    assert warp.backend == "warp" and not warp.overflow.any() and not warp.diverged.any()
    assert (warp.moved == c.moved).all() and c.moved.any()
    assert np.abs(warp.shift - c.shift)[~c.moved].max() < 1e-3
    place = {o.id: k for k, o in enumerate(scene.objects)}
    order = [place[object_id] for object_id in (*c.free, *c.fixed)]
    model = model_of(scene, LOAD)
    template = Template.of(model, scene)
    start = poses_of(scene, poses)[:, order]
    enough = worlds_warp.launch(template, start, 20, "cpu")
    grown = worlds_warp.launch(template, start, 20, "cpu", worlds_warp.Room(8, 8, 8))
    assert grown.grown > 0 and not grown.overflow.any() and np.allclose(grown.poses, enough.poses, atol=1e-5)
    monkeypatch.setattr(worlds_warp, "LAUNCH", 3)
    parts = worlds_warp.run_warp(template, start, 20, "cpu")
    assert np.allclose(parts.poses, enough.poses, atol=1e-5)
    monkeypatch.setattr(worlds_warp, "GROWTHS", 0)
    short = worlds_warp.launch(template, start, 20, "cpu", worlds_warp.Room(8, 8, 8))
    assert short.overflow.all() and short.problem is not None and "needed at least" in short.problem
    rows = worlds_warp.launch(template, start, 20, "cpu", worlds_warp.Room(4096, 4096, 8))
    assert rows.overflow.all() and "rows a world" in (rows.problem or "")
