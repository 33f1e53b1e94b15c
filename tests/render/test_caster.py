"""Drafts: what is where, light and shadow, glass, edges, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.shapes import box, frustum
from sceneweaver.cli import main
from sceneweaver.render.camera import Camera
from sceneweaver.render.instances import Instance
from sceneweaver.render.tracing import DirectLights, Quality, TracedPicture, trace
from sceneweaver.render.tracing.world import corner_normals
from sceneweaver.scene import InputError, MissingDependencyError

RED = Material("red", (0.9, 0.05, 0.05))
WHITE = Material("white", (0.9, 0.9, 0.9))


def _mesh(shape, material: Material = RED) -> Mesh:
    zero = np.zeros(len(shape[1]), dtype=np.int32)
    return Mesh(shape[0], shape[1], zero, zero, (material,))


def cast(instances, camera, width: int, height: int, **more) -> TracedPicture:
    return trace(instances, camera, width, height, **{"lights": DirectLights(), **more})


def _draw(*instances: Instance, size: int = 64, quality: Quality | None = None) -> TracedPicture:
    camera = Camera.look_at((4, 0, 1.2), (0, 0, 0.5))
    return cast(list(instances), camera, size, size, quality=quality)


def _at(mesh: Mesh, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Instance:
    matrix = np.eye(4)
    matrix[:3, 3] = (x, y, z)
    return Instance(mesh, matrix)


CUBE = _mesh(box((-0.5, 0.5), (-0.5, 0.5), (0, 1)))


def test_a_red_box_is_red_in_the_middle() -> None:
    picture = _draw(_at(CUBE))
    r, g, b = (int(v) for v in picture.rgb[32, 32])
    assert r > 120 and g < 90 and b < 90
    corner = picture.rgb[1, 1].astype(int)
    assert corner.max() - corner.min() < 20 and corner.min() > 180
    assert picture.instance[32, 32] == 0 and picture.instance[1, 1] == -1
    assert picture.distance[32, 32] == pytest.approx(3.55, abs=0.1)


def test_the_nearer_object_hides_the_other() -> None:
    picture = _draw(_at(CUBE), _at(_mesh(box((-0.1, 0.1), (-0.1, 0.1), (0, 1)), WHITE), x=2.0))
    assert picture.instance[34, 32] == 1 and 0 in picture.instance


def test_glass_shows_what_is_behind() -> None:
    glass = _mesh(box((-0.01, 0.01), (-0.4, 0.4), (0, 1)), Material("glass", (0.9, 0.9, 0.9), 0.05, opacity=0.2))
    r, g, b = (int(v) for v in _draw(_at(CUBE), _at(glass, x=1.5)).rgb[32, 32])
    assert r > g + 40 and r > b + 40


def test_a_box_throws_a_shadow() -> None:
    floor = _mesh(box((-4, 4), (-4, 4), (-0.1, 0)), WHITE)
    camera = Camera.orthographic((0, 0, 6), (0, 0, 0), 6.0)
    with_box = cast([_at(floor), _at(CUBE)], camera, 60, 60).rgb.astype(int).sum(axis=2)
    without = cast([_at(floor)], camera, 60, 60).rgb.astype(int).sum(axis=2)
    # The sun stands in front and to the right: the shadow falls to the back and the left, upward in the picture.
    assert with_box[26, 21] < without[26, 21] - 60
    assert abs(with_box[45, 50] - without[45, 50]) < 30


def test_what_shines_is_bright() -> None:
    lamp = _mesh(box((-0.5, 0.5), (-0.5, 0.5), (0, 1)), Material("glow", (1.0, 1.0, 0.9), emission=1.0))
    assert _draw(_at(lamp)).rgb[32, 32].min() > 220


def test_the_same_input_gives_the_same_picture() -> None:
    first, second = _draw(_at(CUBE)).rgb, _draw(_at(CUBE)).rgb
    assert (first == second).all()


def test_nothing_but_background_where_nothing_is() -> None:
    picture = _draw(_at(CUBE, x=-100.0, y=60.0))
    assert (picture.instance == -1).all() and np.ptp(picture.rgb.reshape(-1, 3), axis=0).max() == 0
    assert np.isinf(picture.distance).all()


def test_normals_are_smooth_around_and_sharp_at_edges() -> None:
    cylinder = _mesh(frustum(0.5, 0.5, (0, 1), 24))
    normals = corner_normals(cylinder).reshape(-1, 3, 3)
    corners = cylinder.vertices[cylinder.faces]
    side = np.ptp(corners[:, :, 2], axis=1) > 0.5
    radial = corners[side][:, :, :2] / np.linalg.norm(corners[side][:, :, :2], axis=2, keepdims=True)
    assert np.einsum("fij,fij->fi", normals[side][:, :, :2], radial).min() > 0.99
    flat = corner_normals(CUBE)
    assert np.allclose(np.abs(flat).max(axis=1), 1.0)


@pytest.mark.parametrize("size", [(0, 10), (10, 0), (100_000, 100_000)])
def test_a_picture_without_pixels_is_refused(size: tuple[int, int]) -> None:
    with pytest.raises(InputError, match="picture: .* pixels"):
        cast([_at(CUBE)], Camera.look_at((1, 0, 0), (0, 0, 0)), *size)


def test_the_commands_draw_and_tell(tmp_path, capsys) -> None:
    out = tmp_path / "sheet.png"
    assert main(["assets", "sheet", "mug", "stool", "--tile", "48", "--seeds", "2", "-o", str(out)]) == 0
    assert out.stat().st_size > 1000
    assert main(["assets", "sheet", "mugg", "-o", str(out)]) == 2
    assert "category: 'mugg' is unknown" in capsys.readouterr().err
    assert main(["assets", "sheet", "mug", "--view", "below", "-o", str(out)]) == 2
    assert "view: 'below' is unknown" in capsys.readouterr().err
    assert main(["assets", "show", "ofice chair", "--store", str(tmp_path / "s")]) == 0
    said = capsys.readouterr()
    assert "was taken for 'office chair'" in said.err and "parametric:office_chair?seed=0" in said.out
    assert main(["assets", "list", "--store", str(tmp_path / "s"), "--source", "parametric"]) == 0
    assert "parametric:desk" in capsys.readouterr().out


CAMERA = Camera.look_at((4.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.6)
EMPTY = Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32), *[np.zeros(0, np.int32)] * 2, (Material("m", (1, 1, 1)),))


def wall(material: Material, size: float = 0.5) -> Mesh:
    """A square at x = 0 that faces the camera."""
    v = np.array([[0, -size, -size], [0, size, -size], [0, size, size], [0, -size, size]])
    zeros = np.zeros(2, np.int32)
    return Mesh(v, np.array([[0, 1, 2], [0, 2, 3]], np.int32), zeros, zeros, (material,))


def drawn(mesh: Mesh, transform=None, **more):
    things = [Instance(mesh, np.eye(4) if transform is None else transform)]
    return cast(things, CAMERA, 65, 65, **more)


def test_depth_and_object_are_those_of_the_middle_of_a_pixel():
    picture = drawn(wall(Material("red", (0.8, 0.1, 0.1))))
    axis = ((np.arange(65) + 0.5) / 32.5 - 1) * math.tan(0.3)
    u, v = np.meshgrid(axis, -axis)
    inside = (np.abs(u * 4) < 0.5) & (np.abs(v * 4) < 0.5)
    assert (picture.instance == np.where(inside, 0, -1)).all()
    assert np.allclose(picture.distance[inside], 4 * np.sqrt(1 + u**2 + v**2)[inside], atol=1e-4)
    assert np.isinf(picture.distance[~inside]).all()


def test_edges_are_no_darker_than_both_of_their_sides():
    lights = DirectLights(background=(0.6, 0.6, 0.6))
    rgb = drawn(wall(Material("white", (0.95, 0.95, 0.95))), lights=lights, quality=Quality(rays=16)).rgb
    row = rgb[32].astype(int).sum(axis=1)
    assert row.min() >= min(row[0], row[32]) - 3


def test_half_shaded_surfaces_have_next_to_no_noise():
    grey = Material("grey", (0.5, 0.5, 0.5))
    roof = np.array([[0.0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 1.3], [0, 0, 0, 1]])  # level, above what is seen
    things = [Instance(wall(grey, 40.0), np.eye(4)), Instance(wall(grey, 3.0), roof)]
    picture = cast(things, CAMERA, 65, 65, quality=Quality(bounces=24))
    inner = picture.rgb[8:-8, 8:-8, 1].astype(float)
    assert (picture.instance == 0).all() and np.ptp(inner.mean(axis=1)) > 5, "it is shaded"
    assert np.std(inner - inner.mean(axis=1, keepdims=True)) < 0.2, "of 255: the roof shades all of a row alike"


def test_a_mesh_without_triangles_is_not_there():
    with pytest.raises(InputError, match="nothing to draw"):
        drawn(EMPTY)
    both = [Instance(EMPTY, np.eye(4)), Instance(wall(Material("m", (1, 0, 0))), np.eye(4))]
    assert cast(both, CAMERA, 9, 9).instance[4, 4] == 1


@pytest.mark.parametrize("transform", [np.eye(3), np.zeros((4, 4)), np.full((4, 4), np.nan), np.diag([1, 1, 0, 1])])
def test_bad_transforms(transform):
    with pytest.raises(InputError, match=r"instances\[0\].transform"):
        drawn(wall(Material("m", (1, 1, 1))), transform)


@pytest.mark.parametrize("sun", [(0.0, 0.0, 0.0), (math.nan, 0.0, 1.0)])
def test_bad_sun(sun):
    with pytest.raises(InputError, match=r"lights\.sun"):
        DirectLights(sun=sun)


@pytest.mark.parametrize("device", ["cuda:99", "tpu", ""])
def test_devices_that_are_not_there(device):
    with pytest.raises(MissingDependencyError, match="device"):
        drawn(EMPTY, device=device)


@pytest.mark.parametrize(
    ("field", "more"),
    [
        ("target", {"target": (1.0, 0.0, 0.0)}),
        ("target", {"target": (math.nan, 0.0, 0.0)}),
        ("eye", {"target": (0.0, 0.0)}),
        ("fov", {"fov": 0.0}),
        ("fov", {"fov": 4.0}),
        ("fov", {"fov": math.nan}),
        ("aspect", {"aspect": 0.0}),
    ],
)
def test_bad_cameras(field, more):
    with pytest.raises(InputError, match=rf"camera.*{field}"):
        Camera.look_at(**{"eye": (1.0, 0.0, 0.0), "target": (0.0, 0.0, 0.0), **more})


def test_flat_cameras_have_a_height():
    with pytest.raises(InputError, match="camera.height"):
        Camera.orthographic((1.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)


def test_what_is_narrower_than_a_pixel_leaves_no_specks() -> None:
    """The sides of folds of a tenth of a millimetre are met by some rays, seen aslant: their pixels stay pale."""
    folds = [(0.002 * k, 0.0001 * (k % 2)) for k in range(-400, 401)]
    steps = [(x, z) for (x, z), (_, before) in zip(folds[1:], folds, strict=False) for z in (before, z)]
    points = np.array([(x, y, z) for x, z in steps for y in (-1.0, 1.0)])
    first = 2 * np.arange(len(steps) - 1)[:, None]
    cloth = _mesh((points, np.concatenate([first + (0, 2, 3), first + (0, 3, 1)])), WHITE)
    camera = Camera.look_at((0.4, -3.0, 2.5), (0, 0, 0), fov=0.2)
    seen = cast([_at(cloth)], camera, 120, 120).linear[20:100, 20:100, 1]
    assert seen.min() > 0.6 * np.median(seen)
