"""Episodes as Habitat keeps them: ``.json.gz`` for its PointNav-v1 and ObjectNav-v1 data sets.

Habitat has y up, and an agent that is not turned looks along -z: a point (x, y, z) of a home is (x, z, -y) there, as it
is in the GLB files of this library, and a yaw of 0, along +x, is a turn by -90 degrees about its y axis.
"""

from __future__ import annotations

import gzip
import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, load_packed_json, write_atomic
from sceneweaver.io.messages import path_name

from .episodes import Episode, EpisodeSet, Goal, Point, Task, rounded

SOURCE = "sceneweaver"
"""The key under which a file has what Habitat does not keep: the radius of the base and the home."""


def to_habitat(point: Sequence[float]) -> list[float]:
    """A point of a home [m] in Habitat's frame."""
    x, y, z = point
    return [x, z, -y + 0.0]


def from_habitat(point: Sequence[float]) -> Point:
    """A point of Habitat's frame in that of the home [m]."""
    x, y, z = (float(value) for value in point)
    return x, -z + 0.0, y


def rotation_of(yaw: float) -> list[float]:
    """The quaternion (x, y, z, w) of an agent in Habitat that looks along a yaw [rad] of the home."""
    half = (yaw - math.pi / 2) / 2
    return [0.0, math.sin(half), 0.0, math.cos(half)]


def yaw_of(rotation: Sequence[float]) -> float:
    """The yaw [rad] in the home of an agent with a quaternion (x, y, z, w) in Habitat, in (-pi, pi]."""
    _, y, _, w = (float(value) for value in rotation)
    angle = 2 * math.atan2(y, w) + math.pi / 2
    return math.atan2(math.sin(angle), math.cos(angle))


def write_episodes(episodes: EpisodeSet, scene: str | None = None) -> dict[str, Any]:
    """Episodes as the JSON of Habitat's data sets.

    Args:
        episodes: from `point_goal_episodes` or `object_goal_episodes`.
        scene: the path of the home's GLB, relative to the folder of scenes; None: its id with ``.glb``.
    """
    scene = f"{episodes.home}.glb" if scene is None else scene
    data: dict[str, Any] = {"episodes": [_episode(one, scene) for one in episodes.episodes]}
    if episodes.task == "objectnav":
        numbers = {name: k for k, name in enumerate(sorted(episodes.goals))}
        data |= {
            "goals_by_category": {
                f"{Path(scene).name}_{name}": [_goal(goal, k) for k, goal in enumerate(goals)]
                for name, goals in sorted(episodes.goals.items())
            },
            "category_to_task_category_id": numbers,
            "category_to_scene_annotation_category_id": numbers,
        }
    return {**data, SOURCE: {"home": episodes.home, "task": episodes.task, "radius": episodes.radius}}


def _episode(one: Episode, scene: str) -> dict[str, Any]:
    path = [{"position": to_habitat(p), "rotation": None, "action": None} for p in one.path]
    data: dict[str, Any] = {
        "episode_id": one.id,
        "scene_id": scene,
        "start_position": to_habitat(one.start),
        "start_rotation": rotation_of(one.yaw),
        "info": {"geodesic_distance": one.geodesic, "euclidean_distance": round(one.euclidean, 6)},
        "goals": [{"position": to_habitat(one.goal), "radius": None}],
        "start_room": None,
        "shortest_paths": [path],
    }
    if one.category is not None:
        data["info"]["closest_goal_object_id"] = one.object
        data |= {"goals": [], "object_category": one.category}
    return data


def _goal(goal: Goal, number: int) -> dict[str, Any]:
    return {
        "position": to_habitat(goal.position),
        "radius": None,
        "object_id": number,
        "object_name": goal.object,
        "object_category": goal.category,
        "room_id": None,
        "room_name": goal.room,
        "view_points": [
            {"agent_state": {"position": to_habitat(view), "rotation": rotation_of(yaw)}, "iou": None}
            for view, yaw in goal.views
        ],
    }


