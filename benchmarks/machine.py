"""Facts about the machine, so that a number can be told from another machine's."""

from __future__ import annotations

import os
import platform
import subprocess
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from benchmarks.settings import ROOT, Settings
from sceneweaver.runtime.threads import cores

PACKAGES = ("sceneweaver", "warp-lang", "jax", "numpy", "shapely", "scipy", "torch", "drake")


def resolve(device: str) -> str:
    """The device that a name stands for; raises what ``refine`` would when it is not there."""
    from sceneweaver.layout.devices import pick_devices

    return pick_devices(device)[0]


def device_name(device: str) -> str:
    """What the device is called: the model of the processor or of the GPU."""
    import warp as wp

    return cpu_model() if device == "cpu" else wp.get_device(device).name


def cpu_model() -> str:
    """The model of the processor."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                if line.startswith("model name"):
                    return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def memory_gib() -> float | None:
    """Main memory [GiB]."""
    try:
        return round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 1)
    except (ValueError, OSError, AttributeError):
        return None


def commit() -> str:
    """The commit of the checkout, "+" when files differ from it."""

    def git(*arguments: str) -> str:
        return subprocess.run(("git", *arguments), cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()

    try:
        return git("rev-parse", "--short=12", "HEAD") + ("+" if git("status", "--porcelain", "-uno") else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def versions() -> dict[str, str]:
    """Versions of what the numbers depend on."""
    found = {"python": platform.python_version()}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found


def facts(settings: Settings) -> dict[str, Any]:
    """Everything about the machine as JSON data; the load tells whether it had other work to do."""
    device = resolve(settings.device)
    return {
        "cpu": cpu_model(),
        "cores": cores(),
        "memory_gib": memory_gib(),
        "device": device,
        "device_name": device_name(device),
        "system": f"{platform.system()} {platform.machine()}",
        "load": round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
        "versions": versions(),
        "commit": settings.commit or commit(),
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
    }
