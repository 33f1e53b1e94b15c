"""Drawings that are made once for all finishes are what they would be if each were drawn by itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import Material, draws, make
from sceneweaver.assets.drawing import MAKERS, Drawing, Request
from sceneweaver.assets.journal import Journal
from sceneweaver.assets.parametric import makers
from sceneweaver.assets.parametric.drawings import Drawings

PALETTES = (
    None,
    "plywood/black paint/black steel,iron/charcoal,tan,rust/0",
    "birch/white paint,light grey paint/white steel/off white,steel blue,navy/0",
    "walnut/sage paint/brass/green,mustard,cream/3",
)
LOOKS = tuple(Request(style=style, palette=palette) for palette in PALETTES for style in (None, "modern", "rustic"))
ODD = (
    Request(color="blue", palette=PALETTES[1]),
    Request(color="red", material="velvet"),
    Request(palette=PALETTES[2], suite=1, mirrored=True),
    Request(palette=PALETTES[1], suite=2, label="odd thing"),
    Request(palette=PALETTES[3], shape="round", parts=(("drawers", 2), ("shelves", 3))),
)
SAMPLE = ("armchair", "kitchen_cabinet", "mug", "wall_clock", "dining_chair", "book")


def same(a: Any, b: Any) -> bool:
    """Whether two assets, or what they are made of, are equal to the bit."""
    if isinstance(a, np.ndarray):
        alike = a.dtype == b.dtype and a.shape == b.shape and a.flags.c_contiguous == b.flags.c_contiguous
        return alike and a.tobytes() == b.tobytes()
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    if is_dataclass(a):
        return all(same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a))
    return repr(a) == repr(b)


def _differ(names: Iterator[str] | tuple[str, ...], drawings: Drawings, seeds: int) -> list[tuple[str, int, Request]]:
    cases = [(name, seed, request) for name in names for seed in range(seeds) for request in LOOKS + ODD]
    return [case for case in cases if not same(make(*case), drawings.get(*case))]


def test_finishes_of_a_drawing_are_what_is_drawn() -> None:
    drawings = Drawings(2**30)
    assert _differ(SAMPLE, drawings, 1) == []
    assert drawings.drawn < 0.5 * len(drawings)


@pytest.mark.slow
def test_finishes_of_all_drawings_are_what_is_drawn() -> None:
    assert _differ(tuple(makers()), Drawings(2**27), 3) == []


def test_finishes_share_their_arrays_which_are_counted_once() -> None:
    drawings = Drawings(2**30)
    one, two = (drawings.get("mug", 0, Request(palette=palette)) for palette in PALETTES[1:3])
    assert one.mesh.materials != two.mesh.materials and one.id != two.id
    assert one.geometry == two.geometry and one.mesh.vertices is two.mesh.vertices and one.hulls is two.hulls
    both = drawings.nbytes
    drawings.get("mug", 0, Request(palette=PALETTES[3]))
    assert drawings.nbytes - both < 0.2 * both
    drawings.keep(0)
    drawings.get("fork", 0, Request())
    assert len(drawings) == 1 and 0 < drawings.nbytes < both


def test_equal_geometry_has_equal_arrays() -> None:
    drawings, found = Drawings(2**30), {}
    for name in SAMPLE:
        for request in LOOKS:
            asset = drawings.get(name, 0, request)
            mesh = replace(asset.mesh, materials=())
            bare = replace(asset, id="", mesh=mesh, mass=0.0, masses=(), attributes={}, description="")
            assert same(found.setdefault(asset.geometry, bare), bare)
    assert len(found) < 0.6 * len(SAMPLE) * len(LOOKS)


@pytest.fixture
def curious() -> Iterator[str]:
    """A category whose drawing asks all that can be asked of its finishes."""

    def draw(d: Drawing) -> None:
        body, cover = d.material("body", "@wood"), d.material("cover", "@fabric, oak")
        seen = {body: 0.1, cover: 0.2}
        d.box(d.bounds.bottom(0.2 + 0.01 * len(body.name) + 0.1 * len(seen)), body)
        d.box(d.bounds.top(0.1 + 0.1 * cover.roughness), replace(cover, color=(0.1, 0.2, 0.3)))
        d.box(d.bounds.front(0.02 if "oak" in str(body) else 0.04), Material("own", (0.5, 0.5, 0.5)))
        d.box(d.bounds.back(0.02 if body == cover or d.style == "modern" else 0.03), body if d.in_room else cover)

    makers()
    before = MAKERS.pop("pouf")
    draws("pouf")(draw)
    yield "pouf"
    MAKERS["pouf"] = before


def test_a_drawing_may_ask_anything_of_its_finishes(curious: str) -> None:
    drawings = Drawings(2**30)
    assert _differ((curious,), drawings, 3) == []
    assert len({drawings.get(curious, 0, request).geometry for request in LOOKS}) > 3


def test_a_process_takes_over_what_another_drew(tmp_path: Path) -> None:
    first, second = Drawings(2**30), Drawings(2**30)
    first.share(Journal(tmp_path))
    cases = [(name, 0, request) for name in SAMPLE for request in (*LOOKS[:4], *ODD)]
    for case in cases:
        first.get(*case)
    assert first.told == 0
    second.share(Journal(tmp_path))
    assert all(same(second.get(*case), first.get(*case)) for case in cases)
    assert second.drawn == 0 < second.told


def test_what_was_told_may_be_broken_or_go(tmp_path: Path) -> None:
    request, first = Request(palette=PALETTES[1]), Drawings(2**30)
    first.share(Journal(tmp_path))
    whole = first.get("armchair", 0, request)
    (file,) = tmp_path.glob("*.journal")
    content = file.read_bytes()
    for cut in (len(content) - 1, len(content) // 2, 10):
        for path in tmp_path.iterdir():
            path.unlink()
        file.write_bytes(content[:cut])
        second = Drawings(2**30)
        second.share(Journal(tmp_path))
        assert same(second.get("armchair", 0, request), whole) and second.drawn == 1
    file.write_bytes(content)
    third = Drawings(2**30)
    third.share(Journal(tmp_path))
    third.get("mug", 0, request)  # has looked
    for path in tmp_path.glob("*.journal"):
        path.unlink()
    assert same(third.get("armchair", 0, request), whole)


def test_drawings_of_the_user_are_not_told(curious: str, tmp_path: Path) -> None:
    drawings = Drawings(2**30)
    drawings.share(Journal(tmp_path))
    drawings.get(curious, 0, Request())
    assert not list(tmp_path.iterdir())
