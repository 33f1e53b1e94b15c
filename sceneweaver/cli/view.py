"""``sceneweaver view``: shows a run in the browser, from a server that only this computer can reach."""

from __future__ import annotations

import contextlib
import os
import webbrowser
from collections.abc import Callable
from functools import partial
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import typer

from sceneweaver.home import Home
from sceneweaver.io import parse_json, read_bytes
from sceneweaver.scene import InputError, Scene

from .home_views import holds_home, home_page

HOST = "127.0.0.1"
PORTS_TRIED = 50
MAX_BYTES = 2 << 30
"""Largest file [bytes] that is served."""

_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".json": "application/json",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".glb": "model/gltf-binary",
    ".usdc": "application/octet-stream",
    ".usda": "text/plain; charset=utf-8",
    ".xml": "text/plain; charset=utf-8",
    ".txt": "text/plain; charset=utf-8",
    ".md": "text/plain; charset=utf-8",
    ".csv": "text/plain; charset=utf-8",
    ".obj": "text/plain; charset=utf-8",
    ".stl": "application/octet-stream",
}


def run_view(folder: Path, port: int, open_browser: bool) -> int:
    """Serve a run folder, a report.html, a scene.json, a home.json or a scene.glb until Ctrl-C.

    Raises:
        InputError: when there is nothing to show, or no port is free.
    """
    page, root = show(folder)
    server = make_server(page, root, port)
    address = f"http://{HOST}:{server.server_address[1]}/"
    typer.echo(f"Showing {folder} at {address}  (Ctrl-C ends)")
    if open_browser:
        with contextlib.suppress(webbrowser.Error, OSError):
            webbrowser.open(address)
    try:
        server.serve_forever(poll_interval=0.2)
    except KeyboardInterrupt:
        typer.echo("")
    finally:
        server.server_close()
    return 0


def show(path: Path) -> tuple[Callable[[], bytes], Path | None]:
    """What to show of a path: a function that gives the page, and the folder whose files may be asked for as well.

    Raises:
        InputError: when there is nothing to show.
    """
    if path.is_dir():
        if (path / "report.html").is_file():
            return partial(read_bytes, path / "report.html", max_bytes=MAX_BYTES), path
        for name in ("home.json", "scene.json", "scene.glb"):
            if (path / name).is_file():
                return _fixed(_page(path / name)), path
        raise InputError(
            f"{path}: holds no report.html, home.json, scene.json or scene.glb; give a folder that a run wrote"
        )
    if not path.exists():
        raise InputError(f"{path}: does not exist; give a run's folder, a report.html, a scene.json or a scene.glb")
    if path.suffix.lower() in (".html", ".htm"):
        return partial(read_bytes, path, max_bytes=MAX_BYTES), None
    return _fixed(_page(path)), None


def make_server(page: Callable[[], bytes], root: Path | None, port: int) -> ThreadingHTTPServer:
    """A server on this port or, when it is taken, the next one that is free; port 0 is any.

    Raises:
        InputError: when the port is none, or none of the next ones is free.
    """
    if not 0 <= port <= 65535:
        raise InputError(f"--port: {port} is no port; give one from 1024 to 65535, or 0 for any")
    handler = partial(_Handler, page, None if root is None else Path(os.path.realpath(root)))
    for tried in range(port, min(port + PORTS_TRIED, 65536)):
        try:
            server = ThreadingHTTPServer((HOST, tried), handler)
        except OSError:
            continue
        server.daemon_threads = True
        return server
    raise InputError(f"--port: none from {port} to {min(port + PORTS_TRIED, 65536) - 1} is free; give another")


def _fixed(data: bytes) -> Callable[[], bytes]:
    return lambda: data


def _page(path: Path) -> bytes:
    """A page made for a scene or a home alone."""
    from sceneweaver.report import ReportData, report_html

    if path.suffix.lower() == ".glb":
        from sceneweaver.report.from_glb import read_glb

        scene, load = read_glb(path)
        return report_html(ReportData(scene, load=load)).encode()
    if holds_home(path):
        from sceneweaver.report.home import home_report

        return home_report(home_page(Home.load(path), path.parent)).encode()
    scene = Scene.load(path)
    metrics = _metrics(path.parent / "metrics.json", path)
    if metrics is not None:
        with contextlib.suppress(KeyError, TypeError, ValueError, AttributeError):  # damaged: judged anew
            return report_html(ReportData(scene, metrics)).encode()
    from sceneweaver.verify import check

    return report_html(ReportData(scene, check(scene).to_dict())).encode()


def _metrics(path: Path, scene: Path) -> dict[str, Any] | None:
    """The metrics.json beside a scene.json, unless it is older or damaged: then the scene is judged anew."""
    try:
        if scene.name != "scene.json" or path.stat().st_mtime < scene.stat().st_mtime:
            return None
        data = parse_json(read_bytes(path))
    except (OSError, InputError):
        return None
    return data if isinstance(data, dict) and data.get("schema") == "sceneweaver.metrics/1" else None


class _Handler(BaseHTTPRequestHandler):
    """Answers GET and HEAD for the page and for plain files below one folder; nothing is listed, nothing is changed."""

    server_version = "sceneweaver"
    sys_version = ""
    timeout = 30

    def __init__(self, page: Callable[[], bytes], root: Path | None, *args: Any):
        self._page, self._root = page, root
        super().__init__(*args)

    def do_GET(self) -> None:  # noqa: N802, D102 - the name is that of the base class
        self._answer(True)

    def do_HEAD(self) -> None:  # noqa: N802, D102
        self._answer(False)

    def log_message(self, template: str, *args: Any) -> None:
        """Say nothing: what a browser asks for is no news."""

    def _answer(self, body: bool) -> None:
        # Another site could have its name resolve to this computer; a browser tells which name it used.
        host = self.headers.get("Host", "").rpartition(":")[0] or self.headers.get("Host", "")
        if host not in (HOST, "localhost"):
            self.send_error(HTTPStatus.FORBIDDEN)
            return
        name = unquote(urlsplit(self.path).path)
        try:
            if name in ("/", "/index.html"):
                data, kind = self._page(), _TYPES[".html"]
            else:
                file = self._file(name)
                if file is None:
                    self.send_error(HTTPStatus.NOT_FOUND)
                    return
                data, kind = read_bytes(file, max_bytes=MAX_BYTES), _TYPES[file.suffix.lower()]
        except (OSError, InputError):
            self.send_error(HTTPStatus.NOT_FOUND)
            return
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")
        self.end_headers()
        if body:
            with contextlib.suppress(ConnectionError):
                self.wfile.write(data)

    def _file(self, name: str) -> Path | None:
        """The file of a path below the folder; None for anything hidden, unknown, outside, or no plain file."""
        parts = [part for part in name.split("/") if part]
        if self._root is None or any(p.startswith(".") or "\\" in p or "\0" in p for p in parts):
            return None
        file = Path(os.path.realpath(self._root.joinpath(*parts)))
        if not file.is_relative_to(self._root) or not file.is_file() or file.suffix.lower() not in _TYPES:
            return None
        return file
