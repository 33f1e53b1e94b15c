"""Boxes as ATISS and all that follow it write them: arrays of classes, translations, half sizes and angles.

Frame of them all: metres, right-handed, y up. ``translations`` [n, 3] are box centres relative to the centre of the
floor plan's box; ``sizes`` [n, 3] are HALF extents along x, y, z of the object's own axes; ``angles`` [n, 1] turn about
+y, counter-clockwise seen from above (x' = x cos + z sin, z' = -x sin + z cos), with the front along +z at 0.

A network's own output differs: ``angles`` [n, 2] are (cos, sin) in that order, and translations and half sizes are
scaled to [-1, 1] by the bounds in ``dataset_stats.txt``. Negative half sizes tell it. ``objectness`` [n, 1], against
its name, is the score of the class "empty": boxes are those where it is NEGATIVE.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sceneweaver.io import InputError

from .box_files import STATISTICS, Statistics, class_names
from .frames import Y_UP, facing
from .model import SourceObject
from .values import member, numbers

if TYPE_CHECKING:
    import numpy as np

PADDING = frozenset({"empty", "start", "end"})
"""Classes of slots that hold nothing."""

HANGING = frozenset({"pendant_lamp", "ceiling_lamp", "chandelier"})
"""Classes of 3D-FRONT that hang from the ceiling, whose height none of these files has."""

ARRAYS = ("class_labels", "translations", "sizes", "angles")


@dataclass(frozen=True)
class Boxes:
    """The boxes of one room: class, centre, half extents (their axes) and angle [rad] of each."""

    labels: tuple[str, ...]
    translations: np.ndarray
    sizes: np.ndarray
    angles: np.ndarray
    slots: tuple[int, ...]
    notes: tuple[str, ...] = ()


def boxes_of(data: Mapping[str, Any], statistics: Statistics, where: str) -> Boxes:
    """The boxes of one room from arrays of it; slots that hold nothing are left out.

    Args:
        data: ``class_labels`` [n, classes] (one-hot or scores) or [n] (indices or names), ``translations``, ``sizes``,
            ``angles``, and maybe ``objectness``.
        statistics: names of the classes, and bounds.
        where: place of the data, for errors.

    Raises:
        InputError: missing, of other shapes, not finite; a scaled output without the bounds.
    """
    import numpy as np

    translations = numbers(member(data, "translations", where), (None, 3), f"{where}: translations")
    count = len(translations)
    sizes = numbers(member(data, "sizes", where), (count, 3), f"{where}: sizes")
    labels = _labels(member(data, "class_labels", where), count, _classes(data, statistics, where), where)
    angles, turned = _angles(member(data, "angles", where), count, where)
    kept = [k for k, label in enumerate(labels) if label not in PADDING]
    notes = []
    if "objectness" in data and count:
        scores = _column(data["objectness"], count, f"{where}: objectness")
        empty = [k for k in kept if scores[k] >= 0]
        if len(empty) == len(kept):
            notes.append("objectness is negative nowhere, which would leave nothing: classes alone tell what is empty")
        elif empty:
            notes.append(
                f"{len(empty)} boxes are left out: their objectness, the score of being empty, is not negative"
            )
            kept = [k for k in kept if scores[k] < 0]
    translations, sizes, angles = translations[kept], sizes[kept], angles[kept]
    if (sizes <= 0).any():
        scaled = bool(np.abs(sizes).max() <= 1.2 and np.abs(translations).max() <= 1.2)
        if not scaled:
            raise InputError(f"{where}: sizes: {sizes.min():g} is no half extent; they must be positive")
        if statistics.sizes is None or statistics.translations is None:
            raise InputError(
                f"{where}: sizes: negative ones, so this is a network's output in [-1, 1]; put {STATISTICS} beside it, "
                "or name its folder with --asset-folder"
            )
        translations, sizes = _unscaled(translations, statistics.translations), _unscaled(sizes, statistics.sizes)
        notes.append(f"translations and sizes are a network's output in [-1, 1]; the bounds of {STATISTICS} scale them")
        if (sizes <= 0).any():
            raise InputError(f"{where}: sizes: {sizes.min():g} m after scaling; {STATISTICS} is of another data set")
    elif turned and statistics.sizes is not None:
        notes.append("angles are (cos, sin), but no half size is negative: taken as metres, not as scaled to [-1, 1]")
    return Boxes(tuple(labels[k] for k in kept), translations, sizes, angles, tuple(kept), tuple(notes))


def rotation_of(angle: float) -> np.ndarray:
    """The rotation [3, 3] of an object of ours by their angle [rad] about +y."""
    import math

    import numpy as np

    c, s = math.cos(angle), math.sin(angle)
    about_y = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    return Y_UP @ about_y @ facing("z", "y").T


def size_of(half: np.ndarray) -> tuple[float, float, float]:
    """Depth, width and height [m] of their half extents along x, y, z: their front is z."""
    return 2 * float(half[2]), 2 * float(half[0]), 2 * float(half[1])


def thing(
    name: str,
    label: str,
    centre: np.ndarray,
    half: np.ndarray,
    angle: float,
    *,
    asset: str | None = None,
    keep: dict[str, Any] | None = None,
) -> SourceObject:
    """A box of theirs as an object: ``centre`` [3] in their frame, y up, moved to the room's."""
    x, y, z = (Y_UP @ centre).tolist()
    return SourceObject(
        name=name,
        label=label,
        position=(x, y, z),
        rotation=rotation_of(angle),
        size=size_of(half),
        asset=asset,
        mount="ceiling" if label in HANGING else None,
        keep=keep or {},
    )


