"""One network, three ways to compute it: NumPy, JAX, Warp; and what it must not depend on."""

from __future__ import annotations

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.prior.flow import DeviceFlow
from sceneweaver.prior.network import encode, velocity
from sceneweaver.prior.tokens import padded, tokens_of
from tests.prior.conftest import WORDS, small_weights


def drawn(prior, scene, count=3, seed=5):
    tokens = tokens_of(scene, prior.words)
    noise = np.random.default_rng(seed).standard_normal((count, len(tokens.index), 4)).astype(np.float32)
    return tokens, noise


def test_jax_and_numpy_agree_with_padding(small):
    import jax
    import jax.numpy as jnp

    tokens, noise = drawn(small, sw.Scene.example("study"))
    weights, shape = small_weights()
    time = np.full((1, len(noise)), 0.3, dtype=np.float32)
    ours = velocity(weights, shape, small.context(tokens), noise[None], time)
    sizes = len(tokens.walls) + 3, len(tokens.openings) + 2, len(tokens.objects) + 4
    arrays = {k: jnp.asarray(v) for k, v in padded([tokens], *sizes).arrays().items()}
    x = jnp.pad(jnp.asarray(noise)[None], ((0, 0), (0, 0), (0, 4), (0, 0)), constant_values=9.0)
    there = {k: jnp.asarray(v) for k, v in weights.items()}
    run = jax.jit(lambda w, a, x, t: velocity(w, shape, encode(w, shape, a, jnp), x, t, jnp))
    theirs = run(there, arrays, x, jnp.asarray(time))
    assert np.abs(ours).max() > 0.1
    np.testing.assert_allclose(np.asarray(theirs)[:, :, : noise.shape[1]], ours, atol=1e-4)


@pytest.mark.parametrize("name", ["bedroom", "study"])
def test_warp_and_numpy_agree(small, name):
    scene = sw.Scene.example(name)
    first = scene.objects[0]
    scene = scene.model_copy(update={"objects": (first.model_copy(update={"fixed": True}), *scene.objects[1:])})
    tokens, noise = drawn(small, scene)
    weights, shape = small_weights()
    ours = small.flow(tokens, noise, steps=3)
    theirs = DeviceFlow(weights, shape, "cpu").integrated(noise, small.context(tokens), 3)
    np.testing.assert_allclose(theirs, ours, atol=1e-4)
    np.testing.assert_array_equal(theirs[:, 0], np.repeat(tokens.given[:1], len(noise), axis=0))


def test_kernels_compile_for_a_gpu(tmp_path):
    from sceneweaver.prior import flow_kernels

    for kernel in (flow_kernels.embed, flow_kernels.attention(32)):
        assert wp.compile_aot_module(kernel.module, arch=90, module_dir=tmp_path, use_ptx=True)


@pytest.mark.slow
def test_products_compile_for_a_gpu(tmp_path):
    from sceneweaver.prior import flow_kernels

    module = flow_kernels.product.module
    assert wp.compile_aot_module(module, arch=90, module_dir=tmp_path, use_ptx=False)


def test_the_order_of_objects_does_not_matter(small):
    scene = sw.Scene.example("bedroom")
    tokens, noise = drawn(small, scene)
    there = small.flow(tokens, noise)
    turned = scene.model_copy(update={"objects": scene.objects[::-1]})
    again = tokens_of(turned, small.words)
    np.testing.assert_allclose(small.flow(again, noise[:, ::-1])[:, ::-1], there, atol=1e-4)


def test_relations_change_what_is_drawn(small):
    scene = sw.Scene.example("bedroom")
    tokens, noise = drawn(small, scene)
    bare = tokens_of(scene.model_copy(update={"relations": ()}), small.words)
    assert np.abs(small.flow(bare, noise) - small.flow(tokens, noise)).max() > 1e-3


def test_what_was_not_trained_on_is_unknown(small):
    scene = sw.Scene.example("bedroom")
    objects = tuple(o.model_copy(update={"category": "zither"}) for o in scene.objects)
    tokens = tokens_of(scene.model_copy(update={"objects": objects}), WORDS)
    assert not tokens.categories.any()
    assert np.isfinite(small.sample(scene.model_copy(update={"objects": objects}), 2)).all()
