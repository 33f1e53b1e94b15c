"""The checker: ways, light, stairs, programmes, envelopes, oblique walls; and what must not change its mind."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import pytest

import sceneweaver as sw
from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.plans import Envelope, PlanReport, Programme, check_plan
from tests.plans.houses import BOXES, Data, both, home_with, house, outline, part, resized, with_part, without
from tests.plans.random_homes import random_home


def rules(report: PlanReport) -> set[str]:
    return {violation.rule for violation in report.violations}


def lines(report: PlanReport, rule: str) -> list[str]:
    return [violation.detail for violation in report.violations if violation.rule == rule]


# ---- what must not matter


def turned(data: Data, steps: int) -> Data:
    """The home turned by quarters of a circle; numbers of walls and sides of leaves stay."""

    def turn(point: list[float]) -> list[float]:
        x, y = point
        for _ in range(steps):
            x, y = -y, x
        return [x, y]

    for item in (*data["rooms"], *data.get("stairs", ())):
        item["outline"] = [turn(list(p)) for p in item["outline"]]
    for stair in data.get("stairs", ()):
        stair["up"] = turn(list(stair["up"]))
    return data


def moved(data: Data, dx: float, dy: float) -> Data:
    """The home elsewhere."""
    for item in (*data["rooms"], *data.get("stairs", ())):
        item["outline"] = [[round(x + dx, 3), round(y + dy, 3)] for x, y in item["outline"]]
    return data


def mirrored(data: Data) -> Data:
    """The home in a mirror: walls run the other way round, so numbers, offsets and hinges change."""
    lengths = {}
    for room in data["rooms"]:
        corners = room["outline"]
        n = len(corners)
        lengths[room["id"]] = [math.dist(corners[i], corners[(i + 1) % n]) for i in range(n)]
        room["outline"] = [[-x, y] for x, y in (corners[-k] for k in range(1, n + 1))]
    for item in (*data["doors"], *data["windows"]):
        n = len(lengths[item["room"]])
        length = lengths[item["room"]][item["wall"]]
        item["offset"] = round(length - item["offset"] - item["width"], 3)
        item["wall"] = (n - 2 - item["wall"]) % n
        if "hinge" in item:
            item["hinge"] = {"left": "right", "right": "left"}[item["hinge"]]
    return data


@pytest.mark.parametrize("seed", range(200, 208))
def test_turned_moved_and_mirrored_homes_are_judged_alike(seed: int):
    home = random_home(seed)
    data = [home.model_dump(mode="json") for _ in range(5)]
    others = [turned(data[0], 1), turned(data[1], 2), moved(data[2], -3.217, 11.003), mirrored(data[3])]
    expected = Counter((v.rule, frozenset(v.rooms), round(v.amount, 6)) for v in check_plan(home).violations)
    for other in others:
        found = check_plan(Home.model_validate(other)).violations
        assert Counter((v.rule, frozenset(v.rooms), round(v.amount, 6)) for v in found) == expected


@pytest.mark.parametrize("seed", range(300, 306))
def test_the_order_of_parts_does_not_matter(seed: int):
    home = random_home(seed)
    data = home.model_dump(mode="json")
    for key in ("rooms", "doors", "windows"):
        data[key].reverse()
    a, b = check_plan(home), check_plan(Home.model_validate(data))
    assert Counter((v.rule, frozenset(v.rooms)) for v in a.violations) == Counter(
        (v.rule, frozenset(v.rooms)) for v in b.violations
    )
    assert a.cost == pytest.approx(b.cost) and a.areas == b.areas


def test_the_house_in_a_mirror_is_as_good():
    report = check_plan(Home.model_validate(mirrored(house() | {"stairs": []})))
    assert rules(report) == {"stairs-there", "reached"}  # without its stairs, as the data of a stair was left out


# ---- to the millimetre


@pytest.mark.parametrize(("width", "good"), [(2.130, True), (2.129, False)])
def test_a_millimetre_decides(width: float, good: bool):
    home = home_with(resized("child", 0.3, round(3.0 - width, 3), 2.9, 3.0))
    found = lines(check_plan(home, profile="base"), "habitable-side")
    assert found == ([] if good else ["child: clear width is 2.129 m; at least 2.130 m"])


# ---- ways


def test_a_bedroom_is_no_way():
    """The child's room behind the bedroom: no annex, so the way is none; a dressing room there is."""
    home = home_with(both(without("doors", "to-child"), with_part("rooms", "closet", type="childrens_room")))
    report = check_plan(home)
    assert "closet: the way to it crosses bath, which is no way; give it a door to a hall" in lines(report, "reached")
    assert "child: no doors lead from the entrance to it; add a door" in lines(report, "reached")


