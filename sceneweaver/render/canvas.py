"""A small antialiased drawing surface: shapes are drawn enlarged and averaged down, text is drawn at its final size.

All coordinates are pixels of the final picture, x to the right and y downward; widths of lines, dashes and the spacing
of hatching are in units of the canvas, so that large pictures have bold lines.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

from PIL import Image, ImageChops, ImageDraw, ImageFilter, ImageFont

Point = tuple[float, float]
Color = tuple[int, int, int] | tuple[int, int, int, int]

SUPERSAMPLE = 2


@lru_cache(maxsize=64)
def font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """Pillow's own scalable font, so that a picture needs no font of the machine."""
    return ImageFont.load_default(max(size, 1))


@lru_cache(maxsize=4096)
def text_width(text: str, size: int) -> float:
    """Width of one line of text in pixels."""
    return font(size).getlength(text)


@dataclass(frozen=True)
class Text:
    """Lines of text centred at a point; ``upright`` text runs from bottom to top.

    ``anchor`` says what of a line stands at the point: its left end, middle or right end (upright text: its middle).
    """

    lines: tuple[str, ...]
    at: Point
    size: int
    color: Color
    halo: Color | None = None
    halo_width: int = 0
    upright: bool = False
    anchor: Literal["l", "m", "r"] = "m"
    bold: bool = False


