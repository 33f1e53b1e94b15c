"""Compiles every module of kernels once, before several workers of pytest would do so each.

``python -m tests.warm_kernels`` fills Warp's kernel cache for the CPU; what is there already is left as it is.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

ROOT = Path(__file__).parent.parent / "sceneweaver"
MARK = "wp.set_module_options("  # what each module of kernels says once, and no other module does


def modules() -> list[str]:
    """Names of the modules of sceneweaver that may hold kernels, the largest first."""
    found = [
        (file.stat().st_size, file.relative_to(ROOT.parent).with_suffix(""))
        for folder, _folders, names in os.walk(ROOT, followlinks=True)
        for file in (Path(folder, name) for name in names if name.endswith(".py"))
        if MARK in file.read_text(encoding="utf-8")
    ]
    return [".".join(path.parts) for _size, path in sorted(found, reverse=True)]


def compile_module(name: str) -> None:
    """Compile the kernels of one module for the CPU, if it has any and the cache lacks them."""
    import warp as wp

    importlib.import_module("sceneweaver.kernels")  # starts Warp quietly
    module = wp.get_module(importlib.import_module(name).__name__)
    if module.kernels:
        wp.load_module(module.name, device="cpu")


def main() -> None:
    """Compile all modules, in as many processes as there are cores."""
    # Spawned, not forked: a process that holds Warp and its compiler cannot be forked safely.
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(os.cpu_count(), mp_context=context) as pool:
        list(pool.map(compile_module, modules()))


if __name__ == "__main__":
    main()
