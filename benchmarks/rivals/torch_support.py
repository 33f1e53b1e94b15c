"""What the Torch rivals share about the library itself: whether it is there, and which device a name stands for."""

from __future__ import annotations

from importlib.util import find_spec


def missing(device: str) -> str | None:
    """Why Torch cannot be used on a device; None when it can."""
    if find_spec("torch") is None:
        return "torch is not installed"
    if device.startswith("cuda"):
        import torch

        if not torch.cuda.is_available():
            return "this torch finds no CUDA device"
    return None


def on_cuda(device: str) -> bool:
    """Whether the name of a device, as `pick` takes it, stands for a GPU."""
    return pick(device).startswith("cuda")


def pick(device: str) -> str:
    """Torch's name for a device of the benchmarks; ``auto`` is a GPU where there is one."""
    if device != "auto":
        return device
    import torch

    return "cuda" if torch.cuda.is_available() else "cpu"
