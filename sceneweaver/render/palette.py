"""Soft colours of the drawings: by stated colour or material where there is one, else by the kind of furniture."""

from __future__ import annotations

import re
import zlib
from typing import TYPE_CHECKING

from PIL import ImageColor

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

_FAMILIES: dict[str, tuple[Rgb, str]] = {
    "bed": ((188, 201, 217), "bed mattress crib cot bunk daybed futon pillow blanket headboard"),
    "seat": ((224, 188, 160), "chair stool bench seat recliner highchair chaise"),
    "sofa": ((186, 199, 173), "sofa couch loveseat armchair ottoman pouf beanbag sectional settee"),
    "table": ((229, 206, 168), "table desk counter island workbench bar lectern podium"),
    "storage": (
        (207, 192, 175),
        "wardrobe closet dresser nightstand cabinet sideboard bookcase bookshelf shelf shelves rack drawer drawers "
        "chest cupboard stand locker console credenza hutch trolley cart safe box bin basket",
    ),
    "plant": ((164, 190, 146), "plant tree flower flowers cactus fern planter bush"),
    "light": ((243, 223, 160), "lamp light chandelier pendant sconce candle lantern"),
    "screen": (
        (163, 174, 186),
        "tv television monitor laptop computer screen printer speaker phone projector keyboard",
    ),
    "ware": (
        (227, 233, 235),
        "toilet sink basin bathtub bath shower bidet washer washing dryer fridge refrigerator"
        " freezer stove oven dishwasher microwave hob cooker machine mug cup plate bowl",
    ),
    "decor": (
        (219, 180, 172),
        "vase picture painting mirror clock frame art sculpture statue poster photo curtain book"
        " books stack globe candleholder",
    ),
    "rug": ((226, 216, 222), "rug carpet mat doormat"),
    "sport": ((168, 190, 190), "treadmill bike bicycle dumbbell dumbbells weights rower elliptical punching gym"),
}
_OTHERS: tuple[Rgb, ...] = (
    (200, 190, 212),
    (190, 207, 205),
    (222, 198, 188),
    (206, 208, 180),
    (192, 200, 216),
    (218, 196, 206),
)
_FAMILY_OF = {word: family for family, (_, words) in _FAMILIES.items() for word in words.split()}

_MATERIALS: dict[str, Rgb] = {
    "oak": (222, 192, 148),
    "ash": (228, 208, 174),
    "birch": (236, 218, 184),
    "beech": (230, 200, 162),
    "pine": (234, 206, 156),
    "maple": (232, 208, 172),
    "teak": (200, 158, 112),
    "walnut": (166, 128, 98),
    "mahogany": (158, 104, 84),
    "cherry": (188, 126, 98),
    "wood": (220, 190, 150),
    "wooden": (220, 190, 150),
    "bamboo": (226, 210, 160),
    "rattan": (222, 196, 150),
    "wicker": (218, 192, 148),
    "cork": (210, 172, 128),
    "metal": (178, 184, 190),
    "steel": (182, 189, 196),
    "chrome": (200, 206, 211),
    "iron": (122, 124, 128),
    "aluminium": (196, 202, 207),
    "brass": (216, 188, 112),
    "copper": (206, 148, 116),
    "gold": (222, 194, 116),
    "glass": (206, 226, 232),
    "mirror": (210, 226, 233),
    "marble": (234, 232, 228),
    "stone": (204, 200, 192),
    "granite": (170, 168, 166),
    "concrete": (196, 194, 190),
    "ceramic": (232, 230, 224),
    "porcelain": (238, 240, 240),
    "terracotta": (208, 142, 112),
    "leather": (176, 128, 98),
    "linen": (228, 220, 202),
    "cotton": (232, 226, 214),
    "wool": (222, 212, 198),
    "jute": (212, 190, 148),
    "charcoal": (98, 98, 102),
    "cream": (243, 234, 212),
    "sage": (178, 194, 164),
    "mustard": (220, 184, 98),
    "rose": (220, 176, 176),
    "sand": (226, 208, 176),
    "blush": (230, 198, 192),
    "denim": (124, 148, 178),
    "natural": (226, 206, 170),
    "off-white": (240, 236, 226),
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
        family = _FAMILY_OF.get(word) or _FAMILY_OF.get(word.removesuffix("s"))
        if family is not None:
            base = _FAMILIES[family][0]
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
