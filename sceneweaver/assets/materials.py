"""Named finishes, and colours by name."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from sceneweaver.scene import InputError

from .body import Material
from .category import read_yaml
from .textures.patterns.two_colors import colors_of, mean_of, name_of

STYLES = ("modern", "scandinavian", "industrial", "classic", "rustic")


@dataclass(frozen=True)
class Finish:
    """A material with what a choice among materials needs to know."""

    material: Material
    family: str
    styles: tuple[str, ...]
    tints: bool
    asked: bool
    """Whether it is used only where a request names it."""


@cache
def finishes() -> dict[str, Finish]:
    """All finishes by name, from ``materials.yaml``."""
    data = _materials()
    found = {}
    for name, row in data["materials"].items():
        row = dict(row)
        family, styles, asked = row.pop("family"), tuple(row.pop("styles", STYLES)), row.pop("asked", False)
        color = rgb(row.pop("color"))
        if (second := row.pop("second", None)) is not None:
            row["texture"], color = _print(row["texture"], color, rgb(second))
        material = Material(name=name, color=color, **row)
        found[name] = Finish(material, family, styles, family in data["tints"], asked)
    return found


def finish(name: str) -> Finish:
    """A finish by name; KeyError when there is none."""
    return finishes()[name]


def paint(name: str) -> Finish:
    """A finish by name, or paint in any colour ("mint paint"); KeyError when there is none."""
    known = finishes().get(name)
    if known is not None or not name.endswith(" paint"):
        return finish(name)
    try:
        made = tinted(finish("white paint").material, name.removesuffix(" paint"))
    except InputError:
        raise KeyError(name) from None
    return replace(finish("white paint"), material=made)


def expand(names: tuple[str, ...]) -> list[Finish]:
    """Finishes of names, where "@wood" stands for all of that family but those that have to be asked for."""
    found: list[Finish] = []
    for name in names:
        if name.startswith("@"):
            found += [f for f in finishes().values() if f.family == name[1:] and not f.asked]
        else:
            found.append(finish(name))
    return found


@cache
def material_words() -> dict[str, tuple[str, ...]]:
    """Every word for a material with the finishes that it means, the closest first."""
    table: dict[str, tuple[str, ...]] = {name: (name,) for name in finishes()}
    for name, words in _materials()["words"].items():
        if name.startswith("@"):
            means = tuple(f.material.name for f in finishes().values() if f.family == name[1:])
        else:
            means = tuple(name.split("/"))
            means += tuple(n for n in finishes() if n not in means and len(means) == 1 and name in n.split())
        means = tuple(n for n in means if n in finishes())
        table.update(dict.fromkeys([*([] if name[0] == "@" or "/" in name else [name]), *words], means))
    return table


@cache
def print_words() -> tuple[str, ...]:
    """Every word for cloth with a print."""
    prints = {name for name, one in finishes().items() if colors_of(one.material.texture) is not None}
    return tuple(word for word, means in material_words().items() if means and means[0] in prints)


@cache
def finishes_named(text: str) -> tuple[Finish, ...]:
    """The finishes that some words mean, the closest first; none when they name no material."""
    words = _plain(text)
    table, worked = material_words(), set(_materials()["finishes"])
    if words not in table:
        words = " ".join(word for word in words.split() if word not in worked)
    if words not in table and words.endswith("s"):
        words = words[:-1]
    return tuple(finish(name) for name in table.get(words, ()))


@cache
def alike(family: str) -> frozenset[str]:
    """The families that may take the place of one: what is hard for what is hard, what is soft for what is soft."""
    return frozenset(name for row in _materials()["alike"] if family in row["of"] for name in row["take"])


def tinted(material: Material, color: str) -> Material:
    """The material in a named colour; of a print it is the ground that has it."""
    name, made = f"{color} {material.name.rpartition(' ')[2]}", shade(color)
    if (said := colors_of(material.texture)) is None:
        return replace(material, name=name, color=made)
    kind, _, second = said
    if color_name(second) == color_named(color):  # white stripes on white
        second = said[1]
    texture, mean = _print(kind, made, second)
    return replace(material, name=name, color=mean, texture=texture)


def _print(
    kind: str, first: tuple[float, float, float], second: tuple[float, float, float]
) -> tuple[str, tuple[float, float, float]]:
    """Texture and colour of a material that is printed in two colours, sRGB in 0..1."""
    return name_of(kind, first, second), mean_of(kind, first, second)


def color_named(text: str) -> str:
    """The basic colour of a word ("gray" and "charcoal" are "grey"); InputError when it is none."""
    return _shade(text)[0]


def shade(text: str) -> tuple[float, float, float]:
    """sRGB in 0..1 of a colour's name; InputError when it is none."""
    return _shade(text)[1]


