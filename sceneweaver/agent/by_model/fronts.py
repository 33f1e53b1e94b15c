"""The front of an asset by a model that looks at it from its four sides."""

from __future__ import annotations

import hashlib
import itertools
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from pydantic import Field

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Mesh
from sceneweaver.io.messages import clean, printable_line, shorten
from sceneweaver.llm import ModelClient, ModelFailed, Picture, Reply

from .pictures import packed
from .scene_text import NAME, compact, prompt

PURPOSE = "front"
SURE = 0.6
"""Confidence from which on the model is believed."""

LABELS = ("A", "B", "C", "D")

SIZE = 320
"""Width and height [pixels] of each picture."""

REASON = 200


class SeenFront(Reply):
    """Which picture shows the front."""

    reason: str = ""
    label: Literal["A", "B", "C", "D", "none"]
    confidence: float = Field(ge=0, le=1)


@dataclass(frozen=True)
class Front:
    """Where the front of an asset is.

    Attributes:
        quarters: quarter turns counter-clockwise from the asset's own +x, 0 to 3.
        confidence: how sure it is, 0 to 1.
        by: name of the model, or "shape" where that is not sure and the front stays where the import found it.
        reason: what the model said.
    """

    quarters: int
    confidence: float
    by: str
    reason: str = ""


def front_by_views(client: ModelClient, asset: Asset, *, device: str = "cpu") -> Front:
    """Ask a model which of four pictures shows the front.

    The letters go round the asset in an order that depends on its shape alone, so that one that always says A does not
    confirm what is there. Where the model sees no front or is less than `SURE`, the offline answer stays.

    Raises:
        ModelError: when there is no answer, or the model takes no pictures.
    """
    if not client.pictures:
        raise ModelFailed(f"{PURPOSE}: the model takes no pictures")
    order = order_of(asset)
    views = side_views(asset, device=device)
    pictures = [Picture(views[side], f"side {label}") for label, side in zip(LABELS, order, strict=True)]
    thing = compact({"thing": shorten(clean(asset.category), NAME)})
    answer = client.ask(PURPOSE, SeenFront, prompt("fronts"), [thing, *pictures])
    reason = printable_line(answer.reason, REASON)
    if answer.label == "none" or answer.confidence < SURE:
        return Front(0, asset.origin.front_confidence, "shape", reason)
    return Front(order[LABELS.index(answer.label)], answer.confidence, client.name, reason)


def side_views(asset: Asset, *, device: str = "cpu") -> list[bytes]:
    """PNG files of the four sides, that of its frame's +x first, then counter-clockwise; all in the same light."""
    from sceneweaver.render import Quality
    from sceneweaver.render.studio import portrait

    found = []
    for quarters in range(4):
        side = replace(asset, mesh=turned(asset.mesh, -quarters), mount="floor")  # no wall may hide its back
        found.append(packed(portrait(side, SIZE, "front", Quality.draft(), device)))
    return found


def turned(mesh: Mesh, quarters: int) -> Mesh:
    """A mesh some quarter turns counter-clockwise about the z axis."""
    turn = np.linalg.matrix_power(np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), quarters % 4)
    return replace(mesh, vertices=mesh.vertices @ turn.T)


def order_of(asset: Asset) -> tuple[int, ...]:
    """Which side each of the four letters shows."""
    shape = np.round(asset.mesh.vertices, 4) + 0.0
    digest = hashlib.sha256(np.ascontiguousarray(shape, dtype="<f8").tobytes()).digest()
    return list(itertools.permutations(range(4)))[digest[0] % 24]
