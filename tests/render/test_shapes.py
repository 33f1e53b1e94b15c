"""Outlines in the plane, the palette and the symbols."""

from __future__ import annotations

import math

import pytest
from PIL import Image, ImageChops

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.render import palette, shapes, symbols
from sceneweaver.render.canvas import Canvas
from sceneweaver.render.shapes import View, content, step_for
from sceneweaver.render.words import tables
from sceneweaver.scene import Pose, Room, Support, Surface
from tests.render.scenes import box, everything, rectangle, room_of

SQUARE = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))


def test_a_quarter_turn_takes_the_front_to_the_left():
    assert shapes.to_world(Pose.from_yaw(2.0, 3.0, 0.0, math.pi / 2), [(1.0, 0.0)])[0] == pytest.approx((2.0, 4.0))


def test_a_prism_that_lies_down_shows_its_height():
    half = math.sqrt(0.5)
    pose = Pose(position=(0.0, 0.0, 1.0), quaternion=(half, 0.0, 0.0, half))  # about x: up becomes -y
    prism = shapes.prism(pose, SQUARE, 0.0, 3.0)
    ys = [y for _, y in prism.polygon]
    assert (min(ys), max(ys)) == pytest.approx((-3.0, 0.0))
    assert (prism.bottom, prism.top) == pytest.approx((0.5, 1.5))
    assert signed_area(prism.polygon) == pytest.approx(3.0)


def test_layers_follow_supporters_and_survive_dangling_ones():
    assert shapes.layers(everything()) == {
        "shelf": 0,
        "inside": 1,
        "upon": 1,
        "picture": 100,
        "lamp": 100,
        "chair": 0,
    }
    top = (Surface(name="top", polygon=SQUARE, z=0.5),)
    tower = room_of(
        box("wall-shelf", 1.0, 1.0, mount="wall", surfaces=top),
        box("tray", 1.0, 1.0, mount="surface", support=Support(object="wall-shelf", surface="top"), surfaces=top),
        box("cup", 1.0, 1.0, mount="surface", support=Support(object="tray", surface="top")),
    )
    assert shapes.layers(tower) == {"wall-shelf": 100, "tray": 201, "cup": 202}


@pytest.mark.parametrize(
    ("a", "b", "share"),
    [
        ((-1, 0), (1, 0), (0.25, 0.75)),
        ((0, 0), (2, 0), (0, 0.25)),
        ((-1, 2), (1, 2), None),
        ((0, 0), (0.1, 0.1), (0, 1)),
    ],
)
def test_cut(a, b, share):
    found = shapes.cut(a, b, SQUARE)
    assert found == (None if share is None else pytest.approx(share))


def test_view_turns_y_downward():
    view = View(100.0, 1.0, 5.0)
    assert view.point((1.0, 5.0)) == (0.0, 0.0) and view.point((2.0, 4.0)) == (100.0, 100.0)


@pytest.mark.parametrize(("scale", "step"), [(100, 1), (20, 2), (8, 5), (4, 10), (1.8, 20), (0.4, 100)])
def test_ticks_get_coarser(scale, step):
    assert step_for(scale, 34) == step


def test_content_holds_near_objects_and_not_far_ones():
    room = Room(outline=rectangle(4.0, 3.0))
    near, far = box("a", 4.5, 1.0), box("b", 400.0, 1.0)
    assert content(room, shapes.prisms(near)).x1 == pytest.approx(4.75 + WALL_THICKNESS)
    assert content(room, shapes.prisms(far)).x1 < 6.0


def test_categories_keep_their_colours_and_families_differ():
    assert palette.category_color("coffee_table") == palette.category_color("Coffee Table")
    names = ("bed", "chair", "sofa", "table", "wardrobe", "plant", "lamp", "tv", "sink", "vase", "rug")
    assert len({palette.category_color(n) for n in names}) == len(names)
    assert palette.category_color("flux capacitor") == palette.category_color("flux_capacitor")
    assert palette.category_color("") == palette.category_color("椅子")


@pytest.mark.parametrize("color", ["red", "#00ff00", "deep sky blue", "rgb(255, 0, 255)", "yellow"])
def test_stated_colours_are_softened(color):
    fill = palette.fill_of(box("a", 0, 0, attributes={"color": color}))
    assert max(fill) - min(fill) < 130 and max(fill) < 250


@pytest.mark.parametrize("value", [None, 3, "", "  ", ["red"], "gibberish", "(" * 50])
def test_odd_colours_fall_back_to_the_category(value):
    assert palette.fill_of(box("a", 0, 0, attributes={"color": value})) == palette.category_color("box")


def test_text_reads_on_every_colour():
    assert palette.ink_on((20, 20, 20)) == palette.PAPER and palette.ink_on((230, 230, 220)) == palette.INK


@pytest.mark.parametrize("category", sorted({words.split()[0] for words in tables()["symbols"].values()}))
@pytest.mark.parametrize("size", [(0.2, 0.2), (0.6, 1.8), (2.1, 1.6)])
def test_symbols_stay_inside_their_box(category, size):
    depth, width = size
    for stroke in symbols.strokes_of(category, depth, width):
        assert len(stroke.points) >= 2
        assert all(abs(x) <= depth / 2 + 1e-6 and abs(y) <= width / 2 + 1e-6 for x, y in stroke.points)


def test_symbols_are_found_by_words_of_the_category():
    for category in ("bed", "king bed", "floor_lamp", "Office Chair", "plants"):
        assert symbols.strokes_of(category, 0.9, 1.4), category
    assert symbols.strokes_of("flux capacitor", 0.9, 1.4) == []


def test_hatching_stays_inside_and_lines_up():
    polygon = [(20.0, 20.0), (80.0, 20.0), (80.0, 80.0), (50.0, 40.0), (20.0, 80.0)]
    canvas = Canvas(100, 100, (255, 255, 255))
    canvas.hatch(polygon, (0, 0, 0), 1.0, 6.0)
    drawn = canvas.finish().convert("L").point([255 * (v < 200) for v in range(256)])
    allowed = Canvas(100, 100, (0, 0, 0))
    allowed.polygon(polygon, fill=(255, 255, 255), line=(255, 255, 255), width=3.0)
    outside = ImageChops.subtract(drawn, allowed.finish().convert("L"))
    assert drawn.getbbox() is not None and outside.getbbox() is None


def test_outline_goes_around_the_union_only():
    canvas = Canvas(100, 100, (255, 255, 255))
    left, right = [(20, 20), (55, 20), (55, 60), (20, 60)], [(45, 20), (80, 20), (80, 60), (45, 60)]
    canvas.outline([left, right], (200, 0, 0), 3.0)
    image = canvas.finish()
    assert image.getpixel((18, 40)) == (200, 0, 0) and image.getpixel((50, 40))[1] > 150
    assert image.getpixel((5, 5)) == (255, 255, 255)


def test_shapes_outside_of_the_picture_do_no_harm():
    canvas = Canvas(50, 50, (255, 255, 255))
    away = [(500.0, 500.0), (510.0, 500.0), (510.0, 510.0)]
    canvas.outline([away], (200, 0, 0), 3.0)
    canvas.overlap([away], [away], (200, 0, 0))
    canvas.shadow([(away, (1.0, 1.0))], away, (0, 0, 0, 90), 2.0)
    assert ImageChops.difference(canvas.finish(), Image.new("RGB", (50, 50), (255, 255, 255))).getbbox() is None
