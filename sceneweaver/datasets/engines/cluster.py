"""Blocks made by a Ray cluster. Results are files: the folder of the data set lies where all nodes see it."""

from __future__ import annotations

import faulthandler
import os
import shutil
import socket
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

from sceneweaver.io import reason
from sceneweaver.runtime.package import missing_extra
from sceneweaver.runtime.processes import THREADS
from sceneweaver.scene import MissingDependencyError, SceneWeaverError

from ..work import Produce
from .local import START
from .manifest import Dataset, open_dataset
from .schedule import Job, Message, Schedule, Task, attempt

RETRIES = 1
"""How often Ray begins a task anew whose worker or node is gone, before that counts as the fault of the task."""

TICK = 1.0
"""Seconds between checks of a full disk and of the size of the cluster."""


def ray_module():
    """The module ray, which sends no statistics of its use.

    Raises:
        MissingDependencyError: when it is not installed.
    """
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")  # tasks without a GPU say nothing about it
    try:
        import ray
    except ModuleNotFoundError:
        raise MissingDependencyError(missing_extra("ray", "--engine ray needs Ray")) from None
    return ray


class RayEngine:
    """Tasks of a Ray cluster, one core each, and a share of a GPU where rooms are laid out on one.

    Args:
        job: what is asked for; its data set lies in a folder that all nodes see.
    """

    def __init__(self, job: Job):
        self._job, self._workers = job, job.options.workers

    def run(self, numbers: Iterable[int]) -> None:
        """Make these blocks.

        Raises:
            DiskFullError: the disk is full, and the engine is not patient. MissingDependencyError: of Ray or a worker.
        """
        ray = ray_module()
        with _connected(self._job.options.address, self._workers):
            cores = int(ray.cluster_resources().get("CPU", 1))
            workers = self._workers or cores
            schedule = Schedule(self._job, numbers, workers)
            work: dict[Any, Task] = {}
            try:
                while not schedule.over:
                    self._submit(ray, schedule, work)
                    done, _ = ray.wait(list(work), timeout=TICK) if work else ([], [])
                    for ref in done:
                        self._ended(ray, ref, work.pop(ref), schedule)
            finally:
                for ref in work:
                    ray.cancel(ref, force=True)

    def _submit(self, ray: Any, schedule: Schedule, work: dict[Any, Task]) -> None:
        resources = ray.cluster_resources()
        cores, gpus = int(resources.get("CPU", 1)), resources.get("GPU", 0)
        share = min(1.0, gpus / cores) if self._job.dataset.device == "cuda" else 0.0
        remote = ray.remote(_remote).options(
            num_cpus=1, num_gpus=share, max_retries=RETRIES, runtime_env={"env_vars": THREADS}
        )
        path, device = str(self._job.dataset.folder.path.absolute()), self._job.dataset.device
        while len(work) < (self._workers or 2 * cores):  # some lie ready, so that no worker waits for the next
            task = schedule.take()
            if task is None:
                return
            work[remote.remote(path, task, device, self._job.produce)] = task

    def _ended(self, ray: Any, ref: Any, task: Task, schedule: Schedule) -> None:
        try:
            message, who = ray.get(ref)
        except (ray.exceptions.WorkerCrashedError, ray.exceptions.OutOfMemoryError, ray.exceptions.NodeDiedError):
            schedule.died(task, "worker killed")
        except ray.exceptions.RayTaskError as error:
            schedule.died(task, f"worker failed: {reason(error.cause or error)}")
        else:
            schedule.heard(task, message, who)


def _remote(path: str, task: Task, device: str, produce: Produce | None) -> tuple[Message, dict[str, Any]]:
    """Carry out a task in a process of Ray, which ends when it makes no scene for too long."""
    fresh = not _dataset.cache_info().currsize
    dataset = _dataset(path)

    def alive(more: float = 0.0) -> None:
        faulthandler.dump_traceback_later(task.patience(dataset.spec) + more, exit=True)

    alive(START if fresh else 0.0)
    try:
        who = {"worker": os.getpid(), "host": socket.gethostname(), "pid": os.getpid()}
        return attempt(dataset, task, device, produce, alive), who
    finally:
        faulthandler.cancel_dump_traceback_later()


@lru_cache(maxsize=1)
def _dataset(path: str) -> Dataset:
    return open_dataset(Path(path))


@contextmanager
def _connected(address: str | None, workers: int | None) -> Iterator[None]:
    """Be a driver of a cluster; one of this machine ends with the block, and its files go."""
    ray = ray_module()
    if ray.is_initialized():  # by who called us
        yield
        return
    quiet = {"log_to_driver": False, "configure_logging": False, "logging_level": "ERROR"}
    place = None if address else tempfile.mkdtemp(prefix="sw-ray-", dir="/tmp")  # paths of its sockets have to be short
    try:
        try:
            if address:
                ray.init(address=address, **quiet)
            else:
                ray.init(address="local", num_cpus=workers, include_dashboard=False, _temp_dir=place, **quiet)
        except (ConnectionError, ValueError, RuntimeError) as error:
            raise SceneWeaverError(f"--address: no Ray cluster ({reason(error)}); start one or leave it out") from None
        yield
    finally:
        ray.shutdown()
        if place is not None:
            shutil.rmtree(place, ignore_errors=True)
