"""Pictures of homes: the walk, what of other rooms is built for a view, walls with their openings."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import sceneweaver as sw
from sceneweaver.home import Home, HomeDoor, wall_openings
from sceneweaver.render.blocks import finishes_of
from sceneweaver.render.camera import Camera
from sceneweaver.render.home import home_views, render_home, report_parts, shell
from sceneweaver.render.home.overview import overview_camera
from sceneweaver.render.home.walk import Walk, seen, walk_order
from sceneweaver.render.tracing import Quality
from sceneweaver.render.tracing.rays import Triangles
from tests.render.home.homes import flat, house

FAST = Quality(windows=1, lamps=1, bounces=1, suns=1, spacing=2, levels=2, rays=1)


def test_a_walk_begins_at_the_entrance_and_goes_through_doors() -> None:
    home = house()
    stops = walk_order(home)
    assert (stops[0].room, stops[0].door) == ("hall", "front")
    own = [stop.room for stop in stops if stop.onward is None]
    assert sorted(own) == sorted(room.id for room in home.rooms if not room.outdoor)
    for before, stop in zip(stops, stops[1:], strict=False):
        if stop.onward is not None:
            assert before.room == stop.room and stop.onward in {(name, room) for room, name in home.graph()[stop.room]}
    seen = {stops[0].room}
    for stop in stops[1:]:
        assert stop.room == stops[0].room or stop.before in seen
        if stop.door not in (None, "front"):
            door = next(d for d in home.doors if d.id == stop.door)
            assert {door.room, door.to} == {stop.room, stop.before}
        seen.add(stop.room)


def test_views_are_named_in_the_order_of_a_report() -> None:
    views = home_views(house())
    assert list(views)[:4] == ["plan_ground", "plan_upper", "overview_ground", "overview_upper"]
    assert views["walk_01"] == "Hall, from the entrance"
    assert set(report_parts(house())["shows"]) == {name for name in views if name.startswith("walk")}


@pytest.fixture(scope="module")
def walk() -> Walk:
    return Walk(flat())


@pytest.mark.parametrize("number", range(len(walk_order(Home.example("flat")))))
def test_a_walk_looks_from_the_room_or_its_door(walk: Walk, number: int) -> None:
    stop, camera = walk.stops[number], walk.camera(number)
    room = shapely.Polygon(flat().room(stop.room).outline)
    assert room.buffer(0.5).contains(shapely.Point(camera.eye[:2]))
    ahead = np.asarray(camera.eye) + 0.8 * camera.axis
    assert room.contains(shapely.Point(ahead[:2]))
    if stop.onward is not None:
        door = next(d for d in flat().shell(stop.room).doors if d.id == stop.onward[0])
        wall = flat().room(stop.room).walls[door.wall]
        u, v, far = camera.project(np.array([[*wall.point(door.offset + door.width / 2), 1.0]]))[0]
        assert abs(u) < 1 and abs(v) < 1 and far > 0.5


def _triangles(home: Home, storey: str) -> Triangles:
    looks = {room.id: finishes_of(shell.scene_of(home, room)) for room in home.rooms_of(storey)}
    mesh = shell.walls_mesh(home, storey, looks, home.storey(storey).height)
    assert mesh is not None
    return Triangles(mesh.vertices, mesh.faces)


@pytest.mark.parametrize(("home", "storey"), [(Home.example("flat"), "ground"), (house(), "upper")])
def test_walls_stand_but_for_their_openings(home: Home, storey: str) -> None:
    """A level ray through each door passes the wall; beside the door it ends at the paint, over it at the lintel."""
    triangles = _triangles(home, storey)
    for found in wall_openings(home, storey):
        door = found.opening
        if not isinstance(door, HomeDoor):
            continue
        wall = home.room(door.room).walls[door.wall]
        middle = door.offset + door.width / 2
        for at, z, through in (
            (middle, 1.0, True),
            (middle, door.height + 0.1, False),
            (door.offset - 0.05, 1.0, False),
        ):
            eye, ahead = wall.point(at, 0.2), wall.point(at, -5.0)
            hits = triangles.first_hits([Camera.look_at((*eye, z), (*ahead, z), 0.01, 1.0)], 1, 1)
            assert (float(hits.distance[0, 0, 0]) > 0.2 + found.thickness) == through, (door.id, at, z)


def test_an_overview_holds_the_storey() -> None:
    camera = overview_camera(house(), "ground", 4 / 3)
    corners = np.array([(*point, 0.0) for room in house().rooms_of("ground") for point in room.outline])
    u, v, ahead = camera.project(corners).T
    assert (np.abs(u) < 1).all() and (np.abs(v) < 1).all() and (ahead > 0).all()


def test_pictures_are_drawn() -> None:
    home = Home.example("flat")
    pictures = render_home(home, views=["walk_06", "overview_ground"], width=48, height=36, quality=FAST)
    for picture in pictures.values():
        assert picture.size == (48, 36)
        values = np.asarray(picture, dtype=float)
        assert 60 < values.mean() < 235 and values.std() > 8


def test_of_other_rooms_only_those_in_view_are_built() -> None:
    """From its door one sees of the bathroom the bathroom alone; the hall's view goes through open doors."""
    walk = Walk(flat())
    found = {}
    for number in (0, 5):
        room, camera = flat().room(walk.stops[number].room), walk.camera(number)
        near = walk.near(room, camera)
        found[room.id] = set(seen(near, list(walk.building(room, near, camera)), camera))
    assert "hall" not in found["bath"] and "bath" in found["bath"]
    assert {"hall", "bath"} <= found["hall"]


def test_what_cannot_be_drawn_is_said() -> None:
    with pytest.raises(sw.InputError, match="'walk_99' is unknown"):
        render_home(flat(), views=["walk_99"])
    with pytest.raises(sw.InputError, match="too few"):
        render_home(flat(), width=4)
