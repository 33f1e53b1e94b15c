"""What all tests share: kernels are compiled once, not by each worker, and the garbage collector rests meanwhile."""

from __future__ import annotations

import gc
import subprocess
import sys
from collections.abc import Generator

import pytest
from hypothesis import settings

from tests.sizes import WHOLE

settings.register_profile(WHOLE)


@pytest.hookimpl(tryfirst=True)  # before xdist starts its workers
def pytest_sessionstart(session: pytest.Session) -> None:
    """Fill the kernel cache before workers start. A run in one process compiles what it needs by itself."""
    option = session.config.option
    is_worker = hasattr(session.config, "workerinput")
    if getattr(option, "numprocesses", None) and not is_worker and not option.collectonly:
        # What does not compile fails in the tests that need it, which say more.
        subprocess.run([sys.executable, "-m", "tests.warm_kernels"], cwd=session.config.rootpath, check=False)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect tests without the garbage collector, and leave modules and tests, which all stay, out of it later on.

    To look through these few million objects again and again took a third of the time of collecting, and a tenth of
    that of the tests.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
