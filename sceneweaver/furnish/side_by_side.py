"""Rooms made side by side in processes that stay for all plans of a design, or one after the other in this one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, suppress
from types import TracebackType

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.runtime import processes
from sceneweaver.runtime.deadline import Deadline

from .jobs import FurnishedRoom, RoomJob, furnish_room, ready

TICK = 0.2
"""Seconds between two looks at the clock and at signals while rooms are furnished elsewhere."""

LATE = 5.0
"""Seconds after its time is up that a process gets to come back with a room."""


class RoomPool:
    """What makes rooms, on any number of processes the same ones.

    Processes are started when two rooms are wanted at once, or by `begin`, and stay until the block ends: a home whose
    plan is solved again is furnished by those that have loaded everything. Those that something was left undone in, as
    time was up or a process broke down, are ended, and others take their place.

    Args:
        workers: processes; 1: this one alone, None: one for each core.

    Examples:
        >>> from sceneweaver.furnish.side_by_side import RoomPool
        >>> with RoomPool(1) as pool:
        ...     pool.begin(8)  # one worker is this process: nothing is started
        ...     pool.workers
        1
    """

    def __init__(self, workers: int | None = None) -> None:
        self.workers = workers or processes.cores()
        self._held = ExitStack()
        self._pool: ProcessPoolExecutor | None = None
        self._count = 0

    def __enter__(self) -> RoomPool:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._close(now=kind is not None)

    def begin(self, rooms: int) -> None:
        """Start processes for so many rooms, which load what these need while this one does something else."""
        if min(self.workers, rooms) > 1:
            self._started(min(self.workers, rooms))

    def made(self, jobs: Sequence[RoomJob], deadline: Deadline) -> Iterator[FurnishedRoom]:
        """The rooms, each as it gets done; those that take longest are begun first."""
        order = sorted(jobs, key=lambda job: (-_work(job), job.room_id))
        count = min(self.workers, len(order))
        if count < 1:
            return
        if count == 1 and self._pool is None:
            for at, job in enumerate(order):
                yield furnish_room(job, _share(deadline, job, order[at:], 1), deadline.stop)
            return
        pool, whole = self._started(count), False
        try:
            yield from _side_by_side(pool, order, min(count, self._count), deadline)
            whole = not (deadline.passed or deadline.stop.reason)
        finally:
            if not whole or _broken_down(pool):
                self._close(now=True)

    def _started(self, count: int) -> ProcessPoolExecutor:
        """The processes: those that there are, or so many new ones."""
        if self._pool is None:
            self._count = count
            self._pool = self._held.enter_context(processes.pool(count, deaf=True))
            for _ in range(count):
                self._pool.submit(ready)
        return self._pool

    def _close(self, *, now: bool) -> None:
        """End the processes; at once where what they are at is not wanted any more."""
        pool, self._pool = self._pool, None
        if pool is not None and now:
            running = list((pool._processes or {}).values())  # noqa: SLF001 - there is no public way to end one
            pool.shutdown(wait=False, cancel_futures=True)
            for process in running:
                process.kill()
        self._held.close()


def _broken_down(pool: ProcessPoolExecutor) -> bool:
    """Whether one of its processes has ended, after which a pool takes nothing more."""
    try:
        pool.submit(ready)
    except (BrokenProcessPool, RuntimeError):
        return True
    return False


def _side_by_side(
    pool: ProcessPoolExecutor, order: Sequence[RoomJob], count: int, deadline: Deadline
) -> Iterator[FurnishedRoom]:
    waiting, running = list(order), dict[Future[FurnishedRoom], RoomJob]()
    while waiting or running:
        while waiting and len(running) < count and not (deadline.passed and len(waiting) < len(order)):
            job = waiting.pop(0)
            seconds = _share(deadline, job, [job, *waiting], count)
            try:
                running[pool.submit(furnish_room, job, seconds)] = job
            except BrokenProcessPool as error:
                yield _broken(job, error)
        if not running and deadline.passed:
            break
        done, _ = wait(running, TICK, FIRST_COMPLETED)
        for future in done:
            job = running.pop(future)
            try:
                yield future.result()
            except BrokenProcessPool as error:
                yield _broken(job, error)
        if deadline.stop.reason or deadline.left < -LATE:
            break
    for job in [*running.values(), *waiting]:
        reason = deadline.stop.reason or "time was up"
        yield FurnishedRoom(job.room_id, job.request, failed=reason, cut_off=reason)


def _broken(job: RoomJob, error: BaseException) -> FurnishedRoom:
    """A room whose process ended under it."""
    return FurnishedRoom(job.room_id, job.request, failed=f"the process that made it ended: {error}")


def _work(job: RoomJob) -> float:
    """How long a room takes, in no unit: with its floor, and longer where units have to fit a wall."""
    with suppress(ValueError, ZeroDivisionError):
        return signed_area(job.shell.outline) + (8.0 if "kitchen" in job.shell.type else 0.0)
    return 0.0


def _share(deadline: Deadline, job: RoomJob, left: Sequence[RoomJob], workers: int) -> float | None:
    """Seconds that one of the rooms that are left may take, so that the others get theirs; None: any."""
    if deadline.left == math.inf:
        return None
    share = _work(job) / max(1e-6, sum(_work(other) for other in left))
    return max(1.0, deadline.left * min(1.0, workers * share))
