"""What many pieces of furniture share, as functions of a drawing and the box to fill."""

from .cases import board_top as board_top
from .cases import carcass as carcass
from .cases import cornice as cornice
from .cases import frame as frame
from .cases import shelves as shelves
from .cases import slats as slats
from .cases import walls as walls
from .cavities import FORWARD as FORWARD
from .cavities import cavity as cavity
from .cavities import compartments as compartments
from .cavities import rack as rack
from .fittings import TURN as TURN
from .fittings import band as band
from .fittings import button as button
from .fittings import knob as knob
from .fittings import screen as screen
from .fittings import tap as tap
from .fronts import FRONT as FRONT
from .fronts import REACH as REACH
from .fronts import SWING as SWING
from .fronts import bar_pull as bar_pull
from .fronts import door as door
from .fronts import doors as doors
from .fronts import drawer as drawer
from .fronts import drawers as drawers
from .fronts import handle as handle
from .fronts import lip as lip
from .fronts import pulls as pulls
from .pictures import art as art
from .pictures import clock_face as clock_face
from .soft import blanket as blanket
from .soft import curtain as curtain
from .soft import cushions as cushions
from .soft import mattress as mattress
from .soft import piping as piping
from .soft import towel as towel
from .supports import beam as beam
from .supports import castors as castors
from .supports import feet as feet
from .supports import leg as leg
from .supports import legs as legs
from .supports import star_base as star_base
from .supports import wheel as wheel
from .units import Layout as Layout
from .units import fronts as fronts
from .units import unit as unit
from .vessels import CORNERS as CORNERS
from .vessels import basin as basin
from .vessels import bottle as bottle
from .vessels import bowl as bowl
from .vessels import drain as drain
from .vessels import open_box as open_box
from .vessels import oval as oval
from .vessels import perimeter as perimeter
from .vessels import tub as tub
from .vessels import vessel as vessel

__all__ = [
    "CORNERS",
    "FRONT",
    "REACH",
    "SWING",
    "TURN",
    "Layout",
    "art",
    "band",
    "bar_pull",
    "basin",
    "beam",
    "blanket",
    "board_top",
    "bottle",
    "bowl",
    "button",
    "carcass",
    "castors",
    "cavity",
    "compartments",
    "clock_face",
    "cornice",
    "curtain",
    "cushions",
    "door",
    "doors",
    "drain",
    "drawer",
    "drawers",
    "feet",
    "frame",
    "fronts",
    "handle",
    "knob",
    "leg",
    "legs",
    "lip",
    "mattress",
    "open_box",
    "oval",
    "perimeter",
    "piping",
    "pulls",
    "rack",
    "screen",
    "shelves",
    "slats",
    "star_base",
    "tap",
    "towel",
    "unit",
    "tub",
    "vessel",
    "walls",
    "wheel",
]
