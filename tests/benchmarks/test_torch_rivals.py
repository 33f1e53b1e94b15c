"""The rivals in PyTorch, where it is installed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from benchmarks.families import FAMILIES
from benchmarks.judging import Judge, opinion, place
from benchmarks.rivals import RIVALS, solve
from benchmarks.rooms import ROOMS, load, witness
from benchmarks.settings import Settings
from benchmarks.starts import movable, noisy_poses, random_poses
from benchmarks.tenbox import ten_boxes
from sceneweaver.scene import Scene

torch = pytest.importorskip("torch", reason="torch is not installed")

from benchmarks.rivals.prisms import Prism  # noqa: E402
from benchmarks.rivals.torch_descent import Descent, advance  # noqa: E402
from benchmarks.rivals.torch_objective import Objective, batch  # noqa: E402
from benchmarks.rivals.torch_overlap import Boxes, Frames, Polygons  # noqa: E402

LIKE = {"device": "cpu", "dtype": torch.float64}


@pytest.fixture(autouse=True)
def one_thread():
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    yield
    torch.set_num_threads(before)


def _losses(scene: Scene, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Losses of space and of relations [B]."""
    space, relations = Objective(scene, "cpu")(batch(poses, movable(scene), "cpu"))
    return space.numpy(), relations.numpy()


@dataclass(frozen=True)
class _Two:
    """Two unit squares, one of them at the origin."""

    prisms: tuple[Prism, ...] = tuple(
        Prism(k, k, np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]), (0.0, 1.0)) for k in (0, 1)
    )


@pytest.mark.parametrize("shapes", [Boxes, Polygons])
@pytest.mark.parametrize(
    ("pose", "depth"),
    [
        ((1.1, 0.0, 0.0), -0.1),
        ((0.9, 0.0, 0.0), 0.1),
        ((0.9, 0.95, 0.0), 0.05),
        ((1.2, 0.0, np.pi / 4), 0.5 + np.sqrt(0.5) - 1.2),
    ],
)
def test_depth_of_two_squares(shapes, pose, depth):
    x = torch.tensor([(0.0, 0.0, 0.0), pose], **LIKE).T[..., None]
    found = shapes(_Two().prisms, np.array([[0, 1]]), LIKE).depth(Frames(x))
    assert float(found) == pytest.approx(depth)


def test_boxes_are_polygons():
    x = torch.as_tensor(np.random.default_rng(0).normal(0, 0.7, (3, 2, 200)), **LIKE)
    boxes, polygons = (kind(_Two().prisms, np.array([[0, 1]]), LIKE).depth(Frames(x)) for kind in (Boxes, Polygons))
    assert boxes.numpy() == pytest.approx(polygons.numpy())


def test_gradient_of_everything():
    scene = load("living-dining-L")
    objective = Objective(scene, "cpu", torch.float64)
    x = batch(random_poses(scene, 1, 0), movable(scene), "cpu").double().requires_grad_(True)
    assert torch.autograd.gradcheck(lambda x: torch.stack(objective(x)).sum(), (x,))


@pytest.mark.parametrize("name", ROOMS[:-2])
def test_nothing_is_amiss_in_space_at_the_witness(name):
    """A margin of 2 mm is asked for that witnesses need not have."""
    space, _ = _losses(load(name), witness(load(name))[None])
    assert space[0] < 1e-3


def test_what_has_no_loss_is_valid_and_what_the_judge_rejects_has_one():
    scene = ten_boxes()
    rng = np.random.default_rng(0)
    poses = np.repeat(witness(scene)[None], 200, axis=0)
    rows = np.arange(200)
    moved = movable(scene)[rng.integers(0, 10, 200)]
    poses[rows, moved, :2] += rng.normal(0.0, 0.05, (200, 2))
    poses[rows, moved, 3] += rng.normal(0.0, 0.1, 200)
    total = sum(_losses(scene, poses))
    valid = np.array([opinion(place(scene, p)).valid for p in poses])
    assert valid[total == 0].all() and (total == 0).sum() > 5
    assert (total[~valid] > 0).all() and (~valid).sum() > 20


def test_pairs_that_are_left_out_do_not_touch():
    scene = load("restaurant-60")
    objective = Objective(scene, "cpu")
    x = batch(noisy_poses(scene, 2, 0), movable(scene), "cpu")
    before, _ = objective(x)
    counts = [o.pairs.shape[1] for o in objective.overlaps]
    objective.look(x, 1.2)
    assert all(o.pairs.shape[1] < c for o, c in zip(objective.overlaps, counts, strict=True))
    assert objective(x)[0].numpy() == pytest.approx(before.numpy(), rel=1e-4)


def test_a_step_is_one_graph():
    """Nothing in a step keeps it from being compiled as a whole."""
    descent = Descent(load("dining-round"), 3, "cpu")
    torch._dynamo.reset()
    whole = torch.compile(advance, backend="aot_eager", fullgraph=True, dynamic=False)
    arguments = (descent.objective, descent.state, descent.noise, descent.now)
    for ours, theirs in zip(whole(*arguments), advance(*arguments), strict=True):
        assert torch.allclose(ours, theirs, atol=1e-5)


def test_descent_solves_most_noisy_starts_and_repeats_itself():
    scene = ten_boxes()
    starts = noisy_poses(scene, 32, 0)
    poses, seconds = solve(RIVALS["torch descent"], scene, starts, 0, "cpu")
    opinions = Judge(1)(scene, poses)
    assert seconds > 0
    assert all(o.solid for o in opinions)
    assert sum(o.valid for o in opinions) >= 24
    assert np.array_equal(poses, solve(RIVALS["torch descent"], scene, starts, 0, "cpu")[0])


@pytest.mark.parametrize("name", ["ten-boxes", "bedroom-small", "living-dining-L"])
def test_positions_only_never_turns_anything(name):
    scene = ten_boxes() if name == "ten-boxes" else load(name)
    starts = noisy_poses(scene, 4, 0)
    poses, _ = solve(RIVALS["torch positions"], scene, starts, 0, "cpu")
    floor = movable(scene)
    assert np.array_equal(poses[:, floor, 2:], starts[:, floor, 2:])
    assert np.abs(poses[:, floor, :2] - starts[:, floor, :2]).max() > 0.05


def test_positions_only_parts_most_boxes():
    scene = ten_boxes()
    poses, _ = solve(RIVALS["torch positions"], scene, noisy_poses(scene, 16, 0), 0, "cpu")
    assert sum(o.solid for o in Judge(1)(scene, poses)) >= 12


def test_they_take_part_in_the_families(tmp_path):
    names = ("torch descent", "torch positions")
    settings = Settings(rooms=("bedroom-small",), device="cpu", quick=True, most=4, rivals=names, out=tmp_path)
    result = FAMILIES["throughput"](settings, Judge(1))
    assert result.failures == []
    for table, rows in (("throughput", 1), ("boxes", 2)):
        for name in names:
            found = [row for row in result.table(table).rows if row["system"] == name]
            assert len(found) == rows
            assert all(row["rate"] >= 0 for row in found)


def test_a_gpu_that_is_not_there_is_said_so():
    if torch.cuda.is_available():
        pytest.skip("there is one")
    assert RIVALS["torch descent"].missing("cuda:0") == "this torch finds no CUDA device"
    assert RIVALS["torch descent"].missing("cpu") is None
