"""Metadata of other libraries, on folders made here: what is read, and what is refused."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest

from sceneweaver.assets.imports.prepare import prepare
from sceneweaver.assets.parametric import make
from sceneweaver.assets.readers import READERS, entries
from sceneweaver.scene import InputError
from tests.assets.meshes import Y_UP, body, turned, write

CHAIR = make("dining_chair", 1)


def _read(folder: Path, reader: str):
    """The one entry of a folder, which its reader must be the first to take."""
    assert next(r.name for r in READERS.values() if r.fits(folder)) == reader
    (hints,) = entries(folder)
    return hints


def _same(hints) -> None:
    """The file's body, in our frame, is the chair that it was made from."""
    got = prepare(hints)
    assert got.size == pytest.approx(CHAIR.size, abs=2e-3)
    back = got.mesh.vertices[got.mesh.vertices[:, 2] > 0.9 * got.size[2]]
    assert back[:, 0].mean() < 0, "the back rest stands behind"


@pytest.mark.parametrize("flat", [True, False])
def test_objathor(tmp_path: Path, flat: bool) -> None:
    row = {
        "category": "dining chair",
        "scale": CHAIR.size[2],
        "frontView": 0,
        "pose_z_rot_angle": 0.0,
        "license": "by",
        "materials": ["oak", 3],
        "onFloor": True,
    }
    mesh = body(CHAIR, matrix=Y_UP, scale=17.0)
    if flat:
        write(mesh, tmp_path / "abc.glb")
        (tmp_path / "annotations.json.gz").write_bytes(gzip.compress(json.dumps({"abc": row, "gone": row}).encode()))
    else:
        write(mesh, tmp_path / "abc" / "abc.glb")
        (tmp_path / "abc" / "annotations.json").write_text(json.dumps(row))
    hints = _read(tmp_path, "objathor")
    assert (hints.name, hints.licence, hints.mount) == ("abc", "by", "floor")
    _same(hints)


def test_future3d(tmp_path: Path) -> None:
    write(body(CHAIR, matrix=Y_UP), tmp_path / "m1" / "raw_model.obj")
    rows = [{"model_id": "m1", "category": "Dining Chair / Other", "style": "Modern"}, {"model_id": "gone"}]
    (tmp_path / "model_info.json").write_text(json.dumps(rows))
    hints = _read(tmp_path, "3d-future")
    assert (hints.category, hints.attributes["style"]) == ("dining chair", "modern")
    _same(hints)


@pytest.mark.parametrize(("front", "matrix"), [("", Y_UP), ("-z", Y_UP @ turned(2))])
def test_hssd(tmp_path: Path, front: str, matrix) -> None:
    write(body(CHAIR, matrix=matrix), tmp_path / "objects" / "7" / "7a.glb")
    table = tmp_path / "semantics" / "objects" / "object_categories_filtered.csv"
    table.parent.mkdir(parents=True)
    table.write_text(f"id,clean_category,front,up\n7a,dining chair,{front},\n8b,sofa,,\n")
    hints = _read(tmp_path, "hssd")
    assert (hints.up, hints.front) == ("y", front or "z")
    _same(hints)


def test_abo(tmp_path: Path) -> None:
    write(body(CHAIR, matrix=Y_UP), tmp_path / "original" / "1" / "B1.glb")
    (tmp_path / "3dmodels.csv").write_text("3dmodel_id,path\nB1,1/B1.glb\nB2\n")
    listing = {
        "3dmodel_id": "B1",
        "product_type": [{"value": "DINING_CHAIR"}],
        "item_name": [{"language_tag": "de_DE", "value": "Stuhl"}, {"language_tag": "en_US", "value": "A\u2028b"}],
    }
    text = json.dumps(listing, ensure_ascii=False) + "\n"
    (tmp_path / "listings_0.json.gz").write_bytes(gzip.compress(text.encode()))
    hints = _read(tmp_path, "abo")
    assert (hints.category, hints.description) == ("dining chair", "A\u2028b")
    _same(hints)


MODEL = """<mujoco><compiler meshdir="visual"{angle}/><asset><mesh name="v" file="c.obj" scale="0.5 0.5 0.5"/>
</asset><worldbody><body><geom type="mesh" mesh="v" group="1" contype="0" conaffinity="0" {pose}/>
</body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("angle", "pose", "quarters"),
    [
        ("", 'euler="0 0 90"', 2),
        (' angle="radian"', 'euler="0 0 1.5707963"', 2),
        ("", 'quat="0.7071068 0 0 0.7071068"', 2),
        ("", "", 3),
    ],
)
def test_mjcf(tmp_path: Path, angle: str, pose: str, quarters: int) -> None:
    # RoboCasa's front is -y in the body's frame; the geom turns the mesh there.
    write(body(CHAIR, matrix=turned(quarters), scale=2.0), tmp_path / "chair_2" / "visual" / "c.obj")
    (tmp_path / "chair_2" / "model.xml").write_text(MODEL.format(angle=angle, pose=pose))
    hints = _read(tmp_path, "mjcf")
    assert hints.category == "chair"
    _same(hints.with_(category="dining chair"))


def test_metascenes(tmp_path: Path) -> None:
    write(body(CHAIR, shift=(4, 2, 0)), tmp_path / "Annotation_scenes" / "scene0" / "12" / "12.obj")
    hints = _read(tmp_path, "metascenes")
    assert (hints.name, hints.up, hints.metres) == ("scene0-12", "z", 1.0)
    _same(hints.with_(category="dining chair"))


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("annotations.json", b"{", "annotations.json: invalid JSON: it ends too early"),
        ("annotations.json.gz", gzip.compress(b"{}" * 99, mtime=0)[:-12], "annotations.json.gz: not readable as gzip"),
        ("annotations.json", b"[3]", "annotations.json: must be a list of objects"),
        ("model_info.json", b'{"a": 1}', "model_info.json: must be a list of objects"),
        ("x/model.xml", b"<mujoco><asset>", "model.xml: damaged XML"),
        (
            "x/model.xml",
            b'<!DOCTYPE a [<!ENTITY b "c">]><mujoco/>',
            "model.xml: XML entities and document types are not read",
        ),
        ("x/model.xml", b"<mujoco/>", "model.xml: no geom with a mesh"),
    ],
)
def test_damaged_tables_are_named(tmp_path: Path, name: str, data: bytes, says: str) -> None:
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_bytes(data)
    with pytest.raises(InputError, match=says) as caught:
        list(entries(tmp_path))
    assert "\n" not in str(caught.value)


def test_readers_are_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="format: 'hsd' is unknown; did you mean"):
        list(entries(tmp_path, "hsd"))
    with pytest.raises(InputError, match="does not look like a folder of hssd"):
        list(entries(tmp_path, "hssd"))
    with pytest.raises(InputError, match="no such file or folder"):
        list(entries(tmp_path / "none"))
