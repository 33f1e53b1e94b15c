"""The annotated top view: what is drawn, and that nothing else changes it."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from PIL import Image

from sceneweaver.render import draw_top, save_top
from sceneweaver.render.topview import printable
from sceneweaver.scene import Dropped, InputError, Pose, Room
from tests.render.scenes import Violation, box, everything, rectangle, room_of, zoo


def pixels(scene, **options):
    return np.asarray(draw_top(scene, **{"width": 500, **options}), dtype=int)


def redness(image) -> int:
    return int(((image[..., 0] > 170) & (image[..., 1] < 110) & (image[..., 2] < 110)).sum())


@pytest.mark.parametrize("name", ["bedroom-small", "living-dining-L", "studio-U", "restaurant-60"])
@pytest.mark.parametrize("annotated", [True, False])
def test_zoo_rooms_are_drawn(name, annotated):
    image = draw_top(zoo(name), width=640, annotated=annotated)
    assert image.mode == "RGB" and image.width == 640
    assert 200 < image.height < 1200
    assert len(image.getcolors(640 * 1200)) > 100


def test_a_hall_of_300_objects_is_drawn_with_its_labels_thinned():
    image = draw_top(zoo("hall-300"))
    assert image.width == 1600 and 1600 < image.height < 2000


@pytest.mark.parametrize("width", [200, 333, 1000])
def test_width_is_as_asked(width):
    assert draw_top(everything(), width=width).width == width


@pytest.mark.parametrize("width", [0, 199, 10_000, -5])
def test_width_out_of_range_is_refused(width):
    with pytest.raises(InputError, match="width"):
        draw_top(everything(), width=width)


@pytest.mark.parametrize(
    "outline",
    [rectangle(2.0, 2.0), rectangle(0.5, 0.5), rectangle(200.0, 150.0), rectangle(40.0, 1.2), rectangle(1.2, 40.0)],
)
def test_rooms_of_any_size_keep_a_sensible_shape(outline):
    scene = room_of(box("a", 0.25, 0.25, size=(0.2, 0.2, 0.2)), room=Room(outline=outline))
    image = draw_top(scene, width=600)
    assert image.width == 600 and 120 < image.height < 900


def test_an_empty_room_is_drawn():
    assert draw_top(room_of(), width=300).width == 300


@pytest.mark.parametrize("annotated", [True, False])
def test_the_same_scene_gives_the_same_bytes(tmp_path, annotated):
    for name in ("one.png", "two.png"):
        save_top(everything(), tmp_path / name, width=500, annotated=annotated)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()


@pytest.mark.parametrize("scene", [zoo("studio-U"), zoo("restaurant-60"), everything()], ids=lambda s: s.id)
def test_the_order_of_objects_changes_nothing(scene):
    objects = list(scene.objects)
    random.Random(0).shuffle(objects)
    shuffled = scene.model_copy(update={"objects": tuple(objects)})
    assert np.array_equal(pixels(scene), pixels(shuffled))


def test_moving_the_whole_room_moves_only_numbers():
    """Without its annotation, a plan does not depend on where the origin is."""
    scene = room_of(box("a", 1.0, 1.0), box("b", 3.0, 2.0, yaw=0.3))
    moved = room_of(
        box("a", 11.0, -4.0),
        box("b", 13.0, -3.0, yaw=0.3),
        room=Room(outline=tuple((x + 10, y - 5) for x, y in rectangle(4.0, 3.0))),
    )
    assert np.abs(pixels(scene, annotated=False) - pixels(moved, annotated=False)).max() <= 30


def test_violating_objects_are_outlined_red():
    scene = room_of(box("a", 1.0, 1.0), box("b", 1.3, 1.0), box("c", 3.0, 2.0))
    plain, marked = (
        pixels(scene, annotated=False),
        pixels(scene, annotated=False, violations=[Violation("collision", ("a", "b"), "a sinks into b")]),
    )
    assert redness(plain) == 0 and redness(marked) > 100
    changed = np.argwhere((plain != marked).any(axis=2))
    assert changed[:, 1].max() < plain.shape[1] / 2  # c, in the right half, is as it was


def test_a_violation_is_spelt_out_and_the_title_says_not_valid():
    scene = room_of(box("a", 1.0, 1.0))
    violation = Violation("out_of_bounds", ("a",), "a reaches 2 cm out of the room")
    marked = draw_top(scene, width=500, violations=[violation])
    assert marked.height > draw_top(scene, width=500).height
    title = np.asarray(marked, dtype=int)[:40, 250:]
    assert redness(title) > 20
    assert not np.array_equal(np.asarray(marked), np.asarray(draw_top(scene, width=500, valid=True)))


def test_blocked_openings_and_walls_may_be_named_in_a_violation():
    scene = everything()
    violations = [
        Violation("blocked_opening", ("chair", "door-in")),
        Violation("relation", ("chair", "wall:2", "none")),
    ]
    assert redness(pixels(scene, violations=violations)) > redness(pixels(scene))


def test_a_soft_relation_marks_nothing():
    scene = room_of(box("a", 1.0, 1.0))
    soft = [Violation("soft_relation", ("a",), "a against_wall: gap 3 m")]
    assert redness(pixels(scene, violations=soft, valid=True)) == 0


def test_valid_not_valid_and_not_checked_look_different():
    scene = room_of(box("a", 1.0, 1.0))
    dropped = scene.model_copy(update={"dropped": (Dropped(id="b", category="bed", reason="no room"),)})
    heads = [
        pixels(s, valid=v)[:40].tobytes() for s, v in ((scene, True), (scene, False), (scene, None), (dropped, None))
    ]
    assert len(set(heads)) == 4


@pytest.mark.parametrize(
    "name",
    ["椅子-1", "Стул", "ﬁancé Ångström", "a" * 300, "-", "...", "🪑", "x_y-z 1", "1"],
)
def test_any_name_can_be_drawn(name):
    objects = [box(f"{name}{k}" if k else name, 0.5 + k, 1.0, category=name) for k in range(3)]
    scene = room_of(*objects, id=name, prompt=name)
    assert draw_top(scene, width=400, violations=[Violation("collision", (name,), name)]).width == 400


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain-1", "plain-1"),
        ("Ångström", "Angstrom"),
        ("straße", "strasse"),
        ("椅子-1", "??-1"),
        ("椅子", ""),
        (" a\n\tb ", "a b"),
        ("\x07bell", "?bell"),
    ],
)
def test_printable(text, shown):
    assert printable(text) == shown


def test_tilted_and_outlying_objects_are_drawn():
    tilted = box("tilted", 2.0, 1.5, size=(0.3, 0.3, 1.0))
    half = math.radians(80) / 2
    tilted = tilted.model_copy(
        update={"pose": Pose(position=(2.0, 1.5, 0.2), quaternion=(math.sin(half), 0.0, 0.0, math.cos(half)))}
    )
    image = pixels(room_of(tilted, box("far", 500.0, 500.0), box("near", -0.4, 1.0)))
    assert image.shape[1] == 500
    upright = pixels(
        room_of(box("tilted", 2.0, 1.5, size=(0.3, 0.3, 1.0)), box("far", 500.0, 500.0), box("near", -0.4, 1))
    )
    assert not np.array_equal(image, upright)


def test_colour_and_material_are_shown():
    looks = [{}, {"color": "#204080"}, {"color": "light green"}, {"material": "walnut"}, {"color": "no such colour"}]
    images = [pixels(room_of(box("a", 1.0, 1.0, attributes=look))).tobytes() for look in looks]
    assert len(set(images)) == 4 and images[0] == images[-1]


def test_save_replaces_a_file_and_leaves_nothing_else(tmp_path):
    target = tmp_path / "top.png"
    target.write_text("old")
    save_top(everything(), target, width=300)
    assert [p.name for p in tmp_path.iterdir()] == ["top.png"]
    with Image.open(target) as image:
        assert image.format == "PNG" and image.width == 300


def test_save_into_a_missing_folder_is_refused_in_one_line(tmp_path):
    with pytest.raises(InputError) as refused:
        save_top(everything(), tmp_path / "no" / "top.png", width=300)
    assert "\n" not in str(refused.value) and "folder" in str(refused.value)
