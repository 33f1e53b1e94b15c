"""Whether the board of a window's sill goes through the cloth of a curtain, by the meshes as they are drawn."""

from __future__ import annotations

import math

import numpy as np

from benchmarks.designs import LIBRARY
from sceneweaver.assets.placed import scaled_asset
from sceneweaver.assets.roles import with_role
from sceneweaver.critic.survey import Survey
from sceneweaver.scene import Window
from sceneweaver.verify.solids import Body, Opening

SILL = (0.07, 0.04, 0.028)
"""How far the board of a sill stands out of the wall and beside its window, and how thick it is [m]."""

SLACK = 0.002
"""Depth [m] up to which cloth may lie in the board."""

LOWEST = 0.1
"""Height [m] of a sill from which on it has a board."""


def pierced(survey: Survey) -> tuple[list[Body], list[Body]]:
    """The curtains that a sill goes through, and all that hang at a window with a sill."""
    found, all_ = [], []
    for body in survey.of_kind(with_role("curtain")):
        windows = [w for w in survey.placed.windows if _at(body, w)]
        if windows:
            all_.append(body)
            found += [body] if any(_through(body, w) for w in windows) else []
    return found, all_


def _at(body: Body, opening: Opening) -> bool:
    window = opening.item
    assert isinstance(window, Window)
    along, depth = opening.wall.coordinates(body.centre)
    middle = window.offset + window.width / 2
    near = abs(depth) < 0.5 and abs(along - middle) < (window.width + body.size[1]) / 2
    return near and window.sill > LOWEST and body.z[0] < window.sill < body.z[1]


def _through(body: Body, opening: Opening) -> bool:
    """Whether some triangle of the curtain comes into the board."""
    window, wall = opening.item, opening.wall
    asset, scale = scaled_asset(0, body.item, LIBRARY.load)
    if asset is None:
        return False
    frame = body.item.pose.frame
    v = asset.mesh.vertices * scale
    cos, sin = math.cos(body.yaw), math.sin(body.yaw)
    x, y = frame.x + cos * v[:, 0] - sin * v[:, 1], frame.y + sin * v[:, 0] + cos * v[:, 1]
    start, (ax, ay), (nx, ny) = np.array(wall.point(0.0)), wall.along, wall.inward
    u, w = (x - start[0]) * ax + (y - start[1]) * ay, (x - start[0]) * nx + (y - start[1]) * ny
    z = v[:, 2] + body.z[0]
    out, beside, thick = SILL
    sill = float(getattr(window, "sill", 0.0))
    level = sill - thick / 2
    corners = asset.mesh.faces
    below, above = z[corners].min(axis=1) <= level, z[corners].max(axis=1) >= level
    rows = corners[below & above]
    for a, b in ((0, 1), (1, 2), (2, 0)):
        one, other = rows[:, a], rows[:, b]
        rise = z[other] - z[one]
        t = np.where(np.abs(rise) > 1e-9, (level - z[one]) / np.where(rise == 0.0, 1.0, rise), 0.5)
        cut = (t >= 0.0) & (t <= 1.0)
        at, deep = u[one] + t * (u[other] - u[one]), w[one] + t * (w[other] - w[one])
        ends = (window.offset - beside, window.offset + window.width + beside)
        if np.any(cut & (at > ends[0]) & (at < ends[1]) & (deep > 0.0) & (deep < out - SLACK)):
            return True
    return False
