"""A model made of boxes alone: coarser than hulls, and quicker in a batch."""

from __future__ import annotations

from dataclasses import replace
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.io import parse_xml

from .model import Model
from .xml import text

FEW = 8
"""Boxes of a body that are left as they are."""

_OWN = ("name", "type", "mesh", "pos", "size", "mass")  # attributes of a geom that a box has anew

_HANDLE = ":handle:"  # in names of geoms
_WASTE = 0.02  # share of volume that the common box of two boxes of a body may add
_MOST_WASTE = 0.2  # the same, while the body has more than FEW boxes


def boxed(model: Model, most: int | None = None) -> Model:
    """The model with each collision hull replaced by a box of its volume, along the axes of its body.

    The box has the hull's lower and upper end, so that what stands level stands as before, and its middle; depth and
    width are those of the hull, smaller by one factor: the box around a round or slanted hull would be in the way of
    its neighbours (5 % of the things of a bedroom then move which stand still as hulls; so it is less than 1 %).
    Boxes of a body that fill their common box become that one: to 2 % of volume, and to 20 % while the body has more
    than ``FEW``, the fullest first; and any while a body that has a joint has more than ``most``. Handles stay boxes of
    their own. Masses stay; so do the room, joints and exclusions.
    """
    root = parse_xml(model.xml, "room")
    spans = {}
    for mesh in root.iterfind("asset/mesh"):
        points = np.array(mesh.get("vertex", "").split(), dtype=float).reshape(-1, 3)
        if len(points):
            spans[mesh.get("name")] = _like(points)
    for body in root.iter("body"):
        solid = [g for g in body.findall("geom") if g.get("class") != "room:visual"]
        hulls = [g for g in solid if g.get("mesh") in spans]
        few = most if _lead(body) else None
        if not hulls and (few is None or len(solid) <= few):
            continue
        boxes = [_span(g, spans) for g in solid]
        plain = all(b is not None for b in boxes) and len({g.get("friction") for g in solid}) == 1
        for geom in solid:
            body.remove(geom)
        if plain:
            found = [(*b, float(g.get("mass", 0))) for g, b in zip(solid, boxes, strict=True) if b is not None]
            held = [b for g, b in zip(solid, found, strict=True) if _HANDLE in g.get("name", "")]
            others = [b for g, b in zip(solid, found, strict=True) if _HANDLE not in g.get("name", "")]
            kept = [*_joined(others, few and max(few - len(held), 1)), *held]
            rest = {k: v for k, v in solid[0].attrib.items() if k not in _OWN}
            for k, (low, high, mass) in enumerate(kept):
                name = (
                    f"{body.get('name')}:part:{k}" if k < len(kept) - len(held) else f"{body.get('name')}{_HANDLE}{k}"
                )
                body.insert(k + _lead(body), _box(low, high, mass, {"name": name, **rest}))
            continue
        for geom, span in zip(solid, boxes, strict=True):  # a part that is no box of its body's axes stays as it is
            rest = {k: v for k, v in geom.attrib.items() if k == "name" or k not in _OWN}
            body.append(geom if span is None else _box(*span, float(geom.get("mass", 0)), rest))
    asset = root.find("asset")
    if asset is not None:
        used = {g.get("mesh") for g in root.iter("geom")}
        for mesh in [m for m in asset.findall("mesh") if m.get("name") in spans and m.get("name") not in used]:
            asset.remove(mesh)
    return replace(model, xml=Xml.tostring(root, encoding="unicode") + "\n")


def _like(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(low [3], high [3]) of the box that stands for the hull of these points [V, 3]."""
    from scipy.spatial import ConvexHull

    low, high = points.min(axis=0), points.max(axis=0)
    full = float(np.prod(high - low))
    share = min(1.0, float(ConvexHull(points).volume) / full) if full > 0 else 1.0
    middle, half = (low + high) / 2, (high - low) / 2 * [share**0.5, share**0.5, 1.0]
    return middle - half, middle + half


def _lead(body: Xml.Element) -> int:
    """Where geoms begin: after the joints."""
    return sum(child.tag in ("freejoint", "joint", "inertial") for child in body)


def _span(geom: Xml.Element, spans: dict[str | None, tuple[np.ndarray, np.ndarray]]):
    """(low [3], high [3]) of a geom along the axes of its body; None for what is neither a hull nor such a box."""
    if geom.get("quat") or geom.get("euler"):
        return None
    pos = np.array(geom.get("pos", "0 0 0").split(), dtype=float)
    if geom.get("mesh") in spans:
        low, high = spans[geom.get("mesh")]
        return low + pos, high + pos
    if geom.get("type") != "box":
        return None
    half = np.array(geom.get("size", "").split(), dtype=float)
    return pos - half, pos + half


def _joined(
    boxes: list[tuple[np.ndarray, np.ndarray, float]], most: int | None
) -> list[tuple[np.ndarray, np.ndarray, float]]:
    """Boxes (low, high, mass), those joined that fill their common box, the fullest pairs first; at most ``most``."""
    left = list(boxes)
    while len(left) > 1:
        low, high = np.array([b[0] for b in left]), np.array([b[1] for b in left])
        volume = np.prod(high - low, axis=1)
        both = np.prod(np.maximum(high[:, None], high) - np.minimum(low[:, None], low), axis=2)
        common = np.prod(np.maximum(np.minimum(high[:, None], high) - np.maximum(low[:, None], low), 0), axis=2)
        waste = both / np.maximum(volume[:, None] + volume - common, 1e-15) - 1
        waste[np.tril_indices(len(left))] = np.inf
        i, j = np.unravel_index(int(np.argmin(waste)), waste.shape)
        if waste[i, j] > (_WASTE if len(left) <= FEW else _MOST_WASTE) and (most is None or len(left) <= most):
            break
        joined = (np.minimum(low[i], low[j]), np.maximum(high[i], high[j]), left[i][2] + left[j][2])
        left = [b for k, b in enumerate(left) if k not in (i, j)] + [joined]
    return left


def _box(low: np.ndarray, high: np.ndarray, mass: float, rest: dict[str, str]) -> Xml.Element:
    pos, half = (low + high) / 2, np.maximum((high - low) / 2, 5e-5)
    return Xml.Element("geom", {"type": "box", "pos": text(pos), "size": text(half), "mass": text(mass), **rest})
