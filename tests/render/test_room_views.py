"""Pictures of whole rooms: what they show, what is cut away, how the shell is built, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets import Material, make
from sceneweaver.render import EyeLevel, Quality, draw_room, draw_rooms
from sceneweaver.render.blocks import FLOORS, Builder, finishes_of
from sceneweaver.render.instances import hidden_with, instances_of
from sceneweaver.render.shell import STUB, add_wall_finish, build_shell, floor_mesh
from sceneweaver.render.viewpoints import corner_camera, corner_directions, cut_walls, opposite
from sceneweaver.render.views import corner_light, glows_of
from sceneweaver.scene import Door, InputError, Pose, Room, RoomFinish, Scene, Window
from tests.render.scenes import ZOO, box, everything, room_of

QUICK = Quality(rays=1, levels=1, windows=1, lamps=1, bounces=1)
L_ROOM = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))


def furnished() -> Scene:
    """A bed, a picture on the far wall and one on the near one, a pendant."""
    bed = make("bed", seed=1).object("bed", pose=Pose.from_yaw(1.2, 1.5, 0.0, 0.0))
    picture = {"category": "picture", "size": (0.03, 0.6, 0.5), "mount": "wall"}
    back = box("back", 0.015, 2.5, z=1.4, **picture)
    side = box("side", 2.0, 0.015, z=1.4, yaw=np.pi / 2, **picture)
    lamp = box("lamp", 2.5, 1.5, z=2.2, size=(0.4, 0.4, 0.3), mount="ceiling", category="pendant_lamp")
    room = Room(
        outline=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)),
        windows=(Window(id="w", wall=3, offset=0.8, width=1.4, sill=0.9, height=1.3),),
    )
    return room_of(bed, back, side, lamp, room=room)


def load(asset_id: str):
    category, _, seed = asset_id.removeprefix("parametric:").partition("?seed=")
    return make(category, seed=int(seed))


@pytest.mark.parametrize("view", ["corner", "corner2", "top"])
def test_pictures_have_the_size_asked_for_and_show_something(view: str) -> None:
    picture = draw_room(furnished(), load, view, 96, 72, QUICK)
    assert picture.size == (96, 72) and picture.mode == "RGB"
    pixels = np.asarray(picture, dtype=float)
    assert pixels.std() > 12 and 90 < pixels.mean() < 245


def test_what_hangs_from_the_ceiling_hides_nothing() -> None:
    scene = furnished()
    assert hidden_with(scene, ()) == {"lamp"}
    bare = scene.model_copy(update={"objects": tuple(o for o in scene.objects if o.id != "lamp")})
    for view in ("corner", "top"):
        with_lamp, without = (np.asarray(draw_room(s, load, view, 64, 48, QUICK), dtype=float) for s in (scene, bare))
        assert np.abs(with_lamp - without).mean() < 2.0  # the noise of the light


def test_a_room_is_seen_at_eye_level() -> None:
    room = EyeLevel(furnished(), load, 64 / 48)
    assert len(room.cameras) == 3
    pixels = np.asarray(room.draw("eye-corner", 64, 48, QUICK), dtype=float)
    assert pixels.shape == (48, 64, 3) and pixels.std() > 12 and 60 < pixels.mean() < 245


def test_views_of_one_call_are_those_of_single_calls() -> None:
    scene = furnished()
    both = draw_rooms(scene, load, ("top", "corner"), 64, 48, QUICK)
    assert list(both) == ["top", "corner"]
    for view, picture in both.items():
        assert np.array_equal(np.asarray(picture), np.asarray(draw_room(scene, load, view, 64, 48, QUICK)))


@pytest.mark.parametrize("name", ["living-dining-L", "studio-U", "bedroom-small"])
def test_scenes_without_assets_are_drawn(name: str) -> None:
    drawn = draw_rooms(Scene.load(ZOO / f"{name}.json"), None, ("corner", "top"), 64, 48, QUICK)
    assert all(np.asarray(picture).std() > 10 for picture in drawn.values())


def test_a_turned_room_with_all_kinds_of_doors_is_drawn_in_all_views() -> None:
    assert len(draw_rooms(everything(), None, ("corner", "corner2", "top", "top_annotated"), 64, 48, QUICK)) == 4


def test_every_point_of_the_room_is_in_the_picture() -> None:
    for outline in (L_ROOM, tuple((3 * x, y) for x, y in L_ROOM)):
        scene = Scene(id="s", room=Room(outline=outline))
        for way in corner_directions(scene):
            cut = cut_walls(scene, way)
            camera = corner_camera(scene, way, cut, 4 / 3)
            shell = build_shell(scene.room, finishes_of(scene), cut)
            points = np.concatenate([shell.floor.vertices, *(w.vertices for w in shell.walls if w is not None)])
            rel = points - np.asarray(camera.eye)
            for axis in (camera.right, camera.up):
                across = rel @ np.asarray(axis) / np.dot(axis, axis) / (rel @ np.asarray(camera.forward))
                assert np.abs(across).max() < 1.0
                assert across.max() + across.min() == pytest.approx(0.0, abs=0.12)


def test_walls_before_the_room_are_stubs_and_the_others_stand() -> None:
    scene = furnished()
    way = corner_directions(scene)[0]
    cut = cut_walls(scene, way)
    assert len(cut) == 2
    shell = build_shell(scene.room, finishes_of(scene), cut)
    for k, wall in enumerate(shell.walls):
        assert wall is not None
        assert wall.bounds[1, 2] == pytest.approx(STUB if k in cut else scene.room.height)


def test_no_wall_of_a_notch_stands_before_the_floor_behind_it() -> None:
    scene = Scene(id="s", room=Room(outline=L_ROOM))
    for way in corner_directions(scene):
        turned = {w.index for w in scene.room.walls if float(np.dot(w.outward, way)) > 0.12}
        more = cut_walls(scene, way) - turned
        assert more <= {2, 3}  # those of the notch; from some corners they hide nothing
    assert any(len(cut_walls(scene, way)) > 3 for way in corner_directions(scene))


def test_what_hangs_on_a_cut_wall_goes_with_it_and_what_stands_on_that() -> None:
    scene = furnished()
    assert hidden_with(scene, {3}) == {"back", "lamp"} and hidden_with(scene, {0}) == {"side", "lamp"}
    assert hidden_with(scene, {1, 2}) == {"lamp"}


def test_the_camera_looks_at_fronts() -> None:
    # The bed and the picture look along +x: they are seen from there.
    ways = corner_directions(furnished())
    assert ways[0][0] > 0 and opposite(ways) @ ways[0] == pytest.approx(-1.0)


@pytest.mark.parametrize(("swing", "hinge"), [("in-left", 1.0), ("in-right", 1.9)])
def test_doors_stand_ajar_from_the_hinge_that_their_swing_names(swing, hinge: float) -> None:
    door = Door(id="d", wall=0, offset=1.0, width=0.9, height=2.0, swing=swing)
    room = Room(outline=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), doors=(door,))
    mesh = build_shell(room, finishes_of(Scene(id="s", room=room))).walls[0]
    assert mesh is not None
    # What reaches farthest into the room is the leaf's free end, away from its hinge.
    x = float(mesh.vertices[np.argmax(mesh.vertices[:, 1]), 0])
    assert abs(x - hinge) > 0.6


@pytest.mark.parametrize("kind", FLOORS)
def test_floors_cover_their_plan_and_no_more(kind: str) -> None:
    plan = np.array(L_ROOM)
    mesh = floor_mesh(Material(kind, (0.5, 0.5, 0.5)), plan)
    corners = mesh.vertices[mesh.faces]
    lid = np.abs(corners[:, :, 2]).max(axis=1) < 1e-9
    a, b, c = (corners[lid, k, :2] for k in range(3))
    area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert area.min() > -1e-9
    assert 0.95 * 14.0 < area.sum() <= 14.0 + 1e-6
    assert mesh.bounds[1, 2] == pytest.approx(0.0, abs=1e-9)


def finished(scene: Scene, **finish) -> Scene:
    return scene.model_copy(update={"room": scene.room.model_copy(update={"finish": RoomFinish(**finish)})})


def test_finishes_come_from_the_scene_else_from_the_room() -> None:
    scene = furnished()
    assert finishes_of(scene).looks.floor_kind == "wood"
    bath = scene.model_copy(update={"room": scene.room.model_copy(update={"type": "small_bathroom"})})
    assert finishes_of(bath).looks.floor_kind == "tile"
    look = finishes_of(finished(scene, walls="sage", floor={"material": "stone", "tone": "sand"}))
    assert look.looks.floor_kind == "stone" and look.looks.floor.color[0] > look.looks.floor.color[2]
    paint = look.wall(0).color
    assert paint[1] > max(paint[0], paint[2])


def test_an_accent_wall_is_painted_and_the_others_are_not() -> None:
    scene = finished(furnished(), walls="white", accent={"kind": "paint", "color": "navy", "walls": [2]})
    shell = build_shell(scene.room, finishes_of(scene))
    names = [{m.name for m in mesh.materials} for mesh in shell.walls if mesh is not None]
    assert ["navy wall" in found for found in names] == [k == 2 for k in range(len(names))]


@pytest.mark.parametrize(
    ("finish", "thick"),
    [
        ({"accent": {"kind": "paper", "color": "sage", "walls": [1]}}, 0.002),
        ({"accent": {"kind": "panelling", "color": "sage", "walls": [1]}}, 0.02),
        ({"tiles": {"color": "white", "low": 0.2, "high": 2.0, "walls": [1]}}, 0.004),
    ],
)
def test_what_is_on_a_wall_is_thin_and_leaves_its_openings_free(finish, thick: float) -> None:
    room = furnished().room.model_copy(update={"windows": (), "doors": ()})
    window = Window(id="w", wall=1, offset=0.5, width=1.0, sill=0.5, height=1.0)
    room = room.model_copy(update={"windows": (window,), "finish": RoomFinish(**finish)})
    builder, plain = Builder(), Builder()
    look = finishes_of(Scene(id="s", room=room))
    add_wall_finish(builder, room, room.walls[1], look, room.height)
    add_wall_finish(plain, room, room.walls[0], look, room.height)
    mesh = builder.mesh()
    assert mesh is not None and plain.mesh() is None
    along, deep = room.walls[1].coordinates(mesh.vertices[:, :2].T)
    assert deep.min() >= -1e-6 and deep.max() <= thick + 1e-9
    assert along.min() > -1e-6 and along.max() < room.walls[1].length + 1e-6
    corners = np.stack([along, mesh.vertices[:, 2]], axis=1)[mesh.faces]
    middle = corners.mean(axis=1)
    inside = (abs(middle[:, 0] - 1.0) < 0.48) & (abs(middle[:, 1] - 1.0) < 0.48)
    assert not inside.any()


@pytest.mark.parametrize(
    ("finish", "message"),
    [
        ({"walls": "octarine"}, r"room\.finish\.walls: 'octarine' is unknown"),
        ({"floor": {"tone": "octarine"}}, r"room\.finish\.floor\.tone: 'octarine' is unknown"),
        ({"tiles": {"color": "octarine", "high": 1.0}}, r"room\.finish\.tiles\.color: 'octarine' is unknown"),
    ],
)
def test_unknown_finishes_are_refused(finish, message: str) -> None:
    with pytest.raises(InputError, match=message):
        finishes_of(finished(furnished(), **finish))


def test_unknown_views_sizes_and_assets_are_refused() -> None:
    with pytest.raises(InputError, match="view: 'korner' is unknown"):
        draw_room(furnished(), load, "korner")
    with pytest.raises(InputError, match="width, height: 4 x 4 pixels are too few"):
        draw_room(furnished(), load, "corner", 4, 4)
    lost = room_of(box("x", 1, 1, asset="nowhere:thing"))

    def missing(asset_id: str):
        raise InputError(f"asset: '{asset_id}' is not there")

    with pytest.raises(InputError, match=r"objects\[0\]\.asset: 'nowhere:thing' is not there"):
        draw_room(lost, missing, "corner", 32, 32, QUICK)


def test_an_object_of_another_size_than_its_asset_is_scaled() -> None:
    asset = make("desk", seed=3)
    thing = asset.object("desk", pose=Pose.from_yaw(1, 1, 0, 0.5))
    d, w, h = thing.size
    scene = room_of(thing.model_copy(update={"size": (d, 2 * w, h)}))
    (one,) = instances_of(scene, lambda _: asset)
    assert np.allclose(np.linalg.norm(one.transform[:3, :3], axis=0), (1, 2, 1), atol=1e-5)


def test_sun_comes_in_by_the_window() -> None:
    scene = furnished()
    way = corner_directions(scene)[0]
    light = corner_light(scene.room, way, cut_walls(scene, way), [])
    # The window is in the wall at x = 0, whose outside is -x.
    assert light.beam[0] < 0 < light.beam[2] and light.portals
    bare = scene.room.model_copy(update={"windows": ()})
    assert corner_light(bare, way, set(), []).portals == ()


def test_lamps_are_found_where_they_glow() -> None:
    lamp = make("floor_lamp", seed=1)
    desk = make("desk", seed=1)
    scene = room_of(desk.object("d", pose=Pose.from_yaw(1, 1, 0, 0)), lamp.object("l", pose=Pose.from_yaw(3, 2, 0, 0)))
    found = glows_of(instances_of(scene, lambda name: lamp if "lamp" in name else desk))
    assert len(found) == 1
    assert found[0][:2] == pytest.approx((3, 2), abs=0.3) and found[0][2] > 0.8


def test_notes_grow_the_picture_by_edge_and_key() -> None:
    drawn = draw_rooms(everything(), None, ("top", "top_annotated"), 320, 240, QUICK)
    top, notes = drawn["top"], drawn["top_annotated"]
    assert notes.width > top.width and notes.height > top.height
    # The axes: red along x, green along y, somewhere in the picture.
    pixels = np.asarray(notes).astype(int)
    red = (pixels[..., 0] > 170) & (pixels[..., 1] < 90) & (pixels[..., 2] < 90)
    green = (pixels[..., 1] > 120) & (pixels[..., 0] < 90) & (pixels[..., 2] < 110)
    assert red.sum() > 10 and green.sum() > 10
