"""Rooms in ManiSkill 3: each parallel environment of SAPIEN has a room of its own.

ManiSkill is no dependency: ``pip install mani_skill``. Rooms are folders with ``scene.urdf.json``, as
``sceneweaver export scene.json -o FOLDER --to urdf`` writes them.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sceneweaver.io import load_json
from sceneweaver.scene import InputError, MissingDependencyError

ENV_ID = "SceneWeaverRoom-v1"


def room_files(folder: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """What stands in an exported room: ``file`` (absolute), ``position`` [3], ``quaternion`` (x, y, z, w), ``fixed``.

    Raises:
        InputError: there is no such room.
    """
    path = Path(folder) / "scene.urdf.json"
    if not path.is_file():
        raise InputError(
            f"rooms: {path} is not there; write it with: sceneweaver export scene.json -o FOLDER --to urdf"
        )
    rows = load_json(path)["robots"]
    return [row | {"file": str(path.parent.resolve() / row["file"])} for row in rows]


def register(rooms: Sequence[str | os.PathLike[str]], env_id: str = ENV_ID) -> str:
    """Register an environment of ManiSkill whose parallel environments take these rooms in turn.

    Objects are in ``env.objects[k]`` by name for environment k, as actors or articulations of SAPIEN; tasks, rewards
    and observations are for subclasses, or for wrappers, to say.

    Args:
        rooms: Folders of exported rooms.
        env_id: Its name for ``gymnasium.make``.

    Returns:
        ``env_id``.

    Raises:
        InputError: a room is not there.
        MissingDependencyError: ManiSkill is not installed.
    """
    try:
        import sapien  # type: ignore[import-not-found]
        from mani_skill.envs.sapien_env import BaseEnv  # type: ignore[import-not-found]
        from mani_skill.utils.building.ground import build_ground  # type: ignore[import-not-found]
        from mani_skill.utils.registration import register_env  # type: ignore[import-not-found]
    except ImportError:
        raise MissingDependencyError("ManiSkill is not installed; pip install mani_skill") from None
    listed = [room_files(room) for room in rooms]
    if not listed:
        raise InputError("rooms: none is given; give at least one folder")

    @register_env(env_id, max_episode_steps=500, override=True)
    class RoomEnv(BaseEnv):
        """Parallel rooms with one robot."""

        SUPPORTED_ROBOTS = ("panda", "fetch")
        SUPPORTED_REWARD_MODES = ("none",)

        def __init__(self, *args: Any, robot_uids: str = "fetch", **options: Any) -> None:
            self.objects: list[dict[str, Any]] = []
            super().__init__(*args, robot_uids=robot_uids, reward_mode="none", **options)

        def _load_agent(self, options: dict[str, Any]) -> None:
            super()._load_agent(options, sapien.Pose(p=[0.0, 0.0, 5.0]))  # out of the way while rooms are built

        def _load_scene(self, options: dict[str, Any]) -> None:
            build_ground(self.scene)
            self.objects = [self._load_room(k, listed[k % len(listed)]) for k in range(self.num_envs)]

        def _load_room(self, k: int, rows: list[dict[str, Any]]) -> dict[str, Any]:
            found = {}
            for row in rows:
                loader = self.scene.create_urdf_loader()
                loader.fix_root_link = row["fixed"]
                loader.name = f"{row['name']}-{k}"
                parsed = loader.parse(row["file"])
                articulated = bool(parsed["articulation_builders"])
                builder = (parsed["articulation_builders"] or parsed["actor_builders"])[0]
                x, y, z, w = row["quaternion"]
                builder.initial_pose = sapien.Pose(p=row["position"], q=[w, x, y, z])
                builder.set_scene_idxs([k])
                # Rugs and mats are written without collision parts, as what stands over them shares their layer.
                still = not articulated and (row["fixed"] or not builder.collision_records)
                found[row["name"]] = (builder.build_kinematic if still else builder.build)(name=loader.name)
            return found

        def _initialize_episode(self, env_idx: Any, options: dict[str, Any]) -> None:
            spawn = options.get("base", (0.6, 0.6, 0.0))
            self.agent.robot.set_pose(sapien.Pose(p=spawn))

        def evaluate(self) -> dict[str, Any]:
            return {}

        def _get_obs_extra(self, info: dict[str, Any]) -> dict[str, Any]:
            return {}

    return env_id
