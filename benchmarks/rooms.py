"""The zoo: rooms that each come with a valid layout, their witness."""

from __future__ import annotations

from functools import cache

import numpy as np

from benchmarks.settings import ROOT, Settings
from sceneweaver.scene import Scene

ZOO = ROOT / "tests" / "zoo"

SMALL = (
    "bedroom-small",
    "bedroom",
    "children-twin",
    "living",
    "living-dining-L",
    "dining-round",
    "studio-U",
    "lockers-wall-full",
    "bedroom-tight",
    "bedroom-full-wall",
)
MIDDLE = ("office-20", "office-dense", "gym-30", "restaurant-60", "restaurant-dense")
LARGE = ("library-100", "hall-300")
ROOMS = (*SMALL, *MIDDLE, *LARGE)


@cache
def load(name: str) -> Scene:
    """A room of the zoo."""
    return Scene.load(ZOO / f"{name}.json")


def witness(scene: Scene) -> np.ndarray:
    """The scene's own poses (x, y, z, yaw) [N, 4]."""
    return np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects], dtype=np.float64).reshape(-1, 4)


def by_size(name: str, small: int, middle: int, large: int) -> int:
    """One of three numbers, by the size of the room."""
    return small if name in SMALL else middle if name in MIDDLE else large


def candidates(settings: Settings, name: str) -> int:
    """Candidates a call: 1,024 for small rooms, 256 for middle, 32 for large ones."""
    return settings.size(by_size(name, 1024, 256, 32), by_size(name, 64, 16, 4))


def chosen(settings: Settings, usual: tuple[str, ...]) -> tuple[str, ...]:
    """The rooms asked for, else all of them or the usual ones."""
    return settings.rooms or (ROOMS if settings.everything else usual)
