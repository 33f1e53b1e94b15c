"""What ends early ends in good order: cancelled calls, clients that leave, signals."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from tests.mcp.driving import (
    ARGUMENTS,
    LONG,
    ROOT,
    children,
    command,
    connected,
    http_server,
    in_good_order,
    over_stdio,
    wait_for,
)


def test_a_client_that_closes_stdin_leaves_nothing_behind(tmp_path):
    begun = threading.Event()
    with over_stdio(tmp_path) as driver:
        (server,) = [pid for pid in children(os.getpid()) if str(tmp_path).encode() in command(pid)]
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
            driver.call("list_furniture", words="desk")
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
