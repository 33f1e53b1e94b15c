"""Refinement as a whole: quality, determinism, what must stay, what must be refused."""

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import engine
from sceneweaver.scene import Add, Pose, apply
from tests.layout.made import BED, BOX, CUP, OTHER, PICTURE, relation, room, scene, table, thing, zoo

SMALL = ["bedroom-small", "bedroom", "children-twin", "living", "living-dining-L", "dining-round", "studio-U"]


def refine(what, **options):
    return sw.refine(what, **({"device": "cpu", "candidates": 16, "seed": 0} | options))


def poses_of(what) -> np.ndarray:
    return np.array([(*o.pose.position, o.pose.yaw) for o in what.objects])


@pytest.mark.parametrize("name", [*SMALL, "lockers-wall-full", "bedroom-tight", "office-20"])
def test_random_starts_become_valid_and_the_judge_agrees(name):
    solution = refine(zoo(name), init="random", seed=7)
    assert np.mean(solution.status == 0) >= 0.85
    for i in np.flatnonzero(solution.status == 0):
        report = sw.check(solution.scene(int(i)), walkable=False)
        assert report.valid, report.violations
    for i in np.flatnonzero(solution.status == 1):
        assert not sw.check(solution.scene(int(i)), walkable=False).valid or solution.energy[i] < 0.01


def test_candidates_are_not_copies():
    poses = refine(zoo("bedroom-small"), init="random", candidates=32).poses
    apart = np.abs(poses[:, None] - poses[None]).max(axis=(2, 3)) + np.eye(32)
    assert apart.min() > 0.05


def test_same_seed_same_bits_and_another_seed_others():
    a, b, c = (refine(zoo("living-dining-L"), init="random", seed=s) for s in (5, 5, 6))
    assert a.poses.tobytes() == b.poses.tobytes()
    assert (a.status == b.status).all()
    assert a.poses.tobytes() != c.poses.tobytes()


def test_threads_and_batch_mates_change_nothing(monkeypatch):
    whole = refine(zoo("bedroom"), init="random", candidates=24)
    few = refine(zoo("bedroom"), init="random", candidates=5)
    assert whole.poses[:5].tobytes() == few.poses.tobytes()
    monkeypatch.setattr("os.sched_getaffinity", lambda _pid: {0}, raising=False)
    assert refine(zoo("bedroom"), init="random", candidates=24).poses.tobytes() == whole.poses.tobytes()


def test_many_scenes_in_shared_launches_equal_each_alone():
    scenes = [zoo("bedroom-small"), zoo("living"), zoo("bedroom"), scene([BOX], [])]
    together = sw.refine_many(scenes, candidates=6, seed=2, init="random", device="cpu")
    for one, solution in zip(scenes, together, strict=True):
        alone = refine(one, candidates=6, seed=2, init="random")
        assert solution.source is one
        assert solution.poses.tobytes() == alone.poses.tobytes()
        assert (solution.relations == alone.relations).all()


def test_adam_mends_noisy_layouts():
    what, rng = zoo("bedroom-small"), np.random.default_rng(1)
    start = np.repeat(poses_of(what)[None], 24, axis=0)
    for i, obj in enumerate(what.objects):
        if obj.mount == "floor":
            start[:, i, :2] += rng.normal(0, 0.1, (24, 2))
            start[:, i, 3] += rng.normal(0, 0.1, 24)
    before = refine(what, init=start, optimizer="adam", steps=1)
    after = refine(what, init=start, optimizer="adam")
    assert np.median(after.energy) < 0.2 * np.median(before.energy)
    assert np.mean(after.status == 0) > np.mean(before.status == 0) + 0.2
    assert refine(what, init=start, optimizer="adam").poses.tobytes() == after.poses.tobytes()


def test_current_leaves_a_valid_scene_alone():
    for name in ("bedroom-small", "living-dining-L", "office-20"):
        what = zoo(name)
        best = refine(what, init="current").best
        assert np.abs(poses_of(best)[:, :3] - poses_of(what)[:, :3]).max() < 1e-6


@pytest.mark.parametrize("name", ["bedroom-small", "bedroom", "studio-U", "office-20"])
def test_an_edit_moves_only_what_is_in_the_way(name):
    what, rng = zoo(name), np.random.default_rng(3)
    for _ in range(3):
        i = int(rng.choice([k for k, o in enumerate(what.objects) if o.mount == "floor" and not o.surfaces]))
        obj = what.objects[i]
        x, y, z = obj.pose.position
        edited = what.replace_poses({obj.id: Pose.from_yaw(x + 0.05, y - 0.04, z, obj.pose.yaw + 0.1)})
        touched = {obj.id}
        for violation in sw.check(edited, walkable=False).violations:
            touched |= set(violation.objects)
        solution = refine(edited, init="current")
        assert solution.status[solution.order[0]] == 0
        moved = np.linalg.norm(poses_of(solution.best)[:, :3] - poses_of(edited)[:, :3], axis=1)
        for k, other in enumerate(what.objects):
            if other.id not in touched and (other.support is None or other.support.object not in touched):
                assert moved[k] < 0.01, other.id


@pytest.mark.parametrize(
    ("name", "occupied"),
    [("bedroom", "nightstand-0"), ("bedroom", "armchair-0"), ("lockers-wall-full", "locker-6")],
)
def test_what_is_added_makes_way_and_bystanders_keep_their_poses(name, occupied):
    """Rooms in which things touch: the energy wants more air between them, but nobody asked for that."""
    what = zoo(name)
    x, y, _ = what.object(occupied).pose.position
    new = thing("plant", (0.35, 0.35, 0.8), pose=Pose.from_yaw(x, y, 0.0, 0.0))
    crowded = apply(what, Add(object=new))
    named = {object_id for v in sw.check(crowded, walkable=False).violations for object_id in v.objects}
    solution = refine(crowded, init="current", candidates=16)
    assert (solution.status == 0).all()
    still = [
        k
        for k, o in enumerate(crowded.objects)
        if o.id not in named and (o.support is None or o.support.object not in named)
    ]
    assert len(still) > 5
    moved = np.abs(solution.poses[solution.order[0]] - poses_of(crowded))[still]
    assert moved.max() < 1e-5


