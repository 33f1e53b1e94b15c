"""What people mean by a relation from what the things are for."""

from __future__ import annotations

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import Grounded, Thing, grounded
from sceneweaver.language.read import read_by_rules


def rows(text: str) -> list[Grounded]:
    graph = read_by_rules(text)
    things = {}
    for entity in graph.entities:
        known = category_named(entity.category)
        assert known.size is not None
        depth, width, height = (0.5 * (low + high) for low, high in known.size.ranges)
        things[entity.id] = [Thing(f"{entity.id}-0", entity.category, (depth, width, height), known.mount[0])]
    return grounded(graph, things)[0]


def test_who_watches_a_screen_sits_before_it_at_some_distance() -> None:
    found = {(row.type, row.subject, row.hard): row for row in rows("an armchair facing a tv")}
    assert ("facing", "armchair-0", True) in found and ("facing", "tv-0", False) in found
    assert found["distance", "armchair-0", False].params == {"min": 1.5, "max": 4}


def test_who_looks_into_a_mirror_is_near_it() -> None:
    far = next(row for row in rows("a chair facing a mirror") if row.type == "distance")
    assert (far.params, far.hard) == ({"min": 0.6, "max": 1.5}, False)


def test_a_small_table_beside_a_bed_is_at_its_head() -> None:
    (row,) = rows("a side table next to the bed")
    assert row.type == "leftright_to_leftright" and row.params["backs"] == 0.6


def test_lamps_and_photos_over_furniture_hang() -> None:
    def categories(text: str) -> set[str]:
        return {entity.category for entity in read_by_rules(text).entities}

    assert "pendant" in categories("a dining room with a lamp low over the table")
    assert "wall_sconce" in categories("a bedroom with a lamp above the bed")
    assert "photo_frames" in categories("a bedroom with family photos above the dresser")
    assert "table_lamp" in categories("a bedroom with a lamp on the dresser")


def test_what_goes_with_a_seat_is_where_it_serves() -> None:
    before = rows("an armchair with a footstool")
    assert {row.type for row in before} == {"in_front_of", "near"}
    (lamp,) = rows("a sofa with a floor lamp")
    assert (lamp.type, lamp.params) == ("near", {"max": 0.3})
    stool = rows("a dressing table with a stool")
    assert {row.type for row in stool} == {row.type for row in rows("a stool at a desk")}
