"""Every kernel compiles for a GPU (sm_90), which takes no GPU: two here, all of them in `make bench`."""

from __future__ import annotations

import importlib
import pkgutil

import pytest
import warp as wp

import sceneweaver.kernels

ARCH = 90  # Hopper
NAMES = [f"{sceneweaver.kernels.__name__}.{info.name}" for info in pkgutil.iter_modules(sceneweaver.kernels.__path__)]
TRACING = [f"sceneweaver.render.tracing.{name}_kernels" for name in ("ray", "cache", "develop", "filter", "view")]
BATCHED = [f"sceneweaver.envs.batched.{name}_kernels" for name in ("reset", "task")]
MODULES = [importlib.import_module(name) for name in (*NAMES, *TRACING, *BATCHED)]
# Modules without kernels of their own are compiled with those that use them.
WITH_KERNELS = [m for m in MODULES if wp.get_module(m.__name__).kernels]

# One that only a GPU runs, and one that traces rays.
QUICK = {"gradients_gpu", "ray_kernels"}


def test_modules_are_found():
    names = {m.__name__.rpartition(".")[2] for m in WITH_KERNELS}
    expected = {"bookkeeping", "descent", "evaluator", "gradients_gpu", "lbfgs", "search", "verdict"}
    expected |= {"ray_kernels", "cache_kernels", "develop_kernels", "filter_kernels", "view_kernels"}
    assert expected <= names


def short(module) -> str:
    return module.__name__.rpartition(".")[2]


@pytest.mark.parametrize(
    "module", [pytest.param(m, id=short(m), marks=() if short(m) in QUICK else pytest.mark.slow) for m in WITH_KERNELS]
)
def test_module_compiles(module, tmp_path):
    files = wp.compile_aot_module(module, arch=ARCH, module_dir=tmp_path, use_ptx=True)
    assert files and all(f.stat().st_size > 0 for f in files)
    assert any(f.suffix == ".ptx" for f in files)
    (source,) = (f.read_text() for f in tmp_path.glob("*.cu"))
    if "inline_on_gpu" in source:  # it works on what comes after it only
        assert source.index("#undef WP_NOINLINE") < source.index("static WP_NOINLINE")
