"""Materials of a USD stage: what is seen (UsdPreviewSurface) and how surfaces rub (physics materials)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import Material

from .images import Images, file_stem, images, linear, tinted
from .shared import SharedFiles
from .usd_engines import tune_friction
from .usd_layer import Prim, apply, attribute, prim, prim_names, relate, triple, usd

LAMP = 0.5
"""Emission from which on something is a lamp."""

GLOW = 6.0
"""How many times as bright as white a lamp of emission 1 is, so that it lights what is around it."""


class Looks:
    """The materials of a stage below two scopes, each made when it is first asked for.

    ``files`` are the images that go beside the stage, by path relative to it; not ``textured``: there are none. Where
    files are ``shared``, images are there.
    """

    def __init__(self, looks: Prim, frictions: Prim, textured: bool, shared: SharedFiles | None = None):
        self.textured, self._shared = textured, shared
        self.files: dict[str, bytes] = {}
        self._looks, self._frictions = looks, frictions
        self._names = prim_names()
        self._seen: dict[Material, Any] = {}
        self._rubs: dict[float, Any] = {}

    def dress(self, target: Prim, material: Material) -> None:
        """Bind what is seen."""
        if material not in self._seen:
            self._seen[material] = self._surface(self._names(material.name), material)
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
            tune_friction(made)
            self._rubs[key] = made.path
        apply(target, "MaterialBindingAPI")
        relate(target, "material:binding:physics", self._rubs[key])

    def _surface(self, name: str, material: Material) -> Any:
        """A material with one UsdPreviewSurface shader, and readers of its images; returns its path."""
        made = prim(self._looks, name, "Material", displayName=material.name)
        shader = prim(made, "Surface", "Shader")
        base = [float(c) for c in linear(material.color)]
        glow = [c * material.emission * (GLOW if material.emission >= LAMP else 1.0) for c in base]
        values: dict[str, tuple[str, Any]] = {
            "diffuseColor": ("Color3f", triple(base)),
            "emissiveColor": ("Color3f", triple(glow)),
            **{key: ("Float", float(getattr(material, key))) for key in ("roughness", "metallic", "opacity")},
        }
        attribute(shader, "info:id", "Token", "UsdPreviewSurface", uniform=True)
        inputs = {key: attribute(shader, f"inputs:{key}", kind, value) for key, (kind, value) in values.items()}
        files = images(material.texture) if self.textured else None
        if files is not None:
            self._read(made, shader, inputs, material, files)
        surface = attribute(shader, "outputs:surface", "Token", None)
        output = attribute(made, "outputs:surface", "Token", None)
        output.connectionPathList.explicitItems.append(surface.path)
        return made.path

    def _read(self, made: Prim, shader: Prim, inputs: dict[str, Any], material: Material, files: Images) -> None:
        """Shaders that read the images of a texture into the inputs of a surface."""
        reader = prim(made, "Coordinates", "Shader")
        attribute(reader, "info:id", "Token", "UsdPrimvarReader_float2", uniform=True)
        attribute(reader, "inputs:varname", "String", "st")
        places = attribute(reader, "outputs:result", "Float2", None)
        color, roughness = tinted(material, linear(material.color))

        def image(role: str, data: bytes, space: str, scale: Sequence[float], bias: Sequence[float] = ()) -> Prim:
            name = f"{file_stem(material.texture)}_{role}"
            if self._shared is not None:
                path = self._shared.path(name, "jpg", lambda: data)
            else:
                path = f"textures/{name}.jpg"
                self.files[path] = data
            found = prim(made, role.capitalize(), "Shader")
            attribute(found, "info:id", "Token", "UsdUVTexture", uniform=True)
            attribute(found, "inputs:file", "Asset", usd().Sdf.AssetPath(f"./{path}"))
            for key, value in (("sourceColorSpace", space), ("wrapS", "repeat"), ("wrapT", "repeat")):
                attribute(found, f"inputs:{key}", "Token", value)
            attribute(found, "inputs:scale", "Float4", tuple(float(v) for v in scale))
            if bias:
                attribute(found, "inputs:bias", "Float4", tuple(float(v) for v in bias))
            at = attribute(found, "inputs:st", "Float2", None)
            at.connectionPathList.explicitItems.append(places.path)
            return found

        def connect(key: str, source: Prim, output: str) -> None:
            given = attribute(source, f"outputs:{output}", "Float3" if output == "rgb" else "Float", None)
            inputs[key].connectionPathList.explicitItems.append(given.path)

        connect("diffuseColor", image("color", files.color, "sRGB", (*color, 1.0)), "rgb")
        if files.normal is not None:
            inputs["normal"] = attribute(shader, "inputs:normal", "Normal3f", None)
            connect("normal", image("normal", files.normal, "raw", (2, 2, 2, 1), (-1, -1, -1, 0)), "rgb")
        if files.rough is not None:
            rough = image("rough", files.rough, "raw", (1, roughness, material.metallic, 1))
            connect("roughness", rough, "g")
            if files.metal:
                connect("metallic", rough, "b")
