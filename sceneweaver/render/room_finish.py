"""What floors, walls and what is in them are drawn with."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.assets.body import Material
from sceneweaver.assets.room_looks import FLOORS, RoomLooks, room_looks
from sceneweaver.scene import RoomFinish, Scene


@dataclass(frozen=True)
class Finishes:
    """Materials of the shell. ``looks`` are those of floor and walls, ``plan`` says where accents and tiles are."""

    looks: RoomLooks
    plan: RoomFinish
    outside: Material = Material("wall outside", (0.88, 0.87, 0.85), roughness=0.95)
    cut: Material = Material("wall cut", (0.83, 0.82, 0.80), roughness=0.9)
    ceiling: Material = Material("ceiling", (0.955, 0.952, 0.945), roughness=0.95)
    trim: Material = Material("trim", (0.95, 0.945, 0.93), roughness=0.55)
    leaf: Material = Material("door leaf", (0.73, 0.57, 0.41), roughness=0.5, texture="oak")
    metal: Material = Material("door handle", (0.74, 0.74, 0.75), roughness=0.3, metallic=1.0)
    glass: Material = Material("pane", (0.82, 0.92, 0.97), roughness=0.06, opacity=0.12)
    daylight: Material = Material("daylight", (0.96, 0.985, 1.0), roughness=1.0, emission=0.9)

    def accented(self, wall: int) -> str | None:
        """How a wall is done that is an accent, if it is one."""
        accent = self.plan.accent
        return accent.kind if accent is not None and wall in accent.walls else None

    def tiled(self, wall: int) -> tuple[float, float] | None:
        """Heights [m] between which a wall is tiled, if it is."""
        tiles = self.plan.tiles
        if tiles is None or (tiles.walls is not None and wall not in tiles.walls):
            return None
        return tiles.low, tiles.high

    def wall(self, wall: int) -> Material:
        """The paint of a wall."""
        whole = self.accented(wall) in ("paint", "paper") and self.looks.accent
        return whole or self.looks.wall


def finishes_of(scene: Scene, cut: tuple[float, float, float] | None = None) -> Finishes:
    """The finishes of a scene's room; ``cut`` is the sRGB colour of walls where they are cut.

    Raises:
        InputError: for a colour or a wood of ``room.finish`` that nobody knows.
    """
    looks = room_looks(scene.room)
    more = {} if cut is None else {"cut": Material("wall cut", cut, roughness=0.9)}
    return Finishes(looks, scene.room.finish or RoomFinish(), **more)


__all__ = ["FLOORS", "Finishes", "finishes_of"]
