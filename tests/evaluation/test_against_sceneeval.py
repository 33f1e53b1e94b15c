"""The figures against SceneEval's definitions, worked out by points, rays and pixels (`benchmarks.sceneeval_twin`)."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import sceneeval_twin as twin
from sceneweaver.assets.roles import with_role
from sceneweaver.evaluation import moving, openings, standing
from sceneweaver.scene import Pose, Scene
from sceneweaver.verify import check
from sceneweaver.verify.solids import Placed
from tests.sizes import often


def shaken(name: str, seed: int, far: float) -> Scene:
    """An example whose objects on the floor were moved at random, and lifted a little."""
    scene, random = Scene.example(name), np.random.default_rng(seed)
    poses = {}
    for obj in scene.objects:
        if obj.mount == "floor":
            x, y, z = obj.pose.position
            dx, dy, turn = random.normal(0.0, (far, far, 0.5 * far))
            lift = float(random.choice([0.0, 0.0, 0.003, 0.02]))
            poses[obj.id] = Pose.from_yaw(x + dx, y + dy, z + lift, obj.pose.yaw + turn)
    return scene.replace_poses(poses)


SCENES = {
    "as made": Scene.example("bedroom"),
    "study": Scene.example("study"),
    "a little": shaken("bedroom", 1, 0.03),
    "far": shaken("living-room", 2, 0.4),
    "farther": shaken("study", 3, 0.6),
}


@pytest.fixture(params=list(SCENES))
def scene(request) -> Scene:
    return SCENES[request.param]


def test_collisions(scene):
    ours = {frozenset(v.objects): v.amount for v in check(scene, walkable=False).violations if v.kind == "collision"}
    theirs = twin.collisions(twin.things_of(scene))
    assert theirs <= set(ours), "what still overlaps when moved apart by 5 mm penetrates by over 1 mm"
    deep = {pair for pair, depth in ours.items() if depth > twin.APART}
    assert deep <= theirs, "what is deeper than 5 mm still overlaps when moved by as much"


def test_collisions_are_there_to_be_found():
    assert len(twin.collisions(twin.things_of(SCENES["far"]))) > 2
    assert not twin.collisions(twin.things_of(SCENES["as made"]))


def test_out_of_bounds(scene):
    outside = {v.objects[0] for v in check(scene, walkable=False).violations if v.kind == "out_of_bounds"}
    shares = twin.out_of_bounds(scene, twin.things_of(scene))
    assert {name for name, share in shares.items() if share < twin.IN_BOUNDS} <= outside
    assert all(shares[name] < 1.0 for name in outside if shares[name] < 0.999)
    assert all(share > 0.999 for name, share in shares.items() if name not in outside)


def test_support(scene):
    placed = Placed.of(scene)
    ours = dict(zip((b.id for b in placed.bodies), standing.supported(placed), strict=True))
    theirs = twin.supported(scene, twin.things_of(scene))
    assert ours == theirs


def test_support_tells_what_floats():
    scene = SCENES["as made"]
    x, y, _ = scene.object("bed").pose.position
    floating = scene.replace_poses({"bed": Pose.from_yaw(x, y, 0.02, scene.object("bed").pose.yaw)})
    for one, expected in ((scene, True), (floating, False)):
        placed = Placed.of(one)
        assert standing.supported(placed)[one.index("bed")] is expected
        assert twin.supported(one, twin.things_of(one))["bed"] is expected


@pytest.mark.parametrize("scene", often(SCENES, ["as made", "farther"]), indirect=True)
def test_navigability(scene):
    """A passage as wide as the base is open in one picture and closed in another: cells are 5 cm, pixels 2 cm."""
    things, widths = twin.things_of(scene), (moving.BASE - 0.05, moving.BASE, moving.BASE + 0.05)
    theirs = [twin.navigability(scene, things, width) for width in widths]
    assert min(theirs) - 0.05 <= moving.navigability(Placed.of(scene)) <= max(theirs) + 0.05


def test_navigability_of_a_room_cut_in_two():
    scene = Scene.example("bedroom")
    x0, y0, x1, y1 = Placed.of(scene).floor.bounds
    bar = scene.object("wardrobe").model_copy(
        update={
            "size": (0.3, y1 - y0, 1.0),
            "pose": Pose.from_yaw((x0 + x1) / 2, (y0 + y1) / 2, 0.0, 0.0),
            "parts": None,
            "zones": (),
            "surfaces": (),
        }
    )
    cut = scene.model_copy(update={"objects": (bar,), "relations": ()})
    assert moving.navigability(Placed.of(cut)) == pytest.approx(0.5, abs=0.05)
    assert twin.navigability(cut, twin.things_of(cut), moving.BASE) == pytest.approx(0.5, abs=0.05)


def test_accessibility(scene):
    ours = sorted(moving.accessibility(Placed.of(scene)))
    theirs = sorted(twin.accessibility(scene, twin.things_of(scene)).values())
    assert ours == pytest.approx(theirs, abs=0.12) and np.mean(ours) == pytest.approx(np.mean(theirs), abs=0.03)


def test_openings(scene):
    ours = {o.id: o for o in openings.openings(Placed.of(scene))}
    theirs = twin.openings_covered(scene, twin.things_of(scene), with_role("window_dressing"))
    assert ours.keys() == theirs.keys()
    for name, one in ours.items():
        assert one.share == pytest.approx(theirs[name], abs=0.04)
        assert bool(one.by) or theirs[name] == 0.0
