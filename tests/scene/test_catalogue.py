"""The catalogue has the numbers of the design's table."""

from __future__ import annotations

import dataclasses
import json

import pytest

from sceneweaver.scene import (
    CATALOGUE,
    SIDES,
    InputError,
    ParamSpec,
    Relation,
    RelationSpec,
    Scene,
    register_relation,
    unregister_relation,
)
from sceneweaver.scene.catalogue import ROLES, TARGETS
from sceneweaver.scene.messages import FieldError

ALL, LRF, LR, B, F = (
    ("front", "back", "left", "right"),
    ("left", "right", "front"),
    ("left", "right"),
    ("back",),
    ("front",),
)

# type: target, subject's sides, target's sides, degrees, gap, overlap, other numbers, exempt from zones
TABLE = {
    "against_wall": ("wall?", B, (), 5, (0, 0.07), 0.9, {"door_walls": "allowed", "middle": None}, False),
    "side_against_wall": ("wall?", LRF, (), 5, (0, 0.05), 0.9, {"side": "any"}, False),
    "front_against": ("object", F, ALL, 15, "tucked", 0.5, {}, True),
    "front_to_front": ("object", F, F, 15, "tucked", 0.5, {"offset": None}, True),
    "leftright_to_leftright": ("object", LR, LR, 10, (0, 0.05), 0.5, {"backs": None}, True),
    "side_by_side": ("object", LRF, LRF, 10, (0, 0.05), 0.5, {}, True),
    "back_to_back": ("object", B, B, 10, (0, 0.05), 0.5, {}, True),
    "on_floor": ("none", (), (), None, None, None, {"height": 0.002}, False),
    "on_top": ("object", (), (), None, None, None, {"height": 0.002}, False),
    "inside": ("object", (), (), None, None, None, {"height": 0.002}, False),
    "near": ("object", (), (), None, None, None, {"max": 1.0}, False),
    "distance": ("object", (), (), None, None, None, {"min": None, "max": None}, False),
    "facing": ("object", F, (), 15, None, None, {"offset": None}, False),
    "aligned": ("object", (), (), 3, None, None, {}, False),
    "parallel": ("object", (), (), 3, None, None, {}, False),
    "left_of": ("object", (), ("left",), None, None, None, {"max": 1.5, "min": 0, "band": 1.5, "frame": "own"}, False),
    "right_of": (
        "object",
        (),
        ("right",),
        None,
        None,
        None,
        {"max": 1.5, "min": 0, "band": 1.5, "frame": "own"},
        False,
    ),
    "in_front_of": ("object", (), ("front",), None, None, None, {"max": 1.5, "min": 0, "band": 1.5}, False),
    "behind": ("object", (), ("back",), None, None, None, {"max": 1.5, "min": 0, "band": 1.5}, False),
    "centered_on": ("object", (), (), None, None, None, {"offset": 0.10, "axis": "either", "ahead": None}, False),
    "in_corner": ("none", (), (), None, None, None, {"to_corner": 0.25, "to_wall": 0.15, "corner": 0.17}, False),
    "at_window": ("window", (), (), None, None, 0.5, {"max": 1.0, "offset": 100.0}, False),
    "between": ("objects", (), (), None, None, None, {"along": (0.2, 0.8), "aside": 0.5}, False),
    "around": ("object", F, ALL, 15, "tucked", 0.5, {"n": None, "spread": 25}, True),
    "away_from_door": ("door?", (), (), None, None, None, {"min": 1.0}, False),
    "above": ("object", (), (), None, None, None, {"lateral": 0.5}, False),
    "below": ("object", (), (), None, None, None, {"lateral": 0.5}, False),
    "same_height": ("object", (), (), None, None, None, {"tolerance": 0.03}, False),
    "seated_at": (
        "object",
        F,
        ALL,
        15,
        "tucked",
        None,
        {"side": "front", "k": 0, "n": 1, "offset": 0.05, "frame": "own"},
        False,
    ),
    "next_to": (
        "object",
        (),
        ("left", "right", "front", "back"),
        3,
        (0, 0.6),
        None,
        {"side": "left", "offset": 0.05, "frame": "own"},
        False,
    ),
    "arranged": ("object", (), (), 3, None, None, {"ahead": 0, "left": 0, "turn": 0, "offset": 0.05}, False),
    "run_on": ("object", (), LR, 3, (0, 0.03), None, {"side": "right", "offset": 0.05, "frame": "own"}, False),
    "in_middle": ("none", (), (), None, None, None, {"offset": 0.5}, False),
    "over": ("object", (), (), None, None, None, {"inset": 0, "forward": 0, "left": 0, "offset": None}, False),
    "near_window": ("window?", (), (), None, None, None, {"min": 0, "max": 1.2}, False),
    "near_door": ("door?", (), (), None, None, None, {"min": 0, "max": 1.2}, False),
    "across_from": (
        "object",
        F,
        ALL,
        5,
        (0.3, 3),
        None,
        {"side": "any", "k": 0, "n": 1, "offset": 0.15, "frame": "own"},
        False,
    ),
    "facing_door": ("door?", F, (), 50, None, None, {"aside": None}, False),
    "off_walls": ("none", (), (), None, None, None, {"min": 0.9}, False),
    "on_grid": ("none", (), (), None, None, None, {"k": 0, "n": 1, "offset": 0.3}, False),
    "beside": ("object", (), LR, None, None, None, {"max": 1.5, "min": 0, "band": 1.5}, False),
}


def test_the_types_are_those_of_the_design():
    assert list(CATALOGUE) == list(TABLE)


