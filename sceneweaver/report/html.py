"""Text made safe for HTML, JSON and style; pictures as data addresses."""

from __future__ import annotations

import base64
import html
import io
import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from PIL.Image import Image

_UNSAFE = {"<": "\\u003c", ">": "\\u003e", "&": "\\u0026", "\u2028": "\\u2028", "\u2029": "\\u2029"}


def clean(value: object) -> object:
    """Text in which characters that HTML does not know are spaces; text that is HTML already stays as it is."""
    if hasattr(value, "__html__"):
        return value
    text = "".join(c if c in "\n\t" or c.isprintable() or c == " " else " " for c in str(value))
    return text.encode("utf-8", "replace").decode()


def esc(value: object) -> str:
    """Text for HTML, in elements and in quoted attributes; characters that HTML does not know become spaces."""
    return html.escape(str(clean(value)), quote=True)


def counted(many: int, what: str) -> str:
    """A number of things: "1 picture", "2 pictures"."""
    return f"{many} {what}" + ("" if many == 1 else "s")


def json_block(element_id: str, data: Any) -> str:
    """A script element that holds JSON and can neither run nor be left by what stands in it."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False, ensure_ascii=True)
    for char, code in _UNSAFE.items():
        text = text.replace(char, code)
    return f'<script type="application/json" id="{esc(element_id)}">{text}</script>'


def picture_url(picture: Image, width: int, quality: int = 86) -> str:
    """A picture as a data address: JPEG on white, at most ``width`` pixels wide."""
    from PIL import Image as Images

    if picture.mode in ("RGBA", "LA", "P"):
        layer = picture.convert("RGBA")
        ground = Images.new("RGBA", layer.size, (255, 255, 255, 255))
        picture = Images.alpha_composite(ground, layer)
    picture = picture.convert("RGB")
    if picture.width > width:
        size = (width, max(1, round(picture.height * width / picture.width)))
        picture = picture.resize(size, Images.Resampling.LANCZOS)
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=quality, optimize=True, progressive=True)
    return "data:image/jpeg;base64," + base64.b64encode(file.getvalue()).decode()


def number(value: object, digits: int = 2) -> str:
    """A number for reading; a dash for what is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return "\u2013"
    return str(value) if isinstance(value, int) else f"{value:.{digits}f}"
