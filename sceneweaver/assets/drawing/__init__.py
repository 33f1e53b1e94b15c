"""The drawing language: furniture as a tree of parts, each found from another."""

from .assemble import asset_of as asset_of
from .assemble import outline_shape as outline_shape
from .box import Axis as Axis
from .box import Box as Box
from .box import Interval as Interval
from .box import Vec3 as Vec3
from .drawing import PROUD as PROUD
from .drawing import Drawing as Drawing
from .drawing import Look as Look
from .registry import MAKERS as MAKERS
from .registry import Maker as Maker
from .registry import draws as draws
from .request import Request as Request
from .request import Size as Size
from .tree import Part as Part

__all__ = [
    "MAKERS",
    "PROUD",
    "Axis",
    "Box",
    "Drawing",
    "Interval",
    "Look",
    "Maker",
    "Part",
    "Request",
    "Size",
    "Vec3",
    "asset_of",
    "draws",
    "outline_shape",
]
