"""Rooms sampled by networks in ATISS' terms, saved as arrays: DiffuScene, InstructScene and PhyScene share it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, read_text
from sceneweaver.io.messages import path_name

from .box_files import Statistics, load_arrays
from .box_sets import boxes_of, several, things
from .floor_plans import FloorPlans
from .model import ReadOptions, SourceRoom
from .values import numbers, sequence, word


def read_sampled(path: Path, options: ReadOptions, data: Mapping[str, Any] | None = None) -> Iterator[SourceRoom]:
    """The rooms of a file of arrays, one after another.

    Args:
        path: ``.npz`` or ``.json``.
        options: the folder of ``dataset_stats.txt``, and of ``<room>/boxes.npz`` for the outlines.
        data: the arrays, where they are read already.

    Raises:
        InputError: as `sceneweaver.importers.box_sets.boxes_of`.
    """
    where = path_name(path)
    data = load_arrays(path) if data is None else data
    statistics = Statistics.near(path, options)
    names = _listed(data.get("scene_ids"), f"{where}: scene_ids")
    texts = _listed(data.get("descriptions"), f"{where}: descriptions")
    beside = path.parent / "description.txt"
    text = read_text(beside, max_bytes=100_000).strip() if beside.is_file() else ""
    plans = FloorPlans.within(options.folder)
    folder = path.parent.name
    found, many = several(data, where)
    for k, arrays in enumerate(found):
        place = f"{where}: room {k}" if many else where
        boxes = boxes_of(arrays, statistics, place)
        name = names[k] if k < len(names) else f"{k:04d}" if many else ""
        plan = plans.find(name or folder)
        centre = _centre(data, k, where) if plan is None else plan.centre
        yield SourceRoom(
            name=name,
            type=_type_of(name or folder),
            outline=None if plan is None else plan.outline,
            objects=things(boxes, centre, _jids(arrays, k)),
            text=texts[k] if k < len(texts) else text,
            notes=boxes.notes if plan is None else (*boxes.notes, *plan.notes),
        )


def _centre(data: Mapping[str, Any], k: int, where: str) -> np.ndarray:
    """What translations of a room are relative to [3], with the floor at 0."""
    value = data.get("floor_plan_centroid")
    if value is None:
        return np.zeros(3)
    value = value.tolist() if hasattr(value, "tolist") else value
    rows = value if value and isinstance(value[0], list) else [value]
    return numbers(rows[min(k, len(rows) - 1)], (3,), f"{where}: floor_plan_centroid") * np.array([1.0, 0.0, 1.0])


def _type_of(name: str) -> str:
    """ "livingroom" of a name with an id of 3D-FRONT in it, such as "<house>_LivingRoom-1234"."""
    found = re.search(r"([a-z]*(?:room|library))-\d+", name, re.IGNORECASE)
    return found[1].lower() if found else ""


def _listed(value: Any, where: str) -> list[str]:
    if value is None:
        return []
    return [word(v) for v in sequence(value.tolist() if hasattr(value, "tolist") else value, where)]


def _jids(arrays: Mapping[str, Any], k: int) -> list[str]:
    """Names of the models that were chosen, of one room or of this one of many."""
    value: Any = arrays.get("jids")
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, list):
        return []
    if value and isinstance(value[0], list):
        if k >= len(value):
            raise InputError(f"jids: {len(value)} rooms, but translations has more")
        value = value[k]
    return [word(v) for v in value]
