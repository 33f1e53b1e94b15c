"""Maps as ROS reads them, and the graph of rooms and doors."""

import io
import json

import networkx
import numpy as np
import pytest
import shapely
import yaml
from PIL import Image

from sceneweaver.home import Home
from sceneweaver.navigation import Roadmap, navigation_graph, occupancy_map
from sceneweaver.navigation.maps import FREE, OCCUPIED, UNKNOWN
from sceneweaver.scene import InputError
from tests.navigation.full import full_flat, places
from tests.verify.build import box
from tests.verify.home.homes import bars, flat, house


def test_what_is_free_occupied_and_unknown():
    home = flat(hall=[box("post", (0.4, 0.4, 1.0), 5.4, 3.0), box("lamp", (0.3, 0.3, 0.3), 5.4, 4.5, z=2.0)])
    found = occupancy_map(home)
    for (x, y), value in {
        (5.4, 1.0): FREE,
        (5.4, 3.0): OCCUPIED,
        (5.4, 4.5): FREE,  # under the lamp
        (4.55, 1.0): OCCUPIED,  # a wall
        (4.55, 3.0): FREE,  # the door of the living room
        (0.1, 4.0): OCCUPIED,
        (-0.3, 4.0): UNKNOWN,
    }.items():
        assert found.occupancy[found.cell(x, y)] == value, (x, y)
    labels = {name: k for k, name in enumerate(found.rooms, start=1)}
    assert found.labels[found.cell(5.4, 3.0)] == labels["hall"]  # also under the post
    assert found.labels[found.cell(8.0, 2.0)] == labels["bedroom"] and found.labels[found.cell(4.55, 3.0)] == 0
    assert set(np.unique(found.labels)) == set(range(len(home.rooms) + 1))


def test_areas_are_those_of_the_home():
    home = Home.example("flat")
    found = occupancy_map(home, resolution=0.02)
    for k, room in enumerate(home.rooms, start=1):
        assert (found.labels == k).sum() * 0.02**2 == pytest.approx(shapely.Polygon(room.outline).area, rel=0.01)


def test_navigable_is_where_the_base_gets_to():
    """Behind a gap too narrow nothing is; in front of it the disc is clear of everything."""
    found = occupancy_map(flat(hall=bars(0.49)))
    assert found.navigable[found.cell(5.4, 1.0)] and not found.navigable[found.cell(5.4, 3.0)]
    open_ = occupancy_map(flat(hall=bars(0.51)))
    assert open_.navigable[open_.cell(5.4, 3.0)]
    assert not (open_.navigable & (open_.occupancy != FREE)).any()
    assert occupancy_map(Home.example("flat"), radius=0.5).navigable.sum() < open_.navigable.sum()


