"""Rooms in Isaac Lab 2: each of many environments has a room of its own.

Isaac Lab is no dependency, and runs inside Isaac Sim only. Rooms are USD stages, as ``sceneweaver export`` writes
them; their default prim is the room, so that a reference to it leaves their physics scene behind. Run it with
``isaaclab.sh -p -m sceneweaver.envs.adapters.isaac_lab room-0/scene.usdc room-1/scene.usdc --num_envs 64``.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sceneweaver.scene import InputError, MissingDependencyError

SPACING = 12.0
"""Distance [m] between environments; more than rooms are wide."""


def scene_cfg(rooms: Sequence[str | os.PathLike[str]], num_envs: int, spacing: float = SPACING) -> Any:
    """An ``InteractiveSceneCfg`` with a room, a light and a Franka arm in each environment.

    Rooms differ, so physics is not replicated from the first environment. Doors and drawers are joints below
    ``{ENV_REGEX_NS}/Room``.

    Args:
        rooms: USD files; environments take them in turn.
        num_envs: How many environments.
        spacing: See ``SPACING``.

    Raises:
        InputError: a file is not there.
        MissingDependencyError: Isaac Lab is not there, or its app is not started.
    """
    files = [str(Path(room).resolve()) for room in rooms]
    missing = [file for file in files if not Path(file).is_file()]
    if missing or not files:
        raise InputError(f"rooms: {missing[0] if missing else 'none'} is not there; give USD files")
    try:
        import isaaclab.sim as sim_utils  # type: ignore[import-not-found]
        from isaaclab.assets import AssetBaseCfg  # type: ignore[import-not-found]
        from isaaclab.scene import InteractiveSceneCfg  # type: ignore[import-not-found]
        from isaaclab.utils import configclass  # type: ignore[import-not-found]
        from isaaclab_assets import FRANKA_PANDA_HIGH_PD_CFG  # type: ignore[import-not-found]
    except ImportError:
        raise MissingDependencyError("Isaac Lab is not there; run this inside it, with its app started") from None

    @configclass
    class RoomSceneCfg(InteractiveSceneCfg):
        """Rooms side by side."""

        room = AssetBaseCfg(
            prim_path="{ENV_REGEX_NS}/Room",
            spawn=sim_utils.MultiUsdFileCfg(usd_path=files, random_choice=False),
        )
        light = AssetBaseCfg(prim_path="/World/Light", spawn=sim_utils.DomeLightCfg(intensity=1500.0))
        robot = FRANKA_PANDA_HIGH_PD_CFG.replace(prim_path="{ENV_REGEX_NS}/Robot")

    return RoomSceneCfg(num_envs=num_envs, env_spacing=spacing, replicate_physics=False)


def main() -> None:
    """Step rooms with a robot that holds its pose."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("rooms", nargs="+", help="USD files of rooms")
    parser.add_argument("--num_envs", type=int, default=16)
    parser.add_argument("--steps", type=int, default=1000)
    try:
        from isaaclab.app import AppLauncher  # type: ignore[import-not-found]
    except ImportError:
        raise MissingDependencyError("Isaac Lab is not there; run this with isaaclab.sh -p") from None
    AppLauncher.add_app_launcher_args(parser)
    options = parser.parse_args()
    app = AppLauncher(options).app

    import isaaclab.sim as sim_utils  # type: ignore[import-not-found]  # only once the app is there
    from isaaclab.scene import InteractiveScene  # type: ignore[import-not-found]

    sim = sim_utils.SimulationContext(sim_utils.SimulationCfg(dt=1 / 120, device=options.device))
    scene = InteractiveScene(scene_cfg(options.rooms, options.num_envs))
    sim.reset()
    robot = scene["robot"]
    for _ in range(options.steps):
        if not app.is_running():
            break
        robot.set_joint_position_target(robot.data.default_joint_pos)
        scene.write_data_to_sim()
        sim.step()
        scene.update(sim.get_physics_dt())
    app.close()


if __name__ == "__main__":
    main()
