"""Plans of storeys: to scale, doors on their hinges, names on free floor, dimensions that add up."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ElementTree

import pytest
import shapely

import sceneweaver as sw
from sceneweaver.home import Home, HomeDoor, wall_openings
from sceneweaver.home.treads import treads
from sceneweaver.render.canvas import Canvas, Text, line_height, text_width
from sceneweaver.render.home import draw_plan, plan_picture
from sceneweaver.render.home.plan import MM
from sceneweaver.render.home.plan_dimensions import room_chain
from sceneweaver.render.home.plan_names import clear_area, room_titles
from sceneweaver.render.home.plan_walls import swept
from sceneweaver.render.shapes import Bounds
from tests.render.home.homes import flat, house

SVG = "{http://www.w3.org/2000/svg}"


def test_a_plan_is_to_scale_on_paper() -> None:
    """The walls of the example are 10.4 m long: 208 mm at 1:50."""
    root = ElementTree.fromstring(draw_plan(Home.example("flat")))
    _, _, width, _ = map(float, root.get("viewBox", "").split())
    assert float(root.get("width", "").removesuffix("mm")) == pytest.approx(width * MM, abs=0.2)
    xs = [float(p.split(",")[0]) for p in root.findall(f"{SVG}polygon")[0].get("points", "").split()]
    assert (max(xs) - min(xs)) * MM == pytest.approx(208, abs=0.1)
    assert any(text.text == "1:50" for text in root.iter(f"{SVG}text"))


def test_a_picture_has_the_width_that_is_asked_for_and_prints_at_the_same_scale() -> None:
    small, large = (plan_picture(Home.example("flat"), width=width) for width in (600, 1200))
    assert (small.width, large.width) == (600, 1200)
    assert small.width / small.info["dpi"][0] == pytest.approx(large.width / large.info["dpi"][0], rel=1e-6)


@pytest.mark.parametrize("home", [Home.example("flat"), house()], ids=["flat", "house"])
def test_leaves_swing_into_their_room_from_their_hinge(home: Home) -> None:
    for storey in home.storeys:
        for found in wall_openings(home, storey.id):
            door, leaves = found.opening, swept(home, found)
            if not isinstance(door, HomeDoor) or door.kind in ("open", "sliding"):
                assert not leaves
                continue
            assert len(leaves) == (2 if door.kind == "double" else 1)
            reach = door.width / len(leaves)
            for leaf in leaves:
                shape = shapely.Polygon(leaf)
                assert shape.area == pytest.approx(math.pi / 4 * reach**2, rel=0.01)
                if door.opens_into is not None:
                    room = shapely.Polygon(home.room(door.opens_into).outline)
                    assert room.intersection(shape).area == pytest.approx(shape.area, rel=1e-6)
            if door.kind == "hinged" and door.opens_into is not None:
                own = next(d for d in home.shell(door.opens_into).doors if d.id == door.id)
                wall = home.room(door.opens_into).walls[own.wall]
                at = own.offset if own.swing == "in-left" else own.offset + own.width
                assert math.dist(leaves[0][0], wall.point(at)) < 1e-6


@pytest.mark.parametrize("side", ["south", "north", "west", "east"])
def test_dimensions_add_up_and_name_the_clear_rooms(side) -> None:
    home = Home.example("flat")
    chain = room_chain(home, "ground", side, Bounds(0.0, 0.0, 10.4, 7.9))
    lengths = [b - a for a, b in zip(chain.at, chain.at[1:], strict=False)]
    assert sum(lengths) == pytest.approx(10.4 if side in ("south", "north") else 7.9)
    clear = [round(length, 3) for length, is_room in zip(lengths, chain.rooms, strict=True) if is_room]
    assert clear == {"south": [4.2, 1.6, 3.8], "north": [4.2, 1.6, 3.8], "west": [4.1, 3.1], "east": [3.7, 3.5]}[side]


def _written(monkeypatch, home: Home, storey: str) -> list[Text]:
    texts: list[Text] = []
    monkeypatch.setattr(Canvas, "text", lambda self, text: texts.append(text))
    plan_picture(home, storey)
    return texts


def test_names_lie_in_their_rooms_and_off_furniture(monkeypatch) -> None:
    home = flat()
    titles = room_titles(home)
    written = {text.lines[0]: text for text in _written(monkeypatch, home, "ground")}
    scale = 1000 / 50 / MM
    sheet = ElementTree.fromstring(draw_plan(home))
    first = sheet.findall(f"{SVG}polygon")[0].get("points", "").split()
    left = min(float(p.split(",")[0]) for p in first)
    bottom = max(float(p.split(",")[1]) for p in first)
    for room in home.rooms:
        text = written[titles[room.id]]
        half = text_width(text.lines[0], text.size) / 2, line_height(text.size) / 2
        half = half[::-1] if text.upright else half
        (x, y) = ((text.at[0] - left) / scale, (bottom - text.at[1]) / scale)
        box = shapely.box(x - half[0] / scale, y - half[1] / scale, x + half[0] / scale, y + half[1] / scale)
        assert shapely.Polygon(room.outline).contains(box), room.id
        for thing in room.scene.objects if room.scene is not None else ():
            for part in thing.solids:
                shape = shapely.MultiPoint([thing.pose.frame.world(*p) for p in part.polygon]).convex_hull
                assert thing.size[2] < 0.03 or not shape.intersects(box), (room.id, thing.id)


def test_all_rooms_are_named_with_their_areas(monkeypatch) -> None:
    home = house()
    for storey in ("ground", "upper"):
        lines = [line for text in _written(monkeypatch, home, storey) for line in text.lines]
        for room in home.rooms_of(storey):
            assert room_titles(home)[room.id] in lines
            assert f"{clear_area(room):.1f} m" in lines
        assert ("UP" if storey == "ground" else "DN") in lines


def test_stairs_have_their_treads() -> None:
    home = house()
    root = ElementTree.fromstring(draw_plan(home, "upper"))
    white = [p for p in root.findall(f"{SVG}polygon") if p.get("fill") == "#ffffff" and p.get("stroke") == "#4a4642"]
    assert len(white) >= len(treads(home.stairs[0])) == 15


def test_rooms_may_be_links_and_nothing_of_the_file_becomes_markup() -> None:
    home = Home.example("flat").with_changes(prompt='<script>alert("1")</script>', id="a<b>")
    text = draw_plan(home, links={room.id: f"#room-{room.id}" for room in home.rooms})
    root = ElementTree.fromstring(text)
    assert [a.get("href") for a in root.iter(f"{SVG}a")] == [f"#room-{room.id}" for room in home.rooms]
    assert "<script" not in text and "a<b" not in text


def test_equal_homes_give_equal_plans() -> None:
    assert draw_plan(house(), "upper") == draw_plan(Home.loads(house().dumps()), "upper")


def test_what_cannot_be_drawn_is_said() -> None:
    home = Home.example("flat")
    with pytest.raises(sw.InputError, match="attic"):
        draw_plan(home, "attic")
    with pytest.raises(sw.InputError, match="width: 10 is not between"):
        plan_picture(home, width=10)
