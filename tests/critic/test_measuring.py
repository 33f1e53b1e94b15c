"""What the critic measures with arrays is what plain geometry says, one thing at a time."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sceneweaver.critic.space import floor_of, largest_rectangle
from sceneweaver.critic.survey import Survey
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check


@pytest.fixture(scope="module")
def survey() -> Survey:
    scene = Scene.example("bedroom")
    return Survey.of(scene, check(scene), room_type("bedroom"), read_request("a bedroom"))


def test_neighbours_and_areas_are_those_of_the_boxes(survey: Survey) -> None:
    for body in survey.bodies:
        box = survey.boxes[body.index]
        for distance in (0.0, 0.3, 2.0):
            gaps = {b.id: box.distance(survey.boxes[b.index]) for b in survey.bodies if b is not body}
            near = survey.near(body, distance)
            assert {b.id: gap for b, gap in near} == {name: gap for name, gap in gaps.items() if gap <= distance}
            assert [round(gap, 4) for _, gap in near] == sorted(round(gap, 4) for _, gap in near)
        area = box.buffer(0.4, join_style="mitre")
        met = survey.reaching(area)
        assert met == [b for b in survey.bodies if survey.boxes[b.index].intersects(area)]
        shares = [survey.footprint(b).intersection(area).area / area.area for b in met]
        assert survey.taken(area, met) == pytest.approx(shares, abs=1e-12)
        parts = shapely.union_all([shapely.Polygon(p) for p in survey.placed.parts.xy[survey.placed.part_rows(body)]])
        assert survey.footprint(body).symmetric_difference(parts).area < 1e-9


def test_the_floor_under_furniture_is_in_its_parts(survey: Survey) -> None:
    floor = floor_of(survey)
    shapes = shapely.union_all([survey.footprint(b) for b in survey.standing])
    rows, columns = np.nonzero(floor.inside)
    x, y = floor.world(rows + 0.5, columns + 0.5)
    points = shapely.points(x, y)
    off = shapely.distance(shapely.boundary(shapes), points) < 1e-6
    wanted = shapely.contains(shapes, points)
    taken = floor.taken[rows, columns]
    assert 0 < taken.sum() < len(taken)
    assert (taken == wanted)[~off].all()


def test_the_largest_rectangle_is_the_largest_and_the_first() -> None:
    rng = np.random.default_rng(1)
    for share in (0.3, 0.6, 0.9):
        for _ in range(6):
            free = rng.random((7, 9)) < share
            sizes = [
                (rows * columns, r, c, rows, columns)
                for r in range(7)
                for c in range(9)
                for rows in range(1, 8 - r)
                for columns in range(1, 10 - c)
                if free[r : r + rows, c : c + columns].all()
            ]
            found = largest_rectangle(free)
            assert found[0] == max((s[0] for s in sizes), default=0)
            assert not found[0] or found in sizes
