"""Rooms and homes as environments for robots, for Gymnasium. It needs the extra ``envs``.

`make` gives a room over MuJoCo; ``gymnasium.make("sceneweaver/Room-v0", scenes=...)`` does the same once this module is
imported. `HomeEnv`, or ``gymnasium.make("sceneweaver/Home-v0", homes=...)``, is a whole home for navigation.
"""

from typing import Any

from .env import RoomEnv as RoomEnv
from .geometry import SceneGeometry as SceneGeometry
from .homes import HomeEnv as HomeEnv
from .layouts import layouts_of as layouts_of
from .layouts import poses_of as poses_of
from .navigation import FloorMap as FloorMap
from .reach import ReachReport as ReachReport
from .reach import reach_of as reach_of
from .robots import Robot as Robot
from .robots import fixed_arm as fixed_arm
from .robots import mobile_manipulator as mobile_manipulator
from .sampling import tasks_of as tasks_of
from .tasks import Close as Close
from .tasks import NavigateTo as NavigateTo
from .tasks import Open as Open
from .tasks import PutIn as PutIn
from .tasks import PutOn as PutOn
from .tasks import Take as Take
from .tasks import Task as Task
from .tasks import Tidy as Tidy
from .world import RoomState as RoomState
from .world import World as World

__all__ = [
    "Close",
    "FloorMap",
    "HomeEnv",
    "NavigateTo",
    "Open",
    "PutIn",
    "PutOn",
    "ReachReport",
    "Robot",
    "RoomEnv",
    "RoomState",
    "SceneGeometry",
    "Take",
    "Task",
    "Tidy",
    "World",
    "fixed_arm",
    "layouts_of",
    "make",
    "mobile_manipulator",
    "poses_of",
    "reach_of",
    "tasks_of",
]


def make(scenes: Any, task: str | Task | None = None, **options: Any) -> RoomEnv:
    """An environment; arguments are those of `RoomEnv`.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> env = envs.make(sw.Scene.example("bedroom"), seed=0)
        >>> observation, info = env.reset()
        >>> info["success"]
        False
    """
    return RoomEnv(scenes, task, **options)


def _register() -> None:
    import gymnasium

    if "sceneweaver/Room-v0" not in gymnasium.registry:
        gymnasium.register("sceneweaver/Room-v0", entry_point="sceneweaver.envs.env:RoomEnv")
    if "sceneweaver/Home-v0" not in gymnasium.registry:
        gymnasium.register("sceneweaver/Home-v0", entry_point="sceneweaver.envs.homes:HomeEnv")


_register()
