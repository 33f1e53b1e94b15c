"""Environments of clients, made when they are first asked for: ``environments.yaml`` says what is in them.

They are in the folder that SCENEWEAVER_CLIENTS names, else in the user's cache; one that is there is taken as it is.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import yaml

_TIME = 1800  # [s] for one installation


class UnavailableError(Exception):
    """An environment cannot be made here; the message says why, in one line."""


def folder() -> Path:
    """Where the environments are."""
    named = os.environ.get("SCENEWEAVER_CLIENTS")
    return Path(named) if named else Path.home() / ".cache" / "sceneweaver" / "clients"


def python_of(name: str) -> Path:
    """The Python of an environment, which is made where it is not there.

    Raises:
        UnavailableError: there is no such Python, no index, or no wheel for this machine.
    """
    place = folder() / name
    python = place / "bin" / "python"
    if python.exists():
        return python
    wanted = yaml.safe_load(Path(__file__).with_name("environments.yaml").read_text(encoding="utf-8"))[name]
    draft = place.with_name(f"{name}.part")
    shutil.rmtree(draft, ignore_errors=True)
    draft.parent.mkdir(parents=True, exist_ok=True)
    made = [_base(wanted["python"], name), "-m", "venv", str(draft)]
    filled = [str(draft / "bin" / "python"), "-m", "pip", "install", "-q", "--no-cache-dir", *wanted["packages"]]
    try:
        for command in (made, filled):
            done = subprocess.run(command, capture_output=True, text=True, timeout=_TIME, check=False)
            if done.returncode:
                lines = done.stderr.strip().splitlines() or ["no message"]
                raise UnavailableError(f"{name}: {lines[-1][:200]}")
        draft.rename(place)
    except subprocess.TimeoutExpired:
        raise UnavailableError(f"{name}: not installed within {_TIME} s") from None
    finally:
        shutil.rmtree(draft, ignore_errors=True)
    return python


def _base(version: str, name: str) -> str:
    """An interpreter of a version: on the path, or where uv knows one."""
    found = shutil.which(f"python{version}")
    if found is not None and subprocess.run([found, "-c", ""], capture_output=True, check=False).returncode:
        found = None  # the shim of a version that is not chosen
    local = Path(__file__).resolve().parents[2] / ".uv" / "bin" / "uv"
    uv = shutil.which("uv") or (str(local) if local.exists() else None)
    if found is None and uv is not None:
        done = subprocess.run([uv, "python", "find", version], capture_output=True, text=True, check=False)
        found = done.stdout.strip() or None
    if found is None:
        raise UnavailableError(f"{name}: no Python {version} here")
    return found