def test_a_toilet_behind_a_bedroom_is_for_its_people_alone():
    change = both(with_part("rooms", "hall", type="bedroom"), without("doors", "front"))
    report = check_plan(home_with(change))
    assert lines(report, "shared-toilet") == ["the entrance reaches no toilet"]


def test_with_a_programme_an_annex_lies_behind_its_own_room():
    programme = programme_of(("hall", "shower"), ("shower", "store"))
    assert "reached" not in rules(check_plan(home_with(), programme))
    programme = programme_of(("hall", "shower"), ("hall", "store"))
    said = lines(check_plan(home_with(), programme), "reached")
    assert said == ["store: the way to it crosses shower, which is no way; give it a door to a hall"]


def programme_of(*pairs: tuple[str, ...], **changes: Any) -> Programme:
    """The programme of the house."""
    storeys = {"ground": 0, "upper": 1}
    nodes = {
        name: {
            "type": kind,
            "area": [0.9 * area, area, 1.1 * area],
            "storey": storeys[storey],
        }
        for name, (kind, storey, (x0, y0, x1, y1)) in BOXES.items()
        for area in [(x1 - x0) * (y1 - y0)]
    }
    for name, change in changes.items():
        nodes[name] = {**nodes[name], **change}
    return Programme.from_graph(nodes, pairs, use="house", storeys=2, entrance="hall")


# ---- programmes


@pytest.mark.parametrize(
    ("programme", "rule", "line"),
    [
        (programme_of(), None, ""),
        (programme_of(child={"area": [8, 9, 10]}), "programme-area", "child: floor is 7.02 m2; the programme asks for"),
        (programme_of(child={"area": [5, 6, 7]}), "programme-area", "asks for at most 7.00 m2"),
        (
            programme_of(child={"side": 2.601}),
            "programme-side",
            "child: clear width is 2.600 m; the programme",
        ),
        (programme_of(child={"storey": 0}), "programme-storeys", "child: it is on storey 1; the programme asks for 0"),
        (programme_of(child={"type": "study"}), "programme-rooms", "it is of type childrens_room"),
        (programme_of(bath={"daylight": True}), None, ""),
        (programme_of(shower={"daylight": True}), "daylight", "shower: it has no window"),
        (programme_of(("hall", "store")), "programme-adjacency", "hall and store: no door joins them"),
        (
            programme_of(("hall", "living", "open")),
            "programme-adjacency",
            "hall and living: no open passage",
        ),
        (programme_of(("living", "kitchen", "near")), "programme-adjacency", "living and kitchen: they share no wall"),
        (programme_of(("hall", "kitchen", "apart")), "programme-adjacency", "hall and kitchen: they share a wall"),
        (programme_of(("hall", "stairs", "open"), ("kitchen", "shower", "near")), None, ""),
    ],
)
def test_what_a_programme_asks_for(programme: Programme, rule: str | None, line: str):
    report = check_plan(home_with(), programme)
    assert rules(report) - {"reached"} == ({rule} if rule else set())
    assert not rule or line in lines(report, rule)[0]


def test_missing_rooms_and_others():
    home = home_with(both(without("rooms", "closet"), without("doors", "to-closet")))
    assert lines(check_plan(home, programme_of()), "programme-rooms") == ["closet: the plan has no such room"]
    data = house()
    data["rooms"].append({"id": "shed", "type": "closet", "storey": "ground", "outline": outline((12, 0, 14, 2))})
    report = check_plan(Home.model_validate(data), programme_of())
    assert lines(report, "programme-rooms") == ["shed: the programme has no such room"]


