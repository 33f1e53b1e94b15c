"""A plan drawn in any program that writes SVG: closed shapes named by their rooms, lines for doors and windows."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, load_xml
from sceneweaver.io.messages import path_name, show

from ..drawings import Drawing, Drawn, rooms_of_drawing
from ..line_plans import Label
from ..model import ReadOptions, SourceFormat, SourceRoom
from ..svg_text import NUMBER, matrix_of, tag

WORDS = ("{http://www.inkscape.org/namespaces/inkscape}label", "data-name", "aria-label", "class", "id")
"""Attributes that say what an element is, the surest first."""

CALLED = ("rect", "polygon", "polyline", "line", "path", "circle", "ellipse")
SAME = 1e-6


def matches(path: Path, head: bytes) -> bool:
    """Any SVG."""
    return b"<svg" in head


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the drawing, in its order."""
    where = path_name(path)
    root = load_xml(path)
    if tag(root) != "svg":
        raise InputError(f"{where}: <{tag(root)}> is no <svg>; give a drawing as plain SVG")
    drawing = Drawing(where)
    stated = root.get("data-scale")
    if stated is not None:
        try:
            drawing.unit = float(stated)
        except ValueError:
            drawing.unit = -1.0
        if not 0 < drawing.unit < 1e4:
            raise InputError(f"{where}: data-scale {show(stated)}: give metres for a unit, such as 0.01")
        drawing.said = f"a unit is {drawing.unit:g} m, by the drawing's data-scale"
    _walk(root, drawing)
    for room in rooms_of_drawing(drawing, options.scale):
        if options.room in (None, room.name):
            yield room


def _walk(root: Any, drawing: Drawing) -> None:
    """Fills a drawing with the elements of a tree, transforms applied, y turned upwards."""
    flip = np.diag((1.0, -1.0, 1.0))
    left: list[tuple[Any, np.ndarray, tuple[str, ...]]] = [(root, flip, ())]
    while left:
        element, above, words = left.pop()
        name = tag(element)
        if name in ("defs", "symbol", "clipPath", "mask", "style", "metadata", "title", "desc"):
            continue
        turn = above @ matrix_of(element.get("transform", ""), drawing.where)
        own = _words(element) if element is not root else ()
        inner = [child for child in element if isinstance(child.tag, str)]
        if name == "text":
            text = " ".join("".join(element.itertext()).split())
            at = turn @ (*(_number(element, key, drawing, 0.0) for key in ("x", "y")), 1.0)
            if text:
                drawing.texts.append(Label(text, (float(at[0]), float(at[1]))))
            continue
        if name in CALLED:
            called = element.get("id") or f"{name} {len(drawing.elements) + 1}"
            for points, closed in _shapes(element, name, called, (*own, *words), drawing):
                moved = points @ turn[:2, :2].T + turn[:2, 2]
                drawing.elements.append(Drawn(called, (*own, *words), moved, closed))
            continue
        if name == "use":
            drawing.notes.append(f"{element.get('id') or 'use'}: a copy by <use> is not read; draw it out")
            continue
        left.extend((child, turn, (*own, *words)) for child in reversed(inner))


def _words(element: Any) -> tuple[str, ...]:
    titles = [(child.text or "") for child in element if isinstance(child.tag, str) and tag(child) == "title"]
    return tuple(w for w in (*titles, *(element.get(key) or "" for key in WORDS)) if w.strip())


def _number(element: Any, key: str, drawing: Drawing, otherwise: float | None = None) -> float:
    text = element.get(key)
    if text is None and otherwise is not None:
        return otherwise
    found = NUMBER.match((text or "").strip())
    if not found or (text or "").strip()[found.end() :] not in ("", "px"):
        called = element.get("id") or tag(element)
        raise InputError(
            f"{drawing.where}: {called}: {key} is {show(text) if text else 'missing'}; give a number of units"
        )
    return float(found[0])


