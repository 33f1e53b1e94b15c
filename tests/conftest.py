"""What all tests share: kernels are compiled once, long files begin first, the garbage collector seldom looks."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
from collections.abc import Generator, Iterator

import pytest
from hypothesis import settings

from sceneweaver.cli.app import COLLECT
from tests.sizes import WHOLE

settings.register_profile(WHOLE)

FIRST = (
    *("agent/test_design.py", "jax/test_jax.py", "mcp/test_transports.py", "cli/test_stopping.py"),
    *("runtime/test_compiling.py", "bench/test_run.py", "agent/test_starting.py", "cli/test_program.py"),
    *("report/test_browser.py", "llm/test_misbehaviour.py", "explain/test_explain.py", "language/test_hostile.py"),
    *("test_docstrings.py", "prior/test_training.py", "cli/test_design_models.py", "bench/test_layout_bench.py"),
    *("furnish/test_design_home.py", "datasets/test_engines.py", "agent/by_model/test_design_by_model.py"),
    *("agent/test_given_room.py", "benchmarks/test_solvers.py", "mcp/test_homes.py", "benchmarks/test_families.py"),
    *("assets/test_parametric.py", "mcp/test_ending.py", "packaging/test_wheel.py", "test_notebooks.py"),
    *("kernels/test_verdict_judge.py", "agent/test_deliver.py", "agent/test_loop.py", "cli/test_export.py"),
)
"""The files that take longest, six seconds and more. A worker takes whole files: one of these as the last would leave
the other workers without work."""


def pytest_configure(config: pytest.Config) -> None:
    """Hand files out in the order of the tests; xdist would begin with those of most tests, which are short ones."""
    if hasattr(config.option, "loadscopereorder"):
        config.option.loadscopereorder = False


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest files first."""
    places = {f"tests/{name}": place for place, name in enumerate(FIRST)}
    items.sort(key=lambda item: places.get(item.nodeid.partition("::")[0], len(places)))


@pytest.hookimpl(tryfirst=True)  # before xdist starts its workers
def pytest_sessionstart(session: pytest.Session) -> None:
    """Fill the kernel cache before workers start. A run in one process compiles what it needs by itself."""
    option = session.config.option
    is_worker = hasattr(session.config, "workerinput")
    if getattr(option, "numprocesses", None) and not is_worker and not option.collectonly:
        # What does not compile fails in the tests that need it, which say more.
        subprocess.run([sys.executable, "-m", "tests.warm_kernels"], cwd=session.config.rootpath, check=False)


@pytest.fixture(autouse=True, scope="session")
def no_waiting_for_disks() -> Iterator[None]:
    """What tests write need not outlive a power cut. A file that is not open is still an error."""

    def fsync(descriptor: int) -> None:
        os.fstat(descriptor)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "fsync", fsync)
        yield


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect tests without the garbage collector, and leave modules and tests, which all stay, out of it later on.

    To look through these few million objects again and again took a third of the time of collecting, and a tenth of
    that of the tests. What tests leave is looked through as seldom as in the program itself: with the thresholds of
    Python that took another twentieth.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(*COLLECT)
        gc.enable()
