"""Layouts as a data set: how many different valid ones a second are written to Parquet, and how good they are."""

from __future__ import annotations

import argparse
import json
import resource
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp

from benchmarks.layout_rows import Written, examine_all
from sceneweaver.datasets import Requests, Spec
from sceneweaver.datasets.layouts.block import Taken, taken_programs
from sceneweaver.datasets.layouts.collect import Collection, chains_for, collect
from sceneweaver.datasets.layouts.pack import furniture
from sceneweaver.datasets.layouts.tables import Writers, schema
from sceneweaver.io import write_atomic
from sceneweaver.layout.devices import pick_devices
from sceneweaver.runtime.threads import cores

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
SPARE = 0.1
"""Programs that are asked for beyond those that are wanted, as a share, since some come to nothing."""


def main(arguments: list[str] | None = None) -> int:
    """Measure; 1 when a layout that was written is not valid, or is there twice."""
    p = argparse.ArgumentParser(prog="python -m benchmarks layouts", description=__doc__)
    p.add_argument("--seconds", type=float, default=60.0, help="0: only draw the programs and search first layouts")
    p.add_argument("--programs", type=int, default=300, help="how many; with --scenes at most")
    p.add_argument("--scenes", type=Path, help="a folder of scene files to take as programs; default: draw them")
    p.add_argument("--save", type=Path, help="a folder to write the programs to, for --scenes of other machines")
    p.add_argument("--candidates", type=int, default=24, help="layouts that are searched first for each program")
    p.add_argument("--device", default="auto")
    p.add_argument("--judged", type=int, default=5000)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--json", type=Path, help="a file for the figures, written again after every stage")
    asked = p.parse_args(arguments)
    device, figures = pick_devices(asked.device)[0], Figures(asked.json)
    taken, ready = _prepared(asked, device, figures)
    if asked.save:
        save(asked.save, taken)
    if not asked.seconds:
        return 0
    with tempfile.TemporaryDirectory() as folder:
        written = _collected(asked, device, figures, taken, ready, Path(folder))
        return _examined(written, figures)


class Figures:
    """What was measured, in lines and as one JSON file."""

    def __init__(self, path: Path | None):
        self._path = path
        self._found: dict[str, Any] = {}

    def note(self, **found: Any) -> None:
        """Add figures, and write the file again."""
        self._found |= found
        if self._path:
            write_atomic(self._path, json.dumps(self._found, indent=1) + "\n")


def spec_of(programs: int, candidates: int, seed: int, scenes: list[str] | None = None) -> Spec:
    """The specification whose programs are measured: drawn ones, or those of scene files."""
    asked = {"kinds": dict.fromkeys(KINDS, 1.0)} if scenes is None else {"scenes": scenes}
    return Spec.model_validate(
        {
            "schema": "sceneweaver.dataset/1",
            "name": "layouts",
            "product": "layouts",
            "count": programs * MOST,
            "seed": seed,
            "requests": asked,
            "rooms": {"layouts": MOST, "objects": [15, 40], "candidates": candidates, "attempts": 2},
            "block": 4096,
        }
    )


def save(folder: Path, taken: list[Taken]) -> None:
    """Write programs as scene files."""
    folder.mkdir(parents=True, exist_ok=True)
    for one in taken:
        scene = one.scene.scene
        (folder / f"{one.program.request.room:04d}-{scene.room.type}.json").write_text(scene.dumps())


def _prepared(asked: argparse.Namespace, device: str, figures: Figures) -> tuple[list[Taken], float]:
    """The programs with their first layouts, and how many seconds that took."""
    count, names, folder = asked.programs + int(SPARE * asked.programs) + 1, None, Path()
    if asked.scenes is not None:
        folder, names = asked.scenes, sorted(path.name for path in asked.scenes.glob("*.json"))[:count]
        count = len(names)
    spec = spec_of(count, asked.candidates, asked.seed, names)
    began, cpu = time.perf_counter(), _cpu()
    found, refused = taken_programs(spec, Requests(spec, folder).block(0), device)
    ready, cpu = time.perf_counter() - began, _cpu() - cpu
    different = {furniture(found[room].scene.scene.dumps()): found[room] for room in sorted(found)}
    taken = list(different.values())[: asked.programs]
    counts = [len(t.scene.scene.objects) for t in taken]
    kinds = Counter(t.scene.scene.room.type for t in taken)
    _say(f"{len(taken)} programs of {min(counts)} to {max(counts)} objects (median {np.median(counts):.0f})")
    _say(f"  {', '.join(f'{kind} {count}' for kind, count in sorted(kinds.items()))}")
    _say(f"  {len(refused.keys() - found.keys())} refused, {len(found) - len(different)} like others")
    how = "draw them" if asked.scenes is None else f"read them from {asked.scenes}"
    _say(f"  {ready:.1f} s to {how} and search their first layouts, {cores()} cores; {cpu:.1f} CPU seconds")
    figures.note(
        programs=len(taken),
        drawn=asked.scenes is None,
        kinds=len(kinds),
        objects=[min(counts), float(np.median(counts)), max(counts)],
        first_layouts=sum(len(t.first.poses) for t in taken),
        preparation_seconds=round(ready, 2),
        preparation_cpu_seconds=round(cpu, 2),
        cores=cores(),
        device=device,
    )
    return taken, ready


