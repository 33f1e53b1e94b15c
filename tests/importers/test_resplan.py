"""ResPlan: plans as GeoJSON geometries, WKT and a FeatureCollection; the pickle is never loaded."""

from __future__ import annotations

import json
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from shapely.geometry import mapping

import sceneweaver as sw
from tests.importers.boxes import refused, rooms, same_ring

BEDROOM = [(40, 60), (110, 60), (110, 130), (40, 130)]
SECOND = [(40, 140), (90, 140), (90, 200), (40, 200)]
LIVING = [(115, 60), (210, 60), (210, 200), (95, 200), (95, 140), (115, 140)]
INNER = [(40, 60), (210, 60), (210, 200), (40, 200)]
SHAPES = {
    "bedroom": shapely.MultiPolygon([shapely.Polygon(BEDROOM), shapely.Polygon(SECOND)]),
    "living": shapely.Polygon(LIVING),
    "door": shapely.box(110, 90, 115, 105),
    "front_door": shapely.box(206, 155, 214, 171),
    "window": shapely.LineString([(60, 58), (85, 58)]),
    "inner": shapely.Polygon(INNER),
    "wall": shapely.box(0, 0, 5, 5),
}
AREA = 77.0
UNIT = math.sqrt(AREA / (170 * 140))


def plan(kind: str = "mapping") -> dict[str, Any]:
    shapes = {layer: mapping(g) if kind == "mapping" else g.wkt for layer, g in SHAPES.items()}
    return {"id": 3, "unitType": "Apartment", "area": AREA, "graph": {}, **shapes, "storage": None}


def collection() -> dict[str, Any]:
    features = [
        {
            "type": "Feature",
            "properties": {"category": layer.replace("front_door", "Front Door")},
            "geometry": mapping(g),
        }
        for layer, g in SHAPES.items()
    ]
    return {"type": "FeatureCollection", "features": features, "area": AREA}


def write(folder: Path, data: Any, name: str = "plan_3.json") -> Path:
    (folder / name).write_text(json.dumps(data))
    return folder / name


@pytest.mark.parametrize("data", [plan("mapping"), plan("wkt"), collection()], ids=["geojson", "wkt", "collection"])
def test_rooms_and_openings(tmp_path: Path, data: dict) -> None:
    first, second, living = rooms(write(tmp_path, data), "resplan")
    assert [room.name for room in (first, second, living)] == ["bedroom_0", "bedroom_1", "living_room_0"]
    same_ring(first.outline, np.array(BEDROOM) * UNIT)
    same_ring(second.outline, np.array(SECOND) * UNIT)
    same_ring(living.outline, np.array(LIVING) * UNIT)
    door, window = first.openings
    np.testing.assert_allclose(sorted([door.start, door.end]), np.array([(112.5, 90), (112.5, 105)]) * UNIT, atol=1e-5)
    np.testing.assert_allclose(sorted([window.start, window.end]), np.array([(60, 58), (85, 58)]) * UNIT, atol=1e-5)
    assert [o.kind for o in first.openings] == ["door", "window"] and not second.openings
    inner, front = living.openings
    assert (inner.leads_to, front.leads_to) == (None, "outside")
    np.testing.assert_allclose(sorted([front.start, front.end]), np.array([(210, 155), (210, 171)]) * UNIT, atol=1e-5)


def test_many_plans_and_no_area(tmp_path: Path) -> None:
    data = plan()
    del data["area"]
    found = rooms(write(tmp_path, [data, {**data, "id": 8}]), "resplan")
    assert [room.name for room in found[::3]] == ["3-bedroom_0", "8-bedroom_0"]
    same_ring(found[0].outline, np.array(BEDROOM) * 18 / 256)
    assert "256 pixels" in found[0].notes[0]


def test_to_scenes(tmp_path: Path) -> None:
    scenes = list(sw.read_scenes(write(tmp_path, plan())))
    assert [len(s.scene.room.doors) for s in scenes] == [1, 0, 2]
    assert [s.scene.room.type for s in scenes] == ["bedroom", "bedroom", "living_room"]
    sw.check(scenes[0].scene)


def test_pickles_are_never_loaded(tmp_path: Path) -> None:
    (tmp_path / "ResPlan.pkl").write_bytes(pickle.dumps([plan()]))
    refused("resplan", tmp_path / "ResPlan.pkl", match=r"shapely\.geometry\.mapping")
    with pytest.raises(sw.InputError, match=r"shapely\.geometry\.mapping"):
        list(sw.read_scenes(tmp_path / "ResPlan.pkl"))


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda d: d.update(bedroom="POLYGON ((0 0, 1 1"), "no geometry"),
        (lambda d: d.update(bedroom={"type": "Polygon", "coordinates": [[[0, 0], [1, "a"], [1, 1]]]}), "bedroom"),
        (lambda d: d.update(bedroom="POLYGON ((0 0, nan 1, 1 1, 0 0))"), "bedroom"),
        (lambda d: d.update(bedroom=[3]), r"bedroom\[0\]"),
        (lambda d: [d.pop(k) for k in ("bedroom", "living")], "no layer is a room"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, change: Any, match: str) -> None:
    data = plan()
    change(data)
    refused("resplan", write(tmp_path, data), match=match)


def test_broken_collections_cut_off_and_empty(tmp_path: Path) -> None:
    data = collection()
    data["features"][0]["properties"] = {}
    refused("resplan", write(tmp_path, data), match="says what it is")
    for text in (json.dumps(plan())[:120], "", "3", '{"type": "FeatureCollection"}'):
        (tmp_path / "plan.json").write_text(text)
        refused("resplan", tmp_path / "plan.json")
