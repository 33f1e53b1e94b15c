"""Named finishes, and colours by name."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from importlib import resources

import numpy as np

from sceneweaver.scene import InputError

from .body import Material

STYLES = ("modern", "scandinavian", "industrial", "classic", "rustic")

_COLORS = {
    "white": "#f2f0ec",
    "cream": "#ece2cf",
    "beige": "#d5c7ae",
    "tan": "#b88a5c",
    "brown": "#7a5236",
    "dark brown": "#402b20",
    "black": "#222224",
    "grey": "#8d9093",
    "light grey": "#c9ccce",
    "silver": "#c4c6c9",
    "gold": "#c8a24f",
    "red": "#b5382f",
    "burgundy": "#6f2430",
    "orange": "#e07f38",
    "yellow": "#e6bd45",
    "mustard": "#cf9f3f",
    "green": "#58885a",
    "dark green": "#2f5a3b",
    "sage": "#9fb09a",
    "teal": "#3f7d80",
    "blue": "#4a78b0",
    "light blue": "#a3c1da",
    "navy": "#2c3e5c",
    "purple": "#7a5a94",
    "pink": "#d79aa6",
}

_ALIASES = {
    "gray": "grey",
    "light gray": "light grey",
    "wood": "brown",
    "wooden": "brown",
    "navy blue": "navy",
    "dark blue": "navy",
    "violet": "purple",
    "ivory": "cream",
    "golden": "gold",
    "rose": "pink",
    "charcoal": "black",
    "turquoise": "teal",
    "olive": "sage",
    "maroon": "burgundy",
}


@dataclass(frozen=True)
class Finish:
    """A material of the palette with what a choice among materials needs to know."""

    material: Material
    family: str
    styles: tuple[str, ...]
    tints: bool


@cache
def palette() -> dict[str, Finish]:
    """All finishes by name, from ``materials.yaml``."""
    import yaml

    data = yaml.safe_load(resources.files(__package__ or "").joinpath("materials.yaml").read_text(encoding="utf-8"))
    found = {}
    for name, row in data["materials"].items():
        row = dict(row)
        family, styles = row.pop("family"), tuple(row.pop("styles", STYLES))
        material = Material(name=name, color=rgb(row.pop("color")), **row)
        found[name] = Finish(material, family, styles, family in data["tints"])
    return found


def finish(name: str) -> Finish:
    """A finish by name; KeyError when there is none."""
    return palette()[name]


def expand(names: tuple[str, ...]) -> list[Finish]:
    """Finishes of names, where "@wood" stands for all of that family."""
    found: list[Finish] = []
    for name in names:
        if name.startswith("@"):
            found += [f for f in palette().values() if f.family == name[1:]]
        else:
            found.append(finish(name))
    return found


def tinted(material: Material, color: str) -> Material:
    """The material in a named colour."""
    return replace(material, name=f"{color} {material.name.rpartition(' ')[2]}", color=rgb(_COLORS[color]))


def color_named(text: str) -> str:
    """The basic colour of a word ("gray" is "grey"); InputError when it is none."""
    word = " ".join(text.lower().split())
    word = _ALIASES.get(word, word)
    if word not in _COLORS:
        raise InputError(f"color: '{text}' is unknown; use one of {', '.join(_COLORS)}")
    return word


def color_words() -> tuple[str, ...]:
    """Every word that `color_named` knows, but for those that name a material."""
    return (*_COLORS, *(word for word in _ALIASES if word not in ("wood", "wooden")))


def color_name(color: tuple[float, float, float]) -> str:
    """The basic colour nearest to an sRGB colour, by distance in CIELAB."""
    names = list(_COLORS)
    table = _lab(np.array([rgb(_COLORS[name]) for name in names]))
    return names[int(np.argmin(np.linalg.norm(table - _lab(np.array([color])), axis=1)))]


def rgb(text: str) -> tuple[float, float, float]:
    """sRGB in 0..1 of "#rrggbb"."""
    r, g, b = (round(int(text[i : i + 2], 16) / 255, 4) for i in (1, 3, 5))
    return r, g, b


def _lab(color: np.ndarray) -> np.ndarray:
    """CIELAB (D65) of sRGB colours [N, 3]."""
    linear = np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
    xyz = linear @ np.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])
    xyz = xyz / np.array([0.9505, 1.0, 1.089])
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)
