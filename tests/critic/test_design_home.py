"""The rules for homes and for all rooms: each is kept by one room and broken by another that differs in one thing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from sceneweaver.critic.groups import groups_of
from sceneweaver.critic.survey import Survey
from tests.critic import rooms
from tests.critic.rooms import Case, on, put


def broken(case: Case, rule: str) -> set[str]:
    """The objects of a rule's breaches; {""} for a breach about the room."""
    return {name for f in case.review().faults if f.rule == rule for name in f.objects or ("",)}


def named(case: Case, kind: str) -> Case:
    """The case as a room of another name."""
    return replace(case, room_type=case.room_type.model_copy(update={"name": kind}))


def bedroom(*more: rooms.SceneObject) -> Case:
    """The bedroom with a rug under its bed, or what else is put there."""
    return rooms.bedroom().but({"id": "rug-0", "gone": True}).plus(*more)


def rug(x: float, y: float, yaw: float, depth: float, width: float) -> rooms.SceneObject:
    return put("rug-1", x, y, yaw, size=(depth, width, 0.00045))


def curtain(x: float, width: float = 1.9, height: float = 2.3) -> rooms.SceneObject:
    return put("curtain-0", x, 3.9, -90, 0.05, size=(0.18, width, height), mount="wall")


def nursery(x: float) -> Case:
    """A room for a child with a single bed, its head at the far wall."""
    bed = put("single_bed-0", x, 2.95, -90, size=(2.0, 0.9, 0.8))
    return named(rooms._case(rooms.room(3.6, 4.0), [bed], [], rooms.BEDROOM), "childrens_room")


def laid(depth: float, width: float) -> Case:
    """A kitchen with a rug under its table."""
    return rooms.kitchen().plus(put("rug-0", 2.0, 1.45, 90, size=(depth, width, 0.00045)))


def waiting(x: float, yaw: float) -> Case:
    """Three armchairs at the wall y = 0 and a television; its place along x and where it looks."""
    chairs = [put(f"armchair-{k}", 1.0 + k, 0.5, 90, size=(0.8, 0.8, 0.9)) for k in range(3)]
    tv = put("tv-0", x, 4.0 if yaw else 0.05, yaw or 90, 1.0, size=(0.05, 1.6, 0.9), mount="wall")
    return named(rooms._case(rooms.room(4.0, 4.05, door=2.9), [*chairs, tv], [], rooms.LIVING), "waiting_room")


LIVING, PLAIN = rooms.living, bedroom
TV = {"id": "tv_on_stand-0", "gone": True}
BOXES = [put(f"sideboard-{k}", 0.6 + 1.3 * k, 0.9, 90, size=(0.5, 1.2, 0.8)) for k in range(3)]

