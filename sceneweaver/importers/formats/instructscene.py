"""InstructScene: sampled rooms as ``.npz`` or ``.json``, in the terms of `sceneweaver.importers.box_sets`.

Two ways to hold them: arrays ``class_labels``, ``translations``, ``sizes``, ``angles`` as its evaluation joins them, or
its networks' own ``objs`` [slot] (indices of the classes, the one past the last is empty) with ``boxes`` [slot][8]:
translation, half size, (cos, sin). The instruction is in ``description.txt`` beside it, as InstructScene saves it, or
in ``descriptions``. Its data set (boxes.npz) is read as ATISS'.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError
from sceneweaver.io.messages import path_name

from ..box_files import is_archive, load_arrays, members
from ..model import ReadOptions, SourceFormat, SourceRoom
from ..sampled import read_sampled
from ..values import keys_seen

MARKS = {"objs", "edges", "relations", "triples", "objfeat_vq_indices"}


def matches(path: Path, head: bytes) -> bool:
    """Arrays of boxes with a scene graph, or with an instruction beside them."""
    if is_archive(path, head):
        names = members(path)
        if "floor_plan_vertices" in names:
            return False
    elif path.suffix.lower() == ".json" and head.lstrip()[:1] == b"{":
        names = keys_seen(head)
    else:
        return False
    boxes = {"boxes", "translations", "class_labels"} & names
    return bool(boxes) and bool(names & MARKS or (path.parent / "description.txt").is_file()) and "ed_rm" not in names


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its rooms, one after another."""
    data = load_arrays(path)
    if "translations" not in data and "boxes" in data:
        data = _split(data, path_name(path))
    yield from read_sampled(path, options, data)


def _split(data: dict[str, Any], where: str) -> dict[str, Any]:
    """``objs`` and ``boxes`` as arrays of their own."""
    import numpy as np

    if "objs" not in data:
        raise InputError(f"{where}: 'objs' is missing; boxes need the class of each slot")
    try:
        boxes = np.asarray(data["boxes"], dtype=float)
    except (OverflowError, TypeError, ValueError):
        raise InputError(f"{where}: boxes: n x 8 numbers are needed, of each room alike") from None
    if boxes.ndim not in (2, 3) or boxes.shape[-1] not in (7, 8):
        raise InputError(f"{where}: boxes: 8 numbers a slot are needed: translation, half size, cos and sin")
    rest = {key: value for key, value in data.items() if key not in ("objs", "boxes")}
    return {
        **rest,
        "class_labels": data["objs"],
        "translations": boxes[..., :3],
        "sizes": boxes[..., 3:6],
        "angles": boxes[..., 6:],
    }


FORMAT = SourceFormat(
    name="instructscene",
    title="InstructScene",
    matches=matches,
    read=read,
    notes=(
        "Read: .npz or .json with class_labels, translations, sizes and angles, or with objs and boxes (translation, "
        "half size, cos, sin); names of the classes from dataset_stats.txt beside it or in --asset-folder; the "
        "instruction from description.txt beside it; outlines from the folder of <room>/boxes.npz as --asset-folder, "
        "by scene_ids or the name of the file's folder.",
        "Meaning: y up, half extents, the front along +z; negative half sizes mean the network's own scale in [-1, 1], "
        "which dataset_stats.txt undoes.",
        "Lost: without floor plans the outline (InstructScene draws a rectangle around the objects, and so do we), "
        "doors, windows, the scene graph's edges, features. Pickles are never loaded.",
    ),
    licence="3D-FRONT's terms of use",
    priority=1,
)
