"""The folder of a comparison: a file for every run that is done, one file in the end; and reading them."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import shutil
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.scene import InputError, write_atomic

from .extras import pyarrow
from .schema import COLUMNS, KEY, Row, arrow_schema
from .settings import Settings

RESULTS, PARTS, SETTINGS = "results.parquet", "runs", "settings.json"
PACKAGES = ("sceneweaver", "warp-lang", "numpy", "jax", "torch", "optax", "optimistix", "blackjax", "evosax")
Key = tuple[str, str, int]
"""Method, problem and seed."""


@dataclass(frozen=True)
class Run:
    """One run, read again.

    Attributes:
        columns: by name an array with a value for each look; the names and what they are stand in docs/harness.md.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> (run,) = bench.read_runs(path)
        >>> run.key
        ('adam', 'bedroom', 0)
        >>> bool(run["seconds"][0] == 0 and run.last("valid") >= 0)
        True
    """

    columns: dict[str, np.ndarray]

    def __getitem__(self, name: str) -> np.ndarray:
        return self.columns[name]

    def last(self, name: str) -> Any:
        """The value at the end of the run."""
        return self.columns[name][-1]

    @property
    def key(self) -> Key:
        """Method, problem and seed."""
        return str(self.last("method")), str(self.last("problem")), int(self.last("seed"))

    @property
    def failed(self) -> bool:
        """Whether it failed or was killed."""
        return self.last("outcome") in ("failed", "killed")


class Folder:
    """A folder that runs are added to, one by one; a run is there as a whole or not at all."""

    def __init__(self, path: Path, settings: Settings) -> None:
        """Begin or go on. InputError: the folder holds runs that were made with other settings."""
        self.path, self.settings = path, settings
        pyarrow()
        (path / PARTS).mkdir(parents=True, exist_ok=True)
        note = path / SETTINGS
        if note.exists():
            before = json.loads(note.read_text("utf-8"))
            other = [name for name, value in settings.to_dict().items() if before.get(name) != value]
            if other:
                raise InputError(f"out: {path} holds runs with another {', '.join(other)}; give another folder")
        else:
            write_atomic(note, json.dumps(settings.to_dict(), indent=1) + "\n")
        self.done = {run.key for run in read_runs(path)} if any(_files(path)) else set()

    def add(self, rows: Sequence[Row]) -> None:
        """Write the rows of one run."""
        key = rows[0].method, rows[0].problem, rows[0].seed
        name = hashlib.sha256(json.dumps(key).encode()).hexdigest()[:24]
        self._write(self.path / PARTS / f"{name}.parquet", [row.to_dict() for row in rows])
        self.done.add(key)

    def close(self) -> Path:
        """Put all runs into one file."""
        if not _files(self.path):
            return self.path / RESULTS
        runs = sorted(read_runs(self.path), key=lambda run: (run.key[1], run.key[0], run.key[2]))
        rows = [dict(zip(COLUMNS, values, strict=True)) for run in runs for values in _rows_of(run)]
        self._write(self.path / RESULTS, rows)
        shutil.rmtree(self.path / PARTS)
        return self.path / RESULTS

    def _write(self, path: Path, rows: Sequence[dict[str, Any]]) -> None:
        pa = pyarrow()
        table = pa.Table.from_pylist(list(rows), arrow_schema(json.dumps(describe(self.settings)).encode()))
        partly = path.with_name(f".{path.name}.{os.getpid()}")
        pa.parquet.write_table(table, partly)
        os.replace(partly, path)


def describe(settings: Settings) -> dict[str, Any]:
    """What the rows are of: settings, versions, machine."""
    import warp as wp

    device = wp.get_device(settings.device).name if settings.device != "cpu" else platform.processor()
    found = {name: found for name in PACKAGES if (found := _version(name))}
    return {
        "settings": settings.to_dict(),
        "versions": {"python": platform.python_version(), **found},
        "machine": {"system": f"{platform.system()} {platform.machine()}", "cores": os.cpu_count(), "device": device},
    }


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _files(path: Path) -> list[Path]:
    if path.is_file():
        return [path]
    return [*([path / RESULTS] if (path / RESULTS).is_file() else []), *sorted((path / PARTS).glob("[!.]*.parquet"))]


def read_runs(path: Path | str) -> list[Run]:
    """The runs of a folder, or of a Parquet file.

    Raises:
        InputError: there are none, or the file is no such file. MissingDependencyError: pyarrow is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> sorted(run.key[0] for run in bench.read_runs("results"))
        ['adam', 'langevin']
    """
    files = _files(Path(path))
    if not files:
        raise InputError(f"{path}: no results; sceneweaver bench run writes some")
    runs: dict[Key, Run] = {}
    for file in files:
        for run in _read(file):
            runs[run.key] = run
    return list(runs.values())


def read_about(path: Path | str) -> dict[str, Any]:
    """Settings, versions and machine of results, as JSON data.

    Raises:
        InputError: there are none. MissingDependencyError: pyarrow is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> sorted(bench.read_about(path))
        ['machine', 'settings', 'versions']
    """
    files = _files(Path(path))
    pa = pyarrow()
    if not files:
        raise InputError(f"{path}: no results; sceneweaver bench run writes some")
    return json.loads(pa.parquet.read_schema(files[0]).metadata[KEY])


def _read(path: Path) -> Iterable[Run]:
    pa = pyarrow()
    try:
        table = pa.parquet.read_table(path)
    except (pa.ArrowInvalid, OSError) as error:
        raise InputError(f"{path}: no Parquet file: {str(error).splitlines()[0]}") from None
    missing = [name for name in COLUMNS if name not in table.column_names]
    if missing:
        raise InputError(f"{path}: there is no column {missing[0]}; these are no results of sceneweaver bench")
    columns = {name: table[name].to_numpy(zero_copy_only=False) for name in COLUMNS}
    keys = list(zip(*(columns[name].tolist() for name in ("method", "problem", "seed")), strict=True))
    first = [i for i, key in enumerate(keys) if i == 0 or key != keys[i - 1]]
    parts = zip(first, [*first[1:], len(keys)], strict=True)
    return [Run({name: values[a:b] for name, values in columns.items()}) for a, b in parts]


def _rows_of(run: Run) -> Iterable[tuple[Any, ...]]:
    columns = [[None if isinstance(v, float) and np.isnan(v) else v for v in run[name].tolist()] for name in COLUMNS]
    return zip(*columns, strict=True)