def _collected(
    asked: argparse.Namespace, device: str, figures: Figures, taken: list[Taken], ready: float, folder: Path
) -> list[Written]:
    """Write layouts for as long as was asked."""
    start, cpu = time.perf_counter(), _cpu()
    writers = Writers(folder, schema(40))
    collections = [Collection(k, k, t.scene, MOST, writers.add) for k, t in enumerate(taken)]
    first, seeds = [t.first for t in taken], [t.program.seed for t in taken]
    scenes = [t.scene for t in taken]
    steps = collect(scenes, first, seeds, collections, device, lambda: time.perf_counter() - start > asked.seconds)
    stepped = time.perf_counter() - start
    writers.close()
    seconds, cpu = time.perf_counter() - start, _cpu() - cpu
    rows, size = sum(c.count for c in collections), sum(path.stat().st_size for path in writers.paths)
    each = [c.count for c in collections]
    chains = chains_for(MOST, len(taken), device)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    pooled = wp.get_device(device).is_mempool_enabled
    on_device = wp.get_mempool_used_mem_high(device) / 2**30 if pooled else 0.0
    _say(f"{rows:,} different valid layouts written in {seconds:.1f} s on {device}: {rows / seconds:,.0f} a second")
    _say(f"  {cpu:.1f} CPU seconds: {rows / cpu:,.0f} a CPU second")
    _say(f"  {memory:.1f} GiB of memory, {on_device:.1f} GiB on the GPU")
    _say(f"  {steps} steps of {chains:,} chains a program, {min(each):,} to {max(each):,} layouts a program")
    _say(f"  {size / rows:.0f} bytes a layout, {size / seconds / 1e6:.0f} MB/s; {seconds - stepped:.1f} s to end files")
    _say(f"  with the preparation: {rows / (seconds + ready):,.0f} a second")
    figures.note(
        layouts=rows,
        seconds=round(seconds, 2),
        seconds_to_end_files=round(seconds - stepped, 2),
        layouts_a_second=round(rows / seconds),
        cpu_seconds=round(cpu, 2),
        layouts_a_cpu_second=round(rows / cpu),
        memory_gib=round(memory, 2),
        gpu_memory_gib=round(on_device, 2),
        steps=steps,
        chains_a_program=chains,
        layouts_a_program=[min(each), int(np.median(each)), max(each)],
        bytes_a_layout=round(size / rows, 1),
    )
    return [
        Written(k, t.scene.scene.dumps(), writers.path(k), each[k], -(-asked.judged // len(taken)))
        for k, t in enumerate(taken)
    ]


def _examined(written: list[Written], figures: Figures) -> int:
    """Count all layouts that were written, and judge an even sample."""
    start = time.perf_counter()
    rows = signatures = distinct = groups = judged = 0
    wrong: list[str] = []
    for number, (one, found) in enumerate(zip(written, examine_all(written), strict=True), 1):
        assert found.rows == one.count
        rows, signatures, distinct = rows + found.rows, signatures + found.signatures, distinct + found.distinct
        groups, judged, wrong = groups + found.groups, judged + found.judged, wrong + list(found.wrong)
        if number % 25 == 0 or number == len(written):
            figures.note(
                programs_examined=number,
                counted=rows,
                signatures=signatures,
                distinct=distinct,
                arrangements=groups,
                judged=judged,
                exceptions=len(wrong),
                examination_seconds=round(time.perf_counter() - start, 2),
            )
    _say(f"judged {judged:,}: {len(wrong)} exceptions {wrong[:3] or ''}")
    _say(f"  of all {rows:,}, counted again, {distinct:,} are distinct by wall, 0.5 m cell and eighth of a turn")
    _say(f"  {groups:,} arrangements of the large pieces at walls ({groups / max(rows, 1):.1%})")
    _say(f"  {time.perf_counter() - start:.1f} s to judge and count")
    return int(bool(wrong) or signatures < rows)


def _cpu() -> float:
    """CPU seconds of this process and those that it waited for."""
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime


def _say(text: Any) -> None:
    from benchmarks.console import say

    say(text)


if __name__ == "__main__":
    raise SystemExit(main())
