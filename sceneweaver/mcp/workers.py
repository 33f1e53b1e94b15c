"""The server's side of the processes that do its work: started when needed, asked to stop, and ended in time."""

from __future__ import annotations

import atexit
import contextlib
import os
import threading
import time
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path
from typing import Any

import anyio

from sceneweaver.runtime import processes
from sceneweaver.scene import InputError, MissingDependencyError, SceneWeaverError

from .files import tidy
from .limits import CLOSING, GRACE, Limits
from .worker import serve

Said = Callable[[float, float | None, str], Awaitable[None]]
"""Reports progress: how much is done, of how much, and what is going on."""


class WorkFailed(SceneWeaverError):
    """A process broke down, or met a fault of the program; the log has the rest."""


class Worker:
    """One process, see `sceneweaver.mcp.worker`."""

    def __init__(self, device: str) -> None:
        self.process = processes.Worker(serve, device, threads=None, killed_with_parent=False, starts_others=True)
        self.connection = self.process.connection
        self.run: Path | None = None  # the folder that it writes to
        self._ending = threading.Lock()

    def end(self, seconds: float) -> None:
        """Wait so long for the process to end by itself, then end it, and clear up after it, once.

        A second thread that ends it waits for the first: one that clears up while the server's own process ends would
        leave its lock behind.
        """
        with self._ending:
            self.process.end(seconds)
            run, self.run = self.run, None
            if run is not None:
                tidy(run)

    def retire(self, reason: str) -> None:
        """End a job early: in good order where it takes no longer than `GRACE`."""
        with contextlib.suppress(OSError):
            self.connection.send(("stop", reason))
        began = time.monotonic()
        with contextlib.suppress(OSError, EOFError):
            while self.connection.poll(max(0.0, began + GRACE - time.monotonic())):
                if self.connection.recv()[0] != "progress":
                    break
        self.end(CLOSING)


class Pool:
    """Processes that are free, and those that end in the background."""

    def __init__(self, device: str) -> None:
        self._device = device
        self._all: list[Worker] = []
        self._free: list[Worker] = []
        atexit.register(self.close)  # before Python waits for processes that know nothing of its end

    def take(self, usual: Worker | None) -> Worker:
        """The usual process if it is free, else one that is, else a new one."""
        self._all = [worker for worker in self._all if worker.process.alive]
        free = [worker for worker in self._free if worker in self._all]
        if not free:
            worker = Worker(self._device)
            self._all.append(worker)
            return worker
        worker = usual if usual in free else free[0]
        self._free = [each for each in free if each is not worker]
        return worker

    def give_back(self, worker: Worker) -> None:
        """A process is free again."""
        self._free.append(worker)

    def drop(self, worker: Worker, reason: str) -> None:
        """Let a process end in the background; it is not taken again."""
        threading.Thread(target=worker.retire, args=(reason,), daemon=True).start()

    def close(self) -> None:
        """End all processes within `CLOSING` seconds, and clear up after them."""
        for worker in self._all:
            with contextlib.suppress(OSError):
                worker.connection.close()
        until = time.monotonic() + CLOSING
        for worker in self._all:
            worker.end(max(0.0, until - time.monotonic()))


class Lane:
    """Calls that are done one after the other."""

    def __init__(self, pool: Pool, limits: Limits) -> None:
        self._pool, self._limits = pool, limits
        self._lock = anyio.Lock()
        self._waiting = 0
        self._usual: Worker | None = None

    async def run(
        self, name: str, arguments: Mapping[str, Any], said: Said, *, seconds: float, folder: Path | None = None
    ) -> Any:
        """Do a job when its turn has come; cancelled, it is asked to stop.

        Args:
            name: of the job, in `sceneweaver.mcp.jobs.JOBS`.
            arguments: of the job.
            said: reports progress.
            seconds: after which it stops by itself, and soon after that is stopped.
            folder: what a design writes to.

        Raises:
            InputError: what the job says, that too many wait, or that time is up.
            WorkFailed: a fault.
        """
        if self._waiting >= self._limits.waiting:
            raise InputError(f"{name}: {self._waiting} calls wait already; try again when one has ended")
        self._waiting += 1
        try:
            if self._lock.locked():
                await said(0, None, "waiting for other work to end")
            await self._lock.acquire()
        finally:
            self._waiting -= 1
        try:
            return await self._do(name, dict(arguments), said, seconds, folder)
        finally:
            self._lock.release()

    async def _do(self, name: str, arguments: dict[str, Any], said: Said, seconds: float, folder: Path | None) -> Any:
        worker = self._usual = self._pool.take(self._usual)
        worker.run = folder
        try:
            with anyio.fail_after(seconds + GRACE):
                worker.connection.send(("job", name, arguments, seconds))
                answer = await self._answer(worker, said)
        except TimeoutError:
            self._pool.drop(worker, "time was up")
            raise InputError(f"{name}: stopped after {seconds:g} s; ask for less, or give more time") from None
        except (EOFError, OSError):
            self._pool.drop(worker, "lost")
            raise WorkFailed(f"{name}: the process that did it has ended, perhaps for want of memory") from None
        except BaseException:
            self._pool.drop(worker, "the client has cancelled it")
            raise
        worker.run = None
        self._pool.give_back(worker)
        match answer:
            case ("done", result):
                return result
            case (_, "missing", message):
                raise MissingDependencyError(message)
            case (_, "input" | "late", message):
                raise InputError(message)
            case (_, _, fault):
                raise WorkFailed(f"{name}: unexpected {fault}; the server's log says where")

    async def _answer(self, worker: Worker, said: Said) -> tuple[Any, ...]:
        while True:
            await anyio.wait_readable(worker.connection.fileno())
            os.set_blocking(worker.connection.fileno(), True)  # which uvloop has changed
            answer = worker.connection.recv()
            if answer[0] != "progress":
                return answer
            await said(*answer[1:])


class Workers:
    """The processes of a server: as many as work at once, which is one on what takes long and one on what does not."""

    def __init__(self, device: str, limits: Limits) -> None:
        pool = Pool(device)
        self.long, self.quick = Lane(pool, limits), Lane(pool, limits)
        self.close = pool.close
