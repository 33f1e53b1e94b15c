"""Handles, their versions, and what differs between two of them."""

from __future__ import annotations

import pytest

from sceneweaver.mcp.differences import Difference, difference
from sceneweaver.mcp.handles import Handle, Handles
from sceneweaver.mcp.limits import Limits
from sceneweaver.scene import InputError, Scene

STUDY = Scene.example("study")
REPORT = {"valid": True}


def handle(changes: int, most: int = 100) -> Handle:
    made = Handle("s1", most)
    for k in range(changes):
        made.add(STUDY.model_copy(update={"id": f"study {k + 1}"}), REPORT, "changed")
    return made


def test_undo_and_redo_walk_along_the_line():
    one = handle(3)
    assert [one.step(-1).number, one.step(-1).number, one.step(1).number] == [2, 1, 2]
    assert one.add(STUDY, REPORT, "changed").number == 4
    assert one.line == [1, 2, 4] and sorted(one.versions) == [1, 2, 3, 4]
    with pytest.raises(InputError, match="redo: nothing of s1 was undone"):
        one.step(1)
    assert one.get(3).content.id == "study 3"  # what was undone can still be looked at
    assert [one.step(-1).number, one.step(-1).number] == [2, 1]
    with pytest.raises(InputError, match="there is nothing to undo"):
        one.step(-1)
    assert one.current.number == 1


def test_the_oldest_versions_are_forgotten_and_that_is_said():
    one = handle(5, most=3)
    assert sorted(one.versions) == one.line == [3, 4, 5] and one.current.number == 5
    with pytest.raises(InputError, match="version: 1 of s1 is no longer kept, the last 3 are; give one of 3 to 5"):
        one.get(1)
    with pytest.raises(InputError, match="version: 9 of s1 is not there"):
        one.get(9)
    one.step(-1), one.step(-1)
    with pytest.raises(InputError, match="older versions than 3 are no longer kept"):
        one.step(-1)
    one.add(STUDY, REPORT, "changed")  # after an undo the current version is kept, whatever its number
    assert one.current.number == 6 and one.step(-1).number == 3


def test_scenes_are_kept_up_to_a_bound():
    handles = Handles(Limits(scenes=2))
    names = [handles.open(STUDY, REPORT, "opened").id for _ in range(2)]
    with pytest.raises(InputError, match="2 are open, and no more are kept; close one first"):
        handles.open(STUDY, REPORT, "opened")
    handles.close(names[0])
    assert handles.open(STUDY, REPORT, "opened").id == "s3"  # an id is never given twice
    with pytest.raises(InputError, match="scene: 's1' is not open"):
        handles.get("s1")


def test_equal_scenes_do_not_differ():
    assert difference(STUDY, STUDY).empty


def test_a_difference_says_everything():
    first, second, third, *_ = STUDY.ids
    after = STUDY.move(first, by=(0.3, 0.4), turn=30).resize(second, height=STUDY.object(second).size[2] + 0.1)
    after = after.rename(third, "renamed").relate(first, "near", second, max=2.0)
    found = difference(STUDY, after)
    assert found.added == ["renamed"] and found.removed == [third] and not found.room
    moved = next(each for each in found.moved if each.id == first)
    assert (moved.distance, moved.rise, moved.turn) == (0.5, 0.0, 30.0)
    assert [each.id for each in found.resized] == [second]
    assert any(line.startswith(f"{first} near {second}") for line in found.related)
    assert difference(after, STUDY).unrelated == found.related
    assert difference(STUDY, after.rename("renamed", third)).changed == []


def test_equal_relations_are_counted():
    twice = STUDY.model_copy(update={"relations": (*STUDY.relations, STUDY.relations[0])})
    assert len(difference(STUDY, twice).related) == 1
    assert difference(twice, STUDY) == Difference(unrelated=difference(STUDY, twice).related)
