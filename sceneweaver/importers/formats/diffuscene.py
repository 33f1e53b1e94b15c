"""DiffuScene: rooms as its network or its post-processing gives them, saved as ``.npz`` or ``.json``.

Arrays ``class_labels``, ``translations``, ``sizes``, ``angles`` of one room [slot][..] or of many [room][slot][..], as
`sceneweaver.importers.box_sets` says, and maybe ``scene_ids`` and ``floor_plan_centroid``. The last class, "end" or
"empty", is that of slots without an object. DiffuScene itself writes pictures and meshes only; pickles of its arrays
are refused with a line on how to save them.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..box_files import is_archive, members
from ..box_sets import ARRAYS
from ..model import ReadOptions, SourceFormat, SourceRoom
from ..sampled import read_sampled
from ..values import keys_seen

OTHERS = {
    "floor_plan_vertices",
    "objectness",
    "scene_ids",
    "objs",
    "edges",
    "relations",
    "triples",
    "objfeat_vq_indices",
}


def matches(path: Path, head: bytes) -> bool:
    """Arrays of boxes, without the marks of ATISS, PhyScene and InstructScene."""
    names = members(path) if is_archive(path, head) else keys_seen(head) if head.lstrip()[:1] == b"{" else set()
    if is_archive(path, head):
        return set(ARRAYS) <= names and not names & OTHERS
    return bool({"class_labels", "translations"} & names) and not names & OTHERS and "objects" not in names


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its rooms, one after another."""
    yield from read_sampled(path, options)


FORMAT = SourceFormat(
    name="diffuscene",
    title="DiffuScene",
    matches=matches,
    read=read,
    notes=(
        "Read: .npz or .json with class_labels, translations, sizes and angles of one room or of many; names of the "
        "classes from dataset_stats.txt beside it or in --asset-folder, or from an array 'classes'; outlines from the "
        "folder of ATISS' <room>/boxes.npz as --asset-folder, where scene_ids name the rooms.",
        "Meaning: y up, half extents, the front along +z; two columns of angles are (cos, sin); where half sizes are "
        "negative the values are the network's in [-1, 1], and dataset_stats.txt scales them.",
        "Assumed: coordinates are relative to the centre of the floor plan; the floor is at height 0.",
        "Lost: without those floor plans the outline (drawn around the objects), doors, windows, features of the "
        "objects. Pickles are never loaded: the error says how to convert them.",
    ),
    licence="3D-FRONT's terms of use",
)
