"""The folder of a run: damaged states are one line each, and one process writes at a time."""

from __future__ import annotations

import json
import os

import pytest

from sceneweaver.agent import Settings
from sceneweaver.agent.folder import RunFolder
from sceneweaver.agent.memory import Memory, Step
from sceneweaver.agent.roles import Roles
from sceneweaver.cli import main
from sceneweaver.critic import CRITERIA, Review
from sceneweaver.language import SceneGraph
from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import check

BRIEF = SceneGraph(text="a room")


@pytest.fixture
def kept(tmp_path):
    """A folder with the state of a run of one step, as a dictionary that can be spoilt, and what writes it back."""
    folder = RunFolder(tmp_path)
    scene = Scene.example("bedroom")
    (tmp_path / "steps" / "01").mkdir(parents=True)
    scene.save(tmp_path / "steps" / "01" / "scene.json")
    memory = Memory(steps=(Step(number=1, call=None, accepted=True),))
    folder.state("steps/01/scene.json", memory, BRIEF, Settings())
    data = json.loads((tmp_path / "state.json").read_text())
    return folder, data, lambda value: (tmp_path / "state.json").write_text(json.dumps(value))


def test_a_sound_state_is_taken_up_again(kept):
    folder, *_ = kept
    memory, scene = folder.resume(BRIEF, Settings())
    assert len(memory.steps) == 1 and scene == Scene.example("bedroom")


def test_a_run_goes_on_with_those_who_began_it(kept):
    folder, *_ = kept
    folder.check_roles(Roles())
    with pytest.raises(InputError, match="holds a run with planner rules, not llm; choose another place"):
        folder.check_roles(Roles.of("llm"))
    with pytest.raises(InputError, match="holds a run with reader rules, not llm"):
        folder.check_roles(Roles.of("rules", "llm"))
    RunFolder(folder.path / "other").check_roles(Roles.of("llm"))


WRONG = {"missing": None, "number": 3, "text": "x", "list": [], "null": None, "inner": {"seed": [], "steps": {}}}


@pytest.mark.parametrize("field", ["schema", "prompt", "settings", "scene", "memory"])
@pytest.mark.parametrize("how", WRONG)
def test_a_field_that_is_missing_or_of_another_type(kept, field, how):
    folder, data, write = kept
    if how == "missing":
        del data[field]
    elif field == "prompt" and how == "text":
        data["brief"] = 3
        field = "brief"
    else:
        data[field] = WRONG[how]
    write(data)
    with pytest.raises(
        InputError, match=rf"state.json: this is no state of a run \(.*{field}.*\); remove it or choose"
    ) as found:
        folder.resume(BRIEF, Settings())
    assert "\n" not in str(found.value)


@pytest.mark.parametrize("scene", ["../../etc/scene.json", "/etc/passwd", "", "steps/01/../../x/scene.json"])
def test_the_scene_of_a_state_lies_in_its_folder(kept, scene):
    folder, data, write = kept
    write({**data, "scene": scene})
    with pytest.raises(InputError, match="this is no state of a run .*scene"):
        folder.resume(BRIEF, Settings())


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "3", "null", '{"schema": ' * 100_000, '{"a": ' * 500 + "1" + "}" * 500]
)
def test_what_is_no_state_at_all(kept, text):
    folder, *_ = kept
    (folder.path / "state.json").write_text(text)
    with pytest.raises(
        InputError, match=r"state.json: this is no state of a run \(.*\); remove it or choose another folder"
    ):
        folder.resume(BRIEF, Settings())


def test_what_is_nested_too_deep(kept):
    folder, data, write = kept
    deep: dict = {}
    for _ in range(300):
        deep = {"a": deep}
    data["memory"]["steps"][0]["tried"] = [deep]
    write(data)
    with pytest.raises(InputError, match="nested deeper than 32 levels"):
        folder.resume(BRIEF, Settings())


def test_a_state_that_is_a_pipe(kept):
    folder, *_ = kept
    os.unlink(folder.path / "state.json")
    os.mkfifo(folder.path / "state.json")
    with pytest.raises(InputError, match="this is a pipe or a device"):
        folder.resume(BRIEF, Settings())


def test_the_command_says_it_in_one_line_with_code_2(kept, capfd):
    folder, data, write = kept
    write({**data, "memory": {"steps": 3}})
    assert main(["design", "a room", "--out", str(folder.path)]) == 2
    said = capfd.readouterr().err
    assert said.count("\n") == 1 and "memory.steps" in said


def test_two_runs_do_not_share_a_folder_and_leftovers_go(kept):
    folder, *_ = kept
    (folder.path / "views").mkdir()
    for place in (folder.path, folder.path / "views", folder.path / "steps" / "01"):
        (place / ".sceneweaver-0123456789abcdef.tmp").mkdir()
        (place / ".sceneweaver-0123456789abcdef.tmp" / "corner.png").write_bytes(b"half")
    with folder.held():
        assert not list(folder.path.rglob("*.tmp"))
        with pytest.raises(InputError, match=f"--out: .* is being written by process {os.getpid()}; wait for it"):
            RunFolder(folder.path).held().__enter__()
    with folder.held():
        pass


def test_a_run_does_not_go_on_from_links_to_elsewhere(kept):
    folder, data, write = kept
    for name in ("state.json", "steps/01/scene.json"):
        place, away = folder.path / name, folder.path / "away"
        place.rename(away)
        place.symlink_to(away)
        with pytest.raises(InputError, match="this is .*a link to another place"):
            folder.resume(BRIEF, Settings())
        place.unlink()
        away.rename(place)
    (folder.path / "steps" / "01").rename(folder.path / "away")
    (folder.path / "steps" / "01").symlink_to(folder.path / "away")
    with pytest.raises(InputError, match="01: this is a link to another place"):
        folder.resume(BRIEF, Settings())


@pytest.mark.parametrize("name", ["views", "steps", "steps/01"])
def test_a_folder_with_links_for_folders_is_not_written(tmp_path, name):
    own, away = tmp_path / "own", tmp_path / "away"
    away.mkdir()
    (own / name).parent.mkdir(parents=True)
    (own / name).symlink_to(away)
    with pytest.raises(InputError, match="this is a link to another place"), RunFolder(own).held():
        pass
    assert not os.listdir(away)


@pytest.mark.parametrize("there", [True, False])
def test_links_for_files_of_a_run_are_replaced(tmp_path, there):
    own, away = tmp_path / "own", tmp_path / "away"
    for folder in (own, own / "steps", own / "steps" / "01", away):
        folder.mkdir()
    names = ["scene.json", "metrics.json", "steps/01/scene.json", "steps/01/step.json"]
    for k, name in enumerate(names):
        if there:
            (away / f"{k}").write_text("keep")
        (own / name).symlink_to(away / f"{k}")
    folder, scene = RunFolder(own), Scene.example("bedroom")
    report = check(scene)
    folder.keep(scene, report)
    folder.step(1, scene, report, Review(grades=dict.fromkeys(CRITERIA, 7.0)), Memory(), BRIEF, Settings())
    assert all((own / name).is_file() and not (own / name).is_symlink() for name in names)
    assert {path.read_text() for path in away.iterdir()} == ({"keep"} if there else set())
