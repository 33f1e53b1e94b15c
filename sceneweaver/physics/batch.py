"""Settle and stability of many layouts at once.

The candidates of one scene are worlds of one launch: one model, other initial poses. With a GPU they are stepped by
MuJoCo Warp, else by MuJoCo C on the cores of this machine (MuJoCo Warp compiles for long on a CPU, and is slower
there). Scenes of other objects need other models: ``settle_scenes`` groups equal ones and takes group after group.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Literal

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.runtime.compiling import has_driver, start_warp
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import InputError, MissingDependencyError, Pose, Scene

from .boxes import boxed
from .model import Model, build
from .settle import LITTLE, Settled, measures, pose_of, settled
from .worlds import SimulationResult, Template, run_c, shifts, steps_of

Shapes = Literal["hull", "box"]
Backend = Literal["c", "warp"]
Candidates = np.ndarray | Sequence[Scene] | None


@dataclass(frozen=True)
class Many:
    """Many layouts of one scene after some seconds of physics.

    Attributes:
        source: The scene.
        free: Ids of the F objects that may move; fixed: of those that may not.
        start, poses: [B, N, 7] before and after: x, y, z and the quaternion x, y, z, w; objects in the scene's order.
        shift: [B, F] how far the middle of each free object's box went [m]; NaN where nothing can be said.
        overflow: [B] there was no room for all contacts; diverged: [B] the simulation went astray.
        backend: "c" or "warp"; device: "cpu", "cuda:0" ...
        outcome: Numbers of the run: contacts, seconds, room.
    """

    source: Scene
    free: tuple[str, ...]
    fixed: tuple[str, ...]
    start: np.ndarray
    poses: np.ndarray
    shift: np.ndarray
    overflow: np.ndarray
    diverged: np.ndarray
    backend: Backend
    device: str
    outcome: SimulationResult

    @property
    def moved(self) -> np.ndarray:
        """[B, F] what went farther than ``LITTLE``, and all of a world of which nothing can be said."""
        return ~(self.shift <= LITTLE)

    @property
    def problem(self) -> str | None:
        """What to say of worlds that had no room for all contacts; None when all had."""
        return self.outcome.problem

    def settled(self, world: int) -> Settled:
        """As ``settle`` returns for one scene.

        Raises:
            InputError: when nothing can be said of that world.
        """
        if self.overflow[world] or self.diverged[world]:
            raise InputError(self.problem if self.overflow[world] and self.problem else _DIVERGED)
        ids = self.source.ids
        begun = self.source.replace_poses(dict(zip(ids, map(pose_of, self.start[world]), strict=True)))
        shift = dict(zip(self.free, self.shift[world].tolist(), strict=True))
        rows = dict(zip(ids, self.poses[world], strict=True))
        return settled(begun, {name: pose_of(rows[name]) for name, far in shift.items() if far <= LITTLE}, shift)


_DIVERGED = "objects: the simulation went astray; are there objects inside each other?"


def settle_many(
    scene: Scene,
    candidates: Candidates = None,
    load: Load | None = None,
    seconds: float = 3.0,
    *,
    shapes: Shapes = "hull",
    device: str = "auto",
    backend: Backend | None = None,
    threads: int | None = None,
) -> Many:
    """Let many layouts of one scene come to rest, as worlds of one launch.

    Args:
        scene: The scene.
        candidates: Poses [B, N, 4] (x, y, z, yaw of the scene's objects, as ``refine`` returns them; objects that the
            scene calls fixed keep their poses), or scenes that differ from it in poses only. None: the scene itself.
        load: From asset id to asset; None: the library of this user.
        seconds: How long.
        shapes: "hull": convex parts, as ``settle`` has them; "box": boxes of their volume (see ``boxed``).
        device: "auto" (the first GPU, else the CPU), "cpu", "cuda" or "cuda:1" ...
        backend: "warp" or "c"; None: MuJoCo Warp on a GPU, MuJoCo C on a CPU.
        threads: Of MuJoCo C; None: as many as there are cores.

    Raises:
        InputError: poses of the wrong shape, or scenes of other objects. Worlds with too little room for contacts are
        no error: see ``overflow`` and ``problem``.
    """
    if shapes not in ("hull", "box"):
        raise InputError(f'shapes: "{shapes}" is not one of hull, box')
    steps = steps_of(seconds)
    poses = poses_of(scene, candidates)
    model = model_of(scene, load, shapes)
    template = Template.of(model, scene)
    at = np.array([scene.index(name) for name in (*model.free, *model.fixed)], dtype=int)
    outcome, kind, device = run(template, poses[:, at], steps, device, backend, threads)
    end = np.empty_like(poses)
    end[:, at] = outcome.poses
    shift = shifts(template, poses[:, at], outcome.poses)
    shift[outcome.overflow | outcome.diverged] = math.nan
    return Many(
        scene, model.free, model.fixed, poses, end, shift, outcome.overflow, outcome.diverged, kind, device, outcome
    )


def stability_many(
    scene: Scene, candidates: Candidates = None, load: Load | None = None, **options: Any
) -> list[dict[str, Any] | None]:
    """How far free objects move in each of many layouts; options as of ``settle_many``.

    Returns:
        A list of what ``stability`` returns, one a world; None for a world of which nothing can be said.
    """
    many = settle_many(scene, candidates, load, **options)
    counts = {"free": len(many.free), "fixed": len(many.fixed)}
    return [
        None
        if many.overflow[k] or many.diverged[k]
        else measures(dict(zip(many.free, row.tolist(), strict=True))) | counts
        for k, row in enumerate(many.shift)
    ]


def settle_scenes(scenes: Sequence[Scene], load: Load | None = None, **options: Any) -> list[Settled | None]:
    """Settle scenes of any kind; options as of ``settle_many``.

    Scenes that differ in poses only are worlds of one launch; each other kind is a launch of its own.

    Returns:
        One for each scene, in their order; None where nothing can be said: no room for its contacts, or gone astray.
    """
    groups: dict[str, list[int]] = {}
    for k, scene in enumerate(scenes):
        groups.setdefault(_kind(scene), []).append(k)
    found: list[Settled | None] = [None] * len(scenes)
    for members in groups.values():
        many = settle_many(scenes[members[0]], [scenes[k] for k in members], load, **options)
        for world, k in enumerate(members):
            if not (many.overflow[world] or many.diverged[world]):
                result = many.settled(world)
                little = {o.id: o.pose for o in result.scene.objects}
                found[k] = Settled(scenes[k].replace_poses(little), result.moved, result.faults)
    return found


def run(
    template: Template, start: np.ndarray, steps: int, device: str, backend: Backend | None, threads: int | None
) -> tuple[SimulationResult, Backend, str]:
    """Step the worlds where they are to be stepped: (outcome, backend, device)."""
    device = device_named(device)
    kind: Backend = backend or ("c" if device == "cpu" else "warp")
    if kind not in ("c", "warp"):
        raise InputError(f'backend: "{kind}" is not one of c, warp')
    if kind == "c" and device != "cpu":
        raise InputError(f'backend: "c" has no {device}; say device="cpu"')
    if not template.free:
        none = np.zeros(len(start), dtype=bool)
        return SimulationResult(start.copy(), none, none.copy(), 0.0, 0, 0.0), kind, device
    if kind == "c":
        return run_c(template, start, steps, min(threads or cores(), len(start))), kind, device
    from .worlds_warp import run_warp

    return run_warp(template, start, steps, device), kind, device


def model_of(scene: Scene, load: Load | None = None, shapes: Shapes = "hull") -> Model:
    """The model that all layouts of a scene share."""
    whole = build(scene, load, loose=False)
    return boxed(whole) if shapes == "box" else whole


def poses_of(scene: Scene, candidates: Candidates = None) -> np.ndarray:
    """Candidates as poses [B, N, 7]: x, y, z and the quaternion x, y, z, w.

    Raises:
        InputError: as ``settle_many``.
    """
    own = np.array([(*o.pose.position, *o.pose.quaternion) for o in scene.objects], dtype=float).reshape(-1, 7)
    if candidates is None:
        return own[None]
    if isinstance(candidates, np.ndarray):
        return _poses(scene, own, candidates)
    found, kind = [], _kind(scene)
    for k, other in enumerate(candidates):
        if not isinstance(other, Scene) or _kind(other) != kind:
            raise InputError(f"candidates[{k}]: differs from the scene in more than poses; use settle_scenes")
        found.append([(*o.pose.position, *o.pose.quaternion) for o in other.objects])
    if not found:
        raise InputError("candidates: there are none; give at least one")
    return np.array(found, dtype=float).reshape(len(found), -1, 7)


def _poses(scene: Scene, own: np.ndarray, given: np.ndarray) -> np.ndarray:
    count = len(scene.objects)
    if given.ndim != 3 or given.shape[1:] != (count, 4) or not len(given):
        raise InputError(f"candidates: shape {given.shape}; give [B, {count}, 4] of x, y, z and yaw")
    if not np.isfinite(given).all():
        raise InputError("candidates: some numbers are not finite; leave those candidates out")
    given = given.astype(float)
    poses = np.zeros((len(given), count, 7))
    poses[..., :3] = given[..., :3]
    poses[..., 5], poses[..., 6] = np.sin(given[..., 3] / 2), np.cos(given[..., 3] / 2)
    still = np.array([o.fixed for o in scene.objects], dtype=bool)
    poses[:, still] = own[still]
    return poses


def _kind(scene: Scene) -> str:
    """Equal for scenes whose models differ in poses only."""
    objects = [
        o.model_copy(update={"pose": Pose(), "support": None}).model_dump(
            mode="json", exclude={"attributes", "intent", "description", "zones", "surfaces"}
        )
        for o in scene.objects
    ]
    return json.dumps([scene.room.model_dump(mode="json"), objects], sort_keys=True)


def device_named(name: str) -> str:
    """The Warp device of a name; "auto" is the first GPU, else the CPU.

    Raises:
        InputError: not a name of one.
        MissingDependencyError: it is not there.
    """
    if name == "cpu":
        return name
    kind, _, index = name.partition(":")
    if name != "auto" and (kind != "cuda" or not (index.isdigit() or name == "cuda")):
        raise InputError(f'device: "{name}" is not one of auto, cpu, cuda, cuda:0, cuda:1 ...')
    if name == "auto" and not has_driver():
        return "cpu"
    start_warp()
    wp: Any = import_module("warp")
    if name == "auto":
        return "cuda:0" if wp.is_cuda_available() else "cpu"
    if int(index or 0) >= wp.get_cuda_device_count():
        raise MissingDependencyError(f'device: "{name}" is not there; use device="cpu"')
    return f"cuda:{int(index or 0)}"