@pytest.mark.parametrize("name", TABLE)
def test_numbers_of_the_design(name):
    spec = CATALOGUE[name]
    target, sides, target_sides, degrees, gap, overlap, others, ties = TABLE[name]
    assert (spec.type, spec.target, spec.ties_zones) == (name, target, ties)
    assert spec.subject_sides == sides and spec.target_sides == target_sides
    for key, value in {"degrees": degrees, "gap": gap, "overlap": overlap, **others}.items():
        assert spec.value(None, key) == value, key
    named = {key for key, value in (("degrees", degrees), ("gap", gap), ("overlap", overlap)) if value is not None}
    assert {*spec.params, *spec.constants} == named | {*others}
    assert spec.target in TARGETS and {*spec.subject_sides, *spec.target_sides} <= {*SIDES}
    assert spec.description.endswith(".") and all(p.description for p in spec.params.values())
    assert all(p.unit in ("m", "deg", "") and p.name == key for key, p in spec.params.items())


def test_zones_are_tied_by_the_types_of_the_contract_alone():
    tying = {name for name, spec in CATALOGUE.items() if spec.ties_zones}
    assert tying == {
        "front_against",
        "front_to_front",
        "leftright_to_leftright",
        "side_by_side",
        "back_to_back",
        "around",
    }


def test_defaults_pass_their_own_checks():
    for spec in CATALOGUE.values():
        given = {k: p.default for k, p in spec.params.items() if p.default is not None}
        required = {k: 1 for k, p in spec.params.items() if p.required}
        assert spec.check_params({**given, **required}) == {**given, **required}


def test_a_relation_overrides_and_the_rest_stays():
    relation = Relation(type="front_to_front", subject="a", target="b", params={"gap": [0.3, 0.5]})
    spec = CATALOGUE[relation.type]
    assert spec.value(relation, "gap") == (0.3, 0.5) and spec.value(relation, "degrees") == 15
    assert spec.value(relation.params, "gap") == (0.3, 0.5) and spec.value(None, "gap") == "tucked"
    with pytest.raises(InputError, match='front_to_front: no number "gpa"; did you mean "gap"'):
        spec.value(relation, "gpa")


def test_gap_range_resolves_tucked_by_the_subjects_depth():
    spec = CATALOGUE["front_against"]
    assert spec.gap_range(None, 0.5) == (-0.4, 0.05) and spec.gap_range({"gap": (0.0, 0.1)}, 0.5) == (0.0, 0.1)
    assert CATALOGUE["against_wall"].gap_range(None, 0.5) == (0, 0.07)
    with pytest.raises(InputError, match="near: "):
        CATALOGUE["near"].gap_range(None, 0.5)


def test_a_choice_is_one_of_its_words():
    spec = CATALOGUE["next_to"]
    assert spec.check_params({"side": "back"}) == {"side": "back"}
    for value in ("top", 1, None, ["back"]):
        with pytest.raises(FieldError) as caught:
            spec.check_params({"side": value})
        assert "give one of left, right, front, back" in caught.value.text


def test_roles():
    assert CATALOGUE.with_role("seat") == {"front_against", "front_to_front", "around", "seated_at"}
    assert CATALOGUE.with_role("wall", "seat") == CATALOGUE.with_role("wall") | CATALOGUE.with_role("seat")
    assert all(spec.roles <= set(ROLES) for spec in CATALOGUE.values())
    assert all(CATALOGUE.with_role(role) for role in ROLES)
    assert "near" in CATALOGUE.with_role("placing") and "aligned" not in CATALOGUE.with_role("placing")


def test_target_kinds():
    assert (CATALOGUE["against_wall"].target_kind, CATALOGUE["against_wall"].target_optional) == ("wall", True)
    assert (CATALOGUE["near"].target_kind, CATALOGUE["near"].target_optional) == ("object", False)
    assert CATALOGUE["in_corner"].target_optional


def test_catalogue_is_read_only():
    with pytest.raises(TypeError):
        CATALOGUE["near"] = CATALOGUE["distance"]
    with pytest.raises(dataclasses.FrozenInstanceError):
        CATALOGUE["near"].target = "none"
    with pytest.raises(TypeError):
        CATALOGUE["near"].params["max"] = None


def test_relations_of_your_own(small):
    small["relations"].append({"type": "orbits", "subject": "chair-0", "target": "desk-0", "params": {"radius": 2}})
    with pytest.raises(InputError, match='"orbits" is unknown'):
        Scene.from_json(small)
    radius = ParamSpec("radius", "number", 1.0, "m", "Distance of the centres", minimum=0)
    spec = register_relation(RelationSpec("orbits", "Keeps its distance.", params={"radius": radius}))
    try:
        scene = Scene.from_json(small)
        assert CATALOGUE["orbits"] is spec and spec.value(scene.relations[-1], "radius") == 2
        with pytest.raises(InputError, match="is there already"):
            register_relation(spec)
    finally:
        unregister_relation("orbits")
    assert "orbits" not in CATALOGUE
    for name, message in (("orbits", "is unknown"), ("near", "is built in")):
        with pytest.raises(InputError, match=message):
            unregister_relation(name)
    with pytest.raises(InputError, match='target is "objct"; did you mean "object"'):
        register_relation(RelationSpec("x", "x", target="objct"))
    with pytest.raises(InputError, match='side "top" is unknown'):
        register_relation(RelationSpec("x", "x", subject_sides=("top",)))


def test_zoo_relations_are_all_known(zoo_file):
    for relation in json.loads(zoo_file.read_text("utf-8"))["relations"]:
        CATALOGUE[relation["type"]].check_params(relation["params"])
