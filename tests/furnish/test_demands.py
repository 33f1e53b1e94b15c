"""What furniture needs of a plan: least floors, least sides, walls."""

from __future__ import annotations

import sceneweaver as sw
from sceneweaver.furnish.demands import furnishable, needs_of, raised, short_walls
from sceneweaver.furnish.kinds import kind_of
from sceneweaver.language import read_request
from sceneweaver.plans import Programme


def _programme(**rooms: object) -> Programme:
    return Programme.from_graph({"hall": "entrance_hall", **rooms}, [("hall", name) for name in rooms])


def test_needs_follow_from_furniture() -> None:
    bath, living = needs_of(kind_of("bathroom")), needs_of(kind_of("living_room"))
    assert 2.5 < bath.area < 4.5
    assert 2.7 < living.side < 3.2  # a sofa, a television, and 1.7 m between
    plain = needs_of(kind_of("bathroom"), read_request("a bathroom"))
    more = needs_of(kind_of("bathroom"), read_request("a bathroom with a washing machine and a wardrobe"))
    assert more.area > plain.area + 0.8
    bare = needs_of(kind_of("kitchen"), read_request("a kitchen without a dining table"))
    assert bare.area < needs_of(kind_of("kitchen")).area


def test_a_programme_asks_for_what_furniture_needs() -> None:
    wanted, said = furnishable(_programme(bath={"type": "bathroom", "area": (1.5, 3.0, 6.0), "side": 0.6}))
    assert wanted.room("bath").area[0] > 2.5 and wanted.room("bath").side > 0.6
    assert [line.partition(":")[0] for line in said] == ["bath"]
    tight, _ = furnishable(_programme(bath={"type": "bathroom", "area": (1.5, 1.8, 2.0), "side": 0.6}))
    assert tight.room("bath").area[2] == 2.0  # what it may have at most was asked for
    assert tight.room("bath").area[0] <= 2.0


def test_a_programme_asks_for_more_after_a_failure() -> None:
    before = _programme(bath="bathroom", bed="bedroom")
    after, said = raised(before, ["bath"])
    assert after.room("bed") == before.room("bed")
    for old, new in zip(before.room("bath").area, after.room("bath").area, strict=True):
        assert new > old
    assert len(said) == 1 and said[0].startswith("bath")
    assert [room.id for room in after.rooms] == [room.id for room in before.rooms]


def test_walls_that_are_too_short_are_told() -> None:
    flat = sw.Home.example("flat")
    assert "bedroom" not in short_walls(flat)
    room = flat.room("bedroom")
    x, y = room.outline[0]
    slim = ((x, y), (x + 0.9, y), (x + 0.9, y + 0.9), (x, y + 0.9))
    rooms = tuple(r.model_copy(update={"outline": slim}) if r.id == "bedroom" else r for r in flat.rooms)
    doors = tuple(d for d in flat.doors if "bedroom" not in (d.room, d.to))
    windows = tuple(w for w in flat.windows if w.room != "bedroom")
    assert short_walls(flat.with_changes(rooms=rooms, doors=doors, windows=windows))["bedroom"] > 0.1
