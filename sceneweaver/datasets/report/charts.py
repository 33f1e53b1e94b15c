"""Drawings of the report: charts by the templates of ``web``, and plans of rooms."""

from __future__ import annotations

import base64
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any
from urllib.parse import quote

import numpy as np

from sceneweaver.render import palette

from ..templates import html

Line = tuple[str, Sequence[tuple[float, float]]]
"""A name, and points (x, y)."""


def _drawn(chart: str, *numbers: Any, **named: Any) -> str:
    """A chart of ``charts.html``."""
    return getattr(html().get_template("report/web/charts.html").module, chart)(*numbers, **named)


def histogram(spread: Mapping[str, Any]) -> str:
    """A histogram of `statistics.Spread.result`, with a mark at the mean; bins beyond the last number are cut."""
    counts, low, high = list(spread["histogram"]), spread["low"], spread["high"]
    step = (high - low) / len(counts)
    filled = [k for k, count in enumerate(counts) if count]
    first, last = (0 if filled[0] < 4 else filled[0] - 1), max(filled[-1] + 1, 4)
    counts, start, end = counts[first:last], low + first * step, low + last * step
    width, height, base = 300, 112, 92
    wide, most = width / len(counts), max(counts)

    def number(value: float) -> str:
        return f"{100 * value:.0f} %" if high == 1.0 else f"{value:g}"

    bars = []
    for k, count in enumerate(counts):
        if count:
            tall = count / most * (base - 8)
            words = f"{number(start + k * step)} to {number(start + (k + 1) * step)}: {count:,}"
            bars.append((k * wide + 0.7, base - tall, wide - 1.4, tall, words))
    mean = min(max((spread["mean"] - start) / (end - start), 0.0), 1.0) * width
    beyond = "+" if spread["most"] > high else ""
    return _drawn("histogram", width, height, base, bars, mean, number(start), number(end) + beyond)


def heat_map(cells: np.ndarray) -> str:
    """A heat map [rows from below, columns] as the data address of a picture: the brighter, the more often."""
    from PIL import Image
    from scipy.ndimage import gaussian_filter

    smooth = gaussian_filter(np.asarray(cells, dtype=float), 0.9, mode="nearest")[::-1]
    share = (smooth / (smooth.max() or 1.0))[..., None] ** 0.7
    stops = np.array([[247, 244, 238], [252, 211, 138], [232, 121, 70], [150, 38, 90], [60, 14, 80]], dtype=float)
    place = share * (len(stops) - 1)
    lower = np.minimum(place.astype(int), len(stops) - 2)[..., 0]
    mixed = stops[lower] + (place - lower[..., None]) * (stops[lower + 1] - stops[lower])
    file = io.BytesIO()
    Image.fromarray(mixed.round().astype(np.uint8)).save(file, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}"


def lines(series: Sequence[Line], *, x: str, y: str, width: int = 680, height: int = 230) -> str:
    """Lines over a common axis that begins at zero, the names of the axes at their ends; empty without points."""
    points = [point for _, line in series for point in line]
    if not points:
        return ""
    left, right, top, base = 52, 10, 22, height - 32
    far, highest = (max(values) for values in zip(*points, strict=True))
    far = far or 1.0
    step, across = nice(highest / 4), nice(far / 5)
    high = step * math.ceil(highest / step - 1e-9) or step

    def place(px: float, py: float) -> tuple[float, float]:
        return left + px / far * (width - left - right), base - py / high * (base - top)

    levels = [(place(0, k * step)[1], f"{k * step:g}") for k in range(round(high / step) + 1)]
    ticks = [(place(k * across, 0)[0], f"{k * across:g}") for k in range(math.floor(far / across + 1e-9) + 1)]
    curves = [(name, " ".join("{:.1f} {:.1f}".format(*place(*point)) for point in line)) for name, line in series]
    return _drawn("lines", width, height, left, right, x=x, y=y, levels=levels, ticks=ticks, curves=curves)


def nice(step: float) -> float:
    """The smallest of 1, 2 and 5 times a power of ten that is at least a step."""
    if step <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(step))
    return next((factor * power for factor in (1, 2, 5) if factor * power >= step * (1 - 1e-9)), 10 * power)


BINS = 80
"""Points of the line of throughput."""


def throughput(records: Sequence[Mapping[str, Any]]) -> Line:
    """Delivered scenes a second over minutes since the first block began; a block counts evenly over its time."""
    start = min(record["start"] for record in records)
    end = max(record["end"] for record in records)
    edges = np.linspace(0.0, max(end - start, 1e-3), min(BINS, 2 * len(records)) + 1)
    rate = np.zeros(len(edges) - 1)
    for record in records:
        first, last = record["start"] - start, max(record["end"] - start, record["start"] - start + 1e-3)
        inside = np.clip(np.minimum(edges[1:], last) - np.maximum(edges[:-1], first), 0.0, None)
        rate += record["ok"] * inside / (last - first)
    rate /= np.diff(edges)
    middle = (edges[1:] + edges[:-1]) / 2
    return "scenes a second", [(at / 60, value) for at, value in zip(middle.tolist(), rate.tolist(), strict=True)]


def memory(records: Iterable[Mapping[str, Any]]) -> list[Line]:
    """Resident memory [MB] of each worker process over the scenes that it has made."""
    workers: dict[tuple[Any, ...], list[tuple[float, float]]] = {}
    for record in sorted(records, key=lambda record: record["end"]):
        if record.get("rss"):
            line = workers.setdefault((record.get("host"), record.get("worker"), record.get("pid")), [])
            made = sum(record.get(status, 0) for status in ("ok", "rejected", "failed"))
            line.append(((line[-1][0] if line else 0) + made, record["rss"] / 1e6))
    return [(f"worker {worker} on {host}", line) for (host, worker, _), line in workers.items() if len(line) > 1]


def throughput_svg(records: Sequence[Mapping[str, Any]]) -> str:
    """The line of throughput as an SVG; empty without records."""
    return lines([throughput(records)], x="minutes", y="scenes a second") if records else ""


def memory_svg(records: Iterable[Mapping[str, Any]]) -> str:
    """The lines of memory as an SVG; empty without records."""
    return lines(memory(records), x="scenes made by a worker", y="MB")


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
        large = [part for part in obj["parts"] if extent_of(part["polygon"]) > 0.15 * max(d, w)]
        large = sorted(large, key=lambda part: -extent_of(part["polygon"]))[:_PARTS]
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


def extent_of(polygon: Sequence[Sequence[float]]) -> float:
    """The longer side [m] of the box about a polygon."""
    left, low, right, high = box_of(polygon)
    return max(right - left, high - low)


def _cm(metres: float) -> int:
    return round(100 * metres)


def _color(rgb: palette.Rgb) -> str:
    return "#{:02x}{:02x}{:02x}".format(*rgb)
