"""Train the prior by flow matching, with JAX and optax (extra ``prior``).

A pose is four numbers, x and y in units of the room and cosine and sine of the yaw. Between noise x0 ~ N(0, 1) and a
layout x1 the path is straight, x_t = (1 - t) x0 + t x1, and the network learns its velocity x1 - x0 (Lipman et al.,
2023; Liu et al., 2023), at moments t = sigmoid(z), z ~ N(0, 1) (Esser et al., 2024). A step takes some rooms, turns
each by a random quarter, mirrors half of them, and takes several layouts and moments of each, so that the encoder reads
a room once for all. Names of categories and kinds, relations, and places of some objects are left out or given away at
random: so the network knows what to do without them.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from .network import Shape, encode, first_weights, velocity
from .vocabulary import UNKNOWN, Words

CHUNK = 25
"""Steps between two looks of the host."""


@dataclass(frozen=True)
class Recipe:
    """How to train.

    Attributes:
        rooms, layouts: rooms of a step, and layouts of each.
        rate: the highest learning rate.
        warm, fall: shares of the training in which it rises, and in which it falls to zero at the end.
        decay: weight decay.
        average: of the moving average of weights, per step.
        no_names, no_relations, some_given: how often categories are left out (of an object, and for a quarter of that
            of a whole room), relations of a room, and how often some objects' places are given.
        low: numbers of products of matrices, "bfloat16" or "float32".
        sides: numbers of the relation types that a mirror exchanges; -1: none.
    """

    rooms: int = 192
    layouts: int = 12
    rate: float = 1e-3
    warm: float = 0.02
    fall: float = 0.4
    decay: float = 0.01
    average: float = 0.999
    no_names: float = 0.08
    no_relations: float = 0.1
    some_given: float = 0.15
    low: str = "bfloat16"
    sides: tuple[int, int] = (-1, -1)


def trained_names(data: dict[str, np.ndarray], words: Words, least: int = 2) -> tuple[dict[str, np.ndarray], Words]:
    """The data with numbers of those categories and kinds alone that at least so many rooms have, and their names."""
    found = dict(data)
    names = []
    for key, known in (("token.categories", words.categories), ("token.kind", words.kinds)):
        numbers = data[key].reshape(len(data["counts"]), -1)
        rooms = np.zeros(len(known) + 1, dtype=np.int64)
        for row in numbers:
            rooms[np.unique(row)] += 1
        kept = np.flatnonzero((rooms >= least) & (np.arange(len(rooms)) != UNKNOWN))
        table = np.full(len(known) + 1, UNKNOWN, dtype=np.int32)
        table[kept] = 1 + np.arange(len(kept))
        found[key] = table[data[key]]
        names.append(tuple(known[k - 1] for k in kept))
    return found, Words(names[0], names[1], words.relations)


@dataclass
class State:
    """Where training stands: weights, their moving average, the optimiser's arrays, steps, and seconds so far."""

    weights: dict[str, np.ndarray]
    average: dict[str, np.ndarray]
    moments: list[np.ndarray]
    step: int
    seconds: float

    def arrays(self) -> dict[str, np.ndarray]:
        """All of it as arrays by name."""
        found = {f"w.{k}": v for k, v in self.weights.items()} | {f"a.{k}": v for k, v in self.average.items()}
        found |= {f"m.{i:04d}": v for i, v in enumerate(self.moments)}
        return found | {"step": np.array(self.step), "seconds": np.array(self.seconds)}

    @classmethod
    def of(cls, arrays: Mapping[str, np.ndarray]) -> State:
        """What `arrays` gave."""
        weights = {k[2:]: v for k, v in arrays.items() if k.startswith("w.")}
        average = {k[2:]: v for k, v in arrays.items() if k.startswith("a.")}
        moments = [arrays[k] for k in sorted(k for k in arrays if k.startswith("m."))]
        return cls(weights, average, moments, int(arrays["step"]), float(arrays["seconds"]))


