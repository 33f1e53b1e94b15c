"""The prior as users know it: weights, and layouts drawn with them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.io import InputError
from sceneweaver.scene import Scene

from .network import Context, Shape, encode, velocity
from .tokens import Tokens, padded, tokens_of
from .vocabulary import Words
from .weights import load_weights

if TYPE_CHECKING:
    from .flow import DeviceFlow

SHIPPED = Path(__file__).with_name("weights.npz")
"""The weights that come with the library."""

STEPS = 4
"""Steps of the flow unless told otherwise."""

AT_ONCE = 32
"""Candidates in one pass: what a pass needs then fits into the caches of a core."""


class LayoutPrior:
    """A learned prior of layouts: where furniture of such categories and sizes stands in a room of such a shell.

    It draws layouts to start from; they are likely, not valid, and `sceneweaver.refine` makes them so. How it was
    trained, on what, and what it is good for stands in docs/prior.md.

    Attributes:
        shape: of its network.
        words: categories, kinds of rooms and relation types that it knows; of others it sees sizes and mounts.
        about: how it was trained.

    Examples:
        >>> import sceneweaver as sw
        >>> prior = sw.LayoutPrior.load()
        >>> scene = sw.Scene.example("bedroom")
        >>> poses = prior.sample(scene, candidates=4, seed=1)
        >>> poses.shape
        (4, 16, 4)
        >>> solution = sw.refine(scene, init=poses, device="cpu")
        >>> bool((solution.status == 0).any())
        True
    """

    def __init__(self, weights: Mapping[str, np.ndarray], shape: Shape, words: Words, about: Mapping[str, Any]) -> None:
        """Use `load`. ``weights`` are float32 arrays by name."""
        self.shape, self.words, self.about = shape, words, dict(about)
        self._weights = dict(weights)
        self._devices: dict[str, DeviceFlow] = {}

    def __repr__(self) -> str:
        return f"LayoutPrior({sum(w.size for w in self._weights.values()):,} weights)"

    @classmethod
    def load(cls, path: str | Path | None = None) -> LayoutPrior:
        """Read weights, those that ship with the library unless a file is named; they are kept.

        Raises:
            InputError: the file is missing, damaged, or holds something else.
        """
        return _loaded(SHIPPED if path is None else Path(path).resolve())

    def sample(
        self, scene: Scene, candidates: int = 64, seed: int = 0, steps: int = STEPS, *, device: str = "cpu"
    ) -> np.ndarray:
        """Draw layouts of a scene.

        Args:
            scene: what to lay out. Poses matter for what is fixed; heights on walls stay, and what stands on something
                goes along with it.
            candidates: how many layouts B.
            seed: equal seeds draw equal layouts; more candidates begin with the same ones.
            steps: of the flow from noise to layouts, by Euler's method.
            device: "cpu", with NumPy, or a CUDA device, with Warp kernels; they agree to rounding.

        Returns:
            World poses (x, y, z, yaw) [B, N, 4] float64, objects in the scene's order.

        Raises:
            InputError: an argument is out of range, or the scene has more than a network is asked to look at.
        """
        for name, value in (("candidates", candidates), ("steps", steps)):
            if not isinstance(value, int | np.integer) or isinstance(value, bool) or value < 1:
                raise InputError(f"{name}: {value!r} is not a whole number of at least 1")
        if not isinstance(seed, int | np.integer) or not 0 <= seed < 2**32:
            raise InputError(f"seed: {seed!r} is not a whole number from 0 to 2**32 - 1")
        tokens = tokens_of(scene, self.words)
        if not len(tokens.index):
            return placed(scene, tokens, np.zeros((candidates, 0, 4)))
        noise = np.random.default_rng(seed).standard_normal((candidates, len(tokens.index), 4)).astype(np.float32)
        return placed(scene, tokens, self.flow(tokens, noise, steps, device))

    def flow(self, tokens: Tokens, noise: np.ndarray, steps: int = STEPS, device: str = "cpu") -> np.ndarray:
        """Where the flow leads from noise [B, N, 4] in the room's frame: x, y, cosine and sine of N tokens."""
        context = self.context(tokens)
        if device != "cpu" and self.shape.slim % 64 == 0:  # whole tiles of `flow_kernels.product`
            return self._on(device).integrated(noise, context, steps)
        parts = np.array_split(noise, range(AT_ONCE, len(noise), AT_ONCE))
        move = self._velocity(context)
        return np.concatenate([integrated(move, part[None], context, steps)[0] for part in parts])

    def context(self, tokens: Tokens) -> Context:
        """What the encoder makes of a scene."""
        arrays = padded([tokens], len(tokens.walls), len(tokens.openings), len(tokens.objects)).arrays()
        return encode(self._weights, self.shape, arrays)

    def _on(self, device: str) -> DeviceFlow:
        """The network on a device, copied there once."""
        from .flow import DeviceFlow

        if device not in self._devices:
            self._devices[device] = DeviceFlow(self._weights, self.shape, device)
        return self._devices[device]

    def _velocity(self, context: Context) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
        return lambda x, time: velocity(self._weights, self.shape, context, x, time)


def integrated(
    move: Callable[[np.ndarray, np.ndarray], np.ndarray], noise: np.ndarray, context: Context, steps: int
) -> np.ndarray:
    """Poses [S, K, N, 4] at the end of the flow, by Euler's method; what is fixed stays where it is given."""
    fixed, given = np.asarray(context.fixed)[:, None], np.asarray(context.given)[:, None]
    x = np.where(fixed > 0, given, noise).astype(np.float32)
    for k in range(steps):
        time = np.full(x.shape[:2], k / steps, dtype=np.float32)
        x = np.where(fixed > 0, given, x + move(x, time) / np.float32(steps)).astype(np.float32)
    return x


def placed(scene: Scene, tokens: Tokens, local: np.ndarray) -> np.ndarray:
    """World poses [B, N, 4] of a scene's objects at what the network says [B, tokens, 4].

    Heights are those of the scene. What stands on something keeps its place there.
    """
    home = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects], dtype=np.float64).reshape(-1, 4)
    poses = np.repeat(home[None], len(local), axis=0)
    xy, yaw = tokens.world(local)
    free = np.array([not scene.objects[i].fixed for i in tokens.index], dtype=bool)
    moved = tokens.index[free]
    poses[:, moved, :2], poses[:, moved, 3] = xy[:, free], yaw[:, free]
    number = {o.id: i for i, o in enumerate(scene.objects)}
    done = set(tokens.index.tolist())
    while len(done) < len(scene.objects):
        for i, obj in enumerate(scene.objects):
            if obj.support is None or i in done or number[obj.support.object] not in done:
                continue
            done.add(i)
            if not obj.fixed:
                below = number[obj.support.object]
                poses[:, i] = absolute(relative(home[i], home[below]), poses[:, below])
    return poses


@lru_cache(maxsize=4)
def _loaded(path: Path) -> LayoutPrior:
    return LayoutPrior(*load_weights(path))
