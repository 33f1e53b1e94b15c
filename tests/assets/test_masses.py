"""What furniture and its doors and drawers weigh."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.assets.body import Material
from sceneweaver.assets.drawing.masses import bulk_of, masses_of
from sceneweaver.assets.drawing.tree import Piece
from sceneweaver.assets.materials import finish, tinted
from sceneweaver.assets.shapes import box


@pytest.mark.parametrize(
    ("category", "role", "least", "most"),
    [
        ("filing_cabinet", "drawer", 3.0, 8.0),
        ("kitchen_cabinet", "drawer", 2.0, 6.0),
        ("dresser", "drawer", 1.0, 9.0),
        ("nightstand", "drawer", 1.0, 3.0),
        ("fridge", "door", 4.0, 16.0),
        ("stove", "door", 3.0, 10.0),
        ("dishwasher", "door", 3.0, 9.0),
        ("microwave", "door", 0.7, 3.0),
        ("wardrobe", "door", 5.0, 25.0),
        ("wall_cabinet", "door", 1.2, 6.0),
        ("washing_machine", "door", 1.5, 5.0),
        ("freezer", "lid", 4.0, 12.0),
    ],
)
def test_doors_and_drawers_weigh_what_they_do_in_life(category: str, role: str, least: float, most: float) -> None:
    for seed in (0, 3):
        asset = make(category, seed)
        assert sum(asset.masses) == pytest.approx(asset.mass, abs=1e-3)
        own = [mass for link, mass in zip(asset.links, asset.masses[1:], strict=True) if link.role == role]
        assert all(least <= mass <= most for mass in own), (seed, own)


def _slab(thick: float, material: Material, link: int = 0) -> Piece:
    points, faces = box((0.0, 1.0), (0.0, 1.0), (0.0, thick), 0.0)
    return Piece(points, faces, np.eye(4), material, link)


def _masses(pieces: list[Piece], links: int, limits: tuple[float, float]) -> tuple[float, ...]:
    return masses_of(bulk_of(pieces, links), [piece.material for piece in pieces], limits)


def test_a_board_is_solid_and_a_thick_body_is_hollow() -> None:
    wood, steel = finish("oak").material, finish("steel").material
    assert _masses([_slab(0.01, wood)], 0, (0.0, 99.0)) == pytest.approx([6.5], rel=1e-6)
    assert _masses([_slab(0.1, steel)], 0, (0.0, 99.0)) == pytest.approx([7800 * 0.0008 * 2.4], rel=1e-6)
    blue = tinted(finish("white porcelain").material, "blue")
    assert _masses([_slab(0.001, blue)], 0, (0.0, 99.0)) == pytest.approx([2.3], rel=1e-6)


def test_the_total_stays_in_its_range() -> None:
    wood = finish("oak").material
    pieces = [_slab(0.01, wood), _slab(0.01, wood, 1)]
    assert _masses(pieces, 1, (20.0, 30.0)) == pytest.approx([13.5, 6.5])
    assert _masses(pieces, 1, (1.0, 6.5)) == pytest.approx([3.25, 3.25])
