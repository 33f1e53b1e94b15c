"""Many worlds of one model as one launch of MuJoCo Warp."""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

import time
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.geometry.rotations import matrix, xyzw
from sceneweaver.runtime.compiling import start_warp
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import InputError

from .worlds import CHUNK, SimulationResult, Template, merged

LAUNCH = 2048
"""Worlds of one launch at most: a bedroom of 1,024 worlds needs about 10 GB while it looks for contacts."""

GROWTHS = 4
"""How often a run begins again with more room; each time at least twice as much."""

_HUGE = 1e10  # as of MuJoCo: numbers beyond it are no state
_TRIED = 16  # worlds whose contacts are counted to find out how much room is needed
# By the sizes of a model: contacts a world and rows that were enough.
_known: dict[tuple[int, ...], tuple[float, int]] = {}


@wp.kernel(enable_backward=False)
def _most(
    nacon: wp.array(dtype=int), ncollision: wp.array(dtype=int), nefc: wp.array(dtype=int), most: wp.array(dtype=int)
):
    """The most so far: contacts of all worlds, pairs of all worlds, rows of a world."""
    k = wp.tid()
    wp.atomic_max(most, 2, nefc[k])
    if k == 0:
        most[0] = wp.max(most[0], nacon[0])
        most[1] = wp.max(most[1], ncollision[0])


@dataclass(frozen=True)
class Room:
    """What there is room for: contacts (and pairs of parts that are near) and pairs of hulls that touch, of all worlds;
    constraint rows of a world."""

    contacts: int
    touching: int
    rows: int

    def more(self, most: np.ndarray, full: int) -> Room:
        """Twice as much of what was short by these flags, and a quarter more than was seen to be needed."""
        kinds, contacts, touching, rows = _kinds(), self.contacts, self.touching, self.rows
        if full & kinds["contacts"]:
            contacts = max(2 * contacts, int(1.25 * max(most[0], most[1])))
        if full & kinds["touching"]:
            touching = 2 * touching
        if full & kinds["rows"]:
            rows = max(2 * rows, int(1.25 * most[2]))
        return Room(max(contacts, touching), touching, rows)


def run_warp(template: Template, start: np.ndarray, steps: int, device: str) -> SimulationResult:
    """Step worlds, at most ``LAUNCH`` at once; arguments as of ``launch``.

    Raises:
        InputError: the device has too little memory.
    """
    cuts = range(LAUNCH, len(start), LAUNCH)
    try:
        return merged([launch(template, part, steps, device) for part in np.split(start, list(cuts))])
    except RuntimeError as error:
        if "alloc" not in str(error).lower():
            raise
        raise InputError(
            f"candidates: {device} has too little memory for {min(len(start), LAUNCH)} worlds of {len(template.free)} "
            "free objects at once; use fewer candidates"
        ) from None


def launch(
    template: Template, start: np.ndarray, steps: int, device: str, room: Room | None = None
) -> SimulationResult:
    """Step all worlds at once.

    On a GPU one step is captured as a graph, which is launched again and again; every ``CHUNK`` steps it is looked at
    whether there was room for all contacts, and if not, the run begins again with more.

    Args:
        template: What the worlds share.
        start: [B, N, 7] initial poses.
        steps: How many steps.
        device: A Warp device.
        room: What there is room for at first; None: found out by a trial.
    """
    start_warp()
    mjw: Any = import_module("mujoco_warp")
    worlds, placed = len(start), template.placed(start)
    qpos = template.qpos(start)
    with wp.ScopedDevice(device):
        batched = None if placed is None else {"body_pos": worlds, "body_quat": worlds}
        model = mjw.put_model(template.model, batch_sizes=batched)
        model.opt.warn_overflow = 0  # it would print; we report
        if placed is not None:
            model.body_pos.assign(placed[0].astype(np.float32))
            model.body_quat.assign(placed[1].astype(np.float32))
        room = room or _trial(template, start, placed)
        kinds = _kinds()
        short = kinds["contacts"] | kinds["touching"] | kinds["rows"]
        began, grown = time.perf_counter(), 0
        while True:
            last = grown == GROWTHS  # it goes on to the end, for the worlds that have room enough
            data, most, full = _attempt(mjw, model, template, qpos, placed, steps, room, last)
            peak = most.numpy()
            if last or not full & short:
                break
            room, grown, data = room.more(peak, full), grown + 1, None
        end = data.qpos.numpy().astype(float)
        bits = data.overflow.numpy()
        seconds = time.perf_counter() - began
    overflow = (bits & short) != 0
    if not overflow.any():
        _remember(template, worlds, peak)
    problem = _problem(overflow, room, peak) if overflow.any() else None
    rest = np.abs(np.concatenate([end, data.qvel.numpy()], axis=1))
    return SimulationResult(
        poses=template.read(end, start),
        overflow=overflow,
        diverged=np.logical_not((rest < _HUGE).all(axis=1)),
        contacts=float(peak[0]) / worlds,
        constraints=int(peak[2]),
        seconds=seconds,
        grown=grown,
        room={"contacts": room.contacts, "touching": room.touching, "rows": room.rows}
        | {"contacts_most": int(peak[0]), "near_most": int(peak[1])},
        problem=problem,
    )


