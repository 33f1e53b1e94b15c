"""Questions and answers as files, and runs that are answered from them."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from pydantic_ai.messages import ModelResponse, ToolCallPart
from pydantic_ai.models.function import FunctionModel

from sceneweaver.llm import (
    BudgetSpent,
    Limits,
    ModelClient,
    ModelFailed,
    Picture,
    Prices,
    ReplayError,
    Reply,
    open_client,
)
from sceneweaver.llm.records import Recorder
from sceneweaver.scene import InputError

ROOM = "a room with a bed"


class Plan(Reply):
    """What to do."""

    steps: int


def says(*replies):
    left = list(replies)
    return FunctionModel(
        lambda messages, info: ModelResponse(parts=[ToolCallPart("answer", left.pop(0) if len(left) > 1 else left[0])])
    )


def client(folder, *replies, **options):
    recorder = Recorder(folder, {"title": "openai:small", "pictures": True, **options.pop("facts", {})})
    return ModelClient(says(*replies), recorder=recorder, **options)


def ask(client, text=ROOM, check=None, purpose="plan", **options):
    return client.ask(purpose, Plan, "Plan.", [text, Picture(b"\x89PNG1", "from above")], check=check, **options)


def positive(plan):
    if plan.steps < 1:
        raise InputError("steps: has to be one or more")
    return plan.model_copy(update={"steps": plan.steps + 100})


def record(folder, name):
    return json.loads((folder / name).read_text())


def test_record(tmp_path):
    ask(client(tmp_path / "llm", {"steps": 0}, {"steps": 2}), check=positive)
    found = record(tmp_path / "llm", "0001-plan.json")
    assert found["schema"] == "sceneweaver.llm_record/1"
    assert (found["instructions"], found["content"][0]) == ("Plan.", {"text": ROOM})
    assert (tmp_path / "llm" / "pictures" / found["content"][1]["picture"]).read_bytes() == b"\x89PNG1"
    assert found["attempts"][0]["reply"] == [{"tool": "answer", "arguments": {"steps": 0}}]
    assert found["attempts"][1]["told"] == "steps: has to be one or more"
    assert (found["answer"], found["failure"]) == ({"steps": 2}, {})
    assert found["usage"]["calls"] == 2
    schema = record(tmp_path / "llm" / "kinds", f"{found['kind']}.json")
    assert schema["properties"]["steps"]["type"] == "integer"
    assert record(tmp_path / "llm", "usage.json")["usage"]["by_purpose"]["plan"]["calls"] == 2


def test_pictures_are_stored_once(tmp_path):
    asked = client(tmp_path / "llm", {"steps": 2})
    ask(asked), ask(asked)
    assert len(list((tmp_path / "llm" / "pictures").iterdir())) == 1


def test_replay(tmp_path):
    first = client(tmp_path / "llm", {"steps": 0}, {"steps": 2}, {"steps": 3}, {"steps": 0})
    told = [ask(first, check=positive), ask(first, check=positive)]
    with pytest.raises(ModelFailed) as failed:
        ask(first, check=positive)
    again = open_client(replay=tmp_path, records=tmp_path / "again")
    assert [ask(again, check=positive), ask(again, check=positive)] == told
    with pytest.raises(ModelFailed) as failed_again:
        ask(again, check=positive)
    assert str(failed_again.value) == str(failed.value)
    assert again.usage.to_dict() == first.usage.to_dict()
    assert (again.name, again.pictures) == ("openai:small", True)
    for name in ("0001-plan.json", "0002-plan.json", "0003-plan.json"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "llm" / name).read_bytes()


def test_replay_has_the_pictures_that_were_shown(tmp_path):
    first = client(tmp_path / "llm", {"steps": 2}, {"steps": 3})
    assert first.shown("plan") is None
    first.ask("plan", Plan, "Plan.", [ROOM, Picture(b"\x89PNG1", "a"), Picture(b"\x89PNG2", "b")])
    first.ask("plan", Plan, "Plan.", [ROOM])
    again = open_client(replay=tmp_path)
    pictures = again.shown("plan")
    assert pictures == (Picture(b"\x89PNG1", "a"), Picture(b"\x89PNG2", "b")) and again.shown("judge") == ()
    assert again.ask("plan", Plan, "Plan.", [ROOM, *pictures]).steps == 2
    assert again.shown("plan") == ()
    for file in (tmp_path / "llm" / "pictures").iterdir():
        file.unlink()
    assert open_client(replay=tmp_path).shown("plan") == (Picture(b"", "a"), Picture(b"", "b"))


def test_replay_needs_no_library(tmp_path):
    ask(client(tmp_path / "llm", {"steps": 2}))
    code = f"""
