"""A harness: any optimiser over many problems, as anytime curves, profiles, tables and plots; `sceneweaver bench`.

It needs the extra ``bench`` (pyarrow, matplotlib).
"""

from .board import board_markdown as board_markdown
from .board import leaderboard as leaderboard
from .curves import Profile as Profile
from .curves import Target as Target
from .curves import data_profile as data_profile
from .curves import performance_profile as performance_profile
from .entries import Method as Method
from .pairs import Pair as Pair
from .pairs import paired as paired
from .plots import plot as plot
from .results import Run as Run
from .results import read_about as read_about
from .results import read_runs as read_runs
from .runner import run as run
from .settings import Settings as Settings
from .tables import Line as Line
from .tables import compare as compare
from .tables import markdown as markdown

__all__ = [
    "Line",
    "board_markdown",
    "leaderboard",
    "Method",
    "Pair",
    "Profile",
    "Run",
    "Settings",
    "Target",
    "compare",
    "data_profile",
    "markdown",
    "paired",
    "performance_profile",
    "plot",
    "read_about",
    "read_runs",
    "run",
]
