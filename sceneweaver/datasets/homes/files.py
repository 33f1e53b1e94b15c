"""What a shard holds of a home, and the columns of its row."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import shapely

from sceneweaver.assets import Library
from sceneweaver.home import Home
from sceneweaver.navigation import (
    Roadmap,
    navigation_graph,
    object_goal_episodes,
    occupancy_map,
    point_goal_episodes,
)
from sceneweaver.navigation.habitat import packed_episodes
from sceneweaver.verify.home import HomeReport, Ways

from ..describe import describe
from ..files.fingerprint import Layout
from ..spec import Spec
from ..store import AssetStore
from ..store.scene_files import scene_files


def home_files(
    spec: Spec, key: str, home: Home, report: HomeReport, seed: int, library: Library, store: AssetStore
) -> tuple[dict[str, bytes], dict[str, Any]]:
    """By suffix, what a shard holds of a home, and the columns that tell of its episodes.

    Args:
        spec: says what is wanted.
        key: the name of the home in shards.
        home: the home.
        report: the judge's word on it.
        seed: of its episodes, and of how its rooms are described.
        library: where its assets come from.
        store: where meshes and images go.
    """
    asked = spec.of_homes
    roadmap = Roadmap(home, asked.radius, stairs=False)
    points = point_goal_episodes(home, asked.point_goals, seed, roadmap=roadmap)
    things = object_goal_episodes(home, asked.object_goals, seed, roadmap=roadmap)
    files = {
        "home.json": _text(home.to_json()),
        "metrics.json": _text(timeless(report).to_dict()),
        "navigation.json": navigation_graph(home, asked.radius).to_json().encode(),
        "pointnav.json.gz": packed_episodes(points, f"{key}.glb"),
        "objectnav.json.gz": packed_episodes(things, f"{key}.glb"),
        **map_files(home, asked.resolution, roadmap.ways),
        **room_files(spec, home, seed),
        **scene_files(home, spec.exports, store, library.load),
    }
    return files, {"point_goals": len(points.episodes), "object_goals": len(things.episodes)}


def map_files(home: Home, resolution: float, ways: Ways) -> dict[str, bytes]:
    """The maps of all storeys: ``map-<n>.png``, ``.yaml``, ``.npz``, ``.rooms.png``, ``.rooms.json``, from below."""
    found: dict[str, bytes] = {}
    for number, storey in enumerate(home.storeys):
        found |= occupancy_map(home, storey.id, resolution, ways=ways).files(f"map-{number}")
    return found


def room_files(spec: Spec, home: Home, seed: int) -> dict[str, bytes]:
    """The scenes of the furnished rooms, ``room-<nn>.scene.json`` by their place in the home, with their captions."""
    found: dict[str, bytes] = {}
    for number, room in enumerate(home.rooms):
        if room.scene is None:
            continue
        found[f"room-{number:02d}.scene.json"] = _text(room.scene.to_json())
        texts = describe(room.scene, (seed + number) % 2**32) if spec.captions else {}
        found |= {f"room-{number:02d}.{suffix}": content for suffix, content in texts.items()}
    return found


def timeless(report: HomeReport) -> HomeReport:
    """A report without what differs from run to run."""
    rooms = {name: replace(room, seconds={}) for name, room in report.rooms.items()}
    return replace(report, rooms=rooms, seconds={})


def _text(data: Mapping[str, Any]) -> bytes:
    return json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()


def home_columns(home: Home) -> dict[str, Any]:
    """The columns of a row that tell of a home itself."""
    things = [obj for room in home.rooms if room.scene is not None for obj in room.scene.objects]
    return {
        "area": round(sum(shapely.Polygon(room.outline).area for room in home.rooms), 3),
        "storeys": len(home.storeys),
        "room_count": len(home.rooms),
        "room_types": sorted({room.type for room in home.rooms}),
        "door_count": len(home.doors),
        "object_count": len(things),
        "categories": sorted({obj.category for obj in things}),
        "furnished": any(room.scene is not None for room in home.rooms),
    }


def report_columns(report: HomeReport) -> dict[str, Any]:
    """The columns of a row that the judge measures."""
    access = report.access
    return {
        "valid": report.valid,
        "plan_valid": None if report.plan is None else report.plan.valid,
        "walkable_share": round(access.walkable_share, 9),
        "reachable_share": round(access.reachable_share, 9),
        "unreached": [*access.unreached_rooms, *access.unreached_objects],
    }


def asset_columns(home: Home, library: Library) -> dict[str, Any]:
    """The columns of a row that tell where its assets come from."""
    things = [obj for room in home.rooms if room.scene is not None for obj in room.scene.objects]
    ids = sorted({obj.asset for obj in things if obj.asset is not None})
    return {"asset_ids": ids, "licences": sorted({library.load(name).origin.licence for name in ids})}


def home_fingerprint(home: Home) -> dict[str, Any]:
    """What packing needs of a home to find near-duplicates: as for a room, of its walls and all large furniture.

    Each room stands for a thing of its kind and area in its middle that looks away from the middle of the home, so that
    plans are told apart by their rooms as rooms are by their furniture.
    """
    order = {storey.id: number for number, storey in enumerate(home.storeys)}
    floors = [shapely.Polygon(room.outline) for room in home.rooms]
    hull: Any = shapely.union_all(floors).convex_hull
    outline = np.asarray(hull.exterior.coords)[:-1][::-1]
    middle = np.array(hull.centroid.coords[0])
    boxes: list[tuple[str, tuple[float, ...]]] = []
    for room, floor in zip(home.rooms, floors, strict=True):
        storey, side = order[room.storey], float(np.sqrt(floor.area))
        at = np.array(floor.centroid.coords[0])
        out = at - middle
        boxes.append((f"{storey} room {room.type}", (*at, float(np.arctan2(out[1], out[0])), side, side)))
        if room.scene is not None:
            things = Layout.of(room.scene)
            named = (f"{storey} {name}" for name in things.categories)
            boxes += zip(named, map(tuple, things.boxes.tolist()), strict=True)
    boxes.sort(key=lambda box: box[0])
    return Layout(outline, tuple(name for name, _ in boxes), np.array([box for _, box in boxes])).columns
