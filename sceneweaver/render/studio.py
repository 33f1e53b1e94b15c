"""One asset on an endless pale floor, and contact sheets of many."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from PIL import Image, ImageDraw

from sceneweaver.assets.asset import Asset
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from .camera import Camera
from .canvas import font
from .instances import Instance
from .tracing import DirectLights, Quality, trace

VIEWS = {
    "corner": (-1.0, 0.62, -0.52),
    "front": (-1.0, 0.0, -0.12),
    "side": (0.0, 1.0, -0.12),
    "top": (0.0, 0.0, -1.0),
}

_PAPER = (0.875, 0.870, 0.860)  # light [linear] of floor and background alike: pale, but white furniture stands out


def portrait(
    asset: Asset, size: int = 240, view: str = "corner", quality: Quality | None = None, device: str = "cpu"
) -> Image.Image:
    """A square picture of one asset.

    Raises:
        InputError: for a view that is unknown.
    """
    if view not in VIEWS:
        raise InputError(f"view: '{view}' is unknown{suggest(view, VIEWS)}")
    low, high = asset.mesh.bounds
    reach = float(np.linalg.norm(high - low))
    lighting = DirectLights(reach=0.5 * reach, background=_PAPER)
    floor = _plane(30 * reach, asset.mount == "wall", low, asset.mount == "ceiling", high, lighting)
    instances = [Instance(asset.mesh, np.eye(4)), Instance(floor, np.eye(4))]
    camera = Camera.framing(low, high, VIEWS[view], fov=0.42, margin=1.12)
    drawn = trace(instances, camera, size, size, lights=lighting, quality=quality, device=device)
    return Image.fromarray(drawn.rgb)


def contact_sheet(
    rows: Iterable[tuple[str, Asset]], columns: int = 8, tile: int = 240, view: str = "corner", device: str = "cpu"
) -> Image.Image:
    """Portraits in a grid, each with its label below."""
    return grid_of([(label, portrait(asset, tile, view, device=device)) for label, asset in rows], columns, tile)


def grid_of(pictures: Sequence[tuple[str, Image.Image]], columns: int = 8, tile: int = 240) -> Image.Image:
    """Square pictures of ``tile`` pixels in a grid, each with its label below.

    Raises:
        InputError: there is none.
    """
    if not pictures:
        raise InputError("sheet: there is nothing to draw")
    columns = max(1, min(columns, len(pictures)))
    text = font(max(11, tile // 15))
    strip = tile // 8
    count = -(-len(pictures) // columns)
    sheet = Image.new("RGB", (columns * tile, count * (tile + strip)), (246, 245, 243))
    pen = ImageDraw.Draw(sheet)
    for k, (label, picture) in enumerate(pictures):
        x, y = (k % columns) * tile, (k // columns) * (tile + strip)
        sheet.paste(picture, (x, y))
        pen.text((x + tile / 2, y + tile + strip / 2), label, font=text, fill=(60, 58, 55), anchor="mm")
    return sheet


def _backdrop(normal: tuple[float, float, float], lighting: DirectLights) -> Material:
    """A matt finish that, facing along ``normal`` and unshaded, looks like the background: no horizon is seen."""
    sun = np.array(lighting.sun) / np.linalg.norm(lighting.sun)
    above = 0.5 + normal[2] / 3  # of the sky's colour, the rest is the ground's: the mean over what the plane faces
    light = np.array(lighting.sky) * above + np.array(lighting.ground) * (1 - above)
    light = light + np.array(lighting.sun_color) * max(0.0, float(sun @ normal))
    c = np.minimum(np.array(lighting.background) / light, 1.0)
    r, g, b = (float(v) for v in np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055))
    return Material("backdrop", (r, g, b), roughness=1.0)


def _plane(
    size: float, vertical: bool, low: Sequence[float], hung: bool, high: Sequence[float], lighting: DirectLights
) -> Mesh:
    """A floor under the asset, or a wall behind it; above a hanging one a ceiling would only be in the way."""
    if vertical:
        x = float(low[0]) - 1e-4
        corners = [(x, -size, -size), (x, size, -size), (x, size, size), (x, -size, size)]
    else:
        z = float(low[2]) - (0.6 * float(high[2] - low[2]) if hung else 1e-4)
        corners = [(-size, -size, z), (size, -size, z), (size, size, z), (-size, size, z)]
    return Mesh(
        np.array(corners),
        np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32),
        np.zeros(2, dtype=np.int32),
        np.zeros(2, dtype=np.int32),
        (_backdrop((1.0, 0.0, 0.0) if vertical else (0.0, 0.0, 1.0), lighting),),
    )
