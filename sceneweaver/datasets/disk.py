"""Full disks: told apart from other errors, since a run waits for room instead of failing."""

from __future__ import annotations

import errno
import shutil
import time
from dataclasses import dataclass, field
from pathlib import Path

from sceneweaver.scene import SceneWeaverError

FULL = (errno.ENOSPC, errno.EDQUOT)
LEAST = 64 * 2**20
"""Bytes that have to be free before a run goes on that knows no better."""

RETRY = 30.0
"""Seconds after which a run tries again at the latest."""


class DiskFullError(SceneWeaverError):
    """There is no room on the disk of a data set, and nobody wants to wait for it."""

    exit_code = 4


def disk_full(error: BaseException | None) -> bool:
    """Whether an error, or one that it was raised from or while handling, says that the disk or a quota is full."""
    while error is not None:
        if isinstance(error, OSError) and error.errno in FULL:
            return True
        error = error.__cause__ or error.__context__
    return False


@dataclass
class Wait:
    """A pause of a run while its disk is full.

    Attributes:
        path: a folder on that disk.
        needed: bytes with which the run goes on.
        until: when it tries again whatever the system says of free bytes, since that knows of no quota.
    """

    path: Path
    needed: int
    until: float = field(default_factory=lambda: time.monotonic() + RETRY)

    @property
    def free(self) -> int:
        """Bytes that are free."""
        return shutil.disk_usage(self.path).free

    @property
    def over(self) -> bool:
        """Whether it is worth a try."""
        return self.free >= self.needed or time.monotonic() >= self.until

    def __str__(self) -> str:
        return (
            f"disk full: {self.path} has {self.free / 2**20:.0f} MB free, about {self.needed / 2**20:.0f} MB are "
            "needed; remove something"
        )


def waiting(path: Path, needed: int = LEAST, *, wait: bool) -> Wait:
    """The pause to make.

    Raises:
        DiskFullError: nobody wants to wait.
    """
    pause = Wait(path, needed)
    if not wait:
        raise DiskFullError(f"{pause}, then resume")
    return pause
