"""The drawing language: boxes, copies, links, fitting, texture coordinates and components."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sceneweaver.assets.category import categories
from sceneweaver.assets.drawing import Box, Drawing, asset_of
from sceneweaver.assets.drawing import components as c
from sceneweaver.assets.parametric import make
from tests.assets.rules import volume_of


def drawing(name: str = "dresser", seed: int = 1) -> Drawing:
    return Drawing(categories()[name], seed)


@pytest.mark.parametrize("side", ["top", "bottom", "front", "back", "left", "right"])
def test_slabs_inside_and_outside_share_the_side(side: str) -> None:
    box = Box((0.0, 1.0), (-2.0, 2.0), (0.5, 3.0))
    inside, outside = getattr(box, side)(0.1), getattr(box, side)(-0.1)
    assert inside.anchor(side) == pytest.approx(box.anchor(side))
    axis = next(k for k in range(3) if abs(inside.size[k] - 0.1) < 1e-9)
    assert outside.size == pytest.approx(inside.size)
    assert abs(np.subtract(outside.center, inside.center)[axis]) == pytest.approx(0.1)
    assert (inside | box) == box and (outside | box).size[axis] == pytest.approx(box.size[axis] + 0.1)


def test_parts_of_a_split_fill_it_with_gaps() -> None:
    box = Box.sized(1.0, 2.0, 3.0)
    rows = box.rows([1, 2, 1], gap=0.1)
    assert [row.height for row in rows] == pytest.approx([0.7, 1.4, 0.7])
    assert rows[0].z[0] == 0.0 and rows[-1].z[1] == pytest.approx(3.0)
    assert rows[1].z[0] - rows[0].z[1] == pytest.approx(0.1)
    assert box.place(0.1, 0.2, 0.3, at="front left top").anchor("front left top") == box.anchor("front left top")
    assert box.share(z=(0.5, 1.0)) == box.top(1.5)


def test_corners_point_inward_and_stay_closed_bodies() -> None:
    d = drawing()
    with d.corners(Box.sized(1.0, 2.0, 0.0), inset=0.1):
        d.hull([(0, 0, 0), (0.2, 0, 0), (0, 0.1, 0), (0, 0, 0.3)], "oak")
    asset = asset_of(d)
    assert asset.size == pytest.approx((0.8, 1.8, 0.3))
    assert volume_of(asset.mesh) == pytest.approx(4 * 0.2 * 0.1 * 0.3 / 6)  # mirrored faces look outward too
    assert len(asset.hulls) == 4


def test_a_mirrored_door_opens_the_other_way() -> None:
    d = drawing()
    with d.mirror("y"):
        c.door(d, "door", Box((0.2, 0.22), (0.01, 0.4), (0.0, 0.7)), "oak", "brass", "left")
        d.surface("shelf", Box((0.0, 0.2), (0.1, 0.3), (0.0, 0.1)))
    one, other = d.drawn.links
    assert (one.name, other.name) == ("door", "door-1")
    # A point of the leaf far from the hinge goes to the front when either door opens.
    for link, y in ((one, 0.05), (other, -0.05)):
        arm = np.array([0.22, y, 0.0]) - np.array(link.anchor)
        speed = np.cross(np.array(link.axis) * (link.limits[1] or link.limits[0]), arm)
        assert speed[0] > 0.1, link.name
    areas = [np.array(s.polygon) for s in d.drawn.surfaces]
    for ring in areas:
        x, y = ring.T
        assert np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)) > 0  # counter-clockwise both
    assert areas[0][:, 1].min() > 0 > areas[1][:, 1].max()


def test_copies_inside_a_link_move_with_it() -> None:
    d = drawing()
    with d.slide("drawer"), d.along((0.0, -0.3, 0.1), (0.0, 0.3, 0.1), 4):
        d.box(Box.sized(0.02, 0.02, 0.02), "oak")
    assert len(d.drawn.links) == 1 and {piece.link for piece in d.drawn.pieces} == {1}
    ys = sorted(float(piece.placed[:, 1].mean()) for piece in d.drawn.pieces)
    assert ys == pytest.approx([-0.3, -0.1, 0.1, 0.3])


def test_rings_and_grids_stand_where_they_should() -> None:
    d = drawing()
    with d.ring(6, radius=0.5):
        d.box(Box((0.0, 0.1), (-0.01, 0.01), (0.0, 0.1)), "oak")
    far = [np.linalg.norm(piece.placed[:, :2], axis=1).max() for piece in d.drawn.pieces]
    assert far == pytest.approx([math.hypot(0.6, 0.01)] * 6, abs=1e-3)
    d = drawing()
    with d.grid(Box.sized(1.0, 2.0, 1.0), x=2, y=4, z=1):
        d.ball(Box.sized(0.1, 0.1, 0.1), "oak")
    middles = {tuple(np.round(piece.placed.mean(axis=0)[:2], 3) + 0.0) for piece in d.drawn.pieces}
    assert middles == {(x, y) for x in (-0.25, 0.25) for y in (-0.75, -0.25, 0.25, 0.75)}


def test_fit_stretches_surfaces_zones_hinges_and_travels() -> None:
    d = drawing()
    case = Box.sized(0.5, 1.0, 1.0)
    d.box(case, "oak", bevel=0.0)
    d.surface("top", case, headroom=0.2)
    d.zone("front", (0.25, 0.75), (-0.5, 0.5), (0.0, 1.0))
    c.drawer(d, "drawer", case.front(0.3).bottom(0.2), "oak", "brass", "none", travel=0.2)
    with d.hinge("lid", (0.0, 0.5, 1.0), axis=(0.0, 1.0, 1.0)):
        d.box(case.top(-0.02), "oak", bevel=0.0)
    d.fit((1.0, 3.0, 2.04))
    (surface,), (zone,), (slide, lid) = d.drawn.surfaces, d.drawn.zones, d.drawn.links
    assert np.ptp(np.array(surface.polygon), axis=0) == pytest.approx((1.0, 3.0))
    assert surface.z == pytest.approx(2.0) and surface.headroom == pytest.approx(0.4)
    assert zone.z == pytest.approx((0.0, 2.0)) and max(x for x, _ in zone.polygon) == pytest.approx(1.5)
    assert slide.limits == pytest.approx((0.0, 0.4))
    assert lid.anchor == pytest.approx((0.0, 1.5, 2.0)) and lid.limits == (0.0, 1.57)
    assert lid.axis == pytest.approx(np.array([0.0, 3.0, 2.0]) / math.hypot(3.0, 2.0))


def test_a_drawer_holds_what_falls_into_it() -> None:
    d = drawing()
    room = c.drawer(d, "drawer", Box.sized(0.5, 0.8, 0.2), "oak", "brass")
    x, y, _ = room.center
    below = [h for h in d.drawn.hulls if h.vertices[:, 2].max() <= room.z[0] + 1e-9]
    assert any(
        h.vertices[:, 0].min() < x < h.vertices[:, 0].max() and h.vertices[:, 1].min() < y < h.vertices[:, 1].max()
        for h in below
    )
    for side in ("front", "back", "left", "right"):
        point = np.array(room.anchor(side)) + 0.005 * np.sign(np.subtract(room.anchor(side), room.center))
        assert any(((h.vertices.min(axis=0) <= point) & (point <= h.vertices.max(axis=0))).all() for h in d.drawn.hulls)
    assert min(room.size) > 0.1


def test_texture_coordinates_are_metres_along_the_grain() -> None:
    d = drawing()
    d.box(Box.sized(0.02, 1.5, 0.1), "oak", bevel=0.0)  # a board along y
    with d.at(0.3, 0.2, 0.5, yaw=0.7, roll=0.4):
        d.box(Box.sized(0.8, 0.05, 0.05), "oak", bevel=0.0)
    mesh = asset_of(d).mesh
    assert mesh.uv is not None and mesh.uv.shape == (len(mesh.faces), 3, 2) and mesh.uv.dtype == np.float32
    corners = mesh.vertices[mesh.faces]
    for a, b in ((0, 1), (1, 2), (2, 0)):  # lengths on the texture are lengths on the body
        seen = np.linalg.norm(mesh.uv[:, a] - mesh.uv[:, b], axis=1)
        assert seen == pytest.approx(np.linalg.norm(corners[:, a] - corners[:, b], axis=1), abs=1e-5)
    first = np.ptp(mesh.uv[:12].reshape(12, 3, 2), axis=1).max(axis=0)
    assert first[0] == pytest.approx(1.5, abs=1e-5) and first[1] <= 0.1 + 1e-5


def test_a_sheet_is_laid_out_along_its_cloth() -> None:
    d = drawing()
    c.curtain(d, Box((-0.1, 0.1), (-0.5, 0.5), (0.0, 2.0)), "navy fabric", folds=6)
    mesh = asset_of(d).mesh
    assert mesh.uv is not None
    fall, width = np.ptp(mesh.uv.reshape(-1, 2), axis=0)
    assert fall == pytest.approx(2.0, abs=0.02) and width > 1.5  # one metre of window takes more cloth than that


def test_the_tree_names_its_parts() -> None:
    d = drawing()
    with d.part("case"), d.at(z=0.5, yaw=math.pi / 2), d.part("top") as top:
        d.box(Box.sized(0.4, 1.0, 0.02), "oak")
    assert top.bounds.size == pytest.approx((0.4, 1.0, 0.02)) and top.bounds.z[0] == pytest.approx(0.0)
    assert list(d.root.lines()) == [
        "dresser: " + " x ".join(f"{v:.3f}" for v in d.size),
        "  case: 1.000 x 0.400 x 0.020",
        "    top: 0.400 x 1.000 x 0.020",
    ]


@pytest.mark.parametrize(
    "style", ["square", "round", "tapered", "splayed", "turned", "hairpin", "sled", "panel", "trestle"]
)
def test_legs_fill_their_height_inside_their_place(style: str) -> None:
    d = drawing()
    with d.part("legs") as part:
        c.legs(d, Box((0.1, 0.9), (-0.3, 1.2), (0.2, 0.9)), "oak", style)
    assert part.bounds.z == pytest.approx((0.2, 0.9), abs=2e-3)
    assert part.bounds.x[0] >= 0.1 - 1e-6 and part.bounds.x[1] <= 0.9 + 1e-6
    assert part.bounds.y[0] >= -0.3 - 1e-6 and part.bounds.y[1] <= 1.2 + 1e-6


def test_what_is_no_drawing_is_refused() -> None:
    with pytest.raises(ValueError, match="no legs of style spaghetti"):
        c.legs(drawing(), Box.sized(1, 1, 1), "oak", "spaghetti")
    d = drawing()
    with pytest.raises(ValueError, match="a link inside a link"), d.slide("a"), d.hinge("b", (0, 0, 0)):
        pass
    with pytest.raises(ValueError, match="a box needs room"):
        d.box(Box((0, 0), (0, 1), (0, 1)), "oak")


def test_a_vessel_stays_open_and_castors_stand_in_their_corners() -> None:
    d = drawing()
    box = Box.sized(0.6, 1.0, 0.4)
    outer = [c.oval(box.inset(x=0.05, y=0.05), 0.0, 4.0), c.oval(box, 0.4, 4.0)]
    inner = [c.oval(box.inset(x=0.03, y=0.03), 0.4, 4.0), c.oval(box.inset(x=0.1, y=0.1), 0.03, 4.0)]
    c.vessel(d, outer, inner, "white ceramic")
    c.castors(d, box.bottom(-0.08).move(z=0.08))
    asset = asset_of(d)
    assert asset.size == pytest.approx((0.6, 1.0, 0.4), abs=1e-6)
    within = np.array([0.0, 0.0, 0.2])
    for hull in asset.hulls:  # the middle of the room inside lies in no part
        corners = hull.vertices[hull.faces]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.einsum("ij,ij->i", within - corners[:, 0], normal).max() > 0
    wall = volume_of(asset.mesh)
    assert 0.02 < wall < 0.35 * 0.6 * 1.0 * 0.4


def test_shapes_by_shares_fill_their_box() -> None:
    d = drawing()
    box = Box((0.1, 0.5), (-0.3, 0.3), (0.2, 0.9))
    with d.part("turned") as turned:
        d.turned(box, [(0.5, 0.0), (1.0, 0.4), (0.7, 1.0)], "oak")
    with d.part("sections") as sections:
        d.sections(box, [(0.6, 0.8, 0.0), (1.0, 1.0, 0.5), (0.4, 0.3, 1.0, 0.1, 0.0)], "oak", radius=0.2)
    for part in (turned, sections):
        assert np.concatenate([part.bounds.x, part.bounds.y, part.bounds.z]) == pytest.approx(
            [*box.x, *box.y, *box.z], abs=0.005
        )


def test_what_lies_inside_others_has_no_colliders() -> None:
    d = drawing()
    box = d.ball(Box.sized(0.1, 0.1, 0.1), "oak")
    with d.no_colliders():
        d.box(box.inset(0.02), "brass")
        d.turned(box.inset(0.02), [(1.0, 0.0), (1.0, 1.0)], "brass")
        d.bar((0, 0, 0.02), (0, 0, 0.08), 0.01, "brass")
    d.box(box, "oak")
    assert len(d.drawn.pieces) == 5 and len(d.drawn.hulls) == 2


def test_a_table_of_bodies_says_forms_copies_and_labels() -> None:
    from sceneweaver.assets.parametric.families.pieces import draw

    d = drawing()
    draw(
        d,
        "form: only; a: oak, walnut; b: brass\nturned a .5 .5 .4 0 .5 .5 .4 .8\nwrap b .1 .3\n"
        "=only box b .4 .6 .4 .6 .8 1\n=other box a 0 1 0 1 0 1\n"
        "^y *2 .2 0 0 box b .3 .4 .8 1 0 .1; .3 .4 .8 1 .2 .3\nsurface top .4 .6 .4 .6 1",
    )
    pieces = d.drawn.pieces
    assert [piece.material.name for piece in pieces[1:]] == ["brass"] * 10
    assert len(d.drawn.hulls) == 1 + 1 + 8  # the label has none
    assert [s.name for s in d.drawn.surfaces] == ["top"]
    left = [piece.placed[:, 1].mean() > 0 for piece in pieces[3:]]
    assert left.count(True) == 4
    assert asset_of(d).size == pytest.approx(d.size, abs=1e-4)


@pytest.mark.parametrize(
    ("category", "name", "covered"),
    [
        ("wall_cabinet", "opening", False),
        ("laundry_hamper", "opening-top", False),
        ("dresser", "opening", True),
        ("chest", "opening-top", False),
    ],
)
def test_zones_keep_free_what_opens(category, name, covered):
    """What doors and lids sweep is in a zone, of their own where the access zone does not have it."""
    asset = make(category, 0)
    found = {zone.name: zone for zone in asset.zones}
    assert (name not in found) == covered
    if covered:
        return
    zone = found[name]
    d, w, h = asset.size
    xy = np.array(zone.polygon)
    assert zone.hard and np.abs(xy[:, 1]).max() <= w / 2 + 1e-3
    if name == "opening":
        assert xy[:, 0].min() == pytest.approx(d / 2, abs=1e-3)
        widths = [np.ptp(np.concatenate([k.vertices for k in asset.hulls if k.link == n])[:, 1]) for n in (1, 2)]
        assert np.ptp(xy[:, 0]) > 0.9 * max(widths) - 0.03  # a door that stands open
    else:
        assert zone.z[0] == pytest.approx(h) and zone.z[1] > h + 0.2
