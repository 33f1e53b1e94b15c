"""Palettes: what the walls, the floor and the furniture of a room are made of, chosen once for a room."""

from __future__ import annotations

import colorsys
import random
from collections.abc import Collection, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from sceneweaver.assets.materials import color_named, finishes, hue, shade
from sceneweaver.assets.scheme import allowed_color, is_avoided
from sceneweaver.scene.base import FrozenModel

from .load import data_of, room_types
from .looks import Look

FloorMaterial = Literal["wood", "tile", "carpet", "concrete", "stone"]
AccentKind = Literal["plain", "paint", "paper", "panelling"]

FALLBACK = "home"
"""Group of the rooms that stand in none."""

PALE = 0.72
"""Lightness (HLS) from which on a colour that a request names is painted on the walls; darker ones are accents."""

DARK = 0.25
"""Lightness below which metal in a room of one colour is black."""

HUES = 3
"""Colours of textiles in a room at most."""

_METALS = {"gold": "brass", "brass": "brass", "copper": "copper", "bronze": "bronze", "silver": "chrome"}


class Palette(FrozenModel):
    """The colours and materials of a room: names from ``assets/colors.yaml`` and ``assets/materials.yaml``."""

    name: str
    groups: tuple[str, ...] = Field(alias="for", description="Groups of rooms that it is for")
    styles: tuple[str, ...]
    walls: str = Field(description="Colour of the walls")
    accent: str = Field(description="Colour of the accent wall")
    floors: Mapping[FloorMaterial, str] = Field(description="Tone of the floor by its material: a wood, or a colour")
    woods: Annotated[tuple[str, ...], Field(min_length=1, max_length=2)]
    paints: Annotated[tuple[str, ...], Field(min_length=1, max_length=2)]
    metals: Annotated[tuple[str, ...], Field(min_length=1, max_length=2)]
    textiles: Annotated[tuple[str, ...], Field(min_length=1, max_length=HUES)]


@cache
def palettes() -> Mapping[str, Palette]:
    """All palettes by name."""
    return MappingProxyType({name: Palette(name=name, **row) for name, row in _data()["palettes"].items()})


@cache
def groups_of(room: str) -> tuple[str, ...]:
    """The groups of a kind of room, for which there are palettes."""
    known = room_types().get(room)
    if known is not None and known.palettes is not None:
        return (known.palettes,)
    return tuple(name for name, rooms in _data()["kinds"].items() if room in rooms) or (FALLBACK,)


def palette_for(
    room: str,
    style: str | None = None,
    colors: Sequence[str] = (),
    seed: int = 0,
    look: Look | None = None,
    avoid: Collection[str] = (),
) -> Palette:
    """The palette of a room.

    Args:
        room: the kind of room.
        style: its style; palettes of another one are used only where there is none of it.
        colors: colours that the request names for the room. They win: the palette that comes nearest is taken, pale
            ones are painted on the walls, others on the accent wall, and textiles have all of them.
        seed: draws among the palettes that suit.
        look: what the request says of the look of the room; it outranks all but ``colors``.
        avoid: basic colours, finishes and families of them that are not wanted.
    """
    known = palettes().values()
    groups = set(groups_of(room))
    fitting = [p for p in known if groups & set(p.groups)] or list(known)
    fitting = [p for p in fitting if style in p.styles] or fitting
    named = [_METALS.get(c, c) for c in colors if c in _METALS or _is_color(c)]
    metals = [c for c in named if c in _METALS.values()]
    wanted = [c for c in named if c not in metals]
    if wanted:
        basics = {color_named(c) for c in wanted}
        most = max(len(basics & _basics(p)) for p in fitting)
        fitting = [p for p in fitting if len(basics & _basics(p)) == most]
    if avoid:
        least = min(len(_basics(p) & {*avoid}) for p in fitting)
        fitting = [p for p in fitting if len(_basics(p) & {*avoid}) == least]
    chosen = random.Random(f"palette {room} {seed}").choice(fitting)
    return without(_with(chosen if look is None else dressed(chosen, look), wanted, metals), avoid)


def without(palette: Palette, avoid: Collection[str]) -> Palette:
    """The palette with calm colours in the place of those that are not wanted, and other woods for such woods."""
    if not avoid:
        return palette
    floors = {
        of: tone if is_allowed(tone, avoid) else _floor_instead(tone, avoid) for of, tone in palette.floors.items()
    }
    paints = (paint.removesuffix(" paint") for paint in palette.paints)
    return palette.model_copy(
        update={
            "walls": allowed_color(palette.walls, avoid),
            "accent": allowed_color(palette.accent, avoid),
            "floors": floors,
            "paints": tuple(dict.fromkeys(f"{allowed_color(color, avoid)} paint" for color in paints)),
            "textiles": tuple(dict.fromkeys(allowed_color(color, avoid) for color in palette.textiles)),
        }
    )


