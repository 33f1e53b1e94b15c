"""A room that a model writes down: drawn when it holds together, refused in words that mend it when not."""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

import pytest
from pydantic_ai.models.test import TestModel

from sceneweaver.agent.executor import Executor
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import categories
from sceneweaver.generate.room_rules import check_room, missing
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.load import group_templates
from sceneweaver.knowledge.surfaces import crowds
from sceneweaver.language import read_request
from sceneweaver.llm import ModelClient
from sceneweaver.scene import CATALOGUE, InputError
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_llm import programme, vocabulary
from sceneweaver.tools.registry import tool
from sceneweaver.tools.room_reply import ProgrammeReply
from tests.agent.by_model.scripted import Script
from tests.tools.programmes import PROGRAMME, changed, item, place

DORMITORY = "a dormitory with two bunk beds and a dining table for four"


def context(library, client: ModelClient | None, text: str = DORMITORY, room: str = "dormitory") -> Context:
    brief = read_request(text)
    kind = room_type(room)
    return Context(brief, kind, empty_scene(brief, kind), library, 1, text, client=client)


def proposed(library, script: Script, **more: Any):
    return tool("init_llm").load().propose(context(library, script.client, **more))


HELD = [
    *PROGRAMME["items"],
    item("locker", "locker", need="needed", place=[place("against_wall")]),
    item("wardrobe", "wardrobe", need="needed", place=[place("against_wall")], fill="wardrobe"),
    item("desk", "desk", need="needed", place=[place("against_wall")]),
    item("bed", "single_bed", place=[place("against_wall")]),
]
GOOD = {**PROGRAMME, "area": 34, "items": HELD}


def test_a_room_that_holds_together_is_drawn(library):
    script = Script(GOOD)
    made = proposed(library, script)
    assert script.refusals == [] and made.scene is not None and made.fresh
    assert "a model wrote down what the room holds" in made.notes[0]
    assert made.scene.provenance["tool"] == "init_llm" and made.scene.room.type == "dormitory"
    kinds = [o.category for o in made.scene.objects]
    assert kinds.count("bunk_bed") == 2 and kinds.count("chair") == 4 and "wood_stove" in kinds


def test_it_is_valid_when_it_is_laid_out(library):
    items = [
        item("shelf", "metal shelf", need="needed", place=[place("against_wall")], fill="storage"),
        item("bin", "plastic_bin", need="needed", on=["shelf"]),
        item("box", "cardboard_box", need="needed", on=["shelf"]),
        item("bench", "workbench", need="needed", place=[place("against_wall")]),
        item("light", "ceiling_light", place=[place("on_grid")]),
    ]
    script = Script({"kind": "bicycle workshop", "area": 14, "items": items})
    made = proposed(library, script, text="a store room with one shelf", room="storage_room")
    within = context(library, None, "a store room with one shelf", "storage_room")
    executor = Executor(within.room_type, within.brief, Settings(device="cpu", candidates=8, generations=0))
    outcome = executor.run(within.scene, made, seed=1)
    assert outcome.report.valid, outcome.report.violations
    assert script.refusals == []


def test_equal_answers_make_equal_rooms(library):
    scenes = [proposed(library, Script(GOOD)).scene for _ in range(2)]
    assert scenes[0] == scenes[1]


WRONG: list[tuple[Any, str]] = [
    (changed(GOOD, 1, what=["frobnicator"]), "table.what names frobnicator, which nothing draws"),
    (changed(GOOD, 0, what=["bunkbedd"], id="bunk"), ""),
    (changed(GOOD, 0, place=[place("by_wall")]), "by_wall"),
    (changed(GOOD, 0, place=[place("near", "sofa")]), "bunk: near names sofa, which is no item"),
    (changed(GOOD, 0, place=[place("near", "bunk")]), "bunk.place near: `to` is bunk; give the id of another item"),
    (changed(GOOD, 0, place=[place("near", "table", max="far")]), "bunk.place near: params.max"),
    (changed(GOOD, 0, place=[place("near", "table", distance=2)]), "unknown param"),
    (changed(GOOD, 0, place=[place("between", "table")]), "between needs two targets"),
    (changed(GOOD, 1, width=[9.0, 9.5]), "table.width is [9, 9.5]; a dining_table has"),
    (changed(GOOD, 1, width=[1.6, 1.4]), "the first must not be more than the second"),
    (changed(GOOD, 1, top="feast"), "table.top is feast"),
    (changed(GOOD, 4, fill="boks"), 'shelf.fill is boks; did you mean "books"?'),
    (changed(GOOD, 0, count=[5, 2]), "bunk.count is [5, 2]; give [least, most]"),
    (changed(GOOD, 0, count=[900, 900]), "objects; at most 150"),
    (changed(GOOD, 2, **{"with": "stool"}), "stool is no item before it"),
    (changed(GOOD, 3, id="table"), "two items are called table"),
    (changed(GOOD, 3, what=["mug"], place=[]), "say with `on` which items carry it"),
    (changed(GOOD, 3, what=["mug"], place=[], mount="ceiling"), "a mug is not held by a ceiling"),
    ({**GOOD, "area": 6}, "m2 of floor; name less, or give a larger area"),
    ({**GOOD, "area": 1e9}, "area"),
    ({**GOOD, "groups": [{"use": "beds"}]}, 'group "beds" is unknown; did you mean "bed"?'),
    ({**GOOD, "groups": [{"use": "bed", "drop": ["sofa"]}]}, 'there is no item "sofa"'),
    ({**GOOD, "items": [one for one in HELD if one["id"] != "desk"]}, "such a room needs desk"),
    ({**GOOD, "items": [one for one in HELD if one["id"] not in ("table", "chair")]}, "asks for dining table"),
    ({**GOOD, "items": []}, "items"),
    ({**GOOD, "pose": [1, 2, 3]}, "pose"),
    (changed(GOOD, 0, position=[1, 2]), "position"),
    (changed(GOOD, 0, id="../../etc"), "id"),
    (changed(GOOD, 0, what=["x" * 5000]), "which nothing draws"),
    ("a mountain hut, surely", ""),
]


