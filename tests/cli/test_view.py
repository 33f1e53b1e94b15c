"""The server of ``view``: one page, one folder, this computer only."""

from __future__ import annotations

import http.client
import json
import os
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from sceneweaver.cli.view import make_server, run_view, show
from sceneweaver.export import write_glb
from sceneweaver.scene import InputError, Pose, Room, Scene, SceneObject

SCENE = Scene(
    id="small",
    prompt="a crate",
    room=Room(outline=((0, 0), (3, 0), (3, 2), (1, 2), (1, 3), (0, 3))),
    objects=(SceneObject(id="crate", category="crate", size=(0.5, 0.7, 0.4), pose=Pose.from_yaw(1, 1, 0, 0.5)),),
)


@pytest.fixture
def run(tmp_path: Path) -> Iterator[tuple[Path, int]]:
    folder = tmp_path / "run"
    (folder / "views").mkdir(parents=True)
    (folder / "report.html").write_text("<p>report</p>")
    (folder / "views" / "top é.png").write_bytes(b"png")
    (folder / ".secret.json").write_text("{}")
    (folder / "key.pem").write_text("key")
    (tmp_path / "outside.json").write_text("{}")
    os.symlink(tmp_path / "outside.json", folder / "link.json")
    server = make_server(*show(folder), 0)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True)
    thread.start()
    yield folder, server.server_address[1]
    server.shutdown()
    server.server_close()
    thread.join(5)


def _ask(port: int, path: str, method: str = "GET", host: str | None = None) -> tuple[int, bytes, str]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=5)
    connection.putrequest(method, path, skip_host=True)
    connection.putheader("Host", host or f"127.0.0.1:{port}")
    connection.endheaders()
    answer = connection.getresponse()
    data = answer.read()
    connection.close()
    return answer.status, data, answer.headers.get("Content-Type", "")


def test_serves_the_page_and_the_folder(run) -> None:
    _, port = run
    assert _ask(port, "/") == (200, b"<p>report</p>", "text/html; charset=utf-8")
    assert _ask(port, "/?x=1")[0] == 200
    assert _ask(port, "/views/top%20%C3%A9.png") == (200, b"png", "image/png")
    assert _ask(port, "/", "HEAD")[:2] == (200, b"")
    assert _ask(port, "/", host=f"localhost:{port}")[0] == 200


@pytest.mark.parametrize(
    "path",
    [
        "/../outside.json",
        "/%2e%2e/outside.json",
        "/views/../../outside.json",
        "/..%2foutside.json",
        "/link.json",
        "/.secret.json",
        "/key.pem",
        "/views",
        "/views/",
        "//etc/passwd",
        "/%00",
        "/nothing.json",
        "/views/..%5c..%5cx",
    ],
)
def test_nothing_else(run, path: str) -> None:
    assert _ask(run[1], path)[0] == 404


def test_other_names_and_methods_are_refused(run) -> None:
    assert _ask(run[1], "/", host="evil.example")[0] == 403
    assert _ask(run[1], "/", "POST")[0] == 501
    assert _ask(run[1], "/", "DELETE")[0] == 501


def test_a_taken_port_gives_the_next(run) -> None:
    server = make_server(lambda: b"", None, run[1])
    assert server.server_address[1] > run[1]
    server.server_close()


def test_a_scene_alone_gets_a_page(tmp_path: Path) -> None:
    SCENE.save(tmp_path / "scene.json")
    page, root = show(tmp_path / "scene.json")
    assert root is None and b"a crate" in page() and b"scene-meshes" in page()
    # Metrics of another time are not believed.
    (tmp_path / "metrics.json").write_text(json.dumps({"schema": "sceneweaver.metrics/1", "valid": False}))
    assert b">not valid<" in show(tmp_path)[0]()
    os.utime(tmp_path / "metrics.json", (1, 1))
    assert b">valid<" in show(tmp_path)[0]()


def test_our_own_glb_comes_back(tmp_path: Path) -> None:
    from sceneweaver.report.from_glb import read_glb

    write_glb(SCENE, tmp_path / "scene.glb")
    scene, load = read_glb(tmp_path / "scene.glb")
    assert scene.room == SCENE.room and scene.ids == SCENE.ids and scene.prompt == SCENE.prompt
    assert scene.objects[0].pose == SCENE.objects[0].pose
    mesh = load(scene.objects[0].asset or "").mesh
    assert mesh.bounds == pytest.approx(load("0").mesh.bounds) and len(mesh.faces) == 12
    assert b"crate" in show(tmp_path)[0]()


def test_what_moves_in_our_own_glb_moves_when_it_comes_back(tmp_path: Path) -> None:
    from sceneweaver.assets import make
    from sceneweaver.report.from_glb import read_glb
    from sceneweaver.report.view3d import pack

    fridge = make("fridge", 1)
    scene = Scene(
        id="s",
        room=SCENE.room,
        objects=(fridge.object("fridge", pose=Pose.from_yaw(1.5, 1.5, 0.0, 0.5)),),
    )
    write_glb(scene, tmp_path / "scene.glb", load=lambda _: fridge)
    before, after = (
        [item["joint"] for item in pack(one, [], [], load).data["items"] if "joint" in item]
        for one, load in ((scene, lambda _: fridge), read_glb(tmp_path / "scene.glb"))
    )
    assert len(after) == len(before) >= 2
    for was, now in zip(before, after, strict=True):
        assert (now["name"], now["kind"]) == (was["name"], was["kind"])
        for key in ("axis", "limits") + (("anchor",) if was["kind"] == "hinge" else ()):
            assert now[key] == pytest.approx(was[key], abs=1e-6), key


def test_anybodys_glb_is_shown(tmp_path: Path) -> None:
    import trimesh

    other = trimesh.Scene()
    other.add_geometry(trimesh.creation.box((1, 2, 3)), node_name="wall:1")
    (tmp_path / "other.glb").write_bytes(other.export(file_type="glb"))  # type: ignore[arg-type]
    from sceneweaver.report.from_glb import read_glb

    scene, _ = read_glb(tmp_path / "other.glb")
    assert scene.objects[0].size == pytest.approx((1, 3, 2), abs=1e-5), "y up became z up"


@pytest.mark.parametrize("name", ["missing", "empty", "broken.glb", "broken.json"])
def test_nothing_to_show(tmp_path: Path, name: str) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "broken.glb").write_bytes(b"glTF nothing")
    (tmp_path / "broken.json").write_text("{")
    with pytest.raises(InputError, match=name) as caught:
        run_view(tmp_path / name, 0, False)
    assert "\n" not in str(caught.value)


def test_a_port_that_is_none() -> None:
    with pytest.raises(InputError, match="--port"):
        make_server(lambda: b"", None, 70000)


@pytest.mark.parametrize("spoil", [{"violations": 3}, {"violations": [{}]}, {"scores": [], "seconds": "x"}])
def test_damaged_metrics_are_measured_anew(tmp_path, spoil):
    Scene.example("bedroom").save(tmp_path / "scene.json")
    page, _ = show(tmp_path)
    (tmp_path / "metrics.json").write_text(json.dumps({"schema": "sceneweaver.metrics/1", **spoil}))
    again, _ = show(tmp_path)
    assert len(again()) > 0.9 * len(page())
