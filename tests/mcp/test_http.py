"""Who may talk to the HTTP server: clients of this computer, by its own names."""

from __future__ import annotations

import http.client
import json
import socket
from urllib.parse import urlsplit

import pytest

from sceneweaver.mcp import serve
from sceneweaver.scene import InputError
from tests.mcp.driving import LONG, children, http_server, in_good_order, wait_for

HOST = "127.0.0.1"
HELLO = {
    "jsonrpc": "2.0",
    "id": 1,
    "method": "initialize",
    "params": {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}},
}


@pytest.fixture(scope="module")
def port(tmp_path_factory):
    with http_server(tmp_path_factory.mktemp("http")) as (address, _):
        yield urlsplit(address).port


def status(port: int, headers: dict[str, str], body: bytes | None = None) -> int:
    connection = http.client.HTTPConnection(HOST, port, timeout=20)
    base = {"Content-Type": "application/json", "Accept": "application/json, text/event-stream"}
    data = json.dumps(HELLO).encode() if body is None else body
    connection.request("POST", "/mcp", data, {**base, **headers})
    code = connection.getresponse().status
    connection.close()
    return code


def test_its_own_names_are_answered(port):
    assert status(port, {}) == 200
    assert status(port, {"Host": f"localhost:{port}", "Origin": f"http://localhost:{port}"}) == 200


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "evil.example"},
        {"Host": "evil.example:{port}"},
        {"Host": "127.0.0.1.evil.example:{port}"},
        {"Host": "127.0.0.1:1"},
        {"Host": ""},
        {"Origin": "http://evil.example"},
        {"Origin": "http://localhost:1"},
        {"Origin": "https://127.0.0.1:{port}"},
        {"Origin": "null"},
    ],
    ids=str,
)
def test_other_hosts_and_origins_are_refused(port, headers):
    assert status(port, {key: value.format(port=port) for key, value in headers.items()}) in (400, 403, 421)


def test_a_body_that_is_too_large_or_no_json_is_refused(port):
    assert status(port, {}, b" " * (5 * 2**20)) == 413
    assert status(port, {}, b"{") == 400
    assert status(port, {"Content-Type": "text/plain"}) in (400, 415)


def test_only_the_loopback_listens(port):
    own = socket.gethostbyname(socket.gethostname())
    if own.startswith("127."):
        pytest.skip("this computer has no other address")
    with pytest.raises(OSError), socket.create_connection((own, port), timeout=2):
        pass


def test_a_port_that_is_taken_is_refused(tmp_path, port):
    with pytest.raises(InputError, match=f"--port: {port} is not free"):
        serve(tmp_path, transport="http", port=port, device="cpu")


@pytest.mark.slow
def test_a_client_that_is_cut_off_takes_its_work_along(tmp_path):
    """An older client, whose protocol has no other sign of it than the closed connection."""
    with http_server(tmp_path) as (address, process):
        place = (HOST, urlsplit(address).port)
        headers = {"Content-Type": "application/json", "Accept": "application/json, text/event-stream"}
        connection = http.client.HTTPConnection(*place, timeout=60)
        connection.request("POST", "/mcp", json.dumps(HELLO), headers)
        answer = connection.getresponse()
        headers["Mcp-Session-Id"] = answer.getheader("mcp-session-id")
        answer.read()
        meta = {"_meta": {"progressToken": 1}}
        call = {"name": "design", "arguments": {"folder": "big", **LONG}, **meta}
        connection.request(
            "POST", "/mcp", json.dumps({"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": call}), headers
        )
        answer = connection.getresponse()
        while b"the request is read" not in answer.readline():
            pass
        assert len(children(process.pid)) == 1
        answer.close()
        connection.close()
        wait_for(lambda: not children(process.pid) and in_good_order(tmp_path))
        assert (tmp_path / "big/scene.json").exists()
