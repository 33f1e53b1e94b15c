"""What seats share: bent shells and back rests."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ...drawing import Drawing, Interval, Look

WOODS = "oak, walnut, beech, light oak, white paint, black paint, birch, cherry"
COVERS = "@fabric, brown leather, tan leather, black leather"
PLASTICS = ", ".join(
    f"{color} plastic" for color in ("white", "black", "blue", "red", "green", "yellow", "orange", "grey")
)


def bent(rows: Sequence[Sequence[float]], power: float = 2.0, count: int = 7) -> np.ndarray:
    """A grid for a shell bent across: of each row x, z, half width, and how far its edges turn forward and up [m].

    Between its middle and its edges a row turns by the ``power`` of the share of its half width.
    """
    x, z, half, forward, up = np.asarray(rows, dtype=np.float64).T[:, :, None]
    share = np.linspace(-1.0, 1.0, count)
    bend = np.abs(share) ** power
    return np.stack([x + forward * bend, half * share, z + up * bend], axis=-1)


def arc_panel(
    d: Drawing,
    width: float,
    z: Interval,
    thickness: float,
    bulge: float,
    material: Look,
    lean: float = 0.0,
    narrow: float = 1.0,
    count: int = 9,
) -> None:
    """A back rest about the frame's origin, bent around the sitter.

    Args:
        d: The drawing.
        width: Of its foot [m].
        z: Heights of its foot and its top [m].
        thickness: Of the panel [m].
        bulge: How far its edges come forward [m].
        material: What it is of.
        lean: How far its top leans back [m].
        narrow: Width of its top, as a share of that of its foot.
        count: Points across.
    """
    share = np.linspace(-1.0, 1.0, count)[:, None]
    rise = np.linspace(0.0, 1.0, 5)
    x = bulge * (1 - np.cos(1.2 * share)) / (1 - math.cos(1.2)) - lean * rise
    y = share * width / 2 * (1 + (narrow - 1) * rise**2)
    heights = np.broadcast_to(z[0] + rise * (z[1] - z[0]), x.shape)
    d.sheet(np.stack([x, y, heights], axis=-1), thickness, material, ((count - 1) // 2, 1 if narrow == 1 else 2))
