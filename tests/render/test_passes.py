"""Data passes against geometry: depth, normals, ids, positions against ray casts; cameras and files there and back."""

from __future__ import annotations

import json

import numpy as np
import pytest
from PIL import Image

from sceneweaver.assets import make
from sceneweaver.render import Quality
from sceneweaver.render.camera import Camera, Shot, shot_from
from sceneweaver.render.pass_files import read_shots, write_passes
from sceneweaver.render.passes import ARRAYS, PASSES, PassRenderer, auto_shots, class_named, class_names
from sceneweaver.render.viewpoints import EYE_VIEWS
from sceneweaver.render.views import Inside
from sceneweaver.scene import Door, InputError, MissingDependencyError, Pose, Room, Scene, Window
from tests.render.scenes import box, rectangle, room_of
from tests.render.test_eye_camera import brute_force

QUICK = Quality.draft()
WIDTH, HEIGHT = 32, 24


def furnished() -> Scene:
    stool = make("stool", seed=1).object("stool", pose=Pose.from_yaw(2.2, 1.2, 0.0, 0.7))
    room = Room(
        type="bedroom",
        outline=rectangle(4.0, 3.0),
        doors=(Door(id="door", wall=0, offset=0.5, width=0.9, height=2.0),),
        windows=(Window(id="window", wall=1, offset=0.8, width=1.4, sill=0.9, height=1.2),),
    )
    bed = box("bed", 2.9, 2.2, size=(1.0, 1.4, 0.5), yaw=np.pi / 2, category="bed")
    return room_of(bed, stool, room=room)


def load(_: str):
    return make("stool", seed=1)


@pytest.fixture(scope="module")
def renderer() -> PassRenderer:
    scene = furnished()
    shots = auto_shots(scene, WIDTH, HEIGHT)
    steep = Camera.look_at((0.4, 0.5, 2.2), (2.5, 1.8, 0.2), 1.0, WIDTH / HEIGHT)
    return PassRenderer(scene, [*shots, Shot("steep", steep, WIDTH, HEIGHT)], load, QUICK)


class Grey:
    """A grey picture."""

    def __init__(self, width: int, height: int) -> None:
        self.rgb = np.full((height, width, 3), 188, np.uint8)
        self.linear = np.full((height, width, 3), 2.5, np.float32)