@pytest.mark.parametrize(("wrong", "words"), WRONG, ids=range(len(WRONG)))
def test_what_is_wrong_is_told_to_the_model(wrong, words, library):
    script = Script(wrong, GOOD)
    proposed(library, script)
    assert not words or any(words in line for line in script.refusals), script.refusals


def test_what_the_request_does_not_want_is_refused(library):
    more = {**GOOD, "items": [*HELD, item("tv", "television", place=[place("against_wall")])]}
    script = Script(more, GOOD)
    proposed(library, script, text=DORMITORY + ", without a television")
    assert "tv: the request wants no" in script.refusals[0]


def test_what_is_only_there_for_what_is_not_wanted_is_not_needed():
    living, held = room_type("living_room"), programme(ProgrammeReply.model_validate(PROGRAMME), room_type("dormitory"))
    said = "; ".join(missing(held, living, read_request("a living room without a television")))
    assert "tv" not in said and "such a room needs sofa" in said
    assert "such a room needs tv_stand" in "; ".join(missing(held, living, read_request("a living room")))


def test_a_range_that_reaches_beyond_is_cut():
    wide = programme(ProgrammeReply.model_validate(changed(PROGRAMME, 1, width=[0.2, 99])), room_type("dormitory"))
    low, high = wide.item("table").size[1] or (0, 0)
    known = categories()["dining_table"].size
    assert known is not None and (low, high) == known.width
    check_room(wide)


def test_it_needs_a_model_and_says_so(library):
    with pytest.raises(InputError, match="tool init_llm needs a language model, and there is none; use init_prior"):
        tool("init_llm").load().propose(context(library, None))


def test_a_model_that_never_gets_it_right_is_one_line(library):
    with pytest.raises(InputError, match="^tool init_llm: ") as caught:
        proposed(library, Script({**GOOD, "area": 6}))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_arbitrary_data_is_refused(seed, library):
    with pytest.raises(InputError, match="init_llm"):
        tool("init_llm").load().propose(context(library, ModelClient(TestModel(seed=seed))))


def test_the_question_holds_request_and_words_and_is_the_same_for_equal_runs(library):
    one, two = Script(GOOD), Script(GOOD)
    proposed(library, one)
    proposed(library, two)
    assert one.prompts == two.prompts
    assert DORMITORY in one.prompts[0] and "against_wall" in one.prompts[0] and "bunk_bed" in one.prompts[0]


def test_the_words_hold_all_that_a_room_may_be_written_in_and_are_few():
    words = json.loads(vocabulary())
    for name, spec in CATALOGUE.items():
        if spec.target != "objects":
            assert words["relations"][name] == f"({' '.join((spec.target, *sorted(spec.params)))}) {spec.description}"
    assert set(words["groups"]) == set(group_templates()) and set(words["themes"]) == set(crowds())
    assert words["groups"]["desk"].startswith("(desk chair:office_chair bin:wastebasket) ")
    assert set(words["categories"].split()) == {name for name, one in categories().items() if one.size is not None}
    assert len(vocabulary()) < 40_000


def test_items_are_put_in_order_and_nouns_become_categories():
    turned = {**PROGRAMME, "items": PROGRAMME["items"][::-1]}
    room = programme(ProgrammeReply.model_validate(turned), room_type("dormitory"))
    ids = [one.id for one in room.items]
    assert ids.index("table") < ids.index("chair")
    assert room.item("stove").what == ("wood_stove",)
    check_room(room)


