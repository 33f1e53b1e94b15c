"""Layouts to train the prior on: many drafts of rooms, of each the best of many layouts that the engine finds valid.

Each process draws drafts and searches their layouts, a few rooms at once; all share the GPU. Kept are, of a room, the
best layout of each signature and then the next best by what the agent chooses by: soft relations and design quality.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import time
import traceback
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.console import say
from benchmarks.prior_rooms import training_rooms
from sceneweaver.assets import categories
from sceneweaver.io import InputError, read_arrays, write_atomic
from sceneweaver.knowledge import room_types
from sceneweaver.prior.tokens import TRAINED, fits, padded, tokens_of
from sceneweaver.prior.vocabulary import Words
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import Scene
from sceneweaver.scene.catalogue import CATALOGUE

AT_ONCE = 8
"""Rooms that a process searches together."""

LONGEST = 25.0
"""Seconds in which they are searched at most: a room that is hard is left at what was found."""

AHEAD = 16
"""As many times these rooms are drawn ahead while the kernels compile."""

LEAST = 4
"""Valid layouts that a room needs to be taken."""


def main(arguments: list[str] | None = None) -> int:
    """Write layouts for some seconds; 1 when there are none."""
    p = argparse.ArgumentParser(prog="python -m benchmarks prior_data", description=__doc__)
    p.add_argument("--out", type=Path, required=True, help="a folder for parts; what is there stays and counts")
    p.add_argument("--seconds", type=float, default=200.0, help="after which no more rooms are begun")
    p.add_argument("--rooms", type=int, default=20_000, help="rooms at most")
    p.add_argument("--candidates", type=int, default=512, help="layouts searched of each room")
    p.add_argument("--keep", type=int, default=24, help="layouts kept of each room at most")
    p.add_argument("--workers", type=int, default=cores(), help="processes")
    p.add_argument("--device", default="auto")
    asked = p.parse_args(arguments)
    asked.out.mkdir(parents=True, exist_ok=True)
    end = time.time() + asked.seconds
    rooms = training_rooms()[: asked.rooms]
    if asked.device == "auto":
        from sceneweaver.layout.devices import pick_devices

        asked.device = pick_devices("auto")[0]
    context = multiprocessing.get_context("spawn")
    begin, counter = context.Event(), context.Value("q", 0)
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ[name] = "1"
    options = (str(asked.out), asked.candidates, asked.keep, asked.device, end, rooms)
    workers = [
        context.Process(target=_work, args=(k, begin, counter, *options), daemon=True) for k in range(asked.workers)
    ]
    for worker in workers:
        worker.start()
    _warm(asked.device, asked.keep)
    say(f"kernels are ready after {asked.seconds - (end - time.time()):.0f} s")
    begin.set()
    for worker in workers:
        worker.join(max(1.0, end + 30.0 - time.time()))
        if worker.is_alive():
            worker.terminate()
    found = summary(asked.out)
    say(json.dumps(found))
    for path in sorted(asked.out.glob("error-*.txt"))[:2]:
        say(f"{path.name}: {path.read_text()[-1500:]}")
    return 0 if found["rooms"] else 1


def summary(folder: Path) -> dict[str, Any]:
    """How many rooms and layouts there are."""
    parts = sorted(folder.glob("part-*.npz"))
    counts = [read_arrays(path)["counts"] for path in parts]
    rooms = np.concatenate(counts) if counts else np.zeros(0, dtype=np.int64)
    failed = [json.loads(path.read_text())["failed"] for path in sorted(folder.glob("part-*.json"))]
    return {"parts": len(parts), "rooms": len(rooms), "layouts": int(rooms.sum()), "failed": int(sum(failed))}


def _warm(device: str, keep: int) -> None:
    """Compile all kernels that the workers need, once."""
    _searched([_drawn("bedroom", 0), _drawn("kitchen", 0), _drawn("office", 0)], 64, keep, device, 0)


def _work(number: int, begin: Any, counter: Any, out: str, candidates: int, keep: int, device: str, end: float, rooms):
    """What a process does: take the next rooms, draw them, search them, write them; ahead while kernels compile."""
    waiting: list[tuple[int, list, int]] = []
    errors = 0
    while time.time() < end and errors < 4:
        if not waiting or (not begin.is_set() and len(waiting) < AHEAD):
            with counter.get_lock():
                first = counter.value
                counter.value += AT_ONCE
            if first < len(rooms):
                if not (Path(out) / f"part-{first:06d}.npz").exists():
                    waiting.append((first, *_drafts(rooms[first : first + AT_ONCE], end)))
                continue
            if not waiting:
                return
        begin.wait()
        first, drawn, failed = waiting.pop(0)
        try:
            found = _searched(drawn, candidates, keep, device, first)
            path = Path(out) / f"part-{first:06d}.npz"
            write_part(path, found)
            write_atomic(path.with_suffix(".json"), json.dumps({"failed": failed + len(drawn) - len(found)}))
        except Exception:
            write_atomic(Path(out) / f"error-{first:06d}.txt", traceback.format_exc())
            errors += 1


def _drafts(rooms: list[tuple[str, int]], end: float) -> tuple[list, int]:
    """The drafts of rooms, and how many came to nothing or are too large."""
    drawn, failed = [], 0
    for kind, seed in rooms:
        if time.time() >= end:
            break
        try:
            one = _drawn(kind, seed)
        except Exception:  # a room that can not be drawn is one less
            failed += 1
            continue
        if fits(one[2]):
            drawn.append(one)
        else:
            failed += 1
    return drawn, failed


def _drawn(kind: str, seed: int) -> tuple[str, int, Scene, list]:
    """A draft as the search sees it, with what its layouts are chosen by."""
    from benchmarks.drafts import draft

    made = draft(kind, seed)
    plain = made.plain
    plain = plain.model_copy(update={"free_areas": ()}) if plain.free_areas else plain
    return kind, seed, plain, made.terms


def _searched(drawn: list, candidates: int, keep: int, device: str, seed: int) -> list[dict[str, Any]]:
    """The best layouts of rooms."""
    from sceneweaver.layout.engine import refine_many
    from sceneweaver.layout.solution import best_of_each_signature

    if not drawn:
        return []
    scenes, terms = [d[2] for d in drawn], [d[3] for d in drawn]
    solutions = refine_many(
        scenes, candidates=candidates, seed=seed, device=device, quality=terms, snap=True, time_limit=LONGEST
    )
    found = []
    for (kind, own, scene, _), solution in zip(drawn, solutions, strict=True):
        ranked = solution.ranked
        if len(ranked) < LEAST:
            continue
        best = best_of_each_signature(solution)[: keep // 2]
        order = np.concatenate([best, ranked[~np.isin(ranked, best)]])[:keep]
        quality = np.asarray(solution.quality)
        found.append(
            {
                "kind": kind,
                "seed": own,
                "scene": scene,
                "poses": solution.poses[order],
                "quality": quality[order],
                "median": float(np.median(quality[ranked])),
                "valid": len(ranked) / candidates,
            }
        )
    return found


def write_part(path: Path, found: list[dict[str, Any]]) -> None:
    """Write rooms with their layouts: tokens of the scenes, and the poses that the network learns."""
    if not found:
        return
    words, file = all_words(), BytesIO()
    tokens = [tokens_of(one["scene"], words) for one in found]
    arrays = {f"token.{name}": array for name, array in padded(tokens, **TRAINED).arrays().items()}
    arrays["token.edges"] = arrays["token.edges"].astype(np.uint8)
    poses = np.zeros((sum(len(one["poses"]) for one in found), TRAINED["objects"], 4), dtype=np.float32)
    row = 0
    for one, token in zip(found, tokens, strict=True):
        local = token.local(one["poses"])
        poses[row : row + len(local), : local.shape[1]] = local
        row += len(local)
    np.savez_compressed(
        file,
        **arrays,
        poses=poses,
        counts=np.array([len(one["poses"]) for one in found], dtype=np.int64),
        quality=np.concatenate([one["quality"] for one in found]),
        median=np.array([one["median"] for one in found], dtype=np.float32),
        valid=np.array([one["valid"] for one in found], dtype=np.float32),
        seeds=np.array([one["seed"] for one in found], dtype=np.int64),
        units=np.array([token.unit for token in tokens], dtype=np.float32),
    )
    write_atomic(path, file.getvalue())


def all_words() -> Words:
    """All names that there are; training leaves out those that it did not see."""
    return Words.of(categories(), room_types(), CATALOGUE)


def read_parts(folder: Path) -> dict[str, np.ndarray]:
    """The arrays of all parts, joined in the order of their rooms."""
    parts = [read_arrays(path) for path in sorted(folder.glob("part-*.npz"))]
    if not parts:
        raise InputError(f"{folder}: there are no parts; run python -m benchmarks prior_data first")
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


if __name__ == "__main__":
    raise SystemExit(main())
