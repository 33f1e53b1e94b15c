"""CubiCasa5K: rooms, doors and windows of an SVG, with transforms, a scale from the doors, and nothing executed."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import refused, rooms, same_ring

SVG = """\
<svg xmlns="http://www.w3.org/2000/svg" width="900" height="700" viewBox="0 0 900 700">
 <g id="Model" class="Model v1-1"><g class="Floorplan Floor-1" transform="translate(100,40)">
  <g id="Wall" class="Wall External"><polygon points="0,0 620,0 600,20 20,20 "/>
   <g id="Window" class="Window Regular"><polygon points="120,0 220,0 220,20 120,20 "/><g class="Panel"/></g></g>
  <g id="Wall" class="Wall"><polygon points="300,20 310,20 310,320 300,320 "/>
   <g id="Door" class="Door Swing Beside"><polygon points="300,100 310,100 310,164 300,164 "/>
    <g class="Threshold"><polygon points="300,100 310,100 310,164 300,164 "/></g></g></g>
  <g id="Wall" class="Wall External"><polygon points="0,0 20,20 20,420 0,440 "/>
   <g id="Door" class="Door Swing Opposite"><polygon points="0,200 20,200 20,280 0,280 "/></g></g>
  <g class="Space LivingRoom Dining"><polygon points="20,20 300,20 300,320 200,320 200,420 20,420 "/>
   <g class="NameLabel"><text>OH</text></g></g>
  <g class="Space Bath"><polygon points="0,0 290,0 290,300 0,300 " transform="translate(310,20)"/></g>
  <g class="FixedFurnitureSet"><g class="FixedFurniture Toilet" transform="matrix(0,1,-1,0,400,60)">
   <g class="BoundaryPolygon"><polygon points="0,0 40,0 40,60 0,60 "/></g></g></g>
 </g></g>
</svg>
"""
UNIT = 0.8 / 72.0  # doors of 64 and 80 units: the middle one is 72


def metres(points: Sequence[tuple[float, float]]) -> np.ndarray:
    """Points of the group in metres, y up; the group is moved by (100, 40)."""
    return np.array([((x + 100) * UNIT, -(y + 40) * UNIT) for x, y in points])


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "model.svg"
    path.write_text(SVG)
    return path


def test_rooms_in_metres_with_y_up(file: Path) -> None:
    living, bath = rooms(file, "cubicasa")
    assert (living.name, living.type, bath.type) == ("living_room_0", "living_room", "bath")
    same_ring(living.outline, metres([(20, 20), (300, 20), (300, 320), (200, 320), (200, 420), (20, 420)]))
    same_ring(bath.outline, metres([(310, 20), (600, 20), (600, 320), (310, 320)]))
    assert not living.objects and any("1 Toilet" in note for note in living.notes)
    assert any(f"{UNIT:.6g} m" in note for note in living.notes)


def test_doors_and_windows(file: Path) -> None:
    living, bath = rooms(file, "cubicasa")
    window, inner, outer = living.openings
    assert [o.kind for o in living.openings] == ["window", "door", "door"]
    for opening, ends in (
        (window, [(120, 10), (220, 10)]),
        (inner, [(305, 164), (305, 100)]),
        (outer, [(10, 280), (10, 200)]),
    ):
        np.testing.assert_allclose(sorted([opening.start, opening.end]), metres(ends), atol=1e-5)
    assert [o.name for o in bath.openings] == [inner.name]


def test_to_scenes(file: Path) -> None:
    living, bath = sw.read_scenes(file)
    assert len(living.scene.room.doors) == 2 and len(living.scene.room.windows) == 1
    assert len(bath.scene.room.doors) == 1
    sw.check(living.scene)


def test_without_doors_a_unit_is_a_centimetre(file: Path) -> None:
    file.write_text('<svg><g class="Space Kitchen"><polygon points="0,0 300 0 300,250 0,250"/></g></svg>')
    (kitchen,) = rooms(file, "cubicasa")
    same_ring(kitchen.outline, [(0, 0), (3, 0), (3, -2.5), (0, -2.5)])
    assert "0.01 m is assumed" in kitchen.notes[0]


def test_transforms_by_hand(file: Path) -> None:
    """Rotated by 90 degrees (x, y) is (-y, x); then doubled, then moved by (500, 0)."""
    file.write_text(
        '<svg><g transform="translate(500) scale(2)"><g class="Space Kitchen" transform="rotate(90)">'
        '<polygon points="0,0 150,0 150,100 0,100"/></g></g></svg>'
    )
    (kitchen,) = rooms(file, "cubicasa")
    same_ring(kitchen.outline, [(5, 0), (5, -3), (3, -3), (3, 0)])


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        ("<svg", '<!DOCTYPE svg [<!ENTITY a "b">]><svg', "document types"),
        ('points="20,20 300,20 ', 'points="20,20 nan,20 ', "finite"),
        ('points="20,20 300,20 ', 'points="20,20 300,abc ', "pairs"),
        ('points="20,20 300,20 300,320 200,320 200,420 20,420 "', 'points="20,20"', "pairs"),
        ("translate(100,40)", "skewX(30)", "is not read"),
        ("translate(100,40)", "matrix(1,2)", "matrix has 2"),
        ('class="Space', 'class="Place', "no room"),
        ("svg", "plan", "no <svg>"),
        ("</g></g>\n</svg>", "", "damaged"),
    ],
)
def test_broken_files_are_one_line(file: Path, old: str, new: str, match: str) -> None:
    assert old in SVG
    file.write_text(SVG.replace(old, new))
    refused("cubicasa", file, match=match)


def test_an_empty_file(file: Path) -> None:
    file.write_text("")
    refused("cubicasa", file)