def test_fixed_objects_keep_their_exact_poses():
    pose = Pose.from_yaw(2.123456789, 1.987654321, 0.0, 0.3)
    fixed = thing("pillar", (0.4, 0.4, 2.5), fixed=True, pose=pose)
    solution = refine(scene([fixed, BED, BOX], [relation("against_wall", "bed")]), init="random")
    assert (solution.status == 0).all()
    for i in range(solution.candidates):
        assert solution.scene(i).object("pillar").pose == pose


def test_a_fixed_object_in_the_wrong_place_is_no_valid_layout():
    high = thing("crate", fixed=True, pose=Pose(position=(2, 2, 0.1)))
    outside = thing("crate", fixed=True, pose=Pose(position=(9, 9, 0)))
    for wrong in (high, outside):
        solution = refine(scene([wrong, BOX], []), init="random")
        assert (solution.status == 1).all()
        assert not sw.check(solution.best).valid


def test_wall_and_ceiling_objects_are_placed_with_the_rest():
    lamp = thing("lamp", (0.5, 0.5, 0.4), mount="ceiling")
    tall = thing("wardrobe", (0.6, 1.2, 2.6))
    links = [relation("against_wall", "wardrobe"), relation("above", "picture", "bed")]
    what = scene([BED, tall, PICTURE, lamp], links)
    solution = refine(what, init="random")
    assert np.mean(solution.status == 0) > 0.9
    best = solution.best
    assert sw.check(best).valid
    assert best.object("lamp").pose.position[2] == pytest.approx(2.3, abs=1e-6)


def test_stacks_are_carried_along():
    tray = thing(
        "tray",
        (0.4, 0.5, 0.02),
        mount="surface",
        support=CUP.support,
        surfaces=[{"name": "top", "polygon": [[-0.2, -0.25], [0.2, -0.25], [0.2, 0.25], [-0.2, 0.25]], "z": 0.02}],
    )
    cup = thing("cup", (0.1, 0.1, 0.1), mount="surface", support={"object": "tray", "surface": "top"})
    solution = refine(scene([table(), tray, cup, OTHER], [relation("near", "other", "table", max=0.3)]), init="random")
    assert np.mean(solution.status == 0) > 0.9
    assert sw.check(solution.best).valid
    assert solution.best.object("cup").pose.position[2] == pytest.approx(0.77, abs=1e-6)


def test_distinct_layouts_differ_and_are_valid():
    solution = refine(zoo("bedroom-small"), init="random", candidates=64)
    chosen = solution.distinct(5)
    assert len(chosen) == 5
    for i, a in enumerate(chosen):
        assert sw.check(a, walkable=False).valid
        for b in chosen[:i]:
            d = poses_of(a) - poses_of(b)
            turn = np.abs((d[:, 3] + np.pi) % (2 * np.pi) - np.pi)
            assert np.linalg.norm(d[:, :3], axis=1).max() >= 0.5 or turn.max() >= np.pi / 4 - 1e-6


def test_the_best_has_floor_to_walk_on():
    solution = refine(zoo("living"), init="random", candidates=64)
    best = int(solution.order[0])
    assert solution.walkable[best] >= 0.9
    assert abs(sw.check(solution.best).walkable_share - solution.walkable[best]) < 0.15


def test_time_limit_cuts_off_and_says_so():
    solution = refine(zoo("restaurant-dense"), init="random", candidates=512, time_limit=0.3)
    assert solution.timed_out
    assert solution.candidates == 512
    assert np.sum(solution.status != 0) > 0, "it was cut off before all were valid"
    for i in np.flatnonzero(solution.status == 0)[:4]:
        assert sw.check(solution.scene(int(i)), walkable=False).valid


def test_progress_reaches_the_total():
    seen = []
    refine(zoo("living"), candidates=40, progress=lambda *state: seen.append(state))
    assert seen[-1][:2] == (40, 40)
    assert all(done <= total and valid <= done for done, total, valid, _best in seen)


def test_scenes_with_little_in_them():
    assert refine(scene([], [])).best.objects == ()
    assert (refine(scene([BOX], []), init="random").status == 0).all()


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"candidates": 0}, "candidates"),
        ({"candidates": 2.5}, "candidates"),
        ({"seed": -1}, "seed"),
        ({"init": "nowhere"}, "init"),
        ({"init": np.zeros((2, 3, 4))}, "init"),
        ({"init": np.full((2, 1, 4), np.nan)}, "init"),
        ({"optimizer": "magic"}, "optimizer"),
        ({"time_limit": 0}, "time_limit"),
        ({"steps": 0}, "steps"),
        ({"device": "tpu"}, "device"),
    ],
)
def test_bad_arguments_are_named(options, says):
    with pytest.raises(sw.InputError, match=says) as error:
        refine(scene([BOX], []), **options)
    assert "\n" not in str(error.value)


def test_a_device_that_is_not_there():
    with pytest.raises(sw.MissingDependencyError, match="cuda:99"):
        refine(scene([BOX], []), device="cuda:99")


def test_an_object_larger_than_the_room_is_never_valid():
    solution = refine(scene([thing("whale", (9, 2, 1))], [], room=room(4, 3)), init="random", candidates=4)
    assert (solution.status == 1).all()
    assert engine.BROKEN == 1
