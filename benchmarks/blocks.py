"""Blocks with nets in a fixed outline, of the size of the GSRC benchmarks' n30: a generator of such problems."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.layout import ObjectiveTerm
from sceneweaver.scene import SCHEMA, Scene

HEIGHT = 0.5  # [m] of every block


@dataclass(frozen=True)
class BlockProblem:
    """Rectangular blocks, two-pin nets between their middles, and a square outline of ``side`` metres.

    ``sizes`` [N, 2] are width and height [m], ``nets`` [E, 2] are pairs of different blocks.
    """

    sizes: np.ndarray
    nets: np.ndarray
    side: float

    @property
    def terms(self) -> list[ObjectiveTerm]:
        """The nets as an objective."""
        return [ObjectiveTerm("wire_length", (f"b{i}", f"b{j}")) for i, j in self.nets]

    @property
    def scene(self) -> Scene:
        """The blocks in a room without doors, piled up in its middle."""
        middle = self.side / 2
        objects = [
            {
                "id": f"b{i}",
                "category": "block",
                "mount": "floor",
                "size": [float(w), float(h), HEIGHT],
                "pose": {"position": [middle, middle, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0]},
            }
            for i, (w, h) in enumerate(self.sizes)
        ]
        outline = [[0.0, 0.0], [self.side, 0.0], [self.side, self.side], [0.0, self.side]]
        room = {"type": "hall", "outline": outline}
        return Scene.from_json({"schema": SCHEMA, "id": "blocks", "room": room, "objects": objects})


def block_problem(seed: int, blocks: int = 30, nets: int = 45, fill: float = 0.7) -> BlockProblem:
    """Draw a problem: areas that differ by a factor of ten, aspect ratios up to two, every block in some net.

    Args:
        seed: of the draw.
        blocks: how many.
        nets: pairs of blocks, no pair twice; at least half as many as blocks.
        fill: share of the outline that the blocks cover.
    """
    rng = np.random.default_rng(seed)
    area = np.exp(rng.uniform(0.0, np.log(10.0), blocks))
    aspect = np.exp(rng.uniform(-np.log(2.0), np.log(2.0), blocks))
    sizes = np.round(0.5 * np.stack([np.sqrt(area * aspect), np.sqrt(area / aspect)], axis=-1), 3)
    order = rng.permutation(blocks)
    pairs = {tuple(sorted((int(order[i]), int(order[i - 1])))) for i in range(0, blocks, 2)}
    while len(pairs) < nets:
        i, j = rng.choice(blocks, size=2, replace=False)
        pairs.add((int(min(i, j)), int(max(i, j))))
    side = float(np.sqrt(sizes.prod(axis=1).sum() / fill))
    return BlockProblem(sizes, np.array(sorted(pairs)), side)
