"""The ray caster: what is where, light and shadow, glass, and the same picture for the same input."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.shapes import box, frustum
from sceneweaver.cli import main
from sceneweaver.render.camera import Camera
from sceneweaver.render.caster import Instance, Picture, Quality, cast
from sceneweaver.render.mesh_shading import corner_normals
from sceneweaver.scene import InputError

RED = Material("red", (0.9, 0.05, 0.05))
WHITE = Material("white", (0.9, 0.9, 0.9))


def _mesh(shape, material: Material = RED) -> Mesh:
    zero = np.zeros(len(shape[1]), dtype=np.int32)
    return Mesh(shape[0], shape[1], zero, zero, (material,))


def _draw(*instances: Instance, size: int = 64, quality: Quality | None = None) -> Picture:
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
    assert picture.objects[32, 32] == 0 and picture.objects[1, 1] == -1
    assert picture.depth[32, 32] == pytest.approx(3.55, abs=0.1)


def test_the_nearer_object_hides_the_other() -> None:
    picture = _draw(_at(CUBE), _at(_mesh(box((-0.1, 0.1), (-0.1, 0.1), (0, 1)), WHITE), x=2.0))
    assert picture.objects[34, 32] == 1 and 0 in picture.objects


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


def test_no_instances_are_a_background() -> None:
    picture = _draw()
    assert (picture.objects == -1).all() and np.ptp(picture.rgb.reshape(-1, 3), axis=0).max() == 0


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
        cast([], Camera.look_at((1, 0, 0), (0, 0, 0)), *size)


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
