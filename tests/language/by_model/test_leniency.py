"""What small models write and mean."""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

import pytest
from pydantic import BaseModel, BeforeValidator, ValidationError

from sceneweaver.assets.materials import STYLES
from sceneweaver.language.by_model.leniency import Count, Flag, Listed, Metres, Number, Text, Whole, absent, term
from sceneweaver.language.by_model.reply import SAME, RelationReply, RequestReply, Style
from sceneweaver.language.model import RelationType

Word = Literal["next_to", "color", "L"]


class Lenient(BaseModel):
    names: Annotated[tuple[Text, ...], Listed] = ()
    number: Annotated[Number | None, BeforeValidator(absent)] = None
    length: Annotated[Metres | None, BeforeValidator(absent)] = None
    whole: Annotated[Whole | None, BeforeValidator(absent)] = None
    count: Count = None
    flag: Flag = False
    word: Annotated[Word | None, BeforeValidator(term(get_args(Word)))] = None


@pytest.mark.parametrize(
    ("field", "given", "meant"),
    [
        ("names", None, ()),
        ("names", "none", ()),
        ("names", " bed ", ("bed",)),
        ("names", [["bed"]], ("bed",)),
        ("names", ["bed", None, "desk"], ("bed", "desk")),
        ("names", '["bed", "desk"]', ("bed", "desk")),
        ("number", "2.5", 2.5),
        ("number", "2,5", 2.5),
        ("number", "n/a", None),
        ("length", "90 cm", 0.9),
        ("length", "2.4 m", 2.4),
        ("length", "45mm", 0.045),
        ("length", 3, 3.0),
        ("whole", "3", 3),
        ("whole", 3.0, 3),
        ("whole", "", None),
        ("count", 2, (2, 2)),
        ("count", "2", (2, 2)),
        ("count", [2], (2, 2)),
        ("count", "2-4", (2, 4)),
        ("count", "[2, 4]", (2, 4)),
        ("count", ["2", "4"], (2, 4)),
        ("count", {"min": 2, "max": 4}, (2, 4)),
        ("count", [3, None], (3, 7)),
        ("count", [None, 4], (1, 4)),
        ("count", [], None),
        ("count", [None, None], None),
        ("flag", None, False),
        ("flag", "true", True),
        ("word", "Next to", "next_to"),
        ("word", "next-to", "next_to"),
        ("word", "Colour", "color"),
        ("word", "l", "L"),
        ("word", "none", None),
    ],
)
def test_what_can_mean_one_thing_is_taken_so(field: str, given: Any, meant: Any) -> None:
    assert getattr(Lenient.model_validate({field: given}), field) == meant


@pytest.mark.parametrize(
    ("field", "given"),
    [
        ("number", "1,500"),
        ("number", "about two"),
        ("number", True),
        ("number", "nan"),
        ("number", float("inf")),
        ("length", "6 ft"),
        ("whole", 2.5),
        ("whole", "two"),
        ("count", [1, 2, 3]),
        ("count", 2.5),
        ("count", "many"),
        ("count", {"a": 1, "b": 2, "c": 3}),
        ("flag", "perhaps"),
        ("word", "beside"),
        ("names", [["bed", "desk"]]),
    ],
)
def test_what_may_mean_several_things_is_refused(field: str, given: Any) -> None:
    with pytest.raises(ValidationError):
        Lenient.model_validate({field: given})


def test_other_words_for_relations_and_a_room_in_a_word() -> None:
    said = RelationReply.model_validate({"type": "Across from", "subject": ["a"], "targets": "b"})
    assert (said.type, said.subject, said.targets) == ("opposite", "a", ("b",))
    assert set(SAME.values()) <= set(get_args(RelationType))
    assert not set(SAME) & set(get_args(RelationType))
    assert RequestReply.model_validate({"room": "bedroom"}).room.kind == "bedroom"
    assert RequestReply.model_validate({"room": None}).room == RequestReply().room


def test_the_styles_of_a_reply_are_those_that_there_are() -> None:
    assert get_args(Style) == STYLES
