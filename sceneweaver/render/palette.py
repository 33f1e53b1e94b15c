"""Soft colours of the drawings: by stated colour or material where there is one, else by the kind of furniture."""

from __future__ import annotations

import re
import zlib
from typing import TYPE_CHECKING

from PIL import ImageColor

from sceneweaver.io import packaged

if TYPE_CHECKING:
    from sceneweaver.scene import SceneObject

Rgb = tuple[int, int, int]

PAPER: Rgb = (251, 249, 245)
FLOOR: Rgb = (243, 238, 229)
GRID: Rgb = (224, 215, 200)
WALL: Rgb = (66, 62, 58)
WALL_TEXT: Rgb = (190, 183, 174)
INK: Rgb = (45, 42, 39)
MUTED: Rgb = (134, 127, 118)
FAINT: Rgb = (196, 189, 179)
GLASS: Rgb = (205, 224, 236)
OPENING: Rgb = (104, 143, 176)
ZONE: Rgb = (186, 140, 84)
ALARM: Rgb = (208, 52, 48)
GOOD: Rgb = (58, 128, 84)

_WORDS = packaged.yaml_data(__package__ or "", "palette.yaml")
_OTHERS: list[Rgb] = [tuple(color) for color in _WORDS["others"]]
_MATERIALS: dict[str, Rgb] = {name: tuple(color) for name, color in _WORDS["materials"].items()}
_FAMILIES: dict[str, Rgb] = {
    word: tuple(family["color"]) for family in _WORDS["families"].values() for word in family["words"].split()
}


def fill_of(obj: SceneObject) -> Rgb:
    """The colour that an object is filled with."""
    for key in ("color", "colour", "material"):
        named = _named(obj.attributes.get(key))
        if named is not None:
            return named
    return category_color(obj.category)


def category_color(category: str) -> Rgb:
    """The colour of a category: that of its family, a shade lighter or darker to tell relatives apart."""
    words = words_of(category)
    number = zlib.crc32(" ".join(words).encode())
    for word in reversed(words):
        base = _FAMILIES.get(word) or _FAMILIES.get(word.removesuffix("s"))
        if base is not None:
            break
    else:
        base = _OTHERS[number % len(_OTHERS)]
    shade = ((number >> 8) % 9 - 4) / 4 * 0.07
    return lighter(base, shade) if shade > 0 else darker(base, -shade)


def words_of(category: str) -> list[str]:
    """Lower-case words of a category: ``coffee_table`` and ``Coffee Table`` give the same."""
    return [w for w in re.split(r"[^a-z0-9]+", category.lower()) if w]


def _named(value: object) -> Rgb | None:
    """The softened colour that a text such as ``"#8899aa"``, ``"light blue"`` or ``"walnut"`` names, if any."""
    if not isinstance(value, str) or not value.strip():
        return None
    text = value.strip().lower()
    for name in (text, text.replace(" ", "")):
        try:
            return _soft(ImageColor.getrgb(name)[:3])
        except ValueError:
            continue
    for word in (text, *reversed(re.split(r"[^a-z-]+", text))):
        if word in _MATERIALS:
            return _MATERIALS[word]
        try:
            return _soft(ImageColor.getrgb(word)[:3])
        except ValueError:
            continue
    return None


def _soft(color: tuple[int, ...]) -> Rgb:
    """A colour pulled toward the paper and away from full saturation, so that no object shouts."""
    grey = 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2]
    calm = tuple(grey + (c - grey) * 0.6 for c in color)
    r, g, b = (round(min(max(c * 0.66 + 0.34 * 238, 0), 244)) for c in calm)
    return (r, g, b)


def lighter(color: Rgb, share: float) -> Rgb:
    """Toward white by ``share`` in [0, 1]."""
    return mixed(color, (255, 255, 255), share)


def darker(color: Rgb, share: float) -> Rgb:
    """Toward a warm near-black by ``share`` in [0, 1]."""
    return mixed(color, (38, 30, 24), share)


def mixed(first: Rgb, second: Rgb, share: float) -> Rgb:
    """``first`` with ``share`` of ``second`` mixed in."""
    r, g, b = (round(a + (b - a) * share) for a, b in zip(first, second, strict=True))
    return (r, g, b)


def ink_on(color: Rgb) -> Rgb:
    """Text that reads well on a colour."""
    return INK if 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2] > 120 else PAPER
