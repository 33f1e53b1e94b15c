"""Three hundred rooms of eighty kinds with the grades that strict eyes gave them from pictures alone.

``data/judged_rooms/grades.csv`` has a line for each room and judge, ``faults.jsonl.xz`` the faults that they named in
their words, ``scenes.tar.xz`` the scenes. Eighty of the rooms are laid out anew without wishes, so that bad layouts of
the same things are there too. The kinds of rooms of the split "held_out" are none of those of "fit", and each of these
rooms has two judges.
"""

from __future__ import annotations

import csv
import tarfile
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.strict_eyes import GRADED
from sceneweaver.critic import review_scene
from sceneweaver.critic.grade import Lost
from sceneweaver.critic.survey import Survey
from sceneweaver.critic.traits import traits_of
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.rules.grades import Traits
from sceneweaver.scene import Scene
from sceneweaver.verify import check

FOLDER = Path(__file__).parent / "data" / "judged_rooms"

DESIGNED = "designed"
"""How rooms are made as they are delivered; others have their first layout, or are laid out anew without wishes."""


@dataclass(frozen=True)
class JudgedRoom:
    """One room: grades [judges, 4] of those who looked at it."""

    name: str
    kind: str
    made: str
    split: str
    grades: NDArray[np.float64]


@dataclass(frozen=True)
class Measured:
    """What the critic sees in a room: points lost by criterion, its traits, and the grades that it gives."""

    lost: tuple[Lost, ...]
    traits: Traits
    grades: tuple[float, ...]


def judged_rooms(split: str, folder: Path = FOLDER) -> list[JudgedRoom]:
    """The rooms of a split, "fit" or "held_out", by name."""
    rows: dict[str, list[dict[str, str]]] = defaultdict(list)
    with (folder / "grades.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["split"] == split:
                rows[row["room"]].append(row)
    return [
        JudgedRoom(
            name,
            seen[0]["kind"],
            seen[0]["made"],
            split,
            np.array([[float(row[name]) for name in GRADED] for row in sorted(seen, key=lambda r: int(r["judge"]))]),
        )
        for name, seen in sorted(rows.items())
    ]


def scenes_of(rooms: list[JudgedRoom], folder: Path = FOLDER) -> list[str]:
    """The scenes of rooms as JSON texts."""
    wanted = {f"{room.name}.json": k for k, room in enumerate(rooms)}
    texts = [""] * len(rooms)
    with tarfile.open(folder / "scenes.tar.xz") as archive:
        for member in archive:
            if member.name in wanted and (data := archive.extractfile(member)) is not None:
                texts[wanted[member.name]] = data.read().decode()
    return texts


def measured(rooms: list[JudgedRoom], processes: int = 1) -> list[Measured]:
    """What the critic sees in rooms, in their order."""
    texts, kinds = scenes_of(rooms), [room.kind for room in rooms]
    if processes == 1:
        return [*map(_measured, texts, kinds)]
    with ProcessPoolExecutor(processes) as pool:
        return [*pool.map(_measured, texts, kinds, chunksize=8)]


def _measured(text: str, kind: str) -> Measured:
    scene, of_kind = Scene.loads(text), room_type(kind)
    request, report = read_request(f"Design me a {kind.replace('_', ' ')}"), check(scene)
    review = review_scene(scene, report, of_kind, request)
    lost = tuple(Lost.of([f for f in review.faults if f.criterion == name]) for name in GRADED)
    traits = traits_of(Survey.of(scene, report, of_kind, request))
    return Measured(lost, traits, tuple(review.grades[name] for name in GRADED))
