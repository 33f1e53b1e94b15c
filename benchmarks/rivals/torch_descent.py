"""The engine's own objective in batched PyTorch: Adam with a cosine rate and noise that is annealed away.

One run for each start: noise takes the place of restarts. Collisions weigh little at first, so that objects get past
each other. A step is compiled into a few kernels, on a GPU recorded as a CUDA graph as well; `prepare` does that, so
that it is not in what is timed. On a CPU the kernels are short and end in a barrier: where other programs keep the
cores busy, it is many times slower with several threads than with one (``OMP_NUM_THREADS=1``).
"""

from __future__ import annotations

import math
import os
import shutil
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.rivals.base import Rival, register
from benchmarks.rivals.torch_support import missing, on_cuda, pick
from benchmarks.starts import carry, movable
from sceneweaver.scene import Scene

if TYPE_CHECKING:
    from torch import Tensor

    from benchmarks.rivals.torch_objective import Objective

STEPS = 400
RATE = (0.1, 0.0003)  # of Adam, at the first and the last step
NOISE, QUIET = 0.05, 0.7  # [m, rad] of the first step; the share of steps after which there is none
SPACE = (1.0, 300.0)  # weight of collisions, bounds and clear space against relations, first and last
LOUD = 0.85  # share of steps over which that weight grows
BETA = (0.9, 0.99)
COMPILED = 256  # candidates from which on the step is compiled on a CPU as well; it takes up to a minute for a scene
WARM = 3  # steps before one is recorded
LOOK, SLACK = 4, 1.2  # steps between looks at who is near; [m] that two may close in on each other meanwhile

State = tuple["Tensor", ...]
"""Poses, mean and mean square of gradients, best poses [3, n, B], and their losses [B]."""


def schedule() -> np.ndarray:
    """Rate, noise, corrections of both means' bias and weight of space; a row a step and one to look at the end."""
    k = np.arange(STEPS + 1)
    rate = RATE[1] + (RATE[0] - RATE[1]) * (1 + np.cos(math.pi * k / STEPS)) / 2
    noise = NOISE * (1 + np.cos(math.pi * np.minimum(k / (QUIET * STEPS), 1.0))) / 2
    weight = SPACE[0] * (SPACE[1] / SPACE[0]) ** np.minimum(k / (LOUD * STEPS), 1.0)
    return np.stack([rate, noise, 1 / (1 - BETA[0] ** (k + 1)), 1 / (1 - BETA[1] ** (k + 1)), weight], axis=1)


def advance(objective: Objective, state: State, noise: Tensor, now: Tensor) -> State:
    """One step of all candidates. ``noise`` is N(0, 1) [3, n, B], ``now`` a row of `schedule`."""
    import torch

    x, mean, square, best, best_loss = state

    def total(x: Tensor) -> tuple[Tensor, Tensor]:
        space, relations = objective(x)
        return (now[4] * space + relations).sum(), SPACE[1] * space + relations

    gradient, (_, loss) = torch.func.grad_and_value(total, has_aux=True)(x)
    better = loss < best_loss
    best, best_loss = torch.where(better, x, best), torch.where(better, loss, best_loss)
    mean = BETA[0] * mean + (1 - BETA[0]) * gradient
    square = BETA[1] * square + (1 - BETA[1]) * gradient * gradient
    step = now[0] * (mean * now[2]) / ((square * now[3]).sqrt() + 1e-8)
    return x - step + now[1] * noise, mean, square, best, best_loss


