"""Layouts that the prior draws: poses, seeds, files, bad input."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.io.weights import quantised
from sceneweaver.prior import LayoutPrior
from sceneweaver.prior.tokens import tokens_of
from sceneweaver.prior.weights import load_weights, save_weights
from tests.prior.conftest import WORDS, small_weights


def home(scene):
    return np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])


def test_equal_seeds_draw_equal_layouts_and_more_begin_alike(small):
    scene = sw.Scene.example("bedroom")
    poses = small.sample(scene, 5, seed=7)
    assert poses.shape == (5, len(scene.objects), 4) and np.isfinite(poses).all()
    np.testing.assert_array_equal(small.sample(scene, 5, seed=7), poses)
    np.testing.assert_allclose(small.sample(scene, 40, seed=7)[:5], poses, atol=1e-5)
    assert np.abs(small.sample(scene, 5, seed=8) - poses).max() > 0.1


def test_fixed_things_and_heights_stay_and_riders_go_along(small):
    scene = sw.Scene.example("study")
    first = next(o for o in scene.objects if o.mount == "floor")
    objects = tuple(o.model_copy(update={"fixed": o is first}) for o in scene.objects)
    scene = scene.model_copy(update={"objects": objects})
    poses, given = small.sample(scene, 3, seed=1), home(scene)
    number = {o.id: i for i, o in enumerate(scene.objects)}
    for i, obj in enumerate(scene.objects):
        np.testing.assert_allclose(poses[:, i, 2], given[i, 2], atol=1e-9)
        if obj.fixed:
            np.testing.assert_array_equal(poses[:, i], np.repeat(given[i : i + 1], 3, axis=0))
        if obj.support is not None:
            k = number[obj.support.object]
            apart = np.linalg.norm(poses[:, i, :2] - poses[:, k, :2], axis=-1)
            np.testing.assert_allclose(apart, np.linalg.norm(given[i, :2] - given[k, :2]), atol=1e-6)
    assert any(o.support is not None for o in scene.objects)


def test_tokens_and_world_are_inverse():
    scene = sw.Scene.example("bedroom")
    tokens, given = tokens_of(scene, WORDS), home(scene)[None]
    xy, yaw = tokens.world(tokens.local(given))
    np.testing.assert_allclose(xy, given[:, tokens.index, :2], atol=1e-5)
    np.testing.assert_allclose(np.cos(yaw - given[:, tokens.index, 3]), 1.0, atol=1e-6)


def test_a_room_that_is_turned_and_moved_has_the_same_tokens(small):
    scene = sw.Scene.example("study")
    c, s = np.cos(0.7), np.sin(0.7)

    def there(x, y):
        return float(c * x - s * y + 3.0), float(s * x + c * y - 2.0)

    room = scene.room.model_copy(update={"outline": tuple(there(x, y) for x, y in scene.room.outline)})
    objects = tuple(
        o.model_copy(
            update={"pose": sw.Pose.from_yaw(*there(*o.pose.position[:2]), o.pose.position[2], o.pose.yaw + 0.7)}
        )
        for o in scene.objects
    )
    turned = scene.model_copy(update={"room": room, "objects": objects})
    ours, theirs = tokens_of(scene, WORDS), tokens_of(turned, WORDS)
    for name in ("room", "walls", "openings", "objects", "edges", "unary"):
        np.testing.assert_allclose(getattr(theirs, name), getattr(ours, name), atol=1e-5, err_msg=name)


def test_weights_go_through_a_file_in_8_bits(tmp_path):
    weights, shape = small_weights()
    save_weights(tmp_path / "prior.npz", weights, shape, WORDS, {"rooms": 3})
    found, again, words, about = load_weights(tmp_path / "prior.npz")
    assert (again, words, about) == (shape, WORDS, {"rooms": 3})
    for name, value in weights.items():
        step = np.asarray(quantised(value)[1]) if value.ndim == 2 else np.abs(value) * 1e-3
        assert (np.abs(found[name] - value) <= 0.51 * step + 1e-7).all(), name
    number, _ = quantised(weights["pose"])
    assert number.dtype == np.int8
    prior = LayoutPrior.load(tmp_path / "prior.npz")
    scene = sw.Scene.example("bedroom")
    off = prior.sample(scene, 4) - LayoutPrior(weights, shape, WORDS, {}).sample(scene, 4)
    assert np.abs(off[..., :2]).max() < 0.3


def test_the_shipped_weights_are_small_and_load():
    from sceneweaver.prior.model import SHIPPED

    assert SHIPPED.stat().st_size < 20 * 2**20
    prior = sw.LayoutPrior.load()
    assert prior is sw.LayoutPrior.load() and "weights" in repr(prior)


def test_refine_begins_with_the_prior():
    scene = sw.Scene.example("bedroom")
    one = sw.refine(scene, candidates=4, seed=3, init="prior", device="cpu")
    two = sw.refine(scene, candidates=4, seed=3, init=sw.LayoutPrior.load().sample(scene, 4, 3), device="cpu")
    np.testing.assert_array_equal(one.poses, two.poses)
    (many,) = sw.refine_many([scene], candidates=4, seed=3, init="prior", device="cpu")
    np.testing.assert_array_equal(many.poses, one.poses)
    assert (one.status == 0).any() and sw.check(one.best).valid


def test_refine_many_takes_poses_of_each_scene():
    scenes = [sw.Scene.example(name) for name in ("bedroom", "study")]
    starts = [np.repeat(home(scene)[None], 3, axis=0) for scene in scenes]
    both = sw.refine_many(scenes, candidates=3, seed=1, init=starts, device="cpu")
    for scene, start, found in zip(scenes, starts, both, strict=True):
        alone = sw.refine(scene, seed=1, init=start, device="cpu")
        np.testing.assert_array_equal(found.poses, alone.poses)


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"candidates": 0}, "candidates: 0"),
        ({"steps": 1.5}, "steps: 1.5"),
        ({"seed": -1}, "seed: -1"),
        ({"seed": True}, None),
    ],
)
def test_bad_arguments_are_named(small, options, text):
    if text is None:
        assert small.sample(sw.Scene.example("bedroom"), **({"candidates": 1} | options)).shape[0] == 1
        return
    with pytest.raises(sw.InputError, match=text):
        small.sample(sw.Scene.example("bedroom"), **options)


def test_bad_files_are_one_line(tmp_path):
    weights, shape = small_weights()
    path = tmp_path / "prior.npz"
    with pytest.raises(sw.InputError):
        LayoutPrior.load(tmp_path / "missing.npz")
    path.write_bytes(b"no archive")
    with pytest.raises(sw.InputError):
        LayoutPrior.load(path)
    np.savez(path, other=np.zeros(3))
    with pytest.raises(sw.InputError, match="no weights of a prior"):
        LayoutPrior.load(path)
    save_weights(path, weights | {"out": weights["out"][:5]}, shape, WORDS, {})
    with pytest.raises(sw.InputError, match="damaged"):
        LayoutPrior.load(path)
    save_weights(path, weights | {"norm": weights["norm"] * np.nan}, shape, WORDS, {})
    with pytest.raises(sw.InputError, match="damaged"):
        LayoutPrior.load(path)
    full = tmp_path / "cut.npz"
    save_weights(full, weights, shape, WORDS, {})
    full.write_bytes(full.read_bytes()[:2000])
    with pytest.raises(sw.InputError):
        LayoutPrior.load(full)


def test_a_room_that_is_too_large_is_refused(small, monkeypatch):
    from sceneweaver.prior import tokens

    monkeypatch.setattr(tokens, "MOST_OBJECTS", 3)
    with pytest.raises(sw.InputError, match='init="sample"'):
        small.sample(sw.Scene.example("bedroom"), 1)


def test_an_empty_room_has_no_poses(small):
    scene = sw.Scene.example("bedroom").model_copy(update={"objects": (), "relations": (), "free_areas": ()})
    assert small.sample(scene, 2).shape == (2, 0, 4)
