"""Warp code: the compiled problem's tables and everything that runs on the device."""

import ctypes
import importlib
import os

import warp as wp


def _start() -> None:
    """Start Warp without its notes; SCENEWEAVER_DEBUG=1 keeps them.

    On a machine without a GPU driver Warp's native code writes a warning straight to the terminal on each start. That
    is the normal case for a CPU user, so that one write is turned away.
    """
    if os.environ.get("SCENEWEAVER_DEBUG"):
        return
    wp.config.log_level = wp.LOG_ERROR
    try:
        ctypes.CDLL("libcuda.so.1")
    except OSError:
        terminal = os.dup(2)
        sink = os.open(os.devnull, os.O_WRONLY)
        try:
            os.dup2(sink, 2)
            wp.init()
        finally:
            os.dup2(terminal, 2)
            os.close(terminal)
            os.close(sink)


def load(device: str, *names: str) -> None:
    """Compile and load kernel modules ahead of their first launch, side by side on two threads.

    From a warm cache this takes milliseconds; from an empty one it halves the wait.
    """
    modules = [wp.get_module(importlib.import_module(f"{__name__}.{name}").__name__) for name in names]
    wp.force_load(device, modules, max_workers=2)


_start()
