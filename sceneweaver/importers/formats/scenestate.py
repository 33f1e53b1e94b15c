"""SceneState (``scene@1.0.x``): what SceneEval, SSTK, HSSD, HSM and SceneSmith exchange, and what we write."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from sceneweaver.io import load_packed_json

from ..arch import Arch, arch_of
from ..asset_files import AssetFiles, asset_files
from ..frames import AXES, Y_UP, affine, facing, quaternion_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..plans import room_at
from ..values import Entry

_MODEL = "z"
"""Front of a model whose up axis is y, as glTF and SSTK have it."""

_MOUNTS: dict[str, Mount] = {"floor": "floor", "wall": "wall", "ceiling": "ceiling", "surface": "surface"}


def _matches(path: Path, head: bytes) -> bool:
    return path.name.lower().endswith((".json", ".json.gz")) and b'"sceneState"' in head and b'"format"' in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    root = Entry.of(path, load_packed_json(path))
    scene = root["scene"] if root.has("scene") else root
    unit = scene["unit"].number(1e-6, 1e3) if scene.has("unit") else 1.0
    things = list(scene["object"].entries())
    notes: list[str] = []
    matrices = [_matrix(thing) for thing in things]
    arch = arch_of(scene.find("arch"))
    frame = _frame(scene, arch, notes)
    arch = arch.turned(frame)
    files = asset_files(options.folder)
    turned = [(frame @ at * unit, frame @ turn, scale * unit) for at, turn, scale in matrices]
    if things and (slab := _slab(arch, turned)):
        notes.append(f"things stand on the upper face of the floor slab; {slab:g} m are taken off all heights")
        turned = [(at - (0.0, 0.0, slab), turn, scale) for at, turn, scale in turned]
    if things and abs(arch.level) > 1e-9:
        notes.append(f"the floor lies at {arch.level:g} m and is moved to 0")
        turned = [(at - (0.0, 0.0, arch.level), turn, scale) for at, turn, scale in turned]
    up = _model_up([turn for _, turn, _ in turned])
    if up == "z" and things:
        notes.append("models are z up with their front along +y (as SceneSmith has them), not y up with front +z")
    names = _names(things)
    objects = [_object(thing, names, k, *turned[k], up, unit, frame, files, notes) for k, thing in enumerate(things)]
    _tell(objects, files, notes)
    yield from _rooms(arch, objects, scene.word("description"), notes)


def _matrix(thing: Entry) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Translation [3], rotation [3, 3] and scale [3] of an object, of its matrix or of the parts of it."""
    given = thing["transform"]
    if given.has("data"):
        try:
            return affine(given["data"].numbers(16, -1e6, 1e6), column_major=True)
        except ValueError as error:
            raise given["data"].error(f"{error}; give 16 numbers column by column") from None
    try:
        turn = quaternion_matrix(given["rotation"].numbers(4)) if given.has("rotation") else np.eye(3)
    except ValueError as error:
        raise given["rotation"].error(f"{error}; give x, y, z, w") from None
    scale = given["scale"].numbers(3, 1e-9, 1e6) if given.has("scale") else [1.0, 1.0, 1.0]
    return np.array(given["translation"].numbers(3)), turn, np.array(scale)


def _frame(scene: Entry, arch: Arch, notes: list[str]) -> np.ndarray:
    """The rotation from the file's frame to ours.

    Where walls are, they tell what is up: HSM writes "up": y over data that is z up.
    """
    said = _axis(scene, "up") or "z"
    up = arch.up or said
    if up != said:
        notes.append(f"the header says that {said} is up, but the floor lies as if {up} were; so it is read")
    if up == "z":
        return np.eye(3)
    if up == "y":
        return Y_UP
    raise scene["up"].error(f"{up} is up; only y and z are read")


def _axis(scene: Entry, key: str) -> str | None:
    """The name of the axis that a field holds as [x, y, z] or {"x": ...}; None where it is missing."""
    if not scene.has(key):
        return None
    field = scene[key]
    values = field.numbers(3) if isinstance(field.value, list) else field.named("xyz")
    for name, axis in AXES.items():
        if np.allclose(values, axis, atol=1e-6):
            return name
    raise field.error("must be one of the axes, such as [0, 0, 1]")


def _slab(arch: Arch, poses: Sequence[tuple[np.ndarray, np.ndarray, np.ndarray]]) -> float:
    """The thickness [m] of the floor where all things stand just that above its points, as SSTK has it; else 0."""
    thick = arch.floor_depth
    lowest = min(float(at[2]) for at, _, _ in poses)
    return thick if thick > 0 and abs(lowest - arch.level - thick) < 1e-6 else 0.0


def _model_up(turns: Sequence[np.ndarray]) -> str:
    """The axis of the models that most of them have upwards: y, or z."""
    y = sum(turn[2, 1] > 0.99 for turn in turns)
    z = sum(turn[2, 2] > 0.99 for turn in turns)
    return "z" if z > y else "y"


def _names(things: Sequence[Entry]) -> list[str]:
    names = []
    for k, thing in enumerate(things):
        given = thing.value.get("id") if isinstance(thing.value, dict) else None
        names.append(str(given) if isinstance(given, str | int) and str(given) else str(k))
    return names


