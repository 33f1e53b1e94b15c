"""Which layouts of a bank stay as they are while the robot does nothing."""

from __future__ import annotations

import numpy as np

from sceneweaver.envs.env import PERIOD
from sceneweaver.envs.robots import Robot
from sceneweaver.scene import InputError

from .bank import Bank
from .env import BatchedRoomEnv


def steady(
    bank: Bank,
    robot: str | Robot = "mobile",
    *,
    device: str = "auto",
    seconds: float = 1.0,
    far: float = 0.05,
    worlds: int = 256,
) -> Bank:
    """The bank without layouts in which a free body moves by itself.

    Boxes are coarser than the parts of assets, so that what just fits may be pushed away.

    Args:
        bank: Rooms and layouts.
        robot, device: As for `BatchedRoomEnv`.
        seconds: How long it is looked at.
        far: How far a body may move [m].
        worlds: So many layouts at once.

    Raises:
        InputError: no layout stays as it is.
    """
    worlds = min(worlds, bank.layouts)
    env = BatchedRoomEnv(bank, worlds, robot=robot, device=device)
    kept = np.zeros(bank.layouts, dtype=bool)
    for first in range(0, bank.layouts, worlds):
        rows = np.minimum(first + np.arange(worlds), bank.layouts - 1)
        start = env.reset(options={"layout": rows})[0]["objects"]
        env.action.zero_()
        for _ in range(max(round(seconds / PERIOD), 1)):
            env.step_device()
        end = env.observations["objects"].numpy()
        moved = np.linalg.norm(end[..., :3] - start[..., :3], axis=-1).max(axis=1, initial=0.0)
        kept[rows] = (moved <= far) & ~env.overflow()
    if not kept.any():
        raise InputError("bank: in every layout something moves by itself")
    return bank.keep(kept)
