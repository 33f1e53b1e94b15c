"""Mesh files and tables of unknown origin: pipes, bombs, and packages that are not there."""

from __future__ import annotations

import base64
import builtins
import gzip
import json
import os
import time
import zipfile

import numpy as np
import pytest

from sceneweaver.assets.imports.load import load
from sceneweaver.assets.readers import entries
from sceneweaver.cli.app import main
from sceneweaver.io import archives, load_csv, load_packed_json, read_mesh, read_meshes
from sceneweaver.scene import InputError, MissingDependencyError
from sceneweaver.verify.meshes import MeshSet

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=np.float32)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], dtype=np.uint32)


def gltf(uri: str) -> dict:
    """A tetrahedron whose buffer is elsewhere."""
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": uri, "byteLength": 96}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 48},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
            {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": 12},
        ],
    }


def stl(name: str) -> bytes:
    """A tetrahedron as an STL file in text, whose name is in Latin-1."""
    rows = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in CORNERS[face])
        + "endloop\nendfacet\n"
        for face in FACES
    )
    return f"solid {name}\n{rows}endsolid {name}\n".encode("latin-1")


def test_a_buffer_beside_the_file_is_read_and_a_pipe_is_not(tmp_path):
    (tmp_path / "sound.bin").write_bytes(CORNERS.tobytes() + FACES.tobytes())
    (tmp_path / "sound.gltf").write_text(json.dumps(gltf("sound.bin")))
    assert len(load(tmp_path / "sound.gltf").faces) == 4
    os.mkfifo(tmp_path / "pipe.bin")
    for uri, name in (("pipe.bin", "pipe.gltf"), ("link.bin", "link.gltf")):
        (tmp_path / name).write_text(json.dumps(gltf(uri)))
    (tmp_path / "link.bin").symlink_to(tmp_path / "pipe.bin")
    for name in ("pipe.gltf", "link.gltf"):
        with pytest.raises(InputError, match="is a pipe or a device; give a regular file"):
            load(tmp_path / name)
    os.mkfifo(tmp_path / "pipe.stl")
    with pytest.raises(InputError, match="pipe.stl: this is a pipe or a device"):
        load(tmp_path / "pipe.stl")
    with pytest.raises(InputError, match="meshes.'a'.: .*is a pipe or a device"):
        MeshSet({"a": tmp_path / "pipe.stl"}).get("a")


def test_usd_does_not_wait_for_a_pipe(tmp_path):
    os.mkfifo(tmp_path / "pipe.usda")
    for how in (
        "(\n    subLayers = [@./pipe.usda@]\n)",
        '\ndef Xform "a" (\n    references = @./pipe.usda@</a>\n)\n{\n}',
    ):
        (tmp_path / "chair.usda").write_text(f"#usda 1.0\n{how}\n")
        with pytest.raises(InputError, match="pipe.usda: this is a pipe or a device"):
            load(tmp_path / "chair.usda")


def test_arrays_larger_than_any_file_are_refused(tmp_path):
    uri = "data:application/octet-stream;base64," + base64.b64encode(CORNERS.tobytes() + FACES.tobytes()).decode()
    document = gltf(uri)
    (tmp_path / "sound.gltf").write_text(json.dumps(document))
    assert len(load(tmp_path / "sound.gltf").faces) == 4
    document["accessors"][0] = {"componentType": 5126, "type": "VEC3", "count": 1 << 40}  # so many zeros
    (tmp_path / "zeros.gltf").write_text(json.dumps(document))
    with pytest.raises(InputError, match="its arrays have .* MiB; at most 1024 MiB are read"):
        load(tmp_path / "zeros.gltf")


def test_a_mesh_shown_over_and_over_is_counted_each_time(tmp_path, monkeypatch):
    uri = "data:application/octet-stream;base64," + base64.b64encode(CORNERS.tobytes() + FACES.tobytes()).decode()
    document = gltf(uri)
    document["nodes"] = [{"mesh": 0}] * 50
    document["scenes"] = [{"nodes": list(range(50))}]
    (tmp_path / "many.gltf").write_text(json.dumps(document))
    assert len(load(tmp_path / "many.gltf").faces) == 200
    monkeypatch.setattr("sceneweaver.assets.imports.load.MAX_TRIANGLES", 100)
    with pytest.raises(InputError, match="over 100 triangles"):
        load(tmp_path / "many.gltf")


def test_a_packed_array_is_bounded(tmp_path, monkeypatch):
    np.savez_compressed(tmp_path / "zeros.npz", vertices=np.zeros(1 << 20))
    monkeypatch.setitem(archives.read_arrays.__kwdefaults__, "max_bytes", 1 << 20)
    with pytest.raises(InputError, match="zeros.npz: it unpacks to more than 1 MiB"):
        load(tmp_path / "zeros.npz")
    with zipfile.ZipFile(tmp_path / "odd.npz", "w") as packed:
        packed.writestr("vertices.npy", b"no array")
    with pytest.raises(InputError, match="odd.npz: the file is damaged"):
        load(tmp_path / "odd.npz")


