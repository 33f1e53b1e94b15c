"""Pictures from inside a room, with the light of the real world on its objects and on the room around them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from PIL import Image

from sceneweaver.assets import Asset
from sceneweaver.scene import Scene

from .camera import Camera
from .caster import Instance, Quality
from .eye_camera import eye_cameras
from .interior import Element, build_interior
from .room_bodies import instances_of
from .room_finish import finishes_of
from .tracing import TracedPicture, TraceQuality, Tracer, interior_lights

_DRAFT, _FINE = 3, 10  # rays a pixel up to which, and from which on, a quality of the ray caster is a draft or fine


class Inside:
    """A furnished room, ready for any number of cameras in it.

    Attributes:
        parts: The room around the furniture.
        instances: What is drawn: the objects of the scene in their order, then ``parts``.
    """

    def __init__(
        self, scene: Scene, things: Sequence[Instance], cameras: Sequence[Camera], device: str = "cpu"
    ) -> None:
        """Build the room; a door in which one of the cameras stands is open."""
        self.parts: list[Element] = build_interior(scene, finishes_of(scene), cameras)
        self.instances = [*things, *(Instance(part.mesh, np.eye(4)) for part in self.parts)]
        self._scene, self._device = scene, device
        self._tracer: Tracer | None = None

    def picture(self, camera: Camera, width: int, height: int, quality: Quality | None = None) -> TracedPicture:
        """What a camera sees."""
        if self._tracer is None:  # most of the light is shared by all cameras
            self._tracer = Tracer(self.instances, interior_lights(self._scene), self._device)
        return self._tracer.picture(camera, width, height, _traced(quality))


class EyeLevel:
    """The pictures of a room at eye level, one by one; what they share is worked out once.

    Attributes:
        cameras: The camera of each of `EYE_VIEWS`.
    """

    def __init__(
        self,
        scene: Scene,
        load: Callable[[str], Asset] | None = None,
        aspect: float = 4 / 3,
        device: str = "cpu",
    ) -> None:
        """Choose the cameras; ``load`` gives the asset of an id, ``aspect`` is width over height."""
        self.cameras = eye_cameras(scene, aspect)
        self._inside = Inside(scene, instances_of(scene, load), list(self.cameras.values()), device)

    def draw(self, view: str, width: int, height: int, quality: Quality | None = None) -> Image.Image:
        """One of the pictures, in any size of that aspect."""
        return Image.fromarray(self._inside.picture(self.cameras[view], width, height, quality).rgb)


def _traced(quality: Quality | None) -> TraceQuality:
    """The like of a quality of the ray caster."""
    if quality is None or _DRAFT < quality.rays < _FINE:
        return TraceQuality.normal()
    return TraceQuality.draft() if quality.rays <= _DRAFT else TraceQuality.fine()
