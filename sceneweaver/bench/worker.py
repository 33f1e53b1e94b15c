"""Runs in a process of their own, which may crash or hang without an end to the comparison."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace
from multiprocessing.connection import Connection

from sceneweaver.runtime import processes

from .clock import settle
from .execute import Prepared, blank, execute
from .methods import Method
from .schema import Row
from .settings import Settings
from .tasks import Task


class Worker:
    """A process that runs one method on one problem at a time; a new one takes its place where it had to end."""

    def __init__(self) -> None:
        self._process: processes.Worker | None = None

    def execute(self, method: Method, task: Task, seed: int, settings: Settings) -> Iterator[Row]:
        """Rows as of `execute.execute`; the last one says so where the process was killed or crashed."""
        row, limit = blank(method, task, seed, settings), time.monotonic() + settings.limit
        end = self._send((method, task, seed, settings))
        while True:
            if not end.poll(max(limit - time.monotonic(), 0.0)):
                self.close()
                reason = f"killed after {settings.limit:g} s"
                break
            try:
                found = end.recv()
            except EOFError:
                reason = f"the process ended by itself, exit code {self.close()}"
                break
            if isinstance(found, bool):
                if not found:
                    self.close()
                return
            row = found
            yield row
        yield replace(row, checkpoint=row.checkpoint + 1, outcome="killed", reason=reason)

    def _send(self, order: tuple[Method, Task, int, Settings]) -> Connection:
        if self._process is None or not self._process.alive:
            self.close()
            self._process = processes.Worker(serve, threads=None)
        self._process.connection.send(order)
        return self._process.connection

    def close(self) -> int | None:
        """End the process; its exit code."""
        process, self._process = self._process, None
        return process.end(1.0) if process is not None else None


def serve(end: Connection) -> None:
    """Do what is asked for until nobody asks any more. Whether the device still works follows the last row of a run."""
    prepared = Prepared()
    while True:
        try:
            method, task, seed, settings = end.recv()
        except EOFError:
            return
        for row in execute(method, task, seed, settings, prepared):
            end.send(row)
        end.send(works(settings.device))


def works(device: str) -> bool:
    """Whether a device still works for this process: an error of CUDA stays for good."""
    try:
        settle(device)
    except Exception:  # Warp and PyTorch raise their own
        return False
    return True
