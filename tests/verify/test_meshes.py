"""Collisions and bounds of meshes: concave, touching, open, missing, wrong."""

import numpy as np
import pytest
import trimesh

from sceneweaver.io import InputError
from sceneweaver.verify import MeshSet
from tests.verify.build import box, judge, only, rectangle, turned


def block(size, x=0.0, y=0.0, z=0.0):
    """A box mesh of that size standing on z, centred on (x, y)."""
    return trimesh.creation.box(size, transform=trimesh.transformations.translation_matrix((x, y, z + size[2] / 2)))


def joined(*blocks):
    return trimesh.util.concatenate(blocks)


def open_(mesh):
    """The mesh without one triangle."""
    return trimesh.Trimesh(mesh.vertices, mesh.faces[1:], process=False)


CUBE = block((1, 1, 1))
DESK = joined(
    block((0.8, 1.2, 0.04), z=0.7),
    *(block((0.05, 0.05, 0.72), x, y) for x in (-0.375, 0.375) for y in (-0.575, 0.575)),
)
CHAIR = joined(
    block((0.5, 0.5, 0.05), z=0.42),
    block((0.05, 0.5, 0.5), x=-0.225, z=0.4),
    *(block((0.05, 0.05, 0.44), x, y) for x in (-0.225, 0.225) for y in (-0.225, 0.225)),
)


def desk(**more):
    return box("desk", (0.8, 1.2, 0.74), 4.0, 4.0, asset="desk", **more)


def chair(x, **more):
    """A chair that faces the desk from the right."""
    return box("chair", (0.5, 0.5, 0.9), x, 4.0, 180.0, asset="chair", **more)


FURNITURE = {"desk": DESK, "chair": CHAIR}


@pytest.mark.parametrize(("dx", "count"), [(1.1, 0), (1.0, 0), (0.9995, 0), (0.9985, 1), (0.5, 1)])
@pytest.mark.parametrize("both", [True, False])
def test_box_meshes(dx, count, both):
    a, b = box("a", (1, 1, 1), 4, 4, asset="cube"), box("b", (1, 1, 1), 4 + dx, 4, asset="cube" if both else None)
    report = judge([a, b], meshes={"cube": CUBE})
    assert report.collisions == count
    assert not report.warnings
    if count:
        assert only(report, "collision").amount == pytest.approx(1 - dx)


def test_a_chair_under_a_desk():
    """Boxes and hulls overlap; the meshes do not before the back of the chair meets the desk."""
    assert judge([desk(), chair(4.4)]).collisions == 1
    assert judge([desk(), chair(4.4)], meshes=FURNITURE).valid
    assert judge([desk(), chair(4.4)], meshes={"desk": DESK}).collisions == 1
    report = judge([desk(), chair(4.18)], meshes=FURNITURE)
    assert report.collisions == 1
    assert only(report, "collision").amount <= 0.05
    assert only(report, "collision").objects == ("desk", "chair")


@pytest.mark.parametrize(("overlap", "count"), [(-0.001, 0), (0.0005, 0), (0.0009, 0), (0.0015, 1), (0.01, 1)])
def test_concave_meshes_that_touch(overlap, count):
    """The chair's back against the edge of the desk: much shared volume and deep hulls, but hardly any depth."""
    report = judge([desk(), chair(4.2 - overlap)], meshes=FURNITURE)
    assert report.collisions == count
    if count:
        assert only(report, "collision").amount == pytest.approx(overlap, abs=1e-4)


def test_a_concave_mesh_touching_in_two_directions():
    """A cube in the corner of an L, 0.5 mm into both of its legs."""
    corner = joined(block((1.0, 0.1, 1.0), y=-0.45), block((0.1, 1.0, 1.0), x=-0.45))
    for overlap, count in ((0.0005, 0), (0.002, 1)):
        at = 4.0 - 0.4 + 0.2 - overlap
        things = [box("l", (1, 1, 1), 4, 4, asset="l"), box("c", (0.4, 0.4, 0.4), at, at, asset="c")]
        report = judge(things, meshes={"l": corner, "c": block((0.4, 0.4, 0.4))})
        assert report.collisions == count


