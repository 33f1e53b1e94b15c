"""Pictures of a room with its robot by MuJoCo's renderer, which needs OpenGL (``MUJOCO_GL=egl`` or ``osmesa``)."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import MissingDependencyError

from .world import World

Array = np.ndarray


class Pictures:
    """Renders a world; the context of OpenGL is made with the first picture."""

    def __init__(self, world: World) -> None:
        """Pictures of a world."""
        self._world = world
        self._renderer: Any = None

    def overview(self, data: Any, size: tuple[int, int] = (480, 640)) -> Array:
        """The room from above at a slant, uint8 [H, W, 3]."""
        outline = np.asarray(self._world.scene.room.outline)
        middle = (*outline.mean(axis=0), 0.8)
        return self._picture(data, size, middle, 1.3 * float(np.ptp(outline, axis=0).max()), 45.0, -60.0)

    def mast(self, data: Any, size: tuple[int, int]) -> Array:
        """What a camera at the height of a head sees ahead and below, uint8 [H, W, 3]."""
        x, y, yaw = self._world.base(data)
        middle = (x + 0.8 * np.cos(yaw), y + 0.8 * np.sin(yaw), 1.0)
        return self._picture(data, size, middle, 1.0, float(np.degrees(yaw)), -35.0)

    def close(self) -> None:
        """Let go of the context."""
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None

    def _picture(self, data: Any, size: tuple[int, int], middle: Any, far: float, azimuth: float, up: float) -> Array:
        mujoco = load_mujoco()
        if self._renderer is None or (self._renderer.height, self._renderer.width) != tuple(size):
            self.close()
            try:
                self._renderer = mujoco.Renderer(self._world.model, *size)
            except Exception as error:  # whatever the driver says
                text = f"no OpenGL for pictures ({error}); set MUJOCO_GL to egl or osmesa"
                raise MissingDependencyError(text) from None
        camera = mujoco.MjvCamera()
        camera.lookat[:] = middle
        camera.distance, camera.azimuth, camera.elevation = far, azimuth, up
        self._renderer.update_scene(data, camera)
        return self._renderer.render()
