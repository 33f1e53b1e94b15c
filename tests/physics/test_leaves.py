"""Door leaves: where the door's zone is, clear of the walls, and opened and closed in MuJoCo."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.geometry.polygons import rectangle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.physics import build
from sceneweaver.physics.leaves import THICK, Leaf, _hits, _walls, leaves
from sceneweaver.scene import Door, Room, Scene, Window
from sceneweaver.verify.solids import Placed

mujoco: Any = import_module("mujoco")

OUTLINE = ((0, 0), (4, 0), (4, 3), (2, 3), (2, 5), (0, 5))  # corner 3 is reflex
SWINGS = ("in-left", "in-right", "out", "slide")
PLACES = [(0, 0.0), (0, 1.5), (0, 3.1), (1, 1.0), (2, 0.3), (3, 0.6), (5, 2.0)]


def _room(swing: str, wall: int, offset: float, turn: float = 0.0) -> Room:
    c, s = math.cos(turn), math.sin(turn)
    outline = tuple((c * x - s * y + 3, s * x + c * y - 2) for x, y in OUTLINE)
    door = Door.model_validate({"id": "d", "wall": wall, "offset": offset, "width": 0.9, "height": 2, "swing": swing})
    return Room(
        outline=outline, doors=(door,), windows=(Window(id="w", wall=4, offset=0.4, width=1, sill=1, height=1),)
    )


def _load(room: Room) -> tuple[Any, Any]:
    model = mujoco.MjModel.from_xml_string(build(Scene(id="s", room=room)).xml)
    return model, mujoco.MjData(model)


def _deepest(model: Any, data: Any, joint: str, at: float) -> float:
    """How deep [m] anything is in anything with that joint at that place; not in contact: 0."""
    data.qpos[model.joint(joint).qposadr[0]] = at
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_collision(model, data)
    return max([-float(c.dist) for c in data.contact[: data.ncon]], default=0.0)


def _corners(leaf: Leaf, at: float) -> np.ndarray:
    """The leaf's corners from above, opened by ``at``, in the world, [4, 2]."""
    (x, y, _), (hx, hy, _) = leaf.boxes[0]
    plan = np.array([(x + u * hx, y + v * hy) for u in (-1, 1) for v in (-1, 1)])
    if leaf.joint == "slide":
        plan, turn = plan + np.array([at * leaf.axis[0], 0.0]), leaf.yaw
    else:
        turn = leaf.yaw + at * leaf.axis[2]
    c, s = math.cos(turn), math.sin(turn)
    return plan @ np.array([[c, s], [-s, c]]) + np.array(leaf.position[:2])


@pytest.mark.parametrize("swing", SWINGS)
@pytest.mark.parametrize(("wall", "offset"), PLACES)
def test_no_wall_is_touched_from_closed_to_open(swing: str, wall: int, offset: float) -> None:
    room = _room(swing, wall, offset, 0.4)
    (leaf,) = leaves(room)
    model, data = _load(room)
    for at in np.linspace(*leaf.limits, 40):
        assert _deepest(model, data, leaf.name, at) < 1e-4
    assert leaf.limits[1] > (1.3 if leaf.joint == "hinge" else 0.7)


def test_a_wall_in_the_way_is_the_limit() -> None:
    (free,) = leaves(_room("in-left", 0, 1.5))
    room = _room("in-left", 0, 0.0)
    (near,) = leaves(room)
    model, data = _load(room)
    assert near.limits[1] < free.limits[1] == pytest.approx(math.pi / 2, abs=1e-3)
    assert _deepest(model, data, near.name, near.limits[1] + 0.05) > 1e-3, "the handle meets the other wall there"


@pytest.mark.parametrize("swing", ["in-left", "in-right"])
@pytest.mark.parametrize("wall", [2, 3])
def test_a_doorway_in_a_reflex_corner_is_free(swing: str, wall: int) -> None:
    """The slab of the next wall would stand in it."""
    room = _room(swing, wall, 1.1 if wall == 2 else 0.0)
    (leaf,) = leaves(room)
    model, data = _load(room)
    assert not leaf.stuck and leaf.limits[1] > 1.3
    assert max(_deepest(model, data, leaf.name, at) for at in np.linspace(*leaf.limits, 40)) < 1e-4


def test_a_door_that_cannot_open_stays_where_it_is() -> None:
    """In an acute corner the free end of a leaf meets the other wall at once."""
    door = Door(id="d", wall=1, offset=0.0, width=1.1, height=2.0, swing="in-right")
    room = Room(outline=((0, 0), (6, 0), (4, 3), (2, 3)), doors=(door,))
    (leaf,) = leaves(room)
    model, data = _load(room)
    mujoco.mj_step(model, data, 250)
    assert leaf.stuck and abs(data.joint(leaf.name).qpos[0]) < 1e-3


