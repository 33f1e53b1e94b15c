"""Data passes: what each pixel of a camera shows, as numbers to learn from."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.assets.category import categories, read_yaml
from sceneweaver.io.messages import quote, suggest
from sceneweaver.scene import InputError, Scene, SceneObject

from .camera import Shot
from .instances import instances_of
from .interior import Element
from .tracing import DirectLights, Quality
from .tracing.world import collect, triangles_on
from .viewpoints import eye_cameras
from .views import Inside

PASSES = ("rgb", "depth", "normal", "position", "instance", "semantic", "material")

ARRAYS = {
    "rgb": ("rgb", "color"),
    "depth": ("depth", "distance"),
    "normal": ("normal_world", "normal_cam"),
    "position": ("position",),
    "instance": ("instance",),
    "semantic": ("semantic",),
    "material": ("material",),
}
"""The arrays of each pass."""

_BATCH = 8_000_000  # rays that are cast together


@dataclass(frozen=True)
class Frame:
    """What one camera saw: ``arrays`` by name, each [H, W] or [H, W, 3].

    ``rgb`` uint8, as a photo, and ``color`` float32, the light itself, linear; ``depth`` float32, along the optical
    axis [m], and ``distance`` float32, from the optical centre [m], both inf where nothing is; ``normal_world`` and
    ``normal_cam`` float32, unit vectors toward the camera, 0 where nothing is, the latter with x to the right, y up, z
    backward; ``position`` float32 in the world [m], nan where nothing is; ``instance``, ``semantic`` and ``material``
    int32 ids of the tables of `Labels`, 0 where nothing is.
    """

    shot: Shot
    arrays: dict[str, np.ndarray]


@dataclass(frozen=True)
class Labels:
    """What the ids mean: rows of instances (id, name, category, semantic), of classes and of materials (id, name)."""

    instances: tuple[dict[str, Any], ...]
    semantics: tuple[dict[str, Any], ...]
    materials: tuple[dict[str, Any], ...]


class PassRenderer:
    """A scene that is looked at by several cameras.

    Examples:
        >>> from sceneweaver.render.passes import PassRenderer, auto_shots
        >>> import sceneweaver as sw
        >>> scene = sw.Scene(id="empty", room=sw.Room.rectangle(4, 3))
        >>> shots = auto_shots(scene, 64, 48)
        >>> frame = next(PassRenderer(scene, shots).frames(["depth", "instance"]))
        >>> frame.shot.name, frame.arrays["depth"].shape
        ('eye-door', (48, 64))
    """

    def __init__(
        self,
        scene: Scene,
        shots: Sequence[Shot],
        load: Callable[[str], Asset] | None = None,
        quality: Quality | None = None,
        device: str = "cpu",
    ) -> None:
        """Prepare it.

        Args:
            scene: The scene.
            shots: The cameras; a door in which one of them stands is open.
            load: Gives the asset of an id; None: ``Library().load``.
            quality: Of the colours.
            device: "cpu" or "cuda:0".

        Raises:
            InputError: an asset cannot be loaded, two cameras have one name, or one has no perspective.
        """
        _check(shots)
        self.shots, self.quality = tuple(shots), quality
        self._inside = Inside(scene, instances_of(scene, load), [shot.camera for shot in shots], device)
        solids = self._inside.instances
        names = sorted({material.name for one in solids for material in one.mesh.materials})
        self.labels = _labels(scene, self._inside.parts, names)
        self._geometry = collect(solids, DirectLights())
        self._triangles = triangles_on(self._geometry, device)
        numbers = {name: k for k, name in enumerate(names, 1)}
        of_row = np.array([numbers[material.name] for material in self._geometry.materials], dtype=np.int32)
        self._material = of_row[self._geometry.material]
        self._instance = (self._geometry.instance + 1).astype(np.int32)
        classes = [UNLABELLED, *(row["semantic"] for row in self.labels.instances)]
        self._semantic = np.array(classes, dtype=np.int32)

    def frames(self, passes: Sequence[str] = PASSES) -> Iterator[Frame]:
        """The frame of each camera in turn, with the arrays of some passes; rays of several cameras are cast together.

        Raises:
            InputError: a pass that is unknown.
        """
        check_passes(passes)
        wanted = {array for name in passes for array in ARRAYS[name]}
        for batch in _batches(self.shots):
            cameras, width, height = [shot.camera for shot in batch], batch[0].width, batch[0].height
            hits = self._triangles.first_hits(cameras, width, height)
            for shot, face, distance, bary in zip(batch, hits.face, hits.distance, hits.bary, strict=True):
                arrays = self._arrays(shot, face, distance, bary, wanted)
                if "rgb" in wanted:
                    picture = self._inside.picture(shot.camera, width, height, self.quality)
                    arrays["rgb"], arrays["color"] = picture.rgb, picture.linear
                yield Frame(shot, {name: arrays[name] for name in sum(ARRAYS.values(), ()) if name in wanted})

    def _arrays(
        self, shot: Shot, face: np.ndarray, distance: np.ndarray, bary: np.ndarray, wanted: set[str]
    ) -> dict[str, np.ndarray]:
        way = shot.camera.rays(shot.width, shot.height)
        seen = face >= 0
        found = {"distance": distance, "depth": (distance * (way @ shot.camera.axis)).astype(np.float32)}
        found["instance"] = np.where(seen, self._instance[face], 0)
        found["semantic"] = self._semantic[found["instance"]]
        found["material"] = np.where(seen, self._material[face], 0)
        if "position" in wanted:
            where = np.asarray(shot.camera.eye) + way * np.where(seen, distance, np.nan)[..., None]
            found["position"] = where.astype(np.float32)
        if "normal_world" in wanted:
            world = self._normal(face, bary, way) * seen[..., None]
            found["normal_world"] = world.astype(np.float32)
            found["normal_cam"] = (world @ shot.camera_to_world[:3, :3]).astype(np.float32)
        return found

    def _normal(self, face: np.ndarray, bary: np.ndarray, way: np.ndarray) -> np.ndarray:
        """Smooth unit normals toward the camera; the flat one where the smooth one leans away from it."""
        corners = self._geometry.corners[face]
        flat = np.cross(corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :])
        flat = flat / np.maximum(np.linalg.norm(flat, axis=-1, keepdims=True), 1e-18)
        away = (flat * way).sum(axis=-1, keepdims=True) > 0
        shares = np.concatenate([bary, 1 - bary.sum(axis=-1, keepdims=True)], axis=-1)
        smooth = (self._geometry.normals[face] * shares[..., None]).sum(axis=-2)
        smooth = smooth / np.maximum(np.linalg.norm(smooth, axis=-1, keepdims=True), 1e-18)
        flat, smooth = np.where(away, -flat, flat), np.where(away, -smooth, smooth)
        return np.where((smooth * way).sum(axis=-1, keepdims=True) < 0, smooth, flat)


def auto_shots(scene: Scene, width: int, height: int) -> list[Shot]:
    """The cameras at eye level that a scene chooses by itself, see `eye_cameras`."""
    return [Shot(name, camera, width, height) for name, camera in eye_cameras(scene, width / height).items()]


def check_passes(passes: Sequence[str]) -> None:
    """InputError unless all are of `PASSES`, and there is one."""
    for name in passes:
        if name not in PASSES:
            raise InputError(f"passes: '{name}' is unknown{suggest(name, PASSES)}; use some of {', '.join(PASSES)}")
    if not passes:
        raise InputError(f"passes: none is named; use some of {', '.join(PASSES)}")


def _check(shots: Sequence[Shot]) -> None:
    if not shots:
        raise InputError("cameras: there is none")
    names = [shot.name for shot in shots]
    for shot in shots:
        if names.count(shot.name) > 1:
            raise InputError(f"cameras: two have the name {quote(shot.name)}; give each its own")
        if shot.camera.flat:
            raise InputError(f"cameras: {quote(shot.name)} has no perspective; data passes need some")


def _batches(shots: Sequence[Shot]) -> Iterator[list[Shot]]:
    """Neighbouring shots of one size, as many as are cast together."""
    batch: list[Shot] = []
    for shot in shots:
        size = (shot.width, shot.height)
        full = (len(batch) + 1) * shot.width * shot.height > _BATCH
        if batch and (full or size != (batch[0].width, batch[0].height)):
            yield batch
            batch = []
        batch.append(shot)
    yield batch


def _labels(scene: Scene, room: Sequence[Element], materials: Sequence[str]) -> Labels:
    rows: list[tuple[str, str, str, int]] = []
    rows += [(thing.id, thing.category, "object", class_of(thing)) for thing in scene.objects]
    rows += [(part.name, part.category, "room", class_named(part.category)) for part in room]
    return Labels(
        tuple(
            {"id": k, "name": name, "category": category, "of": of, "semantic": number}
            for k, (name, category, of, number) in enumerate(rows, 1)
        ),
        tuple({"id": k, "name": name} for k, name in enumerate(class_names(), 1)),
        tuple({"id": k, "name": name} for k, name in enumerate(materials, 1)),
    )


UNLABELLED = 0
"""The class of what is none of them: the world outside, and pixels that show nothing."""

_FURNITURE, _PROP = "otherfurniture", "otherprop"


@cache
def class_names() -> tuple[str, ...]:
    """Names of the classes; the id of the first one is 1."""
    return tuple(row["name"] for row in _table())


def class_of(thing: SceneObject) -> int:
    """The class of an object: by the words of its category, else by its group in the library, else a piece of furniture
    or a prop."""
    found = class_named(thing.category)
    if found == UNLABELLED:
        large = thing.mount == "floor" and max(thing.size) > 0.5
        found = class_names().index(_FURNITURE if large else _PROP) + 1
    return found


@cache
def class_named(category: str) -> int:
    """The class that the words of a category name, or `UNLABELLED`."""
    words = category.lower().replace("_", " ").replace("-", " ").split()
    by_words = {text: k + 1 for k, row in enumerate(_table()) for text in row["words"]}
    for start in range(len(words)):  # the longest end that is known
        text = " ".join(words[start:])
        if text in by_words:
            return by_words[text]
    by_group = {text: k + 1 for k, row in enumerate(_table()) for text in row.get("groups", ())}
    entry = categories().get("_".join(words))
    while entry is not None and entry.parent is not None:
        if entry.parent in by_group:
            return by_group[entry.parent]
        entry = categories().get(entry.parent)
    return UNLABELLED


@cache
def _table() -> list[dict]:
    return read_yaml(resources.files(__package__ or "").joinpath("nyu40.yaml"))
