"""One scene to solve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .compile import CompiledScene


@dataclass
class Job:
    """One scene to solve: world poses [B, N, 4] to begin with, how to begin ("given": from those), the seed.

    ``first`` is the number of the first candidate, when others solve those before it. ``into`` [B, N, 4] float32 is
    where the layouts go (None: new memory), ``pools`` what its surfaces are laid out from (None: not solved yet).
    """

    compiled: CompiledScene
    world: np.ndarray
    start: str
    seed: int
    keep: bool = False  # prefer the layout that moves least
    walk: bool = True  # measure the walkable floor of the best few
    first: int = 0
    into: np.ndarray | None = None
    pools: list[np.ndarray] | None = None
    only: np.ndarray | None = None  # numbers of the candidates [B], where they do not follow one another

    @property
    def numbers(self) -> np.ndarray:
        """Numbers [B] of the candidates, which their random streams follow from."""
        return self.first + np.arange(len(self.world)) if self.only is None else self.only