def train(
    data: dict[str, np.ndarray],
    shape: Shape,
    recipe: Recipe,
    *,
    seed: int = 0,
    steps: int | None = None,
    seconds: float | None = None,
    state: State | None = None,
) -> Iterator[tuple[Callable[[], State], float, int]]:
    """Train, and hand out every chunk of steps what gives the state, the loss, and how many steps it were.

    The last chunk is as short as makes the steps exactly those that are told; by the time chunks are whole.

    Args:
        data: arrays of rooms: ``token.*`` as `tokens.Padded`, ``poses`` [L, N, 4] and how many of them each room has.
        shape: of the network.
        recipe: how.
        seed: of the first weights and of what is drawn.
        steps: how many in all; the learning rate follows from them.
        seconds: instead of steps, for how long in all, of which ``state`` may have had a part; then the learning rate
            follows from the time.
        state: where to go on from; None: begin.
    """
    import jax
    import jax.numpy as jnp
    import optax

    low = _product(recipe, jax)
    kept, poses = _on_device(data, jnp)
    rooms = len(data["counts"])
    rule = optax.chain(
        optax.clip_by_global_norm(1.0),
        optax.scale_by_adam(0.9, 0.98),
        optax.add_decayed_weights(recipe.decay, mask={name: "norm" not in name for name in first_weights(shape, 0)}),
    )

    loss = partial(_loss, shape=shape, low=low, jax=jax)

    def chunk(weights: Any, average: Any, moments: Any, step: Any, rate: Any, keys: Any, kept: Any, poses: Any) -> Any:
        def one(carry: Any, key: Any) -> Any:
            weights, average, moments, step = carry
            keys = jax.random.split(key)
            tokens, x1, there = _batch(keys[0], kept, poses, rooms, recipe, jax)
            value, slope = jax.value_and_grad(loss)(weights, tokens, x1, there, keys[1])
            change, moments = rule.update(slope, moments, weights)
            weights = jax.tree.map(lambda w, c: w - rate * c, weights, change)
            mix = jnp.minimum(recipe.average, (1.0 + step) / (10.0 + step))
            average = jax.tree.map(lambda a, w: a + (1.0 - mix) * (w - a), average, weights)
            return (weights, average, moments, step + 1.0), value

        carry, values = jax.lax.scan(one, (weights, average, moments, step), keys)
        return carry[0], carry[1], carry[2], values.mean()

    run = jax.jit(chunk, donate_argnums=(0, 1, 2))
    begin = first_weights(shape, seed) if state is None else state.weights
    weights = {k: jnp.asarray(v) for k, v in begin.items()}
    average = {k: jnp.array(v) for k, v in (begin if state is None else state.average).items()}
    moments = rule.init(weights)
    if state is not None:
        moments = jax.tree.unflatten(jax.tree.structure(moments), [jnp.asarray(m) for m in state.moments])
    step, before = (0, 0.0) if state is None else (state.step, state.seconds)
    began = time.monotonic()
    while True:
        spent = before + time.monotonic() - began
        progress = step / steps if steps is not None else spent / (seconds or 1.0)
        if progress >= 1.0:
            return
        rate = recipe.rate * min(1.0, (progress + 1e-3) / recipe.warm, (1.0 - progress) / recipe.fall)
        count = CHUNK if steps is None else min(CHUNK, steps - step)
        keys = jax.random.split(jax.random.fold_in(jax.random.key(seed), step), CHUNK)[:count]
        weights, average, moments, value = run(
            weights, average, moments, jnp.float32(step), jnp.float32(rate), keys, kept, poses
        )
        step += count

        def now(w: Any = weights, a: Any = average, m: Any = moments, n: int = step) -> State:
            leaves = [np.asarray(x) for x in jax.tree.leaves(m)]
            weights, average = ({k: np.asarray(v) for k, v in tree.items()} for tree in (w, a))
            return State(weights, average, leaves, n, before + time.monotonic() - began)

        yield now, float(value), step


