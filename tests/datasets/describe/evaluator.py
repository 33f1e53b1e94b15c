"""A second reading of scenes, from their JSON alone: shapely on footprints, cross products, rays one by one.

It shares nothing with `sceneweaver.datasets.describe` but the table of nouns, and answers questions and judges
statements by its own arithmetic.
"""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import shapely
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, Point, Polygon, box

from sceneweaver.assets import categories
from sceneweaver.datasets.describe.naming import noun, nouns


class Room:
    """A scene as its file has it."""

    def __init__(self, data: dict[str, Any]):
        self.data = data
        self.outline = Polygon(data["room"]["outline"])
        self.corners = np.array(data["room"]["outline"], dtype=float)
        self.objects = {o["id"]: o for o in data["objects"]}
        doors = data["room"]["doors"]
        self.door = doors[0] if len(doors) == 1 else None

    def yaw(self, i: str) -> float:
        x, y, z, w = self.objects[i]["pose"]["quaternion"]
        return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

    def at(self, i: str) -> np.ndarray:
        return np.array(self.objects[i]["pose"]["position"][:2])

    def front(self, i: str) -> np.ndarray:
        return np.array([math.cos(self.yaw(i)), math.sin(self.yaw(i))])

    def solids(self, i: str) -> list[tuple[Polygon, float, float]]:
        item = self.objects[i]
        d, w, h = item["size"]
        parts = item.get("parts") or [{"polygon": box(-d / 2, -w / 2, d / 2, w / 2).exterior.coords[:-1], "z": [0, h]}]
        x, y, z = item["pose"]["position"]
        return [(self._world(p["polygon"], i), z + p["z"][0], z + p["z"][1]) for p in parts]

    def _world(self, polygon: Any, i: str) -> Polygon:
        x, y, _ = self.objects[i]["pose"]["position"]
        return translate(rotate(Polygon(polygon), self.yaw(i), origin=(0, 0), use_radians=True), x, y)

    def box(self, i: str) -> Polygon:
        d, w, _ = self.objects[i]["size"]
        return self._world(box(-d / 2, -w / 2, d / 2, w / 2).exterior.coords[:-1], i)

    def footprint(self, i: str) -> Any:
        return shapely.union_all([p for p, _, _ in self.solids(i)])

    def heights(self, i: str) -> tuple[float, float]:
        solids = self.solids(i)
        return min(z for _, z, _ in solids), max(z for _, _, z in solids)

    def wall(self, k: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Ends, direction, and normal into the room."""
        a, b = self.corners[k], self.corners[(k + 1) % len(self.corners)]
        along = (b - a) / np.linalg.norm(b - a)
        return a, b, along, np.array([-along[1], along[0]])

    def doorway(self) -> tuple[np.ndarray, np.ndarray]:
        a, _, along, inward = self.wall(self.door["wall"])
        return a + along * (self.door["offset"] + self.door["width"] / 2), inward

    def door_zone(self) -> Polygon:
        a, _, along, inward = self.wall(self.door["wall"])
        start, end = self.door["offset"], self.door["offset"] + self.door["width"]
        depth = self.door["width"] if self.door["swing"].startswith("in") else 0.6
        return Polygon([a + along * u + inward * v for u, v in ((start, 0), (end, 0), (end, depth), (start, depth))])

    def wall_name(self, k: int) -> list[str]:
        """All names that fit a wall."""
        start, inward = self.doorway()
        _, _, _, normal = self.wall(k)
        turned = math.degrees(math.atan2(inward[0] * -normal[1] - inward[1] * -normal[0], float(inward @ -normal)))
        found = {0: "the wall opposite the door", 90: "the wall on the left", -90: "the wall on the right"}
        names = [name for angle, name in found.items() if abs(turned - angle) < 20]
        names += ["the wall with the door"] * (k == self.door["wall"])
        windows = [w["wall"] for w in self.data["room"]["windows"]]
        return names + [f"the wall with the window{'s' * (len(windows) > 1)}"] * (k in windows)

    def from_door(self, i: str) -> float:
        """Bearing of an object [deg], to the left of straight ahead."""
        start, inward = self.doorway()
        away = self.at(i) - start
        return math.degrees(math.atan2(inward[0] * away[1] - inward[1] * away[0], float(inward @ away)))

    def free_floor(self, radius: float, low: float = 0.02, high: float = 1.8) -> Any:
        hard = [p for i in self.objects for p, z0, z1 in self.solids(i) if z0 < high and z1 > low]
        return self.outline.buffer(-radius).difference(shapely.union_all(hard).buffer(radius))

    def entered(self, radius: float) -> Any:
        """What a disc's centre can get to from the zone of the door."""
        free, zone = self.free_floor(radius), self.door_zone()
        return shapely.union_all([p for p in shapely.get_parts(free) if p.intersects(zone)])

    def sees(self, eye: np.ndarray, point: np.ndarray, target: str, solids: list[Any]) -> bool:
        line = LineString([eye[:2], point[:2]])
        if not self.outline.buffer(0.02).contains(line):
            return False
        for owner, polygon, low, high in solids:
            if owner == target or not polygon.intersects(line):
                continue
            inside = polygon.intersection(line)
            along = [line.project(Point(c)) / max(line.length, 1e-9) for c in shapely.get_coordinates(inside)]
            heights = [eye[2] + t * (point[2] - eye[2]) for t in (min(along), max(along))]
            if max(heights) > low + 1e-6 and min(heights) < high - 1e-6:
                return False
        return True

    def seen_share(self, eye: np.ndarray, i: str, count: int = 60) -> float:
        rng = np.random.default_rng(0)
        d, w, h = self.objects[i]["size"]
        c, s = self.front(i)
        local = (rng.random((count, 3)) - (0.5, 0.5, 0.0)) * (d, w, h)
        x, y, z = self.objects[i]["pose"]["position"]
        points = np.stack(
            [x + c * local[:, 0] - s * local[:, 1], y + s * local[:, 0] + c * local[:, 1], z + local[:, 2]], 1
        )
        area = box(*np.minimum(points[:, :2].min(0), eye[:2]), *np.maximum(points[:, :2].max(0), eye[:2]))
        solids = [(k, *solid) for k in self.objects for solid in self.solids(k) if solid[0].intersects(area)]
        return float(np.mean([self.sees(eye, p, i, solids) for p in points]))


def answer(room: Room, row: dict[str, Any]) -> bool:
    """Whether the answer of a question is right."""
    return _ANSWERS[row["template"]](room, row)


def _yes(row: dict[str, Any], true: bool) -> bool:
    return row["answer"] == ("yes" if true else "no")


def _number(row: dict[str, Any], value: float) -> bool:
    return abs(row["answer"] - value) <= row["tolerance"] * 0.6


def _named(room: Room, text: str, word: Any) -> list[str]:
    """Ids of the objects of the category that a text names: of several whose noun stands in it the longest."""
    known = {c for c, category in categories().items() if category.size} | {
        o["category"] for o in room.objects.values()
    }
    found = sorted(c for c in known if word(c) in text and re.search(rf"\b{re.escape(word(c))}\b", text))
    longest = max(found, key=lambda c: len(word(c)))
    return [i for i, o in room.objects.items() if o["category"] == longest]


def _more(room: Room, row: dict[str, Any]) -> bool:
    first, second = re.search(r"more (.*) than (.*?)( in the room)?\?", row["question"]).group(1, 2)
    count = {w: sum(nouns(o["category"]) == w for o in room.objects.values()) for w in (first, second)}
    return _yes(row, count[first] > count[second])


def _on(room: Room, row: dict[str, Any]) -> bool:
    carrier, how = row["objects"][0], row["template"].removeprefix("what_is_")
    room_for = {s["name"]: s["headroom"] is not None for s in room.objects[carrier]["surfaces"]}
    found = [
        noun(o["category"])
        for o in room.objects.values()
        if o["support"] and o["support"]["object"] == carrier and room_for[o["support"]["surface"]] == (how == "in")
    ]
    return sorted(found) == row["answer"]


def _is_on(room: Room, row: dict[str, Any]) -> bool:
    thing, carrier = room.objects[row["objects"][0]], row["objects"][1]
    support = thing["support"]
    if support is None or support["object"] != carrier:
        return row["answer"] == "no"
    return row["answer"] == "yes" and room.box(carrier).buffer(0.05).contains(Point(room.at(thing["id"])))


def _side_from_door(room: Room, row: dict[str, Any]) -> bool:
    a, b = row["objects"]
    start, inward = room.doorway()
    left = np.array([-inward[1], inward[0]])
    across = [(shapely.get_coordinates(room.footprint(i)) - start) @ left for i in (a, b)]
    first = "left" if across[0].mean() > across[1].mean() else "right"
    bearing = "left" if room.from_door(a) > room.from_door(b) else "right"
    apart = max(across[0].min() - across[1].max(), across[1].min() - across[0].max())
    return row["answer"] == first == bearing and apart > 0


def _side_of(room: Room, row: dict[str, Any]) -> bool:
    a, b = row["objects"]
    look = room.front(b) if "You sit on" in row["question"] else -room.front(b)
    away = room.at(a) - room.at(b)
    return row["answer"] == ("left" if look[0] * away[1] - look[1] * away[0] > 0 else "right")


def _degrees_off(room: Room, a: str, b: str) -> float:
    away = room.at(b) - room.at(a)
    return math.degrees(math.acos(np.clip(room.front(a) @ away / np.linalg.norm(away), -1, 1)))


def _faces(room: Room, row: dict[str, Any]) -> bool:
    off = _degrees_off(room, *row["objects"])
    return off < 15 if row["answer"] == "yes" else off > 40


def _wall(room: Room, row: dict[str, Any]) -> bool:
    i = row["objects"][0]
    away = [LineString(room.wall(k)[:2]).distance(room.box(i)) for k in range(len(room.corners))]
    best = int(np.argmin(away))
    others = [k for k in range(len(away)) if k != best and set(room.wall_name(k)) & set(row["options"])]
    return row["answer"] in room.wall_name(best) and min(away[k] for k in others) > 0.2


def _between(room: Room, row: dict[str, Any]) -> bool:
    subject, a, b = row["objects"]
    start, end = room.at(a), room.at(b)
    line = LineString([start, end])

    def middle(i: str) -> bool:
        spot = Point(room.at(i))
        return 0.15 < line.project(spot, normalized=True) < 0.85 and line.distance(spot) < 0.6

    right = [i for i in row["option_objects"] if middle(i)]
    return right == [subject] and row["options"][row["option_objects"].index(subject)] == row["answer"]


def _pick(row: dict[str, Any], values: dict[str, float], best: Any) -> bool:
    chosen = best(row["option_objects"], key=lambda i: values[i])
    return row["options"][row["option_objects"].index(chosen)] == row["answer"]


def _nearest(room: Room, row: dict[str, Any]) -> bool:
    me = room.footprint(row["objects"][0])
    return _pick(row, {i: room.footprint(i).distance(me) for i in row["option_objects"]}, min)


def _apart(room: Room, row: dict[str, Any]) -> float:
    a, b = row["objects"]
    return room.footprint(a).distance(room.footprint(b))


def _height(room: Room, i: str) -> float:
    low, high = room.heights(i)
    return high - low


def _within(room: Room, row: dict[str, Any]) -> bool:
    limit = float(re.search(r"less than ([\d.]+) m", row["question"]).group(1))
    return _yes(row, _apart(room, row) < limit)


def _free(room: Room, row: dict[str, Any]) -> bool:
    rng = np.random.default_rng(0)
    low, high = room.corners.min(0), room.corners.max(0)
    points = shapely.points(low + (high - low) * rng.random((40000, 2)))
    standing = [i for i in room.objects if room.heights(i)[0] < 0.03 < room.heights(i)[1]]
    taken = [room.footprint(i) for i in standing]
    free = shapely.contains(shapely.difference(room.outline, shapely.union_all(taken)), points)
    return _number(row, float(free.mean() * np.prod(high - low)))


def _robot(room: Room, row: dict[str, Any]) -> bool:
    radius = float(re.search(r"(\d+) cm", row["question"]).group(1)) / 200
    return _yes(row, room.entered(radius).distance(room.footprint(row["objects"][0])) <= radius + 0.3)


def _reach(room: Room, row: dict[str, Any]) -> bool:
    i = row["objects"][0]
    plan = room.entered(0.2).distance(room.box(i))
    low = room.objects[i]["pose"]["position"][2]
    up = max(0.0, low - 1.4, 1.4 - low - room.objects[i]["size"][2])
    return _yes(row, math.hypot(plan, up) <= 0.7)


def _seen(room: Room, row: dict[str, Any]) -> bool:
    start, inward = room.doorway()
    share = room.seen_share(np.append(start + 0.05 * inward, 1.6), row["objects"][0])
    return share > 0.25 if row["answer"] == "yes" else share < 0.02


_ANSWERS: dict[str, Any] = {
    "count": lambda room, row: row["answer"] == len(_named(room, row["question"], nouns)),
    "exists": lambda room, row: _yes(row, bool(_named(room, row["question"], noun))),
    "more_of": _more,
    "color": lambda room, row: row["answer"] == room.objects[row["objects"][0]]["attributes"]["color"],
    "what_is_on": _on,
    "what_is_in": _on,
    "is_on": _is_on,
    "side_from_door": _side_from_door,
    "side_of_thing": _side_of,
    "faces": _faces,
    "which_wall": _wall,
    "between": _between,
    "distance": lambda room, row: _number(row, _apart(room, row)),
    "within": _within,
    "nearest": _nearest,
    "taller": lambda room, row: _yes(row, _height(room, row["objects"][0]) > _height(room, row["objects"][1])),
    "largest": lambda room, row: _pick(row, {i: room.box(i).area for i in row["option_objects"]}, max),
    "floor_area": lambda room, row: _number(row, room.outline.area),
    "free_floor": _free,
    "height": lambda room, row: _number(row, 100 * _height(room, row["objects"][0])),
    "robot_reaches": _robot,
    "in_reach": _reach,
    "seen_from_door": _seen,
}


def holds(room: Room, statement: dict[str, Any]) -> bool:
    """Whether a statement of a caption is true."""
    ids, value = statement["objects"], statement.get("value")
    return bool(_STATEMENTS[statement["predicate"]](room, ids, value))


def _against(room: Room, ids: list[str], value: Any) -> bool:
    a, b, _, inward = room.wall(int(value.removeprefix("wall:")))
    near = LineString([a, b]).distance(room.box(ids[0])) < 0.08
    return near and room.front(ids[0]) @ inward > 0.99


def _along(room: Room, ids: list[str], value: Any) -> bool:
    return value is None or LineString(room.wall(int(value.removeprefix("wall:")))[:2]).distance(room.box(ids[0])) < 0.2


def _rests(inner: bool) -> Any:
    def test(room: Room, ids: list[str], value: Any) -> bool:
        support = room.objects[ids[0]]["support"]
        surfaces = {s["name"]: s for s in room.objects[ids[1]]["surfaces"]}
        surface = surfaces[support["surface"]]
        bottom = room.objects[ids[1]]["pose"]["position"][2] + surface["z"]
        rests = abs(room.heights(ids[0])[0] - bottom) < 0.01
        return support["object"] == ids[1] and rests and (surface["headroom"] is not None) == inner

    return test


def _count(room: Room, ids: list[str], value: Any) -> bool:
    there = [i for i, o in room.objects.items() if o["category"] == value["category"]]
    return sorted(ids) == sorted(there) and len(there) == value["count"]


def _extent(room: Room, ids: list[str], value: Any) -> bool:
    lengths = sorted((float(np.linalg.norm(room.wall(k)[1] - room.wall(k)[0])) for k in (0, 1)), reverse=True)
    return np.allclose(lengths, value, atol=0.0501)


def _window_side(room: Room, ids: list[str], value: Any) -> bool:
    windows = {w["id"]: w for w in room.data["room"]["windows"]}
    names = {"straight ahead": "the wall opposite the door"}
    return all(names.get(value, f"the wall {value}") in room.wall_name(windows[i]["wall"]) for i in ids)


def _midway(room: Room, ids: list[str], value: Any) -> bool:
    line, spot = LineString([room.at(ids[1]), room.at(ids[2])]), Point(room.at(ids[0]))
    return line.distance(spot) < 0.5 and 0.2 < line.project(spot, normalized=True) < 0.8


_STATEMENTS: dict[str, Any] = {
    "room_type": lambda room, ids, value: room.data["room"]["type"] == value,
    "floor_area": lambda room, ids, value: abs(room.outline.area - value) <= (0.0501 if value != int(value) else 0.501),
    "extent": _extent,
    "corners": lambda room, ids, value: len(room.corners) == value,
    "doors": lambda room, ids, value: len(room.data["room"]["doors"]) == value,
    "windows": lambda room, ids, value: len(room.data["room"]["windows"]) == value,
    "window_side": _window_side,
    "count": _count,
    "color": lambda room, ids, value: room.objects[ids[0]]["attributes"]["color"] == value,
    "material": lambda room, ids, value: room.objects[ids[0]]["attributes"]["material"] == value,
    "rests_on": _rests(False),
    "rests_in": _rests(True),
    "against_wall": _against,
    "along_wall": _along,
    "on_wall": lambda room, ids, value: room.objects[ids[0]]["mount"] == "wall" and _along(room, ids, value),
    "on_floor": lambda room, ids, value: room.objects[ids[0]]["mount"] == "floor" and room.heights(ids[0])[0] < 0.01,
    "on_ceiling": lambda room, ids, value: room.objects[ids[0]]["mount"] == "ceiling",
    "near": lambda room, ids, value: room.footprint(ids[0]).distance(room.footprint(ids[1])) <= value["max"],
    "facing": lambda room, ids, value: _degrees_off(room, *ids) < 15,
    "between": _midway,
    "left_from_door": lambda room, ids, value: room.from_door(ids[0]) > 20,
    "right_from_door": lambda room, ids, value: room.from_door(ids[0]) < -20,
    "ahead_of_door": lambda room, ids, value: abs(room.from_door(ids[0])) < 12,
}