BREACHES: list[tuple[str, Callable[[], Case], Callable[[], Case], set[str]]] = [
    ("table_on_sofa_axis", LIVING, lambda: LIVING().but({"id": "coffee_table-0", "y": 2.5}), {"coffee_table-0"}),
    ("rug_on_sofa_axis", LIVING, lambda: LIVING().but({"id": "rug-0", "y": 2.5}), {"rug-0", "sofa-0"}),
    ("focus_on_sofa_axis", LIVING, lambda: LIVING().but({"id": "tv_stand-0", "y": 1.7}), {"tv_on_stand-0"}),
    ("screen_on_stand_axis", LIVING, lambda: LIVING().but({"id": "tv_on_stand-0", "y": 2.3}), {"tv_on_stand-0"}),
    ("picture_on_bed_axis", PLAIN, lambda: PLAIN().but({"id": "picture-0", "y": 2.6}), {"picture-0", "bed-0"}),
    (
        "pendant_on_bed_axis",
        lambda: PLAIN(put("pendant-0", 1.1, 2.25)),
        lambda: PLAIN(put("pendant-0", 1.1, 2.6)),
        {"pendant-0"},
    ),
    (
        "rug_on_bed_axis",
        lambda: PLAIN(rug(1.4, 2.25, 0, 2.0, 2.7)),
        lambda: PLAIN(rug(1.4, 2.5, 0, 2.0, 2.7)),
        {"rug-1"},
    ),
    (
        "rug_beyond_bed",
        lambda: PLAIN(rug(1.4, 2.25, 0, 2.0, 2.7)),
        lambda: PLAIN(rug(2.1, 2.25, 0, 1.2, 1.8)),
        {"rug-1", "bed-0"},
    ),
    ("pairs_mirrored", PLAIN, lambda: PLAIN().but({"id": "nightstand-0", "y": 3.5}), {"nightstand-0"}),
    (
        "bed_off_door_wall",
        PLAIN,
        lambda: PLAIN().but({"id": "bed-0", "x": 1.8, "y": 1.08, "yaw": 90}),
        {"bed-0"},
    ),
    ("child_bed_in_corner", lambda: nursery(0.5), lambda: nursery(1.8), {"single_bed-0"}),
    ("back_to_focus", LIVING, lambda: LIVING().but({"id": "armchair-0", "yaw": 0}), {"armchair-0"}),
    (
        "seat_sees_focus",
        LIVING,
        lambda: LIVING().but({"id": "armchair-0", "x": 1.6, "y": 0.75, "yaw": 60}),
        {"armchair-0"},
    ),
    ("seat_sees_focus", lambda: waiting(2.0, -90), lambda: waiting(2.0, 0), {"tv-0"}),
    (
        "focus_unblocked",
        LIVING,
        lambda: LIVING().plus(put("bookcase-1", 1.6, 2.1, 0, size=(0.3, 0.8, 1.8))),
        {"bookcase-1"},
    ),
    (
        "screen_width",
        lambda: LIVING().but(TV).plus(put("tv-0", 0.03, 2.1, 0, 0.8, size=(0.05, 1.5, 0.8), mount="wall")),
        LIVING,
        {"tv_on_stand-0"},
    ),
    (
        "screen_height",
        lambda: LIVING().but(TV).plus(put("tv-0", 0.03, 2.1, 0, 0.8, size=(0.05, 1.5, 0.8), mount="wall")),
        lambda: LIVING().but(TV).plus(put("tv-0", 0.03, 2.1, 0, 1.4, size=(0.05, 1.5, 0.8), mount="wall")),
        {"tv-0"},
    ),
    (
        "one_screen",
        LIVING,
        lambda: LIVING().plus(put("tv-0", 2.0, 0.05, 90, 0.8, size=(0.05, 1.2, 0.7), mount="wall")),
        {"tv-0", "tv_on_stand-0"},
    ),
    ("coffee_table_distance", LIVING, lambda: LIVING().but({"id": "coffee_table-0", "x": 2.9}), {"coffee_table-0"}),
    ("armchair_in_group", LIVING, lambda: LIVING().but({"id": "armchair-0", "yaw": -90}), {"armchair-0"}),
    (
        "seat_in_a_group",
        lambda: LIVING().plus(put("pouf-0", 2.4, 2.1, size=(0.5, 0.5, 0.4))),
        lambda: LIVING().plus(put("pouf-0", 0.6, 0.6, size=(0.5, 0.5, 0.4))),
        {"pouf-0"},
    ),
    (
        "seat_in_a_group",
        LIVING,
        lambda: LIVING().but({"id": "coffee_table-0", "gone": True}),
        {"sofa-0"},
    ),
    (
        "piece_in_a_group",
        LIVING,
        lambda: named(
            rooms._case(
                rooms.room(9.0, 4.2),
                [
                    put("sofa-0", 8.5, 2.1, 180),
                    put("tv_stand-0", 5.5, 2.1, 0),
                    put("sideboard-0", 0.3, 2.1, 0, size=(0.45, 1.2, 0.8)),
                ],
                [],
                rooms.LIVING,
            ),
            "living_room",
        ),
        {"sideboard-0"},
    ),
    (
        "table_beside_seat",
        lambda: LIVING().plus(put("side_table-0", 4.6, 3.33, size=(0.4, 0.4, 0.5))),
        lambda: LIVING().plus(put("side_table-0", 4.0, 3.33, size=(0.4, 0.4, 0.5))),
        {"side_table-0"},
    ),
    (
        "faces_room",
        lambda: LIVING().plus(put("teddy_bear-0", 0.5, 0.5, 45)),
        lambda: LIVING().plus(put("teddy_bear-0", 0.5, 0.5, 180)),
        {"teddy_bear-0"},
    ),
    (
        "rug_under_front_legs",
        lambda: LIVING().but({"id": "rug-0", "x": 3.5}),
        LIVING,
        {"rug-0", "sofa-0"},
    ),
    ("rug_beyond_table", lambda: laid(2.4, 3.0), lambda: laid(1.0, 1.6), {"rug-0", "dining_table-0"}),
    ("rug_in_a_group", LIVING, lambda: LIVING().but({"id": "rug-0", "yaw": 20}), {"rug-0"}),
    (
        "rug_in_a_group",
        LIVING,
        lambda: LIVING().plus(put("round_rug-0", 0.9, 0.9, size=(0.8, 0.8, 0.00045))),
        {"round_rug-0"},
    ),
    (
        "wall_covered",
        lambda: PLAIN().plus(
            *(
                put(f"poster-{k}", x, y, yaw, 1.3, size=(0.02, 0.6, 0.6), mount="wall")
                for k, (x, y, yaw) in enumerate(
                    ((1.5, 0.01, 90), (2.6, 0.01, 90), (3.59, 1.0, 180), (0.5, 3.99, -90), (3.0, 3.99, -90))
                )
            )
        ),
        lambda: rooms.restaurant(),
        {""},
    ),
    (
        "art_width",
        PLAIN,
        lambda: (
            PLAIN()
            .but({"id": "picture-0", "gone": True})
            .plus(put("picture-1", 0.02, 2.2, 0, 1.3, size=(0.03, 0.3, 0.3), mount="wall"))
        ),
        {"picture-1", "bed-0"},
    ),
    ("art_height", PLAIN, lambda: PLAIN().but({"id": "picture-0", "y": 3.6, "z": 1.8}), {"picture-0"}),
    ("art_corner", PLAIN, lambda: PLAIN().but({"id": "picture-0", "y": 3.55}), {"picture-0"}),
    (
        "curtain_centred",
        lambda: PLAIN(curtain(1.7)),
        lambda: PLAIN(curtain(2.1)),
        {"curtain-0"},
    ),
    ("curtain_width", lambda: PLAIN(curtain(1.7)), lambda: PLAIN(curtain(1.7, 1.4)), {"curtain-0"}),
    ("curtain_width", lambda: PLAIN(curtain(1.7)), lambda: PLAIN(curtain(1.7, height=1.8)), {"curtain-0"}),
    (
        "no_empty_floor",
        lambda: rooms.office().plus(*BOXES),
        rooms.office,
        {""},
    ),
    (
        "shelves_filled",
        lambda: rooms.office().plus(
            *(
                on(rooms.office().scene.object("bookcase-0"), f"book-{k}", surface=f"shelf-{k}", left=0.4)
                for k in range(3)
            )
        ),
        rooms.office,
        {"bookcase-0"},
    ),
    (
        "enough_small_things",
        lambda: rooms.bedroom().plus(
            *(on(rooms.bedroom().scene.object("dresser-0"), f"book-{k + 1}", left=-0.05 * k) for k in range(12))
        ),
        rooms.bedroom,
        {""},
    ),
]


