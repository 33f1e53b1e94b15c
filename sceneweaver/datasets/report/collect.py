"""What the report of a data set is drawn from, in one pass over its rows and one over its scenes."""

from __future__ import annotations

import hashlib
import json
import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.io import InputError, parse_json, reason
from sceneweaver.runtime.processes import pool

from ..folder import Folder
from ..layouts.tables import layout_files, programs_of
from ..reading import Span, of_others, rows_of, scenes_of, shards_of, spans_of
from ..statistics import statistics
from ..tables import open_table
from .charts import box_of, plan

PICTURES, PAIRS = 400, 8
"""Plans on the wall, and pairs of near-duplicates, at most."""

_SHOWN = ("key", "prompt", "room_type", "grade", "object_count", "area", "split")


class Sampler:
    """Of each kind of room equally many scenes, spread over the set; and the first near-duplicates.

    Args:
        pictures: scenes on the wall, at most.

    Attributes:
        pairs: keys of near-duplicates, two and two.
    """

    def __init__(self, pictures: int = PICTURES) -> None:
        self._most = pictures
        self.pairs: list[tuple[str, str]] = []
        self._kept: dict[str, list[dict[str, Any]]] = {}
        self._seen: Counter[str] = Counter()
        self._groups: dict[int, str] = {}
        self._rng = np.random.default_rng(0)

    def watch(self, rows: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
        """The rows as they come."""
        for row in rows:
            if row["status"] == "ok":
                self._choose(row)
                self._group(row)
            yield row

    def wall(self) -> dict[str, dict[str, Any]]:
        """The rows for the wall by key; one kind of room after the other takes its turn."""
        order = np.random.default_rng(0).permutation
        left = {kind: [rows[k] for k in order(len(rows))] for kind, rows in sorted(self._kept.items())}
        chosen: dict[str, dict[str, Any]] = {}
        while left and len(chosen) < self._most:
            for kind in list(left):
                row = left[kind].pop(0)
                chosen[row["key"]] = row
                if not left[kind]:
                    del left[kind]
        return dict(list(chosen.items())[: self._most])

    def _choose(self, row: dict[str, Any]) -> None:
        """Reservoir sampling within a kind of room."""
        kind = row.get("room_type") or ""
        kept = self._kept.setdefault(kind, [])
        self._seen[kind] += 1
        place = len(kept) if len(kept) < self._most else int(self._rng.integers(self._seen[kind]))
        if place < self._most:
            kept[place : place + 1] = [{name: row.get(name) for name in _SHOWN}]

    def _group(self, row: dict[str, Any]) -> None:
        group, key = row.get("near_duplicate_group"), row["key"]
        if group is None or len(self.pairs) == PAIRS:
            return
        first = self._groups.setdefault(group, key)
        if first != key and all(first != pair[0] for pair in self.pairs):
            self.pairs.append((first, key))


LAYOUTS = 16
"""How many layouts of a row group are read as scenes."""

CELLS = 24
"""Cells of a heat map along each side of a room."""

SCENES = 20000
"""How many scenes are read at most; of more, evenly chosen ones."""

_TOGETHER = 64  # scenes that are read at a time

MANY = 16
"""How often so many scenes there are when processes are worth their start."""


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
        relations: how many there are, by type and whether they are hard.
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
    relations: Counter[tuple[str, bool]] = field(default_factory=Counter)
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
            self.relations[relation["type"], bool(relation.get("hard", True))] += 1
        if scene.get("palette"):
            self.palettes[scene["palette"]["name"]] += 1
        outline = scene["room"]["outline"]
        signature = shell_signature(outline)
        self.shells[signature] = (outline, self.shells.get(signature, (outline, 0))[1] + 1)
        self._heat(scene)

    def take_over(self, other: Gathered) -> None:
        """Add what was gathered of scenes that follow."""
        self.plans = other.plans | self.plans
        for category, cells in other.heat.items():
            self.heat[category] = self.heat[category] + cells if category in self.heat else cells
        for name in ("together", "present", "palettes", "relations"):
            getattr(self, name).update(getattr(other, name))
        for signature, (outline, count) in other.shells.items():
            self.shells[signature] = (outline, self.shells.get(signature, (outline, 0))[1] + count)
        self.read += other.read

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


def gather(folder: Folder, product: str = "scenes", *, pictures: int = PICTURES, workers: int = 1) -> Gathered:
    """Gather all that the report shows of rows and scenes; of layouts, a row is a program.

    Args:
        folder: the data set.
        product: "scenes" or "layouts".
        pictures: scenes that are drawn, at most.
        workers: processes that read scenes, where there are many.

    Raises:
        InputError: its files are damaged, or not those of a data set.
    """
    with of_others(folder):
        return _gather(folder, product, pictures, workers)


def _gather(folder: Folder, product: str, pictures: int, workers: int) -> Gathered:
    sampler, layouts = Sampler(pictures), product == "layouts"
    numbers = statistics(sampler.watch(program_rows(folder) if layouts else rows_of(folder)))
    if layouts:
        numbers["bytes"] = sum(path.stat().st_size for path in layout_files(folder))
    found = Gathered(numbers, sampler.wall(), sampler.pairs)
    drawn = {*found.wall, *(key for pair in found.pairs for key in pair)}
    step = max(1, math.ceil(numbers["scenes"] / SCENES))
    if layouts:
        _look_at(found, enumerate(program_layouts(folder)), step, drawn)
        return found
    tasks = list(_tasks(folder, step, drawn))
    if workers == 1 or len(tasks) < MANY:
        for task in tasks:
            found.take_over(_gathered(task))
    else:
        with pool(workers) as processes:
            for part in processes.map(_gathered, tasks, chunksize=4):
                found.take_over(part)
    return found


def _gathered(task: tuple[Span, int, int, frozenset[str]]) -> Gathered:
    """What is gathered of the scenes of a span: it, the number of its first scene, the step, and who is drawn."""
    span, first, step, drawn = task
    found, scenes = Gathered({}, {}, []), scenes_of(span, ("scene.json",))
    _look_at(
        found, ((k, (key, files.get("scene.json", b""))) for k, (key, files) in enumerate(scenes, first)), step, drawn
    )
    return found


def _tasks(folder: Folder, step: int, drawn: Collection[str]) -> Iterator[tuple[Span, int, int, frozenset[str]]]:
    first = 0
    for shard in shards_of(folder):
        for span in spans_of(shard, _TOGETHER):
            yield span, first, step, frozenset(drawn).intersection(span.keys)
            first += len(span.keys)


def _look_at(
    found: Gathered, scenes: Iterable[tuple[int, tuple[str, str | bytes]]], step: int, drawn: Collection[str]
) -> None:
    """Gather every so-manieth of some numbered scenes, and draw those that are shown."""
    for number, (key, content) in scenes:
        if number % step and key not in drawn:
            continue
        try:
            scene = parse_json(content)
            if key in drawn and key not in found.plans:
                found.plans[key] = plan(scene)
            if number % step == 0:
                found.add(scene)
        except (ValueError, ArithmeticError, LookupError, TypeError, AttributeError) as error:
            line = f"{key}: its scene.json is damaged ({reason(error)}); see: sceneweaver dataset verify"
            raise InputError(line) from None


def program_rows(folder: Folder) -> Iterator[dict[str, Any]]:
    """The programs as rows like those of scenes, with ``key``; without the scene itself."""
    for row in programs_of(folder):
        row["key"] = _program_key(row["program"])
        row["index"] = row["room"] = row["program"]
        row["bytes"] = None
        del row["scene"]
        yield row


def program_layouts(folder: Folder) -> Iterator[tuple[str, str]]:
    """Key of the program and JSON of the scene of some layouts of each."""
    scenes = {row["program"]: row["scene"] for row in programs_of(folder) if row.get("scene")}
    for path in layout_files(folder):
        with open_table(path) as file:
            for number in range(file.metadata.num_row_groups):
                table = file.read_row_group(number, columns=["program", "poses"])
                rows = np.unique(np.linspace(0, len(table) - 1, min(LAYOUTS, len(table))).astype(int))
                for row in table.take(rows).to_pylist():
                    if row["program"] in scenes:
                        yield _program_key(row["program"]), _posed(scenes[row["program"]], row["poses"])


def _posed(text: str, poses: list[float]) -> str:
    scene = parse_json(text)
    for obj, (x, y, z, yaw) in zip(scene["objects"], np.reshape(poses, (-1, 4)).tolist(), strict=False):
        if not obj.get("fixed"):
            obj["pose"] = {"position": [x, y, z], "quaternion": list(from_yaw(yaw))}
    return json.dumps(scene)


def _program_key(program: int) -> str:
    return f"{program:08d}"


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
