"""The path tracer: light against what can be worked out, first surfaces against rays by hand, and bad input."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest

from sceneweaver.assets import textures
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.shapes import box
from sceneweaver.render.camera import Camera
from sceneweaver.render.instances import Instance
from sceneweaver.render.tracing import Lights, Portal, Quality, Tracer, interior_lights, trace
from sceneweaver.render.tracing.lights import emission_of
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import InputError, Room, Scene

DARK = {"sun_color": (0, 0, 0), "zenith": (0, 0, 0), "horizon": (0, 0, 0), "ground": (0, 0, 0), "hall": (0, 0, 0)}
EVEN = {**DARK, "zenith": (1, 1, 1), "horizon": (1, 1, 1), "ground": (1, 1, 1)}
GREY = Material("grey", (0.735, 0.735, 0.735), roughness=1.0)  # 0.5 in linear light
BLACK = Material("black", (0, 0, 0), roughness=1.0)
SHARP = Quality(windows=24, lamps=24, bounces=24, levels=0, rays=1)


def _mesh(shape, material: Material) -> Mesh:
    zero = np.zeros(len(shape[1]), dtype=np.int32)
    return Mesh(np.asarray(shape[0], dtype=float), np.asarray(shape[1], dtype=np.int32), zero, zero, (material,))


def _quad(low, high, z: float, material: Material, down: bool = False) -> Mesh:
    (x0, y0), (x1, y1) = low, high
    faces = [[0, 2, 1], [0, 3, 2]] if down else [[0, 1, 2], [0, 2, 3]]
    return _mesh(([(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)], faces), material)


def _at(mesh: Mesh, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Instance:
    matrix = np.eye(4)
    matrix[:3, 3] = (x, y, z)
    return Instance(mesh, matrix)


def _inward(size: float, material: Material) -> Mesh:
    vertices, faces = box((-size, size), (-size, size), (-size, size))
    return _mesh((vertices, faces[:, ::-1]), material)


def _share_of_rectangle(point: np.ndarray, normal: np.ndarray, corners: np.ndarray) -> float:
    """Irradiance over pi at a point by a rectangle of radiance 1 above its horizon, after Lambert."""
    to = corners - point
    to = to / np.linalg.norm(to, axis=1, keepdims=True)
    after = np.roll(to, -1, axis=0)
    angle = np.arccos(np.clip((to * after).sum(axis=1), -1, 1))
    edge = np.cross(to, after)
    edge = edge / np.linalg.norm(edge, axis=1, keepdims=True)
    return abs(float((angle * (edge @ normal)).sum())) / (2 * np.pi)


def _matt(albedo: float) -> float:
    """What a surface of roughness 1 throws back in all, with the little that it reflects."""
    gloss = 0.04 * (0.468 - 1.04 * 0.015) + 1.04 * 0.015 - 0.018
    return albedo * (1 - gloss) + gloss


def test_a_white_furnace_is_as_bright_as_its_walls_say() -> None:
    glow = Material("glow", GREY.color, roughness=1.0, emission=1.0)
    room = _inward(1.0, glow)
    lights = Lights(**DARK, lamp_color=(1, 1, 1))
    shine = float(emission_of(room, np.full(len(room.faces), 2.0), lights)[0, 0])
    camera = Camera.look_at((-0.5, -0.4, 0.1), (1, 0.2, -0.1), fov=1.0)
    seen = trace([_at(room)], camera, 24, 24, lights=lights, quality=replace(SHARP, levels=4)).linear
    expected = shine + _matt(0.5) * shine / (1 - 0.5)
    assert seen.mean() == pytest.approx(expected, rel=0.03)
    assert seen.std() < 0.1 * expected


def test_a_lamp_lights_the_floor_as_its_form_factor_says() -> None:
    lamp = _quad((-0.3, -0.2), (0.3, 0.2), 1.0, Material("glow", (0, 0, 0), emission=1.0), down=True)
    floor = _quad((-3, -3), (3, 3), 0.0, GREY)
    lights = Lights(**DARK, lamp_color=(1, 1, 1))
    radiance = float(emission_of(lamp, np.full(2, 0.12), lights)[0, 0])
    camera = Camera.orthographic((0, 0, 0.5), (0, 0, 0), 2.0)
    seen = trace([_at(floor), _at(lamp)], camera, 20, 20, lights=lights, quality=SHARP).linear[..., 0]
    for row, column in ((10, 10), (4, 16), (0, 10)):
        x, y = -1 + (column + 0.5) / 10, 1 - (row + 0.5) / 10
        share = _share_of_rectangle(np.array([x, y, 0.0]), np.array([0, 0, 1.0]), lamp.vertices)
        assert seen[row, column] == pytest.approx(radiance * share * _matt(0.5), rel=0.06)


def test_a_window_lights_the_floor_as_its_form_factor_says() -> None:
    portal = Portal((-0.5, 1.0, 0.4), (1.0, 0.0, 0.0), (0.0, 0.0, 1.2), (0.0, -1.0, 0.0))
    lights = Lights(**EVEN, enclosed=True, portals=(portal,))
    camera = Camera.orthographic((0, 0, 2), (0, 0, 0), 1.8)
    seen = trace([_at(_quad((-3, -3), (3, 3), 0.0, GREY))], camera, 18, 18, lights=lights, quality=SHARP).linear
    corners = np.array([(-0.5, 1, 0.4), (0.5, 1, 0.4), (0.5, 1, 1.6), (-0.5, 1, 1.6)])
    for row, column in ((9, 9), (2, 14), (0, 9)):
        x, y = -0.9 + (column + 0.5) / 10, 0.9 - (row + 0.5) / 10
        share = _share_of_rectangle(np.array([x, y, 0.0]), np.array([0, 0, 1.0]), corners)
        assert seen[row, column, 1] == pytest.approx(share * _matt(0.5), rel=0.06)


def test_no_light_leaks_into_a_closed_box() -> None:
    camera = Camera.look_at((-0.5, -0.4, 0.1), (1, 0.2, -0.1), fov=1.0)
    assert trace([_at(_inward(1.0, GREY))], camera, 32, 32).linear.max() == 0.0


def test_shadows_are_dark_and_touch_what_throws_them() -> None:
    floor, cube = _quad((-4, -4), (4, 4), 0.0, GREY), _mesh(box((-0.5, 0.5), (-0.5, 0.5), (0, 1)), BLACK)
    lights = Lights(sun=(1, 0, 1), **{**DARK, "sun_color": (3, 3, 3)})
    camera = Camera.orthographic((0, 0, 6), (0, 0, 0), 6.0)
    seen = trace([_at(floor), _at(cube)], camera, 60, 60, lights=lights).linear[..., 1]
    assert seen[30, 45] == pytest.approx(3 / np.sqrt(2) / np.pi * _matt(0.5), rel=0.03)
    assert seen[30, 22] < 0.02 * seen[30, 45], "in the shadow, a hand's breadth from the cube"


def test_panes_are_clear_and_mirrors_throw_back() -> None:
    red = _mesh(box((-0.5, 0.5), (-0.5, 0.5), (-0.5, 0.5)), Material("red", (0.9, 0.05, 0.05)))
    pane = Material("pane", (0.9, 0.9, 0.9), 0.05, opacity=0.2)
    mirror = Material("mirror", (0.9, 0.9, 0.9), 0.02, metallic=1.0)
    sheet = box((-0.01, 0.01), (-2, 2), (-2, 2))
    camera = Camera.look_at((0.5, 0, 0), (2, 0, 0), fov=0.5)
    for material, x in ((pane, 2.5), (mirror, -1.0)):
        picture = trace([_at(red, x=x), _at(_mesh(sheet, material), x=1.5)], camera, 16, 16)
        r, g, b = picture.linear[8, 8]
        assert r > 3 * g and r > 3 * b
        assert picture.instance[8, 8] == 1 and picture.distance[8, 8] == pytest.approx(0.99, abs=1e-3)


def test_first_surfaces_are_those_of_rays_by_hand() -> None:
    rng = np.random.default_rng(5)
    things = [_at(_mesh(box((-0.4, 0.4), (-0.3, 0.3), (0, 0.6)), GREY), *rng.uniform(-1.2, 1.2, 2)) for _ in range(5)]
    things.append(_at(_quad((-3, -3), (3, 3), 0.0, GREY)))
    camera = Camera.look_at((2.5, -2.0, 1.6), (0, 0, 0.2), fov=0.8, aspect=1.5)
    seen = trace(things, camera, 48, 32, quality=Quality.draft())
    eye, forward, right, up = (np.asarray(getattr(camera, k)) for k in ("eye", "forward", "right", "up"))
    hits = 0
    for row, column in rng.integers((32, 48), size=(60, 2)):
        way = forward + right * (2 * (column + 0.5) / 48 - 1) + up * (1 - 2 * (row + 0.5) / 32)
        way = way / np.linalg.norm(way)
        best, owner = np.inf, -1
        for k, thing in enumerate(things):
            for a, b, c in (thing.mesh.vertices + thing.transform[:3, 3])[thing.mesh.faces]:
                n = np.cross(b - a, c - a)
                t = (a - eye) @ n / (way @ n + 1e-30)
                p = eye + way * t
                inside = all(np.cross(q - o, p - o) @ n >= 0 for o, q in ((a, b), (b, c), (c, a)))
                if inside and 0 < t < best:
                    best, owner = t, k
        assert seen.instance[row, column] == owner
        if owner >= 0:
            hits += 1
            assert seen.distance[row, column] == pytest.approx(best, abs=1e-3)
        else:
            assert np.isinf(seen.distance[row, column])
    assert hits > 30


def test_maps_have_their_real_size(monkeypatch) -> None:
    tint = np.zeros((64, 64, 3), dtype=np.uint8)
    tint[:, :32] = 255  # one tile is 0.5 m: white for 25 cm, then black
    flat = np.full((64, 64, 3), (128, 128, 255), dtype=np.uint8)
    maps = textures.Maps((0.5, 0.5), tint, 2.0, flat, np.full((64, 64), 255, dtype=np.uint8), 1.0)
    monkeypatch.setattr(textures, "maps", lambda name: maps if name == "stripes" else None)
    floor = _quad((0, 0), (2, 2), 0.0, Material("striped", (0.5, 0.5, 0.5), roughness=1.0, texture="stripes"))
    uv = floor.vertices[floor.faces][..., :2].astype(np.float32)
    floor = Mesh(floor.vertices, floor.faces, floor.face_material, floor.face_link, floor.materials, uv)
    camera = Camera.orthographic((1, 1, 3), (1, 1, 0), 2.0)
    seen = trace([_at(floor)], camera, 64, 64, lights=Lights(**EVEN), quality=Quality.draft()).linear[..., 0]
    columns = (np.arange(64) + 0.5) / 32 % 0.5 < 0.25
    sure = np.abs((np.arange(64) + 0.5) / 32 % 0.25 - 0.125) < 0.09
    assert (seen[:, columns & sure] > 0.3).all() and (seen[:, ~columns & sure] < 0.05).all()


def test_the_same_input_gives_the_same_pictures() -> None:
    things = [_at(_mesh(box((-0.5, 0.5), (-0.5, 0.5), (0, 1)), GREY)), _at(_quad((-3, -3), (3, 3), 0.0, GREY))]
    camera = Camera.look_at((4, 0, 1.2), (0, 0, 0.5))
    tracer = Tracer(things)
    first, second = tracer.picture(camera, 80, 60), Tracer(things).picture(camera, 80, 60)
    assert (first.rgb == second.rgb).all() and (first.linear == second.linear).all()
    assert first.rgb.shape == (60, 80, 3) and first.rgb.dtype == np.uint8
    assert (tracer.picture(camera, 80, 60).rgb == first.rgb).all(), "one tracer draws any number of pictures"


def test_the_sun_enters_by_a_window_and_a_room_without_any_has_none() -> None:
    room = Room.rectangle(4, 5, height=2.6, kind="bedroom").with_window("north")
    lights = interior_lights(Scene(id="s", prompt="", room=room))
    (portal,) = lights.portals
    assert np.dot(lights.sun, portal.inward) < 0 < lights.sun[2]
    size = [np.linalg.norm(edge) for edge in (portal.across, portal.up)]
    assert size == pytest.approx([room.windows[0].width, room.windows[0].height])
    bare = interior_lights(Scene(id="s", prompt="", room=Room.rectangle(4, 5, height=2.6, kind="bedroom")))
    assert bare.enclosed and not bare.portals


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"width": 0}, "picture"),
        ({"height": 10**6, "width": 10**6}, "picture"),
        ({"instances": []}, "nothing to draw"),
        ({"instances": [Instance(_inward(1.0, GREY), np.zeros((4, 4)))]}, r"instances\[0\].transform"),
    ],
)
def test_bad_input_is_named(change: dict, words: str) -> None:
    asked = {"instances": [_at(_inward(1.0, GREY))], "width": 8, "height": 8, **change}
    with pytest.raises(InputError, match=words):
        trace(asked["instances"], Camera.look_at((0, 0, 0), (1, 0, 0)), asked["width"], asked["height"])


def test_lights_and_quality_are_checked() -> None:
    with pytest.raises(InputError, match=r"lights\.sun"):
        Lights(sun=(0, 0, 0))
    with pytest.raises(InputError, match=r"lights\.zenith"):
        Lights(zenith=(-1, 0, 0))
    with pytest.raises(InputError, match=r"quality\.bounces"):
        Quality(bounces=0)


def test_a_picture_is_given_up_at_its_deadline() -> None:
    tracer = Tracer([_at(_inward(1.0, GREY))])
    with pytest.raises(TimeUp), Deadline(time.monotonic() - 1.0).enforced():
        tracer.picture(Camera.look_at((0, 0, 0), (1, 0, 0)), 64, 64)
