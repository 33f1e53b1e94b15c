"""What ends early ends in good order: cancelled calls, clients that leave, signals."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from sceneweaver.scene import Scene
from tests.mcp.driving import ARGUMENTS, ROOT, children, connected, http_server, over_stdio

LONG = {"prompt": "a large restaurant for forty guests", "steps": 50, "candidates": 4096, "time_limit": 200}


def wait_for(what: Callable[[], object], seconds: float = 60.0) -> None:
    until = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < until, "waited in vain"
        time.sleep(0.05)


def command(pid: int) -> bytes:
    return Path(f"/proc/{pid}/cmdline").read_bytes()


def in_good_order(folder: Path) -> bool:
    """Whether nothing is left half written: no temporary files, and every scene loads."""
    if any(folder.rglob(".sceneweaver-*.tmp")) or any(folder.rglob("*.lock")):
        return False
    for path in folder.rglob("scene.json"):
        Scene.load(path)
    return True


@pytest.mark.parametrize("transport", ["stdio", "http"])
def test_a_cancelled_design_ends_and_the_server_goes_on(tmp_path, transport):
    begun = threading.Event()

    def conversation(driver) -> None:
        call = driver.begin("design", lambda *_: begun.set(), folder="big", **LONG)
        assert begun.wait(60)
        assert driver.call("list_scenes")["open"] == []  # it answers meanwhile
        call.cancel()
        wait_for(lambda: in_good_order(tmp_path))
        assert driver.call("list_scenes")["open"] == []
        assert driver.call("open", name="study")["scene"] == "s1"

    if transport == "stdio":
        with over_stdio(tmp_path) as driver:
            conversation(driver)
    else:
        with http_server(tmp_path) as (address, _), connected(address) as driver:
            conversation(driver)


def test_two_clients_share_the_scenes_and_one_that_leaves_takes_its_work_along(tmp_path):
    begun = threading.Event()
    with http_server(tmp_path) as (address, process), connected(address) as stays:
        with connected(address) as leaves:
            assert leaves.call("open", name="study")["scene"] == "s1"
            assert stays.call("open", name="bedroom")["scene"] == "s2"
            moves = [
                driver.begin("turn", scene="s1", object=Scene.example("study").ids[0], degrees=5, exact=True)
                for driver in (leaves, stays)
            ]
            numbers = sorted(move.result(60).structured_content["version"] for move in moves)
            assert numbers == [2, 3]
            leaves.begin("design", lambda *_: begun.set(), folder="big", **LONG)
            assert begun.wait(60)
        wait_for(lambda: in_good_order(tmp_path) and len(children(process.pid)) == 1)  # the quick one
        assert stays.call("check", scene="s1")["version"] == 3


def test_a_client_that_closes_stdin_leaves_nothing_behind(tmp_path):
    begun = threading.Event()
    with over_stdio(tmp_path) as driver:
        (server,) = [
            pid for pid in children(os.getpid()) if b"sceneweaver" in Path(f"/proc/{pid}/cmdline").read_bytes()
        ]
        driver.begin("design", lambda *_: begun.set(), folder="big", **LONG)
        assert begun.wait(60)
        workers = children(server)
        assert workers
    wait_for(lambda: not any(Path(f"/proc/{pid}").exists() for pid in (server, *workers)))
    assert in_good_order(tmp_path)


@pytest.mark.parametrize(
    "number",
    [
        signal.SIGTERM,
        pytest.param(signal.SIGINT, marks=pytest.mark.slow),
        pytest.param(signal.SIGKILL, marks=pytest.mark.slow),
    ],
)
def test_a_signal_ends_the_server_and_its_processes(tmp_path, number):
    with http_server(tmp_path) as (address, process):
        with connected(address) as driver:
            driver.call("open", name="study")
            workers = children(process.pid)
            assert workers
        process.send_signal(number)
        code = process.wait(30)
        assert code == (-9 if number == signal.SIGKILL else 0)
        wait_for(lambda: not any(Path(f"/proc/{pid}").exists() for pid in workers))
        assert "Traceback" not in process.stderr.read()


def test_stdout_is_the_protocol_alone_and_sigterm_ends_it(tmp_path):
    arguments = [sys.executable, *ARGUMENTS, "--folder", str(tmp_path)]
    process = subprocess.Popen(
        arguments, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdin and process.stdout and process.stderr
    hello = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}
    for message in (
        {"id": 1, "method": "initialize", "params": hello},
        {"method": "notifications/initialized"},
        {"id": 2, "method": "tools/call", "params": {"name": "open", "arguments": {"name": "study"}}},
        {"id": 3, "method": "tools/call", "params": {"name": "check", "arguments": {"scene": "s1"}}},
    ):
        process.stdin.write(json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n")
        process.stdin.flush()
        if "id" in message:
            answer = json.loads(process.stdout.readline())
            assert answer["id"] == message["id"] and "result" in answer
    process.send_signal(signal.SIGTERM)
    assert process.wait(30) == 0
    assert process.stdout.read() == b""
    assert b"Traceback" not in process.stderr.read()
    for stream in (process.stdin, process.stdout, process.stderr):
        stream.close()


def test_without_the_sdk_one_line_says_what_to_install(tmp_path):
    code = "import sys; sys.modules['mcp'] = None; from sceneweaver.cli import main; sys.exit(main(['mcp']))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 4 and "sceneweaver[mcp]" in done.stderr and done.stdout == ""
    assert len(done.stderr.splitlines()) == 1
