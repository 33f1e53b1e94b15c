"""A process that does one job after the other for the server, and can be asked to end one early.

Jobs come as ``("job", name, arguments, seconds)``, a
wish to end the running one as ``("stop", reason)``; what goes back is ``("progress", done, total, message)`` and at
last ``("done", result)`` or ``("failed", kind, message)``. The jobs run in the main thread, where time limits work in
the middle of anything. When the connection ends, so does the process.
"""

from __future__ import annotations

import os
import queue
import signal
import threading
import time
import traceback
from multiprocessing.connection import Connection
from typing import Any

from sceneweaver.io import MissingDependencyError, SceneWeaverError
from sceneweaver.runtime.deadline import Deadline, Stop, TimeUp

from .jobs import JOBS, LONG_RUNNERS, Job

LAST = 0.6
"""Seconds that a job has to clear up when the server is gone."""


class Inbox:
    """Reads the connection in a thread of its own, so that a stop is heard while a job runs."""

    def __init__(self, connection: Connection) -> None:
        self._connection, self._stop = connection, Stop()
        self.jobs: queue.SimpleQueue[tuple[str, dict[str, Any], float, Stop] | None] = queue.SimpleQueue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        while True:
            try:
                kind, *rest = self._connection.recv()
            except (EOFError, OSError):
                self._stop.allowance = 0.0
                self._stop.request("the end of the server")
                self.jobs.put(None)
                time.sleep(LAST)
                os._exit(0)
            if kind == "stop":
                self._stop.request(rest[0])
            else:
                self._stop = Stop()
                self.jobs.put((*rest, self._stop))


def serve(connection: Connection, device: str) -> None:
    """Do jobs until the connection ends; what anything prints goes to stderr."""
    for number in (signal.SIGINT, signal.SIGTERM):  # they are for the server, which ends us in order
        signal.signal(number, signal.SIG_IGN)
    os.dup2(2, 1)
    inbox = Inbox(connection)
    while (job := inbox.jobs.get()) is not None:
        answer = _answer(connection, device, *job)
        try:
            connection.send(answer)
        except OSError:
            break
    os._exit(0)  # nothing is left to clear up, and the server waits


def _answer(
    connection: Connection, device: str, name: str, arguments: dict[str, Any], seconds: float, stop: Stop
) -> tuple[Any, ...]:
    def say(done: float, total: float | None, message: str) -> None:
        connection.send(("progress", done, total, message))

    job = Job(device, say, stop, seconds)
    try:
        if name in LONG_RUNNERS:  # they watch the time themselves
            return "done", JOBS[name](job, **arguments)
        with Deadline(time.monotonic() + seconds, stop=stop).enforced():
            return "done", JOBS[name](job, **arguments)
    except TimeUp:
        return "failed", "late", f"{name}: stopped after {seconds:g} s; ask for less, or give more time"
    except MissingDependencyError as error:
        return "failed", "missing", str(error)
    except SceneWeaverError as error:
        return "failed", "input", str(error)
    except Exception as error:
        traceback.print_exc()
        return "failed", "fault", type(error).__name__
