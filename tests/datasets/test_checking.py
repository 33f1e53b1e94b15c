"""Verification of data sets: a whole one holds, and whatever is broken on purpose is found and named."""

from __future__ import annotations

import io
import json
import shutil
import tarfile
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import yaml

from sceneweaver.assets import Library
from sceneweaver.datasets import AssetStore, Folder, Requests, Sample, Spec, write_block
from sceneweaver.datasets.checking import verify_dataset
from sceneweaver.datasets.checking.findings import KEPT, Findings
from sceneweaver.datasets.checking.scene import Judge, included_files, mjcf_files, mjcf_tree
from sceneweaver.datasets.digests import content_of, write_checksums
from sceneweaver.datasets.engines.manifest import create
from sceneweaver.datasets.files import fingerprint, pack
from sceneweaver.datasets.reading import rows_of, scenes_of, shards_of, spans_of
from sceneweaver.datasets.statistics import statistics
from sceneweaver.datasets.store.scene_files import SceneFiles, references
from sceneweaver.datasets.tables import schema_of
from sceneweaver.datasets.twins import twin_files, twins
from sceneweaver.scene import InputError, Pose, Room, Scene, Support
from sceneweaver.verify import check

ROOM = Room.rectangle(5, 4, height=2.6, kind="study").with_door("south", at=0.1).with_window("east")
COUNT, REJECTED = 7, 6
GIVEN = {
    "schema": "sceneweaver.dataset/1",
    "name": "studies",
    "count": COUNT,
    "requests": {"kinds": {"study": 1.0}},
    "rooms": {"layouts": 2},
    "splits": {"train": 0.5, "test": 0.5},
    "block": 2,
    "gates": {"still": 0.05},
}


