"""Episodes: ways and goals are what they say, and files are as Habitat's data sets read them."""

import gzip
import json
import math

import numpy as np
import pytest
import shapely

from sceneweaver.home import Home
from sceneweaver.navigation import (
    Roadmap,
    load_episodes,
    object_goal_episodes,
    point_goal_episodes,
    save_episodes,
)
from sceneweaver.navigation.habitat import from_habitat, packed_episodes, rotation_of, to_habitat, yaw_of
from sceneweaver.scene import InputError
from tests.navigation.full import full_flat, largest
from tests.verify.home.homes import bars, flat, house


def test_points_are_on_the_floor_and_the_ways_are_the_shortest():
    home = full_flat()
    roadmap = Roadmap(home)
    found = point_goal_episodes(home, count=20, seed=5, roadmap=roadmap)
    assert len(found.episodes) == 20
    for episode in found.episodes:
        path = roadmap.path(episode.start, episode.goal)
        assert path is not None and path.length == pytest.approx(episode.geodesic, abs=1e-5)
        assert 1.0 <= episode.geodesic <= 30 and episode.geodesic >= episode.euclidean - 1e-6
        assert episode.path[0] == episode.start and episode.path[-1] == episode.goal
        assert largest(roadmap).covers(shapely.Point(episode.start[:2]))


def test_straight_ways_are_left_out_on_request():
    found = point_goal_episodes(full_flat(), count=10, seed=1, least_ratio=1.2)
    assert len(found.episodes) == 10 and all(e.geodesic >= 1.2 * e.euclidean for e in found.episodes)


def test_what_is_not_reached_from_the_entrance_is_in_no_episode():
    found = point_goal_episodes(flat(hall=bars(0.49)), count=10, seed=1, nearest=0.1)
    assert found.episodes and all(e.start[1] < 1.6 and e.goal[1] < 1.6 for e in found.episodes)
    shut = Home.example("flat")
    shut = shut.with_changes(doors=tuple(d for d in shut.doors if d.to is not None))
    assert point_goal_episodes(shut, count=10).episodes == ()


def test_things_are_found_where_they_are_in_reach():
    home = full_flat()
    roadmap = Roadmap(home)
    found = object_goal_episodes(home, count=20, seed=2, categories=["bed", "sofa"], roadmap=roadmap)
    assert set(found.goals) == {"bed", "sofa"} and len(found.goals["sofa"]) == 2 and len(found.episodes) == 20
    for goals in found.goals.values():
        for goal in goals:
            room, name = goal.object.split("/")
            scene = home.room(room).scene
            assert scene is not None
            x, y, _ = scene.object(name).pose.position
            assert goal.position[:2] == (round(x, 6), round(y, 6)) and goal.room == room
            for (vx, vy, _), yaw in goal.views:
                assert math.hypot(vx - x, vy - y) < 2.0
                assert math.cos(yaw - math.atan2(y - vy, x - vx)) > 0.9999
                roadmap.region((vx, vy))
    for episode in found.episodes:
        assert episode.category is not None
        views = [view for goal in found.goals[episode.category] for view, _ in goal.views]
        lengths = [path.length for view in views if (path := roadmap.path(episode.start, view)) is not None]
        assert episode.geodesic == pytest.approx(min(lengths), abs=1e-5)
        assert episode.object in {goal.object for goal in found.goals[episode.category]}


def test_episodes_go_over_stairs():
    found = point_goal_episodes(house(), count=20, seed=0)
    storeys = {(e.start[2], e.goal[2]) for e in found.episodes}
    assert storeys == {(0.0, 0.0), (0.0, 2.7), (2.7, 0.0), (2.7, 2.7)}
    flat_only = point_goal_episodes(house(), count=20, seed=0, roadmap=Roadmap(house(), stairs=False))
    assert all(e.start[2] == e.goal[2] for e in flat_only.episodes)


def test_seeds_decide():
    home = full_flat()
    one, other, third = (point_goal_episodes(home, count=5, seed=seed) for seed in (3, 3, 4))
    assert one == other != third
    assert packed_episodes(one) == packed_episodes(other)


