"""How scenes, solutions and verdicts show themselves in a notebook.

What draws them is a floor far above this one, so it is named here, and imported when something is first shown.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

DRAWN_BY = "sceneweaver.notebook"


class Displayed:
    """Something that a notebook shows as HTML."""

    def _repr_html_(self) -> str:
        """A small table for notebooks, with a top view where there is a scene to see."""
        return import_module(DRAWN_BY).summary(self)


class Shown(Displayed):
    """Something that also has a view to walk around in."""

    def show(self, *, width: int = 900, height: int = 560, load: Callable[[str], Any] | None = None) -> Any:
        """The 3D view of the report, for the last line of a notebook's cell: one frame that loads nothing.

        Args:
            width, height: of the frame [pixels].
            load: gives the asset of an id; None: the library of this user.

        Returns:
            What a notebook displays; ``html`` is its text.
        """
        return import_module(DRAWN_BY).frame(self, width, height, load)
