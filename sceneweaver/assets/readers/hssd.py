"""HSSD: GLB files in +y up, +z front, and a CSV whose rows may state other axes ("up", "front")."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sceneweaver.io import load_csv

from ..imports.hints import Hints
from .tables import axis_of

_TABLES = (
    "hssd_obj_semantics_condensed.csv",
    "object_categories_filtered.csv",
    "fpmodels-with-decomposed.csv",
    "fpmodels.csv",
)


def fits(path: Path) -> bool:
    """True for a folder with one of HSSD's tables, at its top or under metadata/ or semantics/."""
    return path.is_dir() and _table(path) is not None


def read(path: Path) -> Iterator[Hints]:
    """Objects of the table whose GLB is there."""
    table = _table(path)
    assert table is not None
    files = {file.stem: file for file in sorted(path.rglob("*.glb"))}
    for row in load_csv(table):
        low = {str(k).strip().lower(): (v or "").strip() for k, v in row.items() if k}
        uid = next((low[k] for k in ("id", "object hash", "fullid", "uid") if low.get(k)), "").split(".")[-1]
        if uid not in files:
            continue
        category = (
            next(
                (
                    low[k]
                    for k in ("main_category", "clean_category", "category", "main_wnsynsetkey", "wnlemmas")
                    if low.get(k)
                ),
                "",
            )
            .split(",")[0]
            .split(".")[0]
        )
        yield Hints(
            path=files[uid],
            name=low.get("name") or uid,
            category=category or None,
            up=axis_of(low.get("up")) or "y",
            front=_front(axis_of(low.get("up")), axis_of(low.get("front"))),
            metres=1.0,
            source="hssd",
            licence="CC-BY-NC-4.0",
            attribution="Habitat Synthetic Scenes Dataset",
        )


def _front(up: str | None, front: str | None) -> str | None:
    """The row's front; +z, unless the row's up is along it: then it is left to be found."""
    if front is not None:
        return front
    return None if up is not None and up.endswith("z") else "z"


def _table(path: Path) -> Path | None:
    for name in _TABLES:
        for place in (path, path / "metadata", path / "semantics", path / "semantics" / "objects"):
            if (place / name).is_file():
                return place / name
    return None
