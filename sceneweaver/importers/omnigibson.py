"""What OmniGibson knows of a model: its box in its own frame, and where that lies from the base link."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sceneweaver.io import load_json
from sceneweaver.io.references import named_inside

from .values import Entry


def metadata(folder: Path | None, category: str, model: str) -> Entry | None:
    """The metadata of a model in a folder of assets: ``[objects/]<category>/<model>/misc/metadata.json``."""
    if folder is None or not category or not model:
        return None
    for base in (folder, folder / "objects"):
        place = named_inside(folder, base / category / model / "misc" / "metadata.json")
        if place is not None and place.is_file():
            return Entry.of(place, load_json(place))
    return None


def box_offset(folder: Path | None, category: str, model: str) -> np.ndarray | None:
    """The middle of a model's box from its base link, unscaled [m], [3]; None where that is not known."""
    found = metadata(folder, category, model)
    return (
        np.array(found["base_link_offset"].numbers(3)) if found is not None and found.has("base_link_offset") else None
    )


def native_box(folder: Path | None, category: str, model: str) -> np.ndarray | None:
    """The sides of a model's box, unscaled [m], [3]; None where they are not known."""
    found = metadata(folder, category, model)
    return np.array(found["bbox_size"].numbers(3, 0.0)) if found is not None and found.has("bbox_size") else None