@pytest.mark.parametrize("yaw", [-3.0, -1.0, 0.0, 0.5, 3.1])
def test_the_frame_is_habitats(yaw):
    """y up; an agent looks along -z turned by its quaternion."""
    x, y, z = to_habitat((1.0, 2.0, 3.0))
    assert (x, y, z) == (1.0, 3.0, -2.0) and from_habitat((x, y, z)) == (1.0, 2.0, 3.0)
    _, q, _, w = rotation_of(yaw)
    angle = 2 * math.atan2(q, w)
    looks = (-math.sin(angle), 0.0, -math.cos(angle))  # -z turned about y
    np.testing.assert_allclose(from_habitat(looks), (math.cos(yaw), math.sin(yaw), 0.0), atol=1e-12)
    assert yaw_of(rotation_of(yaw)) == pytest.approx(yaw)


@pytest.mark.parametrize("task", ["pointnav", "objectnav"])
def test_files_have_the_fields_of_habitats_data_sets(task, tmp_path):
    """Those that its classes take as keyword arguments, and no others."""
    make = point_goal_episodes if task == "pointnav" else object_goal_episodes
    made = make(full_flat(), count=4, seed=1)
    save_episodes(made, tmp_path / "all.json.gz", scene="homes/flat.glb")
    data = json.loads(gzip.decompress((tmp_path / "all.json.gz").read_bytes()))
    known = {"episode_id", "scene_id", "start_position", "start_rotation", "info", "goals", "start_room"}
    known |= {"shortest_paths"} | ({"object_category"} if task == "objectnav" else set())
    for episode in data["episodes"]:
        assert set(episode) == known and episode["scene_id"] == "homes/flat.glb"
        assert math.hypot(*episode["start_rotation"]) == pytest.approx(1.0)
        assert episode["info"]["geodesic_distance"] >= 1.0
        assert {frozenset(point) for point in episode["shortest_paths"][0]} == {
            frozenset(("position", "rotation", "action"))
        }
    if task == "objectnav":
        names = data["category_to_task_category_id"]
        assert names == data["category_to_scene_annotation_category_id"]
        for episode in data["episodes"]:
            key = f"flat.glb_{episode['object_category']}"  # Habitat's goals_key
            assert data["goals_by_category"][key]
        for goal in (goal for some in data["goals_by_category"].values() for goal in some):
            assert {"position", "radius", "object_id", "object_category", "view_points"} <= set(goal)
            assert all(set(view) == {"agent_state", "iou"} for view in goal["view_points"])
    read = load_episodes(tmp_path / "all.json.gz")
    assert read.episodes == made.episodes and read.task == task and read.radius == 0.25
    assert dict(read.goals) == dict(made.goals)


def test_files_of_others_are_read(tmp_path):
    """A point goal as Habitat's own data sets have it."""
    episode = {
        "episode_id": "0",
        "scene_id": "data/scene_datasets/gibson/Adrian.glb",
        "start_position": [-1.0, 0.1, 2.0],
        "start_rotation": [0, 0.0, 0, 1.0],
        "info": {"geodesic_distance": 4.5, "difficulty": "easy"},
        "goals": [{"position": [1.0, 0.1, -1.0], "radius": None}],
        "shortest_paths": None,
        "start_room": None,
    }
    (tmp_path / "val.json").write_text(json.dumps({"episodes": [episode]}))
    read = load_episodes(tmp_path / "val.json")
    assert read.home == "Adrian" and read.radius == 0.18
    (one,) = read.episodes
    assert (
        one.start == (-1.0, -2.0, 0.1)
        and one.goal == (1.0, 1.0, 0.1)
        and one.yaw == pytest.approx(math.pi / 2, abs=1e-4)
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[]", "no episodes of Habitat"),
        ('{"episodes": [{}]}', "no episodes of Habitat: KeyError"),
        ("{", "val.json"),
    ],
)
def test_files_that_hold_none_are_refused(text, said, tmp_path):
    (tmp_path / "val.json").write_text(text)
    with pytest.raises(InputError, match=said):
        load_episodes(tmp_path / "val.json")
    with pytest.raises(InputError, match=r"written as \.json\.gz"):
        save_episodes(point_goal_episodes(Home.example("flat"), count=0), tmp_path / "val.json")


@pytest.mark.parametrize("bad", [{"count": -1}, {"nearest": 5.0, "farthest": 1.0}, {"least_ratio": 0.5}])
def test_numbers_out_of_range_are_refused(bad):
    with pytest.raises(InputError, match=next(iter(bad))):
        point_goal_episodes(Home.example("flat"), **bad)
