"""Warp code: the compiled problem's tables and everything that runs on the device."""

import importlib
import os

import warp as wp

if not os.environ.get("SCENEWEAVER_DEBUG"):
    wp.config.log_level = wp.LOG_ERROR  # no greeting, no notes on what is compiled


def load(device: str, *names: str) -> None:
    """Compile and load kernel modules ahead of their first launch, side by side on two threads.

    From a warm cache this takes milliseconds; from an empty one it halves the wait.
    """
    modules = [wp.get_module(importlib.import_module(f"{__name__}.{name}").__name__) for name in names]
    wp.force_load(device, modules, max_workers=2)
