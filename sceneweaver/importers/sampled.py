"""Rooms sampled by networks in ATISS' terms, saved as arrays: DiffuScene, InstructScene and PhyScene share it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, read_text
from sceneweaver.io.messages import path_name

from .box_sets import Statistics, boxes_of, load_arrays, several, things
from .model import ReadOptions, SourceRoom
from .values import numbers, sequence, word


def read_sampled(path: Path, options: ReadOptions, data: Mapping[str, Any] | None = None) -> Iterator[SourceRoom]:
    """The rooms of a file of arrays, one after another.

    Args:
        path: ``.npz`` or ``.json``.
        options: the folder of ``dataset_stats.txt``.
        data: the arrays, where they are read already.

    Raises:
        InputError: as `sceneweaver.importers.box_sets.boxes_of`.
    """
    import numpy as np

    where = path_name(path)
    data = load_arrays(path) if data is None else data
    statistics = Statistics.near(path, options)
    names = _listed(data.get("scene_ids"), f"{where}: scene_ids")
    texts = _listed(data.get("descriptions"), f"{where}: descriptions")
    beside = path.parent / "description.txt"
    text = read_text(beside, max_bytes=100_000).strip() if beside.is_file() else ""
    centres = data.get("floor_plan_centroid")
    found, many = several(data, where)
    for k, arrays in enumerate(found):
        place = f"{where}: room {k}" if many else where
        boxes = boxes_of(arrays, statistics, place)
        centre = np.zeros(3)
        if centres is not None:
            rows = numbers(np.asarray(centres).reshape(-1, 3), (None, 3), f"{where}: floor_plan_centroid")
            centre = rows[min(k, len(rows) - 1)] * np.array([1.0, 0.0, 1.0])
        name = names[k] if k < len(names) else f"{k:04d}" if many else ""
        yield SourceRoom(
            name=name,
            type=_type_of(name),
            objects=things(boxes, centre, _jids(arrays, k)),
            text=texts[k] if k < len(texts) else text,
            notes=boxes.notes,
        )


def _type_of(name: str) -> str:
    """ "livingroom" of an id such as "LivingRoom-1234" or "<house>_LivingRoom-1234"."""
    return name.rpartition("_")[2].partition("-")[0].lower() if "-" in name else ""


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
