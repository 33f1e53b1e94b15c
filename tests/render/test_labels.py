"""Where labels go."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from sceneweaver.render import labels, plan_objects, topview
from sceneweaver.render.canvas import Canvas, text_width
from sceneweaver.render.labels import CELL, FLOOR_OWNER, PAPER_OWNER, Wanted, box_of, place, shortened, split
from tests.render.scenes import box, everything, room_of, zoo

SIZES = (20, 16, 13)


def grid_with(*boxes, shape=(300, 400)):
    """A floor with objects at (left, top, right, bottom) in pixels; later ones lie on top."""
    owners = np.full(shape, PAPER_OWNER, dtype=np.int32)
    owners[20:-20, 20:-20] = FLOOR_OWNER
    wanted = []
    for k, (left, top, right, bottom) in enumerate(boxes):
        owners[top // CELL : bottom // CELL, left // CELL : right // CELL] = k + 1
        center = ((left + right) / 2, (top + bottom) / 2)
        wanted.append(Wanted(f"chair-{k}", k + 1, "chair", f"chair-{k}", center, (right - left) * (bottom - top)))
    return wanted, owners, np.zeros(shape, dtype=bool)


def overlaps(a, b) -> bool:
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = box_of(a), box_of(b)
    return min(ax1, bx1) - max(ax0, bx0) > 1 and min(ay1, by1) - max(ay0, by0) > 1


def test_a_label_sits_in_the_middle_of_a_large_object():
    result = place(*grid_with((100, 100, 300, 200)), SIZES)
    (label,) = result.placed
    assert label.size == 20 and label.lines == ("chair-0",) and not label.upright and not label.beside
    assert label.at == pytest.approx((200, 150), abs=2)


def test_a_tall_object_gets_upright_text():
    (label,) = place(*grid_with((100, 100, 124, 300)), SIZES).placed
    assert label.upright and not label.beside


def test_a_small_object_gets_its_label_beside_it_with_a_leader():
    (label,) = place(*grid_with((200, 200, 216, 216)), SIZES).placed
    assert label.beside and label.leader is not None
    start, end = label.leader
    assert 200 <= end[0] <= 216 and 200 <= end[1] <= 216
    left, top, right, bottom = box_of(label)
    assert left - 6 <= start[0] <= right + 6 and top - 6 <= start[1] <= bottom + 6


def test_a_covered_part_is_avoided():
    wanted, owners, edges = grid_with((100, 100, 300, 200), (150, 130, 250, 170))
    below = next(label for label in place(wanted, owners, edges, SIZES).placed if label.key == "chair-0")
    assert not below.beside
    left, top, right, bottom = box_of(below)
    assert right <= 152 or left >= 248 or bottom <= 134 or top >= 166


def test_one_category_has_one_size():
    result = place(*grid_with((50, 50, 250, 150), (300, 50, 368, 150), (450, 50, 650, 150)), SIZES)
    assert len({label.size for label in result.placed}) == 1


def test_many_tiny_objects_show_their_numbers():
    boxes = [(60 + 24 * i, 60 + 24 * j, 80 + 24 * i, 80 + 24 * j) for i in range(12) for j in range(12)]
    result = place(*grid_with(*boxes), SIZES)
    assert result.numbered > 100
    assert all(label.lines[0].isdigit() or label.beside for label in result.placed)
    assert result.left_out + len(result.placed) == len(boxes)


@pytest.mark.parametrize("scene", [zoo("restaurant-dense"), zoo("office-20"), everything()], ids=lambda s: s.id)
def test_labels_never_overlap(scene, monkeypatch):
    kept = []
    monkeypatch.setattr(labels, "place", lambda *a, _place=labels.place: kept.append(_place(*a)) or kept[-1])
    topview.draw_top(scene, width=1200)
    placed = kept[0].placed
    assert len(placed) > 5
    assert not [(a.key, b.key) for a, b in itertools.combinations(placed, 2) if overlaps(a, b)]


def test_an_object_that_nobody_sees_still_gets_a_label():
    hidden = box("hidden", 1.0, 1.0, size=(0.2, 0.2, 0.2))
    scene = room_of(hidden, box("over", 1.0, 1.0, size=(1.0, 1.0, 1.0)))
    items = plan_objects.items_of(scene)
    assert [i.id for i in items] == ["hidden", "over"]
    assert topview.draw_top(scene, width=400).width == 400


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("coffee_table-0", ("coffee_", "table-0")),
        ("chair-12", ("chair", "-12")),
        ("bed", None),
        ("-1", None),
        ("floor lamp", ("floor", "lamp")),
    ],
)
def test_split(text, lines):
    assert split(text) == lines


@pytest.mark.parametrize("width", [20, 40, 80, 200, 4000])
def test_shortened_text_fits_and_keeps_both_ends(width):
    text = "a_very_long_identifier_of_an_object-000123"
    short = shortened(text, 13, width)
    assert text_width(short, 13) <= max(width, text_width("a…", 13))
    assert short[0] == "a"
    if width >= 80:
        assert short.endswith("123")


def test_halos_and_upright_text_stay_where_they_are_put():
    from sceneweaver.render.canvas import Text

    for upright in (False, True):
        canvas = Canvas(120, 120, (255, 255, 255))
        canvas.text(Text(("chair-1",), (60, 60), 14, (0, 0, 0), (255, 255, 255), 2, upright))
        ys, xs = np.nonzero(np.asarray(canvas.finish())[..., 0] < 128)
        assert abs(xs.mean() - 60) < 4 and abs(ys.mean() - 60) < 4
        assert (np.ptp(ys) > np.ptp(xs)) is np.bool_(upright)
