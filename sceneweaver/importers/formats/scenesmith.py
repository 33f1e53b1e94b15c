"""SceneSmith's own states: ``scene_state.json`` of a room, ``house_state.json`` of a house."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import load_packed_json, named_inside

from ..frames import facing, quaternion_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import along, rectangle
from ..values import Entry

_AXES = facing("y")
"""From a model's frame (z up, front +y) to an object's."""

_MOUNTS: dict[str, Mount] = {
    "furniture": "floor",
    "wall_mounted": "wall",
    "ceiling_mounted": "ceiling",
    "manipuland": "surface",
}
_SHELL = ("wall", "floor", "ceiling")
_KINDS = {"door": "door", "window": "window"}


def _matches(path: Path, head: bytes) -> bool:
    if not path.name.lower().endswith((".json", ".json.gz")):
        return False
    return b'"room_geometry"' in head or (b'"rotation_wxyz"' in head and b'"object_type"' in head)


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    root = Entry.of(path, load_packed_json(path))
    folders = [path.parent, *([options.folder] if options.folder else [])]
    if not root.has("rooms"):
        yield _room(root, "", "", np.zeros(3), folders)
        return
    layout = root.find("layout")
    placed = {} if layout is None else {item["room_id"].text(): item for item in layout.listed("placed_rooms")}
    specs = {} if layout is None else {item.word("room_id", item.word("id")): item for item in layout.listed("rooms")}
    rooms = dict(root["rooms"].items())
    if not rooms:
        raise root["rooms"].error("holds no room; give a house with at least one")
    for name, room in rooms.items():
        at, notes = np.zeros(3), ()
        if name in placed:
            low = placed[name]["position"].numbers(2)
            at[:2] = low[0] + placed[name]["width"].length() / 2, low[1] + placed[name]["depth"].length() / 2
        elif len(rooms) > 1:
            notes = (f"the layout does not say where room {name} lies in the house; it stays around the origin",)
        kind = specs[name].word("room_type", specs[name].word("type")) if name in specs else ""
        yield _room(room, name, kind or name, at, folders, notes)


def _room(
    state: Entry, name: str, kind: str, at: np.ndarray, folders: list[Path], said: tuple[str, ...] = ()
) -> SourceRoom:
    """A room whose middle lies at ``at`` [m]: its own frame has the origin there."""
    notes = list(said)
    outline, height, openings = None, None, []
    if state.has("room_geometry"):
        shell = state["room_geometry"]
        x, y = shell.sides([shell["length"].length(), shell["width"].length(), 1.0])[:2]
        outline = rectangle(x, y, float(at[0]) - x / 2, float(at[1]) - y / 2)
        height = shell["wall_height"].length() if shell.has("wall_height") else None
        openings = [_opening(item, at) for item in shell.listed("openings")]
    things: list[Entry] = []
    for key, item in state["objects"].items():
        if item.word("object_type") in _SHELL:
            continue
        things.append(item)
        item.mapping().setdefault("object_id", key)
    carriers = _carriers(things)
    objects: list[SourceObject] = []
    for item in things:
        members = list(item["metadata"].listed("member_assets")) if item.has("metadata") else []
        if members:
            notes.append(f"{item['object_id'].text()}: read as one thing; it was composed of {len(members)}")
        objects.append(_object(item, carriers, at, folders))
    return SourceRoom(
        name, kind, outline, height, tuple(openings), tuple(objects), state.word("text_description"), tuple(notes)
    )


def _opening(item: Entry, at: np.ndarray) -> SourceOpening:
    a, b = (np.array(item[key].numbers(2)) for key in ("wall_start", "wall_end"))
    length = float(np.hypot(*(b - a)))
    if length < 1e-6:
        raise item.error("wall_start and wall_end are one point; give a wall of some length")
    width, low = item["width"].length(), item["position_along_wall"].number()
    start, end = along((a + at[:2]).tolist(), (b + at[:2]).tolist(), low, low + width)
    kind = _KINDS.get(item.word("opening_type").lower(), "passage")
    bottom = item["sill_height"].length() if item.has("sill_height") else 0.0
    return SourceOpening(
        item.word("opening_id", item.place),
        "door" if kind == "door" else "window" if kind == "window" else "passage",
        start,
        end,
        bottom,
        item["height"].length() if item.has("height") else None,
    )


def _carriers(things: list[Entry]) -> dict[str, str]:
    """The object that each support surface is of."""
    found: dict[str, str] = {}
    for item in things:
        for surface in item.listed("support_surfaces"):
            for key in ("surface_id", "id"):
                if surface.word(key):
                    found[surface.word(key)] = item["object_id"].text()
    return found


def _object(item: Entry, carriers: dict[str, str], at: np.ndarray, folders: list[Path]) -> SourceObject:
    name = item["object_id"].text()
    transform = item["transform"]
    try:
        turn = quaternion_matrix(transform["rotation_wxyz"].numbers(4), "wxyz")
    except ValueError as error:
        raise transform["rotation_wxyz"].error(f"{error}; give w, x, y, z") from None
    position, size = np.array(transform["translation"].numbers(3)) + at, None
    if item.has("bbox_min") and item.has("bbox_max"):
        low, high = (np.array(item[key].numbers(3)) for key in ("bbox_min", "bbox_max"))
        width, depth, tall = (float(v) for v in high - low)
        if min(width, depth, tall) < 0:
            raise item["bbox_max"].error("lies below bbox_min")
        position, size = position + turn @ (low + high) / 2, (depth, width, tall)
    kind = item.word("object_type")
    surface = item["placement_info"].word("parent_surface_id") if item.has("placement_info") else ""
    mesh = _mesh(item.word("geometry_path"), folders)
    glb = mesh is not None and mesh.suffix.lower() in (".glb", ".gltf")
    return SourceObject(
        name,
        item.word("name", name),
        (float(position[0]), float(position[1]), float(position[2])),
        turn @ _AXES.T,
        size,
        "origin" if size is None else "centre",
        asset=item.word("sdf_path") or item.word("geometry_path") or None,
        mesh=mesh,
        mesh_axes=facing("-z", "y") if glb else _AXES,
        support=carriers.get(surface),
        mount=_MOUNTS.get(kind),
        description=item.word("description"),
        fixed=item.value.get("immutable") is True,
        keep={key: item.value[key] for key in ("object_type", "placement_info", "scale_factor") if key in item.value},
    )


def _mesh(name: str, folders: list[Path]) -> Path | None:
    """The file of a path that is relative to the folder of the state, or to the one that the user gives."""
    for folder in folders if name else ():
        place = named_inside(folder, folder / name)
        if place is not None and place.is_file():
            return place
    return None


FORMAT = SourceFormat(
    "scenesmith",
    "SceneSmith states (scene_state.json, house_state.json)",
    _matches,
    _read,
    notes=(
        "Read: rectangle rooms (length along x, width along y, the origin in the middle; in a house moved to the "
        "middle of the placed room), openings from the left edge along their wall, objects with quaternions (w, x, y, "
        "z) and boxes in their own frame (front +y), which are scaled already; what stands on whose surface.",
        "Assumed: every model faces +y, as SceneSmith has it. Stacks and filled containers are one thing.",
        "Lost: materials, support surfaces as polygons. The Drake directives are the format `drake`, "
        "sceneeval_state.json is `scenestate`.",
    ),
    licence="MIT (code)",
)
