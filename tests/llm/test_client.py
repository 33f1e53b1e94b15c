"""Questions and answers: typed, checked, mended, told what is wrong, side by side; and what ends them."""

import asyncio
import threading
import time

import pytest
from pydantic_ai.messages import ModelResponse, TextPart, ToolCallPart
from pydantic_ai.models.function import DeltaToolCall, FunctionModel
from pydantic_ai.models.test import TestModel

from sceneweaver.llm import BudgetSpent, Limits, ModelClient, ModelFailed, Picture, Reply
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import InputError


class Plan(Reply):
    """What to do."""

    steps: int
    names: tuple[str, ...] = ()


def says(*replies, seen=None):
    """A model that says these in turn, the last for ever: arguments of an answer, text, or a function."""
    left = list(replies)

    def said(messages, info):
        if seen is not None:
            seen.append(messages)
        reply = left.pop(0) if len(left) > 1 else left[0]
        reply = reply() if callable(reply) else reply
        if isinstance(reply, ModelResponse):
            return reply
        part = TextPart(reply) if isinstance(reply, str) else ToolCallPart("answer", reply)
        return ModelResponse(parts=[part])

    return FunctionModel(said)


def positive(plan):
    if plan.steps < 1:
        raise InputError("steps: has to be one or more")


def ask(model, check=None, **options):
    return (model if isinstance(model, ModelClient) else ModelClient(model)).ask(
        "plan", Plan, "Plan.", ["a room"], check=check, **options
    )


def test_answer():
    assert ask(says({"steps": 2, "names": ["a"]})) == Plan(steps=2, names=("a",))


def test_test_model():
    assert isinstance(ask(TestModel()), Plan)


def test_streamed():
    async def pieces(messages, info):
        yield {0: DeltaToolCall("answer", '{"st')}
        yield {0: DeltaToolCall(json_args='eps": 4}')}

    assert ask(FunctionModel(stream_function=pieces)).steps == 4


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ("I will not.", "tool call"),
        ({"steps": "many"}, "valid integer"),
        ({"steps": 1, "pose": [0, 0]}, "Extra inputs"),
        ('{"steps": ', "call"),
        ({"steps": 0}, "steps: has to be one or more"),
    ],
)
def test_told_what_is_wrong(wrong, told):
    seen = []
    assert ask(says(wrong, {"steps": 1}, seen=seen), positive).steps == 1
    assert told in str(seen[-1][-1])


def test_text_that_is_the_answer():
    assert ask(says('```json\n{"steps": 3}\n```')).steps == 3


def test_gives_up():
    with pytest.raises(
        ModelFailed, match="plan: no answer passed in 3 replies; the last: steps: has to be one or more"
    ):
        ask(says({"steps": 0}), positive, retries=2)


def test_mended():
    assert ask(says({"steps": 2}), lambda plan: plan.model_copy(update={"steps": 7})).steps == 7


def test_check_is_called_by_the_caller():
    threads = []
    ask(says({"steps": 2}), lambda plan: threads.append(threading.current_thread()))
    assert threads == [threading.current_thread()]


def test_error_of_a_check_reaches_the_caller():
    def broken(plan):
        raise ZeroDivisionError("a bug")

    with pytest.raises(ZeroDivisionError):
        ask(says({"steps": 2}), broken)


def test_refusal_is_asked_once_more():
    seen = []
    client = ModelClient(says(ModelResponse(parts=[TextPart("No.")], finish_reason="content_filter"), seen=seen))
    with pytest.raises(ModelFailed, match="refuses"):
        ask(client)
    assert len(seen) == 2 and not client.lost


def test_pictures_have_titles():
    seen = []
    ModelClient(says({"steps": 1}, seen=seen)).ask("look", Plan, "Look.", ["This:", Picture(b"\x89PNG", "from above")])
    content = seen[0][0].parts[0].content
    assert content[:2] == ["This:", "Picture: from above"] and content[2].data == b"\x89PNG"


def test_samples_stand_side_by_side():
    together = threading.Barrier(3, timeout=20)

    def said(messages, info):
        together.wait()
        return ModelResponse(parts=[ToolCallPart("answer", {"steps": 1})])

    found = ModelClient(FunctionModel(said)).ask_many("plan", Plan, "Plan.", ["a room"], samples=3)
    assert [plan.steps for plan in found] == [1, 1, 1]


def test_sample_that_fails_has_an_error_in_its_place():
    replies = iter([{"steps": 1}, {"steps": 0}])
    lock = threading.Lock()

    def said(messages, info):
        with lock:
            return ModelResponse(parts=[ToolCallPart("answer", next(replies))])

    client = ModelClient(FunctionModel(said))
    found = client.ask_many("plan", Plan, "Plan.", ["a room"], samples=2, check=positive, retries=0)
    assert sorted(type(answer).__name__ for answer in found) == ["ModelFailed", "Plan"]


def test_asked_within_a_running_loop_and_in_a_thread():
    async def inside():
        return ask(says({"steps": 1}))

    assert asyncio.run(inside()).steps == 1
    found = []
    thread = threading.Thread(target=lambda: found.append(ask(says({"steps": 1})).steps))
    thread.start()
    thread.join(20)
    assert found == [1]


def slow(seconds=20.0):
    async def said(messages, info):
        await asyncio.sleep(seconds)
        return ModelResponse(parts=[ToolCallPart("answer", {"steps": 1})])

    return FunctionModel(said)


def test_stopped():
    stop = threading.Event()
    client = ModelClient(slow(), stopped=stop.is_set)
    threading.Timer(0.2, stop.set).start()
    with pytest.raises(BudgetSpent, match="plan: the run was stopped"):
        ask(client)
    with pytest.raises(BudgetSpent, match="not asked"):
        ask(client)
    assert client.lost


def test_time_of_the_run():
    end = time.monotonic() + 0.3
    client = ModelClient(slow(), left=lambda: end - time.monotonic())
    with pytest.raises(BudgetSpent, match="plan: the time for the model was over before the reply was there"):
        ask(client)
    assert client.lost


def test_time_up_ends_a_wait():
    end = time.monotonic() + 0.3
    with pytest.raises(TimeUp), Deadline(end).enforced():
        ask(slow())


def test_calls_are_limited():
    client = ModelClient(says({"steps": 0}), limits=Limits(calls=2))
    with pytest.raises(BudgetSpent, match="limit of 2 calls"):
        ask(client, positive)
    assert client.usage.total.calls == 2