def tested(
    data: dict[str, np.ndarray], shape: Shape, recipe: Recipe, batches: int = 8
) -> Callable[[Mapping[str, np.ndarray]], float]:
    """What gives the loss that weights have on data, always at the same rooms, noise and moments."""
    import jax
    import jax.numpy as jnp

    kept, poses = _on_device(data, jnp)
    rooms, loss = len(data["counts"]), partial(_loss, shape=shape, low=_product(recipe, jax), jax=jax)

    def one(weights: Any, key: Any, kept: Any, poses: Any) -> Any:
        keys = jax.random.split(key)
        return loss(weights, *_batch(keys[0], kept, poses, rooms, recipe, jax), keys[1])

    run = jax.jit(one)

    def found(weights: Mapping[str, np.ndarray]) -> float:
        there = {k: jnp.asarray(v) for k, v in weights.items()}
        return float(np.mean([run(there, jax.random.key(k), kept, poses) for k in range(batches)]))

    return found


def _on_device(data: dict[str, np.ndarray], jnp: Any) -> tuple[dict[str, Any], Any]:
    """Arrays of rooms, with where their layouts begin and how many they are, and the layouts."""
    starts = np.concatenate([[0], np.cumsum(data["counts"])[:-1]]).astype(np.int32)
    kept = {k.removeprefix("token."): jnp.asarray(v) for k, v in data.items() if k.startswith("token.")}
    kept |= {"start": jnp.asarray(starts), "count": jnp.asarray(data["counts"].astype(np.int32))}
    return kept, jnp.asarray(data["poses"])


def _product(recipe: Recipe, jax: Any) -> Any:
    """What computes products of matrices: numbers of fewer bits, sums in 32."""
    if recipe.low == "float32":
        return None
    jnp, kind = jax.numpy, jax.numpy.dtype(recipe.low)
    return lambda x, w: jnp.matmul(x.astype(kind), w.astype(kind), preferred_element_type=jnp.float32)


def _loss(weights: Any, tokens: Any, x1: Any, there: Any, key: Any, *, shape: Shape, low: Any, jax: Any) -> Any:
    """Mean squared error of the velocity of what is not fixed."""
    jnp = jax.numpy
    noise, moment = jax.random.split(key)
    x0 = jax.random.normal(noise, x1.shape)
    t = jax.nn.sigmoid(jax.random.normal(moment, x1.shape[:2]))
    fixed = tokens["objects"][:, None, :, 10:11]
    x = jnp.where(fixed > 0, x1, x0 + t[..., None, None] * (x1 - x0))
    found = velocity(weights, shape, encode(weights, shape, tokens, jnp, low), x, t, jnp, low)
    wanted = there[:, None, :, None] * (1.0 - fixed)
    return (wanted * (found - (x1 - x0)) ** 2).sum() / (4.0 * wanted.sum() * x1.shape[1])


def split_rooms(data: dict[str, np.ndarray], rooms: np.ndarray) -> dict[str, np.ndarray]:
    """The data of some rooms [S] bool alone."""
    layouts = np.repeat(rooms, data["counts"])
    sizes = {len(rooms): rooms, len(layouts): layouts}
    return {name: values[sizes[len(values)]] for name, values in data.items()}