def _shapes(
    element: Any, name: str, called: str, words: tuple[str, ...], drawing: Drawing
) -> list[tuple[np.ndarray, bool]]:
    """Points [n, 2] of an element, and whether they are closed; a path may have several parts."""
    if name in ("circle", "ellipse"):
        if any(re.search(r"room|space", w.lower()) for w in words):
            raise InputError(f"{drawing.where}: {called}: a room has straight walls; draw a polygon, no {name}")
        return []
    if name == "rect":
        x, y = (_number(element, key, drawing, 0.0) for key in ("x", "y"))
        w, h = (_number(element, key, drawing) for key in ("width", "height"))
        if min(w, h) <= 0:
            raise InputError(f"{drawing.where}: {called}: width and height must be positive")
        return [(np.array([(x, y), (x + w, y), (x + w, y + h), (x, y + h)]), True)]
    if name == "line":
        ends = [_number(element, key, drawing, 0.0) for key in ("x1", "y1", "x2", "y2")]
        return [(np.array(ends).reshape(2, 2), False)]
    if name == "path":
        return _path(element.get("d") or "", called, drawing)
    text = element.get("points") or ""
    values = [float(v) for v in NUMBER.findall(text)]
    if re.sub(r"[\s,]", "", NUMBER.sub("", text)) or len(values) < 4 or len(values) % 2:
        raise InputError(f"{drawing.where}: {called}: points {show(text[:40])}: give x,y pairs")
    points = np.array(values).reshape(-1, 2)
    return [_closed(points, name == "polygon")]


def _closed(points: np.ndarray, closed: bool) -> tuple[np.ndarray, bool]:
    if len(points) > 3 and np.abs(points[0] - points[-1]).max() <= SAME * max(1.0, np.abs(points).max()):
        return points[:-1], True
    return points, closed and len(points) > 2


def _path(text: str, called: str, drawing: Drawing) -> list[tuple[np.ndarray, bool]]:
    """The parts of a path of straight lines; arcs and curves, as the swings of doors have them, end a part."""
    tokens = re.findall(r"[A-Za-z]|" + NUMBER.pattern, text)
    if re.sub(r"[\s,]", "", re.sub(r"[A-Za-z]|" + NUMBER.pattern, "", text)):
        raise InputError(f"{drawing.where}: {called}: d {show(text[:40])} is no path")
    found: list[tuple[np.ndarray, bool]] = []
    part: list[tuple[float, float]] = []
    at, command, k = (0.0, 0.0), "", 0
    counts = {"m": 2, "l": 2, "h": 1, "v": 1, "z": 0, "c": 6, "s": 4, "q": 4, "t": 2, "a": 7}

    def finish(closed: bool) -> None:
        if len(part) > 1:
            found.append(_closed(np.array(part), closed))
        part.clear()

    while k < len(tokens):
        if tokens[k].isalpha():
            command = tokens[k]
            k += 1
        kind = command.lower()
        if kind not in counts:
            raise InputError(f"{drawing.where}: {called}: d {show(text[:40])}: {show(command or tokens[k])} is no step")
        values = tokens[k : k + counts[kind]]
        if len(values) < counts[kind] or any(v.isalpha() for v in values):
            raise InputError(f"{drawing.where}: {called}: d {show(text[:40])}: {command} needs {counts[kind]} numbers")
        k += counts[kind]
        numbers = [float(v) for v in values]
        base = at if command.islower() else (0.0, 0.0)
        if kind == "z":
            start = part[0] if part else at
            finish(True)
            at, command = start, "" if k < len(tokens) and not tokens[k].isalpha() else command
            continue
        if kind == "h":
            at = (base[0] + numbers[0], at[1])
        elif kind == "v":
            at = (at[0], base[1] + numbers[0])
        else:
            at = (base[0] + numbers[-2], base[1] + numbers[-1])
        if kind == "m" or kind in "csqta":
            finish(False)
            command = {"m": "l", "M": "L"}.get(command, command)
        part.append(at)
    finish(False)
    return found


FORMAT = SourceFormat(
    name="svg",
    title="A drawing (SVG)",
    matches=matches,
    read=read,
    notes=(
        "Read: rect, polygon, closed polyline and path as rooms, line, polyline, path and thin shapes as doors and "
        "windows; transforms are applied, y is down. Without rooms, lines of walls that enclose rooms.",
        "Meaning: an element's title, label, class or id, else that of a group it is in: the word of a room, room, "
        "wall, door, window, entrance, passage, dimension. A text in a room without a word of its own names it.",
        "The scale is --scale (metres for a unit), a line named dimension with its length as its title or text, or "
        "data-scale of the svg element; without one the file is refused.",
        "Lost: curves (arcs that show how doors swing), copies by <use>, styles. Heights are assumed.",
    ),
    licence="the user's own",
    priority=-1,
)
