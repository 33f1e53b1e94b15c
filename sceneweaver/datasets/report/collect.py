"""What the report of a data set is drawn from, in one pass over its rows and one over its scenes."""

from __future__ import annotations

import hashlib
import json
import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np

from ..folder import Folder
from ..reading import rows_of, scenes_of, shards_of, spans_of
from ..statistics import statistics
from .layouts import layout_files, program_layouts, program_rows
from .plan import box_of, plan
from .sampling import Sampler

CELLS = 24
"""Cells of a heat map along each side of a room."""

SCENES = 20000
"""How many scenes are read at most; of more, evenly chosen ones."""

_TOGETHER = 64  # scenes between two looks at the headers of a shard


@dataclass
class Gathered:
    """What was gathered of a data set.

    Attributes:
        numbers: its statistics.
        wall: rows of the scenes on the wall, by key, in order.
        pairs: keys of near-duplicates, two and two.
        plans: drawings of these scenes, by key.
        heat: by category, how often an object of it stands in each cell [CELLS, CELLS] of a room, turned so that its
            first door is in the lower side; first axis upwards.
        together: in how many scenes two categories stand on the floor, by their names in order.
        present: in how many scenes a category does.
        relations: by type, how many are hard and how many soft.
        shells: outlines that differ, by their signature, with how many scenes have each.
        palettes: how many scenes have a palette.
        read: how many scenes were read.
    """

    numbers: dict[str, Any]
    wall: dict[str, dict[str, Any]]
    pairs: list[tuple[str, str]]
    plans: dict[str, str] = field(default_factory=dict)
    heat: dict[str, np.ndarray] = field(default_factory=dict)
    together: Counter[tuple[str, str]] = field(default_factory=Counter)
    present: Counter[str] = field(default_factory=Counter)
    relations: dict[str, list[int]] = field(default_factory=dict)
    shells: dict[str, tuple[Sequence[Sequence[float]], int]] = field(default_factory=dict)
    palettes: Counter[str] = field(default_factory=Counter)
    read: int = 0

    def add(self, scene: Mapping[str, Any]) -> None:
        """Gather a scene from its JSON."""
        self.read += 1
        named = sorted({obj["category"] for obj in scene["objects"] if obj["mount"] == "floor"})
        self.present.update(named)
        self.together.update(combinations(named, 2))
        for relation in scene.get("relations", ()):
            self.relations.setdefault(relation["type"], [0, 0])[0 if relation.get("hard", True) else 1] += 1
        if scene.get("palette"):
            self.palettes[scene["palette"]["name"]] += 1
        outline = scene["room"]["outline"]
        signature = shell_signature(outline)
        self.shells[signature] = (outline, self.shells.get(signature, (outline, 0))[1] + 1)
        self._heat(scene)

    def _heat(self, scene: Mapping[str, Any]) -> None:
        turn = turn_of(scene["room"])
        left, low, right, high = box_of([turned(p, turn) for p in scene["room"]["outline"]])
        for obj in scene["objects"]:
            if obj["mount"] != "floor":
                continue
            x, y = turned(obj["pose"]["position"], turn)
            column, row = (int(CELLS * (v - a) / (b - a)) for v, a, b in ((x, left, right), (y, low, high)))
            cells = self.heat.setdefault(obj["category"], np.zeros((CELLS, CELLS)))
            cells[min(max(row, 0), CELLS - 1), min(max(column, 0), CELLS - 1)] += 1


def gather(folder: Folder, product: str = "scenes") -> Gathered:
    """Gather all that the report shows of rows and scenes; of layouts, a row is a program."""
    sampler, layouts = Sampler(), product == "layouts"
    numbers = statistics(sampler.watch(program_rows(folder) if layouts else rows_of(folder)))
    if layouts:
        numbers["bytes"] = sum(path.stat().st_size for path in layout_files(folder))
    found = Gathered(numbers, sampler.wall(), sampler.pairs)
    drawn = {*found.wall, *(key for pair in found.pairs for key in pair)}
    step = max(1, math.ceil(numbers["scenes"] / SCENES))
    for number, (key, content) in enumerate(program_layouts(folder) if layouts else _scene_texts(folder)):
        if number % step and key not in drawn:
            continue
        scene = json.loads(content)
        if key in drawn and key not in found.plans:
            found.plans[key] = plan(scene)
        if number % step == 0:
            found.add(scene)
    return found


def shell_signature(outline: Iterable[Iterable[float]]) -> str:
    """Names an outline to 5 cm, wherever its first corner is and however it is turned."""
    points = np.asarray(list(outline), dtype=float)
    sides = np.roll(points, -1, axis=0) - points
    lengths = np.round(np.hypot(sides[:, 0], sides[:, 1]) / 0.05).astype(int)
    ways = np.degrees(np.arctan2(sides[:, 1], sides[:, 0]))
    bends = np.round(np.roll(ways, -1) - ways).astype(int) % 360
    pairs = list(zip(lengths.tolist(), bends.tolist(), strict=True))
    least = min(pairs[k:] + pairs[:k] for k in range(len(pairs)))
    return hashlib.sha256(str(least).encode()).hexdigest()[:16]


def turn_of(room: Mapping[str, Any]) -> int:
    """By how many right angles a room is turned for its first door to be in its lower side."""
    if not room.get("doors"):
        return 0
    outline, wall = room["outline"], room["doors"][0]["wall"]
    (ax, ay), (bx, by) = outline[wall], outline[(wall + 1) % len(outline)]
    return -round(math.atan2(by - ay, bx - ax) / (math.pi / 2)) % 4


def turned(point: Sequence[float], turn: int) -> tuple[float, float]:
    """A point turned by right angles about the origin."""
    x, y = point[0], point[1]
    return ((x, y), (-y, x), (-x, -y), (y, -x))[turn]


def _scene_texts(folder: Folder) -> Iterator[tuple[str, bytes]]:
    for shard in shards_of(folder):
        for span in spans_of(shard, _TOGETHER):
            yield from ((key, files["scene.json"]) for key, files in scenes_of(span, ("scene.json",)))
