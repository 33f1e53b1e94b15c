"""The network: the same on NumPy and JAX, texts of a batch do not see each other, files, marks."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.language.learned.analysis import mentions_of
from sceneweaver.language.learned.evidence import RELATIONS, WORDS
from sceneweaver.language.learned.labels import KINDS, LINKS, MARKS
from sceneweaver.language.learned.network import DISTANCES, NEAR, WIDTH, distances, encode, link_scores, mark_scores
from sceneweaver.language.learned.pieces import END, START, UNKNOWN, Vocabulary
from sceneweaver.language.learned.weights import load_model, save_model

NAMES = [UNKNOWN, START, END, "bed", "##room", "a", "##s", "lamp", ".", "-", "in"]


def small_weights(layers: int = 1) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(3)

    def drawn(*shape: int) -> np.ndarray:
        return (rng.standard_normal(shape) * shape[0] ** -0.5).astype(np.float32)

    kinds, inner = len(KINDS) + 1, 16
    weights = {"pieces": drawn(len(NAMES), WIDTH), "places": drawn(40, WIDTH), "kind": drawn(WIDTH)}
    for layer in range(layers):
        for name, sides in {"wide": (WIDTH, 64), "narrow": (64, WIDTH)}.items():
            weights |= {f"{layer}.{name}": drawn(*sides), f"{layer}.{name}.shift": drawn(sides[1])}
        for name in ("query", "key", "value", "read"):
            weights |= {f"{layer}.{name}": drawn(WIDTH, WIDTH), f"{layer}.{name}.shift": drawn(WIDTH)}
    for norm in ("norm", *(f"{layer}.norm{k}" for layer in range(layers) for k in (1, 2))):
        weights |= {f"{norm}.gain": 1 + 0.1 * drawn(WIDTH), f"{norm}.shift": drawn(WIDTH)}
    weights |= {"mark": drawn(WIDTH, len(MARKS)), "mark.shift": drawn(len(MARKS)), "room": drawn(WIDTH)}
    weights |= {"mark.ruled": drawn(len(WORDS), len(MARKS)), "kinds": drawn(kinds, 8)}
    for side in ("from", "to"):
        weights |= {side: drawn(2 * WIDTH + 8, inner), f"{side}.shift": drawn(inner)}
        weights[f"{side}.link"] = drawn(inner, len(LINKS))
    weights |= {"cross": drawn(len(LINKS), inner, inner), "apart": drawn(DISTANCES, len(LINKS))}
    weights |= {name: drawn(RELATIONS, len(LINKS)) for name in ("ruled", "ruled.back")}
    return weights | {"pair": drawn(kinds, kinds, len(LINKS))}


def links(xp, weights, words):
    first, last, kinds = np.array([[0, 0, 2]]), np.array([[0, 1, 2]]), np.array([[len(KINDS), 0, 4]])
    nothing = np.zeros((1, 3, 3), int)
    return link_scores(xp, weights, words, first, last, kinds, distances(first[0])[None], nothing)


def test_numpy_and_jax_say_the_same():
    weights, ids, mask = small_weights(), np.array([[1, 3, 4, 7, 2]]), np.ones((1, 5), np.float32)
    ours, theirs = (encode(xp, weights, ids, mask, 1) for xp in (np, jnp))
    np.testing.assert_allclose(ours, theirs, atol=2e-4)
    read = np.zeros((1, 5), int)
    np.testing.assert_allclose(mark_scores(weights, ours, read), mark_scores(weights, theirs, read), atol=1e-3)
    np.testing.assert_allclose(links(np, weights, ours), links(jnp, weights, theirs), atol=1e-3)


def test_what_fills_a_batch_up_changes_nothing():
    weights = small_weights()
    alone = encode(np, weights, np.array([[1, 3, 2]]), np.ones((1, 3), np.float32), 1)
    filled = encode(np, weights, np.array([[1, 3, 2, 7, 7]]), np.array([[1, 1, 1, 0, 0]], np.float32), 1)
    np.testing.assert_allclose(filled[:, :3], alone, atol=1e-5)


def test_distances_tell_before_from_behind_and_the_room():
    apart = distances(np.array([0, 5, 6, 60]))
    assert (apart[0] == DISTANCES - 1).all() and (apart[:, 0] == DISTANCES - 1).all()
    assert apart[1, 2] != apart[2, 1] and apart[1, 3] != apart[1, 2]
    assert apart.max() == DISTANCES - 1 == 2 * (len(NEAR) + 1)


def test_words_are_split_into_the_longest_pieces():
    split = Vocabulary(NAMES).split("A Bedroom-lamp in\nBEDS, zzz", 40)
    names = ("a", "bed", "in", "bed", UNKNOWN, UNKNOWN)
    assert [split.ids[k] for k in split.first] == [NAMES.index(name) for name in names]
    assert split.words[1] == (2, 14) and split.ids[0] == NAMES.index(START) and split.ids[-1] == NAMES.index(END)
    assert split.ids[2:6] == tuple(NAMES.index(name) for name in ("bed", "##room", "-", "lamp"))
    short = Vocabulary(NAMES).split("a lamp in a bedroom", 5)
    assert len(short.ids) <= 5 and len(short.words) == 3
    assert Vocabulary(NAMES).split("", 9).words == ()


def test_marks_make_mentions():
    marks = [MARKS.index(m) for m in ("begin thing", "inside thing", "outside", "inside place", "begin place")]
    assert mentions_of(marks) == [(0, 2, "thing"), (3, 4, "place"), (4, 5, "place")]


def test_a_network_goes_through_a_file(tmp_path):
    weights = small_weights()
    save_model(tmp_path / "reader.npz", weights, 1, NAMES, {"requests": 4})
    model = load_model(tmp_path / "reader.npz")
    assert model.layers == 1 and model.about == {"requests": 4} and set(model.weights) == set(weights)
    for name, value in weights.items():
        step = np.abs(value).max() / 127
        assert np.abs(model.weights[name] - value).max() <= 0.51 * step + 2e-3 * np.abs(value).max(), name
    assert model.vocabulary.pieces("lamps") == [NAMES.index("lamp"), NAMES.index("##s")]


def test_a_file_of_something_else_is_one_line(tmp_path):
    with pytest.raises(sw.InputError, match="no such file"):
        load_model(tmp_path / "reader.npz")
    np.savez(tmp_path / "reader.npz", other=np.zeros(3))
    with pytest.raises(sw.InputError, match="no weights of a reader"):
        load_model(tmp_path / "reader.npz")
    save_model(tmp_path / "reader.npz", small_weights() | {"room": np.full(WIDTH, np.nan)}, 1, NAMES, {})
    with pytest.raises(sw.InputError, match="damaged"):
        load_model(tmp_path / "reader.npz")
