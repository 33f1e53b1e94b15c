"""Maps of the storeys of a home as robots keep them: what is occupied, where a base can be, which room is where."""

from __future__ import annotations

import io
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.home import Home, wall_polygons
from sceneweaver.io import InputError, dump_yaml, write_atomic
from sceneweaver.io.messages import is_number, show
from sceneweaver.verify.home import RADIUS, Ways

FREE, OCCUPIED, UNKNOWN = 0, 100, -1
"""Values of ``occupancy``, as in ROS's ``nav_msgs/OccupancyGrid``."""

_GREY = {FREE: 254, OCCUPIED: 0, UNKNOWN: 205}  # as map_server draws them
_THRESHOLDS = {"occupied_thresh": 0.65, "free_thresh": 0.196}
_MARGIN = 0.5  # [m] around the walls
MOST_CELLS = 25_000_000
"""Cells of a map at most: a square of 250 m at 5 cm."""


@dataclass(frozen=True, eq=False)
class OccupancyMap:
    """The map of one storey. Row 0 has the least y, column 0 the least x; a cell stands for its middle.

    Attributes:
        storey: id of the storey.
        resolution: side of a cell [m].
        origin: the corner (x, y) of the first cell in the home's frame [m].
        radius: of the base that ``navigable`` is for [m].
        occupancy: int8 [H, W]: `FREE` floor, `OCCUPIED` by walls or by solids between 2 cm and 1.8 m, else `UNKNOWN`.
        navigable: bool [H, W]: whether the middle of the base may be there, and gets there from the entrance.
        labels: uint8 [H, W]: which room it is, 0 none, k the k-th of ``rooms``; also under furniture.
        rooms: ids of the rooms of the storey.
        types: kinds of these rooms.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import occupancy_map
        >>> found = occupancy_map(sw.Home.example("flat"))
        >>> found.occupancy.shape == found.labels.shape, bool(found.navigable.any())
        (True, True)
    """

    storey: str
    resolution: float
    origin: tuple[float, float]
    radius: float
    occupancy: np.ndarray
    navigable: np.ndarray
    labels: np.ndarray
    rooms: tuple[str, ...]
    types: tuple[str, ...]

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Row and column of the cell that a point of the home's frame [m] is in."""
        return int((y - self.origin[1]) // self.resolution), int((x - self.origin[0]) // self.resolution)

    def files(self, stem: str) -> dict[str, bytes]:
        """The files of the map by name.

        ``<stem>.png`` and ``<stem>.yaml`` are what ROS's map_server reads (white floor, black walls and furniture, grey
        what is unknown), ``<stem>.rooms.png`` has the number of the room as grey value with the names in
        ``<stem>.rooms.json``, and ``<stem>.npz`` the arrays as they are.
        """
        grey = np.vectorize(_GREY.__getitem__, otypes=[np.uint8])(self.occupancy)
        about = {
            "image": f"{stem}.png",
            "mode": "trinary",
            "resolution": float(self.resolution),
            "origin": [float(self.origin[0]), float(self.origin[1]), 0.0],
            "negate": 0,
            **_THRESHOLDS,
        }
        names = {str(k): {"id": a, "type": b} for k, (a, b) in enumerate(zip(self.rooms, self.types, strict=True), 1)}
        arrays = io.BytesIO()
        np.savez_compressed(
            arrays,
            occupancy=self.occupancy,
            navigable=self.navigable,
            labels=self.labels,
            rooms=np.array(self.rooms),
            types=np.array(self.types),
            origin=np.array(self.origin),
            resolution=np.array(self.resolution),
            radius=np.array(self.radius),
        )
        return {
            f"{stem}.png": _png(grey),
            f"{stem}.yaml": dump_yaml(about, sort_keys=False).encode(),
            f"{stem}.rooms.png": _png(self.labels),
            f"{stem}.rooms.json": (json.dumps(names, indent=1, ensure_ascii=False) + "\n").encode(),
            f"{stem}.npz": arrays.getvalue(),
        }

    def save(self, folder: str | Path, stem: str | None = None) -> list[Path]:
        """Write the files of the map into a folder; ``stem`` is ``map_<storey>`` unless given."""
        Path(folder).mkdir(parents=True, exist_ok=True)
        written = []
        for name, content in self.files(stem or f"map_{self.storey}").items():
            write_atomic(Path(folder) / name, content)
            written.append(Path(folder) / name)
        return written


def occupancy_map(
    home: Home,
    storey: str | None = None,
    resolution: float = 0.05,
    radius: float = RADIUS,
    *,
    ways: Ways | None = None,
) -> OccupancyMap:
    """The map of a storey.

    Args:
        home: the home, furnished or not.
        storey: its id; None: the lowest.
        resolution: side of a cell [m], 0.005 to 1.
        radius: of the base that ``navigable`` is for [m].
        ways: those of this home that there are already; their radius counts.

    Raises:
        InputError: no such storey, or a resolution out of its range or too fine for the home.
    """
    import shapely

    if not is_number(resolution) or not 0.005 <= resolution <= 1:
        raise InputError(f"resolution is {show(resolution)}; give metres, 0.005 to 1")
    found = home.storeys[0] if storey is None else home.storey(storey)
    ways = Ways.of(home, radius=radius) if ways is None else ways
    floor, rooms = ways.floors[found.id], home.rooms_of(found.id)
    solid = [*wall_polygons(home, found.id), *(shapely.Polygon(room.outline) for room in rooms)]
    bounds = np.array([shape.bounds for shape in solid])
    low = np.floor((bounds[:, :2].min(axis=0) - _MARGIN) / resolution) * resolution
    count = np.ceil((bounds[:, 2:].max(axis=0) + _MARGIN - low) / resolution).astype(int)
    if int(count[0]) * int(count[1]) > MOST_CELLS:
        raise InputError(
            f"resolution is {resolution:g} m, too fine for {count[0]} x {count[1]} cells; give a coarser one"
        )
    x, y = (low[k] + (np.arange(count[k]) + 0.5) * resolution for k in (0, 1))
    xs, ys = np.meshgrid(x, y)

    def inside(shape: Any) -> np.ndarray:
        shapely.prepare(shape)
        return shapely.intersects_xy(shape, xs, ys)

    free = inside(floor.ground)
    occupancy = np.where(inside(shapely.union_all(solid)), OCCUPIED, UNKNOWN).astype(np.int8)
    occupancy[free] = FREE
    navigable = np.zeros(free.shape, dtype=bool)
    for storey_id, k in ways.entered[1]:
        if storey_id == found.id:
            navigable |= inside(floor.regions[k])
    labels = np.zeros(free.shape, dtype=np.uint8)
    for k, room in enumerate(rooms[:255], start=1):
        labels[inside(shapely.Polygon(room.outline))] = k
    ids, types = tuple(room.id for room in rooms[:255]), tuple(room.type for room in rooms[:255])
    corner = (round(float(low[0]), 9), round(float(low[1]), 9))
    return OccupancyMap(found.id, float(resolution), corner, floor.radius, occupancy, navigable, labels, ids, types)


def _png(grey: np.ndarray) -> bytes:
    """A picture of grey values [H, W], the last row at the top."""
    from PIL import Image

    content = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(grey[::-1])).save(content, "PNG")
    return content.getvalue()
