"""Files that a file of somebody else names: they lie in its own folder, or they are not read.

A name is judged as it is written, without following links: what a user has linked into a folder, as caches of downloads
do, belongs to it.
"""

from __future__ import annotations

import os
from pathlib import Path

from .errors import InputError
from .messages import quote


def named_inside(folder: Path, place: Path) -> Path | None:
    """The place, without ``..`` in it, where it lies below a folder; else None. What is there is not looked at."""
    if "\0" in str(place):
        return None
    flat = Path(os.path.abspath(place))
    return flat if flat.is_relative_to(os.path.abspath(folder)) else None


def required_inside(folder: Path, place: Path, who: str) -> Path:
    """The place of a file that is named by another one, without ``..`` in it.

    Args:
        folder: where it has to lie.
        place: where the name leads.
        who: names the other file in the error.

    Raises:
        InputError: when it leads out of the folder.
    """
    found = named_inside(folder, place)
    if found is None:
        shown = quote(os.path.basename(os.path.abspath(folder)))
        raise InputError(f"{who}: it names {quote(place)}, which lies outside of the folder {shown}; put it there")
    return found
