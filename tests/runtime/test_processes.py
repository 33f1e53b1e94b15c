"""Worker processes: which of them may start processes of their own, and that these end with them."""

from __future__ import annotations

import time
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from sceneweaver.runtime import processes


def spawning(connection: Connection) -> None:
    """Start a process that waits, say its number or what stands against it, and wait for the end."""
    try:
        other = processes.Worker(waiting)
        connection.send(other.pid)
    except AssertionError as error:  # of multiprocessing
        connection.send(str(error))
    waiting(connection)


def waiting(connection: Connection) -> None:
    """Wait until the other end is closed."""
    try:
        connection.recv()
    except EOFError:
        return


@pytest.mark.parametrize("how", ["in order", "killed"])
def test_a_worker_that_may_start_others_takes_them_along(how):
    worker = processes.Worker(spawning, starts_others=True)
    assert worker.connection.poll(60)
    pid = worker.connection.recv()
    assert isinstance(pid, int) and Path(f"/proc/{pid}").exists()
    worker.end(30.0 if how == "in order" else 0.0)
    until = time.monotonic() + 30
    while Path(f"/proc/{pid}").exists() and time.monotonic() < until:
        time.sleep(0.05)
    assert not Path(f"/proc/{pid}").exists() and not worker.alive


def test_other_workers_start_none():
    worker = processes.Worker(spawning)
    assert worker.connection.poll(60)
    assert "daemonic" in worker.connection.recv()
    worker.end()
