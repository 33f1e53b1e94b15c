"""Pictures from inside a room: the light is cast on its objects and on the room around them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .camera import Camera
from .caster import Instance, Quality, cast
from .glow import glowing
from .interior import Element
from .room_light import inside_light


def draw_inside(
    things: Sequence[Instance],
    room: Sequence[Element],
    camera: Camera,
    width: int,
    height: int,
    quality: Quality | None = None,
    device: str = "cpu",
) -> np.ndarray:
    """A picture, uint8 [height, width, 3], of objects and of the parts of their room."""
    parts = [Instance(part.mesh, np.eye(4)) for part in room]
    drawn = cast(
        [*things, *parts],
        camera,
        width,
        height,
        lighting=inside_light(things),
        quality=quality or Quality.normal(),
        device=device,
    )
    return glowing(drawn, len(things))
