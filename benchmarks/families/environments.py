"""Environments: many worlds with different rooms and one robot, stepped at once."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.design_files import design_files, read_scene
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.envs.batched import Bank, BatchedRoomEnv
from sceneweaver.envs.env import PERIOD
from sceneweaver.layout import refine
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import Scene

WORLDS = (256, 1024, 4096)
STEPS = 100
EXAMPLES = ("bedroom", "study")
AGREEMENT = 0.98
_FAR = 0.01  # [m]: a body that goes farther while the robot does nothing has moved

COLUMNS = (
    Column("by", "by"),
    Column("worlds", "worlds", "count"),
    Column("rooms", "rooms", "count"),
    Column("layouts", "layouts", "count"),
    Column("rate", "steps/s", "count"),
    Column("physics", "physics steps/s", "count"),
    Column("each", "ms a step", "number"),
    Column("real", "times real time", "count"),
    Column("contacts", "contacts a world", "number"),
    Column("rows", "rows, most", "count"),
    Column("memory", "memory [GB]", "number"),
    Column("overflow", "overflow", "count"),
    Column("made", "made [s]", "number"),
    Column("first", "first step [s]", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Step worlds of a bank with actions drawn at random."""
    del judge  # MuJoCo C is the judge here
    bank = _bank(settings)
    slots = bank.slots
    result = Result(
        "environments",
        "Batched environments",
        f"Each world has a layout of a room of its own, as far as there are so many ({bank.layouts} layouts of "
        f"{bank.rooms} rooms), and the drawn mobile manipulator; a step is {PERIOD} s of 10 physics steps with actions "
        f"drawn at random, tasks, rewards, observations and resets included. Slots: {slots.still} boxes that stand "
        f"still, {slots.links} doors and drawers, {len(slots.free)} free bodies of {sum(slots.free)} boxes. MuJoCo C "
        f"steps the same worlds on {cores()} threads.",
    )
    table = result.add("worlds", "Steps a second", COLUMNS, keys=2)
    gpu = settings.device != "cpu"
    sizes = [settings.size(n, 4) for n in WORLDS] if gpu and not settings.quick else [settings.size(64, 4)]
    for worlds in dict.fromkeys(sizes) if gpu else ():
        table.rows.append(_timed(bank, worlds, settings, settings.size(STEPS, 3), None))
    few = settings.size(64, 4)
    table.rows.append(_timed(bank, few, settings, settings.size(STEPS // 4, 3), "c"))
    for row in table.rows:
        if row["overflow"]:
            result.failures.append(f"{row['by']}, {row['worlds']} worlds: {row['overflow']} had too little room")
    if gpu:
        agreed = _agreement(bank, few, settings)
        result.notes.append(f"Bodies that move more than 1 cm in 1 s or do not, as MuJoCo C says: {agreed:.1%}.")
        if agreed < AGREEMENT:
            result.failures.append(f"agrees with MuJoCo C in {agreed:.1%} of the cases, goal {AGREEMENT:.0%}")
    return result


def _bank(settings: Settings) -> Bank:
    """A bank from a file, from designs, or from examples and layouts of them."""
    files = [path for path in settings.designs if Path(path).suffix == ".npz"]
    if files:
        return Bank.load(files[0])
    if settings.designs:
        scenes = [read_scene(path) for path in design_files(settings.designs).values()]
        return Bank.of(scenes, jobs=settings.jobs)
    scenes = [Scene.example(name) for name in (EXAMPLES[:1] if settings.quick else EXAMPLES)]
    count = settings.size(64, 2)
    layouts = [
        np.asarray(refine(s, candidates=count, seed=settings.seed, device=settings.device).poses) for s in scenes
    ]
    return Bank.of(scenes, layouts)


def _timed(bank: Bank, worlds: int, settings: Settings, steps: int, backend: str | None) -> dict[str, Any]:
    import warp as wp

    device = "cpu" if backend == "c" else settings.device
    where = wp.get_device(device)
    before = where.free_memory if where.is_cuda else 0
    began = time.perf_counter()
    env = BatchedRoomEnv(bank, worlds, device=device, seed=settings.seed)
    _, info = env.reset(options={"layout": np.arange(worlds) % bank.layouts})
    made = time.perf_counter() - began
    rng = np.random.default_rng(settings.seed)
    shape = env.action.shape
    actions = [wp.array(rng.uniform(-1, 1, shape), dtype=float, device=device) for _ in range(8)]
    began = time.perf_counter()
    env.step_device(actions[0])
    wp.synchronize()
    first = time.perf_counter() - began
    env.step_device(actions[1])
    wp.synchronize()
    began = time.perf_counter()
    for k in range(steps):
        env.step_device(actions[k % len(actions)])
    wp.synchronize()
    spent = time.perf_counter() - began
    load, substeps = env.physics.load(), round(PERIOD / env.template.opt.timestep)
    return {
        "by": "MuJoCo C" if backend == "c" or device == "cpu" else "MuJoCo Warp",
        "worlds": worlds,
        "rooms": len(np.unique(info["room"])),
        "layouts": len(np.unique(info["layout"])),
        "rate": round(worlds * steps / spent),
        "physics": round(worlds * steps * substeps / spent),
        "each": 1e3 * spent / steps,
        "real": round(worlds * steps * PERIOD / spent),
        "contacts": load["contacts"] / worlds,
        "rows": load["rows"],
        "memory": (before - where.free_memory) / 1e9 if where.is_cuda else None,
        "overflow": int(env.overflow().sum()),
        "dropped": float(np.mean(info["dropped"])),
        "dofs": int(env.template.nv),
        "geoms": int(env.template.ngeom),
        "made": made,
        "first": first,
    }


def _agreement(bank: Bank, worlds: int, settings: Settings) -> float:
    """Share of free bodies of which both simulators say, or neither says, that they move by themselves."""
    moved = []
    for device in (settings.device, "cpu"):
        env = BatchedRoomEnv(bank, worlds, device=device, seed=settings.seed)
        start = env.reset(seed=settings.seed, options={"layout": np.arange(worlds) % bank.layouts})[0]["objects"]
        for _ in range(round(1.0 / PERIOD)):
            env.step_device()
        end = env.observations["objects"].numpy()
        moved.append(np.linalg.norm(end[..., :3] - start[..., :3], axis=-1) > _FAR)
    return float((moved[0] == moved[1]).mean())
