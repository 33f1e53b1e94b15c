"""The flow on a GPU: what `model.integrated` does with NumPy, by the kernels of `flow_kernels`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.runtime import compiling
from sceneweaver.runtime.compiling import Variant

from .flow_kernels import ADD, SQUARE, STORE, THREADS, TILE, attention, embed, moved, normed, product
from .network import Context, Shape, moments

AT_ONCE = 8192
"""Candidates in one pass."""


class DeviceFlow:
    """The second half of a network on a device, to draw with again and again."""

    def __init__(self, weights: Mapping[str, np.ndarray], shape: Shape, device: str) -> None:
        """Copy weights there, and compile the kernels."""
        self._weights, self._shape, self.device = weights, shape, device
        self._there = {
            name: wp.array(np.ascontiguousarray(value), dtype=wp.float32, device=device)
            for name, value in weights.items()
            if name.startswith("d") or name in ("pose", "out", "out_bias", "out_norm")
        }
        self._attention = attention(shape.slim // shape.eyes)
        blocks = ((embed, 256), (self._attention, 256), (product, THREADS))
        compiling.load(device, [Variant(kernel.module, block) for kernel, block in blocks])

    def integrated(self, noise: np.ndarray, context: Context, steps: int) -> np.ndarray:
        """Poses [B, N, 4] at the end of the flow from noise [B, N, 4] of one scene, by Euler's method."""
        parts = np.array_split(noise, range(AT_ONCE, len(noise), AT_ONCE))
        return np.concatenate([self._part(part, context, steps) for part in parts])

    def _part(self, noise: np.ndarray, context: Context, steps: int) -> np.ndarray:
        count, objects = noise.shape[:2]
        shape, rows, device = self._shape, count * objects, self.device
        fixed = context.fixed[0, :, 0]
        start = np.where(fixed[:, None] > 0, context.given[0], noise).astype(np.float32).reshape(rows, 4)
        x = self._array(start)
        given = self._array(fixed)
        begin = self._array(context.begin[0])
        seen = [self._layer(context, k) for k in range(shape.steps)]
        h, y, joined = (wp.zeros((rows, shape.slim), dtype=wp.float32, device=device) for _ in range(3))
        heads = wp.zeros((rows, 3 * shape.slim), dtype=wp.float32, device=device)
        wide = wp.zeros((rows, 2 * shape.slim), dtype=wp.float32, device=device)
        time = np.arange(steps, dtype=np.float32) / np.float32(steps)
        moment, mixed = moments(self._weights, shape, time)
        moment_there, mixed_there = self._array(moment), self._array(mixed.reshape(steps, shape.steps, 2, shape.slim))
        still = wp.zeros((2, shape.slim), dtype=wp.float32, device=device)
        w = self._there
        for step in range(steps):
            self._launch(embed, (rows, shape.slim), [begin, w["pose"], moment_there[step], x], [h])
            for k in range(shape.steps):
                self._launch(normed, rows, [w[f"d{k}.norm"], mixed_there[step, k], h], [y])
                self._product(w[f"d{k}.qkv"], STORE, y, heads)
                self._attend(seen[k], heads, joined, (count, shape.eyes, objects))
                self._product(w[f"d{k}.join"], ADD, joined, h)
                self._launch(normed, rows, [w[f"d{k}.norm2"], still, h], [y])
                self._product(w[f"d{k}.up"], SQUARE, y, wide)
                self._product(w[f"d{k}.down"], ADD, wide, h)
            self._launch(normed, rows, [w["out_norm"], still, h], [y])
            self._launch(moved, (rows, 4), [w["out"], w["out_bias"], given, 1.0 / steps, y], [x])
        return x.numpy().reshape(count, objects, 4)

    def _layer(self, context: Context, k: int) -> tuple[wp.array, wp.array, wp.array]:
        """Keys and values [H, T] of a scene's tokens, and biases of attention [H, N, T + N]."""
        vec = self._attention_type()
        keys, values = (
            wp.array(np.ascontiguousarray(a[k][0], dtype=np.float32), dtype=vec, device=self.device)
            for a in (context.keys, context.values)
        )
        return keys, values, self._array(context.bias[k][0])

    def _attend(
        self, seen: tuple[wp.array, wp.array, wp.array], heads: wp.array, out: wp.array, size: tuple[int, int, int]
    ) -> None:
        keys, values, bias = seen
        width = self._shape.slim // self._shape.eyes
        self._launch(
            self._attention, size, [keys, values, bias, width**-0.5, self._vectors(heads)], [self._vectors(out)]
        )

    def _product(self, weight: wp.array, after: int, rows: wp.array, out: wp.array) -> None:
        size = (-(-rows.shape[0] // TILE), weight.shape[1] // TILE)
        wp.launch_tiled(
            product, dim=size, inputs=[weight, after, rows], outputs=[out], device=self.device, block_dim=THREADS
        )

    def _launch(self, kernel: Any, size: Any, inputs: list[Any], outputs: list[Any]) -> None:
        wp.launch(kernel, size, inputs, outputs, device=self.device)

    def _attention_type(self) -> Any:
        return wp.types.vector(length=self._shape.slim // self._shape.eyes, dtype=wp.float32)

    def _vectors(self, rows: wp.array) -> wp.array:
        """Rows [R, H * C] of numbers as vectors [R, H] in the same memory."""
        vec, width = self._attention_type(), self._shape.slim // self._shape.eyes
        return wp.array(ptr=rows.ptr, dtype=vec, shape=(rows.shape[0], rows.shape[1] // width), device=self.device)

    def _array(self, values: np.ndarray) -> wp.array:
        return wp.array(np.ascontiguousarray(values, dtype=np.float32), dtype=wp.float32, device=self.device)
