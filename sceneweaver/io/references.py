"""Files that a file of somebody else names: they lie in its own folder, or they are not read."""

from __future__ import annotations

import os
from pathlib import Path

from .errors import InputError
from .messages import quote


def lies_inside(folder: Path, place: Path) -> bool:
    """Whether a place lies below a folder, also when links are followed; what is there is not looked at."""
    try:
        return place.resolve().is_relative_to(folder.resolve())
    except (OSError, ValueError, RuntimeError):  # links that go round, names that are too long, null characters
        return False


def required_inside(folder: Path, place: Path, who: str) -> Path:
    """The place of a file that is named by another one.

    Args:
        folder: where it has to lie.
        place: where the name leads.
        who: names the other file in the error.

    Raises:
        InputError: when it leads out of the folder.
    """
    if not lies_inside(folder, place):
        shown = quote(os.path.basename(folder.resolve()))
        raise InputError(f"{who}: it names {quote(place)}, which lies outside of {shown}; put it there")
    return place
