"""What readers of SVG share: numbers, transforms, tags."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import show

from .values import LARGEST

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
"""A number of an attribute."""

_CALL = re.compile(r"(matrix|translate|scale|rotate)\s*\(([^()]*)\)")


def tag(element: Any) -> str:
    """The name of an element without its namespace."""
    return str(element.tag).rpartition("}")[2]


def matrix_of(text: str, where: str) -> np.ndarray:
    """The matrix [3, 3] of a transform attribute; InputError for what is none."""
    found = np.eye(3)
    if not text.strip():
        return found
    if re.sub(r"[\s,]", "", _CALL.sub("", text)):
        raise InputError(f"{where}: transform {show(text[:40])} is not read; use matrix, translate, scale or rotate")
    for name, inside in _CALL.findall(text):
        v = [float(n) for n in NUMBER.findall(inside)]
        counts = {"matrix": (6,), "translate": (1, 2), "scale": (1, 2), "rotate": (1, 3)}[name]
        if v and not max(map(abs, v)) <= LARGEST:
            raise InputError(f"{where}: transform {show(text[:40])}: too large for a plan")
        if len(v) not in counts:
            raise InputError(f"{where}: transform {show(text[:40])}: {name} has {len(v)} numbers")
        step = np.eye(3)
        if name == "matrix":
            step[:2] = np.array(v).reshape(3, 2).T
        elif name == "translate":
            step[:2, 2] = v[0], v[1] if len(v) > 1 else 0.0
        elif name == "scale":
            step[0, 0], step[1, 1] = v[0], v[-1]
        else:
            c, s = np.cos(np.radians(v[0])), np.sin(np.radians(v[0]))
            step[:2, :2] = [[c, -s], [s, c]]
            if len(v) == 3:
                step[:2, 2] = np.array(v[1:]) - step[:2, :2] @ np.array(v[1:])
        found = found @ step
    return found
