"""A client of a misbehaving server, and what has to hold however it misbehaves."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sceneweaver.llm import Endpoint, Limits, ModelClient, ModelError, Picture, Reply, open_client
from tests.llm.model_server import MODEL, ModelServer

PNG = b"\x89PNG\r\n\x1a\n not much of a picture"
TRIES = 2
RETRIES = 2
PATIENCE = 300.0
"""Seconds after which an ask that did not end counts as one that hangs."""


class Plan(Reply):
    """What to do next."""

    tool: str
    objects: list[str]
    worth: float
    inputs: dict[str, Any] = {}


PLAN = {"tool": "add_objects", "objects": ["chair_1", "table_2"], "worth": 0.5, "inputs": {"count": 2, "of": ["chair"]}}


def client_of(server: ModelServer, api: str, streamed: bool, timeout: float = 60.0, **options: Any) -> ModelClient:
    """A client of a server."""
    endpoint = Endpoint(
        f"{'openai' if api == 'chat' else 'anthropic'}:{MODEL}",
        server.url if api == "chat" else server.root,
        timeout=timeout,
        stream=streamed,
        tries=TRIES,
    )
    options.setdefault("limits", Limits(seconds=250.0))
    return open_client(endpoint, **options)


def asked(client: ModelClient, **options: Any) -> Plan | ModelError:
    """One question: an answer or the error, any other error raised."""
    try:
        return client.ask(
            "plan", Plan, "You plan rooms.", ["A room.", Picture(PNG, "from above")], retries=RETRIES, **options
        )
    except ModelError as error:
        return error


def in_time(work: Callable[[], Any]) -> Any:
    """What the work gives back or raises; fails where it hangs."""
    found: list[Any] = []

    def run() -> None:
        try:
            found.append((True, work()))
        except BaseException as error:
            found.append((False, error))

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(PATIENCE)
    assert found, "it hangs"
    good, result = found[0]
    if not good:
        raise result
    return result


def assert_one_clear_line(error: ModelError) -> None:
    words = str(error)
    assert words.startswith("plan: ") and len(words) > 15 and len(words) < 500, words
    assert words.isprintable(), words


def strict_json(text: str) -> Any:
    """JSON without NaN and Infinity, in UTF-8."""

    def refused(name: str) -> None:
        raise AssertionError(f"{name} is no JSON")

    text.encode()
    return json.loads(text, parse_constant=refused)


def assert_readable(folder: Path) -> None:
    """Every file of the records is whole, and JSON where it says so."""
    for path in folder.rglob("*"):
        if path.suffix == ".json":
            strict_json(path.read_text())
        elif path.suffix == ".jsonl":
            for row in path.read_text().splitlines():
                strict_json(row)
        assert not path.name.endswith((".tmp", ".part")), path


def peak_memory(anew: bool = False) -> int:
    """Most bytes that this process had in memory, since the last call with `anew`."""
    if anew:
        Path("/proc/self/clear_refs").write_text("5")
    row = next(row for row in Path("/proc/self/status").read_text().splitlines() if row.startswith("VmHWM"))
    return int(row.split()[1]) << 10
