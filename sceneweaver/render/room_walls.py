"""What is on walls beyond paint: stripes of paper, panels with rails, tiles with joints. Each is a few mm thick."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sceneweaver.assets.body import Material
from sceneweaver.geometry.shell import wall_pieces
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room

from .room_blocks import Builder, Range, wall_block
from .room_finish import Finishes

PANELS = 1.15
"""Height [m] of panelling."""

_STRIPE, _PAPER = 0.11, 0.001  # width of a stripe, thickness [m]
_BATTEN, _FIELD, _RAIL = 0.05, 0.42, 0.06  # widths [m] of battens and of the fields between them, height of the rail
_TILE = (0.3, 0.15)  # length and height [m]
_JOINT = 0.003

Rectangle = tuple[Range, Range]


def add_wall_finish(
    builder: Builder, room: Room, wall: Wall, look: Finishes, height: float, pixel: float = 0.0
) -> None:
    """Paper, panels and tiles of a wall up to a height [m] at which it may be cut.

    ``pixel`` is the size [m] of one on the floor: joints thinner than that are drawn wider and paler.
    """
    kind, band, accent = look.accented(wall.index), look.tiled(wall.index), look.looks.accent
    if kind == "paper" and accent is not None:
        _stripes(builder, room, wall, accent, height)
    elif kind == "panelling" and accent is not None:
        add_panels(builder, room, wall, accent, height)
    if band is not None and look.looks.tiles is not None:
        _tiles(builder, room, wall, look.looks.tiles, (band[0], min(band[1], height)), pixel)


def _solid(room: Room, wall: Wall, z: Range) -> Iterator[Rectangle]:
    """The rectangles of a wall that are no openings, between two heights [m]."""
    for along, high, opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height):
        low, top = max(high[0], z[0]), min(high[1], z[1])
        if opening is None and top - low > 1e-3:
            yield along, (low, top)


def _slab(builder: Builder, wall: Wall, along: Range, z: Range, thick: float, material: Material) -> None:
    if along[1] - along[0] > 1e-3 and z[1] - z[0] > 1e-3:
        builder.prism(wall_block(wall, along, (-thick, 0.0)), z, material)


def _stripes(builder: Builder, room: Room, wall: Wall, paper: Material, height: float) -> None:
    r, g, b = (0.72 * c + 0.28 * (1.0 if sum(paper.color) < 2.1 else 0.78) for c in paper.color)
    other = replace(paper, name=f"{paper.name} stripe", color=(r, g, b))
    for (a, b_), z in _solid(room, wall, (0.0, height)):
        for at in np.arange(np.ceil(a / _STRIPE), np.floor(b_ / _STRIPE) + 1):
            if int(at) % 2:
                continue
            span = (max(a, at * _STRIPE), min(b_, (at + 1) * _STRIPE))
            _slab(builder, wall, span, z, _PAPER, other)


def add_panels(builder: Builder, room: Room, wall: Wall, panel: Material, height: float) -> None:
    """Panelling up to `PANELS`, or a lower height [m]."""
    top = min(PANELS, height)
    for along, z in _solid(room, wall, (0.0, top)):
        _slab(builder, wall, along, z, 0.002, panel)
    count = max(1, round(wall.length / (_FIELD + _BATTEN)))
    step = (wall.length - _BATTEN) / count
    battens = [(k * step, k * step + _BATTEN) for k in range(count + 1)]
    for (a, b), z in _solid(room, wall, (0.0, top)):
        for low, high in battens:
            _slab(builder, wall, (max(a, low), min(b, high)), z, 0.009, panel)
    if height >= PANELS:
        for along, z in _solid(room, wall, (PANELS - _RAIL, PANELS)):
            _slab(builder, wall, along, z, 0.018, panel)


def _tiles(builder: Builder, room: Room, wall: Wall, tile: Material, band: Range, pixel: float) -> None:
    """Tiles in a bond over joints, cut at openings."""
    gap = max(_JOINT, min(0.9 * pixel, 0.015))
    r, g, b_ = (c * (1 - 0.3 * _JOINT / gap) for c in tile.color)
    joint = replace(tile, name="tile joint", color=(r, g, b_), roughness=0.9)
    length, tall = _TILE
    for (a, b), (low, high) in _solid(room, wall, band):
        _slab(builder, wall, (a, b), (low, high), 0.001, joint)
        for row in range(int((low - band[0]) // tall), int(np.ceil((high - band[0]) / tall))):
            z = (max(low, band[0] + row * tall), min(high, band[0] + (row + 1) * tall - gap))
            shift = length / 2 if row % 2 else 0.0
            for k in range(int((a + shift) // length), int(np.ceil((b + shift) / length))):
                start = k * length - shift
                _slab(builder, wall, (max(a, start), min(b, start + length - gap)), z, 0.003, tile)
