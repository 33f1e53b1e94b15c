"""ACDC (digital cousins): ``scene_<k>_info.json``, objects as a camera saw them, with the scene's graph beside it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import numpy as np

from sceneweaver.io import InputError, load_json
from sceneweaver.io.references import named_inside

from ..frames import affine, quaternion_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..omnigibson import box_offset
from ..values import Entry

STANDS = 0.02
"""Height [m] by which a box on the floor may miss it before it is set down."""


def _matches(path: Path, head: bytes) -> bool:
    return path.suffix.lower() == ".json" and b'"cam_pose"' in head and b'"objects"' in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    scene = Entry.of(path, load_json(path))
    camera = _camera(scene["cam_pose"])
    notes = ["no walls in the file: the room is drawn around its objects"]
    graph = _graph(path, scene, notes)
    objects = [_object(name, item, camera, graph, options.folder, notes) for name, item in scene["objects"].items()]
    yield SourceRoom(path.stem.removesuffix("_info"), objects=tuple(objects), notes=tuple(notes))


def _camera(pose: Entry) -> np.ndarray:
    """The camera's pose [4, 4] in the world."""
    parts = list(pose.entries())
    if len(parts) != 2:
        raise pose.error("must be [position, quaternion]")
    matrix = np.eye(4)
    matrix[:3, 3] = parts[0].numbers(3)
    matrix[:3, :3] = _turn(parts[1])
    return matrix


def _turn(entry: Entry) -> np.ndarray:
    try:
        return quaternion_matrix(entry.numbers(4))
    except ValueError as error:
        raise error if isinstance(error, InputError) else entry.error(f"{error}; give x, y, z, w") from None


def _graph(path: Path, scene: Entry, notes: list[str]) -> Entry | None:
    """The scene's graph: the file that the scene names, but beside it, whatever folder it was made in."""
    name = PurePosixPath(scene.word("scene_graph").replace("\\", "/")).name
    for place in (name, path.stem.removesuffix("_info") + "_graph.json"):
        found = named_inside(path.parent, path.parent / place) if place else None
        if found is not None and found.is_file():
            return Entry.of(found, load_json(found))
    notes.append("its graph (scene_<k>_graph.json) is not beside it: what carries what comes from geometry")
    return None


def _object(
    name: str, item: Entry, camera: np.ndarray, graph: Entry | None, folder: Path | None, notes: list[str]
) -> SourceObject:
    world = camera @ item["tf_from_cam"].matrix(4, 4)
    try:
        position, rotation, _ = affine(world)
    except ValueError as error:
        raise item["tf_from_cam"].error(f"{error}; give a rotation with a translation") from None
    size = item["bbox_extent"].sides(item["bbox_extent"].numbers(3))
    scale = np.array(item["scale"].numbers(3)) if item.has("scale") else np.ones(3)
    category, model = item.word("category", name), item.word("model")
    offset = box_offset(folder, category, model)
    if offset is not None:
        position = position + rotation @ (scale * offset)
    below = _below(name, graph)
    hung = _hung(item)
    if offset is None and below == "floor" and abs(position[2] - size[2] / 2) > STANDS:
        notes.append(f"{name}: its base is not at its middle (no asset metadata); set down on the floor")
        position[2] = size[2] / 2
    on = below not in (None, "floor")
    mount: Mount | None = "surface" if on else "floor" if below == "floor" and not hung else "wall" if hung else None
    return SourceObject(
        name,
        category,
        (float(position[0]), float(position[1]), float(position[2])),
        rotation,
        size,
        asset=f"{category}/{model}" if model else None,
        support=below if on else None,
        mount=mount,
        keep=item.kept("mount"),
    )


def _below(name: str, graph: Entry | None) -> str | None:
    found = graph.find(name) if graph is not None else None
    return found.word("objBeneath") or None if found is not None else None


def _hung(item: Entry) -> bool:
    """Whether a thing hangs on a wall and does not stand: ``{"floor": false, "wall": true}``."""
    mount = item.get("mount")
    return isinstance(mount, dict) and bool(mount.get("wall")) and not mount.get("floor")


FORMAT = SourceFormat(
    "acdc",
    "ACDC scenes (digital cousins)",
    _matches,
    _read,
    notes=(
        "Read: the camera's pose, each object's pose from the camera, box, model, mount; the graph beside the file.",
        "A box is in the object's own frame, the front +x. Poses are of the model's base: with the asset folder "
        "(<category>/<model>/misc/metadata.json) the box is moved to where it is; without, the base is taken as its "
        "middle, and what the graph has on the floor is set down.",
        "There are no walls, doors or windows: the room is drawn around its objects.",
    ),
    licence="Apache-2.0 (code); BEHAVIOR's assets have their own",
)
