"""Twins: files that differ in what is stated and in nothing else, and are judged as stated."""

from __future__ import annotations

import json
from collections import Counter

import pytest

from sceneweaver.datasets.twins import Twin, twin_files, twins
from sceneweaver.knowledge.library import load_scene
from sceneweaver.scene import Scene
from sceneweaver.verify import check

ROOMS = ("bathroom-1", "waiting_room-1")
EACH = 6


@pytest.fixture(scope="module")
def pairs() -> list[tuple[Scene, list[Twin]]]:
    scenes = [load_scene(name) for name in ROOMS]
    return [(scene, twins(scene, EACH, seed)) for seed, scene in enumerate(scenes)]


def test_there_are_as_many_as_asked_half_of_them_broken(pairs):
    found = [twin.difference for _, some in pairs for twin in some]
    assert len(found) == EACH * len(ROOMS)
    assert Counter(d["valid"] for d in found) == {True: len(found) / 2, False: len(found) / 2}
    assert len({(d["change"], d["breaks"]) for d in found}) >= 5


def test_files_differ_in_what_is_stated_and_in_nothing_else(pairs):
    for scene, some in pairs:
        before = json.loads(scene.dumps())
        for twin in some:
            stated = twin.difference
            after = json.loads(twin_files([twin])["twin-0.scene.json"])
            assert _without_content(before) == _without_content(after)
            old, new = ({o["id"]: o for o in data["objects"]} for data in (before, after))
            ids = {stated["object"], *stated["carried"]}
            assert [i for i in old if i in new] == list(new) and set(old) - set(new) <= {stated["object"]}
            assert {i for i in old if old[i] != new.get(i)} == ids
            for i in ids & set(new):
                changed = {key for key in old[i] if old[i][key] != new[i][key]}
                assert {key: old[i][key] for key in changed}.items() <= stated["before"][i].items()
                assert {key: new[i][key] for key in changed}.items() <= stated["after"][i].items()
            removed = [r["index"] for r in stated["measured"]["relations_removed"]]
            kept = [r for k, r in enumerate(before["relations"]) if k not in removed]
            assert after["relations"] == kept
            assert not removed or stated["change"] == "removed"


def _without_content(data: dict) -> dict:
    return {key: value for key, value in data.items() if key not in ("objects", "relations")}


def test_twins_are_judged_as_stated(pairs):
    for _, some in pairs:
        for twin in some:
            stated = twin.difference
            report = check(twin.scene)
            hard = [v for v in report.violations if v.hard]
            assert [v.kind for v in hard] == ([stated["breaks"]] if stated["breaks"] else [])
            assert report.valid is stated["valid"] is (stated["breaks"] is None)
            assert stated["measured"]["valid"] == [True, report.valid]
            assert stated["measured"]["collisions"] == [0, report.collisions]
            named = {name for v in hard for name in v.objects}
            assert named <= {stated["object"], *stated["carried"], *stated["with"]}
            if stated["change"] in ("moved", "turned"):
                assert stated["measured"]["distance"] > 0.05 or abs(stated["measured"]["turn"]) > 20


def test_twins_follow_from_scene_and_seed_alone(pairs):
    scene, some = pairs[0]
    assert twin_files(twins(Scene.loads(scene.dumps()), EACH, 0)) == twin_files(some)
    assert twin_files(twins(scene, EACH, 1)) != twin_files(some)


def test_an_invalid_scene_has_no_twins(pairs):
    broken = next(twin.scene for _, some in pairs for twin in some if not twin.difference["valid"])
    assert twins(broken, 2, 0) == []
    assert twins(pairs[0][0], 0, 0) == []
