"""The official client, driven from tests that are not asynchronous."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from anyio.from_thread import BlockingPortal, start_blocking_portal
from mcp import Client, StdioServerParameters

from sceneweaver.scene import Scene

ROOT = Path(__file__).parents[2]
ARGUMENTS = ["-m", "sceneweaver", "mcp", "--device", "cpu"]

LONG: dict[str, Any] = {
    "prompt": "a large restaurant for forty guests",
    "steps": 50,
    "candidates": 4096,
    "time_limit": 200,
}
"""A design that takes long."""

Progress = list[tuple[float, float | None, str | None]]


class Driver:
    """A client that is connected to a server."""

    def __init__(self, portal: BlockingPortal, client: Client) -> None:
        self.portal, self.client = portal, client

    def tell(self, tool: str, **arguments: Any) -> Any:
        """The answer to a call, as it came."""
        return self.portal.call(self.client.call_tool, tool, arguments)

    def call(self, tool: str, **arguments: Any) -> dict[str, Any]:
        """The data of an answer, which must be no error."""
        answer = self.tell(tool, **arguments)
        assert not answer.is_error, answer.content[0].text
        assert answer.content[0].text.strip()
        return answer.structured_content

    def refused(self, tool: str, **arguments: Any) -> str:
        """What an error says, which must be one line."""
        answer = self.tell(tool, **arguments)
        assert answer.is_error, answer.content[0].text
        text = answer.content[0].text
        assert "\n" not in text and "Traceback" not in text and len(text) < 500, text
        return text

    def begin(self, tool: str, heard: Callable[..., Any] | None = None, **arguments: Any) -> Future[Any]:
        """A call that goes on while the test does; to cancel the future is to cancel the call."""

        async def call() -> Any:
            async def progress(done: float, total: float | None, message: str | None) -> None:
                if heard is not None:
                    heard(done, total, message)

            return await self.client.call_tool(tool, arguments, progress_callback=progress)

        return self.portal.start_task_soon(call)

    def read(self, uri: str) -> str:
        """The text of a resource."""
        return self.portal.call(self.client.read_resource, uri).contents[0].text


@contextmanager
def connected(server: Any, **options: Any) -> Iterator[Driver]:
    """A client of a server: its address, or how to start it."""
    with start_blocking_portal() as portal:
        client = Client(server, **options)
        with portal.wrap_async_context_manager(client):
            yield Driver(portal, client)


@contextmanager
def over_stdio(folder: Path, *more: str) -> Iterator[Driver]:
    """A client of a server that it starts itself."""
    arguments = [*ARGUMENTS, "--folder", str(folder), *more]
    with connected(StdioServerParameters(command=sys.executable, args=arguments, cwd=ROOT)) as driver:
        yield driver


@contextmanager
def http_server(folder: Path, *more: str) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A server on a free port, its address and its process."""
    arguments = [*ARGUMENTS, "--folder", str(folder), "--transport", "http", "--port", "0", *more]
    process = subprocess.Popen([sys.executable, *arguments], cwd=ROOT, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    try:
        line = process.stderr.readline()
        found = re.search(r"http://127\.0\.0\.1:\d+/mcp", line)
        assert found, line + process.stderr.read()
        yield found[0], process
    finally:
        process.terminate()
        process.wait(20)
        process.stderr.close()


def children(pid: int) -> list[int]:
    """The processes that a process has started."""
    found = []
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                fields = Path("/proc", entry, "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            found += [int(entry)] if int(fields[1]) == pid and fields[0] != "Z" else []
    return found


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