def test_tables_are_bounded(tmp_path, monkeypatch):
    monkeypatch.setitem(load_packed_json.__kwdefaults__, "max_bytes", 1 << 20)
    (tmp_path / "annotations.json.gz").write_bytes(gzip.compress(b" " * (8 << 20)))
    with pytest.raises(InputError, match="annotations.json.gz: it unpacks to more than 1 MB"):
        list(entries(tmp_path, "objathor"))
    monkeypatch.setattr("sceneweaver.io.json_text.MAX_CONTAINERS", 1000)
    monkeypatch.setattr("sceneweaver.io.tables.MAX_CELLS", 1000)
    (tmp_path / "wide.json").write_text("[" + "[],[]," * 1000 + "[]]")
    with pytest.raises(InputError, match="wide.json: invalid JSON: over 1000 lists and objects"):
        load_packed_json(tmp_path / "wide.json")
    (tmp_path / "wide.csv").write_text("a,b\n" * 1000)
    with pytest.raises(InputError, match="wide.csv: not readable as CSV .over 1000 cells"):
        load_csv(tmp_path / "wide.csv")


def test_a_table_nested_too_deep_is_one_line(tmp_path):
    (tmp_path / "deep.json").write_text("[" * 100_000)
    with pytest.raises(InputError, match="deep.json: invalid JSON: nested too deep"):
        load_packed_json(tmp_path / "deep.json")


def test_a_sound_stl_with_a_name_in_latin_letters_is_read(tmp_path):
    pytest.importorskip("charset_normalizer")  # a dependency since trimesh asks for it
    (tmp_path / "chair.stl").write_bytes(stl("Stühlchen"))
    assert len(load(tmp_path / "chair.stl").faces) == 4


def test_a_missing_package_is_named_and_the_file_is_not_called_damaged(tmp_path, monkeypatch):
    real = builtins.__import__

    def without(name, *args, **kwargs):
        if name == "charset_normalizer":
            raise ModuleNotFoundError(f"No module named '{name}'", name=name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without)
    (tmp_path / "chair.stl").write_bytes(stl("Stühlchen"))
    with pytest.raises(MissingDependencyError, match="chair.stl: .*'charset_normalizer'; install it with: pip install"):
        load(tmp_path / "chair.stl")


def tetrahedron(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    uri = "data:application/octet-stream;base64," + base64.b64encode(CORNERS.tobytes() + FACES.tobytes()).decode()
    path.write_text(json.dumps(gltf(uri)))
    return path


@pytest.mark.parametrize(
    ("kind", "table", "text"),
    [
        ("objathor", "annotations.json", '{"NAME": {"category": "chair"}}'),
        ("abo", "3dmodels.csv", "3dmodel_id,path\nC1,NAME.glb\n"),
        ("3d-future", "model_info.json", '[{"model_id": "NAME"}]'),
    ],
)
def test_a_table_names_files_of_its_own_folder_only(tmp_path, kind, table, text):
    root = tmp_path / "library"
    for place in ("a.glb", "a/raw_model.obj", "../b.glb", "../b/raw_model.obj"):
        tetrahedron(root / place)
    (root / table).write_text(text.replace("NAME", "a"))
    assert len(list(entries(root, kind))) == 1
    for name in ("../b", str(tmp_path / "b")):
        (root / table).write_text(text.replace("NAME", name))
        with pytest.raises(InputError, match="which lies outside of the folder"):
            list(entries(root, kind))


def test_odd_values_of_a_manifest_are_one_line(tmp_path):
    tetrahedron(tmp_path / "a.gltf")
    for row, said in (
        ({"file": "a.gltf", "mass": 10**400}, "mass '1000.* is no number above 0"),
        ({"file": "a\0.gltf"}, "lies outside the folder"),
        ({"file": "a.gltf", "\x1b[2J" + "x" * 5000: 1}, "unknown column"),
    ):
        (tmp_path / "manifest.json").write_text(json.dumps([row]))
        with pytest.raises(InputError, match=said) as caught:
            list(entries(tmp_path, "folder"))
        assert len(str(caught.value)) < 300 and str(caught.value).isprintable()
    (tmp_path / "manifest.json").write_text(json.dumps([{"file": "a.gltf", "category": ["chair"], "description": {}}]))
    (hints,) = entries(tmp_path, "folder")
    assert hints.category is None and hints.description == ""


def test_a_long_chain_of_nodes_is_refused_before_it_is_walked(tmp_path):
    document = gltf("sound.bin")
    document["nodes"] = [{"children": [k + 1]} for k in range(20_000)] + [{"mesh": 0}]
    (tmp_path / "chain.gltf").write_text(json.dumps(document))
    with pytest.raises(InputError, match="chain.gltf: nodes within each other more than 256 deep"):
        load(tmp_path / "chain.gltf")


def test_numbers_beyond_all_lengths_are_one_line(tmp_path, capsys):
    rows = "v 0 0 0\nv 1e308 0 0\nv 0 1e308 0\nv 0 0 -1e308\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    (tmp_path / "far.obj").write_text(rows)
    assert main(["assets", "import", str(tmp_path / "far.obj"), "--store", str(tmp_path / "store")]) == 2
    assert "sceneweaver: far.obj: some vertices are NaN, infinite or beyond 1e+09" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["../x.obj", "/abs/x.obj"])