def _attempt(
    mjw: Any, model: Any, template: Template, qpos: np.ndarray, placed: Any, steps: int, room: Room, last: bool
) -> tuple[Any, Any, int]:
    """(data, most, bits of what overflowed): stops early when there is too little room, if it is not the last."""
    worlds = len(qpos)
    data = mjw.make_data(template.model, nworld=worlds, naconmax=room.contacts, naccdmax=room.touching, njmax=room.rows)
    data.qpos.assign(qpos.astype(np.float32))
    if placed is not None:
        _place(template, data, placed)
    most = wp.zeros(3, dtype=int)

    def step() -> None:
        mjw.step(model, data)
        wp.launch(_most, dim=worlds, inputs=[data.nacon, data.ncollision, data.nefc, most])

    kinds, graph, done, full = _kinds(), None, 0, 0
    short = kinds["contacts"] | kinds["touching"] | kinds["rows"]
    if steps and wp.get_device().is_cuda:
        step()  # compiles what has to be compiled, which cannot be done in a capture
        done = 1
        with wp.ScopedCapture() as capture:
            step()
        graph = capture.graph
    while done < steps:
        for _ in range(min(CHUNK, steps - done)):
            wp.capture_launch(graph) if graph is not None else step()
            done += 1
        full = int(np.bitwise_or.reduce(data.overflow.numpy()))
        if full & short and not last:
            break
    return data, most, full


def _place(template: Template, data: Any, placed: tuple[np.ndarray, np.ndarray]) -> None:
    """Where the geoms of fixtures are: MuJoCo Warp computes that once, from the model, and never again."""
    model = template.model
    still = np.isin(model.geom_bodyid, template.fixtures) & (model.body_weldid[model.geom_bodyid] == 0)
    geoms = np.flatnonzero(still)
    if not len(geoms):
        return
    bodies = model.geom_bodyid[geoms]
    turn = matrix(xyzw(placed[1][:, bodies]))
    where, frames = data.geom_xpos.numpy(), data.geom_xmat.numpy()
    where[:, geoms] = placed[0][:, bodies] + (turn @ model.geom_pos[geoms][None, :, :, None])[..., 0]
    frames[:, geoms] = turn @ matrix(xyzw(model.geom_quat[geoms]))[None]
    data.geom_xpos.assign(where)
    data.geom_xmat.assign(frames)


def _trial(template: Template, start: np.ndarray, placed: Any) -> Room:
    """Room for half as many contacts again as some of the worlds begin with, or as a run before needed."""
    worlds = len(start)
    known = _known.get(_sizes(template))
    if known is None:
        mujoco = load_mujoco()
        model, contacts, rows = template.model.__copy__(), 1, 1
        data = mujoco.MjData(model)
        for k in np.unique(np.linspace(0, worlds - 1, min(_TRIED, worlds)).astype(int)):
            if placed is not None:
                model.body_pos[:], model.body_quat[:] = placed[0][k], placed[1][k]
            mujoco.mj_resetData(model, data)
            data.qpos[:] = template.qpos(start[k : k + 1])[0]
            mujoco.mj_step(model, data, 10)
            contacts, rows = max(contacts, int(data.ncon)), max(rows, int(data.nefc))
        known = (1.5 * contacts, int(1.5 * rows))
    # Pairs of parts that are near share the room of contacts; where each has few contacts they are the more. Hulls that
    # touch mostly do so in three or four points, and what is worked out for a pair takes some 8 kB.
    contacts = int(known[0] * worlds) + 256
    return Room(contacts, contacts // 2, known[1] + 64)


def _remember(template: Template, worlds: int, peak: np.ndarray) -> None:
    if len(_known) > 256:
        _known.clear()
    _known[_sizes(template)] = (1.2 * max(peak[0], peak[1]) / worlds, int(1.2 * peak[2]))


def _sizes(template: Template) -> tuple[int, ...]:
    m = template.model
    return tuple(int(n) for n in (m.nq, m.nv, m.nbody, m.ngeom, m.nmesh, m.nmeshvert, m.opt.cone, m.opt.solver))


def _kinds() -> dict[str, int]:
    """Bits of MuJoCo Warp's flags by what they mean."""
    kinds: Any = import_module("mujoco_warp").OverflowType
    return {
        "contacts": int(kinds.BROADPHASE | kinds.NARROWPHASE),
        "touching": int(kinds.CCD),
        "rows": int(kinds.NEFC | kinds.NJMAX_NNZ),
    }


def _problem(overflow: np.ndarray, room: Room, peak: np.ndarray) -> str:
    return (
        f"candidates: no room for all contacts in {int(overflow.sum())} of {len(overflow)} worlds, nothing can be said "
        f"of those: room for {room.contacts} contacts in all ({room.touching} pairs of hulls) and {room.rows} rows a "
        f"world, needed at least {max(int(peak[0]), int(peak[1]))} and {int(peak[2])}; use fewer candidates or objects"
    )