class Descent:
    """Buffers and, on a GPU, the recorded step for one scene and one number of candidates."""

    def __init__(self, scene: Scene, candidates: int, device: str) -> None:
        import torch

        from benchmarks.rivals.torch_objective import Objective

        self.objective = Objective(scene, device)
        self.floor = movable(scene)
        like = {"device": device, "dtype": torch.float32}
        shape = (3, len(self.floor), candidates)
        self.state: State = (*(torch.zeros(shape, **like) for _ in range(4)), torch.zeros(candidates, **like))
        self.noise = torch.zeros(shape, **like)
        self.schedule = torch.as_tensor(schedule(), **like)
        self.now = self.schedule[0].clone()
        self.random = torch.Generator(device)
        self.eager = not (device.startswith("cuda") or (candidates >= COMPILED and has_compiler()))
        self.advance = advance if self.eager else _compiled()
        if not self.eager:
            self._step()
        self.step = self._recorded(device) if device.startswith("cuda") else self._step

    def run(self, start: Tensor, seed: int) -> Tensor:
        """The best poses passed on the way from a start, [3, n, B] both."""
        self.random.manual_seed(seed)
        x, mean, square, best, best_loss = self.state
        for buffer, value in ((x, start), (best, start), (mean, 0.0), (square, 0.0), (best_loss, math.inf)):
            buffer.copy_(value) if value is start else buffer.fill_(value)
        for k in range(STEPS + 1):
            if self.eager and k % LOOK == 0:
                self.objective.look(x, SLACK)
            self.noise.normal_(generator=self.random)
            self.now.copy_(self.schedule[k])
            self.step()
        return best

    def _step(self) -> None:
        found = self.advance(self.objective, self.state, self.noise, self.now)
        for buffer, value in zip(self.state, found, strict=True):
            buffer.copy_(value)

    def _recorded(self, device: str) -> Callable[[], None]:
        """The step as a CUDA graph, which is replayed without Python."""
        import torch

        with torch.cuda.device(device):
            aside = torch.cuda.Stream()  # a capture wants its warm-up on another stream than the usual one
            aside.wait_stream(torch.cuda.current_stream())
            with torch.cuda.stream(aside):
                for _ in range(WARM):
                    self._step()
            torch.cuda.current_stream().wait_stream(aside)
            graph = torch.cuda.CUDAGraph()
            with torch.cuda.graph(graph):
                self._step()
        return graph.replay


def has_compiler() -> bool:
    """Whether there is the C++ compiler that torch.compile needs on a processor."""
    return shutil.which(os.environ.get("CXX", "g++")) is not None


def _compiled() -> Callable[..., State]:
    """`advance` compiled for one scene. Others are forgotten, lest there are too many for Torch to go on compiling."""
    import torch

    torch._dynamo.reset()
    return torch.compile(advance, fullgraph=True, dynamic=False)


_ready: dict[tuple[str, int, str], Descent] = {}
"""The last one that was prepared."""


def _descent(scene: Scene, candidates: int, device: str) -> Descent:
    key = (scene.dumps(), candidates, pick(device))
    if key not in _ready:
        _ready.clear()
        _ready[key] = Descent(scene, candidates, key[2])
    return _ready[key]


def prepare(scene: Scene, starts: np.ndarray, device: str) -> None:
    """Compile and record what `solve` runs for such a scene and so many starts."""
    if len(movable(scene)):
        _descent(scene, len(starts), device)


def solve(scene: Scene, starts: np.ndarray, seed: int, device: str) -> np.ndarray:
    """Descend from the starts."""
    from benchmarks.rivals.torch_objective import batch

    if not len(movable(scene)):
        return carry(scene, starts.astype(np.float64))
    descent = _descent(scene, len(starts), device)
    found = descent.run(batch(starts, descent.floor, pick(device)), seed)
    poses = starts.astype(np.float64)
    poses[np.ix_(range(len(poses)), descent.floor, (0, 1, 3))] = found.cpu().numpy().transpose(2, 1, 0)
    return carry(scene, poses)


def _most(objects: int, device: str) -> int:
    if on_cuda(device):
        return 8192 if objects <= 19 else 2048 if objects <= 30 else 256 if objects <= 70 else 32
    return 1024 if objects <= 19 else 128 if objects <= 30 else 16 if objects <= 70 else 4


register(
    Rival(
        name="torch descent",
        about="the same objective on the same prisms in batched PyTorch (Adam, 400 steps, cosine rate, annealed noise, "
        "compiled); one run for each start.",
        solve=solve,
        prepare=prepare,
        missing=missing,
        most=_most,
    )
)
