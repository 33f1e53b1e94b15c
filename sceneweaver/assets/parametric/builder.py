"""Drawings with intervals in place of boxes: until every family is written in the language of ``drawing``."""

# ruff: noqa: D101, D102, D103

from __future__ import annotations

from .. import shapes
from ..drawing import Box, Drawing
from ..drawing.box import Interval
from ..drawing.request import Request, Size

__all__ = ["Builder", "Interval", "Request", "Size", "span"]


def span(a, b):
    return (a, b) if a <= b else (b, a)


class Builder(Drawing):
    frame = Drawing.at
    solid = Drawing.part
    whole = Drawing.integer
    lathe = Drawing.revolve

    @property
    def _seed(self):
        return self.seed

    def box(self, x, *more, **named):
        if isinstance(x, Box):
            return super().box(x, *more, **named)
        y, z, *rest = more if len(more) > 1 else (more[0], named.pop("z"))
        return super().box(Box(x, y, z), *rest, **named)

    def frustum(self, low, high, z, material, segments=24, bevel=0.0):
        self.add(shapes.frustum(low, high, z, segments, bevel), material)

    def extrude(self, polygon, span, material, bevel=0.0, *, axis="z"):
        super().extrude(polygon, span, material, axis=axis, bevel=bevel)

    def ball(self, radii, *more, **named):
        if isinstance(radii, Box):
            return super().ball(radii, *more, **named)
        center, material, segments = (*more, *named.values(), 20)[:3]
        shape = shapes.ball(radii, center, segments)
        self.add(shape, material, None if segments <= 12 else [shapes.containing_hull(shape[0])])

    def cushion(self, x, *more, **named):
        if isinstance(x, Box):
            return super().cushion(x, *more, **named)
        y, z, *rest = more
        return super().cushion(Box(x, y, z), *rest, **named)

    def sheet(self, grid, thickness, material, cells=1):
        super().sheet(grid, thickness, material, (cells, 1) if isinstance(cells, int) else cells)

    def tube(self, path, radius, material, segments=10, closed=False):
        self.sweep(path, radius, material, segments, closed)

    def surface(self, name, x=None, y=None, z=0.0, headroom=None, polygon=None, **named):
        if isinstance(x, Box):
            return super().surface(name, x, y if headroom is None else headroom, polygon=polygon, **named)
        if polygon is not None:
            xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
            x, y = (min(xs), max(xs)), (min(ys), max(ys))
        return super().surface(name, Box(x, y, (z - 1.0, z)), headroom, polygon=polygon)

    def unsurface(self):
        return self.drawn.surfaces.pop()

    def resurface(self, surface, polygon):
        self.drawn.surfaces.append(surface.model_copy(update={"polygon": tuple(polygon)}))

    def clear(self, x, y=None, z=None):
        super().clear(x if isinstance(x, Box) else Box(x, y, z))