def test_soft_wishes_cost_and_do_not_forbid():
    programme = programme_of()
    wish = {"a": "living", "b": "kitchen", "kind": "near", "hard": False, "weight": 3.0}
    wished = Programme(**{**programme.model_dump(), "adjacencies": [wish]})
    plain, report = (check_plan(home_with(), p) for p in (programme, wished))
    assert report.valid and report.cost == pytest.approx(plain.cost + 3.0)


# ---- light


def test_an_open_passage_lends_light():
    """The kitchen as a dining room without a window: dark, until an open passage of 1.2 m joins it to the hall."""
    dark = both(with_part("rooms", "kitchen", type="dining_room"), without("windows", "w-kitchen"))
    assert {"daylight", "glazing"} <= rules(check_plan(home_with(dark)))
    wide = both(
        dark,
        with_part("doors", "to-kitchen", kind="open", opens_into=None, width=1.2),
        with_part("doors", "to-living", kind="open", opens_into=None, width=1.2),
    )
    assert not {"daylight", "glazing"} & rules(check_plan(home_with(wide)))
    sliding = both(wide, with_part("doors", "to-kitchen", kind="sliding"))
    assert {"daylight", "glazing"} <= rules(check_plan(home_with(sliding)))
    assert not {"daylight", "glazing"} & rules(check_plan(home_with(sliding), profile="japan"))
    narrow = both(wide, with_part("doors", "to-kitchen", width=1.19))
    assert {"daylight", "glazing"} <= rules(check_plan(home_with(narrow)))


def test_doors_onto_a_balcony_have_glass():
    def balcony(data: Data) -> None:
        box = (9.0, 0.3, 10.4, 4.0)
        data["rooms"].append(
            {"id": "balcony", "type": "balcony", "storey": "ground", "outline": outline(box), "outdoor": True}
        )
        door = {"id": "glass", "room": "living", "wall": 1, "offset": 1.0, "width": 1.8, "to": "balcony"}
        data["doors"].append({**door, "kind": "sliding"})

    report = check_plan(home_with(both(without("windows", "w-living", "w-living-south"), balcony)))
    assert report.valid


# ---- stairs


def stairwell(shape: str, box: tuple[float, ...], up: list[int], **fields: Any) -> Home:
    """Two rooms of type stairs alone, one over the other, with a door each."""
    rooms = [
        {"id": name, "type": "stairs", "storey": storey, "outline": outline(box)}  # type: ignore[arg-type]
        for name, storey in (("down", "ground"), ("up", "upper"))
    ]
    stair = {"id": "s", "lower": "down", "upper": "up", "outline": outline(box), "up": up, "shape": shape}  # type: ignore[arg-type]
    usual = {"width": 0.95, "risers": 15, "going": 0.26}
    return Home.model_validate(
        {
            "id": "stairs",
            "storeys": house()["storeys"],
            "rooms": rooms,
            "doors": [
                {"id": "in", "room": "down", "wall": 0, "offset": 0.05, "width": 0.85, "to": None, "kind": "open"},
                {"id": "out", "room": "up", "wall": 2, "offset": 0.05, "width": 0.85, "to": None, "kind": "open"},
            ],
            "stairs": [{**stair, **usual, **fields}],
        }
    )


STAIRS = ("stairs-place", "riser", "going", "stair-width", "stair-run", "headroom")


@pytest.mark.parametrize(
    ("home", "broken"),
    [
        (stairwell("straight", (0, 0, 0.95, 3.64), [0, 1]), set()),
        (stairwell("straight", (0, 0, 0.95, 3.63), [0, 1]), {"stair-run"}),
        (stairwell("straight", (0, 0, 0.95, 3.64), [0, -1]), {"stairs-place"}),
        (stairwell("straight", (0, 0, 3.64, 0.95), [1, 0]), {"stairs-place"}),
        (stairwell("l", (0, 0, 2.77, 2.77), [0, 1]), {"stairs-place"}),
        (stairwell("u", (0, 0, 1.9, 2.78), [0, 1]), {"stairs-place"}),
        (stairwell("u", (0, 0, 1.89, 2.77), [0, 1]), {"stairs-place", "stair-run"}),
    ],
)
def test_stairs_fit_and_lead_on(home: Home, broken: set[str]):
    """Doors lie at the southern edge below and at the northern one above: right for one flight to the north alone."""
    assert rules(check_plan(home)) & set(STAIRS) == broken


