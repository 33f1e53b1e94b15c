"""Homes of a data set: processor time by home and by stage, grades, what is unmet, and a digest of their files."""

from __future__ import annotations

import argparse
import hashlib
import json
import resource
import tempfile
import time
from pathlib import Path
from statistics import fmean

from benchmarks.console import say
from sceneweaver.agent.design import chosen_room
from sceneweaver.critic import review_scene
from sceneweaver.datasets import AssetStore, Requests, Sample, Spec
from sceneweaver.datasets.homes import produce_homes
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check


def main(arguments: list[str] | None = None) -> int:
    """Measure; 1 when a home that is delivered is not valid."""
    p = argparse.ArgumentParser(prog="python -m benchmarks homes", description=__doc__)
    p.add_argument("--homes", type=int, default=3, help="how many (default: 3)")
    p.add_argument("--first", type=int, default=0, help="number of the first (default: 0)")
    p.add_argument("--programme", default="flat-2-bedrooms", help="of all of them (default: flat-2-bedrooms)")
    p.add_argument("--exports", default="glb,mjcf", help="with commas between them; empty: none")
    p.add_argument("--plans", action="store_true", help="plans alone, without furniture")
    p.add_argument("--seed", type=int, default=0)
    asked = p.parse_args(arguments)
    spec = Spec.model_validate(
        {
            "schema": "sceneweaver.dataset/1",
            "name": "measured",
            "product": "homes",
            "count": asked.first + asked.homes,
            "seed": asked.seed,
            "requests": {"programmes": {asked.programme: 1.0}},
            "homes": {"furnished": not asked.plans},
            "exports": [name for name in asked.exports.split(",") if name],
            "time_limit": 10_000.0,
        }
    )
    requests, spent, wrong = Requests(spec), list[float](), 0
    with tempfile.TemporaryDirectory() as folder:
        store = AssetStore(Path(folder))
        for number in range(asked.first, asked.first + asked.homes):
            began = _processor()
            (sample,) = produce_homes(spec, [requests[number]], store)
            spent.append(_processor() - began)
            wrong += sample.status == "ok" and not sample.row["valid"]
            say(f"home {number}: {spent[-1]:.1f} CPU s, {_said(sample)}")
    say(f"{fmean(spent):.1f} CPU s a home")
    return int(wrong > 0)


def _processor() -> float:
    """Processor time of this process and of those that it has waited for [s]."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def _said(sample: Sample) -> str:
    """What a home is, in a line; equal homes have equal digests."""
    if sample.status != "ok":
        return f"{sample.status}: {sample.row['reason']}"
    row, digest = sample.row, hashlib.sha256()
    for name in sorted(sample.files):
        digest.update(name.encode() + sample.files[name])
    grades = [_grade(json.loads(text)) for name, text in sample.files.items() if name.endswith("scene.json")]
    furnished = f"{row['object_count']} objects, mean grade {fmean(grades):.2f}, " if grades else ""
    stages = ", ".join(f"{stage} {seconds:.1f}" for stage, seconds in sample.seconds.items())
    return (
        f"attempt {row['attempt'] + 1}, {'valid' if row['valid'] else 'NOT VALID'}, {row['room_count']} rooms, "
        f"{furnished}{len(row['unmet'])} unmet, files {digest.hexdigest()[:12]}; wall s: {stages}"
    )


def _grade(data: dict) -> float:
    """The critic's grade of a room, 0 to 10."""
    scene = Scene.model_validate(data)
    brief = read_request(scene.prompt)
    return review_scene(scene, check(scene), chosen_room(brief, scene.room)[0], brief).total
