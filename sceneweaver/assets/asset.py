"""An asset: one piece of furniture with its body, what it carries, and what it asks of the room."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal

from sceneweaver.scene import Part, Pose, SceneObject, Support, Surface, Zone

from .body import Grasp, Hull, Interior, Link, Mesh

Mount = Literal["floor", "wall", "ceiling", "surface"]


@dataclass(frozen=True)
class Origin:
    """Where an asset comes from.

    ``axes`` are the up and front axes that its file had ("z x" for ours) and ``metres_per_unit`` its scale;
    ``front_confidence`` in 0..1 says how sure the front is, ``notes`` what an import changed or could not know.
    """

    source: str
    licence: str
    attribution: str = ""
    axes: str = "z x"
    metres_per_unit: float = 1.0
    front_confidence: float = 1.0
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Asset:
    """A piece of furniture in its own frame: origin at the bottom centre of its box, z up, front +x, metres.

    The visual ``mesh`` lies inside the union of the convex ``hulls`` (to 0.5 mm for hard bodies, 1 cm for leaves and
    cloth), and those lie inside the at most eight prisms ``parts`` that the engine moves. ``surfaces`` carry other
    things, ``zones`` are the room it needs to be used, ``sides`` the sides from which it is used. ``grasps`` are where
    a hand takes hold, ``interiors`` the rooms inside. ``masses`` [kg] are those of the base and of each link; empty:
    ``mass`` is shared out by the volume of the hulls. ``drawn_as`` names the drawing that it is a finish of; empty:
    it is the only one, see `geometry`.
    """

    id: str
    category: str
    mesh: Mesh
    hulls: tuple[Hull, ...]
    parts: tuple[Part, ...]
    mount: Mount
    mass: float
    friction: float
    origin: Origin
    surfaces: tuple[Surface, ...] = ()
    zones: tuple[Zone, ...] = ()
    sides: tuple[str, ...] = ()
    links: tuple[Link, ...] = ()
    grasps: tuple[Grasp, ...] = ()
    interiors: tuple[Interior, ...] = ()
    masses: tuple[float, ...] = ()
    attributes: dict[str, Any] = field(default_factory=dict)
    description: str = ""
    drawn_as: str = ""

    @property
    def geometry(self) -> str:
        """A key of its geometry, never empty: assets of equal keys differ at most in finish.

        The arrays of the mesh with its division into materials, hulls, parts, links, grasps, interiors, surfaces and
        zones are equal; id, the materials themselves, masses, attributes and description may be others.
        """
        return self.drawn_as or self.id

    @cached_property
    def size(self) -> tuple[float, float, float]:
        """Depth along the front, width, height [m]."""
        low, high = self.mesh.bounds
        d, w, h = (round(float(v), 6) for v in high - low)
        return d, w, h

    @property
    def nbytes(self) -> int:
        """About the memory that it takes."""
        mesh = self.mesh
        arrays = [
            mesh.vertices,
            mesh.faces,
            mesh.face_material,
            mesh.face_link,
            *([] if mesh.uv is None else [mesh.uv]),
        ]
        arrays += [array for hull in self.hulls for array in (hull.vertices, hull.faces)]
        return sum(array.nbytes + 128 for array in arrays) + 2**14  # prisms, zones, words

    def of_style(self, style: object) -> Asset:
        """The asset, said to be of a style; what looks alike in all styles is of the one that it is chosen for."""
        if not style or self.attributes.get("style") == style:
            return self
        return replace(self, attributes=self.attributes | {"style": style})

    def object(
        self, asset_id: str, *, pose: Pose | None = None, mount: Mount | None = None, support: Support | None = None
    ) -> SceneObject:
        """The scene object of this asset; ``mount`` is the asset's unless it can be had in another way too."""
        extra: dict[str, Any] = {} if pose is None else {"pose": pose}
        return SceneObject(
            id=asset_id,
            category=self.category,
            description=self.description or None,
            size=self.size,
            mount=mount or ("surface" if support else self.mount),
            support=support,
            asset=self.id,
            parts=self.parts,
            zones=self.zones,
            surfaces=self.surfaces,
            attributes=self.attributes,
            **extra,
        )
