"""What gym machines and weights share: discs, weight plates, barbells, consoles."""

from __future__ import annotations

from ...drawing import Box, Drawing, Look, Vec3
from ...drawing.box import Axis

FRAMES = "black steel, white steel, red paint, grey paint, yellow paint"
_PLATES = (
    ("black plastic",) * 4,
    ("red plastic", "blue plastic", "yellow plastic", "green plastic"),
    ("rubber", "rubber", "grey plastic", "grey plastic"),
)


def disc(
    d: Drawing, at: Vec3, radius: float, thick: float, look: Look, axis: Axis = "y", bevel: float = 0.0, sides: int = 24
) -> None:
    """A wheel, a weight or a cover centred at a point, its axle along an axis."""
    size = [thick if own == axis else 2 * radius for own in "xyz"]
    d.cylinder(Box.around(at, *size), look, axis, bevel=bevel, segments=sides)


def plate(d: Drawing, at: Vec3, radius: float, thick: float, look: Look) -> None:
    """A weight plate on a peg along y: a thick rim, a sunk web, a steel hub."""
    disc(d, at, radius, thick, look, bevel=min(0.006, 0.3 * thick), sides=28)
    with d.no_colliders():
        disc(d, at, 0.72 * radius, thick + 0.0003, "black plastic", sides=24)
        disc(d, at, 0.62 * radius, thick + 0.0006, look, sides=24)
    disc(d, at, 0.26 * radius, thick + 0.008, "steel", bevel=0.002, sides=16)


def plates(d: Drawing, count: int) -> list[str]:
    """Finishes of so many plates of a set, the largest first."""
    return list(d.pick("plates", _PLATES)[:count])


def barbell(d: Drawing, x: float, z: float, length: float, looks: list[str], radius: float = 0.2) -> None:
    """A bar along y with plates of these finishes at each end, the largest inside."""
    d.bar((x, -length / 2, z), (x, length / 2, z), 0.014, "steel")
    inner = 0.33 * length
    with d.mirror("y"):
        d.bar((x, inner, z), (x, length / 2, z), 0.024, "chrome", segments=12)
        disc(d, (x, inner + 0.012, z), 0.035, 0.02, "chrome", sides=14)
        for k, look in enumerate(looks):
            plate(d, (x, inner + 0.05 + 0.044 * k, z), radius * (1 - 0.17 * k), 0.04, look)


def dumbbell(d: Drawing, size: float, look: Look) -> None:
    """A dumbbell along y about the frame's origin, with hexagonal heads."""
    grip = 0.21 * size
    d.bar((0.0, -grip, 0.0), (0.0, grip, 0.0), 0.05 * size, "steel")
    with d.mirror("y"):
        disc(d, (0.0, (grip + size / 2) / 2, 0.0), 0.23 * size, size / 2 - grip, look, bevel=0.03 * size, sides=6)


def console(d: Drawing, at: Vec3, wide: float, tall: float) -> None:
    """A console that leans toward the user behind it, with a screen and keys."""
    with d.at(*at, pitch=0.45):
        panel = d.box(Box((-0.02, 0.045), (-wide / 2, wide / 2), (0.0, tall)), "black plastic", 0.012)
        d.print(panel.back(0.0).share(y=(0.15, 0.85), z=(0.3, 0.9)), "screen")
        for key in panel.back(0.0).share(y=(0.18, 0.82), z=(0.1, 0.2)).columns(5, gap=0.012):
            d.print(key, "grey plastic")
