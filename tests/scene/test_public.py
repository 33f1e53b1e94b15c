"""The public surface, and that importing it is cheap."""

from __future__ import annotations

import subprocess
import sys

import sceneweaver.scene

HEAVY = ("shapely", "numpy", "warp", "mujoco", "jax", "trimesh", "pxr", "jsonschema")


def test_all_is_sorted_and_there():
    names = sceneweaver.scene.__all__
    assert names == sorted(names) and len(names) == len({*names})
    assert all(getattr(sceneweaver.scene, name) is not None for name in names)


def test_import_takes_no_heavy_module():
    code = f"import sys, sceneweaver.scene as s; s.Scene.example(); print([m for m in {HEAVY!r} if m in sys.modules])"
    out = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"


def test_public_things_have_docstrings():
    for name in sceneweaver.scene.__all__:
        thing = getattr(sceneweaver.scene, name)
        if callable(thing) and getattr(thing, "__module__", "").startswith("sceneweaver"):
            assert thing.__doc__, name
