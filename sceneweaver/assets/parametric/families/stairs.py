"""Stairs that are furniture: what winds around a post."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws

_RISE = 0.2
"""About how far one tread lies above another [m]."""


@draws("spiral_staircase", even="round")
def spiral_staircase(d: Drawing) -> None:
    """Treads like slices around a post, a baluster on each, a rail that winds up with them and a landing on top."""
    box = d.even("round")
    r, h = box.depth / 2, box.height
    metal = d.material("frame", "black steel, white steel, steel")
    wood = d.material("treads", "oak, walnut, black steel, light oak")
    guard, inner = 0.88, 0.05
    rise_to = h - guard
    count = max(6, round(rise_to / _RISE))
    step, turn = rise_to / count, math.radians(26)
    angle = 0.62 * turn
    with d.part("stair"):
        d.cylinder(Box.sized(2 * inner, 2 * inner, h), metal, segments=16)
        d.cylinder(Box.sized(0.36, 0.36, 0.02), metal, segments=20)
        for k in range(count - 1):
            with d.at(z=(k + 1) * step, yaw=k * turn):
                plan = [(inner - 0.01, -0.05), (inner - 0.01, 0.05)]
                plan += [(0.97 * r * math.cos(a), 0.97 * r * math.sin(a)) for a in (angle, 0.0, -angle)]
                d.hull([(x, y, z) for x, y in plan for z in (-0.04, 0.0)], wood)
                d.bar((0.94 * r, 0.0, 0.0), (0.94 * r, 0.0, guard), 0.009, metal, 6)
        turns = np.linspace(0.0, (count - 2) * turn, 4 * (count - 2) + 1)
        rail = np.c_[0.94 * r * np.cos(turns), 0.94 * r * np.sin(turns), step + guard + turns / turn * step - 0.02]
        d.sweep(rail, 0.02, metal, 8)
    with d.part("landing"), d.at(z=count * step, yaw=(count - 1) * turn):
        wide = 1.5 * turn
        arc = np.linspace(-0.6 * turn, wide, 6)
        plan = [(0.0, -0.05)] + [(0.97 * r * math.cos(a), 0.97 * r * math.sin(a)) for a in arc]
        d.hull([(x, y, z) for x, y in plan for z in (-0.05, 0.0)], wood)
    d.fit(box.size)
