"""What every generator starts from."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.assets import Library
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Scene


@dataclass(frozen=True)
class Setup:
    """A request with its kind of room, the scene so far, where bodies come from, and the seed of all that is drawn."""

    brief: SceneGraph
    room_type: RoomType
    scene: Scene
    library: Library
    seed: int
