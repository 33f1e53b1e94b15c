"""Floor plans in ATISS' terms: the floor's mesh of a room in its house, and the centre that boxes are relative to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import path_name

from .box_files import load_arrays
from .frames import Y_UP
from .outlines import of_triangles
from .values import numbers

FILE = "boxes.npz"


@dataclass(frozen=True)
class FloorPlan:
    """Outline [m] in our frame, or None; what translations are relative to [3], y up, with the floor at 0; notes."""

    outline: tuple[tuple[float, float], ...] | None
    centre: np.ndarray
    notes: tuple[str, ...]

    @classmethod
    def of(cls, data: Mapping[str, Any], where: str) -> FloorPlan:
        """That of the arrays of a boxes.npz: the vertices are the house's, and are NOT relative to the centroid.

        Raises:
            InputError: broken arrays; vertices without faces.
        """
        outline, floor, centre = None, 0.0, np.zeros(3)
        notes: list[str] = []
        if "floor_plan_vertices" in data:
            vertices = numbers(data["floor_plan_vertices"], (None, 3), f"{where}: floor_plan_vertices")
            faces = _faces(data.get("floor_plan_faces"), len(vertices), where)
            corners, left = of_triangles((vertices @ Y_UP.T)[:, :2], faces)
            notes += left
            if corners is not None:
                outline = tuple((float(x), float(y)) for x, y in corners)
                floor, centre = float(vertices[:, 1].min()), (vertices.min(axis=0) + vertices.max(axis=0)) / 2
        if "floor_plan_centroid" in data:
            centre = numbers(data["floor_plan_centroid"], (3,), f"{where}: floor_plan_centroid")
        elif outline is not None:
            notes.append("no floor_plan_centroid: the centre of the floor plan's box is taken")
        if abs(floor) > 1e-9:
            notes.append(f"the floor lies at {floor:g} m in the house; it is moved to 0")
        return cls(outline, centre - np.array([0.0, floor, 0.0]), tuple(notes))


@dataclass(frozen=True)
class FloorPlans:
    """The floor plans of a folder of rooms, ``<room>/boxes.npz``, by the name of the room."""

    folders: Mapping[str, Path]

    @classmethod
    def within(cls, folder: Path | None) -> FloorPlans:
        """Those of the user's folder; none where there is no such folder."""
        if folder is None or not folder.is_dir():
            return cls({})
        return cls({place.name: place for place in sorted(folder.iterdir()) if (place / FILE).is_file()})

    def find(self, name: str) -> FloorPlan | None:
        """That of a room by its id ("Bedroom-77"), by its folder ("<house>_Bedroom-77"), or by a name with it in it.

        Raises:
            InputError: its file is broken.
        """
        if not name:
            return None
        ends = [room for room in self.folders if room.endswith(f"_{name}")]
        inside = sorted((room for room in self.folders if room in name), key=len)  # "Library-8" is in "Library-88"
        room = name if name in self.folders else ends[0] if len(ends) == 1 else inside[-1] if inside else None
        if room is None:
            return None
        file = self.folders[room] / FILE
        return FloorPlan.of(load_arrays(file), path_name(file))


def _faces(value: Any, count: int, where: str) -> np.ndarray:
    if value is None:
        raise InputError(f"{where}: 'floor_plan_faces' is missing; floor_plan_vertices alone are no outline")
    faces = numbers(value, (None, 3), f"{where}: floor_plan_faces").astype(np.int64)
    if len(faces) and not 0 <= faces.min() <= faces.max() < count:
        raise InputError(f"{where}: floor_plan_faces: {int(faces.max())} is no index of the {count} vertices")
    return faces
