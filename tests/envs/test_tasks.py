"""Tasks on states that are made for them: done and just not done, potentials that grow, what a room offers to whom."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sceneweaver import envs
from sceneweaver.envs.geometry import grasps_of
from sceneweaver.envs.predicates import to_world
from sceneweaver.envs.sampling import task_named
from sceneweaver.envs.world import RoomState
from sceneweaver.scene import InputError, Pose, Scene, SceneObject, Support
from tests.envs.rooms import kitchen, load

GLASS, TABLE, FRIDGE = "drinking_glass-0", "dining_table-0", "fridge-0"
AWAY = np.array([0.0, 0.0, 3.0, 1.0, 0, 0, 0])  # of the tool


@pytest.fixture(scope="module")
def geometry() -> envs.SceneGeometry:
    return envs.SceneGeometry(kitchen(), load)


@pytest.fixture(scope="module")
def begun(geometry) -> RoomState:
    """The room as it is, everything closed, the hand far from everything."""
    place = dict(zip(kitchen().ids, envs.poses_of(kitchen()), strict=True))
    bodies = {name: place[owner] for name, owner in geometry.owner.items()}
    return RoomState(bodies, dict.fromkeys(geometry.articulations, 0.0), AWAY, np.array([2.0, 1.0, 0.0]))


def with_glass(geometry: envs.SceneGeometry, state: RoomState, middle, tool=AWAY[:3]) -> RoomState:
    """The state with the glass upright, the middle of its box somewhere, and the tool elsewhere."""
    pose = np.array([*(np.asarray(middle) - geometry.items[GLASS].centre), 1.0, 0, 0, 0])
    return replace(state, bodies={**state.bodies, GLASS: pose}, tool=np.array([*tool, 1.0, 0, 0, 0]))


def tasks(geometry: envs.SceneGeometry, begun: RoomState, robot: envs.Robot) -> list[envs.Task]:
    return envs.tasks_of(geometry, robot, dict(begun.bodies))


def of_kind(geometry, begun, kind):
    return next(t for t in tasks(geometry, begun, envs.mobile_manipulator()) if type(t) is kind)


@pytest.mark.parametrize("kind", [envs.PutIn, envs.PutOn])
def test_a_thing_is_put_when_it_is_there_and_the_hand_is_away(geometry, begun, kind):
    task = of_kind(geometry, begun, kind)
    goal = task.goal(geometry, begun)
    done = with_glass(geometry, begun, goal)
    assert task.subject == GLASS and not task.success(geometry, begun, begun)
    assert task.success(geometry, done, begun)
    assert not task.success(geometry, with_glass(geometry, begun, goal, tool=goal), begun), "still in the hand"
    for off in ((0, 0, 0.4), (3.0, 0, 0)):
        assert not task.success(geometry, with_glass(geometry, begun, goal + off), begun)
    near = with_glass(geometry, begun, goal + [0.1, 0, 0.1], tool=goal)
    assert task.potential(geometry, near, begun) > task.potential(geometry, begun, begun)


def test_on_a_surface_means_on_its_level(geometry, begun):
    task = of_kind(geometry, begun, envs.PutOn)
    goal = task.goal(geometry, begun)
    for rise, done in ((0.019, True), (0.021, False), (-0.021, False)):
        assert task.success(geometry, with_glass(geometry, begun, goal + [0, 0, rise]), begun) == done
    lying = replace(begun, bodies={**begun.bodies, GLASS: np.array([*goal, np.sqrt(0.5), np.sqrt(0.5), 0, 0])})
    bottom = lying.bodies[GLASS][2] - geometry.items[GLASS].size[1] / 2
    down = replace(lying, bodies={**lying.bodies, GLASS: lying.bodies[GLASS] - [0, 0, bottom - goal[2], 0, 0, 0, 0]})
    low = goal[2] - geometry.items[GLASS].size[2] / 2
    flat = replace(down, bodies={**down.bodies, GLASS: down.bodies[GLASS] + [0, 0, low - goal[2], 0, 0, 0, 0]})
    assert task.success(geometry, flat, begun), "what lies there is there as well"


def test_a_thing_is_taken_when_it_is_up_and_in_the_hand(geometry, begun):
    task, centre = envs.Take(GLASS), to_world(begun.bodies[GLASS], geometry.items[GLASS].centre)
    for rise, tool, done in ((0.11, 0.11, True), (0.09, 0.09, False), (0.11, 1.5, False)):
        now = with_glass(geometry, begun, centre + [0, 0, rise], tool=centre + [0, 0, tool])
        assert task.success(geometry, now, begun) == done
    assert task.goal(geometry, begun) == pytest.approx(centre + [0, 0, 0.1])


@pytest.mark.parametrize(("share", "opened", "closed"), [(0.0, False, True), (0.5, False, False), (0.95, True, False)])
def test_doors_are_open_or_closed_by_their_share(geometry, begun, share, opened, closed):
    for name, door in geometry.articulations.items():
        now = replace(begun, joints={**begun.joints, name: share * door.open_end})
        assert envs.Open(name).success(geometry, now, begun) == opened
        assert envs.Close(name).success(geometry, now, begun) == closed
        assert envs.Close(name).start_joints(geometry) == {name: pytest.approx(0.7 * door.open_end)}
        gain = envs.Open(name).potential(geometry, now, begun) - envs.Open(name).potential(geometry, begun, begun)
        assert gain == pytest.approx(min(share, 0.9)), "the hand has not moved"


def test_a_base_goes_near_and_looks(geometry, begun):
    task = envs.NavigateTo(TABLE)
    item, pose = geometry.items[TABLE], begun.bodies[TABLE]
    edge = to_world(pose, np.array([item.low[0], item.centre[1], 0.0]))
    for gap, yaw, done in ((0.6, 0.0, True), (0.8, 0.0, False), (0.6, np.pi, False)):
        assert task.success(geometry, replace(begun, base=np.array([edge[0] - gap, edge[1], yaw])), begun) == done


def test_a_room_is_tidy_when_all_is_home(geometry, begun):
    home = envs.Tidy((envs.PutOn(GLASS, "kitchen_counter-0", kitchen().objects[-1].support.surface),))
    assert home.success(geometry, begun, begun) and home.scattered == (GLASS,)
    floor = with_glass(geometry, begun, (2.0, 2.0, 0.1))
    assert not home.success(geometry, floor, begun)
    assert home.potential(geometry, floor, begun) < home.potential(geometry, begun, begun) == 0.0


def test_a_room_offers_what_a_robot_can_do(geometry, begun):
    def kinds(robot: envs.Robot) -> set[type]:
        return {type(task) for task in tasks(geometry, begun, robot)}

    mobile = envs.mobile_manipulator()
    everything = {envs.Open, envs.Close, envs.PutIn, envs.PutOn, envs.Take, envs.NavigateTo, envs.Tidy}
    assert kinds(mobile) == everything
    assert kinds(envs.fixed_arm()) == everything - {envs.NavigateTo, envs.Tidy}, "it does not drive"
    assert kinds(replace(mobile, payload=0.0)) == {envs.Open, envs.Close, envs.NavigateTo}, "it lifts nothing"
    assert kinds(replace(mobile, heights=(5.0, 6.0))) == {envs.NavigateTo}, "it reaches nothing"


def test_only_what_a_hand_closes_around_has_grasps(geometry):
    assert grasps_of(geometry, TABLE) == []
    found = grasps_of(geometry, GLASS)
    assert found and all(g.width < 0.08 and g.body == GLASS for g in found)
    assert all(abs(g.approach @ g.closing) < 1e-9 for g in found)


def lived_in() -> Scene:
    """The kitchen with one more glass, in the middle of its table."""
    scene = kitchen()
    table, glass = scene.objects[3], scene.objects[4]
    top = next(s for s in table.surfaces if s.name == "top")
    x, y, _ = table.pose.position
    support = Support(object=table.id, surface=top.name)
    other = glass.model_copy(
        update={"id": "drinking_glass-1", "pose": Pose.from_yaw(x, y, top.z, 0.0), "support": support}
    )
    return scene.model_copy(update={"objects": (*scene.objects, other)})


def of_scene(scene: Scene, robot: envs.Robot | None = None) -> tuple[envs.SceneGeometry, dict, list[envs.Task]]:
    geometry = envs.SceneGeometry(scene, load)
    place = dict(zip(scene.ids, envs.poses_of(scene), strict=True))
    poses = {name: place[owner] for name, owner in geometry.owner.items()}
    return geometry, poses, envs.tasks_of(geometry, robot or envs.mobile_manipulator(), poses)


def test_things_are_put_where_there_is_room_on_a_table_that_is_in_use():
    geometry, poses, found = of_scene(lived_in())
    puts = [t for t in found if isinstance(t, envs.PutOn) and (t.item, t.support) == (GLASS, TABLE)]
    assert puts, "something in its middle does not make a table useless"
    state = RoomState(poses, {}, AWAY, np.zeros(3))
    goal = puts[0].goal(geometry, state)
    other = to_world(poses["drinking_glass-1"], geometry.items["drinking_glass-1"].centre)
    radius = max(geometry.items[GLASS].size[:2]) / 2
    assert np.linalg.norm(goal[:2] - other[:2]) > 2 * radius + 0.05
    assert puts[0].success(geometry, with_glass(geometry, state, goal), state)
    assert task_named("put the glass on the dining table", found, geometry).subject.startswith("drinking_glass")


@pytest.mark.parametrize(
    ("words", "about"),
    [
        ("go to the dining_table", TABLE),
        ("go to the dining table", TABLE),
        ("go to dining_table-0", TABLE),
        ("go to the oak dining table", TABLE),
        ("go to the wooden table", TABLE),
        ("open the refrigerator", FRIDGE),
    ],
)
def test_a_thing_is_named_as_people_name_it(words, about):
    scene = kitchen()
    oak = {"material": "oak", "color": "tan"}
    dressed = tuple(o.model_copy(update={"attributes": oak}) if o.id == TABLE else o for o in scene.objects)
    geometry, _, found = of_scene(scene.model_copy(update={"objects": dressed}))
    assert geometry.owner[task_named(words, found, geometry).subject] == about


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("go to the sofa", "nothing in scene 'small-kitchen' is 'sofa'"),
        ("go to the red dining table", r"nothing in scene .* is 'red dining table'; there is dining_table-0"),
        ("put the glass on the fridge", "not feasible in scene 'small-kitchen': out of the robot's reach"),
        ("put the glass away", "does not say where to"),
        ("paint the fridge", "no known verb"),
    ],
)
def test_what_is_refused_says_why(words, said):
    geometry, _, found = of_scene(kitchen())
    with pytest.raises(InputError, match=said):
        task_named(words, found, geometry)


def test_reach_is_that_of_the_robot():
    """Half a metre between two low walls: a base of 0.2 m goes through, one of 0.25 m does not."""
    scene, mobile = kitchen(), envs.mobile_manipulator()
    walls = tuple(
        SceneObject(
            id=f"block-{k}", category="block", size=(0.1, 1.75, 0.9), pose=Pose.from_yaw(x, 1.6, 0.0, np.pi / 2)
        )
        for k, x in enumerate((0.875, 3.125))
    )
    blocked = scene.model_copy(update={"objects": (*scene.objects, *walls)})
    slim, wide = (envs.reach_of(blocked, replace(mobile, radius=r), load) for r in (0.2, 0.25))
    assert slim.share == 1.0 and slim.unreached == () and slim.surfaces[TABLE, "top"] > 0.9
    assert wide.share < 1.0 and TABLE in wide.unreached and wide.surfaces[TABLE, "top"] < 0.1
    _, _, found = of_scene(blocked, replace(mobile, radius=0.25))
    assert not any(t.subject == TABLE or getattr(t, "support", "") == TABLE for t in found), "no task asks for it"
