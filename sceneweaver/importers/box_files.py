"""Files of boxes in ATISS' terms: NumPy archives and JSON, never pickles, and the statistics beside them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.io import InputError, open_zip, read_arrays
from sceneweaver.io.messages import path_name

from .model import ReadOptions
from .values import loaded, mapping, member, numbers, word

if TYPE_CHECKING:
    import numpy as np

STATISTICS = "dataset_stats.txt"

PICKLE = (
    "a pickle, which can run any program when it is loaded, so none is read; convert it where it was made, such as "
    "with numpy.savez(file, class_labels=..., translations=..., sizes=..., angles=...)"
)


def is_pickle(path: Path, head: bytes) -> bool:
    """Whether a file is a pickle, by its name or its first bytes."""
    return path.suffix.lower() in (".pkl", ".pickle") or (
        head[:1] == b"\x80" and head[1:2] in (b"\x02", b"\x03", b"\x04", b"\x05")
    )


def is_archive(path: Path, head: bytes) -> bool:
    """Whether a file is a NumPy archive, by its name and first bytes."""
    return path.suffix.lower() == ".npz" and head[:2] == b"PK"


def members(path: Path) -> set[str]:
    """Names of the arrays of a NumPy archive.

    Raises:
        InputError: as `sceneweaver.io.open_zip`.
    """
    with open_zip(path) as packed:
        return {entry.removesuffix(".npy") for entry in packed.namelist()}


def load_arrays(path: Path) -> dict[str, Any]:
    """The arrays of a NumPy archive, or the members of a JSON object, by name.

    Raises:
        InputError: damaged; a pickle, or pickles in it.
    """
    name = path_name(path)
    if is_pickle(path, b""):
        raise InputError(f"{name}: it is {PICKLE}")
    if path.suffix.lower() != ".npz":
        return dict(mapping(loaded(path), name))
    try:
        return dict(read_arrays(path))
    except InputError as error:
        if "objects of Python" in str(error):
            raise InputError(f"{name}: an array in it is {PICKLE}") from None
        raise


@dataclass(frozen=True)
class Statistics:
    """What ``dataset_stats.txt`` says: names of the classes, and the bounds [2, 3] that scale a network's output."""

    classes: tuple[str, ...] = ()
    translations: np.ndarray | None = None
    sizes: np.ndarray | None = None

    @classmethod
    def near(cls, path: Path, options: ReadOptions) -> Statistics:
        """Those beside a file, in the folders above it, or in the user's folder; else none.

        Raises:
            InputError: they are broken.
        """
        places = [options.folder] if options.folder else []
        places += [path, *path.parents[:2]]
        for place in places:
            file = place if place.name == STATISTICS else place / STATISTICS
            if file.is_file():
                return cls.of(file)
        return cls()

    @classmethod
    def of(cls, file: Path) -> Statistics:
        """Those of a file; errors as `near`."""
        name = path_name(file)
        data = mapping(loaded(file), name)
        bounds = {
            key: numbers(data[f"bounds_{key}"], (6,), f"{name}: bounds_{key}").reshape(2, 3)
            for key in ("translations", "sizes")
            if f"bounds_{key}" in data
        }
        return cls(class_names(member(data, "class_labels", name), f"{name}: class_labels"), **bounds)


def class_names(value: Any, where: str) -> tuple[str, ...]:
    """Names of classes from a list or an array.

    Raises:
        InputError: it holds no texts.
    """
    listed = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(listed, list) or not all(isinstance(name, str) for name in listed):
        raise InputError(f'{where}: names of the classes are needed, such as ["bed", "nightstand"]')
    return tuple(word(name) for name in listed)
