"""A small plan of a room as SVG, drawn from the JSON of its scene: a few kilobytes, for hundreds on a page."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from types import SimpleNamespace
from typing import Any
from urllib.parse import quote

from sceneweaver.render import palette

SMALLEST = 0.12
"""Things on surfaces whose longer side is shorter than this [m] are left out."""

_PARTS = 5  # of an object, at most
_MARGIN = 0.18  # around the outline [m]
_FLAT = {"rug", "carpet", "mat"}


def plan(scene: Mapping[str, Any]) -> str:
    """The plan of a scene as the text of an SVG file, in centimetres, north up."""
    room = scene["room"]
    outline = room["outline"]
    left, low, right, high = box_of(outline)
    floor, pen = path_of(outline), max(right - left, high - low)  # lines of one width on cards of one size
    body = [f"<path d='{floor}' fill='{_color(palette.FLOOR)}'/>"]
    body += [_object(obj, 0.28 * pen) for obj in sorted(_shown(scene["objects"]), key=_height)]
    body.append(f"<path d='{floor}' fill='none' stroke='{_color(palette.WALL)}' stroke-width='{1.6 * pen:.1f}'/>")
    body += [_opening(outline, door, palette.PAPER, 1.8 * pen) for door in room.get("doors", ())]
    body += [_opening(outline, window, palette.GLASS, 1.1 * pen) for window in room.get("windows", ())]
    corner = f"{_cm(left - _MARGIN)} {_cm(-high - _MARGIN)}"
    box = f"{corner} {_cm(right - left + 2 * _MARGIN)} {_cm(high - low + 2 * _MARGIN)}"
    return f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='{box}'>{''.join(body)}</svg>"


def box_of(points: Sequence[Sequence[float]]) -> tuple[float, float, float, float]:
    """Least x and y, greatest x and y [m]."""
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


def path_of(points: Sequence[Sequence[float]]) -> str:
    """A polygon [m] as the data of an SVG path [cm], north up."""
    return "M" + " ".join(f"{_cm(x)} {_cm(-y)}" for x, y in points) + "Z"


def image_url(svg: str) -> str:
    """An SVG as a data address."""
    return "data:image/svg+xml," + quote(svg, safe=" '/=:,.-;()!*")


def _shown(objects: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """What is seen from above at this size."""
    return [o for o in objects if o["mount"] in ("floor", "wall") or max(o["size"][:2]) >= SMALLEST]


def _height(obj: Mapping[str, Any]) -> tuple[float, str]:
    flat = not _FLAT.isdisjoint(palette.words_of(obj["category"]))
    return (-1.0 if flat else obj["pose"]["position"][2] + obj["size"][2]), obj["id"]


def _object(obj: Mapping[str, Any], edge: float) -> str:
    x, y, _ = obj["pose"]["position"]
    qx, qy, qz, qw = obj["pose"]["quaternion"]
    yaw = math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz))
    cos, sin = math.cos(yaw), math.sin(yaw)
    d, w, _ = obj["size"]
    shapes = [[(-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2)]]
    if obj.get("parts"):
        large = [part for part in obj["parts"] if _extent(part["polygon"]) > 0.15 * max(d, w)]
        large = sorted(large, key=lambda part: -_extent(part["polygon"]))[:_PARTS]
        shapes = [part["polygon"] for part in sorted(large, key=lambda part: part["z"][1])] or shapes
    seen: Any = SimpleNamespace(attributes=obj.get("attributes") or {}, category=obj["category"])
    fill = palette.fill_of(seen)
    paths = "".join(path_of([(x + cos * u - sin * v, y + sin * u + cos * v) for u, v in shape]) for shape in shapes)
    dark = _color(palette.darker(fill, 0.35))
    return f"<path d='{paths}' fill='{_color(fill)}' stroke='{dark}' stroke-width='{edge:.1f}'/>"


def _opening(outline: Sequence[Sequence[float]], opening: Mapping[str, Any], color: palette.Rgb, width: float) -> str:
    (ax, ay), (bx, by) = outline[opening["wall"]], outline[(opening["wall"] + 1) % len(outline)]
    length = math.hypot(bx - ax, by - ay)
    ends = [opening["offset"] / length, (opening["offset"] + opening["width"]) / length]
    line = " ".join(f"{_cm(ax + t * (bx - ax))} {_cm(-ay - t * (by - ay))}" for t in ends)
    return f"<path d='M{line}' stroke='{_color(color)}' stroke-width='{width:.1f}'/>"


def _extent(polygon: Sequence[Sequence[float]]) -> float:
    left, low, right, high = box_of(polygon)
    return max(right - left, high - low)


def _cm(metres: float) -> int:
    return round(100 * metres)


def _color(rgb: palette.Rgb) -> str:
    return "#{:02x}{:02x}{:02x}".format(*rgb)