def test_l_stairs_split_as_they_fit():
    """15 risers in two flights of 7 and 8, or 3 and 12: legs of 6 and 7 goings and the landing, or 2 and 11."""
    for box, lack in (((0, 0, 2.77, 2.51), 0.0), ((0, 0, 1.47, 3.81), 0.0), ((0, 0, 1.47, 3.8), 0.01)):
        said = lines(check_plan(stairwell("l", box, [0, 1])), "stair-run")
        assert bool(said) == bool(lack), box


def test_stairs_over_stairs_leave_headroom():
    data = house()
    data["storeys"].append({"id": "roof", "elevation": 5.1, "height": 2.5})
    data["storeys"][1].update(height=2.2)
    for name in ("w-bedroom", "w-child", "w-bath"):
        part(data, "windows", name).update(height=1.2)
    data["rooms"].append({"id": "top", "type": "stairs", "storey": "roof", "outline": outline((3.0, 4.3, 5.0, 7.1))})
    first = data["stairs"][0]
    data["stairs"].append({**first, "id": "s2", "lower": "stairwell", "upper": "top", "risers": 12})
    said = lines(check_plan(Home.model_validate(data)), "headroom")
    assert said == ["stairs s from stairs to stairwell: headroom is 1.950 m; at least 2.030 m"]


# ---- envelopes


def test_windows_lie_in_open_walls():
    home = sw.Home.example("flat")
    xs, ys = zip(*(p for room in home.rooms for p in room.outline), strict=True)
    w, d = max(xs) + 0.3, max(ys) + 0.3
    assert check_plan(home, envelope=Envelope.rectangle(w, d)).valid
    report = check_plan(home, envelope=Envelope.rectangle(w, d, closed=(3,)))
    assert rules(report) == {"windows-outside"}
    assert lines(report, "windows-outside")[0].endswith("it lies in wall 3 of the envelope, which has none")
    wide = check_plan(home, envelope=Envelope.rectangle(w + 2, d))
    assert {"no-voids", "windows-outside"} <= rules(wide)


# ---- oblique walls


def tilted(home: Home) -> Home:
    """The home turned by the angle of the triangle 3, 4, 5: multiples of 5 mm stay on the grid."""
    data = home.model_dump(mode="json")
    for room in data["rooms"]:
        room["outline"] = [[round(0.8 * x - 0.6 * y, 3), round(0.6 * x + 0.8 * y, 3)] for x, y in room["outline"]]
    return Home.model_validate(data)


def test_a_tilted_flat_is_judged_by_what_fits_along_the_axes():
    """Areas, walls, doors, leaves, light and ways are as before; squares along the axes are smaller."""
    home = sw.Home.example("flat")
    found = check_plan(tilted(home))
    assert found.areas == check_plan(home).areas
    assert rules(found) <= {"habitable-side", "kitchen-side", "bath-side", "hall-width"}


def test_faults_of_tilted_homes_are_found():
    """The same faults as of the homes that stand straight, but those of squares and of the boxes around rooms."""
    measured = {
        "doors-lead",
        "windows-outside",
        "leaves-free",
        "reached",
        "entrance",
        "daylight",
        "glazing",
        "disjoint",
    }
    seen: Counter[str] = Counter()
    for seed in range(400, 404):
        home = random_home(seed)
        straight, found = (
            {(v.rule, frozenset(v.rooms)) for v in check_plan(h).violations if v.rule in measured}
            for h in (home, tilted(home))
        )
        assert straight == found
        seen.update(rule for rule, _ in found)
    assert {"doors-lead", "windows-outside", "reached", "daylight", "disjoint"} <= set(seen)


# ---- what is refused


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        ((3,), "home is of type int; give a Home"),
        ((sw.Home.example("flat"), {"rooms": []}), "programme is of type dict; give a Programme"),
        ((sw.Home.example("flat"), None, "strict"), 'profile "strict" is not known'),
        ((sw.Home.example("flat"), None, 7), "profile is of type int; give a Profile or a name"),
    ],
)
def test_bad_arguments(arguments: tuple[Any, ...], line: str):
    with pytest.raises(InputError) as said:
        check_plan(*arguments)
    assert line in str(said.value) and "\n" not in str(said.value)