@pytest.fixture(autouse=True, scope="module")
def no_light():
    """Casting light takes long: pictures are grey here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Inside, "picture", lambda self, _, width, height, *__: Grey(width, height))
        yield


@pytest.fixture(scope="module")
def frames(renderer):
    return {frame.shot.name: frame for frame in renderer.frames()}


def test_every_camera_has_all_arrays(frames) -> None:
    assert tuple(frames) == (*EYE_VIEWS, "steep")
    for frame in frames.values():
        assert tuple(frame.arrays) == sum(ARRAYS.values(), ())
        assert all(array.shape[:2] == (HEIGHT, WIDTH) for array in frame.arrays.values())
        assert frame.arrays["rgb"].dtype == np.uint8


def test_depth_distance_and_ids_are_those_of_a_plain_search(renderer, frames) -> None:
    from sceneweaver.render.blocks import finishes_of
    from sceneweaver.render.instances import instances_of
    from sceneweaver.render.interior import build_interior

    scene = furnished()
    cameras = [shot.camera for shot in renderer.shots]
    bodies = [(one.mesh, one.transform) for one in instances_of(scene, load)]
    bodies += [(part.mesh, np.eye(4)) for part in build_interior(scene, finishes_of(scene), cameras)]
    for name in ("eye-corner", "steep"):
        frame = frames[name]
        rows, columns = np.mgrid[1:HEIGHT:4, 1:WIDTH:4]
        # Rays by the matrix K and the pose as OpenCV has it, not by what the passes were cast with.
        pixels = np.stack([columns + 0.5, rows + 0.5, np.ones_like(rows)], axis=-1).reshape(-1, 3)
        pose = frame.shot.camera_to_world_opencv
        way = pixels @ np.linalg.inv(frame.shot.k).T @ pose[:3, :3].T
        length = np.linalg.norm(way, axis=1)
        origin = np.broadcast_to(pose[:3, 3], way.shape)
        found = []
        for mesh, place in bodies:
            corners = (mesh.vertices @ place[:3, :3].T + place[:3, 3])[mesh.faces]
            found.append(search(origin, way / length[:, None], corners))
        distance = np.min(found, axis=0)
        got = frame.arrays["distance"][rows, columns].reshape(-1)
        assert np.allclose(got, distance, atol=2e-3)
        # The third coordinate of the rays of K is 1: their length brings distance to depth.
        assert np.allclose(frame.arrays["depth"][rows, columns].reshape(-1), distance / length, atol=2e-3)
        instance = frame.arrays["instance"][rows, columns].reshape(-1)
        first = np.argmin(found, axis=0) + 1
        second = np.sort(found, axis=0)[1]
        clear = second - distance > 2e-3  # where two bodies touch either may be seen
        assert clear.mean() > 0.8 and np.array_equal(instance[clear], first[clear])


def search(origin: np.ndarray, way: np.ndarray, corners: np.ndarray) -> np.ndarray:
    parts = [corners[k : k + 2000] for k in range(0, len(corners), 2000)]
    flat = [np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) > 1e-12 for p in parts]
    with np.errstate(all="ignore"):
        return np.min([brute_force(origin, way, p[keep]) for p, keep in zip(parts, flat, strict=True)], axis=0)


def test_ids_name_objects_and_parts_of_the_room(renderer, frames) -> None:
    rows = {row["id"]: row for row in renderer.labels.instances}
    assert [rows[1]["name"], rows[2]["name"]] == ["bed", "stool"] and rows[1]["of"] == "object"
    names = {row["name"] for row in rows.values()}
    assert {"floor", "ceiling", "wall:0", "wall:3", "door", "window"} <= names
    classes = {row["id"]: row["name"] for row in renderer.labels.semantics}
    for frame in frames.values():
        for number in np.unique(frame.arrays["instance"]):
            seen = frame.arrays["instance"] == number
            assert (frame.arrays["semantic"][seen] == rows[number]["semantic"]).all()
    assert classes[rows[1]["semantic"]] == "bed" and classes[rows[2]["semantic"]] == "chair"
    assert {classes.get(row["semantic"]) for row in rows.values() if row["name"] == "door"} == {"door"}
    shown = {rows[k]["name"] for frame in frames.values() for k in np.unique(frame.arrays["instance"])}
    assert {"bed", "stool", "floor", "ceiling", "window"} <= shown
    materials = {row["id"] for row in renderer.labels.materials}
    assert all(set(np.unique(frame.arrays["material"])) <= materials for frame in frames.values())


def test_normals_are_unit_and_face_the_camera(frames) -> None:
    for frame in frames.values():
        world, camera = frame.arrays["normal_world"], frame.arrays["normal_cam"]
        assert np.allclose(np.linalg.norm(world, axis=-1), 1.0, atol=1e-4)
        way = frame.shot.camera.rays(WIDTH, HEIGHT)
        assert ((world * way).sum(axis=-1) < 1e-4).all()
        # In the camera's frame z points back at it, and the ray through a pixel forward.
        assert np.allclose(camera, world @ frame.shot.camera_to_world[:3, :3], atol=1e-5)
        floor = frame.arrays["position"][..., 2] < 1e-4
        assert np.allclose(world[floor & (frame.arrays["semantic"] == 2)], (0, 0, 1), atol=1e-4)


def test_positions_are_seen_where_they_are(frames) -> None:
    for frame in frames.values():
        points = frame.arrays["position"].reshape(-1, 3)
        world_to_camera = np.array(frame.shot.to_dict()["world_to_camera_opencv"])
        seen = points @ world_to_camera[:3, :3].T + world_to_camera[:3, 3]
        pixels = seen @ frame.shot.k.T
        x, y = (pixels[:, :2] / pixels[:, 2:]).T
        columns, rows = np.meshgrid(np.arange(WIDTH) + 0.5, np.arange(HEIGHT) + 0.5)
        assert np.allclose(x, columns.reshape(-1), atol=1e-2) and np.allclose(y, rows.reshape(-1), atol=1e-2)
        assert np.allclose(seen[:, 2], frame.arrays["depth"].reshape(-1), atol=1e-4)


def test_a_shifted_lens_moves_the_optical_centre() -> None:
    shot = Shot("a", Camera.level((0, 0, 1.5), 0.3, 1.2, 4 / 3, -0.2), 400, 300)
    assert shot.k[1, 2] == pytest.approx(150 * 0.8) and shot.k[0, 2] == pytest.approx(200)
    assert shot.k[0, 0] == pytest.approx(200 / np.tan(0.6)) == pytest.approx(shot.k[1, 1])
    assert shot.to_dict()["shift_y"] == pytest.approx(-30 / 400)


@pytest.mark.parametrize("keys", [("K", "camera_to_world_opencv"), ("fx", "fy", "cx", "cy", "camera_to_world_blender")])
def test_cameras_are_read_as_they_are_written(keys) -> None:
    shot = Shot("a", Camera.level((1, 2, 1.5), 0.3, 1.2, 4 / 3, -0.2), 400, 300)
    data = {name: value for name, value in shot.to_dict().items() if name in (*keys, "name", "width", "height")}
    again = shot_from(json.loads(json.dumps(data)), "b", 10, 10)
    assert (again.name, again.width, again.height) == ("a", 400, 300)
    for key in ("eye", "forward", "right", "up"):
        assert np.allclose(getattr(again.camera, key), getattr(shot.camera, key))


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ([], "camera-0: is no object"),
        ({"target": [0, 0, 1]}, "camera-0: has no 'eye'"),
        ({"fx": 1.0}, "camera-0: has no 'cx'"),
        ({"eye": [0, 0, "x"], "target": [1, 0, 0]}, "camera-0: makes no camera"),
        ({"K": [[1, 0, 0]], "camera_to_world_opencv": np.eye(4).tolist()}, "camera-0: makes no camera"),
        ({"K": np.eye(3).tolist(), "camera_to_world_opencv": (2 * np.eye(4)).tolist()}, "the pose is no rotation"),
    ],
)
def test_bad_cameras_are_one_line(tmp_path, data, message: str) -> None:
    (tmp_path / "c.json").write_text(json.dumps({"cameras": [data]}))
    with pytest.raises(InputError, match=message):
        read_shots(tmp_path / "c.json", 40, 30)


def test_bad_files_of_cameras_are_one_line(tmp_path) -> None:
    with pytest.raises(InputError, match="--cameras: .*none.json: no such file"):
        read_shots(tmp_path / "none.json", 40, 30)
    (tmp_path / "c.json").write_text("{")
    with pytest.raises(InputError, match="--cameras: .*c.json: invalid JSON: it ends too early"):
        read_shots(tmp_path / "c.json", 40, 30)
    (tmp_path / "c.json").write_text("{}")
    with pytest.raises(InputError, match="has no list of cameras"):
        read_shots(tmp_path / "c.json", 40, 30)


def test_png_files(renderer, frames, tmp_path) -> None:
    written = write_passes(renderer, tmp_path / "out", ["depth", "instance", "normal"])
    assert {path.name for path in (tmp_path / "out").iterdir()} == {path.name for path in written}
    frame = frames["steep"].arrays
    depth = np.asarray(Image.open(tmp_path / "out" / "steep_depth.png"))
    assert depth.dtype == np.uint16 and np.abs(depth - frame["depth"] * 1000).max() <= 0.5
    assert np.array_equal(np.asarray(Image.open(tmp_path / "out" / "steep_instance.png")), frame["instance"])
    normal = np.asarray(Image.open(tmp_path / "out" / "steep_normal_world.png")) / 127.5 - 1
    assert np.abs(normal - frame["normal_world"]).max() < 0.005
    cameras = read_shots(tmp_path / "out" / "cameras.json", 1, 1)
    assert [shot.name for shot in cameras] == [*EYE_VIEWS, "steep"] and cameras[0].width == WIDTH
    labels = json.loads((tmp_path / "out" / "labels.json").read_text())
    assert labels["instances"][0] == {"id": 1, "name": "bed", "category": "bed", "of": "object", "semantic": 4}
    assert [row["name"] for row in labels["semantics"]] == list(class_names())


def test_npz_files(renderer, frames, tmp_path) -> None:
    write_passes(renderer, tmp_path, PASSES, "npz")
    frame = frames["eye-door"]
    with np.load(tmp_path / "eye-door.npz") as data:
        assert np.array_equal(data["semantic_instance"], frame.arrays["instance"])
        assert np.array_equal(data["depth_meters"], frame.arrays["distance"])
        assert (data["color"] == 2.5).all() and (data["rgb"] == 188).all()
        assert np.allclose(data["K"], frame.shot.k)


def test_exr_files(renderer, frames, tmp_path) -> None:
    openexr = pytest.importorskip("OpenEXR")
    write_passes(renderer, tmp_path, ["rgb", "depth", "normal", "instance", "semantic"], "exr")
    with openexr.File(str(tmp_path / "steep.exr"), separate_channels=True) as file:
        channels = {name: np.array(channel.pixels) for name, channel in file.channels().items()}
    arrays = frames["steep"].arrays
    expected = {"Combined.R", "Combined.G", "Combined.B", "Depth.Z", "Distance.Z", "IndexOB.X", "Semantic.X"}
    expected |= {f"{layer}.{axis}" for layer in ("Normal", "NormalCamera") for axis in "XYZ"}
    assert set(channels) == {f"ViewLayer.{name}" for name in expected}
    assert np.array_equal(channels["ViewLayer.Depth.Z"], arrays["depth"])
    assert np.array_equal(channels["ViewLayer.IndexOB.X"], arrays["instance"])
    assert (channels["ViewLayer.Combined.G"] == 2.5).all()  # the light itself
    assert np.array_equal(channels["ViewLayer.Normal.Y"], arrays["normal_world"][..., 1])


def test_without_openexr_the_extra_is_named(renderer, tmp_path, monkeypatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "OpenEXR", None)
    with pytest.raises(MissingDependencyError, match=r"\(extra 'exr'\); install it with: pip install 'openexr"):
        write_passes(renderer, tmp_path, ["depth"], "exr")
    assert not list(tmp_path.iterdir())


def test_what_cannot_be_asked_for_is_refused(renderer, tmp_path) -> None:
    with pytest.raises(InputError, match="passes: 'dept' is unknown; did you mean"):
        next(renderer.frames(["dept"]))
    with pytest.raises(InputError, match="format: 'tiff' is unknown"):
        write_passes(renderer, tmp_path, ["depth"], "tiff")
    shot = renderer.shots[0]
    with pytest.raises(InputError, match="two have the name 'eye-door'"):
        PassRenderer(furnished(), [shot, shot], load)
    flat = Shot("flat", Camera.orthographic((0, 0, 5), (0, 0, 0), 3.0), 8, 8)
    with pytest.raises(InputError, match="'flat' has no perspective"):
        PassRenderer(furnished(), [flat], load)
    strange = PassRenderer(furnished(), [Shot("../x", shot.camera, 8, 8)], load)
    with pytest.raises(InputError, match="makes no file name"):
        write_passes(strange, tmp_path, ["depth"])


@pytest.mark.parametrize(
    ("category", "name"),
    [("king_bed", "bed"), ("round dining table", "table"), ("bedside lamp", "lamp"), ("tv stand", "cabinet")],
)
def test_categories_have_classes(category: str, name: str) -> None:
    assert class_names()[class_named(category) - 1] == name


def test_nothing_is_found_in_words_that_name_no_class() -> None:
    assert class_named("zebra") == 0