def test_what_small_models_write_is_understood():
    loose = {"id": "stove", "what": "wood stove", "count": 1, "width": 0.6, "on": None, "place": "soft against_wall"}
    items = [{**loose, "place": ["soft against_wall", {"type": "near", "to": "table", "params": None}]}, loose]
    given = {**PROGRAMME, "groups": None, "items": [*PROGRAMME["items"][:3], {**items[0], "id": "fire"}, items[1]]}
    room = programme(ProgrammeReply.model_validate(given), room_type("dormitory"))
    fire, stove = room.item("fire"), room.item("stove")
    assert [(p.type, p.to, p.soft) for p in fire.place] == [("against_wall", None, True), ("near", "table", False)]
    assert (stove.count.least, stove.count.most, stove.size[1]) == (1, 1, (0.6, 0.6)) and stove.place[0].soft


def test_a_group_brings_its_items():
    with_group = {**PROGRAMME, "area": 40, "groups": [{"use": "bed", "as": "guest", "drop": ["bench"]}]}
    room = programme(ProgrammeReply.model_validate(with_group), room_type("bedroom"))
    assert {"guest_bed", "guest_nightstand"} <= {one.id for one in room.items}
    assert "guest_bench" not in {one.id for one in room.items}
    check_room(room)


def test_rules_never_offer_it():
    from sceneweaver.agent.design import usable
    from sceneweaver.tools.registry import tools

    offered = [n for n, t in tools().items() if usable(n, t, Settings(), room_type("bedroom"))]
    assert "init_llm" not in offered and "init_prior" in offered


def test_all_that_a_model_wrote_is_there_however_much_the_request_says(library):
    names = "a bunk bed, a desk, a chair, a wardrobe, a mirror, a rug, a plant, a clock, a poster, a vase and a bin"
    text = f"a dormitory with {names}"
    asked = [
        item("rug", "rug"),
        item("mirror", "wall_mirror", mount="wall"),
        item("plant", "potted plant"),
        item("clock", "wall clock"),
        item("poster", "poster"),
        item("vase", "vase", on=["table", "desk"]),
        item("bin", "wastebasket"),
    ]
    script = Script({**GOOD, "area": 60, "items": [*HELD, *asked]})
    made = proposed(library, script, text=text)
    assert script.refusals == [] and made.scene is not None
    kinds = {o.intent.program_item for o in made.scene.objects}
    assert {"stove", "shelf", "lamp", "locker", "table"} <= kinds


DESKS = item("desk", "desk", need="needed", count=[24, 24], row="grid")
CHAIRS = item("chair", "chair", need="needed", **{"with": "desk"}, place=[place("front_against", "desk")])
BOARD = item("board", "whiteboard", need="needed", place=[place("against_wall")])
TEACHER = item("teacher_desk", "desk", need="needed", place=[place("against_wall")])


def furnished(library, text: str, *items: dict[str, Any], room: str = "classroom") -> tuple[Counter[str], str]:
    """How many of each item of a model's room there are, those of the request alone under "", and what is noted."""
    script = Script({"kind": room, "area": 70, "items": list(items)})
    made = proposed(library, script, text=text, room=room)
    assert script.refusals == [] and made.scene is not None
    return Counter(o.intent.program_item or "" for o in made.scene.objects), made.notes[0]


@pytest.mark.parametrize("text", ["a classroom with a teacher's desk", "a classroom with a desk"])
def test_what_the_request_names_takes_no_place_of_other_things(text, library):
    counts, note = furnished(library, text, TEACHER, DESKS, CHAIRS, BOARD)
    assert (counts["teacher_desk"], counts["desk"], counts["chair"]) == (1, 24, 24)
    assert "not as it was written" not in note


def test_what_the_request_names_besides_is_there_besides(library):
    counts, _ = furnished(library, "a classroom with a teacher's desk", DESKS, CHAIRS, BOARD)
    assert (counts[""], counts["desk"], counts["chair"]) == (1, 24, 24)
    counts, _ = furnished(library, "a classroom with 24 desks and a teacher's desk", TEACHER, DESKS, CHAIRS, BOARD)
    assert (counts[""], counts["teacher_desk"], counts["desk"]) == (0, 1, 24)


def test_the_number_of_the_request_counts_and_is_told(library):
    counts, note = furnished(library, "a classroom with two desks", DESKS, CHAIRS, BOARD)
    assert (counts["desk"], counts["chair"]) == (2, 2)
    assert "not as it was written: 2 of 24 desk, as the request says how many" in note


def test_hard_relations_that_cannot_be_kept_are_told(library):
    locker = item("locker", "locker", need="needed", place=[place("around", "table"), place("near", "table", True)])
    wrong = {**GOOD, "area": 40, "items": [locker if one["id"] == "locker" else one for one in HELD]}
    made = proposed(library, Script(wrong))
    assert "locker around table is not kept, as around cannot be said of such a thing there" in made.notes[0]
    assert "near" not in made.notes[0]
