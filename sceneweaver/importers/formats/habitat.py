"""Habitat scene instances (``*.scene_instance.json``): ReplicaCAD, HSSD and others."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from sceneweaver.io import load_json, load_packed_json, named_inside

from ..asset_files import AssetFile, asset_files
from ..frames import AXES, Y_UP, facing, quaternion_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..plans import room_at
from ..values import Entry

_FRONT, _UP = "-z", "y"
"""Axes of an object in Habitat's frame."""

_PREFIXES = ("frl_apartment_", "frl_")
_ENDS = (".object_config.json", ".ao_config.json")


@dataclass(frozen=True)
class _Template:
    """What the user's folder has of an object template."""

    mesh: Path | None = None
    label: str = ""
    front: str = _FRONT
    up: str = _UP
    aligned: bool = False
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    com: tuple[float, float, float] | None = None


def _matches(path: Path, head: bytes) -> bool:
    if not path.name.lower().endswith((".json", ".json.gz")):
        return False
    return ".scene_instance." in path.name.lower() or (b'"object_instances"' in head and b'"template_name"' in head)


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    root = Entry.of(path, load_packed_json(path))
    for key in ("object_instances", "articulated_object_instances", "stage_instance"):
        if root.has(key):
            break
    else:
        raise root.error("no object_instances, articulated_object_instances or stage_instance; is it a scene instance?")
    notes: list[str] = []
    templates = _Templates(options.folder)
    usual = root.word("translation_origin", "com")
    objects: list[SourceObject] = []
    names: dict[str, int] = {}
    for item in root.listed("object_instances"):
        objects.append(_object(item, usual, templates, names))
    for item in root.listed("articulated_object_instances"):
        objects.append(_object(item, usual, templates, names, moving=True))
    if root.has("articulated_object_instances"):
        count = len(list(root.listed("articulated_object_instances")))
        notes.append(f"{count} articulated objects are read where they stand closed; their URDFs are not")
    bare = sum(o.mesh is None for o in objects)
    if bare:
        notes.append(f"Habitat's scene instances have no sizes: {bare} of {len(objects)} objects have no mesh")
    centres = sum(o.mesh is None and o.anchor == "centre" for o in objects)
    if centres:
        notes.append(f"{centres} translations are of the centre of mass, taken for the middle of the box")
    if root.has("stage_instance"):
        notes.append("the stage (walls, floor) is a mesh: it is not read")
    yield from _rooms(path, options, objects, notes)


class _Templates:
    """Object templates of a folder: meshes, labels and configurations by name."""

    def __init__(self, folder: Path | None):
        self._files = asset_files(folder)
        self._folder = folder
        self._configs = {} if folder is None else _configurations(folder)

    def find(self, name: str) -> _Template:
        """What is known of a template, whose name may be a path."""
        if self._files is None or self._folder is None:
            return _Template()
        short = name.rpartition("/")[2]
        known, config = self._files.find(short), self._configs.get(short)
        if config is None:
            return _Template(known.mesh, known.label, known.front or _FRONT, known.up or _UP)
        return self._configured(Entry.of(config, load_json(config)), config, known)

    def _configured(self, entry: Entry, path: Path, known: AssetFile) -> _Template:
        mesh = known.mesh
        asset = entry.word("render_asset")
        if asset and self._folder is not None:
            place = named_inside(self._folder, path.parent / asset)
            if place is not None and place.is_file():
                mesh = place
        x, y, z = entry["scale"].numbers(3, 1e-6, 1e6) if entry.has("scale") else (1.0, 1.0, 1.0)
        unit = entry["units_to_meters"].number(1e-6, 1e6) if entry.has("units_to_meters") else 1.0
        up, front = _axis(entry, "up"), _axis(entry, "front")
        com = entry["COM"].numbers(3) if entry.has("COM") else None
        return _Template(
            mesh,
            known.label,
            front or known.front or _FRONT,
            up or known.up or _UP,
            up is not None and front is not None,
            (x * unit, y * unit, z * unit),
            None if com is None else (com[0], com[1], com[2]),
        )


@lru_cache(maxsize=4)
def _configurations(folder: Path) -> dict[str, Path]:
    """The configuration files of a folder by the name of their template."""
    found: dict[str, Path] = {}
    for here, folders, files in os.walk(folder):
        folders.sort()
        for file in sorted(files):
            for end in _ENDS:
                if file.endswith(end):
                    found.setdefault(file.removesuffix(end), Path(here) / file)
    return found


def _axis(entry: Entry, key: str) -> str | None:
    if not entry.has(key):
        return None
    values = np.array(entry[key].numbers(3))
    return next((name for name, axis in AXES.items() if np.allclose(values, axis, atol=1e-3)), None)


