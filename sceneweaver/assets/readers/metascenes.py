"""MetaScenes objects: ``Annotation_scenes/<scan>/<instance>/<instance>.obj``, z up in metres, in the scan's frame.

The files know neither front nor category, so both are found or left open; the place in the scan is centred away.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..imports.hints import Hints


def fits(path: Path) -> bool:
    """True for the folder that holds Annotation_scenes, that folder, or one scan of it."""
    return path.is_dir() and next(iter(_files(path)), None) is not None


def read(path: Path) -> Iterator[Hints]:
    """One entry an instance."""
    for file in _files(path):
        yield Hints(
            path=file,
            name=f"{file.parent.parent.name}-{file.stem}",
            up="z",
            metres=1.0,
            source="metascenes",
            licence="MetaScenes terms of use",
        )


def _files(path: Path) -> list[Path]:
    base = path / "Annotation_scenes" if (path / "Annotation_scenes").is_dir() else path
    deep = [p for p in sorted(base.glob("*/*/*.obj")) if p.stem == p.parent.name]
    if deep or "Annotation_scenes" not in path.parts:
        return deep if base.name == "Annotation_scenes" else []
    return [p for p in sorted(path.glob("*/*.obj")) if p.stem == p.parent.name]
