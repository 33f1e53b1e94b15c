"""Cameras at eye level, and the first hits that they are chosen by."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from sceneweaver.assets import make
from sceneweaver.render.camera import Camera
from sceneweaver.render.probe import DOOR, FLOOR, WALL, Probe
from sceneweaver.render.tracing import Triangles
from sceneweaver.render.viewpoints import EYE_HEIGHT, EYE_VIEWS, corner_directions, eye_cameras
from sceneweaver.scene import Door, InputError, Pose, Room, Scene, Window
from tests.render.scenes import box, everything, rectangle, room_of, zoo
from tests.sizes import often

L_ROOM = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))


def bedroom() -> Scene:
    """A bed with its head at the west wall, a wardrobe in the south-east corner, a door south, a window north."""
    bed = box("bed", 1.05, 1.8, size=(2.0, 1.6, 0.9), category="bed")
    wardrobe = box("wardrobe", 3.7, 0.8, size=(0.6, 1.6, 2.1), yaw=np.pi, category="wardrobe")
    room = Room(
        outline=rectangle(4.0, 3.6),
        doors=(Door(id="d", wall=0, offset=2.3, width=0.9, height=2.0),),
        windows=(Window(id="w", wall=2, offset=1.0, width=1.5, sill=0.9, height=1.3),),
    )
    return room_of(bed, wardrobe, room=room)


@pytest.fixture(scope="module")
def bedroom_cameras() -> dict[str, Camera]:
    return eye_cameras(bedroom())


def rooms() -> dict[str, Scene]:
    toilet = room_of(box("toilet", 0.35, 0.5, category="toilet"), width=1.0, depth=1.5)
    hall = room_of(box("bench", 10.0, 0.4, size=(0.4, 1.5, 0.5), category="bench"), width=20.0, depth=1.6)
    bare = Scene(id="bare", room=Room(outline=L_ROOM))
    low = room_of(box("bed", 1.5, 1.5, category="bed"), room=Room(outline=rectangle(4, 3), height=1.4))
    found = {"toilet": toilet, "hall": hall, "bare": bare, "low": low, "bedroom": bedroom(), "everything": everything()}
    return found | {name: zoo(name) for name in ("living-dining-L", "studio-U", "office-20")}


@pytest.mark.parametrize("name", often(rooms(), ("hall", "low", "studio-U")))
def test_cameras_stand_in_the_room_level_and_free(name: str) -> None:
    scene = rooms()[name]
    cameras = eye_cameras(scene)
    assert tuple(cameras) == EYE_VIEWS
    # A camera in a doorway stands a little outside of the outline.
    floor = shapely.Polygon(scene.room.outline).buffer(0.36)
    for camera in cameras.values():
        x, y, z = camera.eye
        assert shapely.contains_xy(floor, x, y)
        assert z == pytest.approx(min(EYE_HEIGHT, 0.6 * scene.room.height))
        assert camera.axis[2] == pytest.approx(0.0, abs=1e-9) and camera.up[:2] == (0.0, 0.0)
        angle = 2 * math.degrees(math.atan(float(np.linalg.norm(camera.right))))
        assert 65.0 <= angle <= 74.0
    glimpses = Probe(scene).look(list(cameras.values()), 80, 60)
    for glimpse in glimpses:
        assert (glimpse.distance[glimpse.ids >= 0] < 0.4).mean() < 0.02 if (glimpse.ids >= 0).any() else True
    pairs = [(a, b) for k, a in enumerate(cameras.values()) for b in list(cameras.values())[k + 1 :]]
    for a, b in pairs:
        turned = math.acos(float(np.clip(a.axis @ b.axis, -1, 1)))
        assert math.dist(a.eye, b.eye) > 0.25 or turned > 0.3


def test_the_focus_is_seen_from_the_front_and_nothing_stands_before_the_lens(bedroom_cameras) -> None:
    scene, cameras = bedroom(), bedroom_cameras
    glimpses = dict(zip(cameras, Probe(scene).look(list(cameras.values()), 160, 120), strict=True))
    for view in EYE_VIEWS:
        shares = glimpses[view].pixels(2) / (160 * 120)
        assert shares[0] > 0.06, view
        assert shares[1] < 0.3, view
    # From the foot of the bed, not over its head.
    assert cameras["eye-corner"].eye[0] > 1.8


def test_the_door_view_is_taken_at_a_door(bedroom_cameras) -> None:
    door = bedroom().room.doors[0]
    x, y, _ = bedroom_cameras["eye-door"].eye
    assert door.offset - 0.1 < x < door.offset + door.width + 0.1 and -0.36 < y < 1.1


def test_equal_scenes_have_equal_cameras(bedroom_cameras) -> None:
    assert eye_cameras(bedroom()) == bedroom_cameras


def test_the_overview_looks_at_key_pieces_from_the_front() -> None:
    sofa = make("sofa", seed=1)
    thing = sofa.object("sofa", pose=Pose.from_yaw(2.0, 0.6, 0.0, np.pi / 2))
    # A tall shelf beside it would hide it from the west.
    shelf = box("shelf", 0.5, 1.5, size=(0.4, 2.4, 2.2), category="bookcase")
    way = corner_directions(room_of(thing, shelf))[0]
    assert way[1] > 0 and way[0] > 0


def test_first_hits_are_those_of_a_plain_search() -> None:
    rng = np.random.default_rng(3)
    vertices = rng.uniform(-1.0, 1.0, (60, 3))
    faces = np.arange(60).reshape(20, 3)
    cameras = [
        Camera.look_at((0.0, -4.0, 0.5), (0.0, 0.0, 0.0), 0.7, 4 / 3),
        Camera.level((3.0, 1.0, 0.2), 2.9, 1.0, 4 / 3, -0.3),
        Camera.orthographic((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), 2.5, 4 / 3),
    ]
    hits = Triangles(vertices, faces).first_hits(cameras, 24, 18)
    for camera, face, distance in zip(cameras, hits.face, hits.distance, strict=True):
        origin = np.broadcast_to(camera.origins(24, 18), (18, 24, 3)).reshape(-1, 3)
        way = camera.rays(24, 18).reshape(-1, 3)
        nearest = brute_force(origin, way, vertices[faces])
        assert np.array_equal(np.isfinite(nearest), face.reshape(-1) >= 0)
        assert np.allclose(distance.reshape(-1), nearest, atol=1e-4)


def brute_force(origin: np.ndarray, way: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Distance of the first hit of each ray [N] on any of the triangles [F, 3, 3], by Cramer's rule."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    columns = np.stack(np.broadcast_arrays(b - a, c - a, -way[:, None, :]), axis=-1)
    u, v, t = np.moveaxis(np.linalg.solve(columns, (origin[:, None] - a)[..., None])[..., 0], -1, 0)
    hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)
    return np.where(hit, t, np.inf).min(axis=1)


def test_points_are_projected_onto_the_pixels_that_show_them() -> None:
    for camera in (
        Camera.look_at((0.0, -4.0, 0.5), (0.0, 0.0, 0.0), 0.7, 1.5),
        Camera.level((3.0, 1.0, 0.2), 2.9, 1.0, 1.5, -0.3),
        Camera.orthographic((0.0, 1.0, 5.0), (0.0, 0.0, 0.0), 2.5, 1.5),
    ):
        points = (camera.origins(6, 4) + 2.5 * camera.rays(6, 4)).reshape(-1, 3)
        u, v, _ = camera.project(points).T
        x, y = np.meshgrid(2 * (np.arange(6) + 0.5) / 6 - 1, 1 - 2 * (np.arange(4) + 0.5) / 4)
        assert np.allclose(u, x.reshape(-1)) and np.allclose(v, y.reshape(-1))


def test_a_probe_knows_walls_doors_and_floor() -> None:
    scene = bedroom()
    (south,) = Probe(scene).look([Camera.level((2.75, 3.0, 1.0), -np.pi / 2, 1.2)], 64, 64)
    assert south.ids[32, 32] == DOOR and south.distance[32, 32] == pytest.approx(3.0, abs=0.02)
    assert south.ids[60, 32] == FLOOR and WALL in south.ids
    (west,) = Probe(scene, hidden={"bed"}, cut={3}).look([Camera.level((2.75, 1.8, 1.0), np.pi, 0.4)], 8, 8)
    assert (west.ids == -1).all()


def test_bad_cameras_are_refused() -> None:
    with pytest.raises(InputError, match="camera: eye"):
        Camera.level((0.0, math.nan, 1.0), 0.0, 1.0)
    with pytest.raises(InputError, match=r"camera\.fov"):
        Camera.level((0.0, 0.0, 1.0), 0.0, 4.0)
    with pytest.raises(InputError, match="pictures: 0 of"):
        Triangles(np.eye(3), np.array([[0, 1, 2]])).first_hits([], 4, 4)
