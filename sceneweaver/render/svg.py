"""The drawing surface of plans as SVG: the same calls as a `Plan`, and a text that prints at scale."""

from __future__ import annotations

import html
import io
from collections.abc import Iterable, Sequence

from PIL import Image

from .canvas import Color, Point, Text, line_height
from .palette import PAPER
from .shapes import Plan, View

_FONT = "Aileron, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif"
_ANCHORS = {"l": "start", "m": "middle", "r": "end"}


class SvgPlan(Plan):
    """A plan that is written down instead of painted.

    Widths of lines and sizes of text are those of a `Plan` of as many pixels; ``view_box`` is that size. Text is above
    all shapes there, and is here.
    """

    def __init__(self, width: int, height: int, view: View, unit: float) -> None:
        super().__init__(1, 1, view, unit)  # the raster of the base class is not used
        self.width, self.height = width, height
        self._parts: list[str] = []
        self._last: list[str] = []

    def polygon(
        self, points: Sequence[Point], fill: Color | None = None, line: Color | None = None, width: float = 1.0
    ) -> None:
        """A filled polygon with an optional closed outline."""
        look = _fill(fill) + (self._stroke(line, width) if line is not None else "")
        self._parts.append(f'<polygon points="{_points(points)}"{look}/>')

    def line(self, points: Sequence[Point], color: Color, width: float = 1.0) -> None:
        """A polyline with round joints."""
        self._parts.append(f'<polyline points="{_points(points)}" fill="none"{self._stroke(color, width)}/>')

    def dashed(
        self,
        points: Sequence[Point],
        color: Color,
        width: float = 1.0,
        dash: tuple[float, float] = (6.0, 4.0),
        closed: bool = False,
    ) -> None:
        """A dashed polyline; the dashes run on around the corners."""
        run = [*points, points[0]] if closed else list(points)
        dashes = " ".join(_number(length * self.unit) for length in dash)
        self._parts.append(
            f'<polyline points="{_points(run)}" fill="none"{self._stroke(color, width)} stroke-dasharray="{dashes}"/>'
        )

    def shadow(
        self, shapes: Iterable[tuple[Sequence[Point], Point]], within: Sequence[Point], color: Color, blur: float
    ) -> None:
        """Nothing: a drawing of lines throws no shadows."""

    def pill(
        self, box: tuple[float, float, float, float], radius: float, fill: Color, line: Color | None = None
    ) -> None:
        """A rounded rectangle from (left, top) to (right, bottom)."""
        left, top, right, bottom = box
        place = f'x="{_number(left)}" y="{_number(top)}" width="{_number(right - left)}"'
        look = _fill(fill) + (self._stroke(line, 1.2) if line is not None else "")
        self._parts.append(f'<rect {place} height="{_number(bottom - top)}" rx="{_number(radius)}"{look}/>')

    def text(self, text: Text) -> None:
        """Lines of text; a halo lies under the letters."""
        x, y = text.at
        step = line_height(text.size)
        first = -step * (len(text.lines) - 1) / 2 + text.size * 0.355
        turn = f' transform="rotate(-90 {_number(x)} {_number(y)})"' if text.upright else ""
        anchor = "middle" if text.upright else _ANCHORS[text.anchor]
        bold = ' font-weight="700"' if text.bold else ""
        halo = ""
        if text.halo is not None and text.halo_width > 0:
            halo = f' stroke="{_hex(text.halo)}" stroke-width="{_number(2 * text.halo_width)}" paint-order="stroke"'
            halo += ' stroke-linejoin="round"'
        for row, line in enumerate(text.lines):
            place = f'x="{_number(x)}" y="{_number(y + first + row * step)}"'
            look = f'font-size="{text.size}" text-anchor="{anchor}"{bold}{_fill(text.color)}{halo}'
            self._last.append(f"<text {place} {look}{turn}>{_escaped(line)}</text>")

    def raw(self, markup: str) -> None:
        """Markup above everything, such as links over rooms."""
        self._last.append(markup)

    def finish(self) -> Image.Image:
        """The base class's picture; a written plan has none: see `document`."""
        raise NotImplementedError("a written plan is no picture; use document()")

    def document(self, title: str, size: tuple[float, float] | None = None) -> str:
        """The whole SVG; ``size`` is that on paper [mm], so that it prints at scale."""
        out = io.StringIO()
        paper = f' width="{_number(size[0])}mm" height="{_number(size[1])}mm"' if size is not None else ""
        out.write(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}"{paper} role="img"'
            f' font-family="{_FONT}" stroke-linecap="round" stroke-linejoin="round"><title>{_escaped(title)}</title>\n'
        )
        out.write(f'<rect width="{self.width}" height="{self.height}"{_fill(PAPER)}/>\n')
        for part in (*self._parts, *self._last):
            out.write(part + "\n")
        out.write("</svg>\n")
        return out.getvalue()

    def _stroke(self, color: Color, width: float) -> str:
        opacity = f' stroke-opacity="{color[3] / 255:.3g}"' if len(color) == 4 and color[3] < 255 else ""
        return f' stroke="{_hex(color)}" stroke-width="{_number(max(0.5, width * self.unit))}"{opacity}'


def _points(points: Iterable[Point]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _hex(color: Color) -> str:
    return "#" + "".join(f"{int(c):02x}" for c in color[:3])


def _fill(color: Color | None) -> str:
    if color is None:
        return ' fill="none"'
    opacity = f' fill-opacity="{color[3] / 255:.3g}"' if len(color) == 4 and color[3] < 255 else ""
    return f' fill="{_hex(color)}"{opacity}'


def _escaped(text: str) -> str:
    """Text for an element; characters that XML does not know are spaces."""
    return html.escape("".join(c if c.isprintable() else " " for c in text))
