"""Scenes side by side in padded arrays, in the frame of each room."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import InputError, Scene

from .vocabulary import Vocabulary

FRAMES = ("room", "middle", "unit")
ALIGNED = 64  # bytes: what JAX wants of memory that it takes as it is
DOOR, WINDOW = 1, 2
MOUNTS = ("", "floor", "wall", "ceiling", "surface")
"""Names of the numbers of ``mounts``; 0 is padding."""


@dataclass(frozen=True)
class Limits:
    """How much a scene may have: objects N, corners C of the outline, doors and windows O together."""

    objects: int
    corners: int
    openings: int

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not isinstance(value, int) or isinstance(value, bool) or value < 1:
                raise InputError(f"{field.name}: {value!r} is not a whole number of at least 1")


@dataclass(frozen=True)
class Tensors:
    """Scenes [B] as arrays with N objects, C corners and O openings; what is not there is 0, and its mask False.

    Lengths are in the frame that was asked for: metres from the scene's origin (``"room"``), metres from the middle of
    the room's bounding box (``"middle"``), or such that the longer half side of that box is 1 (``"unit"``). Axes are
    those of the scene. All arrays are C-contiguous and begin at a multiple of 64 bytes, so ``torch.from_numpy`` and
    ``jax.numpy.from_dlpack`` on a CPU share their memory.

    Attributes:
        poses: [B, N, 4] float32, x, y, z and yaw [rad] of the objects, the middle of the underside.
        turns: [B, N, 2] float32, cosine and sine of the yaw.
        sizes: [B, N, 3] float32, depth along the front, width, height.
        categories: [B, N] int32, numbers of the vocabulary.
        mounts: [B, N] int32: 1 floor, 2 wall, 3 ceiling, 4 surface.
        supports: [B, N] int32, the place of the object that carries it, -1: none.
        mask: [B, N] bool, which objects there are.
        corners, corner_mask: [B, C, 2] float32 and [B, C] bool, the outline, counter-clockwise.
        openings: [B, O, 7] float32: middle x, y, inward normal x, y, width, lower edge, height.
        opening_kinds: [B, O] int32: 0 none, 1 door, 2 window.
        rooms: [B] int32, number of the kind of room.
        heights: [B] float32 of the ceiling.
        origin, scale: [B, 2] and [B] float32: a point p of the frame is ``p * scale + origin`` in the scene [m].
        keys: of the scenes.
    """

    poses: np.ndarray
    turns: np.ndarray
    sizes: np.ndarray
    categories: np.ndarray
    mounts: np.ndarray
    supports: np.ndarray
    mask: np.ndarray
    corners: np.ndarray
    corner_mask: np.ndarray
    openings: np.ndarray
    opening_kinds: np.ndarray
    rooms: np.ndarray
    heights: np.ndarray
    origin: np.ndarray
    scale: np.ndarray
    keys: tuple[str, ...]

    def __len__(self) -> int:
        """How many scenes."""
        return len(self.keys)

    def arrays(self, convert: Callable[[np.ndarray], Any] | None = None) -> dict[str, Any]:
        """The arrays by name, as they are or as ``jax.numpy.from_dlpack`` or ``torch.from_numpy`` takes them."""
        own: Mapping[str, np.ndarray] = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "keys"}
        return {name: value if convert is None else convert(value) for name, value in own.items()}

    def world(self, poses: Any) -> np.ndarray:
        """Poses [B, N, 4] of the frame as poses in the scenes [m], such as ``sw.refine`` takes."""
        found = np.array(poses, dtype=np.float32)
        if found.shape != self.poses.shape:
            raise InputError(f"poses: an array of shape {found.shape}; these scenes have {self.poses.shape}")
        found[..., :3] *= self.scale[:, None, None]
        found[..., :2] += self.origin[:, None]
        return np.where(self.mask[..., None], found, 0.0).astype(np.float32)


def empty(count: int, limits: Limits) -> dict[str, np.ndarray]:
    """Arrays of zeros for so many scenes."""
    n, c, o = limits.objects, limits.corners, limits.openings
    floats = {"poses": (n, 4), "turns": (n, 2), "sizes": (n, 3), "corners": (c, 2), "openings": (o, 7)}
    floats |= {"heights": (), "origin": (2,), "scale": ()}
    whole = {"categories": (n,), "mounts": (n,), "supports": (n,), "opening_kinds": (o,), "rooms": ()}
    found = {name: aligned((count, *shape), np.float32) for name, shape in floats.items()}
    found |= {name: aligned((count, *shape), np.int32) for name, shape in whole.items()}
    found |= {name: aligned((count, *shape), np.bool_) for name, shape in (("mask", (n,)), ("corner_mask", (c,)))}
    found["supports"][:] = -1
    return found


def aligned(shape: tuple[int, ...], dtype: Any) -> np.ndarray:
    """An array of zeros whose memory begins at a multiple of `ALIGNED`."""
    size = int(np.prod(shape, dtype=np.int64)) * np.dtype(dtype).itemsize
    raw = np.zeros(size + ALIGNED, dtype=np.uint8)
    start = -raw.ctypes.data % ALIGNED
    return raw[start : start + size].view(dtype).reshape(shape)


def collate(
    scenes: Sequence[Scene],
    vocabulary: Vocabulary,
    limits: Limits,
    *,
    frame: str = "middle",
    keys: Sequence[str] | None = None,
) -> Tensors:
    """Scenes as padded arrays.

    Args:
        scenes: the scenes B.
        vocabulary: numbers of categories and kinds of rooms.
        limits: N, C and O.
        frame: "room", "middle" or "unit", see `Tensors`.
        keys: of the scenes; their ids where left out.

    Raises:
        InputError: a scene has more than the limits, or the frame is unknown.
    """
    if frame not in FRAMES:
        raise InputError(f'frame: "{frame}" is not one of {", ".join(FRAMES)}')
    out = empty(len(scenes), limits)
    named = tuple(scene.id for scene in scenes) if keys is None else tuple(keys)
    for b, scene in enumerate(scenes):
        _enter(out, b, scene, named[b], vocabulary, limits, frame)
    return Tensors(**out, keys=named)


def _enter(
    out: dict[str, np.ndarray], b: int, scene: Scene, key: str, vocabulary: Vocabulary, limits: Limits, frame: str
) -> None:
    room, objects = scene.room, scene.objects
    have = {"objects": len(objects), "corners": len(room.outline), "openings": len(room.doors) + len(room.windows)}
    for name, count in have.items():
        if count > getattr(limits, name):
            raise InputError(f"{name}: scene {key} has {count}, more than {getattr(limits, name)}; give {name}={count}")
    outline = np.array(room.outline, dtype=np.float64)
    low, high = outline.min(axis=0), outline.max(axis=0)
    origin = np.zeros(2) if frame == "room" else 0.5 * (low + high)
    scale = 0.5 * float((high - low).max()) if frame == "unit" else 1.0
    out["origin"][b], out["scale"][b] = origin, scale
    out["heights"][b], out["rooms"][b] = room.height / scale, vocabulary.room(room.type)
    out["corners"][b, : len(outline)] = (outline - origin) / scale
    out["corner_mask"][b, : len(outline)] = True
    walls = walls_of(room.outline)
    openings = [(DOOR, d, 0.0) for d in room.doors] + [(WINDOW, w, w.sill) for w in room.windows]
    for k, (kind, opening, sill) in enumerate(openings):
        wall = walls[opening.wall]
        middle = (np.array(wall.point(opening.offset + 0.5 * opening.width)) - origin) / scale
        spans = np.array([opening.width, sill, opening.height]) / scale
        out["openings"][b, k] = (*middle, *wall.inward, *spans)
        out["opening_kinds"][b, k] = kind
    if not objects:
        return
    n, index = len(objects), {o.id: i for i, o in enumerate(objects)}
    poses = np.array([(*o.pose.position, o.pose.yaw) for o in objects], dtype=np.float64)
    poses[:, :2] -= origin
    poses[:, :3] /= scale
    out["poses"][b, :n] = poses
    out["turns"][b, :n] = np.stack([np.cos(poses[:, 3]), np.sin(poses[:, 3])], axis=1)
    out["sizes"][b, :n] = np.array([o.size for o in objects]) / scale
    out["categories"][b, :n] = [vocabulary.category(o.category) for o in objects]
    out["mounts"][b, :n] = [MOUNTS.index(o.mount) for o in objects]
    out["supports"][b, :n] = [-1 if o.support is None else index[o.support.object] for o in objects]
    out["mask"][b, :n] = True