@cache
def _shade(text: str) -> tuple[str, tuple[float, float, float]]:
    data = _colors()
    word = _plain(text).replace("gray", "grey").removesuffix(" colored").removesuffix(" coloured")
    if word in data["basic"]:
        return word, rgb(data["basic"][word])
    if word in data["colors"]:
        basic, value = data["colors"][word]
        return basic, rgb(value)
    if word in data["aliases"]:
        return _shade(data["aliases"][word])
    first, _, rest = word.partition(" ")
    if first in data["shades"] and rest in (*data["basic"], *data["colors"], *data["aliases"]):
        basic, value = _shade(rest)
        by = data["shades"][first]
        r, g, b = (v + (1 - v) * by if by > 0 else v * (1 + by) for v in value)
        return basic, (r, g, b)
    raise InputError(f"color: '{text}' is unknown; use one of {', '.join(data['basic'])}")


def color_words() -> tuple[str, ...]:
    """Every word that `color_named` knows, but for those that name a material."""
    data = _colors()
    grey = [word.replace("grey", "gray") for word in (*data["basic"], *data["colors"]) if "grey" in word]
    return (*data["basic"], *data["colors"], *grey, *(w for w in data["aliases"] if w not in ("wood", "wooden")))


@cache
def shaded_colors() -> tuple[str, ...]:
    """Hues of one word with a word for a shade before them: "pale pink"."""
    data = _colors()
    hues = [word for word in (*data["basic"], *data["colors"]) if " " not in word and hue(color_named(word))]
    shades = [word for word, by in data["shades"].items() if by and word != "off"]
    return tuple(f"{shade_} {word}" for shade_ in shades for word in hues)


@cache
def color_name(color: tuple[float, float, float]) -> str:
    """The basic colour nearest to an sRGB colour, by distance in CIELAB."""
    data = _colors()["basic"]
    names, table = list(data), _lab(np.array([rgb(value) for value in data.values()]))
    return names[int(np.argmin(np.linalg.norm(table - _lab(np.array([color])), axis=1)))]


@cache
def hue(color: str) -> str | None:
    """The hue of a basic colour, all its shades alike ("navy" is blue); None for a neutral one."""
    return next((name for name, shades in _colors()["hues"].items() if color in shades), None)


def shades_of(name: str) -> tuple[str, ...]:
    """The basic colours of a hue, as `hue` names it."""
    return tuple(_colors()["hues"][name])


def contents_of(category: str) -> str:
    """The finish of what is in a vessel of a category."""
    rows: dict[str, list[str]] = _materials()["contents"]
    return next((name for name, of in rows.items() if category in of), "amber glass")


@cache
def own_look() -> frozenset[str]:
    """The categories whose colours are their own in any room."""
    return frozenset(_materials()["own_look"])


@cache
def _materials() -> dict[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("materials.yaml"))


@cache
def _colors() -> dict[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("colors.yaml"))


def _plain(text: str) -> str:
    return " ".join(text.lower().replace("-", " ").replace("_", " ").split())


def rgb(text: str) -> tuple[float, float, float]:
    """sRGB in 0..1 of "#rrggbb"."""
    r, g, b = (round(int(text[i : i + 2], 16) / 255, 4) for i in (1, 3, 5))
    return r, g, b


def reflectance(color: tuple[float, float, float]) -> float:
    """The share of light that an sRGB colour in 0..1 reflects: its luminance Y (IEC 61966-2-1)."""
    return float(_xyz(np.array([color]))[0, 1])


def _xyz(color: np.ndarray) -> np.ndarray:
    """CIE XYZ (D65) of sRGB colours [N, 3]."""
    linear = np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
    return linear @ np.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])


def _lab(color: np.ndarray) -> np.ndarray:
    """CIELAB (D65) of sRGB colours [N, 3]."""
    xyz = _xyz(color) / np.array([0.9505, 1.0, 1.089])
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)
