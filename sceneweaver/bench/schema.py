"""One row of results: a look at a run. Written as Parquet, with what the comparison is of as metadata of the file."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

KEY = b"sceneweaver.bench"  # of the file's metadata: JSON, see `results.describe`

COLUMNS = {
    "method": ("string", "name of the optimiser"),
    "problem": ("string", "name of the problem"),
    "family": ("string", "family of the problem"),
    "problem_hash": ("string", "of what the problem was, SHA-256"),
    "objects": ("int32", "objects of the problem"),
    "variables": ("int32", "coordinates that may change"),
    "best_known": ("float64", "lowest energy of a valid layout known before [m], or null"),
    "seed": ("int64", "of the starts and of the method"),
    "candidates": ("int32", "layouts that the method moves at once"),
    "checkpoint": ("int32", "number of the look, 0 before the first step"),
    "steps": ("int64", "steps of the method so far"),
    "rounds": ("int32", "how often it began, the first time included"),
    "seconds": ("float64", "time spent in the method by the run's clock, without looks and setup"),
    "wall_seconds": ("float64", "the same by the wall clock, the device synchronised"),
    "cpu_seconds": ("float64", "the same as processor time of all threads"),
    "setup_seconds": ("float64", "wall time of the uncounted first step: kernels and functions are compiled"),
    "energy_calls": ("int64", "how often the method asked for energies"),
    "evaluations": ("int64", "layouts whose energy it measured"),
    "valid": ("float64", "share of candidates that the engine calls valid"),
    "distinct": ("int32", "valid layouts, any two with an object 0.5 m or 45 degrees apart"),
    "best_energy": ("float64", "lowest energy of any candidate [m]"),
    "best_valid_energy": ("float64", "lowest energy of a valid candidate [m]; null: none is valid"),
    "median_energy": ("float64", "of all candidates [m]"),
    "outcome": ("string", '"running"; at the last look "ended", "budget", "failed" or "killed"'),
    "reason": ("string", "why it failed or was killed, in one line; empty otherwise"),
}


@dataclass(frozen=True)
class Row:
    """One look at a run; `COLUMNS` says what the fields are."""

    method: str
    problem: str
    family: str
    problem_hash: str
    objects: int
    variables: int
    best_known: float | None
    seed: int
    candidates: int
    checkpoint: int = 0
    steps: int = 0
    rounds: int = 0
    seconds: float = 0.0
    wall_seconds: float = 0.0
    cpu_seconds: float = 0.0
    setup_seconds: float = 0.0
    energy_calls: int = 0
    evaluations: int = 0
    valid: float = 0.0
    distinct: int = 0
    best_energy: float | None = None
    best_valid_energy: float | None = None
    median_energy: float | None = None
    outcome: str = "running"
    reason: str = ""

    def to_dict(self) -> dict[str, Any]:
        """By column."""
        return asdict(self)


def arrow_schema(metadata: bytes) -> Any:
    """The schema of a file, with its metadata."""
    from .extras import pyarrow

    pa = pyarrow()
    fields = [
        pa.field(name, pa.type_for_alias(kind), metadata={"about": about}) for name, (kind, about) in COLUMNS.items()
    ]
    return pa.schema(fields, metadata={KEY: metadata})
