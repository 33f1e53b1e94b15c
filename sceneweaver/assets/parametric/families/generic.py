"""The body of what is not known."""

from __future__ import annotations

from ..builder import Builder
from ..registry import draws


@draws("object")
def generic(b: Builder) -> None:
    """A plain block with cut edges and a band around it, so that nobody takes it for furniture."""
    d, w, h = b.size
    body = b.material("body", "cardboard", "light grey paint", "beige fabric")
    t = min(0.002, 0.1 * min(d, w))
    with b.solid("all"):
        b.box((-d / 2 + t, d / 2 - t), (-w / 2 + t, w / 2 - t), (0.0, h), body, bevel=0.04 * min(b.size))
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.42 * h, 0.58 * h), "grey plastic", bevel=0.0)
    b.surface("top", (-0.4 * d, 0.4 * d), (-0.4 * w, 0.4 * w), h)
