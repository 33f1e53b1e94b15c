"""Mesh files from elsewhere: normalised, or refused in one line that names the file; nothing is left half-written."""

from __future__ import annotations

import json
import multiprocessing
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from sceneweaver.assets.imports.hints import Hints
from sceneweaver.assets.imports.limited import LimitedError, run_limited
from sceneweaver.assets.imports.prepare import content_hash, prepare
from sceneweaver.assets.parametric import make
from sceneweaver.assets.readers import entries
from sceneweaver.assets.store import Store
from sceneweaver.cli import main
from sceneweaver.scene import InputError
from tests.assets.meshes import Y_UP, body, turned, write, write_usd


@pytest.fixture(scope="module")
def wardrobe():
    return make("wardrobe", 3)


def _same(got, want, tolerance: float = 2e-3) -> None:
    """The same body in the same frame: sizes, and what stands where."""
    np.testing.assert_allclose(got.size, want.size, atol=tolerance)
    a, b = got.mesh.vertices, want.mesh.vertices
    assert max(cKDTree(a).query(b)[0].max(), cKDTree(b).query(a)[0].max()) < tolerance


def test_centimetres_y_up_turned_and_off_centre(tmp_path: Path, wardrobe) -> None:
    mesh = body(wardrobe, matrix=Y_UP @ turned(1), scale=100.0, shift=(310.0, -40.0, 75.0))
    got = prepare(Hints(path=write(mesh, tmp_path / "w.obj"), name="w", category="wardrobe"), cache=tmp_path)
    _same(got, wardrobe)
    assert got.origin.metres_per_unit == 0.01
    assert any("centimetres" in note for note in got.origin.notes)
    assert any("confidence" in note for note in got.origin.notes)
    np.testing.assert_allclose(got.mesh.bounds[0][:2], -got.mesh.bounds[1][:2], atol=1e-9)
    assert abs(got.mesh.bounds[0][2]) < 1e-9


@pytest.mark.parametrize("quarters", range(4))
def test_a_stated_front_is_turned_to_x(tmp_path: Path, wardrobe, quarters: int) -> None:
    axis = ("x", "y", "-x", "-y")[quarters]
    path = write(body(wardrobe, matrix=turned(quarters)), tmp_path / "w.stl")
    got = prepare(Hints(path=path, name="w", category="wardrobe", up="z", front=axis), cache=tmp_path)
    _same(got, wardrobe)
    assert got.origin.front_confidence == 1.0


def test_glb_keeps_colours_and_its_stated_axes(tmp_path: Path) -> None:
    chair = make("dining_chair", 1)
    mesh = body(chair, matrix=Y_UP)
    mesh.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(baseColorFactor=[200, 30, 30, 255], roughnessFactor=0.3)
    )
    got = prepare(Hints(path=write(mesh, tmp_path / "c.glb"), name="c", category="dining chair", front="z"))
    _same(got, chair)
    assert got.attributes["color"] == "red"
    assert got.mesh.materials[0].roughness == pytest.approx(0.3)


@pytest.mark.parametrize(("up", "metres"), [("Z", 1.0), ("Y", 0.01)])
def test_usd_says_its_unit_and_axis(tmp_path: Path, wardrobe, up: str, metres: float) -> None:
    path = write_usd(wardrobe, tmp_path / "w.usda", up=up, metres=metres)
    front = "z" if up == "Y" else "x"
    _same(prepare(Hints(path=path, name="w", category="wardrobe", front=front), cache=tmp_path), wardrobe)


def test_parts_contain_the_mesh_and_prisms_contain_the_parts(tmp_path: Path) -> None:
    from tests.assets.rules import _holds, _outside, _planes, _samples

    got = prepare(Hints(path=write(body(make("step_stool", 2)), tmp_path / "a.obj"), name="a", category="step_stool"))
    planes = [_planes(h)[:2] for h in got.hulls]
    assert all(not _planes(h)[2] for h in got.hulls)
    assert _outside(_samples(got), planes, got.hulls) < 1e-6
    assert 1 <= len(got.parts) <= 8
    assert all(any(_holds(part, h.vertices) for part in got.parts) for h in got.hulls)


def test_shelf_boards_are_found_with_their_head_room(tmp_path: Path) -> None:
    case = make("bookcase", 3)
    got = prepare(Hints(path=write(body(case), tmp_path / "b.obj"), name="b", category="bookcase", up="z", front="x"))
    for want in case.surfaces:
        near = [s for s in got.surfaces if abs(s.z - want.z) < 5e-3]
        assert near, want.name
        assert near[0].headroom == pytest.approx(want.headroom, abs=0.01) if want.headroom else True


