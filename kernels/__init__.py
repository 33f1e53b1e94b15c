"""Warp code: the compiled problem's tables and everything that runs on the device."""

import importlib
from typing import Any

import warp as wp

from sceneweaver.runtime import compiling
from sceneweaver.runtime.compiling import Variant

compiling.prepare_warp()

USUAL_BLOCK = 256
"""Threads of a block with which a GPU launches kernels, where nothing else is said."""

BLOCKS = {
    "anneal": (32,),
    "descent": (64,),
    "gradients_gpu": (64,),
    "plan_cuts": (64,),
    "plan_search": (64,),
    "plan_verdict": (64,),
    "proposals": (128, 64),
    "rounds": (USUAL_BLOCK, 64),
    "sequence_pair": (32,),
    "snap": (32, USUAL_BLOCK),
    "starts": (32,),
    "step": (USUAL_BLOCK, 64),
}
"""With which numbers of threads a GPU launches the kernels of a module, where these are not the usual ones alone."""


def load(device: str, *names: str) -> int:
    """Compile and load kernel modules ahead of their first launch; see `sceneweaver.runtime.compiling.load`."""
    return compiling.load(device, [variant for name in names for variant in variants_of(name)])


def load_for(kernel: Any, device: str, block: int = USUAL_BLOCK) -> None:
    """Compile and load the module of a kernel for launches with so many threads a block."""
    compiling.load(device, [Variant(kernel.module, block)])


def variants_of(name: str) -> list[Variant]:
    """What is launched of a module of this floor, by its name."""
    module = wp.get_module(importlib.import_module(f"{__name__}.{name}").__name__)
    return [Variant(module, block) for block in BLOCKS.get(name, (USUAL_BLOCK,))]