def study(number: int) -> Scene:
    """One of many rooms: two desks and a lamp, elsewhere each time."""
    load = Library().load
    desk, lamp = load("parametric:desk?seed=3"), load("parametric:table_lamp?seed=1")
    x, top = 1.0 + 0.3 * number, desk.surfaces[0]
    objects = (
        desk.object("desk", pose=Pose.from_yaw(x, 2.6, 0.0, 1.5)),
        desk.object("desk 2", pose=Pose.from_yaw(4.0, 1.2 + 0.1 * number, 0.0, 0.0)),
        lamp.object("lamp", pose=Pose.from_yaw(x, 2.6, top.z, 0.3), support=Support(object="desk", surface=top.name)),
    )
    return Scene(id=f"s{number}", prompt="a study", room=ROOM, objects=objects)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A packed data set of six studies in four rooms; a seventh was rejected."""
    root = tmp_path_factory.mktemp("set")
    spec = Spec.model_validate(GIVEN)
    requests, store = Requests(spec), AssetStore(root)
    create(Folder(root), spec, "cpu", source=yaml.safe_dump(GIVEN).encode())
    writer = SceneFiles(store, Library().load)
    for number in range(requests.blocks):
        wanted = [(request, layout) for request in requests.block(number) for layout in range(request.layouts)]
        write_block(Folder(root).block(number), [_sample(*one, writer) for one in wanted])
    store.sync()
    store.close()
    pack(Folder(root), requests)
    return root


def _sample(request, layout: int, writer: SceneFiles) -> Sample:
    index, key = request.index + layout, request.key(layout)
    scene = study(index)
    row = {"room": request.room, "layout": layout, "seed": request.seed, "prompt": "a study", "kind": "study"}
    if index == REJECTED:
        return Sample(index, key, "rejected", row | {"reason": "grade: 2 of 5"})
    report = check(scene)
    files = writer.of(scene, ("glb", "mjcf"))
    row |= {"room_type": "study", "area": 20.0, "wall_count": 4, "object_count": 3, "relation_count": 0, "valid": True}
    row |= {"collisions": 0, "out_of_bounds": 0, "relations_satisfied": 1.0, "walkable_share": report.walkable_share}
    row |= {"categories": sorted({o.category for o in scene.objects}), "gates": {"valid": True}, "grade": 7.0}
    row |= {
        "assets": references(files),
        "asset_ids": sorted({str(o.asset) for o in scene.objects}),
        "licences": ["Apache-2.0"],
    }
    row |= fingerprint(scene)
    files |= {"scene.json": scene.dumps().encode(), "metrics.json": json.dumps(report.to_dict()).encode()}
    return Sample(index, key, "ok", row, files)


@pytest.fixture
def root(whole: Path, tmp_path: Path) -> Path:
    """A copy to break."""
    return shutil.copytree(whole, tmp_path / "set")


def faults(root: Path, **options) -> dict[str, set[str]]:
    """What is found: keys by check."""
    found = verify_dataset(root, **options)
    named: dict[str, set[str]] = {}
    for fault in found.data["first"]:
        named.setdefault(fault["check"], set()).add(fault["key"])
    assert found.ok is not bool(named) and sum(found.data["faults"].values()) >= len(found.data["first"])
    return named


def change_files(root: Path, key: str, change: Callable[[dict[str, bytes]], object], *, honest: bool = True) -> None:
    """Change the files of a scene in its shard; an honest forger writes index and checksums anew."""
    for shard in shards_of(Folder(root)):
        scenes = [scene for span in spans_of(shard, 4) for scene in scenes_of(span)]
        with tarfile.open(shard, "w", format=tarfile.USTAR_FORMAT) as tar:
            for name, files in scenes:
                if name == key:
                    change(files)
                    if honest:
                        digest, size = content_of(files)
                        change_rows(root, lambda row, new=(digest, size): _rehash(row, key, *new))
                for suffix, content in sorted(files.items()):
                    info = tarfile.TarInfo(f"{name}.{suffix}")
                    info.size = len(content)
                    tar.addfile(info, io.BytesIO(content))
    if honest:
        write_checksums(Folder(root))


def _rehash(row, key: str, digest: str, size: int) -> None:
    if row["key"] == key:
        row |= {"content_hash": digest, "bytes": size}


def change_rows(root: Path, change: Callable[[dict], object]) -> None:
    """Change the rows of the index, and write statistics and checksums anew."""
    path = Folder(root).index
    rows = pq.read_table(path).to_pylist()
    for row in rows:
        change(row)
    pq.write_table(pa.Table.from_pylist(rows, schema=schema_of("index")), path)
    numbers = statistics(rows_of(Folder(root)))
    (root / "meta" / "statistics.json").write_text(json.dumps(numbers))
    write_checksums(Folder(root))


def with_pose(files: dict[str, bytes], name: str, x: float, y: float) -> None:
    """Move an object in scene.json alone."""
    scene = Scene.loads(files["scene.json"])
    files["scene.json"] = scene.move(name, to=(x, y)).dumps().encode()


def test_a_whole_set_holds_and_says_what_was_measured(root):
    found = verify_dataset(root, stability=2)
    assert found.ok, found.lines()
    counts = found.data["counts"]
    assert (counts["rows"], counts["scenes"], counts["judged"], counts["compiled"]) == (7, 6, 6, 6)
    assert counts["glb read"] == counts["xml read"] == 6 and counts["files hashed"] > 5
    assert found.data["stability"]["things"] == 6 and found.data["stability"]["moved_over_0_1m"] == 0.0
    assert json.loads((root / "verification.json").read_bytes()) == found.data
    assert "All holds." in (root / "verification.md").read_text()


def test_a_byte_of_a_shard(root):
    shard = shards_of(Folder(root))[0]
    content = bytearray(shard.read_bytes())
    place = content.index(b'"prompt"')
    content[place + 1] ^= 1
    shard.write_bytes(content)
    key = next(span.keys[0] for span in spans_of(shard, 1))
    found = faults(root)
    assert found["checksum"] == {f"data/{shard.name}"} and found["content"] == {key}


def test_an_asset_that_is_missing_and_one_that_is_another(root):
    first, second = sorted((root / "assets").glob("??/*.xml"))[:2]
    first.unlink()
    second.write_bytes(second.read_bytes() + b"<!-- more -->\n")
    found = faults(root)
    assert found["checksum"] == {p.relative_to(root).as_posix() for p in (first, second)}
    assert found["asset"] and found["compile"]


def test_an_object_that_was_moved_in_the_scene_alone(root):
    change_files(root, "00000002", lambda files: with_pose(files, "desk", 1.7, 2.5))
    found = faults(root)
    assert found.pop("record", {"00000002"}) == {"00000002"}  # what can be walked on may have changed
    assert found == {"export": {"00000002"}}


def test_a_scene_that_collides_whatever_is_recorded(root):
    change_files(root, "00000001", lambda files: with_pose(files, "desk 2", 1.4, 2.6))
    found = verify_dataset(root)
    assert found.data["faults"]["judge"] == 1 and found.data["counts"]["collisions"] == 1
    assert any("collision: " in line and "00000001" in line for line in found.lines())


def test_twins_are_what_is_stated_of_them(root):
    def add(files):
        scene = Scene.loads(files["scene.json"])
        made = twin_files(twins(scene, 3, seed=1))
        files |= made
        if scene.id == "s1":
            twin = Scene.loads(made["twin-0.scene.json"])
            stated = json.loads(made["twin-0.difference.json"])
            stays = [o.id for o in twin.objects if o.id not in (stated["object"], *stated["carried"])]
            files["twin-0.scene.json"] = twin.remove(stays[0], cascade=True).dumps().encode()
            stated = json.loads(made["twin-1.difference.json"])
            stated["measured"]["collisions"][1] += 1
            files["twin-1.difference.json"] = json.dumps(stated).encode()

    for key in ("00000000", "00000001"):
        change_files(root, key, add)
    found = verify_dataset(root)
    lines = [fault["detail"] for fault in found.data["first"]]
    assert found.data["counts"]["twins"] == 6 and {fault["key"] for fault in found.data["first"]} == {"00000001"}
    assert any("twin-0: " in line and "not stated" in line for line in lines)
    assert any(line.startswith("twin-1: collisions is ") for line in lines)


def test_rows_that_were_swapped(root):
    rows = {row["key"]: row for row in rows_of(Folder(root))}
    swapped = {"00000000": "00000003", "00000003": "00000000"}

    def swap(row):
        if row["key"] in swapped:
            other = rows[swapped[row["key"]]]
            row |= {name: other[name] for name in ("content_hash", "bytes", "walkable_share")}

    change_rows(root, swap)
    assert faults(root)["content"] == set(swapped)


def test_a_verdict_that_was_edited(root):
    def lie(files):
        report = json.loads(files["metrics.json"])
        files["metrics.json"] = json.dumps(report | {"collisions": 2}).encode()

    change_files(root, "00000004", lie)
    change_rows(root, lambda row: row.update(walkable_share=0.5) if row["key"] == "00000005" else None)
    assert faults(root) == {"record": {"00000004", "00000005"}}


def test_a_room_in_two_splits(root):
    def move(row):
        if row["key"] == "00000003":
            row |= {"split": "test" if row["split"] == "train" else "train", "shard": None}

    change_rows(root, move)
    found = verify_dataset(root)
    details = [fault["detail"] for fault in found.data["first"] if fault["check"] == "split"]
    assert details and details[0].startswith("room 1 is in")
    assert "00000003" in {fault["key"] for fault in found.data["first"] if fault["check"] == "shard"}


def test_rows_without_reason_licence_or_gate(root):
    def change(row):
        if row["key"] == "00000006":
            row["reason"] = None
        if row["key"] == "00000000":
            row["licences"] = []
        if row["key"] == "00000003":
            row |= {"asset_ids": [*row["asset_ids"], "stolen"], "licences": ["MIT"]}
        if row["key"] == "00000001":
            row["gates"] = row["gates"] | {"valid": False}
        if row["key"] == "00000002":
            row["index"] = 5

    change_rows(root, change)
    licences = {"00000000", "00000003"}
    assert faults(root) == {"index": {"00000006", "00000002"}, "licence": licences, "gate": {"00000001"}}


def test_statistics_of_other_rows(root):
    path = root / "meta" / "statistics.json"
    path.write_text(json.dumps(json.loads(path.read_bytes()) | {"scenes": 7}))
    write_checksums(Folder(root))
    assert faults(root) == {"record": {"meta/statistics.json"}}


def test_scenes_that_the_index_does_not_know_and_files_that_are_not_listed(root):
    change_rows(root, lambda row: row.update(key="00000009") if row["key"] == "00000004" else None)
    (root / "meta" / "more.json").write_text("{}")
    found = faults(root)
    assert found == {"shard": {"00000004", "00000009"}, "checksum": {"meta/more.json"}}


def test_a_thing_that_falls_is_named_with_how_far(root):
    _, files = next(scenes_of(next(spans_of(shards_of(Folder(root))[0], 1))))
    scene, text = Scene.loads(files["scene.json"]), files["xml"].decode()
    x, y, z = scene.object("lamp").pose.position
    place = text.index('pos="', text.index('<body name="lamp"')) + 5
    raised = text[:place] + f"{x:g} {y:g} {z + 0.5:g}" + text[text.index('"', place) :]
    judge, found = Judge(root, still=0.05), Findings()
    judge.simulate("k", raised.encode(), 1.0, found)
    assert found.faults["stability"] == 1 and found.first["stability"][0].detail.startswith("lamp moves 0.")
    assert (found.stability() or {})["farthest"][0]["object"] == "lamp"


@pytest.mark.slow
def test_other_processes_find_the_same(root):
    change_files(root, "00000001", lambda files: files.update(glb=files["glb"][:-4]))
    alone, others = verify_dataset(root).data, verify_dataset(root, workers=2).data
    assert alone["faults"] == {"export": 1} and alone | {"seconds": 0} == others | {"seconds": 0}


def test_a_sample_is_judged_and_all_is_hashed(root):
    change_files(root, "00000005", lambda files: files.update({"metrics.json": b"{}"}), honest=False)
    found = verify_dataset(root, sample=2)
    assert found.data["counts"]["judged"] == 2 and found.data["faults"]["content"] == 1


def test_what_is_no_packed_set_is_refused(tmp_path, root):
    with pytest.raises(InputError, match="no data set"):
        verify_dataset(tmp_path)
    for path in (Folder(root).index, Folder(root).checksums):
        path.unlink()
    with pytest.raises(InputError, match="not packed yet"):
        verify_dataset(root)


def test_findings_add_up_in_any_order_and_keep_few():
    parts = []
    for start in range(0, 90, 30):
        part = Findings()
        for key in range(start + 29, start - 1, -1):
            part.fault("judge", f"{key:08d}", "x")
            part.moved(f"{key:08d}", {"a": 0.02 * key, "b": 0.0})
        parts.append(part)
    one, other = Findings(), Findings()
    for part in parts:
        one.add(part)
    for part in reversed(parts):
        other.add(part)
    one.counts["simulated"] = other.counts["simulated"] = 90
    assert one == other and one.faults["judge"] == 90
    assert [fault.key for fault in one.first["judge"]] == [f"{key:08d}" for key in range(KEPT)]
    assert (one.stability() or {})["moved_over_0_01m"] == pytest.approx(89 / 180)


@pytest.mark.parametrize(
    "content",
    [
        b'<mujoco><asset><mesh name="a" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/></asset></mujoco>\n',
        b'<mujoco><asset><mesh file="assets/aa/b.obj"/><texture file="c.png"/></asset></mujoco>',
        b'<mujocoinclude><mesh name="filed"/></mujocoinclude>',
    ],
)
def test_what_an_included_file_names_is_what_its_tree_does(content):
    assert included_files(content) == set(mjcf_files(mjcf_tree(content)))
    for damaged in (content[: len(content) // 2], content.strip()[:-1], b""):
        with pytest.raises(InputError):
            included_files(damaged)


def test_an_export_that_is_asked_for_and_not_there(root):
    key, files = next(scenes_of(next(spans_of(shards_of(Folder(root))[0], 1))))
    row, found = next(row for row in rows_of(Folder(root)) if row["key"] == key), Findings()
    Judge(root, ("glb", "mjcf", "usd")).judge(row, files, found)
    assert [fault.detail for fault in found.first["export"]] == ["has no usdc"] and not found.faults["judge"]
