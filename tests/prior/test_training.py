"""Training: rooms are turned and mirrored as wholes, the loss falls, and what was stopped goes on as if it had not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.prior import training
from sceneweaver.prior.network import Shape, first_weights
from sceneweaver.prior.tokens import TRAINED, padded, tokens_of
from sceneweaver.prior.training import Recipe, State, _batch, _loss, _on_device, split_rooms, train, trained_names
from tests.prior.conftest import WORDS

SIDES = (WORDS.relation("left_of"), WORDS.relation("right_of"))
RECIPE = Recipe(rooms=4, layouts=2, low="float32", sides=SIDES)  # pyright: ignore[reportArgumentType]
AT_WALL = WORDS.relation("against_wall")


@pytest.fixture(scope="module")
def data() -> dict[str, np.ndarray]:
    """Three layouts, all as given, of two example scenes."""
    scenes = [sw.Scene.example(name) for name in ("bedroom", "study")]
    tokens = [tokens_of(scene, WORDS) for scene in scenes]
    poses = np.zeros((6, TRAINED["objects"], 4), dtype=np.float32)
    for k, (scene, token) in enumerate(zip(scenes, tokens, strict=True)):
        home = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])
        poses[3 * k : 3 * k + 3, : len(token.index)] = token.local(home)
    arrays = {f"token.{name}": value for name, value in padded(tokens, **TRAINED).arrays().items()}
    return arrays | {"poses": poses, "counts": np.array([3, 3])}


def test_names_of_no_room_are_left_out(data):
    found, words = trained_names(data, WORDS, least=1)
    assert set(words.categories) <= set(WORDS.categories) and "desk" in words.categories
    there = data["token.categories"] > 0
    assert ((found["token.categories"] > 0) == there).all()
    rare, few = trained_names(data, WORDS, least=2)
    assert len(few.categories) < len(words.categories) and rare["token.categories"].max() == len(few.categories)


def test_rooms_can_be_split(data):
    one = split_rooms(data, np.array([False, True]))
    assert len(one["counts"]) == 1 and len(one["poses"]) == 3
    np.testing.assert_array_equal(one["poses"], data["poses"][3:])


def test_rooms_are_turned_and_mirrored_with_all_that_is_in_them(data):
    import jax
    import jax.numpy as jnp

    run = jax.jit(lambda key, kept, poses: _batch(key, kept, poses, 2, replace(RECIPE, rooms=24), jax))
    tokens, x, there = run(jax.random.key(1), *_on_device(data, jnp))
    walls, mask = np.asarray(tokens["walls"]), np.asarray(tokens["mask"])[:, 1 : 1 + TRAINED["walls"]]
    along = walls[..., 2:4] - walls[..., 0:2]
    along /= np.maximum(np.linalg.norm(along, axis=-1, keepdims=True), 1e-9)
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    assert np.abs(inward - walls[..., 4:6])[mask].max() < 1e-5
    x, there, objects = np.asarray(x), np.asarray(there).astype(bool), np.asarray(tokens["objects"])
    backs = []
    for s, n in zip(*np.nonzero(there & (np.asarray(tokens["unary"])[..., AT_WALL] > 0)), strict=True):
        back = x[s, 0, n, :2] - 0.5 * objects[s, n, 0] * x[s, 0, n, 2:]
        off = np.abs(((back - walls[s, :, :2]) * walls[s, :, 4:6]).sum(axis=-1))
        off += 1.0 - walls[s, :, 4:6] @ x[s, 0, n, 2:]
        backs.append(off[mask[s]].min())
    assert len(backs) > 20 and np.quantile(backs, 0.9) < 0.1
    assert len({tuple(np.round(w[0, :4], 3)) for w in walls}) >= 8  # of two rooms in eight ways each


SIZES = {"wide": 32, "deep": 1, "heads": 2, "slim": 32, "steps": 1, "eyes": 2}
SHAPE = Shape(len(WORDS.categories), len(WORDS.kinds), len(WORDS.relations), **SIZES)


def exact(data, steps, ends):
    """A training of so many steps hands out states after ``ends``, and Adam has counted them."""
    made = [(now(), step) for now, _, step in train(data, SHAPE, RECIPE, seed=3, steps=steps)]
    assert [step for _, step in made] == ends == [state.step for state, _ in made]
    counts = [int(m) for m in made[-1][0].moments if m.shape == () and m.dtype.kind == "i"]
    assert counts and set(counts) == {steps}


def test_chunks_are_as_many_steps_as_are_told(data, monkeypatch):
    """With a chunk that only counts its keys: to compile one that learns takes long."""
    import jax
    import optax  # noqa: F401 - before jax.jit is another: it compiles functions of its own where it is imported

    def counted(_chunk, **_options):
        def run(weights, average, moments, _step, _rate, keys, *_data):
            one_more = jax.tree.map(lambda m: m + len(keys) * (m.shape == () and m.dtype.kind == "i"), moments)
            return weights, average, one_more, 0.0

        return run

    monkeypatch.setattr(jax, "jit", counted)
    exact(data, 2, [2])
    monkeypatch.setattr(training, "CHUNK", 3)
    exact(data, 5, [3, 5])
    exact(data, 3, [3])


def test_the_loss_can_be_lowered(data):
    import jax
    import jax.numpy as jnp

    kept, poses = _on_device(data, jnp)
    keys = jax.random.split(jax.random.key(2))

    def loss(weights):
        batch = _batch(keys[0], kept, poses, 2, replace(RECIPE, rooms=2, layouts=1), jax)
        return _loss(weights, *batch, keys[1], shape=SHAPE, low=None, jax=jax)

    weights = {k: jnp.asarray(v) for k, v in first_weights(SHAPE, 3).items()}
    fast = {"xla_backend_optimization_level": 0}  # to compile; it runs twice
    run = jax.jit(jax.value_and_grad(loss)).lower(weights).compile(fast)
    value, slope = run(weights)
    lower, _ = run({k: w - 1e-2 * slope[k] for k, w in weights.items()})
    assert 0.0 < lower < value


@pytest.mark.slow
def test_fewer_steps_than_a_chunk_has_are_just_so_many(data):
    exact(data, 2, [2])


@pytest.mark.slow
def test_the_last_chunk_is_as_short_as_is_left(data, monkeypatch):
    monkeypatch.setattr(training, "CHUNK", 3)
    exact(data, 5, [3, 5])
    exact(data, 3, [3])


@pytest.mark.slow
def test_the_loss_falls_and_a_stopped_training_goes_on(data, monkeypatch):
    monkeypatch.setattr(training, "CHUNK", 10)
    whole = [(now(), loss) for now, loss, _ in train(data, SHAPE, RECIPE, seed=3, steps=200)]
    assert np.mean([v for _, v in whole[-4:]]) < 0.8 * whole[0][1]
    half = State.of(whole[9][0].arrays())
    rest = [now() for now, _, _ in train(data, SHAPE, RECIPE, seed=3, steps=200, state=half)]
    assert rest[-1].step == 200 and len(rest) == 10
    for name, value in whole[-1][0].average.items():
        np.testing.assert_allclose(rest[-1].average[name], value, atol=1e-5, err_msg=name)