def test_a_table_top_that_is_inside_out_is_found(tmp_path: Path) -> None:
    top = trimesh.creation.box((1.2, 0.8, 0.04), trimesh.transformations.translation_matrix((0, 0, 0.73)))
    top.invert()
    legs = [
        trimesh.creation.box((0.05, 0.05, 0.71), trimesh.transformations.translation_matrix((x, y, 0.355)))
        for x in (-0.55, 0.55)
        for y in (-0.35, 0.35)
    ]
    path = write(trimesh.util.concatenate([top, *legs]), tmp_path / "t.obj")
    got = prepare(Hints(path=path, name="t", category="dining table", up="z", front="y", metres=1.0))
    (surface,) = got.surfaces
    assert surface.name == "top" and surface.headroom is None and surface.z == pytest.approx(0.75, abs=1e-4)


def test_a_ten_metre_toy_is_caught(tmp_path: Path) -> None:
    path = write(trimesh.creation.box((9.0, 10.0, 7.0)), tmp_path / "t.stl")
    with pytest.raises(
        InputError, match=r"t: with the stated unit it would be .* m; a .* is .* m; give --unit or --size"
    ):
        prepare(Hints(path=path, name="t", category="toy car", metres=1.0))


def _truncated(folder: Path) -> Path:
    path = write(body(make("wardrobe", 3)), folder / "cut.glb")
    path.write_bytes(path.read_bytes()[:-500])
    return path


def _made(folder: Path, name: str, data: bytes) -> Path:
    path = folder / name
    path.write_bytes(data)
    return path