@pytest.mark.parametrize(
    ("rule", "good", "bad", "objects"), BREACHES, ids=[f"{k}-{b[0]}" for k, b in enumerate(BREACHES)]
)
def test_a_rule_is_kept_and_broken(
    rule: str, good: Callable[[], Case], bad: Callable[[], Case], objects: set[str]
) -> None:
    kept = broken(good(), rule)
    assert not kept & objects
    assert objects <= broken(bad(), rule)


def test_groups_are_found_without_relations() -> None:
    case = rooms.living()
    scene = case.scene.model_copy(update={"relations": ()})
    survey = Survey.of(scene, case.report(), case.room_type, case.brief)
    (group,) = groups_of(survey).seatings
    assert group.anchor.id == "sofa-0" and {b.id for b in group.seats} == {"sofa-0", "armchair-0"}
    assert group.table is not None and group.table.id == "coffee_table-0"
    assert group.focus is not None and group.focus.id == "tv_on_stand-0"
    bed = rooms.bedroom()
    survey = Survey.of(bed.scene.model_copy(update={"relations": ()}), bed.report(), bed.room_type, bed.brief)
    (sleeping,) = groups_of(survey).sleepings
    assert {b.id for b in sleeping.stands} == {"nightstand-0", "nightstand-1"}
    assert [b.id for b in sleeping.over] == ["picture-0"]


def test_what_words_leave_out_is_no_empty_floor_or_bare_wall() -> None:
    case = rooms.office()
    lean = case.but(brief=case.brief.model_copy(update={"only": True}))
    assert broken(case, "no_empty_floor") and broken(case, "shelves_filled")
    assert not any(broken(lean, rule) for rule in ("no_empty_floor", "shelves_filled", "wall_covered"))
