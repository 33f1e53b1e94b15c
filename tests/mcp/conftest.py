"""Servers for the tests of a module: each is started once, and one small room is designed on it."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from sceneweaver.mcp import build_server
from tests.mcp.driving import Driver, Progress, connected, http_server, over_stdio

REQUEST = {"prompt": "a store room with only a desk and one shelf", "steps": 1, "candidates": 8, "clutter": 0}


@dataclass
class Site:
    """A connected server, its folder, the room that was designed on it, and the progress of that.

    ``address`` is None over stdio.
    """

    driver: Driver
    folder: Path
    room: dict[str, Any]
    heard: Progress
    address: str | None = None

    @property
    def desk(self) -> str:
        return next(o["id"] for o in self.room["objects"] if o["category"] == "desk")


@pytest.fixture(scope="module")
def stdio_site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """A server over stdio."""
    folder = tmp_path_factory.mktemp("stdio")
    with over_stdio(folder) as driver:
        yield _site(driver, folder)


@pytest.fixture(scope="module")
def http_site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """A server over streamable HTTP."""
    folder = tmp_path_factory.mktemp("http")
    with http_server(folder) as (address, process):
        with connected(address) as driver:
            yield _site(driver, folder, address)
        process.send_signal(signal.SIGTERM)
        assert process.wait(30) == 0


@pytest.fixture(scope="module", params=["stdio", "http"])
def site(request: pytest.FixtureRequest) -> Site:
    """A server reached over one of the transports."""
    return request.getfixturevalue(f"{request.param}_site")


def _site(driver: Driver, folder: Path, address: str | None = None) -> Site:
    heard: Progress = []
    answer = driver.begin("design", lambda *each: heard.append(each), folder="rooms/store", **REQUEST).result(120)
    assert not answer.is_error, answer.content[0].text
    return Site(driver, folder, answer.structured_content, heard, address)


@pytest.fixture(scope="module")
def near(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Driver, Path]]:
    """A server in this process, with the bedroom open as s1."""
    folder = tmp_path_factory.mktemp("near")
    server = build_server(folder, device="cpu")
    with connected(server) as driver:
        driver.call("open", name="bedroom")
        yield driver, folder
    server.service.workers.close()