@pytest.mark.parametrize(
    ("make_file", "says"),
    [
        (lambda f: _made(f, "empty.glb", b""), "empty.glb: the file is empty"),
        (_truncated, r"cut.glb: the file is cut off: \d+ of \d+ bytes"),
        (lambda f: _made(f, "noise.glb", bytes(range(256)) * 4), "noise.glb: this is no GLB file"),
        (lambda f: _made(f, "noise.obj", b"v 1 2\nf 1 2 9\n"), "noise.obj: "),
        (lambda f: _made(f, "nothing.obj", b"# only words\n"), "nothing.obj: "),
        (lambda f: _made(f, "bad.usda", b"#usda 1.0\ndef Mesh {"), "bad.usda: "),
        (lambda f: _made(f, "what.blend", b"BLENDER"), "files of type '.blend' are not read"),
        (lambda f: f / "missing.obj", "no such file"),
        (lambda f: _made(f, "nan.obj", b"v 0 0 0\nv 1 0 0\nv nan 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n"), "nan.obj: "),
        (lambda f: _made(f, "flat.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "flat.obj: the mesh has no extent"),
    ],
)
def test_files_of_no_use_are_refused_in_one_line(tmp_path: Path, make_file, says: str) -> None:
    with pytest.raises(InputError, match=says) as caught:
        prepare(Hints(path=make_file(tmp_path), name="x"))
    assert "\n" not in str(caught.value)


@pytest.mark.slow  # its decomposition takes half a minute
def test_non_manifold_meshes_are_taken(tmp_path: Path) -> None:
    box = trimesh.creation.box((0.5, 0.8, 0.7))
    torn = trimesh.Trimesh(box.vertices, np.concatenate([box.faces[:-3], [[0, 1, 7]], [[0, 1, 7]]]), process=False)
    got = prepare(Hints(path=write(torn, tmp_path / "torn.obj"), name="torn", up="z", metres=1.0), cache=tmp_path)
    np.testing.assert_allclose(got.size, (0.5, 0.8, 0.7), atol=1e-6)
    corners = np.concatenate([hull.vertices for hull in got.hulls])
    np.testing.assert_allclose(np.ptp(corners, axis=0), (0.5, 0.8, 0.7), atol=1e-3)


@pytest.mark.slow
def test_five_million_triangles_are_simplified(tmp_path: Path) -> None:
    ball = trimesh.creation.icosphere(subdivisions=9, radius=0.3)  # 5.2 million
    got = prepare(Hints(path=write(ball, tmp_path / "ball.stl"), name="ball", up="z", metres=1.0), seconds=120)
    assert len(got.mesh.faces) <= 20_000
    np.testing.assert_allclose(got.size, (0.6, 0.6, 0.6), atol=0.01)


def test_native_work_has_a_time_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(LimitedError, match="not done within 0.01 s"):
        run_limited("decompose", {"vertices": np.zeros((3, 3))}, 0.01)
    with pytest.raises(LimitedError):
        run_limited("decompose", {"vertices": np.zeros((3, 3))}, 30)


def test_a_failed_decomposition_is_conservative_and_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from sceneweaver.assets.imports import collision

    def fail(*_):
        raise LimitedError("not done within 1 s")

    monkeypatch.setattr(collision, "run_limited", fail)
    cup = trimesh.creation.annulus(0.03, 0.04, 0.09)
    got = prepare(Hints(path=write(cup, tmp_path / "cup.stl"), name="cup", up="z", metres=1.0))
    assert any("whole hulls" in note and "not done within" in note for note in got.origin.notes)
    assert len(got.hulls) == 1


def test_the_store_gives_back_what_was_put_in(tmp_path: Path, wardrobe) -> None:
    store = Store(tmp_path / "store")
    content = content_hash(wardrobe)
    assert store.add(wardrobe, content) and not store.add(wardrobe, content)
    (row,) = store.rows()
    assert row["licence"] == "Apache-2.0" and row["hash"] == content and len(row["parts"]) == len(wardrobe.parts)
    assert not list((tmp_path / "store" / "drafts").iterdir())


def test_an_import_that_dies_leaves_nothing(tmp_path: Path, wardrobe, monkeypatch: pytest.MonkeyPatch) -> None:
    from sceneweaver.assets import store as module

    def die(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(module, "_write_body", die)
    store = Store(tmp_path / "store")
    with pytest.raises(InputError, match="No space left"):
        store.add(wardrobe, content_hash(wardrobe))
    assert not list(store.rows())
    assert not [p for p in (tmp_path / "store").rglob("*") if p.is_file()]


def _import_one(arguments: tuple[str, str]) -> str:
    path, store = arguments
    asset = prepare(
        Hints(path=Path(path), name="w", category="wardrobe", up="z", front="x"), cache=Store(Path(store)).cache
    )
    Store(Path(store)).add(asset, content_hash(asset))
    return asset.id


def test_two_processes_may_import_at_once(tmp_path: Path, wardrobe) -> None:
    path = write(body(wardrobe), tmp_path / "w.stl")
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        first, second = pool.map(_import_one, [(str(path), str(tmp_path / "store"))] * 2)
    assert first == second
    store = Store(tmp_path / "store")
    assert [row["id"] for row in store.rows()] == [first]
    assert store.load(first).size == pytest.approx(wardrobe.size, abs=1e-5)


def test_a_folder_with_a_manifest(tmp_path: Path, wardrobe, capsys) -> None:
    write(body(wardrobe, matrix=turned(2), scale=1000), tmp_path / "mine" / "w.stl")
    row = {"file": "w.stl", "category": "wardrobe", "up": "z", "front": "-x", "unit": "mm", "licence": "CC0-1.0"}
    (tmp_path / "mine" / "manifest.json").write_text(json.dumps([row]))
    assert main(["assets", "import", str(tmp_path / "mine"), "--store", str(tmp_path / "s"), "--json"]) == 0
    (made,) = json.loads(capsys.readouterr().out)["imported"]
    got = Store(tmp_path / "s").load(made["id"])
    _same(got, wardrobe)
    assert got.origin.licence == "CC0-1.0"
    command = ["assets", "import", str(tmp_path / "mine"), "--store", str(tmp_path / "s"), "--license-allow", "MIT"]
    assert main(command) == 0
    assert "1 skipped by licence" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("row", "says"),
    [
        ({"file": "w.stl", "colour": "red"}, "unknown column 'colour'; did you mean \"color\""),
        ({"file": "../w.stl"}, "outside the folder"),
        ({"file": "w.stl", "up": "upward"}, "up 'upward' is no axis"),
        ({"file": "w.stl", "height": -1}, "height '-1' is no number above 0"),
        ({"file": "w.stl", "unit": "parsec"}, "unit 'parsec' is unknown"),
        ({}, "a row has no 'file'"),
    ],
)
def test_a_wrong_manifest_is_named(tmp_path: Path, row: dict, says: str) -> None:
    (tmp_path / "manifest.json").write_text(json.dumps([row]))
    with pytest.raises(InputError, match=says):
        list(entries(tmp_path))


def test_the_command_names_what_it_refuses_and_goes_on(tmp_path: Path, wardrobe, capsys) -> None:
    write(body(wardrobe), tmp_path / "mine" / "wardrobe" / "good.stl")
    _made(tmp_path / "mine", "empty.glb", b"")
    assert main(["assets", "import", str(tmp_path / "mine"), "--store", str(tmp_path / "s")]) == 3
    said = capsys.readouterr()
    assert "empty.glb: the file is empty" in said.err and "1 imported, 1 refused" in said.out
    assert main(["assets", "import", str(tmp_path / "none")]) == 2


def test_the_worker_needs_no_package_of_ours() -> None:
    source = Path(run_limited.__code__.co_filename).parents[1] / "sources" / "infinigen_worker.py"
    assert "sceneweaver." not in source.read_text()
    done = subprocess.run([sys.executable, "-m", "py_compile", str(source)], capture_output=True, timeout=60)
    assert done.returncode == 0