def things(boxes: Boxes, origin: np.ndarray, assets: list[str] | None = None) -> tuple[SourceObject, ...]:
    """The boxes of a room as objects; ``origin`` [3] is what translations are relative to, y up."""
    return tuple(
        thing(
            f"{label}_{slot}",
            label,
            boxes.translations[k] + origin,
            boxes.sizes[k],
            float(boxes.angles[k]),
            asset=assets[slot] if assets and slot < len(assets) else None,
        )
        for k, (label, slot) in enumerate(zip(boxes.labels, boxes.slots, strict=True))
    )


def several(data: Mapping[str, Any], where: str) -> tuple[list[dict[str, Any]], bool]:
    """The rooms of arrays with one axis more, ``[room][slot][..]``, or the one of arrays of one; and whether many.

    Raises:
        InputError: arrays of unequal numbers of rooms.
    """
    first = member(data, "translations", where)
    if _depth(first) < 3:
        return [dict(data)], False
    names = [key for key in (*ARRAYS, "objectness") if key in data]
    for key in names:
        if _depth(data[key]) < 2 or len(data[key]) != len(first):
            found = len(data[key]) if _depth(data[key]) else "no"
            raise InputError(f"{where}: {key}: {found} rooms, but translations has {len(first)}")
    rest = {key: value for key, value in data.items() if key not in names}
    return [{**rest, **{name: data[name][k] for name in names}} for k in range(len(first))], True


def _depth(value: Any) -> int:
    """Axes of an array or of nested lists, by their first entries."""
    if hasattr(value, "ndim"):
        return int(value.ndim)
    if not isinstance(value, list):
        return 0
    return 1 + (_depth(value[0]) if value else 0)


def _unscaled(values: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    return (values + 1) / 2 * (bounds[1] - bounds[0]) + bounds[0]


def _angles(value: Any, count: int, where: str) -> tuple[np.ndarray, bool]:
    """Angles [n] in rad, and whether they were (cos, sin)."""
    import numpy as np

    try:
        array = np.asarray(value)
    except ValueError:
        array = np.asarray(None)
    if array.ndim == 2 and array.shape[1] == 2:
        pairs = numbers(array, (count, 2), f"{where}: angles")
        return np.arctan2(pairs[:, 1], pairs[:, 0]), True
    return _column(value, count, f"{where}: angles"), False


def _column(value: Any, count: int, where: str) -> np.ndarray:
    """Numbers [n], written as n or as n x 1."""
    if _depth(value) == 2:
        return numbers(value, (count, 1), where)[:, 0]
    return numbers(value, (count,), where)


def _classes(data: Mapping[str, Any], statistics: Statistics, where: str) -> tuple[str, ...]:
    """Names of the classes: of the file itself where it has them, else of the statistics."""
    for key in ("classes", "class_names", "object_types"):
        if key in data:
            return class_names(data[key], f"{where}: {key}")
    return statistics.classes


def _labels(value: Any, count: int, classes: tuple[str, ...], where: str) -> list[str]:
    """The class of each slot; ``class_labels`` may lack "start" (DiffuScene) and "end", or have "empty"."""
    import numpy as np

    place = f"{where}: class_labels"
    try:
        array = np.asarray(value)
    except ValueError:
        array = np.asarray(None)
    if array.dtype.kind == "U":
        found = class_names(array, place)
        if len(found) != count:
            raise InputError(f"{place}: {len(found)} classes, but translations has {count} boxes")
        return list(found)
    if count == 0:
        return []
    if not classes:
        raise InputError(
            f"{place}: nothing names the classes; put {STATISTICS} beside the file, or name its folder with "
            "--asset-folder"
        )
    if array.ndim == 1:
        indices, width = numbers(array, (count,), place).astype(int), len(classes)
        names = [*classes, "empty"]
    else:
        scores = numbers(array, (count, None), place)
        indices, width = scores.argmax(axis=1), scores.shape[1]
        names = _of_width(classes, width, place)
        none = np.ptp(scores, axis=1) == 0  # a slot without a class
        indices = np.where(none, len(names), indices)
        names = [*names, "empty"]
    if (indices < 0).any() or (indices >= len(names)).any():
        raise InputError(f"{place}: {int(indices.max())} is no index of the {width} classes")
    return [names[k] for k in indices.tolist()]


def _of_width(classes: tuple[str, ...], width: int, place: str) -> list[str]:
    """The names of ``width`` columns."""
    types = [name for name in classes if name not in PADDING]
    for names in (list(classes), [*types, "empty"], types):
        if len(names) == width:
            return names
    raise InputError(
        f"{place}: {width} columns, but {len(types)} classes are named; is {STATISTICS} that of this data set?"
    )