class Canvas:
    """An RGB picture with filled shapes, lines, hatching, soft shadows and text."""

    def __init__(self, width: int, height: int, background: Color, unit: float = 1.0) -> None:
        self.width, self.height, self.unit = width, height, unit
        self._s = SUPERSAMPLE
        self._image = Image.new("RGB", (width * self._s, height * self._s), background[:3])
        self._draw = ImageDraw.Draw(self._image, "RGBA")
        self._texts: list[Text] = []

    # Shapes.

    def polygon(
        self, points: Sequence[Point], fill: Color | None = None, line: Color | None = None, width: float = 1.0
    ) -> None:
        """A filled polygon with an optional closed outline."""
        if fill is not None:
            self._draw.polygon(self._scaled(points), fill=fill)
        if line is not None:
            self.line([*points, points[0], points[1]], line, width)

    def line(self, points: Sequence[Point], color: Color, width: float = 1.0) -> None:
        """A polyline with round joints."""
        self._draw.line(self._scaled(points), fill=color, width=self._width(width), joint="curve")

    def dashed(
        self,
        points: Sequence[Point],
        color: Color,
        width: float = 1.0,
        dash: tuple[float, float] = (6.0, 4.0),
        closed: bool = False,
    ) -> None:
        """A dashed polyline; the dashes run on around the corners."""
        on, off = (self.unit * length for length in dash)
        run = [*points, points[0]] if closed else list(points)
        done = 0.0
        for (x0, y0), (x1, y1) in zip(run, run[1:], strict=False):
            length = math.hypot(x1 - x0, y1 - y0)
            if length < 1e-9:
                continue
            start = math.floor(done / (on + off)) * (on + off)
            while start < done + length:
                a, b = max(start - done, 0.0) / length, min(start + on - done, length) / length
                if b > a:
                    ends = ((x0 + (x1 - x0) * a, y0 + (y1 - y0) * a), (x0 + (x1 - x0) * b, y0 + (y1 - y0) * b))
                    self.line(ends, color, width)
                start += on + off
            done += length

    def hatch(
        self, points: Sequence[Point], color: Color, width: float = 1.0, spacing: float = 8.0, angle: float = 45.0
    ) -> None:
        """Parallel lines inside a polygon; equal angles line up across polygons."""
        spacing = spacing * self.unit
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        turned = [(x * c - y * s, x * s + y * c) for x, y in points]
        low, high = min(y for _, y in turned), max(y for _, y in turned)
        row = math.ceil(low / spacing)
        while row * spacing < high:
            y = row * spacing
            crossings = sorted(
                x0 + (y - y0) / (y1 - y0) * (x1 - x0)
                for (x0, y0), (x1, y1) in zip(turned, turned[1:] + turned[:1], strict=True)
                if (y0 <= y) != (y1 <= y)
            )
            for x0, x1 in zip(crossings[::2], crossings[1::2], strict=False):
                self.line(((x0 * c + y * s, y * c - x0 * s), (x1 * c + y * s, y * c - x1 * s)), color, width)
            row += 1

    def shadow(
        self, shapes: Iterable[tuple[Sequence[Point], Point]], within: Sequence[Point], color: Color, blur: float
    ) -> None:
        """A soft shadow of several polygons, each moved by its own offset, that falls only inside ``within``."""
        mask = Image.new("L", (self.width, self.height), 0)
        draw = ImageDraw.Draw(mask)
        for points, (dx, dy) in shapes:
            for share in (0.0, 0.5, 1.0):
                draw.polygon([(x + dx * share, y + dy * share) for x, y in points], fill=255)
        mask = mask.filter(ImageFilter.GaussianBlur(blur))
        strength = color[3] if len(color) == 4 else 255
        mask = mask.point([v * strength // 255 for v in range(256)]).resize(self._image.size, Image.Resampling.BILINEAR)
        floor = Image.new("L", self._image.size, 0)
        ImageDraw.Draw(floor).polygon(self._scaled(within), fill=255)
        self._image.paste(color[:3], mask=ImageChops.multiply(mask, floor))
        self._draw = ImageDraw.Draw(self._image, "RGBA")

    def outline(self, shapes: Sequence[Sequence[Point]], color: Color, width: float) -> None:
        """An outline just outside the union of several polygons, with a light wash of the colour inside."""
        box = self._box(shapes, margin=width * self.unit + 2)
        if box is None:
            return
        inside = self._mask(shapes, box)
        ring = ImageChops.subtract(self._mask(shapes, box, edge=self._width(width)), inside)
        self._image.paste(color[:3], box[:2], inside.point([v // 7 for v in range(256)]))
        self._image.paste(color[:3], box[:2], ring)
        self._draw = ImageDraw.Draw(self._image, "RGBA")

    def overlap(self, first: Sequence[Sequence[Point]], second: Sequence[Sequence[Point]], color: Color) -> None:
        """Fill what two sets of polygons share."""
        box = self._box([*first, *second], margin=1)
        if box is None:
            return
        shared = ImageChops.darker(self._mask(first, box), self._mask(second, box))
        self._image.paste(color[:3], box[:2], shared.point([v * 3 // 5 for v in range(256)]))
        self._draw = ImageDraw.Draw(self._image, "RGBA")

    def pill(
        self, box: tuple[float, float, float, float], radius: float, fill: Color, line: Color | None = None
    ) -> None:
        """A rounded rectangle from (left, top) to (right, bottom)."""
        scaled = tuple(v * self._s for v in box)
        self._draw.rounded_rectangle(
            scaled, radius * self._s, fill=fill, outline=line, width=max(1, round(1.2 * self._s))
        )

    def disc(self, at: Point, radius: float, fill: Color, line: Color | None = None) -> None:
        """A disc; with ``line``, in a ring of that colour."""
        for share, color in ((1.0, line), (0.84, fill)) if line is not None else ((1.0, fill),):
            r = share * radius
            if color is not None:
                self.pill((at[0] - r, at[1] - r, at[0] + r, at[1] + r), r, color)

    def leader(self, ends: tuple[Point, Point], color: Color, halo: Color, width: float) -> None:
        """A line from a label to a dot on what it names."""
        self.line(ends, halo, 3.0)
        self.line(ends, color, width)
        self.disc(ends[1], 2.6 * self.unit, color)

    # Text.

    def text(self, text: Text) -> None:
        """Add text; it is drawn above all shapes."""
        self._texts.append(text)

    def finish(self) -> Image.Image:
        """The picture at its final size."""
        image = self._image.reduce(self._s) if self._s > 1 else self._image.copy()
        draw = ImageDraw.Draw(image, "RGBA")
        for text in self._texts:
            if text.upright:
                _paste_upright(image, text)
            else:
                _write(draw, text, text.at)
        return image

    # Helpers.

    def _scaled(self, points: Sequence[Point]) -> list[Point]:
        s = self._s
        return [(x * s, y * s) for x, y in points]

    def _width(self, width: float) -> int:
        return max(1, round(width * self.unit * self._s))

    def font_size(self, units: float, least: int = 8) -> int:
        """The size of text [pixels], no smaller than can be read."""
        return max(least, round(units * self.unit))

    def _box(self, shapes: Sequence[Sequence[Point]], margin: float) -> tuple[int, int, int, int] | None:
        """Bounding box in enlarged pixels, cut to the picture; None when nothing is left."""
        points = [p for shape in shapes for p in shape]
        if not points:
            return None
        s = self._s
        left = max(0, math.floor((min(p[0] for p in points) - margin) * s))
        top = max(0, math.floor((min(p[1] for p in points) - margin) * s))
        right = min(self.width * s, math.ceil((max(p[0] for p in points) + margin) * s))
        bottom = min(self.height * s, math.ceil((max(p[1] for p in points) + margin) * s))
        return (left, top, right, bottom) if right > left and bottom > top else None

    def _mask(self, shapes: Sequence[Sequence[Point]], box: tuple[int, int, int, int], edge: int = 0) -> Image.Image:
        """The polygons within ``box`` as a mask, grown by ``edge`` enlarged pixels."""
        mask = Image.new("L", (box[2] - box[0], box[3] - box[1]), 0)
        draw = ImageDraw.Draw(mask)
        for shape in shapes:
            points = [(x * self._s - box[0], y * self._s - box[1]) for x, y in shape]
            draw.polygon(points, fill=255)
            if edge:
                draw.line([*points, points[0]], fill=255, width=2 * edge)
                for x, y in points:
                    draw.ellipse((x - edge, y - edge, x + edge, y + edge), fill=255)
        return mask


def line_height(size: int) -> float:
    """Distance between the baselines of two lines."""
    return size * 1.12


def _write(draw: ImageDraw.ImageDraw, text: Text, at: Point) -> None:
    """Draw horizontal text: first all halos, then all letters."""
    step = line_height(text.size)
    first = at[1] - step * (len(text.lines) - 1) / 2 + text.size * 0.355  # baseline that centres the capitals
    places = [(at[0], first + row * step) for row in range(len(text.lines))]
    face, anchor = font(text.size), text.anchor + "s"
    if text.halo is not None and text.halo_width > 0:
        for where, line in zip(places, text.lines, strict=True):
            draw.text(where, line, text.halo, face, anchor, stroke_width=text.halo_width, stroke_fill=text.halo)
    shifts = (0.0, max(1.0, text.size / 40)) if text.bold else (0.0,)
    for (x, y), line in zip(places, text.lines, strict=True):
        for shift in shifts:
            draw.text((x + shift, y), line, text.color, face, anchor)


def _paste_upright(image: Image.Image, text: Text) -> None:
    """Draw text that runs from bottom to top."""
    pad = text.halo_width + 3
    width = math.ceil(max(text_width(line, text.size) for line in text.lines)) + 2 * pad
    height = math.ceil(line_height(text.size) * len(text.lines)) + 2 * pad
    ground = text.halo if text.halo is not None else text.color
    layer = Image.new("RGBA", (width, height), (*ground[:3], 0))
    _write(ImageDraw.Draw(layer), replace(text, anchor="m"), (width / 2, height / 2))
    turned = layer.transpose(Image.Transpose.ROTATE_90)
    image.paste(turned, (round(text.at[0] - turned.width / 2), round(text.at[1] - turned.height / 2)), turned)
