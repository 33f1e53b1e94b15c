"""Whole homes as a Gymnasium environment for navigation: a round base that turns and goes, with a laser scan.

There is no simulator in it: the base is a disc that slides along what it meets, so that a step takes a fraction of a
millisecond. Episodes are those of `sceneweaver.navigation`, drawn here or read from Habitat's files.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from sceneweaver.home import Home
from sceneweaver.navigation import (
    Distances,
    Episode,
    EpisodeSet,
    Path,
    Roadmap,
    load_episodes,
    object_goal_episodes,
    occupancy_map,
    point_goal_episodes,
)
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError

try:
    import gymnasium
except ImportError:
    raise MissingDependencyError(missing_extra("envs", "gymnasium is not installed")) from None

Array = np.ndarray
Place = str | os.PathLike[str]

STOP, FORWARD, LEFT, RIGHT = range(4)
"""Actions, numbered as Habitat's."""

_KEPT = 8  # homes whose roadmaps are kept
_WIDEST = 1e6  # bound of numbers of observations that have none
_NEAR = 1e-6  # [m]
_AHEAD = 0.3  # [m] along the way at which the expert looks


class HomeEnv(gymnasium.Env):
    """A home, a round base and somewhere to go.

    Actions are Habitat's: 0 stop, 1 forward by ``step``, 2 and 3 left and right by ``turn``. What the base meets it
    slides along. An episode is a success when it stops within ``success`` of the goal, along the floor. Observations
    are a dict of float32 arrays:

    - ``scan`` [rays]: distance [m] from the middle of the base to walls and furniture, ray k at an angle of
      2 pi k / rays from where it looks, counter-clockwise; ``reach`` where there is nothing so near;
    - ``gps`` [2] and ``compass`` [1]: where it is and looks in the frame of its start [m, rad];
    - ``pointgoal`` [2]: distance [m] and angle [rad] to the goal from where it looks; for points alone;
    - ``objectgoal`` int64 [1]: the number of the kind of thing in ``categories``; for things alone.

    The reward is by how many metres the shortest way has become shorter, and 1 for a success. ``info`` has ``episode``,
    ``category``, ``distance_to_goal`` [m], ``collided``, ``success`` and ``spl`` (success weighted by path length,
    Anderson et al., 2018).

    Args:
        homes: a home, a path of one, or several; `reset` chooses.
        episodes: for each home its episodes, or a path of Habitat's ``.json.gz``; None: they are drawn.
        task: of drawn episodes, "pointnav" or "objectnav".
        count: of drawn episodes for each home.
        radius: of the base [m]; of given episodes it is theirs.
        step, turn: of an action [m, degrees].
        rays, reach: of the scan: how many, and how far they see [m].
        success: how near the goal has to be [m].
        max_steps: after which an episode is cut off.
        seed: of the first `reset` that has none, and of episodes that are drawn.
        render_mode: "rgb_array" or None: the map of the storey with the way that was gone.

    Raises:
        InputError: something of this is wrong, or a home has no episodes.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import HomeEnv
        >>> env = HomeEnv(sw.Home.example("flat"), count=4, seed=0)
        >>> observation, info = env.reset()
        >>> while not info["success"]:
        ...     observation, reward, terminated, truncated, info = env.step(env.expert_action())
        >>> terminated, info["spl"] > 0.8
        (True, True)
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    # Options of an environment are keyword arguments, as `gymnasium.make` hands them over by name, hence more than ten.
    def __init__(
        self,
        homes: Home | Place | Sequence[Home | Place],
        episodes: EpisodeSet | Place | Sequence[EpisodeSet | Place] | None = None,
        *,
        task: str = "pointnav",
        count: int = 50,
        radius: float = 0.25,
        step: float = 0.25,
        turn: float = 30.0,
        rays: int = 64,
        reach: float = 5.0,
        success: float = 0.25,
        max_steps: int = 500,
        seed: int | None = None,
        render_mode: str | None = None,
    ) -> None:
        """Load the homes, and draw or load their episodes."""
        listed = [homes] if isinstance(homes, Home | str | os.PathLike) else list(homes)
        if not listed:
            raise InputError("homes: none is given; give at least one")
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise InputError(f"render_mode: '{render_mode}' is not known; use rgb_array or None")
        if task not in ("pointnav", "objectnav"):
            raise InputError(f"task: '{task}' is not known; use pointnav or objectnav")
        for name, value in (("step", step), ("turn", turn), ("rays", rays), ("reach", reach), ("success", success)):
            if not value > 0:
                raise InputError(f"{name} is {value}; give a number above 0")
        self.homes = tuple(one if isinstance(one, Home) else Home.load(one) for one in listed)
        self.step_length, self.turn, self.success, self.max_steps = step, math.radians(turn), success, max_steps
        self.rays, self.reach, self.render_mode = rays, reach, render_mode
        self._radius, self._first_seed = radius, seed
        self._roadmap = lru_cache(_KEPT)(self._make_roadmap)
        self._away = lru_cache(64)(self._make_distances)
        if episodes is None:
            draw = point_goal_episodes if task == "pointnav" else object_goal_episodes
            self.episodes = tuple(
                draw(home, count, seed or 0, roadmap=self._roadmap(k)) for k, home in enumerate(self.homes)
            )
        else:
            given = [episodes] if isinstance(episodes, EpisodeSet | str | os.PathLike) else list(episodes)
            self.episodes = tuple(
                one if isinstance(one, EpisodeSet) else load_episodes(os.fspath(one)) for one in given
            )
            if len(self.episodes) != len(self.homes):
                raise InputError(f"episodes: {len(self.episodes)} sets for {len(self.homes)} homes; give one for each")
            if len({(one.radius, one.task) for one in self.episodes}) > 1:
                raise InputError("episodes: they differ in task or radius; give those of one kind")
            self._radius = self.episodes[0].radius
        for home, some in zip(self.homes, self.episodes, strict=True):
            if not some.episodes:
                raise InputError(f"episodes: home '{home.id}' has none; ask for nearer goals, or furnish it")
        self.task = self.episodes[0].task
        self.categories = tuple(sorted({name for some in self.episodes for name in some.goals}))
        self.action_space = gymnasium.spaces.Discrete(4)
        self.observation_space = self._observation_space()

    def reset(self, *, seed: int | None = None, options: Mapping[str, Any] | None = None) -> tuple[dict, dict]:
        """Begin an episode.

        Args:
            seed: Of all that is random from now on; None: go on as before.
            options: ``home`` and ``episode``: their numbers.
        """
        if seed is None and self._first_seed is not None:
            seed, self._first_seed = self._first_seed, None
        super().reset(seed=seed)
        options = options or {}
        self.home_number = int(options.get("home", self.np_random.integers(len(self.homes))))
        some = self.episodes[self.home_number].episodes
        number = int(options.get("episode", self.np_random.integers(len(some))))
        self.episode: Episode = some[number]
        self.roadmap = self._roadmap(self.home_number)
        self.distances = self._away(self.home_number, number if self.task == "pointnav" else -1, self.episode.category)
        point, self._region = self.roadmap.region(self.episode.start, 0.1)
        self.position, self.yaw, self.height = point.copy(), self.episode.yaw, self.episode.start[2]
        self._walls = self._segments()
        self._left = self.distances.distance(self._at())
        self._shortest = max(self._left, _NEAR)
        self._gone, self._steps, self._trail = 0.0, 0, [self.position.copy()]
        return self._observe(), self._info(collided=False, success=False)

    def step(self, action: int | np.integer) -> tuple[dict, float, bool, bool, dict]:
        """Go on by one action."""
        number, collided = int(action), False
        if not 0 <= number < 4:
            raise InputError(f"action is {number}; give 0 stop, 1 forward, 2 left or 3 right")
        before = self._left
        if number == FORWARD:
            collided = self._forward()
            self._left = self.distances.distance(self._at())
        elif number in (LEFT, RIGHT):
            self.yaw = _wrapped(self.yaw + (self.turn if number == LEFT else -self.turn))
        self._steps += 1
        success = number == STOP and self._left <= self.success
        reward = before - self._left + float(success)
        truncated = self._steps >= self.max_steps and number != STOP
        return self._observe(), reward, number == STOP, truncated, self._info(collided=collided, success=success)

    def shortest_path(self) -> Path | None:
        """The shortest way from where the base is to the goal."""
        return self.distances.path(self._at())

    def expert_action(self) -> int:
        """What follows the shortest way: turn to the point a little ahead on it, go, and stop at its end."""
        path = self.shortest_path()
        if path is None or path.length <= self.success:
            return STOP
        turned = _wrapped(_direction(_along(path.points[:, :2], _AHEAD) - self.position) - self.yaw)
        if abs(turned) > self.turn / 2 + 1e-9:
            return LEFT if turned > 0 else RIGHT
        return FORWARD

    def render(self) -> Array | None:
        """The map of the storey, uint8 [H, W, 3], with the way that was gone (blue), the base (red), the goal (green);
        None without a render mode."""
        if self.render_mode is None:
            return None
        home = self.homes[self.home_number]
        storey = min(home.storeys, key=lambda s: abs(s.elevation - self.height)).id
        found = occupancy_map(home, storey, ways=self.roadmap.ways)
        picture = np.repeat(np.choose(found.occupancy.astype(int) % 255 // 100, [254, 0, 205])[..., None], 3, axis=2)
        picture = picture.astype(np.uint8)
        y, x = (found.origin[k] + (np.arange(found.occupancy.shape[1 - k]) + 0.5) * found.resolution for k in (1, 0))
        xs, ys = np.meshgrid(x, y)
        for points, colour, wide in (
            (np.array(self._trail), (60, 100, 220), 0.05),
            (np.array([self.episode.goal[:2]]), (40, 160, 60), 0.15),
            (self.position[None], (210, 50, 40), self._radius),
        ):
            for px, py in points:
                picture[(xs - px) ** 2 + (ys - py) ** 2 <= wide**2] = colour
        return picture[::-1].copy()

    def _make_roadmap(self, number: int) -> Roadmap:
        return Roadmap(self.homes[number], self._radius, stairs=False)

    def _make_distances(self, home: int, episode: int, category: str | None) -> Distances:
        some = self.episodes[home]
        if category is None:
            return self._roadmap(home).to([some.episodes[episode].goal], 0.1)
        views = [view for goal in some.goals[category] for view, _ in goal.views]
        return self._roadmap(home).to(views, 0.1)

    def _at(self) -> Array:
        return np.array([*self.position, self.height])

    def _segments(self) -> Array:
        """Walls and furniture [n, 2, 2] at the storey of the episode, from above."""
        import shapely

        home = self.homes[self.home_number]
        storey = min(home.storeys, key=lambda s: abs(s.elevation - self.height)).id
        parts = shapely.get_parts(self.roadmap.ways.floors[storey].ground)
        rings = [ring for part in parts for ring in (part.exterior, *part.interiors)]
        lines = [np.asarray(ring.coords) for ring in rings]
        return np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in lines])

    def _forward(self) -> bool:
        """Go on by a step; whether something was in the way, along which the base then slides."""
        target = self.position + self.step_length * np.array([math.cos(self.yaw), math.sin(self.yaw)])
        reached, collided = self.roadmap.slide(self._region, self.position, target)
        self._gone += float(np.linalg.norm(reached - self.position))
        self.position = reached
        self._trail.append(reached.copy())
        return collided

    def _scan(self) -> Array:
        """Distances [rays] to the nearest wall or thing along each ray."""
        angles = self.yaw + 2 * np.pi * np.arange(self.rays) / self.rays
        ray = np.stack([np.cos(angles), np.sin(angles)], axis=1)[:, None]
        start = self._walls[:, 0] - self.position
        along = self._walls[:, 1] - self._walls[:, 0]
        cross = ray[..., 0] * along[:, 1] - ray[..., 1] * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            far = (start[:, 0] * along[:, 1] - start[:, 1] * along[:, 0]) / cross
            share = (start[:, 0] * ray[..., 1] - start[:, 1] * ray[..., 0]) / cross
        hit = (np.abs(cross) > 1e-12) & (far >= 0) & (share >= -1e-9) & (share <= 1 + 1e-9)
        return np.minimum(np.where(hit, far, np.inf).min(axis=1), self.reach)

    def _observation_space(self) -> Any:
        box, spaces = gymnasium.spaces.Box, gymnasium.spaces
        found: dict[str, Any] = {
            "scan": box(0.0, self.reach, (self.rays,), np.float32),
            "gps": box(-_WIDEST, _WIDEST, (2,), np.float32),
            "compass": box(-np.float32(np.pi), np.float32(np.pi), (1,), np.float32),
        }
        if self.task == "pointnav":
            found["pointgoal"] = box(-_WIDEST, _WIDEST, (2,), np.float32)
        else:
            found["objectgoal"] = box(0, max(0, len(self.categories) - 1), (1,), np.int64)
        return spaces.Dict(found)

    def _observe(self) -> dict[str, Array]:
        start, look = np.asarray(self.episode.start[:2]), self.episode.yaw
        turn = np.array([[math.cos(look), math.sin(look)], [-math.sin(look), math.cos(look)]])
        found = {
            "scan": self._scan().astype(np.float32),
            "gps": (turn @ (self.position - start)).astype(np.float32),
            "compass": np.clip([_wrapped(self.yaw - look)], -np.pi, np.pi).astype(np.float32),
        }
        if self.task == "pointnav":
            step = np.asarray(self.episode.goal[:2]) - self.position
            angle = _wrapped(_direction(step) - self.yaw)
            found["pointgoal"] = np.array([np.linalg.norm(step), angle], dtype=np.float32)
        else:
            found["objectgoal"] = np.array([self.categories.index(str(self.episode.category))])
        return found

    def _info(self, *, collided: bool, success: bool) -> dict[str, Any]:
        return {
            "home": self.homes[self.home_number].id,
            "episode": self.episode.id,
            "category": self.episode.category,
            "distance_to_goal": self._left,
            "collided": collided,
            "success": success,
            "spl": float(success) * self._shortest / max(self._shortest, self._gone),
        }


def _direction(step: Array) -> float:
    return math.atan2(step[1], step[0])


def _wrapped(angle: float) -> float:
    return float((angle + np.pi) % (2 * np.pi) - np.pi)


def _along(points: Array, far: float) -> Array:
    """The point of a chain [K, 2] so far [m] from its beginning, or its end."""
    for a, b in zip(points[:-1], points[1:], strict=True):
        length = float(np.linalg.norm(b - a))
        if length >= far:
            return a + (b - a) * (far / length)
        far -= length
    return points[-1]
