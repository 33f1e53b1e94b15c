"""Makers of simple closed shapes as (vertices, faces); every convex one is its own collision part.

All are numpy only. Vertices are float64 [V, 3] in metres, faces int32 [F, 3], counter-clockwise seen from outside.
"""

from .blocks import box as box
from .blocks import extrusion as extrusion
from .convex import containing_hull as containing_hull
from .convex import convex_pieces as convex_pieces
from .convex import hull as hull
from .convex import hull_of as hull_of
from .lofts import dome as dome
from .lofts import ellipse as ellipse
from .lofts import lofted as lofted
from .lofts import rectangle as rectangle
from .lofts import staved_hulls as staved_hulls
from .rounds import ball as ball
from .rounds import frustum as frustum
from .rounds import hollow_hulls as hollow_hulls
from .rounds import lathe as lathe
from .rounds import lathe_hulls as lathe_hulls
from .soft import cushion as cushion
from .soft import pillow as pillow
from .soft import sheet as sheet
from .soft import sheet_uv as sheet_uv
from .sweeps import sweep as sweep
from .sweeps import sweep_hulls as sweep_hulls

__all__ = [
    "ball",
    "box",
    "containing_hull",
    "convex_pieces",
    "cushion",
    "dome",
    "ellipse",
    "extrusion",
    "frustum",
    "hollow_hulls",
    "hull",
    "hull_of",
    "lathe",
    "lathe_hulls",
    "lofted",
    "pillow",
    "rectangle",
    "sheet",
    "sheet_uv",
    "staved_hulls",
    "sweep",
    "sweep_hulls",
]
