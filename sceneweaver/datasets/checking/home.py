"""One home of a data set judged again: its files against each other, against the judges and against its row."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from sceneweaver.export.home.names import HomeNames
from sceneweaver.home import Home
from sceneweaver.io import InputError, parse_json, write_atomic
from sceneweaver.language.homes import read_home
from sceneweaver.navigation import EpisodeSet, Roadmap, load_episodes
from sceneweaver.plans import PlanReport, Programme, check_plan
from sceneweaver.verify.home import HomeReport, Ways, check_home

from ..homes.files import home_columns, map_files, report_columns
from ..spec import Homes
from .findings import Findings
from .scene import APART, Judge

LONGER = 1e-3
"""How far [m] the shortest way of an episode may be from what is recorded: rounding of its ends."""

_CLOSE = {"area": 0.01, "walkable_share": 1e-3, "reachable_share": 1e-6}
_EPISODES = ("pointnav.json.gz", "objectnav.json.gz")


@dataclass
class HomeJudge(Judge):
    """Judges the homes of a data set, one by one.

    Attributes:
        homes: how they were made.
    """

    homes: Homes = Homes()

    def judge(self, row: Mapping[str, Any], files: Mapping[str, bytes], found: Findings) -> None:
        """Judge a home; faults and counts go to ``found``."""
        key = row["key"]
        found.counts["judged"] += 1
        try:
            home = Home.loads(files["home.json"].decode())
        except KeyError:
            return found.fault("content", key, "has no home.json")
        except (InputError, UnicodeDecodeError) as error:
            return found.fault("judge", key, f"home.json: {error}")
        report = check_home(home, self._plan(row, home), robot_radius=self.homes.radius)
        for room in home.rooms:
            if room.scene is not None:
                found.judged(key, room.scene, report.rooms[room.id])
        for violation in report.violations:
            found.fault("judge", key, violation.detail)
        for line in (*_differences(row, home, report), *_metrics(files.get("metrics.json"), report)):
            found.fault("record", key, line)
        for line in (*_rooms(home, files), *self._navigation(home, files)):
            found.fault("record", key, line)
        self.exports(row, files, found, lambda frames: _misplaced(home, frames))
        return None

    def _plan(self, row: Mapping[str, Any], home: Home) -> PlanReport:
        """The exact checker's word on its plan, as it was asked for."""
        programme = Programme.example(row["kind"]) if row.get("kind") else read_home(row["prompt"]).programme
        return check_plan(home, programme, self.homes.profile)

    def _navigation(self, home: Home, files: Mapping[str, bytes]) -> Iterator[str]:
        """Lines about maps that are not those of the home, and episodes whose ways are not the shortest."""
        ways = Ways.of(home, radius=self.homes.radius)
        for name, content in map_files(home, self.homes.resolution, ways).items():
            if files.get(name) != content:
                yield f"{name} is not the map of home.json" if name in files else f"has no {name}"
        roadmap = Roadmap(home, self.homes.radius, stairs=False, ways=ways)
        for name in _EPISODES:
            if name not in files:
                yield f"has no {name}"
                continue
            with TemporaryDirectory() as folder:
                path = Path(folder) / name
                write_atomic(path, files[name])
                try:
                    episodes = load_episodes(path)
                except InputError as error:
                    yield str(error).removeprefix(f"{folder}/")
                    continue
            yield from _longer(name, episodes, roadmap)


def _longer(name: str, episodes: EpisodeSet, roadmap: Roadmap) -> Iterator[str]:
    """Lines about episodes whose way is not the shortest, or that begin or end where the base cannot be."""
    for one in episodes.episodes:
        try:
            goals = [one.goal]
            if one.category is not None:
                goals = [view for goal in episodes.goals[one.category] for view, _ in goal.views]
            length = roadmap.to(goals).distance(one.start)
        except (InputError, KeyError) as error:
            yield f"{name}: episode {one.id}: {error}"
            continue
        if not abs(length - one.geodesic) <= LONGER:
            yield f"{name}: episode {one.id} is {length:.3f} m long, not {one.geodesic:.3f} m"


def _rooms(home: Home, files: Mapping[str, bytes]) -> Iterator[str]:
    """Lines about scenes of rooms that are not those of the home."""
    for number, room in enumerate(home.rooms):
        name = f"room-{number:02d}.scene.json"
        if room.scene is None:
            if name in files:
                yield f"{name} is there, and {room.id} is empty"
        elif name not in files:
            yield f"has no {name}"
        elif parse_json(files[name]) != room.scene.to_json():
            yield f"{name} is not the scene of {room.id} in home.json"


def _differences(row: Mapping[str, Any], home: Home, report: HomeReport) -> Iterator[str]:
    """Lines about columns of a row that are not what the home is. Columns that are null say nothing."""
    for name, value in (home_columns(home) | report_columns(report)).items():
        said = row.get(name)
        if said is None or value is None:
            continue
        close = math.isclose(said, value, rel_tol=1e-6, abs_tol=_CLOSE[name]) if name in _CLOSE else said == value
        if not close:
            yield f"{name} is {value!r}; the index says {said!r}"


def _metrics(content: bytes | None, report: HomeReport) -> Iterator[str]:
    """Lines about ``metrics.json`` where it is not what is measured."""
    if content is None:
        return
    try:
        said = parse_json(content)
        for name, value in (("valid", report.valid), ("counts", report.counts)):
            if said[name] != value:
                yield f"{name} is {value!r}; metrics.json says {said[name]!r}"
    except (KeyError, TypeError, ValueError) as error:
        yield f"metrics.json: {error}"


def _misplaced(home: Home, frames: Mapping[str, np.ndarray]) -> Iterator[str]:
    """Lines about objects that a file has elsewhere than the home, or not at all."""
    names = HomeNames.of(home).things
    for room in home.rooms:
        height = home.storey_of(room.id).elevation
        for obj in room.scene.objects if room.scene is not None else ():
            name = names[room.id][obj.id]
            if name not in frames:
                yield f"{name} is missing"
                continue
            far = float(np.linalg.norm(frames[name][:3, 3] - (np.array(obj.pose.position) + (0, 0, height))))
            if not far <= APART:
                yield f"{name} is {far:.3f} m away from its pose in home.json"
