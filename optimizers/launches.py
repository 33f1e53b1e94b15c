"""Kernel launches in a fixed order, repeated without a look from the host: recorded once, as a graph on a GPU."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import warp as wp

from .base import Monitor


class Launches:
    """A block of launches whose arguments never change; what changes from step to step lives in arrays.

    On a GPU a block that is repeated becomes a CUDA graph. On a CPU pieces of a batch run in threads, where nothing may
    be captured; there the prepared commands are replayed one by one, which saves the packing of their arguments.
    """

    def __init__(self, device: str) -> None:
        self.device = device
        self._commands: list[Any] = []
        self._keep: list[Any] = []  # the commands hold addresses only

    def add(self, kernel: Any, dim: Any, inputs: Sequence[Any], outputs: Sequence[Any]) -> None:
        """Append a launch. Nothing runs yet."""
        command = wp.launch(kernel, dim, [*inputs], [*outputs], device=self.device, record_cmd=True)
        self._commands.append(command)
        self._keep.append((inputs, outputs))

    def __len__(self) -> int:
        return len(self._commands)

    def play(self, monitor: Monitor, times: int = 1, rest: int = 0) -> bool:
        """Run the block ``times`` times, then its first ``rest`` launches; False when time ran out before the end."""
        graph = self._graph() if times > 1 and self.device != "cpu" else None
        for _ in range(times):
            if self._expired(monitor):
                return False
            if graph is None:
                self._run(len(self))
            else:
                wp.capture_launch(graph)
        if rest:
            if self._expired(monitor):
                return False
            self._run(rest)
        return True

    def _run(self, count: int) -> None:
        for command in self._commands[:count]:
            command.launch()

    def _graph(self) -> Any:
        with wp.ScopedCapture(device=self.device, force_module_load=False) as capture:  # recording loaded the modules
            self._run(len(self))
        return capture.graph

    def _expired(self, monitor: Monitor) -> bool:
        if monitor.deadline is not None and self.device != "cpu":
            wp.synchronize_device(self.device)  # else all would be in the queue before the first is done
        return monitor.expired()
