"""Each term of the energy alone, on two boxes, with numbers worked out by hand; and against the reference."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.layout.pack import MARGINS
from tests.kernels import compare
from tests.kernels.harness import any_options, as_float32, energies
from tests.kernels.made import centred
from tests.sizes import sizes
from tests.verify.build import box, relation, scene

KNEE, AIM = 0.05, MARGINS["collision_aim"]
ALONE = {"collision": 0.0, "bounds": 0.0, "zone": 0.0, "opening": 0.0, "relation": 0.0}
FRONT = {"name": "front", "polygon": centred(0.5, 1.0, 0.75), "z": [0.0, 1.0], "hard": True}


def problem(*objects: dict[str, Any], relations=(), **room) -> LayoutProblem:
    return compile_scene(scene(list(objects), list(relations), **room)).room


def pair(a: dict[str, Any] | None = None, b: dict[str, Any] | None = None, relations=(), **room) -> LayoutProblem:
    """Two boxes of 1 m in a room of 8 m, clear of its walls."""
    objects = [box(id, (1.0, 1.0, 1.0), 4.0, 4.0, **(more or {})) for id, more in (("a", a), ("b", b))]
    return problem(*objects, relations=relations, **room)


def penalty(v: float) -> tuple[float, float]:
    """Value and slope."""
    return (0.0, 0.0) if v <= 0 else (v * v / (2 * KNEE), v / KNEE) if v < KNEE else (v - KNEE / 2, 1.0)


def run(p: LayoutProblem, layout, device: str, **weights):
    """Shares, soft shares and gradients of one layout; weights not given are zero."""
    found = energies(p, np.array([layout], dtype=float), device, weights={**ALONE, **weights})
    return found.share[0], found.soft[0], found.gradient[0]


DEPTHS = {"inactive": -0.01, "touching": 0.0, "near side of the knee": 0.02, "far side of the knee": 0.3}
depths = pytest.mark.parametrize("depth", DEPTHS.values(), ids=DEPTHS.keys())


@depths
def test_collision(device, depth):
    share, soft, gradient = run(pair(), [[4, 4, 0, 0], [5 - depth, 4.2, 0, 0]], device, collision=2.0)
    value, slope = penalty(depth + AIM)
    np.testing.assert_allclose(share, [value, value], atol=2e-6, rtol=1e-5)  # half of twice the value each
    np.testing.assert_allclose(gradient[:, :3], [[2 * slope, 0, 0], [-2 * slope, 0, 0]], atol=1e-4)
    assert not soft.any()


def test_collision_is_gated_by_height_not_eased_by_it(device):
    share, _, gradient = run(pair(), [[4, 4, 0, 0], [4.7, 4, 0.98, 0]], device, collision=1.0)
    assert share.sum() == pytest.approx(penalty(0.3 + AIM)[0], rel=1e-5)
    assert not gradient[:, 2].any()
    share, _, gradient = run(
        pair(), [[4, 4, 0, 0], [4.7, 4, 1 - 0.9 * MARGINS["least_overlap_z"], 0]], device, collision=1.0
    )
    assert not share.any() and not gradient.any()


@depths
@pytest.mark.parametrize("owner", [0, 1], ids=["of the first", "of the second"])
def test_hard_zone(device, depth, owner):
    zoned: list[dict[str, Any]] = [{}, {}]
    zoned[owner]["zones"] = [FRONT]
    layout = np.array([[4.0, 4, 0, 0]] * 2)
    layout[1 - owner, 0] = 5.5 - depth  # in front of the owner
    share, _, gradient = run(pair(*zoned), layout, device, zone=1.0)
    value, slope = penalty(depth)
    np.testing.assert_allclose(share, [value / 2] * 2, atol=2e-6, rtol=1e-5)
    np.testing.assert_allclose(gradient[owner, :2], [slope, 0.0], atol=1e-4)
    np.testing.assert_allclose(gradient[1 - owner, :2], [-slope, 0.0], atol=1e-4)


@pytest.mark.parametrize("what", ["soft", "tied", "zone on zone", "overhead"])
def test_zones_that_may_be_entered(device, what):
    layout = [[4.0, 4, 0, 0], [5.2, 4, 0, 0]]
    a: dict[str, Any] = {"zones": [FRONT]}
    links = []
    if what == "soft":
        a = {"zones": [{**FRONT, "hard": False}]}
    elif what == "tied":
        links = [relation("front_against", "b", "a")]
    elif what == "zone on zone":
        layout = [[4.0, 4, 0, 0], [5.7, 4, 0, math.pi]]
        a["zones"] = [FRONT]
    else:
        layout[1][2] = 1.0
    share, _, gradient = run(pair(a, a if what == "zone on zone" else {}, links), layout, device, zone=1.0)
    assert not share.any() and not gradient.any()


@depths
def test_bounds_half_plane(device, depth):
    share, _, gradient = run(pair(), [[7.5 + depth, 4, 0, 0], [4, 4, 0, 0]], device, bounds=3.0)
    value, slope = penalty(depth + AIM)
    np.testing.assert_allclose(share, [3 * value, 0], atol=5e-6, rtol=1e-5)
    np.testing.assert_allclose(gradient[0, :3], [3 * slope, 0, 0], atol=1e-4)


def test_bounds_takes_the_deepest_vertex_once_for_each_plane(device):
    yaw = 0.1
    share, _, gradient = run(pair(), [[7.6, 4, 0, yaw], [4, 4, 0, 0]], device, bounds=1.0)
    c, s = math.cos(yaw), math.sin(yaw)
    assert share[0] == pytest.approx(penalty(7.6 + 0.5 * (c + s) - 8 + AIM)[0], rel=1e-5)
    np.testing.assert_allclose(gradient[0], [1, 0, 0, 0.5 * (c - s)], atol=1e-4)


L_ROOM = [[0, 0], [8, 0], [8, 4], [4, 4], [4, 8], [0, 8]]


@pytest.mark.parametrize(
    ("at", "depth", "way"),
    [((4.1, 7), 0.6, (-1, 0)), ((7, 4.2), 0.7, (0, -1)), ((6.0, 5.7), 2.2, (0, -1)), ((5.4, 6.2), 1.9, (-1, 0))],
    ids=["through one side", "through the other", "far in, down", "far in, left"],
)
def test_bounds_pocket_pushes_back_into_the_room(device, at, depth, way):
    """The pocket of the L is a triangle whose long side is no side of the room: no way out, however near."""
    p = pair(outline=L_ROOM)
    half_plane = (at[0] + at[1] + 1.0 - 12.0) / math.sqrt(2)
    share, _, gradient = run(p, [[*at, 0, 0], [1, 1, 0, 0]], device, bounds=1.0)
    value = penalty(depth + AIM)[0] + penalty(half_plane + AIM)[0]
    assert share[0] == pytest.approx(value, rel=1e-5)
    push = -np.array(way) + penalty(half_plane + AIM)[1] * np.array([1, 1]) / math.sqrt(2)
    np.testing.assert_allclose(gradient[0, :2], push, atol=1e-4)


@depths
@pytest.mark.parametrize("opening", ["door", "window"])
def test_openings(device, depth, opening):
    kind = {"id": opening, "wall": 0, "offset": 3.0, "width": 1.0, "height": 1.0}
    door, window = [{**kind, "height": 2.0, "swing": "slide"}], [{**kind, "sill": 0.5}]
    p = pair({"zones": [FRONT]}, **({"doors": door} if opening == "door" else {"windows": window}))
    front = 0.6 if opening == "door" else 0.3
    layout = [[3.6, front + 0.5 - depth, 0, 0], [4, 4, 0, 0]]
    share, _, gradient = run(p, layout, device, opening=1.0)
    value, slope = penalty(depth)
    np.testing.assert_allclose(share, [value, 0], atol=2e-6, rtol=1e-5)
    np.testing.assert_allclose(gradient[0, :2], [0, -slope], atol=1e-4)
    layout[0][2] = 2.0 if opening == "door" else -0.5  # over the door, under the window
    assert not run(p, layout, device, opening=1.0)[0].any()


def test_openings_do_not_mind_what_hangs_on_a_wall(device):
    door = {"id": "door", "wall": 0, "offset": 3.0, "width": 1.0, "height": 2.0, "swing": "in-left"}
    p = pair({"mount": "wall"}, doors=[door])
    assert not run(p, [[3.6, 0.5, 0, 0], [4, 4, 0, 0]], device, opening=1.0)[0].any()


@depths
@pytest.mark.parametrize("end", ["floor", "ceiling"])
def test_height_of_what_hangs(device, depth, end):
    z, sign = (-depth, -1) if end == "floor" else (1.7 + depth, 1)
    share, _, gradient = run(pair({"mount": "wall"}), [[4, 4, z, 0], [2, 2, z, 0]], device, bounds=1.0)
    value, slope = penalty(depth + MARGINS["bounds_aim"])
    np.testing.assert_allclose(share, [value, 0], atol=2e-6, rtol=1e-5)  # b stands: its height is given
    np.testing.assert_allclose(gradient[0], [0, 0, sign * slope, 0], atol=1e-4)


def test_pull(device):
    p = pair()
    layout = np.array([[4, 4, 0, 3.0], [2, 2, 0, 0.0]])
    anchors = layout + [[0.3, -0.4, 0.1, 0.5], [0, 0, 0, 0]]
    anchors[0, 3] -= 2 * math.pi
    found = energies(p, layout[None], device, weights={**ALONE, "pull": 2.0}, anchors=anchors[None])
    np.testing.assert_allclose(found.share[0], [0.09 + 0.16 + 0.01 + 0.25, 0], atol=1e-5)
    np.testing.assert_allclose(found.soft, found.share)
    np.testing.assert_allclose(found.gradient[0, 0], [-0.6, 0.8, -0.2, -1.0], atol=1e-5)


@pytest.mark.parametrize(("hard", "weight", "soft"), [(True, 1.0, False), (True, 3.0, False), (False, 3.0, True)])
def test_relation_belongs_to_its_subject(device, hard, weight, soft):
    link = {**relation("near", "a", "b", hard=hard, max=1.0), "weight": weight}
    share, mild, gradient = run(pair(relations=[link]), [[4, 4, 0, 0], [6.5, 4.1, 0, 0]], device, relation=1.0)
    factor = weight if hard else 0.2 * weight
    np.testing.assert_allclose(share, [factor * penalty(0.5 + 0.005)[0], 0], rtol=1e-5)
    np.testing.assert_allclose(mild, share if soft else [0, 0])
    np.testing.assert_allclose(gradient[:, :2], [[-factor, 0], [factor, 0]], atol=1e-4)


def test_what_is_carried_along_is_left_to_the_verdict(device):
    """A cup sunk into the table that carries it, and its relation to the table, are no part of the energy."""
    top = {"name": "top", "polygon": centred(0.9, 0.9), "z": 1.0, "headroom": None}
    table = box("table", (1.0, 1.0, 1.0), 4.0, 4.0, surfaces=[top])
    cup = box("cup", (0.1, 0.1, 0.1), 4.0, 4.0, z=1.0, mount="surface", support={"object": "table", "surface": "top"})
    p = problem(table, cup, relations=[relation("left_of", "cup", "table")])
    share, _, gradient = run(p, [[4, 4, 0, 0], [4, 4, 0.5, 0]], device, collision=1.0, relation=1.0)
    assert not share.any() and not gradient.any()


BLOB = [[-0.5, -0.4], [0.4, -0.5], [0.6, 0.1], [0.1, 0.5], [-0.4, 0.3]]


@sizes("count", 60, 250)
@pytest.mark.parametrize("term", ["collision", "zone", "bounds", "opening"])
def test_turned_polygons_agree_with_the_reference(device, term, count):
    """Random poses and yaws of odd shapes, one term at a time; depths of all sizes, some less than the knee."""
    rng = np.random.default_rng(7)
    parts = [{"polygon": BLOB, "z": [0.0, 0.5]}, {"polygon": centred(0.3, 0.9, 0.1), "z": [0.4, 1.0]}]
    corners = [[0.5, -0.5], [1.2, -0.5], [1.2, 0.5], [0.9, 0.5], [0.9, -0.2], [0.5, -0.2]]
    zone = {"name": "L", "polygon": corners, "z": [0.0, 1.0], "hard": True}
    door = {"id": "door", "wall": 0, "offset": 3.0, "width": 1.0, "height": 2.0, "swing": "in-left"}
    both = {"parts": parts, "zones": [zone]}
    p = pair(both, {**both, "mount": "wall"}, outline=L_ROOM, doors=[door])
    spots = {"collision": (2, 2), "zone": (2, 2), "bounds": (4.5, 4.5), "opening": (3.5, 0.5)}
    layouts = rng.normal(size=(count, 2, 4)) * (0.6, 0.6, 0.3, 3.0) + (*spots[term], 0.2, 0.0)
    options = [any_options(p, rng) for _ in layouts]
    tally = compare.check(
        [p], [0] * len(layouts), as_float32(layouts), options, device, weights={**ALONE, term: 1.3}, name=term
    )
    assert tally.active > 0.48 * count
