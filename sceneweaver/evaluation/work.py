"""Judging many scenes: in this process, or in several that may crash or hang without harm to the others."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, replace

from sceneweaver.assets.placed import Load
from sceneweaver.runtime.deadline import Deadline
from sceneweaver.runtime.processes import pool
from sceneweaver.scene import Scene

from .candidate import Candidate
from .judge import SceneRow, judge_scene
from .requested import Annotated

GRACE = 20.0
"""Seconds that a process has beyond the limit of its scene, start of Python included, before it is ended."""

AHEAD = 2
"""Scenes in wait for each process."""


@dataclass(frozen=True)
class Task:
    """A scene to judge, and how."""

    system: str
    candidate: Candidate
    simulate: bool
    asked: Annotated | None
    time_limit: float
    key: str

    def row(self, load: Load | None = None) -> SceneRow:
        """Judge it here."""
        return judge_scene(
            self.system,
            self.candidate,
            simulate=self.simulate,
            asked=self.asked,
            load=load,
            time_limit=self.time_limit,
            key=self.key,
        )

    def failed(self, reason: str) -> SceneRow:
        """The row of a scene that nothing could be measured of."""
        scene = self.candidate.scene
        return SceneRow(
            self.system, self.candidate.name, self.candidate.format, scene.room.type, error=reason, key=self.key
        )


def _judged(task: Task, text: str) -> SceneRow:
    """What a process of the pool does: the scene comes as text, which is read faster than a pickled one."""
    candidate = replace(task.candidate, scene=Scene.loads(text))
    return replace(task, candidate=candidate).row()


def rows_of(tasks: Iterable[Task], jobs: int, deadline: Deadline, load: Load | None = None) -> Iterator[SceneRow]:
    """The rows of some tasks, as they are done; none are begun once the deadline has passed."""
    if jobs < 2:  # noqa: PLR2004 - one process is this one
        for task in tasks:
            if deadline.passed:
                return
            yield task.row(load)
        return
    left, alone = iter(tasks), list[Task]()
    while not deadline.passed:
        ended = yield from _one_pool(left, jobs, deadline, alone)
        for task in alone:
            if deadline.passed:
                return
            yield from _apart(task, deadline)
        alone.clear()
        if ended:
            return


def _one_pool(
    left: Iterator[Task], jobs: int, deadline: Deadline, alone: list[Task]
) -> Generator[SceneRow, None, bool]:
    """Rows until all is done (True) or a process died or hung; what was in work then is added to ``alone``."""
    with pool(jobs, deaf=True) as processes:
        running: dict[Future[SceneRow], tuple[Task, float]] = {}
        while True:
            while len(running) < AHEAD * jobs and not deadline.passed:
                task = next(left, None)
                if task is None:
                    break
                running[_submit(processes, task)] = (task, time.monotonic())
            if not running or deadline.passed:
                _end(processes)
                return True
            done, _ = wait(running, timeout=1.0, return_when=FIRST_COMPLETED)
            broken = False
            for future in done:
                task, _ = running.pop(future)
                try:
                    yield future.result()
                except BrokenProcessPool:
                    alone.append(task)
                    broken = True
                except Exception as error:  # noqa: BLE001 - one scene must not end the others
                    yield task.failed(f"{type(error).__name__}: {error}")
            late = [began for task, began in running.values() if _overdue(task, began, AHEAD + 1)]
            if broken or late:
                alone.extend(task for task, _ in running.values())
                _end(processes)
                return False


def _submit(processes: ProcessPoolExecutor, task: Task) -> Future[SceneRow]:
    text = task.candidate.scene.dumps()
    bare = replace(task.candidate, scene=_EMPTY)
    return processes.submit(_judged, replace(task, candidate=bare), text)


_EMPTY = Scene.model_construct()
"""Stands for a scene that travels as text."""


def _overdue(task: Task, began: float, waits: int) -> bool:
    """Whether a task that may have waited for others is so late that its process must hang."""
    return time.monotonic() - began > waits * (task.time_limit + GRACE)


def _apart(task: Task, deadline: Deadline) -> Iterator[SceneRow]:
    """The row of a scene that was in work when a process ended, judged alone."""
    with pool(1, deaf=True) as processes:
        future = _submit(processes, task)
        limit = min(task.time_limit + 2 * GRACE, max(deadline.left, 1.0))
        done, _ = wait([future], timeout=limit)
        if not done:
            _end(processes)
            if not deadline.passed:
                yield task.failed(f"its process hung for {limit:.0f} s")
            return
        try:
            yield future.result()
        except BrokenProcessPool:
            yield task.failed("its process died, of too little memory or a fault in a library")
        except Exception as error:  # noqa: BLE001
            yield task.failed(f"{type(error).__name__}: {error}")


def _end(processes: ProcessPoolExecutor) -> None:
    """End the processes of a pool at once."""
    running = list((processes._processes or {}).values())  # noqa: SLF001 - there is no other way to end one that hangs
    processes.shutdown(wait=False, cancel_futures=True)
    for process in running:
        with contextlib.suppress(ValueError, OSError):
            process.kill()