def test_a_thin_sheet_inside_a_body_is_not_a_touch():
    sheet = block((0.5, 0.5, 0.0008))
    things = [box("a", (1, 1, 1), 4, 4, asset="cube"), box("b", (0.5, 0.5, 0.1), 4, 4, z=0.5, asset="sheet")]
    assert judge(things, meshes={"cube": CUBE, "sheet": sheet}).collisions == 1


def test_parts_gate_and_meshes_decide():
    """Parts that touch settle it; parts that overlap do not where the meshes inside stay apart."""
    parts = [{"polygon": rectangle(-0.5, -0.5, 0.5, 0.5), "z": [0.0, 1.0]}]
    thin = {"cube": block((0.8, 0.8, 0.8))}

    def collisions(dx, meshes):
        a, b = (box(name, (1, 1, 1), x, 4, asset="cube", parts=parts) for name, x in (("a", 4.0), ("b", 4.0 + dx)))
        return judge([a, b], meshes=meshes).collisions

    assert collisions(0.9, None) == 1
    assert collisions(0.9, thin) == 0
    assert collisions(0.79, thin) == 1
    assert collisions(1.0, {"cube": block((1.2, 1.2, 1.2))}) == 0


def test_a_mesh_out_of_its_parts_is_reported():
    parts = [{"polygon": rectangle(-0.5, -0.5, 0.5, 0.5), "z": [0.0, 1.0]}]
    thing = box("a", (1, 1, 1), 4, 4, asset="cube", parts=parts)
    assert judge([thing], meshes={"cube": CUBE}).warnings == ()
    assert judge([thing], meshes={"cube": block((1, 1.06, 1))}).warnings == (
        "a: its mesh reaches 3.0 cm out of its collision parts",
    )


@pytest.mark.parametrize("parts", [None, [{"polygon": rectangle(-0.5, -0.5, 0.5, 0.5), "z": [0.0, 1.0]}]])
def test_open_meshes_are_judged_by_parts_or_hull(parts):
    meshes = {"cube": open_(CUBE)}
    things = [box(name, (1, 1, 1), x, 4, asset="cube", parts=parts) for name, x in (("a", 4.0), ("b", 4.9))]
    report = judge(things, meshes=meshes)
    assert report.collisions == 1
    by = "parts" if parts else "convex hull"
    assert report.warnings == tuple(f"{k}: mesh 'cube' is not watertight; judged by its {by}" for k in "ab")
    assert report.to_dict()["warnings"] == list(report.warnings)
    apart = [things[0], {**things[1], "pose": box("b", (1, 1, 1), 5.01, 4)["pose"]}]
    assert judge(apart, meshes=meshes).valid
    assert len(judge(apart, meshes=meshes).warnings) == 2


def test_a_flat_mesh_has_no_volume():
    flat = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 1, 2]], process=False)
    things = [box("a", (1, 1, 1), 4, 4, asset="cube"), box("b", (1, 1, 0.1), 4, 4, z=0.5, asset="flat")]
    report = judge(things, meshes={"cube": CUBE, "flat": flat})
    assert report.collisions == 0
    assert len(report.warnings) == 1


def test_seams_are_closed():
    """Exporters repeat vertices along seams; the body is watertight all the same."""
    split = trimesh.Trimesh(CUBE.vertices[CUBE.faces].reshape(-1, 3), np.arange(36).reshape(-1, 3), process=False)
    assert not split.is_watertight
    assert MeshSet({"cube": split}).get("cube").solid.volume() == pytest.approx(1.0)


def test_overlapping_shells_and_cavities():
    solid = MeshSet({"m": joined(block((1, 1, 1)), block((1, 1, 1), x=0.5))}).get("m").solid
    assert solid.volume() == pytest.approx(1.5)
    hole = block((0.5, 0.5, 0.5), z=0.25)
    hole.invert()
    hollow = MeshSet({"m": joined(block((1, 1, 1)), hole)}).get("m").solid
    assert hollow.volume() == pytest.approx(1 - 0.125)


def test_tilted_meshes():
    """A leaning cube meets a wall of boxes only by its upper edge."""
    up = turned(45.0, "y")
    corner = np.sqrt(0.5)
    for dx, count in ((corner + 0.5 + 0.002, 0), (corner + 0.5 - 0.01, 1)):
        lean = box("a", (1, 1, 1), 4 - corner / 2, 4, z=corner / 2, quaternion=up, asset="cube")
        report = judge([lean, box("b", (1, 1, 2), 4 - corner / 2 + corner / 2 + dx, 4)], meshes={"cube": CUBE})
        assert report.collisions == count


