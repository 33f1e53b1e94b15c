"""Materials with grain: maps that repeat, keep the colour of their material, and lie on meshes at their real size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.materials import finishes
from sceneweaver.assets.room_looks import FLOORS, room_looks
from sceneweaver.assets.textures import found, kind_of, library, maps, patterns, uv_of
from sceneweaver.assets.textures.patterns.two_colors import PRINTS, SHARES, mean_of, name_of
from sceneweaver.assets.textures.relief import developed, to_linear
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.scene import InputError, Room
from tests.sizes import share


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The user's folder of textures, and a cache of its own."""
    monkeypatch.setenv("SCENEWEAVER_TEXTURES", str(tmp_path / "textures"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    library._of_pattern.cache_clear()
    library._of_folder.cache_clear()
    yield tmp_path / "textures"
    library._of_pattern.cache_clear()
    library._of_folder.cache_clear()


@pytest.mark.parametrize(
    "name", share([*patterns(), *(name_of(kind, (0.8, 0.6, 0.4), (0.1, 0.1, 0.1)) for kind in PRINTS)], 3)
)
def test_patterns_repeat_without_a_seam_and_keep_the_colour(name):
    """Drawn small: over the border neighbours differ no more than inside; tint times gain has the mean 1."""
    pattern = found(name)
    assert pattern is not None
    made = developed(pattern.draw(128), pattern.size)
    tint = to_linear(made.tint / 255.0) * made.gain
    assert np.abs(tint.mean(axis=(0, 1)) - 1).max() < 0.02
    assert abs(made.roughness.mean() / 255 * made.rough_gain - 1) < 0.02
    assert made.gain >= 1 and made.rough_gain >= 1
    normal = made.normal / 127.5 - 1
    assert np.abs(np.linalg.norm(normal, axis=2) - 1).max() < 0.02 and normal[..., 2].min() > 0.1
    for image in (tint.mean(axis=2), normal[..., 0], normal[..., 1]):
        for turned in (image, image.T):
            rows = np.abs(np.diff(turned, axis=0)).mean(axis=1)
            assert np.abs(turned[0] - turned[-1]).mean() <= 1.5 * rows.max() + 0.01


@pytest.mark.parametrize("kind", PRINTS)
def test_prints_show_their_ground_in_its_colour(kind):
    """On a material of the mean colour the commonest pixels have one of the two colours."""
    first, second = (0.8, 0.6, 0.4), (0.1, 0.1, 0.1)
    pattern = found(name_of(kind, first, second))
    assert pattern is not None
    made = developed(pattern.draw(128), pattern.size)
    shown = to_linear(made.tint / 255.0) * made.gain * to_linear(np.array(mean_of(kind, first, second)))
    assert np.abs(shown.max(axis=(0, 1)) - to_linear(np.array(first))).max() < 0.15


def test_the_shares_of_prints_are_those_that_they_show():
    shown = {kind: float(draw(256).mean()) for kind, (_, draw) in PRINTS.items()}
    assert shown == pytest.approx(SHARES, abs=1e-9)


def test_every_finish_and_floor_names_a_pattern_of_the_library():
    for finish in finishes().values():
        assert finish.material.texture == "plain" or found(finish.material.texture) is not None, finish.material.name
    for floor in FLOORS:
        room = Room.model_validate({"outline": [(0, 0), (3, 0), (3, 3), (0, 3)], "height": 2.5})
        finish = {"walls": "white", "floor": {"material": floor}}
        looks = room_looks(Room.model_validate({**room.model_dump(), "finish": finish}))
        assert found(looks.floor.texture) is not None and found(looks.wall.texture) is not None


def test_names_of_earlier_versions_are_patterns():
    assert [found(old).name for old in ("wood", "fabric", "stone", "metal", "leaf")] == [
        "oak",
        "weave",
        "granite",
        "brushed",
        "leaf",
    ]
    assert kind_of("wood") == "wood" and kind_of("plain") == "plain" and kind_of("what a user has") == "plain"
    assert maps("plain") is None


def test_an_unknown_texture_is_one_clear_line():
    with pytest.raises(InputError, match=r'texture: \'okk\' is unknown; did you mean "oak"'):
        maps("okk")


def test_maps_are_kept_in_a_file_and_made_again_when_it_is_broken(folder):
    made = maps("plastic")
    assert maps("plastic") is made
    (path,) = library.cache_folder().glob("plastic-*.npz")
    older = path.with_name("plastic-256-0123456789ab.npz")
    older.write_bytes(b"of an earlier version")
    for content in (path.read_bytes(), b"broken"):
        path.write_bytes(content)
        library._of_pattern.cache_clear()
        again = maps("plastic")
        assert again is not made and np.array_equal(again.tint, made.tint) and again.gain == made.gain
    assert len(path.read_bytes()) > 1000 and not older.exists()


def _save(folder, name, size, value, mode="RGB"):
    folder.mkdir(parents=True, exist_ok=True)
    Image.new(mode, size, value).save(folder / name)


def test_a_folder_of_the_user_takes_the_place_of_a_pattern(folder):
    place = folder / "oak"
    _save(place, "Wood051_2K-PNG_Color.png", (200, 130), (180, 120, 60))
    _save(place, "Wood051_2K-PNG_NormalDX.png", (200, 130), (1, 2, 3))
    _save(place, "Wood051_2K-PNG_NormalGL.png", (200, 130), (120, 130, 250))
    _save(place, "Wood051_2K-PNG_Roughness.png", (200, 130), 90, "L")
    (place / "texture.yaml").write_text("size: [2.0, 0.5]\n")
    made = maps("oak")
    assert made.size == (2.0, 0.5) and made.tint.shape == (128, 128, 3)
    assert np.allclose(to_linear(made.tint / 255.0) * made.gain, 1, atol=0.01)
    assert (made.normal == (120, 130, 250)).all() and made.metallic is None
    assert np.allclose(made.roughness / 255 * made.rough_gain, 1, atol=0.01)


def test_names_of_poly_haven_are_read(folder):
    place = folder / "my wall"
    _save(place, "wall_diff_1k.jpg", (64, 64), (200, 200, 200))
    _save(place, "wall_nor_gl_1k.png", (64, 64), (128, 128, 255))
    _save(place, "wall_rough_1k.png", (64, 64), 200, "L")
    _save(place, "wall_metalness_1k.png", (64, 64), 255, "L")
    made = maps("my wall")
    assert made.size == (1.0, 1.0) and (made.metallic == 255).all()


@pytest.mark.parametrize(
    ("files", "line"),
    [
        ({}, "has no colour image"),
        ({"a_Color.png": b"none"}, "cannot be read"),
        ({"a_Color.png": None, "texture.yaml": b"size: [1, 2, 3]"}, "size has to be metres"),
        ({"a_Color.png": None, "texture.yaml": b"size: nan"}, "size has to be metres"),
        ({"a_Color.png": None, "texture.yaml": b"[[["}, "cannot be read as YAML"),
    ],
)
def test_bad_folders_are_one_clear_line(folder, files, line):
    place = folder / "mine"
    place.mkdir(parents=True)
    for name, content in files.items():
        if content is None:
            _save(place, name, (32, 32), (9, 9, 9))
        else:
            (place / name).write_bytes(content)
    with pytest.raises(InputError, match=line) as error:
        maps("mine")
    assert "\n" not in str(error.value)


def _box(size, texture, turn=None, at=(0.0, 0.0, 0.0)) -> Mesh:
    turn = np.eye(3) if turn is None else turn
    d, w, h = (v / 2 for v in size)
    vertices, faces = prism_mesh(np.array([[-d, -w], [d, -w], [d, w], [-d, w]]), (-h, h))
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(vertices @ turn.T + at, faces, zeros, zeros, (Material("look", (0.5, 0.5, 0.5), texture=texture),))


def _lengths(points: np.ndarray) -> np.ndarray:
    return np.linalg.norm(points - np.roll(points, 1, axis=1), axis=2)


def test_boxes_are_laid_out_in_metres_with_the_grain_along_them():
    for size, axis in (((1.2, 0.1, 0.04), 0), ((0.05, 0.05, 0.7), 2)):
        mesh = _box(size, "oak")
        uv, corners = uv_of(mesh), mesh.vertices[mesh.faces]
        assert uv.shape == (12, 3, 2) and uv.dtype == np.float32 and uv_of(mesh) is uv
        assert np.allclose(_lengths(uv), _lengths(corners), atol=1e-5)
        sides = np.ptp(corners[..., axis], axis=1) > 0.01
        assert np.allclose(np.ptp(uv[sides, :, 0], axis=1), size[axis], atol=1e-5)


def test_a_leg_that_leans_has_its_grain_along_itself():
    angle = 0.3
    turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    mesh = _box((0.04, 0.05, 0.7), "walnut", turn)
    assert np.allclose(_lengths(uv_of(mesh)), _lengths(mesh.vertices[mesh.faces]), atol=1e-5)
    assert np.isclose(np.ptp(uv_of(mesh)[..., 0], axis=1).max(), 0.7, atol=1e-5)


def test_boards_of_one_size_show_different_parts_of_the_pattern():
    first, second = (uv_of(_box((0.8, 0.1, 0.02), "oak", at=(0.0, 0.0, z))) for z in (0.1, 0.4))
    assert np.abs(first - second).max() > 0.01


def test_walls_have_u_level_and_v_up_and_floors_x_and_y():
    angle = 0.5
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    mesh = _box((3.0, 0.1, 2.5), "metro tiles", turn, (1.0, 2.0, 1.25))
    uv, corners = uv_of(mesh), mesh.vertices[mesh.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lying = np.abs(normal[:, 2]) > 1e-6
    assert np.allclose(uv[lying], corners[lying][..., :2], atol=1e-5)
    assert np.allclose(uv[~lying, :, 1], corners[~lying][..., 2], atol=1e-5)
    assert np.allclose(_lengths(uv), _lengths(corners), atol=1e-4)
    # Seen from outside u runs to the right: what is drawn is not mirrored.
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    turned = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    assert (turned[~lying] > 0).all()


def test_what_a_mesh_says_itself_is_taken():
    mesh = _box((1.0, 1.0, 1.0), "oak")
    own = np.zeros((12, 3, 2), dtype=np.float32)
    assert uv_of(replace(mesh, uv=own)) is own
