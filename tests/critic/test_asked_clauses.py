"""What is so beside words that nobody understood is so in part only, and the grade says it."""

from __future__ import annotations

from sceneweaver.critic import Review
from sceneweaver.critic.asked_words import swallowed
from sceneweaver.language import read_request

from .rooms import Case, living


def reviewed(text: str) -> Review:
    case = living()
    # The fixture's objects stand for what the request names.
    graph = read_request(text)
    return Case(case.scene, case.room_type, graph).review()


def statuses(review: Review) -> dict[str, str]:
    return {outcome.item: outcome.status for outcome in review.alignment.items}


def test_words_that_are_lost_cast_doubt_on_their_clause_alone() -> None:
    plain = statuses(reviewed("a living room with a sofa, a coffee table"))
    assert plain["sofa"] == plain["coffee_table"] == "met"
    lost = statuses(reviewed("a living room with a sofa for everything else glorp, a coffee table"))
    assert lost["coffee_table"] == "met" and lost["sofa"] == "partly", lost


def test_a_request_that_is_not_all_so_is_graded_at_most_eight() -> None:
    whole = reviewed("a living room with a sofa")
    assert whole.grades["alignment"] == 10.0
    part = reviewed("a living room with a sofa. Everything glorp.")
    assert part.grades["alignment"] <= 8.0


def test_a_side_or_an_each_that_was_not_read_casts_doubt() -> None:
    graph = read_request("a living room with a sofa against the wall, a coffee table")
    text = graph.text.replace("the wall", "the rear wall")  # as if "rear" were a word that says nothing
    moved = graph.model_copy(update={"text": text})
    assert [d.words for d in swallowed(moved)] == ["rear wall"]
    said = graph.model_copy(update={"text": "a living room with a sofa against the wall for everyone"})
    assert [d.words for d in swallowed(said)] == ["everyone"]
    assert not list(swallowed(read_request("a living room with a sofa against the left wall")))


def test_what_one_cannot_see_of_a_thing_makes_it_so_in_part() -> None:
    found = statuses(reviewed("a living room with a tattered sofa"))
    assert found["sofa"] != "met", found
