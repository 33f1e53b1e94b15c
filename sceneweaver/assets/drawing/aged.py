"""What age and use do to the finishes of a thing: dust, dirt, rust, wear, fading, soot and mould."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..body import Material


@dataclass(frozen=True)
class Ageing:
    """What becomes of a finish.

    Args:
        color: sRGB that it takes on.
        share: How much of it.
        roughness: It has at least.
        texture: The pattern of what is on it; empty: its own stays.
        metals: Whether only metal changes.
    """

    color: tuple[float, float, float]
    share: float
    roughness: float
    texture: str = ""
    metals: bool = False


AGED = {
    "worn": Ageing((0.66, 0.61, 0.54), 0.25, 0.8, "scuffed"),
    "dusty": Ageing((0.71, 0.69, 0.64), 0.5, 0.95),
    "dirty": Ageing((0.27, 0.22, 0.16), 0.25, 0.85, "stained"),
    "rusty": Ageing((0.47, 0.22, 0.1), 0.8, 0.95, "stained", metals=True),
    "faded": Ageing((0.86, 0.83, 0.77), 0.55, 0.7),
    "charred": Ageing((0.06, 0.055, 0.05), 0.85, 0.95, "stained"),
    "mouldy": Ageing((0.25, 0.32, 0.19), 0.35, 0.95, "stained"),
}
"""By posture."""


def aged(materials: Sequence[Material], posture: str | None) -> list[Material]:
    """Finishes as a posture leaves them; as they are where it says nothing of age.

    What shines stays as it is, and what is seen through, but for dust on it.
    """
    ageing = AGED.get(posture or "")
    if ageing is None:
        return list(materials)
    return [_aged(m, ageing, posture or "") if _ages(m, ageing) else m for m in materials]


def _ages(material: Material, ageing: Ageing) -> bool:
    if material.emission > 0.0 or (material.opacity < 1.0 and ageing.texture):
        return False
    return material.metallic > 0.3 or material.kind in ("steel", "iron") if ageing.metals else True


def _aged(material: Material, ageing: Ageing, posture: str) -> Material:
    color = tuple(own + ageing.share * (to - own) for own, to in zip(material.color, ageing.color, strict=True))
    return replace(
        material,
        name=f"{posture} {material.name}",
        color=color,
        roughness=max(material.roughness, ageing.roughness),
        metallic=material.metallic * (1.0 - ageing.share),
        texture=ageing.texture or material.texture,
    )


__all__ = ["AGED", "Ageing", "aged"]