def _batch(key: Any, kept: Mapping[str, Any], poses: Any, rooms: int, recipe: Recipe, jax: Any) -> tuple[Any, Any, Any]:
    """Tokens of some rooms, layouts [S, K, N, 4] of each, and which objects [S, N] there are."""
    jnp = jax.numpy
    keys = jax.random.split(key, 10)
    count, layouts, objects = recipe.rooms, recipe.layouts, poses.shape[1]
    rows = jax.random.randint(keys[0], (count,), 0, rooms)
    tokens = {k: v[rows] for k, v in kept.items() if k not in ("start", "count")}
    tokens["edges"] = tokens["edges"].astype(jnp.int32)
    there = tokens["mask"][:, -objects:].astype(jnp.float32)
    which = jnp.floor(jax.random.uniform(keys[1], (count, layouts)) * kept["count"][rows][:, None]).astype(jnp.int32)
    # Where places are given away, all layouts of the room are the same one.
    told = jax.random.uniform(keys[2], (count,)) < recipe.some_given
    which = jnp.where(told[:, None], which[:, :1], which)
    x1 = poses[kept["start"][rows][:, None] + which]
    share = jax.random.uniform(keys[3], (count, 1))
    given = told[:, None] & (jax.random.uniform(keys[4], (count, objects)) < share)
    fixed = jnp.maximum(tokens["objects"][..., 10], given * there)
    tokens["objects"] = tokens["objects"].at[..., 10].set(fixed)
    tokens["given"] = fixed[..., None] * jnp.where(given[..., None], x1[:, 0], tokens["given"])
    blank = jax.random.uniform(keys[5], (count, objects)) < recipe.no_names
    blank |= jax.random.uniform(keys[6], (count, 1)) < recipe.no_names / 4
    tokens["categories"] = jnp.where(blank, UNKNOWN, tokens["categories"])
    drop = jax.random.uniform(keys[7], (count, 2))
    tokens["kind"] = jnp.where(drop[:, 0] < 2 * recipe.no_names, UNKNOWN, tokens["kind"])
    bare = drop[:, 1] < recipe.no_relations
    same = jnp.eye(tokens["edges"].shape[1], dtype=jnp.int32) * tokens["mask"][:, None]
    tokens["edges"] = jnp.where(bare[:, None, None], same, tokens["edges"])
    tokens["unary"] = jnp.where(bare[:, None, None], 0.0, tokens["unary"])
    tokens, x1 = _mirrored(tokens, x1, jax.random.bernoulli(keys[9], 0.5, (count,)), recipe.sides, jnp)
    quarter = jax.random.randint(keys[8], (count,), 0, 4)
    c, s = jnp.array([1.0, 0.0, -1.0, 0.0])[quarter], jnp.array([0.0, 1.0, 0.0, -1.0])[quarter]
    tokens["walls"] = _turned(tokens["walls"], (0, 2, 4), c, s, jnp)
    tokens["openings"] = _turned(tokens["openings"], (0, 2), c, s, jnp)
    tokens["given"] = _turned(tokens["given"], (0, 2), c, s, jnp)
    flat = _turned(x1.reshape(count, layouts * objects, 4), (0, 2), c, s, jnp)
    return tokens, flat.reshape(x1.shape), there


def _mirrored(tokens: Any, x1: Any, chosen: Any, sides: tuple[int, int], jnp: Any) -> tuple[Any, Any]:
    """Some of the rooms as in a mirror in their y axis: what is left becomes right."""
    out = dict(tokens)
    here = chosen[:, None, None]

    def flipped(rows: Any, columns: tuple[int, ...]) -> Any:
        sign = jnp.ones(rows.shape[-1]).at[jnp.array(columns)].set(-1.0)
        return jnp.where(chosen.reshape(-1, *(1,) * (rows.ndim - 1)), rows * sign, rows)

    walls = flipped(tokens["walls"], (0, 2, 4))
    out["walls"] = jnp.where(here, walls[..., jnp.array([2, 3, 0, 1, 4, 5, 6, 7])], walls)  # still counter-clockwise
    out["openings"] = flipped(tokens["openings"], (0, 2))
    out["given"] = flipped(tokens["given"], (0, 2))
    swapped = jnp.array([*range(14), 15, 14])
    out["objects"] = jnp.where(here, tokens["objects"][..., swapped], tokens["objects"])
    a, b = sides
    if min(sides) >= 0:
        edges, unary = tokens["edges"], tokens["unary"]
        pairs = ((2 + 2 * a, 2 + 2 * b), (3 + 2 * a, 3 + 2 * b))
        other = edges
        for one, two in pairs:
            other = jnp.where(edges == one, two, jnp.where(edges == two, one, other))
        out["edges"] = jnp.where(here, other, edges)
        order = jnp.arange(unary.shape[-1]).at[jnp.array([a, b])].set(jnp.array([b, a]))
        out["unary"] = jnp.where(here, unary[..., order], unary)
    return out, flipped(x1, (0, 2))


def _turned(rows: Any, columns: tuple[int, ...], c: Any, s: Any, jnp: Any) -> Any:
    """Rows [S, A, F] with the vectors that begin at some columns turned by angles with cosines and sines [S]."""
    c, s = c[:, None], s[:, None]
    parts = list(jnp.split(rows, rows.shape[-1], axis=-1))
    for k in columns:
        x, y = parts[k][..., 0], parts[k + 1][..., 0]
        parts[k], parts[k + 1] = (c * x - s * y)[..., None], (s * x + c * y)[..., None]
    return jnp.concatenate(parts, axis=-1)
