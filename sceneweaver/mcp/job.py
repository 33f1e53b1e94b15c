"""What every job of a worker process is given."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sceneweaver.scene import Scene

if TYPE_CHECKING:
    from sceneweaver.runtime.deadline import Stop


@dataclass(frozen=True)
class Job:
    """The device, how to report progress, who asks the job to stop, and the seconds that it has."""

    device: str
    say: Callable[[float, float | None, str], None]
    stop: Stop
    seconds: float


def report_of(scene: Scene) -> dict[str, Any]:
    """The judge's report as the data of metrics.json."""
    from sceneweaver.verify import check

    return check(scene).to_dict()


def drawing_device(device: str) -> str:
    """Where pictures are drawn by who computes on a device: one GPU that is named, else the CPU."""
    return {"cuda": "cuda:0"}.get(device, device if device[5:].isdigit() else "cpu")
