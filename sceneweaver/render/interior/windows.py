"""Windows at eye level: frame, sashes with panes and handles, the board on the sill inside and the ledge outside."""

from __future__ import annotations

from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Window

from ..room_blocks import Builder, wall_block
from ..room_finish import Finishes
from .mouldings import Plane, moulding, plate, rectangle, rod

_FRAME, _SASH = 0.045, 0.05  # widths [m] of frame and sash
_PANE = 0.004
_SASH_WIDTH = 0.85  # about how wide a sash is [m]
_BOARD = (
    (-0.026, -0.03),
    (0.0, -0.03),
    (0.0, 0.044),
    (-0.005, 0.051),
    (-0.013, 0.054),
    (-0.021, 0.051),
    (-0.026, 0.044),
)
"""Profile of a window board (above the sill, into the room) [m]."""


def add_window(builder: Builder, wall: Wall, window: Window, look: Finishes) -> None:
    """A window in its opening, with clear panes: what is outside is seen."""
    start, end = window.offset, window.offset + window.width
    low, high = window.sill, window.sill + window.height
    plane = Plane.on_wall(wall)
    share = min(1.0, min(window.width, window.height) / 0.5)
    frame, sash = _FRAME * share, _SASH * share
    path = rectangle((start, end), (low, high))
    moulding(
        builder, plane, path, [(0.0, -0.09), (frame, -0.09), (frame, -0.036), (0.0, -0.03)], look.trim, closed=True
    )
    inner = (start + 0.7 * frame, end - 0.7 * frame)
    count = max(1, round((inner[1] - inner[0]) / _SASH_WIDTH))
    wide = (inner[1] - inner[0]) / count
    profile = [(0.0, -0.08), (sash, -0.08), (sash, -0.036), (0.8 * sash, -0.026), (0.0, -0.022)]
    for k in range(count):
        a, b = inner[0] + k * wide + 0.001, inner[0] + (k + 1) * wide - 0.001
        z = (low + 0.7 * frame, high - 0.7 * frame)
        moulding(builder, plane, rectangle((a, b), z), profile, look.trim, closed=True)
        glass = rectangle((a + sash - 0.004, b - sash + 0.004), (z[0] + sash - 0.004, z[1] - sash + 0.004))
        plate(builder, plane, glass, (-0.044 - _PANE, -0.044), look.glass)
        if window.height > 0.5 and (k % 2 == 1 or count == 1 or k == count - 1):
            _handle(builder, plane, a + 0.5 * sash, _handle_height(low, high), look)
    if low > 0.1:  # one down to the floor has no board
        ends = [(start - 0.045, low), (end + 0.045, low)]
        moulding(builder, plane, ends, _BOARD, look.trim)
    ledge = wall_block(wall, (start, end), (0.085, WALL_THICKNESS + 0.04))
    builder.prism(ledge, (low - 0.012, low + 0.002), look.metal)


def _handle_height(low: float, high: float) -> float:
    """Where the handle is [m]: in the middle of a low window, in reach at a tall one."""
    return min((low + high) / 2, max(1.1, low + 0.3 * (high - low)))


def _handle(builder: Builder, plane: Plane, at: float, z: float, look: Finishes) -> None:
    base = rectangle((at - 0.013, at + 0.013), (z - 0.032, z + 0.032))
    plate(builder, plane, base, (-0.026, -0.014), look.metal, bevel=0.003)
    rod(builder, plane, ((at, z, -0.02), (at, z, 0.018)), 0.007, look.metal)
    rod(builder, plane, ((at, z + 0.01, 0.016), (at, z - 0.105, 0.016)), 0.008, look.metal)
