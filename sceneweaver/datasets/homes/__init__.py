"""Data sets of homes: each planned, furnished, judged, and described for robots that navigate."""

from .files import home_files as home_files
from .making import MadeHome as MadeHome
from .making import MakeHome as MakeHome
from .produce import produce_homes as produce_homes
