"""Tight bedrooms made for the benchmarks: their witnesses are valid, also to the independent checker."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from benchmarks.families.tight import SEEDS, fill
from benchmarks.starts import blind
from benchmarks.tight_rooms import tight_room
from sceneweaver.layout import refine
from sceneweaver.verify import check
from tests.sizes import sizes

CHECKER = Path(__file__).parents[1] / "oracle" / "check_scene.py"


@sizes("seeds", SEEDS[:2], SEEDS)
def test_witnesses_are_valid_and_the_rooms_are_tight(tmp_path: Path, seeds: Sequence[int]) -> None:
    files = []
    for seed in seeds:
        scene = tight_room(seed)
        report = check(scene, walkable=False)
        assert not report.violations
        files.append(tmp_path / f"{scene.id}.json")
        scene.save(files[-1])
        floor, walls = fill(scene)
        assert floor > 0.4 and walls > 0.45
    lines = subprocess.run([sys.executable, CHECKER, *files], capture_output=True, text=True, check=True).stdout
    assert lines.splitlines()[-1] == f"{len(files)}/{len(files)} valid"


@pytest.mark.slow
def test_further_attempts_make_the_most_of_a_tight_room() -> None:
    scene = blind(tight_room(10))
    few, usual = (refine(scene, candidates=64, init="random", device="cpu", steps=steps) for steps in (10, None))
    assert few.status.astype(bool).any(), "it is not tight"
    assert not usual.status.any()
    ready = few.status == 0
    assert usual.poses[ready].tobytes() == few.poses[ready].tobytes()


def test_a_seed_gives_the_same_room_and_another_seed_another_one() -> None:
    one, two = tight_room(7), tight_room(8)
    assert one.dumps() == tight_room.__wrapped__(7).dumps()
    assert one.room != two.room and [o.size for o in one.objects] != [o.size for o in two.objects]
