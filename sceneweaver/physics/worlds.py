"""One MuJoCo model, many worlds: initial poses that differ, what became of them, and MuJoCo C stepping them.

Only poses differ between the worlds of a template: free bodies start elsewhere, and so may fixtures stand. Poses are
[B, N, 7]: x, y, z and the quaternion x, y, z, w of N objects in B worlds, as in a scene.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import transform
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.runtime.threads import map_threads
from sceneweaver.scene import InputError, Scene

from .model import STEP, Model

CHUNK = 50
"""Steps between two looks at how many contacts there are."""


@dataclass(frozen=True)
class Template:
    """What all worlds share.

    Attributes:
        model: the MjModel.
        free, fixed: ids of the bodies that may move and that may not; their order is that of ``poses``: free first.
        middle: [N] half the height of each object [m]: a shift is that of the middle of the box.
    """

    model: Any
    free: tuple[str, ...]
    fixed: tuple[str, ...]
    middle: np.ndarray

    @classmethod
    def of(cls, model: Model, scene: Scene) -> Template:
        """Compile the model of a scene."""
        mujoco = load_mujoco()
        middle = [scene.object(name).size[2] / 2 for name in (*model.free, *model.fixed)]
        compiled = mujoco.MjModel.from_xml_string(model.xml, model.files)
        return cls(compiled, model.free, model.fixed, np.asarray(middle, dtype=float))

    @property
    def address(self) -> np.ndarray:
        """[F] where the seven numbers of each free body begin in ``qpos``."""
        return np.array([int(self.model.joint(object_id).qposadr[0]) for object_id in self.free], dtype=int)

    @property
    def fixtures(self) -> np.ndarray:
        """Numbers of the bodies that do not move [N - F]."""
        return np.array([int(self.model.body(object_id).id) for object_id in self.fixed], dtype=int)

    def qpos(self, poses: np.ndarray) -> np.ndarray:
        """[B, nq] initial positions: joints of doors and drawers closed, free bodies where ``poses`` has them."""
        q = np.tile(self.model.qpos0, (len(poses), 1))
        for k, at in enumerate(self.address):
            q[:, at : at + 3] = poses[:, k, :3]
            q[:, at + 3 : at + 7] = poses[:, k, [6, 3, 4, 5]]
        return q

    def placed(self, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
        """Positions [B, nbody, 3] and wxyz quaternions [B, nbody, 4] of all bodies in their parents.

        None when no fixture stands elsewhere than in the model.
        """
        at, mine = self.fixtures, poses[:, len(self.free) :]
        where, turn = np.asarray(self.model.body_pos), np.asarray(self.model.body_quat)
        turned = mine[..., [6, 3, 4, 5]]
        same = np.allclose(mine[..., :3], where[at], atol=1e-9) and np.allclose(turned, turn[at], atol=1e-9)
        if same:
            return None
        positions, turns = np.tile(where, (len(poses), 1, 1)), np.tile(turn, (len(poses), 1, 1))
        positions[:, at], turns[:, at] = mine[..., :3], turned
        return positions, turns

    def read(self, qpos: np.ndarray, start: np.ndarray) -> np.ndarray:
        """Poses [B, N, 7] from positions [B, nq]; fixtures as in ``start``."""
        poses = np.array(start, dtype=float)
        for k, at in enumerate(self.address):
            poses[:, k, :3] = qpos[:, at : at + 3]
            poses[:, k, 3:] = qpos[:, [at + 4, at + 5, at + 6, at + 3]]
        return poses


@dataclass(frozen=True)
class SimulationResult:
    """What became of the worlds.

    Attributes:
        poses: [B, N, 7] at the end, free bodies first.
        overflow: [B] there was no room for all contacts or constraints: nothing can be said of that world.
        diverged: [B] numbers that are not finite, or too large for the simulator.
        contacts: the most contacts of a world at once (MuJoCo C, looked at now and then), or their mean over all
            worlds where they were most (MuJoCo Warp).
        constraints: the most constraint rows of a world.
        seconds: time of stepping, with the copies to and from the device.
        grown: how often there was too little room and the run began again with more.
        room: what there was room for: contacts of all worlds, rows of a world.
        problem: what to say of an overflow.
    """

    poses: np.ndarray
    overflow: np.ndarray
    diverged: np.ndarray
    contacts: float
    constraints: int
    seconds: float
    grown: int = 0
    room: dict[str, int] = field(default_factory=dict)
    problem: str | None = None


def merged(parts: Sequence[SimulationResult]) -> SimulationResult:
    """One outcome of worlds that were stepped one part after the other."""
    if len(parts) == 1:
        return parts[0]

    problems = [p.problem for p in parts if p.problem]
    return SimulationResult(
        np.concatenate([p.poses for p in parts]),
        np.concatenate([p.overflow for p in parts]),
        np.concatenate([p.diverged for p in parts]),
        max(p.contacts for p in parts),
        max(p.constraints for p in parts),
        sum(p.seconds for p in parts),
        sum(p.grown for p in parts),
        parts[-1].room,
        problems[0] if problems else None,
    )


def steps_of(seconds: float) -> int:
    """Steps of a time [s].

    Raises:
        InputError: no time.
    """
    if not 0 <= seconds < 1e4:
        raise InputError(f"seconds: {seconds} is no time; give 0 or more")
    return round(seconds / STEP)


def shifts(template: Template, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """[B, F] how far [m] the middle of each free body's box went."""
    count = len(template.free)
    up = np.zeros((count, 3))
    up[:, 2] = template.middle[:count]
    return np.linalg.norm(transform(end[:, :count], up) - transform(start[:, :count], up), axis=-1)


