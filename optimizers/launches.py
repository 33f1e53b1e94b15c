"""Kernel launches repeated without a look from the host: recorded once, as a graph on a GPU."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import warp as wp

from sceneweaver.kernels import load_for

from .base import Monitor


class Launches:
    """A block of launches whose arguments never change; what changes from step to step lives in arrays.

    On a GPU a block that is repeated becomes a CUDA graph. On a CPU pieces of a batch run in threads, where nothing may
    be captured; there the prepared commands are replayed one by one, which saves the packing of their arguments.
    """

    def __init__(self, device: str, unroll: int = 1) -> None:
        """``unroll``: how often a graph holds the block; also how many blocks pass between two looks at the time."""
        self.device = device
        self.unroll = unroll
        self._commands: list[Callable[[], None]] = []
        self._keep: list[Any] = []  # the commands hold addresses only

    def add(self, kernel: Any, dim: Any, inputs: Sequence[Any], outputs: Sequence[Any], block: int = 256) -> None:
        """Append a launch in blocks of ``block`` threads. Nothing runs yet."""
        load_for(kernel, self.device, block)
        command = wp.launch(kernel, dim, [*inputs], [*outputs], device=self.device, record_cmd=True, block_dim=block)
        if command is not None:  # a launch of no threads is none
            self._commands.append(command.launch)
            self._keep.append((inputs, outputs))

    def add_loop(self, condition: wp.array, body: Launches) -> None:
        """Append another block, to be run as long as ``condition[0]``, which its kernels write, is not zero."""
        self._commands.append(partial(wp.capture_while, condition, body.run))

    def __len__(self) -> int:
        return len(self._commands)

    def run(self) -> None:
        """Run the block once."""
        for command in self._commands:
            command()

    def play(self, monitor: Monitor, times: int = 1, rest: int = 0) -> bool:
        """Run the block ``times`` times, then its first ``rest`` launches; False when time ran out before the end."""
        stretches, left = divmod(times, self.unroll)
        graph = self._graph() if stretches > 1 and self.device != "cpu" else None
        for _ in range(stretches):
            if self._expired(monitor):
                return False
            if graph is None:
                if not self._run(self._commands * self.unroll, monitor):
                    return False
            else:
                wp.capture_launch(graph)
        last = self._commands * left + self._commands[:rest]
        if last and (self._expired(monitor) or not self._run(last, monitor)):
            return False
        if graph is not None:
            wp.synchronize_device(self.device)  # to let go of a graph that runs would hold up other devices' threads
        return True

    def _run(self, commands: Sequence[Callable[[], None]], monitor: Monitor) -> bool:
        for command in commands:
            if monitor.broken_off:
                return False
            command()
        return True

    def _graph(self) -> Any:
        with wp.ScopedCapture(device=self.device, force_module_load=False) as capture:  # recording loaded the modules
            for command in self._commands * self.unroll:
                command()
        return capture.graph

    def _expired(self, monitor: Monitor) -> bool:
        if monitor.deadline is not None and self.device != "cpu":
            wp.synchronize_device(self.device)  # else all would be in the queue before the first is done
        return monitor.expired()


def blocks_of(steps: int, size: int, whole: bool, block: Launches, monitor: Monitor) -> Iterator[int]:
    """Run a block so many times, unless time runs out; how often so far, after every ``size`` times or at the end."""
    done = 0
    while done < steps and not monitor.timed_out:
        times = steps - done if whole else min(size, steps - done)
        block.play(monitor, times)
        done += times
        yield done


def repeat_while(device: str, more: wp.array, block: Launches) -> None:
    """Run a block on a GPU as long as ``more[0]``, which its kernels write, is not zero; the GPU itself decides."""
    with wp.ScopedCapture(device=device) as capture:
        wp.capture_while(more, block.run)
    assert capture.graph is not None
    wp.capture_launch(capture.graph)
    wp.synchronize_device(device)  # to let go of a graph that runs would hold up the other devices' threads


def repeatable(device: str, block: Launches) -> Callable[[], None]:
    """A block ready to be run again and again: on a GPU it is recorded once, as a graph."""
    if device == "cpu":
        return block.run
    with wp.ScopedCapture(device=device) as capture:
        block.run()
    assert capture.graph is not None
    return partial(wp.capture_launch, capture.graph)
