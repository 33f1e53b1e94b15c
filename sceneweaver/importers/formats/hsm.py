"""HSM's own state (``hsm_scene_state.json``); its ``stk_scene_state.json`` is SceneState."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import load_packed_json

from ..asset_files import asset_files
from ..frames import facing, yaw_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import along
from ..values import Entry

DOOR = (0.9, 2.0)
"""Width and height [m] of a door of which only the place is known, as HSM makes it."""

WINDOW = (1.6, 1.2, 1.0)
"""Width, height and lower edge [m] of such a window."""

_MOUNTS: dict[str, Mount] = {"wall": "wall", "ceiling": "ceiling", "small": "surface"}


def _matches(path: Path, head: bytes) -> bool:
    if not path.name.lower().endswith((".json", ".json.gz")):
        return False
    return b'"scene_state_version"' in head or (b'"room_vertices"' in head and b'"scene_objects"' in head)


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    root = Entry.of(path, load_packed_json(path))
    corners = [(p[0], p[1]) for p in (v.numbers(2) for v in root["room_vertices"].entries())]
    if len(corners) < 3:
        raise root["room_vertices"].error(f"{len(corners)} corners; a room needs three")
    notes: list[str] = []
    specs = {str(k): v for k, v in root["object_specs"].items()} if root.has("object_specs") else {}
    given = root["scene_objects"]
    things = list(given.entries()) if isinstance(given.value, list) else [v for _, v in given.items()]
    files = asset_files(options.folder)
    names = {item["name"].text() for item in things}
    objects: list[SourceObject] = []
    for item in things:
        name = item["name"].text()
        mesh = Path(item.word("mesh_path")).stem
        known = files.find(mesh) if files is not None and mesh else None
        objects.append(_object(item, name, names, specs, mesh, known.mesh if known else None))
    openings = [*_openings(root, "door_location", corners, notes), *_openings(root, "window_location", corners, notes)]
    text = root.word("room_desc")
    yield SourceRoom(
        "", root.word("room_type"), tuple(corners), None, tuple(openings), tuple(objects), text, tuple(notes)
    )


def _object(
    item: Entry, name: str, names: set[str], specs: dict[str, Entry], asset: str, mesh: Path | None
) -> SourceObject:
    place = item["optimized_world_pos"] if item.has("optimized_world_pos") else item["position"]
    x, up, y = place.numbers(3)
    turn = np.radians(item["rotation"].number(-1e6, 1e6))
    size = item["dimensions"]
    width, tall, depth = size.sides(size.numbers(3, 0.0))
    parent = item.word("parent_name")
    spec = specs.get(str(item.value.get("id")))
    return SourceObject(
        name,
        spec.word("name", name) if spec is not None else name,
        (x, y, up),
        yaw_matrix(np.pi / 2 - turn),  # the front is (sin, cos) of the angle on the plan
        (depth, width, tall),
        "bottom",
        asset=asset or None,
        mesh=mesh,
        mesh_axes=facing("z", "y"),
        support=parent if parent in names and parent != name else None,
        mount=_MOUNTS.get(item.word("obj_type").lower()),
        description=spec.word("description") if spec is not None else "",
        keep={k: item.value[k] for k in ("obj_type", "motif_id", "wall_id") if item.value.get(k) is not None},
    )


def _openings(root: Entry, key: str, corners: list[tuple[float, float]], notes: list[str]) -> Iterator[SourceOpening]:
    """Openings of a field: a place [x, y], several, or cut-outs with location, width and height."""
    if not root.has(key):
        return
    kind = "door" if key.startswith("door") else "window"
    field = root[key]
    single = isinstance(field.value, dict) or (
        isinstance(field.value, list) and field.value and not any(isinstance(v, list | dict) for v in field.value)
    )
    bare = False
    for k, item in enumerate([field] if single else field.entries()):
        cut = isinstance(item.value, dict)
        point = np.array((item["location"] if cut else item).numbers(2))
        width, height = DOOR if kind == "door" else WINDOW[:2]
        bottom = 0.0 if kind == "door" else WINDOW[2]
        width = item["width"].length() if cut and item.has("width") else width
        height = item["height"].length() if cut and item.has("height") else height
        bottom = item["bottom_height"].length() if cut and item.has("bottom_height") else bottom
        bare = bare or not cut
        a, b = _wall_at(point, corners)
        middle = float((point - a) @ (b - a) / np.hypot(*(b - a)))
        start, end = along(a.tolist(), b.tolist(), middle - width / 2, middle + width / 2)
        yield SourceOpening(f"{kind}_{k}", kind, start, end, bottom, height)
    if bare:
        notes.append(f"only the places of {kind}s are in the file; their sizes are HSM's usual ones")


def _wall_at(point: np.ndarray, corners: list[tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
    """The two ends of the wall that is nearest to a point."""
    import shapely

    walls = list(zip(corners, corners[1:] + corners[:1], strict=True))
    a, b = min(walls, key=lambda wall: shapely.LineString(wall).distance(shapely.Point(point)))
    return np.array(a), np.array(b)


FORMAT = SourceFormat(
    "hsm",
    "HSM states (hsm_scene_state.json)",
    _matches,
    _read,
    notes=(
        "Read: the room's corners, doors and windows, scene_objects: y up, bottom centres (x, y, z) become (x, z, y); "
        "the optimised place where there is one; sizes (width, height, depth).",
        "At an angle of 0 a thing faces +z of theirs, +y of ours, and turns clockwise on the plan: so their exporter "
        "and solver have it, though a comment there says -z and counter-clockwise.",
        "Assumed: the sizes of openings of which only the place is known.",
        "Lost: motifs (their parts are things of their own), support surfaces.",
    ),
    licence="MIT (code); HSSD models have their own",
)
