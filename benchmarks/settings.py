"""What a run of the benchmarks was asked to do."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "out" / "benchmarks"


@dataclass(frozen=True)
class Settings:
    """Options shared by all families.

    Attributes:
        rooms: zoo rooms to use; empty: those of the family.
        kinds: kinds of rooms to design; empty: those of the family.
        programmes: programmes of homes to plan; empty: those of the family.
        variants: variants of the agent to compare; empty: all of the family.
        designs: designs that were made before, for a family that reads such; empty: it makes new ones.
        device: as for ``sceneweaver.refine``.
        quick: small sizes, to see that everything works; the numbers mean little.
        everything: the families that use a few rooms use all of them.
        seed: first seed; runs with other seeds count up from it.
        most: at most so many candidates a call; None: as many as the family says.
        count: designs of a family that makes many of one kind; None: as many as the family says.
        jobs: processes of the judge, and of designs that are made side by side.
        rivals: names of rivals to run; None: all that are there.
        out: folder for results and for layouts that contradict the judge.
        commit: commit to note when there is no git checkout; None: ask git.
    """

    rooms: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    programmes: tuple[str, ...] = ()
    variants: tuple[str, ...] = ()
    designs: tuple[Path, ...] = ()
    device: str = "auto"
    quick: bool = False
    everything: bool = False
    seed: int = 0
    most: int | None = None
    count: int | None = None
    jobs: int = 1
    rivals: tuple[str, ...] | None = None
    out: Path = OUT
    commit: str | None = None

    def size(self, full: int, quick: int) -> int:
        """A number of candidates: the full or the quick one, at most ``most``."""
        wanted = quick if self.quick else full
        return wanted if self.most is None else min(wanted, self.most)

    def options(self) -> dict[str, Any]:
        """The options that shape the numbers, as JSON data."""
        data = asdict(self)
        for name in ("out", "commit"):
            del data[name]
        data["designs"] = [str(path) for path in self.designs]
        return {k: list(v) if isinstance(v, tuple) else v for k, v in data.items()}
