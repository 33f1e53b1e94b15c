"""Walls, floors and stairs of homes as bodies: what is solid, by points; pieces of plans, by shapely."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from sceneweaver.export.home.built import BuiltHome
from sceneweaver.export.home.meshes import by_material
from sceneweaver.export.home.pieces import convex_pieces, plan_of, slab_of, standing
from sceneweaver.home import Home, HomeDoor, HomeWindow, wall_openings, wall_polygons
from sceneweaver.physics.enclosure import Standing
from tests.export.home.homes import flat, house, slanted

HOMES = {"flat": flat, "house": house, "slanted": slanted}


def inside(body: Standing, points: np.ndarray) -> np.ndarray:
    """Whether points [N, 3] are in a body but its panes."""
    c, s = math.cos(body.yaw), math.sin(body.yaw)
    local = points - body.position
    local[:, :2] = local[:, :2] @ np.array([[c, -s], [s, c]])
    found = np.zeros(len(points), dtype=bool)
    for slab in body.slabs:
        if slab.pane:
            continue
        box = (np.abs(local - slab.centre) < slab.half).all(axis=1)
        if slab.points is not None:
            box &= shapely.contains_xy(shapely.MultiPoint(slab.points[:, :2]).convex_hull, *local[:, :2].T)
        found |= box
    return found


def within(bodies: list[Standing], points: np.ndarray) -> np.ndarray:
    """In how many bodies points [N, 3] are."""
    return np.sum([inside(body, points) for body in bodies], axis=0)


@pytest.mark.parametrize("name", HOMES)
def test_walls_are_solid_but_for_their_openings(name) -> None:
    """Of random points, those in walls and in no opening are in exactly one body; the others in none."""
    home = HOMES[name]()
    built = BuiltHome.of(home)
    rng = np.random.default_rng(3)
    for plan, bodies in zip(built.plans, built.walls, strict=True):
        walls = shapely.union_all(wall_polygons(home, plan.storey.id))
        x0, y0, x1, y1 = walls.bounds
        points = rng.uniform((x0, y0, plan.low), (x1, y1, plan.high), (20_000, 3))
        wanted = shapely.contains_xy(walls, *points[:, :2].T)
        for opening in wall_openings(home, plan.storey.id):
            thing = opening.opening
            low = plan.low + (thing.sill if isinstance(thing, HomeWindow) else 0.0)
            here = shapely.contains_xy(shapely.Polygon(opening.corners), *points[:, :2].T)
            wanted &= ~(here & (points[:, 2] > low) & (points[:, 2] < low + thing.height))
        count = within(bodies, points)
        pockets = shapely.union_all([p.plan for p in plan.pockets.values()])
        sure = ~shapely.contains_xy(pockets, *points[:, :2].T)
        assert (count[sure] == wanted[sure]).all()
        assert wanted.sum() > 1000


def test_a_wall_between_two_rooms_is_there_once() -> None:
    """The bodies take as much room as the plan of the walls, less the openings and the pocket."""
    home = flat()
    bodies = BuiltHome.of(home).walls[0]
    volume = sum(8 * float(np.prod(s.half)) for body in bodies for s in body.slabs if not s.pane)
    wanted = 2.7 * shapely.union_all(wall_polygons(home, "ground")).area
    wanted -= sum(o.thickness * o.opening.width * o.opening.height for o in wall_openings(home, "ground"))
    assert 0.05 < wanted - volume < 0.2  # the pocket of the sliding door: 0.06 m x 1.1 m x 2 m


def test_bodies_of_one_storey_do_not_reach_into_each_other() -> None:
    for home in (flat(), house(), house("u"), house("l")):
        boxes = [(b.name, s) for b in BuiltHome.of(home).standing for s in b.slabs if not s.pane]
        low = np.array([s.centre - s.half for _, s in boxes])
        high = np.array([s.centre + s.half for _, s in boxes])
        over = np.minimum(high[:, None], high) - np.maximum(low[:, None], low)
        shared = np.prod(np.clip(over, 0, None), axis=2)
        np.fill_diagonal(shared, 0.0)
        stairs = np.array([":stair:" in name for name, _ in boxes])  # treads reach below those before them
        shared[np.ix_(stairs, stairs)] = 0.0
        assert shared.max() < 1e-6, [boxes[k][0] for k in np.unravel_index(shared.argmax(), shared.shape)]


def test_one_can_walk_up_the_stairs_and_out_on_the_landing() -> None:
    """Above each tread there is air for 1.9 m, and after the last one the floor of the upper storey."""
    for shape in ("straight", "u", "l"):
        home = house(shape)
        built = BuiltHome.of(home)
        treads = sorted((b for b in built.fixed if ":stair:" in b.name), key=lambda b: b.slabs[0].centre[2])
        tops = [b.slabs[0].centre[2] + b.slabs[0].half[2] for b in treads]
        rise = 3.0 / home.stairs[0].risers
        assert np.allclose(np.diff([0.0, *tops, 3.0]), rise)
        for body, top in zip(treads, tops, strict=True):
            x, y = body.slabs[0].centre[:2]
            points = np.column_stack([np.full(40, x), np.full(40, y), np.linspace(top + 0.01, top + 1.9, 40)])
            assert not any(inside(other, points).any() for other in built.standing)
        floor = shapely.union_all([plan_of(b) for b in built.fixed if ":floor:up:" in b.name])
        assert floor.distance(plan_of(treads[-1])) < 1e-6
        assert floor.intersection(shapely.union_all([plan_of(b) for b in treads])).area < 1e-6


def test_a_balcony_has_a_railing_and_no_ceiling() -> None:
    home = house()
    built = BuiltHome.of(home)
    rails = [b for b in built.fixed if ":railing:balcony" in b.name]
    assert rails
    for body in rails:
        assert body.slabs[0].centre[2] - body.slabs[0].half[2] == pytest.approx(3.0)
        assert body.slabs[0].half[2] == pytest.approx(0.5)
    balcony = shapely.Polygon(home.room("balcony").outline)
    around = shapely.union_all([plan_of(b) for b in rails])
    assert around.intersection(balcony).area < 1e-9
    ceilings = shapely.union_all([plan_of(b) for b in built.fixed if ":ceiling:" in b.name])
    assert ceilings.intersection(balcony).area < 1e-9
    floors = shapely.union_all([plan_of(b) for b in built.fixed if ":floor:up" in b.name])
    assert balcony.difference(floors).area < 1e-6


@pytest.mark.parametrize("name", HOMES)
def test_what_is_seen_of_walls_is_what_collides(name) -> None:
    """A closed mesh, on whose faces the bodies end: a little before each face is air, a little behind it is wall."""
    built = BuiltHome.of(HOMES[name]())
    for plan, bodies in zip(built.plans, built.walls, strict=True):
        mesh = next(p.mesh for p in built.parts if p.name == f"home:walls:{plan.storey.id}")
        corners = mesh.vertices[mesh.faces]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.abs(normal.sum(axis=0)).max() < 1e-9
        area = np.linalg.norm(normal, axis=1)
        seen = (area > 1e-3) & (corners[:, :, 2].min(axis=1) > plan.low - 1e-6)
        share = np.random.default_rng(1).dirichlet((1, 1, 1), seen.sum())  # no point between two bodies, as middles are
        middle, way = np.einsum("fk,fkx->fx", share, corners[seen]), normal[seen] / area[seen, None]
        before = within(bodies, middle + 2e-3 * way)
        behind = within(bodies, middle - 2e-3 * way)
        assert (before == 0).all()
        above = (middle - 2e-3 * way)[:, 2] > plan.low  # the floor of a pocket has the foundation below it
        assert (behind[above] == 1).all()


def test_each_room_sees_its_own_paint() -> None:
    home = flat()
    finish = {"walls": "sage", "floor": {"material": "wood"}}
    scene = home.room("bath").scene
    assert scene is not None
    painted = scene.model_copy(update={"room": type(scene.room)(**{**scene.room.model_dump(), "finish": finish})})
    built = BuiltHome.of(home.with_scene("bath", painted))
    mesh = next(p.mesh for p in built.parts if p.name == "home:walls:ground")
    by_name = {part.materials[0].name: part for part in by_material(mesh)}
    assert set(by_name) == {"outer wall", "wall paint", "sage wall"}
    points = by_name["sage wall"].vertices[:, :2]
    bath = np.asarray(home.room("bath").outline)
    assert (np.abs(points[:, None] - bath).min(axis=1) < 1.7).all()
    off = np.array([shapely.Polygon(bath).exterior.distance(shapely.Point(p)) for p in points])
    assert off.max() < 2e-3
    outside = by_name["outer wall"].vertices
    x0, y0, x1, y1 = shapely.union_all(wall_polygons(home, "ground")).bounds
    edge = np.minimum(np.abs(outside[:, 0:1] - (x0, x1)).min(axis=1), np.abs(outside[:, 1:2] - (y0, y1)).min(axis=1))
    assert edge.max() < 1e-6


def test_ceilings_are_seen_from_below_only() -> None:
    for part in BuiltHome.of(house()).parts:
        if part.kind == "ceiling":
            corners = part.mesh.vertices[part.mesh.faces]
            normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            assert (normal[:, 2] < 0).all()


def test_leaves_hang_where_the_plan_says() -> None:
    """Closed, a leaf fills its opening; open, it stands in the room into which it opens, on the side of its hinge."""
    home = flat()
    for leaf in BuiltHome.of(home).leaves[0]:
        door = next(d for d in home.doors if d.id == leaf.door)
        opening = next(o for o in wall_openings(home, "ground") if o.opening.id == door.id)
        hole = shapely.Polygon(opening.corners)
        x, y = leaf.position[:2]
        (cx, cy, _), (hx, hy, _) = leaf.boxes[0]

        def plan(turn: float, shift: float, at=(x, y), box=((cx, cy), (hx, hy)), yaw=leaf.yaw):
            c, s = math.cos(yaw + turn), math.sin(yaw + turn)
            (a, b), (u, v) = box
            corners = [(a + shift + i * u, b + k * v) for i, k in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            return shapely.Polygon([(at[0] + c * p - s * q, at[1] + s * p + c * q) for p, q in corners])

        closed = plan(0.0, 0.0)
        assert closed.difference(hole.buffer(1e-6)).area < 1e-9
        if leaf.joint == "slide":
            slid = plan(0.0, leaf.limits[1])
            assert slid.intersection(hole).area < 0.15 * closed.area
            continue
        open_ = plan(leaf.axis[2] * leaf.limits[1], 0.0)
        room = shapely.Polygon(home.room(door.opens_into or door.room).outline)
        assert room.buffer(1e-3).contains(open_)
        assert leaf.limits[1] == pytest.approx(math.pi / 2, abs=1e-3)


def test_a_door_out_of_the_home_swings_out() -> None:
    home = house()
    leaf = next(leaf for leaves in BuiltHome.of(home).leaves for leaf in leaves if leaf.door == "front")
    # The wall runs along x and the hall lies north of it: who goes out has the far end at the left.
    assert leaf.position[:2] == pytest.approx((home.room("hall").outline[0][0] + 2.4 - 0.0039, 0.0), abs=1e-3)
    assert math.cos(leaf.yaw) == pytest.approx(-1.0)
    assert leaf.axis[2] == 1.0  # from there its free end goes south


def test_a_leaf_that_slides_goes_into_the_wall_that_has_room() -> None:
    home = flat()
    moved = [
        d.model_copy(update={"offset": at, "id": f"door-{at}"})
        for d in home.doors
        if d.id == "door-kitchen"
        for at in (0.0, 3.0)
    ]
    for door in moved:
        plan = BuiltHome.of(Home(id="h", rooms=_bare(home), doors=(door,))).plans[0]
        pocket = plan.pockets[door.id]
        assert pocket.far == (door.offset > 1)
        assert plan.walls.buffer(2e-3).contains(pocket.plan)
        assert isinstance(plan.openings[0].opening, HomeDoor)


def _bare(home: Home):
    return tuple(room.model_copy(update={"scene": None}) for room in home.rooms)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000), st.booleans())
def test_convex_pieces_are_the_plan(seed, straight) -> None:
    rng = np.random.default_rng(seed)
    if straight:
        boxes = rng.integers(0, 8, (6, 2, 2))
        plan = shapely.union_all([shapely.box(*np.sort(b, axis=0).reshape(-1)) for b in boxes])
        plan = plan.difference(shapely.box(3, 3, 4, 5))
    else:
        points = np.concatenate([rng.uniform(0, 5, (8, 2))])
        order = np.argsort(np.arctan2(*(points - points.mean(axis=0)).T))
        plan = shapely.Polygon(points[order]).buffer(0)
    pieces = convex_pieces(plan)
    shapes = [shapely.Polygon(piece) for piece in pieces]
    assert shapely.union_all(shapes).symmetric_difference(plan).area < 1e-6 if shapes else plan.area < 1e-4
    assert sum(s.area for s in shapes) == pytest.approx(plan.area, abs=1e-4)
    for piece, shape in zip(pieces, shapes, strict=True):
        assert shape.exterior.is_ccw
        assert shape.convex_hull.area - shape.area < 1e-9
        assert not straight or len(piece) == 4


@pytest.mark.parametrize("turn", [0.0, 0.3, math.pi / 2, 2.5])
def test_a_rectangle_is_a_box_in_any_direction(turn) -> None:
    c, s = math.cos(turn), math.sin(turn)
    corners = np.array([(0, 0), (2, 0), (2, 0.3), (0, 0.3)]) @ np.array([[c, s], [-s, c]]) + (1.0, -2.0)
    slab, yaw = slab_of(corners, 0.5, 1.5)
    assert slab.points is None
    assert sorted(slab.half) == pytest.approx([0.15, 0.5, 1.0])
    body = standing("b", corners, (0.5, 1.5))
    assert body.yaw == yaw
    assert plan_of(body).symmetric_difference(shapely.Polygon(corners)).area < 1e-9
    slab, yaw = slab_of(corners[:3], 0.5, 1.5)
    assert yaw == 0.0
    assert slab.points is not None
    assert len(slab.points) == 6