@pytest.mark.parametrize("swing", ["in-left", "in-right"])
@pytest.mark.parametrize("wall", [0, 3])
def test_the_leaf_sweeps_the_zone_of_its_door(swing: str, wall: int) -> None:
    from shapely.geometry import MultiPoint, Polygon

    room = _room(swing, wall, 0.8, 1.1)
    (leaf,) = leaves(room)
    (zone,) = (Polygon(d.polygon) for d in Placed.of(Scene(id="s", room=room)).doors)
    assert zone.buffer(1e-3).contains(MultiPoint(_corners(leaf, leaf.limits[1])).convex_hull)
    assert not zone.buffer(-1e-3).intersects(MultiPoint(_corners(leaf, 0.0)).convex_hull), "closed, it is in the wall"
    # Left and right are those of somebody who comes in: in-left hangs at the door's offset.
    (ax, ay), (bx, by) = room.outline[wall], room.outline[(wall + 1) % 6]
    along = np.array([bx - ax, by - ay]) / math.dist((ax, ay), (bx, by))
    at = float((np.array(leaf.position[:2]) - (ax, ay)) @ along)
    assert at == pytest.approx(0.8 if swing == "in-left" else 1.7, abs=0.01)


def test_a_closed_leaf_fills_its_opening() -> None:
    for swing in SWINGS:
        room = _room(swing, 0, 1.0)
        (leaf,) = leaves(room)
        across = _corners(leaf, 0.0) - room.outline[0]
        assert across[:, 0].min() < 1.01 and across[:, 0].max() > 1.89
        assert np.ptp(across[:, 1]) == pytest.approx(THICK)
        if swing != "slide":
            assert across[:, 1].min() >= -WALL_THICKNESS - 1e-9 and across[:, 1].max() <= 1e-9
        low, high = (leaf.boxes[0][0][2] + s * leaf.boxes[0][1][2] for s in (-1, 1))
        assert low == pytest.approx(0.005) and high > 1.99
        assert len(leaf.boxes) > 2 and leaf.mass > 10


@pytest.mark.parametrize("swing", SWINGS)
def test_it_stays_closed_and_opens_and_closes(swing: str) -> None:
    room = _room(swing, 3, 0.5)
    (leaf,) = leaves(room)
    model, data = _load(room)
    joint = data.joint(leaf.name)
    mujoco.mj_step(model, data, 250)
    assert abs(joint.qpos[0]) < 1e-3
    reached = []
    for sign in (1, -1):
        joint.qfrc_applied[0] = sign * 20.0  # N, or N m: 23 N at the handle
        mujoco.mj_step(model, data, 750)
        reached.append(float(joint.qpos[0]) / leaf.limits[1])
    assert reached[0] > 0.95 and abs(reached[1]) < 0.02


def test_no_wall_stands_in_the_room() -> None:
    """At a reflex corner a wall ends with its outline: beyond would be the room."""
    model, data = _load(_room("slide", 0, 1.0))
    mujoco.mj_kinematics(model, data)
    corner = np.array([2 + 3, 3 - 2, 1.0])
    for way in ((0.05, -0.05), (-0.05, 0.05), (-0.05, -0.05)):
        point = corner + np.array([*way, 0.0])
        for geom in np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_BOX):
            local = data.geom_xmat[geom].reshape(3, 3).T @ (point - data.geom_xpos[geom])
            assert (np.abs(local) > model.geom_size[geom]).any()


@pytest.mark.parametrize("swing", ["in-left", "in-right", "out", "slide"])
def test_a_hand_finds_the_handles_of_a_leaf(swing: str) -> None:
    """Each grasp is in a box of a handle, and its hand comes from its own side of the wall."""
    room = _room(swing, 0, 1.5)
    (leaf,) = leaves(room)
    assert {grasp.name for grasp in leaf.grasps} == {"inside", "outside"}
    wall = room.walls[0]
    for grasp in leaf.grasps:
        inside = [bool((np.abs(np.array(grasp.position) - c) <= np.array(h) + 1e-9).all()) for c, h in leaf.boxes[1:]]
        assert any(inside)
        c, s = np.cos(leaf.yaw), np.sin(leaf.yaw)
        approach = np.array([[c, -s], [s, c]]) @ grasp.approach[:2]
        toward = approach @ np.array(wall.outward)
        assert toward == pytest.approx(1.0 if grasp.name == "inside" else -1.0)


@pytest.mark.parametrize("swing", ["in-left", "in-right", "out", "slide"])
def test_many_positions_at_once_are_as_one_by_one(swing: Any) -> None:
    import shapely

    outline = ((0.0, 0.0), (4.0, 0.0), (4.0, 1.2), (2.1, 1.2), (2.1, 3.0), (0.0, 3.0))
    door = Door(id="door-0", wall=2, offset=0.3, width=0.9, height=2.0, swing=swing)
    room = Room(type="room", outline=outline, doors=(door,))
    (leaf,), walls = leaves(room), _walls(room)
    positions = np.linspace(-1.0, 3.0, 60).tolist()
    wanted = []
    for at in positions:
        frame = SE2(*leaf.position[:2], leaf.yaw + (at * leaf.axis[2] if leaf.joint == "hinge" else 0.0))
        slid = at if leaf.joint == "slide" else 0.0
        plans = [
            shapely.Polygon([frame.world(x + slid + u, y + v) for u, v in rectangle(2 * hx, 2 * hy)])
            for (x, y, _), (hx, hy, _) in leaf.boxes
        ]
        wanted.append(any(plan.intersection(walls).area > 1e-7 for plan in plans))
    assert 0 < sum(wanted) < len(wanted)
    assert _hits(leaf, positions, walls).tolist() == wanted
