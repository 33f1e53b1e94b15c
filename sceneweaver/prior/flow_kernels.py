"""The network's second half on a GPU: what `network.velocity` computes, a row for each object of each candidate.

Products of matrices are by tiles of 64 x 64; between them, one block a row norms, and one thread a query attends. Times
are the same for all candidates, so what follows from them alone is computed ahead, on the host.
"""

from functools import cache
from typing import Any

import warp as wp

from sceneweaver.runtime import compiling

compiling.prepare_warp()
wp.set_module_options({"enable_backward": False})

TILE, DEEP = 64, 32
"""Rows and columns of a tile of a product, and how many numbers of a row it takes at once."""

THREADS = 128
"""Of a block that computes a tile."""

STORE, SQUARE, ADD = wp.constant(0), wp.constant(1), wp.constant(2)
"""What becomes of a product: it is stored, the square of its positive part is stored, it is added to what is there."""


@wp.kernel
def embed(
    # Problem:
    begin: wp.array2d[wp.float32],
    weight: wp.array2d[wp.float32],
    moment: wp.array[wp.float32],
    # State in:
    x: wp.array2d[wp.float32],
    # State out:
    h_out: wp.array2d[wp.float32],
):
    """Rows [B * N, s] of what is at x [B * N, 4]: the objects, where they are, and the moment."""
    row, channel = wp.tid()
    total = begin[row % begin.shape[0], channel] + moment[channel]
    for k in range(4):
        total += x[row, k] * weight[k, channel]
    waves = (weight.shape[0] - 4) // 4
    for axis in range(2):
        angle = x[row, axis] * wp.pi
        for k in range(waves):
            # sines of x, of y, then cosines of both
            total += wp.sin(angle) * weight[4 + axis * waves + k, channel]
            total += wp.cos(angle) * weight[4 + (2 + axis) * waves + k, channel]
            angle = 2.0 * angle
    h_out[row, channel] = total


@wp.kernel
def normed(
    # Problem:
    weight: wp.array[wp.float32],
    moment: wp.array2d[wp.float32],
    # State in:
    h: wp.array2d[wp.float32],
    # State out:
    y_out: wp.array2d[wp.float32],
):
    """RMSNorm of every row, times (1 + scale) plus shift of the moment [2, s]."""
    row = wp.tid()
    width = h.shape[1]
    total = float(0.0)
    for k in range(width):
        total += h[row, k] * h[row, k]
    factor = 1.0 / wp.sqrt(total / float(width) + 1.0e-6)
    for k in range(width):
        y_out[row, k] = h[row, k] * factor * weight[k] * (1.0 + moment[0, k]) + moment[1, k]


@wp.kernel
def moved(
    # Problem:
    weight: wp.array2d[wp.float32],
    bias: wp.array[wp.float32],
    fixed: wp.array[wp.float32],
    share: wp.float32,
    # State in:
    y: wp.array2d[wp.float32],
    # State out:
    x_out: wp.array2d[wp.float32],
):
    """A step of Euler's method of x [B * N, 4] by the velocity that rows y [B * N, s] say."""
    row, axis = wp.tid()
    if fixed[row % fixed.shape[0]] > 0.0:
        return
    total = bias[axis]
    for k in range(y.shape[1]):
        total += y[row, k] * weight[k, axis]
    x_out[row, axis] = x_out[row, axis] + share * total


@wp.func
def positive_squared(x: wp.float32):
    """The square of the positive part."""
    y = wp.max(x, 0.0)
    return y * y


@wp.kernel(module="unique", enable_backward=False)
def product(
    # Problem:
    weight: wp.array2d[wp.float32],
    after: wp.int32,
    # State in:
    y: wp.array2d[wp.float32],
    # State out:
    z_out: wp.array2d[wp.float32],
):
    """A product of rows y [R, K] with a matrix [K, C], and what becomes of it: `STORE`, `SQUARE` or `ADD`."""
    row, column = wp.tid()
    total = wp.tile_zeros(shape=(TILE, TILE), dtype=wp.float32)
    for k in range(weight.shape[0] // DEEP):
        a = wp.tile_load(y, shape=(TILE, DEEP), offset=(row * TILE, k * DEEP))
        b = wp.tile_load(weight, shape=(DEEP, TILE), offset=(k * DEEP, column * TILE))
        wp.tile_matmul(a, b, total)
    if after == ADD:
        before = wp.tile_load(z_out, shape=(TILE, TILE), offset=(row * TILE, column * TILE))
        wp.tile_store(z_out, wp.tile_map(wp.add, total, before), offset=(row * TILE, column * TILE))
    elif after == SQUARE:
        wp.tile_store(z_out, wp.tile_map(positive_squared, total), offset=(row * TILE, column * TILE))
    else:
        wp.tile_store(z_out, total, offset=(row * TILE, column * TILE))


@cache
def attention(width: int) -> Any:
    """The kernel of attention with heads of some width C."""
    vec = wp.types.vector(length=width, dtype=wp.float32)

    @wp.kernel(module="unique", enable_backward=False)
    def run(
        # Problem:
        keys: wp.array2d[vec],
        values: wp.array2d[vec],
        bias: wp.array3d[wp.float32],
        scale: wp.float32,
        # State in:
        rows: wp.array2d[vec],
        # State out:
        y_out: wp.array2d[vec],
    ):
        # keys, values [H, T] of the scene; bias [H, N, T + N]; rows [B * N, 3 H]; y_out [B * N, H]
        candidate, head, query = wp.tid()
        heads, tokens, objects = keys.shape[0], keys.shape[1], bias.shape[1]
        first = candidate * objects
        q = rows[first + query, head] * scale
        most = float(-1.0e30)
        total = float(0.0)
        found = vec()
        for k in range(tokens + objects):
            if k < tokens:
                key = keys[head, k]
                value = values[head, k]
            else:
                key = rows[first + k - tokens, heads + head]
                value = rows[first + k - tokens, 2 * heads + head]
            score = wp.dot(q, key) + bias[head, query, k]
            if score > most:
                # the running maximum of Milakov and Gimelshein (2018)
                less = wp.exp(most - score)
                total = total * less
                found = found * less
                most = score
            part = wp.exp(score - most)
            total += part
            found = found + part * value
        y_out[first + query, head] = found / total

    return run