def test_bounds_are_those_of_the_vertices():
    """A round body in a corner that its box would leave; and one whose mesh leaves where its box does not."""
    tube = trimesh.creation.cylinder(0.5, 1.0, transform=trimesh.transformations.translation_matrix((0, 0, 0.5)))
    thing = box("a", (1, 1, 1), 0.5, 4, 45.0, asset="tube")
    assert judge([thing]).out_of_bounds == 1
    assert judge([thing], meshes={"tube": tube}).valid
    found = only(judge([box("a", (1, 1, 1), 0.45, 4, asset="tube")], meshes={"tube": tube}), "out_of_bounds")
    assert found.amount == pytest.approx(0.05)
    wide = judge([box("a", (0.5, 0.5, 0.5), 0.45, 4, asset="tube")], meshes={"tube": tube})
    assert wide.out_of_bounds == 1
    tall = judge([box("a", (0.5, 0.5, 0.5), 4, 4, asset="tall")], meshes={"tall": block((0.5, 0.5, 2.8))})
    assert only(tall, "out_of_bounds").detail == "a rises 10.0 cm above the ceiling"


def test_bounds_in_a_notch():
    """Every vertex counts, not only those of the hull: the middle of a U is outside."""
    outline = [[0, 0], [8, 0], [8, 8], [5, 8], [5, 4], [3, 4], [3, 8], [0, 8]]
    legs = joined(block((1, 4, 1)), block((0.2, 0.2, 0.2), y=2.5))
    thing = box("a", (1, 5, 1), 4, 1.98, asset="legs")
    found = only(judge([thing], meshes={"legs": legs}, outline=outline), "out_of_bounds")
    assert found.amount == pytest.approx(0.58)


# ---- where meshes come from


@pytest.mark.parametrize("suffix", ["glb", "obj", "stl", "ply"])
def test_a_folder_of_meshes(tmp_path, suffix):
    DESK.export(tmp_path / f"desk.{suffix}")
    CHAIR.export(tmp_path / f"chair.{suffix}")
    for source in (
        tmp_path,
        str(tmp_path),
        {"desk": tmp_path / f"desk.{suffix}", "chair": f"{tmp_path}/chair.{suffix}"},
    ):
        report = judge([desk(), chair(4.4)], meshes=source)
        assert report.valid
        assert not report.warnings


def test_a_set_is_loaded_once(tmp_path):
    DESK.export(tmp_path / "desk.glb")
    CHAIR.export(tmp_path / "chair.glb")
    meshes = MeshSet(tmp_path)
    assert judge([desk(), chair(4.4)], meshes=meshes).valid
    (tmp_path / "desk.glb").unlink()
    assert judge([desk(), chair(4.4)], meshes=meshes).valid
    assert MeshSet.of(meshes) is meshes


def test_assets_without_a_mesh_are_boxes(tmp_path):
    assert judge([desk(), chair(4.4)], meshes=tmp_path).collisions == 1
    assert judge([desk(), chair(4.4)], meshes={}).collisions == 1
    assert MeshSet(tmp_path).get(None) is None


def test_a_folder_is_not_left(tmp_path):
    DESK.export(tmp_path / "desk.glb")
    inner = tmp_path / "inner"
    inner.mkdir()
    assert MeshSet(inner).get("../desk") is None


def test_wrong_meshes(tmp_path):
    bad = CUBE.copy()
    bad.vertices[0, 0] = np.nan
    (tmp_path / "desk.glb").write_bytes(b"no mesh at all")
    nothing = trimesh.Trimesh()
    for source, text in (
        (tmp_path / "none", "is not a folder"),
        ({"desk": tmp_path / "none.glb"}, r"meshes\['desk'\]: .*none.glb: no such file"),
        (tmp_path, r"meshes\['desk'\]: desk.glb: this is no GLB file"),
        ({"desk": bad}, "finite"),
        ({"desk": nothing}, "no triangles"),
        ({"desk": object()}, "no triangles"),
    ):
        with pytest.raises(InputError, match=text) as caught:
            judge([desk()], meshes=source)
        assert "\n" not in str(caught.value)
