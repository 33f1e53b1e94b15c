"""Elements of MJCF and URDF, with numbers as text of nine digits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from xml.etree.ElementTree import Element, SubElement


def child(parent: Element, tag: str, attributes: Mapping[str, Any] | None = None, /, **more: Any) -> Element:
    """A new element below another; its attributes are texts, numbers or vectors."""
    return SubElement(parent, tag, {name: text(value) for name, value in {**(attributes or {}), **more}.items()})


def text(value: Any) -> str:
    """A text as it is, a number with nine digits, a vector as numbers with blanks between."""
    if isinstance(value, str):
        return value
    if hasattr(value, "__len__"):
        return " ".join([f"{x:.9g}" if isinstance(x, (float, int)) else text(x) for x in value])
    return f"{float(value):.9g}"
