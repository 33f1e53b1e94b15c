"""What a comparison is run with."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

from sceneweaver.scene import InputError

CLOCKS = ("wall", "cpu")
STARTS = ("sample", "random", "perturbed")


@dataclass(frozen=True)
class Settings:
    """The same for every run of a comparison.

    Attributes:
        candidates: layouts that a method moves at once.
        seconds: budget of a run by ``clock`` [s]. A step that ends later does not count.
        budgets: shorter budgets [s] at which the same run is read: what the last step that ended by then left.
        evaluations: budget in layouts measured; None: no such budget.
        clock: "wall", or "cpu": the processor time of all threads, for machines with other work to do.
        device: a Warp device.
        start: where candidates start, see `ProblemCase.start`; the same layouts for every method.
        checkpoints: looks at a run besides those at its start and its end, at times in equal ratios over three decades.
        restarts: a method that ends before the budget is spent begins again from new starts, as long as a candidate is
            not valid; each candidate keeps its best layout.
        enough: a run ends with the first look at a valid layout, where the problem has no objective.
        limit: seconds by ``clock`` after which a run is killed, with all that is not in its budget (compiling, looks);
            where the clock is "cpu" six times as many by the wall clock as well.
        memory: GiB of memory that a run may add to its process before it is killed; None: any.

    Raises:
        InputError: a value out of range.

    Examples:
        >>> from sceneweaver import bench
        >>> bench.Settings(candidates=32, seconds=2.0, clock="cpu").restarts
        True
        >>> bench.Settings(seconds=1.0, budgets=(0.3, 0.1)).readings
        (0.1, 0.3, 1.0)
    """

    candidates: int = 64
    seconds: float = 5.0
    evaluations: int | None = None
    clock: str = "wall"
    device: str = "cpu"
    start: str = "sample"
    checkpoints: int = 16
    restarts: bool = True
    budgets: tuple[float, ...] = ()
    enough: bool = False
    limit: float = 300.0
    memory: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "budgets", tuple(self.budgets))
        for name in ("candidates", "checkpoints"):
            if not isinstance(getattr(self, name), int) or getattr(self, name) < 1:
                raise InputError(f"{name}: {getattr(self, name)!r} is not a whole number of at least 1")
        if self.evaluations is not None and self.evaluations < 1:
            raise InputError(f"evaluations: {self.evaluations!r} is not at least 1")
        for name in ("seconds", "limit"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0):
                raise InputError(f"{name}: {getattr(self, name)!r} is not a number of seconds above 0")
        if not all(0 < each <= self.seconds for each in self.budgets):
            raise InputError(f"budgets: {self.budgets!r} are not seconds above 0 and up to {self.seconds:g}")
        if self.memory is not None and not self.memory > 0:
            raise InputError(f"memory: {self.memory!r} is not above 0 GiB")
        if self.clock not in CLOCKS:
            raise InputError(f'clock: "{self.clock}" is not one of {", ".join(CLOCKS)}')
        if self.start not in STARTS:
            raise InputError(f'start: "{self.start}" is not one of {", ".join(STARTS)}')
        if self.clock == "cpu" and self.device.startswith("cuda"):
            raise InputError('clock: "cpu" does not see what a GPU does; give wall')

    def to_dict(self) -> dict[str, Any]:
        """As JSON data."""
        return {**asdict(self), "budgets": list(self.budgets)}

    @property
    def readings(self) -> tuple[float, ...]:
        """All budgets at which a run is read [s], the longest last."""
        return tuple(sorted({*self.budgets, self.seconds}))

    @property
    def looks(self) -> list[float]:
        """Times of the looks at a run [s], the last at the end of the budget."""
        last = max(self.checkpoints - 1, 1)
        return [self.seconds * 1000.0 ** (k / last - 1.0) for k in range(self.checkpoints)]
