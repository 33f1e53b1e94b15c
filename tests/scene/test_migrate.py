"""Older schema versions are brought up to date; others are refused with what to do."""

from __future__ import annotations

import copy
import math

import pytest

from sceneweaver.scene import SCHEMA, FloorFinish, InputError, RoomFinish, Scene, migration
from sceneweaver.scene import migrate as module
from sceneweaver.scene.migrate import _migrations, migrate

V0 = "sceneweaver.scene/0"


@pytest.fixture
def old(small):
    small["schema"] = V0
    for o in small["objects"]:
        if "pose" in o:
            o["pose"] = {"position": o["pose"]["position"], "yaw": 0.7}
    return small


def test_version_0_had_yaw(old):
    before = copy.deepcopy(old)
    scene = Scene.from_json(old)
    assert scene.schema_ == SCHEMA and scene.object("desk-0").pose.yaw == pytest.approx(0.7)
    assert scene.object("desk-0").pose.position == (2, 2, 0) and scene.object("chair-0").pose.yaw == 0
    assert old == before


@pytest.mark.parametrize("yaw", [float("nan"), math.inf, "0", True, None])
def test_version_0_with_a_bad_yaw(old, yaw):
    old["objects"][1]["pose"]["yaw"] = yaw
    with pytest.raises(InputError, match="object 'desk-0': pose.yaw is .*; give a finite number of radians"):
        Scene.from_json(old)


def test_version_0_that_makes_no_sense_is_refused_by_the_model(old):
    old["objects"][1] = 5
    with pytest.raises(InputError, match=r"objects\[1\] is 5"):
        Scene.from_json(old)


def test_current_data_is_left_alone(small):
    assert migrate(small) is small


@pytest.mark.parametrize(
    ("schema", "message"),
    [
        ("sceneweaver.scene/2", 'written by a newer version than "sceneweaver.scene/1"; upgrade sceneweaver'),
        ("sceneweaver.scene/999999", "newer version"),
        ("sceneweaver.scene/9999999", 'a scene file has "sceneweaver.scene/1"'),
        ("sceneweaver.metrics/1", 'schema is "sceneweaver.metrics/1"; a scene file has "sceneweaver.scene/1"'),
        ("sceneweaver.scene/01", "a scene file has"),
        ("sceneweaver.scene/-1", "a scene file has"),
        (1, "schema is 1; a scene file has"),
        (None, "schema is null; a scene file has"),
        ([], "schema is a list; a scene file has"),
    ],
)
def test_other_schemas(small, schema, message):
    small["schema"] = schema
    with pytest.raises(InputError) as caught:
        Scene.from_json(small)
    assert message in str(caught.value)


def test_no_schema(small):
    del small["schema"]
    with pytest.raises(InputError, match='"schema" is missing; add "schema": "sceneweaver.scene/1"'):
        Scene.from_json(small)


def test_a_version_without_migration(small, monkeypatch):
    monkeypatch.delitem(_migrations, V0)
    small["schema"] = V0
    with pytest.raises(InputError, match="too old to be read"):
        Scene.from_json(small)


def test_migrations_are_chained(small, monkeypatch):

    monkeypatch.setattr(module, "_CURRENT", 3)
    monkeypatch.setattr(module, "SCHEMA", "sceneweaver.scene/3")
    seen = []
    for k in (1, 2):

        @migration(f"sceneweaver.scene/{k}")
        def step(data, k=k):
            seen.append((k, data["schema"]))
            return {**data, "step": k}

    try:
        out = migrate({**small, "schema": V0})
    finally:
        for k in (1, 2):
            del _migrations[f"sceneweaver.scene/{k}"]
    assert seen == [(1, "sceneweaver.scene/1"), (2, "sceneweaver.scene/2")]
    assert out["schema"] == "sceneweaver.scene/3" and out["step"] == 2


def test_a_migration_that_stumbles_gives_one_line(small, monkeypatch):
    monkeypatch.setitem(_migrations, V0, lambda data: data["nothing"])
    small["schema"] = V0
    with pytest.raises(InputError, match=r"could not be brought to sceneweaver.scene/1 \(KeyError"):
        Scene.from_json(small)


@pytest.mark.parametrize("schema", [V0, SCHEMA, "sceneweaver.scene/7", "other/0"])
def test_only_older_versions_without_migration_take_one(schema):
    with pytest.raises(InputError, match="has a migration already|is no version before"):
        migration(schema)


def test_finishes_of_old_files_move_from_the_provenance_to_the_room(small):
    small["provenance"] = {"seed": 7, "finish": {"floor": "stone", "walls": "sage"}}
    before = copy.deepcopy(small)
    scene = Scene.from_json(small)
    assert small == before and scene.provenance == {"seed": 7}
    assert scene.room.finish == RoomFinish(walls="sage", floor=FloorFinish(material="stone"))
    again = scene.to_json()
    assert migrate(again) is again and Scene.from_json(again) == scene


def test_a_finish_of_somebody_else_stays_in_the_provenance(small):
    for foreign in ({"floor": "lava"}, {"gloss": 3}, "matte", {"walls": 3}):
        small["provenance"] = {"finish": foreign}
        scene = Scene.from_json(small)
        assert scene.room.finish is None and scene.provenance == {"finish": foreign}