def packed_episodes(episodes: EpisodeSet, scene: str | None = None) -> bytes:
    """The content of a ``.json.gz``; equal episodes give equal bytes."""
    text = json.dumps(write_episodes(episodes, scene), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return gzip.compress(text.encode(), 9, mtime=0)


def save_episodes(episodes: EpisodeSet, path: str | Path, scene: str | None = None) -> None:
    """Write episodes as a ``.json.gz`` that Habitat's data sets read.

    Args:
        episodes: what is written.
        path: the file.
        scene: as in `write_episodes`.

    Raises:
        InputError: another ending, or the file cannot be written.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import load_episodes, point_goal_episodes, save_episodes
        >>> made = point_goal_episodes(sw.Home.example("flat"), count=2)
        >>> save_episodes(made, "flat.json.gz")
        >>> load_episodes("flat.json.gz") == made
        True
    """
    if not str(path).endswith(".json.gz"):
        raise InputError(f"{path_name(path)}: episodes are written as .json.gz; choose such a name")
    write_atomic(path, packed_episodes(episodes, scene))


def load_episodes(path: str | Path) -> EpisodeSet:
    """Read a ``.json.gz`` or ``.json`` of episodes.

    Raises:
        InputError: it cannot be read, or holds none; one line that names the file.
    """
    data = load_packed_json(path)
    try:
        return read_episodes(data)
    except InputError as error:
        raise InputError(f"{path_name(path)}: {error}") from None


def read_episodes(data: Any) -> EpisodeSet:
    """Episodes of the JSON of Habitat's data sets, those of others as well.

    Where nothing says a radius, it is Habitat's 0.18 m; ids of objects are as they are in the file.

    Raises:
        InputError: something is missing or of another kind.
    """
    try:
        about = data.get(SOURCE, {})
        goals: dict[str, list[Goal]] = {}
        for some in data.get("goals_by_category", {}).values():
            for goal in some:
                goals.setdefault(goal["object_category"], []).append(_read_goal(goal))
        episodes = [_read(one, goals) for one in data["episodes"]]
        first = data["episodes"][0]["scene_id"] if episodes else ""
        objects = "goals_by_category" in data
        task: Task = "objectnav" if objects else "pointnav"
        home = about.get("home", Path(first).name.split(".")[0])
        found = {name: tuple(some) for name, some in goals.items()}
        return EpisodeSet(str(home), task, float(about.get("radius", 0.18)), tuple(episodes), found)
    except (AttributeError, KeyError, TypeError, ValueError, IndexError) as error:
        raise InputError(f"no episodes of Habitat: {type(error).__name__}: {error}") from None


def _read_goal(goal: dict[str, Any]) -> Goal:
    states = [view["agent_state"] for view in goal["view_points"]]
    views = tuple((from_habitat(s["position"]), rounded(yaw_of(s["rotation"]))) for s in states)
    name = str(goal.get("object_name") or goal["object_id"])
    return Goal(name, goal["object_category"], str(goal.get("room_name") or ""), from_habitat(goal["position"]), views)


def _read(one: dict[str, Any], goals: dict[str, list[Goal]]) -> Episode:
    paths = one.get("shortest_paths") or []
    path = tuple(from_habitat(p["position"]) for p in paths[0] if p.get("position")) if paths else ()
    category = one.get("object_category")
    if category is None:
        goal, thing = from_habitat(one["goals"][0]["position"]), None
    else:
        named = one["info"].get("closest_goal_object_id")
        thing = None if named is None else str(named)
        chosen = next((g for g in goals[category] if g.object == thing), goals[category][0])
        goal = path[-1] if path else (chosen.views[0][0] if chosen.views else chosen.position)
    start = from_habitat(one["start_position"])
    geodesic = float(one["info"]["geodesic_distance"])
    yaw = rounded(yaw_of(one["start_rotation"]))
    return Episode(str(one["episode_id"]), start, yaw, goal, category, thing, geodesic, path)