def run_c(template: Template, start: np.ndarray, steps: int, threads: int = 1) -> SimulationResult:
    """Step the worlds by MuJoCo C, on so many threads (which all are this process's)."""
    began = time.perf_counter()
    qpos, placed = template.qpos(start), template.placed(start)
    parts = [part for part in np.array_split(np.arange(len(start)), max(1, threads)) if len(part)]

    def run(part: np.ndarray) -> list[tuple[np.ndarray, Stepped]]:
        return _some(template.model, part, qpos, placed, steps)

    found = [row for rows in map_threads(run, parts, len(parts)) for row in rows]
    end = np.array([row[0] for row in found]).reshape(len(start), -1)
    runs = [row[1] for row in found]
    full = np.array([went.full for went in runs], dtype=bool)
    problem = None
    if full.any():
        problem = (
            f"objects: more contacts than MuJoCo has room for in {int(full.sum())} of {len(start)} worlds, nothing can "
            "be said of those; use fewer objects"
        )
    return SimulationResult(
        poses=template.read(end, start),
        overflow=full,
        diverged=np.array([went.astray is not None for went in runs], dtype=bool),
        contacts=float(max((went.contacts for went in runs), default=0)),
        constraints=max((went.rows for went in runs), default=0),
        seconds=time.perf_counter() - began,
        problem=problem,
    )


@dataclass(frozen=True)
class Stepped:
    """What became of one simulation: whether there was no room for all contacts, at which degree of freedom it went
    ``astray`` (-1: MuJoCo does not say; None: it did not), and the most contacts and constraint rows at once."""

    full: bool
    astray: int | None
    contacts: int
    rows: int


def stepped(model: Any, data: Any, steps: int) -> Stepped:
    """Step a simulation by MuJoCo C, looking now and then whether all is well; it ends early where that is not so."""
    mujoco = load_mujoco()
    kinds = mujoco.mjtWarning
    full, astray, contacts, rows = False, None, 0, 0
    for done in range(0, steps, CHUNK):
        checkpoint()
        try:
            mujoco.mj_step(model, data, min(CHUNK, steps - done))
        except mujoco.FatalError:  # not even room to look for contacts
            full = True
        contacts, rows = max(contacts, int(data.ncon)), max(rows, int(data.nefc))
        full |= any(data.warning[int(kind)].number for kind in (kinds.mjWARN_CONTACTFULL, kinds.mjWARN_CNSTRFULL))
        # MuJoCo begins anew where numbers get too large, and things would seem to be where they were.
        bad = [
            k for k in (kinds.mjWARN_BADQPOS, kinds.mjWARN_BADQVEL, kinds.mjWARN_BADQACC) if data.warning[int(k)].number
        ]
        if bad or not np.isfinite(data.qpos).all():
            astray = -1 if bad[:1] in ([], [kinds.mjWARN_BADQPOS]) else int(data.warning[int(bad[0])].lastinfo)
        if full or astray is not None:
            break
    return Stepped(full, astray, contacts, rows)


def _some(
    model: Any, worlds: np.ndarray, qpos: np.ndarray, placed: tuple[np.ndarray, np.ndarray] | None, steps: int
) -> list[tuple[np.ndarray, Stepped]]:
    """The positions [nq] of some worlds at the end, and how it went, one after the other."""
    mujoco = load_mujoco()
    model = copy(model) if placed is not None else model
    data, found = mujoco.MjData(model), []
    for k in worlds:
        if placed is not None:
            model.body_pos[:], model.body_quat[:] = placed[0][k], placed[1][k]
        mujoco.mj_resetData(model, data)
        data.qpos[:] = qpos[k]
        went = stepped(model, data, steps)
        found.append((np.array(data.qpos), went))
    return found
