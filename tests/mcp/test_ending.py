"""What ends early ends in good order: cancelled calls, clients that leave, signals."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.mcp.driving import (
    ARGUMENTS,
    LONG,
    ROOT,
    children,
    connected,
    http_server,
    in_good_order,
    wait_for,
)


@pytest.mark.slow  # the server of test_transports.py ends so as well
def test_sigterm_ends_a_server_of_http(tmp_path):
    with http_server(tmp_path) as (_, process):
        process.send_signal(signal.SIGTERM)
        assert process.wait(30) == 0


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
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


@pytest.mark.parametrize("how", ["stdin closes", pytest.param("SIGTERM", marks=pytest.mark.slow)])
def test_stdio_carries_the_protocol_alone_and_ends_in_the_middle_of_a_design(tmp_path, how):
    arguments, pipe = [sys.executable, *ARGUMENTS, "--folder", str(tmp_path)], subprocess.PIPE
    process = subprocess.Popen(arguments, cwd=ROOT, stdin=pipe, stdout=pipe, stderr=pipe)
    assert process.stdin and process.stdout and process.stderr
    hello = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}
    opened = {"name": "open", "arguments": {"name": "study"}}
    design = {"name": "design", "arguments": {"folder": "big", **LONG}, "_meta": {"progressToken": 1}}
    for message in (
        {"id": 1, "method": "initialize", "params": hello},
        {"method": "notifications/initialized"},
        {"id": 2, "method": "tools/call", "params": opened},
        {"id": 3, "method": "tools/call", "params": design},
    ):
        process.stdin.write(json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n")
        process.stdin.flush()
        if "id" in message:
            heard = json.loads(process.stdout.readline())
            assert heard.get("id") == message["id"] or heard["method"] == "notifications/progress"
    wait_for(lambda: (tmp_path / "big/steps").exists())
    workers = children(process.pid)
    assert workers
    process.stdin.close() if how == "stdin closes" else process.send_signal(signal.SIGTERM)
    assert process.wait(60) == 0
    wait_for(lambda: not any(Path(f"/proc/{pid}").exists() for pid in workers))
    assert in_good_order(tmp_path)
    for line in process.stdout.read().splitlines():
        assert json.loads(line)["jsonrpc"] == "2.0"
    assert b"Traceback" not in process.stderr.read()
    for stream in (process.stdin, process.stdout, process.stderr):
        stream.close()


def test_without_the_sdk_one_line_says_what_to_install(tmp_path):
    code = "import sys; sys.modules['mcp'] = None; from sceneweaver.cli import main; sys.exit(main(['mcp']))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 4 and "pip install 'mcp<3,>=2.3'" in done.stderr and done.stdout == ""
    assert len(done.stderr.splitlines()) == 1
