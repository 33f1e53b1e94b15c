"""Drawers, cupboards, appliances and vessels hold what is put into them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

from sceneweaver.assets import Asset, Interior, make
from sceneweaver.assets.parametric import makers
from sceneweaver.physics.hulls import reduce, rooms_of
from sceneweaver.physics.solids import solid_of as solid
from sceneweaver.scene import Part
from tests.assets.insides import CONTAINERS, faults


@pytest.mark.parametrize("name", ["nightstand", "fridge", "microwave", "mug", "wine_glass", "basket", "wall_basin"])
def test_a_ball_stays_in(name: str) -> None:
    assert faults(make(name, 0)) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(makers()))
def test_balls_stay_in_everything(name: str) -> None:
    for seed in range(3):
        assert faults(make(name, seed)) == [], seed


SIZES = yaml.safe_load((Path(__file__).parent / "insides.yaml").read_text(encoding="utf-8"))


def _compared(asset: Asset, which: str) -> list[np.ndarray]:
    """The sizes [3] of the interiors that a row of the table is about."""
    drawer = [room for room in asset.interiors if room.link and asset.links[room.link - 1].role == "drawer"]
    fixed = [room for room in asset.interiors if not room.link]
    rooms = {
        "drawer": drawer,
        "basin": [room for room in fixed if room.entry[2] > 0.5],
        "room": [room for room in fixed if room.entry[2] < 0.5] or fixed,
        "all": fixed,
    }[which]
    if which == "all":
        low, high = np.min([r.low for r in rooms], axis=0), np.max([r.high for r in rooms], axis=0)
        return [high - low]
    return [np.subtract(room.high, room.low) for room in rooms]


@pytest.mark.parametrize("name", sorted(SIZES))
def test_insides_are_as_large_as_in_life(name: str) -> None:
    row = SIZES[name]
    for seed in range(4):
        sizes = _compared(make(name, seed), row["of"])
        for axis, extent in enumerate(("depth", "width", "height")):
            low, high = row.get(extent, (0.0, np.inf))
            for size in sizes:
                assert 0.9 * low <= size[axis] <= 1.1 * high, f"seed {seed}: {extent} {size[axis]:.3f} m"


def test_a_hole_in_a_drawer_is_found() -> None:
    asset = make("nightstand", 0)
    number = next(k for k, link in enumerate(asset.links, start=1) if link.role == "drawer")
    room = next(room for room in asset.interiors if room.link == number)
    kept = [h for h in asset.hulls if h.link != number or h.vertices[:, 2].max() > room.low[2] + 0.02]
    torn = replace(asset, id="torn", hulls=tuple(kept), interiors=(room,))
    assert len(torn.hulls) < len(asset.hulls) and faults(torn)


def test_containers_are_categories() -> None:
    assert set(makers()) >= CONTAINERS


def test_merging_leaves_an_interior_free() -> None:
    walls = [((0, 1), (0, 0.1)), ((0, 1), (0.9, 1)), ((0, 0.1), (0, 1)), ((0.9, 1), (0, 1))]
    corners = [np.array([(a, b, c) for a in x for b in y for c in (0.0, 1.0)], dtype=float) for x, y in walls]
    solids = [solid(points, 0) for points in corners]
    prism = Part(polygon=((0, 0), (1, 0), (1, 1), (0, 1)), z=(0.0, 1.0))
    room = Interior("inside", 0, (0.1, 0.1, 0.0), (0.9, 0.9, 1.0))
    assert len(reduce(solids, [prism], 1)) == 1
    assert len(reduce(solids, [prism], 1, rooms_of([room]))) == 4