def test_a_model_names_meshes_of_its_own_folder_only(tmp_path, name):
    model = tmp_path / "chair" / "model.xml"
    model.parent.mkdir()
    (tmp_path / "x.obj").write_text("v 0 0 0\n")
    body = '<worldbody><geom type="mesh" mesh="x"/></worldbody>'
    model.write_text(f'<mujoco><asset><mesh name="x" file="{name}"/></asset>{body}</mujoco>')
    with pytest.raises(InputError, match="it names '.*', which lies outside of the folder"):
        list(entries(model, "mjcf"))


def test_a_slow_mesh_ends_with_its_time(tmp_path, monkeypatch, capsys):
    def slow(path, seconds):
        for _ in range(30_000):
            time.sleep(0.002)
        raise AssertionError

    monkeypatch.setattr("sceneweaver.assets.imports.prepare.load", slow)
    file = tetrahedron(tmp_path / "slow.gltf")
    assert main(["assets", "import", str(file), "--store", str(tmp_path / "store"), "--time-limit", "0.3"]) == 2
    assert "slow.gltf: not done within 0.3 s; raise --time-limit" in capsys.readouterr().err


def test_a_reader_of_usd_that_crashes_is_one_line(tmp_path, monkeypatch):
    (tmp_path / "crash").mkdir()
    (tmp_path / "crash" / "pxr.py").write_text("import os\nos.abort()\n")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "crash"))
    (tmp_path / "chair.usda").write_text("#usda 1.0\n")
    with pytest.raises(InputError, match="chair.usda: the file is damaged.*ended with code -6") as caught:
        load(tmp_path / "chair.usda")
    assert "\n" not in str(caught.value)


def test_a_triangle_without_its_vertices_is_one_line_wherever_it_is_read(tmp_path):
    rows = "0 0 0\n1 0 0\n0 1 0\n"
    head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    (tmp_path / "a.ply").write_text(f"{head}{rows}3 0 1 11521\n")
    for read in (read_meshes, read_mesh, load, lambda path: MeshSet({"a": path}).get("a")):
        with pytest.raises(InputError, match="a.ply: a triangle names a vertex that is not there"):
            read(tmp_path / "a.ply")


def test_a_document_that_is_no_text_is_named(tmp_path):
    (tmp_path / "a.gltf").write_bytes(b'{"asset": "\xff"}')
    with pytest.raises(InputError, match="a.gltf: not UTF-8 text .byte 11."):
        load(tmp_path / "a.gltf")


def test_names_longer_than_any_file_has_are_one_line(tmp_path):
    long = "x" * 300
    (tmp_path / "annotations.json").write_text(json.dumps({long: {"category": "chair"}}))
    assert list(entries(tmp_path, "objathor")) == []
    body = '<worldbody><geom type="mesh" mesh="x"/></worldbody>'
    model = tmp_path / "model.xml"
    model.write_text(f'<mujoco><asset><mesh name="x" file="{long}.obj"/></asset>{body}</mujoco>')
    (hints,) = entries(model, "mjcf")
    with pytest.raises(InputError, match="File name too long"):
        load(hints.path)


@pytest.mark.parametrize("height", ["1e308", "1e-308"])
def test_a_size_that_nothing_has_is_one_line(tmp_path, capsys, height):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    (tmp_path / "manifest.csv").write_text(f"file,category,height\na.obj,chair,{height}\n")
    assert main(["assets", "import", str(tmp_path), "--store", str(tmp_path / "store")]) == 2
    assert "sceneweaver: a: with the stated size it would be" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["objects", "drafts", "cache"])
def test_a_link_in_a_store_is_not_written_through(tmp_path, capsys, name):
    outside, store = tmp_path / "outside", tmp_path / "store"
    outside.mkdir(), store.mkdir()
    (store / name).symlink_to(outside)
    bar = np.array([[0, 0, 0], [1, 0, 0], [1, 0.1, 0], [0.1, 0.1, 0], [0.1, 1, 0], [0, 1, 0]])
    rows = "".join("v {} {} {}\n".format(*p) for z in (0, 0.1) for p in bar + [0, 0, z])
    sides = [(k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6) for k in range(6)]
    faces = [(3, 2, 1, 0), (5, 4, 3, 0), (6, 7, 8, 9), (6, 9, 10, 11), *sides]  # of an L, which has to be decomposed
    rows += "".join("f {} {} {} {}\n".format(*(k + 1 for k in face)) for face in faces)
    (tmp_path / "a.obj").write_text(rows)
    assert main(["assets", "import", str(tmp_path / "a.obj"), "--store", str(store)]) == (0 if name == "cache" else 2)
    assert list(outside.iterdir()) == []
    assert name == "cache" or f"{name}: this is a link to another place; remove it" in capsys.readouterr().err