import sys
from sceneweaver.llm import Picture, Reply, open_client
class Plan(Reply):
    steps: int
print(open_client(replay={str(tmp_path)!r}).ask("plan", Plan, "Plan.", [{ROOM!r}, Picture(b"other", "from above")]))
assert not {{"pydantic_ai", "httpx2", "openai", "asyncio.events"}} & set(sys.modules) - {{"asyncio.events"}}
"""
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert ran.stdout.strip() == "steps=2", ran.stderr


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda c: ask(c, "a room with a bad"), "0001-plan.json is of another request: part 1 of its text differs"),
        (lambda c: ask(c, purpose="judge"), "no record of request 1 for 'judge'"),
        (lambda c: c.ask("plan", Plan, "Plan!", [ROOM]), "its instructions differ from character 5 on: '.', now '!'"),
        (lambda c: c.ask("plan", Plan, "Plan.", [ROOM]), "it has 2 parts, not 1"),
    ],
)
def test_replay_of_another_request(tmp_path, change, says):
    ask(client(tmp_path / "llm", {"steps": 2}))
    with pytest.raises(ReplayError, match=says):
        change(open_client(replay=tmp_path))


def test_replay_of_too_many_requests(tmp_path):
    ask(client(tmp_path / "llm", {"steps": 2}))
    again = open_client(replay=tmp_path)
    ask(again)
    with pytest.raises(ReplayError, match="no record of request 2 for 'plan'"):
        ask(again)


def test_replay_with_another_check(tmp_path):
    ask(client(tmp_path / "llm", {"steps": 0}))
    with pytest.raises(ReplayError, match="an answer of record 0001-plan.json no longer passes: steps"):
        ask(open_client(replay=tmp_path), check=positive)


def test_replay_hands_refused_answers_to_the_check(tmp_path):
    def keeping(seen):
        def check(plan):
            seen.append(plan.steps)
            return positive(plan)

        return check

    seen, again = [], []
    with pytest.raises(ModelFailed):
        ask(client(tmp_path / "llm", {"steps": 0}, {"steps": -1}), check=keeping(seen), retries=2)
    with pytest.raises(ModelFailed):
        ask(open_client(replay=tmp_path), check=keeping(again), retries=2)
    assert again == seen == [0, -1, -1]


def test_replay_of_a_spent_budget(tmp_path):
    first = client(tmp_path / "llm", {"steps": 2}, limits=Limits(calls=1))
    ask(first)
    for _ in range(2):
        with pytest.raises(BudgetSpent):
            ask(first)
    again = open_client(replay=tmp_path)
    ask(again)
    with pytest.raises(BudgetSpent):
        ask(again)
    assert again.lost == first.lost
    with pytest.raises(BudgetSpent, match="not asked"):
        ask(again)


def test_replay_of_samples(tmp_path):
    first = client(tmp_path / "llm", *({"steps": i} for i in range(4)))
    told = first.ask_many("plan", Plan, "Plan.", [ROOM], samples=4)
    assert open_client(replay=tmp_path).ask_many("plan", Plan, "Plan.", [ROOM], samples=4) == told


def test_cost_is_replayed(tmp_path):
    prices = Prices.from_dict({"currency": "EUR", "models": {"function:m": {"input": 1, "output": 2}}})
    recorder = Recorder(tmp_path / "llm", {"title": "m", "priced": True, "currency": "EUR"})
    first = ModelClient(
        FunctionModel(says({"steps": 1}).function, model_name="function:m"), prices=prices, recorder=recorder
    )
    ask(first)
    again = open_client(replay=tmp_path)
    ask(again)
    assert first.usage.total.cost > 0
    assert again.usage.to_dict() == first.usage.to_dict()


def test_next_session_goes_on(tmp_path):
    ask(client(tmp_path / "llm", {"steps": 1}))
    second = client(tmp_path / "llm", {"steps": 2})
    assert second.usage.total.calls == 1
    ask(second)
    assert record(tmp_path / "llm", "0001-plan.json")["answer"] == {"steps": 1}
    assert record(tmp_path / "llm", "0002-plan.json")["answer"] == {"steps": 2}
    again = open_client(replay=tmp_path)
    assert [ask(again).steps, ask(again).steps] == [1, 2]


def test_steps_that_were_not_saved_are_left_out_of_a_replay(tmp_path):
    first = client(tmp_path / "llm", {"steps": 1}, {"steps": 2})
    ask(first)
    first.keep()
    ask(first)  # of a step that was killed
    second = client(tmp_path / "llm", {"steps": 3}, {"steps": 4})
    ask(second), second.keep(), ask(second)
    again = open_client(replay=tmp_path)
    assert [ask(again).steps for _ in range(3)] == [1, 3, 4]


def test_two_runs_in_one_folder(tmp_path):
    first, second = client(tmp_path / "llm", {"steps": 1}), client(tmp_path / "llm", {"steps": 2})
    ask(first)
    with pytest.raises(InputError, match="two runs"):
        ask(second)


@pytest.mark.parametrize("text", ["", "[]", '{"schema": "other"}', "{"])
def test_folder_without_records(tmp_path, text):
    (tmp_path / "endpoint.json").write_text(text)
    with pytest.raises(InputError, match="endpoint.json"):
        open_client(replay=tmp_path)


def test_no_folder(tmp_path):
    with pytest.raises(InputError, match="holds no records"):
        open_client(replay=tmp_path / "none")


@pytest.mark.parametrize("text", ["{}", "[1]", "null", '{"schema": "sceneweaver.llm_record/1"}'])
def test_broken_record(tmp_path, text):
    ask(client(tmp_path / "llm", {"steps": 1}))
    (tmp_path / "llm" / "0001-plan.json").write_text(text)
    with pytest.raises(InputError, match="0001-plan.json"):
        open_client(replay=tmp_path)


@pytest.mark.parametrize("name", ["llm", "llm/pictures", "llm/kinds", "llm/endpoint.json", "llm/usage.json"])
def test_records_do_not_follow_links(tmp_path, name):
    away = tmp_path / "away"
    away.mkdir()
    link = tmp_path / name
    link.parent.mkdir(exist_ok=True)
    link.symlink_to(away if not link.suffix else away / "keep.json")
    with pytest.raises(InputError, match=f"{link.name}: this is a link to another place"):
        Recorder(tmp_path / "llm", {"title": "m", "pictures": True})
    assert not list(away.iterdir())


def _pipe(file: Path) -> None:
    file.unlink()
    os.mkfifo(file)


def _device(file: Path) -> None:
    file.unlink()
    file.symlink_to("/dev/zero")


TAMPERED: dict[str, Callable[[Path], object]] = {
    "truncated": lambda file: file.write_bytes(file.read_bytes()[:-40]),
    "huge": lambda file: os.truncate(file, 2 << 30),
    "pipe": _pipe,
    "device": _device,
    "deep": lambda file: file.write_text("[" * 100_000),
    "digits": lambda file: file.write_text('{"number": ' + "9" * 200_000 + "}"),
    "no text": lambda file: file.write_bytes(b"\xff\xfe\0"),
}


@pytest.mark.parametrize("tamper", TAMPERED.values(), ids=TAMPERED)
@pytest.mark.parametrize("name", ["endpoint.json", "0001-plan.json"])
def test_tampered_records_are_one_line(tmp_path, tamper, name):
    ask(client(tmp_path / "llm", {"steps": 1}))
    tamper(tmp_path / "llm" / name)
    with pytest.raises(InputError) as caught:
        open_client(replay=tmp_path)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 400
