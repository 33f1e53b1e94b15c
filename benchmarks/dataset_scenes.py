"""Scenes of a data set: CPU seconds by kind of room and by stage, grades, and how many requests are served."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import defaultdict
from pathlib import Path

from benchmarks.console import say
from sceneweaver.datasets import AssetStore, Requests, Spec

KINDS = (
    *("bedroom", "restaurant", "gym", "office", "living room", "bathroom", "childrens room", "kitchen"),
    *("meeting room", "waiting room"),
)
"""The kinds of rooms that are measured unless others are named."""


def main(arguments: list[str] | None = None) -> int:
    """Measure; 1 when a scene that is delivered is not valid."""
    p = argparse.ArgumentParser(prog="python -m benchmarks datasets", description=__doc__)
    p.add_argument("--rooms", type=int, default=3, help="rooms of each kind (default: 3)")
    p.add_argument("--warm", type=int, default=0, help="rooms of each kind that are made before, and not counted")
    p.add_argument("--layouts", type=int, default=1, help="scenes of each room (default: 1)")
    p.add_argument("--candidates", type=int, default=24)
    p.add_argument("--kinds", default=",".join(KINDS), help="with commas between them")
    p.add_argument("--exports", default="glb,mjcf", help="with commas between them; empty: none")
    p.add_argument("--device", default="cpu")
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--design", action="store_true", help="make the same rooms with `design`, to compare with")
    asked = p.parse_args(arguments)
    spec = _spec(asked)
    requests = Requests(spec)
    first = asked.warm * len(asked.kinds.split(","))
    return _designed(requests, first, asked) if asked.design else _produced(spec, requests, first, asked)


def _spec(asked: argparse.Namespace) -> Spec:
    prompts = [f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}" for kind in asked.kinds.split(",")]
    return Spec.model_validate(
        {
            "schema": "sceneweaver.dataset/1",
            "name": "measured",
            "count": (asked.rooms + asked.warm) * len(prompts) * asked.layouts,
            "seed": asked.seed,
            "requests": {"prompts": prompts},
            "rooms": {"candidates": asked.candidates, "layouts": asked.layouts},
            "exports": [name for name in asked.exports.split(",") if name],
            "block": len(prompts),
        }
    )


def _produced(spec: Spec, requests: Requests, first: int, asked: argparse.Namespace) -> int:
    from sceneweaver.datasets.produce import produce

    samples, spent = [], 0.0
    with tempfile.TemporaryDirectory() as folder:
        store = AssetStore(Path(folder))
        for number in range(requests.blocks):
            rooms, began = requests.block(number), time.process_time()
            made = [*produce(spec, rooms, store, asked.device)]
            seconds = time.process_time() - began
            counted = rooms[0].room >= first
            say(f"block {number}: {seconds / len(made):.2f} CPU s a scene" + ("" if counted else " (not counted)"))
            if counted:
                samples, spent = samples + made, spent + seconds
    rows: dict[str, list] = defaultdict(list)
    stages: dict[str, float] = defaultdict(float)
    for sample in samples:
        rows[sample.row["prompt"]].append(sample)
        for stage, seconds in sample.seconds.items():
            stages[stage] += seconds
    say(f"{'':18} {'served':>7} {'first':>6} {'objects':>8} {'grade':>6} {'wall s':>7} {'kB':>6}")
    for name, made in [*rows.items(), ("all", samples)]:
        served = [s for s in made if s.status == "ok"]
        count = max(1, len(served))
        grade = sum(s.row["grade"] for s in served) / count
        say(
            f"{name:18} {len(served) / len(made):7.1%} {sum(s.row['attempt'] == 0 for s in served) / count:6.0%} "
            f"{sum(s.row['object_count'] for s in served) / count:8.1f} {grade:6.2f} "
            f"{sum(sum(s.seconds.values()) for s in made) / len(made):7.2f} "
            f"{sum(len(f) for s in served for f in s.files.values()) / 1000 / count:6.0f}"
        )
    say(", ".join(f"{stage} {seconds / len(samples):.2f}" for stage, seconds in stages.items()) + " wall s a scene")
    say(f"{spent / len(samples):.2f} CPU s a scene")
    for sample in samples:
        if sample.status != "ok":
            say(f"{sample.key} {sample.status}: {sample.row['prompt']}: {sample.row['reason']}")
    return int(any(s.status == "ok" and not s.row["valid"] for s in samples))


def _designed(requests: Requests, first: int, asked: argparse.Namespace) -> int:
    from sceneweaver import design

    spent, grades, valid = 0.0, [], 0
    rooms = [requests[room] for room in range(first, len(requests))]
    for room in rooms:
        began = time.process_time()
        with tempfile.TemporaryDirectory() as folder:
            result = design(
                room.prompt,
                seed=room.attempt(0),
                out=folder,
                device=asked.device,
                clutter=room.clutter,
                time_limit=None,
                pictures=False,
                export=asked.exports or "none",
            )
        seconds = time.process_time() - began
        spent, valid = spent + seconds, valid + result.report.valid
        grades.append(result.review.total)
        say(f"{room.prompt:18} {len(result.scene.objects):8} {result.review.total:6.2f} {seconds:7.2f} CPU s")
    say(f"{valid} of {len(rooms)} valid, grade {sum(grades) / len(rooms):.2f}, {spent / len(rooms):.2f} CPU s a scene")
    return 0