def _object(
    item: Entry, usual: str, templates: _Templates, names: dict[str, int], moving: bool = False
) -> SourceObject:
    template = item["template_name"].text()
    known = templates.find(template)
    try:
        turn = quaternion_matrix(item["rotation"].numbers(4), "wxyz") if item.has("rotation") else np.eye(3)
    except ValueError as error:
        raise item["rotation"].error(f"{error}; give w, x, y, z") from None
    at = np.array(item["translation"].numbers(3)) if item.has("translation") else np.zeros(3)
    scale = np.array(known.scale)
    if item.has("uniform_scale"):
        scale = scale * item["uniform_scale"].number(1e-6, 1e6)
    if item.has("non_uniform_scale"):
        scale = scale * item["non_uniform_scale"].numbers(3, 1e-6, 1e6)
    of_com = item.word("translation_origin", usual).lower() != "asset_local" and not moving
    mesh_axes = facing(known.front, known.up)
    # A configuration that says up and front has its asset turned into Habitat's frame; a table only says what is so.
    axes = facing(_FRONT, _UP) if known.aligned else mesh_axes
    if of_com and known.com is not None:
        at = at - turn @ (axes.T @ mesh_axes @ (scale * known.com))
    position = Y_UP @ at
    short = template.rpartition("/")[2]
    names[short] = names.get(short, 0) + 1
    label = known.label or short
    for prefix in _PREFIXES:
        label = label.removeprefix(prefix)
    return SourceObject(
        short if names[short] == 1 else f"{short}_{names[short]}",
        label,
        (float(position[0]), float(position[1]), float(position[2])),
        Y_UP @ turn @ axes.T,
        None,
        "centre" if of_com and known.com is None else "origin",
        asset=template,
        mesh=known.mesh,
        mesh_axes=mesh_axes,
        scale=(float(scale[0]), float(scale[1]), float(scale[2])),
        keep={k: item.value[k] for k in ("motion_type", "fixed_base", "auto_clamp_joint_limits") if k in item.value},
    )


def _rooms(path: Path, options: ReadOptions, objects: list[SourceObject], notes: list[str]) -> Iterator[SourceRoom]:
    """A room for each region of the semantics, where the user's folder has them; else one around all objects."""
    regions = _regions(path, options.folder)
    if not regions:
        notes.append("no regions of rooms were found (semantics/scenes/*.semantic_config.json): all is one room")
        yield SourceRoom("", objects=tuple(objects), notes=tuple(notes))
        return
    outlines = {name: outline for name, (_, outline, _, _) in regions.items()}
    where = [room_at(outlines, *o.position[:2]) for o in objects]
    lost = [o.name for o, room in zip(objects, where, strict=True) if room is None]
    if lost:
        notes.append(f"outside of all rooms, left out: {', '.join(lost[:20])}{' ...' if len(lost) > 20 else ''}")
    for name, (kind, outline, floor, height) in regions.items():
        inside = [_lowered(o, floor) for o, room in zip(objects, where, strict=True) if room == name]
        said = [*notes, f"the floor lies at {floor:g} m and is moved to 0"] if abs(floor) > 1e-9 else notes
        yield SourceRoom(name, kind, outline, height, (), tuple(inside), notes=tuple(said))


def _lowered(thing: SourceObject, floor: float) -> SourceObject:
    x, y, z = thing.position
    return replace(thing, position=(x, y, z - floor))


def _regions(
    path: Path, folder: Path | None
) -> dict[str, tuple[str, tuple[tuple[float, float], ...], float, float | None]]:
    """Kind, outline, height of the floor and of the room [m] of each region, by name."""
    name = path.name.split(".")[0]
    found: dict[str, tuple[str, tuple[tuple[float, float], ...], float, float | None]] = {}
    for root in (path.parent, *([folder] if folder else [])):
        for place in (root, root / "semantics" / "scenes", root / "semantics"):
            file = place / f"{name}.semantic_config.json"
            if not file.is_file():
                continue
            for region in Entry.of(file, load_json(file)).listed("region_annotations"):
                loop = np.array([p.numbers(3) for p in region["poly_loop"].entries()])
                if len(loop) < 3:
                    raise region["poly_loop"].error(f"{len(loop)} points; a region needs three")
                floor = region["floor_height"].number() if region.has("floor_height") else float(loop[:, 1].min())
                height = region["extrusion_height"].length() if region.has("extrusion_height") else None
                title = region.word("name", f"region_{len(found)}")
                while title in found:
                    title += "_"
                outline = tuple((float(x), float(-z)) for x, _, z in loop)
                found[title] = (region.word("label", title), outline, floor, height)
            return found
    return found


FORMAT = SourceFormat(
    "habitat",
    "Habitat scene instances (ReplicaCAD, HSSD)",
    _matches,
    _read,
    notes=(
        "Read: translations and quaternions (w, x, y, z), y up, (x, y, z) becomes (x, -z, y); translation_origin of "
        "the centre of mass (the middle of the box, unless a configuration says COM) or of the asset's origin; scales.",
        "Sizes and labels come from --asset-folder (the data set's folder): object_config.json with render_asset, "
        "scale, units, up, front and COM; GLB files by name; HSSD's table. Rooms come from the region_annotations of "
        "its semantic_config.json; without them all is one room around the objects.",
        "Assumed: objects face -z, as Habitat's default is, unless configuration or table say it.",
        "Lost: the stage (walls and openings are a mesh), URDFs of articulated objects, lights, navigation meshes.",
    ),
)
