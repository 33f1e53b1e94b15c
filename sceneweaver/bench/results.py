"""The results of a comparison: columns, a file for every run that is done, one file in the end; and reading them."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import shutil
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import numpy as np

from sceneweaver.io import load_json, open_parquet, parse_json, write_atomic
from sceneweaver.runtime.package import missing_extra, package_version
from sceneweaver.scene import InputError, MissingDependencyError

from .settings import Settings


def needed(name: str) -> Any:
    """A module that the extra ``bench`` brings.

    Raises:
        MissingDependencyError: it is not installed.
    """
    try:
        return import_module(name)
    except ImportError:
        package = name.partition(".")[0]
        raise MissingDependencyError(missing_extra("bench", f"{package} is not installed")) from None


def pyarrow() -> Any:
    """The package, with what reads and writes Parquet."""
    needed("pyarrow.parquet")
    return needed("pyarrow")


KEY = b"sceneweaver.bench"  # of the file's metadata: JSON, see `results.describe`


@dataclass(frozen=True)
class Row:
    """One look at a run: each field with the type of its column in Parquet and what it is."""

    method: Annotated[str, "string", "name of the optimiser"]
    problem: Annotated[str, "string", "name of the problem"]
    family: Annotated[str, "string", "family of the problem"]
    problem_hash: Annotated[str, "string", "of what the problem was, SHA-256"]
    objects: Annotated[int, "int32", "objects of the problem"]
    variables: Annotated[int, "int32", "coordinates that may change"]
    best_known: Annotated[float | None, "float64", "lowest energy of a valid layout known before [m], or null"]
    seed: Annotated[int, "int64", "of the starts and of the method"]
    candidates: Annotated[int, "int32", "layouts that the method moves at once"]
    checkpoint: Annotated[int, "int32", "number of the look, 0 before the first step"] = 0
    steps: Annotated[int, "int64", "steps of the method so far"] = 0
    rounds: Annotated[int, "int32", "how often it began, the first time included"] = 0
    seconds: Annotated[float, "float64", "time spent in the method by the run's clock, without looks and setup"] = 0.0
    wall_seconds: Annotated[float, "float64", "the same by the wall clock, the device synchronised"] = 0.0
    cpu_seconds: Annotated[float, "float64", "the same as processor time of all threads"] = 0.0
    setup_seconds: Annotated[
        float, "float64", "wall time of the uncounted first steps: kernels and functions are compiled"
    ] = 0.0
    energy_calls: Annotated[int, "int64", "how often the method asked for energies"] = 0
    evaluations: Annotated[int, "int64", "layouts whose energy it measured"] = 0
    valid: Annotated[float, "float64", "share of candidates that the engine calls valid"] = 0.0
    distinct: Annotated[int, "int32", "valid layouts, any two with an object 0.5 m or 45 degrees apart"] = 0
    best_energy: Annotated[float | None, "float64", "lowest energy of any candidate [m]"] = None
    best_valid_energy: Annotated[
        float | None, "float64", "lowest energy of a valid candidate [m]; null: none is valid"
    ] = None
    median_energy: Annotated[float | None, "float64", "of all candidates [m]"] = None
    best_objective: Annotated[
        float | None, "float64", "lowest objective of a valid candidate; null: none is valid, or no objective"
    ] = None
    known_objective: Annotated[
        float | None, "float64", "lowest objective of a valid layout known before, or null: being valid is all"
    ] = None
    budget: Annotated[
        float | None, "float64", "of the settings, [s]: the look is at what there was when it was spent; or null"
    ] = None
    layout: Annotated[
        bytes | None,
        "binary",
        "at budgets and at the end: the best valid poses [N, 4], float32, little-endian; or null",
    ] = None
    outcome: Annotated[str, "string", '"running"; at the last look "ended", "budget", "failed" or "killed"'] = "running"
    reason: Annotated[str, "string", "why it failed or was killed, in one line; empty otherwise"] = ""


COLUMNS: dict[str, tuple[str, str]] = {
    name: hint.__metadata__ for name, hint in get_type_hints(Row, include_extras=True).items()
}
"""The type and the meaning of each column of results."""


def arrow_schema(metadata: bytes) -> Any:
    """The schema of a file, with its metadata."""
    pa = pyarrow()
    fields = [
        pa.field(name, pa.type_for_alias(kind), metadata={"about": about}) for name, (kind, about) in COLUMNS.items()
    ]
    return pa.schema(fields, metadata={KEY: metadata})


RESULTS, PARTS, SETTINGS = "results.parquet", "runs", "settings.json"
PACKAGES = ("warp-lang", "numpy", "jax", "torch", "optax", "optimistix", "blackjax", "evosax")
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

    def at(self, budget: float) -> Run:
        """The run as if its budget had been ``budget`` [s], one of its settings; what happened later is left out.

        A run that ended before stays as it is, and so does one that failed or was killed before.
        """
        there = np.flatnonzero(np.asarray(self["budget"], dtype=float) == budget)
        if not there.size:
            return self
        cut = {name: values[: there[0] + 1] for name, values in self.columns.items()}
        outcome = cut["outcome"].copy()
        outcome[-1] = "budget"
        return Run({**cut, "outcome": outcome})

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
        if note.exists() and _files(path):
            before = load_json(note)
            other = [name for name, value in settings.to_dict().items() if before.get(name) != value]
            if other:
                raise InputError(f"out: {path} holds runs with another {', '.join(other)}; give another folder")
        else:
            write_atomic(note, json.dumps(settings.to_dict(), indent=1) + "\n")
        self.done = {run.key for run in read_runs(path)} if _files(path) else set()

    def add(self, rows: Sequence[Row]) -> None:
        """Write the rows of one run."""
        key = rows[0].method, rows[0].problem, rows[0].seed
        name = hashlib.sha256(json.dumps(key).encode()).hexdigest()[:24]
        self._write(self.path / PARTS / f"{name}.parquet", [asdict(row) for row in rows])
        self.done.add(key)

    def close(self) -> Path:
        """Put all runs into one file."""
        if not (self.path / PARTS).exists() or not _files(self.path):
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


@cache
def describe(settings: Settings) -> dict[str, Any]:
    """What the rows are of: settings, versions, machine."""
    import warp as wp

    device = wp.get_device(settings.device).name if settings.device != "cpu" else _processor()
    found = {name: found for name in PACKAGES if (found := _version(name))}
    return {
        "settings": settings.to_dict(),
        "versions": {"python": platform.python_version(), "sceneweaver": package_version(), **found},
        "machine": {"system": f"{platform.system()} {platform.machine()}", "cores": os.cpu_count(), "device": device},
    }


def _processor() -> str:
    """The name of the processor, as far as the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _files(path: Path) -> list[Path]:
    if path.is_file():
        return [path]
    return [*([path / RESULTS] if (path / RESULTS).is_file() else []), *sorted((path / PARTS).glob("[!.]*.parquet"))]