def is_allowed(name: str, avoid: Collection[str]) -> bool:
    """Whether a colour, or a finish by its name, is none of what is not wanted."""
    known = finishes().get(name)
    if known is not None and (known.family == "wood" or not _is_color(name)):
        return not is_avoided(known, avoid)
    return color_named(name) not in avoid


def _floor_instead(tone: str, avoid: Collection[str]) -> str:
    """Another tone of a floor: a wood for a wood, a calm colour for a colour."""
    known = finishes().get(tone)
    if known is None or known.family != "wood":
        return allowed_color(tone, avoid)
    free = (name for name, one in finishes().items() if one.family == "wood" and not is_avoided(one, avoid))
    return next(free, tone)


def dressed(palette: Palette, look: Look) -> Palette:
    """The palette as a look has it, as far as that says anything."""
    update: dict[str, object] = {
        key: value for key in ("woods", "paints", "metals", "textiles") if (value := getattr(look, key))
    }
    if look.walls is not None and look.walls.color is not None:
        update["walls"] = look.walls.color
    if look.accent is not None:
        update["accent"] = look.accent.color
    if look.floors:
        update["floors"] = {**palette.floors, **look.floors}
    if look.floor is not None and look.floor.tone is not None:
        update["floors"] = {**palette.floors, look.floor.material: look.floor.tone}
    return palette.model_copy(update=update)


def in_colors(palette: Palette, colors: Sequence[str]) -> Palette:
    """The palette of a room in which everything is of one colour, or of two."""
    first, last = colors[0], colors[-1]
    light = sum(shade(first)) / 3
    metal = "white steel" if light > PALE else "black steel" if light < DARK else "brushed steel"
    paints = tuple(dict.fromkeys(f"{color} paint" for color in colors[:2]))
    update: dict[str, object] = {
        "walls": first,
        "accent": last,
        "floors": dict.fromkeys(palette.floors, first),
        "woods": paints,
        "paints": paints,
        "metals": (metal,),
        "textiles": tuple(colors[:HUES]),
    }
    return palette.model_copy(update=update)


def unnamed(colors: Sequence[str]) -> tuple[str, ...]:
    """The finishes that would fight with a scheme of several colours which a request names; none for one colour."""
    if len(colors) < 2:
        return ()
    named = {color_named(c) for c in colors if _is_color(c)}
    rows: Mapping[str, Sequence[str]] = _data()["fighting"]
    return tuple(name for color, names in rows.items() if color not in named for name in names)


def accent_for(room: str, seed: int) -> AccentKind:
    """How the accent wall of a room is done; "plain" where there is none."""
    shares = _data()["accents"].get(groups_of(room)[0]) or {"plain": 1}
    return _drawn(shares, f"accent {room} {seed}")


def floor_for(room: str, usual: FloorMaterial, seed: int) -> FloorMaterial:
    """What the floor of a room is of; ``usual`` where nothing else is known of such rooms."""
    return _drawn(_data()["floors"].get(room) or {usual: 1}, f"floor {room} {seed}")


def _with(palette: Palette, colors: Sequence[str], metals: Sequence[str]) -> Palette:
    """The palette with colours and metals that were named."""
    update: dict[str, object] = {}
    pale = [c for c in colors if colorsys.rgb_to_hls(*shade(c))[1] >= PALE]
    strong = [c for c in colors if c not in pale]
    if pale:
        update["walls"] = pale[0]
    if strong:
        update["accent"] = strong[0]
    if len(colors) + len(metals) > 1:  # a scheme: walls and painted furniture are of it as well
        update["walls"] = (pale or strong or [palette.walls])[0]
        update["paints"] = tuple(f"{color} paint" for color in (*pale, *strong)[:2]) or palette.paints
    if colors:
        own = [t for t in palette.textiles if color_named(t) not in {color_named(c) for c in colors}]
        own = [t for t in own if hue(color_named(t)) is None]  # a hue that nobody named would fight with those
        update["textiles"] = tuple([*dict.fromkeys(colors), *own][: max(HUES, len(colors))])
    if metals:
        update["metals"] = tuple(dict.fromkeys(metals))[:2]
    return palette.model_copy(update=update)


def _basics(palette: Palette) -> set[str]:
    """The basic colours of a palette."""
    own = (palette.walls, palette.accent, *palette.textiles)
    return {color_named(c) for c in own} | {color_named(p.removesuffix(" paint")) for p in palette.paints}


def _is_color(name: str) -> bool:
    try:
        return bool(color_named(name))
    except ValueError:
        return False


def _drawn(shares: Mapping, seed: str):
    names = list(shares)
    return random.Random(seed).choices(names, [shares[name] for name in names])[0]


def _data() -> Mapping:
    return data_of("palettes.yaml")
