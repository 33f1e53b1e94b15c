"""A drawing without its finishes, of which all its finishes are made."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import blake2b
from typing import Any

import numpy as np

from ..asset import Asset
from ..body import Material
from ..materials import color_name
from .aged import aged
from .finishes import Finishes
from .masses import Bulk, masses_of

Slot = int | Material
"""The number of a finish that the drawing was given, or a finish of its own."""


GLOWS = 0.2
"""Share of its colour from which on a material is that of a lamp."""

LIGHT = ("lit", "unlit")
"""Postures of what shines."""


@dataclass(frozen=True, eq=False)
class Bare:
    """A drawing without its finishes.

    ``asset`` has neither id nor materials, and its mesh one material for each of the ``slots``. ``slot`` int32 [P] and
    ``faces`` int32 [P] are those of each piece of the mesh, ``bulk`` what weighs. ``mass`` [kg] are its limits;
    ``shown`` are attributes that follow from its shape.
    """

    asset: Asset
    slots: tuple[Slot, ...]
    slot: np.ndarray
    faces: np.ndarray
    bulk: Bulk
    mass: tuple[float, float]
    shown: dict[str, Any]
    _divisions: dict[tuple[int, ...], np.ndarray] = field(default_factory=dict)

    @cached_property
    def nbytes(self) -> int:
        """About the memory that it takes."""
        return self.asset.nbytes + 24 * len(self.slot) + 4096

    @cached_property
    def key(self) -> str:
        """Equal for equal geometry, of whatever drawing."""
        asset, mesh = self.asset, self.asset.mesh
        digest = blake2b(digest_size=12)
        assert mesh.uv is not None
        for array in (mesh.vertices, mesh.faces, mesh.face_material, mesh.face_link, mesh.uv):
            digest.update(array.tobytes())
        for hull in asset.hulls:
            digest.update(hull.vertices.tobytes() + hull.faces.tobytes())
        counts = [(len(hull.vertices), len(hull.faces), hull.link, hull.handle) for hull in asset.hulls]
        rest = [len(mesh.vertices), counts, asset.category, asset.parts, asset.mount, asset.friction, asset.surfaces]
        rest += [asset.zones, asset.sides, asset.links, asset.grasps, asset.interiors]
        digest.update(repr(rest).encode())
        return f"parametric:{asset.category}#{digest.hexdigest()}"

    def same(self, other: Bare) -> bool:
        """Whether another one of equal geometry can take its place."""
        own, its = (self.slots, self.mass, self.shown), (other.slots, other.mass, other.shown)
        return own == its and np.array_equal(self.slot, other.slot)

    def finished(self, given: Sequence[Material], finishes: Finishes) -> Asset:
        """The asset with the finishes that the drawing was given, as ``finishes`` decided."""
        materials = [given[slot] if isinstance(slot, int) else slot for slot in self.slots]
        shown = dict(self.shown)
        if finishes.request.posture in LIGHT and any(m.emission >= GLOWS for m in materials):
            shown["posture"] = finishes.request.posture
            materials = [_lit(m, finishes.request.posture) for m in materials]
        if (old := aged(materials, finishes.request.posture)) != materials:
            shown["posture"], materials = finishes.request.posture, old
        numbers: dict[Material, int] = {}
        division = tuple(numbers.setdefault(material, len(numbers)) for material in materials)
        masses = masses_of(self.bulk, [materials[slot] for slot in self.slot.tolist()], self.mass)
        bare, request, main = self.asset, finishes.request, finishes.main_material
        attributes: dict[str, Any] = {"style": finishes.style}
        if main is not None:
            attributes |= {"color": color_name(main.color), "material": main.name}
        attributes |= {key: value for key, value in finishes.shown.items() if key != "material"}
        words = bare.category.replace("_", " ")
        same = len(numbers) == len(materials)
        return replace(
            bare,
            id=f"parametric:{finishes.category.name}?seed={finishes.seed}{request.suffix}",
            mesh=replace(bare.mesh, materials=tuple(numbers), face_material=self._divided(division)),
            mass=round(sum(masses), 5),
            masses=masses,
            attributes=attributes | shown,
            description=f"{main.name} {words}" if main is not None else words,
            drawn_as=self.key if same else f"{self.key}/{','.join(map(str, division))}",
        )

    def _divided(self, division: tuple[int, ...]) -> np.ndarray:
        """The material of each face, int32 [F], where slots have these."""
        if len(set(division)) == len(division):
            return self.asset.mesh.face_material
        if division not in self._divisions:
            of_piece = np.array(division, dtype=np.int32)[self.slot]
            self._divisions[division] = np.repeat(of_piece, self.faces)
        return self._divisions[division]


def _lit(material: Material, posture: str) -> Material:
    """A material of what shines, or does not, in a posture."""
    out = posture == "unlit" and material.emission >= GLOWS
    return replace(material, name=f"{material.name} off", emission=0.0) if out else material
