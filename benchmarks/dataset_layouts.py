"""Layouts as a data set: how many different valid ones a second are written to Parquet, and how good they are."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.signature import signatures
from sceneweaver.datasets import Requests, Spec
from sceneweaver.datasets.columns import arrow
from sceneweaver.datasets.layouts.block import Taken, taken_programs
from sceneweaver.datasets.layouts.collect import Collection, chains_for, collect
from sceneweaver.datasets.layouts.read import posed
from sceneweaver.datasets.layouts.tables import Writers, schema
from sceneweaver.layout.devices import pick_devices
from sceneweaver.scene import Scene
from sceneweaver.scene.threads import cores
from sceneweaver.verify import check

# fmt: off
KINDS = (
    "art_studio", "bathroom", "bedroom", "bookstore", "break_room", "cafe", "childrens_room", "dentist",
    "dining_room", "dormitory", "examination_room", "game_room", "garage", "home_gym", "home_theatre",
    "hospital_room", "hotel_room", "kitchen", "laboratory", "laundry_room", "living_room", "meeting_room",
    "museum_room", "music_room", "reception", "storage_room", "studio_apartment", "study", "sunroom", "teen_bedroom",
    "waiting_room", "workshop",
)
# fmt: on
"""Kinds of rooms with 15 to 40 pieces of furniture."""

MOST = 10**6


def main(arguments: list[str] | None = None) -> int:
    """Measure; 1 when a layout that was written is not valid."""
    p = argparse.ArgumentParser(prog="python -m benchmarks layouts", description=__doc__)
    p.add_argument("--seconds", type=float, default=60.0)
    p.add_argument("--programs", type=int, default=300)
    p.add_argument("--candidates", type=int, default=24, help="layouts that are searched first for each program")
    p.add_argument("--device", default="auto")
    p.add_argument("--judged", type=int, default=5000)
    p.add_argument("--seed", type=int, default=0)
    asked = p.parse_args(arguments)
    device = pick_devices(asked.device)[0]
    with tempfile.TemporaryDirectory() as folder:
        return _measure(asked, device, Path(folder))


def spec_of(programs: int, candidates: int, seed: int) -> Spec:
    """The specification whose programs are measured."""
    return Spec.model_validate(
        {
            "schema": "sceneweaver.dataset/1",
            "name": "layouts",
            "product": "layouts",
            "count": programs * MOST,
            "seed": seed,
            "requests": {"kinds": dict.fromkeys(KINDS, 1.0)},
            "rooms": {"layouts": MOST, "objects": [15, 40], "candidates": candidates, "attempts": 4},
            "block": 4096,
        }
    )


def _measure(asked: argparse.Namespace, device: str, folder: Path) -> int:
    spec = spec_of(asked.programs + asked.programs // 2, asked.candidates, asked.seed)
    began = time.perf_counter()
    found, refused = taken_programs(spec, Requests(spec).block(0), device)
    taken = [found[room] for room in sorted(found)][: asked.programs]
    ready = time.perf_counter()
    counts = [len(t.scene.scene.objects) for t in taken]
    kinds = Counter(t.program.request.kind for t in taken)
    _say(f"{len(taken)} programs of {min(counts)} to {max(counts)} objects (median {np.median(counts):.0f})")
    _say(f"  {', '.join(f'{kind} {count}' for kind, count in sorted(kinds.items()))}; {len(refused)} refused")
    _say(f"  {ready - began:.1f} s to draw them and search their first layouts, {cores()} cores")

    start, cpu = time.perf_counter(), time.process_time()
    writers = Writers(folder, schema(spec.rooms.objects[1]))
    collections = [Collection(k, k, t.scene, MOST, writers.add) for k, t in enumerate(taken)]
    first, seeds = [t.first for t in taken], [t.program.seed for t in taken]
    scenes = [t.scene for t in taken]
    steps = collect(scenes, first, seeds, collections, device, lambda: time.perf_counter() - start > asked.seconds)
    writers.close()
    seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
    rows, size = sum(c.count for c in collections), sum(path.stat().st_size for path in writers.paths)
    _say(f"{rows:,} different valid layouts written in {seconds:.1f} s on {device}: {rows / seconds:,.0f} a second")
    each = [c.count for c in collections]
    chains = chains_for(MOST, len(taken), device)
    _say(f"  {cpu:.1f} CPU seconds: {rows / cpu:,.0f} a CPU second")
    _say(f"  {steps} steps of {chains:,} chains a program, {min(each):,} to {max(each):,} layouts a program")
    _say(f"  {size / rows:.0f} bytes a layout, {size / seconds / 1e6:.0f} MB/s")
    _say(f"  with the preparation: {rows / (seconds + ready - began):,.0f} a second")
    return _quality(taken, writers.paths, each, asked.judged)


def _quality(taken: list[Taken], paths: list[Path], each: list[int], judged: int) -> int:
    """Judge an even sample, and count anew what is distinct."""
    pq = arrow().parquet
    rng = np.random.default_rng(0)
    chosen = rng.permutation(len(taken))
    per = max(1, -(-judged // len(taken)))
    work, distinct, groups, total = [], 0, 0, 0
    for k in chosen:
        table = pq.read_table(paths[k % len(paths)], filters=[("program", "=", int(k))])
        scene, width = taken[k].scene.scene, table.schema.field("poses").type.list_size
        poses = table["poses"].combine_chunks().flatten().to_numpy(zero_copy_only=False).reshape(-1, width)
        assert len(poses) == each[k]
        rows = np.unique(np.linspace(0, len(poses) - 1, per).astype(int))
        work.append((scene.dumps(), poses[rows]))
        if total < 2_000_000:
            own = poses[:, : 4 * len(scene.objects)].reshape(len(poses), -1, 4)
            distinct += len(np.unique(signatures(scene, own), axis=0))
            groups += len(np.unique(table["near_duplicate_group"].to_numpy()))
            total += len(poses)
    with ProcessPoolExecutor(cores(), mp_context=get_context("spawn")) as pool:
        wrong = list(pool.map(_wrong, work, chunksize=4))
    count, exceptions = sum(len(poses) for _, poses in work), sum(map(len, wrong))
    _say(f"judged {count:,}: {exceptions} exceptions {[w for some in wrong for w in some][:3] or ''}")
    _say(f"  of {total:,} counted again {distinct:,} are distinct by wall, 0.5 m cell and eighth of a turn")
    _say(f"  {groups:,} arrangements of the large pieces at walls ({groups / total:.1%})")
    return int(exceptions > 0)


def _wrong(one: tuple[str, np.ndarray]) -> list[str]:
    """What the judge finds in layouts of a program that should be valid."""
    scene = Scene.loads(one[0])
    reports = (check(posed(scene, poses), walkable=False) for poses in one[1])
    return [f"{report.violations[0].kind}: {report.violations[0].objects}" for report in reports if not report.valid]


def _say(text: Any) -> None:
    from benchmarks.console import say

    say(text)


if __name__ == "__main__":
    raise SystemExit(main())
