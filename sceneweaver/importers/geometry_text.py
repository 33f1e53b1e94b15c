"""Shapes of shapely that are written as text or as data, read by a grammar of their own: nothing is evaluated."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from sceneweaver.io.messages import shorten

from .values import FARTHEST, Entry

_TOKEN = re.compile(r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?|[A-Za-z_][A-Za-z_0-9.]*|[()\[\],])")
_KNOWN = {"box": "box", "polygon": "Polygon", "linestring": "LineString"}
_DEPTH = 8
_MOST = 10000
"""Most characters of an expression, and most corners of a shape."""


class Shape(NamedTuple):
    """A polygon, closed, or a line through points [m]."""

    closed: bool
    points: tuple[tuple[float, float], ...]


def shape(entry: Entry) -> Shape:
    """The shape of ``"shapely.Polygon([(0, 0), ..])"`` or of ``{"operation": "shapely.box", "args": [..]}``.

    Raises:
        InputError: it is none of box, Polygon and LineString, or its numbers are not those of one.
    """
    if isinstance(entry.value, dict) and "shape" in entry.value:
        return shape(entry["shape"])
    if isinstance(entry.value, dict):
        name, args = entry["operation"].text(), entry["args"].value
        if not isinstance(args, list):
            raise entry["args"].error("must be a list of arguments")
    else:
        name, args = _call(entry)
    kind = _KNOWN.get(re.sub(r"^shapely\.(?:geometry\.)?", "", name).lower())
    if kind is None:
        raise entry.error(f"{shorten(name, 40)}: only shapely.box, Polygon and LineString are read")
    if kind == "box":
        x0, y0, x1, y1 = Entry(args, entry.file, entry.place).numbers(4)
        if not (x1 > x0 and y1 > y0):
            raise entry.error("a box needs min x, min y, max x, max y")
        return Shape(True, ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))
    if len(args) != 1:
        raise entry.error(f"{kind} needs one list of points")
    points = [p.numbers(2) for p in Entry(args[0], entry.file, entry.place).entries()]
    ring = tuple((x, y) for x, y in points)
    if kind == "LineString":
        if not 2 <= len(ring) <= _MOST:
            raise entry.error("a line needs at least 2 points")
        return Shape(False, ring)
    ring = ring[:-1] if ring and ring[0] == ring[-1] else ring
    if not 3 <= len(ring) <= _MOST:
        raise entry.error("a polygon needs at least 3 points")
    return Shape(True, ring)


def _call(entry: Entry) -> tuple[str, list[Any]]:
    """Name and arguments of ``name(arguments)``: numbers and lists of such, in brackets or parentheses."""
    text = entry.text()
    if len(text) > 20 * _MOST:
        raise entry.error("an expression of over 200 kB; simplify the shape")
    tokens, at = [], 0
    while at < len(text.rstrip()):
        match = _TOKEN.match(text, at)
        if match is None:
            raise entry.error(f"cannot read {text[at : at + 20]!r}; write such as shapely.box(0, 0, 5, 4)")
        tokens.append(match[1])
        at = match.end()
    if len(tokens) < 3 or not tokens[0][0].isalpha() or tokens[1] != "(":
        raise entry.error(f"{shorten(text, 40)!r} is no call such as shapely.box(0, 0, 5, 4)")
    args, end = _list(entry, tokens, 2, ")", 0)
    if end != len(tokens):
        raise entry.error(f"text after the closing parenthesis: {shorten(' '.join(tokens[end:]), 40)!r}")
    return tokens[0], args


def _list(entry: Entry, tokens: list[str], at: int, close: str, depth: int) -> tuple[list[Any], int]:
    """Values up to a closing bracket, with the place after it."""
    if depth > _DEPTH:
        raise entry.error("brackets nested too deep")
    values: list[Any] = []
    while at < len(tokens) and tokens[at] != close:
        token = tokens[at]
        if token in "([":
            value, at = _list(entry, tokens, at + 1, ")" if token == "(" else "]", depth + 1)
        elif token[0].isdigit() or token[0] in "+-.":
            value, at = float(token), at + 1
            if abs(value) > FARTHEST:
                raise entry.error(f"{token} lies beyond {FARTHEST:g} m")
        else:
            raise entry.error(f"{shorten(token, 40)!r} stands where a number has to; only numbers and lists are read")
        values.append(value)
        if at < len(tokens) and tokens[at] == ",":
            at += 1
        elif at < len(tokens) and tokens[at] != close:
            raise entry.error(f"a comma is missing before {shorten(tokens[at], 20)!r}")
    if at >= len(tokens):
        raise entry.error(f"{close!r} is missing; is the expression cut off?")
    return values, at + 1
