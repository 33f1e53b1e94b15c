"""Arrays of NumPy, Warp and DLPack (jax, torch) as Warp arrays, without a copy where they lie on the device already."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, cast

import numpy as np
import warp as wp

from sceneweaver.runtime.compiling import start_warp
from sceneweaver.scene import InputError


class SharesMemory(Protocol):
    """An array that hands out its memory by DLPack: of jax, torch, CuPy and others."""

    def __dlpack__(self, *args: Any, **options: Any) -> Any:
        """A capsule of the memory."""
        ...


if TYPE_CHECKING:  # Warp's own class takes no parameters of types when it runs
    WarpArray: TypeAlias = wp.array[Any]
else:
    WarpArray = wp.array

HostArray: TypeAlias = np.ndarray | Sequence[Any]
"""What is answered with NumPy arrays: a NumPy array, or lists of numbers."""

Array: TypeAlias = HostArray | WarpArray | SharesMemory
"""What has poses in it: a NumPy array or lists, a Warp array, or anything with ``__dlpack__``."""


def poses_from(poses: Array, objects: int, device: str) -> wp.array:
    """Poses [B, N, 4] float32 as a Warp array [B, N] of vec4 on a device.

    The memory is shared where that is possible: a float32 array in C order that lies on the device. NumPy arrays of
    another type of number are converted, and go to the device wherever that is; others have to lie there.

    Raises:
        InputError: another shape or type of number, or another device.
    """
    if isinstance(poses, wp.array):
        _check(tuple(poses.shape) + ((4,) if poses.dtype == wp.vec4 else ()), str(poses.device), objects, device)
        if poses.dtype not in (wp.vec4, wp.float32):
            raise InputError(f"poses: numbers of type {poses.dtype.__name__}; poses are float32")
        whole = poses if poses.is_contiguous else poses.contiguous()
        return whole if poses.dtype == wp.vec4 else _shared(whole, wp.vec4, whole.shape[:2])
    if hasattr(poses, "__dlpack__") and not isinstance(poses, np.ndarray):
        found = from_dlpack("poses", cast(SharesMemory, poses))
        if found.dtype != wp.float32:
            raise InputError(f"poses: numbers of type {found.dtype.__name__}; poses are float32")
        return poses_from(found, objects, device)
    try:
        values = np.ascontiguousarray(poses, dtype=np.float32)
    except (TypeError, ValueError):
        raise InputError(f"poses: {type(poses).__name__} is not an array of poses [B, {objects}, 4]") from None
    _check(values.shape, device, objects, device)
    return wp.array(values, dtype=wp.vec4, device=device, copy=device != "cpu")


def from_dlpack(name: str, values: SharesMemory) -> wp.array:
    """An array of another library as a Warp array of the same memory.

    Raises:
        InputError: it does not hand out its memory.
    """
    start_warp()
    try:
        return cast(wp.array, wp.from_dlpack(values))
    except Exception as error:  # each library raises its own
        raise InputError(f"{name}: not an array that can be shared by DLPack: {str(error).splitlines()[0]}") from error


def _check(shape: tuple[int, ...], where: str, objects: int, device: str) -> None:
    if len(shape) != 3 or shape[1:] != (objects, 4):
        raise InputError(f"poses: an array of shape {shape}; poses are [B, {objects}, 4] (x, y, z, yaw)")
    if where != device:
        raise InputError(f"poses: they are on {where}, the problem is on {device}")


def _shared(values: wp.array, dtype: Any, shape: tuple[int, ...]) -> wp.array:
    """The same memory with another type of element."""
    found = wp.array(ptr=values.ptr, dtype=dtype, shape=shape, device=values.device, copy=False)
    found._ref = values  # pyright: ignore[reportAttributeAccessIssue]  # keeps the memory
    return found


def handed_out(values: wp.array, like: Array) -> Any:
    """A result as what it was asked with: NumPy for NumPy and lists, Warp for all else; vectors as a last dimension."""
    width = getattr(values.dtype, "_length_", 1)
    if isinstance(like, wp.array) or (hasattr(like, "__dlpack__") and not isinstance(like, np.ndarray)):
        return values if width == 1 else _shared(values, wp.float32, (*values.shape, width))
    return values.numpy()
