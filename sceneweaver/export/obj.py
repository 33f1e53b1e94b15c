"""Wavefront OBJ files of triangles, and MTL files of their materials."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.physics.xml import text


def obj(
    points: np.ndarray,
    faces: np.ndarray,
    places: tuple[np.ndarray, np.ndarray] | None = None,
    *,
    material: tuple[str, str] | None = None,
    digits: int = 9,
) -> bytes:
    """The file of points [V, 3] with so many digits and faces [F, 3].

    ``places`` are texture coordinates [T, 2] with which of them each corner has [3 F], ``material`` is a library and
    the name of one of its materials.
    """
    lines = [f"mtllib {material[0]}\n"] if material else []
    lines.append(_lines("v" + 3 * f" %.{digits}g", points))
    if places is not None:
        lines.append(_lines("vt %.5g %.5g", places[0]))
    lines += [f"usemtl {material[1]}\n"] if material else []
    if places is None:
        lines.append(_lines("f %d %d %d", faces + 1))
    else:
        corners = np.stack([faces, places[1].reshape(-1, 3)], axis=2) + 1
        lines.append(_lines("f %d/%d %d/%d %d/%d", corners))
    return "".join(lines).encode()


def material_library(looks: Mapping[str, Material]) -> bytes:
    """The MTL file of materials by name."""
    lines = []
    for name, m in looks.items():
        shine = text(np.asarray(m.color) * min(1.0, m.emission))
        lines += [f"newmtl {name}", f"Kd {text(m.color)}", f"Ke {shine}", f"d {text(m.opacity)}"]
        lines += [f"Pr {text(m.roughness)}", f"Pm {text(m.metallic)}", "illum 2", ""]
    return "\n".join(lines).encode()


def _lines(line: str, values: np.ndarray) -> str:
    """A line for each row of an array."""
    return f"{line}\n" * len(values) % tuple(values.reshape(-1).tolist())
