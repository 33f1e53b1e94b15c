"""Scenes as arrays: against the scenes themselves, in every frame, streamed, shuffled, shared without a copy."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.datasets import Folder, Limits, Vocabulary, collate, tensors
from sceneweaver.datasets.arrays import view as views
from sceneweaver.datasets.files import pack
from tests.datasets.small import KINDS, make_small, small_scene
from tests.test_repository import ROOT, code_blocks

SCENES = [small_scene(k) for k in range(5)]


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    root = tmp_path_factory.mktemp("packed")
    requests = make_small(root, 12, failed=(3,))
    pack(Folder(root), requests)
    return root


@pytest.mark.parametrize("frame", ["room", "middle", "unit"])
def test_arrays_say_what_the_scenes_say(frame):
    view = tensors(SCENES, frame=frame)
    found = view.all()
    world = found.world(found.poses)
    for b, scene in enumerate(SCENES):
        n, scale = len(scene.objects), found.scale[b]
        assert found.mask[b].sum() == n and found.mask[b, :n].all()
        wanted = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])
        np.testing.assert_allclose(world[b, :n], wanted, atol=1e-5)
        np.testing.assert_allclose(found.sizes[b, :n] * scale, [o.size for o in scene.objects], atol=1e-5)
        np.testing.assert_allclose(np.arctan2(found.turns[b, :n, 1], found.turns[b, :n, 0]), wanted[:, 3], atol=1e-5)
        assert [view.vocabulary.name(c) for c in found.categories[b, :n]] == [o.category for o in scene.objects]
        carriers = [None if o.support is None else o.support.object for o in scene.objects]
        assert [None if s < 0 else scene.objects[s].id for s in found.supports[b, :n]] == carriers
        corners = found.corners[b][found.corner_mask[b]] * scale + found.origin[b]
        np.testing.assert_allclose(corners, scene.room.outline, atol=1e-5)
        assert found.heights[b] * scale == pytest.approx(scene.room.height)
        for name in ("poses", "turns", "sizes", "categories", "mounts"):
            assert not getattr(found, name)[b, n:].any()
        assert (found.supports[b, n:] == -1).all()


def test_openings_lie_in_their_walls():
    scene = SCENES[0]
    found = tensors([scene], frame="room").all()
    doors = found.openings[0][found.opening_kinds[0] == 1]
    windows = found.openings[0][found.opening_kinds[0] == 2]
    assert (len(doors), len(windows)) == (len(scene.room.doors), len(scene.room.windows))
    outline = np.array(scene.room.outline)
    for row, opening in zip(doors, scene.room.doors, strict=True):
        start, end = outline[opening.wall], outline[(opening.wall + 1) % len(outline)]
        along = (end - start) / np.linalg.norm(end - start)
        np.testing.assert_allclose(row[:2], start + along * (opening.offset + opening.width / 2), atol=1e-5)
        np.testing.assert_allclose(row[2:4], (-along[1], along[0]), atol=1e-6)  # counter-clockwise: inward is left
        np.testing.assert_allclose(row[4:], (opening.width, 0.0, opening.height), atol=1e-6)
    np.testing.assert_allclose(windows[:, 5], [w.sill for w in scene.room.windows], atol=1e-6)


def test_units_have_rooms_from_minus_one_to_one():
    found = tensors(SCENES, frame="unit").all()
    for corners, mask in zip(found.corners, found.corner_mask, strict=True):
        assert np.abs(corners[mask]).max() == pytest.approx(1.0)
        np.testing.assert_allclose(corners[mask].max(axis=0), -corners[mask].min(axis=0), atol=1e-6)


def test_a_packed_set_is_what_its_scenes_are(packed):
    view = tensors(packed)
    found = view.all()
    assert len(view) == len(found) == 11 and set(found.keys) == {f"{k:08d}" for k in range(12) if k != 3}
    scenes = [small_scene(int(key)) for key in found.keys]
    alone = collate(scenes, view.vocabulary, view.limits, keys=found.keys)
    for name, value in alone.arrays().items():
        np.testing.assert_array_equal(getattr(found, name), value)
    assert view.vocabulary.rooms == tuple(sorted({s.room.type for s in scenes}))


def test_splits_share_vocabulary_and_sizes_and_nothing_else(packed):
    parts = [tensors(packed, split=name) for name in ("train", "test")]
    assert parts[0].vocabulary == parts[1].vocabulary and parts[0].limits == parts[1].limits
    keys = [set(part.all().keys) for part in parts]
    assert not keys[0] & keys[1] and len(keys[0] | keys[1]) == 11
    assert [len(part) for part in parts] == [len(k) for k in keys]


def test_each_pass_has_every_scene_once_in_an_order_of_its_seed(packed):
    view = tensors(packed)

    def keys(**options):
        return [key for batch in view.batches(4, **options) for key in batch.keys]

    assert keys() == list(view.all().keys)
    assert keys(seed=1) == keys(seed=1) != keys(seed=2)
    assert sorted(keys(seed=1)) == sorted(keys(seed=1, buffer=3)) == sorted(keys())
    assert [len(batch) for batch in view.batches(4)] == [4, 4, 3]
    assert [len(batch) for batch in view.batches(4, whole=True)] == [4, 4]


def test_no_more_scenes_are_read_than_a_buffer_and_a_batch(packed, monkeypatch):
    read = []
    loads = sw.Scene.loads
    monkeypatch.setattr(views.Scene, "loads", lambda text: read.append(1) or loads(text))
    batches = tensors(packed).batches(2, seed=0, buffer=3)
    next(batches)
    assert len(read) <= 3 + 2 < 11


def test_memory_is_shared_with_jax():
    jnp = pytest.importorskip("jax.numpy")
    found = tensors(SCENES).all()
    for name, value in found.arrays(jnp.from_dlpack).items():
        own = getattr(found, name)
        assert own.flags.c_contiguous and own.ctypes.data % 64 == 0
        assert value.unsafe_buffer_pointer() == own.ctypes.data, name


def test_memory_is_shared_with_pytorch():
    torch = pytest.importorskip("torch")
    found = tensors(SCENES).all()
    for name, value in found.arrays(torch.from_numpy).items():
        assert value.data_ptr() == getattr(found, name).ctypes.data, name


def test_a_vocabulary_lasts(tmp_path):
    words = tensors(SCENES).vocabulary
    words.save(tmp_path / "words.json")
    again = Vocabulary.load(tmp_path / "words.json")
    assert again == words == tensors(SCENES[::-1]).vocabulary
    assert again.category("never heard of") == 1 and again.name(0) == "" and again.name(1) == "?"
    few = Vocabulary.of(["bed"], [])
    found = tensors(SCENES, vocabulary=few).all()
    assert set(np.unique(found.categories[found.mask])) == {1, 2} and set(found.rooms) == {1}


@pytest.mark.parametrize(
    ("text", "message"),
    [("[]", "no vocabulary"), ('{"schema": "sceneweaver.vocabulary/1", "categories": ["a", "a"]}', "different names")],
)
def test_what_is_no_vocabulary_is_one_line(tmp_path, text, message):
    (tmp_path / "x.json").write_text(text)
    with pytest.raises(sw.InputError, match=message):
        Vocabulary.load(tmp_path / "x.json")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"frame": "moon"}, 'frame: "moon" is not one of room, middle, unit'),
        ({"split": "train"}, "a list of scenes has no splits"),
        ({"objects": 3}, "objects: scene .* has .*, more than 3; give objects="),
        ({"corners": 3}, "corners: scene .* has 4, more than 3"),
        ({"openings": 1}, "openings: scene .* has .*, more than 1"),
        ({"objects": -1}, "objects: -1 is not a whole number"),
    ],
)
def test_bad_input_is_one_line(options, message):
    with pytest.raises(sw.InputError, match=message):
        tensors(SCENES, **options).all()


def test_bad_sources_and_batches_are_one_line(packed, tmp_path):
    for source, options, message in (
        ([], {}, "source: no scenes"),
        (tmp_path, {}, "no packed data set of scenes"),
        (packed, {"split": "tests"}, 'split: "tests" is not one of test, train'),
    ):
        with pytest.raises(sw.InputError, match=message):
            tensors(source, **options)
    for options, message in (({"size": 0}, "size: 0"), ({"size": 1, "buffer": True}, "buffer: True")):
        with pytest.raises(sw.InputError, match=message):
            tensors(SCENES).batches(**options)
    with pytest.raises(sw.InputError, match="poses: an array of shape"):
        tensors(SCENES).all().world(np.zeros((1, 2, 4)))
    with pytest.raises(sw.InputError, match="number: 99"):
        Vocabulary.of(KINDS, []).name(99)
    with pytest.raises(sw.InputError, match="objects: 1.5"):
        Limits(1.5, 4, 4)


def test_an_empty_room_has_no_objects():
    bare = sw.Scene.example("bedroom").model_copy(update={"objects": (), "relations": ()})
    found = tensors([bare]).all()
    assert not found.mask.any() and found.corner_mask.sum() == len(bare.room.outline)


@pytest.mark.slow
def test_the_model_of_the_guide_learns_which_way_things_face():
    jnp = pytest.importorskip("jax.numpy")
    pytest.importorskip("optax")
    text = (ROOT / "docs" / "datasets.md").read_text()
    (code,) = (block for block in code_blocks(text, "python") if "optax" in block)
    room = sw.Scene.example("bedroom")
    solution = sw.refine(room, candidates=600, init="random", device="cpu", explain=False)
    scenes = [solution.scene(int(k)) for k in solution.ranked[:500]]
    space = {"scenes": scenes[:400]}
    exec(code.replace('tensors(".", frame', "tensors(scenes, frame"), space)
    view = space["view"]
    others = tensors(scenes[400:], frame="unit", vocabulary=view.vocabulary, objects=view.limits.objects).all()
    way = np.asarray(space["predicted"](space["weights"], others.arrays(jnp.from_dlpack)))
    off = np.arctan2(way[..., 1], way[..., 0]) - others.poses[..., 3]
    median = np.degrees(np.median(np.abs((off + np.pi) % (2 * np.pi) - np.pi), axis=0))
    known = [k for k, o in enumerate(room.objects) if o.category in ("dresser", "picture", "chair", "mirror")]
    round_ones = [k for k, o in enumerate(room.objects) if o.category in ("plant", "floor_lamp")]
    assert median[known].max() < 15 < 45 < median[round_ones].min()
