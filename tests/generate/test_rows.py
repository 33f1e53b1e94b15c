"""What stands in rows is proposed as relations: each piece by the one before it, in variants that fit the room."""

from __future__ import annotations

import pytest

from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import CATALOGUE, Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


@pytest.fixture
def propose(library):
    """What the prior proposes for a request."""

    def run(words: str):
        brief = read_request(words)
        empty = Scene(id="empty", room={"outline": ((0, 0), (3, 0), (3, 3), (0, 3))})
        return InitPrior().propose(Context(brief, room_type(brief.room_type or ""), empty, library, 1))

    return run


@pytest.mark.parametrize("words", ["a restaurant for 40 people", "a kitchen", "a gym", "a classroom for 24 children"])
def test_variants_hang_together(words, propose):
    proposal = propose(words)
    known = {*proposal.scene.ids, *(f"wall:{wall.index}" for wall in proposal.scene.room.walls)}
    assert proposal.variants
    for variant in proposal.variants:
        assert all({r.subject, *r.targets} <= known and r.hard for r in variant)
        placed = [r for r in variant if r.type in CATALOGUE.with_role("formation")]
        subjects = [r.subject for r in placed]
        assert placed and len(subjects) == len(set(subjects)), "each is placed by one other"
        parents = {r.subject: r.target for r in placed}
        for subject in subjects:  # and nothing by itself in the end
            seen = {subject}
            while subject in parents:
                subject = parents[subject]
                assert subject not in seen
                seen.add(subject)


def test_a_grid_is_one_chain(propose):
    proposal = propose("a restaurant for 40 people")
    tables = {o.id for o in proposal.scene.objects if o.intent.program_item in ("four_table", "two_table")}
    for variant in proposal.variants:
        placed = {r.subject for r in variant if r.type == "next_to"} & tables
        assert len(tables - placed) == 1, "all but the first table have a neighbour"


def test_desks_stand_back_to_back_in_clusters(propose):
    proposal = propose("an office for 6 people")
    desks = [o.id for o in proposal.scene.objects if o.intent.program_item == "desk"]
    assert len(desks) == 6 and proposal.variants
    for variant in proposal.variants:
        backs = [r for r in variant if r.type == "back_to_back"]
        assert len(backs) == 3 and {i for r in backs for i in (r.subject, *r.targets)} == set(desks)
        beside = {r.subject for r in variant if r.type == "next_to"} & set(desks)
        assert len(beside) == 2, "of three pairs two stand beside or before another"


def test_a_line_of_several_items_stands_in_their_order(propose):
    proposal = propose("an office for 6 people")
    item = {o.id: o.intent.program_item for o in proposal.scene.objects}
    order = ["bookcase", "cabinet", "printer_table"]
    whole = [r for r in proposal.variants[0] if item[r.subject] in order]
    assert len(whole) == sum(name in order for name in item.values()) - 1
    for r in whole:
        assert order.index(item[r.target]) <= order.index(item[r.subject])
        assert r.params["side"] == "right" and r.params["gap"] == (0.0, 0.03)


def test_seats_share_the_sides_of_a_table(propose):
    proposal = propose("a dining room for 8 people")
    seats = [r for r in proposal.scene.relations if r.type == "seated_at"]
    sides: dict[str, list[tuple[int, int]]] = {}
    for r in seats:
        sides.setdefault(r.params["side"], []).append((r.params["k"], r.params["n"]))
    assert sum(map(len, sides.values())) == len({r.subject for r in seats}) >= 6
    for places in sides.values():
        assert sorted(places) == [(k, len(places)) for k in range(len(places))]


def test_what_is_asked_to_stand_in_the_middle_says_so(propose):
    proposal = propose("a living room with a coffee table in the middle of the room")
    found = [r for r in proposal.scene.relations if r.type == "in_middle"]
    assert found and all(r.asked for r in found)
