"""The objective of a problem: terms in JSON, and their value in float64, which no engine has a part in."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.scene import InputError, Scene

Json = dict[str, Any]

KINDS = ("wire_length", "flow")
METRICS = ("euclidean", "manhattan")


@dataclass(frozen=True)
class Term:
    """A term of an objective, to be minimised.

    Attributes:
        kind: "wire_length" (half the perimeter of the box around the pins [m], of two or more things) or "flow" (the
            distance of two centres [m], with ``metric`` "euclidean" or "manhattan" among the ``params``).
        objects: ids of objects, and for wire lengths of doors and windows too.
        weight: what a metre counts.
        params: for wire lengths ``pins``, an offset [m] in the frame of each thing; centres unless said.

    Raises:
        InputError: a value that is none of these.
    """

    kind: str
    objects: tuple[str, ...]
    weight: float = 1.0
    params: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise InputError(f"objective: kind {self.kind!r} is none of {', '.join(KINDS)}")
        if len(self.objects) < 2 or (self.kind == "flow" and len(self.objects) != 2):
            raise InputError(f"objective: {self.kind} of {len(self.objects)} things; a flow has two, a net two or more")
        if not math.isfinite(self.weight):
            raise InputError(f"objective: weight {self.weight!r} is not a finite number")
        if self.kind == "flow" and self.params.get("metric", "euclidean") not in METRICS:
            raise InputError(f"objective: metric {self.params['metric']!r} is none of {', '.join(METRICS)}")
        pins = self.params.get("pins")
        if pins is not None and np.shape(pins) != (len(self.objects), 2):
            raise InputError(f"objective: pins of shape {np.shape(pins)}; give [dx, dy] for each of the objects")

    @classmethod
    def from_dict(cls, row: Json) -> Term:
        """From JSON, as in the files of problems."""
        try:
            return cls(row["kind"], tuple(row["objects"]), float(row.get("weight", 1.0)), row.get("params") or {})
        except (KeyError, TypeError, ValueError) as error:
            raise InputError(f"objective: {row!r} is no term ({error})") from None

    def to_dict(self) -> Json:
        """As JSON; params are left out where there are none."""
        row = {"kind": self.kind, "objects": list(self.objects), "weight": self.weight}
        return {**row, "params": dict(self.params)} if self.params else row


def value_of(scene: Scene, terms: Sequence[Term], poses: np.ndarray) -> np.ndarray:
    """The weighted sum of terms at poses [B, N, 4], as [B] float64.

    Raises:
        InputError: a term names what the scene has not.
    """
    poses = np.asarray(poses, dtype=np.float64)
    index = {name: k for k, name in enumerate(scene.ids)}
    fixed = {o.id: _on_wall(scene, o) for o in (*scene.room.doors, *scene.room.windows)}
    total = np.zeros(len(poses))
    for term in terms:
        pins = term.params.get("pins") or [(0.0, 0.0)] * len(term.objects)
        points = np.empty((len(poses), len(term.objects), 2))
        for k, (name, (dx, dy)) in enumerate(zip(term.objects, pins, strict=True)):
            if name in index:
                x, y, _, yaw = poses[:, index[name]].T
                c, s = np.cos(yaw), np.sin(yaw)
                points[:, k] = np.stack([x + c * dx - s * dy, y + s * dx + c * dy], axis=1)
            elif name in fixed and term.kind == "wire_length":
                points[:, k] = fixed[name]
            else:
                raise InputError(f'objective: there is no "{name}" in {scene.id} that a {term.kind} can have')
        span = points.max(axis=1) - points.min(axis=1)
        euclid = term.kind == "flow" and term.params.get("metric", "euclidean") == "euclidean"
        total += term.weight * (np.hypot(*span.T) if euclid else span.sum(axis=1))
    return total


def _on_wall(scene: Scene, opening: Any) -> tuple[float, float]:
    """The middle of a door or window, on its wall."""
    return scene.room.walls[opening.wall].point(opening.offset + opening.width / 2, 0.0)
