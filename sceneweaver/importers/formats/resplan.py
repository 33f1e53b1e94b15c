"""ResPlan: floor plans without furniture, from JSON or GeoJSON; never from the pickle in which they are published.

Three serialisations: an object (or a list of such) by layer, ``{"bedroom": geometry, "door": geometry, "area": 90}``,
whose geometries are GeoJSON objects or WKT texts (``shapely.geometry.mapping(g)``, ``g.wkt``); and a GeoJSON
FeatureCollection whose features have the layer as ``type``, ``category``, ``class``, ``layer`` or ``name`` among their
properties. Layers of rooms: living, bedroom, kitchen, bathroom, balcony and the like; door, front_door and window are
openings; wall, inner and others are passed over. y is up. ``area`` [m2] is that of the layer ``inner``, which gives the
scale as ResPlan computes it: sqrt(area / area of inner). Without both a unit is a metre, but for coordinates beyond 60,
which are pixels of its 256 x 256 canvas, taken for 18 m.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, load_json
from sceneweaver.io.messages import path_name, show

from ..box_files import is_pickle
from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..outlines import middle_line, near_wall, of_shape
from ..values import LARGEST, MAX_JSON, keys_seen, mapping, sequence, word

ROOMS = {
    "living": "living_room",
    "bedroom": "bedroom",
    "bathroom": "bathroom",
    "kitchen": "kitchen",
    "balcony": "balcony",
    "balacony": "balcony",  # as some files spell it
    "dining": "dining_room",
    "storage": "storage",
    "stair": "stairs",
    "veranda": "balcony",
    "garage": "garage",
    "entrance": "entrance",
    "laundry": "laundry_room",
    "office": "study",
    "study": "study",
}
OPENINGS = {"door": "door", "front_door": "door", "window": "window"}
NAMES = ("type", "category", "class", "layer", "name", "room_type")
CANVAS, ACROSS = 60.0, 18.0 / 256.0
PICKLE = (
    "a pickle, which can run any program when it is loaded, so none is read; write each plan as JSON where it is "
    "trusted: {layer: shapely.geometry.mapping(geometry)}, with its area"
)


def matches(path: Path, head: bytes) -> bool:
    """JSON whose layers are rooms; or a pickle by ResPlan's name, to say why it is not read."""
    if is_pickle(path, head):
        return "resplan" in path.name.lower()
    if head.lstrip()[:1] not in (b"{", b"["):
        return False
    names = keys_seen(head)
    if "FeatureCollection" in head.decode("utf-8", "replace")[:4096]:
        text = head.decode("utf-8", "replace").lower()
        return any(f'"{room}' in text for room in ROOMS) and any(f'"{name}"' in text for name in NAMES)
    shapes = b'"coordinates"' in head or b"POLYGON" in head
    return shapes and bool(names & {*ROOMS}) and bool(names & {*OPENINGS, "inner", "wall"})


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the plan, or of the plans of a list, one after another."""
    where = path_name(path)
    if is_pickle(path, b""):
        raise InputError(f"{where}: it is {PICKLE}")
    data = load_json(path, max_bytes=MAX_JSON)
    plans = data if isinstance(data, list) else [data]
    for k, plan in enumerate(plans):
        place = f"{where}: [{k}]" if isinstance(data, list) else where
        prefix = f"{word(mapping(plan, place).get('id'), str(k))}-" if isinstance(data, list) else ""
        yield from _plan(mapping(plan, place), prefix, options, place)


def _plan(plan: Mapping[str, Any], prefix: str, options: ReadOptions, where: str) -> Iterator[SourceRoom]:
    layers = _features(plan, where) if plan.get("type") == "FeatureCollection" else _layers(plan, where)
    rooms = [(kind, shape) for layer, shapes in layers.items() if (kind := _room(layer)) for shape in shapes]
    if not rooms:
        raise InputError(f"{where}: no layer is a room; layers are {', '.join(sorted(ROOMS))}")
    unit, said = _unit(plan, layers, rooms, options.scale)
    passed = sorted(layer for layer in layers if not _room(layer) and layer not in OPENINGS)
    holes = []
    for layer, kind in OPENINGS.items():
        for shape in layers.get(layer, []):
            holes.append((layer, kind, *_line(shape, unit)))
    counts: dict[str, int] = {}
    for kind, shape in rooms:
        outline, left = of_shape(shape)
        name = f"{prefix}{kind}_{counts.setdefault(kind, 0)}"
        counts[kind] += 1
        if outline is None or (options.room is not None and options.room != name):
            continue
        ring = outline * unit
        yield SourceRoom(
            name=name,
            type=kind,
            outline=tuple((float(x), float(y)) for x, y in ring),
            openings=tuple(
                SourceOpening(
                    name=f"{layer}_{k}",
                    kind=what,
                    start=(float(a[0]), float(a[1])),
                    end=(float(b[0]), float(b[1])),
                    leads_to="outside" if layer == "front_door" else None,
                )
                for k, (layer, what, a, b, thick) in enumerate(holes)
                if near_wall(ring, a, b, max(0.3, thick))
            ),
            notes=(said, *left, *((f"layers passed over: {', '.join(passed)}",) if passed else ())),
            house=prefix.rstrip("-"),
        )


def _room(layer: str) -> str | None:
    """The kind of room of a layer such as "bedroom", "Bedroom 2" or "bedroom_1"."""
    return ROOMS.get(layer.lower().replace("room", "").strip("_ 0123456789")) or ROOMS.get(
        layer.lower().strip("_ 0123456789")
    )


def _layers(plan: Mapping[str, Any], where: str) -> dict[str, list[Any]]:
    """Shapes by layer of an object by layer."""
    found: dict[str, list[Any]] = {}
    for layer, value in plan.items():
        if (
            layer in ("graph", "neighbor", "id", "unitType")
            or value is None
            or not isinstance(value, str | dict | list)
        ):
            continue
        known = bool(_room(layer)) or layer in (*OPENINGS, "inner")
        values = value if isinstance(value, list) else [value]
        for k, entry in enumerate(values):
            shape = _shape(entry, f"{where}: {layer}[{k}]" if isinstance(value, list) else f"{where}: {layer}", known)
            if shape is not None:
                found.setdefault(layer, []).extend(_parts(shape))
    return found


def _features(plan: Mapping[str, Any], where: str) -> dict[str, list[Any]]:
    """Shapes by layer of a FeatureCollection."""
    found: dict[str, list[Any]] = {}
    for k, feature in enumerate(sequence(plan.get("features"), f"{where}: features")):
        place = f"{where}: features[{k}]"
        properties = mapping(mapping(feature, place).get("properties") or {}, f"{place}: properties")
        layer = next((word(properties[name]) for name in NAMES if word(properties.get(name))), "")
        if not layer:
            raise InputError(f"{place}: properties: none of {', '.join(NAMES)} says what it is")
        layer = layer.lower().replace(" ", "_") if layer.lower().replace(" ", "_") in OPENINGS else layer.lower()
        shape = _shape(feature.get("geometry"), f"{place}: geometry", True)
        if shape is not None:
            found.setdefault(layer, []).extend(_parts(shape))
    return found


def _shape(value: Any, place: str, known: bool) -> Any:
    """The shapely geometry of a GeoJSON object or a WKT text; None where it is empty, or another thing in a layer that
    is not known."""
    import shapely
    from shapely.geometry import shape as of_mapping

    try:
        with np.errstate(invalid="ignore"):  # NaN, which is refused below
            if isinstance(value, str):
                found = shapely.from_wkt(value)
            elif isinstance(value, dict) and ("coordinates" in value or "geometries" in value):
                found = of_mapping(value)
            elif known:
                raise ValueError("neither a GeoJSON object nor a WKT text")
            else:
                return None
    except (shapely.errors.ShapelyError, ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        if not known:
            return None
        shown = f"{value.get('type')} of wrong coordinates" if isinstance(value, dict) else show(value)
        raise InputError(f"{place}: {shown} is no geometry; give GeoJSON or WKT") from error
    if found is None or found.is_empty:
        return None
    coordinates = shapely.get_coordinates(found)
    if not np.isfinite(coordinates).all() or np.abs(coordinates).max() > LARGEST:
        raise InputError(f"{place}: a coordinate is not finite or too large; numbers must be finite")
    return found if found.is_valid else shapely.make_valid(found)


def _parts(shape: Any) -> list[Any]:
    import shapely

    return [part for part in shapely.get_parts(shape) if not part.is_empty]


def _unit(
    plan: Mapping[str, Any], layers: Mapping[str, list[Any]], rooms: list[tuple[str, Any]], scale: float | None
) -> tuple[float, str]:
    """Metres of a unit, and how that was found."""
    if scale is not None:
        return scale, f"a unit is {scale:g} m, as given"
    area = plan.get("area")
    inner = sum(shape.area for shape in layers.get("inner", []))
    if isinstance(area, int | float) and 0 < area < LARGEST and inner > 0:
        unit = math.sqrt(float(area) / inner)
        return unit, f"a unit is {unit:.6g} m, by the area that the plan states"
    if max(float(np.abs(shape.bounds).max()) for _, shape in rooms) > CANVAS:
        return ACROSS, f"the plan states no area: its 256 pixels are taken for 18 m, a unit for {ACROSS:g} m"
    return 1.0, "the plan states no area: its units are taken for metres"


def _line(shape: Any, unit: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Middle line [m] of a door or window, and its thickness."""
    import shapely

    return middle_line(shapely.get_coordinates(shape) * unit)


FORMAT = SourceFormat(
    name="resplan",
    title="ResPlan (JSON, GeoJSON)",
    matches=matches,
    read=read,
    notes=(
        "Read: a plan, or a list of plans, as JSON by layer with GeoJSON geometries or WKT texts, or a GeoJSON "
        "FeatureCollection; ResPlan.pkl is never loaded (the error says how to convert it).",
        "Meaning: a room a polygon of the layers living, bedroom, kitchen, bathroom, balcony, ...; doors, front doors "
        "and windows go to the walls next to them. y is up; rooms keep their places in the plan.",
        "Assumed: the scale is sqrt(area / area of inner), as ResPlan has it; without them 256 pixels are 18 m, or "
        "small coordinates are metres. Heights are not in the file.",
        "Lost: walls, the graph of rooms, holes of rooms, types of units.",
    ),
    licence="MIT (ResPlan)",
)
