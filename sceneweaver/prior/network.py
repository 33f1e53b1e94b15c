"""The network, written once for NumPy and JAX: a set transformer that reads a scene, and one that moves its objects.

`encode` reads the tokens of a scene once. `velocity` then says where each object should go at a moment of the flow, for
any number of candidates; its layers look at the objects as they stand now and at the tokens of the encoder together.
Which tokens a relation is between enters as a bias of attention. Layers norm first, without biases; the activation is
the square of the positive part, which costs one multiplication.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from .tokens import OBJECT_WIDTH, OPENING_WIDTH, ROOM_WIDTH, WALL_WIDTH

Weights = Mapping[str, Any]
"""Arrays by name."""

WAVES = (1.0, 2.0, 4.0, 8.0)
"""Frequencies of the sines of x and y, in half turns a unit."""

POSE_WIDTH = 4 + 4 * len(WAVES)
TIME_WIDTH = 32
FAR = -1.0e9
"""What is added to the attention of what is not there."""


@dataclass(frozen=True)
class Shape:
    """How large a network is.

    Attributes:
        wide, deep, heads: width, layers and heads of attention of the encoder.
        slim, steps, eyes: the same of what moves the objects.
        categories, kinds, relations: how many names each has, without the unknown one.
    """

    categories: int
    kinds: int
    relations: int
    wide: int = 256
    deep: int = 6
    heads: int = 8
    slim: int = 192
    steps: int = 6
    eyes: int = 6

    @property
    def edges(self) -> int:
        """How many numbers edges have."""
        return 2 + 2 * self.relations

    def to_json(self) -> dict[str, int]:
        """As JSON data."""
        return asdict(self)


def layout_of(shape: Shape) -> dict[str, tuple[int, ...]]:
    """Names and shapes of all weights."""
    d, s = shape.wide, shape.slim
    found: dict[str, tuple[int, ...]] = {
        "category": (shape.categories + 1, d),
        "kind": (shape.kinds + 1, d),
        "unary": (shape.relations, d),
        "room": (ROOM_WIDTH, d),
        "wall": (WALL_WIDTH, d),
        "opening": (OPENING_WIDTH, d),
        "object": (OBJECT_WIDTH, d),
        "given": (4, d),
        "sort": (4, d),
        "norm": (d,),
        "start": (d, s),
        "pose": (POSE_WIDTH, s),
        "time_in": (TIME_WIDTH, s),
        "time_out": (s, s),
        "out_norm": (s,),
        "out": (s, 4),
        "out_bias": (4,),
    }
    for k in range(shape.deep):
        found |= {
            f"e{k}.norm": (d,),
            f"e{k}.qkv": (d, 3 * d),
            f"e{k}.join": (d, d),
            f"e{k}.edge": (shape.edges, shape.heads),
            f"e{k}.norm2": (d,),
            f"e{k}.up": (d, 4 * d),
            f"e{k}.down": (4 * d, d),
        }
    for k in range(shape.steps):
        found |= {
            f"d{k}.norm": (s,),
            f"d{k}.time": (s, 2 * s),
            f"d{k}.qkv": (s, 3 * s),
            f"d{k}.context": (d, 2 * s),
            f"d{k}.join": (s, s),
            f"d{k}.edge": (shape.edges, shape.eyes),
            f"d{k}.norm2": (s,),
            f"d{k}.up": (s, 2 * s),
            f"d{k}.down": (2 * s, s),
        }
    return found


def first_weights(shape: Shape, seed: int) -> dict[str, np.ndarray]:
    """Weights to begin training with: normal, by the width that they read; what ends a layer smaller; norms 1."""
    rng = np.random.default_rng(seed)
    found = {}
    for name, size in layout_of(shape).items():
        last = name.rpartition(".")[2]
        if "norm" in name:
            found[name] = np.ones(size, dtype=np.float32)
        elif last in ("out", "out_bias", "edge", "time"):
            found[name] = np.zeros(size, dtype=np.float32)
        else:
            scale = 1.0 if last in ("category", "kind", "unary", "sort") else size[0] ** -0.5
            scale *= 0.3 if last in ("join", "down") else 1.0
            scale *= 0.5 if last in ("category", "kind", "unary", "sort") else 1.0
            found[name] = (scale * rng.standard_normal(size)).astype(np.float32)
    return found


@dataclass(frozen=True)
class Context:
    """What `encode` found in scenes S: for layers of `velocity` keys and values of T tokens and biases of attention.

    Attributes:
        begin: [S, N, slim], the objects.
        keys, values: for each layer [S, eyes, T, slim / eyes].
        bias: for each layer [S, eyes, N, T + N], relations and masks.
        given: [S, N, 4].
        fixed: [S, N, 1], 1 where the object stays at ``given``.
    """

    begin: Any
    keys: tuple[Any, ...]
    values: tuple[Any, ...]
    bias: tuple[Any, ...]
    given: Any
    fixed: Any


def encode(w: Weights, shape: Shape, tokens: Mapping[str, Any], xp: Any = np, low: Any = None) -> Context:
    """Read scenes S.

    Args:
        w: the weights.
        shape: of the network.
        tokens: arrays of `tokens.Padded` by name.
        xp: ``numpy`` or ``jax.numpy``.
        low: what computes products of matrices; None: the operator.
    """
    walls, openings = tokens["walls"].shape[1], tokens["openings"].shape[1]
    first, sort = 1 + walls + openings, w["sort"]
    room = tokens["room"][:, None] @ w["room"] + w["kind"][tokens["kind"]][:, None] + sort[0]
    objects = tokens["objects"] @ w["object"] + w["category"][tokens["categories"]] + tokens["unary"] @ w["unary"]
    h = xp.concatenate(
        [
            room,
            tokens["walls"] @ w["wall"] + sort[1],
            tokens["openings"] @ w["opening"] + sort[2],
            objects + tokens["given"] @ w["given"] + sort[3],
        ],
        axis=1,
    )
    away = xp.where(tokens["mask"], 0.0, FAR).astype(h.dtype)[:, None, None, :]
    for k in range(shape.deep):
        q, key, value = _heads(_product(_normed(h, w[f"e{k}.norm"], xp), w[f"e{k}.qkv"], low), 3, shape.heads, xp)
        bias = away + _biases(w[f"e{k}.edge"], tokens["edges"], xp)
        h = h + _product(_joined(_attended(q, key, value, bias, xp, low), xp), w[f"e{k}.join"], low)
        h = h + _expanded(_normed(h, w[f"e{k}.norm2"], xp), w[f"e{k}.up"], w[f"e{k}.down"], xp, low)
    h = _normed(h, w["norm"], xp)
    edges = tokens["edges"][:, first:]
    edges = xp.concatenate([edges, edges[:, :, first:]], axis=2)
    absent = xp.concatenate([away, away[..., first:]], axis=3)
    keys, values, biases = [], [], []
    for k in range(shape.steps):
        key, value = _heads(_product(h, w[f"d{k}.context"], low), 2, shape.eyes, xp)
        keys.append(key)
        values.append(value)
        biases.append(absent + _biases(w[f"d{k}.edge"], edges, xp))
    fixed = tokens["objects"][:, :, 10:11]
    begin = _product(h[:, first:], w["start"], low)
    return Context(begin, tuple(keys), tuple(values), tuple(biases), tokens["given"], fixed)


def velocity(w: Weights, shape: Shape, context: Context, x: Any, time: Any, xp: Any = np, low: Any = None) -> Any:
    """Where objects go: velocity [S, K, N, 4] of candidates K of scenes S at x [S, K, N, 4] and times [S, K] in [0, 1].

    Velocity of what is fixed is that to where it stays.
    """
    count, candidates, objects = x.shape[:3]
    moment, mixed = moments(w, shape, time, xp, low)
    h = context.begin[:, None] + _product(_seen(x, xp), w["pose"], low) + moment[:, :, None]
    h = h.reshape(count, candidates * objects, shape.slim)
    for k in range(shape.steps):
        scale, shift = mixed[..., k, 0, None, :], mixed[..., k, 1, None, :]
        normed = _normed(h, w[f"d{k}.norm"], xp).reshape(count, candidates, objects, shape.slim)
        normed = normed * (1.0 + scale) + shift
        q, key, value = _heads(_product(normed, w[f"d{k}.qkv"], low), 3, shape.eyes, xp)
        both = _looked(q, key, value, context.keys[k], context.values[k], context.bias[k], xp, low)
        h = h + _product(_joined(both, xp), w[f"d{k}.join"], low).reshape(h.shape)
        h = h + _expanded(_normed(h, w[f"d{k}.norm2"], xp), w[f"d{k}.up"], w[f"d{k}.down"], xp, low)
    out = _normed(h, w["out_norm"], xp).reshape(count, candidates, objects, shape.slim) @ w["out"] + w["out_bias"]
    return out


def moments(w: Weights, shape: Shape, time: Any, xp: Any = np, low: Any = None) -> tuple[Any, Any]:
    """What follows from times [...] alone: what is added to each object [..., slim], and scale and shift of each layer
    [..., steps, 2, slim]."""
    moment = _silu(_product(_waves(time, xp), w["time_in"], low), xp)
    moment = _silu(_product(moment, w["time_out"], low), xp)
    mixed = [_product(moment, w[f"d{k}.time"], low) for k in range(shape.steps)]
    return moment, xp.stack(mixed, axis=-2).reshape(*time.shape, shape.steps, 2, shape.slim)


def _looked(q: Any, key: Any, value: Any, seen: Any, told: Any, bias: Any, xp: Any, low: Any) -> Any:
    """Attention [S, K, H, N, C] of objects of candidates to tokens [S, H, T, C] of their scene and to each other."""
    scale, tokens = q.shape[-1] ** -0.5, seen.shape[2]
    count, candidates, heads, objects, width = q.shape
    # Queries of all candidates side by side: one product with the tokens that they share.
    shared = xp.swapaxes(q, 1, 2).reshape(count, heads, candidates * objects, width)
    first = _product(shared, xp.swapaxes(seen, -1, -2), low).reshape(count, heads, candidates, objects, tokens)
    first = xp.swapaxes(first, 1, 2)
    second = _product(q, xp.swapaxes(key, -1, -2), low)
    share = _softmax(xp.concatenate([first, second], axis=-1) * scale + bias[:, None], xp)
    a, b = share[..., :tokens], share[..., tokens:]
    a = xp.swapaxes(a, 1, 2).reshape(count, heads, candidates * objects, tokens)
    found = xp.swapaxes(_product(a, told, low).reshape(count, heads, candidates, objects, width), 1, 2)
    return found + _product(b, value, low)


def _product(x: Any, w: Any, low: Any) -> Any:
    """A product of matrices, by a function of its own where there is one."""
    return x @ w if low is None else low(x, w)


def _normed(x: Any, weight: Any, xp: Any) -> Any:
    """RMSNorm (Zhang and Sennrich, 2019)."""
    return x * (1.0 / xp.sqrt((x * x).mean(axis=-1, keepdims=True) + 1e-6)) * weight


def _expanded(x: Any, up: Any, down: Any, xp: Any, low: Any) -> Any:
    """Two layers with the square of the positive part between them (So et al., Primer, 2021)."""
    y = xp.maximum(_product(x, up, low), 0.0)
    return _product(y * y, down, low)


def _heads(x: Any, parts: int, heads: int, xp: Any) -> list[Any]:
    """Some arrays [..., H, N, C] of one [..., N, parts * H * C]."""
    *lead, width = x.shape
    y = xp.moveaxis(x.reshape(*lead, parts, heads, width // (parts * heads)), -3, 0)
    return [xp.swapaxes(y[k], -2, -3) for k in range(parts)]


def _joined(x: Any, xp: Any) -> Any:
    """[..., N, H * C] of [..., H, N, C]."""
    y = xp.swapaxes(x, -2, -3)
    return y.reshape(*y.shape[:-2], y.shape[-2] * y.shape[-1])


def _attended(q: Any, key: Any, value: Any, bias: Any, xp: Any, low: Any) -> Any:
    """Attention (Vaswani et al., 2017) with a bias."""
    score = _product(q, xp.swapaxes(key, -1, -2), low) * q.shape[-1] ** -0.5 + bias
    return _product(_softmax(score, xp), value, low)


def _softmax(score: Any, xp: Any) -> Any:
    """Shares along the last axis."""
    e = xp.exp(score - score.max(axis=-1, keepdims=True))
    return e / e.sum(axis=-1, keepdims=True)


def _biases(table: Any, edges: Any, xp: Any) -> Any:
    """[S, H, A, B] of a table [E, H] at edges [S, A, B]."""
    return xp.moveaxis(table[edges], -1, 1)


def _silu(x: Any, xp: Any) -> Any:
    return x / (1.0 + xp.exp(-x))


def _waves(time: Any, xp: Any) -> Any:
    """Sines and cosines [..., 32] of a moment of the flow [...]."""
    steps = xp.asarray(np.pi * np.geomspace(0.5, 64.0, TIME_WIDTH // 2, dtype=np.float32))
    angle = time[..., None] * steps
    return xp.concatenate([xp.sin(angle), xp.cos(angle)], axis=-1)


def _seen(x: Any, xp: Any) -> Any:
    """A pose [..., 4] with sines and cosines of its place [..., 20]."""
    steps = xp.asarray(np.pi * np.array(WAVES, dtype=np.float32))
    angle = (x[..., :2, None] * steps).reshape(*x.shape[:-1], 2 * len(WAVES))
    return xp.concatenate([x, xp.sin(angle), xp.cos(angle)], axis=-1)
