"""Warp code: the compiled problem's tables and everything that runs on the device."""

import importlib
from typing import Any

import warp as wp

from sceneweaver.runtime import compiling

compiling.prepare_warp()


def load(device: str, *names: str) -> int:
    """Compile and load kernel modules ahead of their first launch; see `sceneweaver.runtime.compiling.load`."""
    return compiling.load(device, [module_of(name) for name in names])


def load_for(kernel: Any, device: str, block: int | None = None) -> None:
    """Compile and load the module of a kernel for launches with so many threads a block."""
    compiling.load(device, [kernel.module], block)


def module_of(name: str) -> wp.Module:
    """The Warp module of a module of this floor."""
    return wp.get_module(importlib.import_module(f"{__name__}.{name}").__name__)
