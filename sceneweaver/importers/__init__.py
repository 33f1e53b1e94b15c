"""Scenes of other systems: their files read, brought to our frame, categories and relations.

A format is a small module in `formats`; what all need is here: frames, sizes, categories, openings, supports.
"""

from .categories import category_of as category_of
from .formats import formats as formats
from .home import ImportedHome as ImportedHome
from .home import PlanRepair as PlanRepair
from .home import read_homes as read_homes
from .home import repair_plan as repair_plan
from .model import ReadOptions as ReadOptions
from .model import SourceFormat as SourceFormat
from .model import SourceObject as SourceObject
from .model import SourceOpening as SourceOpening
from .model import SourceRoom as SourceRoom
from .read import AUTO as AUTO
from .read import format_of as format_of
from .read import read_scenes as read_scenes
from .read import sources as sources
from .scene import ImportedScene as ImportedScene
from .scene import to_scene as to_scene

__all__ = [
    "AUTO",
    "ImportedHome",
    "ImportedScene",
    "PlanRepair",
    "ReadOptions",
    "SourceFormat",
    "SourceObject",
    "SourceOpening",
    "SourceRoom",
    "category_of",
    "format_of",
    "formats",
    "read_homes",
    "read_scenes",
    "repair_plan",
    "sources",
    "to_scene",
]
