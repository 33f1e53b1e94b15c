"""What must not matter: where the room lies, how it is turned, its mirror image, the order of objects."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from sceneweaver.layout.compile import CompiledScene, compile_scene
from sceneweaver.scene import Scene
from tests.kernels.harness import Energies, batch_of, best_options, noisy, run_energy, scattered, verdict, zoo
from tests.kernels.made import gallery
from tests.kernels.predicates import object_margins, relation_margins
from tests.kernels.transform import mirror, mirror_layout, move, move_layout, permute
from tests.sizes import examples

pytest.importorskip("hypothesis")
from hypothesis import given  # noqa: E402
from hypothesis import strategies as st  # noqa: E402

NAMES = ("bedroom-small", "living-dining-L", "studio-U", "gallery")
EACH = pytest.mark.parametrize("name", NAMES)
CHECKED = examples(3, 12)
SEEDS = st.integers(0, 2**32 - 1)
NEAR = 5e-5  # [m, rad] of a threshold, the verdict may change when the room moves in float32


@cache
def compiled(name: str) -> CompiledScene:
    return compile_scene(gallery()) if name == "gallery" else zoo(name)


def layouts_of(scene: CompiledScene, seed: int) -> np.ndarray:
    """One layout anywhere, one near the scene's own."""
    rng = np.random.default_rng(seed)
    return np.array([scattered(scene.room, rng), noisy(scene.room, rng, rng.choice([1e-3, 0.02, 0.2]), rigid=True)])


def evaluate(scene: CompiledScene, layouts: np.ndarray) -> Energies:
    """Energies under the best options."""
    batch = batch_of([scene.room], [0] * len(layouts), layouts, "cpu")
    best_options(batch)
    return run_energy(batch)


def assert_same_energy(mine: Energies, theirs: Energies) -> None:
    np.testing.assert_allclose(mine.share, theirs.share, rtol=2e-4, atol=2e-5)
    np.testing.assert_allclose(mine.soft, theirs.soft, rtol=2e-4, atol=2e-5)


def assert_same_verdict(scene: CompiledScene, layouts: np.ndarray, other: Scene, moved: np.ndarray) -> None:
    """Same faults, relations and status, unless a margin is as small as float32 is coarse."""
    mine = verdict(scene.room, layouts, "cpu")
    theirs = verdict(compile_scene(other).room, moved, "cpu")
    for c, layout in enumerate(layouts):
        objects = np.abs(object_margins(scene.room, layout)) > NEAR
        relations = np.abs(relation_margins(scene.room, layout)) > NEAR
        np.testing.assert_array_equal(mine.fault[c][objects], theirs.fault[c][objects])
        np.testing.assert_array_equal(mine.holds[c][relations], theirs.holds[c][relations])
        if objects.all() and relations.all():
            assert mine.status[c] == theirs.status[c]


@EACH
@CHECKED
@given(
    seed=SEEDS,
    angle=st.floats(-np.pi, np.pi) | st.sampled_from([np.pi / 2, np.pi, 0.0]),
    shift=st.tuples(st.floats(-8.0, 8.0), st.floats(-8.0, 8.0)),
)
def test_moving_and_turning_the_room(name, seed, angle, shift):
    scene = compiled(name)
    layouts = layouts_of(scene, seed)
    other, moved = move(scene.scene, angle, shift), move_layout(layouts, angle, shift)
    found = evaluate(compile_scene(other), moved)
    assert_same_energy(found, evaluate(scene, layouts))
    assert_same_verdict(scene, layouts, other, moved)


@EACH
@CHECKED
@given(seed=SEEDS)
def test_mirroring_the_room(name, seed):
    scene = compiled(name)
    layouts = layouts_of(scene, seed)
    other, mirrored = mirror(scene.scene), mirror_layout(layouts)
    assert_same_energy(evaluate(compile_scene(other), mirrored), evaluate(scene, layouts))
    assert_same_verdict(scene, layouts, other, mirrored)


@EACH
def test_mirroring_twice_gives_the_room_back(name):
    scene = compiled(name).scene
    twice = mirror(mirror(scene))
    np.testing.assert_allclose(twice.room.outline, scene.room.outline)
    rooms = ((*room.doors, *room.windows) for room in (twice.room, scene.room))
    for mine, theirs in zip(*rooms, strict=True):
        assert mine.wall == theirs.wall and mine.offset == pytest.approx(theirs.offset)
    assert twice.relations == scene.relations


@EACH
@CHECKED
@given(seed=SEEDS, data=st.data())
def test_permuting_objects_and_relations(name, seed, data):
    scene = compiled(name)
    order = data.draw(st.permutations(range(scene.room.size)))
    links = data.draw(st.permutations(range(len(scene.scene.relations))))
    layouts = layouts_of(scene, seed)
    other = compile_scene(permute(scene.scene, order, links))
    mine, theirs = evaluate(other, layouts[:, order]), evaluate(scene, layouts)
    np.testing.assert_allclose(mine.share, theirs.share[:, order], rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(mine.soft, theirs.soft[:, order], rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(mine.gradient, theirs.gradient[:, order], rtol=1e-4, atol=1e-4)
    one, two = verdict(other.room, layouts[:, order], "cpu"), verdict(scene.room, layouts, "cpu")
    np.testing.assert_array_equal(one.status, two.status)
    np.testing.assert_array_equal(one.fault, two.fault[:, order])
    np.testing.assert_array_equal(one.holds[:, : len(links)], two.holds[:, links])
