"""The server's side of the processes that do its work: started when needed, asked to stop, and ended in time."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
import time
from collections.abc import Awaitable, Callable, Mapping
from multiprocessing import Pipe
from pathlib import Path
from typing import Any

import anyio

import sceneweaver
from sceneweaver.scene import InputError, MissingDependencyError, SceneWeaverError

from .files import tidy
from .limits import CLOSING, GRACE, Limits

Said = Callable[[float, float | None, str], Awaitable[None]]
"""Reports progress: how much is done, of how much, and what is going on."""


class WorkFailed(SceneWeaverError):
    """A process broke down, or met a fault of the program; the log has the rest."""


class Worker:
    """One process, see `sceneweaver.mcp.worker`."""

    def __init__(self, device: str) -> None:
        self.connection, theirs = Pipe()
        self.run: Path | None = None  # the folder that it writes to
        package = os.path.dirname(os.path.dirname(os.path.abspath(sceneweaver.__file__)))
        paths = [package, *filter(None, [os.environ.get("PYTHONPATH")])]
        with theirs:
            self.process = subprocess.Popen(
                # -P: files in the folder of the scenes are no modules
                [sys.executable, "-P", "-m", "sceneweaver.mcp.worker", str(theirs.fileno()), device],
                stdin=subprocess.DEVNULL,
                stdout=2,
                pass_fds=[theirs.fileno()],
                env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            )

    def end(self, seconds: float) -> None:
        """Wait so long for the process to end by itself, then end it, and clear up after it."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        with contextlib.suppress(OSError):
            self.connection.close()
        if self.run is not None:
            tidy(self.run)

    def retire(self, reason: str) -> None:
        """End a job early: in good order where it takes no longer than `GRACE`."""
        with contextlib.suppress(OSError):
            self.connection.send(("stop", reason))
        began = time.monotonic()
        with contextlib.suppress(OSError, EOFError):
            while self.connection.poll(max(0.0, began + GRACE - time.monotonic())):
                if self.connection.recv()[0] != "progress":
                    break
        with contextlib.suppress(OSError):
            self.connection.close()  # which ends the process
        self.end(CLOSING)


class Lane:
    """One process at a time, and those who wait for it."""

    def __init__(self, device: str, limits: Limits) -> None:
        self._device, self._limits = device, limits
        self._lock = anyio.Lock()
        self._waiting = 0
        self._worker: Worker | None = None
        self._retiring: list[tuple[Worker, threading.Thread]] = []

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
        if self._worker is None or self._worker.process.poll() is not None:
            self._worker = Worker(self._device)
        worker = self._worker
        worker.run = folder
        try:
            with anyio.fail_after(seconds + GRACE):
                worker.connection.send(("job", name, arguments, seconds))
                answer = await self._answer(worker, said)
        except TimeoutError:
            self._drop("time was up")
            raise InputError(f"{name}: stopped after {seconds:g} s; ask for less, or give more time") from None
        except (EOFError, OSError):
            self._drop("lost")
            raise WorkFailed(f"{name}: the process that did it has ended, perhaps for want of memory") from None
        except BaseException:
            self._drop("the client has cancelled it")
            raise
        worker.run = None
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

    def _drop(self, reason: str) -> None:
        """Let a process end in the background; the next job gets a new one."""
        worker, self._worker = self._worker, None
        self._retiring = [(each, thread) for each, thread in self._retiring if thread.is_alive()]
        if worker is not None:
            thread = threading.Thread(target=worker.retire, args=(reason,), daemon=True)
            self._retiring.append((worker, thread))
            thread.start()

    def workers(self) -> list[Worker]:
        """All processes that may still run."""
        return [*([self._worker] if self._worker else []), *(worker for worker, _ in self._retiring)]


class Workers:
    """The processes of a server: one for what takes long, one for what does not."""

    def __init__(self, device: str, limits: Limits) -> None:
        self.limits = limits
        self.long = Lane(device, limits)
        self.quick = Lane(device, limits)

    def close(self) -> None:
        """End all processes within `CLOSING` seconds, and clear up after them."""
        workers = [*self.long.workers(), *self.quick.workers()]
        for worker in workers:
            with contextlib.suppress(OSError):
                worker.connection.close()
        until = time.monotonic() + CLOSING
        for worker in workers:
            worker.end(max(0.0, until - time.monotonic()))
