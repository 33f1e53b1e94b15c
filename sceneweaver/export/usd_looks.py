"""Materials of a USD stage: what is seen (UsdPreviewSurface) and how surfaces rub (physics materials)."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import Material

from .glb import linear
from .usd_layer import Names, Prim, apply, attribute, prim, relate, triple


class Looks:
    """The materials of a stage below two scopes, each made when it is first asked for."""

    def __init__(self, looks: Prim, frictions: Prim):
        self._looks, self._frictions = looks, frictions
        self._names = Names()
        self._seen: dict[Material, Any] = {}
        self._rubs: dict[float, Any] = {}

    def dress(self, target: Prim, material: Material) -> None:
        """Bind what is seen."""
        if material not in self._seen:
            self._seen[material] = _surface(self._looks, self._names(material.name), material)
        apply(target, "MaterialBindingAPI")
        relate(target, "material:binding", self._seen[material])

    def rub(self, target: Prim, friction: float) -> None:
        """Bind the friction of a collider.

        USD lets it be inherited, but its reader of physics looks only at what is bound to the collider itself.
        """
        key = round(float(friction), 4)
        if key not in self._rubs:
            made = prim(self._frictions, f"friction_{key:.4f}".replace(".", "_"), "Material", ["PhysicsMaterialAPI"])
            for name, value in (("staticFriction", key), ("dynamicFriction", key), ("restitution", 0.0)):
                attribute(made, f"physics:{name}", "Float", value)
            self._rubs[key] = made.path
        apply(target, "MaterialBindingAPI")
        relate(target, "material:binding:physics", self._rubs[key])


def _surface(parent: Prim, name: str, material: Material) -> Any:
    """A material with one UsdPreviewSurface shader; returns its path."""
    made = prim(parent, name, "Material", displayName=material.name)
    shader = prim(made, "Surface", "Shader")
    base = [float(c) for c in linear(material.color)]
    glow = [min(1.0, c * material.emission) for c in base]
    attribute(shader, "info:id", "Token", "UsdPreviewSurface", uniform=True)
    attribute(shader, "inputs:diffuseColor", "Color3f", triple(base))
    attribute(shader, "inputs:emissiveColor", "Color3f", triple(glow))
    for key in ("roughness", "metallic", "opacity"):
        attribute(shader, f"inputs:{key}", "Float", float(getattr(material, key)))
    surface = attribute(shader, "outputs:surface", "Token", None)
    output = attribute(made, "outputs:surface", "Token", None)
    output.connectionPathList.explicitItems.append(surface.path)
    return made.path