def _results(path: Path | str) -> list[Path]:
    files = _files(Path(path))
    if not files:
        raise InputError(f"{path}: no results; sceneweaver bench run writes some")
    return files


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
    return list({run.key: run for file in _results(path) for run in _read(file)}.values())


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
    with open_parquet(_results(path)[0]) as file:
        about = (file.schema_arrow.metadata or {}).get(KEY)
    if about is None:
        raise InputError(f"{path}: does not say of which settings it is; these are no results of sceneweaver bench")
    return parse_json(about)


def _read(path: Path) -> Iterable[Run]:
    with open_parquet(path) as file:
        table = file.read()
    missing = [name for name in COLUMNS if name not in table.column_names]
    if missing:
        raise InputError(f"{path}: there is no column {missing[0]}; these are no results of sceneweaver bench")
    columns = {name: table[name].to_numpy(zero_copy_only=False) for name in COLUMNS}
    keys = list(zip(*(columns[name].tolist() for name in ("method", "problem", "seed")), strict=True))
    if not keys:
        raise InputError(f"{path}: there is no row in it; these are no results of sceneweaver bench")
    first = [i for i, key in enumerate(keys) if i == 0 or key != keys[i - 1]]
    parts = zip(first, [*first[1:], len(keys)], strict=True)
    return [Run({name: values[a:b] for name, values in columns.items()}) for a, b in parts]


def _rows_of(run: Run) -> Iterable[tuple[Any, ...]]:
    columns = [[None if isinstance(v, float) and np.isnan(v) else v for v in run[name].tolist()] for name in COLUMNS]
    return zip(*columns, strict=True)