def _object(
    thing: Entry,
    names: Sequence[str],
    k: int,
    at: np.ndarray,
    turn: np.ndarray,
    scale: np.ndarray,
    up: str,
    unit: float,
    frame: np.ndarray,
    files: AssetFiles | None,
    notes: list[str],
) -> SourceObject:
    axes = facing(_MODEL, "y") if up == "y" else facing("y", "z")
    rotation = turn @ axes.T
    asset = thing.word("modelId")
    known = files.find(asset) if files is not None and asset else None
    mesh_axes = axes
    if known is not None and known.mesh is not None and known.up and known.front:
        mesh_axes = facing(known.front, known.up) if asset.startswith("fpModel") else axes
    label = thing.word("category") or thing.word("label") or (known.label if known is not None else "")
    size, centre = _box(thing, rotation, unit, frame, names[k], notes)
    position = at if centre is None else centre
    return SourceObject(
        names[k],
        label or _source_name(asset),
        (float(position[0]), float(position[1]), float(position[2])),
        rotation,
        size,
        "origin" if centre is None else "centre",
        asset=thing.word("asset") or asset or None,
        mesh=known.mesh if known is not None else None,
        mesh_axes=mesh_axes,
        scale=(float(scale[0]), float(scale[1]), float(scale[2])),
        support=_parent(thing, names, k),
        mount=_MOUNTS.get(thing.word("mount")),
        description=thing.word("description"),
        keep={key: thing.value[key] for key in ("modelId", "sdfPath", "surface") if key in thing.value},
    )


def _source_name(asset: str) -> str:
    """The words of a model id after its source, such as "desk_0" of "scenesmith.desk_0"."""
    return asset.partition(".")[2] or asset


def _parent(thing: Entry, names: Sequence[str], k: int) -> str | None:
    """The carrier: SceneEval writes an object's own index as ``parentIndex`` where it has none."""
    given = thing.value.get("parentId")
    if given not in (None, "", -1):
        return str(given) if str(given) in names else None
    if "parentId" in thing.value:
        return None
    index = thing.value.get("parentIndex")
    if isinstance(index, int) and not isinstance(index, bool) and 0 <= index < len(names) and index != k:
        return names[index]
    return None


def _box(
    thing: Entry, rotation: np.ndarray, unit: float, frame: np.ndarray, name: str, notes: list[str]
) -> tuple[tuple[float, float, float] | None, np.ndarray | None]:
    """Size (depth, width, height) and centre of the object's ``obb``, where it has one along the object's axes."""
    if not thing.has("obb"):
        return None, None
    obb = thing["obb"]
    axes = frame @ obb["normalizedAxes"].matrix(3, 3).T if obb.has("normalizedAxes") else frame
    lengths = np.array(obb["axesLengths"].numbers(3, 0.0)) * unit
    centre = frame @ np.array(obb["centroid"].numbers(3)) * unit
    fits = np.abs(rotation.T @ axes)
    order = fits.argmax(axis=1)
    if sorted(order.tolist()) != [0, 1, 2] or fits.max(axis=1).min() < 0.999:
        notes.append(f"{name}: its obb is not along its own axes; left out")
        return None, None
    return obb.sides([float(v) for v in lengths[order]]), centre


def _tell(objects: Sequence[SourceObject], files: AssetFiles | None, notes: list[str]) -> None:
    bare = [thing for thing in objects if thing.size is None and thing.mesh is None]
    if bare and files is None:
        notes.append(f"SceneState has no sizes: {len(bare)} of {len(objects)} objects have none; give --asset-folder")
    elif bare:
        notes.append(f"{len(bare)} of {len(objects)} objects have no mesh in the asset folder")
    origin = sum(thing.anchor == "origin" for thing in bare)
    if origin:
        notes.append(f"{origin} objects have no box: the origin of their model is taken for the middle of their bottom")


def _rooms(arch: Arch, objects: Sequence[SourceObject], text: str, notes: list[str]) -> Iterator[SourceRoom]:
    if len(arch.rooms) <= 1:
        room = arch.rooms[0] if arch.rooms else None
        yield SourceRoom(
            "",
            room.type if room else "",
            room.outline if room else None,
            room.height if room else None,
            room.openings if room else (),
            tuple(objects),
            text,
            (*notes, *arch.notes),
        )
        return
    outlines = {room.name: room.outline for room in arch.rooms if room.outline is not None}
    where = [room_at(outlines, *thing.position[:2]) for thing in objects]
    lost = [thing.name for thing, room in zip(objects, where, strict=True) if room is None]
    if lost:
        notes = [*notes, f"outside of all rooms, left out: {', '.join(lost[:20])}{' ...' if len(lost) > 20 else ''}"]
    for room in arch.rooms:
        inside = tuple(thing for thing, name in zip(objects, where, strict=True) if name == room.name)
        yield SourceRoom(
            room.name, room.type, room.outline, room.height, room.openings, inside, text, (*notes, *arch.notes)
        )


FORMAT = SourceFormat(
    "scenestate",
    "SceneState (SceneEval, SSTK, HSSD, HSM, SceneSmith's sceneeval_state.json)",
    _matches,
    _read,
    notes=(
        "Read: matrices column by column (scale within), or translation, rotation (x, y, z, w) and scale; boxes (obb) "
        "where they are; walls with their holes as outline and openings, a room each `roomId`; parents.",
        "Up is where floor and walls say it is: HSM's header says y over data that is z up. Models are y up with front "
        "+z (glTF); z up with front +y where most matrices stand so (SceneSmith).",
        "There are no sizes: --asset-folder gives meshes (`<id>.glb` or `<id>/raw_model.obj` at any depth) and, with "
        "the tables of 3D-FUTURE, HSSD, Objathor or a data.json beside the mesh, labels; else --sizes by model id; "
        "else the usual size of the category. SceneEval's files have neither: without a folder the things are boxes.",
        "Where all things stand at the thickness of the floor slab, as SSTK places them, that is taken off.",
        "Lost: materials, textures, modifications, which way doors open.",
    ),
    written=True,
)
