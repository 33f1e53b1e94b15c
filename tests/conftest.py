"""What all tests share: kernels are compiled once, not by each worker."""

from __future__ import annotations

import subprocess
import sys

import pytest


@pytest.hookimpl(tryfirst=True)  # before xdist starts its workers
def pytest_sessionstart(session: pytest.Session) -> None:
    """Fill the kernel cache before workers start. A run in one process compiles what it needs by itself."""
    option = session.config.option
    is_worker = hasattr(session.config, "workerinput")
    if getattr(option, "numprocesses", None) and not is_worker and not option.collectonly:
        # What does not compile fails in the tests that need it, which say more.
        subprocess.run([sys.executable, "-m", "tests.warm_kernels"], cwd=session.config.rootpath, check=False)