def test_the_files_are_those_of_map_server(tmp_path):
    found = occupancy_map(full_flat())
    written = found.save(tmp_path)
    assert sorted(path.name for path in written) == sorted(path.name for path in tmp_path.iterdir())
    about = yaml.safe_load((tmp_path / "map_ground.yaml").read_text())
    assert set(about) == {"image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}
    grey = np.asarray(Image.open(tmp_path / about["image"]))
    # as map_server: the last row of the picture is the first of the grid, and p = (255 - grey) / 255
    p = (255.0 - grey[::-1]) / 255.0
    read = np.where(p > about["occupied_thresh"], OCCUPIED, np.where(p < about["free_thresh"], FREE, UNKNOWN))
    np.testing.assert_array_equal(read, found.occupancy)
    x, y = about["origin"][0] + 20.5 * 0.05, about["origin"][1] + 40.5 * 0.05
    assert found.cell(x, y) == (40, 20)
    rooms = json.loads((tmp_path / "map_ground.rooms.json").read_text())
    labels = np.asarray(Image.open(tmp_path / "map_ground.rooms.png"))[::-1]
    np.testing.assert_array_equal(labels, found.labels)
    assert rooms["1"] == {"id": "hall", "type": "hall"}
    arrays = np.load(tmp_path / "map_ground.npz", allow_pickle=False)
    np.testing.assert_array_equal(arrays["occupancy"], found.occupancy)
    assert arrays["rooms"].tolist() == list(found.rooms) and arrays["radius"] == 0.25


def test_equal_homes_give_equal_bytes():
    one, other = (occupancy_map(full_flat()).files("map") for _ in range(2))
    assert one == other
    assert Image.open(io.BytesIO(one["map.png"])).mode == "L"


def test_each_storey_has_its_map():
    home = house()
    ground, first = (occupancy_map(home, storey) for storey in ("ground", "first"))
    assert ground.rooms == ("well-ground", "room-ground") and first.rooms == ("well-first", "room-first")
    for found in (ground, first):  # the stair is no floor, below nor above
        assert found.occupancy[found.cell(0.5, 3.0)] == OCCUPIED
        assert found.navigable[found.cell(3.0, 2.0)]


@pytest.mark.parametrize(("bad", "said"), [({"resolution": 0.0}, "resolution is 0.0"), ({"storey": "attic"}, "attic")])
def test_bad_input_is_refused(bad, said):
    with pytest.raises(InputError, match=said):
        occupancy_map(Home.example("flat"), **bad)


def test_the_graph_has_rooms_doors_and_lengths():
    home = full_flat()
    roadmap = Roadmap(home)
    graph = navigation_graph(home, roadmap=roadmap)
    assert [room.id for room in graph.rooms] == [room.id for room in home.rooms]
    assert [joint.id for joint in graph.joints] == [door.id for door in home.doors]
    points = {room.id: room.point for room in graph.rooms}
    for joint in graph.joints:
        if joint.rooms[1] is not None:
            here, there = (points[name] for name in joint.rooms if name is not None)
            assert here is not None and there is not None
            path = roadmap.path(here, there)
            assert path is not None and joint.length == pytest.approx(path.length, abs=1e-5)
    assert all(room.reached for room in graph.rooms)
    assert all(length > 0 for *_, length in graph.between_doors)
    assert {row[0] for row in graph.between_doors} == {"hall", "living"}


def test_networkx_reads_the_graph(tmp_path):
    graph = navigation_graph(Home.example("flat"))
    graph.save(tmp_path / "navigation.json")
    read = networkx.node_link_graph(json.loads((tmp_path / "navigation.json").read_text()), edges="edges")
    assert networkx.is_connected(read) and read.number_of_nodes() == 7
    inside = read.subgraph([room.id for room in graph.rooms])
    for a in inside:
        for b in inside:
            way = networkx.shortest_path(inside, a, b, weight="length")
            assert graph.route(a, b) == tuple(way)


def test_a_door_that_is_no_way_is_in_the_graph_as_such():
    home = Home.example("flat")
    doors = [door.model_copy(update={"width": 0.48}) if door.id == "door-bath" else door for door in home.doors]
    graph = navigation_graph(home.with_changes(doors=tuple(doors)))
    assert graph.route("hall", "bath") == () and graph.route("hall", "bedroom") == ("hall", "bedroom")
    assert [room.id for room in graph.rooms if not room.reached] == ["bath"]
    (bath,) = [joint for joint in graph.joints if not joint.passable]
    assert bath.id == "door-bath" and bath.length is None
    stairs = navigation_graph(house())
    (stair,) = [joint for joint in stairs.joints if joint.kind == "stair"]
    assert stair.passable and stair.length is not None and stair.length > 4.4
    assert stairs.route("room-ground", "room-first") == ("room-ground", "well-ground", "well-first", "room-first")


def test_the_point_of_a_room_is_where_a_base_stands():
    home = full_flat()
    roadmap = Roadmap(home)
    for room in navigation_graph(home, roadmap=roadmap).rooms:
        assert room.point is not None
        point, _ = roadmap.region(room.point)
        np.testing.assert_allclose(point, room.point[:2], atol=1e-6)
    assert len(places(roadmap, 3, 0)) == 3
