"""Replies of the scripted model: they fit what is asked for today, and one room is designed with them."""

import pytest

from benchmarks.families.by_model import rows
from benchmarks.rooms_by_model import pair, rooms
from benchmarks.scripted import kinds
from sceneweaver.agent import design
from sceneweaver.knowledge.load import read_yaml
from sceneweaver.llm import Reply

KINDS = {kind.__name__: kind for kind in kinds()}
REPLIES = [
    pytest.param(row, id=f"{room.name}-{k}-{row['asks']}")
    for room in rooms().values()
    if room.replies.exists()
    for k, row in enumerate(read_yaml(room.replies.read_text("utf-8")))
]


@pytest.mark.parametrize("row", REPLIES)
def test_replies_are_of_the_types_that_are_asked_for(row):
    if row["asks"] == "Inputs":  # of each tool its own
        assert set(row["says"]) == {"inputs"} and isinstance(row["says"]["inputs"], dict)
    else:
        KINDS[row["asks"]].model_validate(row["says"])


def test_a_type_of_someone_else_is_not_asked_for():
    class Plan(Reply):
        pass

    assert Plan not in list(kinds())


def test_every_room_has_replies_for_all_parts():
    for room in rooms().values():
        asked = {row["asks"] for row in read_yaml(room.replies.read_text("utf-8"))}
        assert asked >= {"RequestReply", "Plan", "Look"}, room.name


@pytest.mark.slow
def test_a_room_by_rules_and_with_the_scripted_model_and_its_replay(tmp_path):
    made = pair(rooms()["podcast_studio"], tmp_path, looks=False)
    assert [row["valid"] for row in rows(made)] == ["yes", "yes"]
    assert made.model.met >= made.rules.met
    assert not made.missing
    options = {"device": "cpu", "time_limit": None, "pictures": False, "export": "none"}
    design("", out=tmp_path / "again", replay=tmp_path / "model", **options)
    assert (tmp_path / "again" / "scene.json").read_bytes() == (tmp_path / "model" / "scene.json").read_bytes()
